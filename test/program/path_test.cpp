// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command path.
#include "Program.h"

#include <cmath>
#include <string>
#include <vector>

namespace path_test {

using namespace program_test;

TEST_F(Program, cloud_path_is_not_longer_than_initial_path)
{
  for(const char* const method : {"projected-quadrics", "projected-spheres", "projected-planes",
                                  "spheres", "robust-spheres", "planes", "disks"})
  {
    const nlohmann::json path = json("path cloud.xyz --from 5 --to 143 --start -o p.vtp "
                                     "--surfel-path-method " +
                                     std::string(method));
    EXPECT_LE(path["front_distance"], path["start_length"]);
    // The file has six digits; measured are 2e-7.
    EXPECT_NEAR(path["front_distance"].get<double>(), std::hypot(6. / 11., 1.), 1e-6) << method;
  }
  EXPECT_LT(json("path cloud.xyz --from 5 --to 143 --control-points 3")["points"],
            json("path cloud.xyz --from 5 --to 143")["points"]);
}

TEST_F(Program, distances_and_paths_cross_nonmanifold_vertices)
{
  for(const char* const name : {"pinched.off", "bowtie.off"})
  {
    const nlohmann::json result =
        json(std::string("distance ") + name + " --source 1 --values d.txt");
    EXPECT_EQ(result["unreached"], 0) << name;
    const std::size_t other = std::string(name) == "bowtie.off" ? 4 : 3;
    EXPECT_NEAR(numbers("d.txt")[other], 2., round_off) << name;
    const nlohmann::json path =
        json(std::string("path ") + name + " --from 1 --to " + std::to_string(other));
    EXPECT_NEAR(path["length"].get<double>(), 2., round_off) << name;
  }
}

TEST_F(Program, path_on_a_square_is_straight)
{
  const nlohmann::json corner_path = json("path square.ply --from 0 --to 80 --values p.txt");
  EXPECT_NEAR(corner_path["length"].get<double>(), std::sqrt(2.), round_off);
  EXPECT_NEAR(corner_path["front_distance"].get<double>(), std::sqrt(2.), round_off);
  const std::vector<double> points = numbers("p.txt");
  EXPECT_EQ(points.size(), 3 * corner_path["points"].get<std::size_t>());
  EXPECT_EQ((std::vector<double>(points.begin(), points.begin() + 3)),
            (std::vector<double>{0, 0, 0}));
  EXPECT_EQ((std::vector<double>(points.end() - 3, points.end())), (std::vector<double>{1, 1, 0}));

  const nlohmann::json inner_path =
      json("path square.ply --from-at 0.1,0.2,0 --to-at 0.9,0.3,1 -o p.vtp");
  EXPECT_NEAR(inner_path["length"].get<double>(), std::hypot(0.8, 0.1), round_off);
  EXPECT_EQ(json("info p.vtp")["vertices"], inner_path["points"]);
  EXPECT_EQ(json("path square.ply --from 3 --to 3")["length"], 0.);

  for(const char* const method : {"dijkstra", "fast-marching", "euclidean", "heat"})
  {
    const nlohmann::json path =
        json(std::string("path square.ply --from 9 --to 71 --method ") + method);
    // Paths are straightened, whatever distances they follow.
    EXPECT_NEAR(path["length"].get<double>(), std::hypot(1., 0.75), round_off) << method;
  }
  // These distances are the method's own. Dijkstra passes 6 diagonals and 2 edges.
  EXPECT_NEAR(
      json("path square.ply --from 9 --to 71 --method dijkstra")["front_distance"].get<double>(),
      (6. * std::sqrt(2.) + 2.) / 8., round_off);
  const nlohmann::json exact =
      json("path square.ply --from-at 0.1,0.2,0 --to-at 0.9,0.3,1 --method exact");
  EXPECT_NEAR(exact["length"].get<double>(), std::hypot(0.8, 0.1), round_off);
  EXPECT_NEAR(exact["front_distance"].get<double>(), std::hypot(0.8, 0.1), round_off);
}

TEST_F(Program, path_follows_speeds)
{
  const nlohmann::json path = json("path square.ply --from 0 --to 80 --speed double_speed");
  EXPECT_NEAR(path["length"].get<double>(), std::sqrt(2.), round_off);
  // The travel time of a front: it is measured from vertex to vertex, and 1 % is its usual error.
  EXPECT_NEAR(path["front_distance"].get<double>(), std::sqrt(0.5), 0.01 * std::sqrt(0.5));
  // A plane has no curvature, so that all speeds are equal.
  const nlohmann::json on_cloud =
      json("path cloud.xyz --from 0 --to 143 --speed curvature-attractive");
  EXPECT_NEAR(on_cloud["length"].get<double>(), std::sqrt(2.), round_off);
  for(const char* const options : {"--locally-shortest", "--method heat", "--strength 2"})
    EXPECT_EQ(
        run(std::string("path square.ply --from 0 --to 80 --speed double_speed ") + options).code,
        1)
        << options;
}

TEST_F(Program, path_on_a_cloud_joins_endpoints)
{
  const nlohmann::json path = json("path cloud.xyz --from 0 --to 143 --values p.txt");
  // On a flat grid, the path is at least as long as the straight line and at most 1 % longer.
  EXPECT_GE(path["length"].get<double>(), std::sqrt(2.) * (1. - round_off));
  EXPECT_LE(path["length"].get<double>(), std::sqrt(2.) * 1.01);
  const std::vector<double> points = numbers("p.txt");
  ASSERT_GE(points.size(), 6u);
  // Surfel coordinates up to round-off errors.
  EXPECT_NEAR(points[0] + points[1], 0., round_off);
  EXPECT_NEAR(points[points.size() - 3] + points[points.size() - 2], 2., round_off);
}

} // namespace path_test
