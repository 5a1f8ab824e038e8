// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Geodesic_processing/exponential_map.h>

#include <CGAL/Geodesic_processing/logarithmic_map.h>

#include "Mesh_of.h"
#include "clouds.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <array>
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
  // If a shortest path bends at a saddle vertex, the straightest path leaves it. This affects 3 %
  // of the vertices of the animal and one vertex in eighty of the elephant.
  EXPECT_GT(fraction_recovered(mesh_of(animal()), Vertex(100), 0.5), 0.95);
  if(Mesh mesh; read_model("meshes/elephant_2k8.off", mesh))
  {
    // One vertex in eighty, see above.
    EXPECT_GT(fraction_recovered(mesh, Vertex(100), 0.1), 0.98);
  }
}

TEST(exponential_map, ends_at_boundary)
{
  const Mesh mesh = mesh_of(square(4));
  const auto image = GP::exponential_map(mesh, Vertex(6), {0., 10.},
                                         GP::parameters::up_direction(Vector_3(0., 1., 0.)));
  const auto p = CGAL::Polygon_mesh_processing::construct_point(image, mesh);
  // Round-off errors of a line across four triangles.
  EXPECT_NEAR(p.x(), mesh.point(Vertex(6)).x(), 1e-12);
  EXPECT_NEAR(p.y(), 1., 1e-12);
}

using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

TEST(exponential_map, inverts_logarithmic_map_on_cloud)
{
  const Cloud cloud = octahedron_sphere(5); // 4,098 surfels
  Point_set points(true);
  for(const auto& p : cloud.points)
    points.insert({p[0], p[1], p[2]}, {p[0], p[1], p[2]});
  const auto domain = GP::make_domain(points);
  using GP::internal::norm;
  using GP::internal::operator-;
  // A surfel, and a location next to it; the axes are given or not.
  const Point_set::Index surfel(100);
  const auto check = [&](const auto& base, const auto& np)
  {
    GP::Logarithmic_map<Point_set> map(domain);
    map.compute(base, np.maximum_distance(1.5));
    double sum = 0.;
    for(const Point_set::Index& reached : map.reached())
    {
      const double error =
          norm(to_array(domain.point(map.exponential(map(reached)))) - cloud.points[reached]);
      // The logarithmic map on the cloud has errors of up to 0.9 % of the distance. The tangent
      // planes are up to 0.002 above the sphere.
      EXPECT_LT(error, 0.01 * std::hypot(map(reached)[0], map(reached)[1]) + 0.002);
      sum += error;
    }
    EXPECT_LT(sum / double(map.reached().size()), 0.005); // measured: 0.0035
    // The function and the class give the same result.
    const std::array<double, 2> vector = {0.3, -0.7};
    const auto expected = map.exponential(vector);
    const auto image = GP::exponential_map(points, base, vector, np);
    EXPECT_EQ(image.surfel, expected.surfel);
    EXPECT_EQ(image.offset, expected.offset);
    // Vectors and points of the plane are accepted as well.
    EXPECT_EQ(map.exponential(Kernel::Vector_2(0.3, -0.7)).offset, expected.offset);
    EXPECT_EQ(GP::exponential_map(domain, base, Kernel::Point_2(0.3, -0.7), np).offset,
              expected.offset);
  };
  check(surfel, GP::parameters::up_direction(Vector_3(0.2, 1., 0.3)));
  check(surfel, GP::parameters::number_of_threads(1));
  check(GP::Location<Point_set>{surfel, {0.02, 0.01}},
        GP::parameters::up_direction(Vector_3(0.2, 1., 0.3)));
}

TEST(exponential_map, follows_axes_on_cloud)
{
  const Cloud cloud = octahedron_sphere(4);
  Point_set points(true);
  for(const auto& p : cloud.points)
    points.insert({p[0], p[1], p[2]}, {p[0], p[1], p[2]});
  const auto domain = GP::make_domain(points);
  // The second axis at (1, 0, 0) points to (0, 0, 1), and the first one to (0, 1, 0).
  const auto end = [&](double x, double y)
  {
    return to_array(domain.point(GP::exponential_map(
        domain, Point_set::Index(0), {x, y}, GP::parameters::up_direction(Vector_3(1., 0., 2.)))));
  };
  using GP::internal::norm;
  using GP::internal::operator-;
  // The endpoints are surfels, where the tangent plane touches the sphere. Round-off errors of some
  // hundred steps.
  const double round_off = 1e-12;
  EXPECT_LT(norm(end(CGAL_PI / 2., 0.) - GP::internal::Vec3{0., 1., 0.}), round_off);
  EXPECT_LT(norm(end(0., CGAL_PI / 2.) - GP::internal::Vec3{0., 0., 1.}), round_off);
  EXPECT_LT(norm(end(0., -CGAL_PI / 2.) - GP::internal::Vec3{0., 0., -1.}), round_off);
  EXPECT_LT(norm(end(0., 0.) - GP::internal::Vec3{1., 0., 0.}), round_off);
  EXPECT_THROW(end(std::nan(""), 0.), GP::Invalid_argument_error);
}

TEST(exponential_map, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(square(4));
  try
  {
    GP::exponential_map(mesh, Vertex(6), {std::nan(""), 0.});
    ADD_FAILURE();
  }
  catch(const GP::Invalid_argument_error& error)
  {
    EXPECT_STREQ(error.what(), "A tangent vector is not finite.");
  }
  EXPECT_THROW(GP::exponential_map(mesh, Vertex(6), {1., 0.},
                                   GP::parameters::up_direction(Vector_3(0., 0., 1.))),
               GP::Invalid_argument_error); // normal to the surface
}

} // namespace exponential_map_test
