"""The picture's derivative: its maps, what edges add to a mean, differences of pictures, scenes found again."""

import numpy as np

from book.drawing.registry import Drawing, figure
from book.drawing.style import curve, decades, label_curve, panels, plot
from renderer import Scene, exact, fit, render
from renderer.files.srgb import to_bytes
from renderer.picture.views import derivative_view, image_view

SCENE, SIDE, SMALL, MANY = Scene(field="sine"), 264, 152, 512
MAPS = {"beta": "by β", "ku": "by $k_u$", "lights[0].position[0]": "by a light's x"}
OF_MEAN = MAPS | {"kd": "by $k_d$", "eye": "by the eye's height", "ball_center[0]": "by B's x", "radius": "by $R$"}


def _difference(name, step, side, scene=SCENE):
    """Return the central difference of pictures by a number."""
    here = scene.number(name)
    above, below = (scene.with_numbers({name: here + move}) for move in (step, -step))
    above, below = (render(scene, side, side, exact("general")).rgb for scene in (above, below))
    return (above - below) / (2 * step)


def _by_name(numbers):
    """Return numbers by names that a page can cite."""
    return {name.partition("[")[0]: number for name, number in zip(OF_MEAN, numbers, strict=False)}


@figure
def derivative_maps() -> Drawing:
    """The slopes of the picture of sine by β, by k_u and by a light's place, each on its own symmetric scale."""
    frame = render(SCENE, SIDE, SIDE, derivatives=[*MAPS], bounds=True)
    slopes, bounds = frame.derivatives.values(), frame.derivative_bounds.values()
    numbers = {"largest": _by_name(np.abs(slope).max() for slope in slopes)}
    numbers |= {"bound": _by_name(bound.max() for bound in bounds), "side": SIDE}
    ends = [np.quantile(np.abs(slope), 0.995) for slope in slopes]  # else a few pixels leave the rest white
    maps = [derivative_view(np.clip(slope, -end, end)) for slope, end in zip(slopes, ends, strict=True)]
    return Drawing(panels(maps, [*MAPS.values()]), numbers)


@figure
def derivative_edges() -> Drawing:
    """The mean of the slopes as a share of the slope of the mean colour, by seven numbers."""
    frame = render(SCENE, MANY, MANY, derivatives=[*OF_MEAN])
    steps = [1e-2 if name in frame.moves_boundaries else 1e-4 for name in OF_MEAN]
    means = [_difference(name, step, MANY).mean() for name, step in zip(OF_MEAN, steps, strict=True)]
    shares = [slope.mean() / mean for slope, mean in zip(frame.derivatives.values(), means, strict=True)]
    fig, ax = plot(height=3.2)
    ax.barh([*OF_MEAN.values()], shares)
    ax.set(xlabel="mean of the slopes, as a share of the slope of the mean", ylim=(len(shares) - 0.4, -0.6))
    creased = render(Scene(), MANY, MANY, derivatives=["ku"]).derivatives["ku"].mean()
    creased /= _difference("ku", 1e-2, MANY, Scene()).mean()
    return Drawing(fig, _by_name(shares) | {"side": MANY, "creased": creased}, {"shares": shares})


@figure
def derivative_u_curve() -> Drawing:
    """The largest error of a central difference of pictures by β, by its step, and the exact slope's bound."""
    frame, steps = render(SCENE, 128, 128, derivatives=["beta"], bounds=True), np.logspace(-1, -12, 56)
    exact_slope, on_a = frame.derivatives["beta"], frame.stage.on_a
    apart = np.array([np.abs(_difference("beta", step, 128) - exact_slope)[on_a] for step in steps])
    errors, medians = apart.max(axis=(1, 2)), np.median(apart, axis=(1, 2))
    bound = np.full_like(steps, frame.derivative_bounds["beta"].max())
    fig, ax = plot(height=3.9)
    curve(ax, steps, errors, "numeric", "largest", "right", 1e-7)
    curve(ax, steps, medians, "difference", "median", "left", 1e-10)
    curve(ax, steps, bound, "bound", label="exact slope")
    label_curve(ax, steps, bound, 1e-3, "largest bound of\nthe exact slope", "bound", "below")
    decades(ax, 2, 2, xlabel="step of β", ylabel="error of a difference of pictures")
    numbers = {"least": errors.min(), "best_step": steps[errors.argmin()], "bound": bound[0]}
    return Drawing(fig, numbers | {"side": len(exact_slope)})


@figure
def derivative_fit() -> Drawing:
    """A target, and where its search starts; numbers of ten starts, and of one from afar."""
    names, random, target = ("beta", "ku"), np.random.default_rng(52), render(SCENE, 64, 64, exact("general")).rgb

    def found(share, waves):
        start = {"beta": SCENE.beta * (1 + share), "ku": SCENE.ku + waves}
        return fit(SCENE.with_numbers(start), target, names)

    near = [found(0.2 * share, 0.25 * waves) for share, waves in random.uniform(-1, 1, (10, 2)).tolist()]
    off = [abs(each.scene.number(name) - SCENE.number(name)) for each in near for name in names]
    numbers = {"converged": sum(each.converged for each in near), "off": max(off), "far": found(-0.7, -5).scene.ku}
    numbers |= {"most": max(each.pictures for each in near), "side": len(target)}
    scenes = SCENE.with_numbers({"beta": 0.2, "ku": 8.2}), SCENE
    frames = [render(scene, SMALL, SMALL, bounds=True) for scene in scenes]
    return Drawing(panels([*map(image_view, frames)], ("the target", "the sphere")), numbers, shown=frames)


@figure
def found_again() -> Drawing:
    """A picture of sine under noise, the scene from which `fit` starts, and the one that it finds."""
    begin, random = {"beta": 0.1, "ku": 7.0}, np.random.default_rng(56)
    start = SCENE.with_numbers(begin)
    given = render(SCENE, SMALL, SMALL, exact("general")).rgb + random.normal(0, 0.1, (SMALL, SMALL, 3))
    found = fit(start, given, [*begin])
    numbers = {
        "start": begin,
        "found": {name: found.scene.number(name) for name in begin},
        "error": found.errors,
        "pictures": found.pictures,
        "side": SMALL,
    }
    frames = [render(scene, SMALL, SMALL, bounds=True) for scene in (start, found.scene)]
    pictures = [to_bytes(given), *map(image_view, frames)]
    return Drawing(panels(pictures, ("given", "the start", "found")), numbers, shown=frames)
