// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/volumetric_distance.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

namespace volumetric_distance_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(volumetric_distance, agrees_with_metric)
{
  const Mesh mesh = mesh_of(icosphere(2));
  const Kernel::Point_3 from(0.1, 0.3, -0.2), to(1., 2., 0.);
  const GP::Volumetric_metric<Mesh> metric(mesh, GP::parameters::number_of_refinements(0u));
  const GP::Earth_movers_cost cost = GP::volumetric_distance(
      mesh, from, to, GP::parameters::number_of_refinements(0u).tolerance(1e-4));
  EXPECT_EQ(cost.value, metric.distance(from, to, GP::parameters::tolerance(1e-4)));
  EXPECT_EQ(GP::volumetric_distance(GP::make_domain(mesh), from, to).value,
            GP::volumetric_distance(mesh, from, to).value);
}

} // namespace volumetric_distance_test
