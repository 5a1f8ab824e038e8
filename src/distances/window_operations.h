// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_OPERATIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_OPERATIONS_H

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_pool.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

// Operations on windows, in their coordinates (see Window).

// Positions and sources that differ by less than this fraction of the edge or distance are equal.
constexpr double merge_tolerance = 1e-13;
// Two windows are split only if their overlap is larger than this fraction of the smaller one.
constexpr double min_overlap_ratio = 0.6;

// Returns a value that is positive if a position on the edge is to the right of the line from the
// window's source to the apex, and negative if it is to the left. The scale is arbitrary.
inline double side_of_apex_line(const Window& window, double position, const Vec2& apex_point)
{
  return (position * window.weight() - window.source[0]) * apex_point[1] +
         window.source[1] * (apex_point[0] - position);
}

// Reflects a window, so that its edge of this length runs in the opposite direction.
inline Window mirror(Window w, double length)
{
  if(w.is_straight())
    w.offset -= w.source[0] * length;
  w.source[0] = length * w.weight() - w.source[0];
  const double begin = w.begin;
  w.begin = length - w.end;
  w.end = length - begin;
  return w;
}

// Returns the part of a window that leaves the triangle through its left edge, in the coordinates
// of that edge's twin. The left edge runs from the origin along `axis` to the apex and has this
// length. `begin` and `end` are side_of_apex_line() of the window's ends; `begin` is negative.
inline Window clip_through_left(Window w, double begin, double end, const Vec2& axis, double length)
{
  // The line through (b, 0) meets the edge at the fraction b y / (b y + side_of_apex_line(b)).
  const double y = w.source[1];
  w.begin = length * (w.begin * y / (w.begin * y + begin));
  w.end = end < 0. ? length * (w.end * y / (w.end * y + end)) : length;
  w.source = {dot(w.source, axis), std::min(0., cross(axis, w.source))};
  return w;
}

// Narrows the interval [begin, end] in which `a` and `b` become equally far, by four steps of the
// regula falsi. The interval always contains the position of equal distance, so that a caller cuts
// off only parts with larger distances. The differences at the ends are distance of `a` minus
// distance of `b`.
inline void bracket_equal_distance(const Window& a, const Window& b, double& begin, double& end,
                                   double difference_at_begin, double difference_at_end)
{
  const double tolerance = 1e-14 * (std::abs(a.source[0]) + std::abs(a.source[1]));
  for(int step = 0; step < 4 && begin < end; ++step)
  {
    const double crossing =
        begin + (end - begin) * (difference_at_begin / (difference_at_begin - difference_at_end));
    if(!(crossing > begin && crossing < end))
      break;
    const double value = a.distance(crossing) - b.distance(crossing);
    if(value <= tolerance)
    {
      begin = crossing;
      difference_at_begin = value;
    }
    if(value >= -tolerance)
    {
      end = crossing;
      difference_at_end = value;
    }
  }
}

// Returns the position at which the difference of the distances of two windows is largest or
// smallest. It is NaN or infinite if there is none. Without it in an interval, the difference has
// one zero there at most; otherwise it can have two.
inline double extremum_of_difference(const Window& a, const Window& b)
{
  if(a.is_straight() == b.is_straight())
  {
    // The lines from both sources meet the edge at the same angle. Two straight fronts have weight
    // zero, and the result is NaN.
    const double height_of_a = a.weight() * a.source[1], height_of_b = b.weight() * b.source[1];
    return (a.source[0] * height_of_b - b.source[0] * height_of_a) / (height_of_b - height_of_a);
  }
  const Window &straight = a.is_straight() ? a : b, &curved = a.is_straight() ? b : a;
  return curved.source[0] - curved.source[1] * (straight.source[0] / straight.source[1]);
}

// Cuts off the ends of an overlap [begin, end] from a window that is closer in the middle only. The
// differences are distance of `a` minus distance of `b`.
inline void keep_middle(Window& a, const Window& b, double begin, double middle, double end,
                        double difference_at_begin, double difference_in_middle,
                        double difference_at_end)
{
  double last = middle;
  bracket_equal_distance(b, a, begin, last, -difference_at_begin, -difference_in_middle);
  bracket_equal_distance(a, b, middle, end, difference_in_middle, difference_at_end);
  if(a.begin >= b.begin)
    a.begin = begin;
  if(a.end <= b.end)
    a.end = end;
}

// Splits two overlapping windows at the position of equal distance; `a` is the first one along the
// edge. If one of them is farther in the whole overlap, cuts its overlap off. If their sources
// are equal, merges `a` into `b`. Returns false if `a` must be removed.
inline bool split_overlap(Window& a, Window& b, double min_length)
{
  double overlap_begin = std::max(a.begin, b.begin), overlap_end = std::min(a.end, b.end);
  if(overlap_end - overlap_begin < -min_length)
    return true;
  const auto is_equal = [&](double p, double q)
  { return std::abs(p - q) <= merge_tolerance * std::abs(p); };
  if(std::abs(a.source[0] - b.source[0]) <= merge_tolerance * std::abs(a.source[0]) + min_length &&
     std::abs(a.source[1] - b.source[1]) <= merge_tolerance * std::abs(a.source[1]) + min_length &&
     is_equal(a.offset, b.offset) && a.is_straight() == b.is_straight())
  {
    b.begin = std::min(a.begin, b.begin);
    b.end = std::max(a.end, b.end);
    b.signed_error = a.error() > b.error() ? a.signed_error : b.signed_error;
    return false;
  }
  if(!(overlap_end - overlap_begin >
       min_overlap_ratio * std::min(a.end - a.begin, b.end - b.begin) + min_length))
    return true;
  const double difference_at_begin = a.distance(overlap_begin) - b.distance(overlap_begin),
               difference_at_end = a.distance(overlap_end) - b.distance(overlap_end);
  if(difference_at_begin * difference_at_end >= 0. && a.offset != b.offset)
  {
    // With different offsets, a window can be closer in the middle of the overlap only.
    const double middle = extremum_of_difference(a, b);
    if(middle > overlap_begin && middle < overlap_end)
    {
      const double distance = a.distance(middle), difference = distance - b.distance(middle),
                   tolerance = merge_tolerance * std::abs(distance),
                   sum_at_ends = difference_at_begin + difference_at_end;
      if(difference < -tolerance && sum_at_ends >= 0.)
      {
        keep_middle(a, b, overlap_begin, middle, overlap_end, difference_at_begin, difference,
                    difference_at_end);
        return true;
      }
      if(difference > tolerance && sum_at_ends <= 0.)
      {
        keep_middle(b, a, overlap_begin, middle, overlap_end, -difference_at_begin, -difference,
                    -difference_at_end);
        return true;
      }
    }
  }
  if(difference_at_begin >= 0. && difference_at_end >= 0.)
  {
    if(a.end <= b.end)
    {
      if(a.begin >= b.begin)
        return false;
      a.end = overlap_begin;
    }
    return true;
  }
  if(difference_at_begin <= 0. && difference_at_end <= 0.)
  {
    if(b.begin >= a.begin)
      b.begin = overlap_end;
    return true;
  }
  if(difference_at_begin > 0.)
    return true; // not in order: both stay as they are
  bracket_equal_distance(a, b, overlap_begin, overlap_end, difference_at_begin, difference_at_end);
  if(a.end <= b.end)
    a.end = overlap_end;
  if(b.begin >= a.begin)
    b.begin = overlap_begin;
  return true;
}

// Cuts off the part of a window that overlaps with another one, if the other one is not farther in
// the whole overlap and if the overlap contains an end of the window.
inline void trim_dominated(Window& w, const Window& other)
{
  const double overlap_begin = std::max(w.begin, other.begin),
               overlap_end = std::min(w.end, other.end);
  const auto is_other_closer = [&](double position)
  {
    return other.distance(position) <=
           w.distance(position) + merge_tolerance * std::abs(w.distance(position));
  };
  if(!(overlap_begin < overlap_end) || (overlap_begin > w.begin && overlap_end < w.end) ||
     !is_other_closer(overlap_begin) || !is_other_closer(overlap_end))
    return;
  const double extremum = extremum_of_difference(w, other);
  if(extremum > overlap_begin && extremum < overlap_end && !is_other_closer(extremum))
    return;
  if(overlap_begin == w.begin)
    w.begin = overlap_end;
  else
    w.end = overlap_begin;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_OPERATIONS_H
