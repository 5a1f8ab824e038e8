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
    """A function of the extension, or ``"read_bytes"``."""
    arguments: tuple[Any, ...]
    """Its arguments except for the callback."""

    def core(self, callback: Any = None) -> Mesh | Cloud:
        """Constructs the surface of the extension."""
        if self.constructor == "read_bytes":
            return _read_bytes(*self.arguments)
        core: Mesh | Cloud = getattr(_core, self.constructor)(*self.arguments, callback)
        return core

    def copy(self) -> Content:
        """Returns a content with copies of the arrays."""
        return Content(self.constructor, tuple(map(_copied, self.arguments)))


def _copied(argument: Any) -> Any:
    """Returns a copy of an array, or of what is converted to an array."""
    if argument is None or isinstance(argument, (bool, int, float)):
        return argument
    return np.array(argument, order="C")


def _read_bytes(name: str, content: bytes) -> Mesh | Cloud:
    """Reads a file whose name and content are given."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name)
        with open(path, "wb") as file:
            file.write(content)
        return _core.read(path)


def file_content(path: str) -> Callable[[], Content]:
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
