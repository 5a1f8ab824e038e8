# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays

# Distances of a planar grid of side 1 have a few operations, each with a relative error of 1e-16.
ROUND_OFF = 1e-14


def straight(V, source):
    return np.linalg.norm(V - V[source], axis=1)


@pytest.mark.parametrize("method", ["auto", "exact", "euclidean"])
def test_distance_on_planar_mesh_is_straight(grid, arrays, method):
    for source in (0, 37):
        distance = grid.distance(source, method=method)
        assert np.abs(distance - straight(arrays[0], source)).max() <= ROUND_OFF


def test_distance_by_dijkstra_is_length_along_edges(grid, arrays):
    # The diagonals of the squares go from (i, j) to (i + 1, j + 1).
    steps = np.rint(arrays[0][:, :2] * 10)
    diagonal = steps.min(axis=1)
    expected = (math.sqrt(2) * diagonal + steps.max(axis=1) - diagonal) / 10
    assert np.abs(grid.distance(0, method="dijkstra") - expected).max() <= ROUND_OFF


@pytest.mark.parametrize("method", ["fast-marching", "heat"])
def test_approximate_distance_is_near_exact_distance(grid, arrays, method):
    # The error of both methods is of first order: less than one edge.
    assert np.abs(grid.distance(0, method=method) - straight(arrays[0], 0)).max() < 0.1


def test_distance_on_cloud_is_near_straight_distance(cloud, arrays):
    # The local triangles of surfels in a plane are in this plane, so errors are of second order.
    distance = cloud.distance(0)
    assert np.abs(distance - straight(arrays[0], 0)).max() < 0.01
    assert distance[0] == 0


def test_sources_are_vertices_and_locations(grid, arrays):
    expected = np.minimum(straight(arrays[0], 0), straight(arrays[0], 120))
    row = grid.locate(arrays[0][[120]])[0]
    locations = grid.locate(arrays[0][[0, 120]])
    ranges = ([0, 120], (0, 120), np.array([0, 120], np.uint8), [0, row], locations, iter([0, 120]))
    for sources in ranges:
        assert np.abs(grid.distance(sources) - expected).max() <= ROUND_OFF
    inside = grid.distance((0, [0.5, 0.25, 0.25]))
    point = grid.points([(0, [0.5, 0.25, 0.25])])[0]
    assert np.abs(inside - np.linalg.norm(arrays[0] - point, axis=1)).max() <= ROUND_OFF


def test_polyline_is_source(grid, arrays):
    V = arrays[0]
    line = gp.Polyline(*vars(grid.locate([[x, 0.25, 0] for x in np.linspace(0, 1, 41)])).values())
    expected = np.abs(V[:, 1] - 0.25)
    assert np.abs(grid.distance(line) - expected).max() <= ROUND_OFF
    expected = np.minimum(expected + 0.1, straight(V, 120))
    distance = grid.distance([line, 120], offsets=[0.1, 0])
    assert np.abs(distance - expected).max() <= ROUND_OFF
    solver = grid.solver().compute([120, line])
    assert set(solver.labels) == {0, 1}
    with pytest.raises(gp.InvalidArgumentError, match="common triangle"):
        grid.distance(gp.Polyline(line.indices[::9], line.coordinates[::9]))
    for no_source in (gp.Polyline(line.indices[:0], line.coordinates[:0]), [line, [line]]):
        with pytest.raises(gp.InvalidArgumentError):
            grid.distance(no_source)


def test_path_is_polyline(grid):
    path = grid.path(0, 60)
    distance = grid.distance(gp.Polyline(path.faces, path.barycentric))
    assert np.abs(distance[[0, 12, 24, 60]]).max() <= ROUND_OFF


def test_boundary_is_source(grid, arrays):
    (border,) = grid.border_sources()
    assert len(border) == 41 and border[0] == border[-1]
    V = arrays[0][:, :2]
    to_border = np.minimum(V, 1 - V).min(axis=1)
    for sources in (border, [border], grid.border_sources()):
        assert np.abs(grid.distance(sources) - to_border).max() <= ROUND_OFF
    assert set(grid.voronoi([border, 60]).labels) == {0, 1}
    V, F = grid_arrays(3)
    assert len(gp.Surface(np.concatenate([V, V + 2]), np.concatenate([F, F + 9])).border_sources()) == 2


def test_polyline_on_cloud(cloud, arrays):
    # The triangles of surfels in a plane are in this plane: errors are of second order.
    a, b = cloud.locate([[0.5, 0.5, 0], [0.55, 0.5, 0]])
    line = gp.Polyline(np.array([a.surfel, b.surfel]), np.array([a.offset, b.offset]))
    assert np.abs(cloud.distance(line)[60]) <= ROUND_OFF
    with pytest.raises(gp.UnsupportedSurfaceError):
        cloud.border_sources()


def test_offsets_are_distances_of_sources(grid, arrays):
    V = arrays[0]
    expected = np.minimum(straight(V, 0) + 0.3, straight(V, 120) - 0.1)
    distance = grid.distance([0, 120], offsets=[0.3, -0.1])
    assert np.abs(distance - expected).max() <= ROUND_OFF


def test_maximum_distance_limits_reached_vertices(surface):
    complete = surface.distance(0)
    limited = surface.distance(0, max_distance=0.55)
    is_near = complete <= 0.55
    assert np.array_equal(np.isfinite(limited), is_near)
    # On a cloud, the front can correct final distances by a few percent.
    assert np.abs(limited[is_near] - complete[is_near]).max() <= 0.05 * 0.55


def test_targets_have_final_distances(grid, arrays):
    for targets in (5, [5, 27], grid.locate(arrays[0][[5, 27]])):
        distance = grid.distance(0, targets=targets)
        assert abs(distance[5] - straight(arrays[0], 0)[5]) <= ROUND_OFF


def test_speed_divides_distances(surface, arrays):
    complete = surface.distance(0)
    halved = surface.distance(0, speed=np.full(len(arrays[0]), 2.0))
    assert np.abs(halved - complete / 2).max() <= ROUND_OFF


def test_faces_of_speed_zero_are_obstacles(grid, arrays):
    speed = np.ones(grid.number_of_faces)
    centroids = arrays[0][arrays[1]].mean(axis=1)
    speed[(centroids[:, 0] > 0.4) & (centroids[:, 0] < 0.5)] = 0
    distance = grid.distance(0, face_speed=speed)
    # The strip of obstacles from y = 0 to y = 1 leaves only its boundary, which is connected with
    # one side.
    assert np.isfinite(distance[arrays[0][:, 0] < 0.45]).all()
    assert np.isinf(distance[arrays[0][:, 0] > 0.45]).all()


def test_unreached_component_is_infinite():
    V, F = grid_arrays(4)
    both = gp.Surface(np.concatenate([V, V + [3, 0, 0]]), np.concatenate([F, F + len(V)]))
    distance = both.distance(0)
    assert np.isfinite(distance[:16]).all() and np.isinf(distance[16:]).all()
    path = both.path(0, 20)
    assert path.points.shape == (0, 3) and path.length == math.inf


@pytest.mark.parametrize("scale", [1e-150, 1e-8, 1.0, 1e8, 1e150])
def test_distance_scales(arrays, scale):
    V, F = arrays
    distance = gp.Surface(V * scale, F).distance(37)
    assert np.abs(distance / scale - straight(V, 37)).max() <= ROUND_OFF


def test_out_receives_result(grid):
    expected = grid.distance(0)
    out = np.full((121, 3), -1.0)
    column = out[:, 1]
    assert grid.distance(0, out=column) is column
    assert np.array_equal(column, expected)
    assert (out[:, [0, 2]] == -1).all()
    reversed_out = np.empty(121)[::-1]
    assert np.array_equal(grid.solver().compute(0).distance(out=reversed_out), expected)


def test_arrays_are_read_with_any_strides_and_types(arrays):
    V, F = arrays
    expected = gp.Surface(V, F).distance(5)
    padded = np.full((len(V), 7), np.nan)
    padded[:, 1:6:2] = V
    unaligned = np.frombuffer(b"x" + V.tobytes(), np.uint8)[1:].view(np.float64).reshape(V.shape)
    fortran, swapped = np.asfortranarray(V), V.astype(">f8")
    for points in (padded[:, 1:6:2], fortran, V[::-1][::-1], swapped, unaligned, V.tolist()):
        assert np.array_equal(gp.Surface(points, F).distance(5), expected)
    for kind in ("i1", "u1", "i4", "i8", "u4", "u8", ">i4"):
        assert np.array_equal(gp.Surface(V, F.astype(kind)).distance(5), expected)
    assert np.array_equal(gp.Surface(V, np.asfortranarray(F)).distance(5), expected)
    single = gp.Surface(V.astype(np.float32), F).distance(5)
    assert np.array_equal(single, gp.Surface(V.astype(np.float32).astype(float), F).distance(5))


def test_input_is_unchanged(arrays):
    V, F = arrays
    V.flags.writeable = F.flags.writeable = False
    before = V.copy(), F.copy()
    gp.Surface(V, F).distance(0)
    assert np.array_equal(V, before[0]) and np.array_equal(F, before[1])


def test_soup_is_repaired(arrays):
    V, F = arrays
    G = F.copy()
    G[0] = G[0, ::-1]
    surface = gp.Surface(V, np.concatenate([G, G[5:6]]))
    assert surface.report.number_of_reversed_triangles == 1
    assert surface.report.number_of_duplicate_triangles == 1
    assert surface.report.number_of_components == 1 and surface.report.genus == 0
    assert surface.number_of_faces == len(F) and surface.faces.shape == F.shape
    assert np.array_equal(surface.distance(0), gp.Surface(V, F).distance(0))


def test_polygons_are_triangulated(arrays):
    n = 11
    i = np.arange((n - 1) * n).reshape(n - 1, n)[:, :-1].ravel()
    surface = gp.Surface(arrays[0], np.stack([i, i + n, i + n + 1, i + 1], axis=1))
    assert surface.report.number_of_triangulated_polygons == 100
    assert np.abs(surface.distance(0) - straight(arrays[0], 0)).max() <= ROUND_OFF


def test_points_are_merged(arrays):
    V, F = arrays
    corners = V[F].reshape(-1, 3)
    separate = gp.Surface(corners, np.arange(3 * len(F)).reshape(-1, 3), merge_tolerance=0)
    assert separate.report.number_of_merged_points == 3 * len(F) - len(V)
    source = int(np.flatnonzero((corners == 0).all(axis=1))[0])
    expected = np.linalg.norm(corners, axis=1)
    assert np.abs(separate.distance(source) - expected).max() <= ROUND_OFF


def test_normals_of_cloud_are_estimated(cloud, arrays):
    estimated = gp.Surface(arrays[0])
    # Normals of points in a plane are exact up to round-off errors of quadrics.
    assert np.abs(estimated.distance(0) - cloud.distance(0)).max() < 1e-9


def test_radii_of_cloud_are_used(arrays):
    V = arrays[0]
    normals = np.tile([0.0, 0.0, 1.0], (len(V), 1))
    # Disks that are smaller than half of the spacing do not overlap.
    assert np.isinf(gp.Surface(V, normals=normals, radii=np.full(121, 1e-3)).distance(0)[1:]).all()


def test_files_are_read(tmp_path, arrays):
    V, F = arrays
    mesh = tmp_path / "grid.off"
    lines = ["OFF", f"{len(V)} {len(F)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in V]
    lines += ["3 " + " ".join(str(i) for i in f) for f in F]
    mesh.write_text("\n".join(lines) + "\n")
    assert np.array_equal(gp.read(mesh).distance(0), gp.Surface(V, F).distance(0))
    points = tmp_path / "grid.xyz"
    points.write_text("".join(" ".join(repr(float(x)) for x in p) + "\n" for p in V))
    assert gp.read(str(points)).is_cloud
    assert np.array_equal(gp.read(points).distance(0), gp.Surface(V).distance(0))
