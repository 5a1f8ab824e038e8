# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact distances with the interface of gdist 2.2.

Differences
-----------
- Each call prepares a surface, as in gdist. For many queries on one mesh, use ``Surface.solver()``.
- Meshes need not be manifold, and arrays can have any type.
- Vertices farther than ``max_distance`` are infinitely far in ``compute_gdist()`` and have no entry
  in matrices. In gdist, they can have a finite distance.
- ``distance_matrix_of_selected_points()`` needs distinct points.

All tests of gdist pass. The matrices that ``test_equality_with_stable`` reads are not in its
repository; they were computed with the C++ library of gdist.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._surface import Surface
from .._types import Floats
from ._common import scipy_sparse

__all__ = ["compute_gdist", "distance_matrix_of_selected_points", "local_gdist_matrix"]


def compute_gdist(
    vertices: ArrayLike,
    triangles: ArrayLike,
    source_indices: ArrayLike | None = None,
    target_indices: ArrayLike | None = None,
    max_distance: float = math.inf,
    is_one_indexed: bool = False,
) -> Floats:
    """Computes the exact distance of each target to the nearest source.

    Parameters
    ----------
    vertices
        Shape (n, 3): the points.
    triangles
        Shape (m, 3): the faces.
    source_indices
        Shape (k,): the sources, rows of ``vertices``. By default, the first vertex.
    target_indices
        Shape (l,): the targets, rows of ``vertices``. By default, all vertices.
    max_distance
        Targets farther than this distance are infinitely far.
    is_one_indexed
        Whether the smallest index in ``triangles`` is 1. Sources and targets always begin at 0.

    Returns
    -------
    The distances, shape (l,), in the unit of the coordinates.
    """
    surface = _surface(vertices, triangles, is_one_indexed)
    sources = np.zeros(1, np.int64) if source_indices is None else np.asarray(source_indices)
    if target_indices is None:
        return surface.distance(sources, method="exact", max_distance=max_distance)
    targets = np.asarray(target_indices)
    solver = surface.solver("exact").compute(sources, max_distance=max_distance, targets=targets)
    distances: Floats = solver.distance(targets)
    return distances


def local_gdist_matrix(
    vertices: ArrayLike,
    triangles: ArrayLike,
    max_distance: float = math.inf,
    is_one_indexed: bool = False,
) -> Any:
    """Computes the exact distances of all pairs of vertices within ``max_distance``.

    The parameters are those of ``compute_gdist()``.

    Returns
    -------
    A ``scipy.sparse.csc_matrix`` of the shape (n, n), without entries for distances of 0.
    """
    surface = _surface(vertices, triangles, is_one_indexed)
    return _matrix(surface, np.arange(surface.number_of_points), max_distance)


def distance_matrix_of_selected_points(
    vertices: ArrayLike,
    triangles: ArrayLike,
    points: ArrayLike,
    max_distance: float = math.inf,
    is_one_indexed: bool = False,
) -> Any:
    """Computes the exact distances of all pairs of some vertices.

    Parameters
    ----------
    points
        Shape (k,): distinct rows of ``vertices``.
    vertices, triangles, max_distance, is_one_indexed
        As for ``compute_gdist()``.

    Returns
    -------
    A ``scipy.sparse.csc_matrix`` of the shape (n, n). It has an entry for each pair of different
    points within ``max_distance``.
    """
    return _matrix(
        _surface(vertices, triangles, is_one_indexed), np.asarray(points), max_distance
    )


def _surface(vertices: ArrayLike, triangles: ArrayLike, is_one_indexed: bool) -> Surface:
    return Surface(vertices, np.asarray(triangles) - 1 if is_one_indexed else triangles)


def _matrix(surface: Surface, points: Any, max_distance: float) -> Any:
    """Returns the distances of all pairs of points in a matrix with a row for each vertex."""
    found = surface.sparse_distance_matrix(max_distance, points, method="exact")
    sparse = scipy_sparse()
    rows = np.repeat(points, np.diff(found.indptr))
    n = surface.number_of_points
    result = sparse.csc_matrix((found.data, (rows, points[found.indices])), shape=(n, n))
    result.eliminate_zeros()
    return result
