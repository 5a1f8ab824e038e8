// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/flat_refinement.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of a few sums.
constexpr double rounding = 1e-12;

// The twin's twin, the same ends, the same length; corners turn counterclockwise around each site.
void expect_glued(const Glued_triangles& t)
{
  for(Index side = 0; side < t.corner.size(); ++side)
    if(const Index twin = t.twin[side]; twin != none)
    {
      EXPECT_EQ(t.twin[twin], side);
      EXPECT_EQ(t.corner[side], t.corner[next_side(twin)]);
      EXPECT_EQ(t.length[side], t.length[twin]);
    }
  for(Index site = 0; site < t.number_of_sites(); ++site)
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      EXPECT_EQ(t.corner[t.star[i]], site);
      const Index left = t.twin[previous_side(t.star[i])];
      if(i + 1 < t.first[site + 1] && left != none)
      {
        EXPECT_EQ(t.star[i + 1], left);
      }
    }
}

TEST(flat_refinement, glues_what_was_glued)
{
  for(const Triangulation& shape :
      {tetrahedron(), one_triangle(), square(5, 0.24), torus(12, 8), double_ring(1)})
  {
    const Glued_surface surface(shape);
    const Glued_triangles fine = refined(surface.t());
    EXPECT_EQ(fine.number_of_triangles(), 4 * surface.t().number_of_triangles());
    expect_glued(fine);
    // Sites and sides: as many middles as there are sides, both of a pair counted once.
    const auto borders = [](const Glued_triangles& t)
    { return std::size_t(std::count(t.twin.begin(), t.twin.end(), none)); };
    EXPECT_EQ(fine.number_of_sites(), surface.t().number_of_sites() +
                                          (surface.t().corner.size() + borders(surface.t())) / 2);
    EXPECT_EQ(borders(fine), 2 * borders(surface.t()));
  }
}

TEST(flat_refinement, keeps_area_and_distances)
{
  for(const Triangulation& shape :
      {shaken(icosphere(1), 0.1), square(5, 0.24), cylinder(8, 3, 1., 2.)})
  {
    const Glued_surface surface(shape);
    const auto fine = std::make_shared<const Glued_triangles>(refined(refined(surface.t())));
    const auto area = [](const Glued_triangles& t)
    {
      const std::vector<double> areas = operators(t).area;
      return t.scale * t.scale * std::accumulate(areas.begin(), areas.end(), 0.);
    };
    EXPECT_NEAR(area(*fine), area(surface.t()), rounding * area(*fine));
    Window_propagation coarse_windows(surface.triangles()), fine_windows(fine);
    coarse_windows.run({surface.source(Index(0))});
    fine_windows.run({surface.source(Index(0))});
    for(Index site = 0; site < surface.size(); ++site)
    {
      const double expected = surface.scale() * coarse_windows.distance(site);
      // What exact distances promise (see Exact) on flat sides through which windows are cut anew.
      EXPECT_NEAR(fine->scale * fine_windows.distance(site), expected, 1e-9 * (1. + expected));
    }
  }
}

TEST(flat_refinement, finds_locations_again)
{
  const Glued_surface surface(shaken(icosphere(1), 0.1));
  const Glued_triangles fine = refined(surface.t());
  const auto places = [](const Glued_triangles& coarse, const Glued_triangles& finer)
  {
    // Coordinates are linear too, so that the middles have theirs.
    std::array<Vector, 3> result;
    for(std::size_t c = 0; c < 3; ++c)
    {
      Vector values(coarse.number_of_sites());
      for(std::size_t i = 0; i < coarse.number_of_sites(); ++i)
        values[Eigen::Index(i)] = coarse.point[i][c];
      result[c] = refined(coarse, finer, values);
    }
    return result;
  }(surface.t(), fine);
  for(const auto& b :
      {std::array{0.2, 0.7, 0.1}, std::array{1. / 3., 1. / 3., 1. / 3.},
       std::array{0.1, 0.45, 0.45}, std::array{0., 0., 1.}, std::array{0.5, 0.5, 0.}})
    for(const Index triangle : {0u, 5u, 11u})
    {
      const Location location = refined(Location{triangle, none, b});
      EXPECT_EQ(location.triangle / 4, triangle);
      EXPECT_GE(*std::min_element(location.barycentric.begin(), location.barycentric.end()), 0.);
      for(std::size_t c = 0; c < 3; ++c)
      {
        double before = 0., after = 0.;
        for(std::size_t k = 0; k < 3; ++k)
        {
          before += b[k] * surface.t().point[surface.t().corner[3 * triangle + k]][c];
          after += location.barycentric[k] * places[c][fine.corner[3 * location.triangle + k]];
        }
        EXPECT_NEAR(after, before, rounding);
      }
    }
  const Location site = refined(Location{none, 3, {}});
  EXPECT_EQ(site.triangle, none);
  EXPECT_EQ(site.site, 3u);
}

// Children at corners lie as their parent does, the one in the middle is turned by half.
TEST(flat_refinement, keeps_gradients)
{
  const Glued_surface surface(square(4, 0.24));
  const Glued_triangles fine = refined(surface.t());
  Vector function(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    function[i] = std::cos(double(i));
  const Field coarse = gradient(operators(surface.t()), function);
  const Field children = gradient(operators(fine), refined(surface.t(), fine, function));
  for(std::size_t f = 0; f < coarse.size(); ++f)
    for(std::size_t child = 0; child < 4; ++child)
      for(std::size_t c = 0; c < 2; ++c)
        EXPECT_NEAR((child == 3 ? -2. : 2.) * children[4 * f + child][c], coarse[f][c], 1e-9);
}

// What is refined and coarsened again is as it was; integrals of linear functions are kept, on clouds as on
// meshes.
TEST(flat_refinement, coarsens_fields_and_masses)
{
  const Cloud cloud = octahedron_sphere(2);
  for(const Glued_triangles& t :
      {Glued_surface(square(4, 0.24)).t(), Glued_surface(torus(8, 6)).t(),
       glue_surfels(cloud.points, cloud.normals).triangles})
  {
    const Glued_triangles fine = refined(t);
    Vector function(t.number_of_sites()), masses(fine.number_of_sites());
    for(Eigen::Index i = 0; i < function.size(); ++i)
      function[i] = std::cos(double(i));
    for(Eigen::Index i = 0; i < masses.size(); ++i)
      masses[i] = std::sin(double(i));
    const Vector coarse = coarsened(t, fine, masses);
    EXPECT_NEAR(coarse.dot(function), masses.dot(refined(t, fine, function)), 1e-9);
    EXPECT_NEAR(coarse.sum(), masses.sum(), 1e-9);
    const Field whole = gradient(operators(t), function);
    const Field mean = coarsened(gradient(operators(fine), refined(t, fine, function)));
    for(std::size_t f = 0; f < whole.size(); ++f)
      EXPECT_LT(norm(2. * mean[f] + (-1.) * whole[f]), 1e-9);
  }
}

TEST(flat_refinement, refines_clouds)
{
  const Cloud cloud = octahedron_sphere(2);
  const Glued_triangles sphere = glue_surfels(cloud.points, cloud.normals).triangles;
  const Glued_triangles fine = refined(sphere);
  EXPECT_TRUE(fine.is_cloud());
  EXPECT_EQ(fine.weight.size(), 4 * sphere.weight.size());
  std::set<std::pair<Index, Index>> sides;
  for(Index side = 0; side < sphere.corner.size(); ++side)
    sides.insert(std::minmax(sphere.corner[side], sphere.corner[next_side(side)]));
  EXPECT_EQ(fine.number_of_sites(), sphere.number_of_sites() + sides.size());
}

} // namespace
