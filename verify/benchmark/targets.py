"""From medians to the numbers that the book cites; what they have to reach, and the table that says whether they do."""

import math
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from verify.benchmark.frames import FITTED

RATIOS = {
    **{f"{slow}_to_algebraic_{side}": (f"{case}_{side}_{threads}", f"algebraic_{side}_2")
       for slow, case, threads in (("numpy", "numpy", 2), ("seed", "seed_exact", 1), ("central", "central", 2))
       for side in (64, 256, 1024, 4096)},
    "seed_central_to_exact": ("seed_central_256_1", "seed_exact_256_1"),
    "eps_step_central_to_exact": ("eps_step_central_1024_2", "eps_step_exact_1024_2"),
    "a_alone_central_to_algebraic": ("a_alone_central_1024_1", "a_alone_algebraic_1024_1"),
    "a_alone_central_to_general": ("a_alone_central_1024_1", "a_alone_general_1024_1"),
}  # fmt: skip
"""{number: (the case that takes so many times as long, as this case)}"""


def exponent(times: Mapping[str, float], threads: int) -> float | None:
    """Return p of the fit time ∝ pixels^p through the fitted sizes, or None unless all were timed."""
    names = [f"algebraic_{side}_{threads}" for side in FITTED]
    if not times.keys() >= set(names):
        return None
    pixels = np.array(FITTED, float) ** 2
    return float(np.polyfit(np.log(pixels), np.log([times[name] for name in names]), 1)[0])


def frame_numbers(times: Mapping[str, float]) -> dict[str, float]:
    """Return the milliseconds of frames, the seconds of starts, and what follows from them, of what was timed."""
    numbers: dict[str, float] = {}
    for name, seconds in times.items():
        numbers |= {f"{name}_s": seconds} if name.startswith("start") else {f"{name}_ms": 1e3 * seconds}
    numbers |= {
        n: times[above] / times[below] for n, (above, below) in RATIOS.items() if {above, below} <= times.keys()
    }
    fits = {f"exponent_{threads}": exponent(times, threads) for threads in (1, 2)}
    return numbers | {name: fit for name, fit in fits.items() if fit is not None}


def spreads(seconds: Mapping[str, Sequence[float]]) -> dict[str, float]:
    """Return the quartiles of each case that was called more than once: {NAME_ms_low: …, NAME_ms_high: …}."""
    numbers: dict[str, float] = {}
    for name, calls in seconds.items():
        if len(calls) > 1:
            unit, factor = ("s", 1.0) if name.startswith("start") else ("ms", 1e3)
            low, _, high = statistics.quantiles(calls, n=4, method="inclusive")
            numbers |= {f"{name}_{unit}_low": factor * low, f"{name}_{unit}_high": factor * high}
    return numbers


@dataclass(frozen=True)
class Target:
    """A number of a run and the interval that it has to lie in: [low, high]; `form` is a format with the unit."""

    key: str
    what: str
    high: float = math.inf
    low: float = -math.inf
    form: str = "{:.3g}"

    @property
    def text(self) -> str:
        """The interval in words."""
        low, high = (self.form.format(bound) for bound in (self.low, self.high))
        if self.low == self.high:
            return high
        if math.isinf(self.low):
            return f"≤ {high}"
        return f"≥ {low}" if math.isinf(self.high) else f"{low} to {high}"

    def verdict(self, numbers: Mapping[str, float]) -> tuple[str, str]:
        """Return (measured, verdict), both text; a number that is not there or not a number is not met."""
        if self.key not in numbers:
            return "–", "not measured"
        value = numbers[self.key]
        return self.form.format(value), "met" if self.low <= value <= self.high else "not met"


MS, NS, SECONDS, TIMES = "{:.3g} ms", "{:.3g} ns", "{:.3g} s", "{:,.3g} ×"
TARGETS = (
    Target("algebraic_1024_2_ms", "default frame, exact, 1024², two threads", 9, form=MS),
    Target("numpy_to_algebraic_1024", "… NumPy row tiles take, in its times", low=12, form=TIMES),
    Target("algebraic_256_2_ms", "default frame, exact, 256², two threads", 0.8, form=MS),
    Target("seed_to_algebraic_256", "… the mended seed loops take, in its times", low=5000, form="{:,.0f} ×"),
    Target("central_1024_2_ms", "default frame, central differences, 1024², two threads", 30, form=MS),
    Target("eps_step_exact_1024_2_ms", "ε-step with the cache, exact, 1024²", 5, form=MS),
    Target("eps_step_central_1024_2_ms", "ε-step with the cache, central, 1024²", 15, form=MS),
    Target("image_gradient_ns", "exact gradient from the image point, algebraic, one thread, a point", 8, form=NS),
    Target("a_alone_central_to_algebraic", "sphere A alone: central takes, in times of exact", low=2, form=TIMES),
    Target("exponent_2", "time ∝ pixels to the power, 256² to 8192²", 1.05, 0.95, "{:.3f}"),
    Target("chambers_differing", "pixels whose chamber differs from the per-pixel reference", 0, 0, "{:,}"),
    Target("image_error", "image against the strict scalar reference, largest difference", 1e-13, form="{:.2g}"),
    Target("start_one_picture_s", "a fresh interpreter, one picture of 256², imports included", 1.0, form=SECONDS),
    Target("start_two_pictures_s", "… README's two", 1.5, form=SECONDS),
    Target("start_image_2048_s", "python -m renderer image --size 2048, from nothing", 2.0, form=SECONDS),
    Target("sympy_imported", "times that python -m renderer image imports SymPy", 0, 0, "{:g}"),
)


def table(numbers: Mapping[str, float]) -> str:
    """Return the table as text: what, target, measured, verdict."""
    rows = [("what", "target", "measured", "")] + [(t.what, t.text, *t.verdict(numbers)) for t in TARGETS]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  ".join(map(str.ljust, row, widths)).rstrip() for row in rows)
