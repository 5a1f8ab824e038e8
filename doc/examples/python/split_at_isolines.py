# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts a mesh into bands between isolines of the distance to a boundary, and measures them.

Arguments: a mesh with a boundary, and the width of the bands.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
    width = float(sys.argv[2])
else:
    # A tube of radius 1 and height 2 with 48 sides.
    angle, z = np.meshgrid(np.arange(48) * np.pi / 24, np.linspace(0, 2, 18))
    V = np.stack([np.cos(angle), np.sin(angle), z], axis=-1).reshape(-1, 3)
    i = np.arange(len(V)).reshape(angle.shape)
    j = np.roll(i, -1, axis=1)
    surface = gp.Surface(V, np.stack([i[:-1], j[:-1], j[1:], i[1:]], axis=-1).reshape(-1, 4))
    width = 0.6

boundary = max(surface.border_sources(), key=len)  # the one with the most vertices
distance = surface.distance(boundary)
levels = np.arange(width, distance.max(), width)
lines = surface.isolines(distance, levels)
split = surface.split_at_isolines(distance, levels)
a, b, c = np.moveaxis(split.surface.vertices[split.surface.faces], 1, 0)
areas = np.bincount(split.labels, np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)
for level in levels:
    total = sum(line.length for line in lines if line.value == level)
    print(f"isolines at distance {level:.4f}: length {total:.6f}")
print("areas of the bands:", *(f"{area:.6f}" for area in areas))
