# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves on surfaces."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from numpy.typing import ArrayLike

from . import _core
from ._distances import Distances, Path, SurfelPath
from ._types import Callback, Floats, Integers, Locations, ManyLocations, OneLocation

if TYPE_CHECKING:
    from ._surface import Surface


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


class SplitMesh(NamedTuple):
    """A copy of a mesh that is split along isolines."""

    surface: Surface
    """The copy. Its first points are the points of the mesh, without merged points."""
    labels: Integers
    """Shape (m,): the number of levels that are at most the values in the interior of each face;
    -1 if a value in the face is not finite."""
    locations: Locations
    """The location on the original mesh of each point of the copy. The face of a point without
    faces is -1."""
    edges: Integers
    """Shape (k, 2): the edges of the copy that are on isolines, as pairs of points."""


class PolylinePath(NamedTuple):
    """A path through points in a given order."""

    path: Path | SurfelPath
    """The path. Its length and its bound are the sums of those of its parts."""
    corners: Integers
    """Shape (k,): the rows of ``path.points`` that are the given points. If the path is closed, the
    last row is one more corner."""


class Loop(NamedTuple):
    """A closed curve on a mesh. It has no points if there is no such curve."""

    points: Floats
    """Shape (k, 3): the polyline. The last point equals the first one. A single point is a curve
    that is shrunk to this point."""
    faces: Integers
    """Shape (k,): a face that contains the point."""
    barycentric: Floats
    """Shape (k, 3): the barycentric coordinates of the points."""
    length: float
    """The length of the curve; infinite if there is no curve."""

    @property
    def is_point(self) -> bool:
        """Whether the curve is shrunk to a point."""
        return len(self.points) == 1


class Curves(Distances):
    """The functions of a surface for curves."""

    def isolines(
        self,
        values: ArrayLike,
        levels: ArrayLike,
        *,
        fit_circles: bool = False,
        callback: Callback | None = None,
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
        callback
            A function that takes the completed fraction.
        """
        lines = self._mesh("isolines").isolines(values, levels, bool(fit_circles), callback)
        return [Isoline(*line) for line in lines]

    def split_at_isolines(
        self, values: ArrayLike, levels: ArrayLike, *, fit_circles: bool = False
    ) -> SplitMesh:
        """Splits a copy of a mesh along isolines, so that each face is between two levels.

        The isolines are those of ``isolines()``. Each face of the copy is a part of a face of the
        mesh and has its orientation. A vertex with the value of a level counts as above the level.
        Edges with a value that is not finite are not split.

        Parameters
        ----------
        values, levels, fit_circles
            As for ``isolines()``.

        Takes O(n log k + m) time for k levels and m new points.
        """
        mesh = self._mesh("split_at_isolines")
        core, labels, locations, edges = mesh.split_at_isolines(values, levels, bool(fit_circles))
        return SplitMesh(self._new(core), labels, Locations(*locations), edges)

    def polyline(self, points: ManyLocations, *, close: bool = False) -> PolylinePath:
        """Computes the shortest path that passes through points in a given order.

        The path consists of paths as by ``path()`` and has corners at the points. The functions
        ``shorten_polyline()`` and ``shorten_loop()`` remove the corners.

        Parameters
        ----------
        points
            At least two locations. ``locate()`` returns those of points in space.
        close
            Whether the path returns from the last point to the first one.

        Returns
        -------
        The path. It has no points if two consecutive points are not connected.

        On a cloud, each call takes O(n log n) time to prepare the search.
        """
        path, corners = self._core.polyline(points, bool(close))
        return PolylinePath(self._path(path), corners)

    def shorten_polyline(self, points: ManyLocations) -> Path | SurfelPath:
        """Shortens a polyline to a locally shortest path with the same ends.

        On a mesh, the path has the homotopy type of the polyline. Short paths join consecutive
        points that have no common face.

        Parameters
        ----------
        points
            At least two locations.

        Returns
        -------
        The path. It has no points if two consecutive points are not connected.
        """
        return self._path(self._core.shorten_polyline(points))

    def shorten_loop(self, points: ManyLocations) -> Loop:
        """Shortens a closed curve on a mesh to a locally shortest one in its free homotopy class.

        If the curve is contractible, the result is a point.

        Parameters
        ----------
        points
            At least one location. The last one is joined to the first one. Short paths join
            consecutive points that have no common face.

        Returns
        -------
        The curve. It has no points if two consecutive points are not connected.

        Takes O(m) time for m faces, and a multiple of the number of crossed faces.
        """
        return _loop(self._mesh("shorten_loop").shorten_loop(points))

    def loop_basis(self, *, shorten: bool = True) -> list[Loop]:
        """Computes closed curves that are a basis of the first homology group of a mesh.

        Each component of genus g with b boundary cycles has ``2 * g + max(b - 1, 0)`` loops.

        Parameters
        ----------
        shorten
            Whether the loops are shortened. Otherwise they run along edges.

        Takes O(m log m) time for m faces, and the time of ``shorten_loop()`` for each loop.
        """
        return [_loop(loop) for loop in self._mesh("loop_basis").loop_basis(bool(shorten))]

    def shortest_noncontractible_loop(self, through: OneLocation) -> Loop:
        """Computes a shortest closed curve through a location that is not contractible.

        The curve begins and ends at the location, where it can have a corner. Its length is exact
        up to round-off errors.

        Parameters
        ----------
        through
            A location on a mesh.

        Returns
        -------
        The curve. It has no points if all curves through the location are contractible.
        """
        mesh = self._mesh("shortest_noncontractible_loop")
        return _loop(mesh.shortest_noncontractible_loop(through))

    def bezier_curve(
        self,
        control_points: ManyLocations,
        *,
        number_of_subdivisions: int = 6,
        callback: Callback | None = None,
    ) -> Path:
        """Computes a Bezier curve on a mesh.

        The curve begins at the first control point and ends at the last one. In the algorithm of
        de Casteljau, midpoints are those of shortest paths.

        Parameters
        ----------
        control_points
            At least two locations. The degree is their number minus one.
        number_of_subdivisions
            A number k of at most 20. The result joins 2^k + 1 points of the curve by shortest
            paths.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if two consecutive control points are not connected.

        For degree p, computes 2^k (1 + p (p + 1) / 2) shortest paths.
        """
        mesh = self._mesh("bezier_curve")
        return Path(*mesh.bezier_curve(control_points, number_of_subdivisions, callback))

    def spline(
        self,
        control_points: ManyLocations,
        *,
        degree: int = 3,
        is_closed: bool = False,
        number_of_subdivisions: int = 6,
        callback: Callback | None = None,
    ) -> Path:
        """Computes a uniform B-spline on a mesh.

        An open spline begins at the first control point and ends at the last one.

        Parameters
        ----------
        control_points
            At least two locations.
        degree
            The degree, at least 1 and at most 1000.
        is_closed
            Whether the spline is a closed curve. Then its last point equals the first one.
        number_of_subdivisions
            A number k of at most 20. The result joins the control points of the last subdivision by
            shortest paths.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if two consecutive control points are not connected.

        For l control points and degree p, computes about 2^k l (2 p + 1) shortest paths.
        """
        mesh = self._mesh("spline")
        arrays = mesh.spline(
            control_points, degree, bool(is_closed), number_of_subdivisions, callback
        )
        return Path(*arrays)


def _loop(arrays: _core._LoopArrays) -> Loop:
    points, faces, barycentric, length = arrays
    return Loop(points, faces, barycentric, length if len(points) > 0 else math.inf)
