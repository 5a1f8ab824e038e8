// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/distance_derivatives.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Array_surface.h"
#include "meshes.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace distance_derivatives_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of unit vectors, which are differences of coordinates of order one.
constexpr double round_off = 1e-13;

Distance_derivatives derivatives(const Array_surface& surface, const Surface_location& source,
                                 const Surface_location& target)
{
  return distance_derivatives(surface.triangles(), canonical(surface.t(), source),
                              canonical(surface.t(), target));
}

// A face and barycentric coordinates.
struct Face_point
{
  Index face;
  std::array<double, 3> barycentric;
};

Face_point random_point(std::size_t number_of_faces, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0., 1.);
  double a = unit(random), b = unit(random);
  if(a + b > 1.)
  {
    a = 1. - a;
    b = 1. - b;
  }
  return {Index(random() % number_of_faces), {1. - a - b, a, b}};
}

double exact_distance(const Triangulation& shape, const Face_point& source,
                      const Face_point& target)
{
  const Array_surface surface(shape);
  Window_propagation windows(surface.triangles());
  Front_limits limits;
  limits.targets = {surface.in(target.face, target.barycentric)};
  windows.run({surface.source(surface.in(source.face, source.barycentric))}, limits);
  return surface.scale() * windows.distance(limits.targets[0]);
}

double mean_edge_length(const Triangulation& shape)
{
  double sum = 0.;
  for(std::size_t h = 0; h < shape.corners.size(); ++h)
    sum += distance(shape.points[shape.corners[h]],
                    shape.points[shape.corners[h % 3 == 2 ? h - 2 : h + 1]]);
  return sum / double(shape.corners.size());
}

// A motion of all vertices and of both locations. Vertices move by +1 or -1 along each axis; then
// the square of the error of a derivative is, on average, that of the gradient. Locations move by
// the length of an edge of their faces, in units of `step`.
struct Motion
{
  Motion(const Triangulation& shape, std::mt19937& random) : vertices(shape.points.size())
  {
    for(Vec3& v : vertices)
      for(double& x : v)
        x = random() % 2 == 0 ? 1. : -1.;
    for(auto* b : {&source, &target})
    {
      const std::size_t k = random() % 3;
      (*b)[k] = 1.;
      (*b)[(k + 1) % 3] = -1.;
    }
  }

  double moved_distance(const Triangulation& shape, Face_point from, Face_point to,
                        double step) const
  {
    Triangulation moved = shape;
    const double length = mean_edge_length(shape);
    for(std::size_t v = 0; v < vertices.size(); ++v)
      moved.points[v] = moved.points[v] + (step * length) * vertices[v];
    for(int k = 0; k < 3; ++k)
    {
      from.barycentric[k] += step * source[k];
      to.barycentric[k] += step * target[k];
    }
    return exact_distance(moved, from, to);
  }

  std::vector<Vec3> vertices;
  Vec3 source = {0., 0., 0.}, target = {0., 0., 0.}; // barycentric
};

Vec3 vector_in_face(const Triangulation& shape, Index face, const Vec3& barycentric)
{
  Vec3 result = {0., 0., 0.};
  for(int k = 0; k < 3; ++k)
    result = result + barycentric[k] * shape.points[shape.corners[3 * face + k]];
  return result;
}

TEST(Distance_derivatives, agree_with_central_differences)
{
  std::vector<std::pair<std::string, Triangulation>> shapes = {
      {"sphere", jittered(icosphere(2), 0.02)},
      {"torus", jittered(torus(30, 12), 0.03)},
      {"animal", animal(2)},
      {"square", square(15, 0.24)},
      {"spool", spool(12)}};
  add_models(shapes, {"meshes/joint_221.off", "meshes/pig_468.off", "meshes/spool_649.off"});
  const int cases = 1000 / int(shapes.size());
  // Round-off errors of distances are about 1e-15, and truncation errors are squares of the ratio
  // of the step to a length of the path, which can be a hundredth of an edge.
  constexpr double step = 1e-6;
  int number_of_rejected = 0;
  for(const auto& [name, shape] : shapes)
  {
    SCOPED_TRACE(name);
    const Array_surface surface(shape);
    const double length = mean_edge_length(shape);
    std::mt19937 random(1);
    for(int i = 0; i < cases; ++i)
    {
      const Face_point source = random_point(shape.corners.size() / 3, random),
                       target = random_point(shape.corners.size() / 3, random);
      const Motion motion(shape, random);
      const Distance_derivatives d =
          derivatives(surface, surface.in(source.face, source.barycentric),
                      surface.in(target.face, target.barycentric));
      if(d.differentiability != Differentiability::differentiable)
      {
        ++number_of_rejected;
        continue;
      }
      double squared_norm =
          dot(d.source_gradient, d.source_gradient) + dot(d.target_gradient, d.target_gradient);
      double expected = dot(d.source_gradient, vector_in_face(shape, source.face, motion.source)) +
                        dot(d.target_gradient, vector_in_face(shape, target.face, motion.target));
      for(const auto& [vertex, gradient] : d.vertex_gradients)
      {
        squared_norm += dot(gradient, gradient);
        expected += length * dot(gradient, motion.vertices[surface.caller_vertex(vertex)]);
      }
      const double difference = motion.moved_distance(shape, source, target, step) -
                                motion.moved_distance(shape, source, target, -step);
      EXPECT_NEAR(difference / (2. * step), expected, 1e-6 * std::sqrt(squared_norm) * length)
          << "case " << i;
    }
  }
  EXPECT_LE(number_of_rejected, 1000 / 5);
}

TEST(Distance_derivatives, are_unit_vectors_and_weights_in_the_plane)
{
  const Triangulation shape = square(10, 0.2);
  const Array_surface surface(shape);
  std::mt19937 random(2);
  for(int i = 0; i < 20; ++i)
  {
    const Face_point source = random_point(200, random), target = random_point(200, random);
    const Surface_location s = surface.in(source.face, source.barycentric),
                           t = surface.in(target.face, target.barycentric);
    const Distance_derivatives d = derivatives(surface, s, t);
    const Vec3 away = unit(Vec3(point_at(surface.t(), s)) - Vec3(point_at(surface.t(), t)));
    EXPECT_LT(norm(d.source_gradient - away), round_off);
    EXPECT_LT(norm(d.target_gradient + away), round_off);
    std::map<Index, Vec3> expected;
    for(int k = 0; k < 3; ++k)
    {
      Vec3& at_source = expected[shape.corners[3 * source.face + k]];
      at_source = at_source + source.barycentric[k] * away;
      Vec3& at_target = expected[shape.corners[3 * target.face + k]];
      at_target = at_target - target.barycentric[k] * away;
    }
    for(const auto& [vertex, gradient] : d.vertex_gradients)
      EXPECT_LT(norm(gradient - expected[surface.caller_vertex(vertex)]), round_off);
  }
}

TEST(Distance_derivatives, are_those_of_the_helix_on_a_prism)
{
  const Array_surface surface(rings(
      16, 4, [](double) { return 1.; }, [](double s) { return 2. * s; }, 0.));
  const double width = 5. * 2. * std::sin(pi / 16.), height = 1.;
  const Distance_derivatives d = derivatives(surface, surface.at(16), surface.at(3 * 16 + 5));
  EXPECT_EQ(d.differentiability, Differentiability::differentiable);
  EXPECT_NEAR(surface.scale() * d.distance, std::hypot(width, height), round_off);
  EXPECT_NEAR(d.source_gradient[2], -height / std::hypot(width, height), round_off);
  EXPECT_NEAR(d.target_gradient[2], height / std::hypot(width, height), round_off);
  EXPECT_NEAR(norm(d.source_gradient), 1., round_off);
  EXPECT_NEAR(norm(d.target_gradient), 1., round_off);
}

TEST(Distance_derivatives, bend_at_a_saddle)
{
  const Array_surface surface(cone(12, 3, 3. * pi));
  const Distance_derivatives d = derivatives(surface, surface.at(1), surface.at(1 + 6));
  EXPECT_EQ(d.differentiability, Differentiability::differentiable);
  EXPECT_NEAR(surface.scale() * d.distance, 2., round_off);
  const Vec3 to_source = unit(surface.point(1)), to_target = unit(surface.point(1 + 6));
  std::map<Index, Vec3> gradients;
  for(const auto& [vertex, gradient] : d.vertex_gradients)
    gradients[surface.caller_vertex(vertex)] = gradient;
  EXPECT_LT(norm(gradients[0] + to_source + to_target), round_off);
  EXPECT_LT(norm(gradients[1] - to_source), round_off);
  EXPECT_LT(norm(gradients[1 + 6] - to_target), round_off);
}

TEST(Distance_derivatives, are_rejected_by_each_rule)
{
  const Array_surface sphere(icosphere(2)), flat(square(4)), saddle(cone(12, 3, 2.5 * pi)),
      pair(disjoint_union(tetrahedron(), tetrahedron()));
  Index antipode = 0;
  for(Index i = 0; i < sphere.size(); ++i)
    if(distance(sphere.point(i), sphere.point(0)) >
       distance(sphere.point(antipode), sphere.point(0)))
      antipode = i;
  EXPECT_EQ(derivatives(sphere, sphere.at(0), sphere.at(antipode)).differentiability,
            Differentiability::second_path);
  EXPECT_EQ(derivatives(sphere, sphere.at(7), sphere.at(7)).differentiability,
            Differentiability::coincident);
  EXPECT_EQ(derivatives(pair, pair.at(0), pair.at(4)).differentiability,
            Differentiability::unreachable);
  // Along a diagonal, through vertices.
  EXPECT_EQ(derivatives(flat, flat.at(0), flat.at(24)).differentiability,
            Differentiability::near_vertex);
  // Along an edge to the center, where one side has five of twelve angles of 2.5 pi / 12: more than
  // pi. Then along an edge.
  EXPECT_EQ(derivatives(saddle, saddle.at(1), saddle.at(1 + 5)).differentiability,
            Differentiability::differentiable);
}

TEST(Distance_derivatives, tolerances_decide_rejection)
{
  // On a cone of 1.5 pi, the angles on both sides of the apex are 0.75 pi plus and minus a step.
  const Array_surface surface(cone(12, 3, 1.5 * pi));
  const double shorter = std::sqrt(2. - 2. * std::cos(1.5 * pi * 5. / 12.)),
               longer = std::sqrt(2. - 2. * std::cos(1.5 * pi * 7. / 12.));
  const auto differentiability = [&](const Derivative_tolerances& tolerances)
  {
    return distance_derivatives(surface.triangles(), canonical(surface.t(), surface.at(1)),
                                canonical(surface.t(), surface.at(6)), tolerances)
        .differentiability;
  };
  EXPECT_EQ(differentiability({1e-4, longer / shorter - 1. - 1e-9}),
            Differentiability::differentiable);
  EXPECT_EQ(differentiability({1e-4, longer / shorter - 1. + 1e-9}),
            Differentiability::second_path);
  EXPECT_EQ(differentiability({0.5, 1e-6}), Differentiability::near_vertex);
}

} // namespace distance_derivatives_test
