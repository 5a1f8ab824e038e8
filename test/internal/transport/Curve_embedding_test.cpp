// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Curve_embedding.h>

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include "core/unfold.h"

#include "Array_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace Curve_embedding_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums of some hundred numbers.
constexpr double round_off = 1e-11;

using Curves = std::vector<std::vector<Surface_location>>;

// Returns the zero level set of a linear function: one segment for each triangle that it crosses.
template <typename Function>
Curves zero_level_curves(const Array_surface& surface, const Function& function)
{
  Curves result;
  const Surface_arrays& t = surface.t();
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    std::vector<Surface_location> segment;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const double a = function(surface.point(surface.caller_vertex(t.corner[h]))),
                   b = function(surface.point(surface.caller_vertex(t.corner[next_halfedge(h)])));
      if(a * b < 0.)
        segment.push_back({f, none, barycentric_on_halfedge(h, a / (a - b))});
    }
    if(segment.size() == 2)
      result.push_back(segment);
  }
  return result;
}

Curves height_level_curves(const Array_surface& surface, double height)
{
  return zero_level_curves(surface, [height](const Point& p) { return p[2] - height; });
}

// Returns polylines of three random points in random triangles. They cross each other.
Curves random_curves(const Array_surface& surface, unsigned number)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0., 1.);
  std::uniform_int_distribution<Index> random_triangle(
      0, Index(surface.t().number_of_triangles() / 4));
  Curves result;
  for(unsigned i = 0; i < number; ++i)
  {
    const Index f = random_triangle(random);
    std::vector<Surface_location> segment;
    for(int j = 0; j < 3; ++j)
    {
      std::array<double, 3> b = {coordinate(random), coordinate(random), coordinate(random)};
      if(i % 3 == 0 && j == 1)
        b[i % 2] = 0.;
      const double sum = b[0] + b[1] + b[2];
      segment.push_back({f, none, {b[0] / sum, b[1] / sum, b[2] / sum}});
    }
    result.push_back(segment);
  }
  return result;
}

double curve_length(const Surface_arrays& t, const Curves& curves)
{
  double result = 0.;
  for(const auto& curve : curves)
    for(std::size_t i = 1; i < curve.size(); ++i)
      result += distance_in_triangle(t, curve[i].triangle, curve[i - 1].barycentric,
                                     curve[i].barycentric);
  return result;
}

// Returns the total length of all edges with both ends on curves.
double length_along_curves(const Curve_embedding& embedding)
{
  const Surface_arrays& t = *embedding.triangles();
  std::vector<bool> is_on_curve(t.number_of_vertices(), false);
  for(const std::vector<Index>& vertices : embedding.vertices())
    for(const Index vertex : vertices)
      is_on_curve[vertex] = true;
  double result = 0.;
  for(Index h = 0; h < t.corner.size(); ++h)
    if((t.twin[h] == none || h < t.twin[h]) && is_on_curve[t.corner[h]] &&
       is_on_curve[t.corner[next_halfedge(h)]])
      result += t.length[h];
  return result;
}

void expect_valid_twins(const Surface_arrays& t)
{
  std::vector<Index> count(t.number_of_vertices(), 0);
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    ++count[t.corner[h]];
    if(const Index twin = t.twin[h]; twin != none)
    {
      ASSERT_EQ(t.twin[twin], h);
      EXPECT_EQ(t.corner[h], t.corner[next_halfedge(twin)]);
      EXPECT_EQ(t.length[h], t.length[twin]);
    }
  }
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    EXPECT_EQ(t.ring_begin[vertex + 1] - t.ring_begin[vertex], count[vertex]);
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      EXPECT_EQ(t.corner[t.ring[i]], vertex);
    }
  }
}

double total_area(const Surface_arrays& t)
{
  const std::vector<double> triangle_areas = operators(t).area;
  return std::accumulate(triangle_areas.begin(), triangle_areas.end(), 0.);
}

TEST(Curve_embedding, preserves_area_and_distances)
{
  for(const Triangulation& shape :
      {jittered(icosphere(2), 0.05), square(6, 0.24), cylinder(8, 3, 1., 2.), one_triangle()})
  {
    const Array_surface surface(shape);
    for(const Curves& curves : {height_level_curves(surface, 0.13), random_curves(surface, 40)})
    {
      const Curve_embedding embedding(surface.triangles(), curves, {});
      const auto& fine = embedding.triangles();
      expect_valid_twins(*fine);
      EXPECT_EQ(std::count_if(fine->twin.begin(), fine->twin.end(),
                              [](Index twin) { return twin == none; }) > 0,
                std::count(surface.t().twin.begin(), surface.t().twin.end(), none) > 0);
      EXPECT_NEAR(total_area(*fine), total_area(surface.t()), round_off * total_area(surface.t()));
      Window_propagation coarse_windows(surface.triangles()), fine_windows(fine);
      coarse_windows.run({surface.source(Index(0))});
      fine_windows.run({surface.source(Index(0))});
      for(Index vertex = 0; vertex < surface.size(); ++vertex)
      {
        // The tolerance of exact distances: windows are split at new edges in the same plane.
        EXPECT_NEAR(fine_windows.distance(vertex), coarse_windows.distance(vertex), 1e-9);
      }
    }
  }
}

TEST(Curve_embedding, curves_become_edges_without_shortcuts)
{
  const Array_surface sphere(jittered(icosphere(2), 0.05)), plane(square(6, 0.24));
  for(const double height : {0.13, 0.61, 0.97})
  {
    const Curves curves = height_level_curves(sphere, height);
    const double exact = curve_length(sphere.t(), curves);
    EXPECT_NEAR(length_along_curves({sphere.triangles(), curves, {}}), exact, round_off * exact);
  }
  for(const double angle : {0.1, 0.7, 1.6, 2.9})
  {
    const Curves curves = zero_level_curves(
        plane, [&](const Point& p)
        { return std::cos(angle) * (p[0] - 0.52) + std::sin(angle) * (p[1] - 0.47); });
    const double exact = curve_length(plane.t(), curves);
    EXPECT_NEAR(length_along_curves({plane.triangles(), curves, {}}), exact, round_off * exact);
  }
  const Curves curves = random_curves(sphere, 60);
  const double exact = curve_length(sphere.t(), curves);
  EXPECT_NEAR(length_along_curves({sphere.triangles(), curves, {}}), exact, round_off * exact);
  // Single points must not be connected by an edge.
  Curves points;
  for(const auto& curve : curves)
    points.push_back({curve[0]});
  for(Index i = 0; i < sphere.size(); ++i)
    points.push_back({sphere.at(i)});
  EXPECT_EQ(length_along_curves({sphere.triangles(), points, {}}), 0.);
  // A loop around a triangle, and half of an edge.
  const Curves triangle_loop = {sphere.along({0, 0})};
  const Index* corner = &sphere.t().corner[0];
  const std::vector<Surface_location> loop = {
      {none, corner[0], {}}, {none, corner[1], {}}, {none, corner[2], {}}, {none, corner[0], {}}};
  const double perimeter = sphere.t().length[0] + sphere.t().length[1] + sphere.t().length[2];
  const Curve_embedding enclosed(sphere.triangles(), {loop}, {});
  EXPECT_NEAR(length_along_curves(enclosed), perimeter, round_off);
  EXPECT_GT(enclosed.triangles()->number_of_triangles(), sphere.t().number_of_triangles());
  const std::vector<Surface_location> half = {{0, none, {1., 0., 0.}}, {0, none, {0.5, 0.5, 0.}}};
  EXPECT_NEAR(length_along_curves({sphere.triangles(), {half}, {}}), 0.5 * sphere.t().length[0],
              round_off);
  // An edge between two region vertices may stay. Other edges of a curve vertex must be split.
  const Curve_embedding with_region(sphere.triangles(), {half}, {corner[1], corner[2]});
  EXPECT_EQ(with_region.triangles()->twin[sphere.t().twin[1]] == none, false);
}

TEST(Curve_embedding, lists_vertices_of_each_curve)
{
  const Array_surface surface(one_triangle());
  const auto at = [](double a, double b, double c) { return Surface_location{0, none, {a, b, c}}; };
  // Two crossing segments, their common point, and a segment that begins on an edge.
  const Curves curves = {{at(0.5, 0.25, 0.25), at(0.25, 0.5, 0.25)},
                         {at(0.5, 0.5, 0.), at(0.25, 0.25, 0.5)},
                         {at(0.375, 0.375, 0.25)},
                         {at(0.5, 0.5, 0.), at(1., 0., 0.)}};
  const Curve_embedding embedding(surface.triangles(), curves, {});
  ASSERT_EQ(embedding.vertices().size(), 4u);
  EXPECT_EQ(embedding.vertices()[0].size(), 3u);
  EXPECT_EQ(embedding.vertices()[1].size(), 3u);
  EXPECT_EQ(embedding.vertices()[2].size(), 1u);
  EXPECT_EQ(embedding.vertices()[3].size(), 2u);
  const Index crossing = embedding.vertices()[2][0];
  for(const std::size_t i : {0u, 1u})
    EXPECT_EQ(std::count(embedding.vertices()[i].begin(), embedding.vertices()[i].end(), crossing),
              1);
}

TEST(Curve_embedding, preserves_functions_masses_and_fields)
{
  const Array_surface surface(jittered(icosphere(1), 0.1));
  Curves curves = random_curves(surface, 30);
  for(auto& curve : height_level_curves(surface, 0.3))
    curves.push_back(curve);
  const Curve_embedding embedding(surface.triangles(), curves, {});
  const Surface_arrays &coarse = surface.t(), &fine = *embedding.triangles();
  const Vector function = Vector::Random(Eigen::Index(coarse.number_of_vertices()));
  const Vector refined = embedding.refined(function);
  const auto value = [](const Surface_arrays& t, const Vector& f, const Surface_location& location)
  {
    double result = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      result += location.barycentric[k] * f[t.corner[3 * location.triangle + k]];
    return result;
  };
  for(Index f = 0; f < coarse.number_of_triangles(); ++f)
    for(const auto& b : {std::array{0.2, 0.7, 0.1}, std::array{0.4, 0.3, 0.3},
                         std::array{0., 0.45, 0.55}, std::array{0., 0., 1.}})
    {
      const Surface_location refined_location = embedding.refined(Surface_location{f, none, b});
      EXPECT_GE(*std::min_element(refined_location.barycentric.begin(),
                                  refined_location.barycentric.end()),
                0.);
      EXPECT_NEAR(value(fine, refined, refined_location), value(coarse, function, {f, none, b}),
                  round_off);
    }

  // The integral of the length of a gradient must be the same, also with an anisotropic metric.
  std::vector<Metric_tensor> metric;
  for(Index f = 0; f < coarse.number_of_triangles(); ++f)
    metric.push_back({2. + 0.01 * f, 0.5, 1.});
  const Operators coarse_operators = metric_operators(coarse, metric),
                  fine_operators = metric_operators(fine, embedding.refined(metric));
  double coarse_sum = 0., fine_sum = 0.;
  for(const auto& [o, f, sum] : {std::tuple{&coarse_operators, &function, &coarse_sum},
                                 std::tuple{&fine_operators, &refined, &fine_sum}})
  {
    const Field slope = gradient(*o, *f);
    for(std::size_t i = 0; i < slope.size(); ++i)
      *sum += o->area[i] * norm(slope[i]);
  }
  EXPECT_NEAR(fine_sum, coarse_sum, round_off * coarse_sum);

  // Coarsening a field must preserve its divergence.
  const Operators a = operators(coarse, Degenerate_triangles::thickened),
                  b = operators(fine, Degenerate_triangles::thickened);
  Field field = gradient(b, Vector::Random(Eigen::Index(fine.number_of_vertices())));
  const Vector before = embedding.coarsened(minus_divergence(b, field)),
               after = minus_divergence(a, embedding.coarsened(field));
  EXPECT_LT((before - after).lpNorm<Eigen::Infinity>(),
            round_off * before.lpNorm<Eigen::Infinity>());
  const Vector masses = Vector::Random(Eigen::Index(fine.number_of_vertices()));
  EXPECT_NEAR(embedding.coarsened(masses).dot(function), masses.dot(refined), round_off);
}

TEST(Curve_embedding, handles_degenerate_triangles_and_close_points)
{
  Triangulation shape = square(3);
  for(Point& p : shape.points)
    p[1] *= 1e-13; // needles
  for(const Triangulation& triangulation : {shape, square(3)})
  {
    const Array_surface surface(triangulation);
    Curves curves = random_curves(surface, 20);
    for(double epsilon : {1e-9, 1e-11, 1e-13, 1e-15})
      curves.push_back({{2, none, {1. - epsilon, epsilon, 0.}},
                        {2, none, {0.4, 0.6 - epsilon, epsilon}},
                        {2, none, {0.4 + epsilon, 0.3, 0.3 - epsilon}}});
    const Curve_embedding embedding(surface.triangles(), curves, {});
    expect_valid_twins(*embedding.triangles());
    EXPECT_NEAR(total_area(*embedding.triangles()), total_area(surface.t()),
                1e-9); // the scaled surface has a size of order one
  }
}

// On a cloud, all triangles at an edge are split at a point of the edge, and keep their weights.
TEST(Curve_embedding, splits_all_triangles_at_edges_of_clouds)
{
  const Cloud sphere = ellipsoid_cloud(300, {1., 1., 1.});
  const auto surfels =
      std::make_shared<const Surfel_arrays>(build_surfel_arrays(sphere.points, sphere.normals));
  const std::shared_ptr<const Surface_arrays> coarse(surfels, &surfels->arrays);
  const auto has_ends = [](const Surface_arrays& t, Index h, Index a, Index b)
  {
    const Index from = t.corner[h], to = t.corner[next_halfedge(h)];
    return (from == a && to == b) || (from == b && to == a);
  };
  // A point on an edge with more than two triangles, and a segment inside another triangle.
  Index edge = 0;
  const auto number_at_edge = [&](Index h)
  {
    std::size_t count = 0;
    for(Index other = 0; other < coarse->corner.size(); ++other)
      count += has_ends(*coarse, other, coarse->corner[h], coarse->corner[next_halfedge(h)]);
    return count;
  };
  while(number_at_edge(edge) < 3)
    ++edge;
  const Index a = coarse->corner[edge], b = coarse->corner[next_halfedge(edge)];
  const Surface_location on_edge = {edge / 3, none, barycentric_on_halfedge(edge, 0.3)};
  const Index far = edge / 3 < 100 ? Index(coarse->number_of_triangles() - 1) : 0;
  const Curve_embedding embedding(
      coarse, {{on_edge}, {{far, none, {0.2, 0.3, 0.5}}, {far, none, {0.6, 0.2, 0.2}}}}, {});
  const Surface_arrays& fine = *embedding.triangles();
  EXPECT_TRUE(fine.is_cloud());
  EXPECT_TRUE(fine.twin.empty());
  EXPECT_EQ(fine.ring.size(), fine.corner.size());
  EXPECT_EQ(fine.number_of_vertices(), coarse->number_of_vertices() + 3);
  EXPECT_EQ(embedding.vertices()[1].size(), 2u);
  EXPECT_EQ(fine.weight.size(), fine.number_of_triangles());
  for(Index h = 0; h < fine.corner.size(); ++h)
    EXPECT_FALSE(has_ends(fine, h, a, b));
  // Both parts of the edge have the same triangles as the edge, and keep its length.
  const Index vertex = embedding.vertices()[0].front();
  std::size_t count = 0;
  for(Index h = 0; h < fine.corner.size(); ++h)
    if(has_ends(fine, h, a, vertex))
    {
      ++count;
      EXPECT_NEAR(fine.length[h], 0.3 * coarse->length[edge], round_off);
    }
  EXPECT_EQ(count, number_at_edge(edge));
  // Areas times weights, and gradients of functions that are linear in the coarse triangles.
  const Operators o = operators(*coarse), fine_o = operators(fine);
  EXPECT_NEAR(std::accumulate(fine_o.area.begin(), fine_o.area.end(), 0.),
              std::accumulate(o.area.begin(), o.area.end(), 0.), round_off);
  Vector function(Eigen::Index(coarse->number_of_vertices()));
  for(Eigen::Index i = 0; i < function.size(); ++i)
    function[i] = coarse->point[std::size_t(i)][2];
  const Field expected = gradient(o, function),
              found = embedding.coarsened(gradient(fine_o, embedding.refined(function)));
  for(std::size_t f = 0; f < expected.size(); ++f)
    EXPECT_LT(norm(found[f] - expected[f]), round_off);
}

} // namespace Curve_embedding_test
