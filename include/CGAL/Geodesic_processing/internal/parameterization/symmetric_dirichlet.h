// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cstddef>
#include <functional>
#include <vector>

// Maps of a mesh to the plane that turn no triangle round.

namespace CGAL::Geodesic_processing::internal {

// Twice the area of the image of a triangle; negative where that is turned round.
inline double twice_area_of_image(const Surface_arrays& triangles, const std::vector<Vec2>& image,
                                  Index triangle)
{
  const Index* c = &triangles.corner[3 * std::size_t(triangle)];
  return cross(image[c[1]] - image[c[0]], image[c[2]] - image[c[0]]);
}

// What an image is to be enlarged by for its area to be that of its triangles; 0 where nothing does that.
CGAL_GEODESIC_PROCESSING_EXPORT
double scale_to_area(const Surface_arrays& triangles, const std::vector<Vec2>& image);

// How many triangles have an image whose corners do not run counterclockwise.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t number_of_flips(const Surface_arrays& triangles, const std::vector<Vec2>& image);

// The borders as sides one after another, the longest border first.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::vector<Index>> boundary_loops(const Surface_arrays& triangles);

// Throws Unsupported_surface_error unless the triangles are glued to a disk, maybe with holes: one component,
// a border, no handle.  Sites without triangles do not count.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_is_disk(const Surface_arrays& triangles);

// Tutte's map of a disk: the longest border on a circle, each other site at the mean of its neighbours;
// holes are filled by a site that is their neighbour.  Without flips but for rounding.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec2> tutte_map(const Surface_arrays& triangles);

// What minimizing the distortion of a map has done.
struct Minimization_result
{
  double energy = 0.; // what is left, per area: 4 where nothing is stretched
  std::size_t number_of_steps = 0;
  bool is_complete = true; // false: the callback cancelled it
};

// Minimizes the symmetric Dirichlet energy of a map without flips: the mean, by the area of the triangles, of
// the sum of the squares of the singular values and of their inverses (Smith and Schaefer 2015).  Newton's
// method; each triangle's Hessian is made definite in closed form (Smith, de Goes and Kim 2019), and no step
// goes as far as the first triangle's flip.  It ends where a step lowers the energy by less than a part of it.
CGAL_GEODESIC_PROCESSING_EXPORT
Minimization_result minimize_symmetric_dirichlet(const Surface_arrays& triangles,
                                                 std::vector<Vec2>& image, std::size_t max_steps,
                                                 const std::function<bool(double)>& callback = {},
                                                 double energy_tolerance = 1e-6,
                                                 const std::vector<bool>& is_fixed = {});

// Moves sites that are not held until no triangle is flipped, and says whether that came about.  Steps are of the
// same method, for the same energy with the inverse determinant made finite where that is not positive (Garanzha
// and others 2021).
CGAL_GEODESIC_PROCESSING_EXPORT
bool unflip(const Surface_arrays& triangles, std::vector<Vec2>& image, std::size_t max_steps,
            const std::vector<bool>& is_fixed = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_SYMMETRIC_DIRICHLET_H
