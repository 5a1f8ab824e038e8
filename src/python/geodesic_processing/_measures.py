# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Balls, extents, and derivatives of distances."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._core import InvalidArgumentError
from ._curves import Isoline
from ._distances import Distances
from ._types import Callback, Floats, Integers, ManyLocations, OneLocation


class Ball(NamedTuple):
    """The points of a mesh whose distance to the nearest center is at most a radius."""

    faces: Integers
    """Shape (k,): the faces whose three corners are in the ball."""
    area: float
    """The area of the ball, in squared units of the coordinates."""
    circles: list[Isoline]
    """The boundary of the ball, without the part on the boundary of the mesh. The ball is on the
    right, seen from outside."""


class Eccentricity(NamedTuple):
    """The largest distance of a vertex from a source."""

    value: float
    """The distance."""
    farthest: int
    """A vertex at this distance."""


class Diameter(NamedTuple):
    """Certified bounds of the largest distance between two vertices of a mesh."""

    lower: float
    """The distance between ``start`` and ``end``."""
    upper: float
    """The diameter is at most this value."""
    start: int
    """A vertex: one end of a long shortest path."""
    end: int
    """The vertex at the other end."""
    is_converged: bool
    """Whether ``upper`` is at most ``lower * (1 + relative_tolerance)``."""
    number_of_iterations: int
    """The number of vertices whose distances were computed."""


class Radius(NamedTuple):
    """Certified bounds of the smallest eccentricity of a vertex of a mesh."""

    lower: float
    """The radius is at least this value."""
    upper: float
    """The eccentricity of ``center``."""
    center: int
    """A vertex from which no vertex is farther than ``upper``."""
    farthest: int
    """A vertex that is farthest from the center."""
    is_converged: bool
    """Whether ``upper`` is at most ``lower * (1 + relative_tolerance)``."""
    number_of_iterations: int
    """The number of vertices whose distances were computed."""


class DistanceDerivatives(NamedTuple):
    """The distance between two locations on a mesh and its derivatives, which have no unit."""

    distance: float
    """The distance; infinite if no path connects both locations."""
    differentiability: str
    """``"differentiable"``, or the first test that fails: ``"unreachable"`` (no path connects the
    locations), ``"coincident"`` (they are the same point), ``"near-vertex"`` (the path is too close
    to a vertex) or ``"second-path"`` (another path has almost the same length). In the last two
    cases, the derivatives are those of one shortest path."""
    source_gradient: Floats
    """Shape (3,): the gradient with respect to the source, a unit tangent vector."""
    target_gradient: Floats
    """Shape (3,): the gradient with respect to the target, a unit tangent vector."""
    vertices: Integers
    """Shape (k,): the vertices on which the distance depends, in the order of the path."""
    vertex_gradients: Floats
    """Shape (k, 3): the gradients with respect to the positions of ``vertices``. The barycentric
    coordinates of both locations are constant. All other vertices have gradient zero."""

    @property
    def is_differentiable(self) -> bool:
        """Whether the distance is differentiable."""
        return self.differentiability == "differentiable"


class Measures(Distances):
    """The functions of a surface for balls, extents, and derivatives of distances."""

    def ball(
        self, centers: ManyLocations, radius: float, *, callback: Callback | None = None
    ) -> Ball:
        """Computes the geodesic ball around one or more centers on a mesh.

        Distances are exact. On flat and developable surfaces, the area is exact up to round-off
        errors in all faces that do not meet the cut locus. In other faces, the ball is bounded by
        the polyline of its circle.

        Parameters
        ----------
        centers
            A location, or a range of them.
        radius
            The radius, finite and not negative, in the unit of the coordinates.
        callback
            A function that takes the completed fraction.

        Takes two distance computations that end near the circle.
        """
        faces, area, circles = self._mesh("ball").ball(centers, radius, callback)
        return Ball(faces, area, [Isoline(*circle) for circle in circles])

    def eccentricity(
        self,
        sources: ManyLocations,
        *,
        method: str = "auto",
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        offsets: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> Eccentricity:
        """Computes the largest distance of a vertex from its nearest source.

        Vertices that are not reached are ignored. The parameters are those of ``distance()``. The
        eccentricity of several sources is their covering radius.

        Takes one distance computation.
        """
        solver = self.solver(method).compute(
            sources, speed=speed, face_speed=face_speed, offsets=offsets, callback=callback
        )
        reached = solver.reached
        distance = solver.distance()[reached]
        distance[np.isinf(distance)] = -math.inf
        if not np.isfinite(distance).any():
            raise InvalidArgumentError("No vertex is reached from the sources.")
        farthest = int(np.argmax(distance))
        return Eccentricity(float(distance[farthest]), int(reached[farthest]))

    def diameter(
        self,
        *,
        relative_tolerance: float = 0.01,
        max_iterations: int = 100,
        callback: Callback | None = None,
    ) -> Diameter:
        """Bounds the largest distance between two vertices of a component of a mesh.

        Exact distances from a few vertices bound all distances by the triangle inequality. If the
        mesh has several components, the diameter is the largest one of them.

        Parameters
        ----------
        relative_tolerance
            The computation ends if ``upper`` is at most ``lower * (1 + relative_tolerance)``. With
            zero, the result is the exact diameter.
        max_iterations
            The maximum number of vertices of each component from which distances are computed,
            positive. The bounds are also valid if it is reached.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid.
        UnsupportedSurfaceError
            If the surface is a cloud, or if exact distances exceed their limit of windows.

        Takes one exact distance computation for each iteration; 5 to 15 are usual.
        """
        mesh = self._mesh("diameter")
        return Diameter(*mesh.diameter(relative_tolerance, max_iterations, callback))

    def radius(
        self,
        *,
        relative_tolerance: float = 0.01,
        max_iterations: int = 100,
        callback: Callback | None = None,
    ) -> Radius:
        """Bounds the smallest eccentricity of a vertex of a mesh.

        If the mesh has several components, the radius is the largest one of them. The parameters
        and exceptions are those of ``diameter()``.

        Takes one exact distance computation for each iteration. If all eccentricities are similar,
        as on a sphere, the bounds converge slowly.
        """
        mesh = self._mesh("radius")
        return Radius(*mesh.radius(relative_tolerance, max_iterations, callback))

    def distance_derivatives(
        self,
        source: OneLocation,
        target: OneLocation,
        *,
        vertex_tolerance: float = 1e-4,
        second_path_tolerance: float = 1e-6,
    ) -> DistanceDerivatives:
        """Computes the exact distance between two locations on a mesh and its derivatives.

        Parameters
        ----------
        source, target
            Locations.
        vertex_tolerance
            The minimum distance of crossed edges from their ends, as a fraction of the length of
            the edge, and the minimum excess, in radians, of the angles at vertices where the path
            bends.
        second_path_tolerance
            The minimum excess of the length of another path, as a fraction of the distance.

        Takes one distance computation that stops at the target, and a search for a second path.
        """
        mesh = self._mesh("distance_derivatives")
        return DistanceDerivatives(
            *mesh.distance_derivatives(source, target, vertex_tolerance, second_path_tolerance)
        )
