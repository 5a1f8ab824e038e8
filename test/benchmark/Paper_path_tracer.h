// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_PAPER_PATH_TRACER_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_PAPER_PATH_TRACER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace benchmarks {

// Traces paths as Peyre and Cohen 2003, section 2.3, for comparison: gradients at vertices are
// interpolated linearly in faces, and the path is integrated by the method of Runge and Kutta of
// fourth order. Choices that the paper does not state:
//
// - The gradient of a vertex is rotated into the plane of a face such that the bisectors of the
//   face's angle in the flattened ring and in the face agree.
// - The angles at a boundary vertex are not scaled. A step that leaves the surface slides along
//   the boundary edge, and ends at the end of that edge.
// - A step is straight across unfolded faces. In a face of the source, the path ends with a
//   straight segment to the source, because the distance has no gradient there.
class Paper_path_tracer
{
  using Index = CGAL::Geodesic_processing::internal::Index;
  using Vec2 = CGAL::Geodesic_processing::internal::Vec2;
  using Arrays = CGAL::Geodesic_processing::internal::Surface_arrays;

public:
  using Path = std::vector<CGAL::Geodesic_processing::internal::Surface_location>;

  // Keeps a reference to the arrays of a mesh. Takes O(n) time.
  //
  // distance  #vertices, in the scale of the arrays
  // step      length of a step where the gradient has length one, in mean edge lengths
  Paper_path_tracer(const Arrays& arrays, std::vector<double> distance, Index source, double step)
      : m_arrays(arrays), m_distance(std::move(distance)), m_source(source),
        m_gradient(arrays.corner.size(), Vec2{0., 0.})
  {
    double sum = 0.;
    for(const double length : arrays.length)
      sum += length;
    m_step = step * sum / double(arrays.length.size());
    for(Index vertex = 0; vertex < arrays.number_of_vertices(); ++vertex)
      for_each_fan(vertex, [&](Index begin, Index end) { fit_gradient(vertex, begin, end); });
  }

  // Returns the path from a vertex to the source. Returns an empty path if it does not arrive: it
  // stops, or it takes ten times as many steps as the distance requires.
  Path operator()(Index from) const
  {
    using namespace CGAL::Geodesic_processing::internal;
    Path path = {vertex_location(m_arrays, from)};
    if(from == m_source)
      return path;
    Point x = point_next_to(from);
    const double max_steps = 10. * m_distance[from] / m_step + 100.;
    for(double steps = 0.; steps < max_steps; ++steps)
    {
      if(is_at_source(x.triangle))
      {
        path.push_back(vertex_location(m_arrays, m_source));
        return path;
      }
      append(path, x);
      const Vec2 move = runge_kutta_step(x);
      // The negation also stops at NaN, in faces without area.
      if(!(norm(move) > 1e-6 * m_step))
        return {};
      const Walk walked = walk(x, move, &path);
      if(!walked.is_valid)
        return {};
      x = walked.end;
      for(Index k = 0; k < 3; ++k)
        if(x.barycentric[k] > 1. - vertex_ratio)
        {
          append(path, x);
          x = point_next_to(m_arrays.corner[3 * x.triangle + k]);
          break;
        }
    }
    return {};
  }

private:
  // Crossings of edges and starts of paths keep at least this fraction of an edge from vertices.
  // It exceeds round-off errors, and is far below the lengths to be measured.
  static constexpr double vertex_ratio = 1e-7;

  struct Point
  {
    Index triangle = 0;
    std::array<double, 3> barycentric = {1., 0., 0.};
  };
  struct Walk
  {
    Point end;
    Vec2 rotation = {1., 0.}; // from the frame of the first triangle to that of the last one
    bool is_valid = true;
  };

  // Calls f with the range in `ring` of each fan of a vertex.
  template <typename Function>
  void for_each_fan(Index vertex, Function f) const
  {
    const Index last = m_arrays.ring_begin[vertex + 1];
    for(Index begin = m_arrays.ring_begin[vertex], end = begin; begin < last; begin = end)
    {
      do
        ++end;
      while(end < last && m_arrays.ring[end] == next_corner_ccw(m_arrays, m_arrays.ring[end - 1]));
      f(begin, end);
    }
  }

  // Fits the gradient of a vertex to the slopes along the edges of a fan, whose angles are scaled
  // to the sum 2 pi. Stores the gradient in the frame of each triangle of the fan.
  void fit_gradient(Index vertex, Index begin, Index end)
  {
    using namespace CGAL::Geodesic_processing::internal;
    const Arrays& t = m_arrays;
    const bool is_closed = next_corner_ccw(t, t.ring[end - 1]) == t.ring[begin];
    double sum = 0.;
    for(Index i = begin; i < end; ++i)
      sum += interior_angle(t, t.ring[i]);
    const double factor = is_closed ? 2. * pi / sum : 1.;

    double xx = 0., xy = 0., yy = 0., xs = 0., ys = 0.;
    const auto add = [&](double angle, Index neighbor, double length)
    {
      const double slope = (m_distance[neighbor] - m_distance[vertex]) / length;
      if(!std::isfinite(slope))
        return;
      const double x = std::cos(angle), y = std::sin(angle);
      xx += x * x;
      xy += x * y;
      yy += y * y;
      xs += x * slope;
      ys += y * slope;
    };
    double angle = 0.;
    for(Index i = begin; i < end; ++i)
    {
      const Index h = t.ring[i];
      add(angle, t.corner[next_halfedge(h)], t.length[h]);
      angle += factor * interior_angle(t, h);
    }
    if(!is_closed)
    {
      const Index h = previous_halfedge(t.ring[end - 1]);
      add(angle, t.corner[h], t.length[h]);
    }
    const double determinant = xx * yy - xy * xy;
    if(!(determinant > 0.))
      return;
    const Vec2 gradient = {(yy * xs - xy * ys) / determinant, (xx * ys - xy * xs) / determinant};

    angle = 0.;
    for(Index i = begin; i < end; ++i)
    {
      const Index h = t.ring[i];
      const double interior = interior_angle(t, h);
      const Vec2 edge = direction(h);
      const double turn =
          std::atan2(edge[1], edge[0]) + 0.5 * interior - (angle + 0.5 * factor * interior);
      m_gradient[h] = rotated(gradient, {std::cos(turn), std::sin(turn)});
      angle += factor * interior;
    }
  }

  // Returns the unit vector of a halfedge in the frame of its triangle.
  Vec2 direction(Index h) const
  {
    using namespace CGAL::Geodesic_processing::internal;
    const auto corners = unfolded(m_arrays, h / 3);
    const Vec2 edge = corners[next_halfedge(h) % 3] - corners[h % 3];
    return (1. / norm(edge)) * edge;
  }

  bool is_at_source(Index triangle) const
  {
    const Index* c = &m_arrays.corner[3 * std::size_t(triangle)];
    return c[0] == m_source || c[1] == m_source || c[2] == m_source;
  }

  void append(Path& path, const Point& x) const
  {
    using namespace CGAL::Geodesic_processing::internal;
    path.push_back(canonical(
        m_arrays, {x.triangle, CGAL::Geodesic_processing::internal::none, x.barycentric}));
  }

  Vec2 gradient(const Point& x) const
  {
    using namespace CGAL::Geodesic_processing::internal;
    Vec2 result = {0., 0.};
    for(Index k = 0; k < 3; ++k)
      result = result + x.barycentric[k] * m_gradient[3 * x.triangle + k];
    return result;
  }

  // Returns the point close to a vertex in the triangle whose angle contains the direction of
  // descent, or has the smallest angle to it.
  Point point_next_to(Index vertex) const
  {
    using namespace CGAL::Geodesic_processing::internal;
    Index best = m_arrays.ring[m_arrays.ring_begin[vertex]];
    double min_excess = infinity;
    for(Index i = m_arrays.ring_begin[vertex]; i < m_arrays.ring_begin[vertex + 1]; ++i)
    {
      const Index h = m_arrays.ring[i];
      const double half = 0.5 * interior_angle(m_arrays, h);
      const Vec2 bisector = rotated(direction(h), {std::cos(half), std::sin(half)});
      const Vec2 descent = -1. * m_gradient[h];
      const double excess =
          std::abs(std::atan2(cross(bisector, descent), dot(bisector, descent))) - half;
      if(excess < min_excess)
      {
        min_excess = excess;
        best = h;
      }
    }
    Point result;
    result.triangle = best / 3;
    result.barycentric.fill(2. * vertex_ratio);
    result.barycentric[best % 3] = 1. - 4. * vertex_ratio;
    return result;
  }

  // Returns the displacement of a step, in the frame of the triangle of the point.
  Vec2 runge_kutta_step(const Point& x) const
  {
    using namespace CGAL::Geodesic_processing::internal;
    const auto slope_after = [&](const Vec2& move)
    {
      const Walk walked = walk(x, move, nullptr);
      return rotated_back(-1. * gradient(walked.end), walked.rotation);
    };
    const Vec2 k1 = -1. * gradient(x);
    const Vec2 k2 = slope_after(0.5 * m_step * k1);
    const Vec2 k3 = slope_after(0.5 * m_step * k2);
    const Vec2 k4 = slope_after(m_step * k3);
    return m_step / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
  }

  // Moves a point straight across unfolded faces. Appends the crossed points to `path`, and ends in
  // a triangle of the source, if `path` is not null.
  Walk walk(const Point& x, Vec2 move, Path* path) const
  {
    using namespace CGAL::Geodesic_processing::internal;
    // Far more triangles than a step crosses, except in a cycle around needles.
    constexpr int max_crossings = 10000;
    Walk result;
    result.end = x;
    Index entered = none; // the corner opposite to the edge through which the point has entered
    for(int crossings = 0; crossings < max_crossings; ++crossings)
    {
      Point& end = result.end;
      const auto corners = unfolded(m_arrays, end.triangle);
      const double area = cross(corners[1], corners[2]);
      double fraction = 1.;
      std::array<double, 3> change;
      Index exit = none;
      for(Index k = 0; k < 3; ++k)
      {
        const Vec2 &p = corners[(k + 1) % 3], &q = corners[(k + 2) % 3];
        change[k] = cross(q - p, move) / area;
        if(k != entered && change[k] < 0. && end.barycentric[k] < -change[k] * fraction)
        {
          fraction = end.barycentric[k] / -change[k];
          exit = k;
        }
      }
      result.is_valid = std::isfinite(change[0] + change[1] + change[2]);
      if(!result.is_valid)
        return result;
      for(Index k = 0; k < 3; ++k)
        end.barycentric[k] = std::max(end.barycentric[k] + fraction * change[k], 0.);
      if(exit == none)
        return result;

      const Index h = 3 * end.triangle + (exit + 1) % 3, twin = m_arrays.twin[h];
      const double position =
          std::clamp(end.barycentric[next_halfedge(h) % 3], vertex_ratio, 1. - vertex_ratio);
      const Vec2 edge = direction(h);
      move = (1. - fraction) * move;
      if(twin == none)
      {
        const double slid = position + dot(move, edge) / m_arrays.length[h];
        end.barycentric = barycentric_on_halfedge(h, std::clamp(slid, 0., 1.));
        return result;
      }
      end.barycentric = barycentric_on_halfedge(h, position);
      if(path)
        append(*path, end);
      const Vec2 turn = rotated_back(-1. * direction(twin), edge);
      move = rotated(move, turn);
      result.rotation = rotated(result.rotation, turn);
      end.triangle = twin / 3;
      end.barycentric = barycentric_on_halfedge(twin, 1. - position);
      entered = previous_halfedge(twin) % 3;
      if(path && is_at_source(end.triangle))
        return result;
    }
    result.is_valid = false;
    return result;
  }

  const Arrays& m_arrays;
  std::vector<double> m_distance; // #vertices
  Index m_source;
  double m_step;
  std::vector<Vec2> m_gradient; // #corners: of the corner's vertex, in the frame of the triangle
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_PAPER_PATH_TRACER_H
