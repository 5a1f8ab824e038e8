// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/parameterizations.h"

#include "io/errors.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <limits>

namespace program {

std::vector<std::array<double, 2>> parameterization(const Surface& surface,
                                                    const std::string& method)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  Mesh mesh = surface.domain->mesh();
  const auto boundary = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  if(boundary == Mesh::null_halfedge())
    throw Input_error(surface.name + ": the mesh has no boundary.");
  // CGAL assigns no coordinates to vertices that are not connected to the boundary.
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto uv =
      mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv", {nan, nan}).first;
  const SMP::Error_code code =
      method == "lscm" ? SMP::parameterize(mesh, SMP::LSCM_parameterizer_3<Mesh>(), boundary, uv)
      : method == "authalic"
          ? SMP::parameterize(mesh, SMP::Discrete_authalic_parameterizer_3<Mesh>(), boundary, uv)
          : SMP::parameterize(mesh, SMP::ARAP_parameterizer_3<Mesh>(), boundary, uv);
  if(code != SMP::OK)
    throw Input_error(surface.name + ": " + SMP::get_error_message(code) + ".");
  std::vector<std::array<double, 2>> result;
  for(const auto v : mesh.vertices())
    result.push_back({uv[v].x(), uv[v].y()});
  return result;
}

} // namespace program
