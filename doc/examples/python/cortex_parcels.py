# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes distances between the vertices, and between the parcels, of a cortex in two processes.

Arguments: a surface, and two text files with a number per vertex: 0 in the medial wall, and the
parcel. Without them, the cortex is half of a torus.
Output: distances.npy, float32; minima.txt and means.txt, between parcels.
"""

import sys
import time
from concurrent.futures import ProcessPoolExecutor

import geodesic_processing as gp
import numpy as np

if __name__ == "__main__":
    if len(sys.argv) > 1:
        surface = gp.read(sys.argv[1])
        V, F = surface.vertices, surface.faces
        is_cortex, parcels = (np.loadtxt(name).astype(int) for name in sys.argv[2:4])
    else:
        i, j = np.indices((32, 16))
        u, v = np.pi * i / 16, np.pi * j / 8
        V = np.stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)], -1)
        index = np.ravel_multi_index([[i, i + 1, i + 1, i], [j, j, j + 1, j + 1]], (32, 16), "wrap")
        V, F = V.reshape(-1, 3), index.reshape(4, -1).T
        is_cortex, parcels = (i.ravel() < 17).astype(int), i.ravel() // 4
    # The cortex has no faces in the wall. A path can only run around it.
    cortex = gp.Surface(V, F[is_cortex[F].all(axis=1)])
    parcels = np.where(is_cortex > 0, parcels, -1)
    vertices = np.flatnonzero(is_cortex)
    matrix = np.lib.format.open_memmap("distances.npy", "w+", "f4", 2 * (len(vertices),))
    with ProcessPoolExecutor(2) as pool:
        begin = time.perf_counter()
        cortex.distance_matrix(vertices, out=matrix, method="euclidean", executor=pool)
        print(f"{1000 * (time.perf_counter() - begin) / len(vertices):.2f} ms for each vertex")
        for name, reduce in (("minima.txt", "min"), ("means.txt", "mean")):
            np.savetxt(name, cortex.distance_matrix(
                regions=parcels, reduce=reduce, method="euclidean", executor=pool))
