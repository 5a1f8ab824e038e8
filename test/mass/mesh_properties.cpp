// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_properties.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace mass_test {

namespace PMP = CGAL::Polygon_mesh_processing;

using Mesh = CGAL::Surface_mesh<Point>;

std::optional<Topology> topology_of(const Soup& soup)
{
  if(!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons))
    return std::nullopt;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  const auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  Topology result;
  result.components = double(PMP::connected_components(mesh, component));
  std::vector<Mesh::Halfedge_index> cycles;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  result.boundary_cycles = double(cycles.size());
  const auto isolated = std::count_if(mesh.vertices_begin(), mesh.vertices_end(),
                                      [&](auto v) { return mesh.is_isolated(v); });
  const double characteristic = double(mesh.number_of_vertices() - isolated) -
                                double(mesh.number_of_edges()) + double(mesh.number_of_faces());
  result.genus = result.components - (characteristic + result.boundary_cycles) / 2.;
  return result;
}

bool intersects_itself(const Soup& soup)
{
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return PMP::does_self_intersect(mesh);
}

std::vector<Slit_edge> slit_edges(const Soup& soup)
{
  std::map<Point, std::size_t> number_at;
  for(const Point& p : soup.points)
    ++number_at[p];
  std::map<std::array<std::size_t, 2>, std::size_t> number_of_polygons;
  for(const auto& polygon : soup.polygons)
    for(std::size_t i = 0; i < polygon.size(); ++i)
    {
      const auto [v, w] = std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]);
      ++number_of_polygons[{v, w}];
    }
  std::vector<Slit_edge> result;
  for(const auto& [ends, number] : number_of_polygons)
    if(const Point& p = soup.points[ends[0]], &q = soup.points[ends[1]];
       number == 1 && number_at[p] > 1 && number_at[q] > 1)
      result.push_back({p, q});
  return result;
}

std::size_t number_of_degenerate_faces(const Soup& soup, const std::vector<Slit_edge>& slits)
{
  // The round-off error of an interpolated point, relative to the length of the edge.
  constexpr double round_off = 1e-9;
  const auto is_on_slit = [&](const Point& p)
  {
    return std::any_of(slits.begin(), slits.end(),
                       [&](const Slit_edge& edge)
                       {
                         return CGAL::squared_distance(p, Kernel::Segment_3(edge[0], edge[1])) <=
                                round_off * round_off * CGAL::squared_distance(edge[0], edge[1]);
                       });
  };
  const auto is_degenerate = [&](const std::vector<std::size_t>& triangle)
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(const Point& p = soup.points[triangle[k]];
         p == soup.points[triangle[(k + 1) % 3]] && !is_on_slit(p))
        return true;
    return false;
  };
  return std::size_t(std::count_if(soup.polygons.begin(), soup.polygons.end(), is_degenerate));
}

std::vector<std::size_t> charts(const Textured_mesh& mesh)
{
  boost::disjoint_sets_with_storage<> sets(mesh.uv.size());
  for(const auto& uv : mesh.uv_corners)
  {
    sets.union_set(uv[0], uv[1]);
    sets.union_set(uv[1], uv[2]);
  }
  std::vector<std::size_t> result;
  for(const auto& uv : mesh.uv_corners)
    result.push_back(sets.find_set(uv[0]));
  return result;
}

} // namespace mass_test
