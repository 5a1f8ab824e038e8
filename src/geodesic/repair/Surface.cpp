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
    surface.is_repaired = complete_normals(surface.file, threads);
    return surface;
  }
  surface.is_repaired = triangulate(surface.file, filename);
  if(!surface.is_mesh())
    fail(filename, "all of its faces are degenerate");
  // Halfedge indices have 32 bits.
  if(surface.file.corners.size() >= (std::size_t{1} << 31))
    fail(filename, "it has more than 2^31 halfedges");
  surface.connectivity = orient(surface.file);
  surface.is_repaired = surface.is_repaired || surface.connectivity.number_of_flipped_faces > 0 ||
                        surface.connectivity.number_of_cut_edges > 0;
  return surface;
}

namespace {

using Halfedge = Mesh::Halfedge_index;

std::uint32_t next_corner(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
std::uint32_t previous_corner(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

// Links the boundary halfedges. At a vertex with several fans, those of all fans are linked to one
// cycle. Circulators around the vertex therefore visit all fans. `halfedge` contains the halfedge
// of each corner.
void link_boundary_halfedges(const Surface& surface, const std::vector<Halfedge>& halfedge,
                             Mesh& mesh)
{
  const std::vector<std::uint32_t>&corner = surface.file.corners,
        &twin = surface.connectivity.twins;
  std::vector<Halfedge> first_boundary_halfedge(surface.file.points.size());
  for(std::uint32_t h = 0; h < corner.size(); ++h)
  {
    if(twin[h] != no_halfedge)
      continue;
    std::uint32_t last = previous_corner(h);
    while(twin[last] != no_halfedge)
      last = previous_corner(twin[last]);
    const Halfedge incoming = mesh.opposite(halfedge[h]), outgoing = mesh.opposite(halfedge[last]);
    Halfedge& first_incoming = first_boundary_halfedge[corner[h]];
    if(first_incoming == Mesh::null_halfedge())
    {
      first_incoming = incoming;
      mesh.set_next(incoming, outgoing);
    }
    else
    {
      mesh.set_next(incoming, mesh.next(first_incoming));
      mesh.set_next(first_incoming, outgoing);
    }
    // CGAL requires that the halfedge of a boundary vertex is a boundary halfedge.
    mesh.set_halfedge(Mesh::Vertex_index(corner[h]), incoming);
  }
}

} // namespace

Mesh make_mesh(const Surface& surface)
{
  const std::vector<std::uint32_t>&corner = surface.file.corners,
        &twin = surface.connectivity.twins;
  const auto vertex = [](std::uint32_t v) { return Mesh::Vertex_index(v); };

  Mesh mesh;
  const std::size_t number_of_triangles = corner.size() / 3;
  mesh.reserve(static_cast<Mesh::size_type>(surface.file.points.size()),
               static_cast<Mesh::size_type>(number_of_triangles * 3 / 2 + 2),
               static_cast<Mesh::size_type>(number_of_triangles));
  for(const Point& p : surface.file.points)
    mesh.add_vertex({p[0], p[1], p[2]});

  std::vector<Halfedge> halfedge(corner.size());
  for(std::uint32_t h = 0; h < corner.size(); ++h)
    halfedge[h] = twin[h] != no_halfedge && twin[h] < h
                      ? mesh.opposite(halfedge[twin[h]])
                      : mesh.add_edge(vertex(corner[h]), vertex(corner[next_corner(h)]));
  for(std::uint32_t h = 0; h < corner.size(); ++h)
  {
    if(h % 3 == 0)
      mesh.set_halfedge(mesh.add_face(), halfedge[h]);
    mesh.set_face(halfedge[h], Mesh::Face_index(h / 3));
    mesh.set_next(halfedge[h], halfedge[next_corner(h)]);
    mesh.set_halfedge(vertex(corner[next_corner(h)]), halfedge[h]);
  }
  link_boundary_halfedges(surface, halfedge, mesh);
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
