// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_VECTORS_H
#define GEODESIC_PROGRAM_PICTURE_VECTORS_H

#include "io/Surface_file.h"

#include <cmath>

namespace program {

// Operations on points as vectors
inline Point operator+(const Point& a, const Point& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator-(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator*(double t, const Point& a) { return {t * a[0], t * a[1], t * a[2]}; }

inline double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

inline double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_VECTORS_H
