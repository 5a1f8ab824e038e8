// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/reconstruction.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = Exact_predicates_inexact_constructions_kernel;
using Face = std::array<std::size_t, 3>;

// How often the front may ask how good a triangle is: 30 to 60 times for each surfel of a clean cloud,
// 110 times and more on noise, through which it lays thousands of parts, each after a look at all.
constexpr double first_questions = 2e5, questions_per_surfel = 60.;

// What the front leaves open among surfels near each other has fewer edges than this.
constexpr std::size_t most_edges_of_gap = 16;
// And a ring of so few is closed whatever its size: across it is no farther than along three edges of small
// triangles.  Random samples of a surface leave one in some ten thousand surfels.
constexpr std::size_t few_edges = 6;
// The sine of twenty degrees: by so much the normal of a triangle's surfel may point to the other side,
// as those at creases are means, and by more than that one of them points to this one.
constexpr double slant = 0.34;

// How a triangle lies to its surfels: the least and the largest of what their normals rise over it.
std::pair<double, double> rises(const Glued_triangles& t, const Face& face)
{
  const Spatial& origin = t.point[face[0]];
  const Spatial normal = unit(cross(t.point[face[1]] - origin, t.point[face[2]] - origin));
  const auto [least, largest] =
      std::minmax({dot(t.normal[face[0]], normal), dot(t.normal[face[1]], normal),
                   dot(t.normal[face[2]], normal)});
  return {least, largest};
}

// Whether a triangle is as small as the cloud's own triangles, so that gaps stay open.
bool is_small(const Glued_surfels& surfels, const Face& face)
{
  const std::vector<Spatial>& point = surfels.triangles.point;
  const Spatial &p = point[face[0]], &q = point[face[1]], &r = point[face[2]];
  const double radius =
      std::min({surfels.radius[face[0]], surfels.radius[face[1]], surfels.radius[face[2]]});
  return norm(q - p) * norm(r - q) * norm(p - r) <=
         2. * largest_circumradius * radius * norm(cross(q - p, r - p));
}

// The priority of the advancing front: small triangles first.
struct Small_in_surface
{
  const Glued_surfels* surfels;
  double* questions_left;

  template <typename Advancing_front, typename Cell_handle>
  double operator()(const Advancing_front& front, const Cell_handle& cell, int index) const
  {
    if(--*questions_left < 0.)
      throw Unsupported_surface_error(
          "The cloud is not clean: a surface through its surfels falls into too many parts.");
    const double size = front.smallest_radius_delaunay_sphere(cell, index);
    // The triangulation has vertices that are no surfels.
    if(!(size < infinity))
      return infinity;
    const Face face = {cell->vertex((index + 1) & 3)->info(), cell->vertex((index + 2) & 3)->info(),
                       cell->vertex((index + 3) & 3)->info()};
    const auto [least, largest] = rises(surfels->triangles, face);
    const bool is_in_sheet =
        (least >= -slant && largest > slant) || (largest <= slant && least < -slant);
    return is_in_sheet && is_small(*surfels, face) ? size : infinity;
  }
};

std::vector<Index> corners_of(const std::vector<Face>& faces)
{
  std::vector<Index> result;
  for(const Face& face : faces)
    for(const std::size_t site : face)
      result.push_back(Index(site));
  return result;
}

// Turns over each component that most of its triangles' surfels see from behind.
void orient(const Glued_triangles& t, std::vector<Face>& faces)
{
  const std::vector<Index> twins = twins_of_soup(t.number_of_sites(), corners_of(faces));
  std::vector<bool> is_reached(faces.size(), false);
  std::vector<Index> component;
  for(Index first = 0; first < faces.size(); ++first)
  {
    if(is_reached[first])
      continue;
    component = {first};
    is_reached[first] = true;
    double rise = 0.;
    for(std::size_t i = 0; i < component.size(); ++i)
    {
      const auto [least, largest] = rises(t, faces[component[i]]);
      rise += least + largest;
      for(Index side = 3 * component[i]; side < 3 * component[i] + 3; ++side)
        if(const Index twin = twins[side]; twin != none && !is_reached[twin / 3])
        {
          is_reached[twin / 3] = true;
          component.push_back(twin / 3);
        }
    }
    if(rise < 0.)
      for(const Index face : component)
        std::swap(faces[face][0], faces[face][1]);
  }
}

// The borders of few edges, each of them clockwise around what it leaves open.
std::vector<std::vector<Index>> gaps(std::size_t number_of_sites, const std::vector<Face>& faces)
{
  const std::vector<Index> corners = corners_of(faces);
  const std::vector<Index> twins = twins_of_soup(number_of_sites, corners);
  std::vector<Index> next(number_of_sites, none); // backwards along the border
  for(Index side = 0; side < corners.size(); ++side)
    if(twins[side] == none)
      next[corners[next_side(side)]] = corners[side];
  std::vector<std::vector<Index>> result;
  std::vector<Index> gap;
  for(Index begin = 0; begin < number_of_sites; ++begin)
  {
    gap.clear();
    for(Index site = begin; site != none && gap.size() < most_edges_of_gap;)
    {
      gap.push_back(site);
      site = std::exchange(next[site], none);
      if(site == begin)
      {
        result.push_back(gap);
        break;
      }
    }
  }
  return result;
}

using Edge = std::array<std::size_t, 2>; // sorted

template <typename Use>
void for_each_edge(const Face& face, const Use& use)
{
  for(int k = 0; k < 3; ++k)
    use(Edge{std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])});
}

// Those of the least area, where all of them lie in the surface and none has an edge that is there
// already, but for the rim's.
void close_gaps(const Glued_surfels& surfels, const std::vector<Kernel::Point_3>& points,
                std::vector<Face>& faces)
{
  std::set<Edge> edges;
  for(const Face& face : faces)
    for_each_edge(face, [&](const Edge& edge) { edges.insert(edge); });
  for(const std::vector<Index>& gap : gaps(points.size(), faces))
  {
    std::vector<Kernel::Point_3> rim;
    for(const Index site : gap)
      rim.push_back(points[site]);
    std::vector<Triple<int, int, int>> triples;
    Polygon_mesh_processing::triangulate_hole_polyline(
        rim, std::back_inserter(triples), CGAL::parameters::use_delaunay_triangulation(false));
    std::vector<Face> found;
    std::size_t known = 0; // edges of triangles: the rim's alone
    for(const auto& triple : triples)
    {
      found.push_back({gap[triple.first], gap[triple.second], gap[triple.third]});
      for_each_edge(found.back(), [&](const Edge& edge) { known += edges.count(edge); });
    }
    const bool is_in_surface =
        std::all_of(found.begin(), found.end(),
                    [&](const Face& face)
                    {
                      return (gap.size() <= few_edges || is_small(surfels, face)) &&
                             rises(surfels.triangles, face).second > 0.;
                    });
    if(known > gap.size() || !is_in_surface)
      continue;
    for(const Face& face : found)
      for_each_edge(face, [&](const Edge& edge) { edges.insert(edge); });
    faces.insert(faces.end(), found.begin(), found.end());
  }
}

// The sites moved in their tangent planes, by a part of their radii, so that no four of them lie on a
// circle: among equal triangles the front takes those at lower addresses first.
std::vector<Kernel::Point_3> in_general_position(const Glued_surfels& surfels)
{
  const Glued_triangles& t = surfels.triangles;
  std::mt19937 random;
  const auto part = [&] { return 1e-4 * (double(random()) / double(random.max()) - 0.5); };
  std::vector<Kernel::Point_3> result;
  for(std::size_t site = 0; site < surfels.tree.size(); ++site)
  {
    const auto [u, v] = tangent_frame(t.normal[site]);
    const double a = part() * surfels.radius[site], b = part() * surfels.radius[site];
    const Spatial p = t.point[site] + a * u + b * v;
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

bool are_collinear(const std::vector<Kernel::Point_3>& points)
{
  const auto other = std::find_if(points.begin(), points.end(),
                                  [&](const Kernel::Point_3& p) { return p != points.front(); });
  return other == points.end() || std::all_of(other, points.end(),
                                              [&](const Kernel::Point_3& p)
                                              { return collinear(points.front(), *other, p); });
}

} // namespace

Glued_mesh reconstruction(const Glued_surfels& surfels)
{
  const Glued_triangles& t = surfels.triangles;
  std::vector<Kernel::Point_3> points;
  for(std::size_t site = 0; site < surfels.tree.size(); ++site)
    points.emplace_back(t.point[site][0], t.point[site][1], t.point[site][2]);
  std::vector<Face> faces;
  double questions = first_questions + questions_per_surfel * double(points.size());
  if(!are_collinear(points)) // which it says on standard error
  {
    const std::vector<Kernel::Point_3> moved = in_general_position(surfels);
    advancing_front_surface_reconstruction(moved.begin(), moved.end(), std::back_inserter(faces),
                                           Small_in_surface{&surfels, &questions});
  }
  // It lists them by their addresses.
  for(Face& face : faces)
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  std::sort(faces.begin(), faces.end());
  orient(t, faces);
  close_gaps(surfels, points, faces);
  std::vector<std::array<double, 3>> places;
  for(const Spatial& p : t.point)
    places.push_back(t.origin + t.scale * p);
  const std::vector<Index> corners = corners_of(faces);
  return glue(std::move(places), corners, twins_of_soup(t.number_of_sites(), corners));
}

} // namespace CGAL::Geodesic_processing::internal
