"""The text of `book/static/simulator/kernels.js`: the renderer's kernels, printed for the simulator."""

import json
from dataclasses import asdict

from matplotlib import colormaps
from sympy import diff

from proofs import camera, elementary, step_bounds
from proofs.algebraic_form import MAX_WAVE_NUMBER
from proofs.height_fields import HEIGHT_FIELDS
from proofs.program import chain
from proofs.symbols import u, v
from renderer.generate.fused import COUNTS, geometry_kernel, terms_kernel
from renderer.generate.kernel_list import ONCE_A_SCENE, ROW_KERNELS, RowKernel, field_kernels
from renderer.generate.printers_javascript import PRINTER, print_row_kernel, print_scalar_function
from renderer.generate.source import CORES, of_a_number, wave_numbers_program
from renderer.scene import Scene

HEADER = """// Generated from proofs/ by `python -m renderer.generate`. Do not edit: change the expression instead.
//
// Each `*_row` function runs over the pixels start <= i < stop of a row: arguments ending in `_row` are Float64Arrays,
// the others are numbers, and results are written to the last arrays. Bit for bit the kernels of renderer/kernels.py.
// One function stands around them all, so that a worker can be made from its text.
"use strict";
var Simulator = Simulator || {};

Simulator.kernels = function () {
"""

HELPERS = """
let spare = [];

function spare_rows(count, length) {
  if (spare.length < count || spare[0].length < length) {
    spare = Array.from({ length: Math.max(count, spare.length) }, () => new Float64Array(length));
  }
  return spare;
}

function maximum(a, b) {
  return b > a ? b : a;
}

function minimum(a, b) {
  return b < a ? b : a;
}

function sign(a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}

// To the nearest whole number, ties to even, the sign of zero kept: adding 2^52 leaves no bits for a fraction.
function rint(a) {
  const size = Math.abs(a), rounded = size + 4503599627370496 - 4503599627370496;
  return size > 0 && size < 4503599627370496 ? (a < 0 ? -rounded : rounded) : a;
}
"""

UNUSED = {
    "tangent_interval",
    "shadow_clearance",
    "sixteenth_power",
    "complex_square_twice",
    "chart_v",
    "highlight",
    "diffuse_term",
    "light_cosine_on_floor",
    "blinn",
    "blinn_on_floor",
}
"""What the simulator's scene, with its even shininess, has no use for."""

LIGHTS_ON_A = [
    *(geometry_kernel(style, count, "a") for style in ("phong", "squared") for count in COUNTS),
    *(terms_kernel(count, dull=False) for count in COUNTS),
]

PLOT_PROGRAMS = [
    camera.parallel_radius,
    step_bounds.truncation_bound,
    step_bounds.clamped_bound,
    step_bounds.rounding_bound,
    step_bounds.crease_bound,
    step_bounds.slope_bound,
]
"""What the plots draw: exact loci and proved bounds."""


def elementary_kernels():
    """Return the row kernels of sine and cosine of a product, and of the arctangent."""
    a, b = elementary.a, elementary.b
    kernels = [
        RowKernel(chain(f"{name}_of_product", elementary.two_product, core), (b,)) for name, core in CORES.items()
    ]
    assert kernels[0].program.inputs == (a, b)
    arctangent = elementary.angle_in_half_turns
    return [*kernels, RowKernel(chain("atan2pi", arctangent), arctangent.inputs)]


def _field_parts(fields):
    """Return the texts of the fields' kernels, after sine and cosine of a row of numbers where one of them calls it."""
    parts = []
    for field in fields:
        parts += [print_row_kernel(kernel) for kernel in field_kernels(field)]
        if field.wave_numbers:
            parts.append(print_scalar_function(f"wave_numbers_{field.name}", wave_numbers_program(field)))
    called = [name for name in CORES if any(f" {name}_row(" in part for part in parts)]
    return [*(print_row_kernel(RowKernel(of_a_number(name), (elementary.product,))) for name in called), *parts]


def _field_entry(field):
    """Return the text of a field's entry in the table: its kernels, wave numbers and creases."""
    lines = []
    for kernel in field_kernels(field):
        lines.append(f"{kernel.program.name.removesuffix(f'_{field.name}')}: {kernel.program.name}_row,")
    lines.append(f"wave_numbers: {f'wave_numbers_{field.name}' if field.wave_numbers else 'null'},")
    rates = [(c, diff(factor.args[0], c)) for factor in field.creases for c in (u, v)]
    creases = ", ".join(f'["{c}", (k_u, k_v) => {PRINTER.doprint(rate)}]' for c, rate in rates if rate != 0)
    lines.append(f"creases: [{creases}],")
    return "\n".join([f"  {field.name}: {{", *(f"    {line}" for line in lines), "  },"])


def _default_scene():
    """Return the numbers of the renderer's default scene."""
    return asdict(Scene())


def _colour_map():
    """Return the 256 colours of inferno as hexadecimal digits."""
    return bytes(colormaps["inferno"](range(256), bytes=True)[:, :3]).hex()


def javascript_source():
    """Return the text of book/static/simulator/kernels.js."""
    fields, names, parts = HEIGHT_FIELDS.values(), [], [HELPERS]
    for program in (*(p for p in ONCE_A_SCENE if p.name not in UNUSED), *PLOT_PROGRAMS):
        parts.append(print_scalar_function(program.name, program))
        names.append(program.name)
    for kernel in (*elementary_kernels(), *(k for k in ROW_KERNELS if k.program.name not in UNUSED), *LIGHTS_ON_A):
        parts.append(print_row_kernel(kernel))
        names.append(f"{kernel.program.name}_row")
    parts += _field_parts(fields)
    table = "\n".join(["const fields = {", *map(_field_entry, fields), "};", ""])
    constants = f"const max_algebraic = {MAX_WAVE_NUMBER};\n"
    constants += f"const scene = {json.dumps(_default_scene())};\n"
    constants += f'const inferno = "{_colour_map()}";\n'
    exported = ["fields", "scene", "inferno", "max_algebraic", "rint", *names]
    lines = "".join(f"  {name},\n" for name in exported)
    return HEADER + "\n".join([*parts, table, constants, f"return {{\n{lines}}};\n"]) + "};\n"
