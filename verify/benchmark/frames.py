"""What is timed of whole frames: every renderer, sizes from 64² on, one thread and two, and steps of a sweep.

A case's name is renderer_side_threads. No frame is kept: two of 8192² at once would not fit everywhere.
"""

import itertools
from dataclasses import replace

from renderer import Scene, central, exact, render, stage_of
from verify.benchmark.baselines.numpy_tiles import numpy_tiles
from verify.benchmark.baselines.seed_loops import seed_loops
from verify.benchmark.plan import Case

SCENE = Scene()
A_ALONE = Scene(ball=False, floor=False)
EPS = 1e-3
THREADS = (1, 2)
METHODS = {"algebraic": exact("algebraic"), "general": exact("general"), "central": central(EPS)}
FITTED = (256, 512, 1024, 2048, 4096, 8192)
SIDES = {"seed_exact": (64, 128, 256), "seed_central": (64, 128, 256), "numpy": (64, 256, 1024, 4096),
         "algebraic": (64, *FITTED), "general": (64, 256, 1024, 4096), "central": (64, 256, 1024, 4096)}  # fmt: skip
SLOW = {"seed_exact": 3, "seed_central": 3, "numpy": 5}  # fewer visits, one call each
PIXELS_A_VISIT = 2**23
STEP = 1024


def calls(side):
    """Return how many frames of that side a visit times: two at least, so that one before them touches the memory."""
    return max(2, min(40, PIXELS_A_VISIT // side**2))


def prepared(function, *arguments, **options):
    """Return the case's `prepare`: a function that calls and keeps nothing, compiled by a first small call."""

    def prepare():
        def work():
            function(*arguments, **options)

        if function is render:
            render(arguments[0], 64, 64, *arguments[3:], threads=options["threads"])
        return work

    return prepare


def frame_case(name, side, threads):
    """Return the case of one whole frame, from nothing, by a renderer of SIDES."""
    label = f"{name}_{side}_{threads}"
    if name.startswith("seed"):
        return Case(
            label, prepared(seed_loops, SCENE, side, side, None if name == "seed_exact" else EPS), 1, SLOW[name]
        )
    if name == "numpy":
        return Case(label, prepared(numpy_tiles, SCENE, side, side, threads), max(1, calls(side) // 8), SLOW[name])
    return Case(label, prepared(render, SCENE, side, side, METHODS[name], threads=threads), calls(side))


def stepping(scene, frames, threads):
    """Return a `prepare` whose function draws the next of `frames`, (scene, method), with the chambers given."""

    def prepare():
        stage, following = stage_of(scene, STEP, STEP, threads=threads), itertools.cycle(frames)
        frame = render(scene, STEP, STEP, threads=threads, stage=stage)

        def work():
            nonlocal frame
            changed, method = next(following)
            frame = render(changed, STEP, STEP, method, threads=threads, stage=stage, into=frame)

        for _ in frames:  # whatever is to be compiled, is
            work()
        return work

    return prepare


def step_cases():
    """Return the cases with given chambers: steps of ε and β, and sphere A alone on one thread."""
    steps = [(SCENE, central(10.0**-n)) for n in range(2, 7)]
    betas = [(replace(SCENE, beta=beta), exact()) for beta in (0.1, 0.2, 0.35, 0.5)]
    cases = [
        Case(f"eps_step_exact_{STEP}_2", stepping(SCENE, [(SCENE, exact())], 2), calls(STEP)),
        Case(f"eps_step_central_{STEP}_2", stepping(SCENE, steps, 2), calls(STEP)),
        Case(f"beta_step_{STEP}_2", stepping(SCENE, betas, 2), calls(STEP)),
    ]
    for name, method in METHODS.items():
        cases.append(Case(f"a_alone_{name}_{STEP}_1", stepping(A_ALONE, [(A_ALONE, method)], 1), calls(STEP)))
    return cases


def frame_cases(largest):
    """Return every case of a whole frame up to a side of `largest`."""
    return [
        frame_case(name, side, threads)
        for name, sides in SIDES.items()
        for side in sides
        for threads in ((1,) if name.startswith("seed") else THREADS)
        if side <= largest
    ]
