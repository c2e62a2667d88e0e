"""Older and newer x86 processors draw the same bits, bounds too: every target of LLVM whose features this one has."""

import platform

import llvmlite.binding as llvm
import pytest

from renderer import Scene, central, render
from renderer.machines import native, numpy_rows
from renderer.machines.drawing_code import emit
from tests.test_machines import SIZE, drawn_by

pytestmark = pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="these are features of x86")
AVX2 = "avx2 fma"
AVX512 = f"{AVX2} avx512f avx512bw avx512dq avx512vl"
DRAWN = Scene(ku=7.3, model="phong", shininess=7.5), central(1e-6)
TARGETS = {  # {LLVM's processor: lanes, the features that it needs}
    "x86-64": (2, ""),
    "x86-64-v2": (4, ""),
    "x86-64-v3": (4, AVX2),
    "x86-64-v4": (8, AVX512),
    "haswell": (4, AVX2),
    "znver4": (8, AVX512),
    "skylake-avx512": (16, AVX512),
    "sapphirerapids": (8, AVX512),
    "cascadelake": (16, AVX512),
}


def bytes_of(drawer, scene, method):
    """Return the bytes of all that a machine's frame with bounds holds, by name, and what it counted."""
    with drawn_by(drawer):
        frame = render(scene, *SIZE, method, threads=1, bounds=True)
    return {name: getattr(frame, name).tobytes() for name in ("rgb", "chambers", "bounds", "open")} | frame._counts


@pytest.mark.parametrize("name", TARGETS)
def test_another_processor_draws_the_same_bits(name, monkeypatch):
    """A difference, Phong and a power that is not whole: LLVM may, but must not, fuse a product and a sum."""
    lanes, needs = TARGETS[name]
    here = llvm.get_host_cpu_features()
    if missing := [feature for feature in needs.split() if not here.get(feature)]:
        pytest.skip(f"this processor has no {', '.join(missing)}")
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    triple = llvm.Target.from_default_triple()
    monkeypatch.setattr(native, "_target", lambda: triple.create_target_machine(cpu=name, opt=2))
    monkeypatch.setenv("SYMBOLIC_RENDERING_CODE", "off")

    def drawer(want, job):
        code, engine = native.machine_code(emit, want, lanes)
        draw = native.drawer(want, job, code=code)
        draw.engine = engine
        return draw

    assert bytes_of(drawer, *DRAWN) == bytes_of(numpy_rows.drawer, *DRAWN)
