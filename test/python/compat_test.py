# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules with the interfaces of other packages."""

import inspect
import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import cube_arrays, grid_arrays, prism_arrays, sphere_arrays
from geodesic_processing import compat
from geodesic_processing.compat import gdist, xatlas
from geodesic_processing.compat import potpourri3d as pp3d
from geodesic_processing.compat.pygeodesic import geodesic

ROUND_OFF = 1e-14  # as in distance_test.py
# Paths, maps and curves have round-off errors of some hundred operations.
PATH_ERROR = 1e-12

# All public names of the packages with their parameters; those that are not covered have None.
NAMES = {
    gdist: {
        "compute_gdist":
            "vertices triangles source_indices target_indices max_distance is_one_indexed",
        "local_gdist_matrix": "vertices triangles max_distance is_one_indexed",
        "distance_matrix_of_selected_points":
            "vertices triangles points max_distance is_one_indexed",
    },
    geodesic: {
        "PyGeodesicAlgorithmExact": "points faces",
        "PyGeodesicAlgorithmExact.geodesicDistance": "self sourceIndex targetIndex",
        "PyGeodesicAlgorithmExact.geodesicDistances":
            "self source_indices target_indices max_distance",
        "read_mesh_from_file": "filename",
    },
    xatlas: {
        "Atlas": "",
        "Atlas.add_mesh": "self positions indices normals uvs",
        "Atlas.add_uv_mesh": None,
        "Atlas.generate": "self chart_options pack_options verbose",
        "Atlas.get_mesh": "self mesh_index",
        "Atlas.get_mesh_vertex_assignment": "self mesh_index",
        "Atlas.get_mesh_chart_count": "self mesh_index",
        "Atlas.get_mesh_chart": "self mesh_index chart_index",
        "Atlas.get_utilization": "self atlas_index",
        "Atlas.get_chart_image": None,
        "ChartOptions": "",
        "ChartType": None,
        "PackOptions": "",
        "parametrize": "positions indices normals uvs",
        "export": "path positions indices uvs normals",
    },
    pp3d: {
        "validate_mesh": "V F force_triangular test_indices",
        "validate_points": "V",
        "read_mesh": "filename",
        "read_polygon_mesh": None,
        "write_mesh": "V F filename UV_coords UV_type",
        "read_point_cloud": "filename",
        "write_point_cloud": "V filename",
        "MeshFastMarchingDistanceSolver": "V F",
        "MeshFastMarchingDistanceSolver.compute_distance": "self curves distances sign",
        "MeshMarchingTrianglesSolver": "V F",
        "MeshMarchingTrianglesSolver.marching_triangles": "self u isoval",
        "marching_triangles": "V F u isoval",
        "MeshHeatMethodDistanceSolver": "V F t_coef use_robust",
        "MeshHeatMethodDistanceSolver.compute_distance": "self v_ind",
        "MeshHeatMethodDistanceSolver.compute_distance_multisource": "self v_inds",
        "compute_distance": "V F v_ind",
        "compute_distance_multisource": "V F v_inds",
        "MeshVectorHeatSolver": "V F t_coef use_intrinsic_delaunay",
        "MeshVectorHeatSolver.extend_scalar": "self v_inds values",
        "MeshVectorHeatSolver.get_tangent_frames": "self",
        "MeshVectorHeatSolver.get_connection_laplacian": None,
        "MeshVectorHeatSolver.transport_tangent_vector": None,
        "MeshVectorHeatSolver.transport_tangent_vectors": None,
        "MeshVectorHeatSolver.compute_log_map": "self v_ind strategy",
        "MeshSignedHeatSolver": None,
        "PolygonMeshHeatSolver": "V F t_coef",
        "PolygonMeshHeatSolver.compute_distance": "self v_inds",
        "PolygonMeshHeatSolver.extend_scalar": "self v_inds values",
        "PolygonMeshHeatSolver.get_tangent_frames": None,
        "PolygonMeshHeatSolver.transport_tangent_vectors": None,
        "PolygonMeshHeatSolver.compute_signed_distance": None,
        "EdgeFlipGeodesicSolver": "V F t_coef",
        "EdgeFlipGeodesicSolver.find_geodesic_path":
            "self v_start v_end max_iterations max_relative_length_decrease",
        "EdgeFlipGeodesicSolver.find_geodesic_path_poly":
            "self v_list max_iterations max_relative_length_decrease",
        "EdgeFlipGeodesicSolver.find_geodesic_loop":
            "self v_list max_iterations max_relative_length_decrease",
        "GeodesicTracer": "V F t_coef",
        "GeodesicTracer.trace_geodesic_from_vertex":
            "self start_vert direction_xyz max_iterations",
        "GeodesicTracer.trace_geodesic_from_face":
            "self start_face bary_coords direction_xyz max_iterations",
        "cotan_laplacian": "V F denom_eps",
        "face_areas": "V F",
        "vertex_areas": "V F",
        "edges": "V F",
        "PointCloudHeatSolver": "P t_coef",
        "PointCloudHeatSolver.compute_distance": "self p_ind",
        "PointCloudHeatSolver.compute_distance_multisource": "self p_inds",
        "PointCloudHeatSolver.extend_scalar": "self p_inds values",
        "PointCloudHeatSolver.get_tangent_frames": "self",
        "PointCloudHeatSolver.transport_tangent_vector": None,
        "PointCloudHeatSolver.transport_tangent_vectors": None,
        "PointCloudHeatSolver.compute_log_map": "self p_ind",
        "PointCloudHeatSolver.compute_signed_distance": None,
        "PointCloudLocalTriangulation": None,
    },
}
ATLAS_PROPERTIES = (
    "atlas_count", "mesh_count", "chart_count", "width", "height", "texels_per_unit", "utilization",
)
OPTIONS = {
    "ChartOptions":
        "max_chart_area max_boundary_length normal_deviation_weight roundness_weight "
        "straightness_weight normal_seam_weight texture_seam_weight max_cost max_iterations "
        "use_input_mesh_uvs fix_winding",
    "PackOptions":
        "max_chart_size padding texels_per_unit resolution bilinear blockAlign bruteForce "
        "create_image rotate_charts_to_axis rotate_charts",
}


def resolve(module, name):
    value = module
    for part in name.split("."):
        value = getattr(value, part)
    return value


def euclidean(V, sources):
    """Returns the distances in a convex part of the plane to the nearest of some vertices."""
    return np.linalg.norm(V[:, None] - V[sources], axis=2).min(axis=1)


def is_uncovered(function, name):
    with pytest.raises(NotImplementedError) as caught:
        function()
    return name in str(caught.value)


@pytest.mark.parametrize("module", NAMES)
def test_all_names_are_covered_or_raise(module):
    assert len(compat.__all__) == len(NAMES)
    for name, parameters in NAMES[module].items():
        if parameters is None:
            assert is_uncovered(lambda: resolve(module, name)(None), name)
        else:
            value = resolve(module, name)
            assert value.__doc__, name
            signature = inspect.signature(value)
            assert " ".join(signature.parameters) == parameters, name
    with pytest.raises(AttributeError):
        resolve(module, "no_such_name")


def test_all_attributes_of_atlas_are_covered_or_raise():
    atlas = xatlas.Atlas()
    for name in ATLAS_PROPERTIES[:-1]:
        assert getattr(atlas, name) == 0
    assert is_uncovered(lambda: atlas.chart_image, "Atlas.chart_image")
    assert is_uncovered(lambda: xatlas.Chart(np.empty(0)).type, "Chart.type")
    for name, options in OPTIONS.items():
        for option in options.split():
            setattr(getattr(xatlas, name)(), option, getattr(getattr(xatlas, name), option))
    with pytest.raises(AttributeError):
        xatlas.PackOptions().no_such_option = 1


# gdist


def test_gdist_distances_in_plane_are_euclidean(arrays):
    V, F = arrays
    sources, targets = np.array([0, 60], np.int32), np.array([120, 7], np.int32)
    expected = euclidean(V, sources)
    assert np.abs(gdist.compute_gdist(V, F, sources) - expected).max() <= ROUND_OFF
    found = gdist.compute_gdist(V, F + 1, sources, targets, is_one_indexed=True)
    assert np.abs(found - expected[targets]).max() <= ROUND_OFF
    assert np.abs(gdist.compute_gdist(V, F) - euclidean(V, [0])).max() <= ROUND_OFF
    bounded = gdist.compute_gdist(V, F, sources, max_distance=0.25)
    assert np.array_equal(np.isinf(bounded), expected > 0.25)
    # The distances of these targets are 0.5 sqrt(2) and sqrt(0.29).
    assert np.isinf(gdist.compute_gdist(V, F, sources, targets, 0.6)).tolist() == [True, False]


def test_gdist_matrices_have_distances_of_pairs(arrays):
    sparse = pytest.importorskip("scipy.sparse")
    V, F = arrays
    expected = np.linalg.norm(V[:, None] - V, axis=2)
    matrix = gdist.local_gdist_matrix(V, F)
    assert type(matrix) is sparse.csc_matrix and matrix.nnz == 121 * 120
    assert np.abs(matrix.toarray() - expected).max() <= ROUND_OFF
    # No pair has a distance close to 0.25.
    near = gdist.local_gdist_matrix(V, F + 1, 0.25, True)
    assert near.nnz == np.count_nonzero((expected > 0) & (expected < 0.25))
    assert np.abs((near.toarray() - expected)[near.toarray() > 0]).max() <= ROUND_OFF
    points = np.array([60, 3, 120])
    selected = gdist.distance_matrix_of_selected_points(V, F, points)
    assert selected.shape == (121, 121) and selected.nnz == 6
    block = selected.toarray()[np.ix_(points, points)]
    assert np.abs(block - expected[np.ix_(points, points)]).max() <= ROUND_OFF


# pygeodesic


def test_pygeodesic_path_leads_from_target_to_source(arrays):
    V, F = arrays
    algorithm = geodesic.PyGeodesicAlgorithmExact(V.tolist(), F.tolist())
    length, path = algorithm.geodesicDistance(3, 117)
    assert abs(length - np.linalg.norm(V[3] - V[117])) <= ROUND_OFF
    assert np.abs(path[[0, -1]] - V[[117, 3]]).max() <= ROUND_OFF
    length, path = algorithm.geodesicDistance(5, 5)
    assert length == 0 and np.abs(path - V[5]).max() <= ROUND_OFF


def test_pygeodesic_distances_have_best_sources(arrays):
    V, F = arrays
    algorithm = geodesic.PyGeodesicAlgorithmExact(V, F)
    distances, best = algorithm.geodesicDistances([0, 120], [1, 119, 118])
    assert np.abs(distances - [0.1, 0.1, 0.2]).max() <= ROUND_OFF
    assert best.dtype == np.int32 and best.tolist() == [0, 1, 1]
    distances, best = algorithm.geodesicDistances(max_distance=0.15)
    assert np.abs(distances[[0, 1, 11, 12]] - euclidean(V, [0])[[0, 1, 11, 12]]).max() <= ROUND_OFF
    assert np.array_equal(np.isinf(distances), euclidean(V, [0]) > 0.15)
    assert np.array_equal(best == -1, np.isinf(distances))


def test_pygeodesic_mesh_without_path():
    V, F = grid_arrays(2)
    both = geodesic.PyGeodesicAlgorithmExact(np.concatenate([V, V + 2]), np.concatenate([F, F + 4]))
    length, path = both.geodesicDistance(0, 5)
    assert math.isinf(length) and path.shape == (0, 3)
    with pytest.raises(gp.InvalidArgumentError):
        both.geodesicDistance(0, 8)


def test_pygeodesic_reads_mesh(tmp_path):
    V, F = cube_arrays()
    rows = [f"{len(V)} {len(F)}"] + ["\t".join(map(str, row)) for row in [*V, *F]]
    (tmp_path / "mesh.txt").write_text("\n".join(rows) + "\n")
    points, faces = geodesic.read_mesh_from_file(tmp_path / "mesh.txt")
    assert np.array_equal(points, V) and np.array_equal(faces, F)
    (tmp_path / "mesh.txt").write_text("\n".join(rows[:-1]) + "\n")
    with pytest.raises(ValueError):
        geodesic.read_mesh_from_file(tmp_path / "mesh.txt")


# potpourri3d


def test_potpourri3d_edges_have_order_of_faces():
    V, F = np.zeros((5, 3)), np.array([[0, 1, 2], [0, 2, 3]])
    assert pp3d.edges(V, F).tolist() == [[0, 1], [1, 2], [2, 0], [2, 3], [3, 0]]
    assert pp3d.edges(V, [[0, 1, 2], [2, 1, 3, 4]]).tolist() == [
        [0, 1], [1, 2], [2, 0], [1, 3], [3, 4], [4, 2],
    ]


def test_potpourri3d_validates():
    V, F = grid_arrays(2)
    pp3d.validate_mesh(V, F, True, True)
    for points, faces in (
        (V[:, :2], F), (V, F[:, :2]), (V, F + 1), (V, F - 1), (V, [[0, 1, 2, 3]]),
    ):
        with pytest.raises(ValueError):
            pp3d.validate_mesh(points, faces, True, True)


def test_potpourri3d_areas_and_laplacian(arrays):
    pytest.importorskip("scipy.sparse")
    V, F = arrays
    assert np.abs(pp3d.face_areas(V, F) - 0.005).max() <= ROUND_OFF
    areas = pp3d.vertex_areas(V, F)
    assert abs(areas.sum() - 1) <= PATH_ERROR and abs(areas[60] - 0.01) <= ROUND_OFF
    L = pp3d.cotan_laplacian(V, F)
    assert np.abs(L.sum(axis=1)).max() <= PATH_ERROR and abs(L - L.T).max() <= PATH_ERROR
    # The Dirichlet energy of a function with the unit gradient is the area.
    assert abs(V[:, 0] @ (L @ V[:, 0]) - 1) <= PATH_ERROR
    assert L.diagonal().min() > 0
    damped = pp3d.cotan_laplacian(V, F, denom_eps=0.01)  # twice the area of a triangle is 0.01
    assert abs(damped - L / 2).max() <= PATH_ERROR


@pytest.mark.parametrize("extension", ["obj", "ply"])
def test_potpourri3d_point_cloud_files(tmp_path, extension):
    V = sphere_arrays(2)[0]
    pp3d.write_point_cloud(V, tmp_path / f"cloud.{extension}")
    assert np.array_equal(pp3d.read_point_cloud(tmp_path / f"cloud.{extension}"), V)


def test_potpourri3d_mesh_files(tmp_path):
    V, F = sphere_arrays(1)
    path = tmp_path / "mesh.obj"
    uvs = {"per-vertex": V[:, :2], "per-face": V[F[:, 0], :2], "per-corner": V[F.ravel(), :2]}
    for kind, uv in {None: None, **uvs}.items():
        pp3d.write_mesh(V, F, path, uv, kind)
        points, faces = pp3d.read_mesh(path)
        assert np.array_equal(points, V) and np.array_equal(faces, F)
        lines = [line.split() for line in path.read_text().splitlines()]
        written = np.array([line[1:] for line in lines if line[0] == "vt"], float)
        assert np.array_equal(written, np.empty((0,)) if uv is None else uv)
        with pytest.raises(ValueError):
            pp3d.write_mesh(V, F, path, V[:3, :2], kind or "per-edge")
    assert [word for word in lines[-1]] == ["f", *(
        f"{v + 1}/{c + 1}" for v, c in zip(F[-1], range(3 * len(F) - 3, 3 * len(F)))
    )]
    quads = np.array([[0, 1, 2, 3]])
    pp3d.write_mesh(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]]), quads, path)
    assert is_uncovered(lambda: pp3d.read_mesh(path), "read_mesh")
    assert is_uncovered(lambda: pp3d.write_mesh(V, F, "mesh.stl"), "write_mesh")


def test_potpourri3d_heat_distances(arrays):
    V, F = arrays
    expected = gp.Surface(V, F).distance([0, 60], method="heat")
    solver = pp3d.MeshHeatMethodDistanceSolver(V, F, use_robust=False)
    assert np.array_equal(solver.compute_distance_multisource([0, 60]), expected)
    assert np.array_equal(solver.compute_distance(7), pp3d.compute_distance(V, F, 7))
    assert np.array_equal(pp3d.compute_distance_multisource(V, F, [0, 60]), expected)
    # The error is less than the length of an edge.
    assert np.abs(solver.compute_distance(60) - euclidean(V, [60])).max() <= 0.1
    assert is_uncovered(lambda: pp3d.MeshHeatMethodDistanceSolver(V, F, 2.0), "t_coef")


def test_potpourri3d_polygon_distances():
    V = grid_arrays(3)[0]
    quads = np.array([[0, 3, 4, 1], [1, 4, 5, 2], [3, 6, 7, 4], [4, 7, 8, 5]])
    polygons = [*quads[:3].tolist(), [4, 7, 8], [4, 8, 5]]
    expected = gp.Surface(V, quads).distance([0], method="heat")
    solver = pp3d.PolygonMeshHeatSolver(V, quads)
    assert np.array_equal(solver.compute_distance([0]), expected)
    mixed = pp3d.PolygonMeshHeatSolver(V, polygons)
    # The error is less than the length of an edge.
    assert np.abs(mixed.compute_distance([0]) - euclidean(V, [0])).max() <= 0.5
    assert mixed.extend_scalar([0, 8], [3, 4])[[0, 1, 7, 8]].tolist() == [3, 3, 4, 4]


def test_potpourri3d_fast_marching_from_barycentric_points(arrays):
    V, F = arrays
    solver = pp3d.MeshFastMarchingDistanceSolver(V, F)
    assert solver.compute_distance([[(60,)]])[61] == pytest.approx(0.1, abs=ROUND_OFF)
    edge = 17
    a, b = pp3d.edges(V, F)[edge]
    length = np.linalg.norm(V[a] - V[b])
    found = solver.compute_distance([[(int(a), [])], [(edge, [0.25])]], [[1.0], [2.0]])
    assert found[a] == 1 and abs(found[b] - min(2 + 0.75 * length, 1 + length)) <= ROUND_OFF
    found = solver.compute_distance([[(edge, [0.25])]])
    assert np.abs(found[[a, b]] - [0.25 * length, 0.75 * length]).max() <= ROUND_OFF
    for coordinates in ([0.5, 0.25], [0.5, 0.25, 0.25]):
        found = solver.compute_distance([[(31, coordinates)]])
        point = np.array([0.5, 0.25, 0.25]) @ V[F[31]]
        assert np.abs(found - np.linalg.norm(V - point, axis=1))[F[31]].max() <= ROUND_OFF
    assert is_uncovered(lambda: solver.compute_distance([[(0,)]], sign=True), "sign")


def positions(V, F, points):
    """Returns the positions of barycentric points of vertices and edges."""
    E = pp3d.edges(V, F)
    return np.array([
        (1 - p[1][0]) * V[E[p[0], 0]] + p[1][0] * V[E[p[0], 1]] if p[1] else V[p[0]]
        for p in points
    ])


def test_potpourri3d_isolines_have_smaller_values_on_left():
    V, F = sphere_arrays(3)
    (line,) = pp3d.marching_triangles(V, F, V[:, 2], 0.3)
    points = positions(V, F, line)
    assert np.abs(points[:, 2] - 0.3).max() <= ROUND_OFF
    assert line[0] == line[-1] and all(len(point[1]) == 1 for point in line)
    left = np.cross(points[:-1], np.diff(points, axis=0))
    assert left[:, 2].max() < 0


def test_potpourri3d_isoline_through_vertices(arrays):
    V, F = arrays
    (line,) = pp3d.MeshMarchingTrianglesSolver(V, F).marching_triangles(V[:, :1], V[60, 0])
    assert sorted(line) == [(v, []) for v in range(55, 66)]


def test_potpourri3d_tangent_frames_of_sphere():
    V, F = sphere_arrays(3)
    frames = np.stack(pp3d.MeshVectorHeatSolver(V, F).get_tangent_frames(), axis=1)
    assert np.abs(frames @ frames.transpose(0, 2, 1) - np.eye(3)).max() <= ROUND_OFF
    assert np.abs(np.cross(frames[:, 0], frames[:, 1]) - frames[:, 2]).max() <= ROUND_OFF
    # A normal is a mean of normals of faces, whose angles to it are less than the longest edge.
    longest = np.linalg.norm(V[F] - np.roll(V[F], 1, axis=1), axis=2).max()
    assert np.linalg.norm(frames[:, 2] - V, axis=1).max() <= longest
    assert np.abs(frames[0, 2] - [1, 0, 0]).max() <= ROUND_OFF  # by symmetry


@pytest.mark.parametrize("strategy", ["VectorHeat", "AffineLocal", "AffineAdaptive"])
def test_potpourri3d_log_map_of_plane_is_difference(arrays, strategy):
    V, F = arrays
    solver = pp3d.MeshVectorHeatSolver(V, F)
    uv = solver.compute_log_map(60, strategy=strategy)
    x, y, _ = solver.get_tangent_frames()
    assert np.abs(uv[:, :1] * x[60] + uv[:, 1:] * y[60] - (V - V[60])).max() <= PATH_ERROR


def test_potpourri3d_log_map_of_flat_cloud_is_difference(arrays):
    V = arrays[0]
    solver = pp3d.PointCloudHeatSolver(V)
    uv = solver.compute_log_map(60)
    x, y, normal = solver.get_tangent_frames()
    assert np.abs(np.abs(normal) - [0, 0, 1]).max() <= PATH_ERROR
    assert np.abs(uv[:, :1] * x[60] + uv[:, 1:] * y[60] - (V - V[60])).max() <= PATH_ERROR


def test_potpourri3d_cloud_distances(arrays):
    V = arrays[0]
    solver = pp3d.PointCloudHeatSolver(V)
    expected = gp.Surface(V).distance([0, 60], method="heat")
    assert np.array_equal(solver.compute_distance_multisource([0, 60]), expected)
    assert np.array_equal(solver.compute_distance(0), gp.Surface(V).distance(0, method="heat"))
    assert solver.extend_scalar([0, 120], [1.5, 2.5])[[1, 119]].tolist() == [1.5, 2.5]


def test_potpourri3d_extends_values_of_nearest_sources():
    V, F = grid_arrays(3)
    V, F = np.concatenate([V, V + 5]), np.concatenate([F, F + 9])
    found = pp3d.MeshVectorHeatSolver(V, F).extend_scalar([0, 8], [1.0, -2.0])
    assert found[[0, 1, 3, 5, 7, 8]].tolist() == [1, 1, 1, -2, -2, -2]
    assert np.isnan(found[9:]).all()  # not reached
    with pytest.raises(ValueError):
        pp3d.MeshVectorHeatSolver(V, F).extend_scalar([0, 8], [1.0])


def test_potpourri3d_paths_are_straight_in_plane(arrays):
    V, F = arrays
    solver = pp3d.EdgeFlipGeodesicSolver(V, F)
    bent = solver.find_geodesic_path_poly([3, 60, 11, 117])
    for path in (solver.find_geodesic_path(3, 117), bent):
        assert np.abs(path[[0, -1]] - V[[3, 117]]).max() <= ROUND_OFF
        assert np.abs(np.cross(path - V[3], V[117] - V[3])).max() <= PATH_ERROR
        assert abs(length_of(path) - np.linalg.norm(V[117] - V[3])) <= PATH_ERROR
    assert is_uncovered(lambda: solver.find_geodesic_path(3, 117, 5), "max_iterations")
    name = "max_relative_length_decrease"
    assert is_uncovered(lambda: solver.find_geodesic_path(3, 117, None, 0.5), name)
    for vertices in ([3, 3], [3, 60, 60]):
        with pytest.raises(RuntimeError):
            solver.find_geodesic_path_poly(vertices)


def length_of(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def test_potpourri3d_loops_are_shortest():
    k = 8
    solver = pp3d.EdgeFlipGeodesicSolver(*prism_arrays(k, 3))
    loop = solver.find_geodesic_loop([0, k + 3, 6])
    assert abs(length_of(loop) - 2 * k * math.sin(math.pi / k)) <= PATH_ERROR
    assert np.array_equal(loop[0], loop[-1])
    assert solver.find_geodesic_loop([0, 1, k + 1]).shape == (1, 3)  # contractible


def test_potpourri3d_contractible_loop_ends_around_neck():
    k, radii = 8, [1, 0.8, 0.5, 0.8, 1]
    V, F = prism_arrays(k, len(radii))
    V *= np.column_stack([np.repeat(radii, k)] * 2 + [np.full(len(V), 4.0)])
    # A pole at each end closes the surface, so that all loops are contractible.
    bottom, top = len(V), len(V) + 1
    V = np.concatenate([V, [[0, 0, -1], [0, 0, 5]]])
    i = np.arange(k)
    j, last = (i + 1) % k, 4 * k
    caps = [np.stack([j, i, np.full(k, bottom)], 1), np.stack([i, j, top - last + 0 * i], 1) + last]
    solver = pp3d.EdgeFlipGeodesicSolver(V, np.concatenate([F, *caps]))
    loop = solver.find_geodesic_loop([k + 1, k + 4, k + 7])
    assert abs(length_of(loop) - k * math.sin(math.pi / k)) <= PATH_ERROR
    assert np.abs(loop[:, 2] - 2).max() <= 1e-6  # the square root of the error of the length
    assert np.abs(loop[0] - loop[-1]).max() <= ROUND_OFF
    assert solver.find_geodesic_loop([0, 1, k + 1]).shape == (1, 3)
    assert solver.find_geodesic_loop([0, 1]).shape == (1, 3)


def test_potpourri3d_unconnected_vertices_have_no_path():
    V, F = grid_arrays(2)
    solver = pp3d.EdgeFlipGeodesicSolver(np.concatenate([V, V + 2]), np.concatenate([F, F + 4]))
    for function in (
        lambda: solver.find_geodesic_path(0, 5),
        lambda: solver.find_geodesic_path_poly([0, 5]),
        lambda: solver.find_geodesic_loop([0, 5]),
    ):
        with pytest.raises(RuntimeError):
            function()


def test_potpourri3d_traces_projected_vector(arrays):
    V, F = arrays
    tracer = pp3d.GeodesicTracer(V, F)
    vector = np.array([0.3, -0.17, 9.0])
    path = tracer.trace_geodesic_from_vertex(60, vector)
    assert np.abs(path[-1] - V[60] - [0.3, -0.17, 0]).max() <= PATH_ERROR
    # One point in each of the first two faces, and the beginning.
    assert np.array_equal(tracer.trace_geodesic_from_vertex(60, vector, 1), path[:3])
    start = V[F[31]].mean(axis=0)
    path = tracer.trace_geodesic_from_face(31, [1 / 3] * 3, [0.1, 0.2, 1.0], max_iterations=100)
    assert np.abs(path[[0, -1]] - [start, start + [0.1, 0.2, 0]]).max() <= PATH_ERROR


def test_potpourri3d_repaired_faces_are_not_covered():
    V, F = grid_arrays(3)
    for solver in (
        pp3d.MeshFastMarchingDistanceSolver, pp3d.MeshMarchingTrianglesSolver, pp3d.GeodesicTracer,
    ):
        assert is_uncovered(lambda: solver(V, np.concatenate([F, F[:1]])), "repaired")


# xatlas


def signed_areas(uv):
    a, b, c = uv.transpose(1, 0, 2).astype(float)
    return 0.5 * np.cross(b - a, c - a)


def test_xatlas_repeats_vertices_on_cuts():
    V, F = sphere_arrays(3)
    vmapping, indices, uvs = xatlas.parametrize(V, F, normals=V, uvs=V[:, :2])
    assert (vmapping.dtype, indices.dtype, uvs.dtype) == (np.uint32, np.uint32, np.float32)
    assert np.array_equal(vmapping[indices], F)
    assert uvs.shape == (len(vmapping), 2) and len(vmapping) > len(V)
    assert uvs.min() >= 0 and uvs.max() <= 1
    assert signed_areas(uvs[indices]).min() > 0
    pairs = np.column_stack([vmapping, uvs])
    assert len(np.unique(pairs, axis=0)) == len(pairs)


def test_xatlas_packs_several_meshes():
    sphere, cube = sphere_arrays(2), cube_arrays()
    atlas = xatlas.Atlas()
    for V, F in (sphere, cube):
        atlas.add_mesh(V, F)
    options = xatlas.PackOptions()
    options.resolution, options.padding = 256, 8
    atlas.generate(pack_options=options)
    assert len(atlas) == atlas.mesh_count == 2 and atlas.atlas_count == 1
    assert atlas.width == atlas.height == 256
    count = [atlas.get_mesh_chart_count(mesh) for mesh in range(2)]
    assert sum(count) == atlas.chart_count and min(count) > 0
    corners = []
    for mesh, (V, F) in enumerate((sphere, cube)):
        vmapping, indices, uvs = atlas[mesh]
        assert np.array_equal(vmapping[indices], F)
        corners.append(uvs[indices])
        charts = [atlas.get_mesh_chart(mesh, chart).faces for chart in range(count[mesh])]
        assert sorted(np.concatenate(charts)) == list(range(len(F)))
        atlas_index, chart_index = atlas.get_mesh_vertex_assignment(mesh)
        assert not atlas_index.any() and atlas_index.shape == vmapping.shape
        for faces in charts:
            assert len(np.unique(chart_index[indices[faces]])) == 1
    area = signed_areas(np.concatenate(corners)).sum()
    assert atlas.utilization == atlas.get_utilization(0) <= 1
    # Coordinates are rounded to float32.
    assert abs(atlas.utilization - area) <= 1e-6
    for function in (lambda: atlas.generate(), lambda: atlas.add_mesh(*cube)):
        with pytest.raises(RuntimeError):
            function()
    assert atlas.mesh_count == 2
    for function in (
        lambda: atlas[2],
        lambda: atlas.get_mesh_chart(0, count[0]),
        lambda: atlas.get_utilization(1),
    ):
        with pytest.raises(IndexError):
            function()


def test_xatlas_ignores_seams_of_input():
    V, F = sphere_arrays(2)
    unwelded = np.arange(3 * len(F)).reshape(-1, 3)
    whole, split = xatlas.Atlas(), xatlas.Atlas()
    whole.add_mesh(V, F)
    split.add_mesh(V[F.ravel()], unwelded)
    for atlas in (whole, split):
        atlas.generate()
    assert split.chart_count == whole.chart_count
    vmapping, indices, _ = split[0]
    assert np.array_equal(vmapping[indices], unwelded)


def test_xatlas_keeps_repaired_faces():
    V, F = grid_arrays(4)
    repeated, degenerate = F[5, [1, 2, 0]], [3, 3, 7]
    faces = np.concatenate([[degenerate], F, [repeated]])
    vmapping, indices, uvs = xatlas.parametrize(V, faces)
    assert np.array_equal(vmapping[indices], faces)
    assert (uvs[indices[0]] == 0).all()
    assert signed_areas(uvs[indices[1:-1]]).min() > 0
    assert sorted(indices[-1]) == sorted(indices[6])


def test_xatlas_packs_both_sides_of_sheets():
    V, F = grid_arrays(3)
    faces = np.concatenate([F, F[:, [0, 2, 1]], F[:1, [1, 0, 2]]])
    atlas = xatlas.Atlas()
    atlas.add_mesh(V, faces)
    atlas.generate()
    vmapping, indices, uvs = atlas[0]
    assert np.array_equal(vmapping[indices], faces)
    areas = signed_areas(uvs[indices])
    assert areas.min() > 0
    # The last face is repeated. Coordinates are rounded to float32.
    assert abs(areas[:-1].sum() - atlas.utilization) <= 1e-6


def test_xatlas_options_that_are_not_covered():
    atlas = xatlas.Atlas()
    chart_options, pack_options = xatlas.ChartOptions(), xatlas.PackOptions()
    chart_options.fix_winding = pack_options.bruteForce = True
    atlas.generate(chart_options, pack_options)
    chart_options.max_cost = 3.0
    assert is_uncovered(lambda: atlas.generate(chart_options), "ChartOptions.max_cost")
    pack_options.create_image = True
    assert is_uncovered(lambda: atlas.generate(None, pack_options), "PackOptions.create_image")
    assert is_uncovered(lambda: atlas.generate(verbose=True), "verbose")


@pytest.mark.parametrize("has_uvs", [False, True])
@pytest.mark.parametrize("has_normals", [False, True])
def test_xatlas_exports_obj(tmp_path, has_uvs, has_normals):
    V, F = sphere_arrays(1)
    path = tmp_path / "mesh.obj"
    xatlas.export(path, V, F, V[:, :2] if has_uvs else None, V if has_normals else None)
    surface = gp.read(path)
    assert np.array_equal(surface.vertices, V) and np.array_equal(surface.faces, F)
    words = [line.split()[0] for line in path.read_text().splitlines()]
    counts = [words.count(word) for word in ("v", "vt", "vn", "f")]
    assert counts == [len(V), has_uvs * len(V), has_normals * len(V), len(F)]
