# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes distances on a noisy scan from a point on it.

Arguments: a file with points, and three coordinates. Without them, the scan is a noisy sphere.
Output: distances.txt, one line per point.
"""

import sys

import geodesic_processing as gp
import numpy as np

if len(sys.argv) > 1:
    scan = gp.read(sys.argv[1])
    point = [float(argument) for argument in sys.argv[2:5]]
else:
    # Random points near the unit sphere. The standard deviation of the noise is 0.01.
    random = np.random.default_rng(1)
    P = random.normal(size=(4000, 3))
    P *= random.normal(1, 0.01, (4000, 1)) / np.linalg.norm(P, axis=1, keepdims=True)
    scan = gp.Surface(P)  # a cloud; normals and radii are estimated
    point = [0, 0, 1]

source = scan.locate([point])[0]
distances = scan.distance(source)
np.savetxt("distances.txt", distances)

is_reached = np.isfinite(distances)
farthest = np.where(is_reached, distances, -1).argmax()
path = scan.path(source, farthest)
print(f"reached points: {is_reached.sum()} of {len(distances)}")
print(f"largest distance: {distances[farthest]:.4f}")
print(f"length of the path: {path.length:.4f}, {len(path.points)} points")
