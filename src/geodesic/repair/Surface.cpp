// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/Surface.h"

#include "io/Scanner.h"

namespace program {

Surface read_surface(const std::string& filename, unsigned threads)
{
  return repair(read_surface_file(filename), filename, threads);
}

Surface repair(Surface_file file, const std::string& filename, unsigned threads)
{
  check(file, filename);
  Surface surface;
  surface.name = filename;
  surface.file = std::move(file);
  if(!surface.is_mesh())
  {
    surface.repaired = complete_normals(surface.file, threads);
    return surface;
  }
  surface.repaired = triangulate(surface.file, filename);
  if(!surface.is_mesh())
    fail(filename, "none of its faces has three different corners");
  // Four bytes name a side.
  if(surface.file.corners.size() >= (std::size_t{1} << 31))
    fail(filename, "it has more than 2^31 half-edges");
  surface.gluing = orient(surface.file);
  surface.repaired = surface.repaired || surface.gluing.flipped > 0 || surface.gluing.cut > 0;
  return surface;
}

Mesh make_mesh(const Surface& surface)
{
  using Halfedge = Mesh::Halfedge_index;
  const std::vector<std::uint32_t>&corner = surface.file.corners, &twin = surface.gluing.twins;
  const auto next = [](std::uint32_t s) { return s % 3 == 2 ? s - 2 : s + 1; };
  const auto previous = [](std::uint32_t s) { return s % 3 == 0 ? s + 2 : s - 1; };
  const auto vertex = [](std::uint32_t v) { return Mesh::Vertex_index(v); };

  Mesh mesh;
  const std::size_t triangles = corner.size() / 3;
  mesh.reserve(static_cast<Mesh::size_type>(surface.file.points.size()),
               static_cast<Mesh::size_type>(triangles * 3 / 2 + 2),
               static_cast<Mesh::size_type>(triangles));
  for(const Point& p : surface.file.points)
    mesh.add_vertex({p[0], p[1], p[2]});

  std::vector<Halfedge> halfedge(corner.size());
  for(std::uint32_t s = 0; s < corner.size(); ++s)
    halfedge[s] = twin[s] != no_side && twin[s] < s
                      ? mesh.opposite(halfedge[twin[s]])
                      : mesh.add_edge(vertex(corner[s]), vertex(corner[next(s)]));
  for(std::uint32_t s = 0; s < corner.size(); ++s)
  {
    if(s % 3 == 0)
      mesh.set_halfedge(mesh.add_face(), halfedge[s]);
    mesh.set_face(halfedge[s], Mesh::Face_index(s / 3));
    mesh.set_next(halfedge[s], halfedge[next(s)]);
    mesh.set_halfedge(vertex(corner[next(s)]), halfedge[s]);
  }

  // The border of a fan enters its vertex opposite to a side that leaves it, and goes on along the
  // border of the next fan there, so that circulators see all of them.
  std::vector<Halfedge> first_enters(surface.file.points.size());
  for(std::uint32_t s = 0; s < corner.size(); ++s)
  {
    if(twin[s] != no_side)
      continue;
    std::uint32_t last = previous(s);
    while(twin[last] != no_side)
      last = previous(twin[last]);
    const Halfedge enters = mesh.opposite(halfedge[s]), leaves = mesh.opposite(halfedge[last]);
    Halfedge& first = first_enters[corner[s]];
    if(first == Mesh::null_halfedge())
    {
      first = enters;
      mesh.set_next(enters, leaves);
    }
    else
    {
      mesh.set_next(enters, mesh.next(first));
      mesh.set_next(first, leaves);
    }
    // CGAL wants a border half-edge at a border vertex.
    mesh.set_halfedge(vertex(corner[s]), enters);
  }
  return mesh;
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
