# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Divides a surface into geodesic Voronoi cells around evenly distributed seeds.

Arguments: a mesh and the number of parcels. Output: parcels.txt, the parcel of each vertex.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
    number_of_parcels = int(sys.argv[2])
else:
    # A sphere with folds.
    u, v = np.meshgrid(np.linspace(0, np.pi, 61), np.arange(96) * np.pi / 48, indexing="ij")
    radius = 1 + 0.12 * np.sin(u) ** 2 * np.sin(8 * u) * np.sin(6 * v)
    V = radius * np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)])
    i = np.arange(u.size).reshape(u.shape)
    i[0], i[-1] = i[0, 0], i[-1, 0]  # one vertex for each pole
    j = np.roll(i, -1, axis=1)
    F = np.stack([i[:-1], i[1:], j[1:], j[:-1]], axis=-1).reshape(-1, 4)
    surface = gp.Surface(V.reshape(3, -1).T, F)
    number_of_parcels = 12

seeds = surface.farthest_points(number_of_parcels).locations
voronoi = surface.voronoi(seeds)
np.savetxt("parcels.txt", voronoi.labels, "%d")

a, b, c = np.moveaxis(surface.vertices[surface.faces], 1, 0)
face_areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
areas = np.bincount(voronoi.face_labels, face_areas, number_of_parcels)
pairs = {(line.left, line.right) for line in voronoi.bisectors}
for parcel, area in enumerate(areas):
    neighbors = sorted({q for pair in pairs if parcel in pair for q in pair} - {parcel})
    print(f"parcel {parcel}: area {area:.4f}, next to {neighbors}")
