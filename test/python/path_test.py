# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import rough_arrays

ROUND_OFF = 1e-14  # as in distance_test.py


def test_path_on_planar_mesh_is_straight(grid, arrays):
    V = arrays[0]
    path = grid.path(3, 97)
    assert np.array_equal(path.points[[0, -1]], V[[3, 97]])
    assert abs(path.length - np.linalg.norm(V[3] - V[97])) <= ROUND_OFF
    direction = (V[97] - V[3]) / np.linalg.norm(V[97] - V[3])
    normal = np.cross(path.points - V[3], direction)
    assert np.abs(normal).max() <= ROUND_OFF
    assert path.distance == path.length
    assert path.length * (1 - 3e-12) <= path.lower <= path.length


def test_barycentric_coordinates_belong_to_points(grid, arrays):
    path = grid.path(3, 97)
    corners = arrays[0][grid.faces[path.faces]]
    points = np.einsum("ij,ijk->ik", path.barycentric, corners)
    assert np.abs(points - path.points).max() <= ROUND_OFF
    assert np.abs(path.barycentric.sum(axis=1) - 1).max() <= ROUND_OFF


def test_path_between_locations(grid):
    ends = grid.locate([[0.13, 0.22, 0], [0.81, 0.37, 0]])
    path = grid.path(ends[0], ends[1])
    assert abs(path.length - math.hypot(0.68, 0.15)) <= ROUND_OFF
    assert abs(grid.path(0, ends[1]).length - math.hypot(0.81, 0.37)) <= ROUND_OFF


def test_path_has_exact_distance_on_rough_surface():
    surface = gp.Surface(*rough_arrays(15))
    distance = surface.distance(0)
    pairs = np.stack([np.zeros(10, int), np.arange(20, 220, 20)], axis=1)
    for (_, to), path in zip(pairs, surface.paths(pairs)):
        # Both are exact up to round-off errors of some thousand windows.
        assert abs(path.length - distance[to]) <= 1e-12


def test_paths_equal_single_paths(surface):
    paths = surface.paths([(0, 50), (50, 0), (7, 8)])
    for pair, path in zip([(0, 50), (50, 0), (7, 8)], paths):
        assert np.array_equal(path.points, surface.path(*pair).points)


def test_path_on_cloud_is_nearly_straight(cloud, arrays):
    V = arrays[0]
    path = cloud.path(3, 97)
    expected = np.linalg.norm(V[3] - V[97])
    assert isinstance(path, gp.SurfelPath)
    assert path.surfels.shape == (len(path.points),) and path.offsets.shape == (len(path.points), 2)
    # The minimization ends if the length changes by less than a thousandth.
    assert expected * (1 - 1e-9) <= path.length <= expected * (1 + 1e-3)
    assert abs(path.lower - expected) <= 1e-9


def test_located_points_are_nearest(surface):
    points = np.array([[0.31, 0.52, 0.2], [2.0, 0.5, 0.0]])
    locations = surface.locate(points)
    assert len(locations) == 2
    found = surface.points(locations)
    assert np.abs(found[0] - [0.31, 0.52, 0]).max() <= 1e-12
    if not surface.is_cloud:
        assert np.abs(found[1] - [1, 0.5, 0]).max() <= 1e-12
        assert isinstance(locations[0], gp.Location)
    assert np.array_equal(surface.points(list(locations)), found)
    assert np.array_equal(surface.points(locations[1:]), found[1:])


def test_points_of_vertices_are_input(surface, arrays):
    # Points of a cloud are stored relative to its frame.
    assert np.abs(surface.points([0, 5, 120]) - arrays[0][[0, 5, 120]]).max() <= ROUND_OFF


@pytest.mark.parametrize("scale", [1e-8, 1e8])
def test_path_scales(arrays, scale):
    path = gp.Surface(arrays[0] * scale, arrays[1]).path(0, 120)
    assert abs(path.length / scale - math.sqrt(2)) <= ROUND_OFF
