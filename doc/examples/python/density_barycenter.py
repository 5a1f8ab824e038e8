# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the barycenter of densities by optimal transport on a surface.

Arguments: a mesh and the vertices around which the densities are concentrated.
Output: barycenter.txt, the density of the barycenter at each vertex.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
    centers = [int(argument) for argument in sys.argv[2:]]
else:
    # A curve with 40 steps of length 0.1, extruded along y. Vertex 21 k + 10 is on its middle line.
    angle = np.sin(np.arange(40) * np.pi / 20)
    x, z = (np.append(0, np.cumsum(0.1 * f(angle))) for f in (np.cos, np.sin))
    V = np.stack([np.repeat(x, 21), np.tile(np.linspace(0, 2, 21), 41), np.repeat(z, 21)], axis=1)
    i = np.arange(len(V)).reshape(41, 21)
    F = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    surface = gp.Surface(V, F)
    centers = [21 * 10 + 10, 21 * 30 + 10]

distances = surface.distance_matrix(centers, np.arange(surface.number_of_points))
width = 0.1 * distances[:, centers].max()
densities = np.exp(-0.5 * (distances / width) ** 2)
densities[distances > 4 * width] = 0

result = surface.barycenter([gp.mass_density(values) for values in densities], normalize=True)
np.savetxt("barycenter.txt", result.density)
print(f"distances to the densities: {result.distances.round(4)}")
print(f"sum of their squares: {result.value:.4f}, at least {result.lower:.4f} for all densities")
