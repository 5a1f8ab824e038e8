# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances to features by optimal transport."""

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays


def test_distance_to_vertex(surface):
    found = surface.feature_distance(60)
    exact = np.linalg.norm(surface.vertices - surface.vertices[60], axis=1)
    assert found.is_converged and found.lower <= found.value <= found.upper
    assert (found.distances >= 0).all() and found.distances[60] == 0
    # The distance is never above the geodesic one, and smaller by a fraction of an edge.
    assert (found.distances <= exact + 1e-9).all()
    assert (found.distances >= exact - 0.1).all()
    # The integral of the distance to the center of a square of side 1.
    integral = (np.sqrt(2) + np.arcsinh(1)) / 6
    assert found.upper == pytest.approx(integral, rel=0.1)


def test_distance_to_line_is_height(grid):
    line = np.flatnonzero(grid.vertices[:, 0] == 0)
    found = grid.feature_distance(line)
    # A linear potential is exact; the tolerance of the iteration remains.
    assert np.abs(found.distances - grid.vertices[:, 0]).max() <= 0.01
    assert found.value == pytest.approx(0.5, rel=0.001)


def test_speed_divides_distances(grid):
    one, two = (grid.feature_distance(0, speed=np.full(121, s)) for s in (1.0, 2.0))
    assert np.abs(one.distances - 2 * two.distances).max() <= 0.01  # the tolerance


def test_masses_can_be_fixed(grid):
    free, fixed = (grid.feature_distance([0, 120], fix_masses=f) for f in (False, True))
    # Half of the mass is nearer to each corner, so that both are the same by symmetry.
    assert fixed.value == pytest.approx(free.value, rel=0.01)
    # Four fifths of the mass arrive at one corner.
    asymmetric = [0, 1, 11, 12, 120]
    free, fixed = (grid.feature_distance(asymmetric, fix_masses=f) for f in (False, True))
    assert fixed.value > 1.05 * free.value


def test_refinement_improves_distances(grid):
    errors = []
    exact = np.linalg.norm(grid.vertices - grid.vertices[38], axis=1)
    for refinements in (0, 1, 2):
        found = grid.feature_distance(38, refinements=refinements)
        errors.append(np.abs(found.distances - exact).mean())
    assert errors[0] > errors[1] > errors[2]


def test_unconnected_vertices_are_infinitely_far():
    V, F = grid_arrays(3)
    surface = gp.Surface(np.concatenate([V, V + 5]), np.concatenate([F, F + 9]))
    distances = surface.feature_distance(4).distances
    assert np.isfinite(distances[:9]).all() and np.isinf(distances[9:]).all()


def test_features_reject(surface):
    for function in (
        lambda: surface.feature_distance([]), lambda: surface.feature_distance(None),
        lambda: surface.feature_distance(121), lambda: surface.feature_distance(0, tolerance=-1),
        lambda: surface.feature_distance(0, tolerance=None),
        lambda: surface.feature_distance(0, refinements=-1),
        lambda: surface.feature_distance(0, speed=np.ones(3)),
        lambda: surface.feature_distance(0, callback=1),
    ):
        with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
            function()
    with pytest.raises(gp.Cancelled):
        surface.feature_distance(0, callback=lambda fraction: False)
