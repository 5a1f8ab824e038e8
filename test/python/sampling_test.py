# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distance matrices, samples, Voronoi diagrams, segments and isolines."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import face_areas, sphere_arrays, topology
from error_test import check_error

ROUND_OFF = 1e-14  # as in distance_test.py


def distances_in_space(A, B):
    return np.linalg.norm(A[:, None] - B[None], axis=2)


@pytest.mark.parametrize("threads", [None, 1, 3])
def test_matrix_of_planar_mesh_is_straight(grid, arrays, threads):
    V = arrays[0]
    rows, columns = [0, 7, 60], [5, 118]
    matrix = grid.distance_matrix(rows, columns, threads=threads)
    assert np.abs(matrix - distances_in_space(V[rows], V[columns])).max() <= ROUND_OFF
    matrix = grid.distance_matrix(rows, threads=threads)
    assert np.abs(matrix - distances_in_space(V[rows], V[rows])).max() <= ROUND_OFF


def test_matrix_of_locations(grid):
    points = np.array([[0.13, 0.22, 0], [0.81, 0.37, 0], [0.5, 0.99, 0]])
    matrix = grid.distance_matrix(grid.locate(points))
    assert np.abs(matrix - distances_in_space(points, points)).max() <= 2 * ROUND_OFF


def test_matrix_of_iterator(grid):
    assert np.array_equal(grid.distance_matrix(iter([3, 9])), grid.distance_matrix([3, 9]))


def test_rows_of_matrix_are_distances(surface):
    for method in ("auto", "fast-marching"):
        matrix = surface.distance_matrix([3, 80], np.arange(121), method=method)
        for row, source in zip(matrix, (3, 80)):
            assert np.array_equal(row, surface.distance(source, method=method))


def test_matrix_is_limited_by_maximum_distance(grid):
    complete = grid.distance_matrix(np.arange(121))
    limited = grid.distance_matrix(np.arange(121), max_distance=0.35)
    assert np.array_equal(limited, np.where(complete <= 0.35, complete, math.inf))


def test_samples_are_farthest_points(surface):
    samples = surface.farthest_points(6)
    assert len(samples.locations) == len(samples.radii) == 6
    assert (np.diff(samples.radii) <= 0).all()
    # On a cloud and a flat mesh, distances by the front are exact up to round-off errors.
    distance = surface.distance(samples.locations)
    assert abs(distance.max() - samples.radii[-1]) <= 1e-12
    # The first sample is farthest from a vertex, which is a corner of the square.
    corners = {0, 10, 110, 120}
    first = surface.points(samples.locations[:1])[0]
    assert any(np.abs(first - surface.points([c])[0]).max() <= ROUND_OFF for c in corners)


def test_samples_cover_surface(surface):
    samples = surface.farthest_points(radius=0.3)
    assert samples.radii[-1] <= 0.3 < samples.radii[-2]
    assert surface.distance(samples.locations).max() <= 0.3 + 1e-12
    assert set(samples.labels) <= set(range(len(samples.locations)))


def test_samples_continue(surface):
    complete = surface.farthest_points(6)
    rest = surface.farthest_points(3, first=complete.locations[:3])
    assert np.array_equal(rest.locations.indices, complete.locations.indices[3:])
    assert np.array_equal(rest.labels, complete.labels)


def test_voronoi_labels_are_nearest_seeds(surface, arrays):
    V = arrays[0]
    seeds = [0, 58, 113]
    nearest = distances_in_space(V, V[seeds])
    labels = surface.voronoi(seeds).labels
    assert labels.dtype == np.int64
    chosen = nearest[np.arange(121), labels]
    # At equal distances, both labels are correct.
    assert np.abs(chosen - nearest.min(axis=1)).max() <= ROUND_OFF


def test_bisectors_have_equal_distances(grid, arrays):
    V = arrays[0]
    seeds = [0, 58, 113]
    voronoi = grid.voronoi(seeds)
    assert len(voronoi.face_labels) == len(arrays[1]) and len(voronoi.bisectors) >= 2
    for bisector in voronoi.bisectors:
        left = np.linalg.norm(bisector.points - V[seeds[bisector.left]], axis=1)
        right = np.linalg.norm(bisector.points - V[seeds[bisector.right]], axis=1)
        # Bisectors are exact in the plane, except for Voronoi vertices, which are within a face.
        assert np.abs((left - right)[1:-1]).max(initial=0) <= 1e-9
        corners = V[grid.faces[bisector.faces]]
        points = np.einsum("ij,ijk->ik", bisector.barycentric, corners)
        assert np.abs(points - bisector.points).max() <= ROUND_OFF


def test_voronoi_of_cloud_has_labels_only(cloud):
    voronoi = cloud.voronoi([0, 120])
    assert len(voronoi.face_labels) == 0 and voronoi.bisectors == []


def test_isolines_of_coordinate_are_straight(grid, arrays):
    lines = grid.isolines(arrays[0][:, 0], [0.25, 0.77])
    assert [line.value for line in lines] == [0.25, 0.77]
    for line in lines:
        assert not line.is_closed
        assert np.abs(line.points[:, 0] - line.value).max() <= ROUND_OFF
        assert abs(line.length - 1) <= ROUND_OFF
        corners = arrays[0][grid.faces[line.faces]]
        points = np.einsum("ij,ijk->ik", line.barycentric, corners)
        assert np.abs(points - line.points).max() <= ROUND_OFF


def test_isolines_of_distances_are_circles(grid):
    (line,) = grid.isolines(grid.distance(60), [0.33], fit_circles=True)
    assert line.is_closed and np.array_equal(line.points[0], line.points[-1])
    assert np.abs(np.linalg.norm(line.points - [0.5, 0.5, 0], axis=1) - 0.33).max() <= 1e-13


@pytest.mark.parametrize("method", ["euclidean", "fast-marching", "dijkstra"])
def test_method_of_samples_and_cells(surface, method):
    first = [0, 115]
    distances = [surface.distance(v, method=method) for v in first]
    samples = surface.farthest_points(2, first=first, method=method)
    # A front of three sources differs from three fronts by less than an edge.
    sources = [*first, samples.locations[0]]
    assert abs(samples.radii[0] - surface.distance(sources, method=method).max()) < 0.1
    labels = surface.voronoi(first, method=method).labels
    is_clear = np.abs(distances[0] - distances[1]) > 0.1
    assert np.array_equal(labels[is_clear], np.argmin(distances, axis=0)[is_clear])
    if method == "euclidean":
        assert np.array_equal(labels, surface.voronoi(first).labels)
        assert np.array_equal(samples.radii, surface.farthest_points(2, first=first).radii)


def test_vertices_are_points_of_vertices(surface, arrays):
    # A cloud stores points relative to its center.
    tolerance = 1e-15 if surface.is_cloud else 0
    assert np.abs(surface.vertices - arrays[0]).max() <= tolerance
    surface.vertices[0] = 7.0  # a copy
    assert np.abs(surface.vertices - arrays[0]).max() <= tolerance


def test_vertex_samples_are_farthest_vertices(surface):
    samples = surface.farthest_vertices(7)
    assert samples.vertices.dtype == np.int64 and len(set(samples.vertices)) == 7
    assert samples.vertices[0] in (0, 10, 110, 120)  # a corner of the square
    for k in range(1, 7):
        distance = surface.distance(samples.vertices[:k], method="euclidean")
        # The front of all samples is updated incrementally: equal up to round-off errors.
        assert abs(distance[samples.vertices[k]] - distance.max()) <= 1e-12
        assert abs(samples.radii[k - 1] - distance.max()) <= 1e-12
    assert set(samples.labels) == set(range(7))


def test_vertex_samples_continue(surface):
    complete = surface.farthest_vertices(6)
    rest = surface.farthest_vertices(3, first=complete.vertices[:3])
    assert np.array_equal(rest.vertices, complete.vertices[3:])
    assert np.array_equal(rest.labels, complete.labels)


def test_cells_of_square_are_rectangles(grid):
    seeds = [2 * 11 + 5, 7 * 11 + 5]  # at (0.2, 0.5) and (0.7, 0.5)
    cells = grid.voronoi_cells(seeds)
    x = cells.surface.vertices[cells.surface.faces][:, :, 0]
    # Bisectors are exact in the plane.
    assert x[cells.face_labels == 0].max() <= 0.45 + 1e-12
    assert x[cells.face_labels == 1].min() >= 0.45 - 1e-12
    areas = np.bincount(cells.face_labels, face_areas(cells.surface))
    assert np.abs(areas - [0.45, 0.55]).max() <= 1e-12
    assert topology(cells.surface) == (1, 1, 0)


def test_cells_end_at_maximum_distance(grid):
    cells = grid.voronoi_cells([0], max_distance=0.35)
    corners = cells.surface.vertices[cells.surface.faces]
    is_reached = (np.linalg.norm(corners, axis=2) <= 0.35).all(axis=1)
    assert np.array_equal(cells.face_labels, np.where(is_reached, 0, -1))


@pytest.mark.parametrize("disks", [False, True])
def test_segments_of_mesh_are_connected(grid, arrays, disks):
    segments = grid.segment(5, disks=disks)
    number = len(segments.centers)
    assert number >= 5 if disks else number == 5
    assert set(segments.labels) == set(range(number))
    assert (np.diff(segments.energies[:-1]) <= 0).all()
    for label in range(number):
        patch = gp.Surface(arrays[0], arrays[1][segments.labels == label])
        components, boundaries, genus = topology(patch)
        assert components == 1
        assert not disks or (boundaries, genus) == (1, 0)


def test_segments_are_balanced():
    sphere = gp.Surface(*sphere_arrays(4))
    segments = sphere.segment(6, disks=False)
    areas = np.bincount(segments.labels, face_areas(sphere))
    # Six equal cells are a minimum of the energy. The cells are unions of 2,048 faces, and the
    # iteration stops at a change of a thousandth: 0.8 and 1.2 leave room for a local minimum.
    assert (areas > 0.8 * areas.mean()).all() and (areas < 1.2 * areas.mean()).all()
    assert segments.energies[-1] < segments.energies[0]


def test_segments_do_not_depend_on_threads(surface):
    one, two = surface.segment(5, threads=1), surface.segment(5, threads=2)
    assert np.array_equal(one.labels, two.labels)
    assert np.array_equal(one.energies, two.energies)


def test_segments_of_cloud_have_centers(cloud):
    segments = cloud.segment(4)
    assert len(segments.labels) == 121 and len(segments.centers) == 4
    assert set(segments.labels) == {0, 1, 2, 3}


def test_segment_without_steps_is_voronoi_diagram(cloud):
    segments = cloud.segment(6, max_iterations=0)
    assert len(segments.energies) == 1
    assert np.array_equal(segments.labels, cloud.farthest_points(6).labels)


def test_samples_and_segments_reject(grid, cloud):
    for function in (
        lambda: grid.segment(0), lambda: grid.segment(-1), lambda: grid.segment(2.5),
        lambda: grid.segment(3, seed=-1), lambda: grid.segment(3, max_iterations=None),
        lambda: grid.segment(3, threads=0), lambda: grid.segment(3, speed=np.ones(3)),
        lambda: grid.farthest_vertices(), lambda: grid.farthest_vertices(radius=-1),
        lambda: grid.farthest_vertices(3, first=[500]), lambda: grid.voronoi_cells([]),
        lambda: grid.voronoi_cells(0, max_distance=math.nan),
    ):
        with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
            function()
    with pytest.raises(gp.UnsupportedSurfaceError, match="mesh"):
        cloud.voronoi_cells(0)


def test_callbacks_cancel_sampling(surface):
    stop = lambda fraction: False
    with pytest.raises(gp.Cancelled):
        surface.farthest_vertices(5, callback=stop)
    with pytest.raises(gp.Cancelled):
        surface.segment(5, callback=stop)
    if not surface.is_cloud:
        with pytest.raises(gp.Cancelled):
            surface.voronoi_cells([0, 60], callback=stop)


def test_method_of_segments_is_used(surface):
    default = surface.segment(5)
    assert np.array_equal(surface.segment(5, method="euclidean").labels, default.labels)
    assert not np.array_equal(surface.segment(5, method="dijkstra").energies, default.energies)
    check_error(lambda: surface.segment(5, method="exact"))
