"""The change of a colour by a gradient's error: one light's share of a channel, normalising, and means of samples."""

from proofs.formulas.bump import g, m, perturbed
from proofs.formulas.colour_bounds import diffuse_share, light_bound, most, q, specular_share
from proofs.formulas.shading import albedos, clipped_value, colors, kd, ks, light_colors, light_term, lit
from proofs.theorems.language import *

_other_mu, _other_specular, step, so_far, _before = real("other_mu other_specular step so_far before")


def _light(factor=None):
    """Return the claim |Δ channel| ≤ so far + factor · step, of one light, in red."""
    before, color, albedo = colors[0], light_colors[0], albedos[0]
    after = light_term.expand(lit[0])
    other = after.xreplace({mu: _other_mu, specular: _other_specular, before: _before})
    bound = light_bound(0)
    weights = bound[diffuse_share], bound[specular_share]
    parts = ((weights[0], Max(0, mu) - Max(0, _other_mu), step), (weights[1], specular - _other_specular, q * step))
    return Claim(
        "light_0",
        (
            nonnegative(albedo * kd, weights),
            [both_ways(weight * largest, weight * change) for weight, change, largest in parts],
            both_ways(so_far + (factor or bound.expand(most)) * step, after - other),
        ),
        (
            nonnegative(albedo, color, kd, ks),
            both_ways(so_far, before - _before),
            [both_ways(largest, change) for _, change, largest in parts],
        ),
    )


_of_red = _light()
_weights = [light_bound(0)[share] for share in (diffuse_share, specular_share)]

_first, _second, _bound_on = real("first second bound_on")
_clip = Claim(
    "clip", both_ways(_bound_on, clipped_value(_first) - clipped_value(_second)), both_ways(_bound_on, _first - _second)
)


def _lamp(shine):
    """Return the light's inputs with k_s = shine, and a highlight that changes by 1."""
    ones = (light_colors[0], albedos[0], kd, specular, q, step)
    return {ks: shine, ones: 1, (mu, _other_mu, _other_specular, so_far, colors[0], _before): 0}


difference_bound = Theorem(
    "difference_bound",
    "How far a gradient's error can move a colour",
    {
        r"A light adds at most $i\,(a k_d + k_s q)\,|\Delta N'|$ to the change of a channel, red, green or blue,": (
            _of_red,
            coq("difference_bound__light d2144b88cd2594ea", "difference_bound__channels 53d2c6a05d5fddab"),
        ),
        "and the clip adds nothing;": _clip,
        r"""so for any number of lights $|\Delta I| \le L\min(|\beta||\Delta g|, 2)$, $L = \sum_{\text{lights}}
        i\,(a k_d
        + k_s q)$:""": coq("difference_bound__any_lights a157cf50e1265fd4"),
        "with $q = p$ for Blinn's highlight, and $2p$ for Phong's.": coq(
            "difference_bound__of_both_models ecf137addf51809e"
        ),
    },
    hypotheses=(
        r"light $i$, albedo $a$, $k_d$, $k_s, q \ge 0$; $p$ whole and not negative",
        r"the same chamber: the same point $P$ and the same lights, none of them at $P$; $|\hat v| = 1$",
        r"before the last sentence $|\Delta\,\text{base}^p| \le q|\Delta N'|$",
    ),
    steps={
        r"$|\Delta\max(0,\mu)| \le |\Delta N'|$, $|\Delta\,\text{base}^p| \le q|\Delta N'|$": (
            "Lipschitz, stage by stage",
            "specular_lipschitz",
        ),
        "the light's line": "products of non-negative weights with these; both ways round; over all lights",
        r"$|\Delta N'| \le |\beta||\Delta g|$": ("normalising", "normalising_is_lipschitz"),
    },
    mutants=(
        variant(
            "the clip halves a change", _clip, both_ways(_bound_on / 2, clipped_value(_first) - clipped_value(_second))
        ),
        variant("without the highlight", _of_red, _light(_weights[0]).shows, at=_lamp(1) | {kd: 0}),
        variant("without the diffuse part", _of_red, _light(_weights[1] * q).shows, at=_lamp(0) | {mu: 1, specular: 0}),
    ),
    side_conditions=SideCondition("$k_s \\ge 0$", "light_0", holds=(_lamp(1), _lamp(0)), fails=_lamp(-1)),
)


mean, sample, share, bound = real("mean sample share bound")
_next = mean + share * (sample - mean)
_step = Claim("one_more", both_ways(bound, _next), (share >= 0, share <= 1, both_ways(bound, mean, sample)))

one_more = Theorem(
    "mean_keeps_the_bound",
    "A mean keeps the bound of its samples",
    {
        r"""If $|m| \le b$ and $|x| \le b$, then $|m + w(x - m)| \le b$ for $0 \le w \le 1$: a mean to which one more
        sample is added, with the share $w$, stays within what bounds each.""": _step,
        "So does the mean of any number of samples.": coq("mean_keeps_the_bound__any_number e974597ac7fedc50"),
    },
    hypotheses=r"$0 \le w \le 1$",
    steps={r"$b \mp (m + w(x-m)) = (1-w)(b \mp m) + w(b \mp x) \ge 0$": "products of non-negative terms"},
    mutants=(
        variant("the mean gains on its samples", _step, bound >= 2 * _next),
        variant("a share beyond 1", _step, given=(share >= 0, share <= 2, _step.given[2:])),
        variant("the last sample is not bounded", _step, given=_step.given[:4]),
    ),
    side_conditions=SideCondition(
        r"$0 \le w \le 1$",
        "one_more",
        holds=({mean: 1, sample: -1, share: 1, bound: 1}, {mean: 1, sample: -1, share: 0, bound: 1}),
        fails=({mean: 1, sample: -1, share: -1, bound: 1}, {mean: 1, sample: -1, share: 3, bound: 1}),
    ),
)


a, b = vectors("a b")
length_a, length_b, apart, turned, product = real("length_a length_b apart turned product")
_outside = equations(
    (length_a**2, length_b**2, product, apart**2, turned**2),
    (squared(a), squared(b), dot(a, b), squared(a - b), squared(a / length_a - b / length_b)),
)
_normalise = Claim(
    "normalise",
    (
        equation(length_a**2 * length_b**2 - product**2, squared(cross(a, b))),
        nonnegative(length_a**2 * length_b**2 - product**2, length_a * length_b - 1),
        both_ways(length_a * length_b, product),
        equation(length_a * length_b * turned**2, 2 * (length_a * length_b - product)),
        equation(apart**2, length_a**2 + length_b**2 - 2 * product),
        length_a * length_b * (apart**2 - turned**2) >= 0,
        apart**2 >= turned**2,
        apart >= turned,
        at_least(4, turned**2),
        at_least(2, turned),
    ),
    (length_a >= 1, length_b >= 1, apart >= 0, _outside),
    squares=(cross(a, b), length_a - length_b),
)
_other_m, _other_g = vectors("other_m other_g")
_moved = Claim(
    "moved",
    equation(squared(m - _other_m), beta**2 * squared(g - _other_g)),
    equations(_other_m, normal + beta * _other_g),
    perturbed,
)


def _pair(length):
    """Return two orthogonal vectors of equal length, with the lines derived from them."""
    vectors = {a: (length, 0, 0), b: (0, length, 0), (length_a, length_b): length}
    return {**vectors, product: 0, apart: length * sqrt(2), turned: sqrt(2)}


normalising = Theorem(
    "normalising_is_lipschitz",
    "Normalising is 1-Lipschitz outside the unit ball",
    {
        r"For $|a|, |b| \ge 1$: $\bigl|a/|a| - b/|b|\bigr| \le \min(|a-b|, 2)$.": _normalise,
        r"""With $M = N + \beta g$, $|M| \ge 1$: $|\Delta M| = |\beta||\Delta g|$, so $|\Delta N'| \le
        \min(|\beta||\Delta g|, 2)$.""": _moved,
    },
    hypotheses=r"$|a|, |b| \ge 1$",
    steps={
        r"$|a/|a|-b/|b||^2 = 2 - 2\,a\cdot b/(|a||b|)$": "expansion",
        r"$|a-b|^2 - |a/|a|-b/|b||^2 = (|a|-|b|)^2 + 2(|a||b|-1)(|a||b|-a\cdot b)/(|a||b|) \ge 0$": (
            r"$|a||b| \ge 1$, $|a||b| \ge a\cdot b$"
        ),
        r"$|M| \ge 1$, $M_1-M_2 = \beta(g_1-g_2)$": ("the same $N$ and $\\beta$", "unit_length"),
    },
    mutants=(
        variant("with the constant ½", _normalise, apart >= 2 * turned),
        variant(
            "inside the unit ball too",
            _normalise,
            given=(length_a > 0, length_b > 0, apart >= 0, turned >= 0, _outside),
            at={a: (HALF, 0, 0), b: ("7/50", "12/25", 0), (length_a, length_b): HALF}
            | {product: "7/100", apart: "3/5", turned: "6/5"},
        ),
        variant("at most 1", _normalise, at_least(1, turned)),
    ),
    side_conditions=SideCondition(r"$|a|, |b| \ge 1$", "normalise", holds=_pair(1), fails=_pair(HALF)),
)
