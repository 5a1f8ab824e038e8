// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_loop.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/paths/loop_basis.h>

#include "Array_surface.h"
#include "closed_forms.h"
#include "meshes.h"
#include "path_checks.h"
#include "paths/shorten_geodesic.h"
#include "paths/triangle_strip.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace shorten_loop_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Lengths are sums of at most a few thousand terms.
constexpr double round_off = 1e-12;

// As for shorten_geodesic(): the square root of round-off errors.
constexpr double angle_tolerance = 1e-6;

// Shortens loops on a surface and checks all guarantees of shorten_loop().
class Loop_checker
{
public:
  explicit Loop_checker(const Array_surface& surface)
      : t(surface.t()), m_homotopy(t), m_forms(closed_forms(t))
  {}
  Locally_shortest_path operator()(const std::vector<Surface_location>& loop) const;

private:
  const Surface_arrays& t;
  Homotopy m_homotopy;
  std::vector<Closed_form> m_forms;
};

Locally_shortest_path Loop_checker::operator()(const std::vector<Surface_location>& loop) const
{
  const Locally_shortest_path result = shorten_loop(t, m_homotopy, loop);
  std::vector<Surface_location> closed = loop;
  closed.push_back(loop.front());
  const double length_before = path_length(t, closed);
  expect_path_on_surface(t, result.locations, result.locations.front(), result.locations.front());
  expect_locally_shortest(result, angle_tolerance);
  EXPECT_LE(result.length, length_before * (1. + round_off));
  EXPECT_NEAR(result.length, path_length(t, result.locations), round_off * length_before);
  for(const Closed_form& form : m_forms)
    EXPECT_NEAR(integral(t, form, result.locations), period(t, form, loop), 1e-9);
  if(result.locations.size() == 1)
    return result;
  // No segment can be shortened, wherever the loop is cut open.
  const std::size_t n = result.locations.size() - 1;
  for(std::size_t cut = 0; cut < n; cut += 1 + n / 10)
  {
    std::vector<Surface_location> path(result.locations.begin() + cut, result.locations.end() - 1);
    path.insert(path.end(), result.locations.begin(), result.locations.begin() + cut + 1);
    EXPECT_NEAR(shorten_geodesic(t, path).length, result.length, round_off * length_before);
  }
  // All vertices of the loop are listed with their angles.
  std::size_t number_of_vertices = 0;
  for(std::size_t i = 0; i < n; ++i)
    number_of_vertices += vertex_of(t, result.locations[i]) != none ? 1 : 0;
  EXPECT_EQ(result.touched_vertices.size(), number_of_vertices);
  return result;
}

double shortened_length(const Array_surface& surface, const std::vector<Index>& loop)
{
  return surface.scale() * Loop_checker(surface)(surface.along(loop)).length;
}

TEST(shorten_loop, is_circumference_of_cylinder)
{
  const std::size_t n = 24;
  const Array_surface surface(cylinder(n, 6, 1., 2.));
  // Up along one line, around, and down along another one.
  std::vector<Index> loop = {0, 24, 48, 72};
  for(Index i = 1; i <= 10; ++i)
    loop.push_back(72 + i);
  for(const Index i : {58, 34, 10})
    loop.push_back(i);
  for(Index i = 11; i < n; ++i)
    loop.push_back(i);
  EXPECT_NEAR(shortened_length(surface, loop), 2. * n * std::sin(pi / n), round_off);
}

TEST(shorten_loop, is_at_waist_of_cone)
{
  for(const double outer : {1.1, 2., 20.})
  {
    const std::size_t n = 24;
    // The radii of the two ends are 1 and `outer`.
    const Array_surface surface(rings(
        n, 30, [=](double s) { return 1. + s * (outer - 1.); }, [](double s) { return 3. * s; }));
    std::vector<Index> loop;
    for(Index i = 0; i < n; ++i)
      loop.push_back(30 * n + i);
    EXPECT_NEAR(shortened_length(surface, loop), 2. * n * std::sin(pi / n), round_off);
  }
}

TEST(shorten_loop, surrounds_hole_of_annulus)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const std::size_t n = 36;
    const Array_surface surface(scaled(annulus(n, 12, 0.5, 2.), scale));
    std::vector<Index> loop;
    for(Index i = 0; i < n; ++i)
      loop.push_back(i);
    EXPECT_NEAR(shortened_length(surface, loop), scale * n * std::sin(pi / n), scale * round_off);
  }
}

TEST(shorten_loop, is_inner_equator_or_meridian_of_torus)
{
  const Index n = 40, m = 24;
  const Array_surface surface(torus(n, m));
  // The outer equator is not the shortest loop around the axis: the inner one has radius 0.6.
  std::vector<Index> equator, meridian;
  for(Index i = 0; i < n; ++i)
    equator.push_back(i);
  for(Index j = 0; j < m; ++j)
    meridian.push_back(n * j + 3);
  // The outer equator is a closed geodesic, but its vertices are convex.
  const double length = shortened_length(surface, equator);
  EXPECT_LT(length, 2. * pi * (1. + 0.4));
  EXPECT_GE(length, 1.2 * n * std::sin(pi / n) * (1. - round_off));
  // The meridian is a regular polygon.
  EXPECT_LE(shortened_length(surface, meridian), 0.8 * m * std::sin(pi / m) * (1. + round_off));
}

// Also if the loop is locally shortest, as many loops on polyhedra of convex vertices are.
TEST(shorten_loop, contractible_loop_is_point)
{
  for(const Triangulation& triangulation :
      {icosphere(3), blocks(3, 3, 3, [](int, int, int) { return true; }), torus(30, 20),
       double_torus(2), square(12, 0.2), annulus(24, 6, 1., 2.)})
  {
    const Array_surface surface(triangulation);
    const Loop_checker shortened(surface);
    Path_finder finder(surface.triangles());
    std::mt19937 random(1);
    int number_of_points = 0;
    for(int repetition = 0; repetition < 20; ++repetition)
    {
      // A triangle of three short paths, which is contractible if its corners are close together.
      std::vector<Surface_location> corners, loop;
      for(int i = 0; i < 3; ++i)
        corners.push_back(random_location(surface.t(), random));
      for(int i = 0; i < 3; ++i)
      {
        const auto path = finder(corners[i], corners[(i + 1) % 3]);
        loop.insert(loop.end(), path.begin(), path.end() - 1);
      }
      const auto result = shortened(loop);
      if(result.locations.size() > 1)
      {
        EXPECT_GT(result.length, 0.);
        EXPECT_GT(Homotopy(surface.t()).number_of_generators(), 0u);
        continue;
      }
      ++number_of_points;
      EXPECT_EQ(result.length, 0.);
      EXPECT_TRUE(is_same_point(surface.t(), result.locations.front(),
                                canonical(surface.t(), loop.front())));
    }
    EXPECT_GT(number_of_points, 5);
  }
}

TEST(shorten_loop, basis_loops_are_locally_shortest)
{
  std::vector<Triangulation> surfaces = {
      cylinder(12, 4, 1., 1.),
      jittered(cylinder(12, 20, 1., 1.), 0.02),
      torus(30, 20),
      jittered(torus(60, 30), 0.01),
      double_torus(1),
      jittered(double_torus(4), 0.2),
      jittered(blocks(9, 3, 1, [](int i, int j, int) { return j != 1 || i % 2 == 0; }), 0.1),
      knot(80, 12)};
  for(const std::string name : {"joint_221", "pig_468", "elephant_2k8", "couplingdown_1k8"})
    if(Triangulation model; read_model("meshes/" + name + ".off", model))
      surfaces.push_back(std::move(model));
  for(const Triangulation& triangulation : surfaces)
  {
    const Array_surface surface(triangulation);
    const Loop_checker shortened(surface);
    for(const auto& loop : loop_basis(surface.t()))
      EXPECT_GT(shortened(loop).length, 0.);
  }
}

// A strip from an edge to itself is shortened like the path through the middles of its edges.
TEST(shorten_loop, closed_strip_is_shortened_like_a_path)
{
  int number_of_strips = 0;
  for(const Triangulation& triangulation :
      {jittered(cylinder(12, 20, 1., 1.), 0.02), jittered(torus(60, 30), 0.01), knot(80, 12)})
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = surface.t();
    for(std::vector<Surface_location> loop : loop_basis(t))
    {
      loop.push_back(loop.front());
      const auto crossed = crossed_halfedges(t, loop);
      ASSERT_TRUE(crossed);
      Strip strip;
      for(const Index h : *crossed)
        strip.append(t, h);
      if(strip.halfedges.empty() || t.twin[strip.halfedges.front()] == strip.halfedges.back())
        continue;
      ++number_of_strips;
      std::vector<Surface_location> path;
      for(const Index h : strip.halfedges)
        path.push_back(canonical(t, {h / 3, none, barycentric_on_halfedge(h, 0.5)}));
      path.push_back(path.front());
      strip.triangle = t.twin[strip.halfedges.front()] / 3;
      strip.halfedges.erase(strip.halfedges.begin());
      bool is_geodesic_path, is_geodesic_strip;
      const auto expected = shorten_closed_geodesic(t, path, is_geodesic_path);
      const auto result = shorten_closed_geodesic(t, path.front(), strip, is_geodesic_strip);
      EXPECT_EQ(is_geodesic_strip, is_geodesic_path);
      EXPECT_NEAR(result.length, expected.length, round_off * path_length(t, path));
      EXPECT_NEAR(result.length, path_length(t, result.locations),
                  round_off * path_length(t, path));
    }
  }
  EXPECT_GE(number_of_strips, 4);
}

TEST(shorten_loop, throws_on_invalid_input)
{
  const Array_surface surface(torus(12, 8));
  const Homotopy homotopy(surface.t());
  EXPECT_THROW(shorten_loop(surface.t(), homotopy, {}), Invalid_argument_error);
  EXPECT_THROW(shorten_loop(surface.t(), homotopy, surface.along({0, 1, 30})),
               Invalid_argument_error);
}

} // namespace shorten_loop_test
