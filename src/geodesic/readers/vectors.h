// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_VECTORS_H
#define GEODESIC_PROGRAM_READERS_VECTORS_H

#include "readers/Surface_file.h"

#include <cmath>

// Operations on the points of files and pictures, which are also vectors
namespace program {

inline Point operator+(const Point& p, const Point& q)
{
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}
inline Point operator-(const Point& p, const Point& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Point operator*(double factor, const Point& p)
{
  return {factor * p[0], factor * p[1], factor * p[2]};
}
inline double dot(const Point& p, const Point& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline Point cross(const Point& p, const Point& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
inline double norm(const Point& p) { return std::sqrt(dot(p, p)); }

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_VECTORS_H
