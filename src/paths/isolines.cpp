// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/isolines.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the position between the ends of an edge at which linear interpolation has the value
// `level`. lower < level <= upper.
double linear_crossing(double lower, double upper, double level)
{
  const double difference = upper - lower;
  if(std::isfinite(difference))
    return (level - lower) / difference;
  return (0.5 * level - 0.5 * lower) / (0.5 * upper - 0.5 * lower);
}

// Returns the position between the ends of an edge at which the distance from a point in the plane
// is `level`. The distances of the ends are lower < level <= upper, lower >= 0.
//
// The squared distance at position t is (1 - t) lower^2 + t upper^2 - t (1 - t) length^2. It is
// convex, so that it equals level^2 at exactly one position of the edge, also if the values violate
// the triangle inequality.
double circular_crossing(double lower, double upper, double level, double length)
{
  // The largest number becomes one, because squares may overflow.
  const double size = std::max(upper, length);
  const double l = lower / size, u = upper / size, d = level / size, e = length / size;
  const double quadratic = e * e, linear = (u - l) * (u + l) - e * e;
  const double constant = (d - l) * (d + l);
  const double root = std::sqrt(linear * linear + 4. * quadratic * constant);
  const double t =
      linear >= 0. ? 2. * constant / (linear + root) : (root - linear) / (2. * quadratic);
  return t >= 0. ? std::min(t, 1.) : linear_crossing(lower, upper, level);
}

} // namespace

double isoline_position(double lower, double upper, double level, double length,
                        Edge_interpolation interpolation)
{
  return interpolation == Edge_interpolation::circular && lower >= 0.
             ? circular_crossing(lower, upper, level, length)
             : linear_crossing(lower, upper, level);
}

namespace {

// The triangles that the isolines of each level visit.
struct Triangles_of_levels
{
  std::vector<std::size_t> begin; // #levels + 1
  std::vector<Index> triangle;
};

class Isoline_tracer
{
public:
  Isoline_tracer(const Surface_arrays& triangles, const std::vector<double>& values,
                 Edge_interpolation interpolation)
      : m_triangles(triangles), m_values(values), m_interpolation(interpolation),
        m_last_visit(triangles.number_of_triangles(), 0)
  {}

  // Appends the isolines of one level, given the triangles that they visit.
  void trace(std::size_t level_index, double level, const Index* begin, const Index* end,
             std::vector<Isoline>& isolines)
  {
    m_level = level;
    ++m_visit;
    for(const bool is_open : {true, false})
      for(const Index* f = begin; f != end; ++f)
        if(m_last_visit[*f] != m_visit && (!is_open || next_triangle(entry(*f)) == none))
        {
          Isoline isoline = isoline_from(*f);
          isoline.level = level_index;
          // Isolines around a maximum at a vertex are points.
          if(isoline.polyline.size() > 1)
            isolines.push_back(std::move(isoline));
        }
  }

  // Returns whether all values of a triangle are finite.
  bool has_values(Index f) const
  {
    return std::isfinite(value(3 * f)) && std::isfinite(value(3 * f + 1)) &&
           std::isfinite(value(3 * f + 2));
  }

  // Returns the value at the source of a halfedge.
  double value(Index h) const { return m_values[m_triangles.corner[h]]; }

private:
  bool is_above(Index h) const { return value(h) >= m_level; }

  // Returns the halfedge on which the isoline enters a triangle, from above to below.
  Index entry(Index f) const
  {
    Index h = 3 * f;
    while(!is_above(h) || is_above(next_halfedge(h)))
      ++h;
    return h;
  }
  // Returns the halfedge on which the isoline leaves a triangle, from below to above.
  Index exit(Index f) const
  {
    Index h = 3 * f;
    while(is_above(h) || !is_above(next_halfedge(h)))
      ++h;
    return h;
  }

  // Returns the triangle on the other side of a halfedge, or none at the end of an isoline.
  Index next_triangle(Index h) const
  {
    const Index twin = m_triangles.twin[h];
    return twin != none && has_values(twin / 3) ? twin / 3 : none;
  }

  // Returns the location at which the isoline crosses a halfedge. The position does not depend on
  // the direction of the halfedge.
  Surface_location crossing(Index h) const
  {
    const Index next = next_halfedge(h);
    const bool is_rising = !is_above(h);
    const double lower = value(is_rising ? h : next), upper = value(is_rising ? next : h);
    const double t = isoline_position(lower, upper, m_level,
                                      m_triangles.scale * m_triangles.length[h], m_interpolation);
    Surface_location location;
    location.triangle = h / 3;
    location.barycentric = {0., 0., 0.};
    location.barycentric[(is_rising ? h : next) % 3] = 1. - t;
    location.barycentric[(is_rising ? next : h) % 3] = t;
    return canonical(m_triangles, location);
  }

  // Follows the isoline that enters a triangle.
  Isoline isoline_from(Index first)
  {
    Isoline result;
    result.polyline.push_back(crossing(entry(first)));
    Index f = first;
    do
    {
      m_last_visit[f] = m_visit;
      const Index h = exit(f);
      const Surface_location location = crossing(h);
      // All crossings around a vertex whose value is the level are the same point.
      if(!is_same_point(m_triangles, result.polyline.back(), location))
        result.polyline.push_back(location);
      f = next_triangle(h);
    } while(f != none && f != first);
    result.is_closed = f == first;
    if(result.is_closed)
      result.polyline.back() = result.polyline.front();
    return result;
  }

  const Surface_arrays& m_triangles;
  const std::vector<double>& m_values;
  Edge_interpolation m_interpolation;
  double m_level = 0.;
  // #triangles: the number of the last level that visited a triangle, counted from one
  std::vector<std::size_t> m_last_visit;
  std::size_t m_visit = 0;
};

// Returns the triangles of each level, where levels are sorted.
Triangles_of_levels triangles_of_levels(const Surface_arrays& triangles,
                                        const Isoline_tracer& tracer,
                                        const std::vector<double>& sorted_levels)
{
  Triangles_of_levels result;
  result.begin.assign(sorted_levels.size() + 1, 0);
  // Calls f with the first level above the smallest value and the first one above the largest.
  const auto for_each_triangle = [&](const auto& f)
  {
    for(Index i = 0; i < triangles.number_of_triangles(); ++i)
    {
      if(!tracer.has_values(i))
        continue;
      const auto [low, high] =
          std::minmax({tracer.value(3 * i), tracer.value(3 * i + 1), tracer.value(3 * i + 2)});
      const auto first = std::upper_bound(sorted_levels.begin(), sorted_levels.end(), low);
      const auto last = std::upper_bound(first, sorted_levels.end(), high);
      f(i, std::size_t(first - sorted_levels.begin()), std::size_t(last - sorted_levels.begin()));
    }
  };
  for_each_triangle(
      [&](Index, std::size_t first, std::size_t last)
      {
        for(std::size_t level = first; level < last; ++level)
          ++result.begin[level + 1];
      });
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  result.triangle.resize(result.begin.back());
  std::vector<std::size_t> position(result.begin.begin(), result.begin.end() - 1);
  for_each_triangle(
      [&](Index i, std::size_t first, std::size_t last)
      {
        for(std::size_t level = first; level < last; ++level)
          result.triangle[position[level]++] = i;
      });
  return result;
}

} // namespace

std::vector<Isoline> find_isolines(const Surface_arrays& triangles,
                                   const std::vector<double>& values,
                                   const std::vector<double>& levels,
                                   Edge_interpolation interpolation,
                                   const std::function<bool(double)>& callback)
{
  std::vector<double> sorted_levels = levels;
  std::sort(sorted_levels.begin(), sorted_levels.end());
  sorted_levels.erase(std::unique(sorted_levels.begin(), sorted_levels.end()), sorted_levels.end());
  Isoline_tracer tracer(triangles, values, interpolation);
  const Triangles_of_levels visited = triangles_of_levels(triangles, tracer, sorted_levels);
  std::vector<Isoline> isolines;
  for(std::size_t i = 0; i < levels.size(); ++i)
  {
    if(callback)
      callback(double(i) / double(levels.size()));
    const std::size_t rank =
        std::size_t(std::lower_bound(sorted_levels.begin(), sorted_levels.end(), levels[i]) -
                    sorted_levels.begin());
    tracer.trace(i, levels[i], visited.triangle.data() + visited.begin[rank],
                 visited.triangle.data() + visited.begin[rank + 1], isolines);
  }
  return isolines;
}

} // namespace CGAL::Geodesic_processing::internal
