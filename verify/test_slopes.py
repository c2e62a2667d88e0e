"""Slopes of pictures by numbers of their scenes, and the bounds of these, against differences at 180 digits."""

import math
from dataclasses import replace

import numpy as np
import pytest
from flint import arb, ctx

from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import HeightField, Light, Scene, central, central4, exact, fit, forward, render
from verify.enclosed_pixels import truth_of
from verify.reference import COLORS, chamber_code, scene_values

pytestmark = pytest.mark.usefixtures("by_numpy")
BITS, STEP = 600, arb(2) ** -170
SINE, NAMES = Scene(field="sine"), ("beta", "ku")
CALLS = "log(3 + cospi(k_u*u))**2.5*sqrt(2 + sinpi(2*k_u*u)) + 2**sinpi(k_u*u) - exp(sinpi(k_v*v))/(2 + v)"
LIGHTS = Light((5.0, 5.0, 10.0), (0.0, 0.0, 0.0)), Light((-6.0, 2.0, 8.0), None), Light((-4.0, -4.0, 9.0))
PICTURES = {
    "sine": (SINE, "beta ku kv kd lights[0].position[0]"),
    "lengths": (SINE, "eye radius ball_center[1] ball_radius"),
    "phong": (Scene(ku=5.5, kv=3.25, model="phong", shininess=7.0), "beta ku ks shininess eye"),
    "rings": (Scene(field="rings", beta=-20.0), "beta ku kv"),
    "clipped": (replace(SINE, ks=3.0, kd=2.0), "beta shininess lights[1].color[0] ka ambient[2]"),
    "fractional": (replace(SINE, shininess=0.5), "shininess ks beta"),
    "nothing": (replace(SINE, beta=0.0, ks=0.0), "beta ks ku"),
    "colours": (Scene(), "floor_tint albedo_a[0] albedo_b[2] beta"),
    "black": (Scene(lights=LIGHTS), "lights[0].color[1] lights[0].position[2] lights[2].position[2]"),
    "surface": (replace(SINE, bump="surface", horizon=True, model="blinn_gated"), "beta kv radius"),
    "level": (replace(SINE, ku=0.0), "ku beta"),
    "unlit": (replace(SINE, kd=0.0, ks=0.0), "kd beta"),
    "central": (SINE, "ku eye", central(1e-3)),
    "forward": (Scene(), "beta kv", forward(1e-2)),
    "calls": (Scene(field=HeightField("calls", CALLS)), "ku kv"),
    "central4": (Scene(field="rings", beta=0.0), "beta", central4(1e-3)),
}


def truth(frame, name, column, row):
    """Return the slopes of a pixel's colours by a number, as balls; none of one that lies on an edge."""
    values, number = scene_values(frame.scene), frame.scene.number(name)
    other = scene_values(frame.scene.with_numbers({name: math.nextafter(number, 1 / 3)}))
    (key,) = (each for each in values if values[each] != other[each])
    with ctx.workprec(BITS):
        below, above = (truth_of(frame, column, row, BITS, **{key: arb(values[key]) + sign * STEP}) for sign in (-1, 1))
        codes = [
            chamber_code(frame.scene, lambda line, side=side: int(side[line].unique_fmpz() or 0))
            for side in (below, above)
        ]
        slopes = [(above[color] - below[color]) / (2 * STEP) for color in COLORS]
    edge = codes != [frame.chambers[row, column]] * 2 or any(slope.rad() > 1e-20 for slope in slopes)
    return [] if edge else slopes


@pytest.mark.parametrize("kind", PICTURES)
def test_no_slope_is_further_off_than_its_bound(kind, monkeypatch):
    """No bound is far too large, none NaN; the pixels of the largest bounds are among those compared."""
    scene, names, *method = PICTURES[kind]
    monkeypatch.setitem(HEIGHT_FIELDS, scene.field, HEIGHT_FIELDS.get(scene.field, scene.field))
    frame, random = render(scene, 24, 24, *method, derivatives=names.split(), bounds=True), np.random.default_rng(52)
    for name, bounds in frame.derivative_bounds.items():
        slopes, decided = frame.derivatives[name], np.isfinite(bounds).all(axis=2) & ~frame.open
        assert np.isfinite(slopes).all() and decided.mean() > 0.9 and np.median(bounds) < 1e-10
        ranked, apart = np.argwhere(decided)[np.argsort(bounds.max(axis=2)[decided])], []
        for row, column in [*ranked[-4:].tolist(), *random.permutation(ranked)[:6].tolist()]:
            balls = zip(slopes[row, column], truth(frame, name, column, row), bounds[row, column], strict=False)
            apart += [abs(arb(slope) - true) > arb(bound) for slope, true, bound in balls]
        assert len(apart) > 20 and not any(apart)


def test_both_slopes_at_a_kink_are_within_the_bound():
    """At a clip that is met exactly; on an exact crease that moves, where there is none, the bound is infinite."""
    lit = render(Scene(lights=(), ka=1.0, ambient=(1.0, 0.5, 0.0)), 8, 8, derivatives=("ka", "ambient[2]"), bounds=True)
    on_clip, below, _ = np.moveaxis(lit.derivative_bounds["ka"], 2, 0)
    assert (on_clip >= 1.0).all() and (below < 1e-15).all()
    assert (lit.derivative_bounds["ambient[2]"][..., 2] >= 1.0).all()
    names = "beta", "ku", "kv"
    odd, plain = (render(Scene(), 49, 49, exact("general"), bounds=True, derivatives=by) for by in (names, ()))
    assert odd.moves_boundaries == ("ku", "kv") and lit.moves_boundaries == ()
    infinite = [np.isinf(odd.derivative_bounds[name][:, 24]).any() for name in names]
    assert infinite == [False, True, False] and (odd.open == plain.open).all()


def test_a_scene_is_found_again_from_ten_starts():
    """From amplitudes within 20 % and wave numbers within a quarter wave; with noise, within the stated errors."""
    target, random = render(SINE, 64, 64, exact("general")).rgb, np.random.default_rng(52)
    for share, waves in random.uniform(-1, 1, (10, 2)).tolist():
        start = replace(SINE, beta=SINE.beta * (1 + 0.2 * share), ku=SINE.ku + 0.25 * waves)
        found = fit(start, target, NAMES)
        assert found.converged and max(abs(found.scene.number(name) - SINE.number(name)) for name in NAMES) < 1e-12
    noisy = fit(start, target + random.normal(0, 1e-3, target.shape), NAMES)
    assert all(0 < abs(noisy.scene.number(name) - SINE.number(name)) < 4 * noisy.errors[name] for name in NAMES)
    assert not fit(replace(SINE, beta=0.05, ku=3.0), target, NAMES, 20).converged
