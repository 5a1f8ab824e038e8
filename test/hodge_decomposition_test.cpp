// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/hodge_decomposition.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include "Mesh_of.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
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

// The potentials of a field: of its gradient at vertices, and of its rotation at edges and
// vertices.
template <typename M>
struct Potentials
{
  std::vector<double> gradient, vertex_rotation; // in the order of the vertices
  std::map<typename boost::graph_traits<M>::edge_descriptor, double> rotation;
};

template <typename M, typename F>
Potentials<M> potentials_of(M& mesh, const F& field)
{
  const auto vector_map = [&] { return get(CGAL::dynamic_face_property_t<Vector_3>(), mesh); };
  const auto vertex_map = [&] { return get(CGAL::dynamic_vertex_property_t<double>(), mesh); };
  auto input = vector_map(), gradient = vector_map(), rotation = vector_map(),
       harmonic = vector_map();
  auto f = vertex_map(), g = vertex_map();
  for(const auto face : faces(mesh))
  {
    const auto h = halfedge(face, mesh);
    put(input, face,
        field(CGAL::centroid(get(CGAL::vertex_point, mesh, source(h, mesh)),
                             get(CGAL::vertex_point, mesh, target(h, mesh)),
                             get(CGAL::vertex_point, mesh, target(next(h, mesh), mesh)))));
  }
  Potentials<M> result;
  GP::hodge_decomposition(
      mesh, input, gradient, rotation, harmonic,
      GP::parameters::gradient_potential_map(f)
          .rotation_potential_map(boost::make_assoc_property_map(result.rotation))
          .vertex_rotation_potential_map(g));
  for(const auto v : vertices(mesh))
  {
    result.gradient.push_back(get(f, v));
    result.vertex_rotation.push_back(get(g, v));
  }
  return result;
}

// Returns the gradient of a function that is linear in a face, from its values at the corners. The
// first corner is the source of the face's halfedge.
Vector_3 gradient_in(const Decomposition& d, Face face, const std::array<double, 3>& value)
{
  const Vector_3 normal = d.normal(face);
  Vector_3 result(0., 0., 0.);
  auto h = d.mesh.halfedge(face);
  for(std::size_t k = 0; k < 3; ++k, h = d.mesh.next(h))
  {
    const auto opposite = d.mesh.next(h);
    result += value[k] * CGAL::cross_product(normal, d.mesh.point(d.mesh.target(opposite)) -
                                                         d.mesh.point(d.mesh.source(opposite)));
  }
  return result / normal.squared_length();
}

// Checks that the components are the gradients of the potentials, in the unit of the coordinates,
// with boundary and with several components.
TEST(hodge_decomposition, components_are_gradients_of_potentials)
{
  for(const Triangulation& shape :
      {jittered(icosphere(2), 0.02), square(8, 0.2), annulus(16, 4, 0.5, 1.), torus(12, 8),
       disjoint_union(torus(12, 8), square(6, 0.2))})
    for(const double scale : {1e-6, 1., 1e6})
    {
      Decomposition d(scaled(shape, scale));
      for(const Face f : d.mesh.faces())
      {
        const auto c = d.center(f);
        d.field[f] = Vector_3(std::sin(3. * c.y() / scale), c.x() / scale - 0.3,
                              std::cos(2. * c.x() / scale + c.z() / scale));
      }
      const auto f = d.mesh.add_property_map<Vertex, double>("v:f", 7.).first,
                 g = d.mesh.add_property_map<Vertex, double>("v:g", 7.).first;
      const auto edge_g = d.mesh.add_property_map<Mesh::Edge_index, double>("e:g", 7.).first;
      GP::hodge_decomposition(d.mesh, d.field, d.gradient, d.rotation, d.harmonic,
                              GP::parameters::gradient_potential_map(f)
                                  .rotation_potential_map(edge_g)
                                  .vertex_rotation_potential_map(g));
      double product = 0., squared_norm = 0.;
      for(const Face face : d.mesh.faces())
      {
        std::array<double, 3> at_corner{}, at_edge{}, vertex_g{};
        auto h = d.mesh.halfedge(face);
        for(std::size_t k = 0; k < 3; ++k, h = d.mesh.next(h))
        {
          at_corner[k] = f[d.mesh.source(h)];
          vertex_g[k] = g[d.mesh.source(h)];
          at_edge[k] = edge_g[d.mesh.edge(h)];
        }
        // At a corner: both edges there minus the third one.
        const double sum = at_edge[0] + at_edge[1] + at_edge[2];
        const std::array<double, 3> edge_corner = {sum - 2. * at_edge[1], sum - 2. * at_edge[2],
                                                   sum - 2. * at_edge[0]};
        const Vector_3 normal = d.normal(face) / std::sqrt(d.normal(face).squared_length());
        const double residuals[] = {
            (gradient_in(d, face, at_corner) - d.gradient[face]).squared_length(),
            (CGAL::cross_product(normal, gradient_in(d, face, edge_corner)) - d.rotation[face])
                .squared_length()};
        for(const double residual : residuals)
          EXPECT_LT(std::sqrt(residual), round_off);
        // The rotated gradient of the vertex function is a projection of the rotation.
        const Vector_3 conforming = CGAL::cross_product(normal, gradient_in(d, face, vertex_g));
        const double area = std::sqrt(d.normal(face).squared_length()) / (scale * scale);
        product += area * (conforming * (d.rotation[face] - conforming));
        squared_norm += area * conforming.squared_length();
      }
      EXPECT_NEAR(product, 0., round_off);
      EXPECT_GT(squared_norm, 1e-3);
      for(const auto e : d.mesh.edges())
        if(d.mesh.is_border(e))
        {
          EXPECT_EQ(edge_g[e], 0.);
          EXPECT_EQ(g[d.mesh.vertex(e, 0)], 0.);
        }
    }
}

// On the unit sphere, the upward field is the gradient of z, and the field around the axis is the
// gradient of z, rotated to the left.
template <typename M>
void expect_height_potentials(M mesh)
{
  const auto upward =
      potentials_of(mesh, [](const Kernel::Point_3&) { return Vector_3(0., 0., 1.); });
  const auto around =
      potentials_of(mesh, [](const Kernel::Point_3& p) { return Vector_3(p.y(), -p.x(), 0.); });
  // Rotations are computed from vectors at centers of flat faces, with an error of second order in
  // the edge length of 0.16. Measured: 0.0041, for vertex functions 0.0047.
  constexpr double tolerance = 0.16 * 0.16 / 3.;
  std::size_t i = 0;
  for(const auto v : vertices(mesh))
  {
    const double z = get(CGAL::vertex_point, mesh, v).z();
    EXPECT_NEAR(upward.gradient[i], z, round_off); // linear in each face
    EXPECT_NEAR(upward.vertex_rotation[i], 0., round_off);
    EXPECT_NEAR(around.vertex_rotation[i], z, tolerance);
    ++i;
  }
  for(const auto& [e, value] : around.rotation)
  {
    const auto h = halfedge(e, mesh);
    EXPECT_NEAR(value,
                0.5 * (get(CGAL::vertex_point, mesh, source(h, mesh)).z() +
                       get(CGAL::vertex_point, mesh, target(h, mesh)).z()),
                tolerance);
  }
  EXPECT_EQ(around.rotation.size(), num_faces(mesh) * 3 / 2);
  for(const auto& [e, value] : upward.rotation)
    EXPECT_NEAR(value, 0., round_off);
}

TEST(hodge_decomposition, potentials_on_sphere_are_the_height)
{
  expect_height_potentials(mesh_of(icosphere(3)));
  CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> polyhedron;
  CGAL::copy_face_graph(mesh_of(icosphere(3)), polyhedron);
  CGAL::set_halfedgeds_items_id(polyhedron);
  expect_height_potentials(polyhedron);
}

// On a flat square, a constant field is the gradient of a linear function, which is reproduced. A
// function that vanishes on the boundary is the potential of its rotated gradient.
TEST(hodge_decomposition, potentials_on_square_have_closed_forms)
{
  for(const std::size_t n : {20u, 40u})
  {
    Mesh mesh = mesh_of(square(n, 0.2));
    const auto constant =
        potentials_of(mesh, [](const Kernel::Point_3&) { return Vector_3(2., -3., 0.); });
    const auto vortex = potentials_of(mesh,
                                      [](const Kernel::Point_3& p)
                                      {
                                        const double x = p.x(), y = p.y();
                                        return Vector_3(-x * (1. - x) * (1. - 2. * y),
                                                        (1. - 2. * x) * y * (1. - y), 0.);
                                      });
    double max_error = 0., max_vertex_error = 0.;
    for(const Vertex v : mesh.vertices())
    {
      const double x = mesh.point(v).x(), y = mesh.point(v).y();
      EXPECT_NEAR(constant.gradient[v], 2. * (x - 0.5) - 3. * (y - 0.5), round_off);
      max_vertex_error = std::max(
          max_vertex_error, std::abs(vortex.vertex_rotation[v] - x * (1. - x) * y * (1. - y)));
    }
    for(const auto& [e, value] : vortex.rotation)
    {
      const Kernel::Point_3 p =
          CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
      max_error =
          std::max(max_error, std::abs(value - p.x() * (1. - p.x()) * p.y() * (1. - p.y())));
    }
    // Second order with the edge length 1/n. Measured: 0.11 and 0.13 squared edge lengths.
    EXPECT_LT(max_error, 0.2 / double(n * n));
    EXPECT_LT(max_vertex_error, 0.2 / double(n * n));
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

// The upward field on a sphere is the gradient of z. Surfels without triangles have no potential.
TEST(hodge_decomposition, writes_gradient_potential_on_clouds)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Cloud cloud = ellipsoid_cloud(1000, {1., 1., 1.});
    cloud.add({5., 5., 5.}, {0., 0., 1.});
    const Point_set points = point_set_of(cloud, scale);
    std::vector<Vector_3> gradient(cloud.size()), remainder(cloud.size());
    std::vector<double> potential(cloud.size(), 7.);
    const auto map = [](auto& values)
    {
      return boost::make_function_property_map<std::size_t>([&values](std::size_t i) -> auto& {
        return values[i];
      });
    };
    const auto upward = boost::make_function_property_map<std::size_t>(
        [](std::size_t) { return Vector_3(0., 0., 1.); });
    GP::hodge_decomposition(points, upward, map(gradient), map(remainder),
                            GP::parameters::gradient_potential_map(map(potential)));
    for(std::size_t i = 0; i + 1 < cloud.size(); ++i)
      // Edges have a length of 0.12, and the error is of second order. Measured: 0.0035.
      EXPECT_NEAR(potential[i], scale * cloud.points[i][2], 0.0144 / 2. * scale);
    EXPECT_EQ(potential.back(), 0.);
  }
}

} // namespace hodge_decomposition_test
