# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flattens a patch and writes it with texture coordinates. Argument: a mesh with a boundary.

Output: flat.obj.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
else:
    # A folded sheet of paper: a curve with 40 steps of length 0.1, extruded along y.
    angle = np.sin(np.arange(40) * np.pi / 20)
    x, z = (np.append(0, np.cumsum(0.1 * f(angle))) for f in (np.cos, np.sin))
    V = np.stack([np.repeat(x, 31), np.tile(np.linspace(0, 3, 31), 41), np.repeat(z, 31)], axis=1)
    i = np.arange(len(V)).reshape(41, 31)
    F = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    surface = gp.Surface(V, F)

uv, _, distortion = surface.flatten()
print(f"inverted faces: {distortion.number_of_flips} of {distortion.number_of_triangles}")
print(f"distortion of angles {distortion.conformal:.4f}, of areas {distortion.authalic:.4f}")

corners = np.repeat(surface.faces + 1, 2, axis=1)
with open("flat.obj", "w") as file:
    np.savetxt(file, surface.vertices, "v %.9g %.9g %.9g")
    np.savetxt(file, np.nan_to_num(uv), "vt %.9g %.9g")
    np.savetxt(file, corners, "f %d/%d %d/%d %d/%d")
