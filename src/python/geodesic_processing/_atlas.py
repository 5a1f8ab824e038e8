# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texture atlases."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple, Union, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._base import Base
from ._core import InvalidArgumentError
from ._flattening import corner_array
from ._types import Callback, Floats, Integers, Locations

if TYPE_CHECKING:
    from ._surface import Surface

Bytes = NDArray[np.uint8]
ColorFunction = Callable[[Locations], Any]
"""A function of k locations that returns their colors: uint8, shape (k, 3) or (k, 4)."""


class Atlas(NamedTuple):
    """A texture atlas: a mesh that is cut into charts, and the charts in the unit square.

    Vertices on cuts are repeated: ``points``, ``uv`` and ``faces`` are a mesh with one pair of
    texture coordinates per vertex, as files and renderers need it. Texture coordinates (0, 0) are
    the lower left corner of the texture, and (1, 1) the upper right one.
    """

    surface: Surface
    """The mesh: the surface itself, or the mesh that is reconstructed from a cloud. Its points are
    then all surfels, of which some can be without faces."""
    points: Floats
    """Shape (k, 3): the points of the repeated vertices."""
    uv: Floats
    """Shape (k, 2): their texture coordinates."""
    faces: Integers
    """Shape (m, 3): the repeated vertices at the corners of each face of ``surface``."""
    vertices: Integers
    """Shape (k,): the vertex (or surfel) that is repeated: ``vertices[faces]`` is
    ``surface.faces``."""
    charts: Integers
    """Shape (m,): the chart of each face, starting at 0."""
    number_of_charts: int
    """The number of charts."""
    number_of_flips: int
    """The number of faces whose image is not counterclockwise."""
    number_of_overlaps: int
    """The number of charts whose boundary intersects itself."""
    coverage: float
    """The fraction of the unit square that charts cover."""
    texels_per_length: float
    """Approximate, and equal for all charts."""

    @property
    def corner_uv(self) -> Floats:
        """Shape (m, 3, 2): the texture coordinates of the corners of each face."""
        return self.uv[self.faces]

    @property
    def is_injective(self) -> bool:
        """Whether no two locations inside charts have the same texture coordinates.

        It is a certificate, since both numbers are computed exactly from the coordinates.
        """
        return self.number_of_flips == 0 and self.number_of_overlaps == 0


class Atlases(Base):
    """The functions of a surface for textures."""

    def atlas(
        self,
        charts: int | None = None,
        *,
        texture_size: int = 1024,
        gutter_width: int = 4,
        method: str = "auto",
        speed: ArrayLike | None = None,
        face_speed: ArrayLike | None = None,
        max_iterations: int = 5,
        seed: int = 0,
        threads: int | None = None,
        callback: Callback | None = None,
    ) -> Atlas:
        """Computes a texture atlas: cuts a mesh into charts, flattens and packs them.

        A mesh can have any topology. From a cloud, a mesh is reconstructed first.

        Parameters
        ----------
        charts
            The initial number of charts. More are created for components without a chart, and if
            charts are not disks, would overlap themselves or stretch lengths by a mean factor of
            two. By default 1, so that only the necessary cuts are made.
        texture_size
            The number of texels along each edge of the texture, 16 to 16384; the unit of the
            gutter.
        gutter_width
            The minimum number of texels between two charts along one of the axes. Bilinear lookup
            needs three.
        method
            The front of the tessellation: ``"euclidean"``, which ``"auto"`` selects,
            ``"fast-marching"`` or ``"dijkstra"``.
        speed
            Shape (n,): charts are smaller in regions of low speed.
        face_speed
            Shape (m,): the speed in the faces of a mesh, instead of ``speed``.
        max_iterations
            The maximum number of steps that move the centers of charts.
        seed
            The seed of the centers.
        threads
            The number of threads. By default, that of the hardware. Results do not depend on it.
        callback
            A function that takes the completed fraction. It and Ctrl-C cancel the computation
            between the steps of the tessellation, or after all charts are flattened.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the texture has too few texels for the charts.
        UnsupportedSurfaceError
            If no mesh can be reconstructed from the surfels.
        Cancelled
            If the callback returns a false value.

        About half of the time is Newton's method, which factorizes a sparse matrix with two
        unknowns per vertex of a chart, at most 20 times.
        """
        faces, corner_uv, chart_of_face, summary = self._core.atlas(
            1 if charts is None else charts,
            texture_size,
            gutter_width,
            method,
            speed,
            face_speed,
            max_iterations,
            seed,
            threads,
            callback,
        )
        if faces is None:
            surface = cast("Surface", self)
            faces = surface.faces
        else:
            from ._surface import Surface

            surface = Surface(self._core.points(np.arange(self.number_of_points)), faces)
        # Corners of the same vertex with the same texture coordinates are one repeated vertex.
        corners = np.column_stack([faces.ravel(), corner_uv.reshape(-1, 2)])
        rows, repeated_vertices = np.unique(corners, axis=0, return_inverse=True)
        vertices = rows[:, 0].astype(np.int64)
        points = surface._core.points(vertices)
        return Atlas(
            surface,
            points,
            np.ascontiguousarray(rows[:, 1:]),
            repeated_vertices.reshape(-1, 3),
            vertices,
            chart_of_face,
            *summary,
        )

    def bake_atlas(
        self,
        corner_uv: ArrayLike,
        colors: Union[Bytes, ColorFunction],
        texture_size: int = 1024,
        *,
        gutter_width: int = 4,
        background: ArrayLike = (255, 255, 255, 0),
    ) -> Bytes:
        """Computes the texture of a mesh with texture coordinates.

        Each texel has the color of the location that its center shows. Texels up to half of the
        gutter outside a chart have the color of the closest location on the chart.

        Parameters
        ----------
        corner_uv
            Shape (m, 3, 2), finite: the texture coordinates of the corners of each face, for
            example ``Atlas.corner_uv``.
        colors
            The colors of the vertices, uint8 of the shape (n, 3) or (n, 4), which are interpolated;
            or a function that takes k ``Locations`` and returns their colors, uint8 of the shape
            (k, 3) or (k, 4). It is called once. Colors without opacity are opaque.
        texture_size
            The number of texels along each edge of the texture, at most 16384.
        gutter_width
            As for ``atlas()``.
        background
            The color of all other texels: four integers from 0 to 255.

        Returns
        -------
        The texture, uint8 of the shape (texture_size, texture_size, 4). Its first row is the
        highest one, as in image files.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the function returns an array of another type or shape.

        Takes linear time in the number of texels and of faces.
        """
        mesh = self._mesh("bake_atlas")
        corners = corner_array(corner_uv, "corner_uv")
        numbers, arrays = mesh.texel_locations(
            corner_uv if corners is None else corners, texture_size, gutter_width
        )
        locations = Locations(*arrays)
        if callable(colors):
            found = rgba(colors(locations), len(locations), "The result of colors")
        else:
            of_vertices = rgba(colors, self.number_of_points, "colors")
            of_corners = of_vertices[mesh.faces()[locations.indices]]
            mixed = np.einsum("ik,ikc->ic", locations.coordinates, of_corners)
            found = np.rint(mixed).clip(0, 255).astype(np.uint8)
        result = np.empty((*numbers.shape, 4), np.uint8)
        result[...] = color(background, "background")
        is_covered = numbers >= 0
        result[is_covered] = found[numbers[is_covered]]
        return result


def color(value: ArrayLike, name: str) -> Bytes:
    """Returns a color with opacity. Raises InvalidArgumentError if it is not one."""
    try:
        array = np.asarray(value)
    except ValueError:
        array = np.empty(0)
    if array.shape != (4,) or array.dtype.kind not in "iu" or array.min() < 0 or array.max() > 255:
        raise InvalidArgumentError(f"{name} does not have four integers from 0 to 255.")
    return array.astype(np.uint8)


def rgba(colors: object, size: int, name: str) -> Bytes:
    """Returns colors with opacity. Raises InvalidArgumentError if the type or shape is wrong."""
    if not isinstance(colors, np.ndarray) or colors.dtype != np.uint8:
        raise InvalidArgumentError(f"{name} is not an array of uint8.")
    if colors.shape not in ((size, 3), (size, 4)):
        raise InvalidArgumentError(
            f"{name} has the shape {colors.shape}, but its shape must be ({size}, 3) or "
            f"({size}, 4)."
        )
    if colors.shape[1] == 4:
        return colors
    return np.column_stack([colors, np.full(size, 255, np.uint8)])
