"""How far a gradient's error can move a colour: one light's share of a channel, and its Lipschitz constant."""

from sympy import Max, Min

from proofs.engine.claim import Claim, at_least
from proofs.engine.theorem import Clause, Edge, Mutant, SideCondition, Step, Theorem
from proofs.formulas.shading import albedos, colors, kd, ks, light_colors, light_term, lit
from proofs.formulas.symbols import mu, real, specular

_other_mu, _other_specular, q, step, so_far, _before = real("other_mu other_specular q step so_far before")
_other = {mu: _other_mu, specular: _other_specular, colors[0]: _before}
_red = light_term.expand(lit[0])
_weights = (light_colors[0] * albedos[0] * kd, light_colors[0] * ks)
_parts = ((_weights[0], Max(0, mu), Max(0, _other_mu), step), (_weights[1], specular, _other_specular, q * step))


def _within(factor):
    """Return Δ channel ≤ so far + factor · step."""
    return (at_least(so_far + factor * step, _red - _red.xreplace(_other)),)


_bound = Claim(
    "light",
    (
        at_least(albedos[0] * kd, 0),
        *(at_least(weight, 0) for weight in _weights),
        *(at_least(weight * by, weight * (one - two)) for weight, one, two, by in _parts),
        *_within(_weights[0] + _weights[1] * q),
    ),
    (
        *(c >= 0 for c in (albedos[0], light_colors[0], kd, ks)),
        at_least(so_far, colors[0] - _before),
        at_least(step, Max(0, mu) - Max(0, _other_mu)),
        at_least(q * step, specular - _other_specular),
    ),
)


_first, _second, _bound_on, _slope_error = real("first second bound_on slope_error")
_clip = Claim(
    "clip",
    tuple(
        at_least(_bound_on, Min(1, Max(0, a)) - Min(1, Max(0, b))) for a, b in ((_first, _second), (_second, _first))
    ),
    (at_least(_bound_on, _first - _second), at_least(_bound_on, _second - _first)),
)
_changes, _factors = real("change_1:6"), real("factor_1:6")
_all_lights = Claim(
    "all_lights",
    (
        at_least(sum(_factors) * step, _changes[-1]),
        at_least(sum(_factors), 0),
        at_least(sum(_factors) * _slope_error, _changes[-1]),
    ),
    (
        *(
            at_least(so_far_ + factor * step, to)
            for so_far_, factor, to in zip((0, *_changes[:-1]), _factors, _changes, strict=True)
        ),
        *(at_least(factor, 0) for factor in _factors),
        at_least(step, 0),
        at_least(_slope_error, step),
    ),
)


def _at_unit_weights(factor):
    """Return the claim with another factor, for i = a = k_d = k_s = 1."""
    ones = dict.fromkeys((albedos[0], light_colors[0], kd, ks), 1)
    return _bound.but(shows=[r.xreplace(ones) for r in _within(factor)], given=_bound.given[4:])


def _lamp(shine):
    """Return the light's inputs with k_s = shine, and a highlight that changes by 1."""
    known = {light_colors[0]: 1, albedos[0]: 1, kd: 1, ks: shine, mu: 0, _other_mu: 0, specular: 1, _other_specular: 0}
    return (*known.items(), (q, 1), (step, 1), (so_far, 0), (colors[0], 0), (_before, 0))


difference_bound = Theorem(
    id="difference_bound",
    title="How far a gradient's error can move a colour",
    section="s4",
    statement=(
        Clause(
            r"A light adds at most $i\,(a k_d + k_s q)\,|\Delta N'|$ to the change of a channel ($q = p$ for Blinn, "
            r"$2p$ for Phong, whole $p \ge 1$),",
            (_bound,),
        ),
        Clause("and the clip adds nothing;", (_clip,)),
        Clause(
            r"so $|\Delta I| \le L\,|\beta||\Delta g|$ with $L = \sum_{\text{lights}} i\,(a k_d + k_s q)$, of "
            r"up to five "
            "lights.",
            (_all_lights,),
        ),
    ),
    hypotheses=(r"light $i$, albedo $a$, $k_d$, $k_s \ge 0$", "the same chamber: the same point and the same lights"),
    uses=("normalising_is_lipschitz", "specular_lipschitz"),
    steps=(
        Step(
            r"$|\Delta\max(0,\mu)| \le |\Delta N'|$, $|\Delta\,\text{base}^p| \le q|\Delta N'|$",
            "Lipschitz, stage by stage",
            uses=("specular_lipschitz",),
        ),
        Step("the light's line", "products of non-negative weights with these; both ways round; over all lights"),
        Step(r"$|\Delta N'| \le |\beta||\Delta g|$", "normalising", uses=("normalising_is_lipschitz",)),
    ),
    mutants=(
        Mutant("the clip halves a change", _clip.but(shows=(at_least(_bound_on, 2 * (_clip.shows[0].rhs)),))),
        Mutant(
            "without the last light",
            _all_lights.but(shows=(at_least(sum(_factors[:4]) * step, _changes[-1]),)),
            tuple(zip((*_factors, *_changes, step, _slope_error), (0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1), strict=True)),
        ),
        Mutant("without the highlight", _at_unit_weights(_weights[0])),
        Mutant("without the diffuse part", _at_unit_weights(_weights[1] * q)),
    ),
    side_conditions=(
        SideCondition(
            "$k_s \\ge 0$", "light", (Edge(_lamp(1), "holds"), Edge(_lamp(0), "holds"), Edge(_lamp(-1), "fails"))
        ),
    ),
)
