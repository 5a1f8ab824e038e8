# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes a mesh with well-shaped triangles from a surface with thin triangles.

Arguments: a mesh or a cloud, and the number of vertices. Output: remeshed.off.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
    number_of_vertices = int(sys.argv[2])
else:
    # A unit sphere by longitudes and latitudes. Triangles are thin at the poles.
    u, v = np.meshgrid(np.linspace(0, np.pi, 31), np.arange(96) * np.pi / 48, indexing="ij")
    V = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], axis=-1)
    i = np.arange(u.size).reshape(u.shape)
    i[0], i[-1] = i[0, 0], i[-1, 0]  # one vertex for each pole
    j = np.roll(i, -1, axis=1)
    F = np.stack([i[:-1], i[1:], j[1:], j[:-1]], axis=-1).reshape(-1, 4)
    surface = gp.Surface(V.reshape(-1, 3), F)
    number_of_vertices = 500

result = surface.remesh(number_of_vertices, relaxation_steps=10)
points, faces = result.surface.vertices, result.surface.faces
edges = np.roll(points[faces], -1, axis=1) - points[faces]
edges /= np.linalg.norm(edges, axis=2, keepdims=True)
angles = np.degrees(np.arccos(-(edges * np.roll(edges, 1, axis=1)).sum(axis=2)))
print(f"{len(points)} vertices, {len(faces)} faces, smallest angle {angles.min():.1f} degrees")

with open("remeshed.off", "w") as file:
    file.write(f"OFF\n{len(points)} {len(faces)} 0\n")
    np.savetxt(file, points, "%.9g")
    np.savetxt(file, np.insert(faces, 0, 3, axis=1), "%d")
