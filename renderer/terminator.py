"""The attached shadow: on which side of each light's horizon the bumped normal points."""

import numpy as np

from renderer.kernels import light_cosine_row, normal_on_a_row


def light_cosines(frame, light):
    """Return μ = N'·ω of light number `light` on sphere A, (height, width) float64, NaN off A.

    Its sign decides the attached shadow; a cast shadow of B is not looked at.
    """
    scene, angles_and_gradient = frame.scene, frame.planes_on_a
    count = angles_and_gradient.shape[1]
    place, unused, mu = np.empty((6, count)), np.empty(count), np.empty(count)
    normal_on_a_row(
        *angles_and_gradient, scene.beta, scene.radius, np.zeros(count), 0.0, scene.eye, *place, unused, 0, count
    )
    light_cosine_row(*place[:3], *scene.lights[light].position, *place[3:], mu, 0, count)
    cosines = np.full(frame.raster.shape, np.nan)
    cosines[frame.stage.on_a] = mu
    return cosines
