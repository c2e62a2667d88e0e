"""The cheap highlight: Blinn–Phong's cosine and the square of its base from one root and one division."""

from ..claim import Claim, equation
from ..pixel import instance
from ..program import chain
from ..shading import along_halfway, blinn, blinn_squared, halfway, halfway_squared, light_distance
from ..symbols import bumped, dot, mu, real, specular_base
from ..theorem import Mutant, Step, Theorem

_plain = instance(blinn, "plain")
_both = chain("both", blinn_squared, _plain)
_mu, _base, _length, _distance = real("mu_plain specular_base_plain halfway_length_plain light_distance_plain")
_plain_halfway = tuple(real(f"{s.name}_plain") for s in halfway)
_given = (light_distance > 0, halfway_squared > 0, _length > 0)
_same = (
    equation(_distance, light_distance),
    *(equation(k, light_distance * w) for k, w in zip(halfway, _plain_halfway, strict=True)),
    equation(halfway_squared, light_distance**2 * _length**2),
)
_cosine = Claim("cosine", (equation(mu, _mu),), _given, _both)
_facing = Claim(
    "facing",
    (*_same, equation(_base * _length * light_distance, along_halfway), equation(specular_base, _base**2)),
    (*_given, dot(bumped, halfway) >= 0, dot(bumped, _plain_halfway) / _length >= 0),
    _both,
)

theorem = Theorem(
    id="squared_highlight",
    title="The highlight from one root and one division",
    section="s6",
    statement=r"With $d = L - P$, $k = d + |d|\hat v$ and $s = 1/(|d|\,k\cdot k)$: $\mu = (N'\cdot d)(k\cdot k)s$, and "
    r"the square of Blinn's base is $(N'\cdot k)^2 |d| s$ where $N'\cdot k \ge 0$.",
    hypotheses=("$L \\ne P$", r"$\omega \ne -\hat v$"),
    claims=(_cosine, _facing),
    uses=(),
    steps=(
        Step(r"$k = |d|(\omega + \hat v)$", "so its direction is the halfway vector's"),
        Step(r"$(N'\cdot k)^2/(k\cdot k)$ does not depend on the length of $k$", "nor does its sign, as $|d| > 0$"),
    ),
    mutants=(
        Mutant("the base, not its square", _facing.but(shows=(equation(specular_base, _base),))),
        Mutant("μ without |k|²", _cosine.but(shows=(equation(mu * halfway_squared, _mu),))),
    ),
)
