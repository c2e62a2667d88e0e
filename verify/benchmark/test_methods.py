"""Every method takes the same gradient, each difference at its order; what is not installed is left out."""

import numpy as np
import pytest

from proofs.formulas.camera import angles_on_a
from proofs.formulas.height_fields import HEIGHT_FIELDS
from renderer import Scene, exact, render
from verify.benchmark.methods import table
from verify.benchmark.work_precision import largest_error, points_for
from verify.evaluate.arrays import in_float64
from verify.evaluate.programs import algebraic_gradient

POINTS = 200
AVAILABLE = [method for method in table.METHODS if method.available]
ORDERS = {"forward": 1, "central": 2, "central, 4th order": 4, "central, 6th order": 6, "Richardson, 8th order": 8}
LEAST = {"exact, algebraic, float32": 1e-4, "forward": 1e-5, "central": 1e-7, "central, 4th order": 1e-9}


def error(method, value):
    """Return the method's largest error at the sample's points."""
    return largest_error(method.make(value)(*points_for(method, POINTS)), POINTS)


@pytest.mark.parametrize("method", AVAILABLE, ids=lambda method: method.name)
def test_every_method_finds_the_gradient(method):
    best = min(error(method, value) for value in method.values[:: 1 if len(method.values) < 10 else 3])
    assert best < LEAST.get(method.name, 2e-11)


@pytest.mark.parametrize("name", ORDERS)
def test_differences_have_their_order(name):
    """Between two steps at which truncation leads, the error falls by their ratio to the order."""
    method = next(m for m in table.METHODS if m.name == name)
    high = {1: 1e-4, 2: 1e-3, 4: 1e-2, 6: 2e-2, 8: 3e-2}[ORDERS[name]]
    low = high / 1.5
    fitted = np.log(error(method, high) / error(method, low)) / np.log(high / low)
    assert fitted == pytest.approx(ORDERS[name], abs=0.15)


@pytest.mark.parametrize(("field", "ku", "kv"), [("sine", 8, 4), ("ridges", -6, 5), ("rings", 3, -7), ("sine", 0, 64)])
def test_the_written_out_powers_are_the_renderers(field, ku, kv):
    """The same gradient as in a frame, to rounding."""
    scene = Scene(field=field, ku=float(ku), kv=float(kv), ball=False)
    frame = render(scene, 20, 20, exact("algebraic"))
    on_a, lens = frame.stage.on_a, {"eye": scene.eye, "radius": scene.radius}
    x, y = np.meshgrid(*frame.raster.image_points(scene))
    angles = in_float64(angles_on_a, {"x": x[on_a], "y": y[on_a], **lens})
    program = algebraic_gradient(HEIGHT_FIELDS[field], ku, kv)
    found = in_float64(program, angles | {"k_u": ku, "k_v": kv})
    for name in ("h_u", "h_v"):
        np.testing.assert_allclose(found[name], frame.surface_data[name][on_a], rtol=0, atol=1e-11)


@pytest.mark.parametrize(("ku", "kv"), [(7.0, 4.0), (8.0, 4.5)])
def test_without_an_algebraic_form(ku, kv):
    with pytest.raises(ValueError, match="no algebraic form"):
        algebraic_gradient(HEIGHT_FIELDS["sine"], ku, kv)
