"""The scene: its chambers, its height fields, where the creases fall, and the shadow that the bump moves."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import GAP, TITLE, panels, pixel_axes, pixel_text
from book.figures.chapter_scene import FIELD_NAMES, FINE, SCENE, SIZE, averaged, smooth, symbolic
from proofs.formulas.camera import parallel_radius
from proofs.formulas.shading import floor_albedo, floor_blue, floor_dark
from renderer import Scene, height_at, render
from renderer.generate.kernels import function_of
from renderer.picture.views import image_view
from verify.accuracy.frontiers import fiction

BODIES = {  # surface and bit 7, the dark floor square: (name, colour where both lights arrive)
    1: ("sphere A", (0xD9, 0x6A, 0x4F)),
    2: ("sphere B", (0x6B, 0xA3, 0xD6)),
    3: ("floor, light square", (0xE6, 0xD9, 0xB4)),
    3 | 128: ("floor, dark square", (0x9C, 0xA9, 0x7C)),
}
HIDDEN = {0: ("both lights", 1.0), 4: ("no first", 0.74), 8: ("no second", 0.55), 12: ("neither", 0.4)}
"""{bits 2 and 3, the lights that another body hides: (name, how bright the colour is)}"""


def _colour(code):
    """Return a chamber's colour."""
    return np.rint(np.array(BODIES[code & 131][1]) * HIDDEN[code & 12][1]).astype(np.uint8)


def _chamber_legend(fig, codes, top):
    """Write under the second picture what a colour says: a row for each body, a column for the lights hidden."""
    for column, (hidden, (name, _)) in enumerate(HIDDEN.items()):
        left = 582 + 86 * column
        pixel_text(fig, left, top, name, "muted")
        for row, (body, (surface, _)) in enumerate(BODIES.items()):
            below = top + 14 + 25 * row
            if column == 0:
                pixel_text(fig, 466, below + 12, surface)
            if body | hidden in codes:
                pixel_axes(fig, left, below, 72, 16).imshow(_colour(body | hidden)[None, None], aspect="auto")


@figure
def chambers() -> Drawing:
    """The default scene, and beside it its chambers, each in a colour of its own, with a legend."""
    side = 450
    fine, shown = symbolic(size=side * FINE), symbolic(size=side).chambers
    codes, colours = np.unique(shown), np.zeros((256, 3), np.uint8)
    for code in codes:
        colours[code] = _colour(code)
    fig = panels([smooth(fine), averaged(colours[fine.chambers])], ("the picture", "its chambers"), foot=140)
    _chamber_legend(fig, codes, TITLE + side + 28)
    _, on_a, on_b, on_floor = np.bincount(symbolic().chambers.ravel() & 3)
    pixels = {"a": on_a, "b": on_b, "floor": on_floor}
    return Drawing(fig, {"count": len(codes), "pixels": pixels}, shown=(fine,))


@figure
def height_fields() -> Drawing:
    """Sphere A with each height field as the surface's own bump, the default wave numbers; below it the chart."""
    side, line = 276, (0xD5, 0x5E, 0x00, 0xFF)
    u, v = np.meshgrid((np.arange(side) + 0.5) / side, (np.arange(side // 2) + 0.5) / (side // 2))
    heights = {field: height_at(Scene(field=field), u, v) for field in FIELD_NAMES}
    rim, pictures, shown = int(np.arccos(SCENE.radius / SCENE.eye) / np.pi * side / 2), [], []
    for field, h in heights.items():
        scene, around = Scene(field=field, bump="surface", ball=False), [FINE * n for n in (28, 3, side, side)]
        shown.append(render(scene, *2 * [FINE * 332], crop=tuple(around), bounds=True))
        grey = np.rint(127.5 * (1 + h)).astype(np.uint8)[..., None].repeat(3, axis=2)
        ball, chart = (np.insert(each, 3, 255, axis=2) for each in (smooth(shown[-1]), grey))
        chart[rim : rim + 2] = line
        pictures.append(np.concatenate([ball, np.zeros((GAP, side, 4), np.uint8), chart]))
    data = {"u": u[0], "v": v[:, 0], **heights}
    return Drawing(panels(pictures, FIELD_NAMES), {"ku": int(SCENE.ku), "kv": int(SCENE.kv)}, data, tuple(shown))


def _point(numbers):
    return "(" + ", ".join(f"{number:g}".replace("-", "−") for number in numbers) + ")"


@figure
def default_scene() -> Drawing:
    """Numbers of the chapter's scene, for the table in §2; numbers only."""
    names = ("radius", "eye", "ball_radius", "beta", "shininess", "ka", "kd", "ks", "floor_tint")
    numbers = {name: f"{getattr(SCENE, name):g}" for name in names}
    for number, light in enumerate(SCENE.lights, 1):
        numbers |= {f"light_{number}": _point(light.position), f"colour_{number}": _point(light.color)}
    numbers |= {name: _point(getattr(SCENE, name)) for name in ("ball_center", "ambient", "albedo_a", "albedo_b")}
    floor = floor_albedo.expand(floor_blue)
    numbers |= {name: f"{float(floor.subs({floor_dark: dark})):g}" for dark, name in enumerate(("light", "dark"))}
    lean = SCENE.beta * symbolic().slope.max()
    return Drawing(numbers=numbers | {"field": SCENE.field, "lean": lean, "tilt": np.degrees(np.arctan(lean))})


@figure
def kink_loci() -> Drawing:
    """The creases of ridges that are in view: rays from the axis and circles, v = m/k_v; numbers only."""
    image_radius, angles = function_of(parallel_radius), np.pi * np.arange(1, SCENE.kv) / SCENE.kv
    seen = angles[np.cos(angles) > SCENE.radius / SCENE.eye]
    radii = image_radius(np.sin(seen), np.cos(seen), SCENE.eye, SCENE.radius)
    return Drawing(numbers={"rays": int(SCENE.ku), "circles": len(radii), "circle_radius": radii[0]})


MARKED = 300  # the side of a panel with marks
PINK = (0xCC, 0x79, 0xA7)


@figure
def attached_shadow() -> Drawing:
    """The pixels of A that the bump turns away from a light, or towards it, for each light."""
    frame = symbolic(size=MARKED * FINE)
    pictures = [image_view(frame)]
    for leak, miss in fiction.leaks(SCENE, MARKED * FINE):
        pictures.append(pictures[0] // 3)
        pictures[-1][leak | miss] = PINK
    on_a, turned = symbolic().stage.on_a.sum(), {}
    numbers = {"beta": SCENE.beta, "pixels_a": on_a}
    for name, (leak, miss) in zip(("first", "second"), fiction.leaks(SCENE, SIZE), strict=True):
        turned[name] = leak | miss
        numbers |= {name: turned[name].sum(), f"{name}_share": turned[name].sum() / on_a}
        numbers |= {f"{name}_leaks": leak.sum(), f"{name}_missed": miss.sum()}
    numbers["either_share"] = (turned["first"] | turned["second"]).sum() / on_a
    fig = panels([averaged(each) for each in pictures], ("the picture", "first light", "second light"))
    return Drawing(fig, numbers, shown=(frame,))
