// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_LLE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_LLE_H

#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

// Geodesic locally linear embedding (Peyré and Cohen 2005, section 3).

namespace CGAL::Geodesic_processing::internal {

// Returns the number of nearest base points of each vertex that is required for a number of
// neighbors. Distances between neighbors are measured where their fronts meet, sometimes farther
// away, so a quarter more is required. With half as many more, maps take a seventh longer and
// differ only near inverted faces.
constexpr std::size_t number_of_nearest_for(std::size_t neighbors)
{
  return neighbors + (neighbors + 2) / 4 + 1;
}

// Computes an embedding in the plane from squared distances: the two largest eigenvectors of the
// centered Gram matrix, scaled by the square roots of their eigenvalues. Size n x 2.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::MatrixXd classical_scaling(const Eigen::MatrixXd& squares);

// The initial embeddings that are tried, at least one, and the number of steps that make them as
// rigid as possible. On scans the energy decreases by less than 1 % in the last of 30 steps.
struct Embedding_options
{
  bool use_lle = true, use_isomap = true;
  std::size_t number_of_rigid_steps = 30;
};

// Embeds base points in the plane. There are two initial embeddings: locally linear embedding with
// a linear map fitted to the distances of neighbors, and Isomap. Both are optimized to be as rigid
// as possible, and the one of lower energy is returned. Both energies are zero for a developable
// surface.
//
// If the graph of neighbors is not connected, more neighbors are used, up to `number_of_nearest`.
// Returns an empty vector if it is still not connected or if there are fewer than three base
// points.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec2> embed_base_points(const Base_points& base, std::size_t neighbors,
                                    const Embedding_options& options = {});

// Base points and their images in the plane.
struct Embedded_base_points
{
  Base_points base;            // empty if the callback cancelled
  std::size_t neighbors = 0;   // number of neighbors of each base point
  std::vector<Vec2> positions; // empty if the graph of neighbors is not connected
};

// Computes the nearest base points of each vertex and embeds them. If `can_grow` is true and the
// graph of neighbors is not connected, the number of neighbors is increased to the smallest one for
// which it is, plus `neighbors`.
CGAL_GEODESIC_PROCESSING_EXPORT
Embedded_base_points embed_samples(const Surface_arrays& triangles, const Sampling& sampling,
                                   const Front& front, std::size_t neighbors, bool can_grow,
                                   const std::function<bool(double)>& callback = {},
                                   const Embedding_options& options = {});

// Extends an embedding of the base points to all vertices. The map is continuous, interpolates the
// images of the base points, and is linear if the surface is a piece of the plane. Vertices
// without base points get NaN.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec2> extend_embedding(const Base_points& base, const std::vector<Vec2>& images,
                                   std::size_t neighbors);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_LLE_H
