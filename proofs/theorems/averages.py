"""A mean of bounded differences is bounded: what lets area lights and many samples a pixel stand on one sample."""

from proofs.engine.claim import Claim, at_least
from proofs.engine.theorem import SideCondition, Step, Theorem, variant
from proofs.formulas.symbols import real
from proofs.theorems.relations import both_ways, point

mean, sample, share, bound = real("mean sample share bound")
_next = mean + share * (sample - mean)
_step = Claim(
    "one_more", both_ways(bound, _next), (share >= 0, share <= 1, *both_ways(bound, mean), *both_ways(bound, sample))
)

theorem = Theorem(
    id="mean_keeps_the_bound",
    title="A mean keeps the bound of its samples",
    statement=r"If $|m| \le b$ and $|x| \le b$, then $|m + w(x - m)| \le b$ for $0 \le w \le 1$: a mean to which one "
    r"more sample is added, with the share $w$, stays within what bounds each.",
    hypotheses=(r"$0 \le w \le 1$",),
    claims=(_step,),
    steps=(Step(r"$b \mp (m + w(x-m)) = (1-w)(b \mp m) + w(b \mp x) \ge 0$", "products of non-negative terms"),),
    mutants=(
        variant("the mean gains on its samples", _step, at_least(bound, 2 * _next)),
        variant("a share beyond 1", _step, given=(share >= 0, share <= 2, *_step.given[2:])),
        variant("the last sample is not bounded", _step, given=_step.given[:4]),
    ),
    side_conditions=(
        SideCondition(
            r"$0 \le w \le 1$",
            "one_more",
            holds=[point({mean: 1, sample: -1, share: 1, bound: 1}), point({mean: 1, sample: -1, share: 0, bound: 1})],
            fails=[point({mean: 1, sample: -1, share: -1, bound: 1}), point({mean: 1, sample: -1, share: 3, bound: 1})],
        ),
    ),
)
