# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distance matrices."""

import math
import tracemalloc

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays

METHODS = ["auto", "exact", "euclidean", "fast-marching", "dijkstra", "heat"]


def straight(V):
    return np.linalg.norm(V[:, None] - V[None], axis=2)


@pytest.mark.parametrize("method", METHODS)
def test_rows_are_distances(grid, cloud, method):
    for surface in (grid, cloud):
        if surface.is_cloud and method == "exact":
            continue
        rows = [0, 37, 120]
        expected = np.stack([surface.distance(row, method=method) for row in rows])
        for threads in (1, 2):
            found = surface.distance_matrix(rows, np.arange(121), method=method, threads=threads)
            assert found.shape == (3, 121) and found.flags.c_contiguous
            assert np.array_equal(found, expected)
        # The search stops at the targets.
        few = surface.distance_matrix(rows, [5, 60], method=method)
        expected = np.stack([surface.distance(r, targets=[5, 60], method=method) for r in rows])
        assert np.array_equal(few, expected[:, [5, 60]])


def test_default_is_all_vertices(surface):
    found = surface.distance_matrix(max_distance=0.4, threads=2)
    expected = np.stack([surface.distance(row, max_distance=0.4) for row in range(121)])
    assert np.array_equal(found, expected)
    assert np.array_equal(surface.distance_matrix(None, [7], max_distance=0.4), found[:, [7]])


def test_targets_default_to_sources(grid, arrays):
    locations = grid.locate(arrays[0][[3, 50]] + [0.03, 0.02, 0])
    found = grid.distance_matrix(locations)
    # Sums of some tens of lengths.
    assert found.shape == (2, 2) and np.abs(found - straight(grid.points(locations))).max() < 1e-14
    assert np.array_equal(grid.distance_matrix([3, locations[0]], [7, 8])[0],
                          grid.distance(3, targets=[7, 8])[[7, 8]])


def test_out_receives_matrix(surface, tmp_path):
    expected = surface.distance_matrix([1, 2], np.arange(121))
    out = np.full((5, 121), -1.0)
    result = surface.distance_matrix([1, 2], np.arange(121), out=out[2:4])
    assert result.base is out
    assert np.array_equal(out[2:4], expected) and (out[[0, 1, 4]] == -1).all()
    for dtype in ("f8", "f4"):
        file = np.memmap(tmp_path / dtype, dtype, "w+", shape=(2, 121))
        assert surface.distance_matrix([1, 2], np.arange(121), out=file) is file
        file.flush()
        assert np.array_equal(np.fromfile(tmp_path / dtype, dtype), expected.ravel().astype(dtype))


@pytest.mark.parametrize("dtype", ["f4", np.float32, np.dtype("float32"), "f8", float])
def test_dtype_of_matrix(grid, dtype):
    found = grid.distance_matrix([1, 2], dtype=dtype)
    assert found.dtype == np.dtype(dtype)
    assert np.array_equal(found, grid.distance_matrix([1, 2]).astype(dtype))


def test_no_copy_of_matrix(grid):
    # A second matrix would have 1 MB. The rows and the threads have 121 numbers each.
    sources = [0] * 1000
    tracemalloc.start()
    grid.distance_matrix(sources, np.arange(121))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert 1000 * 121 * 8 <= peak < 1.2 * 1000 * 121 * 8


def test_regions_have_smallest_distances(surface):
    # The regions are the lines of the grid with the same x. Line 10 is in none.
    regions = np.repeat(np.arange(11), 11)
    regions[regions == 10] = -1
    distances = surface.distance_matrix(method="dijkstra")
    columns = np.stack([distances[:, regions == r].min(axis=1) for r in range(10)], axis=1)
    both = np.stack([columns[regions == r].min(axis=0) for r in range(10)])
    found = surface.distance_matrix(regions=regions, method="dijkstra")
    assert np.array_equal(found, both)
    from_vertices = surface.distance_matrix([0, 5], regions=regions, method="dijkstra")
    assert np.array_equal(from_vertices, columns[[0, 5]])
    to_vertices = surface.distance_matrix(None, [0, 5], regions=regions, method="dijkstra")
    # The graph is symmetric, but sums of lengths are added in another order: some round-off errors.
    assert np.abs(to_vertices - columns[[0, 5]].T).max() < 1e-14


def test_regions_have_mean_distances(surface):
    regions = np.arange(121) % 4
    regions[regions == 2] = 7  # regions 2, 4, 5 and 6 are empty
    distances = surface.distance_matrix()
    found = surface.distance_matrix(regions=regions, reduce="mean", threads=2)
    assert found.shape == (8, 8)
    for i in range(8):
        for j in range(8):
            block = distances[np.ix_(regions == i, regions == j)]
            # The mean of 900 numbers below 1.5 in another order.
            assert found[i, j] == pytest.approx(block.mean(), abs=1e-13) if block.size else (
                found[i, j] == math.inf
            )
    rows = surface.distance_matrix([0, 1], regions=regions.astype(np.uint8), reduce="mean")
    assert rows[0, 3] == pytest.approx(distances[0, regions == 3].mean(), abs=1e-13)


def test_locations_are_targets_of_regions(grid, arrays):
    locations = grid.locate(arrays[0][[0, 60]] + [0.01, 0.02, 0])
    found = grid.distance_matrix(None, locations, regions=np.arange(121) // 61)
    points = grid.points(locations)
    near = np.linalg.norm(arrays[0][:61, None] - points[None], axis=2).min(axis=0)
    # Straight lines in a plane, up to round-off errors of some operations.
    assert np.abs(found[0] - near).max() < 1e-14


def test_polyline_is_row(grid, arrays):
    border = grid.border_sources()
    found = grid.distance_matrix([*border, 0], np.arange(121))
    V = arrays[0]
    to_border = np.minimum(V[:, :2], 1 - V[:, :2]).min(axis=1)
    assert np.abs(found[0] - to_border).max() < 1e-14
    assert np.array_equal(found[1], grid.distance(0))


@pytest.mark.parametrize("method", METHODS)
def test_sparse_matrix_has_near_pairs(surface, method):
    if surface.is_cloud and method == "exact":
        return
    for vertices in (None, [5, 7, 100, 3]):
        sparse = surface.sparse_distance_matrix(0.35, vertices, method=method, threads=2)
        rows = np.arange(121) if vertices is None else np.array(vertices)
        assert sparse.shape == (len(rows), len(rows))
        assert sparse.indptr[0] == 0 and sparse.indptr[-1] == len(sparse.data)
        dense = np.full(sparse.shape, math.inf)
        for i in range(len(rows)):
            entries = slice(sparse.indptr[i], sparse.indptr[i + 1])
            assert (np.diff(sparse.indices[entries]) > 0).all()
            dense[i, sparse.indices[entries]] = sparse.data[entries]
        expected = [surface.distance(r, max_distance=0.35, method=method)[rows] for r in rows]
        assert np.array_equal(dense, expected)


def test_arrays_of_sparse_matrix_own_their_memory(grid):
    data = grid.sparse_distance_matrix(0.2).data
    expected = grid.sparse_distance_matrix(0.2).data
    assert np.array_equal(data, expected) and data.dtype == np.float64


READ_ONLY = np.empty((2, 2))
READ_ONLY.flags.writeable = False


@pytest.mark.parametrize(
    "named",
    [
        {"reduce": "max"}, {"reduce": None}, {"dtype": "i4"}, {"dtype": "f2"}, {"dtype": None},
        {"dtype": "no type"}, {"dtype": object()}, {"dtype": ">f8"},
        {"out": np.empty((2, 3))}, {"out": np.empty(4)}, {"out": np.empty((2, 2), "i8")},
        {"out": np.empty((2, 2)).T[::-1]}, {"out": np.empty((2, 2), order="F")},
        {"out": np.empty((2, 4))[:, ::2]}, {"out": READ_ONLY}, {"out": [[0.0] * 2] * 2},
        {"out": np.empty(33, np.uint8)[1:].view("f8").reshape(2, 2)},
        {"regions": np.zeros(121)}, {"regions": np.zeros(120, int)}, {"regions": "all"},
        {"regions": np.full(121, -1)}, {"regions": np.full(121, 121)},
        {"regions": np.zeros(121, int), "targets": [3, 4]},
        {"threads": 0}, {"method": "best"}, {"max_distance": -1}, {"max_distance": math.nan},
        {"callback": 3},
    ],
)
def test_matrix_rejects(surface, named):
    with pytest.raises(gp.InvalidArgumentError, match=r" .*\.$"):
        surface.distance_matrix([0, 1], **named)


def test_sparse_matrix_rejects(surface, arrays):
    location = surface.locate(arrays[0][:1])
    for arguments in ((-1,), (math.nan,), (None,), (1, [0, 0]), (1, []), (1, [121]), (1, location)):
        with pytest.raises(gp.InvalidArgumentError, match=r" .*\.$"):
            surface.sparse_distance_matrix(*arguments)


def test_unsupported_method_of_matrix(cloud):
    for function in (cloud.distance_matrix, lambda **named: cloud.sparse_distance_matrix(1, **named)):
        with pytest.raises(gp.UnsupportedSurfaceError):
            function(method="exact")


def test_distance_is_too_large_for_float32():
    V, F = grid_arrays(3)
    large = gp.Surface(V * 1e39, F)
    with pytest.raises(gp.InvalidArgumentError):
        large.distance_matrix(dtype="f4")
    assert large.distance_matrix().max() > 1e39


def test_cancelled_matrix(surface):
    # The callback is also called in a row, which has less than 4,096 visits here.
    fractions = []

    def callback(fraction):
        fractions.append(fraction)
        return fraction < 0.5

    with pytest.raises(gp.Cancelled):
        surface.distance_matrix(callback=callback, threads=2)
    assert fractions == sorted(fractions) and 0.5 <= fractions[-1] < 0.6
