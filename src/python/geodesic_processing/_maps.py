# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Logarithmic and exponential maps, straightest geodesics and means."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._base import Base
from ._types import (
    Callback,
    Floats,
    Integers,
    Location,
    Locations,
    ManyLocations,
    OneLocation,
    SurfelLocation,
)


class Frame(NamedTuple):
    """A tangent plane in space."""

    origin: Floats
    """Shape (3,): the base point."""
    u: Floats
    """Shape (3,): the unit vector along the first axis."""
    v: Floats
    """Shape (3,): the unit vector along the second axis."""

    @property
    def normal(self) -> Floats:
        """Shape (3,): the unit normal, the cross product of ``u`` and ``v``."""
        return np.cross(self.u, self.v)


class LogMap(NamedTuple):
    """A logarithmic map."""

    uv: Floats
    """Shape (n, 2): the tangent vector of each vertex, along the axes of ``frame``. Its length is
    the distance from the base point. NaN outside the map."""
    frame: Frame
    """The tangent plane at the base point."""
    reached: Integers
    """Shape (k,): the vertices inside the map, approximately ordered by distance."""
    cut_faces: Integers
    """Shape (c,): the faces that are cut. The images of two of their corners are farther apart than
    four times the length of their edge. Beyond these faces, the map is not injective. Empty on
    clouds."""
    number_of_cut_faces: int
    """The number of faces that are cut; on clouds, of triangles."""
    number_of_flips: int
    """The number of inverted faces among those that are not cut."""


class StraightestGeodesic(NamedTuple):
    """A straightest geodesic."""

    points: Floats
    """Shape (k, 3): the polyline."""
    locations: Locations
    """The locations of the points. On a cloud, the projections of the points to the tangent planes
    of the nearest surfels."""
    length: float
    """The length of the path; on a cloud, of the smooth curve through the points."""
    is_cut_by_boundary: bool
    """Whether the path ends at the boundary, shorter than requested."""


class KarcherMean(NamedTuple):
    """A Karcher mean."""

    location: Location | SurfelLocation
    """The mean. At a vertex without faces, its face is -1."""
    point: Floats
    """Shape (3,): the point of the mean; on a cloud, a point of the fitted surface."""
    value: float
    """The weighted sum of squared distances."""
    gradient_norm: float
    """The norm of the gradient of half the value divided by the sum of the weights, a length. At a
    vertex or at the boundary of a mesh, minus the smallest directional derivative, or 0 if no
    direction decreases the value."""
    is_converged: bool
    """Whether ``gradient_norm`` is within the tolerance."""
    number_of_iterations: int
    """The number of steps."""


class Maps(Base):
    """The functions of a surface for logarithmic maps and straightest geodesics."""

    def log_map(
        self,
        base: OneLocation,
        radius: float | None = None,
        up: ArrayLike | None = None,
        *,
        method: str = "gradient",
        stencil_length: float | None = None,
        stencil_size: int = 8,
        number_of_smoothing_steps: int = 0,
        number_of_base_refinements: int = 0,
    ) -> LogMap:
        """Computes the logarithmic map: Riemannian normal coordinates around a base point.

        Parameters
        ----------
        base
            A location.
        radius
            Vertices farther than this distance are outside the map. By default, infinite.
        up
            Shape (3,): a vector in space. The second axis of the map is its projection to the
            tangent plane. By default, the first axis points along an edge.
        method
            - ``"gradient"``: from the gradient of the squared distance at the base point
            - ``"exact"``: from the directions of shortest paths; on meshes only
            - ``"discrete-exponential"``: along edge paths; its errors need not converge to zero
        stencil_length
            The distance from the base point to the stencil of ``"gradient"``. By default, 0.6 to 4
            mean lengths of the edges at the base point; 2.5 on a cloud.
        stencil_size
            The number of locations of the stencil, at least 3.
        number_of_smoothing_steps
            The number of steps, at most 1000, in which ``"gradient"`` smooths squared distances
            before it differentiates them. They change directions only.
        number_of_base_refinements
            How many times, at most 8, ``"gradient"`` halves the edges around the base point of a
            mesh for its computation.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, the base point is a vertex without faces, or ``up`` is normal
            to the surface.
        UnsupportedSurfaceError
            If the method supports neither the surface nor smoothing steps or refinements.

        ``"gradient"`` takes the time of a distance computation for the base point and for each
        location of the stencil, ``"exact"`` that of one exact computation.
        """
        uv, frame, reached, cut_faces, number_of_cut_faces, number_of_flips = self._core.log_map(
            base,
            radius,
            up,
            method,
            stencil_length,
            stencil_size,
            number_of_smoothing_steps,
            number_of_base_refinements,
        )
        return LogMap(uv, Frame(*frame), reached, cut_faces, number_of_cut_faces, number_of_flips)

    def exp_map(
        self, base: OneLocation, uv: ArrayLike, *, up: ArrayLike | None = None
    ) -> Locations:
        """Computes the exponential map: the endpoints of straightest geodesics.

        It is the inverse of ``log_map()``: both have the same axes if they have the same ``up``, or
        none. Beyond the injectivity radius, geodesics continue straight. They end at the boundary.

        Parameters
        ----------
        base
            A location.
        uv
            Shape (k, 2), finite: tangent vectors. Their lengths are those of the geodesics.
        up
            As for ``log_map()``.

        Takes time linear in the number of crossed faces. On a cloud, each call fits a surface to
        the surfels in O(n log n) time.
        """
        return Locations(*self._core.exp_map(base, uv, up))

    def trace(
        self, start: OneLocation, vector: ArrayLike, *, length: float | None = None
    ) -> StraightestGeodesic:
        """Traces the straightest geodesic from a location in a direction.

        Parameters
        ----------
        start
            A location.
        vector
            Shape (3,): a vector in space, which is projected to the plane of the face, or to the
            tangent plane. At a vertex, the face is the one that contains the projection.
        length
            The length of the path, finite and not negative. By default, that of ``vector`` in
            space.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the vector is normal to the surface.
        UnsupportedSurfaceError
            If the path crosses too many thin triangles.

        Takes time linear in the number of crossed faces. On a cloud, each call fits a surface to
        the surfels in O(n log n) time.
        """
        points, locations, path_length, is_cut = self._core.trace(start, vector, length)
        return StraightestGeodesic(points, Locations(*locations), path_length, is_cut)

    def karcher_mean(
        self,
        points: ManyLocations,
        weights: ArrayLike | None = None,
        *,
        initial_location: OneLocation | None = None,
        tolerance: float | None = None,
        max_iterations: int = 100,
        threads: int | None = None,
        callback: Callback | None = None,
    ) -> KarcherMean:
        """Computes the Karcher mean: a local minimum of the weighted sum of squared distances.

        Parameters
        ----------
        points
            A location, or a range of either vertices or other locations.
        weights
            Shape (k,): nonnegative numbers, not all zero. By default, 1 each.
        initial_location
            The location at which the iteration starts. By default, the best of at most eight
            candidates among all vertices.
        tolerance
            The iteration ends if ``gradient_norm`` is at most this fraction of the distance to the
            farthest point. By default, 1e-8 on a mesh and 1e-5 on a cloud.
        max_iterations
            The maximum number of steps.
        threads
            The number of threads on a cloud. By default, that of the hardware.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the points are not in one component.

        On a mesh, a step takes one exact computation up to the farthest point. On a cloud, it
        traces about two geodesics for each point.
        """
        arrays, point, value, gradient_norm, is_converged, steps = self._core.karcher_mean(
            points, weights, initial_location, tolerance, max_iterations, threads, callback
        )
        location = Locations(*arrays)[0]
        return KarcherMean(location, point, value, gradient_norm, is_converged, steps)
