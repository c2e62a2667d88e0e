"""The shader as machine code for this processor, compiled by LLVM when it is first wanted and kept for the process.

`renderer.machines.kept_code` keeps it for other processes too.
"""

import ctypes
import hashlib
from array import array
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import llvmlite.ir as ir
import numpy as np
from llvmlite.binding import create_pass_builder, create_pipeline_tuning_options  # since 0.44

from renderer.machines import Job, compiling, kept_code, numpy_rows
from renderer.machines.drawing_code import arguments, emit
from renderer.machines.points_code import emit_levels, emit_points
from renderer.machines.traced import BYTE, FLOAT
from renderer.threads import run_bands

NAME = "llvm"
POINTS = 8  # go through a kernel's code at a time
BYTES = 16
GROUPS = 2**12  # of them, on a thread


@cache
def host_lanes(want: Any) -> int:
    """Return how many pixels go through the code at a time: 512 bits of them at least, where there are vectors.

    A difference's heights, a power and bounds are long chains of dependent operations: twice as many lanes hide each
    other's latency.
    """
    features = llvm.get_host_cpu_features()
    wide = 8 if features.get("avx") else 4
    return 2 * wide if (want.is_long or want.bounds) and features.get("avx512f") else wide


def _target():
    """Return LLVM's machine for this processor."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    features = llvm.get_host_cpu_features()
    text = features.flatten()
    if features.get("avx512f"):  # LLVM holds to 256 bits by itself, lest a few wide instructions slow the processor
        text += ",-prefer-256-bit"
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(cpu=llvm.get_host_cpu_name(), features=text, opt=2)


def optimized(module: ir.Module | str, target: llvm.TargetMachine) -> llvm.ModuleRef:
    """Return LLVM's module of a text, simplified: the shader is vectors already, so loops stay as they are."""
    parsed = llvm.parse_assembly(str(module))
    parsed.verify()
    tuning = create_pipeline_tuning_options(speed_level=2)
    tuning.loop_vectorization = tuning.slp_vectorization = tuning.loop_unrolling = tuning.loop_interleaving = False
    passes = create_pass_builder(target, tuning)
    passes.getModulePassManager().run(parsed, passes)
    return parsed


def _processor():
    """Return this processor's name and features."""
    return llvm.get_host_cpu_name() + llvm.get_host_cpu_features().flatten()


def _object_code(text, target):
    """Return the object code (bytes) of a module's text: compiled, or as an earlier process of this kind left it."""
    how = Path(__file__).read_text(encoding="utf-8")
    versions = f"{llvmlite.__version__} {llvm.llvm_version_info}"
    key = hashlib.sha256("\n".join([versions, _processor(), how, text]).encode()).hexdigest()
    code = kept_code.load(key)
    if code is None:
        code = target.emit_object(optimized(text, target))
        kept_code.save(key, code)
    return code


def machine_code(emit_into: Callable, *given: Any, **named: Any) -> tuple[Callable[[int], None], llvm.ExecutionEngine]:
    """Return (the function of one address that emit_into(module, name, …) emits; the owner of its memory)."""
    module, target, name = ir.Module(), _target(), "code"
    module.triple = llvm.get_process_triple()
    emit_into(module, name, *given, **named)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target)
    engine.add_object_file(llvm.ObjectFileRef.from_data(_object_code(str(module), target)))
    engine.finalize_object()
    return ctypes.CFUNCTYPE(None, ctypes.c_void_p)(engine.get_function_address(name)), engine


@cache
def _points_code(kernel, everywhere):
    """Return (the function that runs a kernel over points, of the address of its arguments; its outputs; the owner)."""
    outputs: list[int] = []
    code, owner = machine_code(lambda *module: outputs.append(emit_points(*module, kernel, POINTS, FLOAT, everywhere)))
    return code, outputs[0], owner


def over_points(kernel: Callable, *inputs: Any) -> list[np.ndarray]:
    """Return what a kernel gives at each point, an array for each output; inputs: arrays (points,), or one number."""
    with compiling:
        code, outputs, _ = _points_code(kernel, tuple(n for n, each in enumerate(inputs) if np.size(each) == 1))
    given, points = [np.ascontiguousarray(each) for each in inputs], np.broadcast(*inputs).size
    results, together = np.empty((outputs, points)), points - points % POINTS
    places = [(each.ctypes.data, each.itemsize * (each.size > 1)) for each in (*given, *results)]

    def part(band):
        first, end = (POINTS * group for group in (band.start, band.stop))
        arguments = array("q", [end - first, *(place + step * first for place, step in places)])
        code(arguments.buffer_info()[0])

    run_bands(part, together // POINTS, GROUPS, None)
    if together < points:
        rest = (each[together:] if each.size > 1 else each for each in given)
        results[:, together:] = numpy_rows.over_points(kernel, *rest)
    return [*results]


_levels_code = cache(partial(machine_code, emit_levels))


def write_levels(numbers: np.ndarray, begins: np.ndarray, level_at: np.ndarray, levels: np.ndarray) -> None:
    """Write the levels of numbers, (rows, columns), as `numpy_rows.write_levels` does."""
    with compiling:
        code, _ = _levels_code(len(level_at) - 1)
    places = (each.ctypes.data for each in (numbers, levels, begins, level_at))
    arguments = array("q", [*places, *numbers.shape, *numbers.strides, *levels.strides])
    code(arguments.buffer_info()[0])


_bytes_code = cache(partial(machine_code, emit_points, lanes=BYTES, number=ir.FloatType(), kind=BYTE))


def over_bytes(kernel: Callable, *inputs: np.ndarray) -> np.ndarray:
    """Return what a kernel gives of bytes, as bytes; inputs: contiguous, a multiple of BYTES long."""
    with compiling:
        code, _ = _bytes_code(kernel)
    result = np.empty_like(inputs[0])
    arguments = array("q", [len(result), *(each.ctypes.data for each in (*inputs, result))])
    code(arguments.buffer_info()[0])
    return result


@cache
def compiled(want: Any, lanes: int) -> tuple[Callable[[int], None], llvm.ExecutionEngine]:
    """Return (the function that draws a want, of the address of its arguments; the owner of its memory)."""
    return machine_code(emit, want, lanes)


@cache
def _layout(want):
    """Return ({name of an argument: its place}, counts of nothing)."""
    names = arguments(want.shader.planes)
    return {name: place for place, name in enumerate(names)}, array("q", [0] * len(want.shader.counted))


def drawer(
    want: Any, job: Job, lanes: int | None = None, code: Callable[[int], None] | None = None
) -> Callable[[slice], list[int]]:
    """Return the function that draws rows (a slice) of a Job and returns the counts, in the shader's order.

    lanes: how many pixels at a time (default: `host_lanes`). code: the function to call, if it is not to be kept.
    """
    if code is None:
        with compiling:
            code, _ = compiled(want, lanes or host_lanes(want))
    places, counted = _layout(want)
    shared = array("q", bytes(8 * len(places)))
    shared[places["pitch"]], shared[places["light_count"]] = len(job["x"]), len(job["lights"])
    for name, memory in job.items():
        if memory.size:
            shared[places[name]] = ctypes.addressof(ctypes.c_char.from_buffer(memory))  # type: ignore[arg-type]
    first, last, counts = (places[name] for name in ("first_row", "last_row", "counts"))

    def draw(rows):
        arguments, counts_here = shared[:], counted[:]
        arguments[first], arguments[last], arguments[counts] = rows.start, rows.stop, counts_here.buffer_info()[0]
        code(arguments.buffer_info()[0])
        return counts_here.tolist()

    draw.alive = job  # type: ignore[attr-defined]  # whose addresses it has
    return draw
