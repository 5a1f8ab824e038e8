# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact distances and paths with the interface of pygeodesic.geodesic 0.1.11.

Differences
-----------
- Invalid arguments raise an exception. In pygeodesic, a message is printed and the result is
  ``None``.
- Meshes need not be manifold, and vertices without faces are allowed.
- A vertex that no source reaches is infinitely far, its source is -1, and its path has no points.
- Vertices farther than ``max_distance`` are infinitely far. In pygeodesic, they can have a finite
  distance.
- If there are several shortest paths, another one can be returned.

All tests of pygeodesic pass.
"""

from __future__ import annotations

import math
import os

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..._surface import Surface
from ..._types import Floats, Integers

__all__ = ["PyGeodesicAlgorithmExact", "read_mesh_from_file"]


class PyGeodesicAlgorithmExact:
    """Computes exact distances and paths on a triangle mesh.

    Parameters
    ----------
    points
        Shape (n, 3): the points of the vertices.
    faces
        Shape (m, 3): the triangles.
    """

    def __init__(self, points: ArrayLike, faces: ArrayLike) -> None:
        self._surface = Surface(points, faces)
        self._solver = self._surface.solver("exact")

    def geodesicDistance(self, sourceIndex: int, targetIndex: int) -> tuple[float, Floats]:
        """Computes a shortest path between two vertices.

        Parameters
        ----------
        sourceIndex, targetIndex
            The vertices.

        Returns
        -------
        The length of the path, and its points from the target to the source, shape (k, 3).
        """
        targets = [int(targetIndex)]
        path = self._solver.compute(int(sourceIndex), targets=targets).path(targets[0])
        return path.length, path.points

    def geodesicDistances(
        self,
        source_indices: ArrayLike | None = None,
        target_indices: ArrayLike | None = None,
        max_distance: float = math.inf,
    ) -> tuple[Floats, NDArray[np.int32]]:
        """Computes the distance of each target to the nearest source.

        Parameters
        ----------
        source_indices
            Shape (k,): the sources, which are vertices. By default, the first vertex.
        target_indices
            Shape (l,): the targets, which are vertices. By default, all vertices.
        max_distance
            Targets farther than this distance are infinitely far.

        Returns
        -------
        The distances, shape (l,), and the positions of the nearest sources in ``source_indices``,
        shape (l,).
        """
        sources = np.zeros(1, np.int64) if source_indices is None else np.asarray(source_indices)
        targets = None if target_indices is None else np.asarray(target_indices)
        self._solver.compute(sources, max_distance=max_distance, targets=targets)
        distances: Floats = self._solver.distance(targets)
        labels = self._solver.labels.astype(np.int32)
        return distances, labels if targets is None else labels[targets]


def read_mesh_from_file(filename: str | os.PathLike[str]) -> tuple[Floats, Integers]:
    """Reads a mesh from a text file.

    The first line has the numbers of points and faces. Each other line has the three coordinates of
    a point, or the three vertices of a face. Points precede faces, and the first vertex is 0.

    Returns
    -------
    The points, shape (n, 3), and the faces, shape (m, 3).

    Raises
    ------
    ValueError
        If the file does not have this format.
    """
    with open(filename, encoding="utf-8") as file:
        number_of_points, number_of_faces = (int(word) for word in file.readline().split())
        rows = np.loadtxt(file, ndmin=2)
    if rows.shape != (number_of_points + number_of_faces, 3):
        raise ValueError(
            f"{os.fspath(filename)} does not have {number_of_points} points and {number_of_faces} "
            "faces with three numbers each."
        )
    return rows[:number_of_points], rows[number_of_points:].astype(np.int64)
