// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_MESH_SURFACE_H
#define GEODESIC_PYTHON_MESH_SURFACE_H

#include "python/Surface.h"

#include <array>
#include <memory>
#include <vector>

namespace python {

using Mesh_surface = Surface<Mesh_domain>;
using Mesh_class = py::class_<Mesh_surface, std::shared_ptr<Mesh_surface>>;

// Returns the surface of a mesh without removed elements. Its points and faces keep their order. A
// face begins with the target of its halfedge. Polygons are triangulated.
std::shared_ptr<Mesh_surface> surface_of_mesh(const Mesh& mesh);
// Returns the surface of these points and triangles.
std::shared_ptr<Mesh_surface>
surface_of_triangles(const std::vector<Kernel::Point_3>& points,
                     const std::vector<std::array<std::size_t, 3>>& triangles);

// Returns the source and the target of edges, one row each.
template <typename Edges>
py::array_t<std::int64_t> edge_array(const Mesh& mesh, const Edges& edges)
{
  py::array_t<std::int64_t> result(Shape{py::ssize_t(edges.size()), 2});
  std::int64_t* next = result.mutable_data();
  for(const Mesh::Edge_index edge : edges)
  {
    const Mesh::Halfedge_index h = mesh.halfedge(edge);
    *next++ = std::int64_t(std::size_t(mesh.source(h)));
    *next++ = std::int64_t(std::size_t(mesh.target(h)));
  }
  return result;
}

// Each adds the functions of a topic. Their files are compiled separately, because each of them
// instantiates many templates.
void bind_atlas(Mesh_class& mesh);
void bind_base_meshes(py::module_& module, Mesh_class& mesh);
void bind_curvature(Mesh_class& mesh);
void bind_curves(Mesh_class& mesh);
void bind_decals(Mesh_class& mesh);
void bind_distortion(Mesh_class& mesh);
void bind_features(Mesh_class& mesh);
void bind_flattening(Mesh_class& mesh);
void bind_fuzzy(Mesh_class& mesh);
void bind_maps(Mesh_class& mesh);
void bind_measures(Mesh_class& mesh);
void bind_remeshing(Mesh_class& mesh);
void bind_sampling(Mesh_class& mesh);
void bind_transport(Mesh_class& mesh);
void bind_volumes(py::module_& module, Mesh_class& mesh);
void bind_wavelets(py::module_& module, Mesh_class& mesh);

} // namespace python

#endif // GEODESIC_PYTHON_MESH_SURFACE_H
