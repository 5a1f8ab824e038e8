// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands emd, plan, barycenter, streamlines, fuzzy, volume and feature-distance.
#include "Program.h"
#include "readers/Surface_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace transport_test {

using namespace program_test;

TEST_F(Program, transport_distances_decrease_with_basis_size)
{
  const auto farthest = [&](const std::string& method)
  {
    const nlohmann::json found =
        json("distance square.ply --source 0 --values d.txt --method " + method);
    EXPECT_EQ(numbers("d.txt").size(), 81u);
    EXPECT_EQ(found["unreached"], 0);
    return found["max"].get<double>();
  };
  const double spectral = farthest("spectral"), some = farthest("emd --basis 5"),
               many = farthest("emd --basis 40"), biharmonic = farthest("biharmonic");
  EXPECT_EQ(json("distance square.ply --source 0 --method spectral")["basis"], 0);
  EXPECT_GE(json("distance square.ply --source 0 --method emd --basis 5")["basis"], 5);
  EXPECT_GT(some, many);
  // Masses are distributed over triangles of size 1/8, which shortens distances. Otherwise they are
  // never too short.
  EXPECT_GT(many, std::sqrt(2.) - 2. / 8.);
  EXPECT_GT(spectral, many);
  EXPECT_GT(biharmonic, 0.);
  const nlohmann::json matrix =
      json("matrix square.ply --sources 0,80 --method spectral --values m.txt");
  EXPECT_EQ(matrix["entries"], 4);
  const std::vector<double> entries = numbers("m.txt");
  EXPECT_EQ(entries[1], entries[2]);
  EXPECT_NEAR(entries[1], spectral, 1e-6); // single precision
  EXPECT_EQ(run("distance cloud.xyz --source 0 --method spectral --quiet").code, 0);
}

TEST_F(Program, emd_matches_known_costs)
{
  // From one corner of the unit square to the opposite corner.
  const nlohmann::json diagonal =
      json("emd square.ply --from 0 --to 80 --values p.txt -o e.ply --hodge --bound-above");
  const double exact = std::sqrt(2.);
  // Round-off error.
  EXPECT_LE(diagonal["lower"].get<double>(), exact * (1. + 1e-9));   // round-off errors
  EXPECT_NEAR(diagonal["value"].get<double>(), exact, 1e-3 * exact); // relative gap
  EXPECT_GE(diagonal["upper_continuous"].get<double>(), exact);
  const std::vector<double> potential = numbers("p.txt");
  ASSERT_EQ(potential.size(), 81u);
  EXPECT_NEAR(potential[80] - potential[0], diagonal["lower"].get<double>(), round_off);
  const std::string ply = read_file(m_folder / "e.ply");
  for(const char* const field : {"flow_z", "gradient_x", "rotation_y", "harmonic_z"})
    EXPECT_NE(ply.find(std::string("property double ") + field + "\n"), std::string::npos);
  EXPECT_EQ(json("info e.ply")["faces"], 128);

  // Masses as properties and as files. All mass moves by 0.25.
  std::string from, to;
  for(int i = 0; i < 81; ++i)
  {
    from += i % 9 == 2 ? "1\n" : "0\n";
    to += i % 9 == 4 ? "0.5\n" : "0\n";
  }
  write("from.txt", from);
  write("to.txt", to);
  expect_failure("emd square.ply --from from.txt --to to.txt", 2, "total masses");
  // The default gap.
  EXPECT_NEAR(json("emd square.ply --from from.txt --to to.txt --normalize")["value"].get<double>(),
              0.25, 1e-3);
  EXPECT_EQ(run("emd square.ply --from from.txt --to to.txt --normalize -o p.vtp --quiet").code, 0);
  EXPECT_EQ(json("emd p.vtp --from potential --to potential --density")["value"], 0.);
  // The requested gap.
  EXPECT_NEAR(
      json("emd square.ply --from 0 --to 8 --refine 1 --method admm --tolerance 0.01")["value"]
          .get<double>(),
      1., 0.01);
  // A lattice on the unit square.
  EXPECT_NEAR(json("emd cloud.xyz --from 0 --to 11 -o e.vtp")["value"].get<double>(), 1., 0.02);
  EXPECT_EQ(run("emd e.vtp --from flow_x --to flow_x --quiet").code, 0);

  // With a basis, results equal those of the distance commands. Mass distributions and flows are
  // supported too.
  const nlohmann::json some = json("emd square.ply --from 0 --to 80 --basis 5 --hodge -o b.ply");
  const auto entries =
      json("matrix square.ply --sources 0,80 --method emd --basis 5 --values d.txt");
  EXPECT_EQ(some["basis"], entries["basis"]);
  EXPECT_NEAR(some["value"].get<double>(), numbers("d.txt")[1], round_off);
  EXPECT_GT(some["lower"].get<double>(), 0.9 * exact); // masses are distributed around points
  const std::string flow = read_file(m_folder / "b.ply");
  EXPECT_NE(flow.find("property double rotation_x\n"), std::string::npos);
  EXPECT_EQ(flow.find("potential"), std::string::npos);
  const double lines =
      json("emd square.ply --from from.txt --to to.txt --normalize --basis 0")["value"];
  EXPECT_GT(lines, 0.25);
  EXPECT_LT(lines, 0.3); // the flow bends at the ends, whose mass per width is doubled
  EXPECT_EQ(run("emd cloud.xyz --from 0 --to 11 --basis 3 -o c.vtp --quiet").code, 0);

  expect_failure("emd square.ply --from 0", 1, "--to");
  expect_failure("emd square.ply --from 0 --to 80 --basis some", 1, "--basis some");
  expect_failure("emd square.ply --from 0 --to 80 --basis -1", 1, "--basis");
  expect_failure("emd square.ply --from 0 --to 80 --basis 3 --refine 1", 1, "complete");
  expect_failure("emd square.ply --from 0 --to 80 --basis 3 --values p.txt", 1, "complete");
  expect_failure("emd square.ply --from 0 --to 80 --method none", 1, "interior-point");
  expect_failure("emd square.ply --from 0 --to 80 --tolerance 0", 1, "--tolerance");
  expect_failure("emd square.ply --from 0 --to 80 -o e.obj", 1, "ply");
  expect_failure("emd square.ply --from 0 --to 81", 2, "81");
  expect_failure("emd square.ply --from 0 --to nothing", 2, "nothing");
  write("short.txt", "1\n2\n");
  expect_failure("emd square.ply --from 0 --to short.txt", 2, "the number of masses is 2");
  expect_failure("emd cloud.xyz --from 0 --to 11 --bound-above", 2, "needs a mesh");
}

TEST_F(Program, plan_transports_to_a_region)
{
  // From the midpoints of the left and lower boundary edges to the two right corners.
  const nlohmann::json two = json("plan square.ply --from 45,6 --to 8,80 -o p.ply --hodge");
  EXPECT_NEAR(two["value"].get<double>(), 0.5 * (std::sqrt(1. + 9. / 64.) + 0.25), 2e-3);
  for(const double arrival : two["arrivals"])
    EXPECT_NEAR(arrival, 0.5,
                0.02); // the other corner is 0.07 farther away, which is fifty times the gap
  const std::string ply = read_file(m_folder / "p.ply");
  for(const char* const field : {"arrivals", "potential", "flow_x", "rotation_z"})
    EXPECT_NE(ply.find(std::string("property double ") + field + "\n"), std::string::npos);
  // To a property: the arrivals of the previous result.
  EXPECT_NEAR(json("plan p.ply --from 0 --to arrivals")["value"].get<double>(), 1., 1e-3);
  EXPECT_NEAR(json("plan cloud.xyz --from 0 --to 11,12")["value"].get<double>(), 1. / 11., 1e-3);

  // The nearest corner has too little capacity, given by numbers or by a property. Also tests
  // uniform spreading.
  const nlohmann::json full = json("plan square.ply --from 45 --to 8,80 --capacity 0.7,0.6");
  EXPECT_NEAR(full["arrivals"][1].get<double>(), 0.6, 0.02);
  const nlohmann::json halves = json("plan p.ply --from 45 --to arrivals --capacity arrivals");
  const double to_both = 0.5 * (std::hypot(1., 0.625) + std::hypot(1., 0.375));
  EXPECT_NEAR(halves["value"].get<double>(), to_both,
              0.02); // a fraction of an edge length at the split of the flow
  const nlohmann::json even = json("plan square.ply --from 45 --to 8,80 --spread 100");
  EXPECT_NEAR(even["arrivals"][0].get<double>(), 0.5, 0.01);
  // To a polyline from the corner (0, 0) to (1, 0.5), and to a location in a face.
  EXPECT_NEAR(json("plan square.ply --from 72 --to-path 0,44")["value"].get<double>(),
              2. / std::sqrt(5.), 2e-3);
  EXPECT_NEAR(
      json("plan square.ply --from 8 --to-at 0.52,0.33,0 --to 0 --capacity 0.5,0.5")["value"]
          .get<double>(),
      0.5 * (1. + std::hypot(0.48, 0.33)), 0.02); // same tolerance as above
  expect_failure("plan square.ply --from 0 --to-path 80", 1, "two vertices");
  expect_failure("plan square.ply --from 0 --to-path 80,81", 2, "81");
  expect_failure("plan square.ply --from 0 --to-at 1,2", 1, "--to-at");
  expect_failure("plan cloud.xyz --from 0 --to-at 0,0,0", 2, "need a mesh");
  expect_failure("plan square.ply --from 45 --to 8 --to-path 0,80 --capacity 0.7", 1, "paths");
  expect_failure("plan p.ply --from 45 --to-path 0,80 --capacity arrivals", 1, "--to-path");
  expect_failure("plan square.ply --from 45 --to 8,80 --capacity 0.7", 1, "must be 2");
  expect_failure("plan square.ply --from 45 --to 8,80 --capacity 0.3,0.6", 2, "capacity");
  expect_failure("plan square.ply --from 45 --to 8,80 --capacity none", 2, "none");
  expect_failure("plan square.ply --from 45 --to 8,80 --spread -1", 2, "spreading");
  expect_failure("plan square.ply --from 0", 1, "--to");
  expect_failure("plan square.ply --from 0 --to 81", 2, "81");
  expect_failure("plan square.ply --from 0 --to nothing", 2, "nothing");
  expect_failure("plan cloud.xyz --from 0 --to 11 --bound-above", 2, "needs a mesh");
}

TEST_F(Program, gradient_and_remainder_sum_to_the_tangential_flow_on_a_cloud)
{
  write("ball.xyz", ball_cloud());
  for(const char* const command :
      {"emd ball.xyz --from 0 --to 11", "emd ball.xyz --from 0 --to 11 --basis 3",
       "plan ball.xyz --from 0 --to 1,2", "emd cloud.xyz --from 0 --to 11"})
    for(const char* const name : {"h.ply", "h.vtp"})
    {
      SCOPED_TRACE(command);
      EXPECT_EQ(run(std::string(command) + " --hodge --quiet -o " + name).code, 0);
      const program::Surface_file file = program::read_surface_file(m_folder / name);
      double max_flow = 0., max_gradient = 0., max_error = 0.;
      for(std::size_t i = 0; i < file.points.size(); ++i)
      {
        const auto vector = [&](const std::string& field)
        {
          return program::Point{file.properties.at(field + "_x")[i],
                                file.properties.at(field + "_y")[i],
                                file.properties.at(field + "_z")[i]};
        };
        const program::Point flow = vector("flow"), gradient = vector("gradient"),
                             remainder = vector("remainder"), normal = file.normals[i];
        // The flow is the mean over triangles, so it has a small component along the normal.
        const double height = flow[0] * normal[0] + flow[1] * normal[1] + flow[2] * normal[2];
        for(std::size_t c = 0; c < 3; ++c)
        {
          max_flow = std::max(max_flow, std::abs(flow[c]));
          max_gradient = std::max(max_gradient, std::abs(gradient[c]));
          max_error = std::max(max_error,
                               std::abs(gradient[c] + remainder[c] - flow[c] + height * normal[c]));
        }
      }
      EXPECT_GT(max_flow, 0.);
      EXPECT_GT(max_gradient, 0.1 * max_flow);
      EXPECT_LT(max_error, 1e-12 * max_flow); // round-off errors
      EXPECT_EQ(file.properties.count("rotation_x"), 0u);
    }
}

TEST_F(Program, barycenter_lies_between_masses)
{
  // Barycenter of two opposite corners at distance sqrt(2).
  const nlohmann::json two = json("barycenter square.ply --points 0,80 --values b.txt -o b.ply");
  EXPECT_NEAR(two["value"].get<double>(), 1., 0.01); // relative gap
  EXPECT_EQ(two["point"], 40);
  EXPECT_NEAR(two["point_value"].get<double>(), 1., 1e-9);
  const std::string ply = read_file(m_folder / "b.ply");
  for(const char* const field : {"mass", "density"})
    EXPECT_NE(ply.find(std::string("property double ") + field + "\n"), std::string::npos);
  // The barycenter is equally far from both corners. The barycenter of it and itself is itself.
  EXPECT_NEAR(json("emd b.ply --from mass --to 0 --normalize")["value"].get<double>(),
              std::sqrt(0.5), 0.08);
  // Squares of round-off errors of distances.
  EXPECT_LT(json("barycenter b.ply --of mass --of b.txt")["value"], 1e-12);
  EXPECT_LT(json("barycenter b.ply --of density --of density --density")["value"], 1e-12);
  EXPECT_FALSE(json("barycenter b.ply --of 0,80 --of 8 --normalize").contains("point"));
  // One point has the whole weight.
  const nlohmann::json one =
      json("barycenter square.ply --points 0,80,8 --weight 0 --weight 0 --weight 2");
  EXPECT_EQ(one["value"], 0.);
  EXPECT_EQ(one["point"], 8);
  // The relative gap of barycenters.
  EXPECT_NEAR(json("barycenter cloud.xyz --points 0,11")["value"].get<double>(), 0.5, 0.01);

  expect_failure("barycenter square.ply", 1, "--of");
  expect_failure("barycenter square.ply --points 0,81", 2, "81");
  expect_failure("barycenter square.ply --of nothing", 2, "nothing");
  expect_failure("barycenter square.ply --points 0,80 --weight 1", 1, "--weight");
  expect_failure("barycenter square.ply --points 0,80 --weight 1 --weight -1", 2, "weight");
  expect_failure("barycenter square.ply --points 0,80 --density", 1, "--density");
  expect_failure("barycenter square.ply --points 0,80 --tolerance 0", 1, "--tolerance");
}

TEST_F(Program, streamlines_end_at_the_target)
{
  // From the lower left corner to the two adjacent corners.
  const nlohmann::json lines =
      json("streamlines square.ply --from 0 --to 8,72 --number 20 -o l.obj");
  EXPECT_EQ(lines["lines"], 20);
  EXPECT_EQ(lines["arrived"], 20);
  EXPECT_NEAR(lines["mean_length"].get<double>(), 1., 1e-9); // round-off errors
  EXPECT_NE(read_file(m_folder / "l.obj").find("\nl "), std::string::npos);
  EXPECT_NEAR(
      json("streamlines square.ply --from 0 --to 80 --seeds 0")["mean_length"].get<double>(),
      std::sqrt(2.), round_off);
  EXPECT_GE(
      json("streamlines square.ply --from 1 --to 78 --as-traced")["mean_length"].get<double>(),
      std::hypot(5. / 8., 1.));
  EXPECT_EQ(json("streamlines cloud.xyz --from 0 --to 11,12 --number 7")["arrived"], 7);

  expect_failure("streamlines square.ply --from 0", 1, "--to");
  expect_failure("streamlines square.ply --from 0 --to 81", 2, "81");
  expect_failure("streamlines square.ply --from 0 --to 80 --seeds 99", 2, "99");
}

TEST_F(Program, fuzzy_likelihood_is_high_between_endpoints)
{
  EXPECT_EQ(run("fuzzy square.ply --from 36 --to 44 --width 0.15 --values f.txt --quiet").code, 0);
  EXPECT_EQ(
      run("fuzzy square.ply --from 36 --to 44 --by-distances --values d.txt -o d.ply --quiet").code,
      0);
  const std::vector<double> flow = numbers("f.txt"), detour = numbers("d.txt");
  ASSERT_EQ(flow.size(), 81u);
  ASSERT_EQ(detour.size(), 81u);
  EXPECT_NEAR(detour[40], 1., 1e-9); // no detour up to round-off errors
  EXPECT_GT(flow[40], 0.5);
  for(const std::size_t corner : {0u, 8u, 72u, 80u})
  {
    EXPECT_LT(flow[corner], 0.1);
    // The detour is twelve widths long.
    EXPECT_LT(detour[corner], 1e-4);
  }
  EXPECT_EQ(run("fuzzy cloud.xyz --from 0 --to 11 --quiet").code, 0);

  expect_failure("fuzzy square.ply --from 0", 1, "--to");
  expect_failure("fuzzy square.ply --from 0 --to 0", 1, "different");
  expect_failure("fuzzy square.ply --from 0 --to 9 --width 0", 1, "--width");
  expect_failure("fuzzy square.ply --from 0 --to 99", 2, "99");
}

TEST_F(Program, volume_computes_distances_and_paths)
{
  // An octahedron with a vertex at 1 and at -1 on each axis.
  write("o.off", "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                 "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  const nlohmann::json pair =
      json("volume o.off --from 0.2,0,0 --to=-0.2,0,0 --bound-above -o v.ply --values v.txt");
  EXPECT_GE(pair["lower"].get<double>(), 0.4);
  EXPECT_LE(pair["lower"].get<double>(), pair["value"].get<double>());
  EXPECT_LE(pair["value"].get<double>(), pair["upper"].get<double>());
  EXPECT_LE(pair["upper"].get<double>(), pair["upper_continuous"].get<double>());
  EXPECT_NE(read_file(m_folder / "v.ply").find("property double potential\n"), std::string::npos);
  // Each octahedron vertex has unit mass.
  EXPECT_NEAR(json("volume o.off --from 1,0,0 --to 0,1,0")["value"].get<double>(), std::sqrt(2.),
              2e-3);
  const nlohmann::json slice =
      json("volume o.off --from 0.2,0,0 --slice z,0.1 --slice x,2 --resolution 7 --values s.txt "
           "-o s.ply");
  EXPECT_EQ(slice["points"], 98); // 7 x 7 points, twice
  EXPECT_LE(slice["gap"].get<double>(), 0.02);
  EXPECT_GE(slice["max"].get<double>(), 2.);
  EXPECT_NE(read_file(m_folder / "s.ply").find("property double distance\n"), std::string::npos);
  const nlohmann::json path =
      json("volume o.off --from 0.4,0.1,0 --to=-0.4,0.1,0 --path -o p.obj --values p.txt");
  EXPECT_TRUE(path["arrives"]);
  EXPECT_GE(path["length"].get<double>(), 0.8);

  expect_failure("volume o.off --from 0,0,0", 1, "--to or --slice");
  expect_failure("volume o.off --from 0,0,0 --to 1,1,1 --slice z,0", 1, "--to or --slice");
  expect_failure("volume o.off --from 0,0 --to 1,1,1", 1, "x,y,z");
  expect_failure("volume o.off --from 0,0,0 --slice w,0", 1, "like z,0.5");
  for(const char* const slice : {"z,a", "z,", "z", "z,inf", "z,1,2"})
    expect_failure(std::string("volume o.off --from 0,0,0 --slice ") + slice, 1,
                   std::string("--slice ") + slice + ": a slice must be an axis and a number");
  expect_failure("volume o.off --from 0,0,0 --to 1,0,0 --tolerance 0", 1, "--tolerance");
  expect_failure("volume o.off --from 0,0,0 --to 3,0,0 --path", 2, "different sides");
  expect_failure("volume square.ply --from 0,0,0 --to 1,0,0", 2, "not closed");
  expect_failure("volume cloud.xyz --from 0,0,0 --to 1,0,0", 2, "closed mesh");
}

TEST_F(Program, feature_distance_matches_known_distances)
{
  const nlohmann::json border =
      json("feature-distance square.ply --border --values d.txt -o d.ply");
  const std::vector<double> distances = numbers("d.txt");
  ASSERT_EQ(distances.size(), 81u);
  EXPECT_EQ(distances[0], 0.);
  EXPECT_LE(border["max"].get<double>(), 0.5 * (1. + 1e-9)); // round-off errors
  EXPECT_NEAR(border["max"].get<double>(), 0.5,
              0.5 / 16.); // a fraction of an edge length at the crease
  EXPECT_NEAR(border["value"].get<double>(), 1. / 6., 0.01); // same error of the integral
  // The feature consists of all vertices except the boundary. A corner is as far as its nearest
  // interior vertex.
  EXPECT_NEAR(json("feature-distance d.ply --feature distance")["max"].get<double>(),
              std::sqrt(2.) / 8., 0.02);
  EXPECT_EQ(run("feature-distance cloud.xyz --feature 0,1 --quiet").code, 0);
  // For locations in faces, the distance is at most a fraction of the edge length 0.125 too short.
  EXPECT_NEAR(json("feature-distance square.ply --feature-at 0.52,0.33,0")["max"].get<double>(),
              std::hypot(0.52, 0.67), 0.05);
  // Edges split the faces along the path. The remaining error is the gap of 0.1 %.
  EXPECT_NEAR(json("feature-distance square.ply --feature-path 0,44")["max"].get<double>(),
              2. / std::sqrt(5.), 2e-3);
  // The gap.
  EXPECT_NEAR(json("feature-distance square.ply --feature 72 --feature-path 0,44,8 --border")["max"]
                  .get<double>(),
              0.375, 1e-3);

  // Of a single point, the dual potential with fixed masses is the distance, up to half an edge.
  EXPECT_NEAR(json("feature-distance square.ply --feature 0 --fixed-masses")["max"].get<double>(),
              std::sqrt(2.), 0.5 / 8.);
  expect_failure("feature-distance square.ply", 1, "--feature");
  expect_failure("feature-distance square.ply --feature 99", 2, "99");
  expect_failure("feature-distance cloud.xyz --border", 2, "no boundary");
  expect_failure("feature-distance cloud.xyz --feature-path 0,1", 2, "need a mesh");
}

} // namespace transport_test
