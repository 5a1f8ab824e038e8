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

// Points spread over a surface, the nearest of them around each site, and the distances of those that are
// near each other.
struct Base_points
{
  std::vector<Index> vertices;       // #points: where they are
  std::size_t number_of_nearest = 0; // how many of them each site knows
  std::vector<Index>
      neighbor; // nearest * #sites: which ones, the nearest first; none where there are fewer
  std::vector<double> distance; // nearest * #sites; infinite where there are fewer
  std::vector<double>
      pair_distance; // #points * #points, symmetric; infinite where no site knows both

  std::size_t size() const { return vertices.size(); }
  double distance_between(std::size_t i, std::size_t j) const
  {
    return pair_distance[i * size() + j];
  }
};

// So many carry a flattening, if there is no better reason.
inline constexpr std::size_t default_number_of_base_points = 200;
// The matrices of all pairs of base points are dense.
inline constexpr std::size_t max_number_of_base_points = 1000;

// So many that they are not as far apart as the surface is wide, in the mean: the usual ones at least, which on
// a cloud are all that are told, and the most at most.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t suitable_number_of_base_points(const Surface_arrays& triangles);

// Lets a front start from each sample, which goes on only as long as the sample is among the `nearest` ones:
// together they visit little more than `nearest` times all sites.  Distances between samples are lengths of
// straight lines across the triangles where two fronts meet.
//
// An empty result when the callback cancelled it.
CGAL_GEODESIC_PROCESSING_EXPORT
Base_points nearest_base_points(const Surface_arrays& triangles, const Sampling& sampling,
                                Front front, std::size_t number_of_nearest,
                                const std::function<bool(double)>& callback = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_BASE_POINTS_H
