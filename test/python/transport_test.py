# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Optimal transport and fields."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, prism_arrays
from error_test import check_error

GAP = 1e-3  # the default tolerance of the bounds, relative to the upper bound
# Sums of some hundred terms and some tens of back substitutions, as in the tests of the library.
SOLVER_ERROR = 1e-9


def check_bounds(cost, expected, tolerance=GAP):
    """Checks a distance that is exact up to the gap between the bounds."""
    assert isinstance(cost, gp.TransportCost) and cost.is_converged
    assert cost.lower <= cost.value <= cost.upper
    assert cost.upper - cost.lower <= tolerance * cost.upper
    assert cost.residual <= SOLVER_ERROR
    assert abs(cost.value - expected) <= tolerance * expected


def distance_between(V, i, j):
    return np.linalg.norm(V[j] - V[i])


@pytest.mark.parametrize("method", ["interior-point", "admm", "weiszfeld"])
def test_distance_of_vertices_is_straight(grid, arrays, method):
    # Weiszfeld's method stalls at a gap of about a percent.
    tolerance = {"interior-point": GAP, "admm": 0.01, "weiszfeld": 0.02}[method]
    result = grid.emd(3, 97, method=method, tolerance=tolerance)
    expected = distance_between(arrays[0], 3, 97)
    assert result.cost.lower * (1 - 1e-9) <= expected
    assert abs(result.cost.value - expected) <= tolerance * expected
    assert result.basis_size is None


def test_flow_and_potential_certify_the_distance(grid, arrays):
    V, F = arrays
    result = grid.emd(3, 97)
    check_bounds(result.cost, distance_between(V, 3, 97))
    assert result.cost.upper_continuous == math.inf
    assert abs(result.potential[97] - result.potential[3] - result.cost.lower) <= SOLVER_ERROR
    edges = np.concatenate([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]])
    slopes = np.abs(result.potential[edges[:, 0]] - result.potential[edges[:, 1]])
    slopes /= np.linalg.norm(V[edges[:, 0]] - V[edges[:, 1]], axis=1)
    assert slopes.max() <= 1 + SOLVER_ERROR
    # No mass crosses the boundary, so that the integral of the flow is the displacement.
    displacement = result.flow.sum(axis=0) / len(F)
    assert np.abs(displacement - (V[97] - V[3])).max() <= SOLVER_ERROR


def test_upper_bound_on_surface(grid, arrays):
    cost = grid.emd(3, 97, bound_from_above=True).cost
    assert distance_between(arrays[0], 3, 97) <= cost.upper_continuous * (1 + 1e-9) < math.inf


def test_all_kinds_of_masses(grid, arrays):
    V = arrays[0]
    inside = grid.locate([[0.52, 0.11, 0], [0.12, 0.91, 0]])
    check_bounds(grid.emd(inside[0], inside[1]).cost, math.hypot(0.4, 0.8))
    check_bounds(grid.emd([0, 10], np.array([110, 120])).cost, 1)
    # A unit mass moves by 1 to the negative mass, another one by 0.5.
    a, b = np.zeros(121), np.zeros(121)
    a[[0, 10]] = 2, -1
    b[5] = 1
    for first in (a, a.astype(np.float32), a.tolist()):
        check_bounds(grid.emd(first, b).cost, 1.5)
    uniform = gp.mass_density(np.ones(121))
    assert grid.emd(uniform, gp.mass_density([1.0] * 121)).cost.value == 0
    # Masses move by less than a square of the grid.
    assert 0 < grid.emd(uniform, np.full(121, 1 / 121)).cost.value < 0.1
    # The mean distance from a corner, up to the discretization error around it.
    mean = (math.sqrt(2) + math.asinh(1)) / 3
    assert abs(grid.emd(uniform, 0).cost.value - mean) <= 0.05 * mean
    assert abs(grid.emd(5 * a, b, normalize=True).cost.value - 1.5) <= 2 * GAP
    assert grid.emd(V[:, 0].copy(), V[:, 0][::-1].copy()).cost.value > 0


def test_speeds_and_metrics(grid, arrays):
    expected = distance_between(arrays[0], 3, 97)
    check_bounds(grid.emd(3, 97, speed=np.full(121, 2.0)).cost, expected / 2)
    check_bounds(grid.emd(3, 97, face_speed=np.full(200, 2.0)).cost, expected / 2)
    # A metric with eigenvalues 4 and 1: lengths are doubled in the direction of x.
    metric = np.diag([4.0, 1.0, 1.0])
    dx, dy, _ = arrays[0][97] - arrays[0][3]
    for named in (
        {"metric": np.tile(metric, (121, 1, 1))},
        {"face_metric": np.tile(metric, (200, 1, 1))},
        {"metric": np.tile(metric, (121, 1, 1)), "number_of_refinements": 0},
    ):
        check_bounds(grid.emd(3, 97, **named).cost, math.hypot(2 * dx, dy))


@pytest.mark.parametrize("refinements", [0, 1, 2])
def test_distance_on_prism_is_that_of_unrolled_plane(refinements):
    surface = gp.Surface(*prism_arrays(6, 3))
    cost = surface.emd(0, 15, number_of_refinements=refinements, tolerance=1e-5).cost
    check_bounds(cost, surface.path(0, 15).length, 1e-5)
    assert abs(cost.estimate - cost.value) <= 1e-5


def test_distance_on_cloud(cloud, arrays):
    expected = distance_between(arrays[0], 3, 97)
    result = cloud.emd(3, 97)
    # The local triangulations overlap: the distance is not exact, but symmetric.
    assert abs(result.cost.value - expected) <= 0.05 * expected
    assert abs(cloud.emd(97, 3).cost.value - result.cost.value) <= GAP * expected
    assert result.flow.shape == (121, 3) and result.potential.shape == (121,)
    slower = cloud.emd(3, 97, speed=np.full(121, 0.5)).cost.value
    assert abs(slower - 2 * result.cost.value) <= 2 * GAP * slower


def test_basis_restricts_the_flow(surface, arrays):
    flow_of = "gradient"
    complete = surface.emd(3, 97).cost
    values = []
    for basis in (0, 10, 40):
        result = surface.emd(3, 97, basis, transport_flow=flow_of)
        assert result.potential is None and result.basis_size >= basis
        assert result.cost.lower <= result.cost.value <= result.cost.upper
        values.append(result.cost)
    for smoother, finer in zip(values, values[1:]):
        assert finer.lower <= smoother.upper * (1 + SOLVER_ERROR)
    assert complete.lower <= values[-1].upper * (1 + SOLVER_ERROR)
    assert surface.emd(3, 97, basis=10).basis_size >= 10


def test_flow_of_basis_moves_the_mass(grid, arrays):
    V, F = arrays
    result = grid.emd(3, 97, basis=10, transport_flow="gradient")
    displacement = result.flow.sum(axis=0) / len(F)
    assert np.abs(displacement - (V[97] - V[3])).max() <= SOLVER_ERROR


def test_masses_of_different_components(arrays):
    V, F = arrays
    surface = gp.Surface(np.concatenate([V, V + [0, 0, 1]]), np.concatenate([F, F + len(V)]))
    check_error(lambda: surface.emd(0, 130))
    result = surface.emd(0, 130, basis=0)
    assert result.cost.value == math.inf and np.isnan(result.flow).all()
    check_bounds(surface.emd([0, 121], [10, 131]).cost, 1)


def test_barycenter_of_two_vertices(surface, arrays):
    V = arrays[0]
    result = surface.barycenter([3, 97])
    assert isinstance(result, gp.TransportBarycenter) and result.is_converged
    assert result.lower <= result.value <= result.upper <= result.lower * 1.0102
    # The sum of squares is smallest if both distances are half of the distance of the vertices.
    distance = surface.emd(3, 97).cost.value
    assert abs(result.value - distance**2 / 2) <= 0.02 * result.value
    assert abs(result.masses.sum() - 1) <= 1e-6 and result.masses.min() >= 0
    assert np.abs(result.distances - distance / 2).max() <= 0.1 * distance
    positive = result.masses > 0
    assert (result.density[positive] > 0).all() and (result.density[~positive] == 0).all()
    assert V.shape[0] == len(result.masses)


def test_barycenter_of_rows(grid):
    masses = np.zeros((3, 121))
    masses[0, 3] = masses[1, 97] = masses[2, 44] = 2
    result = grid.barycenter(masses, weights=[1, 2, 0.5], normalize=True)
    as_vertices = grid.barycenter([3, 97, 44], [1, 2, 0.5])
    assert abs(result.value - as_vertices.value) <= 0.02 * result.value
    assert len(result.distances) == 3
    density = [gp.mass_density(np.ones(121)), gp.mass_density(np.ones(121))]
    assert grid.barycenter(density).upper <= 1e-6


def test_geodesic_barycenter_minimizes_squared_distances(surface, arrays):
    V = arrays[0]
    locations, weights = [3, 97, 44], [1, 2, 0.5]
    result = surface.geodesic_barycenter(locations, weights)
    objective = sum(
        w * ((V - V[i]) ** 2).sum(axis=1) for i, w in zip(locations, weights)
    )
    assert np.abs(result.objective - objective).max() <= 1e-12
    assert result.value == result.objective[result.vertex] == result.objective.min()
    slow = surface.geodesic_barycenter(locations, weights, speed=np.full(121, 0.5))
    assert np.abs(slow.objective - 4 * objective).max() <= 1e-11
    assert type(result.vertex) is int


def test_mass_moves_to_nearest_exit(grid, arrays):
    V = arrays[0]
    result = grid.transport_to_region(60, [0, 57])
    check_bounds(result.cost, distance_between(V, 60, 57))
    assert abs(result.arrivals[57] - 1) <= 1e-6 and abs(result.arrivals.sum() - 1) <= 1e-6
    assert np.abs(result.potential[[0, 57]]).max() <= SOLVER_ERROR
    assert (np.abs(result.potential) <= grid.distance([0, 57]) + SOLVER_ERROR).all()
    # The integral of the flow is the displacement, except for the part that moves elsewhere.
    displacement = result.flow.sum(axis=0) / 200
    assert np.abs(displacement - (V[57] - V[60])).max() <= 1e-5


def test_capacities_limit_arrivals(grid, arrays):
    V = arrays[0]
    result = grid.transport_to_region(60, [57, 65], capacities=[0.4, math.inf])
    expected = 0.4 * distance_between(V, 60, 57) + 0.6 * distance_between(V, 60, 65)
    check_bounds(result.cost, expected)
    # Arrivals have the accuracy of the bounds.
    assert np.abs(result.arrivals[[57, 65]] - [0.4, 0.6]).max() <= 2 * GAP


def test_spreading_weight_spreads_arrivals(grid):
    exits = [49, 60, 71]
    direct = grid.transport_to_region(0, exits)
    assert abs(direct.arrivals[49] - 1) <= GAP
    spread = grid.transport_to_region(0, exits, spreading_weight=100.0)
    # With a large weight, the densities at the exits are equal, which have equal areas.
    assert np.abs(spread.arrivals[exits] - 1 / 3).max() <= 0.01


def test_mass_leaves_a_full_exit(grid):
    exits = [49, 60, 71]
    spread = grid.transport_to_region(60, exits, spreading_weight=100.0)
    assert np.abs(spread.arrivals[exits] - 1 / 3).max() <= 0.01
    limited = grid.transport_to_region(60, exits, capacities=[1, 0.4, 1])
    check_bounds(limited.cost, 0.06)
    assert abs(limited.arrivals[60] - 0.4) <= GAP and abs(limited.arrivals.sum() - 1) <= GAP


def test_region_on_cloud(cloud):
    result = cloud.transport_to_region([60, 61], 0)
    assert abs(result.arrivals[0] - 1) <= 1e-6
    assert result.cost.value > 0 and result.flow.shape == (121, 3)


def test_streamline_between_vertices_is_straight(surface, arrays):
    V = arrays[0]
    expected = distance_between(V, 3, 97)
    (line,) = surface.streamlines(3, 97, seeds=3)
    assert line.has_arrived
    # Lines on a cloud move along edges of the graph and are then shortened.
    tolerance = 0.05 if surface.is_cloud else 0.01
    assert np.abs(line.path.points[[0, -1]] - V[[3, 97]]).max() <= 0.2
    assert abs(line.path.length - expected) <= tolerance * expected + 0.2
    assert abs(line.path.distance - expected) <= tolerance * expected + 0.2


def test_streamlines_of_equal_masses(grid):
    lines = grid.streamlines([0, 10], [110, 120], 6)
    assert len(lines) == 6 and all(line.has_arrived for line in lines)
    assert all(isinstance(line.path, gp.Path) for line in lines)
    # Masses move by one in the direction of x, from the faces at the vertices.
    for line in lines:
        assert abs(line.path.points[-1, 0] - line.path.points[0, 0] - 1) <= 0.2
    assert grid.streamlines(0, 10, 0) == []
    traced = grid.streamlines([0, 10], [110, 120], 6, straighten=False)
    assert all(a.path.length <= b.path.length * (1 + 1e-12) for a, b in zip(lines, traced))


def test_constant_field_is_gradient(surface, arrays):
    field = np.tile([1.0, 2.0, 0.0], (121 if surface.is_cloud else 200, 1))
    result = surface.hodge_decomposition(field + [0, 0, 3])  # the normal component is ignored
    assert np.abs(result.gradient - field).max() <= SOLVER_ERROR
    potential = (arrays[0] - 0.5) @ [1, 2, 0]
    # On a cloud, the integral is that over weighted triangles.
    shift = result.gradient_potential - potential
    assert np.abs(shift - shift.mean()).max() <= SOLVER_ERROR
    if surface.is_cloud:
        assert isinstance(result, gp.SurfelHodgeDecomposition)
        assert np.abs(result.remainder).max() <= SOLVER_ERROR
    else:
        assert np.abs(shift).max() <= SOLVER_ERROR
        for zero in (result.rotation, result.harmonic, result.rotation_potential):
            assert np.abs(zero).max() <= SOLVER_ERROR


def gradients(V, F, values):
    """Returns the gradients of a function that is linear in each face."""
    a, b, c = V[F].transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    double_area = np.linalg.norm(normal, axis=1, keepdims=True)
    normal /= double_area
    fa, fb, fc = values[F].T[:, :, None]
    return np.cross(normal, fa * (c - b) + fb * (a - c) + fc * (b - a)) / double_area, normal


def test_vortices_are_rotation(grid, arrays):
    V, F = arrays
    is_inside = ((V[:, :2] > 0) & (V[:, :2] < 1)).all(axis=1)
    potential = np.random.default_rng(4).uniform(-1, 1, 121) * is_inside
    gradient, normal = gradients(V, F, potential)
    field = np.cross(normal, gradient)
    result = grid.hodge_decomposition(field)
    assert np.abs(result.rotation - field).max() <= 1e-8
    assert np.abs(result.gradient).max() <= 1e-8 and np.abs(result.harmonic).max() <= 1e-8
    assert np.abs(result.vertex_rotation_potential - potential).max() <= SOLVER_ERROR
    middle = potential[result.edges].mean(axis=1)
    assert len(result.edges) == 320
    assert np.abs(result.rotation_potential - middle).max() <= SOLVER_ERROR


def test_field_around_prism_is_harmonic():
    V, F = prism_arrays(6, 4)
    surface = gp.Surface(V, F)
    _, normal = gradients(V, F, V[:, 2])
    around = np.cross([0, 0, 1], normal)
    result = surface.hodge_decomposition(around + np.array([0, 0, 1]))
    assert np.abs(result.harmonic - around).max() <= SOLVER_ERROR
    assert np.abs(result.gradient - [0, 0, 1]).max() <= SOLVER_ERROR
    assert np.abs(result.gradient_potential - V[:, 2] + 0.5).max() <= SOLVER_ERROR


@pytest.mark.parametrize("call", [
    lambda s, callback: s.emd(3, 97, callback=callback),
    lambda s, callback: s.emd(3, 97, method="admm", callback=callback),
    lambda s, callback: s.emd(3, 97, basis=5, callback=callback),
    lambda s, callback: s.barycenter([3, 97], callback=callback),
    lambda s, callback: s.geodesic_barycenter([3, 97], callback=callback),
    lambda s, callback: s.transport_to_region(3, 97, callback=callback),
    lambda s, callback: s.streamlines(3, 97, 2, callback=callback),
])
def test_callback_cancels_transport(grid, call):
    fractions = []
    call(grid, fractions.append)
    assert fractions and all(0 <= fraction <= 1 for fraction in fractions)
    with pytest.raises(gp.Cancelled):
        call(grid, lambda fraction: False)
    raised = KeyError("reason")

    def callback(fraction):
        raise raised

    with pytest.raises(KeyError) as caught:
        call(grid, callback)
    assert caught.value is raised


V3, F3 = grid_arrays(3)
NORMALS = np.tile([0.0, 0.0, 1.0], (9, 1))
BAD_MASSES = [
    None, [], 9, -1, "0", [0, 9], np.zeros((9, 1)), np.zeros(8), np.full(9, np.nan), [0.5, 0.5],
    np.full(9, np.inf), [1.0, "a"], np.ones(9, bool), gp.mass_density(np.ones(8)), (0, (1, 1, 1)),
    gp.mass_density(np.full(9, np.nan)), gp.mass_density("heavy"), gp.mass_density(None), 1.5,
]


@pytest.mark.parametrize("masses", BAD_MASSES)
def test_transport_rejects_masses(masses):
    for surface in (gp.Surface(V3, F3), gp.Surface(V3, normals=NORMALS)):
        check_error(lambda: surface.emd(masses, 0))
        check_error(lambda: surface.emd(0, masses, basis=2))
        check_error(lambda: surface.barycenter([0, masses]))
        check_error(lambda: surface.transport_to_region(masses, 0))
        check_error(lambda: surface.streamlines(0, masses, 3))


EYE = np.eye(3)


@pytest.mark.parametrize("named", [
    {"method": "best"}, {"method": None}, {"tolerance": 0}, {"tolerance": math.nan},
    {"tolerance": "small"}, {"max_iterations": 0}, {"max_iterations": 1.5},
    {"number_of_refinements": -1}, {"number_of_refinements": 31}, {"number_of_refinements": "1"},
    {"speed": np.ones(8)}, {"speed": -np.ones(9)}, {"speed": "fast"}, {"face_speed": np.ones(9)},
    {"speed": np.ones(9), "face_speed": np.ones(8)}, {"metric": EYE},
    {"metric": np.tile(EYE, (8, 1, 1))}, {"metric": np.tile(-EYE, (9, 1, 1))},
    {"metric": np.full((9, 3, 3), np.nan)}, {"metric": "flat"}, {"face_metric": EYE},
    {"metric": np.tile(EYE, (9, 1, 1)), "face_metric": np.tile(EYE, (8, 1, 1))}, {"callback": 3},
])
def test_transport_rejects_arguments(named):
    for surface in (gp.Surface(V3, F3), gp.Surface(V3, normals=NORMALS)):
        check_error(lambda: surface.emd(0, 8, **named))
        check_error(lambda: surface.transport_to_region(0, 8, **named))
        check_error(lambda: surface.streamlines(0, 8, 1, **named))
        if "method" not in named:
            check_error(lambda: surface.barycenter([0, 8], **named))


def test_other_transport_arguments_are_rejected():
    mesh, cloud = gp.Surface(V3, F3), gp.Surface(V3, normals=NORMALS)
    check_error(lambda: cloud.emd(0, 8, face_speed=np.ones(8)))
    check_error(lambda: cloud.emd(0, 8, face_metric=np.zeros((0, 3, 3))))
    check_error(lambda: cloud.emd(0, 8, bound_from_above=True), gp.UnsupportedSurfaceError)
    check_error(lambda: mesh.emd(0, [1.0] * 9))  # the total masses differ
    for basis in (-1, 10, 1.5, "all"):
        check_error(lambda: mesh.emd(0, 8, basis))
    check_error(lambda: mesh.emd(0, 8, transport_flow="gradient"))
    check_error(lambda: mesh.emd(0, 8, 2, transport_flow="fast"))
    for named in ({"method": "admm"}, {"speed": np.ones(9)}, {"number_of_refinements": 1},
                  {"bound_from_above": True}, {"metric": np.tile(EYE, (9, 1, 1))}):
        check_error(lambda: mesh.emd(0, 8, 2, **named))
    for masses in (None, 0, [], gp.mass_density(np.ones(9))):
        check_error(lambda: mesh.barycenter(masses))
    for weights in ([1], [1, -1], [0, 0], [1, math.nan], "equal"):
        check_error(lambda: mesh.barycenter([0, 8], weights))
        check_error(lambda: mesh.geodesic_barycenter([0, 8], weights))
    check_error(lambda: mesh.geodesic_barycenter([]))
    check_error(lambda: mesh.geodesic_barycenter([0, 9]))
    check_error(lambda: mesh.geodesic_barycenter([0, 8], speed=np.ones(8)))
    for region in (None, [], 9, [0.5]):
        check_error(lambda: mesh.transport_to_region(0, region))
    for capacities in ([1, 1], [0], [-1], [math.nan], [0.5], "full"):
        check_error(lambda: mesh.transport_to_region(0, [8], capacities=capacities))
    for weight in (-1, math.nan, None):
        check_error(lambda: mesh.transport_to_region(0, 8, spreading_weight=weight))
    check_error(lambda: mesh.streamlines(0, 8))
    check_error(lambda: mesh.streamlines(0, 8, 2, seeds=[0]))
    check_error(lambda: mesh.streamlines(0, 8, -1))
    check_error(lambda: mesh.streamlines(0, 8, seeds=[9]))
    for field in (np.ones((9, 3)), np.ones((8, 2)), np.full((8, 3), np.nan), None, "up"):
        check_error(lambda: mesh.hodge_decomposition(field))
    check_error(lambda: cloud.hodge_decomposition(np.ones((8, 3))))


def test_geodesic_barycenter_uses_method_and_speed_of_faces(grid):
    locations = [3, 60, 117]
    by_edges = grid.geodesic_barycenter(locations, method="dijkstra")
    squares = [grid.distance(i, method="dijkstra") ** 2 for i in locations]
    # A sum of three squares of about 1.
    assert np.abs(by_edges.objective - sum(squares)).max() <= 1e-14
    fast = grid.geodesic_barycenter(locations, face_speed=np.full(grid.number_of_faces, 2.0))
    expected = grid.geodesic_barycenter(locations).objective / 4
    assert np.abs(fast.objective - expected).max() <= 1e-13
    for named in ({"method": "best"}, {"face_speed": np.ones(121)}):
        check_error(lambda: grid.geodesic_barycenter(locations, **named))
