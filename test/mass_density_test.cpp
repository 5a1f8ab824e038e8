// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/mass_density.h>

#include <CGAL/Geodesic_processing/internal/adaptors/masses.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

namespace mass_density_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(mass_density, is_read_at_each_vertex)
{
  Mesh mesh = mesh_of(square(3));
  const auto map = mesh.add_property_map<Vertex, double>("v:density", 0.).first;
  for(const Vertex v : mesh.vertices())
    map[v] = 10. + double(std::size_t(v));
  const auto domain = GP::make_domain(mesh);
  const GP::internal::Mass_distribution density =
      GP::internal::masses(domain, GP::mass_density(map));
  EXPECT_TRUE(density.at_locations.empty());
  EXPECT_EQ(density.at_vertices.size(), 0);
  ASSERT_EQ(density.density.size(), Eigen::Index(num_vertices(mesh)));
  for(GP::internal::Index i = 0; i < domain.number_of_vertices(); ++i)
    EXPECT_EQ(density.density[i], map[domain.vertex(i)]);
}

} // namespace mass_density_test
