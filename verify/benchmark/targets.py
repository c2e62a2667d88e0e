"""What follows from the times of frames, such as ratios; and which times were asked for, with a table of those met."""

import operator
from collections.abc import Mapping
from contextlib import suppress

import numpy as np

from verify.benchmark.frames import FITTED

RATIOS = {
    **{f"{slow}_to_algebraic_{side}": (f"{case}_{side}_{threads}", f"algebraic_{side}_2")
       for slow, case, threads in (("numpy", "numpy", 2), ("seed", "seed_exact", 1), ("central", "central", 2))
       for side in (64, 256, 1024, 4096)},
    "seed_central_to_exact": ("seed_central_256_1", "seed_exact_256_1"),
    "eps_step_central_to_exact": ("eps_step_central_1024_2", "eps_step_exact_1024_2"),
    "a_alone_central_to_algebraic": ("a_alone_central_1024_1", "a_alone_algebraic_1024_1"),
    **{f"bounds_to_plain_{side}": (f"bounds_{side}", f"no_bounds_{side}") for side in (256, 1024)},
    "a_alone_central_to_general": ("a_alone_central_1024_1", "a_alone_general_1024_1"),
}  # fmt: skip
"""{number: (the case that takes so many times as long, as this case)}"""


def derived(numbers: Mapping[str, float]) -> dict[str, float]:
    """Return what follows from {CASE_ms: milliseconds} of the cases that were timed, of others nothing."""

    def time(case):
        return numbers[f"{case}_ms"]

    found = {}
    for name, (slow, fast) in RATIOS.items():
        with suppress(KeyError):
            found[name] = time(slow) / time(fast)
    for threads in (1, 2):
        with suppress(KeyError):
            times = [time(f"algebraic_{side}_{threads}") for side in FITTED]  # time ∝ pixels^p
            found[f"exponent_{threads}"] = float(np.polyfit(2 * np.log(FITTED), np.log(times), 1)[0])
    with suppress(KeyError):
        found["pixel_2048_to_1024"] = time("no_bounds_2048") / time("no_bounds_1024") / 4
    return found


TARGETS = {
    "algebraic_1024_2_ms": ("default frame, exact, 1024², two threads", "≤", 9, "ms"),
    "numpy_to_algebraic_1024": ("… NumPy row tiles take, in its times", "≥", 12, "×"),
    "algebraic_256_2_ms": ("default frame, exact, 256², two threads", "≤", 0.8, "ms"),
    "seed_to_algebraic_256": ("… the mended seed loops take, in its times", "≥", 5000, "×"),
    "central_1024_2_ms": ("default frame, central differences, 1024², two threads", "≤", 30, "ms"),
    "eps_step_exact_1024_2_ms": ("ε-step with the cache, exact, 1024²", "≤", 5, "ms"),
    "eps_step_central_1024_2_ms": ("ε-step with the cache, central, 1024²", "≤", 15, "ms"),
    "image_gradient_ns": ("exact gradient from the image point, algebraic, one thread, a point", "≤", 8, "ns"),
    "a_alone_central_to_algebraic": ("sphere A alone: central takes, in times of exact", "≥", 2, "×"),
    "exponent_2": ("time ∝ pixels to the power, 256² to 8192²", "≤", 1.05, ""),
    "bounds_to_plain_256": ("with bounds, exact, sine, 256², all threads, in times of the plain picture", "≤", 4, "×"),
    "bounds_to_plain_1024": ("… 1024²", "≤", 5, "×"),
    "pixel_2048_to_1024": ("a pixel of 2048², in times of one of 1024²", "≤", 1.1, "×"),
    "chambers_differing": ("pixels whose chamber differs from the per-pixel reference", "≤", 0, ""),
    "image_error": ("image against the strict scalar reference, largest difference", "≤", 1e-13, ""),
    "start_one_picture_s": ("a fresh interpreter, one picture of 256², imports included", "≤", 1.0, "s"),
    "start_two_pictures_s": ("… README's two", "≤", 1.5, "s"),
    "start_image_2048_s": ("python -m renderer image --size 2048, from nothing", "≤", 2.0, "s"),
}
"""{number of a run: (what it is, the relation that is to hold, to which value, unit)}"""


def table(numbers: Mapping[str, float]) -> str:
    """Return the table as text: what, target, measured, verdict."""
    rows = [("what", "target", "measured", "")]
    for key, (what, relation, bound, unit) in TARGETS.items():
        found, verdict = "–", "not measured"
        if key in numbers:
            met = {"≤": operator.le, "≥": operator.ge}[relation](numbers[key], bound)
            found, verdict = f"{numbers[key]:,.4g} {unit}", "met" if met else "not met"
        rows.append((what, f"{relation} {bound:,g} {unit}", found, verdict))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  ".join(map(str.ljust, row, widths)).rstrip() for row in rows)
