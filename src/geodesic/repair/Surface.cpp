// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/Surface.h"

#include "readers/Scanner.h"
#include "repair/complete_normals.h"

#include <boost/property_map/function_property_map.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/irange.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace program {

namespace {

using Domain = CGAL::Geodesic_processing::Soup_domain<Kernel::Point_3>;

// Replaces the polygons by the triangles of a mesh.
void set_triangles(const Domain& domain, Surface_file& file)
{
  const std::size_t number_of_faces = domain.number_of_faces();
  file.corners.resize(3 * number_of_faces);
  file.polygon_begin.resize(number_of_faces + 1);
  for(std::size_t f = 0; f < number_of_faces; ++f)
  {
    const auto corners = domain.corners(Mesh::Face_index(static_cast<Mesh::size_type>(f)));
    for(std::size_t k = 0; k < 3; ++k)
      file.corners[3 * f + k] = static_cast<std::uint32_t>(corners[k]);
    file.polygon_begin[f + 1] = 3 * (f + 1);
  }
}

// Constructs the domain from the arrays of a file, without copies of them.
Domain make_domain(const Surface_file& file, unsigned threads)
{
  const auto point_map = boost::make_function_property_map<Point>(
      [](const Point& p) { return Kernel::Point_3(p[0], p[1], p[2]); });
  const auto polygon = [&file](std::size_t f)
  {
    return boost::make_iterator_range(file.corners.data() + file.polygon_begin[f],
                                      file.corners.data() + file.polygon_begin[f + 1]);
  };
  return CGAL::Geodesic_processing::make_domain(
      file.points,
      boost::irange<std::size_t>(0, file.number_of_polygons()) |
          boost::adaptors::transformed(polygon),
      CGAL::Geodesic_processing::parameters::number_of_threads(threads).point_map(point_map));
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
  try
  {
    surface.domain = make_domain(surface.file, threads);
  }
  catch(const std::runtime_error& error)
  {
    throw Input_error(filename + ": " + error.what());
  }
  surface.is_repaired = surface.domain->report().is_changed();
  if(surface.is_repaired)
    set_triangles(*surface.domain, surface.file);
  if(surface.file.corners.empty())
    fail(filename, "all of its faces are degenerate");
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
