# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the levels of a network with graph convolutions and pooling on a surface.

The nodes of a level are farthest point samples: the first ones of the previous level. A vertex
belongs to the cell of its nearest node. Nodes with adjacent cells are joined by an edge.

Argument: a mesh. Output: levels.npz with cells and edges of each level.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
else:
    # A torus with the radii 2 and 1.
    u, v = np.meshgrid(np.arange(64) * np.pi / 32, np.arange(32) * np.pi / 16, indexing="ij")
    ring = 2 + np.cos(v)
    V = np.stack([ring * np.cos(u), ring * np.sin(u), np.sin(v)], axis=-1).reshape(-1, 3)
    i = np.arange(len(V)).reshape(u.shape)
    corners = [np.roll(i, (-k, -l), axis=(0, 1)) for k, l in ((0, 0), (1, 0), (1, 1), (0, 1))]
    surface = gp.Surface(V, np.stack(corners, axis=-1).reshape(-1, 4))

sizes = (256, 64, 16)
samples = surface.farthest_vertices(max(sizes))
features = surface.vertices[:, 2]
levels = {}
for size in sizes:
    cells = surface.voronoi(samples.vertices[:size]).labels
    sides = cells[np.concatenate([surface.faces[:, [k, (k + 1) % 3]] for k in range(3)])]
    edges = np.unique(np.sort(sides[sides[:, 0] != sides[:, 1]], axis=1), axis=0)
    pooled = np.bincount(cells, features, size) / np.bincount(cells, None, size)
    levels |= {f"cells_{size}": cells, f"edges_{size}": edges, f"features_{size}": pooled}
    print(f"{size} nodes, {len(edges)} edges, covering radius {samples.radii[size - 1]:.4f}")
np.savez("levels.npz", **levels)
