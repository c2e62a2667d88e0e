"""The 50-digit reference: the programs of `proofs/`, printed for mpmath and run on the exact values of float64 inputs.

It shares the expressions with the kernels and nothing else: arithmetic, sinpi, cospi and atan2pi are mpmath's.
"""

from functools import lru_cache

import mpmath

from proofs import symbols
from proofs.finite_difference import METHODS
from proofs.height_fields import HEIGHT_FIELDS
from proofs.pixel import CHANNELS, light_color, light_position, pixel
from renderer.generate.printers import MpmathPrinter

DIGITS = 50
NOTHING = mpmath.nan  # the value of a line that has none, such as the normal of a sphere that is not hit

_NAMESPACE = {
    "sqrt": mpmath.sqrt,
    "floor": mpmath.floor,
    "nint": mpmath.nint,
    "sign": mpmath.sign,
    "pow": mpmath.power,
    "mpf": mpmath.mpf,
    "inf": mpmath.inf,
    "pi": mpmath.pi,
    "sinpi": mpmath.sinpi,
    "cospi": mpmath.cospi,
    "sinpi_of_product": lambda a, b: mpmath.sinpi(a * b),
    "cospi_of_product": lambda a, b: mpmath.cospi(a * b),
    "atan2pi": lambda y, x: mpmath.atan2(y, x) / mpmath.pi if (x, y) != (0, 0) else mpmath.mpf(0),
}


class Reference:
    """A straight-line program at any precision."""

    def __init__(self, program):
        printer = MpmathPrinter()
        self.program = program
        self.lines = [(s.name, compile(printer.doprint(e), s.name, "eval")) for s, e in program.definitions]

    def __call__(self, values, digits=DIGITS):
        """Return {name: value} of every line; `values` has a float or an mpf for every input's name."""
        # A product k·u of float64 numbers has 106 bits; the guard digits keep it exact, and cancellation away.
        with mpmath.workdps(digits + 20):
            scope = dict(_NAMESPACE)
            scope |= {s.name: mpmath.mpf(values[s.name]) for s in self.program.inputs}
            for name, code in self.lines:
                try:
                    scope[name] = mpmath.mpmathify(eval(code, scope))
                except ZeroDivisionError:
                    scope[name] = NOTHING
            return {name: scope[name] for name, _ in self.lines}


@lru_cache(maxsize=64)
def _pixel_reference(field, model, lights, method):
    gradient = None if method == "exact" else METHODS[method](HEIGHT_FIELDS[field])
    return Reference(pixel(HEIGHT_FIELDS[field], model, lights, gradient))


def scene_values(scene, lights):
    """Return {name: number} of a scene with these of its lights, as `proofs.pixel` names its inputs."""
    center, ball_radius = (scene.ball_center, scene.ball_radius) if scene.ball else ((0.0, 0.0, 0.0), 1.0)
    values = {
        "eye": scene.eye,
        "radius": scene.radius,
        "ball_radius": ball_radius,
        "ball_on": float(scene.ball),
        "floor_on": float(scene.floor),
        "k_u": scene.ku,
        "k_v": scene.kv,
        **{name: getattr(scene, name) for name in ("beta", "ka", "kd", "ks", "shininess", "floor_tint")},
        **{s.name: c for s, c in zip(symbols.ball_center, center, strict=True)},
    }
    for name, triple in (("ambient", scene.ambient), ("albedo_a", scene.albedo_a), ("albedo_b", scene.albedo_b)):
        values |= {f"{name}_{c}": value for c, value in zip(CHANNELS, triple, strict=True)}
    for number, light in enumerate(lights):
        values |= {s.name: p for s, p in zip(light_position(number), light.position, strict=True)}
        values |= {s.name: c for s, c in zip(light_color(number), light.color, strict=True)}
    return values


def reference_pixel(scene, width, height, column, row, method="exact", eps=None, digits=DIGITS):
    """Return {name: value} of every line of a pixel's program, from the exact values of the scene's numbers.

    Among the names: surface, occluded_0 … (lights that are on, in order), dark_square, u, v, h_u, h_v, bumped_x …,
    rgb_red, rgb_green, rgb_blue. Off the surface that a name belongs to it has no meaning.
    """
    lights = [light for light in scene.lights if light.color is not None]
    values = scene_values(scene, lights) | {"column": column, "row": row, "width": width, "height": height}
    if eps is not None:
        values["epsilon"] = eps
    return _pixel_reference(scene.field, scene.model, len(lights), method)(values, digits)
