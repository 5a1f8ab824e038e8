// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the cosine of the angle between two vectors, or 1 if one of them is zero.
double cosine_between(const Vec3& p, const Vec3& q)
{
  const double size = norm(p) * norm(q);
  return size > 0. ? dot(p, q) / size : 1.;
}

// Returns the length of a circular arc over a chord from the sine of half its central angle. Below
// 1e-4 the series of asin(x) / x is exact to round-off errors.
double arc_length_over_chord(double chord, double sine)
{
  return chord * (sine > 1e-4 && sine < 1. ? std::asin(sine) / sine : 1. + sine * sine / 6.);
}

// A path that turns by 30 degrees or more at a point has a corner there.
constexpr double corner_cosine = 0.86602540378443865;

// Points whose normals differ by more than 40 degrees are separated by a sharp edge.
constexpr double sharp_edge_cosine = 0.76604444311897804;

// Segments whose lengths differ by at most this factor have parameter intervals of equal length.
constexpr double max_even_ratio = 2.;

// Computes the shortest path between two points across the line of intersection of their tangent
// planes. Sets the point on that line and the length of the path. Returns false if the points are
// not separated by a sharp edge.
bool find_sharp_edge(const Projection& from, const Projection& to, Vec3& point, double& length)
{
  const Vec3 chord = to.point - from.point;
  const double cosine = dot(from.normal, to.normal);
  if(cosine > sharp_edge_cosine || cosine < -0.99 || dot(from.normal, from.normal) == 0. ||
     dot(to.normal, to.normal) == 0.)
    return false;
  const Vec3 edge_direction = unit(cross(from.normal, to.normal));
  // Project the line to the plane through `from` that is spanned by both normals.
  const Vec3 perpendicular = chord - dot(chord, edge_direction) * edge_direction;
  const double height = dot(perpendicular, to.normal), square = 1. - cosine * cosine;
  const double a = -cosine * height / square, b = height / square;
  const Vec3 projection = a * from.normal + b * to.normal; // relative to `from`
  const double distance_before = norm(projection),
               distance_after = norm(projection - perpendicular);
  // If the detour over the edge is that long, the edge does not lie between the points.
  if(distance_before + distance_after > 2. * norm(chord))
    return false;
  const double distance_along_edge = dot(chord, edge_direction);
  const double fraction = distance_before + distance_after > 0.
                              ? distance_before / (distance_before + distance_after)
                              : 0.5;
  point = from.point + projection + fraction * distance_along_edge * edge_direction;
  length = std::hypot(distance_before + distance_after, distance_along_edge);
  return true;
}

} // namespace

std::vector<Projection> insert_sharp_edges(const std::vector<Projection>& path)
{
  std::vector<Projection> result = {path.front()};
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    Projection edge_point = path[i];
    double length;
    if(find_sharp_edge(path[i], path[i + 1], edge_point.point, length))
      result.push_back(edge_point);
    result.push_back(path[i + 1]);
  }
  return result;
}

std::vector<Projection> subdivide_curve(const Path_surface& surface,
                                        const std::vector<Projection>& path)
{
  std::vector<Projection> result;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Vec3 segment = path[i + 1].point - path[i].point;
    const double interval = norm(segment);
    // Returns the length of the parameter interval of an adjacent segment.
    const auto adjacent_interval = [&](const Vec3& adjacent)
    {
      const double length = norm(adjacent);
      return std::max(length, interval) <= max_even_ratio * std::min(length, interval) ? interval
                                                                                       : length;
    };
    const auto second_difference =
        [&](const Vec3& before, const Vec3& after, double interval_before, double interval_after)
    {
      if(!(cosine_between(before, after) > corner_cosine) ||
         !(std::min(interval_before, interval_after) > 0.))
        return Vec3{0., 0., 0.};
      return 1. / (interval_before + interval_after) *
             (1. / interval_after * after - 1. / interval_before * before);
    };
    // The cubic polynomial is a combination of the parabolas through the first and the last three
    // points. At an end of the path, there is only one parabola.
    Vec3 left = {0., 0., 0.}, right = left;
    double left_interval = 0., right_interval = 0.;
    if(i > 0)
    {
      const Vec3 before = path[i].point - path[i - 1].point;
      left_interval = adjacent_interval(before);
      left = second_difference(before, segment, left_interval, interval);
    }
    if(i + 2 < path.size())
    {
      const Vec3 after = path[i + 2].point - path[i + 1].point;
      right_interval = adjacent_interval(after);
      right = second_difference(segment, after, interval, right_interval);
    }
    double right_weight = i > 0 ? 0. : 1.;
    if(i > 0 && i + 2 < path.size() && interval > 0.)
      right_weight = (left_interval + 0.5 * interval) / (left_interval + interval + right_interval);
    const Vec3 midpoint =
        0.5 * (path[i].point + path[i + 1].point) -
        0.25 * interval * interval * ((1. - right_weight) * left + right_weight * right);
    result.push_back(path[i]);
    result.push_back(surface.project(midpoint, path[i].vertex));
  }
  result.push_back(path.back());
  return result;
}

double polyline_length(const std::vector<Projection>& points)
{
  double sum = 0.;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    sum += norm(points[i + 1].point - points[i].point);
  return sum;
}

double arc_length(const Projection& from, const Projection& to)
{
  Vec3 edge_point;
  double length_around_edge;
  if(find_sharp_edge(from, to, edge_point, length_around_edge))
    return length_around_edge;
  const Vec3 chord = to.point - from.point;
  const double length = norm(chord);
  const auto angle = [&](const Vec3& normal)
  { return length > 0. ? std::asin(std::clamp(dot(chord, normal) / length, -1., 1.)) : 0.; };
  return arc_length_over_chord(length,
                               std::sin(0.5 * std::abs(angle(from.normal) - angle(to.normal))));
}

double curve_length(const std::vector<Projection>& points)
{
  const std::size_t n = points.size();
  std::vector<double> curvature(n, 0.);
  for(std::size_t i = 1; i + 1 < n; ++i)
  {
    const Vec3 before = points[i].point - points[i - 1].point,
               after = points[i + 1].point - points[i].point;
    if(cosine_between(before, after) > corner_cosine)
      curvature[i] = 2. * norm(cross(before, after)) /
                     std::max(norm(before) * norm(after) * norm(before + after), 1e-300);
  }
  if(n > 2)
  {
    curvature[0] = curvature[1];
    curvature[n - 1] = curvature[n - 2];
  }
  double sum = 0.;
  for(std::size_t i = 0; i + 1 < n; ++i)
  {
    const double chord = norm(points[i + 1].point - points[i].point);
    // Half of the central angle, which is close to its sine.
    const double sine = 0.25 * (curvature[i] + curvature[i + 1]) * chord;
    // arc_length_over_chord() multiplies in another order, which changes the last bits.
    sum +=
        sine > 1e-4 && sine < 1. ? chord * std::asin(sine) / sine : chord * (1. + sine * sine / 6.);
  }
  return sum;
}

} // namespace CGAL::Geodesic_processing::internal
