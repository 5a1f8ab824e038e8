# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import sys
import tracemalloc
import types

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays


def use_everything(V, F):
    surface = gp.Surface(V, F)
    cloud = gp.Surface(V, normals=np.tile([0.0, 0.0, 1.0], (len(V), 1)))
    for s in (surface, cloud):
        locations = s.locate(V[:9])
        solver = s.solver().compute([0, locations[1]])
        solver.distance(locations), solver.path(7), solver.labels, solver.reached
        s.path(0, 99), s.points(locations), s.voronoi([0, 99]), s.farthest_points(3)
        s.distance_matrix([0, 1], locations[:5])
        s.log_map(0, 0.2), s.exp_map(0, [[0.1, 0.1]]), s.trace(0, (0.1, 0.1, 0))
        decal = s.decal(99, (0.2, 0.2))
        s.composite_decal(decal, np.zeros((9, 9, 4), np.uint8), np.zeros((len(V), 3), np.uint8))
        s.distance_matrix([0, 1], locations[:5]), s.sparse_distance_matrix(0.02, [0, 1])
        s.distance_matrix([0], regions=np.zeros(len(V), int), reduce="mean", dtype="f4")
        s.farthest_points(2, method="dijkstra"), s.distance(gp.Polyline(*vars(locations).values()))
        for invalid in (lambda: s.distance(-1), lambda: s.distance(0, callback=lambda f: False),
                        lambda: s.distance(0, out=V), lambda: s.locate(V[:, :2])):
            with pytest.raises((ValueError, gp.Cancelled)):
                invalid()
    surface.isolines(surface.distance(0), [0.5]), surface.report, surface.faces
    surface.distance(surface.border_sources())
    gp.as_surface(types.SimpleNamespace(vertices=V, faces=F, convex_hull=None))


def resident_bytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="needs the file system proc")
def test_memory_does_not_grow():
    # The front of 4,900 vertices calls the callback, so that it can be canceled.
    V, F = grid_arrays(70)
    references = sys.getrefcount(V), sys.getrefcount(F)
    for _ in range(4):
        use_everything(V, F)
    before = resident_bytes()
    tracemalloc.start()
    begin = tracemalloc.take_snapshot()
    for _ in range(12):
        use_everything(V, F)
    growth = tracemalloc.take_snapshot().compare_to(begin, "filename")
    tracemalloc.stop()
    # NumPy reports its arrays: one leaked array of a number per vertex has 39 kB in each pass.
    assert sum(max(0, entry.size_diff) for entry in growth) < 39e3
    # A leaked domain has 1 MB in each pass. The allocator keeps memory of earlier passes, but not
    # again in each round.
    growths = [resident_bytes() - before]
    for _ in range(2):
        before = resident_bytes()
        for _ in range(12):
            use_everything(V, F)
        growths.append(resident_bytes() - before)
    assert min(growths) < 6e6
    assert (sys.getrefcount(V), sys.getrefcount(F)) == references
