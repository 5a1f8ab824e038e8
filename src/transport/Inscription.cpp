// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Inscription.h>

#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Barycentric = std::array<double, 3>;

// Of a side: closer points are one.
constexpr double snapping = 1e-10;

// Far below what distances tell apart: across a side of no length no direction is known.
constexpr double shortest_side = 0x1p-36;

struct Vertex_info
{
  Index site = none; // of crossings to be found
  Barycentric barycentric = {};
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Division = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<Vertex_info, Kernel>,
        CGAL::Constrained_triangulation_face_base_2<Kernel>>,
    CGAL::Exact_intersections_tag>;

Barycentric middle(std::initializer_list<Barycentric> points)
{
  Barycentric result = {0., 0., 0.};
  for(const Barycentric& b : points)
    for(std::size_t k = 0; k < 3; ++k)
      result[k] += b[k] / double(points.size());
  return result;
}

// Of a part in the area of the whole.
double share(const std::array<Barycentric, 3>& corner)
{
  const auto& [a, b, c] = corner;
  return std::abs((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]));
}

// The sides of a triangle that hold a point: bit k for side k.
unsigned sides_of(const Barycentric& b)
{
  return (b[2] == 0. ? 1u : 0u) | (b[0] == 0. ? 2u : 0u) | (b[1] == 0. ? 4u : 0u);
}

// Which of sides 0 to 2 holds both points, or none.
Index common_side(const Barycentric& p, const Barycentric& q)
{
  const unsigned both = sides_of(p) & sides_of(q);
  return both & 1u ? 0 : both & 2u ? 1 : both & 4u ? 2 : none;
}

} // namespace

class Inscription::Builder
{
public:
  Builder(Inscription& result, const std::vector<std::vector<Location>>& curves,
          const std::vector<Index>& whole)
      : m_result(result), m_coarse(*result.m_coarse), m_kind(m_coarse.number_of_sites(), Kind::free)
  {
    for(const Index site : whole)
      m_kind[site] = Kind::whole;
    m_result.m_sites.resize(curves.size());
    for(std::size_t i = 0; i < curves.size(); ++i)
      add_curve(i, curves[i]);
    divide_sides();
    divide_triangles();
    glue();
  }

private:
  enum class Kind : char
  {
    free,
    whole,
    curve
  };

  // On a side, from its source on; of two twins the first one knows.
  struct Side_point
  {
    double share;
    Index site;
  };
  struct Side
  {
    std::vector<Side_point> points;                 // without the ends
    std::vector<std::pair<double, double>> covered; // by curves
  };

  // A part of a curve through a triangle.
  struct Segment
  {
    std::size_t curve;
    std::array<Index, 2> site;
  };
  struct Inside
  {
    std::vector<std::pair<Barycentric, Index>> points;
    std::vector<Segment> segments;
  };

  bool is_first(Index side) const
  {
    const Index twin = m_coarse.twin[side];
    return twin == none || side < twin;
  }
  Index first_of(Index side) const { return is_first(side) ? side : m_coarse.twin[side]; }

  Index add_site(const Location& location, Kind kind)
  {
    m_result.m_added.push_back(location);
    m_kind.push_back(kind);
    return Index(m_kind.size() - 1);
  }

  Index add_side_point(Index side, double share, Kind kind)
  {
    if(!is_first(side))
    {
      side = m_coarse.twin[side];
      share = 1. - share;
    }
    std::vector<Side_point>& points = m_sides[side].points;
    for(const Side_point& point : points)
      if(std::abs(point.share - share) < snapping)
        return point.site;
    points.push_back({share, add_site({side / 3, none, on_side(side, share)}, kind)});
    return points.back().site;
  }

  // The site where a location is, new ones included.
  Index add(const Location& location)
  {
    if(const Index site = site_of(m_coarse, location); site != none)
    {
      if(m_kind[site] == Kind::free)
        m_kind[site] = Kind::curve;
      return site;
    }
    if(const Index side = side_of(location); side != none)
      return add_side_point(side, location.barycentric[next_side(side) % 3], Kind::curve);
    auto& points = m_inside[location.triangle].points;
    for(const auto& [place, site] : points)
      if(distance_of(place, location.barycentric) < snapping)
        return site;
    points.emplace_back(location.barycentric, add_site(location, Kind::curve));
    return points.back().second;
  }

  static double distance_of(const Barycentric& a, const Barycentric& b)
  {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
  }

  Location snapped(const Location& location) const
  {
    Location result = cleaned(m_coarse, location);
    for(double& b : result.barycentric)
      if(b < snapping)
        b = 0.;
    return cleaned(m_coarse, result);
  }

  void add_curve(std::size_t curve, const std::vector<Location>& polyline)
  {
    Location last;
    Index last_site = none;
    for(const Location& location : polyline)
    {
      const Location next = snapped(location);
      const Index site = add(next);
      m_result.m_sites[curve].push_back(site);
      if(last_site != none && last_site != site)
        add_segment(curve, last, last_site, next, site);
      last = next;
      last_site = site;
    }
  }

  void add_segment(std::size_t curve, const Location& p, Index p_site, const Location& q,
                   Index q_site)
  {
    const Index triangle = common_triangle(m_coarse, p, q);
    const Barycentric a = *seen_from(m_coarse, triangle, p), b = *seen_from(m_coarse, triangle, q);
    const Index k = common_side(a, b);
    if(k == none)
    {
      m_inside[triangle].segments.push_back({curve, {p_site, q_site}});
      return;
    }
    const Index side = 3 * triangle + k;
    double from = a[(k + 1) % 3], to = b[(k + 1) % 3];
    if(!is_first(side))
    {
      from = 1. - from;
      to = 1. - to;
    }
    m_sides[first_of(side)].covered.push_back(std::minmax(from, to));
    m_along_side.push_back({curve, first_of(side), std::minmax(from, to)});
  }

  // Whether what is between two sites would wrongly be a part of the curves.
  bool is_shortcut(Index a, Index b) const
  {
    return m_kind[a] != Kind::free && m_kind[b] != Kind::free &&
           !(m_kind[a] == Kind::whole && m_kind[b] == Kind::whole);
  }

  void divide_sides()
  {
    for(Index side = 0; side < m_coarse.corner.size(); ++side)
    {
      if(!is_first(side))
        continue;
      const Index from = m_coarse.corner[side], to = m_coarse.corner[next_side(side)];
      const auto found = m_sides.find(side);
      if(found == m_sides.end())
      {
        if(is_shortcut(from, to))
          add_side_point(side, 0.5, Kind::free);
        continue;
      }
      const Side known = found->second;
      std::vector<Side_point> points = known.points;
      points.push_back({0., from});
      points.push_back({1., to});
      std::sort(points.begin(), points.end(),
                [](const Side_point& a, const Side_point& b) { return a.share < b.share; });
      for(std::size_t i = 1; i < points.size(); ++i)
      {
        const double middle = 0.5 * (points[i - 1].share + points[i].share);
        const bool is_covered = std::any_of(
            known.covered.begin(), known.covered.end(),
            [&](const auto& part) { return part.first < middle && middle < part.second; });
        if(!is_covered && is_shortcut(points[i - 1].site, points[i].site))
          add_side_point(side, middle, Kind::free);
      }
    }
    for(auto& [side, known] : m_sides)
      std::sort(known.points.begin(), known.points.end(),
                [](const Side_point& a, const Side_point& b) { return a.share < b.share; });
    // Those of others on the same side.
    for(const auto& [curve, side, part] : m_along_side)
      for(const Side_point& point : m_sides[side].points)
        if(part.first <= point.share && point.share <= part.second)
          m_result.m_sites[curve].push_back(point.site);
  }

  bool is_divided(Index triangle) const
  {
    if(m_inside.count(triangle) > 0)
      return true;
    const Index* corner = &m_coarse.corner[3 * std::size_t(triangle)];
    for(Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
      if(const auto found = m_sides.find(first_of(side));
         found != m_sides.end() && !found->second.points.empty())
        return true;
    return is_enclosed({corner[0], corner[1], corner[2]});
  }

  // Whether a triangle would wrongly be a part of the curves.
  bool is_enclosed(const std::array<Index, 3>& corner) const
  {
    return m_kind[corner[0]] != Kind::free && m_kind[corner[1]] != Kind::free &&
           m_kind[corner[2]] != Kind::free &&
           std::any_of(corner.begin(), corner.end(),
                       [&](Index site) { return m_kind[site] == Kind::curve; });
  }

  void divide_triangles()
  {
    m_fine = m_coarse;
    m_fine.point.clear();
    m_fine.star.clear();
    for(Index triangle = 0; triangle < m_coarse.number_of_triangles(); ++triangle)
      if(is_divided(triangle))
        divide(triangle);
    for(std::vector<Index>& sites : m_result.m_sites)
    {
      std::sort(sites.begin(), sites.end());
      sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
    }
  }

  // Delaunay's, with the curves' segments.  All is exact: what was found on a side stays there.
  void divide(Index triangle)
  {
    auto plane = unfolded(m_coarse, triangle);
    if(!(plane[2][1] > 1e-7 * plane[1][0]))
      plane = {Planar{0., 0.}, Planar{1., 0.}, Planar{0., 1.}};
    const auto exact = [&](const Barycentric& b)
    {
      Kernel::FT x = 0, y = 0, sum = 0;
      for(std::size_t k = 0; k < 3; ++k)
      {
        const Kernel::FT weight(b[k]);
        x += weight * Kernel::FT(plane[k][0]);
        y += weight * Kernel::FT(plane[k][1]);
        sum += weight;
      }
      return Kernel::Point_2(x / sum, y / sum);
    };
    Division division;
    std::map<Index, Division::Vertex_handle> vertex;
    const auto insert = [&](const Barycentric& b, Index site)
    {
      const auto v = division.insert(exact(b));
      v->info() = {site, b};
      vertex.emplace(site, v);
    };
    for(Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
      insert(at_corner(side), m_coarse.corner[side]);
    for(Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
      if(const auto found = m_sides.find(first_of(side)); found != m_sides.end())
        for(const Side_point& point : found->second.points)
          insert(on_side(side, is_first(side) ? point.share : 1. - point.share), point.site);
    const Inside& inside = m_inside[triangle];
    for(const auto& [place, site] : inside.points)
      insert(place, site);
    for(const Segment& segment : inside.segments)
      division.insert_constraint(vertex.at(segment.site[0]), vertex.at(segment.site[1]));

    const auto barycentric = [&](const Kernel::Point_2& p)
    {
      const double last = to_double(p.y()) / plane[2][1];
      const double second = (to_double(p.x()) - last * plane[2][0]) / plane[1][0];
      return Barycentric{1. - last - second, second, last};
    };
    const auto add_vertex = [&](Division::Vertex_handle v, const Barycentric& b, Kind kind) {
      v->info() = {add_site({triangle, none, b}, kind), b};
    };
    for(const Division::Vertex_handle v : division.finite_vertex_handles())
      if(v->info().site == none)
        add_vertex(v, barycentric(v->point()), Kind::curve);
    for(const Segment& segment : inside.segments)
    {
      const Kernel::Segment_2 exact_segment(vertex.at(segment.site[0])->point(),
                                            vertex.at(segment.site[1])->point());
      for(const Division::Vertex_handle v : division.finite_vertex_handles())
        if(exact_segment.has_on(v->point()))
          m_result.m_sites[segment.curve].push_back(v->info().site);
    }
    while(const auto place = shortcut(division))
      add_vertex(division.insert(place->first), place->second, Kind::free);
    add_parts(triangle, division);
  }

  // The middle of an edge, or else of a triangle, that joins sites of curves without being a part of one.
  // It is exact, as two of them may be so close that rounding moves it to either.
  std::optional<std::pair<Kernel::Point_2, Barycentric>> shortcut(const Division& division) const
  {
    for(const Division::Edge& edge : division.finite_edges())
    {
      const auto& [face, i] = edge;
      const auto a = face->vertex(Division::ccw(i)), b = face->vertex(Division::cw(i));
      if(!division.is_constrained(edge) && !division.is_infinite(face) &&
         !division.is_infinite(face->neighbor(i)) && is_shortcut(a->info().site, b->info().site))
        return std::pair(CGAL::midpoint(a->point(), b->point()),
                         middle({a->info().barycentric, b->info().barycentric}));
    }
    for(const Division::Face_handle face : division.finite_face_handles())
    {
      const auto a = face->vertex(0), b = face->vertex(1), c = face->vertex(2);
      if(is_enclosed({a->info().site, b->info().site, c->info().site}))
        return std::pair(
            CGAL::centroid(a->point(), b->point(), c->point()),
            middle({a->info().barycentric, b->info().barycentric, c->info().barycentric}));
    }
    return std::nullopt;
  }

  void add_parts(Index whole, const Division& division)
  {
    const auto plane = unfolded(m_coarse, whole);
    std::map<Division::Face_handle, Index> number;
    m_result.m_first_part[whole] = m_result.m_parts.size();
    for(const Division::Face_handle face : division.finite_face_handles())
    {
      const bool is_new = !number.empty();
      const Index triangle = is_new ? Index(m_fine.number_of_triangles()) : whole;
      number[face] = triangle;
      if(is_new)
      {
        m_fine.corner.resize(m_fine.corner.size() + 3);
        m_fine.length.resize(m_fine.corner.size());
        m_fine.twin.resize(m_fine.corner.size());
      }
      Part part;
      part.triangle = triangle;
      part.whole = whole;
      std::array<Planar, 3> place;
      for(int k = 0; k < 3; ++k)
      {
        const Vertex_info& info = face->vertex(k)->info();
        m_fine.corner[3 * triangle + Index(k)] = info.site;
        part.corner[k] = info.barycentric;
        place[k] = unfolded_point(plane, info.barycentric);
      }
      for(std::size_t k = 0; k < 3; ++k)
        m_fine.length[3 * triangle + k] =
            std::max(norm(place[(k + 1) % 3] - place[k]), shortest_side);
      const Planar along = place[1] - place[0];
      const double length = norm(along);
      part.axis = length > 0. ? (1. / length) * along : Planar{1., 0.};
      m_result.m_parts.push_back(part);
    }
    for(const auto& [face, triangle] : number)
      for(int k = 0; k < 3; ++k)
      {
        const Index side = 3 * triangle + Index(k);
        const auto neighbor = face->neighbor((k + 2) % 3);
        if(!division.is_infinite(neighbor))
          m_fine.twin[side] = 3 * number[neighbor] + (Index(neighbor->index(face)) + 1) % 3;
        else
        {
          const Barycentric &from = face->vertex(k)->info().barycentric,
                            &to = face->vertex((k + 1) % 3)->info().barycentric;
          const Index j = common_side(from, to);
          m_parts_of_side[3 * whole + j].emplace_back(from[(j + 1) % 3], side);
        }
      }
  }

  void glue()
  {
    for(auto& [side, parts] : m_parts_of_side)
      std::sort(parts.begin(), parts.end());
    for(const auto& [side, parts] : m_parts_of_side)
    {
      const Index twin = m_coarse.twin[side];
      const auto found = m_parts_of_side.find(twin);
      for(std::size_t i = 0; i < parts.size(); ++i)
      {
        const Index part = parts[i].second;
        const Index other = twin == none ? none
                            : found == m_parts_of_side.end()
                                ? twin
                                : found->second[parts.size() - 1 - i].second;
        m_fine.twin[part] = other;
        if(other == none)
          continue;
        m_fine.twin[other] = part;
        m_fine.length[part] = m_fine.length[other] =
            std::max(m_fine.length[part], m_fine.length[other]);
      }
    }
    build_stars(m_fine, m_kind.size());
    m_result.m_fine = std::make_shared<const Glued_triangles>(std::move(m_fine));
  }

  struct Along_side
  {
    std::size_t curve;
    Index side;
    std::pair<double, double> part;
  };

  Inscription& m_result;
  const Glued_triangles& m_coarse;
  std::vector<Kind> m_kind;         // #sites, new ones included
  std::map<Index, Side> m_sides;    // of the first of two twins
  std::map<Index, Inside> m_inside; // of a triangle
  std::vector<Along_side> m_along_side;
  std::map<Index, std::vector<std::pair<double, Index>>> m_parts_of_side;
  Glued_triangles m_fine;
};

Inscription::Inscription(std::shared_ptr<const Glued_triangles> triangles,
                         const std::vector<std::vector<Location>>& curves,
                         const std::vector<Index>& whole)
    : m_coarse(std::move(triangles))
{
  Builder(*this, curves, whole);
}

Location Inscription::refined(const Location& location) const
{
  if(location.triangle == none)
    return location;
  const auto first = m_first_part.find(location.triangle);
  if(first == m_first_part.end())
    return location;
  // In the part from whose sides it is the farthest.
  Location result;
  double most = -infinity;
  const auto& b = location.barycentric;
  for(std::size_t i = first->second; i < m_parts.size() && m_parts[i].whole == location.triangle;
      ++i)
  {
    const double whole = share(m_parts[i].corner);
    if(!(whole > 0.))
      continue;
    Barycentric inside;
    const auto& corner = m_parts[i].corner;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Barycentric &next = corner[(k + 1) % 3], &last = corner[(k + 2) % 3];
      inside[k] =
          ((next[1] - b[1]) * (last[2] - b[2]) - (next[2] - b[2]) * (last[1] - b[1])) / whole;
    }
    const double least = std::min({inside[0], inside[1], inside[2]});
    if(least > most)
    {
      most = least;
      result.triangle = m_parts[i].triangle;
      result.barycentric = inside;
    }
  }
  return cleaned(*m_fine, result);
}

Vector Inscription::refined(const Vector& function) const
{
  if(function.size() == 0)
    return function;
  Vector result(Eigen::Index(m_fine->number_of_sites()));
  result.head(function.size()) = function;
  Eigen::Index site = function.size();
  for(const Location& place : m_added)
  {
    result[site] = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      result[site] +=
          place.barycentric[k] * function[m_coarse->corner[3 * std::size_t(place.triangle) + k]];
    ++site;
  }
  return result;
}

Mass_distribution Inscription::refined(const Mass_distribution& masses) const
{
  Mass_distribution result;
  if(masses.at_sites.size() > 0)
  {
    result.at_sites = Vector::Zero(Eigen::Index(m_fine->number_of_sites()));
    result.at_sites.head(masses.at_sites.size()) = masses.at_sites;
  }
  for(const auto& [location, mass] : masses.at_locations)
    result.at_locations.emplace_back(refined(location), mass);
  result.density = refined(masses.density);
  return result;
}

std::vector<Tensor> Inscription::refined(const std::vector<Tensor>& measure) const
{
  std::vector<Tensor> result = measure;
  if(measure.empty())
    return result;
  result.resize(m_fine->number_of_triangles());
  for(const Part& part : m_parts)
  {
    const Tensor& whole = measure[part.whole];
    const Planar u = product(whole, part.axis), left = turned_left(part.axis);
    result[part.triangle] = is_blocked(whole) ? whole
                                              : Tensor{dot(part.axis, u), dot(left, u),
                                                       dot(left, product(whole, left))};
  }
  return result;
}

Field Inscription::coarsened(const Field& fine) const
{
  Field result(fine.begin(), fine.begin() + std::ptrdiff_t(m_coarse->number_of_triangles()));
  for(const auto& [whole, first] : m_first_part)
    result[whole] = {0., 0.};
  for(const Part& part : m_parts)
  {
    const Planar& v = fine[part.triangle];
    result[part.whole] = result[part.whole] +
                         share(part.corner) * (v[0] * part.axis + v[1] * turned_left(part.axis));
  }
  return result;
}

Vector Inscription::coarsened(const Vector& masses) const
{
  Vector result = masses.head(masses.size() - Eigen::Index(m_added.size()));
  Eigen::Index site = result.size();
  for(const Location& place : m_added)
  {
    for(std::size_t k = 0; k < 3; ++k)
      result[m_coarse->corner[3 * std::size_t(place.triangle) + k]] +=
          place.barycentric[k] * masses[site];
    ++site;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
