"""One program, three back ends: Numba's text and NumPy's agree bit for bit, mpmath's to rounding, point by point.

The Numba text is run as plain Python, the same operations in the same order; with --long the compiled kernels too.
"""

import numpy as np
import pytest

from proofs.height_fields import HEIGHT_FIELDS
from renderer import kernels
from renderer.generate.fused import FUSED_KERNELS
from renderer.generate.kernel_list import ROW_KERNELS, SCALAR_PROGRAMS, RowKernel, field_kernels
from renderer.generate.printers import NumPyPrinter
from renderer.generate.source import elementary_functions, kernels_source, print_function
from verify.reference import Reference

POINTS = 48
KERNELS = {
    kernel.program.name: kernel
    for kernel in (
        *ROW_KERNELS,
        *FUSED_KERNELS,
        *(k for field in HEIGHT_FIELDS.values() for k in field_kernels(field)),
        *(RowKernel(program, ()) for program in SCALAR_PROGRAMS),
    )
}
RANGES = {
    "eye": (3, 5), "radius": (0.5, 1), "ball_radius": (0.3, 0.5), "body_radius": (0.3, 0.5), "height": (64, 64),
    "width": (96, 96), "column": (0, 95), "row": (0, 63), "ball_on": (1, 1), "floor_on": (1, 1), "half": (1, 2),
    "ball_center_z": (1.2, 1.6), "light_z": (6, 9), "k_u": (-9, 9), "k_v": (-9, 9), "u": (0, 1), "v": (0, 1),
    "epsilon": (0.01, 0.05), "specular_base": (0, 1), "specular": (0, 1), "shininess": (0.5, 40),
    "floor_dark": (0, 1), "view_scale": (0.2, 0.3), "tangent_squared": (8, 9),
}  # fmt: skip


def plain_kernels():
    """Return the names of renderer/kernels.py, its functions not compiled."""
    text = kernels_source().replace("from numba import njit", "njit = lambda **options: lambda function: function")
    scope = {}
    exec(text, scope)
    return scope


PLAIN = plain_kernels()


def numpy_functions():
    scope = {"np": np}
    for name, program in elementary_functions():
        exec(print_function(name, program, NumPyPrinter(), ""), scope)
    return scope


NUMPY = numpy_functions()


def assert_same(name, numba, numpy):
    """Assert equality to the last bit; `highlight` alone calls pow, which is each library's own: 2 ulp."""
    for a, b in zip(numba, numpy, strict=True):
        if name == "highlight":
            np.testing.assert_array_max_ulp(a, b, 2)
        else:
            np.testing.assert_array_equal(a, b)


def random_inputs(kernel):
    """Return {name: float, or array of POINTS for a row} for a kernel's inputs, in the domain of its program."""
    rng = np.random.default_rng(len(kernel.program.name))
    angle_theta, angle_phi = rng.uniform(-np.pi, np.pi, POINTS), rng.uniform(0.01, np.pi - 0.01, POINTS)
    fixed = {
        "cos_theta": np.cos(angle_theta), "sin_theta": np.sin(angle_theta),
        "cos_phi": np.cos(angle_phi), "sin_phi": np.sin(angle_phi),
    }  # fmt: skip
    values = {}
    for symbol in kernel.program.inputs:
        row = fixed.get(symbol.name, rng.uniform(*RANGES.get(symbol.name, (-1, 1)), POINTS))
        values[symbol.name] = row if symbol in kernel.rows else np.float64(row[0])
    return values


def run_numpy(kernel, values):
    """Return the outputs by the program printed for NumPy, line by line."""
    scope, printer = NUMPY | values, NumPyPrinter()
    with np.errstate(all="ignore"):
        for symbol, expression in kernel.program.definitions:
            scope[symbol.name] = eval(printer.doprint(expression), scope)
    size = POINTS if kernel.rows else 1
    return [np.broadcast_to(np.float64(scope[s.name]), (size,)).copy() for s in kernel.program.outputs]


def run_kernel(kernel, values, functions):
    """Return the outputs of the row kernel (or scalar function) of that name among `functions`."""
    program = kernel.program
    if not kernel.rows:
        result = functions[program.name](*(values[s.name] for s in program.inputs))
        return [np.array([r]) for r in (result if isinstance(result, tuple) else (result,))]
    rows = {name: value.copy() for name, value in values.items() if isinstance(value, np.ndarray)}
    arguments = [rows.get(s.name, values[s.name]) for s in program.inputs]
    outputs = []
    for target in kernel.into or program.outputs:
        if target.name in rows and f"{target.name}" in {s.name for s in kernel.rows}:
            outputs.append(rows[target.name])
        else:
            outputs.append(np.empty(POINTS))
            arguments.append(outputs[-1])
    with np.errstate(all="ignore"):
        functions[f"{program.name}_row"](*arguments, 0, POINTS)
    return outputs


@pytest.mark.parametrize("name", KERNELS)
def test_numba_and_numpy_agree_bit_for_bit(name):
    kernel = KERNELS[name]
    values = random_inputs(kernel)
    assert_same(name, run_kernel(kernel, values, PLAIN), run_numpy(kernel, values))


@pytest.mark.long
@pytest.mark.parametrize("name", KERNELS)
def test_the_compiled_kernel_agrees_bit_for_bit(name):
    kernel = KERNELS[name]
    values = random_inputs(kernel)
    assert_same(name, run_kernel(kernel, values, vars(kernels)), run_numpy(kernel, values))


@pytest.mark.parametrize("name", KERNELS)
def test_mpmath_agrees(name):
    """float64 against 50 digits at six points: 1e-11, or what a difference of step ε ≥ 0.01 amplifies it to."""
    kernel = KERNELS[name]
    values, reference = random_inputs(kernel), Reference(kernel.program)
    outputs = run_kernel(kernel, values, PLAIN)
    for point in range(6 if kernel.rows else 1):
        here = {n: float(v[point]) if isinstance(v, np.ndarray) else float(v) for n, v in values.items()}
        truth = reference(here)
        for symbol, output in zip(kernel.program.outputs, outputs, strict=True):
            expected = float(truth[symbol.name])
            assert output[point] == pytest.approx(expected, rel=1e-11, abs=1e-11, nan_ok=True), symbol
