# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fuzzy geodesics."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from ._base import Base
from ._types import Callback, Floats, OneLocation


class FuzzyGeodesic(NamedTuple):
    """A fuzzy geodesic, and the cost of transporting a unit mass along it."""

    likelihood: Floats
    """Shape (n,): the likelihood that geodesics pass each vertex, from 0 to 1."""
    value: float
    """The cost: the mean of ``lower`` and ``upper``."""
    lower: float
    """A certified lower bound of the cost."""
    upper: float
    """A certified upper bound of the cost for flows that are constant in each face."""
    estimate: float
    """The cost that is extrapolated from the last two refinement levels, not certified."""
    number_of_iterations: int
    """The number of iterations on the finest level."""
    residual: float
    """The largest difference of the divergence of the flow and the masses, relative to the mass."""
    is_converged: bool
    """Whether the gap between the bounds is within the tolerance."""


class FuzzyGeodesics(Base):
    """The functions of a surface for fuzzy geodesics."""

    def fuzzy_geodesic(
        self,
        a: OneLocation,
        b: OneLocation,
        width: float | None = None,
        *,
        method: str = "interior-point",
        tolerance: float = 1e-3,
        number_of_refinements: int | None = None,
        speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> FuzzyGeodesic:
        """Computes the likelihood that geodesics between two neighborhoods pass each vertex.

        It is the amount of flow between Gaussian mass distributions around two locations, scaled to
        a maximum of 1.

        Parameters
        ----------
        a, b
            Locations.
        width
            The standard deviation of the Gaussians, a length; at least an edge length is useful. By
            default, a twentieth of the distance of the locations.
        method
            As for ``emd()``.
        tolerance
            The gap between the bounds of the cost, relative to the upper bound, at which the
            iteration ends.
        number_of_refinements
            The number of 1-to-4 subdivisions of each triangle. By default, 1 up to 5000 vertices,
            otherwise 0.
        speed
            Shape (n,): the speed at the vertices; the cost of a path is its travel time.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, no path connects the locations, or the width is zero, as by
            default for equal locations.
        UnsupportedSurfaceError
            If no triangle has an area, or if the refined surface is too large.
        Cancelled
            If the callback returns a false value.

        Takes the time of an earth mover's distance and two distance computations.
        """
        return FuzzyGeodesic(
            *self._core.fuzzy_geodesic(
                a, b, width, method, tolerance, number_of_refinements, speed, callback
            )
        )

    def fuzzy_geodesic_by_distances(
        self,
        a: OneLocation,
        b: OneLocation,
        width: float | None = None,
        *,
        method: str = "auto",
        speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> Floats:
        """Computes how short the detour through each vertex is.

        It is exp(-|d(a, x) + d(x, b) - d(a, b)| / width) for the distance d.

        Parameters
        ----------
        a, b
            Locations.
        width
            A length. By default, a twentieth of the distance of the locations.
        method
            The method of the distances, as for ``distance()``.
        speed
            Shape (n,): the speed at the vertices; distances are travel times.
        callback
            A function that takes the completed fraction.

        Returns
        -------
        The likelihoods, shape (n,), from 0 to 1.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, no path connects the locations, or the width is zero, as by
            default for equal locations.
        Cancelled
            If the callback returns a false value.

        Takes two distance computations.
        """
        return self._core.fuzzy_geodesic_by_distances(a, b, width, method, speed, callback)
