// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Streamline_tracer.h>

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Region_transport_solver.h>

#include <CGAL/Point_set_3.h>

#include "Array_surface.h"
#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace Streamline_tracer_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Round-off errors of sums of about ten lengths.
constexpr double round_off = 1e-9;

double length_between(const Kernel::Point_3& p, const Kernel::Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// Returns a Gaussian density around a point of a mesh.
auto gaussian(const Mesh& mesh, const Kernel::Point_3& center, double width)
{
  return GP::mass_density(boost::make_function_property_map<Vertex>(
      [&mesh, center, width](Vertex v) {
        return std::exp(-0.5 * CGAL::squared_distance(mesh.point(v), center) / (width * width));
      }));
}

template <typename Line>
void expect_line(const Line& line)
{
  ASSERT_FALSE(line.empty());
  ASSERT_EQ(line.points.size(), line.locations.size());
  double length = 0.;
  for(std::size_t i = 1; i < line.points.size(); ++i)
    length += length_between(line.points[i - 1], line.points[i]);
  EXPECT_NEAR(line.length, length, round_off);
}

// In the plane, streamlines are straight and their lengths equal the potential differences.
TEST(Streamline_tracer, is_straight_in_plane)
{
  const Mesh mesh = mesh_of(square(24, 0.2));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  const auto distance =
      solver.compute(gaussian(mesh, {0.25, 0.3, 0.}, 0.06), gaussian(mesh, {0.75, 0.6, 0.}, 0.06),
                     GP::parameters::do_normalize(true));
  const auto trace = solver.streamlines();
  std::vector<GP::Streamline<Mesh>> lines;
  trace(200, std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 200u);
  double sum = 0., traced_length = 0.;
  for(const auto& line : lines)
  {
    expect_line(line);
    EXPECT_TRUE(line.has_arrived);
    EXPECT_NEAR(line.length, length_between(line.points.front(), line.points.back()), round_off);
    EXPECT_LE(line.front_distance, line.length + round_off);
    sum += line.length / 200.;
  }
  // The assignment by streamlines costs as much as the transport plan, within 2 %.
  EXPECT_NEAR(sum, distance.value, 0.02 * distance.value);

  // Unshortened streamlines have the same endpoints and are 1 % longer in the mean.
  const auto trace_unshortened = solver.streamlines(GP::parameters::do_straighten(false));
  std::vector<GP::Streamline<Mesh>> unshortened_lines;
  trace_unshortened(200, std::back_inserter(unshortened_lines));
  for(std::size_t i = 0; i < lines.size(); ++i)
  {
    expect_line(unshortened_lines[i]);
    EXPECT_EQ(unshortened_lines[i].locations.back(), lines[i].locations.back());
    EXPECT_GE(unshortened_lines[i].length, lines[i].length - round_off);
    traced_length += unshortened_lines[i].length / 200.;
  }
  // Measured are 0.8 %.
  EXPECT_LE(traced_length, 1.01 * sum);
}

// On a sphere, streamlines follow great circles. Faces lie up to h^2 / 6 = 0.1 % below the
// sphere, where the edge length h is 0.08.
TEST(Streamline_tracer, follows_great_circles)
{
  const Mesh mesh = mesh_of(icosphere(4));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  const Kernel::Point_3 p = mesh.point(Vertex(5)), q = mesh.point(Vertex(1200));
  const auto distance = solver.compute(gaussian(mesh, p, 0.15), gaussian(mesh, q, 0.15),
                                       GP::parameters::do_normalize(true));
  std::vector<GP::Streamline<Mesh>> lines;
  solver.streamlines()(200, std::back_inserter(lines));
  double cost = 0.;
  for(const auto& line : lines)
  {
    expect_line(line);
    const auto a = line.points.front(), b = line.points.back();
    const double exact = great_circle({a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()});
    // Measured are 0.05 %.
    EXPECT_NEAR(line.length, exact, 0.002 * exact);
    cost += exact / 200.;
  }
  // The assignment by streamlines costs as much as the transport plan, within 2 %.
  EXPECT_NEAR(cost, distance.value, 0.02 * distance.value);
}

// On an unrolled cylinder, the streamline of a seed ends at the point mass.
TEST(Streamline_tracer, ends_at_point_masses)
{
  const Mesh mesh = mesh_of(cylinder(36, 16, 1., 2.));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  const Vertex from(36 * 4 + 2), to(36 * 12 + 11);
  solver.compute(from, to);
  const auto trace = solver.streamlines();
  const auto line = trace(from);
  expect_line(line);
  EXPECT_EQ(line.points.front(), mesh.point(from));
  EXPECT_EQ(line.points.back(), mesh.point(to));
  GP::Geodesic_distance_solver<Mesh, GP::Exact> exact(mesh);
  exact.compute(from);
  // Straightened streamlines are geodesics.
  EXPECT_NEAR(line.length, exact.distance(to), round_off);
  EXPECT_GE(line.length, line.front_distance - round_off);
  const auto end = trace.destination(from);
  EXPECT_EQ(GP::make_domain(mesh).point(GP::make_domain(mesh).inner(end)), mesh.point(to));

  std::vector<std::pair<GP::Location<Mesh>, GP::Location<Mesh>>> pairs;
  trace.assignment(10, std::back_inserter(pairs));
  ASSERT_EQ(pairs.size(), 10u);
  for(const auto& [before, after] : pairs)
  {
    EXPECT_EQ(GP::make_domain(mesh).point(GP::make_domain(mesh).inner(before)), mesh.point(from));
    EXPECT_EQ(GP::make_domain(mesh).point(GP::make_domain(mesh).inner(after)), mesh.point(to));
  }
  // The tracer owns a copy of the flow. Another query of the solver does not change it.
  solver.compute(to, from);
  EXPECT_EQ(trace(from).points, line.points);
}

TEST(Streamline_tracer, ends_in_region)
{
  const Mesh mesh = mesh_of(square(16));
  const std::vector<Vertex> exits = {Vertex(0), Vertex(17 * 17 - 1)};
  GP::Region_transport_solver<Mesh> solver(mesh, exits);
  const std::vector<Vertex> starts = {Vertex(17 * 3 + 5), Vertex(17 * 12 + 9)};
  solver.compute(starts);
  const auto trace = solver.streamlines();
  for(std::size_t i = 0; i < 2; ++i)
  {
    const auto line = trace(starts[i]);
    EXPECT_TRUE(line.has_arrived);
    EXPECT_EQ(line.points.back(), mesh.point(exits[i]));
    EXPECT_NEAR(line.length, length_between(mesh.point(starts[i]), mesh.point(exits[i])),
                round_off);
  }
}

// If speeds differ, the fastest path is not straight.
TEST(Streamline_tracer, is_not_shortened_if_speeds_differ)
{
  Mesh mesh = mesh_of(square(16));
  auto speed = mesh.add_property_map<Face, double>("f:speed", 1.).first;
  for(const Face f : mesh.faces())
    if(mesh.point(mesh.target(mesh.halfedge(f))).y() > 0.5)
      speed[f] = 3.;
  GP::Earth_movers_solver<Mesh> solver(mesh, GP::parameters::face_speed_map(speed));
  solver.compute(Vertex(17 * 6 + 1), Vertex(17 * 6 + 15));
  const auto line = solver.streamlines()(Vertex(17 * 6 + 1));
  expect_line(line);
  double highest = 0.;
  for(const auto& p : line.points)
    highest = std::max(highest, p.y());
  EXPECT_GE(highest, 0.5); // passes through the fast region
}

TEST(Streamline_tracer, works_on_clouds)
{
  const Surfels surfels = sphere_surfels(4);
  using Cloud = CGAL::Point_set_3<Kernel::Point_3>;
  Cloud cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  GP::Earth_movers_solver<Cloud> solver(cloud);
  const Cloud::Index from(3), to(900);
  solver.compute(from, to);
  const auto trace = solver.streamlines();
  const auto p = cloud.point(from), q = cloud.point(to);
  const double exact = great_circle({p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z()});
  std::vector<GP::Streamline<Cloud>> lines = {trace(from)};
  trace(20, std::back_inserter(lines));
  for(const auto& line : lines)
  {
    expect_line(line);
    EXPECT_TRUE(line.has_arrived);
    EXPECT_EQ(line.points.front(), p);
    EXPECT_EQ(line.points.back(), q);
    // Measured are 0.06 %.
    EXPECT_NEAR(line.length, exact, 0.002 * exact);
  }
}

TEST(Streamline_tracer, zero_flow_gives_trivial_lines)
{
  const Mesh mesh = mesh_of(square(4));
  GP::Earth_movers_solver<Mesh> solver(mesh);
  EXPECT_THROW(solver.streamlines(), GP::Invalid_argument_error);
  solver.compute(Vertex(3), Vertex(3));
  const auto trace = solver.streamlines();
  EXPECT_EQ(trace(Vertex(3)).length, 0.);
  EXPECT_EQ(trace(Vertex(9)).length, 0.);
  EXPECT_THROW(trace(Vertex(99)), GP::Invalid_argument_error);
  const auto zero_masses = boost::make_function_property_map<Vertex>([](Vertex) { return 0.; });
  solver.compute(zero_masses, zero_masses);
  std::vector<GP::Streamline<Mesh>> lines;
  solver.streamlines()(5, std::back_inserter(lines));
  EXPECT_TRUE(lines.empty());
}

} // namespace Streamline_tracer_test
