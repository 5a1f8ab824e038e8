# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances in space, inside and outside of a closed mesh."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._base import Base
from ._transport import Transport, TransportCost
from ._types import Callback, Floats, Integers

CoordinateFunction = Callable[[Floats], ArrayLike]
"""A function of a point of the shape (3,) that returns its barycentric coordinates, shape (n,)."""


class VolumetricDistances(NamedTuple):
    """Distances from one point to many with certified bounds."""

    values: Floats
    """Shape (k,): the mean of the lower and the upper bound."""
    lower: Floats
    """Shape (k,): certified lower bounds."""
    upper: Floats
    """Shape (k,): certified upper bounds."""
    number_of_iterations: Integers
    """Shape (k,): the number of iterations for each point."""
    is_converged: NDArray[np.bool_]
    """Shape (k,): whether the gap between the bounds is within the tolerance."""


class VolumetricPath(NamedTuple):
    """A path in space that does not cross the surface."""

    points: Floats
    """Shape (k, 3): the polyline."""
    has_arrived: bool
    """Whether it reaches its end."""


class VolumetricMetric:
    """Distances between points in space. See ``Surface.volumetric_metric()``.

    It is immutable. Several threads can use it at the same time.
    """

    def __init__(
        self,
        surface: Volumes,
        *,
        number_of_refinements: int | None = None,
        barycentric_coordinates: CoordinateFunction | None = None,
    ) -> None:
        self.surface = surface
        mesh = surface._mesh("volumetric_metric")
        self._core: _core.Volumetric_metric = mesh.volumetric_metric(
            number_of_refinements, barycentric_coordinates
        )

    def distance(
        self,
        a: ArrayLike,
        b: ArrayLike,
        *,
        tolerance: float = 1e-3,
        max_iterations: int = 100,
        bound_from_above: bool = False,
        callback: Callback | None = None,
    ) -> Transport:
        """Computes the distance between two points.

        Parameters
        ----------
        a, b
            Shape (3,), finite: points in space.
        tolerance
            The gap between the bounds, relative to the upper bound, at which the iteration ends.
        max_iterations
            The maximum number of iterations.
        bound_from_above
            Whether ``upper_continuous`` is computed, which takes a few times as long.
        callback
            A function that takes the completed fraction.

        Returns
        -------
        The transport of the coordinates of one point to those of the other. The distance is
        ``cost.value``.

        Takes 5 to 20 iterations of O(n^1.5) time.
        """
        cost, potential, flow = self._core.cost(
            a, b, tolerance, max_iterations, bool(bound_from_above), callback
        )
        return Transport(TransportCost(*cost), potential, flow, None)

    def distances(
        self,
        a: ArrayLike,
        points: ArrayLike,
        *,
        tolerance: float = 0.02,
        threads: int | None = None,
        callback: Callback | None = None,
    ) -> VolumetricDistances:
        """Computes the distances from one point to many, in a tenth of the time of single queries.

        Parameters
        ----------
        a
            Shape (3,), finite: a point in space.
        points
            Shape (k, 3), finite: points in space.
        tolerance
            The maximum gap between the bounds, relative to the upper bound.
        threads
            The number of threads. By default, that of the hardware. Results do not depend on it.
        callback
            A function that takes the completed fraction.
        """
        return VolumetricDistances(*self._core.costs(a, points, tolerance, threads, callback))

    def path(self, a: ArrayLike, b: ArrayLike, *, max_iterations: int = 1000) -> VolumetricPath:
        """Computes a path by gradient descent of the distance to its end.

        The path does not cross the surface. In a bent cavity it follows the center line, and it is
        not the shortest path.

        Parameters
        ----------
        a, b
            Shape (3,), finite: the ends, both inside or both outside of the mesh.
        max_iterations
            The maximum number of distance computations along the path.

        Raises
        ------
        InvalidArgumentError
            If a point is on the surface, or if the surface separates the points.
        """
        return VolumetricPath(*self._core.path(a, b, max_iterations))


class Volumes(Base):
    """The functions of a surface for distances in space."""

    def volumetric_metric(
        self,
        *,
        number_of_refinements: int | None = None,
        barycentric_coordinates: CoordinateFunction | None = None,
    ) -> VolumetricMetric:
        """Prepares distances between points in space, inside and outside of a closed mesh.

        The distance of two points is the cost of transporting the barycentric coordinates of one
        point, as masses at the vertices, to those of the other point along the surface.

        Parameters
        ----------
        number_of_refinements
            As for ``emd()``.
        barycentric_coordinates
            A function of a point of the shape (3,) that returns one weight for each vertex, shape
            (n,). The weights sum to one, and the weighted sum of the vertices is the point. At a
            vertex, its weight is one. By default, mean value coordinates.

        Raises
        ------
        UnsupportedSurfaceError
            If the surface is a cloud, or if the mesh has a boundary or several components.

        Takes two factorizations, each about O(n^1.5) time.
        """
        return VolumetricMetric(
            self,
            number_of_refinements=number_of_refinements,
            barycentric_coordinates=barycentric_coordinates,
        )

    def volumetric_distance(
        self,
        a: ArrayLike,
        b: ArrayLike,
        *,
        number_of_refinements: int | None = None,
        barycentric_coordinates: CoordinateFunction | None = None,
        tolerance: float = 1e-3,
        max_iterations: int = 100,
        bound_from_above: bool = False,
        callback: Callback | None = None,
    ) -> Transport:
        """Computes the distance between two points in space.

        For many queries, use ``volumetric_metric()``, which is prepared only once.

        Parameters
        ----------
        a, b
            Shape (3,), finite: points in space.
        number_of_refinements, barycentric_coordinates
            As for ``volumetric_metric()``.
        tolerance, max_iterations, bound_from_above, callback
            As for ``VolumetricMetric.distance()``.

        Takes the time of ``volumetric_metric()`` and of ``VolumetricMetric.distance()``.
        """
        metric = self.volumetric_metric(
            number_of_refinements=number_of_refinements,
            barycentric_coordinates=barycentric_coordinates,
        )
        return metric.distance(
            a,
            b,
            tolerance=tolerance,
            max_iterations=max_iterations,
            bound_from_above=bound_from_above,
            callback=callback,
        )
