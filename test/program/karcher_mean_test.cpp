// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command karcher-mean.
#include "Program.h"

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace karcher_mean_program_test {

using namespace program_test;

using Point = std::array<double, 3>;

double distance(const Point& p, const Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Returns the last vertex of an OBJ file: the end of its last path.
Point last_vertex(const std::string& obj)
{
  std::istringstream stream(obj.substr(obj.rfind("\nv ") + 3));
  Point result = {0., 0., 0.};
  for(double& coordinate : result)
    stream >> coordinate;
  return result;
}

// The tolerance of the gradient, 1e-8, times a distance of at most 2. In the plane, the error of the
// mean is the gradient.
constexpr double gradient_tolerance = 2e-8;

TEST_F(Program, karcher_mean_in_plane_is_centroid)
{
  const nlohmann::json mean =
      json("karcher-mean square.ply --points 0,8 --point-at 0.9,0.7,3 --weight 1 --weight 1 "
           "--weight 2 --values m.txt -o paths.obj");
  const Point centroid = {0.7, 0.35, 0.};
  EXPECT_LT(distance(mean["mean"].get<Point>(), centroid), gradient_tolerance);
  EXPECT_LT(mean["gradient_norm"].get<double>(), gradient_tolerance);
  EXPECT_TRUE(mean["converged"]);
  // The sum of the weights times the squared distances of (0, 0), (1, 0) and (0.9, 0.7)
  const double value = (0.49 + 0.1225) + (0.09 + 0.1225) + 2. * (0.04 + 0.1225);
  // The error of the value is the squared error of the mean, 4e-16, besides round-off errors.
  EXPECT_NEAR(mean["value"].get<double>(), value, round_off);

  // A location of the grid with nine columns
  const std::vector<double> location = numbers("m.txt");
  ASSERT_EQ(location.size(), 6u);
  Point point = {0., 0., 0.};
  for(std::size_t k = 0; k < 3; ++k)
  {
    const int vertex = int(location[k]);
    point[0] += location[3 + k] * (vertex % 9) / 8.;
    point[1] += location[3 + k] * (vertex / 9) / 8.;
  }
  EXPECT_LT(distance(point, mean["mean"].get<Point>()), round_off);

  const std::string paths = read_file(m_folder / "paths.obj");
  std::size_t number_of_paths = 0;
  for(std::size_t i = paths.find("\nl "); i != std::string::npos; i = paths.find("\nl ", i + 1))
    ++number_of_paths;
  EXPECT_EQ(number_of_paths, 3u);
  EXPECT_LT(distance(last_vertex(paths), mean["mean"].get<Point>()), round_off);
}

TEST_F(Program, karcher_mean_on_cloud_is_midpoint)
{
  write("ball.xyz", ball_cloud());
  const auto points = CGAL::Geodesic_processing::test::icosphere(3).points;
  // The first vertex, and one at a distance of about 1
  std::size_t other = 1;
  const auto cosine = [&](std::size_t i) {
    return points[0][0] * points[i][0] + points[0][1] * points[i][1] + points[0][2] * points[i][2];
  };
  for(std::size_t i = 1; i < points.size(); ++i)
    if(std::abs(cosine(i) - std::cos(1.)) < std::abs(cosine(other) - std::cos(1.)))
      other = i;
  const double angle = std::acos(cosine(other)), length = 2. * std::cos(0.5 * angle);
  Point midpoint;
  for(std::size_t k = 0; k < 3; ++k)
    midpoint[k] = (points[0][k] + points[other][k]) / length;
  const nlohmann::json mean = json("karcher-mean ball.xyz --points 0," + std::to_string(other) +
                                   " --values m.txt -o paths.obj");
  // The tolerance of the gradient on clouds; measured are errors of the mean of at most 5e-6.
  constexpr double cloud_tolerance = 1e-5;
  EXPECT_LT(distance(mean["mean"].get<Point>(), midpoint), cloud_tolerance);
  EXPECT_LT(mean["gradient_norm"].get<double>(), cloud_tolerance);
  // The squared error of the mean, and errors of the fit; measured are 5e-11.
  EXPECT_NEAR(mean["value"].get<double>(), 0.5 * angle * angle, 1e-9);
  EXPECT_TRUE(mean["converged"]);
  ASSERT_EQ(numbers("m.txt").size(), 1u);
  const auto surfel = std::size_t(numbers("m.txt")[0]);
  // The spacing of the surfels is at most 0.17.
  EXPECT_LT(distance({points[surfel][0], points[surfel][1], points[surfel][2]}, midpoint), 0.17);
  // Much closer than the points, whose distance is 0.5
  EXPECT_LT(distance(last_vertex(read_file(m_folder / "paths.obj")), midpoint), 1e-3);
}

// On a square tube, two points on opposite sides have a minimum on each of the other sides.
TEST_F(Program, karcher_mean_depends_on_initial_location)
{
  write("tube.off", "OFF\n8 8 0\n-.5 -.5 0\n.5 -.5 0\n.5 .5 0\n-.5 .5 0\n-.5 -.5 1\n.5 -.5 1\n"
                    ".5 .5 1\n-.5 .5 1\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
                    "3 3 0 4\n3 3 4 7\n");
  const std::string command = "karcher-mean tube.off --point-at=-.5,0,.5 --point-at .5,0,.5 ";
  for(const auto& [initial, y] : {std::pair{"--initial-at .1,.5,.4", 0.5},
                                  {"--initial-at .1,-.5,.4", -0.5},
                                  {"--initial 2", 0.5},
                                  {"--initial 0", -0.5}})
  {
    const nlohmann::json mean = json(command + initial);
    EXPECT_LT(distance(mean["mean"].get<Point>(), {0., y, 0.5}), gradient_tolerance) << initial;
    EXPECT_NEAR(mean["value"].get<double>(), 2., gradient_tolerance);
  }
}

TEST_F(Program, karcher_mean_reports_missing_convergence)
{
  const std::string command = "karcher-mean square.ply --points 0,8,80 --initial 40 ";
  EXPECT_FALSE(json(command + "--iterations 0")["converged"]);
  EXPECT_TRUE(json(command + "--iterations 0 --tolerance 1")["converged"]);
  EXPECT_TRUE(json(command)["converged"]);
  EXPECT_NE(run(command + "--iterations 0").err.find("--tolerance"), std::string::npos);
}

TEST_F(Program, karcher_mean_rejects_invalid_options)
{
  expect_failure("karcher-mean square.ply", 1, "--points");
  expect_failure("karcher-mean square.ply --points x", 1, "--points");
  expect_failure("karcher-mean square.ply --points 0,81", 2, "81");
  expect_failure("karcher-mean square.ply --point-at 0,0", 1, "--point-at");
  expect_failure("karcher-mean square.ply --points 0,80 --weight 1", 1, "--weight");
  expect_failure("karcher-mean square.ply --points 0 --weight -1", 2, "weight");
  expect_failure("karcher-mean square.ply --points 0 --weight 0", 2, "weight");
  expect_failure("karcher-mean square.ply --points 0 --initial 1,2", 1, "--initial");
  expect_failure("karcher-mean square.ply --points 0 --initial 1 --initial-at 0,0,0", 1,
                 "--initial-at");
  expect_failure("karcher-mean square.ply --points 0 --initial 81", 2, "81");
  for(const char* const tolerance : {"-1", "nan"})
    expect_failure(std::string("karcher-mean square.ply --points 0 --tolerance ") + tolerance, 1,
                   "--tolerance");
  expect_failure("karcher-mean square.ply --points 0 -o a.off", 1, "a.off");
  expect_failure("karcher-mean apart.off --points 0,3", 2, "component");
  expect_failure("karcher-mean apart.off --points 6", 2, "vertex 6 has no face");
}

} // namespace karcher_mean_program_test
