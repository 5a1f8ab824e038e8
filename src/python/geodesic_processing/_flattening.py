# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of a surface to the plane, and coordinates in space."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._base import Base
from ._core import InvalidArgumentError, UnsupportedSurfaceError
from ._types import Callback, Floats, Integers


class FlatteningDistortion(NamedTuple):
    """The distortion of a map to the plane. It refers to the map scaled to the area of the surface.

    Means are weighted by the area of the triangles.
    """

    conformal: float
    """The distortion of angles: the square root of the mean of s1/s2 + s2/s1 - 2 for the singular
    values s1 and s2. It is 0 for a conformal map."""
    authalic: float
    """The distortion of areas: the square root of the mean of s1 s2 + 1/(s1 s2) - 2. It is 0 if
    areas are preserved."""
    symmetric_dirichlet: float
    """The mean symmetric Dirichlet energy, at least 4."""
    l2_stretch: float
    """The square root of the mean of (s1^2 + s2^2) / 2."""
    linf_stretch: float
    """The maximum of the larger singular value."""
    number_of_flips: int
    """The number of triangles that are inverted or have no area in the plane."""
    number_of_triangles: int
    """The number of triangles with a positive area and an image."""


class BaseFlattening(NamedTuple):
    """A map to the plane by base points."""

    uv: Floats
    """Shape (n, 2): the image of each vertex, in the unit of the coordinates. NaN for vertices
    without faces and surfels without neighbors."""
    base_points: Integers
    """Shape (b,): the base points, which are vertices."""


class Flattening(NamedTuple):
    """A map to the plane, and its distortion."""

    uv: Floats
    """Shape (n, 2): the image of each vertex, in the unit of the coordinates. NaN for vertices
    without faces and surfels without neighbors."""
    base_points: Integers
    """Shape (b,): the base points, which are vertices."""
    distortion: FlatteningDistortion
    """The distortion of the map."""


class Flattenings(Base):
    """The functions of a surface for maps to the plane."""

    def flatten(
        self,
        injective: bool | None = None,
        *,
        number_of_base_points: int | None = None,
        base_points: ArrayLike | None = None,
        number_of_neighbors: int | None = None,
        flattening_start: str = "best",
        number_of_rigid_steps: int = 30,
        method: str = "auto",
        seed: int = 0,
        callback: Callback | None = None,
    ) -> Flattening:
        """Flattens a patch: changes distances between neighbors as little as possible.

        It is the map of ``lle()``, which has the other parameters. If it is injective, inverted
        faces are turned over, and the symmetric Dirichlet energy is minimized without inverting
        faces.

        Parameters
        ----------
        injective
            Whether no face of a mesh may be inverted. By default, true on a mesh. The image can
            still overlap itself if the images of boundary edges intersect.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid.
        UnsupportedSurfaceError
            If the surface is not connected. If ``injective``, also if it is a cloud, if the mesh
            has no boundary or has handles, or if it touches itself at a vertex.
        Cancelled
            If the callback returns a false value.
        """
        if injective is None:
            injective = not self.is_cloud
        elif injective and self.is_cloud:
            raise UnsupportedSurfaceError(
                "The triangles of a cloud overlap: no map of them is injective."
            )
        uv, found = self._core.lle(
            bool(injective),
            number_of_base_points,
            base_points,
            number_of_neighbors,
            flattening_start,
            number_of_rigid_steps,
            method,
            seed,
            callback,
        )
        return Flattening(uv, found, self.flattening_distortion(uv))

    def lle(
        self,
        *,
        number_of_base_points: int | None = None,
        base_points: ArrayLike | None = None,
        number_of_neighbors: int | None = None,
        flattening_start: str = "best",
        number_of_rigid_steps: int = 30,
        method: str = "auto",
        seed: int = 0,
        callback: Callback | None = None,
    ) -> BaseFlattening:
        """Flattens a patch by geodesic locally linear embedding of base points.

        Faces can be inverted in regions of high curvature.

        Parameters
        ----------
        number_of_base_points
            From 3 to 1000. By default 200, and up to 1000 on a narrow mesh.
        base_points
            Shape (b,): different vertices that replace the farthest point samples.
        number_of_neighbors
            The number of neighbors of each base point, at least 3. By default 10, and more if base
            points would form disconnected groups.
        flattening_start
            The initial embedding of the base points: ``"lle"`` (locally linear), ``"mds"``
            (classical scaling), or ``"best"`` of both.
        number_of_rigid_steps
            The number of steps that make the neighborhoods of base points rigid.
        method
            The front that measures distances: ``"euclidean"``, which ``"auto"`` selects,
            ``"fast-marching"`` or ``"dijkstra"``.
        seed
            The seed of the samples.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the neighbors do not connect all base points.
        UnsupportedSurfaceError
            If the surface is not connected.
        Cancelled
            If the callback returns a false value.

        Takes O(n log n) time.
        """
        return BaseFlattening(
            *self._core.lle(
                False,
                number_of_base_points,
                base_points,
                number_of_neighbors,
                flattening_start,
                number_of_rigid_steps,
                method,
                seed,
                callback,
            )
        )

    def mds(
        self,
        *,
        number_of_base_points: int | None = None,
        base_points: ArrayLike | None = None,
        method: str = "auto",
        seed: int = 0,
        callback: Callback | None = None,
    ) -> BaseFlattening:
        """Flattens a patch by multidimensional scaling of the distances between all base points.

        Long distances have the largest influence. The parameters and exceptions are those of
        ``lle()``; the default number of base points is 200.

        Takes two distance computations for each base point.
        """
        return BaseFlattening(
            *self._core.mds(number_of_base_points, base_points, method, seed, callback)
        )

    def flattening_distortion(self, uv: ArrayLike) -> FlatteningDistortion:
        """Computes the distortion of a map to the plane, independently of its scale.

        Parameters
        ----------
        uv
            The images of the vertices, shape (n, 2), or of the corners of the faces of a mesh,
            shape (m, 3, 2). If a corner has NaN coordinates, its triangle is ignored.

        Takes O(n) time.
        """
        corners = corner_array(uv, "uv")
        if corners is None:
            return FlatteningDistortion(*self._core.flattening_distortion(uv))
        mesh = self._mesh("the distortion of corners")
        return FlatteningDistortion(*mesh.corner_distortion(corners))

    def mean_value_coordinates(
        self, points: ArrayLike, *, callback: Callback | None = None
    ) -> Floats:
        """Computes the mean value coordinates of points with respect to a closed mesh.

        The coordinates of a point sum to one, and the vertices weighted by them sum to the point.
        Inside convex meshes they are positive. On the surface they are barycentric coordinates.

        Parameters
        ----------
        points
            Shape (k, 3), finite: points inside, outside, or on the surface.
        callback
            A function that takes the completed fraction, called before each point.

        Returns
        -------
        The coordinates, shape (k, n).

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid.
        UnsupportedSurfaceError
            If the surface is a cloud, has a boundary or encloses no volume, or if a point is
            millions of diameters away.

        Takes O(n) time for each point.
        """
        mesh = self._mesh("mean_value_coordinates")
        return mesh.mean_value_coordinates(points, callback)


def corner_array(corners: ArrayLike, name: str) -> Floats | None:
    """Returns coordinates of the shape (m, 3, 2) as an array of the shape (m, 6).

    Returns None if the argument is not an array with three dimensions.
    """
    try:
        array = np.asarray(corners)
    except ValueError:  # a ragged list
        return None
    if array.ndim != 3:
        return None
    if array.shape[1:] != (3, 2):
        raise InvalidArgumentError(
            f"{name} has the shape {array.shape}, but its shape must be (n, 3, 2)."
        )
    return array.reshape(len(array), 6)
