# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the functions of all topics need."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

from ._core import Cloud, Mesh, UnsupportedSurfaceError
from ._types import Floats

if TYPE_CHECKING:
    from ._surface import Surface

_Surface = TypeVar("_Surface", bound="Base")


class Base:
    """A surface of the extension. The functions of a topic are in a subclass."""

    _core: Mesh | Cloud

    @classmethod
    def _of(cls: type[_Surface], core: Mesh | Cloud) -> _Surface:
        result = cls.__new__(cls)
        result._core = core
        return result

    @property
    def is_cloud(self) -> bool:
        """Whether the surface is a cloud."""
        return isinstance(self._core, Cloud)

    @property
    def number_of_points(self) -> int:
        """The number of points, also of those without faces."""
        return self._core.number_of_points

    @property
    def number_of_faces(self) -> int:
        """The number of triangles; 0 for a cloud."""
        return self._core.number_of_faces

    @property
    def vertices(self) -> Floats:
        """The points of the vertices of a mesh or of the surfels of a cloud, a new array of the
        shape (n, 3)."""
        return self._core.vertices()

    def _new(self, core: Mesh | Cloud) -> Surface:
        """Returns a surface of the extension as one of the module."""
        raise NotImplementedError

    def _mesh(self, name: str) -> Mesh:
        if isinstance(self._core, Cloud):
            raise UnsupportedSurfaceError(f"A cloud has no faces; {name} needs a mesh.")
        return self._core
