// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/hodge_decomposition.h>

#include <CGAL/Point_set_3.h>

#include <boost/property_map/function_property_map.hpp>

#include "Mesh_of.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace hodge_decomposition_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;

// Round-off errors of some hundred sums.
constexpr double round_off = 1e-9;

struct Decomposition
{
  Mesh mesh;
  Mesh::Property_map<Face, Vector_3> field, gradient, rotation, harmonic;

  explicit Decomposition(const Triangulation& shape) : mesh(mesh_of(shape))
  {
    const auto add = [&](const char* name)
    { return mesh.add_property_map<Face, Vector_3>(name, Vector_3(0., 0., 0.)).first; };
    field = add("f:field");
    gradient = add("f:gradient");
    rotation = add("f:rotation");
    harmonic = add("f:harmonic");
  }
  Vector_3 normal(Face f) const // length is twice the area
  {
    const auto h = mesh.halfedge(f);
    const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
               &r = mesh.point(mesh.target(mesh.next(h)));
    return CGAL::cross_product(q - p, r - p);
  }
  Kernel::Point_3 center(Face f) const
  {
    const auto h = mesh.halfedge(f);
    return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                          mesh.point(mesh.target(mesh.next(h))));
  }
  void decompose() { GP::hodge_decomposition(mesh, field, gradient, rotation, harmonic); }
  template <typename A, typename B>
  double product(const A& a, const B& b) const
  {
    double result = 0.;
    for(const Face f : mesh.faces())
      result += 0.5 * std::sqrt(normal(f).squared_length()) * (a[f] * b[f]);
    return result;
  }
  double size(const Mesh::Property_map<Face, Vector_3>& a) const
  {
    return std::sqrt(product(a, a));
  }
};

// On a sphere, the upward field is a gradient and the field around the axis is a rotation.
TEST(hodge_decomposition, separates_gradients_and_rotations)
{
  Decomposition upward(icosphere(3)), rotating(icosphere(3));
  for(const Face f : upward.mesh.faces())
  {
    upward.field[f] = Vector_3(0., 0., 1.); // the normal component is not part of the field
    const auto c = upward.center(f);
    rotating.field[f] = Vector_3(-c.y(), c.x(), 0.);
  }
  upward.decompose();
  EXPECT_LT(upward.size(upward.rotation), round_off);
  EXPECT_LT(upward.size(upward.harmonic), round_off);
  EXPECT_NEAR(upward.product(upward.gradient, upward.field),
              upward.product(upward.gradient, upward.gradient), round_off);
  EXPECT_NEAR(upward.size(upward.gradient), std::sqrt(8. * GP::internal::pi / 3.),
              0.05); // faces are flat
  rotating.decompose();
  // The field at a face center differs from that of the sphere by O(h^2), with edge length
  // h = 0.16.
  EXPECT_LT(rotating.size(rotating.gradient), 0.03 * rotating.size(rotating.field));
  EXPECT_LT(rotating.size(rotating.harmonic), round_off);
}

// A field around a torus has no divergence. On an open ring there are harmonic fields as well.
TEST(hodge_decomposition, finds_harmonic_fields)
{
  for(const Triangulation& shape :
      {torus(32, 16), cylinder(24, 8, 1., 1.), annulus(24, 6, 0.5, 1.)})
  {
    Decomposition decomposition(shape);
    for(const Face f : decomposition.mesh.faces())
    {
      const auto c = decomposition.center(f);
      const double squared_radius = c.x() * c.x() + c.y() * c.y();
      decomposition.field[f] = Vector_3(-c.y() / squared_radius, c.x() / squared_radius, 0.);
    }
    decomposition.decompose();
    // Faces span a twentieth of a turn.
    EXPECT_GT(decomposition.size(decomposition.harmonic),
              0.99 * decomposition.size(decomposition.field));
    EXPECT_LT(std::abs(decomposition.product(decomposition.gradient, decomposition.harmonic)),
              round_off);
    EXPECT_LT(std::abs(decomposition.product(decomposition.gradient, decomposition.rotation)),
              round_off);
    EXPECT_LT(std::abs(decomposition.product(decomposition.rotation, decomposition.harmonic)),
              round_off);
    for(const Face f : decomposition.mesh.faces())
    {
      const Vector_3 n =
          decomposition.normal(f) / std::sqrt(decomposition.normal(f).squared_length());
      const Vector_3 tangent = decomposition.field[f] - (decomposition.field[f] * n) * n;
      const Vector_3 residual = tangent - decomposition.gradient[f] - decomposition.rotation[f] -
                                decomposition.harmonic[f];
      EXPECT_LT(residual.squared_length(), round_off * round_off);
    }
  }
}

TEST(hodge_decomposition, throws_on_non_finite_field)
{
  Decomposition decomposition(icosphere(1));
  decomposition.field[Face(7)] = Vector_3(std::nan(""), 0., 0.);
  EXPECT_THROW(decomposition.decompose(), GP::Invalid_argument_error);
}

using Point_set = CGAL::Point_set_3<Kernel::Point_3, Vector_3>;
// A vector at a point with a unit normal, of which the tangential component counts.
using Cloud_field = std::function<Vec3(const Vec3& point, const Vec3& normal)>;

Point_set point_set_of(const Cloud& cloud, double scale = 1.)
{
  Point_set result(true);
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Vec3 p = scale * cloud.points[i], &n = cloud.normals[i];
    result.insert(Kernel::Point_3(p[0], p[1], p[2]), Vector_3(n[0], n[1], n[2]));
  }
  return result;
}

Cloud random_sphere(std::size_t n)
{
  std::mt19937 random(3);
  std::normal_distribution<double> coordinate;
  Cloud result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vec3 p = GP::internal::unit({coordinate(random), coordinate(random), coordinate(random)});
    result.add(p, p);
  }
  return result;
}

// Root mean squares of the components, relative to that of the field, and their largest residual:
// the difference of their sum from the tangential field, and their normal components.
struct Cloud_components
{
  double gradient, remainder, residual;
};

template <typename Surface>
Cloud_components components_of(const Surface& surface, const Cloud& cloud, const Cloud_field& field)
{
  const std::size_t n = cloud.size();
  std::vector<Vector_3> input, tangent, gradient(n), remainder(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vec3 v = field(cloud.points[i], cloud.normals[i]);
    const Vector_3 normal(cloud.normals[i][0], cloud.normals[i][1], cloud.normals[i][2]);
    input.emplace_back(v[0], v[1], v[2]);
    tangent.push_back(input[i] - (input[i] * normal) * normal);
  }
  const auto map = [](std::vector<Vector_3>& vectors)
  {
    return boost::make_function_property_map<std::size_t>([&vectors](std::size_t i) -> Vector_3&
                                                          { return vectors[i]; });
  };
  GP::hodge_decomposition(surface, map(input), map(gradient), map(remainder));
  Cloud_components result = {0., 0., 0.};
  double squared_size = 0.;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vector_3 normal(cloud.normals[i][0], cloud.normals[i][1], cloud.normals[i][2]);
    result.gradient += gradient[i].squared_length();
    result.remainder += remainder[i].squared_length();
    squared_size += tangent[i].squared_length();
    const Vector_3 residual = gradient[i] + remainder[i] - tangent[i];
    result.residual = std::max({result.residual, std::sqrt(residual.squared_length()),
                                std::abs(gradient[i] * normal), std::abs(remainder[i] * normal)});
  }
  result.gradient = std::sqrt(result.gradient / squared_size);
  result.remainder = std::sqrt(result.remainder / squared_size);
  return result;
}

// The gradient of the function x y + 3/4 z^2, a spherical harmonic of degree two plus a constant on
// the unit sphere.
Vec3 quadratic_gradient(const Vec3& p, const Vec3&) { return {p[1], p[0], 1.5 * p[2]}; }

Vec3 rotated_gradient(const Vec3& p, const Vec3& n)
{
  return GP::internal::cross(n, quadratic_gradient(p, n));
}

// The two harmonic fields of a torus around the z-axis, up to constants: around the axis and
// around the tube.
Vec3 around_axis(const Vec3& p, const Vec3&)
{
  const double squared_radius = p[0] * p[0] + p[1] * p[1];
  return {-p[1] / squared_radius, p[0] / squared_radius, 0.};
}
Vec3 around_tube(const Vec3& p, const Vec3& n) { return GP::internal::cross(n, around_axis(p, n)); }

// The gradient of a surfel is a mean over triangles, with an error of first order on random
// surfels. The limits are 1.3 times the errors measured with 1,000 surfels. With 4,000 surfels,
// edges are half as long. The factors of the steps allow for a rate below one.
TEST(hodge_decomposition, separates_gradients_on_clouds)
{
  struct Case
  {
    std::function<Cloud(std::size_t)> cloud;
    double remainder; // of a gradient field
    double gradient;  // of other fields
    bool is_torus;
  };
  const std::vector<Case> cases = {
      {[](std::size_t n) {
         return ellipsoid_cloud(n, {1., 1., 1.});
       },
       0.03, 0.011, false},
      {random_sphere, 0.13, 0.021, false},
      {[](std::size_t n) { return torus_cloud(n, 0.4); }, 0.056, 0.031, true}};
  for(const Case& c : cases)
    for(const double density : {1., 4.})
    {
      const Cloud cloud = c.cloud(std::size_t(1000. * density));
      const auto domain = GP::make_domain(point_set_of(cloud));
      const double step = 1. / std::sqrt(density);
      const Cloud_components of_gradient = components_of(domain, cloud, quadratic_gradient);
      EXPECT_LT(of_gradient.remainder, 1.1 * step * c.remainder);
      EXPECT_NEAR(of_gradient.gradient, 1., 1.1 * step * c.remainder);
      // Surfels of a torus in rows are aligned at 1,000 surfels by chance, hence no rate there.
      std::vector<Cloud_field> without_gradient = {rotated_gradient};
      if(c.is_torus)
        without_gradient.insert(without_gradient.end(), {around_axis, around_tube});
      for(const Cloud_field& field : without_gradient)
      {
        const Cloud_components components = components_of(domain, cloud, field);
        EXPECT_LT(components.gradient, (c.is_torus ? 1. : 1.3 * step) * c.gradient);
        // The components are orthogonal up to the error of the gradients. Measured: 0.0011.
        EXPECT_NEAR(components.remainder, 1., 0.003);
        EXPECT_LT(components.residual, round_off);
      }
    }
}

// The decomposition is linear, does not depend on the normal component and the scale, and is the
// same for a point set and its domain.
TEST(hodge_decomposition, is_linear_and_scale_invariant_on_clouds)
{
  const Cloud cloud = torus_cloud(1000, 0.4);
  const auto mixture = [](const Vec3& p, const Vec3& n)
  { return quadratic_gradient(p, n) + 2. * around_axis(p, n) + 3. * n; };
  // Relative size of the gradient: the fields are orthogonal, up to the errors above.
  double squared_gradient = 0., squared_size = 0.;
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Vec3 &p = cloud.points[i], &n = cloud.normals[i];
    const Vec3 g = quadratic_gradient(p, n), h = 2. * around_axis(p, n);
    const double gradient = GP::internal::dot(g, g) - std::pow(GP::internal::dot(g, n), 2);
    squared_gradient += gradient;
    squared_size += gradient + GP::internal::dot(h, h);
  }
  const Cloud_components expected = components_of(point_set_of(cloud), cloud, mixture);
  // The errors are those of the torus above. Measured: 0.012.
  EXPECT_NEAR(expected.gradient, std::sqrt(squared_gradient / squared_size), 0.03);
  EXPECT_LT(expected.residual, round_off);
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Cloud_components components =
        components_of(GP::make_domain(point_set_of(cloud, scale)), cloud, mixture);
    EXPECT_NEAR(components.gradient, expected.gradient, round_off);
    EXPECT_NEAR(components.remainder, expected.remainder, round_off);
  }
}

TEST(hodge_decomposition, throws_on_non_finite_field_of_cloud)
{
  const Cloud cloud = square_cloud(5);
  for(const double bad : {std::nan(""), GP::internal::infinity})
    EXPECT_THROW(components_of(point_set_of(cloud), cloud,
                               [&](const Vec3& p, const Vec3&) {
                                 return Vec3{0., p[0] == 1. ? bad : 0., 0.};
                               }),
                 GP::Invalid_argument_error);
}

// Named parameters and the fifth map of a mesh are told apart by their types.
TEST(hodge_decomposition, reads_named_parameters_of_clouds)
{
  const Surfels surfels = sphere_surfels(2);
  std::vector<Vector_3> gradient(surfels.size()), remainder(surfels.size());
  const auto map = [](std::vector<Vector_3>& vectors)
  {
    return boost::make_function_property_map<std::size_t>([&vectors](std::size_t i) -> Vector_3&
                                                          { return vectors[i]; });
  };
  const auto upward = boost::make_function_property_map<std::size_t>(
      [](std::size_t) { return Vector_3(0., 0., 1.); });
  GP::hodge_decomposition(
      surfels, upward, map(gradient), map(remainder),
      GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    const Vector_3 normal = surfels[i].second;
    const Vector_3 tangent = Vector_3(0., 0., 1.) - normal.z() * normal;
    // The remainder has the error of a mean over triangles with edges of length 0.3.
    EXPECT_LT(std::sqrt((gradient[i] - tangent).squared_length()), 0.1);
    EXPECT_LT(std::sqrt((gradient[i] + remainder[i] - tangent).squared_length()), round_off);
  }
}

} // namespace hodge_decomposition_test
