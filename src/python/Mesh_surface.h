// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_MESH_SURFACE_H
#define GEODESIC_PYTHON_MESH_SURFACE_H

#include "python/Surface.h"

#include <memory>

namespace python {

using Mesh_surface = Surface<Mesh_domain>;
using Mesh_class = py::class_<Mesh_surface, std::shared_ptr<Mesh_surface>>;

// Each adds the functions of a topic. Their files are compiled separately, because each of them
// instantiates many templates.
void bind_atlas(Mesh_class& mesh);
void bind_curves(Mesh_class& mesh);
void bind_decals(Mesh_class& mesh);
void bind_flattening(Mesh_class& mesh);
void bind_fuzzy(Mesh_class& mesh);
void bind_maps(Mesh_class& mesh);

} // namespace python

#endif // GEODESIC_PYTHON_MESH_SURFACE_H
