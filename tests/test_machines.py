"""NumPy draws what LLVM draws, in groups of any size, to the last bit."""

from contextlib import contextmanager
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from renderer import Light, Scene, central, central4, exact, forward, kernels, render, stage_of
from renderer.machines import native, numpy_rows
from renderer.picture import stage
from tests.strategies import methods, rasters, scenes

LANES = [2, 4, 8, 16]
SIZE = (49, 32)
SCENES = {  # beside those that are drawn at random below
    "ridges": (Scene(), exact()),
    "central": (Scene(field="sine"), central(1e-3)),
    "forward": (Scene(ku=7.0, kv=3.5), forward(1e-2)),
    "central4": (Scene(field="rings"), central4(1e-2)),
    "no_floor": (Scene(floor=False), central(1e-2)),
    "fractional": (Scene(shininess=7.5), exact()),
    "fractional_phong": (Scene(shininess=0.7, model="phong"), central(1e-2)),
    "five_lights": (Scene(lights=tuple(Light((3.0 * n - 6, 4, 9), (0.3, 0.4, 0.2)) for n in range(5))), exact()),
    "largest": (Scene(ku=2.0**20, kv=-(2.0**20), beta=1e100, ka=1e6, kd=1e6, ks=1e6, shininess=1e6), exact()),
    "least": (Scene(ku=5e-324, kv=1e-300, beta=-5e-324, shininess=1e-3), exact("general")),
    "widest_step": (Scene(beta=1e100), forward(0.5)),
    "least_step": (Scene(field="rings", beta=1e100), central4(1e-40)),
    "near": (Scene(radius=4 * (1 - 1e-9), ball=False, lights=(Light((9, 9, 9)),)), exact()),
    "far": (Scene(eye=1e6, ball=False), exact()),
    "tiny": (Scene(1e-60, 4e-60, False, lights=(Light((5e-60, 5e-60, 1e-59)),)), central(1e-3)),
    "huge": (Scene(1e60, 4e60, False, lights=(Light((5e60, 5e60, 1e61)),)), exact()),
}


@contextmanager
def drawn_by(drawer):
    """Let a machine's drawer draw."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(stage, "machine", lambda: SimpleNamespace(drawer=drawer))
        yield


def held(frame):
    """Return {name: array} of what a frame holds, the counts among it."""
    planes = {"rgb": frame.rgb, "chambers": frame.chambers, "on_a": frame.planes_on_a}
    return planes | {kind: np.array(count) for kind, count in frame._counts.items()}


def differing(one, other):
    """Return the names of what differs in two frames' arrays: any number that is not equal, but NaN is NaN."""
    assert one.keys() == other.keys()
    return [name for name in one if not np.array_equal(one[name], other[name], equal_nan=name in ("rgb", "on_a"))]


def picture(name):
    """Return the arrays of one of SCENES."""
    scene, method = SCENES[name]
    return held(render(scene, *SIZE, method))


@pytest.fixture(scope="module")
def by_numpy():
    """What NumPy draws of SCENES."""
    with drawn_by(numpy_rows.drawer):
        return {name: picture(name) for name in SCENES}


@pytest.mark.parametrize("lanes", LANES)
def test_pictures_by_llvm_are_numpys_to_the_last_bit(lanes, by_numpy):
    """All by 8 lanes, every third by others: what lanes change is the same code in all of them."""
    with drawn_by(partial(native.drawer, lanes=lanes)):
        for name in list(SCENES)[:: 1 if lanes == 8 else 3]:
            assert differing(picture(name), by_numpy[name]) == [], name


@given(scenes(), rasters(40), methods, st.sampled_from(LANES), st.data())
def test_whatever_the_scene_the_bits_are_the_same(scene, size, method, lanes, data):
    crop = None
    if data.draw(st.booleans()):
        left, top = (data.draw(st.integers(0, side - 1)) for side in size)
        crop = (left, top, *(data.draw(st.integers(1, s - n)) for s, n in zip(size, (left, top), strict=True)))
    frames = []
    for drawer in (numpy_rows.drawer, partial(native.drawer, lanes=lanes)):
        with drawn_by(drawer):
            frames.append(held(render(scene, *size, method, crop=crop)))
    assert differing(*frames) == []


def drawn(field="ridges"):
    """Draw as another process would."""
    native.compiled.cache_clear()
    with drawn_by(native.drawer):
        return held(render(Scene(field=field), *SIZE))


def test_code_that_was_kept_is_not_compiled_again(tmp_path, monkeypatch):
    expected = drawn()
    kept = tmp_path / "kept"
    monkeypatch.setenv("SYMBOLIC_RENDERING_CODE", str(kept))
    assert differing(drawn(), expected) == []
    number = len(list(kept.iterdir()))
    with monkeypatch.context() as patched:
        patched.setattr(native, "optimized", lambda *_: pytest.fail("compiled again"))
        assert differing(drawn(), expected) == []
    assert len(list(kept.iterdir())) == number > 0
    drawn("sine")  # another text
    monkeypatch.setattr(native, "_processor", lambda: "another")
    drawn()
    assert len(list(kept.iterdir())) == 3 * number


@pytest.mark.parametrize("threads", [1, 2, 3])
@pytest.mark.parametrize("width", [1, 15, 16, 17, 301])
def test_bands_threads_and_ragged_widths(width, threads, monkeypatch):
    """Bands of a row or two; also A alone, drawn on a stage and over an earlier frame."""
    monkeypatch.setattr(stage, "SMALLEST_BAND", 1)
    size, found = (width, 21), []
    for drawer, count in ((numpy_rows.drawer, 1), (native.drawer, threads)):
        with drawn_by(drawer):
            whole = render(Scene(), *size, central(1e-3), threads=count)
            own = stage_of(Scene(), *size, threads=count)
            staged = render(Scene(beta=0.1), *size, threads=count, stage=own)
            arrays = [held(whole), held(staged)]  # before the colours are handed over
            over = render(Scene(field="rings"), *size, threads=count, stage=own, into=staged)
            found.append([*arrays, held(over)])
    assert [differing(*pair) for pair in zip(*found, strict=True)] == [[], [], []]


@pytest.mark.parametrize("name", ["ridges", "central4", "fractional", "no_floor", "five_lights", "largest", "far"])
def test_bounds_change_no_bit_and_are_the_same(name):
    """By both machines; of a crop, of several threads, and with a stage and a frame to draw into."""
    (scene, method), frames = SCENES[name], []
    for drawer in (numpy_rows.drawer, native.drawer):
        with drawn_by(drawer):
            frames.append(render(scene, *SIZE, method, bounds=True))
    assert differing(*(held(frame) | {"bounds": frame.bounds, "open": frame.open} for frame in frames)) == []
    assert differing(picture(name), held(frames[0])) == []
    own = stage_of(scene, *SIZE)
    earlier = render(scene, *SIZE, method, stage=own)
    for part, more in (((slice(5, 12), slice(3, 43)), {"crop": (3, 5, 40, 7)}), ((), {"stage": own, "into": earlier})):
        frame = render(scene, *SIZE, method, threads=3, bounds=True, **more)
        assert (frame.bounds == frames[0].bounds[part]).all()
        assert (frame.open == frames[0].open[part]).all()
        assert (frame.rgb == frames[0].rgb[part]).all()


def test_memory_serves_again_once_no_array_lies_in_it():
    first = render(Scene(), *SIZE, threads=1)
    place, view = first.planes.ctypes.data, first.rgb[::2]
    colors = view.copy()
    del first
    second = render(Scene(beta=0.0), *SIZE, threads=1)
    assert second.planes.ctypes.data != place and (view == colors).all()
    del view
    assert render(Scene(), *SIZE, threads=1).planes.ctypes.data == place


def one_ulp(name):
    """Return a kernel whose first result is off by one unit in the last place."""
    right = getattr(kernels, name)

    def wrong(*arguments):
        first, *rest = right(*arguments)
        return first * (1.0 + 2.0**-52), *rest

    return wrong


def count_one_more(machine, kind, mask):
    """Count as `Rows.count` does, and one."""
    machine.counts[kind] += int(np.count_nonzero(mask)) + 1


@pytest.mark.parametrize(
    ("place", "name", "wrong", "noticed"),
    [
        (kernels, "light_term", one_ulp("light_term"), "rgb"),
        (kernels, "angles_on_a", one_ulp("angles_on_a"), "on_a"),
        (kernels, "shadow", lambda *arguments: 1.0, "chambers"),
        (numpy_rows.Rows, "count", count_one_more, "light_terms"),
    ],
)
def test_a_wrong_kernel_is_noticed(place, name, wrong, noticed, by_numpy, monkeypatch):
    """NumPy draws by it; LLVM's code is of the right ones."""
    monkeypatch.setattr(place, name, wrong)
    with drawn_by(numpy_rows.drawer):
        assert noticed in differing(picture("ridges"), by_numpy["ridges"])
