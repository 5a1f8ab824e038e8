# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stamps an image on a mesh: colors the vertices around a point by a logarithmic map.

Arguments: a mesh, a vertex, and the width of the stamp. Output: stamp.off, a mesh with colors.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
    center, width = int(sys.argv[2]), float(sys.argv[3])
else:
    # A curve with 200 steps of length 0.03, extruded along y.
    angle = np.sin(np.arange(200) * np.pi / 66)
    x, z = (np.append(0, np.cumsum(0.03 * f(angle))) for f in (np.cos, np.sin))
    V = np.stack([np.repeat(x, 101), np.tile(np.linspace(0, 3, 101), 201), np.repeat(z, 101)], 1)
    i = np.arange(len(V)).reshape(201, 101)
    F = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    surface = gp.Surface(V, F)
    center, width = 101 * 100 + 50, 2.0

# The image: rings in two colors, transparent outside.
t = (np.arange(256) + 0.5) / 128 - 1  # the centers of pixels
radius = np.hypot(*np.meshgrid(t, t))
image = np.zeros((256, 256, 4), np.uint8)
image[...] = np.where((radius % 0.4 < 0.2)[..., None], (200, 30, 60, 255), (250, 220, 90, 255))
image[radius > 1, 3] = 0

stamp = surface.decal(center, (width, width), method="exact")
colors = np.full((surface.number_of_points, 3), 220, np.uint8)
colors = surface.composite_decal(stamp, image, colors)
print(f"colored vertices: {len(stamp.vertices)} of {len(colors)}")
with open("stamp.off", "w") as file:
    file.write(f"COFF\n{len(colors)} {surface.number_of_faces} 0\n")
    np.savetxt(file, np.hstack([surface.vertices, colors]), "%.9g %.9g %.9g %d %d %d")
    np.savetxt(file, np.insert(surface.faces, 0, 3, axis=1), "%d")
