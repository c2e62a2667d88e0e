"""The shader, written once for all machines: a pixel's surface, shadows and light, as §2 and §3 derive them.

A *machine* runs it (`renderer.machines.traced.Tracer`, `renderer.machines.numpy_rows.Rows`, or one around these): it
gives values for many pixels at once, and masks that say for which of them something holds.

    variable(value)                                 a value that changes: `value`, `set(value, mask)`
    when(mask, body)                                body(), unless the mask holds for no pixel of the group
    choose(alternatives, index, result_of)          result_of(alternatives[index]), two numbers
    by_squaring(exponent, first, square, multiply)  the steps that raise something to a whole power
    each_light(body)                                body(light) for each light that is on
    count(kind, mask)                               adds the pixels of the mask to a count of WORK
"""

from collections.abc import Callable, Iterable
from functools import partial
from types import SimpleNamespace
from typing import Any

from renderer import kernels as k
from renderer.machines.forms import COLORS, Numbers, Variables
from renderer.operations import Mask, Number, floor, of_whole_power, where
from renderer.scene.fields import field_kernels

NOTHING, SPHERE_A, SPHERE_B, FLOOR = 0.0, 1.0, 2.0, 3.0
DARK_BIT = 128.0
BOUNDS = tuple(f"{color}_bound" for color in COLORS)
ANGLES, CHART, SLOPES = ("cos_theta", "sin_theta", "cos_phi", "sin_phi"), ("u", "v"), ("h_u", "h_v")
ON_A = (*ANGLES, *SLOPES)
PLANES = (*COLORS, "code", *ON_A, *CHART, *BOUNDS, "open")
WORK = ("gradient_evaluations", "shadow_tests", "specular_powers", "light_terms")

Bodies = Callable[[SimpleNamespace], Iterable[tuple[Numbers, Numbers]]]


class Group:
    """The pixels of a group while they are drawn.

    pixels: their image points x, y (x is NaN beyond a row's end), and `load` and `store` of the frame's planes by name.
    scene: `renderer.shader.numbers.scene_numbers`. want: `renderer.shader.numbers.Want`.
    """

    def __init__(self, machine: Any, scene: SimpleNamespace, want: Any, pixels: Any):
        self.machine, self.scene, self.want, self.pixels = machine, scene, want, pixels
        self.x, self.y = pixels.x, pixels.y
        self.sphere_a = (0.0, 0.0, 0.0, scene.radius)

    def draw(self) -> None:
        """Find or load the chamber of every pixel, light it, and store the wanted planes."""
        want, x = self.want, self.x
        surface, self.code = self.loaded_surface() if want.chambers_known else self.visible_surface()
        on_a, on_b, on_floor = ((surface == number) & (x == x) for number in (SPHERE_A, SPHERE_B, FLOOR))
        over = want.surfaces == "a"
        there = self.loaded(COLORS) if over and want.colors else (0.0, 0.0, 0.0)
        self.color = Variables(self.machine, there)
        if want.surfaces != "elsewhere":
            self.machine.when(on_a, lambda: self.draw_a(on_a))
        if not over:
            self.machine.when(on_b, lambda: self.draw_b(on_b))
            self.machine.when(on_floor, lambda: self.draw_floor(on_floor))
        if not want.chambers_known:
            self.pixels.store("code", self.code.value)
        if want.colors:
            for name, channel in zip(COLORS, self.color.value, strict=True):
                self.pixels.store(name, channel)

    def visible_surface(self) -> tuple[Number, Any]:
        """Return the surface that each ray meets first, and the chamber code so far, a variable.

        A is met where ρ² is at most `reach_of_a`; B is looked for where it can be.
        """
        s, x, y = self.scene, self.x, self.y
        code = self.machine.variable(where(x * x + y * y <= s.reach_of_a, SPHERE_A, s.ground))
        near_b = within(s.box_of_b, x, y)

        def look():
            code.set(k.visible_surface(x, y, s.eye, s.radius, *s.ball, s.ball_on, s.floor_on), near_b)

        self.machine.when(near_b, look)
        return code.value, code

    def loaded_surface(self) -> tuple[Number, Any]:
        """Return the surface that each pixel's chamber code says, and the code, a variable."""
        code = self.pixels.load("code")
        return code - 4.0 * floor(0.25 * code), self.machine.variable(code)

    def draw_a(self, mask: Mask) -> None:
        """Light sphere A: angles, gradient, bumped normal (§2 and §3)."""
        s, want = self.scene, self.want
        angles = self.loaded(ANGLES) if want.charted else k.angles_on_a(self.x, self.y, s.eye, s.radius)
        gradient = self.gradient(angles, mask) if want.colors or want.stored else (0.0, 0.0)
        chart = self.chart(angles) if CHART[0] in want.stored else ()
        for name, value in zip((*ON_A, *CHART), (*angles, *gradient, *chart), strict=False):
            if name in want.stored:
                self.pixels.store(name, value)
        slopes = self.machine.choose(
            want.bumps, s.bump, lambda bump: slopes_of_bump(bump, angles[-1], s.radius, gradient)
        )
        point = k.point_on_a(*angles, s.radius)
        place = (*point, *k.bumped_normal(*angles, *slopes, s.beta))
        self.light_up(mask, place, s.albedo_a, lambda light: [(s.ball, light.b_on_a)], upright=point)

    def loaded(self, names: Iterable[str]) -> Numbers:
        """Return the numbers of planes."""
        return tuple(self.pixels.load(name) for name in names)

    def chart(self, angles: Numbers) -> Numbers:
        """Return u and v on A."""
        return self.loaded(CHART) if self.want.charted else k.chart(*angles)

    def draw_b(self, mask: Mask) -> None:
        """Light sphere B, which has no bump."""
        s = self.scene
        place = k.normal_of_b(self.x, self.y, s.eye, *s.ball)
        self.light_up(mask, place, s.albedo_b, lambda light: [(self.sphere_a, light.a_on_b)])

    def draw_floor(self, mask: Mask) -> None:
        """Light the floor and its squares."""
        s = self.scene
        place = k.normal_of_floor(self.x, self.y)
        if self.want.chambers_known:
            dark = self.code.value >= DARK_BIT
        else:
            dark = k.checker(self.x, self.y) > 0.0
            self.code.set(self.code.value + DARK_BIT, mask & dark)
        red, blue = map(partial(where, dark), s.floor_dark, s.floor_light)
        self.light_up(mask, place, (red, red, blue),
                      lambda light: [(self.sphere_a, light.a_on_floor), (s.ball, light.b_on_floor)])  # fmt: skip

    def gradient(self, angles: Numbers, mask: Mask) -> Numbers:
        """Return h_u and h_v by the wanted way."""
        s = self.scene

        def by(way):
            name, way = way
            field = field_kernels(name)
            if way == "flat":
                return 0.0, 0.0
            if way == "stored":
                return self.loaded(SLOPES)
            self.machine.count("gradient_evaluations", mask)
            if way == "algebraic":
                u_real, u_imaginary, v_real, v_imaginary = k.algebraic_bases(*angles)
                by_complex = k.complex_square, k.complex_product
                cos_u, sin_u = power(self.machine, (u_real, s.turn_u * u_imaginary), s.power_u, *by_complex)
                cos_v, sin_v = power(self.machine, (v_real, s.turn_v * v_imaginary), s.power_v, *by_complex)
                return field["gradient_from_factors"](sin_u, cos_u, sin_v, cos_v, s.ku, s.kv)
            u, v = self.chart(angles)
            if way == "general":
                return field["gradient"](u, v, s.ku, s.kv)
            return difference(field, way, u, v, s.ku, s.kv, s.eps)

        return self.machine.choose(self.want.ways, s.way, by)

    def light_up(
        self, mask: Mask, place: Numbers, albedo: Numbers, bodies: Bodies, upright: Numbers | None = None
    ) -> None:
        """Find each light's shadows, and add up the light.

        place: the point, and N'. upright: along the surface's own normal, where N' is another.
        bodies: light → [(a body that may stand in its way, where on the image its shadow can be)].
        """
        s, want, machine = self.scene, self.want, self.machine
        if want.chambers_known and not want.colors:
            return
        point, normal = place[:3], place[3:]
        color, view = Variables(machine, s.ambient), self.view()

        def shine(light, lit):
            machine.count("light_terms", lit)
            mu, specular = self.model(point, light, normal, view, lit)
            color.set(k.light_term(*color.value, *light.color, *albedo, s.kd, s.ks, mu, specular), lit)

        def reach(light):
            lit = mask & ~(
                self.loaded_shadow(light) if want.chambers_known else self.shadow(light, mask, point, bodies(light))
            )
            if want.colors:
                lit = lit if want.by_color else lit & (light.glows > 0.0)
                if want.horizon:
                    lit = lit & self.faces(light, point, upright or normal)
                machine.when(lit, lambda: shine(light, lit))

        machine.each_light(reach)
        self.color.set(map(k.clip, color.value), mask)

    def faces(self, light: SimpleNamespace, point: Numbers, upright: Numbers) -> Mask:
        """Return where a light stands before the surface itself."""
        return k.height_of_light(*point, *light.position, *upright) > 0.0

    def view(self) -> Numbers:
        """Return the direction to the eye."""
        here = self.x, self.y, self.scene.eye
        return k.view_direction(*here, k.view_length(*here))

    def loaded_shadow(self, light: SimpleNamespace) -> Mask:
        """Return where the chamber code has the light's bit."""
        shifted = floor(self.code.value * light.inverse_bit)
        return shifted > 2.0 * floor(0.5 * shifted)

    def shadow(
        self, light: SimpleNamespace, mask: Mask, point: Numbers, bodies: Iterable[tuple[Numbers, Numbers]]
    ) -> Mask:
        """Return where a body stands before the light, and put the light's bit into the code."""
        hidden = self.machine.variable(0.0)
        for body, box in bodies:
            near = mask & within(box, self.x, self.y)

            def test(body=body, near=near):
                self.machine.count("shadow_tests", near)
                hidden.set(1.0, near & (k.shadow(*point, *light.position, *body) > 0.0))

            self.machine.when(near, test)
        self.code.set(self.code.value + light.bit, hidden.value > 0.0)
        return hidden.value > 0.0

    def model(self, point: Numbers, light: SimpleNamespace, normal: Numbers, view: Numbers, lit: Mask) -> Numbers:
        """Return μ and the highlight, by the wanted model of light."""
        s = self.scene

        def by(choice):
            name, style = choice
            base, squared = k.LIGHT_MODELS[name]
            inputs = (*point, *light.position, *normal, *view)
            mu, specular = map(self.value, (squared if style == "squared" else base)(*inputs))
            if style == "diffuse":
                return mu, 0.0
            self.machine.count("specular_powers", lit)
            if not self.want.integer_power:  # for no group that is unlit, or without a highlight
                highlight = self.machine.variable(0.0)
                self.machine.when(lit & (specular > 0.0), lambda: highlight.set(k.highlight(specular, s.power)))
                return mu, highlight.value
            (highlight,) = power(self.machine, (specular,), s.power)
            return mu, of_whole_power(highlight, specular, s.power)

        return self.machine.choose(self.want.lights, s.model, by)

    def value(self, number: Number) -> Number:
        """Return a number as one of the machine's."""
        return self.machine.variable(number).value if isinstance(number, float) else number


def slopes_of_bump(bump: str, sin_phi: Number, radius: Number, gradient: Numbers) -> Numbers:
    """Return the slopes along e_θ and e_φ by which a bump tilts the normal: the chart's, or the surface's own."""
    return k.surface_slopes(sin_phi, radius, *gradient) if bump == "surface" else gradient


def power(
    machine: Any,
    base: Numbers,
    exponent: Number,
    square: Callable = lambda a: (a * a,),
    product: Callable = lambda a, b: (a * b,),
) -> Numbers:
    """Return base^exponent, a whole number that is not negative, by repeated squaring.

    base: the parts of a number, real alone or real and imaginary. square, product: of parts.
    """
    squared, result = (Variables(machine, parts) for parts in (base, (1.0, 0.0)[: len(base)]))
    machine.by_squaring(
        exponent,
        first=lambda: result.set(squared.value),
        square=lambda: squared.set(square(*squared.value)),
        multiply=lambda: result.set(product(*result.value, *squared.value)),
    )
    return result.value


def difference(field: dict[str, Callable], method: str, *arguments: Number) -> Numbers:
    """Return h_u and h_v by a difference of a field's height; where h does not depend on u, h_u is 0.

    arguments: u, v, k_u, k_v, ε.
    """
    slopes = field[method](field["height"], *arguments)
    return slopes if isinstance(slopes, tuple) else (0.0, slopes)


def within(box: Numbers, x: Number, y: Number) -> Mask:
    """Return which image points are in a box (left, right, low, high)."""
    left, right, low, high = box
    return (left <= x) & (x <= right) & (low <= y) & (y <= high)
