# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature, and speeds that depend on it."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._base import Base
from ._types import Floats


class PrincipalCurvatures(NamedTuple):
    """The principal curvatures and directions of all vertices. The unit of curvatures is the
    inverse of that of the coordinates. They are positive on a sphere with outward normals."""

    min_curvature: Floats
    """Shape (n,): the smaller principal curvature."""
    max_curvature: Floats
    """Shape (n,): the larger principal curvature."""
    min_direction: Floats
    """Shape (n, 3): the unit vector in whose direction the curvature is ``min_curvature``; zero if
    it is undefined, as at isolated vertices."""
    max_direction: Floats
    """Shape (n, 3): the unit vector for ``max_curvature``, orthogonal to ``min_direction``."""


class Curvature(Base):
    """The functions of a surface for curvatures and speeds."""

    def principal_curvatures(
        self, ball_radius: float | None = None, *, threads: int | None = None
    ) -> PrincipalCurvatures:
        """Estimates the principal curvatures and directions at each vertex.

        Parameters
        ----------
        ball_radius
            The radius of the geodesic ball over which curvatures are averaged. A larger ball
            reduces both noise and detail. By default, three times the mean length of the incident
            edges.
        threads
            The number of threads. By default, that of the hardware. Results do not depend on it.

        Takes O(n b) time for b vertices per ball.
        """
        return PrincipalCurvatures(*self._core.principal_curvatures(ball_radius, threads))

    def curvature_speeds(
        self,
        kind: str = "attractive",
        *,
        strength: float | None = None,
        ball_radius: float | None = None,
        threads: int | None = None,
    ) -> Floats:
        """Computes speeds from the curvature, such that samples and cells adapt to the shape.

        Parameters
        ----------
        kind
            - ``"attractive"``: speeds are low at creases, where samples concentrate
            - ``"repulsive"``: speeds are high at creases, which samples avoid
        strength
            The factor of the curvature. By default, the speed is 1/2 or 2 if the curvature is that
            of a sphere of the same area.
        ball_radius, threads
            As for ``principal_curvatures()``, with the same time.

        Returns
        -------
        Positive speeds, shape (n,). They do not change if the surface is scaled.
        """
        return self._core.curvature_speeds(kind, strength, ball_radius, threads)

    def similar_curvature_speeds(
        self,
        vertex: int | np.integer[Any],
        *,
        strength: float | None = None,
        ball_radius: float | None = None,
        threads: int | None = None,
    ) -> Floats:
        """Computes speeds that are high if the mean curvature is similar to that at a vertex.

        Paths that start on a ridge tend to follow ridges.

        Parameters
        ----------
        vertex
            A vertex, at which the speed is 1.
        strength, ball_radius, threads
            As for ``curvature_speeds()``, with the same time.

        Returns
        -------
        Speeds in (0, 1], shape (n,). They do not change if the surface is scaled.
        """
        return self._core.similar_curvature_speeds(vertex, strength, ball_radius, threads)

    def image_speeds(self, image: ArrayLike, *, strength: float | None = None) -> Floats:
        """Computes speeds that are low if the gradient of an image on the surface is large.

        Parameters
        ----------
        image
            Shape (n,) or (n, 3), finite: a gray value or a color for each vertex.
        strength
            The factor of the relative gradient. By default 20: the minimum speed is 1/21.

        Returns
        -------
        Speeds in (0, 1], shape (n,). They do not change if the surface or the image is scaled.

        Takes O(n) time.
        """
        return self._core.image_speeds(image, strength)
