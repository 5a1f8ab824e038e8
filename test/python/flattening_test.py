# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps to the plane, their distortion, and mean value coordinates."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, sphere_arrays
from error_test import check_error


def distances_between(points):
    return np.linalg.norm(points[:, None] - points[None], axis=2)


def rolled_arrays(n):
    """Returns a square that is rolled to a half cylinder, without stretching it."""
    V, F = grid_arrays(n)
    # Each column is rotated about the previous one, so that all faces keep their shapes.
    step = 1 / (n - 1)
    angle = np.linspace(0, math.pi, n)
    x = np.concatenate([[0], np.cumsum(step * np.cos(angle[:-1]))])
    z = np.concatenate([[0], np.cumsum(step * np.sin(angle[:-1]))])
    column = np.arange(n * n) // n
    return np.stack([x[column], V[:, 1], z[column]], axis=1), F


def cap_arrays():
    """Returns the part of a sphere above the plane z = -0.1, which has no isometric map."""
    V, F = sphere_arrays(3)
    F = F[(V[F][:, :, 2] > -0.1).all(axis=1)]
    used, F = np.unique(F, return_inverse=True)
    return V[used], F.reshape(-1, 3)


def check_isometric(surface, flat, tolerance):
    uv, n = flat.uv, surface.number_of_points
    assert uv.shape == (n, 2)
    grid = np.stack(np.meshgrid(np.linspace(0, 1, 11), np.linspace(0, 1, 11), indexing="ij"), 2)
    expected = distances_between(grid.reshape(-1, 2))
    assert np.abs(distances_between(uv) - expected).max() <= tolerance


@pytest.mark.parametrize("arrays_of", [grid_arrays, rolled_arrays])
def test_flattening_of_developable_mesh_is_isometric(arrays_of):
    surface = gp.Surface(*arrays_of(11))
    flat = surface.flatten()
    # All vertices are base points, and the distances of neighbors are those in the plane. The last
    # step of Newton's method decreases the energy by less than 1e-6 of it, which is the square of
    # an error of 1e-3 in lengths. The step squares this error.
    check_isometric(surface, flat, 1e-6)
    assert sorted(flat.base_points) == list(range(121))
    assert flat.distortion.number_of_flips == 0
    assert flat.distortion.symmetric_dirichlet == pytest.approx(4, abs=1e-6)
    assert flat.distortion == surface.flattening_distortion(flat.uv)


def test_scaling_of_planar_mesh_is_isometric(surface):
    # Classical scaling of exact distances, with all vertices as base points, has round-off errors.
    check_isometric(surface, surface.mds(), 1e-12)


def test_flattening_of_flat_cloud_is_isometric(cloud):
    flat = cloud.flatten()
    # The embedding of base points starts at classical scaling, which is exact, and stays there.
    check_isometric(cloud, flat, 1e-9)
    assert flat.distortion.number_of_triangles > 0


def test_injective_map_has_no_flips():
    surface = gp.Surface(*cap_arrays())
    flat = surface.flatten()
    assert flat.distortion.number_of_flips == 0
    plain = surface.flatten(injective=False)
    assert np.array_equal(plain.uv, surface.lle().uv)
    # The energy is minimized.
    assert flat.distortion.symmetric_dirichlet < plain.distortion.symmetric_dirichlet


def test_base_points_are_used():
    surface = gp.Surface(*cap_arrays())
    for function in (surface.flatten, surface.lle, surface.mds):
        assert len(function(number_of_base_points=30).base_points) == 30
        chosen = np.arange(0, surface.number_of_points, 7)
        assert np.array_equal(np.sort(function(base_points=chosen).base_points), chosen)
    few = surface.lle(number_of_neighbors=4, flattening_start="lle", number_of_rigid_steps=0)
    assert not np.array_equal(few.uv, surface.lle().uv)


def test_vertex_without_face_has_no_image(arrays):
    surface = gp.Surface(np.concatenate([arrays[0], [[5, 5, 5]]]), arrays[1])
    for function in (surface.flatten, surface.lle, surface.mds):
        uv = function(number_of_base_points=50).uv
        assert np.isnan(uv[121]).all() and np.isfinite(uv[:121]).all()


def test_distortion_of_linear_map(surface, arrays):
    # The singular values of the inverse are sqrt(2) and 1 / sqrt(2) after scaling.
    found = surface.flattening_distortion(arrays[0][:, :2] * [8, 4])
    expected = (math.sqrt(0.5), 0, 5, math.sqrt(1.25), math.sqrt(2))
    assert np.abs(np.subtract(found[:5], expected)).max() <= 1e-7
    assert found.number_of_flips == 0
    mirrored = surface.flattening_distortion(arrays[0][:, 1::-1])
    assert mirrored.number_of_flips == mirrored.number_of_triangles > 0
    assert mirrored.conformal <= 1e-7


def test_distortion_of_corners_equals_that_of_vertices(grid, arrays):
    uv = arrays[0][:, :2] ** 2
    assert grid.flattening_distortion(uv[grid.faces]) == grid.flattening_distortion(uv)


def test_faces_without_image_are_ignored(grid, arrays):
    uv = arrays[0][:, :2].copy()
    uv[60] = np.nan
    found = grid.flattening_distortion(uv)
    assert found.number_of_triangles == len(arrays[1]) - 6 and found.authalic <= 1e-7


def test_mean_value_coordinates_reproduce_points():
    surface = gp.Surface(*sphere_arrays(1))
    points = np.array([[0, 0, 0], [0.3, -0.2, 0.4], [2, 1, 0], [0.1, 0.1, 1.5]])
    weights = surface.mean_value_coordinates(points)
    assert weights.shape == (4, surface.number_of_points)
    # Round-off errors grow with the square of the distance in diameters.
    assert np.abs(weights.sum(axis=1) - 1).max() <= 1e-12
    assert np.abs(weights @ sphere_arrays(1)[0] - points).max() <= 1e-12
    assert weights[:2].min() > 0  # inside a convex mesh


def test_mean_value_coordinates_are_symmetric():
    surface = gp.Surface(*sphere_arrays(0))
    (weights,) = surface.mean_value_coordinates([[0, 0, 0]])
    assert np.abs(weights - 1 / 6).max() <= 1e-14


def test_mean_value_coordinates_on_surface_are_barycentric():
    V, F = sphere_arrays(0)
    barycentric = np.array([0.2, 0.3, 0.5])
    (weights,) = gp.Surface(V, F).mean_value_coordinates([barycentric @ V[F[2]]])
    expected = np.zeros(6)
    expected[F[2]] = barycentric
    # The plane of the face contains the point up to round-off errors.
    assert np.abs(weights - expected).max() <= 1e-7


def test_flattening_is_canceled(surface):
    for function in (surface.flatten, surface.lle, surface.mds):
        with pytest.raises(gp.Cancelled):
            function(callback=lambda fraction: False)


def test_fractions_increase(grid):
    fractions = []
    grid.flatten(callback=fractions.append)
    assert fractions == sorted(fractions) and 0 <= fractions[0] and 0.5 <= fractions[-1] <= 1


def test_coordinates_are_canceled():
    surface = gp.Surface(*sphere_arrays(0))
    with pytest.raises(gp.Cancelled):
        surface.mean_value_coordinates([[0, 0, 0]], callback=lambda fraction: False)


@pytest.mark.parametrize(
    "named",
    [
        {"number_of_base_points": 2}, {"number_of_base_points": 1001},
        {"number_of_base_points": "all"}, {"base_points": [0, 1]}, {"base_points": [0, 1, 121]},
        {"base_points": [0, 1, -1]}, {"base_points": [0, 1, 1, 5]}, {"base_points": []},
        {"base_points": [0.5, 1, 2]}, {"base_points": [0, 5, 60], "number_of_base_points": 3},
        {"seed": -1}, {"callback": 3},
    ],
)
def test_flattenings_reject(surface, named):
    check_error(lambda: surface.flatten(**named))
    check_error(lambda: surface.lle(**named))
    check_error(lambda: surface.mds(**named))


@pytest.mark.parametrize(
    "named",
    [
        {"number_of_neighbors": 2}, {"number_of_neighbors": 3.5}, {"flattening_start": "worst"},
        {"flattening_start": None}, {"number_of_rigid_steps": -1},
    ],
)
def test_embeddings_reject(surface, named):
    check_error(lambda: surface.flatten(**named))
    check_error(lambda: surface.lle(**named))


@pytest.mark.parametrize(
    "uv",
    [
        None, [], "uv", np.zeros((120, 2)), np.zeros((121, 3)), np.zeros(121), [[0, 1], [2]],
        np.zeros((3, 3, 2)), np.zeros((200, 2, 3)), np.zeros((200, 6)), np.zeros((1, 200, 3, 2)),
    ],
)
def test_distortion_rejects(grid, uv):
    check_error(lambda: grid.flattening_distortion(uv))


def test_coordinates_reject(grid):
    surface = gp.Surface(*sphere_arrays(0))
    for points in ([], [0, 0, 0], [[0, 0]], [[0, 0, math.nan]], [[math.inf, 0, 0]], None):
        check_error(lambda: surface.mean_value_coordinates(points))
    check_error(lambda: grid.mean_value_coordinates([[0, 0, 0]]), gp.UnsupportedSurfaceError)


def test_unsupported_flattenings(cloud, grid, arrays):
    kind = gp.UnsupportedSurfaceError
    check_error(lambda: cloud.flatten(injective=True), kind)
    check_error(lambda: cloud.mean_value_coordinates([[0, 0, 0]]), kind)
    check_error(lambda: cloud.flattening_distortion(np.zeros((3, 3, 2))), kind)
    check_error(lambda: gp.Surface(*sphere_arrays(1)).flatten(), kind)
    V, F = arrays
    two = gp.Surface(np.concatenate([V, V + [5, 0, 0]]), np.concatenate([F, F + 121]))
    check_error(lambda: two.flatten(), kind)


@pytest.mark.parametrize("name", ["lle", "mds"])
def test_method_of_flattening_is_used(grid, arrays, name):
    flatten = getattr(grid, name)
    default = flatten().uv
    assert np.array_equal(flatten(method="euclidean").uv, default)
    # On a planar mesh, only distances of the default front are exact. Those of fast marching are
    # wrong by some percent, and paths along edges are up to 41 % longer.
    expected = distances_between(arrays[0])
    errors = [
        np.abs(distances_between(flatten(method=method).uv) - expected).max()
        for method in ("euclidean", "fast-marching", "dijkstra")
    ]
    assert errors[0] < 0.1 * min(errors[1:])
    check_error(lambda: flatten(method="exact"))


def test_method_of_injective_flattening_is_used(grid):
    assert not np.array_equal(grid.flatten(method="dijkstra").uv, grid.flatten().uv)
