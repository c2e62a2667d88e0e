"""One or two lights on a run of the floor or of sphere A in one loop, and their terms in another.

Hardly a pixel sees more lights than that. What it goes through then stays in the processor's registers, where the
kernels for one light at a time (`kernel_list`) write and read a row for every name that two of them share.
"""

from proofs import bump, camera, shading
from proofs.program import Program, chain
from proofs.symbols import bumped, h_u, h_v, mu, point, real, view, x
from renderer.generate.kernel_list import ANGLES, RowKernel

COUNTS = (1, 2)
STYLES = {"dull": shading.light_direction.keep(mu, name="cosine"), **shading.MODELS, "squared": shading.blinn_squared}
"""What gives μ and the highlight's base, in each style of `renderer.material`."""
PLACES = {
    "floor": (camera.normal_of_floor, (x,)),
    "a": (chain("normal_on_a", bump.bumped_normal, camera.point_of_normal), (*ANGLES, h_u, h_v, x)),
}
"""What gives the point and the normal there, and what of its inputs varies along a row."""


def _numbered(program, number, shared, renamed=()):
    """Return a program for one of several lights: every name carries its number, but for those shared or renamed."""
    own = {*program.inputs, *(symbol for symbol, _ in program.definitions)} - {*shared}
    names = {symbol: real(f"{symbol.name}_{number}") for symbol in own} | dict(renamed)
    return Program(
        program.name,
        tuple(names.get(s, s) for s in program.inputs),
        tuple((names.get(s, s), expression.xreplace(names)) for s, expression in program.definitions),
        tuple(names.get(s, s) for s in program.outputs),
    )


def geometry_kernel(style, count, place):
    """Return the kernel for μ and the highlight's base of `count` lights at a place."""
    model, (before, varying) = STYLES[style], PLACES[place]
    lights = [_numbered(model, number, (*point, *bumped, *view)) for number in range(1, count + 1)]
    outputs = tuple(symbol for each in lights for symbol in each.outputs)
    name = f"{style}_of_{count}_on_{place}"
    program = chain(name, before, camera.view_length, camera.view_direction, *lights, outputs=outputs)
    return RowKernel(program.folded(), varying)


def terms_kernel(count, dull, place="sphere"):
    """Return the kernel that adds `count` lights to the ambient colour, with a highlight or without.

    The albedo is one for all pixels, but on the floor, where every pixel has its own.
    """
    shared, color, terms = (*shading.albedos, shading.kd, shading.ks), shading.colors, []
    for number in range(1, count + 1):
        terms.append(_numbered(shading.light_term, number, shared, zip(shading.colors, color, strict=True)))
        color = terms[-1].outputs
    highlights = [real(f"specular_{number}") for number in range(1, count + 1)]
    cosines = [real(f"mu_{number}") for number in range(1, count + 1)]
    if dull:
        terms.insert(0, Program("dull", cosines[:1], tuple((s, 0 * cosines[0]) for s in highlights), ()))
    program = chain(f"{'diffuse' if dull else 'light'}_terms_of_{count}_on_{place}", *terms, outputs=color)
    varying = shading.albedos if place == "floor" else ()
    return RowKernel(program.folded(), (*cosines, *([] if dull else highlights), *varying))


FUSED_KERNELS = [
    *(geometry_kernel(style, count, place) for place in PLACES for style in STYLES for count in COUNTS),
    *(terms_kernel(count, dull, place) for place in ("sphere", "floor") for dull in (False, True) for count in COUNTS),
]
