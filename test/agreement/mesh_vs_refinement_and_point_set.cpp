// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes.h"
#include "methods.h"
#include "rough_surfaces.h"

#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <gtest/gtest.h>

#include <map>

namespace mesh_vs_refinement_and_point_set {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Returns the same surface with each face divided into four coplanar ones. The original points
// come first.
Triangulation subdivided_mesh(const Triangulation& shape)
{
  Triangulation result{shape.points, {}};
  std::map<std::pair<Index, Index>, Index> midpoint_index;
  const auto midpoint = [&](Index a, Index b)
  {
    const auto [entry, is_new] =
        midpoint_index.try_emplace(std::minmax(a, b), Index(result.points.size()));
    if(is_new)
    {
      Point p;
      for(int k = 0; k < 3; ++k)
        p[k] = 0.5 * (shape.points[a][k] + shape.points[b][k]);
      result.points.push_back(p);
    }
    return entry->second;
  };
  for(std::size_t c = 0; c < shape.corners.size(); c += 3)
  {
    const Index p = shape.corners[c], q = shape.corners[c + 1], r = shape.corners[c + 2];
    const Index a = midpoint(p, q), b = midpoint(q, r), d = midpoint(r, p);
    result.corners.insert(result.corners.end(), {p, a, d, a, q, b, d, b, r, a, b, d});
  }
  return result;
}

// Returns the mean of |a / b - 1| beyond 5 % of the largest distance.
double mean_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  const double max_distance = *std::max_element(b.begin(), b.end());
  return mean_relative_error(a, 0.05 * max_distance, [&](Index i) { return b[i]; });
}

void expect_agreement_with_refined(const Triangulation& shape)
{
  const Array_surface coarse(shape), fine(subdivided_mesh(shape));
  for(const Method method : all_methods)
  {
    const auto d = distances(coarse, method, {coarse.source(0)});
    auto on_fine = distances(fine, method, {fine.source(0)});
    on_fine.resize(d.size());
    // Both meshes have errors, and the finer one has smaller ones. They are as documented for each
    // method, and half as large again on coarse meshes.
    const double error = method == Method::euclidean_front ? 0.006
                         : method == Method::dijkstra      ? 0.1
                                                           : 0.03;
    EXPECT_LT(mean_difference(on_fine, d), error) << method;
    if(method != Method::dijkstra)
      continue;
    for(Index i = 0; i < d.size(); ++i) // the refined mesh contains the original edges
      EXPECT_LE(on_fine[i], d[i] * (1. + round_off_tolerance));
  }
}

void expect_agreement_of_heat_and_front(const Triangulation& shape)
{
  const Array_surface surface(shape);
  const auto front = distances(surface, Method::euclidean_front, {surface.source(0)});
  const auto heat = distances(surface, Method::heat, {surface.source(0)});
  // The sum of both errors on coarse scans: 3 % for heat (femur_3k9, compared with exact
  // distances) and 0.6 % for the front.
  EXPECT_LT(mean_difference(heat, front), 0.036);
}

TEST(Distances_vs_refinement_and_point_set, agree_with_refined_mesh)
{
  expect_agreement_with_refined(jittered(icosphere(4), 0.01));
}

TEST(Distances_vs_refinement_and_point_set, heat_agrees_with_front)
{
  expect_agreement_of_heat_and_front(jittered(icosphere(5), 0.005));
}

TEST(Distances_vs_refinement_and_point_set, agree_with_point_set)
{
  const Triangulation sphere = icosphere(5);
  const Array_surface surface(sphere);
  const auto on_mesh = distances(surface, Method::euclidean_front, {surface.source(0)});
  const internal::Surfel_arrays cloud = internal::build_surfel_arrays(sphere.points, sphere.points);
  internal::Front front(std::make_shared<const Surface_arrays>(cloud.arrays),
                        internal::Front_kind::euclidean);
  front.run({{{{none, cloud.internal_vertex[0], {}}}, 0., 0}});
  std::vector<double> on_cloud;
  for(Index i = 0; i < sphere.points.size(); ++i)
    on_cloud.push_back(cloud.arrays.scale * front.distance(cloud.internal_vertex[i]));
  // Both have second-order errors: a constant of order one times h^2, with edge length h = 0.04.
  EXPECT_LT(mean_difference(on_cloud, on_mesh), 0.002);
}

TEST(Distances_vs_refinement_and_point_set, agree_on_rough_surfaces_and_scans)
{
  std::vector<std::pair<std::string, Triangulation>> surfaces = {{"animal", animal()},
                                                                 {"bone", bone()}};
  add_models(surfaces, {"meshes/elephant_2k8.off", "meshes/femur_3k9.off", "meshes/cow_2k9.off"});
  for(const auto& [name, surface] : surfaces)
  {
    SCOPED_TRACE(name);
    expect_agreement_with_refined(surface);
    expect_agreement_of_heat_and_front(surface);
  }
}

} // namespace mesh_vs_refinement_and_point_set
