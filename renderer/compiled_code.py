"""What Numba compiles for, and where it keeps the code: in a folder of its own for every version of the sources.

Numba's cache looks at the file of the function that it keeps, and not at the files of those that it calls, so that an
edited formula would go on drawing as before. Import this before anything is compiled.
"""

import hashlib
import os
import tempfile
from pathlib import Path

import numba
from numba.core.codegen import get_host_cpu_features

HERE = Path(__file__).resolve().parent


def sources_digest():
    """Return a hash of the renderer's sources."""
    digest = hashlib.sha256()
    for path in sorted(HERE.glob("*.py")):
        digest.update(path.name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def cache_folder():
    """Return the folder: under NUMBA_CACHE_DIR where that is set, else beside the sources, else a temporary one."""
    chosen = os.environ.get("NUMBA_CACHE_DIR")
    beside = HERE / "__pycache__"
    writable = os.access(beside if beside.exists() else HERE, os.W_OK)
    base = Path(chosen) if chosen else beside if writable else Path(tempfile.gettempdir()) / f"renderer-{os.getuid()}"
    return base / sources_digest()


numba.config.CACHE_DIR = str(cache_folder())
if numba.config.CPU_FEATURES is None and "+avx512f" in (features := get_host_cpu_features()).split(","):
    # LLVM holds to 256 bits by itself, lest a few wide instructions slow the processor; these loops are nothing else.
    numba.config.CPU_FEATURES = f"{features},-prefer-256-bit"
