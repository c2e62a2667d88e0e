"""The shader for processors that this machine is not draws the same bytes, bounds too: emulated, or by fewer features.

An emulator (qemu-user) runs it for aarch64 and riscv64, linked by Debian's cross compilers.
"""

import platform
import shutil
import subprocess
from types import SimpleNamespace

import llvmlite.binding as llvm
import llvmlite.ir as ir
import pytest

from renderer.machines import native, numpy_rows
from renderer.machines.drawing_code import emit
from tests.drawing_memory import drawer_over_memory
from tests.test_machines import SCENES
from tests.test_webassembly import assert_noticed, bytes_of

pytestmark = pytest.mark.long
LANES = 4
BASE = 2**36
DRIVER = f"""
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
void draw(void *);
int main(int count, char **names) {{
    struct stat status;
    int file = open(names[1], O_RDWR);
    if (fstat(file, &status)) return 2;
    void *at = mmap((void *){BASE}, status.st_size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file, 0);
    if (at == MAP_FAILED) return 3;
    draw(at);
    return 0;
}}
"""
ELSEWHERE = {
    "aarch64": SimpleNamespace(triple="aarch64-linux-gnu", features="+neon", options={}),
    "riscv64": SimpleNamespace(triple="riscv64-linux-gnu", features="+m,+a,+f,+d,+c", options={"abiname": "lp64d"}),
}
HERE = {
    "sse2": ("x86-64", ""),
    "avx2": ("haswell", "-fma"),
    "avx2 and its fused products": ("haswell", ""),
    "avx512": ("skylake-avx512", ""),
}


@pytest.fixture(params=ELSEWHERE)
def elsewhere(request, tmp_path):
    """A machine's `drawer` that draws on another processor, emulated."""
    name, asked = request.param, ELSEWHERE[request.param]
    compiler, emulator = f"{asked.triple}-gcc", f"qemu-{name}"
    missing = [tool for tool in (compiler, emulator) if not shutil.which(tool)]
    if missing:
        pytest.skip(f"{' and '.join(missing)} not installed")
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple(asked.triple).create_target_machine(
        features=asked.features, opt=2, reloc="pic", codemodel="small", **asked.options
    )

    def run(want, memory):
        module = ir.Module()
        module.triple = asked.triple
        emit(module, "draw", want, LANES)
        (tmp_path / "draw.o").write_bytes(target.emit_object(native.optimized(module, target)))
        (tmp_path / "main.c").write_text(DRIVER)
        (tmp_path / "memory").write_bytes(memory)
        link = [compiler, "-static", "-o", "program", "main.c", "draw.o", "-lm"]
        for command in (link, [emulator, "./program", "memory"]):
            subprocess.run(command, cwd=tmp_path, check=True)
        return (tmp_path / "memory").read_bytes()

    return drawer_over_memory(run, BASE)


@pytest.mark.parametrize("name", SCENES)
def test_another_processor_draws_the_same_bytes(name, elsewhere):
    assert bytes_of(elsewhere, *SCENES[name]) == bytes_of(numpy_rows.drawer, *SCENES[name])


def test_another_processor_that_bounds_otherwise_is_noticed(elsewhere):
    assert_noticed(elsewhere)


@pytest.mark.skipif(platform.machine() not in ("x86_64", "AMD64"), reason="these are features of x86")
@pytest.mark.parametrize("features", HERE)
def test_an_older_or_newer_x86_draws_the_same_bytes(features, monkeypatch):
    """`avx2 and its fused products`: LLVM may, but must not, round a product and a sum at once."""
    processor, text = HERE[features]
    if "avx512" in features and not llvm.get_host_cpu_features().get("avx512f"):
        pytest.skip("this processor has no AVX-512")
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    here = llvm.Target.from_default_triple()
    monkeypatch.setattr(native, "_target", lambda: here.create_target_machine(cpu=processor, features=text, opt=2))
    monkeypatch.setenv("SYMBOLIC_RENDERING_CODE", "off")
    for name, asked in SCENES.items():

        def drawer(want, job):
            code, engine = native.machine_code(emit, want, LANES)
            draw = native.drawer(want, job, code=code)
            draw.engine = engine
            return draw

        assert bytes_of(drawer, *asked) == bytes_of(numpy_rows.drawer, *asked), name
