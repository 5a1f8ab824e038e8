# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distance matrices whose rows are computed by the workers of an executor."""

from __future__ import annotations

import hashlib
import pickle
from concurrent.futures import Executor
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import InvalidArgumentError
from ._executors import distribute
from ._tiles import Output, Record
from ._types import Callback, Floats, Integers, Locations, Polyline

if TYPE_CHECKING:
    from ._distances import Distances

# By default, there are at most as many tiles.
_max_number_of_tiles = 256
# A tile prepares the method again. On a cortex of 29,271 vertices, this takes as long as four rows of
# "euclidean", and a tenth of a row of "exact". So a tile has at least so many rows, unless there are
# few tiles.
_min_rows = 64
_min_exact_rows = 4
_few_tiles = 8
# The largest tile in bytes.
_max_tile_size = 1 << 26
# The number of rows that are computed at once for a mean.
_rows_per_sum = 64


class Matrix(NamedTuple):
    """The arguments of a matrix, except for its rows. They are the same for all tiles."""

    targets: Any
    max_distance: float
    regions: Any
    reduce: str
    method: str
    threads: int | None
    dtype: Any


def write_matrix(
    executor: Executor | None,
    surface: Distances,
    sources: Any,
    matrix: Matrix,
    out: Output | None,
    rows_per_tile: int | None,
    callback: Callback | None,
) -> Any:
    """Computes a matrix in tiles. The arguments are those of ``Surface.distance_matrix()``."""
    n = surface.number_of_points
    number_of_regions = 0
    if matrix.regions is not None:
        if sources is not None and matrix.targets is not None:
            raise InvalidArgumentError("regions cannot be combined with sources and targets.")
        matrix = matrix._replace(regions=_checked_regions(matrix.regions, n))
        number_of_regions = int(np.max(matrix.regions)) + 1
    rows = np.arange(n) if sources is None else _items(sources, "sources", Polyline)
    if matrix.targets is not None:
        matrix = matrix._replace(targets=_items(matrix.targets, "targets"))
    elif sources is not None and not number_of_regions:
        if any(isinstance(row, Polyline) for row in rows):
            raise InvalidArgumentError("targets are required if a source is a polyline.")
        matrix = matrix._replace(targets=rows)
    has_region_rows = sources is None and number_of_regions > 0
    number_of_rows = number_of_regions if has_region_rows else len(rows)
    number_of_columns = len(matrix.targets) if matrix.targets is not None else (
        number_of_regions or n
    )
    result, matrix = _output(out, (number_of_rows, number_of_columns), matrix)

    key = _key(surface, None if sources is None else rows, matrix, result.shape)
    record = Record(result, key, is_kept=out is not None)
    if rows_per_tile is None:
        is_exact = matrix.method == "exact" or (matrix.method == "auto" and not surface.is_cloud)
        min_rows = 1 if has_region_rows else _min_exact_rows if is_exact else _min_rows
        rows_per_tile = _default_rows(result, min_rows)
    elif not _is_integer(rows_per_tile) or rows_per_tile < 1:
        raise InvalidArgumentError("rows_per_tile is not a positive integer.")
    tiles = record.missing_tiles(int(rows_per_tile))
    function = _rows_of_regions if has_region_rows else _rows_of_sources
    arguments = [
        (matrix, range(begin, end) if has_region_rows else rows[begin:end]) for begin, end in tiles
    ]
    for index, values in distribute(executor, surface, function, arguments, callback):
        record.write(*tiles[index], values)
    record.remove()
    return result


def _checked_regions(regions: ArrayLike, n: int) -> Integers:
    result = np.asarray(regions)
    if result.dtype.kind not in "iu" or result.shape != (n,):
        raise InvalidArgumentError("regions are not an integer for each vertex.")
    if not 0 <= result.max() < n:
        raise InvalidArgumentError(
            "regions contain no vertex, or a region that is not smaller than the number of vertices."
        )
    return result.astype(np.int64)


def _items(argument: Any, name: str, *single_types: type) -> Any:
    """Returns a range of locations with a length. A single location becomes a range."""
    is_pair = isinstance(argument, tuple) and len(argument) == 2
    is_location = is_pair and _is_integer(argument[0]) and not _is_integer(argument[1])
    if _is_integer(argument) or is_location or isinstance(argument, single_types):
        return [argument]
    if isinstance(argument, (np.ndarray, Locations)):
        result: Any = argument
    elif isinstance(argument, (str, bytes)) or not hasattr(argument, "__iter__"):
        raise InvalidArgumentError(f"{name} are neither vertices nor locations.")
    else:
        result = list(argument)
    if np.ndim(result if isinstance(result, np.ndarray) else [0]) != 1 or len(result) == 0:
        raise InvalidArgumentError(f"{name} are empty, or an array with several dimensions.")
    return result


def _is_integer(argument: Any) -> bool:
    return isinstance(argument, (int, np.integer)) and not isinstance(argument, bool)


def _output(
    out: Output | None, shape: tuple[int, int], matrix: Matrix
) -> tuple[Output, Matrix]:
    """Returns the output, and the matrix with its type. Raises InvalidArgumentError."""
    try:
        # np.dtype(None) is float64.
        dtype = np.dtype((matrix.dtype if out is None else out.dtype) or "no type")
    except (AttributeError, TypeError):
        dtype = np.dtype(object)
    if dtype not in (np.dtype("f4"), np.dtype("f8")):
        raise InvalidArgumentError("The numbers of a matrix are not of the type float64 or float32.")
    result = np.empty(shape, dtype) if out is None else out
    if tuple(result.shape) != shape:
        raise InvalidArgumentError(f"out has not the shape {shape} of the matrix.")
    if isinstance(result, np.ndarray) and not result.flags.writeable:
        raise InvalidArgumentError("out is not writable.")
    return result, matrix._replace(dtype=str(dtype))


def _key(surface: Distances, sources: Any, matrix: Matrix, shape: tuple[int, ...]) -> str:
    """Returns a hash of all that determines the numbers of a matrix."""
    # Results do not depend on the number of threads.
    arguments = pickle.dumps((sources, matrix._replace(threads=0), shape))
    return hashlib.blake2b(surface.content_hash.encode() + arguments, digest_size=8).hexdigest()


def _default_rows(out: Output, min_rows: int) -> int:
    """Returns the number of rows of a tile: a multiple of the chunks of a Zarr array."""
    rows, columns = out.shape
    wanted = max(min(min_rows, -(-rows // _few_tiles)), -(-rows // _max_number_of_tiles))
    result = max(1, min(wanted, _max_tile_size // (columns * int(out.dtype.itemsize))))
    rows_per_chunk: int = getattr(out, "chunks", (1,))[0]
    return max(1, result // rows_per_chunk) * rows_per_chunk


def _rows_of_sources(surface: Distances, matrix: Matrix, sources: Any) -> NDArray[Any]:
    """Computes the rows of sources, in a worker."""
    targets = matrix.targets
    if targets is None and matrix.regions is None:
        targets = np.arange(surface.number_of_points)
    rows: NDArray[Any] = surface.distance_matrix(
        sources,
        targets,
        max_distance=matrix.max_distance,
        regions=matrix.regions,
        reduce=matrix.reduce,
        dtype=matrix.dtype,
        method=matrix.method,
        threads=matrix.threads,
    )
    return rows


def _rows_of_regions(surface: Distances, matrix: Matrix, regions: range) -> NDArray[Any]:
    """Computes the rows of regions, in a worker."""
    rows = np.stack([_row_of_region(surface, matrix, region) for region in regions])
    with np.errstate(over="ignore"):
        result = rows.astype(matrix.dtype)
    if np.isinf(result[np.isfinite(rows)]).any():
        raise InvalidArgumentError(
            "A distance is too large for numbers of 32 bits. Write numbers of 64 bits."
        )
    return result


def _row_of_region(surface: Distances, matrix: Matrix, region: int) -> Floats:
    """Computes a row as the extension does: to the last bit, in the same order of sums.

    The extension computes all rows of regions at once. A row is computed here from the distances of
    all targets, of which it needs a minimum or sum for each column.
    """
    assert matrix.regions is not None
    is_inside = matrix.regions == region
    sources = np.flatnonzero(is_inside)
    targets, columns, sizes = _columns(surface, matrix)
    if len(sources) == 0:
        return np.full(len(sizes), np.inf)
    computed = matrix._replace(targets=targets, reduce="min", dtype="float64")
    if matrix.reduce == "min":
        from_region = computed._replace(regions=np.where(is_inside, 0, -1))
        result = np.full(len(sizes), np.inf)
        np.minimum.at(result, columns, _rows_of_sources(surface, from_region, None)[0])
        return result
    total = np.zeros(len(sizes))
    for begin in range(0, len(sources), _rows_per_sum):
        some = sources[begin : begin + _rows_per_sum]
        for row in _rows_of_sources(surface, computed._replace(regions=None), some):
            total += np.bincount(columns, row, len(sizes))
    pairs = len(sources) * sizes
    return np.where(pairs > 0, total / np.maximum(pairs, 1), np.inf)


def _columns(surface: Distances, matrix: Matrix) -> tuple[Any, Integers, Integers]:
    """Returns the targets, the column of each of them, and the number of targets of each column."""
    if matrix.targets is not None:
        columns = np.arange(len(matrix.targets))
        return matrix.targets, columns, np.ones_like(columns)
    assert matrix.regions is not None
    targets = np.flatnonzero(matrix.regions >= 0)
    columns = matrix.regions[targets]
    return targets, columns, np.bincount(columns)
