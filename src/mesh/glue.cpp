// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/locality.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// In a box of size one: far below what distances tell apart, far above the rounding of positions.
constexpr double shortest_side = 0x1p-36;

double distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return std::sqrt(x * x + y * y + z * z);
}

// The order of triangles by their smallest site, ties by face: a counting sort.
std::vector<Index> order_of_triangles(const std::vector<Index>& corner, std::size_t sites)
{
  const std::size_t m = corner.size() / 3;
  std::vector<Index> begin(sites + 1, 0), order(m);
  const auto smallest = [&](std::size_t f) {
    return std::min({corner[3 * f], corner[3 * f + 1], corner[3 * f + 2]});
  };
  for(std::size_t f = 0; f < m; ++f)
    ++begin[smallest(f) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for(std::size_t f = 0; f < m; ++f)
    order[begin[smallest(f)]++] = static_cast<Index>(f);
  return order;
}

// Triangles without area in double precision: a side of length zero, or sides of which the longest
// is not shorter than the two others together.
std::size_t number_of_degenerate_triangles(const std::vector<double>& length)
{
  std::size_t count = 0;
  for(std::size_t c = 0; c < length.size(); c += 3)
  {
    const double a = length[c], b = length[c + 1], l = length[c + 2];
    const double longest = std::max({a, b, l});
    if(std::min({a, b, l}) <= 0. || a + b + l - longest <= longest)
      ++count;
  }
  return count;
}

} // namespace

void build_stars(Glued_triangles& t, std::size_t sites)
{
  t.first.assign(sites + 1, 0);
  for(const Index site : t.corner)
    ++t.first[site + 1];
  std::partial_sum(t.first.begin(), t.first.end(), t.first.begin());
  t.star.resize(t.corner.size());

  std::vector<Index> end(t.first.begin(), t.first.end() - 1);
  std::vector<bool> placed(t.corner.size(), false);
  for(Index c = 0; c < t.corner.size(); ++c)
  {
    if(placed[c])
      continue;
    // Clockwise to the border, or once around: the side that leaves a corner has the twin whose
    // next side leaves the same site.
    Index start = c;
    while(t.twin[start] != none)
    {
      start = next_side(t.twin[start]);
      if(start == c)
        break;
    }
    Index turn = start;
    do
    {
      placed[turn] = true;
      t.star[end[t.corner[turn]]++] = turn;
      turn = t.twin[previous_side(turn)];
    } while(turn != none && turn != start);
  }
}

Glued_mesh glue(std::vector<std::array<double, 3>> points, const std::vector<Index>& corners,
                const std::vector<Index>& twins)
{
  Glued_mesh result;
  Glued_triangles& t = result.triangles;
  const std::size_t n = points.size(), m = corners.size() / 3;

  const Frame frame = unit_frame(points);
  to_frame(points, frame);
  result.vertex_of_site = morton_order(points);
  result.site_of_vertex.resize(n);
  t.point.resize(n);
  for(Index s = 0; s < n; ++s)
  {
    result.site_of_vertex[result.vertex_of_site[s]] = s;
    t.point[s] = points[result.vertex_of_site[s]];
  }
  points = {};

  {
    std::vector<Index> site(corners.size());
    std::transform(corners.begin(), corners.end(), site.begin(),
                   [&](Index vertex) { return result.site_of_vertex[vertex]; });
    result.face_of_triangle = order_of_triangles(site, n);
    result.triangle_of_face.resize(m);
    for(Index f = 0; f < m; ++f)
      result.triangle_of_face[result.face_of_triangle[f]] = f;

    t.corner.resize(3 * m);
    t.twin.resize(3 * m);
    for(std::size_t f = 0; f < m; ++f)
      for(std::size_t k = 0, from = 3 * std::size_t(result.face_of_triangle[f]); k < 3; ++k)
      {
        const Index twin = twins[from + k];
        t.corner[3 * f + k] = site[from + k];
        t.twin[3 * f + k] = twin == none ? none : 3 * result.triangle_of_face[twin / 3] + twin % 3;
      }
  }

  t.length.resize(3 * m);
  double longest = 0.;
  for(Index side = 0; side < 3 * m; ++side)
  {
    const Index twin = t.twin[side];
    t.length[side] = twin < side
                         ? t.length[twin]
                         : distance(t.point[t.corner[side]], t.point[t.corner[next_side(side)]]);
    longest = std::max(longest, t.length[side]);
  }
  result.degenerate = number_of_degenerate_triangles(t.length);
  // No direction is known across a side of no length.  The larger of two lengths obeys the triangle
  // inequality where both do.
  if(longest > 0.)
    for(double& length : t.length)
      length = std::max(length, shortest_side);
  const double unit = longest > 0. ? std::ldexp(1., std::ilogb(longest)) : 1.;
  const double factor = 1. / unit; // exact: a power of two
  for(double& length : t.length)
    length *= factor;
  for(auto& point : t.point)
    for(double& coordinate : point)
      coordinate *= factor;
  t.scale = frame.scale * unit;
  t.origin = frame.origin;

  build_stars(t, n);
  return result;
}

std::vector<Index> twins_of_soup(std::size_t number_of_points, const std::vector<Index>& corners)
{
  // Sides sorted into buckets by their smaller end; each bucket is short.
  std::vector<Index> begin(number_of_points + 1, 0), sides(corners.size());
  std::vector<Index> twin(corners.size(), none);
  const auto low = [&](Index side) { return std::min(corners[side], corners[next_side(side)]); };
  const auto high = [&](Index side) { return std::max(corners[side], corners[next_side(side)]); };
  for(Index side = 0; side < corners.size(); ++side)
    ++begin[low(side) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  {
    auto end = begin;
    for(Index side = 0; side < corners.size(); ++side)
      sides[end[low(side)]++] = side;
  }
  for(std::size_t v = 0; v < number_of_points; ++v)
  {
    const auto bucket = sides.begin() + begin[v], bucket_end = sides.begin() + begin[v + 1];
    std::sort(bucket, bucket_end,
              [&](Index a, Index b)
              { return std::make_pair(high(a), a) < std::make_pair(high(b), b); });
    for(auto run = bucket; run != bucket_end;)
    {
      const auto run_end =
          std::find_if(run, bucket_end, [&](Index side) { return high(side) != high(*run); });
      if(run_end - run == 2 && corners[run[0]] != corners[run[1]])
      {
        twin[run[0]] = run[1];
        twin[run[1]] = run[0];
      }
      run = run_end;
    }
  }
  return twin;
}

namespace {

std::pair<std::vector<Index>, std::size_t> joined(const Glued_triangles& triangles,
                                                  const Site_graph& graph)
{
  const std::size_t n = triangles.number_of_sites();
  std::vector<Index> label(n, none), stack;
  std::size_t count = 0;
  const auto reach = [&](Index site)
  {
    if(label[site] == none)
    {
      label[site] = static_cast<Index>(count);
      stack.push_back(site);
    }
  };
  for(Index seed = 0; seed < n; ++seed)
  {
    if(label[seed] != none)
      continue;
    reach(seed);
    while(!stack.empty())
    {
      const Index site = stack.back();
      stack.pop_back();
      for(Index i = triangles.first[site]; i < triangles.first[site + 1]; ++i)
      {
        reach(triangles.corner[next_side(triangles.star[i])]);
        reach(triangles.corner[previous_side(triangles.star[i])]);
      }
      if(!graph.first.empty())
        for(Index i = graph.first[site]; i < graph.first[site + 1]; ++i)
          reach(graph.target[i]);
    }
    ++count;
  }
  return {std::move(label), count};
}

} // namespace

std::pair<std::vector<Index>, std::size_t> components(const Glued_triangles& triangles)
{
  return joined(triangles, triangles.graph);
}

std::pair<std::vector<Index>, std::size_t> islands(const Glued_triangles& triangles)
{
  return joined(triangles, Site_graph());
}

} // namespace CGAL::Geodesic_processing::internal
