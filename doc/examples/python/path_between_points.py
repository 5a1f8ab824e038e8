# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes a shortest path between two points that were clicked in a viewer.

Arguments: a file, and six coordinates of two points. The points need not be on the surface.
Output: path.obj, a polyline.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
    clicks = np.array(sys.argv[2:8], float).reshape(2, 3)
else:
    # A tube of radius 1 and height 2 with 64 sides.
    angle, z = np.meshgrid(np.arange(64) * np.pi / 32, np.linspace(0, 2, 21))
    V = np.stack([np.cos(angle), np.sin(angle), z], axis=-1).reshape(-1, 3)
    i = np.arange(len(V)).reshape(angle.shape)
    j = np.roll(i, -1, axis=1)
    F = np.stack([i[:-1], j[:-1], j[1:], i[1:]], axis=-1).reshape(-1, 4)
    surface = gp.Surface(V, F)
    clicks = np.array([[1.1, 0, 0.13], [0, 1.1, 1.73]])

start, end = surface.locate(clicks)  # the closest locations, also inside faces
path = surface.path(start, end)
print(f"length: {path.length:.6f}, {len(path.points)} points")
print(f"no path is shorter than {path.lower:.6f}")

with open("path.obj", "w") as file:
    file.writelines("v {} {} {}\n".format(*point) for point in path.points)
    file.write("l " + " ".join(str(i + 1) for i in range(len(path.points))) + "\n")
