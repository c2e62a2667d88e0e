"""What the seed says of its pictures, looked at; numbers only, for the ledger."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.figures.chapter_scene import SIZE, numeric, symbolic
from renderer import Scene, central, render
from renderer.sweep import difference_on_a, rms
from renderer.views import to_bytes

FIRST_LEVEL = 0.5 / 255  # what rounds to the first of 255 levels
SMALL_STEPS = 10.0 ** -np.arange(8, 17)


def flat_limits(size=128):
    """Return three pictures' largest or mean difference from the plain sphere, and two differences' errors."""
    flat = render(Scene(beta=0.0), size, size).rgb
    no_height = render(Scene(field="sine", ku=0, beta=1.5), size, size).rgb
    high = render(Scene(field="sine", beta=1.5), size, size)
    errors = {
        eps: np.abs(render(high.scene, size, size, central(eps), stage=high.stage).rgb - high.rgb).max()
        for eps in (1e-3, 1e-4)
    }
    return {
        "no_height": np.abs(no_height - flat).max(),
        "called_no_height": np.abs(high.rgb - flat).mean(),
        "high_error": errors[1e-3],
        "high_error_ratio": errors[1e-3] / errors[1e-4],
    }


def first_visible_step():
    """Return the largest step from 1e-8 downwards at which |ΔI| × 100 reaches the first level of a linear canvas."""
    for eps in SMALL_STEPS:
        frame = render(Scene(field="sine"), SIZE, SIZE, central(eps), stage=symbolic("sine").stage)
        if 100 * np.abs(difference_on_a(frame, symbolic("sine"))).max() >= FIRST_LEVEL:
            return float(eps)
    raise ValueError("no step of these reaches the first level")


def clamp_taken(eps):
    """Return the share of A's pixels whose v ± ε lies in the chart and whose rounded span is below 2ε all the same."""
    v = symbolic().surface_data["v"][symbolic().stage.on_a]
    v = v[(v - eps > 0) & (v + eps < 1)]
    return float(np.mean((v + eps) - (v - eps) < 2 * eps))


@figure("seed_pictures")
def seed_pictures() -> Drawing:
    """The seed's words on its pictures against the pictures: limits, what an eye sees, where the creases part."""
    on_a = symbolic().stage.on_a
    small, large = numeric(eps=1e-3), numeric(eps=1e-2)
    levels = np.abs(to_bytes(small.rgb).astype(int) - to_bytes(symbolic().rgb))[on_a].max(axis=1)
    h_u, h_v = symbolic().surface_data["h_u"][on_a], symbolic().surface_data["h_v"][on_a]
    sum_of_slopes, length = np.abs(h_u) + np.abs(h_v), np.hypot(h_u, h_v)
    steps = np.array([1e-2, 1e-3, 1e-4])
    sine = [rms(difference_on_a(numeric("sine", eps=float(eps)), symbolic("sine"))) for eps in steps]
    straddling, kink = large.straddling[on_a], symbolic().kink[on_a]
    numbers = {
        "off_a": float(np.abs(large.rgb - symbolic().rgb)[~on_a].max()),
        "levels_changed": float(np.mean(levels > 0)),
        "sum_over_length": float(np.max(sum_of_slopes[length > 0] / length[length > 0])),
        "straddled_without_flag": float(np.mean(~kink[straddling])),
        "sine_rms_slope": float(np.polyfit(np.log(steps), np.log(sine), 1)[0]),
        "first_visible": first_visible_step(),
        "clamp_1e-3": clamp_taken(1e-3),
        "clamp_1e-6": clamp_taken(1e-6),
    }
    return Drawing(numbers=numbers | flat_limits())
