# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geodesic distances and paths on triangle meshes and surfel clouds.

Conventions
-----------
- A vertex is the index of a row of ``V`` (mesh) or ``P`` (cloud).
- A location is a vertex, a pair ``(face, barycentric)`` on a mesh, a pair ``(surfel, offset)`` on a
  cloud, or a row of ``Surface.locate(points)``. Ranges are lists or tuples of them, arrays of
  vertices, and ``Locations``. A tuple of two integers is a range of two vertices.
- Lengths have the unit of the coordinates. A distance is infinite if no source reaches the vertex.
- Arrays of float64 and float32, int32, int64, uint32 and uint64 are read without a copy, with any
  strides. Others are converted.
- Invalid arguments raise ``InvalidArgumentError``, surfaces that a method does not support raise
  ``UnsupportedSurfaceError``. Both are subclasses of ``ValueError``.
- Computations run without the GIL. Several threads can use the same object. A solver serves one
  thread at a time.
- ``callback(fraction)`` is called with the completed fraction. If it returns a false value other
  than ``None``, the function raises ``Cancelled``. If it raises an exception, this exception
  arrives. Computations with this argument react to Ctrl-C.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Cancelled, FileError, InvalidArgumentError, UnsupportedSurfaceError

__all__ = [
    "Bisector",
    "Cancelled",
    "FileError",
    "InvalidArgumentError",
    "Isoline",
    "Location",
    "Locations",
    "Path",
    "Samples",
    "Solver",
    "SoupReport",
    "Surface",
    "SurfelLocation",
    "SurfelPath",
    "UnsupportedSurfaceError",
    "Voronoi",
    "read",
]


Callback = Callable[[float], Any]
"""A function that takes the completed fraction."""
Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


class Location(NamedTuple):
    """A location on a mesh."""

    face: int
    """The index of the face, a row of ``Surface.faces``."""
    barycentric: tuple[float, float, float]
    """The barycentric coordinates with respect to the corners of the face."""


class SurfelLocation(NamedTuple):
    """A location on a cloud: a point of the tangent plane of a surfel."""

    surfel: int
    """The index of the surfel."""
    offset: tuple[float, float]
    """The components along the two axes of the tangent plane, in the unit of the coordinates."""


OneLocation = Union[int, np.integer[Any], tuple[int, ArrayLike], Location, SurfelLocation]
ManyLocations = Union[OneLocation, Iterable[OneLocation], NDArray[np.integer[Any]]]


class Locations(Sequence[Union[Location, SurfelLocation]]):
    """Locations on a surface, as arrays. Its rows are ``Location`` or ``SurfelLocation``."""

    def __init__(self, indices: Integers, coordinates: Floats) -> None:
        self.indices = indices
        """Shape (k,): the faces of a mesh, the surfels of a cloud."""
        self.coordinates = coordinates
        """Shape (k, 3): barycentric coordinates on a mesh; (k, 2): offsets on a cloud."""

    def __len__(self) -> int:
        return len(self.indices)

    @overload
    def __getitem__(self, row: int) -> Location | SurfelLocation: ...

    @overload
    def __getitem__(self, row: slice) -> Locations: ...

    def __getitem__(self, row: int | slice) -> Location | SurfelLocation | Locations:
        if isinstance(row, slice):
            return Locations(self.indices[row], self.coordinates[row])
        index = int(self.indices[row])
        a, b, *c = self.coordinates[row].tolist()
        return Location(index, (a, b, c[0])) if c else SurfelLocation(index, (a, b))

    def __iter__(self) -> Iterator[Location | SurfelLocation]:
        return (self[row] for row in range(len(self)))


class SoupReport(NamedTuple):
    """The repairs of a soup, and the topology of the mesh. All members are numbers."""

    number_of_merged_points: int
    number_of_triangulated_polygons: int
    number_of_degenerate_faces: int
    number_of_duplicate_triangles: int
    number_of_triangles_without_area: int
    number_of_reversed_triangles: int
    number_of_split_edges: int
    number_of_nonmanifold_points: int
    number_of_components: int
    number_of_boundary_cycles: int
    genus: int


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


class Samples(NamedTuple):
    """The result of farthest point sampling."""

    locations: Locations
    """The samples."""
    radii: Floats
    """Shape (k,): the covering radius after each sample."""
    labels: Integers
    """Shape (n,): the position of the nearest sample for each vertex, -1 if there is none. First
    samples have the first positions."""


class Bisector(NamedTuple):
    """A line between two cells of a Voronoi diagram."""

    left: int
    """The label of the cell on the left, seen from outside."""
    right: int
    """The label of the cell on the right."""
    points: Floats
    """Shape (k, 3): the polyline."""
    faces: Integers
    """Shape (k,): a face that contains the point."""
    barycentric: Floats
    """Shape (k, 3): the barycentric coordinates of the points."""


class Voronoi(NamedTuple):
    """A geodesic Voronoi diagram. On clouds, only ``labels`` is not empty."""

    labels: Integers
    """Shape (n,): the position of the nearest seed for each vertex, -1 if no seed reaches it."""
    face_labels: Integers
    """Shape (m,): the cell that contains the centroid of each face."""
    bisectors: list[Bisector]
    """The lines between the cells."""


class Isoline(NamedTuple):
    """A line of constant value on a mesh. Larger values are on the left, seen from outside."""

    value: float
    """The value on the line."""
    is_closed: bool
    """Whether the last point equals the first one."""
    points: Floats
    """Shape (k, 3): the polyline."""
    faces: Integers
    """Shape (k,): a face that contains the point."""
    barycentric: Floats
    """Shape (k, 3): the barycentric coordinates of the points."""
    length: float
    """The length of the polyline."""


class Surface:
    """A triangle mesh or a surfel cloud, prepared for any number of queries. It is immutable.

    Parameters
    ----------
    V
        Points, shape (n, 3), finite.
    F
        Polygons of a mesh, shape (m, k) with k >= 3: rows of ``V``. They need not be a manifold or
        oriented; ``report`` has the repairs. Polygons with more than three corners are
        triangulated.
    normals
        Normals of a cloud, shape (n, 3), of any positive length. If neither ``F`` nor ``normals``
        is given, normals are estimated from 18 neighbors.
    radii
        Radii of the surfels of a cloud, shape (n,). By default, the distance to the 8th neighbor
        divided by the square root of two.
    merge_tolerance
        Points of a mesh within this distance are merged. By default, no points are merged.
    remove_degenerate_faces
        Whether triangles without area are removed.

    Raises
    ------
    InvalidArgumentError
        If an array has a wrong shape or type or is empty, if a number is not finite, if an index is
        not a row of ``V``, or if a normal has no direction.
    UnsupportedSurfaceError
        If there are too many points or halfedges, or too few points to estimate normals.

    Takes O(n) time for a mesh and O(n log n) time for a cloud.
    """

    def __init__(
        self,
        V: ArrayLike,
        F: ArrayLike | None = None,
        *,
        normals: ArrayLike | None = None,
        radii: ArrayLike | None = None,
        merge_tolerance: float | None = None,
        remove_degenerate_faces: bool = False,
    ) -> None:
        self._core: _core.Mesh | _core.Cloud
        if F is None:
            if merge_tolerance is not None or remove_degenerate_faces:
                raise InvalidArgumentError(
                    "merge_tolerance and remove_degenerate_faces need the faces F of a mesh."
                )
            self._core = _core.make_cloud(V, normals, radii)
        else:
            if normals is not None or radii is not None:
                raise InvalidArgumentError("A mesh has faces, but neither normals nor radii.")
            self._core = _core.make_mesh(V, F, merge_tolerance, bool(remove_degenerate_faces))

    @classmethod
    def _of(cls, core: _core.Mesh | _core.Cloud) -> Surface:
        result = cls.__new__(cls)
        result._core = core
        return result

    def __repr__(self) -> str:
        if self.is_cloud:
            return f"<geodesic_processing.Surface: {self.number_of_points} surfels>"
        return (
            f"<geodesic_processing.Surface: {self.number_of_points} points, "
            f"{self.number_of_faces} faces>"
        )

    @property
    def is_cloud(self) -> bool:
        """Whether the surface is a cloud."""
        return isinstance(self._core, _core.Cloud)

    @property
    def number_of_points(self) -> int:
        """The number of points, also of those without faces."""
        return self._core.number_of_points

    @property
    def number_of_faces(self) -> int:
        """The number of triangles; 0 for a cloud."""
        return self._core.number_of_faces

    @property
    def faces(self) -> Integers:
        """The triangles after repair, a new array of the shape (m, 3)."""
        return self._mesh("faces").faces()

    @property
    def report(self) -> SoupReport:
        """The repairs of the polygons, and the topology of the mesh."""
        return SoupReport(**self._mesh("report").report())

    def solver(self, method: str = "auto") -> Solver:
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
        """
        return Solver(self, method)

    def distance(
        self,
        sources: ManyLocations,
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
            A location, or a range of them.
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
        solver = self.solver(method)
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
        self, pairs: Iterable[tuple[OneLocation, OneLocation]] | NDArray[np.integer[Any]]
    ) -> list[Path | SurfelPath]:
        """Computes a path for each pair of locations.

        Parameters
        ----------
        pairs
            Pairs of locations, or an array of vertices of the shape (k, 2).
        """
        return [self._path(path) for path in self._core.paths(pairs)]

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
        sources: ManyLocations,
        targets: ManyLocations | None = None,
        *,
        max_distance: float = math.inf,
        method: str = "auto",
        threads: int | None = None,
        callback: Callback | None = None,
    ) -> Floats:
        """Computes the distance from each source to each target.

        Parameters
        ----------
        sources
            A location, or a range of them: the rows.
        targets
            A location, or a range of either vertices or other locations: the columns. By default,
            the sources.
        max_distance
            Targets farther than this distance are infinitely far.
        method
            As for ``solver()``.
        threads
            The number of threads. By default, that of the hardware. Results do not depend on it.
        callback
            A function that takes the completed fraction, called before each row. It and Ctrl-C
            cancel the computation before the next row.

        Returns
        -------
        The distances, shape (k, l), stored by columns.
        """
        return self._core.distance_matrix(
            sources, targets, max_distance, method, threads, callback
        )

    def farthest_points(
        self,
        n: int | None = None,
        radius: float | None = None,
        *,
        first: ManyLocations | None = None,
        speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> Samples:
        """Distributes samples evenly: each sample has the largest distance to the previous ones.

        Parameters
        ----------
        n
            The number of samples. By default, samples are added until ``radius`` is reached.
        radius
            Sampling stops if each vertex has a sample within this distance.
        first
            Existing samples: a location, or a range of either vertices or other locations.
        speed
            Shape (n,): samples are denser in regions of low speed.
        callback
            A function that takes the completed fraction.
        """
        indices, coordinates, radii, labels = self._core.farthest_points(
            n, radius, first, speed, callback
        )
        return Samples(Locations(indices, coordinates), radii, labels)

    def voronoi(
        self,
        seeds: ManyLocations,
        *,
        speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> Voronoi:
        """Computes the nearest seed of each vertex, and on a mesh the lines between the cells.

        Parameters
        ----------
        seeds
            A location, or a range of them.
        speed
            Shape (n,): the speed at the vertices.
        callback
            A function that takes the completed fraction.
        """
        if isinstance(self._core, _core.Cloud):
            labels = self._core.voronoi(seeds, speed, callback)
            return Voronoi(labels, np.empty(0, np.int64), [])
        labels, face_labels, lines = self._core.voronoi(seeds, speed, callback)
        return Voronoi(labels, face_labels, [Bisector(*line) for line in lines])

    def isolines(
        self, values: ArrayLike, levels: ArrayLike, *, fit_circles: bool = False
    ) -> list[Isoline]:
        """Computes the isolines of a function on a mesh that is linear in each face.

        Parameters
        ----------
        values
            Shape (n,): the values of the vertices. They can be infinite.
        levels
            Shape (k,), finite: the values of the isolines.
        fit_circles
            Whether values are interpolated along edges like distances from a point in the plane.
        """
        lines = self._mesh("isolines").isolines(values, levels, bool(fit_circles))
        return [Isoline(*line) for line in lines]

    def _mesh(self, name: str) -> _core.Mesh:
        if isinstance(self._core, _core.Cloud):
            raise UnsupportedSurfaceError(f"A cloud has no faces; {name} needs a mesh.")
        return self._core

    def _path(self, arrays: _core._PathArrays) -> Path | SurfelPath:
        points, indices, coordinates, length, lower, distance = arrays
        if len(points) == 0:
            length = lower = math.inf
        if self.is_cloud:
            return SurfelPath(points, indices, coordinates, length, lower, distance)
        return Path(points, indices, coordinates, length, lower, distance)


class Solver:
    """Computes distances from different sources on one surface. See ``Surface.solver()``.

    Members except for ``compute()`` refer to its last call. Before the first call, no vertex is
    reached.
    """

    def __init__(self, surface: Surface, method: str = "auto") -> None:
        self.surface = surface
        self._core = surface._core.solver(method)

    def compute(
        self,
        sources: ManyLocations,
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


def read(path: str | os.PathLike[str]) -> Surface:
    """Reads a surface from a file: a mesh if it has faces, otherwise a cloud.

    Formats: PLY, OFF, OBJ, STL, XYZ, PWN, VTP, GLB, glTF, GIFTI and FreeSurfer, also compressed by
    gzip. If a cloud has no normals, they are estimated.

    Raises
    ------
    FileError
        If the file cannot be read. It is a subclass of ``OSError`` and ``ValueError``.
    """
    return Surface._of(_core.read(os.fspath(path)))
