# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the distances of all pairs of vertices of a cortex. Paths avoid the medial wall.

Arguments: a surface (FreeSurfer, GIFTI, ...), and a text file with one number per vertex, which is
positive in the wall. Without them, the cortex is a folded sphere.
Output: distances.npy, float32, and vertices.txt, the vertices of its rows and columns.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
    V, all_faces, is_wall = surface.vertices, surface.faces, np.loadtxt(sys.argv[2]) > 0
else:
    u, v = np.meshgrid(np.linspace(0, np.pi, 21), np.arange(32) * np.pi / 16, indexing="ij")
    radius = 1 + 0.15 * np.sin(u) ** 2 * np.sin(8 * u) * np.sin(6 * v)
    directions = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], axis=-1)
    V = (radius[..., None] * directions).reshape(-1, 3)
    i = np.arange(len(V)).reshape(u.shape)
    i[0], i[-1] = i[0, 0], i[-1, 0]  # one vertex for each pole
    j = np.roll(i, -1, axis=1)
    all_faces = np.stack([i[:-1], i[1:], j[1:], j[:-1]], axis=-1).reshape(-1, 4)
    is_wall = directions.reshape(-1, 3)[:, 0] > 0.8

# The cortex has no faces in the wall. A path can only run around it.
F = all_faces[~is_wall[all_faces].any(axis=1)]
cortex = gp.Surface(V, F)
vertices = np.unique(F)
np.savetxt("vertices.txt", vertices, "%d")
shape = (len(vertices), len(vertices))
matrix = np.lib.format.open_memmap("distances.npy", "w+", np.float32, shape)
cortex.distance_matrix(vertices, out=matrix)  # rows are written to the file
matrix.flush()
print(f"matrix: {shape[0]} x {shape[1]}, largest distance {matrix.max():.4f}")
