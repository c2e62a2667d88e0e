"""The verb doctor: what draws here, by how many threads, in which versions, and where compiled code is kept."""

import os
import platform
from importlib import metadata

import numpy as np

import renderer
from renderer.machines import kept_code, machine
from renderer.scene.scene import Scene
from renderer.shader.numbers import Shot
from renderer.threads import available_cores

EXTRAS = {"plot": "matplotlib", "tiff": "tifffile", "dask": "distributed", "checker": "python-flint"}


def report() -> list[tuple[str, str]]:
    """Return [(name, value)], both text."""
    return [
        ("symbolic-rendering", renderer.__version__),
        ("Python", f"{platform.python_version()} ({platform.python_implementation()}, {platform.platform()})"),
        ("NumPy", np.__version__),
        ("zlib-ng", _version("zlib-ng")),
        *_machine(),
        ("threads", f"{available_cores()} at most, unless --threads says otherwise"),
        ("compiled code", _kept()),
        *((f"extra {extra}", _version(package)) for extra, package in EXTRAS.items()),
    ]


def _machine():
    if machine().NAME == "numpy":
        return [("machine", "numpy: the same bits, slowly, as llvmlite is not installed or too old")]
    import llvmlite.binding as llvm

    from renderer.machines.native import host_lanes

    version = ".".join(map(str, llvm.llvm_version_info))
    lanes = host_lanes(Shot(Scene()).want)
    return [
        ("llvmlite", f"{metadata.version('llvmlite')} (LLVM {version})"),
        ("machine", f"llvm: {llvm.get_host_cpu_name()}, {lanes} pixels at a time in the default scene"),
    ]


def _kept():
    kept_in = kept_code.folder()
    if kept_in is None:
        return f"not kept: {kept_code.VARIABLE} is off, or the user has no home"
    if not os.path.lexists(kept_in):
        return f"{kept_in} (not there yet)"
    if not kept_code.trusted(kept_in):
        return f"not kept: {kept_in} is not a folder of this user's that nobody else may write to"
    sizes = [path.stat().st_size for path in kept_in.glob("*.o")]
    return f"{kept_in} ({len(sizes)} files, {sum(sizes) / 2**20:.1f} MiB)"


def _version(package):
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "not installed"
