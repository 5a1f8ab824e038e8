// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/mesh_optimization.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace mesh_optimization_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A sphere whose coarse vertices are samples, so that the dual is the coarse mesh.
struct Sampled_sphere
{
  Sampled_sphere() : arrays(icosphere(3)), surface(arrays.triangles(), {})
  {
    sampling.emplace(arrays.triangles(), Front(arrays.triangles(), Front_kind::euclidean),
                     Sample_location::triangle);
    std::vector<Surface_location> samples;
    for(Index i = 0; i < 12; ++i)
      samples.push_back(arrays.at(i));
    sampling->add(samples);
    cells = connected_cells(arrays.t(), *sampling);
    triangles = compute_dual_triangles(arrays.t(), cells.labels);
  }

  Array_surface arrays;
  Refined_surface surface;
  std::optional<Sampling> sampling;
  Cells cells;
  std::vector<std::array<Index, 3>> triangles;
};

TEST(Mesh_optimization, mesh_without_fit_interpolates_the_samples)
{
  const Sampled_sphere s;
  const Remeshing_options options;
  const Coarse_mesh mesh =
      Mesh_optimization(s.surface, options).build_mesh(s.cells, *s.sampling, s.triangles);
  ASSERT_EQ(mesh.points.size(), 12u);
  EXPECT_EQ(mesh.triangles.size(), 20u);
  for(Index i = 0; i < 12; ++i)
    EXPECT_EQ(mesh.points[i], s.arrays.t().point[s.arrays.vertex(i)]);
}

TEST(Mesh_optimization, fit_moves_points_by_at_most_the_maximum_deviation)
{
  const Sampled_sphere s;
  Remeshing_options options;
  options.does_fit_to_input = true;
  for(const double deviation : {1e-3, 1e-2, infinity})
  {
    options.maximum_deviation = deviation;
    const Coarse_mesh mesh =
        Mesh_optimization(s.surface, options).build_mesh(s.cells, *s.sampling, s.triangles);
    for(Index i = 0; i < 12; ++i)
    {
      const double distance = norm(mesh.points[i] - s.arrays.t().point[s.arrays.vertex(i)]);
      EXPECT_GT(distance, 0.);                       // an inscribed icosahedron grows
      EXPECT_LE(distance, deviation * (1. + 1e-12)); // round-off error
    }
  }
}

TEST(Mesh_optimization, far_locations_depend_on_the_maximum_deviation)
{
  const Sampled_sphere s;
  const auto number_of_far = [&](double deviation)
  {
    Remeshing_options options;
    options.maximum_deviation = deviation / s.arrays.scale();
    Mesh_optimization optimization(s.surface, options);
    const Coarse_mesh mesh = optimization.build_mesh(s.cells, *s.sampling, s.triangles);
    return optimization.far_locations(s.cells, *s.sampling, mesh).size();
  };
  // The faces of an icosahedron in the unit sphere are at distance 0.795 from its center.
  EXPECT_EQ(number_of_far(0.1), 12u);
  EXPECT_EQ(number_of_far(0.21), 0u);
  EXPECT_EQ(number_of_far(infinity), 0u);
}

TEST(Mesh_optimization, samples_are_added_at_self_intersections_only)
{
  const Sampled_sphere s;
  const Remeshing_options options;
  Mesh_optimization optimization(s.surface, options);
  Remeshing candidate;
  candidate.triangles = s.triangles;
  for(Index i = 0; i < 12; ++i)
    candidate.points.push_back(s.arrays.point(i));
  EXPECT_TRUE(optimization.locations_at_intersections(s.cells, *s.sampling, candidate).empty());
  EXPECT_EQ(candidate.number_of_self_intersections, 0u);
  // A vertex that is moved through the opposite face.
  for(double& x : candidate.points[0])
    x *= -1.05;
  EXPECT_FALSE(optimization.locations_at_intersections(s.cells, *s.sampling, candidate).empty());
  EXPECT_GT(candidate.number_of_self_intersections, 0u);
}

} // namespace mesh_optimization_test
