# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Matrices that are written in tiles of rows, so that an interrupted computation continues."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray


class Output(Protocol):
    """An array of NumPy or Zarr, or an object that is used in the same way."""

    @property
    def shape(self) -> tuple[int, ...]: ...

    @property
    def dtype(self) -> Any: ...

    def __getitem__(self, rows: Any, /) -> Any: ...

    def __setitem__(self, rows: Any, values: Any, /) -> None: ...


# The first row of a tile, the row after its last one, and the hash of its numbers.
_Tile = tuple[int, int, str]
_ATTRIBUTE = "geodesic_processing_tiles"


class Record:
    """The finished tiles of an output.

    A tile is finished if the record has the hash of the numbers that the output contains. So a record
    of an output that has been overwritten, or that has not reached the disk, has no effect.

    The key is a hash of the surface and of the arguments. Where the record is stored depends on the
    output: for a ``numpy.memmap``, in the file ``NAME.KEY.tiles``; for an array of Zarr, in its
    attribute ``geodesic_processing_tiles``; for other outputs, in the memory of this process.
    """

    # Records of arrays in memory.
    _in_memory: dict[str, list[_Tile]] = {}

    def __init__(self, out: Output, key: str, *, is_kept: bool = True) -> None:
        """Reads the record of an output. If it is not kept, nothing is recorded."""
        self._out = out
        self._is_kept = is_kept
        self._key = key
        name = getattr(out, "filename", None) if isinstance(out, np.memmap) else None
        self._path = None if name is None else f"{os.fspath(name)}.{key}.tiles"
        self._tiles: list[_Tile] = []
        if is_kept:
            self._tiles = [tile for tile in self._load() if self._is_valid(tile)]
            self._save()

    def missing_tiles(self, number_of_rows: int) -> list[tuple[int, int]]:
        """Returns the unfinished rows, in tiles of at most this size."""
        is_missing = np.ones(self._out.shape[0], bool)
        for begin, end, _ in self._tiles:
            is_missing[begin:end] = False
        return [
            (row, min(row + number_of_rows, end))
            for begin, end in _runs(is_missing)
            for row in range(begin, end, number_of_rows)
        ]

    def write(self, begin: int, end: int, rows: NDArray[Any]) -> None:
        """Writes a tile, and then records it."""
        self._out[begin:end] = rows
        if not self._is_kept:
            return
        tile = (begin, end, _hash(rows))
        self._tiles.append(tile)
        if self._path is not None:
            with open(self._path, "a", encoding="ascii") as file:
                file.write(_line(tile))
        else:
            self._save()

    def remove(self) -> None:
        """Removes the record, because the output is complete."""
        if not self._is_kept:
            return
        if self._path is not None:
            os.remove(self._path)
        elif self._attributes is not None:
            self._attributes.pop(_ATTRIBUTE, None)
        else:
            self._in_memory.pop(self._key, None)

    @property
    def _attributes(self) -> Any:
        return getattr(self._out, "attrs", None)

    def _load(self) -> Iterable[_Tile]:
        if self._path is not None:
            return _read_tiles(self._path)
        if self._attributes is not None:
            stored = self._attributes.get(_ATTRIBUTE, {})
            return [(begin, end, text) for begin, end, text in stored.get(self._key, [])]
        return self._in_memory.get(self._key, [])

    def _save(self) -> None:
        if self._path is not None:
            with open(self._path, "w", encoding="ascii") as file:
                file.writelines(map(_line, self._tiles))
        elif self._attributes is not None:
            self._attributes[_ATTRIBUTE] = {self._key: self._tiles}
        else:
            self._in_memory[self._key] = self._tiles

    def _is_valid(self, tile: _Tile) -> bool:
        begin, end, expected = tile
        is_range = 0 <= begin < end <= self._out.shape[0]
        return is_range and _hash(np.asarray(self._out[begin:end])) == expected


def _hash(rows: NDArray[Any]) -> str:
    return hashlib.blake2b(np.ascontiguousarray(rows).tobytes(), digest_size=16).hexdigest()


def _line(tile: _Tile) -> str:
    return "{} {} {}\n".format(*tile)


def _read_tiles(path: str) -> Iterator[_Tile]:
    """Reads the lines of a file. Ignores a damaged line, for example the last one after a crash."""
    if not os.path.exists(path):
        return
    with open(path, encoding="ascii", errors="replace") as file:
        for words in map(str.split, file.readlines()):
            if len(words) == 3 and words[0].isdecimal() and words[1].isdecimal():
                yield int(words[0]), int(words[1]), words[2]


def _runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Returns the beginning and the end of each run of true values."""
    ends = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    return [(int(begin), int(end)) for begin, end in zip(ends[::2], ends[1::2])]
