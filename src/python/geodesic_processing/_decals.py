# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Images that are placed on a surface."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from numpy.typing import ArrayLike

from ._atlas import Bytes, color
from ._base import Base
from ._core import InvalidArgumentError
from ._flattening import corner_array
from ._maps import Frame
from ._types import Floats, Integers, OneLocation


class Decal(NamedTuple):
    """The placement of an image. Image coordinates (0, 0) are its lower left corner, (1, 1) its
    upper right one."""

    frame: Frame
    """The center of the image, and its directions right and up."""
    vertices: Integers
    """Shape (k,): the vertices that the image covers."""
    coordinates: Floats
    """Shape (k, 2): their image coordinates."""
    faces: Integers
    """Shape (l,): the faces that intersect the image; empty on clouds."""
    face_coordinates: Floats
    """Shape (l, 3, 2): the image coordinates of the corners of these faces, which can be outside
    the image."""


class DecalTexture(NamedTuple):
    """A texture in which each face that a decal covers has its own triangle."""

    image: Bytes
    """Shape (h, w, 4), uint8: the texture. Its first row is the highest one."""
    corner_uv: Floats
    """Shape (m, 3, 2): the texture coordinates of the corners of each face. All corners of faces
    without a decal have the same coordinates, at which the texture has the color of the
    background."""
    faces: Integers
    """Shape (l,): the covered faces."""


class Decals(Base):
    """The functions of a surface for decals."""

    def decal(
        self,
        base: OneLocation,
        size: tuple[float, float] | ArrayLike,
        up: ArrayLike | None = None,
        *,
        method: str = "gradient",
    ) -> Decal:
        """Places an image on a surface by a logarithmic map.

        Distances and directions from the center of the image are preserved.

        Parameters
        ----------
        base
            A location: the center of the image.
        size
            The width and the height of the image, in the unit of the coordinates.
        up
            Shape (3,): the upward direction of the image in space. By default, the image is up
            along the second axis of ``log_map()``.
        method
            ``"gradient"`` or ``"exact"``, as for ``log_map()``.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the width or the height is not positive and finite.
        UnsupportedSurfaceError
            If the method does not support the surface.

        Takes the time of ``log_map()`` up to the corners of the image, a few times on a mesh.
        """
        frame, vertices, coordinates, faces, corners = self._core.decal(base, size, up, method)
        return Decal(Frame(*frame), vertices, coordinates, faces, corners)

    def composite_decal(self, decal: Decal, image: Bytes, colors: Bytes) -> Bytes:
        """Composites an image over the colors of the vertices that a decal covers.

        Parameters
        ----------
        decal
            The placement of the image on this surface.
        image
            Shape (h, w, 3) or (h, w, 4), uint8: the image, interpolated between the centers of its
            pixels. Its first row is the highest one. An image without opacity is opaque.
        colors
            Shape (n, 3) or (n, 4), uint8: the colors of the vertices. They are not changed.

        Returns
        -------
        The new colors, a new array of the same shape.

        Takes O(n) time.
        """
        decal = as_decal(decal)
        return self._core.composite_decal(decal.vertices, decal.coordinates, image, colors)

    def bake_decals(
        self,
        layers: Iterable[tuple[Decal, Bytes]],
        segments: int,
        *,
        background: ArrayLike = (255, 255, 255, 255),
    ) -> DecalTexture:
        """Composites images into one texture of a mesh.

        Parameters
        ----------
        layers
            Pairs of a decal on this surface and an image as for ``composite_decal()``. Later images
            are drawn over earlier ones.
        segments
            The length, in texels, of the two legs of the right triangle of a face in the texture.
        background
            The color of texels that no image covers: four integers from 0 to 255.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if the texture has more than 2^28 texels.
        UnsupportedSurfaceError
            If the surface is a cloud.

        Takes O(segments^2 l) time for l covered faces of all layers.
        """
        mesh = self._mesh("bake_decals")
        try:
            pairs = [(decal, image) for decal, image in layers]
        except (TypeError, ValueError):
            raise InvalidArgumentError("layers are not pairs of a decal and an image.") from None
        arrays = []
        for decal, image in pairs:
            corners = corner_array(as_decal(decal).face_coordinates, "face_coordinates")
            arrays.append((decal.faces, corners, image))
        return DecalTexture(
            *mesh.bake_decals(arrays, segments, color(background, "background"))
        )


def as_decal(decal: object) -> Decal:
    """Returns a decal. Raises InvalidArgumentError if it is none."""
    if not isinstance(decal, Decal):
        raise InvalidArgumentError("A decal is not the result of Surface.decal().")
    return decal
