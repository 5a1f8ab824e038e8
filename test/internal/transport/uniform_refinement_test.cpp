// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/uniform_refinement.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <set>

namespace uniform_refinement_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums of up to some hundred terms; measured are 2e-15.
constexpr double round_off = 1e-12;

// Checks that a halfedge and its twin have the same ends and length, and that rings are
// counterclockwise.
void expect_valid_twins(const Surface_arrays& t)
{
  for(Index h = 0; h < t.corner.size(); ++h)
    if(const Index twin = t.twin[h]; twin != none)
    {
      EXPECT_EQ(t.twin[twin], h);
      EXPECT_EQ(t.corner[h], t.corner[next_halfedge(twin)]);
      EXPECT_EQ(t.length[h], t.length[twin]);
    }
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      EXPECT_EQ(t.corner[t.ring[i]], vertex);
      const Index left = t.twin[previous_halfedge(t.ring[i])];
      if(i + 1 < t.ring_begin[vertex + 1] && left != none)
      {
        EXPECT_EQ(t.ring[i + 1], left);
      }
    }
}

TEST(uniform_refinement, preserves_connectivity)
{
  for(const Triangulation& shape :
      {tetrahedron(), one_triangle(), square(5, 0.24), torus(12, 8), double_torus(1)})
  {
    const Array_surface surface(shape);
    const Surface_arrays fine = refined(surface.t());
    EXPECT_EQ(fine.number_of_triangles(), 4 * surface.t().number_of_triangles());
    expect_valid_twins(fine);
    // Each vertex and each edge yields one vertex. An edge has two halfedges, a boundary edge has
    // one.
    const auto number_of_boundary_halfedges = [](const Surface_arrays& t)
    { return std::size_t(std::count(t.twin.begin(), t.twin.end(), none)); };
    EXPECT_EQ(fine.number_of_vertices(),
              surface.t().number_of_vertices() +
                  (surface.t().corner.size() + number_of_boundary_halfedges(surface.t())) / 2);
    EXPECT_EQ(number_of_boundary_halfedges(fine), 2 * number_of_boundary_halfedges(surface.t()));
  }
}

TEST(uniform_refinement, preserves_area_and_distances)
{
  for(const Triangulation& shape :
      {jittered(icosphere(1), 0.1), square(5, 0.24), cylinder(8, 3, 1., 2.)})
  {
    const Array_surface surface(shape);
    const auto fine = std::make_shared<const Surface_arrays>(refined(refined(surface.t())));
    const auto area = [](const Surface_arrays& t)
    {
      const std::vector<double> areas = operators(t).area;
      return t.scale * t.scale * std::accumulate(areas.begin(), areas.end(), 0.);
    };
    EXPECT_NEAR(area(*fine), area(surface.t()), round_off * area(*fine));
    Window_propagation coarse_windows(surface.triangles()), fine_windows(fine);
    coarse_windows.run({surface.source(Index(0))});
    fine_windows.run({surface.source(Index(0))});
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
    {
      const double expected = surface.scale() * coarse_windows.distance(vertex);
      // The tolerance of exact distances (see Exact): windows are split at new edges in the same
      // plane.
      EXPECT_NEAR(fine->scale * fine_windows.distance(vertex), expected,
                  round_off * (1. + expected));
    }
  }
}

TEST(uniform_refinement, maps_locations)
{
  const Array_surface surface(jittered(icosphere(1), 0.1));
  const Surface_arrays fine = refined(surface.t());
  const auto coordinates = [](const Surface_arrays& coarse, const Surface_arrays& finer)
  {
    // Since coordinates are linear functions, refining them yields the coordinates of the
    // midpoints.
    std::array<Vector, 3> result;
    for(std::size_t c = 0; c < 3; ++c)
    {
      Vector values(coarse.number_of_vertices());
      for(std::size_t i = 0; i < coarse.number_of_vertices(); ++i)
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
      const Surface_location location = refined(Surface_location{triangle, none, b});
      EXPECT_EQ(location.triangle / 4, triangle);
      EXPECT_GE(*std::min_element(location.barycentric.begin(), location.barycentric.end()), 0.);
      for(std::size_t c = 0; c < 3; ++c)
      {
        double before = 0., after = 0.;
        for(std::size_t k = 0; k < 3; ++k)
        {
          before += b[k] * surface.t().point[surface.t().corner[3 * triangle + k]][c];
          after += location.barycentric[k] * coordinates[c][fine.corner[3 * location.triangle + k]];
        }
        EXPECT_NEAR(after, before, round_off);
      }
    }
  const Surface_location vertex = refined(Surface_location{none, 3, {}});
  EXPECT_EQ(vertex.triangle, none);
  EXPECT_EQ(vertex.vertex, 3u);
}

// Children at corners have the orientation of their parent; the center triangle is rotated by 180
// degrees.
TEST(uniform_refinement, preserves_gradients)
{
  const Array_surface surface(square(4, 0.24));
  const Surface_arrays fine = refined(surface.t());
  Vector function(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    function[i] = std::cos(double(i));
  const Field coarse = gradient(operators(surface.t()), function);
  const Field children = gradient(operators(fine), refined(surface.t(), fine, function));
  for(std::size_t f = 0; f < coarse.size(); ++f)
    for(std::size_t child = 0; child < 4; ++child)
      for(std::size_t c = 0; c < 2; ++c)
        EXPECT_NEAR((child == 3 ? -2. : 2.) * children[4 * f + child][c], coarse[f][c], round_off);
}

// If a function is refined, and its gradient is coarsened, the result must be the original
// gradient. Integrals of linear functions must be preserved. This holds on meshes and clouds.
TEST(uniform_refinement, coarsening_inverts_refinement)
{
  const Cloud cloud = octahedron_sphere(2);
  for(const Surface_arrays& t : {Array_surface(square(4, 0.24)).t(), Array_surface(torus(8, 6)).t(),
                                 build_surfel_arrays(cloud.points, cloud.normals).arrays})
  {
    const Surface_arrays fine = refined(t);
    Vector function(t.number_of_vertices()), masses(fine.number_of_vertices());
    for(Eigen::Index i = 0; i < function.size(); ++i)
      function[i] = std::cos(double(i));
    for(Eigen::Index i = 0; i < masses.size(); ++i)
      masses[i] = std::sin(double(i));
    const Vector coarse = coarsened(t, fine, masses);
    EXPECT_NEAR(coarse.dot(function), masses.dot(refined(t, fine, function)), round_off);
    EXPECT_NEAR(coarse.sum(), masses.sum(), round_off);
    const Field coarse_field = gradient(operators(t), function);
    const Field mean = coarsened(gradient(operators(fine), refined(t, fine, function)));
    for(std::size_t f = 0; f < coarse_field.size(); ++f)
      EXPECT_LT(norm(2. * mean[f] + (-1.) * coarse_field[f]), round_off);
  }
}

TEST(uniform_refinement, works_on_clouds)
{
  const Cloud cloud = octahedron_sphere(2);
  const Surface_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals).arrays;
  const Surface_arrays fine = refined(sphere);
  EXPECT_TRUE(fine.is_cloud());
  EXPECT_EQ(fine.weight.size(), 4 * sphere.weight.size());
  std::set<std::pair<Index, Index>> edges;
  for(Index h = 0; h < sphere.corner.size(); ++h)
    edges.insert(std::minmax(sphere.corner[h], sphere.corner[next_halfedge(h)]));
  EXPECT_EQ(fine.number_of_vertices(), sphere.number_of_vertices() + edges.size());
}

} // namespace uniform_refinement_test
