// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_COLORS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_COLORS_H

#include <CGAL/Geodesic_processing/internal/log_map/decal.h>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <array>
#include <cmath>

// Conversions between the user's color types and Rgba.

namespace CGAL::Geodesic_processing::internal {

inline Rgba to_rgba(const CGAL::IO::Color& color)
{
  return {color.red() / 255., color.green() / 255., color.blue() / 255., color.alpha() / 255.};
}
inline Rgba to_rgba(const std::array<double, 3>& color)
{
  return {color[0], color[1], color[2], 1.};
}
inline Rgba to_rgba(const Rgba& color) { return color; }

inline void assign(CGAL::IO::Color& color, const Rgba& rgba)
{
  const auto byte = [](double x)
  { return static_cast<unsigned char>(std::lround(255. * std::clamp(x, 0., 1.))); };
  color = CGAL::IO::Color(byte(rgba[0]), byte(rgba[1]), byte(rgba[2]), byte(rgba[3]));
}
inline void assign(std::array<double, 3>& color, const Rgba& rgba)
{
  color = {rgba[0], rgba[1], rgba[2]};
}
inline void assign(Rgba& color, const Rgba& rgba) { color = rgba; }

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_COLORS_H
