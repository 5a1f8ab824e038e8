# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the functions of all topics need."""

from __future__ import annotations

import hashlib
import pickle
from typing import TYPE_CHECKING, Any, TypeVar

from ._content import Content, MakeContent, content_of
from ._core import Cloud, Mesh, UnsupportedSurfaceError
from ._types import Floats

if TYPE_CHECKING:
    from ._surface import Surface

_Surface = TypeVar("_Surface", bound="Base")


class Base:
    """A surface of the extension. The functions of a topic are in a subclass."""

    _core: Mesh | Cloud
    _make_content: MakeContent | None = None
    _hash: str | None = None

    @classmethod
    def _of(
        cls: type[_Surface], core: Mesh | Cloud, make_content: MakeContent | None = None
    ) -> _Surface:
        """Returns a surface. By default, its content is ``content_of(core)``."""
        result = cls.__new__(cls)
        result._core = core
        result._make_content = make_content
        return result

    def __reduce__(self) -> tuple[Any, ...]:
        make_content = self._make_content
        content = content_of(self._core) if make_content is None else make_content()
        return _of_content, (type(self), content)

    @property
    def content_hash(self) -> str:
        """A hash of all that determines the surface: arrays and options, or the bytes of a file."""
        if self._hash is None:
            self._hash = hashlib.blake2b(pickle.dumps(self), digest_size=16).hexdigest()
        return self._hash

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


def _of_content(cls: type[_Surface], content: Content) -> _Surface:
    return cls._of(*content.construct())
