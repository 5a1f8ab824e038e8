// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMPASS_ROSE_H
#define GEODESIC_PROGRAM_COMPASS_ROSE_H

#include "Image.h"

namespace program {

// A round picture that tells where up is: a star of eight rays, the upper one red, in a ring.
Image compass_rose();

} // namespace program

#endif // GEODESIC_PROGRAM_COMPASS_ROSE_H
