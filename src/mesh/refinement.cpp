// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "core/unfold.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Barycentric = std::array<double, 3>;

constexpr std::array<Barycentric, 3> whole = {Barycentric{1., 0., 0.}, Barycentric{0., 1., 0.},
                                              Barycentric{0., 0., 1.}};

Barycentric mixed(const std::array<Barycentric, 3>& corners, const Barycentric& b)
{
  Barycentric result = {0., 0., 0.};
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      result[j] += b[i] * corners[i][j];
  return result;
}

// The coordinates of a point with respect to three others; not finite when these are in line.
Barycentric solved(const std::array<Barycentric, 3>& corners, const Barycentric& p)
{
  const auto area = [](const Barycentric& a, const Barycentric& b, const Barycentric& c)
  { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
  const double all = area(corners[0], corners[1], corners[2]);
  return {area(p, corners[1], corners[2]) / all, area(corners[0], p, corners[2]) / all,
          area(corners[0], corners[1], p) / all};
}

// Triangles to be glued, in the order in which they were made.
struct Pieces
{
  std::vector<std::array<double, 3>> points;
  std::vector<Index> corners, twins;
  std::vector<Index> parent;
  std::vector<std::array<Barycentric, 3>> in_parent;
};

Refinement glued(const Refinement& from, Pieces pieces)
{
  if(pieces.corners.size() > (std::size_t(1) << 31))
    throw Unsupported_surface_error(
        "Triangles small enough for so many samples have more than 2^31 half-edges.");
  Glued_mesh mesh = glue(std::move(pieces.points), pieces.corners, pieces.twins);
  Glued_triangles& t = mesh.triangles;
  const Glued_triangles& before = *from.triangles;
  for(int k = 0; k < 3; ++k)
    t.origin[k] = before.origin[k] + before.scale * t.origin[k];
  t.scale *= before.scale;
  Refinement result;
  result.coarse = from.coarse;
  result.parent.reserve(mesh.face_of_triangle.size());
  result.corners.reserve(mesh.face_of_triangle.size());
  for(const Index piece : mesh.face_of_triangle)
  {
    const Index parent = pieces.parent[piece];
    std::array<Barycentric, 3> corners = pieces.in_parent[piece];
    if(!from.parent.empty())
      for(Barycentric& corner : corners)
        corner = mixed(from.corners[parent], corner);
    result.parent.push_back(from.parent.empty() ? parent : from.parent[parent]);
    result.corners.push_back(corners);
  }
  result.triangles = std::make_shared<const Glued_triangles>(std::move(t));
  return result;
}

// Places of a triangle: its corners 0, 1, 2 and the middles 3, 4, 5 of its sides.
using Piece = std::array<Index, 3>;

struct Cut
{
  std::array<Piece, 4> pieces;
  Index size;
};

// What becomes of a triangle some of whose sides are halved: convex pieces, counterclockwise.
// is_shorter: of the two ways to cut what is left behind the corner between two halved sides, the one
// from the end of the second one is shorter.
Cut pieces_of(const std::array<bool, 3>& is_halved, bool is_shorter)
{
  const int number = is_halved[0] + is_halved[1] + is_halved[2];
  if(number == 0)
    return {{Piece{0, 1, 2}}, 1};
  if(number == 3)
    return {{Piece{0, 3, 5}, Piece{3, 1, 4}, Piece{5, 4, 2}, Piece{3, 4, 5}}, 4};
  // Turned such that side k, or sides k and k + 1, are the halved ones.
  Index k = 0;
  while(!is_halved[k] || (number == 2 && !is_halved[(k + 1) % 3]))
    ++k;
  const Index a = k, b = (k + 1) % 3, c = (k + 2) % 3, ab = 3 + a, bc = 3 + b;
  if(number == 1)
    return {{Piece{a, ab, c}, Piece{ab, b, c}}, 2};
  if(is_shorter)
    return {{Piece{ab, b, bc}, Piece{a, ab, c}, Piece{ab, bc, c}}, 3};
  return {{Piece{ab, b, bc}, Piece{a, ab, bc}, Piece{a, bc, c}}, 3};
}

Barycentric place_in(Index place) { return place < 3 ? whole[place] : on_side(place - 3, 0.5); }

} // namespace

Refinement refinement(std::shared_ptr<const Glued_triangles> triangles)
{
  const Glued_triangles& t = *triangles;
  Refinement result{triangles, triangles, {}, {}};
  std::vector<Index> site_of_fan, fan(t.corner.size());
  for(Index site = 0; site < t.number_of_sites(); ++site)
  {
    site_of_fan.push_back(site);
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      if(i > t.first[site] && turn_left(t, t.star[i - 1]) != t.star[i])
        site_of_fan.push_back(site);
      fan[t.star[i]] = Index(site_of_fan.size() - 1);
    }
  }
  if(site_of_fan.size() == t.number_of_sites())
    return result;
  Pieces pieces;
  for(const Index site : site_of_fan)
    pieces.points.push_back(t.point[site]);
  pieces.corners = std::move(fan);
  pieces.twins = t.twin;
  pieces.parent.resize(t.number_of_triangles());
  std::iota(pieces.parent.begin(), pieces.parent.end(), Index(0));
  pieces.in_parent.assign(t.number_of_triangles(), whole);
  return glued(result, std::move(pieces));
}

Refinement halved(const Refinement& from, const std::vector<bool>& is_halved)
{
  const Glued_triangles& t = *from.triangles;
  Pieces pieces;
  pieces.points = t.point;
  std::vector<Index> middle(t.corner.size(), none);
  for(Index side = 0; side < t.corner.size(); ++side)
    if(is_halved[side])
    {
      if(t.twin[side] < side)
        middle[side] = middle[t.twin[side]];
      else
      {
        middle[side] = Index(pieces.points.size());
        pieces.points.push_back(0.5 *
                                (t.point[t.corner[side]] + t.point[t.corner[next_side(side)]]));
      }
    }

  // A triangle becomes one more for each of its halved sides.
  const std::size_t number =
      t.number_of_triangles() + std::size_t(std::count(is_halved.begin(), is_halved.end(), true));
  pieces.corners.reserve(3 * number);
  pieces.twins.reserve(3 * number);
  pieces.parent.reserve(number);
  pieces.in_parent.reserve(number);

  // Where the parts of each side are: the whole or its first half, and its second half.
  std::vector<std::array<Index, 2>> part(t.corner.size(), {none, none});
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const auto point_at = [&](Index place)
    { return place < 3 ? t.corner[3 * f + place] : middle[3 * f + place - 3]; };
    const std::array<bool, 3> is_cut = {is_halved[3 * f], is_halved[3 * f + 1],
                                        is_halved[3 * f + 2]};
    bool is_shorter = false;
    if(is_cut[0] + is_cut[1] + is_cut[2] == 2)
    {
      Index k = 0;
      while(is_cut[k])
        ++k;
      // The side that is not halved runs from c to a.
      const Index c = k, a = (k + 1) % 3, b = (k + 2) % 3;
      const auto corners = unfolded(t, f);
      is_shorter = norm(unfolded_point(corners, place_in(3 + a)) - corners[c]) <
                   norm(unfolded_point(corners, place_in(3 + b)) - corners[a]);
    }
    const Cut cut = pieces_of(is_cut, is_shorter);
    const Index first = Index(pieces.corners.size());
    for(Index i = 0; i < cut.size; ++i)
    {
      const Piece& piece = cut.pieces[i];
      for(const Index place : piece)
        pieces.corners.push_back(point_at(place));
      pieces.parent.push_back(f);
      pieces.in_parent.push_back({place_in(piece[0]), place_in(piece[1]), place_in(piece[2])});
    }
    pieces.twins.resize(pieces.corners.size(), none);
    for(Index i = 0; i < 3 * cut.size; ++i)
    {
      const Index from_place = cut.pieces[i / 3][i % 3], to_place = cut.pieces[i / 3][(i + 1) % 3];
      for(Index j = 0; j < i; ++j)
        if(cut.pieces[j / 3][j % 3] == to_place && cut.pieces[j / 3][(j + 1) % 3] == from_place)
        {
          pieces.twins[first + i] = first + j;
          pieces.twins[first + j] = first + i;
        }
      if(from_place < 3 && (to_place == (from_place + 1) % 3 || to_place == 3 + from_place))
        part[3 * f + from_place][0] = first + i;
      else if(from_place >= 3 && to_place == (from_place - 3 + 1) % 3)
        part[3 * f + from_place - 3][1] = first + i;
    }
  }
  for(Index side = 0; side < t.corner.size(); ++side)
    if(const Index twin = t.twin[side]; twin != none)
    {
      const bool is_cut = is_halved[side];
      pieces.twins[part[side][0]] = part[twin][is_cut ? 1 : 0];
      if(is_cut)
        pieces.twins[part[side][1]] = part[twin][0];
    }
  return glued(from, std::move(pieces));
}

Location to_coarse(const Refinement& refinement, const Location& location)
{
  if(refinement.parent.empty())
    return location;
  const Location fine =
      location.triangle == none ? at_site(*refinement.triangles, location.site) : location;
  if(fine.triangle == none)
    return {}; // a site without triangles
  return cleaned(*refinement.coarse, {refinement.parent[fine.triangle], none,
                                      mixed(refinement.corners[fine.triangle], fine.barycentric)});
}

std::vector<Location> to_fine(const Refinement& refinement, const std::vector<Location>& locations)
{
  if(refinement.parent.empty())
    return locations;
  // The triangles in each of the coarse ones.
  std::vector<Index> first(refinement.coarse->number_of_triangles() + 1, 0),
      children(refinement.parent.size());
  for(const Index parent : refinement.parent)
    ++first[parent + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> end(first.begin(), first.end() - 1);
  for(Index f = 0; f < children.size(); ++f)
    children[end[refinement.parent[f]]++] = f;

  std::vector<Location> result;
  for(const Location& location : locations)
  {
    const Location coarse =
        location.triangle == none ? at_site(*refinement.coarse, location.site) : location;
    Location best;
    double least = -infinity; // of its coordinates
    for(Index i = coarse.triangle == none ? 0 : first[coarse.triangle];
        coarse.triangle != none && i < first[coarse.triangle + 1]; ++i)
    {
      const Barycentric b = solved(refinement.corners[children[i]], coarse.barycentric);
      if(const double low = std::min({b[0], b[1], b[2]}); low > least)
      {
        least = low;
        best = {children[i], none, b};
      }
    }
    if(best.triangle != none)
      best = cleaned(*refinement.triangles, best);
    result.push_back(best);
  }
  return result;
}

std::vector<Index> coarse_sides(const Refinement& refinement)
{
  std::vector<Index> result(refinement.triangles->corner.size(), none);
  if(refinement.parent.empty())
    std::iota(result.begin(), result.end(), Index(0));
  else
    for(Index side = 0; side < result.size(); ++side)
    {
      const auto& corners = refinement.corners[side / 3];
      for(Index k = 0; k < 3; ++k)
        if(corners[side % 3][(k + 2) % 3] == 0. && corners[(side + 1) % 3][(k + 2) % 3] == 0.)
          result[side] = 3 * refinement.parent[side / 3] + k;
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
