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
#include <set>
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

bool touches_itself_at(const Soup& soup, const Point& point)
{
  // The round-off error of an interpolated point, relative to the length of an edge.
  constexpr double round_off = 1e-9;
  const auto is_near = [&](const auto& element, double squared_size)
  { return CGAL::squared_distance(point, element) <= round_off * round_off * squared_size; };
  // The parts of faces that contain the point are adjacent if they share an edge that contains it,
  // or a vertex at it.
  boost::disjoint_sets_with_storage<> sets(soup.points.size() + soup.polygons.size());
  std::set<std::size_t> containing;
  std::map<std::array<std::size_t, 2>, std::size_t> polygon_at_edge;
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
  {
    const std::vector<std::size_t>& polygon = soup.polygons[f];
    const std::size_t set = soup.points.size() + f;
    const auto at = [&](std::size_t i) -> const Point& { return soup.points[polygon[i]]; };
    const auto contains = [&](std::size_t i)
    {
      const Kernel::Triangle_3 triangle(at(0), at(i), at(i + 1));
      const double squared_size =
          std::max(CGAL::squared_distance(at(0), at(i)), CGAL::squared_distance(at(0), at(i + 1)));
      return triangle.is_degenerate() ? is_near(Kernel::Segment_3(at(0), at(i)), squared_size)
                                      : is_near(triangle, squared_size);
    };
    bool is_containing = false;
    for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
      is_containing = is_containing || contains(i);
    if(!is_containing)
      continue;
    containing.insert(f);
    for(std::size_t i = 0; i < polygon.size(); ++i)
    {
      const std::size_t j = (i + 1) % polygon.size();
      const double squared_length = CGAL::squared_distance(at(i), at(j));
      if(is_near(at(i), squared_length))
        sets.union_set(set, polygon[i]);
      if(!is_near(Kernel::Segment_3(at(i), at(j)), squared_length))
        continue;
      const auto [v, w] = std::minmax(polygon[i], polygon[j]);
      sets.union_set(set,
                     soup.points.size() + polygon_at_edge.try_emplace({v, w}, f).first->second);
    }
  }
  std::set<std::size_t> roots;
  for(const std::size_t f : containing)
    roots.insert(sets.find_set(soup.points.size() + f));
  return roots.size() > 1;
}

std::size_t number_of_degenerate_faces(const Soup& soup, const Soup& input)
{
  const auto is_degenerate = [&](const std::vector<std::size_t>& triangle)
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(const Point& p = soup.points[triangle[k]];
         p == soup.points[triangle[(k + 1) % 3]] && !touches_itself_at(input, p))
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
