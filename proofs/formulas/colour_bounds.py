"""The bound of a colour's change by a gradient's error, as a program (theorem difference_bound)."""

from proofs.engine.program import Program
from proofs.engine.vectors import real
from proofs.formulas.shading import albedos, kd, ks, light_colors

q = real("q")  # by how much the highlight changes at most, over |ΔN'|
diffuse_share, specular_share, most = real("diffuse_share specular_share most")


def light_bound(channel: int) -> Program:
    """Return the program → i(a k_d + k_s q): how much a light adds at most to |ΔI|/|ΔN'| of a channel."""
    color, albedo = light_colors[channel], albedos[channel]
    shares = {diffuse_share: color * albedo * kd, specular_share: color * ks}
    lines = shares | {most: diffuse_share + specular_share * q}
    return Program(f"light_bound_{channel}", (color, albedo, kd, ks, q), lines)
