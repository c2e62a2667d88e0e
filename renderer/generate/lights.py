"""The text of `renderer/lights.py`: one or two lights on a run, by the kernel of the style and of their number."""

from proofs.shading import albedos
from renderer.generate.fused import COUNTS, PLACES, STYLES, geometry_kernel, terms_kernel
from renderer.generate.shaders import wrapped

HEADER = '''"""Generated from proofs/ by `python -m renderer.generate`. Do not edit: it is printed there.

One or two of the lights, `lights[first]` and `lights[second]`, on a run of `count` pixels: μ and the base of the
highlight into `mu` and `base`, the other light's into `other_mu` and `other_base`; then the colours. The albedo is
a sphere's (red, green, blue), or two rows: red and green, and blue.
"""

from renderer.kernels import (
'''
ROWS = {"mu": "mu", "specular_base": "base", "specular": "base"}
NUMBERS = {"kd": 0, "ks": 1, "red": 3, "green": 4, "blue": 5}
ALBEDO = {"sphere": ("albedo[0]", "albedo[1]", "albedo[2]"), "floor": ("albedo", "albedo", "albedo_blue")}
OF_A_LIGHT = {f"light_{part}": n for n, part in enumerate(("x", "y", "z", "red", "green", "blue"))}


def _argument(symbol, place):
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
    return ALBEDO[place][albedos.index(symbol)] if symbol in albedos else symbol.name


def _call(kernel, place):
    targets = [target for target in kernel.program.outputs if target not in kernel.program.inputs]
    arguments = [_argument(symbol, place) for symbol in (*kernel.program.inputs, *targets)]
    return wrapped(f"{kernel.program.name}_row", [*arguments, "0", "count"])


def _function(name, place, arguments, cases):
    """Return a function that calls, in the first of its cases {test: kernels by number of lights}, the right one."""
    lines = [f"def {name}_on_{place}(", *(f"    {line}" for line in arguments), "):"]
    for test, kernels in cases.items():
        lines.append(f"    if {test}:")
        for kernel in kernels:
            lines += [f"        {'if lit == 1' if kernel is kernels[0] else 'else'}:"]
            lines += [f"            {line}" for line in _call(kernel, place)]
    return "\n".join(["", "", "@compiled", *lines, ""])


def _functions():
    """Yield (name, place, arguments, cases) of every function."""
    given = {"floor": "x, y, eye,", "a": "cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, radius, x, y, eye,"}
    which = "lights, first, second, lit, mu, base, other_mu, other_base,"
    for place in PLACES:
        kernels = {style: [geometry_kernel(style, count, place) for count in COUNTS] for style in STYLES}
        arguments = [given[place], which, "dull, phong, blinn, squared, count,"]
        yield "lights", place, arguments, {f"{style} is not None": each for style, each in kernels.items()}
    for place, albedo in {"sphere": "albedo,", "floor": "albedo, albedo_blue,"}.items():
        kernels = {dull: [terms_kernel(count, dull, place) for count in COUNTS] for dull in (True, False)}
        cases = {"dull is not None": kernels[True], "dull is None": kernels[False]}
        yield "add_lights", place, [f"numbers, {albedo}", which, "red, green, blue, dull, count,"], cases


def lights_source():
    """Return the text of renderer/lights.py."""
    functions = list(_functions())
    kernels = [kernel for *_, cases in functions for each in cases.values() for kernel in each]
    names = sorted(["compiled", *(f"{kernel.program.name}_row" for kernel in kernels)])
    imports = "".join(f"    {name},\n" for name in names)
    return HEADER + imports + ")\n" + "".join(_function(*each) for each in functions)
