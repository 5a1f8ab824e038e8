# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fuzzy geodesics."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from error_test import check_error


def test_likelihood_is_length_of_detour(surface):
    a, b = 24, 84
    from_a, from_b = surface.distance(a), surface.distance(b)
    likelihood = surface.fuzzy_geodesic_by_distances(a, b, 0.1)
    expected = np.exp(-np.abs(from_a + from_b - from_a[b]) / 0.1)
    # Distances have round-off errors of 1e-14, which are divided by the width.
    assert np.abs(likelihood - expected).max() <= 1e-12


def test_default_width_is_twentieth_of_distance(surface):
    width = surface.distance(24)[84] / 20
    found = surface.fuzzy_geodesic_by_distances(24, 84)
    assert np.abs(found - surface.fuzzy_geodesic_by_distances(24, 84, width)).max() <= 1e-11


def test_locations_are_accepted(grid):
    ends = grid.locate([[0.2, 0.2, 0], [0.8, 0.8, 0]])
    found = grid.fuzzy_geodesic_by_distances(ends[0], ends[1], 0.1)
    expected = grid.fuzzy_geodesic_by_distances(24, 96, 0.1)
    assert np.abs(found - expected).max() <= 1e-12


def test_flow_is_a_likelihood(surface, arrays):
    result = surface.fuzzy_geodesic(24, 84, 0.12)
    assert result.likelihood.max() == 1 and result.likelihood.min() >= 0
    assert result.is_converged and result.lower <= result.value <= result.upper
    assert result.upper - result.lower <= 1e-3 * result.upper
    # The flow between two discs is in their convex hull, up to the smoothing.
    middle = np.abs(arrays[0][:, 0] - 0.5) < 0.01
    assert arrays[0][middle][result.likelihood[middle].argmax(), 1] == pytest.approx(0.5, abs=0.21)
    # Masses that move along a segment have the distance of their means as a lower bound.
    assert result.upper >= 0.9 * surface.distance(24)[84]


def test_flow_is_symmetric(grid):
    there, back = grid.fuzzy_geodesic(24, 84, 0.12), grid.fuzzy_geodesic(84, 24, 0.12)
    # Both have the same optimum, up to the tolerance of 1e-3.
    assert max(there.lower, back.lower) <= min(there.upper, back.upper)


def test_refinements_and_tolerance_are_used(grid):
    rough = grid.fuzzy_geodesic(24, 84, 0.12, number_of_refinements=0, tolerance=0.1)
    fine = grid.fuzzy_geodesic(24, 84, 0.12, number_of_refinements=1)
    assert rough.number_of_iterations < fine.number_of_iterations
    # Flows that are constant in smaller faces are more general.
    assert fine.upper <= rough.upper * (1 + 1e-3)


def test_speed_changes_flow(surface, arrays):
    speed = np.full(121, 2.0)
    slow = surface.fuzzy_geodesic(24, 84, 0.12)
    fast = surface.fuzzy_geodesic(24, 84, 0.12, speed=speed)
    # The cost is a travel time; both values are within 1e-3 of the optimum.
    assert abs(fast.value / slow.value - 0.5) <= 1e-3
    times = surface.fuzzy_geodesic_by_distances(24, 84, 0.1, speed=speed)
    expected = surface.fuzzy_geodesic_by_distances(24, 84, 0.2)
    # With speeds, the default method is a front, whose distances on a plane have round-off errors.
    assert np.abs(times - expected).max() <= 1e-10


def test_computation_is_canceled(surface):
    with pytest.raises(gp.Cancelled):
        surface.fuzzy_geodesic(24, 84, 0.12, callback=lambda fraction: False)
    with pytest.raises(gp.Cancelled):
        surface.fuzzy_geodesic_by_distances(24, 84, callback=lambda fraction: False)


def test_fuzzy_geodesics_reject(surface):
    for function in (surface.fuzzy_geodesic, surface.fuzzy_geodesic_by_distances):
        check_error(lambda: function(24, 24))
        check_error(lambda: function(24, 121))
        check_error(lambda: function(None, 84))
        check_error(lambda: function(24, 84, -1))
        check_error(lambda: function(24, 84, math.nan))
        check_error(lambda: function(24, 84, "wide"))
        check_error(lambda: function(24, 84, speed=np.ones(3)))
        check_error(lambda: function(24, 84, callback=3))
    check_error(lambda: surface.fuzzy_geodesic(24, 84, tolerance=-1))
    check_error(lambda: surface.fuzzy_geodesic(24, 84, number_of_refinements=31))
    check_error(lambda: surface.fuzzy_geodesic(24, 84, number_of_refinements=0.5))


def test_vertex_without_face_is_rejected(arrays):
    surface = gp.Surface(np.concatenate([arrays[0], [[5, 5, 5]]]), arrays[1])
    check_error(lambda: surface.fuzzy_geodesic(0, 121))


@pytest.mark.parametrize("method", ["admm", "weiszfeld"])
def test_methods_of_transport_have_the_same_optimum(grid, method):
    exact = grid.fuzzy_geodesic(24, 84, 0.12)
    found = grid.fuzzy_geodesic(24, 84, 0.12, method=method, tolerance=0.05)
    # Both intervals contain the optimum.
    assert max(found.lower, exact.lower) <= min(found.upper, exact.upper)
    assert found.value != exact.value


def test_method_of_distances_is_used(surface):
    a, b, method = 24, 84, "dijkstra"
    from_a, from_b = surface.distance(a, method=method), surface.distance(b, method=method)
    likelihood = surface.fuzzy_geodesic_by_distances(a, b, 0.1, method=method)
    expected = np.exp(-np.abs(from_a + from_b - from_a[b]) / 0.1)
    # Distances have round-off errors of 1e-14, which are divided by the width.
    assert np.abs(likelihood - expected).max() <= 1e-12


def test_unknown_methods_are_rejected(grid):
    check_error(lambda: grid.fuzzy_geodesic(24, 84, method="exact"))
    check_error(lambda: grid.fuzzy_geodesic_by_distances(24, 84, method="admm"))
