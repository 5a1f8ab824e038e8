# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvatures and speeds."""

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import sphere_arrays

RADIUS = 2.5


@pytest.fixture(scope="module", params=["mesh", "cloud"])
def sphere(request):
    V, F = sphere_arrays(4)
    if request.param == "mesh":
        return gp.Surface(RADIUS * V, F)
    return gp.Surface(RADIUS * V, normals=V)


@pytest.fixture(scope="module")
def cylinder():
    """A cylinder of radius 2 around the z axis."""
    n, m = 60, 40
    i, j = np.meshgrid(np.arange(n), np.arange(m), indexing="ij")
    a = 2 * np.pi * i.ravel() / n
    V = np.stack([2 * np.cos(a), 2 * np.sin(a), 0.2 * j.ravel()], axis=1)
    p = (i * m + j)[:, :-1].ravel()
    q = ((i + 1) % n * m + j)[:, :-1].ravel()
    F = np.concatenate([np.stack([p, q, q + 1], 1), np.stack([p, q + 1, p + 1], 1)])
    return gp.Surface(V, F), (j.ravel() > 10) & (j.ravel() < 30)


def test_curvatures_of_sphere(sphere):
    found = sphere.principal_curvatures()
    # Averages over balls of about 100 vertices: the discretization error is a few percent.
    assert np.abs(RADIUS * found.min_curvature - 1).max() <= 0.1
    assert np.abs(RADIUS * found.max_curvature - 1).max() <= 0.1
    assert (found.min_curvature <= found.max_curvature).all()


def test_directions_are_orthonormal_and_tangent(sphere):
    found = sphere.principal_curvatures(ball_radius=0.8, threads=1)
    a, b = found.min_direction, found.max_direction
    assert a.shape == b.shape == (sphere.number_of_points, 3)
    # Unit vectors from an eigenvalue decomposition.
    assert np.abs(np.linalg.norm(a, axis=1) - 1).max() <= 1e-12
    assert np.abs(np.linalg.norm(b, axis=1) - 1).max() <= 1e-12
    assert np.abs((a * b).sum(axis=1)).max() <= 1e-12
    # The normal is that of an average over a ball, in which normals differ by at most 0.8 / RADIUS.
    assert np.abs((a * sphere.vertices).sum(axis=1)).max() <= 0.8


def test_directions_of_cylinder(cylinder):
    surface, is_inside = cylinder
    found = surface.principal_curvatures()
    assert np.abs(found.min_curvature[is_inside]).max() <= 1e-3
    assert np.abs(found.max_curvature[is_inside] - 0.5).max() <= 0.05
    # The grid is symmetric up to its diagonals.
    assert (np.abs(found.min_direction[is_inside, 2]) >= 0.99).all()


def test_plane_has_no_curvature(surface):
    found = surface.principal_curvatures()
    assert np.abs(found.min_curvature).max() <= 1e-12
    assert np.abs(found.max_curvature).max() <= 1e-12


def test_isolated_vertex_has_no_directions():
    surface = gp.Surface([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5]], [[0, 1, 2]])
    found = surface.principal_curvatures()
    assert (found.min_direction[3] == 0).all() and (found.max_direction[3] == 0).all()


def test_threads_do_not_change_curvatures(sphere):
    one, two = sphere.principal_curvatures(threads=1), sphere.principal_curvatures(threads=2)
    assert all(np.array_equal(a, b) for a, b in zip(one, two))


def test_speeds_of_plane_are_one(surface):
    for kind in ("attractive", "repulsive"):
        assert np.abs(surface.curvature_speeds(kind) - 1).max() <= 1e-12
    assert np.abs(surface.similar_curvature_speeds(60) - 1).max() <= 1e-12
    assert (surface.image_speeds(np.full(121, 7.0)) == 1).all()


def test_default_speeds_of_sphere(sphere):
    # The default strength yields 1/2 and 2; curvatures have an error of a few percent.
    assert np.abs(sphere.curvature_speeds() - 0.5).max() <= 0.03
    assert np.abs(sphere.curvature_speeds("repulsive") - 2).max() <= 0.1
    assert (sphere.curvature_speeds(strength=0) == 1).all()
    assert (sphere.curvature_speeds(strength=3) < sphere.curvature_speeds()).all()


def test_speeds_follow_their_formula(sphere):
    # With a strength s, the speed is 1 / (1 + s t) or 1 + s t, and t does not depend on s.
    t = sphere.curvature_speeds("repulsive", strength=1.0, ball_radius=0.9) - 1
    attractive = sphere.curvature_speeds(strength=0.3, ball_radius=0.9)
    assert np.abs(attractive - 1 / (1 + 0.3 * t)).max() <= 1e-14


def test_similar_curvature_is_fast(sphere):
    speed = sphere.similar_curvature_speeds(17, strength=5.0)
    assert speed[17] == 1 and (speed > 0).all() and (speed <= 1).all()


def test_speeds_of_cylinder_differ_at_boundary(cylinder):
    surface, is_inside = cylinder
    speed = surface.similar_curvature_speeds(np.flatnonzero(is_inside)[0])
    assert np.abs(speed[is_inside] - 1).max() <= 1e-3


def test_constant_gradient_has_minimum_speed(surface):
    x = surface.vertices[:, 0]
    # The norm of the gradient is the same everywhere: the speed is 1 / (1 + strength).
    assert np.abs(surface.image_speeds(x) - 1 / 21).max() <= 1e-12
    assert np.abs(surface.image_speeds(100 * x, strength=3) - 1 / 4).max() <= 1e-12
    colors = np.stack([x, x, x], axis=1)
    assert np.abs(surface.image_speeds(colors) - 1 / 21).max() <= 1e-12


def test_edges_of_image_are_slow(grid):
    image = (grid.vertices[:, 0] > 0.55).astype(float)
    speed = grid.image_speeds(image)
    assert (speed[np.abs(grid.vertices[:, 0] - 0.55) > 0.2] == 1).all()
    assert speed.min() == 1 / 21


def test_curvature_rejects(surface):
    for function in (
        lambda: surface.principal_curvatures(-1), lambda: surface.principal_curvatures("large"),
        lambda: surface.principal_curvatures(threads=0),
        lambda: surface.curvature_speeds("fast"), lambda: surface.curvature_speeds(strength=-1),
        lambda: surface.curvature_speeds(strength=np.inf),
        lambda: surface.curvature_speeds(ball_radius=np.nan),
        lambda: surface.similar_curvature_speeds(-1), lambda: surface.similar_curvature_speeds(121),
        lambda: surface.similar_curvature_speeds(None), lambda: surface.image_speeds(np.ones(3)),
        lambda: surface.image_speeds(np.ones((121, 2))), lambda: surface.image_speeds(None),
        lambda: surface.image_speeds(np.full(121, np.nan)),
        lambda: surface.image_speeds(np.ones(121), strength=-1),
    ):
        with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
            function()
