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
#include <iterator>
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

std::size_t number_of_degenerate_faces(const Soup& soup)
{
  const auto is_degenerate = [&](const std::vector<std::size_t>& triangle)
  {
    const Point &p = soup.points[triangle[0]], &q = soup.points[triangle[1]],
                &r = soup.points[triangle[2]];
    return p == q || q == r || r == p;
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
