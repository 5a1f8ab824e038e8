// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_CLOUD_SURFACE_H
#define GEODESIC_PYTHON_CLOUD_SURFACE_H

#include "python/Surface.h"

#include <memory>

namespace python {

using Cloud_surface = Surface<Cloud_domain>;
using Cloud_class = py::class_<Cloud_surface, std::shared_ptr<Cloud_surface>>;

// Each adds the functions of a topic, as for meshes.
void bind_atlas(Cloud_class& cloud);
void bind_base_meshes(py::module_& module, Cloud_class& cloud);
void bind_curvature(Cloud_class& cloud);
void bind_curves(Cloud_class& cloud);
void bind_decals(Cloud_class& cloud);
void bind_distortion(Cloud_class& cloud);
void bind_features(Cloud_class& cloud);
void bind_flattening(Cloud_class& cloud);
void bind_fuzzy(Cloud_class& cloud);
void bind_maps(Cloud_class& cloud);
void bind_remeshing(Cloud_class& cloud);
void bind_sampling(Cloud_class& cloud);
void bind_transport(Cloud_class& cloud);

} // namespace python

#endif // GEODESIC_PYTHON_CLOUD_SURFACE_H
