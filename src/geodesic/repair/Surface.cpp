// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/Surface.h"

#include "readers/Scanner.h"
#include "repair/complete_normals.h"

#include <boost/range/iterator_range.hpp>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace program {

namespace {

// Replaces the polygons by the triangles of a mesh.
void set_triangles(const Mesh& mesh, Surface_file& file)
{
  file.corners.clear();
  file.polygon_begin.assign(1, 0);
  for(const Mesh::Face_index face : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(face);
    for(const Mesh::Vertex_index corner :
        {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))})
      file.corners.push_back(corner);
    file.polygon_begin.push_back(file.corners.size());
  }
}

} // namespace

Surface repair(Surface_file file, const std::string& filename, unsigned threads)
{
  check(file, filename);
  Surface surface;
  surface.name = filename;
  surface.file = std::move(file);
  if(surface.file.number_of_polygons() == 0)
  {
    surface.is_repaired = complete_normals(surface.file, threads);
    return surface;
  }
  std::vector<Kernel::Point_3> points;
  points.reserve(surface.file.points.size());
  for(const Point& p : surface.file.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<boost::iterator_range<const std::uint32_t*>> polygons;
  polygons.reserve(surface.file.number_of_polygons());
  for(std::size_t f = 0; f < surface.file.number_of_polygons(); ++f)
    polygons.emplace_back(surface.file.corners.data() + surface.file.polygon_begin[f],
                          surface.file.corners.data() + surface.file.polygon_begin[f + 1]);
  try
  {
    surface.domain = CGAL::Geodesic_processing::make_domain(points, polygons);
  }
  catch(const std::runtime_error& error)
  {
    throw Input_error(filename + ": " + error.what());
  }
  set_triangles(surface.domain->mesh(), surface.file);
  if(surface.file.corners.empty())
    fail(filename, "all of its faces are degenerate");
  surface.is_repaired = surface.domain->report().is_changed();
  return surface;
}

Cloud make_cloud(const Surface& surface)
{
  Cloud cloud;
  cloud.add_normal_map();
  cloud.reserve(surface.file.points.size());
  for(std::size_t i = 0; i < surface.file.points.size(); ++i)
  {
    const Point &p = surface.file.points[i], &n = surface.file.normals[i];
    cloud.insert({p[0], p[1], p[2]}, {n[0], n[1], n[2]});
  }
  const auto radii = surface.file.properties.find("radius");
  if(radii != surface.file.properties.end())
  {
    const auto radius = cloud.add_property_map<double>("radius", 0.).first;
    for(const Cloud::Index& surfel : cloud)
      radius[surfel] = radii->second[surfel];
  }
  return cloud;
}

} // namespace program
