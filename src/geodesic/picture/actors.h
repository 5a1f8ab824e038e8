// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_ACTORS_H
#define GEODESIC_PROGRAM_PICTURE_ACTORS_H

#include "picture/Render_mesh.h"

#include "io/Image.h"

#include <vtkSmartPointer.h>

#include <cstdint>
#include <vector>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace program {

// Actors of VTK. Coordinates are in the box [-1, 1]^3.

inline constexpr Color line_color = {0.08, 0.08, 0.12}, marker_color = {0.86, 0.11, 0.12};
// Radii in units of half the longest side of the bounding box
inline constexpr double thin_radius = 0.0022, thick_radius = 0.011, marker_radius = 0.024;

vtkSmartPointer<vtkPolyData> to_poly_data(const std::vector<Point>& points,
                                          const std::vector<std::uint32_t>& corners);

// Renders lines as tubes. Returns their actor, which the renderer owns, or nullptr if there are
// no lines.
vtkActor* add_tubes(vtkRenderer* renderer, vtkPolyData* lines, double radius, const Color& color);
vtkActor* add_tubes(vtkRenderer* renderer, const std::vector<std::vector<Point>>& polylines,
                    double radius, const Color& color);

void add_sphere(vtkRenderer* renderer, const Point& center, double radius, const Color& color);

void add_mesh(vtkRenderer* renderer, const Render_mesh& mesh, double opacity = 1.);

// Adds a mesh with a texture. `points` replace those of the surface.
void add_textured_mesh(vtkRenderer* renderer, const std::vector<Point>& points,
                       const Surface_file& surface, const Image& image);

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_ACTORS_H
