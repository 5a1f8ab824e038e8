// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_BASE_POINTS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_BASE_POINTS_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Base points on a surface, the nearest of them for each vertex, and the distances between those
// close to each other.
struct Base_points
{
  std::vector<Index> vertices;       // #points: the vertex of each base point
  std::size_t number_of_nearest = 0; // length of the list of each vertex
  // number_of_nearest * #vertices: the nearest base points by increasing distance, then none
  std::vector<Index> neighbor;
  // number_of_nearest * #vertices: their distances, then infinity
  std::vector<double> distance;
  // #points * #points, symmetric; infinity if no vertex has both in its list
  std::vector<double> pair_distance;

  std::size_t size() const { return vertices.size(); }
  double distance_between(std::size_t i, std::size_t j) const
  {
    return pair_distance[i * size() + j];
  }
};

// Number of base points for a map, if the surface needs no more.
inline constexpr std::size_t default_number_of_base_points = 200;
// Bounds the size of the dense matrices of all pairs of base points.
inline constexpr std::size_t max_number_of_base_points = 1000;

// Computes a number of base points for which their mean spacing is below the mean width of a mesh
// with boundary. At least `default_number_of_base_points` and at most `max_number_of_base_points`.
// For a cloud, returns the default.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t suitable_number_of_base_points(const Surface_arrays& triangles);

// Computes the nearest base points of each vertex. From each sample a front runs while the sample
// is among the nearest ones of the vertices. All fronts together visit little more than
// number_of_nearest * #vertices vertices. If two fronts meet, the distance of their sources is the
// length of a straight line in the triangles there.
//
// Returns an empty result if the callback cancelled.
CGAL_GEODESIC_PROCESSING_EXPORT
Base_points nearest_base_points(const Surface_arrays& triangles, const Sampling& sampling,
                                Front front, std::size_t number_of_nearest,
                                const std::function<bool(double)>& callback = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_BASE_POINTS_H
