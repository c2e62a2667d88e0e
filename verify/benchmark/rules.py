"""What each rule that leaves work out saves: the same picture, by the shader traced or fed without that rule.

A rule is taken away from what the shader is given, or from the machine that traces it; the shader knows of none.
"""

from collections.abc import Callable
from contextlib import nullcontext
from unittest import mock

import numpy as np

from renderer import Light, Scene, central, exact
from renderer.machines import Job, native, traced
from renderer.picture.stage import Stage
from renderer.scene.bounds import EVERYWHERE
from renderer.scene.methods import GradientMethod
from renderer.scene.raster import Raster
from renderer.shader import numbers
from renderer.shader.shader import COLORS
from verify.benchmark.plan import Case

SIDE = 512
ALL = EVERYWHERE * 2
FIVE = tuple(Light((3.0 * n - 6, 4, 9), (0.3 * (n > 0), 0.2, 0.0) if n else (0, 0, 0)) for n in range(5))
SCENES = {
    "chapter": (Scene(), exact()),
    "plain": (Scene(ball=False, floor=False, ks=0.0, beta=0.0), exact()),
    "lights": (Scene(lights=FIVE), central(1e-3)),
}
"""The chapter's; sphere A alone, without bump and highlight; five lights, one of them black, and a difference."""

_places_of, _way_of, _style_of, _lanes = numbers.places_of, numbers.way_of, numbers.style_of, native.host_lanes


def _places(change):
    """Return what puts other boxes into the scene's numbers: change(reach, box of B, boxes of the lights)."""
    return lambda: mock.patch.object(numbers, "places_of", lambda geometry: change(*_places_of(geometry)))


def _from_one(self, exponent, first, square, multiply):
    """Repeated squaring that begins with 1 and looks at every bit."""
    builder, exponent = self.builder, self.whole(exponent)
    bits = builder.sub(traced.WHOLE(64), builder.ctlz(exponent, traced.BIT(0)))
    with self.loop(traced.WHOLE(0), bits) as number:
        with builder.if_then(builder.trunc(builder.lshr(exponent, number), traced.BIT)):
            multiply()
        square()


def _forget_the_literal(self, machine, vector, literal=None, still=None):
    self.machine, self.vector, self.literal, self.still = machine, vector, None, still


RULES = {
    "passed_over": lambda: mock.patch.object(traced.Tracer, "when", lambda self, mask, body: body()),
    "box_of_b": _places(lambda reach, ball, lights: (reach, ALL, lights)),
    "shadow_boxes": _places(lambda reach, ball, lights: (reach, ball, [(ALL,) * 4 for _ in lights])),
    "literals": lambda: mock.patch.object(traced.Value, "__init__", _forget_the_literal),
    "first_bit": lambda: mock.patch.object(traced.Tracer, "by_squaring", _from_one),
    "algebraic": lambda: mock.patch.object(numbers, "uses_algebraic_form", lambda scene, method: False),
    "flat": lambda: mock.patch.object(
        numbers, "way_of", lambda s, m: (s.field, "general") if not s.beta else _way_of(s, m)
    ),
    "diffuse": lambda: mock.patch.object(
        numbers, "style_of", lambda s: (s.model, "base") if not s.ks else _style_of(s)
    ),
    "squared": lambda: mock.patch.object(
        numbers, "style_of", lambda s: (s.model, _style_of(s)[1].replace("squared", "base"))
    ),
    "twice_the_lanes": lambda: mock.patch.object(native, "host_lanes", lambda want: min(8, _lanes(want))),
}
"""{rule: what takes it away while a picture's code and numbers are made}"""


def prepare(scene: Scene, method: GradientMethod, without: Callable = nullcontext) -> Callable[[], None]:
    """Return the function that draws a scene on one thread, made without a rule."""
    stage = Stage(scene, Raster(SIDE, SIDE))
    planes = dict(zip(COLORS, stage.new_plane(channels=3), strict=True)) | {"code": stage.new_plane(np.uint8)}
    with without():
        want, given = numbers.want_of(scene, method), numbers.numbers_of.__wrapped__(scene, method)
        lanes = native.host_lanes(want)
        code, engine = native.compiled.__wrapped__(want, lanes)
    draw = native.drawer(want, Job(*given, *stage.raster_of(), planes), lanes, code)

    def work():
        draw(range(SIDE))

    work.keeps = engine  # type: ignore[attr-defined]
    return work


def rule_cases() -> list[Case]:
    """Return the cases: each scene as it is, and without each rule."""
    cases = []
    for name, (scene, method) in SCENES.items():
        for rule, without in {"": nullcontext, **RULES}.items():
            label = f"without_{rule}_{name}" if rule else f"with_all_{name}"
            cases.append(Case(label, lambda given=(scene, method, without): prepare(*given), 5))
    return cases
