# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances and paths."""

from __future__ import annotations

import math
from collections.abc import Iterable
from concurrent.futures import Executor
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core
from ._base import Base
from ._core import InvalidArgumentError
from ._executors import distribute
from ._matrix import Matrix, write_matrix
from ._types import (
    Callback,
    Floats,
    Integers,
    Locations,
    ManyLocations,
    ManySources,
    OneLocation,
    Polyline,
)


class Path(NamedTuple):
    """A path on a mesh. It has no points if its ends are not connected."""

    points: Floats
    """Shape (k, 3): the polyline."""
    faces: Integers
    """Shape (k,): a face that contains the point."""
    barycentric: Floats
    """Shape (k, 3): the barycentric coordinates of the points."""
    length: float
    """The length of the polyline; infinite if there is no path."""
    lower: float
    """A certified lower bound of the length of all paths between its ends; infinite if there is no
    path. It is the length minus round-off errors if the path is a shortest path. It is the straight
    distance of the ends if the method is approximate."""
    distance: float
    """The distance by the method of the solver: a travel time if there are speeds."""


class SurfelPath(NamedTuple):
    """A path on a cloud. It has no points if its ends are not connected."""

    points: Floats
    """Shape (k, 3): the polyline."""
    surfels: Integers
    """Shape (k,): the surfel nearest to each point on the same sheet."""
    offsets: Floats
    """Shape (k, 2): the offsets in the tangent planes of the surfels."""
    length: float
    """The length of the polyline; infinite if there is no path."""
    lower: float
    """The straight distance of the ends; infinite if there is no path."""
    distance: float
    """The length of the smooth curve through the points, or the distance by a solver."""


class SparseMatrix(NamedTuple):
    """A sparse matrix by compressed rows. ``scipy.sparse.csr_matrix(m[:3], m.shape)`` accepts it."""

    data: Floats
    """The entries of all rows."""
    indices: NDArray[np.int32]
    """The column of each entry, increasing in each row."""
    indptr: NDArray[np.int32]
    """The entries of row i are those from ``indptr[i]`` to ``indptr[i + 1]``."""
    shape: tuple[int, int]
    """The numbers of rows and columns."""


class Distances(Base):
    """The functions of a surface for distances and paths."""

    def solver(self, method: str = "auto", *, callback: Callback | None = None) -> Solver:
        """Returns a solver for distances from different sources.

        Parameters
        ----------
        method
            - ``"exact"``: distances on the polyhedron, up to round-off errors; on meshes only
            - ``"euclidean"``: a circular front of second order
            - ``"fast-marching"``: a front of first order; for speeds
            - ``"dijkstra"``: the shortest path along edges
            - ``"heat"``: a smooth approximation; its solver factorizes two matrices
            - ``"auto"``: exact on meshes, unless speeds differ; otherwise euclidean
        callback
            A function that takes a fraction. ``"heat"`` calls it with 0 before each factorization.
            A factorization cannot be interrupted: each takes about half a second for 100,000
            vertices.
        """
        return Solver(self, method, callback=callback)

    def border_sources(self) -> list[Polyline]:
        """Returns the boundary cycles of a mesh, as sources: closed polylines.

        O(m + b log b) for m faces and b edges on the boundary.
        """
        cycles = self._mesh("border_sources").border_sources()
        return [Polyline(faces, barycentric) for faces, barycentric in cycles]

    def distance(
        self,
        sources: ManySources,
        *,
        method: str = "auto",
        max_distance: float = math.inf,
        targets: ManyLocations | None = None,
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        offsets: ArrayLike | None = None,
        callback: Callback | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Computes the distance of each vertex to the nearest source.

        Parameters
        ----------
        sources
            A location, a ``Polyline``, or a range of them.
        method
            As for ``solver()``.
        max_distance
            Vertices farther than this distance are infinitely far.
        targets
            A location, or a range of either vertices or other locations: the computation stops if
            their distances are final. Other distances can be infinite.
        speed
            Shape (n,): the speed at the vertices, zero at obstacles. Distances are travel times.
        face_speed
            Shape (m,): the speed in the faces of a mesh, instead of ``speed``.
        offsets
            Shape (k,): the distance of each source itself.
        callback
            A function that takes the completed fraction.
        out
            A writable array of float64 of the shape (n,) that receives the result. It is unchanged
            if the function raises an exception.

        Returns
        -------
        The distances, shape (n,): ``out`` if it is given.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid.
        UnsupportedSurfaceError
            If the method does not support the surface or the speeds.
        Cancelled
            If the callback returns a false value.

        Takes O(n log n) time; ``"exact"`` takes O(n^1.5) time in practice.
        """
        result = _core.output(out, self.number_of_points)
        solver = self.solver(method, callback=callback)
        solver.compute(
            sources,
            max_distance=max_distance,
            targets=targets,
            speed=speed,
            face_speed=face_speed,
            offsets=offsets,
            callback=callback,
        )
        solver._core.write_distances(result)
        return result

    def path(self, a: OneLocation, b: OneLocation) -> Path | SurfelPath:
        """Computes a shortest path between two locations; on a cloud, a locally shortest path.

        No other distances are computed. The first path on a cloud takes O(n log n) time.
        """
        return self.paths([(a, b)])[0]

    def paths(
        self,
        pairs: Iterable[tuple[OneLocation, OneLocation]] | NDArray[np.integer[Any]],
        *,
        executor: Executor | None = None,
        callback: Callback | None = None,
    ) -> list[Path | SurfelPath]:
        """Computes a path for each pair of locations.

        Parameters
        ----------
        pairs
            Pairs of locations, or an array of vertices of the shape (k, 2).
        executor
            Its workers compute the paths, as for ``distance_matrix()``. If it fails, no path is
            returned.
        callback
            A function that takes the completed fraction.
        """
        if isinstance(pairs, np.ndarray) and pairs.ndim == 0:  # it has __iter__, which fails
            raise InvalidArgumentError("pairs are not a list of pairs of vertices or locations.")
        if executor is not None:
            return _distributed_paths(self, executor, pairs, callback)
        return [self._path(path) for path in self._core.paths(pairs, callback)]

    def locate(self, points: ArrayLike) -> Locations:
        """Computes the location on the surface that is closest to each point.

        Parameters
        ----------
        points
            Shape (k, 3), finite.

        The first call takes O(n log n) time, each point about O(log n) time.
        """
        return Locations(*self._core.locate(points))

    def points(self, locations: ManyLocations) -> Floats:
        """Returns the points of locations, shape (k, 3)."""
        return self._core.points(locations)

    def distance_matrix(
        self,
        sources: ManySources | None = None,
        targets: ManyLocations | None = None,
        *,
        max_distance: float = math.inf,
        regions: ArrayLike | None = None,
        reduce: str = "min",
        dtype: DTypeLike = "f8",
        out: Any = None,
        method: str = "auto",
        threads: int | None = None,
        executor: Executor | None = None,
        rows_per_tile: int | None = None,
        callback: Callback | None = None,
    ) -> Any:
        """Computes the distance from each source to each target.

        Parameters
        ----------
        sources
            A location, a ``Polyline``, or a range of them: the rows. By default, all vertices.
        targets
            A location, or a range of either vertices or other locations: the columns. By default,
            the sources.
        max_distance
            Targets farther than this distance are infinitely far. If most of them are, use
            ``sparse_distance_matrix()``.
        regions
            Shape (n,), integers below n: the region of each vertex, negative if it is in none. If
            ``sources`` are ``None``, each region has a row. If ``targets`` are ``None``, each
            region has a column. There are ``max(regions) + 1`` regions. An empty region is
            infinitely far.
        reduce
            ``"min"``: an entry is the smallest distance to, from or between regions. A row is then
            computed from all vertices of its region at once. ``"mean"``: it is the mean of the
            distances of all pairs, which is infinite if a pair is not connected.
        dtype
            The type of a new array: float64 or float32.
        out
            A writable array of float64 or float32 in C order, for example a ``numpy.memmap``, that
            receives the result; or an array of Zarr, which is written in tiles.
        method
            As for ``solver()``.
        threads
            The number of threads, of each worker if there is an executor. By default, that of the
            hardware, or 1 for a worker. Results do not depend on it.
        executor
            Any ``concurrent.futures.Executor``, for example a ``ProcessPoolExecutor``, the executor
            of a Dask client, or an ``MPIPoolExecutor``. Its workers compute tiles of rows, which
            this thread writes. A worker receives the surface once, and keeps the last 4 surfaces.
            Results do not depend on it.
        rows_per_tile
            The number of rows of a tile. By default, there are at most 256 tiles, of at most 64 MB.
            They have at least 4 rows of ``"exact"`` or 64 of other methods, unless there are fewer
            than 8 tiles. A tile contains whole chunks of an array of Zarr.
        callback
            A function that takes the completed fraction of the rows; with tiles, that of the missing
            rows. If it or Ctrl-C cancels the computation, some rows of ``out`` are written.

        Returns
        -------
        The distances, shape (k, l), in C order: ``out`` if it is given. Rows are written directly to
        this array. An entry is equal to that of ``distance()``, to the last bit, if neither regions
        nor approximate methods are used.

        If a computation in tiles is interrupted, for example because a process was killed, finished
        tiles remain in ``out``. The same call with the same ``out`` only computes missing tiles. A
        record has a hash of each finished tile. It is in the file ``NAME.KEY.tiles`` of a
        ``numpy.memmap``, in the attribute ``geodesic_processing_tiles`` of an array of Zarr, and
        otherwise in the memory of this process. It is removed when the matrix is complete.

        Takes one distance computation for each row; for ``"mean"``, one for each vertex in a region.
        """
        if not isinstance(reduce, str) or reduce not in ("min", "mean"):
            raise InvalidArgumentError("reduce is neither min nor mean.")
        if executor is not None or not (out is None or isinstance(out, np.ndarray)):
            if threads is None and executor is not None:
                threads = 1
            matrix = Matrix(targets, max_distance, regions, reduce, method, threads, dtype)
            return write_matrix(executor, self, sources, matrix, out, rows_per_tile, callback)
        return self._core.distance_matrix(
            sources,
            targets,
            max_distance,
            regions,
            reduce == "mean",
            dtype,
            out,
            method,
            threads,
            callback,
        )

    def sparse_distance_matrix(
        self,
        max_distance: float,
        vertices: ManyLocations | None = None,
        *,
        method: str = "auto",
        threads: int | None = None,
        callback: Callback | None = None,
    ) -> SparseMatrix:
        """Computes the distances of all pairs of vertices within ``max_distance``.

        Parameters
        ----------
        max_distance
            The bound of the distances.
        vertices
            A vertex, or a range of distinct vertices: the rows and the columns. By default, all
            vertices.
        method, threads, callback
            As for ``distance_matrix()``.

        Returns
        -------
        A sparse matrix. It has an entry for each pair within the bound, even if the distance is 0.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if there are more than 2^31 pairs.

        Takes time and memory proportional to the number of vertices that the fronts visit.
        """
        data, indices, indptr = self._core.sparse_distance_matrix(
            vertices, max_distance, method, threads, callback
        )
        size = len(indptr) - 1
        return SparseMatrix(data, indices, indptr, (size, size))

    def _path(self, arrays: _core._PathArrays) -> Path | SurfelPath:
        return SurfelPath(*_checked(arrays)) if self.is_cloud else Path(*_checked(arrays))


def _distributed_paths(
    surface: Distances, executor: Executor, pairs: Any, callback: Callback | None
) -> list[Path | SurfelPath]:
    """Computes paths in about 256 tasks."""
    pairs = pairs if isinstance(pairs, np.ndarray) else list(pairs)
    size = -(-len(pairs) // 256) or 1
    arguments = [(pairs[begin : begin + size],) for begin in range(0, len(pairs) or 1, size)]
    results: list[list[Path | SurfelPath]] = [[] for _ in arguments]
    for index, some in distribute(executor, surface, _paths, arguments, callback):
        results[index] = some
    return [path for some in results for path in some]


def _paths(surface: Distances, pairs: Any) -> list[Path | SurfelPath]:
    return surface.paths(pairs)


def _checked(arrays: _core._PathArrays) -> _core._PathArrays:
    """Makes the lengths infinite if there is no path."""
    points, indices, coordinates, length, lower, distance = arrays
    if len(points) == 0:
        length = lower = distance = math.inf
    return points, indices, coordinates, length, lower, distance


class Solver:
    """Computes distances from different sources on one surface. See ``Surface.solver()``.

    Members except for ``compute()`` refer to its last call. Before the first call, no vertex is
    reached.
    """

    def __init__(
        self, surface: Distances, method: str = "auto", *, callback: Callback | None = None
    ) -> None:
        self.surface = surface
        self._core = surface._core.solver(method, callback)

    def compute(
        self,
        sources: ManySources,
        *,
        max_distance: float = math.inf,
        targets: ManyLocations | None = None,
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        offsets: ArrayLike | None = None,
        relative_tolerance: float = 0.0,
        callback: Callback | None = None,
    ) -> Solver:
        """Computes distances to the nearest source, and returns the solver.

        ``relative_tolerance`` is a fraction, 0 by default. If it is positive, ``"exact"`` merges
        similar windows, which is faster on smooth meshes. The relative error of a distance is then
        at most this fraction. The other parameters are those of ``Surface.distance()``.

        After an ``InvalidArgumentError`` or an ``UnsupportedSurfaceError``, the last result
        remains. After ``Cancelled``, ``KeyboardInterrupt`` or an exception of the callback, only
        vertices whose distances were final are reached.
        """
        self._core.compute(
            sources, max_distance, targets, speed, face_speed, offsets, relative_tolerance, callback
        )
        return self

    def distance(
        self, locations: ManyLocations | None = None, *, out: Floats | None = None
    ) -> Any:
        """Returns the distances of all vertices, or of locations.

        Parameters
        ----------
        locations
            A location, or a range of them. By default, all vertices.
        out
            A writable array of float64 that receives the distances of all vertices.

        Returns
        -------
        A number for a single location, otherwise an array.
        """
        if locations is None:
            result = _core.output(out, self.surface.number_of_points)
            self._core.write_distances(result)
            return result
        if out is not None:
            raise InvalidArgumentError("out cannot be combined with locations.")
        return self._core.distances(locations)

    def path(self, location: OneLocation) -> Path | SurfelPath:
        """Returns the path from a location to its nearest source.

        With ``"exact"`` it is a shortest path. With other methods it is locally shortest.
        """
        return self.surface._path(self._core.path(location))

    @property
    def labels(self) -> Integers:
        """Shape (n,): the position of the nearest source for each vertex; -1 if there is none."""
        return self._core.labels()

    @property
    def reached(self) -> Integers:
        """Shape (k,): the vertices that were reached, approximately ordered by distance."""
        return self._core.reached()
