# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls, extents, and derivatives of distances."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, points_of, prism_arrays, rough_arrays
from error_test import check_error

ROUND_OFF = 1e-14  # as in distance_test.py


def test_ball_in_plane_is_disk(grid, arrays):
    V, F = arrays
    ball = grid.ball(60, 0.37)
    assert abs(ball.area - math.pi * 0.37**2) <= 1e-13  # a sum of some hundred areas
    is_inside = np.linalg.norm(V - V[60], axis=1) <= 0.37
    assert np.array_equal(np.sort(ball.faces), np.flatnonzero(is_inside[F].all(axis=1)))
    (circle,) = ball.circles
    assert circle.is_closed and circle.value == 0.37
    assert np.abs(np.linalg.norm(circle.points - V[60], axis=1) - 0.37).max() <= 1e-13


def test_ball_of_two_centers(grid):
    centers = grid.locate([[0.2, 0.2, 0], [0.81, 0.79, 0]])
    ball = grid.ball(centers, 0.15)
    assert abs(ball.area - 2 * math.pi * 0.15**2) <= 1e-13 and len(ball.circles) == 2
    whole = grid.ball(0, 2)
    assert abs(whole.area - 1) <= 1e-13 and len(whole.faces) == 200 and whole.circles == []


def test_eccentricity_of_corner_is_diagonal(surface):
    # The front of a cloud has round-off errors relative to its spacing.
    result = surface.eccentricity(0)
    assert result.farthest == 120 and abs(result.value - math.sqrt(2)) <= 1e-12
    assert type(result.value) is float and type(result.farthest) is int


def test_eccentricity_by_methods_and_speeds(grid):
    result = grid.eccentricity([0, 120], method="dijkstra")
    distance = grid.distance([0, 120], method="dijkstra")
    assert result.value == distance.max() == distance[result.farthest]
    result = grid.eccentricity(0, speed=np.full(121, 2.0), offsets=[1.0])
    assert abs(result.value - 1 - math.sqrt(0.5)) <= ROUND_OFF
    result = grid.eccentricity(0, face_speed=np.full(200, 2.0))
    assert abs(result.value - math.sqrt(0.5)) <= ROUND_OFF


def test_eccentricity_ignores_other_components(arrays):
    V, F = arrays
    surface = gp.Surface(np.concatenate([V, V + [0, 0, 1]]), np.concatenate([F, F + len(V)]))
    assert surface.eccentricity(0).farthest == 120


def test_diameter_and_radius_of_square(grid):
    diameter = grid.diameter(relative_tolerance=0)
    assert abs(diameter.lower - math.sqrt(2)) <= ROUND_OFF
    assert diameter.is_converged and diameter.upper <= diameter.lower * (1 + 1e-12)
    assert {diameter.start, diameter.end} in ({0, 120}, {10, 110})
    radius = grid.radius(relative_tolerance=0)
    assert radius.center == 60 and radius.is_converged
    assert abs(radius.upper - math.sqrt(0.5)) <= ROUND_OFF
    assert radius.farthest in (0, 10, 110, 120)
    assert grid.eccentricity(radius.center).value == radius.upper


def test_bounds_are_valid_after_few_iterations():
    surface = gp.Surface(*rough_arrays(8))
    matrix = surface.distance_matrix(np.arange(64))
    eccentricities = matrix.max(axis=1)
    for result, exact in (
        (surface.diameter(max_iterations=1), eccentricities.max()),
        (surface.radius(max_iterations=1), eccentricities.min()),
        (surface.diameter(), eccentricities.max()),
        (surface.radius(), eccentricities.min()),
    ):
        # Exact distances have round-off errors of some hundred windows.
        assert result.lower * (1 - 1e-12) <= exact <= result.upper * (1 + 1e-12)
        assert result.is_converged == (result.upper <= result.lower * 1.01)


def test_derivatives_in_plane(grid, arrays):
    V = arrays[0]
    points = np.array([[0.13, 0.22, 0], [0.81, 0.37, 0]])
    source, target = grid.locate(points)
    result = grid.distance_derivatives(source, target)
    direction = points[1] - points[0]
    length = np.linalg.norm(direction)
    assert abs(result.distance - length) <= ROUND_OFF
    assert result.is_differentiable and result.differentiability == "differentiable"
    assert np.abs(result.source_gradient + direction / length).max() <= ROUND_OFF
    assert np.abs(result.target_gradient - direction / length).max() <= ROUND_OFF
    # The distance is invariant to translations and proportional to the scale.
    assert np.abs(result.vertex_gradients.sum(axis=0)).max() <= 1e-13
    scaled = (result.vertex_gradients * V[result.vertices]).sum()
    assert abs(scaled - result.distance) <= 1e-13


def test_derivatives_are_finite_differences():
    V, F = rough_arrays(6)
    source, target = (3, (0.3, 0.3, 0.4)), (40, (0.2, 0.5, 0.3))
    result = gp.Surface(V, F).distance_derivatives(source, target)
    assert result.is_differentiable
    rng = np.random.default_rng(3)
    motion = rng.uniform(-1, 1, V.shape)
    # The error of central differences is the square of the step; the path must cross the same
    # edges. Round-off errors of distances are divided by the step.
    step = 1e-6
    moved = [gp.Surface(V + s * motion, F).distance_derivatives(source, target).distance
             for s in (step, -step)]
    slope = (result.vertex_gradients * motion[result.vertices]).sum()
    assert abs((moved[0] - moved[1]) / (2 * step) - slope) <= 1e-7


def test_differentiability_states_reason(grid):
    assert grid.distance_derivatives(3, 3).differentiability == "coincident"
    assert grid.distance_derivatives(0, 120).differentiability == "near-vertex"
    V, F = grid_arrays(3)
    apart = gp.Surface(np.concatenate([V, V + [0, 0, 1]]), np.concatenate([F, F + 9]))
    result = apart.distance_derivatives(0, 9)
    assert result.differentiability == "unreachable" and result.distance == math.inf
    assert len(result.vertices) == len(result.vertex_gradients) == 0
    # Two paths around a prism between the midpoints of opposite sides have the same length.
    V, F = prism_arrays(4, 2)
    prism = gp.Surface(V, F)
    ends = prism.locate([(V[0] + V[1]) / 2 + [0, 0, 0.37], (V[2] + V[3]) / 2 + [0, 0, 0.37]])
    result = prism.distance_derivatives(*ends)
    assert result.differentiability == "second-path" and not result.is_differentiable
    assert abs(result.distance - 2 * math.sqrt(2)) <= 1e-13
    points = points_of(V, prism.faces, ends.indices, ends.coordinates)
    assert np.abs(points[:, 2] - 0.37).max() <= ROUND_OFF


@pytest.mark.parametrize("function", ["diameter", "radius", "ball", "eccentricity"])
def test_callback_cancels(function):
    surface = gp.Surface(*rough_arrays(40))
    arguments = {"ball": (0, 0.5), "eccentricity": (0,)}.get(function, ())
    with pytest.raises(gp.Cancelled):
        getattr(surface, function)(*arguments, callback=lambda fraction: False)


def test_measures_reject():
    V, F = grid_arrays(3)
    surface = gp.Surface(V, F)
    for radius in (-1, math.inf, math.nan, None, "1"):
        check_error(lambda: surface.ball(0, radius))
    check_error(lambda: surface.ball([], 1))
    check_error(lambda: surface.ball(9, 1))
    for function in (surface.diameter, surface.radius):
        for tolerance in (-1, math.nan, None, "0"):
            check_error(lambda: function(relative_tolerance=tolerance))
        for number in (0, -1, 1.5, None):
            check_error(lambda: function(max_iterations=number))
        check_error(lambda: function(callback=3))
    check_error(lambda: surface.eccentricity([]))
    check_error(lambda: surface.eccentricity(0, method="best"))
    check_error(lambda: surface.eccentricity(0, speed=np.ones(8)))
    check_error(lambda: surface.distance_derivatives(0, 9))
    check_error(lambda: surface.distance_derivatives([0], 1))
    check_error(lambda: surface.distance_derivatives(0, 8, vertex_tolerance=-1))
    check_error(lambda: surface.distance_derivatives(0, 8, second_path_tolerance=math.nan))
    cloud = gp.Surface(V, normals=np.tile([0.0, 0.0, 1.0], (9, 1)))
    kind = gp.UnsupportedSurfaceError
    check_error(lambda: cloud.ball(0, 1), kind)
    check_error(lambda: cloud.diameter(), kind)
    check_error(lambda: cloud.radius(), kind)
    check_error(lambda: cloud.distance_derivatives(0, 1), kind)
    check_error(lambda: cloud.eccentricity(0, method="exact"), kind)
