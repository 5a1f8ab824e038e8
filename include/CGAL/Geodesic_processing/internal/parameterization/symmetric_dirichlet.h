// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cstddef>
#include <functional>
#include <vector>

// Maps of meshes to the plane without inverted triangles.

namespace CGAL::Geodesic_processing::internal {

// Computes twice the signed area of the image of a triangle, negative if it is inverted.
inline double twice_area_of_image(const Surface_arrays& triangles, const std::vector<Vec2>& image,
                                  Index triangle)
{
  const Index* c = &triangles.corner[3 * std::size_t(triangle)];
  return cross(image[c[1]] - image[c[0]], image[c[2]] - image[c[0]]);
}

// Computes the factor that scales the area of an image to the area of the triangles, or 0 if there
// is none.
CGAL_GEODESIC_PROCESSING_EXPORT
double scale_to_area(const Surface_arrays& triangles, const std::vector<Vec2>& image);

// Returns the number of triangles whose image does not have positive signed area.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t number_of_flips(const Surface_arrays& triangles, const std::vector<Vec2>& image);

// The result of the minimization of the distortion of a map.
struct Minimization_result
{
  double energy = 0.; // the final mean energy per area; 4 for an isometry
  std::size_t number_of_iterations = 0;
  bool is_complete = true; // false if the callback cancelled
};

// Minimizes the symmetric Dirichlet energy of a map without inverted triangles (Smith and Schaefer
// 2015). It is the mean, weighted by area, of the sum of the squared singular values and their
// inverses.
//
// Newton's method; the Hessian of each triangle is projected to a positive semidefinite matrix in
// closed form (Smith, de Goes and Kim 2019). No step reaches the first inversion of a triangle.
// The iteration ends if a step decreases the energy by less than the fraction `energy_tolerance`.
//
// is_fixed: #vertices, or empty: vertices that must not move
CGAL_GEODESIC_PROCESSING_EXPORT
Minimization_result minimize_symmetric_dirichlet(const Surface_arrays& triangles,
                                                 std::vector<Vec2>& image, std::size_t max_steps,
                                                 const std::function<bool(double)>& callback = {},
                                                 double energy_tolerance = 1e-6,
                                                 const std::vector<bool>& is_fixed = {});

// Moves vertices that are not fixed until no triangle is inverted. Returns whether this succeeded.
// The same Newton steps minimize a regularized energy, in which the inverse determinant is finite
// for inverted triangles (Garanzha et al. 2021).
CGAL_GEODESIC_PROCESSING_EXPORT
bool unflip(const Surface_arrays& triangles, std::vector<Vec2>& image, std::size_t max_steps,
            const std::vector<bool>& is_fixed = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_H
