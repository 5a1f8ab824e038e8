# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The content of a surface, by which another process constructs it again."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from . import _core
from ._core import Cloud, FileError, Mesh


class Content(NamedTuple):
    """All that is needed to construct a surface again, in another process."""

    constructor: str
    """``"make_mesh"``, ``"cloud_of_content"`` or ``"read_bytes"``."""
    arguments: tuple[Any, ...]
    """The arguments of this function."""

    def construct(self) -> tuple[Mesh | Cloud, MakeContent]:
        """Constructs the surface of the extension. Its content is this one."""
        if self.constructor == "make_mesh":
            return make_mesh(*self.arguments)
        if self.constructor == "read_bytes":
            return _read_bytes(*self.arguments), lambda: self
        core = _core.cloud_of_content(*self.arguments)
        return core, lambda: content_of(core)


MakeContent = Callable[[], Content]
"""Makes the content of a surface when it is needed: most surfaces are never sent to a process."""


def content_of(core: Mesh | Cloud) -> Content:
    """Returns the content of a cloud, or of a mesh that is constructed without repairs."""
    if isinstance(core, Cloud):
        return Content("cloud_of_content", core.content())
    return Content("make_mesh", (core.vertices(), core.faces(), None, None, False))


# The repairs after which the faces of a mesh do not determine the polygons.
_REPAIRS = (
    "number_of_triangulated_polygons",
    "number_of_degenerate_faces",
    "number_of_duplicate_triangles",
    "number_of_reversed_triangles",
)


def make_mesh(
    V: Any,
    F: Any,
    offsets: Any,
    merge_tolerance: Any,
    remove_degenerate_faces: bool,
    callback: Any = None,
) -> tuple[Mesh, MakeContent]:
    """Constructs a mesh of the extension.

    The content refers to the mesh, which has all points, and all polygons that needed no repair. If
    polygons are repaired, it has a copy of them.
    """
    core = _core.make_mesh(V, F, offsets, merge_tolerance, remove_degenerate_faces, callback)
    report = core.report()
    polygons: tuple[Any, Any] | None = None
    if any(report[name] > 0 for name in _REPAIRS):
        # Corners are smaller than 2^32, the maximum number of points.
        corners = np.array(F, np.uint32, order="C")
        polygons = corners, None if offsets is None else np.array(offsets, np.int64)

    def content() -> Content:
        faces = (core.faces(), None) if polygons is None else polygons
        arguments = (core.vertices(), *faces, merge_tolerance, remove_degenerate_faces)
        return Content("make_mesh", arguments)

    return core, content


def _read_bytes(name: str, content: bytes) -> Mesh | Cloud:
    """Reads a file whose name and content are given."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name)
        with open(path, "wb") as file:
            file.write(content)
        return _core.read(path)


def file_content(path: str) -> MakeContent:
    """Returns a function that reads the bytes of a file. It fails if the file has changed."""
    path = os.path.abspath(path)

    def state() -> tuple[int, int] | None:
        if not os.path.exists(path):
            return None
        status = os.stat(path)
        return status.st_size, status.st_mtime_ns

    before = state()

    def read() -> Content:
        with open(path, "rb") as file:
            content = file.read()
        if state() != before:
            raise FileError(f"{path}: the file has changed since the surface was read.")
        return Content("read_bytes", (os.path.basename(path), content))

    return read
