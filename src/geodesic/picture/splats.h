// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_SPLATS_H
#define GEODESIC_PROGRAM_PICTURE_SPLATS_H

#include "picture/Render_mesh.h"

#include <vector>

namespace program {

// Returns a disk for each point, orthogonal to its normal. The radius is chosen so that adjacent
// disks overlap.
Render_mesh make_splats(const std::vector<Point>& points, const std::vector<Point>& normals,
                        const std::vector<Color>& colors);

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_SPLATS_H
