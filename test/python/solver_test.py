# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
import math

import geodesic_processing as gp
import numpy as np
import pytest

ROUND_OFF = 1e-14  # as in distance_test.py


@pytest.mark.parametrize("method", ["exact", "euclidean", "fast-marching", "dijkstra", "heat"])
def test_solver_equals_distance(grid, method):
    solver = grid.solver(method)
    for source in (0, 60, 0):
        expected = grid.distance(source, method=method)
        assert np.array_equal(solver.compute(source).distance(), expected)


def test_solver_without_computation_reaches_nothing(surface):
    solver = surface.solver()
    assert np.isinf(solver.distance()).all()
    assert len(solver.reached) == 0 and (solver.labels == -1).all()


def test_distance_of_locations(grid, arrays):
    solver = grid.solver().compute(0)
    assert solver.distance(12) == solver.distance()[12]
    assert isinstance(solver.distance(12), float)
    points = np.array([[0.33, 0.71, 0.5], [0.9, 0.05, -0.1]])
    locations = grid.locate(points)
    expected = np.linalg.norm(points[:, :2], axis=1)
    assert np.abs(solver.distance(locations) - expected).max() <= ROUND_OFF
    assert abs(solver.distance(locations[1]) - expected[1]) <= ROUND_OFF
    mixed = solver.distance([12, locations[0]])
    assert mixed.shape == (2,) and mixed[0] == solver.distance(12)


def test_labels_and_reached(surface):
    solver = surface.solver().compute([0, 120], max_distance=0.45)
    labels, distance = solver.labels, solver.distance()
    assert labels.dtype == np.int64
    assert np.array_equal(labels == -1, np.isinf(distance))
    assert np.array_equal(np.sort(solver.reached), np.flatnonzero(labels >= 0))
    assert labels[0] == 0 and labels[120] == 1 and labels[1] == 0 and labels[119] == 1


def test_path_has_length_of_distance(grid, arrays):
    solver = grid.solver().compute(0)
    path = solver.path(120)
    assert np.array_equal(path.points[[0, -1]], arrays[0][[120, 0]])
    assert abs(path.length - math.sqrt(2)) <= ROUND_OFF
    # The lower bound is the length minus 2e-12 of it.
    assert path.length * (1 - 3e-12) <= path.lower <= path.length
    steps = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
    assert abs(steps.sum() - path.length) <= ROUND_OFF


def test_relative_tolerance_bounds_error(grid, arrays):
    expected = np.linalg.norm(arrays[0], axis=1)
    distance = grid.solver().compute(0, relative_tolerance=0.01).distance()
    # distance is the mean of bounds that differ by at most 1 % of the lower one.
    assert (np.abs(distance - expected) <= 0.01 * expected + ROUND_OFF).all()


def test_invalid_call_keeps_last_result(grid):
    solver = grid.solver().compute(0)
    before = solver.distance()
    with pytest.raises(gp.InvalidArgumentError):
        solver.compute(0, max_distance=-1)
    with pytest.raises(gp.InvalidArgumentError):
        solver.compute([])
    assert np.array_equal(solver.distance(), before)


def test_solver_keeps_surface_alive(arrays):
    solver = gp.Surface(*arrays).solver()
    assert np.isfinite(solver.compute(0).distance()).all()
