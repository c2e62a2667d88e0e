"""The geometry of a scene: what its chambers depend on, beside the raster."""

from typing import NamedTuple

from renderer.scene.scene import Scene


class Geometry(NamedTuple):
    """What the chambers depend on, beside the raster: lengths, and the lights' positions, None for one that is off."""

    eye: float
    radius: float
    ball: tuple[float, float, float, float]
    ball_on: float
    floor_on: float
    lights: tuple


def geometry_of(scene: Scene) -> Geometry:
    """Return the Geometry of a scene. Without sphere B, `ball_on` is 0 and `ball` a unit sphere that is never drawn."""
    ball = (*scene.ball_center, scene.ball_radius) if scene.ball else (0.0, 0.0, 0.0, 1.0)
    lights = tuple(None if light.color is None else light.position for light in scene.lights)
    return Geometry(scene.eye, scene.radius, ball, float(scene.ball), float(scene.floor), lights)
