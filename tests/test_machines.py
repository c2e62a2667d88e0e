"""NumPy draws what LLVM draws, in groups of any size, to the last bit."""

import operator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from itertools import chain, product, repeat
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import example, given, strategies as st

from renderer import (
    HeightField,
    Light,
    Scene,
    central,
    exact,
    forward,
    gradient_at,
    height_at,
    k_v,
    kernels,
    machines,
    pixel,
    render,
    sinpi,
    u,
    v,
)
from renderer.machines import native, numpy_rows
from renderer.machines.forms import COLORS, flat, of_form
from renderer.picture import stage
from renderer.scene.scene import BUMPS
from renderer.shader.numbers import SCENE_FORM, numbers_of
from tests.strategies import methods, rasters, scenes
from verify.coq.recorded_pixel import ANY, WANTS, recorded
from verify.coq.recorder import values_of

LANES = [2, 4, 8, 16]
SIZE = (49, 32)
SCENES = {  # beside those that are drawn at random below
    "general": (Scene(ku=7.3, model="phong"), exact("general")),
    "central_rings": (Scene(field="rings", shininess=7.5), central(1e-6)),
    "forward": (Scene(ku=7.0, kv=3.5), forward(1e-2)),
    "five_lights": (Scene(lights=tuple(Light((3.0 * n - 6, 4, 9), (0.3, 0.4, 0.2)) for n in range(5))), exact()),
    "largest": (Scene(ku=2.0**20, kv=-(2.0**20), beta=1e100, ka=1e6, kd=1e6, ks=1e6, shininess=1e6), exact()),
    "least": (Scene(ku=5e-324, kv=1e-300, beta=-5e-324, shininess=1e-3), exact("general")),
    "sum": (Scene(field=HeightField("sum", sinpi(62 * u + 3 * k_v * v))), exact()),
    "tiny": (Scene(1e-60, 4e-60, False, lights=(Light((5e-60, 5e-60, 1e-59)),)), central(1e-3)),
}


@contextmanager
def drawn_by(drawer, smallest_band=stage.SMALLEST_BAND):
    """Let a machine's drawer draw, in bands of at least so many pixels."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(stage, "SMALLEST_BAND", smallest_band)
        monkeypatch.setattr(stage, "machine", lambda: SimpleNamespace(drawer=drawer))
        yield


numpy_draws = partial(drawn_by, numpy_rows.drawer)


def held(frame):
    """Return {name: array} of what a frame holds, the counts among it."""
    planes = {"rgb": frame.rgb, "chambers": frame.chambers, "on_a": frame.planes_on_a}
    return planes | {kind: np.array(count) for kind, count in frame._counts.items()}


def differing(one, other):
    """Return the names of what differs in two frames' arrays: any number that is not equal, but NaN is NaN."""
    assert one.keys() == other.keys()
    return [name for name in one if not np.array_equal(one[name], other[name], equal_nan=name in ("rgb", "on_a"))]


@given(scenes(), rasters(40), methods, st.sampled_from(LANES), st.data())
def test_whatever_the_scene_the_bits_are_the_same(scene, size, method, lanes, data):
    """Of a part of a picture too, which equals that part of the whole."""
    left, top = (data.draw(st.integers(0, side - 1)) for side in size)
    width, height = data.draw(st.integers(1, size[0] - left)), data.draw(st.integers(1, size[1] - top))
    draw, part = partial(render, scene, *size, method), np.s_[top : top + height, left : left + width]
    with numpy_draws():
        ours = draw((left, top, width, height))
    with drawn_by(partial(native.drawer, lanes=lanes), 1):
        assert differing(held(ours), held(draw(ours.raster.crop, threads=3))) == []
        complete = draw()
        for name in ("rgb", "chambers", "kink", "slope", "straddling"):
            np.testing.assert_array_equal(getattr(ours, name), getattr(complete, name)[part], name)


def test_code_is_kept_by_its_text_and_by_the_processor(tmp_path, monkeypatch):
    monkeypatch.setenv("SYMBOLIC_RENDERING_CODE", str(tmp_path))
    files = []
    for field, processor in (("ridges", "one"), ("sine", "one"), ("ridges", "other"), ("ridges", "one")):
        monkeypatch.setattr(native, "_processor", lambda processor=processor: processor)
        native.compiled.cache_clear()
        render(Scene(field=field), *SIZE)
        files.append(len(list(tmp_path.iterdir())))
    assert files == [1, 2, 3, 3]


@pytest.mark.parametrize("name", SCENES)
def test_bounds_change_no_bit_and_are_the_same(name):
    """By both machines; of a crop by several threads, and with a stage and a frame to draw into."""
    (scene, method), frames = SCENES[name], []
    plain = render(scene, *SIZE, method)
    for drawer in (native.drawer, numpy_rows.drawer):
        with drawn_by(drawer):
            frames.append(render(scene, *SIZE, method, bounds=True))
            assert differing(held(frames[-1]), held(plain)) == []
    part = render(scene, *SIZE, method, (3, 5, 40, 7), threads=3, bounds=True)
    over = render(scene, *SIZE, method, bounds=True, stage=plain.stage, into=plain)
    for frame, kind in product(frames, ("rgb", "bounds", "open")):
        assert (getattr(part, kind) == getattr(frame, kind)[5:12, 3:43]).all()
        assert (getattr(over, kind) == getattr(frame, kind)).all()


@pytest.mark.parametrize("name", ["central_rings", "sum"])
def test_slopes_change_no_bit_and_are_the_same(name):
    """By both machines, alone or together; of a crop by several threads, and of A alone on a stage."""
    (scene, method), names = SCENES[name], ("beta", "kd")
    draw = partial(render, scene, *SIZE, method)
    plain, together = draw(bounds=True), draw(derivatives=names, bounds=True)
    with numpy_draws():
        ours = draw(derivatives=names)
    assert differing(held(ours), held(plain)) == differing(held(together), held(plain)) == []
    assert (together.bounds == plain.bounds).all()
    part, slopes = draw((3, 5, 40, 7), threads=3, derivatives=names), together.derivatives
    of_one = pixel(scene, *SIZE, 24, 16, method, names).derivatives
    assert of_one == {name: tuple(slope[16, 24].tolist()) for name, slope in slopes.items()}
    assert (ours.derivative({"beta": 2.0, "kd": -1.0}) == 2.0 * slopes["beta"] - slopes["kd"]).all()
    for by, on in (("beta", plain.stage.on_a), ("kd", plain.chambers & 3)):
        alone = draw(derivatives=[by], stage=plain.stage)
        assert (part.derivatives[by] == slopes[by][5:12, 3:43]).all()
        assert all((other.derivatives[by] == slopes[by]).all() for other in (ours, alone))
        assert alone.work["slopes"][by] == np.count_nonzero(on)


RECORDING = recorded()


def done(name, *numbers):
    """Return the result of a recorded operation."""
    if name == "product_error":
        return kernels.two_product(*numbers)[1]
    return (getattr(operator, f"__{name}__", None) or getattr(kernels, name))(*numbers)


def of_any(shot, known_powers):
    """Return a scene's numbers, as the recorded program of any scene takes them, and the lights'."""
    numbers, lights = numbers_of(shot)
    chosen = of_form(SCENE_FORM, map(np.asarray, numbers))
    chosen.way = ANY.ways.index((shot.scene.field, "general" if known_powers else shot.way))
    chosen.bump, chosen.model = BUMPS.index(shot.scene.bump), ANY.lights.index(shot.want.lights[0])
    return chosen, lights


@given(scenes(), rasters(), methods)
@example(Scene(), SIZE, exact())
def test_a_recorded_pixel_has_the_bits_of_the_picture(scene, size, method):
    """The default scene's as it is drawn; any other's by the gradient's general form and a power that is not whole."""
    known = scene == Scene()
    if not known:
        scene = replace(scene, shininess=scene.shininess % 1e5 // 1 + 0.5)
        method = exact("general") if method.name == "exact" else method
    frame = render(scene, *size, method)
    chosen, lights = of_any(frame.shot, known)
    x, y = frame.raster.image_points(scene)
    inputs = chain((x, y[:, None], 0.0, 0.0), flat(chosen), lights.ravel(), repeat(np.zeros(())))
    with np.errstate(all="ignore"):
        numbers = values_of(RECORDING.lines, inputs, done)
    drawing = len(WANTS) * len(lights) + (2 if known else scene.horizon)
    code, *colors = (numbers[RECORDING.outputs[name][drawing]] for name in ("code", *COLORS))
    assert (code == frame.chambers).all()
    assert all((color == plane).all() for color, plane in zip(colors, frame.planes, strict=True))


@pytest.mark.parametrize("field", ["ridges", "rings", HeightField("sum", sinpi(62 * u + 3 * k_v * v))])
def test_at_points_the_bits_are_the_same(field, monkeypatch):
    """Slopes by every method, heights, and the data of a frame: points that fill no whole group."""
    scene, at = Scene(field=field), np.random.default_rng(53).random((2, 3, 1401))

    def computed():
        slopes = [gradient_at(scene, *at, each) for each in (exact(), forward(1e-3), central(1e-4))]
        data = render(scene, 128, 99, central(1e-3)).data_on_a
        return [height_at(scene, *at), *(slope for pair in slopes for slope in pair), *data.values()]

    compiled, few = computed(), []
    monkeypatch.setattr(machines, "FEW_POINTS", np.inf)
    monkeypatch.setattr(native, "over_points", lambda *given: few.append(given))
    assert all(np.array_equal(one, other) for one, other in zip(compiled, computed(), strict=True)) and not few
