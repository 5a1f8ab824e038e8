// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_REPAIR_COMPLETE_NORMALS_H
#define GEODESIC_PROGRAM_REPAIR_COMPLETE_NORMALS_H

#include "readers/Surface_file.h"

namespace program {

// Gives unit normals to a cloud. Normals that are missing, zero or not finite are estimated from
// 16 neighbors. If all are missing, they are oriented along a minimum spanning tree. Otherwise,
// each is oriented like the nearest given normal. Returns whether given normals had to be
// replaced.
bool complete_normals(Surface_file& cloud, unsigned threads = 1);

} // namespace program

#endif // GEODESIC_PROGRAM_REPAIR_COMPLETE_NORMALS_H
