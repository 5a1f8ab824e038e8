# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Split meshes, polylines, loops, and curves."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, points_of, prism_arrays
from error_test import check_error

ROUND_OFF = 1e-14  # as in distance_test.py
# Points of curves and of shortened polylines have round-off errors of some hundred operations.
CURVE_ERROR = 1e-12

CONTROL_POINTS = np.array([[0.12, 0.2, 0], [0.31, 0.93, 0], [0.88, 0.77, 0], [0.71, 0.13, 0]])


def face_areas(V, F):
    a, b, c = V[F].transpose(1, 0, 2)
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def split_points(surface, split, V):
    return points_of(V, surface.faces, split.locations.indices, split.locations.coordinates)


def test_split_mesh_is_subdivision(grid, arrays):
    V, F = arrays
    levels = [0.77, 0.25]
    split = grid.split_at_isolines(V[:, 0], levels)
    points = split.surface.vertices
    faces = split.surface.faces
    assert np.abs(points[: len(V)] - V).max() <= ROUND_OFF
    assert np.abs(split_points(grid, split, V) - points).max() <= ROUND_OFF
    assert abs(face_areas(points, faces).sum() - 1) <= CURVE_ERROR
    x = points[faces][:, :, 0]
    between = np.concatenate([[-math.inf], sorted(levels), [math.inf]])
    assert (x >= between[split.labels][:, None] - ROUND_OFF).all()
    assert (x <= between[split.labels + 1][:, None] + ROUND_OFF).all()
    ends = points[split.edges][:, :, 0]
    # Each of the ten squares of a column has two edges on an isoline.
    assert len(split.edges) == 2 * 2 * 10
    assert np.abs(ends[:, :, None] - levels).min(axis=2).max() <= ROUND_OFF


def test_split_mesh_fits_circles(grid):
    split = grid.split_at_isolines(grid.distance(60), [0.33], fit_circles=True)
    points = split.surface.points(np.unique(split.edges))
    assert np.abs(np.linalg.norm(points - [0.5, 0.5, 0], axis=1) - 0.33).max() <= 1e-13
    assert set(split.labels) == {0, 1}


def test_faces_with_infinite_values_are_not_split(grid, arrays):
    values = arrays[0][:, 0].copy()
    values[values > 0.55] = math.inf
    split = grid.split_at_isolines(values, [0.25])
    points = split.surface.vertices
    is_infinite = points[split.surface.faces][:, :, 0].max(axis=1) > 0.55
    assert np.array_equal(split.labels == -1, is_infinite)


def test_split_mesh_keeps_isolated_points(arrays):
    V = np.concatenate([arrays[0], [[5.0, 5, 5]]])
    surface = gp.Surface(V, arrays[1])
    split = surface.split_at_isolines(V[:, 0], [0.25])
    assert split.locations.indices[121] == -1
    assert np.array_equal(split.surface.points([121]), [[5, 5, 5]])


def test_polyline_passes_points(grid, arrays):
    V = arrays[0]
    points = [0, 38, 38, 104]
    result = grid.polyline(points)
    assert np.array_equal(result.path.points[result.corners], V[points])
    length = np.linalg.norm(np.diff(V[points], axis=0), axis=1).sum()
    assert abs(result.path.length - length) <= ROUND_OFF
    assert length * (1 - 3e-12) <= result.path.lower <= result.path.length
    closed = grid.polyline(np.array(points), close=True)
    assert len(closed.corners) == 5 and closed.corners[-1] == len(closed.path.points) - 1
    assert abs(closed.path.length - length - np.linalg.norm(V[104] - V[0])) <= ROUND_OFF


def test_polyline_through_vertices_and_locations(grid, arrays):
    inside = grid.locate([[0.52, 0.11, 0]])[0]
    result = grid.polyline([3, inside, 97])
    points = np.stack([arrays[0][3], [0.52, 0.11, 0], arrays[0][97]])
    assert np.abs(result.path.points[result.corners] - points).max() <= ROUND_OFF


def test_polyline_on_cloud(cloud, arrays):
    V = arrays[0]
    result = cloud.polyline([0, 38, 104])
    assert isinstance(result.path, gp.SurfelPath)
    length = np.linalg.norm(np.diff(V[[0, 38, 104]], axis=0), axis=1).sum()
    # The minimization ends if the length changes by less than a thousandth.
    assert length * (1 - 1e-9) <= result.path.length <= length * (1 + 1e-3)
    assert len(result.corners) == 3


def test_polyline_between_components_is_empty(arrays):
    V, F = arrays
    surface = gp.Surface(np.concatenate([V, V + [0, 0, 1]]), np.concatenate([F, F + len(V)]))
    for path in (surface.polyline([0, 130]).path, surface.shorten_polyline([0, 130])):
        assert len(path.points) == 0 and path.length == path.lower == path.distance == math.inf
    loop = surface.shorten_loop([0, 130])
    assert len(loop.points) == 0 and loop.length == math.inf and not loop.is_point


def test_shortened_polyline_is_straight(surface, arrays):
    V = arrays[0]
    path = surface.shorten_polyline([3, 60, 9, 97])
    expected = np.linalg.norm(V[97] - V[3])
    assert np.abs(path.points[[0, -1]] - V[[3, 97]]).max() <= CURVE_ERROR
    # As in path_test.py for clouds.
    tolerance = 1e-3 if surface.is_cloud else CURVE_ERROR
    assert expected * (1 - 1e-9) <= path.length <= expected * (1 + tolerance)


def test_shortened_polyline_keeps_its_side():
    k = 12
    surface = gp.Surface(*prism_arrays(k, 2))
    side = 2 * math.sin(math.pi / k)
    # From vertex 0 to vertex 2, the long way around the prism.
    path = surface.shorten_polyline([0, 9, 6, 4, 2])
    assert abs(path.length - (k - 2) * side) <= CURVE_ERROR
    assert abs(surface.path(0, 2).length - 2 * side) <= CURVE_ERROR


def test_loops_around_prism():
    k = 9
    V, F = prism_arrays(k, 4)
    surface = gp.Surface(V, F)
    length = 2 * k * math.sin(math.pi / k)
    zigzag = [k, 2 * k + 2, k + 5, 7]
    (basis,) = surface.loop_basis()
    for loop in (
        surface.shorten_loop(zigzag), basis, surface.shortest_noncontractible_loop(k + 3),
        surface.shortest_noncontractible_loop((0, (0.2, 0.3, 0.5))),
    ):
        assert abs(loop.length - length) <= CURVE_ERROR and not loop.is_point
        assert np.abs(loop.points[0] - loop.points[-1]).max() <= ROUND_OFF
        points = points_of(V, surface.faces, loop.faces, loop.barycentric)
        assert np.abs(points - loop.points).max() <= ROUND_OFF
        steps = np.linalg.norm(np.diff(loop.points, axis=0), axis=1)
        assert abs(steps.sum() - loop.length) <= CURVE_ERROR
    (along_edges,) = surface.loop_basis(shorten=False)
    assert along_edges.length >= length - CURVE_ERROR
    assert np.isin(along_edges.barycentric, (0, 1)).all()


def test_contractible_loop_is_point(grid):
    loop = grid.shorten_loop([0, 10, 60])
    assert loop.is_point and loop.length == 0 and loop.points.shape == (1, 3)
    assert grid.loop_basis() == []
    loop = grid.shortest_noncontractible_loop(60)
    assert len(loop.points) == 0 and loop.length == math.inf


def test_basis_of_torus_has_two_loops():
    k = 12
    u, v = np.meshgrid(*[2 * np.pi * np.arange(k) / k] * 2, indexing="ij")
    radius = 2 + np.cos(v)
    V = np.stack([radius * np.cos(u), radius * np.sin(u), np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = np.indices((k, k))
    a, b = i * k + j, (i + 1) % k * k + j
    c, d = (i + 1) % k * k + (j + 1) % k, i * k + (j + 1) % k
    F = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    surface = gp.Surface(V, F)
    assert surface.report.genus == 1 and len(surface.loop_basis()) == 2
    # Around the tube, a regular polygon of radius 1. Around the axis, the inner polygon of radius 1
    # has the same length.
    loop = surface.shortest_noncontractible_loop(0)
    assert loop.length <= 2 * k * math.sin(math.pi / k) + CURVE_ERROR


def contains(path, points):
    """Returns whether the path has a vertex at each point."""
    distances = np.linalg.norm(path.points[:, None] - points, axis=2)
    return distances.min(axis=0).max() <= CURVE_ERROR


def test_bezier_curve_in_plane_has_its_points(grid):
    control_points = grid.locate(CONTROL_POINTS)
    path = grid.bezier_curve(control_points, number_of_subdivisions=3)
    assert isinstance(path, gp.Path) and path.distance == path.length
    t = np.linspace(0, 1, 9)[:, None]
    weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3]
    assert contains(path, sum(w * p for w, p in zip(weights, CONTROL_POINTS)))
    finer = grid.bezier_curve(control_points)
    assert path.length < finer.length < path.length * 1.01


def subdivided(points, degree, is_closed, number_of_subdivisions):
    """Returns the control points of a uniform B-spline (Lane and Riesenfeld)."""
    if not is_closed:
        ends = [np.repeat(points[i : i + 1], degree - 1, axis=0) for i in (0, len(points) - 1)]
        points = np.concatenate([ends[0], points, ends[1]])
    for _ in range(number_of_subdivisions):
        points = np.repeat(points, 2, axis=0)
        for _ in range(degree):
            if is_closed:
                points = (points + np.roll(points, -1, axis=0)) / 2
            else:
                points = (points[:-1] + points[1:]) / 2
    return points


@pytest.mark.parametrize("degree", [1, 2, 3])
@pytest.mark.parametrize("is_closed", [False, True])
def test_spline_in_plane_has_its_points(grid, degree, is_closed):
    path = grid.spline(
        grid.locate(CONTROL_POINTS), degree=degree, is_closed=is_closed, number_of_subdivisions=2
    )
    assert contains(path, subdivided(CONTROL_POINTS, degree, is_closed, 2))
    assert np.array_equal(path.points[0], path.points[-1]) == is_closed


def test_curves_of_vertices_and_locations_are_equal(grid, arrays):
    vertices = [1, 60, 97]
    # Both are the same points up to round-off errors.
    locations = grid.locate(arrays[0][vertices])
    for function in (grid.bezier_curve, grid.spline):
        a, b = function(vertices), function([1, locations[1], 97])
        assert abs(a.length - b.length) <= CURVE_ERROR


def test_callback_cancels_curves(grid):
    for function in (grid.bezier_curve, grid.spline):
        fractions = []
        function([0, 60, 97], callback=fractions.append)
        assert fractions == sorted(fractions) and 0 <= fractions[0] and fractions[-1] <= 1
        with pytest.raises(gp.Cancelled):
            function([0, 60, 97], callback=lambda fraction: False)


def test_curves_reject():
    V, F = grid_arrays(3)
    surface = gp.Surface(V, F)
    check_error(lambda: surface.split_at_isolines(np.arange(8), [4]))
    check_error(lambda: surface.split_at_isolines(np.arange(9), []))
    check_error(lambda: surface.split_at_isolines(np.arange(9), [math.nan]))
    for function in (
        surface.polyline, surface.shorten_polyline, surface.bezier_curve, surface.spline
    ):
        for points in ([], [0], [0, 9], [0, -1], None, "01", [0, 1.5], [0, (0, (1, 1, 1))]):
            check_error(lambda: function(points))
    for points in ([], [9], None, np.zeros(2)):
        check_error(lambda: surface.shorten_loop(points))
        check_error(lambda: surface.shortest_noncontractible_loop(points))
    for number in (-1, 21, 1.5, None):
        check_error(lambda: surface.bezier_curve([0, 8], number_of_subdivisions=number))
        check_error(lambda: surface.spline([0, 8], number_of_subdivisions=number))
    for degree in (0, -1, 1001, 2.5, None):
        check_error(lambda: surface.spline([0, 8], degree=degree))
    isolated = gp.Surface(np.concatenate([V, V[:1] + 5]), F)
    check_error(lambda: isolated.polyline([9, (0, (1, 0, 0))]))
    check_error(lambda: surface.bezier_curve([0, 8], callback=3))


def test_meshes_only():
    V, _ = grid_arrays(3)
    cloud = gp.Surface(V, normals=np.tile([0.0, 0.0, 1.0], (9, 1)))
    for call in (
        lambda: cloud.split_at_isolines(np.arange(9), [4]),
        lambda: cloud.shorten_loop([0, 2, 8]),
        lambda: cloud.loop_basis(),
        lambda: cloud.shortest_noncontractible_loop(0),
        lambda: cloud.bezier_curve([0, 8]),
        lambda: cloud.spline([0, 8]),
    ):
        check_error(call, gp.UnsupportedSurfaceError)
