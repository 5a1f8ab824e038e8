// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A feature edge in one of its directions: a halfedge, or the reverse of a boundary halfedge, which
// has no twin.
struct Directed_edge
{
  Index halfedge = none;
  bool is_reversed = false;
};

// Consecutive samples of a polyline coincide if they are closer than the first fraction of a step.
// One of them is then moved along the polyline by the second fraction.
constexpr double coincidence_ratio = 1e-3, separation_ratio = 0.25;

class Feature_polylines
{
public:
  Feature_polylines(const Surface_arrays& t, const std::vector<double>& spacing)
      : m_triangles(t), m_spacing(spacing), m_edges_begin(t.number_of_vertices() + 1, 0),
        m_is_done(t.corner.size(), false)
  {
    for_each_directed_edge([&](const Directed_edge& edge)
                           { ++m_edges_begin[source_of(edge) + 1]; });
    std::partial_sum(m_edges_begin.begin(), m_edges_begin.end(), m_edges_begin.begin());
    m_edges_out.resize(m_edges_begin.back());
    std::vector<Index> end(m_edges_begin.begin(), m_edges_begin.end() - 1);
    for_each_directed_edge([&](const Directed_edge& edge)
                           { m_edges_out[end[source_of(edge)]++] = edge; });
  }

  std::vector<Surface_location> sample()
  {
    for(const bool is_loop : {false, true})
      for(Index vertex = 0; vertex + 1 < m_edges_begin.size(); ++vertex)
      {
        const Index number_of_steps = m_edges_begin[vertex + 1] - m_edges_begin[vertex];
        if(number_of_steps == 2 && !is_loop)
          continue;
        if(number_of_steps > 0 && !is_loop)
          m_result.push_back(vertex_location(m_triangles, vertex));
        for(Index i = m_edges_begin[vertex]; i < m_edges_begin[vertex + 1]; ++i)
          if(!m_is_done[m_edges_out[i].halfedge])
          {
            trace_chain(m_edges_out[i]);
            sample_chain(is_loop);
          }
      }
    return std::move(m_result);
  }

private:
  template <typename Visitor>
  void for_each_directed_edge(const Visitor& visit) const
  {
    for(Index halfedge = 0; halfedge < m_spacing.size(); ++halfedge)
      if(m_spacing[halfedge] > 0.)
      {
        visit(Directed_edge{halfedge, false});
        if(m_triangles.twin[halfedge] == none)
          visit(Directed_edge{halfedge, true});
      }
  }
  Index source_of(const Directed_edge& edge) const
  {
    return m_triangles.corner[edge.is_reversed ? next_halfedge(edge.halfedge) : edge.halfedge];
  }
  Index target_of(const Directed_edge& edge) const
  {
    return m_triangles.corner[edge.is_reversed ? edge.halfedge : next_halfedge(edge.halfedge)];
  }
  Vec3 direction(const Directed_edge& edge) const
  {
    return unit(m_triangles.point[target_of(edge)] - m_triangles.point[source_of(edge)]);
  }
  void mark(Index halfedge)
  {
    m_is_done[halfedge] = true;
    if(m_triangles.twin[halfedge] != none)
      m_is_done[m_triangles.twin[halfedge]] = true;
  }

  // Sets `m_chain` to the edges from `edge` on, up to a vertex in which not exactly two feature
  // edges meet.
  void trace_chain(Directed_edge edge)
  {
    m_chain.clear();
    for(;;)
    {
      mark(edge.halfedge);
      m_chain.push_back(edge);
      const Index end = target_of(edge), i = m_edges_begin[end];
      if(m_edges_begin[end + 1] != i + 2 ||
         (m_is_done[m_edges_out[i].halfedge] && m_is_done[m_edges_out[i + 1].halfedge]))
        return;
      edge = m_edges_out[m_is_done[m_edges_out[i].halfedge] ? i + 1 : i];
    }
  }

  void sample_chain(bool is_loop)
  {
    parameterize_chain(is_loop);
    const std::set<double> corners = find_corners();
    if(is_loop)
      m_result.push_back(vertex_location(m_triangles, source_of(m_chain[0])));
    const bool is_closed = is_loop || source_of(m_chain.front()) == target_of(m_chain.back());
    const std::size_t number_of_pieces = corners.size() - 1;
    const double min_steps =
        is_closed && number_of_pieces < 3 ? std::ceil(3. / double(number_of_pieces)) : 1.;
    m_samples.clear();
    for(auto from = corners.begin(), to = std::next(from); to != corners.end(); ++from, ++to)
    {
      const double number_of_steps = std::max(min_steps, std::round(*to - *from));
      const double step = (*to - *from) / number_of_steps;
      for(double k = 0.; k < number_of_steps; ++k)
        m_samples.push_back({*from + k / number_of_steps * (*to - *from), k > 0. ? step : 0.});
    }
    m_samples.push_back({*corners.rbegin(), 0.});
    separate_samples();
    for(std::size_t i = 1; i + 1 < m_samples.size(); ++i)
      m_result.push_back(location_on_chain(m_samples[i].position));
  }

  // Moves samples that coincide with the previous one by a fraction of a step. They do so if the
  // chain runs along both sides of a crack of zero width, with an end of the crack between them. An
  // edge between them would have the length zero.
  void separate_samples()
  {
    for(std::size_t i = 1; i < m_samples.size(); ++i)
    {
      Sample &a = m_samples[i - 1], &b = m_samples[i];
      const double max_distance = coincidence_ratio * std::max(a.step, b.step);
      if(!(max_distance > 0.) ||
         norm(point_on_chain(a.position) - point_on_chain(b.position)) >
             max_distance * m_spacing[m_chain[edge_at(b.position)].halfedge])
        continue;
      if(b.step > 0.)
        b.position += separation_ratio * b.step;
      else
        a.position -= separation_ratio * a.step;
    }
  }

  // Computes the turning angles and the arc lengths of the chain. A closed chain is rotated to
  // begin at the largest angle.
  void parameterize_chain(bool is_loop)
  {
    const std::size_t n = m_chain.size();
    m_turning_angle.assign(n, 0.);
    for(std::size_t i = is_loop ? 0 : 1; i < n; ++i)
    {
      const Vec3 before = direction(m_chain[(i + n - 1) % n]), after = direction(m_chain[i]);
      m_turning_angle[i] = std::atan2(norm(cross(before, after)), dot(before, after));
    }
    if(is_loop)
    {
      const auto sharpest = std::max_element(m_turning_angle.begin(), m_turning_angle.end()) -
                            m_turning_angle.begin();
      std::rotate(m_turning_angle.begin(), m_turning_angle.begin() + sharpest,
                  m_turning_angle.end());
      std::rotate(m_chain.begin(), m_chain.begin() + sharpest, m_chain.end());
    }
    m_arc_length.assign(1, 0.);
    for(const Directed_edge& edge : m_chain)
      m_arc_length.push_back(m_arc_length.back() +
                             m_triangles.length[edge.halfedge] / m_spacing[edge.halfedge]);
  }

  // Returns the arc lengths of the corners and of both ends of the chain.
  std::set<double> find_corners()
  {
    m_sharp_corners.clear();
    for(std::size_t i = 1; i < m_chain.size(); ++i)
      if(m_turning_angle[i] > pi / 3.)
        m_sharp_corners.push_back(i);
    std::stable_sort(m_sharp_corners.begin(), m_sharp_corners.end(),
                     [&](std::size_t i, std::size_t j)
                     { return m_turning_angle[i] > m_turning_angle[j]; });
    std::set<double> corners = {0., m_arc_length.back()};
    for(const std::size_t i : m_sharp_corners)
    {
      const auto above = corners.lower_bound(m_arc_length[i]);
      if(*above - m_arc_length[i] >= 0.5 && m_arc_length[i] - *std::prev(above) >= 0.5)
        corners.insert(m_arc_length[i]);
    }
    return corners;
  }

  // Returns the edge of the chain at an arc length.
  std::size_t edge_at(double position) const
  {
    const auto above = std::upper_bound(m_arc_length.begin() + 1, m_arc_length.end() - 1, position);
    return std::size_t(above - m_arc_length.begin()) - 1;
  }

  // Returns the location at an arc length.
  Surface_location location_on_chain(double position) const
  {
    const std::size_t i = edge_at(position);
    const double fraction =
        std::clamp((position - m_arc_length[i]) / (m_arc_length[i + 1] - m_arc_length[i]), 0., 1.);
    const Directed_edge& edge = m_chain[i];
    return canonical(
        m_triangles,
        {edge.halfedge / 3, none,
         barycentric_on_halfedge(edge.halfedge, edge.is_reversed ? 1. - fraction : fraction)});
  }

  Vec3 point_on_chain(double position) const
  {
    return scaled_coordinates(m_triangles, location_on_chain(position));
  }

  struct Sample
  {
    double position; // arc length
    double step;     // distance to the samples before and after it; 0 if it must not move
  };

  const Surface_arrays& m_triangles;
  const std::vector<double>& m_spacing; // #halfedges
  // #vertices + 1: begin of the edges of each vertex in `m_edges_out`
  std::vector<Index> m_edges_begin;
  std::vector<Directed_edge> m_edges_out; // the directed feature edges, by source
  std::vector<bool> m_is_done;            // #halfedges
  std::vector<Surface_location> m_result;

  // Buffers of a chain, members to avoid allocations: there can be as many chains as triangles.
  std::vector<Directed_edge> m_chain;
  // at the source of each edge; arc lengths in units of the spacing
  std::vector<double> m_turning_angle, m_arc_length;
  std::vector<std::size_t> m_sharp_corners;
  std::vector<Sample> m_samples;
};

} // namespace

std::vector<Surface_location> sample_feature_polylines(const Surface_arrays& triangles,
                                                       const std::vector<double>& spacing)
{
  return Feature_polylines(triangles, spacing).sample();
}

std::vector<bool> boundary_and_sharp_halfedges(const Surface_arrays& t, double angle)
{
  std::vector<Vec3> normal(angle < 180. ? t.number_of_triangles() : 0);
  for(Index f = 0; f < normal.size(); ++f)
  {
    const Vec3 origin = t.point[t.corner[3 * f]];
    normal[f] =
        unit(cross(t.point[t.corner[3 * f + 1]] - origin, t.point[t.corner[3 * f + 2]] - origin));
  }
  std::vector<bool> result(t.corner.size(), false);
  for(Index halfedge = 0; halfedge < t.corner.size(); ++halfedge)
    if(t.twin[halfedge] == none)
      result[halfedge] = true;
    else if(!normal.empty())
    {
      const Vec3 &u = normal[halfedge / 3], &v = normal[t.twin[halfedge] / 3];
      result[halfedge] = norm(u) > 0. && norm(v) > 0. &&
                         std::atan2(norm(cross(u, v)), dot(u, v)) >= angle * pi / 180.;
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
