// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Geodesic_processing/exponential_map.h>

#include <CGAL/Geodesic_processing/logarithmic_map.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace exponential_map_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;

TEST(exponential_map, inverts_logarithmic_map)
{
  // Returns the fraction of vertices that the exponential of their logarithm recovers. Round-off
  // errors grow with the number of faces on the path.
  const auto fraction_recovered = [](const Mesh& mesh, Vertex base, double radius)
  {
    std::size_t number = 0;
    GP::Logarithmic_map<Mesh, GP::Exact> map(mesh);
    const auto np = GP::parameters::up_direction(Vector_3(0.2, 1., 0.3));
    map.compute(base, np.maximum_distance(radius));
    for(const Vertex v : map.reached())
    {
      const auto image = GP::exponential_map(map.domain(), base, map(v), np);
      const auto p = CGAL::Polygon_mesh_processing::construct_point(image, mesh);
      number += std::sqrt(CGAL::squared_distance(p, mesh.point(v))) < 1e-9 * radius;
    }
    return double(number) / double(map.reached().size());
  };
  EXPECT_EQ(fraction_recovered(mesh_of(icosphere(4)), Vertex(7), 1.5), 1.);
  EXPECT_EQ(fraction_recovered(mesh_of(square(20, 0.25)), Vertex(220), 0.7), 1.);
  if(Mesh mesh; read_model("meshes/elephant_2k8.off", mesh))
  {
    // If a shortest path bends at a saddle vertex, the straightest path leaves it. This affects
    // one vertex in eighty.
    EXPECT_GT(fraction_recovered(mesh, Vertex(100), 0.1), 0.95);
  }
}

TEST(exponential_map, ends_at_boundary)
{
  const Mesh mesh = mesh_of(square(4));
  const auto image = GP::exponential_map(mesh, Vertex(6), {0., 10.},
                                         GP::parameters::up_direction(Vector_3(0., 1., 0.)));
  const auto p = CGAL::Polygon_mesh_processing::construct_point(image, mesh);
  EXPECT_NEAR(p.x(), mesh.point(Vertex(6)).x(), 1e-12);
  EXPECT_NEAR(p.y(), 1., 1e-12);
}

TEST(exponential_map, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(square(4));
  EXPECT_THROW(GP::exponential_map(mesh, Vertex(6), {std::nan(""), 0.}),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::exponential_map(mesh, Vertex(6), {1., 0.},
                                   GP::parameters::up_direction(Vector_3(0., 0., 1.))),
               GP::Invalid_argument_error); // normal to the surface
}

} // namespace exponential_map_test
