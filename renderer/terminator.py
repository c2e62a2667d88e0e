"""The attached shadow: on which side of each light's horizon the bumped normal points."""

import numpy as np

from renderer.kernels import light_cosine_row, normal_on_a_row


def light_cosines(frame, light):
    """Return μ = N'·ω of light number `light` on sphere A, (height, width) float64, NaN off A.

    Its sign decides the attached shadow; a cast shadow of B is not looked at.
    """
    cosines = np.full(frame.raster.shape, np.nan)
    position, stage = frame.scene.lights[light].position, frame.stage
    g, columns = stage.geometry, frame.raster.shape[1]
    place = np.empty((6, columns))
    for band in stage.bands:
        p = frame.planes(band)
        for row, start, stop, _ in band.runs_on_a:
            angles = (p.cos_theta[row], p.sin_theta[row], p.cos_phi[row], p.sin_phi[row])
            normal_on_a_row(*angles, g.radius, p.h_u[row], p.h_v[row], frame.scene.beta, *place, start, stop)
            target = cosines[band.top + row]
            light_cosine_row(*place[:3], *position, *place[3:], target, start, stop)
    return cosines
