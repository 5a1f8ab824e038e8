# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Types of arguments, and locations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

Callback = Callable[[float], Any]
"""A function that takes the completed fraction."""
Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


class Location(NamedTuple):
    """A location on a mesh."""

    face: int
    """The index of the face, a row of ``Surface.faces``."""
    barycentric: tuple[float, float, float]
    """The barycentric coordinates with respect to the corners of the face."""


class SurfelLocation(NamedTuple):
    """A location on a cloud: a point of the tangent plane of a surfel."""

    surfel: int
    """The index of the surfel."""
    offset: tuple[float, float]
    """The components along the two axes of the tangent plane, in the unit of the coordinates."""


OneLocation = Union[int, np.integer[Any], tuple[int, ArrayLike], Location, SurfelLocation]
ManyLocations = Union[OneLocation, Iterable[OneLocation], NDArray[np.integer[Any]]]


class Locations(Sequence[Union[Location, SurfelLocation]]):
    """Locations on a surface, as arrays. Its rows are ``Location`` or ``SurfelLocation``."""

    def __init__(self, indices: Integers, coordinates: Floats) -> None:
        self.indices = indices
        """Shape (k,): the faces of a mesh, the surfels of a cloud."""
        self.coordinates = coordinates
        """Shape (k, 3): barycentric coordinates on a mesh; (k, 2): offsets on a cloud."""

    def __len__(self) -> int:
        return len(self.indices)

    @overload
    def __getitem__(self, row: int) -> Location | SurfelLocation: ...

    @overload
    def __getitem__(self, row: slice) -> Locations: ...

    def __getitem__(self, row: int | slice) -> Location | SurfelLocation | Locations:
        if isinstance(row, slice):
            return Locations(self.indices[row], self.coordinates[row])
        index = int(self.indices[row])
        a, b, *c = self.coordinates[row].tolist()
        return Location(index, (a, b, c[0])) if c else SurfelLocation(index, (a, b))

    def __iter__(self) -> Iterator[Location | SurfelLocation]:
        return (self[row] for row in range(len(self)))


class Polyline(Locations):
    """A source along a line. Consecutive locations are in a common face of the mesh, or in a common
    triangle of the cloud. It is closed if its last location is the first one.

    The indices and coordinates of a ``Path`` or an ``Isoline`` are valid polylines.
    """


ManySources = Union[ManyLocations, Polyline, Iterable[Union[OneLocation, Polyline]]]
