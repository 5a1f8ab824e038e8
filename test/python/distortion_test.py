# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distortion of maps to the plane."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import face_areas, sphere_arrays

# Singular values are computed from edge lengths of 0.1.
ROUND_OFF = 1e-12


def test_identity_has_no_distortion(grid):
    found = grid.face_distortion(grid.vertices[:, :2])
    assert np.abs(found.sigma_1 - 1).max() <= ROUND_OFF
    assert np.abs(found.sigma_2 - 1).max() <= ROUND_OFF
    assert found.is_inverted.dtype == bool and not found.is_inverted.any()
    assert np.abs(found.area - face_areas(grid)).max() <= ROUND_OFF


def test_singular_values_of_stretched_square(grid):
    uv = grid.vertices[:, :2] * [4, -0.5]
    found = grid.face_distortion(uv)
    # From the plane to the face, lengths are divided by 4 and by 0.5.
    assert np.abs(found.sigma_1 - 2).max() <= 10 * ROUND_OFF
    assert np.abs(found.sigma_2 - 0.25).max() <= 10 * ROUND_OFF
    assert found.is_inverted.all()


def test_images_of_corners_are_those_of_vertices(grid):
    uv = np.random.default_rng(5).uniform(size=(121, 2))
    of_vertices = grid.face_distortion(uv)
    of_corners = grid.face_distortion(uv[grid.faces])
    assert all(np.array_equal(a, b) for a, b in zip(of_vertices, of_corners))
    assert grid.surface_distortion(uv) == grid.surface_distortion(uv[grid.faces])


def test_corners_are_in_the_order_of_faces(grid):
    # Each face is scaled by its own factor. If corners were permuted, singular values would differ.
    factor = 1 + np.arange(grid.number_of_faces) / 7
    uv = grid.vertices[grid.faces][:, :, :2] * factor[:, None, None] + [3, 1]
    found = grid.face_distortion(uv)
    assert np.abs(found.sigma_1 * factor - 1).max() <= 1000 * ROUND_OFF
    assert np.abs(found.sigma_2 * factor - 1).max() <= 1000 * ROUND_OFF


A, B = 2.0, 0.5  # singular values
MEASURES = {
    "mips": A / B,
    "symmetric-mips": A / B + B / A,
    "conformal": (A - B) ** 2 / 2,
    "green-lagrange": (A**2 - 1) ** 2 + (B**2 - 1) ** 2,
    "dirichlet": (A**2 + B**2) / 2,
    "l2-stretch": math.sqrt((A**2 + B**2) / 2),
    "linf-stretch": A,
    "symmetric-stretch": max(A, 1 / B),
    "symmetric-dirichlet": A**2 + B**2 + 1 / A**2 + 1 / B**2,
    "riemannian": 2 * math.hypot(math.log(A), math.log(B)),
}


@pytest.mark.parametrize("measure", MEASURES)
def test_measures_of_stretched_square(surface, measure):
    found = surface.surface_distortion(surface.vertices[:, :2] / [A, B], measure)
    expected = MEASURES[measure]
    assert abs(found.mean - expected) <= 100 * ROUND_OFF
    assert abs(found.worst - expected) <= 100 * ROUND_OFF
    assert found.number_of_flips == 0
    assert found.integral == pytest.approx(found.area * found.mean, rel=1e-15)
    # On a cloud, triangles overlap, and the weighted area is an estimate.
    assert abs(found.area - 1) <= (0.2 if surface.is_cloud else ROUND_OFF)
    if not surface.is_cloud:
        assert found.number_of_triangles == surface.number_of_faces


def test_worst_location_is_the_worst_face(grid):
    uv = grid.vertices[grid.faces][:, :, :2]
    uv[17] *= 3
    uv[40] = np.nan
    found = grid.surface_distortion(uv)
    assert found.number_of_triangles == grid.number_of_faces - 1
    assert found.worst_location.face == 17
    assert np.abs(np.array(found.worst_location.barycentric) - 1 / 3).max() <= 1e-15
    assert abs(found.worst - (2 / 9 + 18)) <= 1000 * ROUND_OFF


def test_map_without_images(surface):
    found = surface.surface_distortion(np.full((121, 2), np.nan))
    assert found.number_of_triangles == 0 and found.worst_location is None
    assert math.isnan(found.mean)


def test_minimum_of_flat_mesh_is_isometric(grid):
    uv = grid.vertices[:, :2] * [2, 0.7]
    before = uv.copy()
    found = grid.minimize_distortion(uv)
    assert np.array_equal(uv, before)
    assert found.number_of_flips_before == found.number_of_flips == 0
    # Iteration ends at a relative change of 1e-6.
    assert 4 <= found.symmetric_dirichlet + 1e-12 and found.symmetric_dirichlet <= 4 + 1e-4
    assert 0 < found.number_of_iterations <= 200
    mean = grid.surface_distortion(found.uv).mean
    assert mean == pytest.approx(found.symmetric_dirichlet, rel=1e-9)


def test_inverted_faces_are_unflipped(grid):
    uv = grid.vertices[:, :2].copy()
    uv[60] = [0.75, 0.62]  # outside of its neighbors
    found = grid.minimize_distortion(uv)
    assert found.number_of_flips_before > 0 and found.number_of_flips == 0
    assert not grid.face_distortion(found.uv).is_inverted.any()
    assert found.symmetric_dirichlet <= 4 + 1e-4


def test_energy_decreases_with_iterations(grid):
    uv = grid.vertices[:, :2] * [3, 1] + 0.02 * np.sin(37 * grid.vertices[:, :2])
    energies = [
        grid.minimize_distortion(uv, max_iterations=n).symmetric_dirichlet for n in (0, 1, 3, 20)
    ]
    assert energies == sorted(energies, reverse=True)


def test_distortion_rejects(grid, cloud):
    uv = grid.vertices[:, :2]
    for function in (grid.face_distortion, grid.surface_distortion, grid.minimize_distortion):
        for bad in (uv[1:], grid.vertices, uv[:, 0], None, "uv", [[0, 1], [2]]):
            with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
                function(bad)
    for bad in (uv[grid.faces][1:], uv[grid.faces][:, :2], np.zeros((200, 3, 3))):
        for function in (grid.face_distortion, grid.surface_distortion):
            with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
                function(bad)
    for function in (
        lambda: grid.surface_distortion(uv, "best"), lambda: grid.surface_distortion(uv, None),
        lambda: grid.minimize_distortion(np.full((121, 2), np.nan)),
        lambda: grid.minimize_distortion(uv, max_iterations=-1),
    ):
        with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
            function()
    sphere = gp.Surface(*sphere_arrays(1))
    for function in (
        lambda: sphere.minimize_distortion(sphere.vertices[:, :2]),
        lambda: cloud.minimize_distortion(uv), lambda: cloud.face_distortion(uv),
        lambda: cloud.surface_distortion(uv[grid.faces]),
    ):
        with pytest.raises(gp.UnsupportedSurfaceError, match=r"\.$"):
            function()
    with pytest.raises(gp.Cancelled):
        grid.minimize_distortion(uv * [2, 1], callback=lambda fraction: False)
