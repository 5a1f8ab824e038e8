# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples and Voronoi cells."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._base import Base
from ._types import Callback, Floats, Integers, Locations, ManyLocations, ManySources

if TYPE_CHECKING:
    from ._surface import Surface


class Samples(NamedTuple):
    """The result of farthest point sampling."""

    locations: Locations
    """The samples."""
    radii: Floats
    """Shape (k,): the covering radius after each sample."""
    labels: Integers
    """Shape (n,): the position of the nearest sample for each vertex, -1 if there is none. First
    samples have the first positions."""


class VertexSamples(NamedTuple):
    """The result of farthest point sampling at vertices."""

    vertices: Integers
    """Shape (k,): the samples."""
    radii: Floats
    """Shape (k,): as for ``Samples``."""
    labels: Integers
    """Shape (n,): as for ``Samples``."""


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


class VoronoiCells(NamedTuple):
    """A mesh that is cut along the bisectors of a Voronoi diagram."""

    surface: Surface
    """The mesh. Each of its faces lies in one cell."""
    face_labels: Integers
    """Shape (m,): the cell of each face of ``surface``, a position in the seeds; -1 if a corner of
    the original face is not reached."""


class Segments(NamedTuple):
    """A centroidal tessellation: cells of about equal size."""

    labels: Integers
    """Shape (m,) for a mesh, (n,) for a cloud: the cell of each face or surfel; -1 if no center
    reaches it."""
    centers: Locations
    """The center of each cell."""
    energies: Floats
    """The sum over all cells of the integrated squared distance to the center: at the start, after
    each step, and after cells were added to obtain disks."""


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

    def farthest_vertices(
        self,
        n: int | None = None,
        radius: float | None = None,
        *,
        first: ManyLocations | None = None,
        method: str = "auto",
        speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> VertexSamples:
        """Distributes samples as ``farthest_points()``, but only at vertices.

        The parameters and the time are those of ``farthest_points()``.
        """
        return VertexSamples(
            *self._core.farthest_vertices(n, radius, first, method, speed, callback)
        )

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

    def voronoi_cells(
        self,
        seeds: ManyLocations,
        *,
        max_distance: float = math.inf,
        speed: ArrayLike | None = None,
        callback: Callback | None = None,
    ) -> VoronoiCells:
        """Cuts a mesh along the bisectors of ``voronoi()``.

        Faces keep their orientation. If a bisector passes through a vertex, faces without area are
        created.

        Parameters
        ----------
        seeds
            A location, or a range of them.
        max_distance
            Vertices farther than this distance are not reached.
        speed
            Shape (n,): the speed at the vertices.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        UnsupportedSurfaceError
            If the surface is a cloud, or if faces around a vertex do not form a surface.

        Takes O(n log n) time.
        """
        core, labels = self._mesh("voronoi_cells").voronoi_cells(
            seeds, max_distance, speed, callback
        )
        return VoronoiCells(self._new(core), labels)

    def segment(
        self,
        n: int,
        *,
        disks: bool = True,
        max_iterations: int = 20,
        method: str = "auto",
        speed: ArrayLike | None = None,
        seed: int = 0,
        threads: int | None = None,
        callback: Callback | None = None,
    ) -> Segments:
        """Divides the surface into geodesic Voronoi cells of about equal size.

        Centers are moved to the intrinsic centroids of their cells, from samples by
        ``farthest_points()``. On a mesh, cells are patches of faces.

        Parameters
        ----------
        n
            The number of cells. There are fewer if the surface does not have as many different
            locations.
        disks
            Whether each patch of a mesh is required to be a topological disk. Cells are then added
            until it is. The cells of a cloud have no topology, so it is not used.
        max_iterations
            The maximum number of steps, and at most as many again after cells were added. They end
            if a step decreases the energy by less than a thousandth.
        method
            As for ``farthest_points()``.
        speed
            Shape (n,): cells are smaller in regions of low speed.
        seed
            Selects the vertex from which the first center is farthest.
        threads
            The number of threads. By default, that of the hardware. Results do not depend on it.
        callback
            A function that takes the completed fraction.

        Each step takes about the time of five distance computations.
        """
        labels, indices, coordinates, energies = self._core.segment(
            n,
            bool(disks) and not self.is_cloud,
            max_iterations,
            seed,
            method,
            speed,
            threads,
            callback,
        )
        return Segments(labels, Locations(indices, coordinates), energies)
