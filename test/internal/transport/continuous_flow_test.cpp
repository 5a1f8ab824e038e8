// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include "Array_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

namespace continuous_flow_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

double exact_distance(const Array_surface& surface, Index from, Index to)
{
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(from)});
  return windows.distance(surface.vertex(to));
}

Transport_result transport(const Array_surface& surface, Index from, Index to)
{
  Vector masses = Vector::Zero(surface.size());
  masses[surface.vertex(from)] -= 1.;
  masses[surface.vertex(to)] += 1.;
  return Transport_solver(operators(surface.t())).solve(masses);
}

double cost_of_continuous_flow(const Surface_arrays& t, const Operators& o, const Field& flow,
                               const std::vector<Metric_tensor>& metric = {})
{
  return continuous_flow(t, o, flow, metric).cost;
}

TEST(continuous_flow, cost_is_at_least_exact_distance)
{
  for(const Triangulation& shape :
      {jittered(icosphere(3), 0.02), torus(40, 16), double_torus(2), cylinder(24, 8, 1., 2.),
       cone(12, 6, 4.), cone(12, 6, 8.), square(16, 0.24), annulus(24, 6, 0.5, 1.)})
  {
    const Array_surface surface(shape);
    const Operators o = operators(surface.t());
    for(const Index to : {7u, surface.size() / 2, surface.size() - 1})
    {
      const double exact = exact_distance(surface, 0, to);
      const double cost = cost_of_continuous_flow(surface.t(), o, transport(surface, 0, to).flow);
      EXPECT_GE(cost, exact);
      // Spreading adds at most the length of one edge at each end. On these coarse surfaces, a flow
      // that is constant along edges can be longer by another half.
      EXPECT_LE(cost, 1.5 * exact + 2. * 2.);
    }
  }
}

TEST(continuous_flow, converges_under_refinement)
{
  double previous_cost = infinity;
  for(const unsigned level : {2u, 3u, 4u})
  {
    const Array_surface surface(icosphere(level));
    const double cost = cost_of_continuous_flow(surface.t(), operators(surface.t()),
                                                transport(surface, 0, 30).flow) /
                        exact_distance(surface, 0, 30);
    EXPECT_GE(cost, 1.);
    EXPECT_LT(cost, previous_cost);
    previous_cost = cost;
  }
}

TEST(continuous_flow, passes_nonmanifold_vertices)
{
  // Two squares with a common vertex, and one mass in each.
  Triangulation shape = disjoint_union(square(4), square(4));
  for(std::size_t i = 25; i < 50; ++i)
    for(std::size_t c = 0; c < 2; ++c)
      shape.points[i][c] = shape.points[i - 25][c] + 1.;
  for(Index& corner : shape.corners)
    if(corner == 25)
      corner = 24;
  const Array_surface surface(shape);
  const Operators o = operators(surface.t());
  const double exact = exact_distance(surface, 0, 49);
  const double cost = cost_of_continuous_flow(surface.t(), o, transport(surface, 0, 49).flow);
  EXPECT_GE(cost, exact);
  EXPECT_LE(cost, 2.5 * exact); // spreads mass at four corners of squares with 4 x 4 cells
}

TEST(continuous_flow, cost_scales_with_metric)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Operators o = operators(surface.t());
  const Field flow = transport(surface, 0, 100).flow;
  const double cost = cost_of_continuous_flow(surface.t(), o, flow);
  const std::vector<Metric_tensor> doubled_metric(o.number_of_triangles(), {2., 0., 2.});
  // The same sum of doubled lengths: round-off errors.
  EXPECT_NEAR(cost_of_continuous_flow(surface.t(), o, flow, doubled_metric), 2. * cost,
              1e-12 * cost);
  // The metric doubles lengths in one direction only. Hence the cost increases by a factor between
  // 1 and 2.
  const std::vector<Metric_tensor> anisotropic_metric(o.number_of_triangles(), {1.5, 0.5, 1.5});
  const double anisotropic_cost = cost_of_continuous_flow(surface.t(), o, flow, anisotropic_metric);
  EXPECT_GT(anisotropic_cost, cost);
  EXPECT_LT(anisotropic_cost, 2. * cost);
}

TEST(continuous_flow, throws_on_cloud)
{
  const Cloud cloud = octahedron_sphere(2);
  const Surface_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals).arrays;
  const Operators o = operators(sphere);
  EXPECT_THROW(continuous_flow(sphere, o, Field(o.number_of_triangles(), Vec2{0., 0.})),
               Unsupported_surface_error);
}

} // namespace continuous_flow_test
