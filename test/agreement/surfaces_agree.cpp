// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes.h"
#include "methods.h"

#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include <gtest/gtest.h>

#include <map>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Each face cut into four flat ones: the same surface, and the first points are the same.
Triangulation refined(const Triangulation& shape)
{
  Triangulation result{shape.points, {}};
  std::map<std::pair<Index, Index>, Index> middle;
  const auto between = [&](Index a, Index b)
  {
    const auto [place, is_new] = middle.try_emplace(std::minmax(a, b), Index(result.points.size()));
    if(is_new)
    {
      Point p;
      for(int k = 0; k < 3; ++k)
        p[k] = 0.5 * (shape.points[a][k] + shape.points[b][k]);
      result.points.push_back(p);
    }
    return place->second;
  };
  for(std::size_t c = 0; c < shape.corners.size(); c += 3)
  {
    const Index p = shape.corners[c], q = shape.corners[c + 1], r = shape.corners[c + 2];
    const Index a = between(p, q), b = between(q, r), d = between(r, p);
    result.corners.insert(result.corners.end(), {p, a, d, a, q, b, d, b, r, a, b, d});
  }
  return result;
}

// The mean of |a / b - 1| beyond 5 percent of the largest distance.
double mean_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  const double farthest = *std::max_element(b.begin(), b.end());
  return mean_relative_error(a, 0.05 * farthest, [&](Index i) { return b[i]; });
}

void expect_agreement_with_refined(const Triangulation& shape)
{
  const Glued_surface coarse(shape), fine(refined(shape));
  for(const Method method : all_methods)
  {
    const auto d = distances(coarse, method, {coarse.source(0)});
    auto on_fine = distances(fine, method, {fine.source(0)});
    on_fine.resize(d.size());
    // The errors of both, and the finer one has less: what each method's page states,
    // and half as much again on coarse meshes.
    const double error = method == Method::euclidean_front ? 0.006
                         : method == Method::dijkstra      ? 0.1
                                                           : 0.03;
    EXPECT_LT(mean_difference(on_fine, d), error) << method;
    if(method != Method::dijkstra)
      continue;
    for(Index i = 0; i < d.size(); ++i) // the old edges are still there
      EXPECT_LE(on_fine[i], d[i] * (1. + rounding));
  }
}

void expect_agreement_of_heat_and_front(const Triangulation& shape)
{
  const Glued_surface surface(shape);
  const auto front = distances(surface, Method::euclidean_front, {surface.source(0)});
  const auto heat = distances(surface, Method::heat, {surface.source(0)});
  // The errors of both on coarse scans: heat's of 3 percent (femur_3k9, against exact distances) and the
  // front's of 0.6.
  EXPECT_LT(mean_difference(heat, front), 0.036);
}

TEST(Surfaces_agree, with_their_refinement)
{
  expect_agreement_with_refined(shaken(icosphere(4), 0.01));
}

TEST(Surfaces_agree, by_heat_and_by_front)
{
  expect_agreement_of_heat_and_front(shaken(icosphere(5), 0.005));
}

TEST(Surfaces_agree, with_the_cloud_of_their_points)
{
  const Triangulation sphere = icosphere(5);
  const Glued_surface surface(sphere);
  const auto on_mesh = distances(surface, Method::euclidean_front, {surface.source(0)});
  const internal::Glued_surfels cloud = internal::glue_surfels(sphere.points, sphere.points);
  internal::Front front(std::make_shared<const Glued_triangles>(cloud.triangles),
                        internal::Front_kind::euclidean);
  front.run({{{{none, cloud.site_of_surfel[0], {}}}, 0., 0}});
  std::vector<double> on_cloud;
  for(Index i = 0; i < sphere.points.size(); ++i)
    on_cloud.push_back(cloud.triangles.scale * front.distance(cloud.site_of_surfel[i]));
  // Both are of second order: h^2 with sides of 0.04, times a constant of order one.
  EXPECT_LT(mean_difference(on_cloud, on_mesh), 0.002);
}

class Real_surfaces : public testing::TestWithParam<const char*>
{};

TEST_P(Real_surfaces, agree)
{
  const Triangulation shape = read_off(model(std::string("meshes/") + GetParam()));
  if(shape.points.empty())
    GTEST_SKIP() << no_models;
  expect_agreement_with_refined(shape);
  expect_agreement_of_heat_and_front(shape);
}

INSTANTIATE_TEST_SUITE_P(Surfaces_agree, Real_surfaces,
                         testing::Values("elephant_2k8.off", "femur_3k9.off", "cow_2k9.off"));

} // namespace
