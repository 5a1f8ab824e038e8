// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_APPROXIMATE_WINDOWS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_APPROXIMATE_WINDOWS_H

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_pool.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Geodesic_processing::internal {

// Approximate window propagation: two consecutive windows of an edge are replaced by one with a
// point source, as far as a tolerance admits (Surazhsky and others 2005, section 5).
//
// Unlike there, the distances of the new window are nowhere larger than those of the old ones, and
// equal at the outer ends. Three properties follow.
// - Its lines cover at least the region that the old lines cover. This is because its distance is
//   smaller beside the ends, so that its lines there lean farther outwards.
// - Whatever dominates a window, the distances behind it can only become smaller than those of the
//   exact propagation. They are therefore lower bounds.
// - The smallest distance is continuous along an edge, as in the exact propagation, which the
//   pruning of windows requires. Without equal distances at the ends, lower bounds were up to 1.5 %
//   too large.
// The largest difference of the distances, added to the error of the old windows, is the error of
// the new one. It bounds the length of real paths through it.

// An interval of an edge, and the distances at its ends.
struct End_distances
{
  double length, at_begin, at_end;
};

// A point source with the given distances at the ends is determined by its offset. The larger the
// offset, the smaller are the distances in between. The following two functions return the smallest
// offset with one more property, or -infinity if each offset has it.

// The distance increases at the begin by at most this slope.
inline double offset_for_slope(const End_distances& ends, double slope)
{
  const double p = ends.at_begin, q = ends.at_end, excess = (q - p) / ends.length - slope;
  return excess > 0.
             ? ((q - p) * (q + p) / ends.length - 2. * p * slope - ends.length) / (2. * excess)
             : -std::numeric_limits<double>::infinity();
}

// The distance at a position between the ends is at most this one, by Stewart's theorem.
inline double offset_for_distance(const End_distances& ends, double position, double distance)
{
  const double p = ends.at_begin, q = ends.at_end, t = position / ends.length;
  const double excess = p + t * (q - p) - distance;
  return excess > 0. ? ((p - distance) * (p + distance) + t * (q - p) * (q + p) -
                        position * (ends.length - position)) /
                           (2. * excess)
                     : -std::numeric_limits<double>::infinity();
}

// Returns the derivative of a window's distance along the edge.
inline double slope(const Window& w, double position)
{
  const Vec2 to_source = w.source - w.weight() * Vec2{position, 0.};
  return -to_source[0] / norm(to_source);
}

// Returns the largest value, in the first window, of its distance minus that of the second one. The
// second window is not straight.
inline double max_difference(const Window& w, const Window& other)
{
  double result = std::max(w.distance(w.begin) - other.distance(w.begin),
                           w.distance(w.end) - other.distance(w.end));
  // The difference has one extremum, where the lines to both sources are parallel.
  const Vec2 direction = w.is_straight() ? w.source : other.source - w.source;
  const double extremum = other.source[0] - direction[0] * (other.source[1] / direction[1]);
  if(extremum > w.begin && extremum < w.end)
    result = std::max(result, w.distance(extremum) - other.distance(extremum));
  return result;
}

// Merges window `a` into its successor `b` if the error of the result is at most `tolerance` times
// its smallest distance. Otherwise returns false.
inline bool merge_similar(const Window& a, Window& b, double tolerance, double min_length)
{
  // The radius of the wave is at most this multiple of the distance: a larger one has round-off
  // errors, and changes the distances on an edge by less than the tolerances in use.
  constexpr double max_radius = 16.;
  constexpr double round_off = 1. + 1e-12;

  if(b.begin - a.end > min_length || a.begin > b.begin || a.end > b.end)
    return false;
  const End_distances ends = {b.end - a.begin, a.distance(a.begin), b.distance(b.end)};
  const double a_end = a.distance(a.end), b_begin = b.distance(b.begin);
  const double offset = std::max(
      {-max_radius * (ends.at_begin + ends.at_end), offset_for_slope(ends, slope(a, a.begin)),
       offset_for_slope({ends.length, ends.at_end, ends.at_begin}, -slope(b, b.end)),
       offset_for_distance(ends, a.end - a.begin, a_end),
       offset_for_distance(ends, b.begin - a.begin, b_begin)});
  // The position of the source from its distances to both ends.
  const double radius = ends.at_begin - offset;
  const double x = 0.5 * ((ends.at_begin - ends.at_end) *
                              (ends.at_begin + ends.at_end - 2. * offset) / ends.length +
                          ends.length);
  const double square = (radius - x) * (radius + x);
  if(!(square > 0.) || !(radius > 0.) || !(ends.at_end > offset))
    return false;
  const Window result = {{a.begin + x, -std::sqrt(square)}, offset, a.begin, b.end, b.origin, 0.f};
  // Windows that are not the nearest ones at their outer ends have no such source.
  if(!(result.distance(a.begin) <= ends.at_begin * round_off &&
       result.distance(b.end) <= ends.at_end * round_off &&
       result.distance(a.end) <= a_end * round_off &&
       result.distance(b.begin) <= b_begin * round_off))
    return false;
  // Differences are negative by round-off errors if the windows have the same source. A window with
  // a negative error would be a straight front.
  const double error =
      std::max({0., max_difference(a, result) + a.error(), max_difference(b, result) + b.error()});
  if(!(error <= tolerance * result.distance(std::clamp(result.source[0], a.begin, b.end))))
    return false;
  b = result;
  b.signed_error = std::nextafter(float(error), std::numeric_limits<float>::infinity());
  return true;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_APPROXIMATE_WINDOWS_H
