# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples and Voronoi cells."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._base import Base
from ._types import Callback, Floats, Integers, Locations, ManyLocations, ManySources


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


class Sampling(Base):
    """The functions of a surface for samples and cells."""

    def farthest_points(
        self,
        n: int | None = None,
        radius: float | None = None,
        *,
        first: ManyLocations | None = None,
        method: str = "auto",
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
        method
            The front: ``"euclidean"``, which ``"auto"`` selects, ``"fast-marching"`` or
            ``"dijkstra"``.
        speed
            Shape (n,): samples are denser in regions of low speed.
        callback
            A function that takes the completed fraction.
        """
        indices, coordinates, radii, labels = self._core.farthest_points(
            n, radius, first, method, speed, callback
        )
        return Samples(Locations(indices, coordinates), radii, labels)

    def voronoi(
        self,
        seeds: ManySources,
        *,
        method: str = "auto",
        speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> Voronoi:
        """Computes the nearest seed of each vertex, and on a mesh the lines between the cells.

        Parameters
        ----------
        seeds
            A location, a ``Polyline``, or a range of them.
        method
            As for ``farthest_points()``.
        speed
            Shape (n,): the speed at the vertices.
        callback
            A function that takes the completed fraction.
        """
        if isinstance(self._core, _core.Cloud):
            labels = self._core.voronoi(seeds, method, speed, callback)
            return Voronoi(labels, np.empty(0, np.int64), [])
        labels, face_labels, lines = self._core.voronoi(seeds, method, speed, callback)
        return Voronoi(labels, face_labels, [Bisector(*line) for line in lines])
