"""The text of `renderer/lights.py`: one or two lights on a run, by the kernel of the style and of their number."""

from renderer.generate.fused import COUNTS, PLACES, STYLES, geometry_kernel, terms_kernel
from renderer.generate.shaders import wrapped

HEADER = '''"""Generated from proofs/ by `python -m renderer.generate`. Do not edit: it is printed there.

One or two of the lights, `lights[first]` and `lights[second]`, on a run of `count` pixels: μ and the base of the
highlight into `mu` and `base`, the other light's into `other_mu` and `other_base`; then the colours.
"""

from renderer.kernels import (
'''
ROWS = {"mu": "mu", "specular_base": "base", "specular": "base"}
NUMBERS = {"kd": 0, "ks": 1, "red": 3, "green": 4, "blue": 5}
ALBEDO = {f"albedo_{color}": f"albedo[{n}]" for n, color in enumerate(("red", "green", "blue"))}
OF_A_LIGHT = {f"light_{part}": n for n, part in enumerate(("x", "y", "z", "red", "green", "blue"))}


def _argument(symbol):
    """Return what a kernel's name is called by its caller."""
    name, _, number = symbol.name.rpartition("_")
    if name in ROWS:
        return ROWS[name] if number == "1" else f"other_{ROWS[name]}"
    if name in OF_A_LIGHT:
        return f"lights[{'first' if number == '1' else 'second'}, {OF_A_LIGHT[name]}]"
    if name.startswith("lit_"):
        return name.removeprefix("lit_")
    if symbol.name in NUMBERS:
        return f"numbers[{NUMBERS[symbol.name]}]"
    return ALBEDO.get(symbol.name, symbol.name)


def _call(kernel):
    targets = [target for target in kernel.program.outputs if target not in kernel.program.inputs]
    arguments = [_argument(symbol) for symbol in (*kernel.program.inputs, *targets)]
    return wrapped(f"{kernel.program.name}_row", [*arguments, "0", "count"])


def _function(name, arguments, cases):
    """Return a function that calls, in the first of its cases (test, kernels by number of lights), the right one."""
    lines = [f"def {name}(", *(f"    {line}" for line in arguments), "):"]
    for test, kernels in cases:
        lines.append(f"    if {test}:")
        for kernel in kernels:
            lines += [f"        {'if lit == 1' if kernel is kernels[0] else 'else'}:"]
            lines += [f"            {line}" for line in _call(kernel)]
    return "\n".join(["", "", "@inlined", *lines, ""])


def lights_source():
    """Return the text of renderer/lights.py."""
    common = ["lights, first, second, lit, mu, base, other_mu, other_base, dull, phong, blinn, squared, count,"]
    given = {
        "floor": ["x, y, eye,"],
        "a": ["cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye,"],
    }
    parts, kernels = [], []
    for place in PLACES:
        cases = [(f"{s} is not None", [geometry_kernel(s, count, place) for count in COUNTS]) for s in STYLES]
        parts.append(_function(f"lights_on_{place}", given[place] + common, cases))
        kernels += [kernel for _, each in cases for kernel in each]
    cases = [
        (f"dull is {'not ' if dull else ''}None", [terms_kernel(n, dull) for n in COUNTS]) for dull in (True, False)
    ]
    given = [
        "numbers, albedo, lights, first, second, lit, mu, base, other_mu, other_base, red, green, blue, dull, count,"
    ]
    parts.append(_function("add_lights", given, cases))
    kernels += [kernel for _, each in cases for kernel in each]
    names = sorted(["inlined", *(f"{kernel.program.name}_row" for kernel in kernels)])
    return HEADER + "".join(f"    {name},\n" for name in names) + ")\n" + "".join(parts)
