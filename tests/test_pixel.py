"""The record of one pixel: the same bits as the frame, and parts that add up to its colour."""

import math
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from renderer import Scene, pixel, render
from renderer.picture.pixel_record import PixelRecord
from renderer.scene.raster import Raster
from tests.strategies import methods, rasters, scenes


@given(scenes(), rasters(), methods, st.data())
def test_a_record_has_the_bits_of_the_frame_and_what_adds_up_to_them(scene, size, method, data):
    column, row = (data.draw(st.integers(0, side - 1)) for side in size)
    record, frame = pixel(scene, *size, column, row, method), render(scene, *size, method)
    assert record.rgb == tuple(frame.rgb[row, column])
    assert record.chamber == frame.chambers[row, column]
    assert bool(record.kink) == frame.kink[row, column]
    assert bool(record.straddling) == frame.straddling[row, column]
    if record.surface == "A":
        surface = {name: plane[row, column] for name, plane in frame.surface_data.items()}
        assert (record.u, record.v, record.h) == (surface["u"], surface["v"], surface["h"])
        assert record.gradient == (surface["h_u"], surface["h_v"])
    if record.surface == "none":
        assert (record.rgb, record.lights) == ((0.0, 0.0, 0.0), ())
        return
    on = [number for number, light in enumerate(scene.lights) if light.color is not None]
    assert [light.number for light in record.lights] == on
    assert all(light.occluded == bool(record.chamber >> (2 + light.number) & 1) for light in record.lights)
    assert all(light.adds == (0.0, 0.0, 0.0) for light in record.lights if light.occluded)
    for channel in range(3):
        terms = [scene.ka * scene.ambient[channel], *(light.adds[channel] for light in record.lights)]
        assert record.rgb[channel] == pytest.approx(min(1.0, sum(terms)), abs=2e-15)


def first_of(surface, scene=None):
    """The first pixel of a surface in the default frame, as a record."""
    scene = scene or Scene()
    row, column = np.argwhere(render(scene, 64, 64).chambers & 3 == surface)[0]
    return pixel(scene, 64, 64, int(column), int(row))


def test_a_record_has_the_gradient_of_the_field_without_a_bump_too():
    flat, bumped = (pixel(Scene(beta=beta), 256, 256, 104, 72) for beta in (0.0, 0.35))
    assert flat.gradient == bumped.gradient != (0.0, 0.0)


@pytest.mark.parametrize(("surface", "name"), [(0, "none"), (2, "B"), (3, "floor")])
def test_what_exists_on_a_alone_is_none_elsewhere(surface, name):
    record = first_of(surface, Scene(floor=surface == 3))
    assert record.surface == name
    assert {getattr(record, field) for field in ("theta", "phi", "u", "v", "h", "gradient", "kink")} == {None}


@pytest.mark.parametrize("surface", [1, 2, 3])
def test_points_lie_on_their_surfaces_and_on_the_ray_through_the_pixel(surface):
    record, scene = first_of(surface), Scene()
    off = {1: math.hypot(*record.point) - 1, 2: math.dist(record.point, scene.ball_center) - 0.32, 3: record.point[2]}
    assert abs(off[surface]) <= 1e-14
    x, y = Raster(64, 64).image_points(scene)
    eye, image_point = np.array([0, 0, 4.0]), np.array([x[record.column], y[record.row], 0.0])
    share = 1 - record.point[2] / 4
    assert 0 < share <= 1
    np.testing.assert_allclose(record.point, eye + share * (image_point - eye), rtol=0, atol=1e-14)


def test_the_chart_belongs_to_the_point():
    record = first_of(1)
    x, y, z = record.point
    assert record.theta == pytest.approx(math.atan2(y, x), abs=1e-14)
    assert record.phi == pytest.approx(math.acos(z), abs=1e-12)
    assert (record.u, record.v) == pytest.approx(((record.theta + math.pi) / (2 * math.pi), record.phi / math.pi))


def test_the_bumped_normal_is_the_frames():
    record = first_of(1)
    (h_u, h_v), theta, phi = record.gradient, record.theta, record.phi
    n = np.array(record.point)
    e_theta = np.array([-math.sin(theta), math.cos(theta), 0])
    e_phi = np.array([math.cos(phi) * math.cos(theta), math.cos(phi) * math.sin(theta), -math.sin(phi)])
    m = n + 0.35 * (h_u * e_theta + h_v * e_phi)
    np.testing.assert_allclose(record.normal, m / np.linalg.norm(m), rtol=0, atol=1e-13)


@pytest.mark.parametrize("model", ["blinn", "phong"])
@pytest.mark.parametrize("surface", [1, 2, 3])
def test_the_light_of_a_pixel_is_the_models(model, surface):
    scene = replace(Scene(), model=model, shininess=7.5)
    record = first_of(surface, scene)
    n, p = np.array(record.normal), np.array(record.point)
    view = np.array([0, 0, 4.0]) - p
    view /= np.linalg.norm(view)
    for light, source in zip(record.lights, scene.lights, strict=True):
        omega = np.array(source.position) - p
        omega /= np.linalg.norm(omega)
        halfway = (omega + view) / np.linalg.norm(omega + view)
        base = n @ halfway if model == "blinn" else (2 * (n @ omega) * n - omega) @ view
        assert light.mu == pytest.approx(n @ omega, abs=1e-14)
        assert light.specular == pytest.approx(max(0.0, base) ** 7.5, abs=1e-13)


@pytest.mark.parametrize("place", [(-1, 0), (64, 0), (0, -1), (0, 64), (0.5, 0)])
def test_a_pixel_off_the_raster_is_rejected(place):
    with pytest.raises(ValueError, match=r"crop = .* is not allowed: .* inside the raster of 64 x 64"):
        pixel(Scene(), 64, 64, *place)


def test_a_record_is_plain_numbers():
    record = first_of(1)
    plain = (int, float, str, bool, tuple)
    assert all(isinstance(getattr(record, f.name), plain) for f in fields(PixelRecord))
    assert all(type(c) is float for c in (*record.rgb, *record.point, *record.normal, *record.gradient))
