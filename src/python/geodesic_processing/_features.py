# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances to features by optimal transport."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from ._base import Base
from ._types import Callback, Floats, ManyLocations


class FeatureDistance(NamedTuple):
    """The distance to a feature, and its integral over the surface with certified bounds."""

    distances: Floats
    """Shape (n,): the distance of each vertex; infinite if no path leads to the feature."""
    value: float
    """The mean of the bounds of the integral of the distance, over all points with a path to the
    feature; with fixed masses, the cost of the transport to them."""
    lower: float
    """A certified lower bound of the integral."""
    upper: float
    """A certified upper bound for flows that are constant in each face."""
    estimate: float
    """The value extrapolated from the last two refinement levels, not certified."""
    number_of_iterations: int
    """The number of iterations on the finest level."""
    residual: float
    """The largest difference of the divergence of the flow and the masses, relative to the total
    mass that is moved."""
    is_converged: bool
    """Whether the gap between the bounds is within the tolerance."""


class Features(Base):
    """The functions of a surface for distances to features."""

    def feature_distance(
        self,
        feature: ManyLocations,
        *,
        fix_masses: bool = False,
        speed: ArrayLike | None = None,
        refinements: int | None = None,
        tolerance: float = 0.001,
        callback: Callback | None = None,
    ) -> FeatureDistance:
        """Computes the distance to a feature: minus the potential of a uniform mass that is
        transported to the feature.

        The distance is never above the geodesic distance, and smaller by a fraction of an edge.

        Parameters
        ----------
        feature
            A location, or a range of them.
        fix_masses
            Whether the arriving mass is distributed uniformly over the feature. The result is then
            a distance only if the feature is a point.
        speed
            Shape (n,): the speed at the vertices.
        refinements
            The number of 1-to-4 subdivisions of each triangle. By default, 1 up to 5,000 vertices
            and otherwise 0.
        tolerance
            The gap between the bounds, relative to the upper bound, at which the iteration ends.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid.
        UnsupportedSurfaceError
            If no triangle has an area, or if the refined surface is too large.
        Cancelled
            If the callback returns a false value.

        Takes 10 to 25 iterations of O(n^1.5) time each.
        """
        return FeatureDistance(
            *self._core.feature_distance(
                feature, bool(fix_masses), speed, refinements, tolerance, callback
            )
        )
