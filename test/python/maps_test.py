# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Logarithmic and exponential maps, straightest geodesics and Karcher means."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, sphere_arrays
from error_test import check_error

UP = (0, 1, 0)


def cube():
    """Returns a cube of side 1; its sides have two triangles each."""
    V = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = np.array(
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    )
    return gp.Surface(V, quads)


@pytest.mark.parametrize("method", ["gradient", "exact"])
@pytest.mark.parametrize("base", [60, 37])
def test_tangent_vectors_in_plane_are_differences(grid, arrays, method, base):
    V = arrays[0]
    found = grid.log_map(base, up=UP, method=method)
    # Distances and gradients are exact in the plane up to round-off errors.
    assert np.abs(found.uv - (V - V[base])[:, :2]).max() <= 1e-12
    assert np.abs(found.frame.origin - V[base]).max() <= 1e-14
    assert np.abs(np.array(found.frame[1:]) - [[1, 0, 0], UP]).max() <= 1e-14
    assert np.abs(found.frame.normal - [0, 0, 1]).max() <= 1e-14
    assert sorted(found.reached) == list(range(121))
    assert len(found.cut_faces) == found.number_of_cut_faces == found.number_of_flips == 0


def test_tangent_vectors_of_flat_cloud_are_differences(cloud, arrays):
    V = arrays[0]
    found = cloud.log_map(60, up=UP)
    # The front on a cloud is exact in a plane up to round-off errors.
    assert np.abs(found.uv - (V - V[60])[:, :2]).max() <= 1e-12
    assert found.cut_faces.shape == (0,)


def test_tangent_vectors_of_location_are_differences(grid, arrays):
    point = np.array([0.33, 0.48, 0])
    found = grid.log_map(grid.locate([point])[0], up=UP, method="exact")
    assert np.abs(found.uv - (arrays[0] - point)[:, :2]).max() <= 1e-12


def test_discrete_exponential_has_lengths_of_edge_paths(grid):
    found = grid.log_map(60, method="discrete-exponential")
    # In the plane, the sum of edge vectors is the difference, which is not longer than the path.
    assert (np.hypot(*found.uv.T) <= grid.distance(60, method="dijkstra") + 1e-12).all()


def test_exact_vectors_have_exact_distances():
    sphere = gp.Surface(*sphere_arrays(2))
    uv = sphere.log_map(0, method="exact").uv
    # Both are exact up to round-off errors.
    assert np.abs(np.hypot(*uv.T) - sphere.distance(0)).max() <= 1e-12


def test_map_is_limited_by_radius(surface, arrays):
    found = surface.log_map(60, 0.35)
    distance = np.linalg.norm(arrays[0] - arrays[0][60], axis=1)
    assert sorted(found.reached) == list(np.flatnonzero(distance <= 0.35))
    assert np.array_equal(np.isnan(found.uv[:, 0]), distance > 0.35)


def test_map_of_closed_surface_is_cut():
    sphere = gp.Surface(*sphere_arrays(3))
    found = sphere.log_map(0)
    # The images of the faces near the opposite point are on a circle.
    assert len(found.cut_faces) == found.number_of_cut_faces > 0
    centers = sphere_arrays(3)[0][sphere.faces[found.cut_faces]].mean(axis=1)
    assert (centers[:, 0] < 0).all()


def test_smoothing_and_refinement_keep_lengths(grid):
    expected = grid.log_map(60, up=UP).uv
    smooth = grid.log_map(60, up=UP, number_of_smoothing_steps=3)
    # In the plane, exact vectors do not change inside the map.
    assert np.abs(np.hypot(*smooth.uv.T) - np.hypot(*expected.T)).max() <= 1e-12
    refined = grid.log_map(60, up=UP, number_of_base_refinements=2)
    assert np.abs(refined.uv - expected).max() <= 1e-12
    wide = grid.log_map(60, up=UP, stencil_length=0.2, stencil_size=12)
    assert np.abs(wide.uv - expected).max() <= 1e-12


@pytest.mark.parametrize("up", [None, UP])
def test_exponential_map_is_inverse(grid, arrays, up):
    uv = grid.log_map(37, up=up, method="exact").uv
    ends = grid.exp_map(37, uv, up=up)
    assert np.abs(grid.points(ends) - arrays[0]).max() <= 1e-12


def test_exponential_map_of_cloud_is_inverse(cloud, arrays):
    inner = np.flatnonzero((np.abs(arrays[0][:, :2] - 0.5) < 0.35).all(axis=1))
    uv = cloud.log_map(60, up=UP).uv[inner]
    # The surface that is fitted to the surfels is flat; its geodesics have nine digits.
    assert np.abs(cloud.points(cloud.exp_map(60, uv, up=UP)) - arrays[0][inner]).max() <= 1e-8


def test_exponential_map_ends_at_boundary(grid):
    (end,) = grid.points(grid.exp_map(60, [[3, 0]], up=UP))
    assert np.abs(end - [1, 0.5, 0]).max() <= 1e-14


def test_geodesic_in_plane_is_straight(grid):
    path = grid.trace(60, (0.3, -0.4, 5), length=0.25)
    assert np.abs(path.points[-1] - [0.65, 0.3, 0]).max() <= 1e-14
    assert abs(path.length - 0.25) <= 1e-15 and not path.is_cut_by_boundary
    assert np.abs(grid.points(path.locations) - path.points).max() <= 1e-14
    assert np.abs(np.cross(path.points - path.points[0], [0.6, -0.8, 0])).max() <= 1e-14


def test_length_of_geodesic_is_that_of_vector(surface):
    path = surface.trace(60, (0.1, 0.2, 0))
    # A path on a cloud has the requested length to about nine digits.
    assert abs(path.length - math.hypot(0.1, 0.2)) <= 1e-9
    assert np.abs(path.points[-1] - [0.6, 0.7, 0]).max() <= 1e-9


def test_geodesic_is_cut_by_boundary(surface):
    path = surface.trace(60, (1, 0, 0), length=5)
    assert path.is_cut_by_boundary and path.length < 5
    # A cloud ends at most 1.5 radii, less than twice the spacing, beyond the last surfel.
    assert 1 - 1e-9 <= path.points[-1, 0] <= 1.2


def test_geodesic_around_cube_is_closed():
    surface = cube()
    start = surface.locate([[0.3, 0.6, 1]])[0]
    path = surface.trace(start, (1, 0, 0), length=4)
    assert np.abs(path.points[-1] - path.points[0]).max() <= 1e-14
    assert np.abs(path.points[:, 1] - 0.6).max() <= 1e-14


def test_mean_in_plane_is_weighted_mean(grid, arrays):
    V, points, weights = arrays[0], [0, 47, 99, 110], [1, 2, 0.5, 3]
    mean = grid.karcher_mean(points, weights)
    expected = np.average(V[points], axis=0, weights=weights)
    assert mean.is_converged and mean.number_of_iterations <= 100
    # The gradient, which is the distance from the minimum, is within the tolerance of 1e-8.
    assert np.abs(mean.point - expected).max() <= 1.5e-8
    squares = ((V[points] - expected) ** 2).sum(axis=1)
    assert abs(mean.value - np.dot(weights, squares)) <= 1e-12
    assert isinstance(mean.location, gp.Location)
    assert np.abs(grid.points([mean.location]) - mean.point).max() <= 1e-14


def test_mean_of_flat_cloud_is_mean(cloud, arrays):
    points = [24, 47, 91]
    mean = cloud.karcher_mean(points)
    # The tolerance is 1e-5 of the distance to the farthest point, which is less than 1.
    assert mean.is_converged
    assert np.abs(mean.point - arrays[0][points].mean(axis=0)).max() <= 1e-5
    assert isinstance(mean.location, gp.SurfelLocation)


def test_mean_of_locations(grid):
    points = np.array([[0.13, 0.22, 0], [0.81, 0.37, 0], [0.33, 0.98, 0]])
    mean = grid.karcher_mean(grid.locate(points), tolerance=1e-10, threads=1)
    assert np.abs(mean.point - points.mean(axis=0)).max() <= 1e-10


def test_initial_location_selects_mean():
    surface = cube()
    points = surface.locate([[0.5, 0.5, 0], [0.5, 0.5, 1]])  # four sides have equal means
    for side in ([0, 0.5, 0.5], [0.5, 1, 0.5]):
        start = surface.locate([side])[0]
        mean = surface.karcher_mean(points, initial_location=start)
        assert mean.is_converged and abs(mean.value - 2) <= 1e-12
        assert np.abs(mean.point - side).max() <= 1e-7


def test_mean_at_isolated_vertex_has_no_face():
    V, F = grid_arrays(3)
    surface = gp.Surface(np.concatenate([V, [[5, 5, 5]]]), F)
    mean = surface.karcher_mean(9)
    assert mean.location.face == -1 and np.array_equal(mean.point, [5, 5, 5])


def test_mean_is_canceled(grid):
    with pytest.raises(gp.Cancelled):
        grid.karcher_mean([0, 10, 47], callback=lambda fraction: False)


def test_maps_reject(surface):
    bad = {"log_map": [
        {"base": 121}, {"base": None}, {"base": 0, "radius": -1}, {"base": 0, "radius": "far"},
        {"base": 0, "radius": math.nan}, {"base": 0, "up": (0, 1)}, {"base": 0, "up": (0, 0, 1)},
        {"base": 0, "up": (0, math.nan, 1)}, {"base": 0, "up": "up"}, {"base": 0, "method": "best"},
        {"base": 0, "method": None}, {"base": 0, "stencil_size": 2},
        {"base": 0, "stencil_length": -1}, {"base": 0, "stencil_size": 8.5},
        {"base": 0, "number_of_smoothing_steps": 1001},
        {"base": 0, "number_of_base_refinements": -1},
    ], "exp_map": [
        {"base": -1, "uv": [[0, 0]]}, {"base": 0, "uv": [0, 0]}, {"base": 0, "uv": []},
        {"base": 0, "uv": [[0, math.nan]]}, {"base": 0, "uv": [[0, math.inf]]},
        {"base": 0, "uv": [[0, 1, 2]]}, {"base": 0, "uv": [[0, 1]], "up": (0, 0, 1)},
    ], "trace": [
        {"start": 500, "vector": UP}, {"start": 0, "vector": (0, 1)}, {"start": 0, "vector": None},
        {"start": 0, "vector": (0, 0, 1)}, {"start": 0, "vector": (0, 0, 0)},
        {"start": 0, "vector": (math.inf, 0, 0)}, {"start": 0, "vector": UP, "length": -1},
        {"start": 0, "vector": UP, "length": math.nan}, {"start": 0, "vector": UP, "length": "1"},
    ], "karcher_mean": [
        {"points": []}, {"points": None}, {"points": [0, 121]}, {"points": [0], "weights": [1, 2]},
        {"points": [0, 1], "weights": [1, -1]}, {"points": [0, 1], "weights": [0, 0]},
        {"points": [0, 1], "weights": [1, math.nan]}, {"points": [0, 1], "tolerance": -1},
        {"points": [0, 1], "max_iterations": -1}, {"points": [0, 1], "initial_location": 121},
        {"points": [0, 1], "threads": 0}, {"points": [0, 1], "callback": 3},
        {"points": [0, surface.locate([[0.3, 0.4, 0]])[0]]},
    ]}
    for function, cases in bad.items():
        for named in cases:
            check_error(lambda: getattr(surface, function)(**named))


def test_unsupported_maps(cloud, grid):
    kind = gp.UnsupportedSurfaceError
    check_error(lambda: cloud.log_map(0, method="exact"), kind)
    check_error(lambda: cloud.log_map(0, number_of_base_refinements=1), kind)
    check_error(lambda: grid.log_map(0, method="exact", number_of_smoothing_steps=1), kind)


@pytest.mark.parametrize("scale", [1e-8, 1e8])
def test_maps_scale(arrays, scale):
    surface = gp.Surface(scale * arrays[0], arrays[1])
    uv = surface.log_map(60, up=UP).uv
    assert np.abs(uv / scale - (arrays[0] - arrays[0][60])[:, :2]).max() <= 1e-12
    end = surface.trace(60, (0.1 * scale, 0, 0)).points[-1] / scale
    assert np.abs(end - [0.6, 0.5, 0]).max() <= 1e-14
