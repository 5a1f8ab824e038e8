# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances, paths and logarithmic maps with the interface of potpourri3d 1.4.

Differences
-----------
- Meshes need not be manifold. Vertices that no source reaches are infinitely far; their extended
  values are NaN.
- ``use_robust`` and ``use_intrinsic_delaunay`` have no effect. ``t_coef`` must be 1.
- ``extend_scalar()`` returns the values of the nearest sources, without smoothing.
- ``MeshVectorHeatSolver.compute_log_map()`` is exact with all strategies. Tangent frames of a mesh
  begin at the first edge of the last face of a vertex.
- ``PolygonMeshHeatSolver`` triangulates polygons.
- ``EdgeFlipGeodesicSolver`` begins with shortest paths between consecutive vertices, not with
  shortest edge paths. The path between two vertices is therefore a shortest path. The limits
  ``max_iterations`` and ``max_relative_length_decrease`` are not covered.
- ``GeodesicTracer`` projects directions at a vertex to the face that contains the projection.
- ``read_mesh()`` raises ``NotImplementedError`` for faces that are repaired or triangulated by
  ``read()``. ``write_mesh()`` writes OBJ files, ``write_point_cloud()`` also PLY files.
- Not covered: ``MeshSignedHeatSolver``, ``PointCloudLocalTriangulation``, ``read_polygon_mesh()``,
  transport of tangent vectors, the connection Laplacian, and signed distances.

Tests of potpourri3d pass, with the following exceptions.

- ``test_write_read_mesh``: reads random triangles, which are repaired
- ``test_mesh_vector_heat``: uses the connection Laplacian and transports vectors
- ``test_point_cloud_vector_heat``: extends values to random points of a cube, of which some are
  not reached, and transports vectors
- ``test_mesh_flip_geodesic``: limits the number of iterations
- ``test_point_cloud_local_triangulation``: uses ``PointCloudLocalTriangulation``
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from typing import Any, Union, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _core
from .._distances import Path, Solver
from .._surface import Surface, read
from .._types import Floats, Integers, Locations
from ._common import missing_method, missing_names, not_covered, require_default, scipy_sparse

__all__ = [
    "EdgeFlipGeodesicSolver",
    "GeodesicTracer",
    "MeshFastMarchingDistanceSolver",
    "MeshHeatMethodDistanceSolver",
    "MeshMarchingTrianglesSolver",
    "MeshVectorHeatSolver",
    "PointCloudHeatSolver",
    "PolygonMeshHeatSolver",
    "compute_distance",
    "compute_distance_multisource",
    "cotan_laplacian",
    "edges",
    "face_areas",
    "marching_triangles",
    "read_mesh",
    "read_point_cloud",
    "validate_mesh",
    "validate_points",
    "vertex_areas",
    "write_mesh",
    "write_point_cloud",
]

__getattr__ = missing_names(
    __name__, "MeshSignedHeatSolver", "PointCloudLocalTriangulation", "read_polygon_mesh"
)

BarycentricPoint = Union[tuple[int], tuple[int, Sequence[float]]]
"""A vertex ``(v,)`` or ``(v, [])``, a point ``(e, [t])`` of an edge at the fraction t from its
first vertex, or a point ``(f, [a, b])`` or ``(f, [a, b, c])`` of a face."""
Frames = tuple[Floats, Floats, Floats]
"""The first axes, the second axes and the normals, each of the shape (n, 3)."""
Polygons = Union[NDArray[np.integer[Any]], Sequence[Sequence[int]]]


# Arrays


def validate_points(V: NDArray[Any]) -> None:
    """Raises ``ValueError`` if an array does not have the shape (n, 3)."""
    if V.ndim != 2 or V.shape[1] != 3:
        raise ValueError(f"The points have the shape {V.shape}, but their shape must be (n, 3).")


def validate_mesh(
    V: NDArray[Any], F: Polygons, force_triangular: bool = False, test_indices: bool = False
) -> None:
    """Raises ``ValueError`` if arrays are no mesh.

    Parameters
    ----------
    V
        Shape (n, 3): the points.
    F
        Shape (m, k): the faces; or a list of polygons.
    force_triangular
        Whether all faces must be triangles.
    test_indices
        Whether all corners must be rows of ``V``.
    """
    validate_points(V)
    sizes = {F.shape[1]} if isinstance(F, np.ndarray) and F.ndim == 2 else {len(f) for f in F}
    if min(sizes, default=3) < 3:
        raise ValueError("A face has fewer than three corners.")
    if force_triangular and sizes - {3}:
        raise ValueError("A face is not a triangle.")
    corners = np.concatenate([np.empty(0, np.int64), *F])
    if test_indices and len(corners) > 0 and not (0 <= corners.min() <= corners.max() < len(V)):
        raise ValueError("A corner of a face is not a row of the points.")


def edges(V: NDArray[Any], F: Polygons) -> Integers:
    """Returns the edges of a mesh, shape (e, 2): the indices of their vertices.

    An edge has the orientation of its first face. Edges are ordered by their first faces.
    """
    validate_mesh(V, F)
    return _edges(F)[0]


def _edges(F: Polygons) -> tuple[Integers, Integers]:
    """Returns the edges, and the edge that begins at each corner of all faces."""
    tails = np.concatenate([np.asarray(face) for face in F])
    tips = np.concatenate([np.roll(face, -1) for face in F])
    ends = np.sort(np.column_stack([tails, tips]), axis=1)
    _, first, label = np.unique(ends, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    first = first[order]
    return np.column_stack([tails[first], tips[first]]), np.argsort(order)[label.ravel()]


def face_areas(V: NDArray[Any], F: NDArray[Any]) -> Floats:
    """Returns the areas of triangles, shape (m,)."""
    validate_mesh(V, F, force_triangular=True)
    return _double_areas(V, F) / 2


def vertex_areas(V: NDArray[Any], F: NDArray[Any]) -> Floats:
    """Returns a third of the area of the incident triangles of each vertex, shape (n,)."""
    areas = np.zeros(len(V))
    np.add.at(areas, F, face_areas(V, F)[:, None] / 3)
    return areas


def cotan_laplacian(V: NDArray[Any], F: NDArray[Any], denom_eps: float = 0.0) -> Any:
    """Returns the cotangent Laplacian, which is positive semidefinite.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the triangles, shape (m, 3).
    denom_eps
        It is added to twice the area of each triangle, by which the cotangents are divided.

    Returns
    -------
    A ``scipy.sparse.csr_matrix`` of the shape (n, n). Its rows sum to zero.
    """
    validate_mesh(V, F, force_triangular=True)
    denominators = _double_areas(V, F) + denom_eps
    from_corner, to_corner, weights = [], [], []
    for i in range(3):  # the edge opposite to the corner i
        a, b, c = F[:, i], F[:, (i + 1) % 3], F[:, (i + 2) % 3]
        dot = np.einsum("ij,ij->i", V[b] - V[a], V[c] - V[a])
        from_corner += [b, c]
        to_corner += [c, b]
        weights += [dot / denominators / 2] * 2
    sparse = scipy_sparse()
    pairs = (np.concatenate(from_corner), np.concatenate(to_corner))
    adjacency = sparse.coo_matrix((np.concatenate(weights), pairs), shape=(len(V), len(V))).tocsr()
    return (sparse.diags(np.asarray(adjacency.sum(axis=1)).ravel()) - adjacency).tocsr()


def _double_areas(V: NDArray[Any], F: NDArray[Any]) -> Floats:
    a, b, c = V[F].transpose(1, 0, 2)
    double_areas: Floats = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return double_areas


# Files


def read_mesh(filename: str | os.PathLike[str]) -> tuple[Floats, Integers]:
    """Reads the points, shape (n, 3), and the triangles, shape (m, 3), of a mesh.

    The formats are those of ``read()``. If faces of the file have to be repaired or triangulated,
    ``NotImplementedError`` is raised.
    """
    surface = read(filename)
    if surface.is_cloud:
        raise ValueError(f"{os.fspath(filename)} has no faces.")
    report = surface.report
    if (
        report.number_of_triangulated_polygons > 0
        or report.number_of_degenerate_faces > 0
        or report.number_of_duplicate_triangles > 0
        or report.number_of_reversed_triangles > 0
    ):
        raise not_covered("read_mesh() of faces that are not an oriented triangle mesh")
    return surface.vertices, surface.faces


def read_point_cloud(filename: str | os.PathLike[str]) -> Floats:
    """Reads points, shape (n, 3). The formats are those of ``read()``; faces are ignored."""
    return read(filename).vertices


def write_mesh(
    V: NDArray[Any],
    F: NDArray[Any],
    filename: str | os.PathLike[str],
    UV_coords: NDArray[Any] | None = None,
    UV_type: str | None = None,
) -> None:
    """Writes a mesh to an OBJ file.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the faces, shape (m, k).
    filename
        A name with the extension obj.
    UV_coords
        Texture coordinates: shape (n, 2), (m, 2) or (m k, 2).
    UV_type
        Their elements: ``"per-vertex"``, ``"per-face"`` or ``"per-corner"``. By default, no
        texture coordinates are written.
    """
    validate_mesh(V, F, test_indices=True)
    if _extension(filename) != ".obj":
        raise not_covered(f"write_mesh() to a {_extension(filename)} file")
    m, k = F.shape
    elements = {
        "per-vertex": (len(V), F),
        "per-face": (m, np.repeat(np.arange(m), k).reshape(m, k)),
        "per-corner": (m * k, np.arange(m * k).reshape(m, k)),
    }
    with open(filename, "w", encoding="ascii") as file:
        _write_rows(file, V, "v ")
        if UV_type is None:
            _write_rows(file, F + 1, "f ")
            return
        if UV_type not in elements:
            raise ValueError(f"UV_type is {UV_type!r}, but it must be one of {list(elements)}.")
        size, indices = elements[UV_type]
        if UV_coords is None or UV_coords.shape != (size, 2):
            raise ValueError(f"UV_coords must have the shape ({size}, 2).")
        _write_rows(file, UV_coords, "vt ")
        for face, uv in zip((F + 1).tolist(), (indices + 1).tolist()):
            file.write("f " + " ".join(f"{i}/{j}" for i, j in zip(face, uv)) + "\n")


def write_point_cloud(V: NDArray[Any], filename: str | os.PathLike[str]) -> None:
    """Writes points, shape (n, 3), to an OBJ or PLY file."""
    validate_points(V)
    extension = _extension(filename)
    if extension not in (".obj", ".ply"):
        raise not_covered(f"write_point_cloud() to a {extension} file")
    with open(filename, "w", encoding="ascii") as file:
        if extension == ".ply":
            properties = "".join(f"property double {axis}\n" for axis in "xyz")
            file.write(
                f"ply\nformat ascii 1.0\nelement vertex {len(V)}\n{properties}end_header\n"
            )
        _write_rows(file, V, "v " if extension == ".obj" else "")


def _extension(filename: str | os.PathLike[str]) -> str:
    return os.path.splitext(os.fspath(filename))[1].lower()


def _write_rows(file: Any, rows: NDArray[Any], word: str) -> None:
    # repr() of a float has the digits that identify it.
    file.writelines(word + " ".join(map(repr, row)) + "\n" for row in rows.tolist())


# Solvers


class MeshHeatMethodDistanceSolver:
    """Computes distances on a triangle mesh by the heat method.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the triangles, shape (m, 3).
    t_coef
        Must be 1.
    use_robust
        Has no effect.
    """

    def __init__(
        self, V: NDArray[Any], F: NDArray[Any], t_coef: float = 1.0, use_robust: bool = True
    ) -> None:
        require_default("t_coef", t_coef, 1.0)
        self._solver = _triangle_mesh(V, F).solver("heat")

    def compute_distance(self, v_ind: int) -> Floats:
        """Computes the distances from a vertex, shape (n,)."""
        return _distances(self._solver, [v_ind])

    def compute_distance_multisource(self, v_inds: ArrayLike) -> Floats:
        """Computes the distances from the nearest of several vertices, shape (n,)."""
        return _distances(self._solver, v_inds)


def compute_distance(V: NDArray[Any], F: NDArray[Any], v_ind: int) -> Floats:
    """Computes the distances from a vertex by the heat method, shape (n,)."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(V: NDArray[Any], F: NDArray[Any], v_inds: ArrayLike) -> Floats:
    """Computes the distances from the nearest of several vertices by the heat method."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)


class PolygonMeshHeatSolver:
    """Computes distances on a polygon mesh by the heat method. Polygons are triangulated.

    Parameters
    ----------
    V
        Shape (n, 3): the points.
    F
        Shape (m, k): the polygons; or a list of polygons.
    t_coef
        Must be 1.
    """

    get_tangent_frames = missing_method("PolygonMeshHeatSolver.get_tangent_frames")
    transport_tangent_vectors = missing_method("PolygonMeshHeatSolver.transport_tangent_vectors")
    compute_signed_distance = missing_method("PolygonMeshHeatSolver.compute_signed_distance")

    def __init__(self, V: NDArray[Any], F: Polygons, t_coef: float = 1.0) -> None:
        require_default("t_coef", t_coef, 1.0)
        validate_mesh(V, F, test_indices=True)
        offsets = np.cumsum([0, *(len(face) for face in F)])
        # Only the extension accepts polygons with different numbers of corners.
        core = _core.make_mesh(V, np.concatenate([*F]), offsets, None, False, None)
        self._surface = Surface._of(core)
        self._solver = self._surface.solver("heat")

    def compute_distance(self, v_inds: ArrayLike) -> Floats:
        """Computes the distances from the nearest of several vertices, shape (n,)."""
        return _distances(self._solver, v_inds)

    def extend_scalar(self, v_inds: ArrayLike, values: ArrayLike) -> Floats:
        """Returns the value of the nearest source for each vertex, shape (n,).

        Parameters
        ----------
        v_inds, values
            Shape (k,): the sources, which are vertices, and their values.
        """
        return _extended(self._surface, v_inds, values)


class PointCloudHeatSolver:
    """Computes distances and logarithmic maps on a point cloud. Normals are estimated.

    Parameters
    ----------
    P
        Shape (n, 3): the points.
    t_coef
        Must be 1.
    """

    transport_tangent_vector = missing_method("PointCloudHeatSolver.transport_tangent_vector")
    transport_tangent_vectors = missing_method("PointCloudHeatSolver.transport_tangent_vectors")
    compute_signed_distance = missing_method("PointCloudHeatSolver.compute_signed_distance")

    def __init__(self, P: NDArray[Any], t_coef: float = 1.0) -> None:
        require_default("t_coef", t_coef, 1.0)
        validate_points(P)
        self._surface = Surface(P)
        self._solver = self._surface.solver("heat")

    def compute_distance(self, p_ind: int) -> Floats:
        """Computes the distances from a point, shape (n,)."""
        return _distances(self._solver, [p_ind])

    def compute_distance_multisource(self, p_inds: ArrayLike) -> Floats:
        """Computes the distances from the nearest of several points, shape (n,)."""
        return _distances(self._solver, p_inds)

    def extend_scalar(self, p_inds: ArrayLike, values: ArrayLike) -> Floats:
        """Returns the value of the nearest source for each point, shape (n,).

        Parameters
        ----------
        p_inds, values
            Shape (k,): the sources, which are points, and their values.
        """
        return _extended(self._surface, p_inds, values)

    def get_tangent_frames(self) -> Frames:
        """Returns the first axes, the second axes and the normals of the tangent planes."""
        return self._axis(0), self._axis(1), np.cross(self._axis(0), self._axis(1))

    def compute_log_map(self, p_ind: int) -> Floats:
        """Computes the logarithmic map of a point, shape (n, 2), along its tangent axes.

        Points that are not reached are NaN.
        """
        return self._surface.log_map(int(p_ind), up=self._axis(1)[p_ind]).uv

    def _axis(self, axis: int) -> Floats:
        n = self._surface.number_of_points
        # The point with a unit offset along an axis of the tangent plane.
        tips = self._surface.points(Locations(np.arange(n), np.tile(np.eye(2)[axis], (n, 1))))
        return _normalized(tips - self._surface.vertices)


class MeshVectorHeatSolver:
    """Computes exact logarithmic maps on a triangle mesh, and values of the nearest sources.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the triangles, shape (m, 3).
    t_coef
        Must be 1.
    use_intrinsic_delaunay
        Has no effect.
    """

    get_connection_laplacian = missing_method("MeshVectorHeatSolver.get_connection_laplacian")
    transport_tangent_vector = missing_method("MeshVectorHeatSolver.transport_tangent_vector")
    transport_tangent_vectors = missing_method("MeshVectorHeatSolver.transport_tangent_vectors")

    def __init__(
        self,
        V: NDArray[Any],
        F: NDArray[Any],
        t_coef: float = 1.0,
        use_intrinsic_delaunay: bool = True,
    ) -> None:
        require_default("t_coef", t_coef, 1.0)
        self._surface = _triangle_mesh(V, F)
        self._frames = _vertex_frames(V, F)

    def extend_scalar(self, v_inds: ArrayLike, values: ArrayLike) -> Floats:
        """Returns the value of the nearest source for each vertex, shape (n,).

        Parameters
        ----------
        v_inds, values
            Shape (k,): the sources, which are vertices, and their values.
        """
        return _extended(self._surface, v_inds, values)

    def get_tangent_frames(self) -> Frames:
        """Returns the first axes, the second axes and the normals at the vertices.

        Normals are means of the normals of faces, weighted by their angles.
        """
        return self._frames

    def compute_log_map(self, v_ind: int, strategy: str = "AffineLocal") -> Floats:
        """Computes the logarithmic map of a vertex, shape (n, 2), along its tangent axes.

        Parameters
        ----------
        v_ind
            The vertex.
        strategy
            ``"VectorHeat"``, ``"AffineLocal"`` or ``"AffineAdaptive"``. The result is exact with
            each of them. Vertices that are not reached are NaN.
        """
        if strategy not in ("VectorHeat", "AffineLocal", "AffineAdaptive"):
            raise ValueError(f"There is no strategy {strategy!r}.")
        return self._surface.log_map(int(v_ind), up=self._frames[1][v_ind], method="exact").uv


class MeshFastMarchingDistanceSolver:
    """Computes distances on a triangle mesh by fast marching.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the triangles, shape (m, 3).
    """

    def __init__(self, V: NDArray[Any], F: NDArray[Any]) -> None:
        self._solver = _oriented_mesh(V, F).solver("fast-marching")
        _, halfedges = _edges(F)
        # The first corner at which each edge begins.
        self._corners = np.unique(halfedges, return_index=True)[1]

    def compute_distance(
        self,
        curves: Sequence[Sequence[BarycentricPoint]],
        distances: Sequence[Sequence[float]] = (),
        sign: bool = False,
    ) -> Floats:
        """Computes the distance of each vertex to the nearest point of some curves, shape (n,).

        Parameters
        ----------
        curves
            Lists of points. Only the points are sources, not the segments between them.
        distances
            The distances of the points themselves; 0 for points without one.
        sign
            Must be false: signed distances are not covered.
        """
        require_default("sign", bool(sign), False)
        offsets = [np.zeros(len(curve)) for curve in curves]
        for offset, values in zip(offsets, distances):
            size = min(len(offset), len(values))
            offset[:size] = values[:size]
        sources = [self._location(point) for curve in curves for point in curve]
        self._solver.compute(sources, offsets=np.concatenate([np.empty(0), *offsets]))
        result: Floats = self._solver.distance()
        return result

    def _location(self, point: BarycentricPoint) -> Any:
        index, *rest = point
        coordinates = [float(t) for t in rest[0]] if rest else []
        if not coordinates:
            return index
        if len(coordinates) > 1:
            a, b = coordinates[:2]
            return index, (a, b, coordinates[2] if len(coordinates) > 2 else 1 - a - b)
        face, corner = divmod(int(self._corners[index]), 3)
        barycentric = np.zeros(3)
        barycentric[[corner, (corner + 1) % 3]] = 1 - coordinates[0], coordinates[0]
        return face, barycentric


class MeshMarchingTrianglesSolver:
    """Computes isolines on a triangle mesh.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the triangles, shape (m, 3).
    """

    def __init__(self, V: NDArray[Any], F: NDArray[Any]) -> None:
        self._surface = _oriented_mesh(V, F)
        self._faces = F
        self._edges, halfedges = _edges(F)
        self._halfedges = halfedges.reshape(-1, 3)

    def marching_triangles(
        self, u: ArrayLike, isoval: float = 0.0
    ) -> list[list[tuple[int, list[float]]]]:
        """Computes the isolines of a function that is linear in each face.

        Parameters
        ----------
        u
            Shape (n,): the values of the vertices.
        isoval
            The value of the isolines.

        Returns
        -------
        A list of points for each isoline: ``(v, [])`` for a vertex v, ``(e, [t])`` for the point of
        an edge at the fraction t from its first vertex. Smaller values are on the left, seen from
        outside. The last point of a closed line equals the first one.
        """
        lines = self._surface.isolines(np.ravel(np.asarray(u)), [isoval])
        return [
            [self._point(*point) for point in zip(line.faces[::-1], line.barycentric[::-1])]
            for line in lines
        ]

    def _point(self, face: int, barycentric: Floats) -> tuple[int, list[float]]:
        corners = self._faces[face]
        if barycentric.max() == 1:
            return int(corners[barycentric.argmax()]), []
        opposite = int(barycentric.argmin())  # its coordinate is 0
        tail, tip = (opposite + 1) % 3, (opposite + 2) % 3
        edge = int(self._halfedges[face, tail])
        second = tip if self._edges[edge, 0] == corners[tail] else tail
        return edge, [float(barycentric[second])]


def marching_triangles(
    V: NDArray[Any], F: NDArray[Any], u: ArrayLike, isoval: float = 0.0
) -> list[list[tuple[int, list[float]]]]:
    """Computes isolines. See ``MeshMarchingTrianglesSolver.marching_triangles()``."""
    return MeshMarchingTrianglesSolver(V, F).marching_triangles(u, isoval)


class EdgeFlipGeodesicSolver:
    """Computes locally shortest paths and loops on a triangle mesh.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the triangles, shape (m, 3).
    t_coef
        Has no effect.
    """

    def __init__(self, V: NDArray[Any], F: NDArray[Any], t_coef: float = 1.0) -> None:
        self._surface = _triangle_mesh(V, F)

    def find_geodesic_path(
        self,
        v_start: int,
        v_end: int,
        max_iterations: int | None = None,
        max_relative_length_decrease: float | None = None,
    ) -> Floats:
        """Computes a shortest path between two vertices.

        Parameters
        ----------
        v_start, v_end
            Different vertices.
        max_iterations, max_relative_length_decrease
            Not covered: paths are always shortened completely.

        Returns
        -------
        The points of the path, shape (k, 3).

        Raises
        ------
        RuntimeError
            If the vertices are equal or not connected.
        """
        vertices = [v_start, v_end]
        _check_shortening(vertices, max_iterations, max_relative_length_decrease)
        return _connected(self._surface.path(int(v_start), int(v_end)).points)

    def find_geodesic_path_poly(
        self,
        v_list: Sequence[int],
        max_iterations: int | None = None,
        max_relative_length_decrease: float | None = None,
    ) -> Floats:
        """Joins vertices by shortest paths, and shortens the whole to a locally shortest path.

        Consecutive vertices must be different. See ``find_geodesic_path()`` for the rest.
        """
        _check_shortening(v_list, max_iterations, max_relative_length_decrease)
        return _connected(self._surface.shorten_polyline(np.asarray(v_list)).points)

    def find_geodesic_loop(
        self,
        v_list: Sequence[int],
        max_iterations: int | None = None,
        max_relative_length_decrease: float | None = None,
    ) -> Floats:
        """Joins vertices to a loop by shortest paths, and shortens it to a locally shortest loop.

        The last point equals the first one. A contractible loop can end around a neck of the mesh.
        If there is no neck, the result is a single point. See ``find_geodesic_path()`` for the
        rest.
        """
        closed = [*v_list, *v_list[:1]]
        _check_shortening(closed, max_iterations, max_relative_length_decrease)
        loop = self._surface.shorten_loop(np.asarray(v_list))
        neck = _loop_around_neck(self._surface, np.asarray(v_list)) if loop.is_point else None
        return _connected(loop.points) if neck is None else neck


class GeodesicTracer:
    """Traces straightest geodesics on a triangle mesh.

    Parameters
    ----------
    V, F
        The points, shape (n, 3), and the triangles, shape (m, 3).
    t_coef
        Has no effect.
    """

    def __init__(self, V: NDArray[Any], F: NDArray[Any], t_coef: float = 1.0) -> None:
        self._surface = _oriented_mesh(V, F)
        self._vertex_normals = _vertex_frames(V, F)[2]
        self._corners = V[F]

    def trace_geodesic_from_vertex(
        self, start_vert: int, direction_xyz: ArrayLike, max_iterations: int | None = None
    ) -> Floats:
        """Traces a straightest geodesic from a vertex.

        Parameters
        ----------
        start_vert
            The vertex.
        direction_xyz
            Shape (3,): the direction in space. The length of its projection to the tangent plane is
            the length of the geodesic, which can end earlier at the boundary.
        max_iterations
            The geodesic ends after this number of edges and one more. By default, it has any number
            of edges.

        Returns
        -------
        The points of the geodesic, shape (k, 3).
        """
        normal = self._vertex_normals[start_vert]
        return self._trace(int(start_vert), normal, direction_xyz, max_iterations)

    def trace_geodesic_from_face(
        self,
        start_face: int,
        bary_coords: ArrayLike,
        direction_xyz: ArrayLike,
        max_iterations: int | None = None,
    ) -> Floats:
        """Traces a straightest geodesic from a point of a face.

        Parameters
        ----------
        start_face
            The face.
        bary_coords
            Shape (3,): the barycentric coordinates of the point.
        direction_xyz, max_iterations
            As for ``trace_geodesic_from_vertex()``, with the plane of the face.
        """
        a, b, c = self._corners[start_face]
        normal = _normalized(np.cross(b - a, c - a))
        start = (int(start_face), np.asarray(bary_coords))
        return self._trace(start, normal, direction_xyz, max_iterations)

    def _trace(
        self, start: Any, normal: Floats, direction: ArrayLike, max_iterations: int | None
    ) -> Floats:
        vector = np.asarray(direction, np.float64)
        length = float(np.linalg.norm(vector - (vector @ normal) * normal))
        points = self._surface.trace(start, vector, length=length).points
        return points if max_iterations is None else points[: max_iterations + 2]


def _triangle_mesh(V: NDArray[Any], F: NDArray[Any]) -> Surface:
    validate_mesh(V, F, force_triangular=True, test_indices=True)
    return Surface(V, F)


def _oriented_mesh(V: NDArray[Any], F: NDArray[Any]) -> Surface:
    """Returns a surface with the same faces, to which indices of faces refer."""
    surface = _triangle_mesh(V, F)
    if not np.array_equal(surface.faces, F):
        raise not_covered("A mesh with faces that have to be repaired")
    return surface


def _distances(solver: Solver, sources: ArrayLike) -> Floats:
    distances: Floats = solver.compute(np.asarray(sources)).distance()
    return distances


def _extended(surface: Surface, sources: ArrayLike, values: ArrayLike) -> Floats:
    vertices, numbers = np.asarray(sources), np.asarray(values, np.float64)
    if vertices.shape != numbers.shape:
        raise ValueError("There must be one value for each source.")
    labels = surface.solver().compute(vertices).labels
    return np.append(numbers, np.nan)[labels]  # the label -1 is no source


def _check_shortening(
    vertices: Sequence[int], max_iterations: int | None, max_decrease: float | None
) -> None:
    require_default("max_iterations", max_iterations, None)
    require_default("max_relative_length_decrease", max_decrease or None, None)
    if any(a == b for a, b in zip(vertices, vertices[1:])):
        raise RuntimeError("Consecutive vertices are equal.")


def _loop_around_neck(surface: Surface, vertices: Integers) -> Floats | None:
    """Returns a locally shortest loop. Returns None if the loop shrinks to a point.

    ``Surface.shorten_loop()`` shrinks all contractible loops. Birkhoff's curve shortening process
    stops at a neck: it alternately shortens the halves of the loop, between other points each time.
    """
    loop = cast(Path, surface.polyline(vertices, close=True).path)
    points, locations, length = loop.points, Locations(loop.faces, loop.barycentric), loop.length
    min_length = 1e-9 * length  # a point
    previous = math.inf
    while length < previous * (1 - 1e-12):  # the decrease exceeds round-off errors
        n = len(locations)
        if n < 4 or length <= min_length:
            return None
        previous = length
        a, b = n // 4, 3 * n // 4
        first = _shortened(surface, locations, np.arange(a, b + 1))
        second = _shortened(surface, locations, np.r_[b:n, 1 : a + 1])
        points, faces, barycentric = (
            np.concatenate([x, y[1:]]) for x, y in zip(first[:3], second[:3])
        )
        locations, length = Locations(faces, barycentric), first.length + second.length
    return points


def _shortened(surface: Surface, locations: Locations, rows: Integers) -> Path:
    part = Locations(locations.indices[rows], locations.coordinates[rows])
    return cast(Path, surface.shorten_polyline(part))


def _connected(points: Floats) -> Floats:
    if len(points) == 0:
        raise RuntimeError("The vertices are not connected.")
    return points


def _vertex_frames(V: NDArray[Any], F: NDArray[Any]) -> Frames:
    """Returns the axes and the normals at the vertices; NaN for vertices without faces."""
    corners = V[F]
    outgoing = np.roll(corners, -1, axis=1) - corners
    incoming = corners - np.roll(corners, 1, axis=1)
    normals = np.cross(incoming, outgoing)
    sines = np.linalg.norm(normals, axis=2)
    angles = np.arctan2(sines, -np.einsum("ijk,ijk->ij", incoming, outgoing))
    # A face without area has no normal and no weight.
    weights = np.divide(angles, sines, out=np.zeros_like(angles), where=sines > 0)
    sums = np.zeros((len(V), 3))
    np.add.at(sums, F, normals * weights[:, :, None])
    normal = _normalized(sums)
    first = np.full((len(V), 3), np.nan)
    first[F] = outgoing  # the last face remains
    x = _normalized(first - np.einsum("ij,ij->i", first, normal)[:, None] * normal)
    return x, np.cross(normal, x), normal


def _normalized(vectors: Floats) -> Floats:
    with np.errstate(invalid="ignore", divide="ignore"):
        result: Floats = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return result
