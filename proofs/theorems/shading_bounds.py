"""How far a gradient's error can move a colour: one light's share of a channel, and its Lipschitz constant."""

from sympy import Max

from proofs.engine.claim import Claim, at_least
from proofs.engine.theorem import Clause, Mutant, SideCondition, Step, Theorem, variant
from proofs.formulas.shading import albedos, clipped_value, colors, kd, ks, light_colors, light_term, lit
from proofs.formulas.symbols import mu, real, specular
from proofs.theorems.relations import both_ways

_other_mu, _other_specular, q, step, so_far, _before = real("other_mu other_specular q step so_far before")


def _light(channel, factor=None):
    """Return the claim |Δ channel| ≤ so far + factor · step, of one light."""
    before, color, albedo = colors[channel], light_colors[channel], albedos[channel]
    after = light_term.expand(lit[channel])
    other = after.xreplace({mu: _other_mu, specular: _other_specular, before: _before})
    weights = color * albedo * kd, color * ks
    parts = ((weights[0], Max(0, mu) - Max(0, _other_mu), step), (weights[1], specular - _other_specular, q * step))
    return Claim(
        f"light_{channel}",
        (
            at_least(albedo * kd, 0),
            *(at_least(weight, 0) for weight in weights),
            *(r for weight, change, most in parts for r in both_ways(weight * most, weight * change)),
            *both_ways(so_far + (factor or weights[0] + weights[1] * q) * step, after - other),
        ),
        (
            *(c >= 0 for c in (albedo, color, kd, ks)),
            *both_ways(so_far, before - _before),
            *(r for _, change, most in parts for r in both_ways(most, change)),
        ),
    )


_lights = tuple(map(_light, range(3)))
_weights = light_colors[0] * albedos[0] * kd, light_colors[0] * ks

_first, _second, _bound_on, _slope_error = real("first second bound_on slope_error")
_clip = Claim(
    "clip", both_ways(_bound_on, clipped_value(_first) - clipped_value(_second)), both_ways(_bound_on, _first - _second)
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
        at_least(_slope_error, step),
    ),
)


def _at_unit_weights(factor):
    """Return the claim with another factor, for i = a = k_d = k_s = 1."""
    ones, claim = dict.fromkeys((albedos[0], light_colors[0], kd, ks), 1), _light(0, factor)
    return claim.but(shows=[r.xreplace(ones) for r in claim.shows[-2:]], given=claim.given[4:])


def _lamp(shine):
    """Return the light's inputs with k_s = shine, and a highlight that changes by 1."""
    known = {light_colors[0]: 1, albedos[0]: 1, kd: 1, ks: shine, mu: 0, _other_mu: 0, specular: 1, _other_specular: 0}
    return (*known.items(), (q, 1), (step, 1), (so_far, 0), (colors[0], 0), (_before, 0))


difference_bound = Theorem(
    id="difference_bound",
    title="How far a gradient's error can move a colour",
    statement=(
        Clause(
            r"A light adds at most $i\,(a k_d + k_s q)\,|\Delta N'|$ to the change of a channel, red, green or blue,",
            _lights,
        ),
        Clause("and the clip adds nothing;", (_clip,)),
        Clause(
            r"so $|\Delta I| \le L\,|\beta||\Delta g|$ with $L = \sum_{\text{lights}} i\,(a k_d + k_s q)$, of "
            "up to five lights.",
            (_all_lights,),
        ),
    ),
    hypotheses=(
        r"light $i$, albedo $a$, $k_d$, $k_s \ge 0$",
        "the same chamber: the same point and the same lights",
        r"$|\Delta\,\text{base}^p| \le q|\Delta N'|$: the highlight is Lipschitz with $q$, for a whole $p \ge 1$ with "
        "$q = p$ (Blinn) or $2p$ (Phong), as is argued",
    ),
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
        variant(
            "the clip halves a change", _clip, *both_ways(_bound_on / 2, clipped_value(_first) - clipped_value(_second))
        ),
        variant(
            "without the last light",
            _all_lights,
            at_least(sum(_factors[:4]) * step, _changes[-1]),
            at=tuple(
                zip((*_factors, *_changes, step, _slope_error), (0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1), strict=True)
            ),
        ),
        Mutant("without the highlight", _at_unit_weights(_weights[0])),
        Mutant("without the diffuse part", _at_unit_weights(_weights[1] * q)),
    ),
    side_conditions=(SideCondition("$k_s \\ge 0$", "light_0", holds=[_lamp(1), _lamp(0)], fails=[_lamp(-1)]),),
)
