// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_in_strip.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr double margin = Split_mesh::min_split_fraction;
// In radians: a smaller difference to pi shortens the path by less than round-off errors.
constexpr double turn_tolerance = 1e-7;
// The maximum number of edges visited by reroutings, which take about a tenth of a second.
constexpr std::size_t max_work = 1000000;

class Strip_shortener
{
public:
  Strip_shortener(const Split_mesh& mesh, const std::vector<bool>& is_barred, Index from, Index to,
                  std::vector<Index> halfedges)
      : m_mesh(mesh), m_t(mesh.triangles()), m_is_barred(is_barred), m_from(from), m_to(to),
        m_halfedges(std::move(halfedges))
  {
    simplify();
    run_funnel();
    // In regions of thin triangles, strips can have thousands of edges and need as many reroutings.
    // The path is valid after each of them, so that their number can be limited.
    std::size_t max_turns = 20 + max_work / (m_halfedges.size() + 1);
    while(!m_halfedges.empty() && max_turns-- > 0 && reroute_around_vertex())
      ;
  }

  const std::vector<Index>& halfedges() const { return m_halfedges; }
  // Returns the fraction of each edge at which the path crosses it.
  std::vector<double> fractions() const
  {
    std::vector<double> result(m_halfedges.size());
    for(std::size_t k = 0; k + 1 < m_bends.size(); ++k)
    {
      const Bend &p = m_bends[k], &q = m_bends[k + 1];
      for(std::size_t i = p.strip_index + 1; i < std::min(q.strip_index, m_halfedges.size()); ++i)
      {
        const Vec2 across = m_left[i] - m_right[i], segment = q.position - p.position;
        const double sine = cross(across, segment);
        const double fraction = sine != 0. ? cross(p.position - m_right[i], segment) / sine : 0.5;
        result[i] = std::clamp(fraction, margin, 1. - margin);
      }
      if(q.strip_index < m_halfedges.size())
        result[q.strip_index] = q.is_left ? 1. - margin : margin;
    }
    return result;
  }

private:
  struct Bend
  {
    Vec2 position;
    std::size_t strip_index; // index of its edge; that of the path's start is -1 (unsigned)
    bool is_left;
  };

  // Removes loops from the strip, and edges at both ends that are incident to the path's endpoints.
  void simplify()
  {
    std::map<Index, std::size_t> position_in_strip;
    std::vector<Index> result;
    for(const Index h : m_halfedges)
    {
      const auto previous_visit = position_in_strip.find(m_mesh.smaller_twin(h));
      if(previous_visit != position_in_strip.end())
      {
        const std::size_t new_size =
            previous_visit->second + (result[previous_visit->second] == h ? 1 : 0);
        while(result.size() > new_size)
        {
          position_in_strip.erase(m_mesh.smaller_twin(result.back()));
          result.pop_back();
        }
        continue;
      }
      position_in_strip[m_mesh.smaller_twin(h)] = result.size();
      result.push_back(h);
    }
    const auto is_incident = [&](Index h, Index vertex)
    { return m_mesh.source(h) == vertex || m_mesh.target(h) == vertex; };
    std::size_t begin = 0;
    for(std::size_t i = 0; i < result.size(); ++i)
      if(is_incident(result[i], m_from))
        begin = i + 1;
    std::size_t end = result.size();
    for(std::size_t i = result.size(); i-- > begin;)
      if(is_incident(result[i], m_to))
        end = i;
    m_halfedges.assign(result.begin() + std::ptrdiff_t(begin),
                       result.begin() + std::ptrdiff_t(end));
  }

  // Computes the positions of the left and right endpoints of the edges in the unfolded strip.
  void unfold()
  {
    m_left.clear();
    m_right.clear();
    if(m_halfedges.empty())
      return;
    const Index first = m_halfedges.front();
    const double base = m_mesh.distance_between(m_from, m_mesh.source(first));
    m_right.push_back({base, 0.});
    m_left.push_back(third_corner(base, m_mesh.distance_between(m_from, m_mesh.target(first)),
                                  m_mesh.length(first)));
    for(std::size_t i = 0;; ++i)
    {
      const Index twin = m_t.twin[m_halfedges[i]];
      const Vec2 back = m_right[i] - m_left[i];
      const double width = norm(back);
      const Vec2 direction = width > 0. ? (1. / width) * back : Vec2{1., 0.};
      const Vec2 far_corner =
          m_left[i] + rotated(third_corner(width, m_mesh.length(previous_halfedge(twin)),
                                           m_mesh.length(next_halfedge(twin))),
                              direction);
      if(i + 1 == m_halfedges.size())
      {
        m_end = far_corner;
        return;
      }
      const bool is_next = m_halfedges[i + 1] == next_halfedge(twin);
      m_right.push_back(is_next ? m_right[i] : far_corner);
      m_left.push_back(is_next ? far_corner : m_left[i]);
    }
  }

  // Runs the funnel algorithm (Lee and Preparata 1984) on edges shortened by a margin at both ends.
  void run_funnel()
  {
    unfold();
    const std::size_t n = m_halfedges.size(), before_first = std::size_t(-1);
    m_bends = {{{0., 0.}, before_first, false}};
    if(n == 0)
      return;
    const auto right = [&](std::size_t i)
    { return i == n ? m_end : (1. - margin) * m_right[i] + margin * m_left[i]; };
    const auto left = [&](std::size_t i)
    { return i == n ? m_end : (1. - margin) * m_left[i] + margin * m_right[i]; };
    Bend apex = m_bends.front(), left_bend = apex, right_bend = apex;
    for(std::size_t i = 0; i <= n; ++i)
    {
      const Vec2 to_right = right(i) - apex.position, to_left = left(i) - apex.position;
      if(cross(right_bend.position - apex.position, to_right) >= 0.)
      {
        if(right_bend.strip_index == apex.strip_index ||
           cross(left_bend.position - apex.position, to_right) <= 0.)
          right_bend = {right(i), i, false};
        else
        {
          apex = right_bend = left_bend;
          m_bends.push_back(apex);
          i = apex.strip_index;
          continue;
        }
      }
      if(cross(left_bend.position - apex.position, to_left) <= 0.)
      {
        if(left_bend.strip_index == apex.strip_index ||
           cross(right_bend.position - apex.position, to_left) >= 0.)
          left_bend = {left(i), i, true};
        else
        {
          apex = left_bend = right_bend;
          m_bends.push_back(apex);
          i = apex.strip_index;
          continue;
        }
      }
    }
    if(m_bends.back().strip_index != n)
      m_bends.push_back({m_end, n, true});
  }

  // Returns the length of the path.
  double length() const
  {
    double result = 0.;
    for(std::size_t k = 0; k + 1 < m_bends.size(); ++k)
      result += norm(m_bends[k + 1].position - m_bends[k].position);
    return result;
  }

  // Reroutes the strip around the first vertex whose outer angle is below pi (Xin and Wang 2007).
  // Because of the margins, the path may become longer; the rerouting is then undone. Returns
  // false if there is no vertex to try.
  bool reroute_around_vertex()
  {
    for(std::size_t k = 1; k + 1 < m_bends.size(); ++k)
    {
      const Bend& bend = m_bends[k];
      const Index h = m_halfedges[bend.strip_index];
      const Index vertex = bend.is_left ? m_mesh.target(h) : m_mesh.source(h);
      if(m_is_barred[vertex] || vertex == m_from || vertex == m_to ||
         std::find(m_rejected_vertices.begin(), m_rejected_vertices.end(), vertex) !=
             m_rejected_vertices.end())
        continue;
      const Vec2 u = m_bends[k - 1].position - bend.position,
                 v = m_bends[k + 1].position - bend.position;
      double outer_angle = std::abs(std::atan2(cross(u, v), dot(u, v))) - 2. * pi;
      for(const Index incident_corner : m_mesh.corners_around(vertex))
        outer_angle += m_mesh.angle_at(incident_corner);
      if(!(outer_angle < pi - turn_tolerance))
        continue;
      const std::vector<Index> old_halfedges = m_halfedges;
      const double length_before = length();
      if(reroute(bend.strip_index, bend.is_left, vertex))
      {
        run_funnel();
        if(!m_halfedges.empty() && length() < length_before)
          return true;
      }
      m_rejected_vertices.push_back(vertex);
      m_halfedges = old_halfedges;
      run_funnel();
      return true;
    }
    return false;
  }

  // Replaces the edges incident to a vertex by those on the other side of the vertex. Returns
  // false if these reach the boundary.
  bool reroute(std::size_t strip_index, bool is_left, Index vertex)
  {
    const auto is_incident = [&](std::size_t i)
    { return (is_left ? m_mesh.target(m_halfedges[i]) : m_mesh.source(m_halfedges[i])) == vertex; };
    std::size_t begin = strip_index, end = strip_index + 1;
    while(begin > 0 && is_incident(begin - 1))
      --begin;
    while(end < m_halfedges.size() && is_incident(end))
      ++end;
    const Index last_triangle = m_t.twin[m_halfedges[end - 1]] / 3;
    std::vector<Index> detour;
    Index h = m_halfedges[begin];
    for(;;)
    {
      h = is_left ? next_halfedge(h) : previous_halfedge(h);
      if(m_t.twin[h] == none || detour.size() > m_t.number_of_triangles())
        return false;
      detour.push_back(h);
      h = m_t.twin[h];
      if(h / 3 == last_triangle)
        break;
    }
    m_halfedges.erase(m_halfedges.begin() + std::ptrdiff_t(begin),
                      m_halfedges.begin() + std::ptrdiff_t(end));
    m_halfedges.insert(m_halfedges.begin() + std::ptrdiff_t(begin), detour.begin(), detour.end());
    simplify();
    return true;
  }

  const Split_mesh& m_mesh;
  const Surface_arrays& m_t;
  const std::vector<bool>& m_is_barred;
  Index m_from, m_to;
  std::vector<Index> m_halfedges;
  std::vector<Index> m_rejected_vertices; // vertices around which the path is longer
  std::vector<Vec2> m_left, m_right;
  Vec2 m_end = {};
  std::vector<Bend> m_bends;
};

} // namespace

Strip_path shorten_in_strip(const Split_mesh& mesh, const std::vector<bool>& is_barred, Index from,
                            Index to, std::vector<Index> halfedges)
{
  const Strip_shortener shortener(mesh, is_barred, from, to, std::move(halfedges));
  return {shortener.halfedges(), shortener.fractions()};
}

} // namespace CGAL::Geodesic_processing::internal
