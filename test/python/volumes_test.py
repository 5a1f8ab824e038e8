# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances in space."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import cube_arrays, grid_arrays
from error_test import check_error

GAP = 1e-3  # the default tolerance of the bounds, relative to the upper bound
INSIDE, OUTSIDE = [0.3, 0.4, 0.6], [1.7, 0.5, -0.2]


@pytest.fixture
def cube():
    return gp.Surface(*cube_arrays())


TETRAHEDRON = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])


@pytest.fixture
def tetrahedron():
    return gp.Surface(TETRAHEDRON, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


def coordinates_in_tetrahedron(point):
    return np.concatenate([[1 - point.sum()], point])


def test_distance_of_vertices_is_that_of_the_surface(cube):
    volumetric = cube.volumetric_distance([0, 0, 0], [1, 1, 0]).cost
    on_surface = cube.emd(0, 6).cost
    assert abs(volumetric.value - on_surface.value) <= 2 * GAP * on_surface.value
    assert volumetric.is_converged and volumetric.lower <= volumetric.value <= volumetric.upper


@pytest.mark.parametrize("b", [INSIDE, OUTSIDE, [0.5, 0.5, 1.0]])
def test_distance_is_symmetric_and_not_below_straight_line(cube, b):
    metric = cube.volumetric_metric()
    a = [0.6, 0.2, 0.3]
    result = metric.distance(a, b)
    assert result.cost.upper >= np.linalg.norm(np.subtract(a, b)) * (1 - 1e-9)
    assert abs(metric.distance(b, a).cost.value - result.cost.value) <= GAP * result.cost.value
    assert metric.distance(b, b).cost.value <= 1e-9
    assert result.potential.shape == (8,) and result.flow.shape == (12, 3)
    assert np.isfinite(result.flow).all()
    assert cube.volumetric_distance(a, b).cost == result.cost


def test_distances_to_many_points_have_bounds(cube):
    metric = cube.volumetric_metric(number_of_refinements=0)
    points = np.random.default_rng(5).uniform(-0.5, 1.5, (40, 3))
    result = metric.distances(INSIDE, points)
    assert result.is_converged.all() and result.is_converged.dtype == bool
    assert (result.upper - result.lower <= 0.02 * result.upper).all()
    for i in (0, 7, 39):
        single = metric.distance(INSIDE, points[i]).cost
        assert result.lower[i] <= single.upper * (1 + 1e-9)
        assert single.lower <= result.upper[i] * (1 + 1e-9)
    sequential = metric.distances(INSIDE, points, threads=1)
    assert np.array_equal(sequential.values, result.values)


def test_path_inside_reaches_its_end(cube):
    path = cube.volumetric_metric().path([0.6, 0.3, 0.3], INSIDE)
    assert path.has_arrived
    assert np.abs(path.points[[0, -1]] - [[0.6, 0.3, 0.3], INSIDE]).max() <= 1e-12
    assert ((path.points > 0) & (path.points < 1)).all()


def test_given_coordinates_replace_mean_value_coordinates(tetrahedron):
    a, b = [0.1, 0.2, 0.3], [0.4, 0.15, 0.2]
    # Barycentric coordinates of a tetrahedron are unique.
    expected = tetrahedron.volumetric_distance(a, b).cost.value
    points = []

    def coordinates(point):
        points.append(point.copy())
        return coordinates_in_tetrahedron(point)

    metric = tetrahedron.volumetric_metric(barycentric_coordinates=coordinates)
    assert abs(metric.distance(a, b).cost.value - expected) <= 1e-9
    assert {tuple(p) for p in points} >= {tuple(a), tuple(b)}
    many = metric.distances(a, [b, a], threads=2)
    assert many.lower[0] <= expected * (1 + 1e-9) and expected <= many.upper[0] * (1 + 1e-9)
    refined = tetrahedron.volumetric_metric(
        barycentric_coordinates=coordinates_in_tetrahedron, number_of_refinements=2
    )
    assert refined.distance(a, b).cost.value >= expected * (1 - 2 * GAP)


def test_errors_of_coordinates_arrive(tetrahedron):
    raised = KeyError("reason")

    def fail(point):
        raise raised

    metric = tetrahedron.volumetric_metric(barycentric_coordinates=fail)
    with pytest.raises(KeyError) as caught:
        metric.distance([0.1, 0.2, 0.3], [0.4, 0.15, 0.2])
    assert caught.value is raised
    with pytest.raises(KeyError) as caught:
        metric.distances([0.1, 0.2, 0.3], [[0.4, 0.15, 0.2]] * 4, threads=2)
    assert caught.value is raised
    for result in (None, np.ones(3), "a", np.ones(4), [0.25] * 4, np.full(4, np.nan)):
        metric = tetrahedron.volumetric_metric(barycentric_coordinates=lambda point: result)
        check_error(lambda: metric.distance([0.1, 0.2, 0.3], [0.4, 0.15, 0.2]))
    check_error(lambda: tetrahedron.volumetric_metric(barycentric_coordinates=3))


def test_callback_cancels_volumetric_distances(cube):
    metric = cube.volumetric_metric()
    with pytest.raises(gp.Cancelled):
        metric.distance(INSIDE, OUTSIDE, callback=lambda fraction: False)
    with pytest.raises(gp.Cancelled):
        metric.distances(INSIDE, [OUTSIDE] * 5, callback=lambda fraction: False)
    assert metric.distance(INSIDE, OUTSIDE).cost.is_converged


def test_volumes_reject(cube):
    metric = cube.volumetric_metric()
    for point in (None, 0, [0, 0], [[0, 0, 0]], [0, 0, math.nan], [0, 0, math.inf], "abc", []):
        check_error(lambda: metric.distance(point, INSIDE))
        check_error(lambda: cube.volumetric_distance(INSIDE, point))
        check_error(lambda: metric.distances(point, [INSIDE]))
        check_error(lambda: metric.path(INSIDE, point))
        check_error(lambda: metric.distances(INSIDE, [point]))
    check_error(lambda: metric.distances(INSIDE, []))
    check_error(lambda: metric.path(INSIDE, OUTSIDE))
    check_error(lambda: metric.distance(INSIDE, OUTSIDE, tolerance=0))
    check_error(lambda: metric.distance(INSIDE, OUTSIDE, max_iterations=0))
    check_error(lambda: metric.distances(INSIDE, [OUTSIDE], threads=0))
    check_error(lambda: cube.volumetric_metric(number_of_refinements=31))
    V, F = grid_arrays(3)
    kind = gp.UnsupportedSurfaceError
    check_error(lambda: gp.Surface(V, F).volumetric_metric(), kind)
    cloud = gp.Surface(V, normals=np.tile([0.0, 0, 1], (9, 1)))
    check_error(lambda: cloud.volumetric_metric(), kind)
