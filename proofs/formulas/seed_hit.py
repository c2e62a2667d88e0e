"""The seed's hit of sphere A by a pixel's ray, and the normal there."""

from sympy import sqrt

from proofs.engine.program import Program
from proofs.engine.vectors import real
from proofs.formulas.symbols import eye, normal, radius, x, y

seed_discriminant, seed_t = real("seed_discriminant seed_t")

seed_normal = Program(
    "seed_normal",
    (x, y, eye, radius),
    {
        seed_discriminant: eye**2 * radius**2 - (eye**2 - radius**2) * (x**2 + y**2),
        seed_t: (eye**2 - sqrt(seed_discriminant)) / (x**2 + y**2 + eye**2),
        normal: (seed_t * x / radius, seed_t * y / radius, eye * (1 - seed_t) / radius),
    },
)
"""t = (e² − √d)/(ρ² + e²), d = e²R² − (e² − R²)ρ²: d cancels toward the silhouette. Source: seed, Cell 1."""
