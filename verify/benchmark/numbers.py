"""From medians to the numbers that the table and the book cite."""

import numpy as np

from verify.benchmark.frames import FITTED


def ratio(times, name, above, below):
    """Return {name: how many times as long `above` takes as `below`}, empty if one was not timed."""
    return {name: times[above] / times[below]} if above in times and below in times else {}


def exponent(times, threads):
    """Return {exponent_threads: p} of the fit time ∝ pixels^p through the fitted sizes; empty unless all were timed."""
    names = [f"algebraic_{side}_{threads}" for side in FITTED]
    if not times.keys() >= set(names):
        return {}
    pixels = np.array(FITTED, float) ** 2
    return {f"exponent_{threads}": float(np.polyfit(np.log(pixels), np.log([times[name] for name in names]), 1)[0])}


def frame_numbers(times):
    """Return the milliseconds of frames, the seconds of starts, and what follows from them."""
    numbers = {}
    for name, seconds in times.items():
        start = name.startswith("start")
        numbers[f"{name}_s" if start else f"{name}_ms"] = seconds if start else 1e3 * seconds
    for side in (64, 256, 1024, 4096):
        ours = f"algebraic_{side}_2"
        numbers |= ratio(times, f"numpy_to_algebraic_{side}", f"numpy_{side}_2", ours)
        numbers |= ratio(times, f"seed_to_algebraic_{side}", f"seed_exact_{side}_1", ours)
        numbers |= ratio(times, f"central_to_algebraic_{side}", f"central_{side}_2", ours)
    numbers |= ratio(times, "seed_central_to_exact", "seed_central_256_1", "seed_exact_256_1")
    numbers |= ratio(times, "eps_step_central_to_exact", "eps_step_central_1024_2", "eps_step_exact_1024_2")
    numbers |= ratio(times, "a_alone_central_to_algebraic", "a_alone_central_1024_1", "a_alone_algebraic_1024_1")
    numbers |= ratio(times, "a_alone_central_to_general", "a_alone_central_1024_1", "a_alone_general_1024_1")
    return numbers | exponent(times, 1) | exponent(times, 2)
