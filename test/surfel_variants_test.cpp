// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/surfel_variants.h>

#include <CGAL/Geodesic_processing/surfel_geodesic_path.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

namespace surfel_variants_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Checks that a variant can be selected and finds a path.
template <typename Parameters>
void expect_a_path(const Parameters& parameters)
{
  const Surfels surfels = sphere_surfels(2);
  const auto path = GP::surfel_geodesic_path(
      surfels, std::size_t(0), std::size_t(100),
      parameters.point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  const double chord = std::sqrt(CGAL::squared_distance(surfels[0].first, surfels[100].first));
  EXPECT_GT(path.front_distance, chord);
  EXPECT_LT(path.front_distance, 3.2); // slightly more than half of the circumference
}

TEST(surfel_variants, every_variant_finds_path)
{
  for(const auto graph : {GP::Surfel_graph::extended_spheres, GP::Surfel_graph::nearest})
    expect_a_path(GP::parameters::surfel_graph(graph));
  for(const auto noise :
      {GP::Surfel_noise::removed_when_found, GP::Surfel_noise::removed, GP::Surfel_noise::kept})
    expect_a_path(GP::parameters::surfel_noise(noise));
}

} // namespace surfel_variants_test
