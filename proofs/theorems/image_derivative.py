"""The image's derivative in β, in closed form: the chain rule through the lines of the shading."""

from proofs.formulas.bump import bumped_by_beta
from proofs.formulas.image_derivative import (
    base_by_beta,
    base_derivatives,
    clip_derivative,
    mu_by_beta,
    mu_derivative,
    term_by_beta,
    term_derivative,
)
from proofs.formulas.shading import (
    albedos,
    blinn,
    clip,
    clipped,
    color,
    halfway_length,
    kd,
    ks,
    light_colors,
    light_direction,
    light_term,
    lit,
    phong,
)
from proofs.theorems.highlight import unclamped
from proofs.theorems.language import *

s, n, power, slope, of_x, by_s = real("s n power slope of_x by_s")
raised, raised_by_beta = real("raised raised_by_beta")


def _closed(model):
    return base_derivatives[model][base_by_beta].xreplace(
        {mu: light_direction[mu], mu_by_beta: mu_derivative[mu_by_beta]}
    )


_along = {bumped: bumped + s * bumped_by_beta}
_mu = Claim("mu", equation(Derivative(light_direction.at(_along)[mu], s), mu_derivative[mu_by_beta]), zero(s))
_blinn, _phong = (
    Claim(model, equation(Derivative(unclamped(program.at(_along)), s), _closed(model)), given)
    for model, program, given in (("blinn", blinn, (halfway_length > 0, zero(s))), ("phong", phong, zero(s)))
)


def _term(lit_side, shiny):
    """Return the claim of a light's share where μ and the base are positive, or negative: 1 or 0.

    base^p and its slope are `raised`.
    """
    name = ("unlit", "lit")[lit_side] + ("_dull", "_shiny")[shiny]
    signs = (mu < 0, mu > 0)[lit_side], (specular_base < 0, specular_base > 0)[shiny]
    share = light_term.expand(lit[0]).xreplace({Max(0, mu): mu * lit_side, specular: raised * shiny})
    share = share.xreplace({mu: mu + s * mu_by_beta, raised: raised + s * raised_by_beta})
    closed = term_derivative.expand(term_by_beta)
    (power,) = (p for p in closed.atoms(Pow) if p.exp.has(shininess))
    closed = closed.xreplace({power: raised / specular_base})
    sides = equations((Max(0, mu), Max(0, specular_base)), (mu * lit_side, specular_base * shiny))
    power_rule = equation(raised_by_beta * specular_base, shininess * raised * base_by_beta)
    return Claim(name, (sides, equation(Derivative(share, s), closed)), (signs, zero(s), [power_rule] * shiny))


_sides = [_term(lit_side, shiny) for lit_side in (1, 0) for shiny in (1, 0)]
_power = Induction(
    "power_rule",
    n,
    equation(by_s * x, power * of_x * slope),
    ((of_x, 1, x * of_x), (by_s, 0, by_s * x + of_x * slope), (power, 0, power + 1)),
)
_kept = clip_derivative[clipped]
_clip = (
    Claim("inside", (equation(clip[clipped], color), equation(_kept, term_by_beta)), (color > 0, color < 1)),
    Claim("above", (equation(clip[clipped], 1), zero(_kept)), color > 1),
    Claim("below", zero(Max(0, color), _kept), color < 0),
)


def _grazing(cosine):
    """Return a light's inputs at μ = cosine, of unit coefficients, in a highlight that does not move."""
    ones = (mu_by_beta, specular_base, raised, shininess, kd, ks, albedos[0], light_colors[0])
    return {mu: cosine, ones: 1, (base_by_beta, raised_by_beta): 0}


theorem = Theorem(
    "image_derivative",
    "The image's derivative in β",
    {
        r"""Along $N' + s\,\partial_\beta N'$, at $s = 0$: $\mu' = \partial_\beta N'\cdot\omega$ and $\text{base}'
        = \partial_\beta N'\cdot H/|H|$ (Blinn) or $2(\mu'\,N'\cdot\hat v + \mu\,\partial_\beta N'\cdot\hat v)$
        (Phong).""": (_mu, _blinn, _phong),
        r"""For every whole $p \ge 0$, with $(\text{base}^p)'$ by the product rule, $(\text{base}^p)'\,\text{base} =
        p\,\text{base}^p\,\text{base}'$.""": _power,
        r"""With it, off $\mu = 0$ and base $= 0$ a light's share of a channel has the derivative $i\,(a k_d\,\mu'[\mu >
        0] + k_s\,p\,\text{base}^{p-1}\,\text{base}'[\text{base} > 0])$;""": _sides,
        "the clip keeps it where the channel is inside $(0, 1)$ and makes it 0 outside $[0, 1]$.": _clip,
        r"""So the lit channel, and the clipped one where it is neither 0 nor 1, has this derivative in
        $\beta$, added to
        that of the lights before, for both models.""": coq("image_derivative__pixel bdac657e0afd363c"),
        r"""The rules by which a renderer hands on slopes compose: of every program whose needed lines have slopes, the
        slope that is computed with it is the derivative of its value, however its inputs move.""": coq(
            "image_derivative__programs cc8eb97b13e02494"
        ),
    },
    hypotheses=(
        r"$N' = M/|M|$ with $M \ne 0$; $|H| > 0$; off $\mu = 0$ and off base $= 0$ for the lit channel",
        r"of the claims, which are steps: $p \ge 1$ whole, and the rules of differentiation (assumed)",
    ),
    steps={
        r"$\partial_\beta N'$": ("in closed form", "normal_by_beta"),
        "each line, along $N' + s\\,\\partial_\\beta N'$ at $s = 0$": "the chain rule",
        r"$(x^{p})'\,x = p\,x^p x'$": "induction on $p$ by the product rule",
    },
    mutants=(
        variant("Phong without its factor 2", _phong, equation(2 * _phong.shows[0].lhs, _closed("phong"))),
        variant("the highlight's factor p + 1", _power, equation(by_s * x, (power + 1) * of_x * slope)),
        variant("the lit side's slope where μ < 0", _sides[2], _sides[0].shows[2:]),
    ),
    side_conditions=SideCondition(r"$\mu \ne 0$", "lit_shiny", holds=_grazing(1), fails=(_grazing(0), _grazing(-1))),
)
