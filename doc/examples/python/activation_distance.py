# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the earth mover's distance between two activations of a cortex, with its bounds.

Arguments: a mesh and the vertices of two activations. Without them, the mesh is a folded sheet.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    cortex = gp.read(sys.argv[1])
    first, second = map(int, sys.argv[2:4])
else:
    # A curve with 60 steps of length 0.1, extruded along y. Vertex 21 k + 10 is on its middle line.
    angle = 1.3 * np.sin(np.arange(60) * np.pi / 10)
    x, z = (np.append(0, np.cumsum(0.1 * f(angle))) for f in (np.cos, np.sin))
    V = np.stack([np.repeat(x, 21), np.tile(np.linspace(0, 2, 21), 61), np.repeat(z, 21)], axis=1)
    i = np.arange(len(V)).reshape(61, 21)
    F = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    cortex = gp.Surface(V, F)
    first, second = 21 * 10 + 10, 21 * 50 + 10


def activation(center, width):
    """Returns masses that sum to one, with a normal distribution around a vertex."""
    mass = np.exp(-0.5 * (cortex.distance(center, max_distance=4 * width) / width) ** 2)
    return mass / mass.sum()


width = 0.05 * cortex.path(first, second).length
a, b = activation(first, width), activation(second, width)
cost = cortex.emd(a, b, bound_from_above=True).cost
print(f"on the cortex: at least {cost.lower:.4f}, at most {cost.upper_continuous:.4f}")
print(f"between the mean positions in space: {np.linalg.norm((a - b) @ cortex.vertices):.4f}")
