# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wavelets on meshes with subdivision connectivity."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from . import _core
from ._surface import Surface
from ._types import Floats, Integers


class WaveletDetails(NamedTuple):
    """The wavelet coefficients of vertex values. They can be modified before synthesis."""

    values: Floats
    """Shape (n,) or (n, c), as the values of the vertices: first the values of the coarsest level,
    then the details of the finer levels, in the order of ``SubdivisionWavelet.vertices``."""
    is_in_frames: bool
    """Whether details are components along the normal, the edge, and their cross product."""


class DecodedWavelets(NamedTuple):
    """The mesh of a stream, and the extent to which the stream was decoded."""

    surface: Surface
    """The mesh. Vertices and faces are in the order of levels."""
    number_of_levels: int
    """The number of levels without the base mesh."""
    number_of_bit_planes: int
    """The number of bit planes that were decoded completely."""
    is_complete: bool
    """Whether these are all bit planes of the encoder."""
    is_damaged: bool
    """Whether a checksum differs; later bit planes were ignored."""


class SubdivisionWavelet:
    """The wavelet transform on a mesh with subdivision connectivity. It is immutable.

    Analysis transforms vertex values to the values of a coarse mesh and details, most of which are
    small. Synthesis inverts it. The levels are recovered from the faces, in any order. Each
    transform takes O(n) time.

    Parameters
    ----------
    surface
        A mesh that is the result of repeated uniform 1-to-4 refinement, as of ``semi_regular()``.
    levels
        The maximum number of levels above the coarsest one. By default, all levels.
    prediction
        The prediction of the values at new vertices: ``"butterfly"`` or ``"linear"``.
    update
        Whether the weighted sum of the values is preserved on all levels.

    Raises
    ------
    UnsupportedSurfaceError
        If the surface is a cloud, or if the mesh has no coarser level.
    """

    def __init__(
        self,
        surface: Surface,
        levels: int | None = None,
        *,
        prediction: str = "butterfly",
        update: bool = True,
    ) -> None:
        self._core = surface._mesh("SubdivisionWavelet").wavelet(
            levels, prediction, bool(update)
        )

    @property
    def number_of_levels(self) -> int:
        """The number of levels without the coarsest one, which is level 0."""
        return self._core.number_of_levels()

    @property
    def numbers_of_vertices(self) -> Integers:
        """The number of vertices of each level, shape (``number_of_levels`` + 1,)."""
        return self._core.numbers_of_vertices()

    @property
    def vertices(self) -> Integers:
        """The vertices in the order of the details, shape (n,): those of a level precede those that
        finer levels add."""
        return self._core.order()

    @property
    def parents(self) -> Integers:
        """Positions in this order, shape (n, 2): the ends of the edge whose midpoint is the vertex.
        For a vertex of the coarsest level, both are its own position."""
        return self._core.parents()

    def triangles(self, level: int) -> Integers:
        """Returns the triangles of a level, shape (m, 3): positions in this order."""
        return self._core.triangles(level)

    def analyze(self, values: ArrayLike, *, frames: bool = False) -> WaveletDetails:
        """Computes the wavelet coefficients of vertex values.

        Parameters
        ----------
        values
            Shape (n,) or (n, c), finite: the values of the vertices, for example
            ``surface.vertices``.
        frames
            Whether details of positions, shape (n, 3), are expressed in local frames of the coarser
            surface. This separates tangential details from normal ones.
        """
        return WaveletDetails(self._core.analyze(values, bool(frames)), bool(frames))

    def synthesize(self, details: WaveletDetails) -> Floats:
        """Computes vertex values, in the shape of the details, from wavelet coefficients.

        Of unmodified coefficients, these are the analyzed values up to round-off errors.
        """
        return self._core.synthesize(details.values, bool(details.is_in_frames))

    def keep_largest(self, details: WaveletDetails, n: int) -> WaveletDetails:
        """Returns a copy in which only the ``n`` vertices with the largest details have them.

        The size of a detail is weighted by its effect on the values of the finest level.
        """
        values = self._core.keep_largest(details.values, bool(details.is_in_frames), n)
        return WaveletDetails(values, bool(details.is_in_frames))

    def encode(
        self, details: WaveletDetails, *, bit_planes: int = 24, max_bytes: int | None = None
    ) -> bytes:
        """Encodes the mesh and its details as a progressive stream.

        ``decode_wavelets()`` reads every prefix that contains the coarsest mesh. Longer prefixes
        decode to better approximations.

        Parameters
        ----------
        details
            The result of ``analyze()``, with at most 16 components.
        bit_planes
            The number of bits of the largest coefficient, 1 to 48.
        max_bytes
            The size to which the stream is truncated. By default, it is unlimited.

        Takes O(n) time for each bit plane.
        """
        return self._core.encode(
            details.values, bool(details.is_in_frames), bit_planes, max_bytes
        )


def decode_wavelets(
    stream: bytes | bytearray | memoryview, *, max_vertices: int = 1 << 24
) -> DecodedWavelets:
    """Decodes a stream of ``SubdivisionWavelet.encode()``, or a prefix of one.

    Damaged bytes are detected by checksums; then only the bit planes before them are used.

    Parameters
    ----------
    stream
        The bytes of an encoded mesh.
    max_vertices
        The maximum number of vertices. It protects against short damaged streams.

    Raises
    ------
    InvalidArgumentError
        If the bytes are not a stream of vertex positions, if the base mesh is incomplete or
        damaged, or if there are too many vertices.

    Takes O(n) time for each bit plane.
    """
    arrays = _core.decode_wavelets(stream, max_vertices)
    return DecodedWavelets(Surface._of(arrays[0]), *arrays[1:])
