// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/parameterizations.h"

#include "io/errors.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <algorithm>
#include <iterator>
#include <limits>

namespace program {

namespace {

// A connected component of a mesh.
struct Component
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices; // in the mesh that contains the component, increasing
};

// Returns the component with the longest boundary cycle; empty if there is no boundary.
Component boundary_component(const Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Component result;
  const auto boundary = PMP::longest_border(mesh).first;
  if(boundary == Mesh::null_halfedge())
    return result;
  std::vector<Mesh::Face_index> faces;
  PMP::connected_component(mesh.face(mesh.opposite(boundary)), mesh, std::back_inserter(faces));
  std::sort(faces.begin(), faces.end());
  for(const Mesh::Face_index face : faces)
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face)))
      result.vertices.push_back(v);
  std::sort(result.vertices.begin(), result.vertices.end());
  result.vertices.erase(std::unique(result.vertices.begin(), result.vertices.end()),
                        result.vertices.end());
  if(faces.size() == mesh.number_of_faces() && result.vertices.size() == mesh.number_of_vertices())
  {
    result.mesh = mesh;
    return result;
  }
  std::vector<Mesh::Vertex_index> copy(mesh.number_of_vertices());
  for(const Mesh::Vertex_index v : result.vertices)
    copy[v] = result.mesh.add_vertex(mesh.point(v));
  for(const Mesh::Face_index face : faces)
  {
    std::vector<Mesh::Vertex_index> corners;
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face)))
      corners.push_back(copy[v]);
    result.mesh.add_face(corners);
  }
  return result;
}

} // namespace

std::vector<std::array<double, 2>> parameterization(const Surface& surface,
                                                    const std::string& method)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  // CGAL's circulators do not visit all fans of a vertex, and some of its functions then crash.
  if(surface.domain->report().number_of_nonmanifold_points > 0)
    throw Input_error(surface.name + ": the method " + method +
                      " needs a manifold, but a vertex has several fans of faces.");
  // CGAL's ARAP_parameterizer_3 also crashes if there are other vertices.
  Component component = boundary_component(surface.domain->mesh());
  Mesh& mesh = component.mesh;
  if(mesh.is_empty())
    throw Input_error(surface.name + ": the mesh has no boundary.");
  const auto boundary = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const SMP::Error_code code =
      method == "lscm" ? SMP::parameterize(mesh, SMP::LSCM_parameterizer_3<Mesh>(), boundary, uv)
      : method == "authalic"
          ? SMP::parameterize(mesh, SMP::Discrete_authalic_parameterizer_3<Mesh>(), boundary, uv)
          : SMP::parameterize(mesh, SMP::ARAP_parameterizer_3<Mesh>(), boundary, uv);
  if(code != SMP::OK)
    throw Input_error(surface.name + ": " + SMP::get_error_message(code) + ".");
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 2>> result(surface.file.points.size(), {nan, nan});
  for(const auto v : mesh.vertices())
    result[component.vertices[v]] = {uv[v].x(), uv[v].y()};
  return result;
}

} // namespace program
