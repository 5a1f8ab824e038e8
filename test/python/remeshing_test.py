# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remeshing, holes, base meshes and semi-regular meshes."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import (
    cube_arrays,
    face_areas,
    grid_arrays,
    points_at,
    sphere_arrays,
    topology,
    torus_arrays,
)
from error_test import check_error

# Coordinates are about 1, and a point is a sum of three products.
ROUND_OFF = 1e-14


@pytest.fixture(scope="module")
def sphere():
    return gp.Surface(*sphere_arrays(4))


@pytest.fixture(scope="module")
def torus():
    return gp.Surface(*torus_arrays(48, 24))


@pytest.fixture(scope="module")
def sphere_cloud():
    V = sphere_arrays(4)[0]
    return gp.Surface(V, normals=V)


def test_remeshed_square_is_the_square(grid):
    result = grid.remesh(30)
    V = result.surface.vertices
    assert len(V) == 30 + result.number_of_added_vertices
    assert (V[:, 2] == 0).all() and topology(result.surface) == (1, 1, 0)
    assert abs(face_areas(result.surface).sum() - 1) <= ROUND_OFF * len(V)
    assert np.abs(points_at(grid, result.locations) - V).max() <= ROUND_OFF
    assert result.number_of_self_intersections == 0
    assert result.edges.shape == (0, 2) and result.paths == []


def test_edges_of_remeshed_square_are_straight(grid):
    result = grid.remesh(20, edge_paths=True)
    V, F = result.surface.vertices, result.surface.faces
    assert len(result.edges) == len(result.paths) == len(V) + len(F) - 1  # Euler's formula
    for (a, b), path in zip(result.edges, result.paths):
        assert isinstance(path, gp.Path)
        assert np.abs(path.points[[0, -1]] - V[[a, b]]).max() <= ROUND_OFF
        # The boundary is straight, so every edge is a straight path in the plane.
        assert abs(path.length - np.linalg.norm(V[a] - V[b])) <= 10 * ROUND_OFF


def test_remeshing_keeps_topology(sphere, torus):
    assert topology(sphere.remesh(0).surface) == (1, 0, 0)
    assert topology(torus.remesh(0).surface) == (1, 0, 1)


def test_first_samples_are_first_vertices(torus):
    result = torus.remesh(40, first=[5, 700])
    assert np.abs(result.surface.vertices[:2] - torus.vertices[[5, 700]]).max() <= ROUND_OFF


def test_sharp_edges_of_cube_are_kept():
    cube = gp.Surface(*cube_arrays(3))
    # Without an angle, faces cut the edges of the cube.
    assert face_areas(cube.remesh(60).surface).sum() < 5.95
    kept = cube.remesh(60, keep_sharp=30).surface
    assert abs(face_areas(kept).sum() - 6) <= 100 * ROUND_OFF


def test_deviation_is_limited(sphere):
    bound = 0.02
    coarse = sphere.remesh(30).surface
    fine = sphere.remesh(30, max_deviation=bound)
    distance = lambda mesh: np.linalg.norm(
        points_at(mesh, mesh.locate(sphere.vertices)) - sphere.vertices, axis=1
    ).max()
    assert distance(coarse) > bound
    assert distance(fine.surface) <= bound * (1 + 1e-9)  # round-off errors of the measurement
    assert fine.number_of_added_vertices == len(fine.surface.vertices) - 30 > 0


def test_fit_reduces_distances(sphere):
    error = lambda mesh: (
        (points_at(mesh, mesh.locate(sphere.vertices)) - sphere.vertices) ** 2
    ).sum()
    assert error(sphere.remesh(50, fit=True).surface) < 0.5 * error(sphere.remesh(50).surface)


def test_relaxation_improves_triangles(torus):
    def smallest_angles(surface):
        corners = surface.vertices[surface.faces]
        u = np.roll(corners, -1, axis=1) - corners
        v = np.roll(corners, 1, axis=1) - corners
        cosine = (u * v).sum(2) / np.linalg.norm(u, axis=2) / np.linalg.norm(v, axis=2)
        return np.arccos(cosine).min(axis=1)

    relaxed = torus.remesh(150, relaxation_steps=10).surface
    assert smallest_angles(relaxed).mean() > smallest_angles(torus.remesh(150).surface).mean()


def test_slow_regions_get_more_vertices(grid):
    speed = np.where(grid.vertices[:, 0] < 0.5, 0.2, 1.0)
    x = grid.remesh(60, speed=speed).surface.vertices[:, 0]
    assert (x < 0.5).sum() > 2 * (x > 0.5).sum()


def test_too_few_samples_raise(torus):
    with pytest.raises(gp.InvalidArgumentError, match="too few"):
        torus.remesh(3, too_few_samples="raise")


def test_cloud_is_reconstructed(sphere_cloud):
    result = sphere_cloud.remesh(100, edge_paths=True)
    V = result.surface.vertices
    assert topology(result.surface) == (1, 0, 0)
    assert result.locations.coordinates.shape == (len(V), 2)
    # Vertices are on chords of the sphere, whose distance from the cloud's tangent planes is at
    # most the square of the spacing, 0.1.
    assert np.abs(sphere_cloud.points(result.locations) - V).max() <= 0.01
    assert isinstance(result.paths[0], gp.SurfelPath)
    assert len(result.edges) == len(result.paths) == 3 * (len(V) - 2)  # Euler's formula


def disk_arrays():
    """Returns an open sphere: the faces around three vertices, which are not adjacent, are
    missing."""
    V, F = sphere_arrays(3)
    return V, F[~np.isin(F, [0, 1, 2]).any(axis=1)]


def from_least(faces):
    """Returns the same triangles, each beginning with its least corner."""
    first = np.argmin(faces, axis=1)[:, None]
    return np.take_along_axis(faces, (first + np.arange(3)) % 3, axis=1)


@pytest.mark.parametrize("method", ["minimal-dihedral-angles", "unfolding"])
def test_holes_are_filled(method):
    V, F = disk_arrays()
    surface = gp.Surface(V, F)
    result = surface.fill_holes(method=method)
    assert result[2:5] == (3, 3, 0)
    assert result.number_of_unfolded == (3 if method == "unfolding" else 0)
    assert np.array_equal(result.surface.vertices, V)
    assert np.array_equal(from_least(result.surface.faces[: len(F)]), from_least(surface.faces))
    # The vertices 0, 1 and 2 had four neighbors: each hole is a quadrilateral.
    assert np.array_equal(result.new_faces, np.arange(len(F), len(F) + 3 * 2))
    assert topology(result.surface) == (1, 0, 0)


def test_bounds_keep_holes_open():
    V, F = disk_arrays()
    surface = gp.Surface(V, F)
    for bounds in ({"max_edges": 3}, {"max_perimeter": 0.1}):
        result = surface.fill_holes(**bounds)
        assert (result.number_of_holes, result.number_of_filled) == (3, 0)
        assert len(result.new_faces) == 0
        assert np.array_equal(from_least(result.surface.faces), from_least(surface.faces))


def test_base_mesh_divides_surface(torus):
    result = torus.base_mesh(20)
    number = result.surface.number_of_faces
    assert topology(result.surface) == topology(result.divided) == (1, 0, 1)
    assert result.surface.number_of_points == 20 + result.number_of_added_vertices
    assert set(result.base_faces) == set(range(number))
    # Faces are only split. A sum of some thousand areas has this relative error.
    area = face_areas(torus).sum()
    assert abs(face_areas(result.divided).sum() - area) <= 1e-10 * area
    V, F = result.divided.vertices, result.divided.faces
    for face in range(number):
        assert topology(gp.Surface(V, F[result.base_faces == face])) == (1, 1, 0)


@pytest.mark.parametrize("coordinates", ["heron", "mean-value", "uniform"])
def test_parameterization_is_one_to_one(torus, coordinates):
    base = torus.parameterize_over_base(20, coordinates=coordinates)
    assert base.number_of_flips == 0 and base.number_of_repaired_faces >= 0
    assert topology(base.surface) == (1, 0, 1)
    locations = base.vertex_locations
    assert np.abs(locations.coordinates.sum(axis=1) - 1).max() <= ROUND_OFF
    assert locations.coordinates.min() >= 0
    mapped = base.map(np.arange(torus.number_of_points))
    assert np.array_equal(mapped.indices, locations.indices)
    assert np.array_equal(mapped.coordinates, locations.coordinates)
    # The inverse solves for a location in a small triangle of the base face.
    assert np.abs(base.points(locations) - torus.vertices).max() <= 1e-9
    assert np.abs(torus.points(base.inverse(locations)) - torus.vertices).max() <= 1e-9


def test_base_vertices_are_vertices_of_base_mesh(torus):
    base = torus.parameterize_over_base(20)
    V = base.surface.vertices
    assert np.abs(torus.points(base.base_vertices) - V).max() <= ROUND_OFF
    assert np.abs(base.points(np.arange(len(V))) - V).max() <= ROUND_OFF
    mapped = base.map(base.base_vertices)
    assert np.abs(points_at(base.surface, mapped) - V).max() <= 1e-9  # as the inverse


def test_isolated_and_merged_points():
    V, F = grid_arrays(9)
    V = np.concatenate([V, V[:1], [[5, 5, 5]]])
    F = np.where(F == 0, 81, F)  # point 81 replaces point 0, which is merged with it
    surface = gp.Surface(V, F, merge_tolerance=0.0)
    base = surface.parameterize_over_base(8)
    locations = base.vertex_locations
    assert (locations.indices[:82] >= 0).all() and locations.indices[82] == -1
    assert np.isnan(locations.coordinates[82]).all()
    assert np.abs(base.points(locations[:82]) - V[:82]).max() <= 1e-9
    with pytest.raises(gp.InvalidArgumentError, match="isolated"):
        base.map(82)


def test_parameterization_of_cloud(sphere_cloud):
    base = sphere_cloud.parameterize_over_base(12)
    assert topology(base.surface) == (1, 0, 0)
    points = base.points(base.vertex_locations)
    # Surfels are vertices of the reconstructed mesh.
    assert np.abs(points - sphere_cloud.vertices).max() <= 1e-9
    inverse = base.inverse(base.vertex_locations)
    assert inverse.coordinates.shape == (len(points), 2)
    assert np.abs(sphere_cloud.points(inverse) - points).max() <= 1e-9


@pytest.mark.parametrize("quads", [False, True])
def test_semi_regular_mesh_is_refined_base(torus, quads):
    result = torus.semi_regular(20, 2, quads=quads)
    number = result.number_of_base_faces * (3 if quads else 1) * 4**2
    assert result.number_of_levels == 2 and result.number_of_flips == 0
    assert result.polygons.shape == (number, 4 if quads else 3)
    assert result.surface.number_of_faces == number * (2 if quads else 1)
    if not quads:
        assert np.array_equal(result.surface.faces, result.polygons)
    assert topology(result.surface) == (1, 0, 1)
    assert (np.diff(result.levels) >= 0).all() and result.levels[-1] == 2
    # Euler's formula: on a torus there are half as many vertices as triangles.
    of_base = result.number_of_base_faces // 2 * (6 if quads else 1)
    assert np.array_equal(np.bincount(result.levels).cumsum(), of_base * 4 ** np.arange(3))
    # All vertices lie on the surface.
    V = result.surface.vertices
    assert np.abs(points_at(torus, torus.locate(V)) - V).max() <= 1e-12
    degree = np.bincount(result.polygons.ravel())[result.levels > 0]
    assert (degree == (4 if quads else 6)).all()


def test_semi_regular_refinement_stops_at_deviation(sphere):
    fine, coarse = (sphere.semi_regular(20, 4, max_deviation=d) for d in (0.02, 0.2))
    assert fine.deviation <= 0.02 < coarse.deviation <= 0.2
    assert coarse.number_of_levels < fine.number_of_levels <= 4
    assert sphere.semi_regular(20, 0).deviation == 0


def test_semi_regular_mesh_of_cloud(sphere_cloud):
    result = sphere_cloud.semi_regular(12, 1)
    assert topology(result.surface) == (1, 0, 0)
    assert len(result.polygons) == 4 * result.number_of_base_faces


def test_meshes_reject(grid, cloud):
    n = grid.number_of_points
    for make in (grid.remesh, grid.base_mesh, grid.parameterize_over_base, grid.semi_regular):
        for arguments, named in [
            ((-1,), {}), ((None,), {}), ((2.5,), {}), ((10,), {"keep_sharp": -1}),
            ((10,), {"keep_sharp": "all"}), ((10,), {"curve_spacing": math.inf}),
            ((10,), {"relaxation_steps": -1}), ((10,), {"first": [n]}), ((10,), {"first": []}),
            ((10,), {"speed": np.ones(3)}), ((10,), {"speed": np.zeros(n)}),
            ((10,), {"seed": -1}), ((10,), {"callback": 3}),
        ]:
            with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
                make(*arguments, **named)
        with pytest.raises(gp.Cancelled):
            make(10, callback=lambda fraction: False)
    for function in (
        lambda: grid.remesh(10, max_deviation=0), lambda: grid.remesh(10, max_deviation=math.nan),
        lambda: grid.remesh(10, too_few_samples="add"), lambda: grid.fill_holes(method="best"),
        lambda: grid.fill_holes(max_edges=-1), lambda: grid.fill_holes(max_perimeter=-1),
        lambda: grid.semi_regular(10, -1), lambda: grid.semi_regular(10, 16),
        lambda: grid.semi_regular(10, 2, max_deviation=-1),
        lambda: grid.semi_regular(10, 2, max_deviation=0.1, quads=True),
        lambda: grid.semi_regular(10, 2, coordinates="area"),
        lambda: grid.parameterize_over_base(10, coordinates=None),
    ):
        with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
            function()
    with pytest.raises(gp.UnsupportedSurfaceError):
        cloud.fill_holes()
    base = grid.parameterize_over_base(6)
    for location in (-1, 10**6, (0, (2, -1, 0)), (10**6, (1, 0, 0)), [], None):
        for function in (base.inverse, base.points, base.map):
            with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
                function(location)


def middle_line(surface):
    """Returns the edges of the square on the line x = 1/2."""
    V, F = surface.vertices, surface.faces
    edges = np.unique(np.sort(F[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)), axis=0)
    return edges[(np.abs(V[edges][:, :, 0] - 0.5) < 1e-9).all(axis=1)]


def crosses_middle(surface):
    """Returns whether a face crosses the line x = 1/2."""
    x = surface.vertices[surface.faces][:, :, 0] - 0.5
    return bool(((x.min(axis=1) < -ROUND_OFF) & (x.max(axis=1) > ROUND_OFF)).any())


@pytest.mark.parametrize(
    "mesh_of",
    [
        lambda grid, **named: grid.remesh(20, **named).surface,
        lambda grid, **named: grid.base_mesh(12, **named).surface,
        lambda grid, **named: grid.parameterize_over_base(12, **named).surface,
        lambda grid, **named: grid.semi_regular(12, 1, **named).surface,
    ],
    ids=["remesh", "base mesh", "parameterization", "semi-regular mesh"],
)
def test_constrained_edges_are_kept(grid, mesh_of):
    edges = middle_line(grid)
    assert len(edges) == 10
    assert crosses_middle(mesh_of(grid))
    assert not crosses_middle(mesh_of(grid, constrained_edges=edges))
    # The order of vertices and edges has no effect.
    assert not crosses_middle(mesh_of(grid, constrained_edges=edges[::-1, ::-1].tolist()))


def test_spacing_along_constrained_edges(grid):
    edges = middle_line(grid)
    counts = []
    for spacing in (0.25, 0.125):
        mesh = grid.remesh(
            4, constrained_edges=edges, edge_spacing=np.full(len(edges), spacing)
        ).surface
        counts.append((np.abs(mesh.vertices[:, 0] - 0.5) <= ROUND_OFF).sum())
    # A line of length 1 with k edges has k + 1 vertices. The topology can require more of them.
    assert counts[0] >= 5 and counts[1] >= 9 and counts[0] < counts[1]


@pytest.mark.parametrize(
    "named",
    [
        {"constrained_edges": [[0, 60]]}, {"constrained_edges": [[3, 3]]},
        {"constrained_edges": [[0, 121]]}, {"constrained_edges": [[-1, 0]]},
        {"constrained_edges": [0, 1]}, {"constrained_edges": [[0, 1, 2]]},
        {"constrained_edges": [[0.0, 1.0]]}, {"constrained_edges": "all"},
        {"constrained_edges": np.empty((0, 2), int)}, {"edge_spacing": [0.1]},
        {"constrained_edges": [[0, 1]], "edge_spacing": [0.1, 0.2]},
        {"constrained_edges": [[0, 1]], "edge_spacing": [-0.1]},
        {"constrained_edges": [[0, 1]], "edge_spacing": [math.inf]},
        {"constrained_edges": [[0, 1]], "edge_spacing": 0.1},
    ],
)
def test_constrained_edges_are_checked(grid, named):
    check_error(lambda: grid.remesh(20, **named))


def test_cloud_has_no_constrained_edges(sphere_cloud):
    check_error(lambda: sphere_cloud.remesh(20, constrained_edges=[[0, 1]]))
    check_error(lambda: sphere_cloud.base_mesh(20, edge_spacing=[0.1]))
