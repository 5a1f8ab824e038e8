# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distortion of maps to the plane."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._base import Base
from ._core import InvalidArgumentError
from ._types import Callback, Floats, Location, Locations, SurfelLocation


class FaceDistortion(NamedTuple):
    """The distortion of all faces: singular values of the Jacobians from the plane to the faces."""

    sigma_1: Floats
    """Shape (m,): the larger singular value; infinite if the image has no area."""
    sigma_2: Floats
    """Shape (m,): the smaller singular value; infinite if the image has no area."""
    is_inverted: NDArray[np.bool_]
    """Shape (m,): whether the image is clockwise."""
    area: Floats
    """Shape (m,): the area of the face on the surface."""


class SurfaceDistortion(NamedTuple):
    """A distortion measure, summarized over all triangles that have an image."""

    integral: float
    """The integral of the measure over the area of the triangles."""
    area: float
    """The total area of these triangles."""
    mean: float
    """The integral divided by the area; NaN if there is no area."""
    worst: float
    """The largest value of the measure."""
    worst_location: Location | SurfelLocation | None
    """The center of a triangle with this value; None if no triangle has an image."""
    number_of_triangles: int
    """The number of these triangles."""
    number_of_flips: int
    """The number of triangles whose image is clockwise."""


class DistortionMinimum(NamedTuple):
    """A map to the plane with minimal distortion."""

    uv: Floats
    """Shape (n, 2): the images of the vertices."""
    number_of_flips_before: int
    """The number of inverted or degenerate faces of the given map."""
    number_of_flips: int
    """The number of inverted or degenerate faces of the new map."""
    number_of_iterations: int
    """The number of steps of Newton's method."""
    symmetric_dirichlet: float
    """The final mean energy per area, at least 4."""


def _rows(uv: ArrayLike) -> tuple[Any, bool]:
    """Returns the images as rows, and whether these are the corners of faces."""
    if getattr(uv, "ndim", 2) != 3:
        return uv, False
    array = np.asarray(uv)
    if array.shape[1:] != (3, 2):
        raise InvalidArgumentError(
            f"uv has the shape {array.shape}, but its shape must be (n, 2) or (m, 3, 2)."
        )
    return array.reshape(-1, 2), True


class Distortion(Base):
    """The functions of a surface for the distortion of maps."""

    def face_distortion(self, uv: ArrayLike) -> FaceDistortion:
        """Computes the distortion of each face of a mesh by a map to the plane.

        Parameters
        ----------
        uv
            Shape (n, 2): the images of the vertices. Or an array of the shape (m, 3, 2): the images
            of the corners of the faces.

        Takes O(n) time.
        """
        mesh = self._mesh("face_distortion")
        return FaceDistortion(*mesh.face_distortion(*_rows(uv)))

    def surface_distortion(
        self, uv: ArrayLike, measure: str = "symmetric-dirichlet"
    ) -> SurfaceDistortion:
        """Computes the integral, the mean and the maximum of a distortion measure.

        Let s1 >= s2 be the singular values of the Jacobian from the plane to a triangle.

        Parameters
        ----------
        uv
            As for ``face_distortion()``; on a cloud the images of the surfels, shape (n, 2). A
            triangle is ignored if the image of a corner is NaN.
        measure
            - ``"mips"``: s1 / s2
            - ``"symmetric-mips"``: s1 / s2 + s2 / s1
            - ``"conformal"``: (s1 - s2)^2 / 2
            - ``"green-lagrange"``: (s1^2 - 1)^2 + (s2^2 - 1)^2
            - ``"dirichlet"``: (s1^2 + s2^2) / 2
            - ``"l2-stretch"``: the square root of ``"dirichlet"``
            - ``"linf-stretch"``: s1
            - ``"symmetric-stretch"``: the maximum of s1 and 1 / s2
            - ``"symmetric-dirichlet"``: s1^2 + s2^2 + 1 / s1^2 + 1 / s2^2
            - ``"riemannian"``: 2 (log(s1)^2 + log(s2)^2)^(1/2)

            All of them are infinite if the image has no area.

        Takes O(n) time.
        """
        rows, has_corners = _rows(uv)
        if has_corners:
            self._mesh("uv of corners")
        integral, area, mean, worst, (indices, coordinates), triangles, flips = (
            self._core.surface_distortion(rows, has_corners, measure)
        )
        location = Locations(indices, coordinates)[0] if triangles > 0 else None
        return SurfaceDistortion(integral, area, mean, worst, location, triangles, flips)

    def minimize_distortion(
        self,
        uv: ArrayLike,
        *,
        max_iterations: int = 200,
        callback: Callback | None = None,
    ) -> DistortionMinimum:
        """Minimizes the symmetric Dirichlet energy of a map of a mesh to the plane without
        inverting faces.

        Inverted faces of the given map are unflipped first. If this fails, Tutte's map replaces it.

        Parameters
        ----------
        uv
            Shape (n, 2), finite: the images of the vertices. It is not modified.
        max_iterations
            The maximum number of Newton steps.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If a value is not finite.
        UnsupportedSurfaceError
            If the surface is a cloud, is not connected, has no boundary, has handles, or touches
            itself at a vertex.
        Cancelled
            If the callback returns a false value.

        Each step takes a factorization of a matrix with two unknowns per vertex.
        """
        mesh = self._mesh("minimize_distortion")
        return DistortionMinimum(*mesh.minimize_distortion(uv, max_iterations, callback))
