// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/intrinsic_delaunay.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns whether the angle opposite to a halfedge is at most a right angle.
bool is_opposite_acute(const Surface_arrays& t, Index h)
{
  const double length = t.length[h], a = t.length[next_halfedge(h)],
               b = t.length[previous_halfedge(h)];
  return length * length <= a * a + b * b;
}

// Returns whether the opposite angles of an edge sum to more than pi and a tolerance, whose cosine
// and sine are given.
bool needs_flip(const Surface_arrays& t, Index h, const Vec2& tolerance)
{
  const Index twin = t.twin[h];
  if(twin == none || twin / 3 == h / 3)
    return false;
  // Most opposite angles are acute: then no square root is needed.
  if(is_opposite_acute(t, h) && is_opposite_acute(t, twin))
    return false;
  const Vec2 a = corner_angle(t, previous_halfedge(h)),
             b = corner_angle(t, previous_halfedge(twin));
  return rotated_back(rotated(a, b), tolerance)[1] < 0.;
}

// Replaces the edge ab of the triangles abc and bad by cd: they become cdb and dca.
Edge_flip flip(Surface_arrays& t, Index h)
{
  const Index twin = t.twin[h];
  const Index bc = next_halfedge(h), ca = previous_halfedge(h), ad = next_halfedge(twin),
              db = previous_halfedge(twin);
  const Vec2 c = apex(t, h), d = apex(t, twin); // d seen from b, with a on the first axis
  const double edge = t.length[h], diagonal = norm(c - (Vec2{edge, 0.} - d));
  // Both heights are at least zero, and their sum is positive.
  Edge_flip result = {h, twin, 0., c[1] / (c[1] + d[1])};
  result.on_edge = std::clamp((c[0] + result.on_diagonal * (edge - d[0] - c[0])) / edge, 0., 1.);

  struct Halfedge
  {
    Index source, twin;
    double length;
  };
  const auto read = [&](Index s) { return Halfedge{t.corner[s], t.twin[s], t.length[s]}; };
  const Halfedge old_bc = read(bc), old_ca = read(ca), old_ad = read(ad), old_db = read(db);
  // h becomes cd, followed by db and bc; twin becomes dc, followed by ca and ad.
  const auto write = [&](Index s, const Halfedge& value)
  {
    t.corner[s] = value.source;
    t.length[s] = value.length;
    t.twin[s] = value.twin;
    if(value.twin != none)
      t.twin[value.twin] = s;
  };
  // A twin that is one of these four halfedges moves, too.
  const auto redirected = [&](Halfedge value)
  {
    if(value.twin == bc)
      value.twin = ca;
    else if(value.twin == ca)
      value.twin = ad;
    else if(value.twin == ad)
      value.twin = db;
    else if(value.twin == db)
      value.twin = bc;
    return value;
  };
  const Halfedge new_db = redirected(old_db), new_bc = redirected(old_bc),
                 new_ca = redirected(old_ca), new_ad = redirected(old_ad);
  write(bc, new_db);
  write(ca, new_bc);
  write(ad, new_ca);
  write(db, new_ad);
  t.corner[h] = old_ca.source;    // c
  t.corner[twin] = old_db.source; // d
  t.length[h] = t.length[twin] = diagonal;
  return result;
}

// Replaces a triangle abc by amc and mbc; ab is the given halfedge. The twins of am and mb are
// left to the caller. Returns mb.
Index bisect(Surface_arrays& t, Index h, Index midpoint)
{
  const Index bc = next_halfedge(h), ca = previous_halfedge(h);
  const double half_length = t.length[h] / 2.;
  const double median = norm(apex(t, h) - Vec2{half_length, 0.});
  const Index mb = Index(t.corner.size()) + h % 3;
  const Index new_bc = next_halfedge(mb), cm = previous_halfedge(mb);
  t.corner.resize(t.corner.size() + 3);
  t.twin.resize(t.corner.size(), none);
  t.length.resize(t.corner.size());
  t.corner[mb] = midpoint;
  t.corner[new_bc] = t.corner[bc];
  t.corner[cm] = t.corner[ca];
  t.corner[bc] = midpoint;
  t.length[new_bc] = t.length[bc];
  t.length[h] = t.length[mb] = half_length;
  t.length[bc] = t.length[cm] = median;
  t.twin[new_bc] = t.twin[bc];
  if(t.twin[new_bc] != none)
    t.twin[t.twin[new_bc]] = new_bc;
  t.twin[bc] = cm;
  t.twin[cm] = bc;
  t.twin[h] = none;
  return mb;
}

} // namespace

void mollify(Surface_arrays& t, double slack)
{
  double deficit = 0.;
  for(Index h = 0; h < t.length.size(); ++h)
    deficit = std::max(deficit, slack - (t.length[h] + t.length[next_halfedge(h)] -
                                         t.length[previous_halfedge(h)]));
  if(deficit > 0.)
    for(double& length : t.length)
      length += deficit;
}

bool is_delaunay(const Surface_arrays& t, double tolerance)
{
  const Vec2 direction = {std::cos(tolerance), std::sin(tolerance)};
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.twin[h] != none && h < t.twin[h] && needs_flip(t, h, direction))
      return false;
  return true;
}

std::vector<Edge_flip> flip_to_delaunay(Surface_arrays& t, double tolerance,
                                        std::size_t max_flips_per_halfedge)
{
  const Vec2 direction = {std::cos(tolerance), std::sin(tolerance)};
  std::vector<Index> stack;
  std::vector<bool> is_stacked(t.corner.size(), false);
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.twin[h] != none && h < t.twin[h] && needs_flip(t, h, direction))
    {
      is_stacked[h] = true;
      stack.push_back(h);
    }
  // Terminates in exact arithmetic because each flip decreases the Dirichlet energy of the
  // identity. Around a vertex of high degree the number of flips is quadratic.
  const std::size_t max_flips = max_flips_per_halfedge * t.corner.size() + 1000;
  std::vector<Edge_flip> flips;
  while(!stack.empty() && flips.size() < max_flips)
  {
    const Index h = stack.back();
    stack.pop_back();
    is_stacked[h] = false;
    if(!needs_flip(t, h, direction))
      continue;
    const Index twin = t.twin[h];
    flips.push_back(flip(t, h));
    for(const Index neighbor :
        {next_halfedge(h), previous_halfedge(h), next_halfedge(twin), previous_halfedge(twin)})
      if(t.twin[neighbor] != none && !is_stacked[neighbor])
      {
        is_stacked[neighbor] = true;
        stack.push_back(neighbor);
      }
  }
  return flips;
}

std::size_t bisect_long_edges(Surface_arrays& t, std::size_t number_of_vertices, double max_length,
                              std::size_t max_vertices, std::vector<Bisection>& bisections)
{
  std::priority_queue<std::pair<double, Index>> queue;
  const auto push = [&](Index h)
  {
    if(t.length[h] > max_length)
      queue.push({t.length[h], h});
  };
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.twin[h] == none || h < t.twin[h])
      push(h);
  while(!queue.empty() && number_of_vertices < max_vertices)
  {
    const auto [length, h] = queue.top();
    queue.pop();
    const Index twin = t.twin[h];
    if(t.length[h] != length || (twin != none && twin / 3 == h / 3))
      continue;
    const Index midpoint = Index(number_of_vertices++);
    const Index rest = bisect(t, h, midpoint);
    bisections.push_back({h, rest / 3});
    push(h);
    push(next_halfedge(h));
    push(next_halfedge(rest));
    if(twin == none)
    {
      push(rest);
      continue;
    }
    const Index twin_rest = bisect(t, twin, midpoint);
    bisections.push_back({twin, twin_rest / 3});
    t.twin[h] = twin_rest;
    t.twin[twin_rest] = h;
    t.twin[rest] = twin;
    t.twin[twin] = rest;
    push(twin);
    push(next_halfedge(twin));
    push(next_halfedge(twin_rest));
  }
  return number_of_vertices;
}

} // namespace CGAL::Geodesic_processing::internal
