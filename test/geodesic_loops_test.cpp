// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_loops.h>

#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "closed_forms.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace geodesic_loops_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Loop = GP::Geodesic_loop<Mesh>;

// Some hundred face crossings.
constexpr double round_off = 1e-11;

// Checks that locations and points agree, that the loop is closed and that the length is correct.
void expect_loop_on(const Mesh& mesh, const Loop& loop)
{
  ASSERT_FALSE(loop.empty());
  ASSERT_EQ(loop.points.size(), loop.locations.size());
  EXPECT_EQ(loop.points.front(), loop.points.back());
  EXPECT_EQ(loop.is_point(), loop.points.size() == 1);
  double length = 0.;
  for(std::size_t i = 0; i < loop.points.size(); ++i)
  {
    EXPECT_LT(distance(point_of(mesh, loop.locations[i]), to_array(loop.points[i])), round_off);
    if(i > 0)
      length += distance(to_array(loop.points[i]), to_array(loop.points[i - 1]));
  }
  EXPECT_NEAR(loop.length, length, round_off);
}

// Returns the lengths of the loops of a basis, sorted.
template <typename Surface>
std::vector<double> basis_lengths(const Surface& surface)
{
  std::vector<GP::Geodesic_loop<GP::Surface_of<Surface>>> loops;
  GP::loop_basis(surface, std::back_inserter(loops));
  std::vector<double> result;
  for(const auto& loop : loops)
    result.push_back(loop.length);
  std::sort(result.begin(), result.end());
  return result;
}

template <typename M>
std::vector<double> basis_lengths_on(const Triangulation& surface)
{
  Numbered<M> mesh;
  fill(mesh, surface);
  return basis_lengths(mesh.mesh);
}

// The perimeter of a regular polygon with n corners on the unit circle.
double perimeter(std::size_t n) { return 2. * n * std::sin(pi / n); }

TEST(geodesic_loops, loop_on_cylinder_is_shortened_to_circle)
{
  const std::size_t n = 20;
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(cylinder(n, 8, 1., 3.), scale));
    const std::vector<Vertex> vertices = {Vertex(0), Vertex(67), Vertex(2 * n + 14)};
    const Loop loop = GP::shorten_loop(mesh, vertices);
    EXPECT_NEAR(loop.length, scale * perimeter(n), scale * round_off);
    // Points near the cylinder stand for the closest locations.
    std::vector<Kernel::Point_3> points;
    for(const double angle : {0.1, 2., 4.})
      points.emplace_back(1.1 * scale * std::cos(angle), 1.1 * scale * std::sin(angle),
                          angle * 0.5 * scale);
    EXPECT_NEAR(GP::shorten_loop(mesh, points).length, scale * perimeter(n), scale * round_off);
    EXPECT_NEAR(GP::shortest_noncontractible_loop(mesh, Vertex(30)).length, scale * perimeter(n),
                scale * round_off);
    const auto basis = basis_lengths(mesh);
    ASSERT_EQ(basis.size(), 1u);
    EXPECT_NEAR(basis.front(), scale * perimeter(n), scale * round_off);
  }
}

TEST(geodesic_loops, contractible_loop_is_point)
{
  const Mesh mesh = mesh_of(icosphere(3));
  const Loop loop =
      GP::shorten_loop(mesh, std::vector<Vertex>{Vertex(0), Vertex(100), Vertex(200)});
  expect_loop_on(mesh, loop);
  EXPECT_TRUE(loop.is_point());
  EXPECT_EQ(loop.points.front(), mesh.point(Vertex(0)));
  EXPECT_EQ(loop.length, 0.);
  EXPECT_TRUE(GP::shortest_noncontractible_loop(mesh, Vertex(0)).empty());
  EXPECT_TRUE(basis_lengths(mesh).empty());
}

TEST(geodesic_loops, locations_and_points_agree)
{
  const Mesh mesh = mesh_of(jittered(double_torus(2), 0.2));
  std::vector<Loop> loops;
  GP::loop_basis(mesh, std::back_inserter(loops));
  EXPECT_EQ(loops.size(), 4u);
  std::vector<Loop> edge_loops;
  GP::loop_basis(mesh, std::back_inserter(edge_loops), GP::parameters::do_shorten(false));
  ASSERT_EQ(edge_loops.size(), loops.size());
  for(std::size_t i = 0; i < loops.size(); ++i)
  {
    expect_loop_on(mesh, loops[i]);
    expect_loop_on(mesh, edge_loops[i]);
    EXPECT_LE(loops[i].length, edge_loops[i].length);
    EXPECT_EQ(GP::shorten_loop(mesh, edge_loops[i].locations).length, loops[i].length);
  }
  const auto location = location_of(5, {0.2, 0.3, 0.5});
  const Loop loop = GP::shortest_noncontractible_loop(mesh, location);
  expect_loop_on(mesh, loop);
  EXPECT_LT(distance(to_array(loop.points.front()), point_of(mesh, location)), round_off);
  // The loop is at most as long as each loop of the basis and a path to it and back.
  EXPECT_LE(GP::shorten_loop(mesh, loop.locations).length, loop.length);
}

TEST(geodesic_loops, are_the_same_on_all_mesh_types)
{
  const Triangulation surface = jittered(torus(20, 12), 0.02);
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const std::vector<double> lengths = basis_lengths_on<Mesh>(surface);
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_EQ(basis_lengths_on<CGAL::Polyhedron_3<Exact_kernel>>(surface), lengths);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  EXPECT_EQ(basis_lengths_on<OpenMesh::TriMesh_ArrayKernelT<>>(surface).size(), 2u);
#endif

  // A soup of single triangles
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> polygons;
  for(std::size_t c = 0; c < surface.corners.size(); ++c)
  {
    const Point& p = surface.points[surface.corners[c]];
    points.emplace_back(p[0], p[1], p[2]);
    if(c % 3 == 2)
      polygons.push_back({c - 2, c - 1, c});
  }
  const auto domain = GP::make_domain(points, polygons, GP::parameters::merge_tolerance(0.));
  EXPECT_EQ(basis_lengths(domain).size(), 2u);
}

// Two plates with a hole each meet in a vertex, and a third triangle is at an edge of one of them.
// Faces are not joined there.
TEST(geodesic_loops, nonmanifold_soup_has_loops_of_its_manifold_parts)
{
  Triangulation surface = blocks(
      3, 3, 2, [](int i, int j, int k) { return k == 0 ? i != 1 || j != 1 : i == 0 && j == 0; });
  const Triangulation other = surface;
  // The second copy meets the first one in the corner (3, 3, 1).
  const Index n = Index(surface.points.size());
  for(Point p : other.points)
    surface.points.push_back({p[0] + 3., p[1] + 3., p[2] + 1.});
  for(const Index corner : other.corners)
    surface.corners.push_back(corner + n);
  std::vector<Kernel::Point_3> points;
  for(const Point& p : surface.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::size_t, 3>> polygons;
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
    polygons.push_back({surface.corners[c], surface.corners[c + 1], surface.corners[c + 2]});
  // A third triangle at an edge.
  points.emplace_back(1.5, -1., -1.);
  polygons.push_back({polygons[0][0], polygons[0][1], points.size() - 1});
  const auto domain = GP::make_domain(points, polygons, GP::parameters::merge_tolerance(0.));
  const std::vector<double> lengths = basis_lengths(domain);
  // The cut along the edge is one boundary cycle, which adds no loop.
  EXPECT_EQ(lengths.size(), 4u);
  // The cross-section of a plate has the perimeter 4. A loop around the hole is as long.
  for(const double length : lengths)
    EXPECT_GE(length, 4. - round_off);
}

TEST(geodesic_loops, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(torus(12, 8));
  EXPECT_THROW(GP::shorten_loop(mesh, std::vector<Vertex>{}), GP::Invalid_argument_error);
  EXPECT_THROW(GP::shortest_noncontractible_loop(mesh, location_of(0, {0.2, 0.2, 0.2})),
               GP::Invalid_argument_error);
  const Mesh two = mesh_of(disjoint_union(square(2), square(2)));
  EXPECT_TRUE(GP::shorten_loop(two, std::vector<Vertex>{Vertex(0), Vertex(12)}).empty());
}

} // namespace geodesic_loops_test
