// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Surfel_path_finder.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfel_estimation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>

#include "Mesh_of.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Surfel_path_finder_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Exact_points = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_set = CGAL::Point_set_3<Exact_points::Point_3>;

// Relative round-off errors of lengths of polylines and of coordinates near 1.
constexpr double round_off = 1e-12;

const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());

double great_circle(const Kernel::Point_3& p, const Kernel::Point_3& q)
{
  return 2. * std::asin(std::min(1., 0.5 * std::sqrt(CGAL::squared_distance(p, q))));
}

TEST(Surfel_path_finder, finds_great_circles)
{
  const Surfels surfels = sphere_surfels(3);
  GP::Surfel_path_finder<Surfels> finder(surfels, maps);
  EXPECT_EQ(finder.number_of_surfels(), surfels.size());
  EXPECT_EQ(finder.number_of_components(), 1u);
  for(std::size_t to = 1; to < surfels.size(); to += 37)
  {
    const auto path = finder(std::size_t(0), to);
    const double expected = great_circle(surfels[0].first, surfels[to].first);
    EXPECT_NEAR(path.front_distance, expected, 1e-8); // fourth-order error with steps of 0.01
    EXPECT_LE(path.length, path.front_distance * (1. + round_off));
    EXPECT_LE(path.front_distance, path.initial_length * (1. + round_off));
    ASSERT_EQ(path.points.size(), path.locations.size());
    EXPECT_EQ(path.points.front(), surfels[0].first);
    EXPECT_EQ(path.points.back(), surfels[to].first);
    EXPECT_EQ(path.locations.front().surfel, 0u);
    EXPECT_EQ(path.locations.back().surfel, to);
    EXPECT_GT(path.number_of_control_points, 0u);
    for(const auto& level : path.levels)
      EXPECT_LE(level.last_energy, level.first_energy);
  }
}

TEST(Surfel_path_finder, locations_refer_to_nearest_surfels)
{
  const Surfels surfels = sphere_surfels(3);
  GP::Surfel_path_finder<Surfels> finder(surfels, maps);
  const auto path = finder(std::size_t(3), std::size_t(500));
  for(std::size_t i = 0; i < path.points.size(); ++i)
  {
    const auto& [surfel, offset] = path.locations[i];
    const auto& [center, normal] = surfels[surfel];
    double min_squared_distance = std::numeric_limits<double>::infinity();
    for(const auto& [other, other_normal] : surfels)
      min_squared_distance =
          std::min(min_squared_distance, CGAL::squared_distance(other, path.points[i]));
    // Two surfels may be equally close.
    EXPECT_LE(CGAL::squared_distance(center, path.points[i]), min_squared_distance * (1. + 1e-9));
    // The offsets are measured in the surfel's tangent plane.
    const double tangential_square = offset[0] * offset[0] + offset[1] * offset[1];
    const double normal_component =
        (path.points[i] - center) * normal / std::sqrt(normal.squared_length());
    // Round-off errors of squares.
    EXPECT_NEAR(tangential_square + normal_component * normal_component,
                CGAL::squared_distance(center, path.points[i]), 1e-14);
  }
}

TEST(Surfel_path_finder, accepts_point_sets)
{
  const Surfels surfels = sphere_surfels(2);
  Point_set points(true);
  for(const auto& [p, n] : surfels)
    points.insert({p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()});
  points.remove(points.begin() + 5);
  GP::Surfel_path_finder<Point_set> finder(points);
  const auto path = finder(*points.begin(), *(points.begin() + 17));
  EXPECT_EQ(path.locations.back().surfel, *(points.begin() + 17));
  EXPECT_EQ(path.points.back(), points.point(*(points.begin() + 17)));
  EXPECT_THROW(finder(*points.begin(), Point_set::Index(1u << 20)), GP::Invalid_argument_error);
}

TEST(Surfel_path_finder, connects_locations)
{
  const Surfels surfels = flat_surfels(2000);
  GP::Surfel_path_finder<Surfels> finder(surfels, maps);
  using Location = GP::Surfel_path_finder<Surfels>::Location;
  const auto& p = surfels[1].first;
  const auto& q = surfels[2].first;
  // In a plane, all surfels have its normal. A tangent plane has an origin and two axes.
  const auto path = finder(Location{1, {0.003, 0.}}, Location{2, {0., 0.004}});
  const double direct = std::sqrt(CGAL::squared_distance(p, q));
  EXPECT_NEAR(std::sqrt(CGAL::squared_distance(path.points.front(), p)), 0.003, round_off);
  EXPECT_NEAR(std::sqrt(CGAL::squared_distance(path.points.back(), q)), 0.004, round_off);
  EXPECT_NEAR(path.front_distance,
              std::sqrt(CGAL::squared_distance(path.points.front(), path.points.back())),
              round_off);
  EXPECT_NEAR(path.front_distance, direct, 0.007 * (1. + round_off));
  EXPECT_THROW(finder(Location{1, {std::nan(""), 0.}}, Location{2, {0., 0.}}),
               GP::Invalid_argument_error);
}

TEST(Surfel_path_finder, locates_points)
{
  const Surfels surfels = flat_surfels(2000);
  GP::Surfel_path_finder<Surfels> finder(surfels, maps);
  const Kernel::Point_3 from(0.21, 0.34, 0.), to(0.81, 0.72, 0.);
  const auto path = finder(finder.locate(from), finder.locate(to));
  EXPECT_LT(CGAL::squared_distance(path.points.front(), from), round_off * round_off);
  EXPECT_LT(CGAL::squared_distance(path.points.back(), to), round_off * round_off);
  const auto above = finder.locate(surfels[7].first + Kernel::Vector_3(0., 0., 3.));
  EXPECT_EQ(above.surfel, 7u);
  EXPECT_NEAR(std::hypot(above.offset[0], above.offset[1]), 0., round_off);
  EXPECT_THROW(finder.locate(Kernel::Point_3(std::nan(""), 0., 0.)), GP::Invalid_argument_error);
  const Surfels no_surfels;
  GP::Surfel_path_finder<Surfels> empty_finder(no_surfels, maps);
  EXPECT_THROW(empty_finder.locate(from), GP::Invalid_argument_error);
}

TEST(Surfel_path_finder, agrees_between_methods)
{
  const Surfels surfels = sphere_surfels(4);
  const double expected = great_circle(surfels[0].first, surfels[1000].first);
  for(const auto method :
      {GP::Surfel_path_method::projected_quadrics, GP::Surfel_path_method::projected_spheres,
       GP::Surfel_path_method::projected_planes, GP::Surfel_path_method::spheres,
       GP::Surfel_path_method::robust_spheres, GP::Surfel_path_method::planes,
       GP::Surfel_path_method::disks})
  {
    GP::Surfel_path_finder<Surfels> finder(surfels, maps.surfel_path_method(method)
                                                        .node_weight(0.7)
                                                        .segment_weight(0.7)
                                                        .number_of_control_points(60));
    // The 2,500 disks have radius 0.06 and touch the sphere at their centers. The error is 0.1 %
    // of the sphere's radius.
    EXPECT_NEAR(finder(std::size_t(0), std::size_t(1000)).front_distance, expected,
                4e-3 * expected);
  }
}

TEST(Surfel_path_finder, agrees_between_search_methods)
{
  const Surfels surfels = flat_surfels(1000);
  double expected = 0.;
  for(const auto search : {GP::Surfel_search::dijkstra, GP::Surfel_search::bidirectional,
                           GP::Surfel_search::a_star, GP::Surfel_search::coarse_to_fine})
  {
    GP::Surfel_path_finder<Surfels> finder(surfels, maps.surfel_search(search));
    const double found = finder(std::size_t(0), std::size_t(700)).front_distance;
    if(expected == 0.)
      expected = found;
    EXPECT_EQ(found, expected);
  }
}

std::vector<GP::internal::Vec3> coordinates(const Point_set& points)
{
  std::vector<GP::internal::Vec3> result;
  for(const auto& p : points.points())
    result.push_back({p.x(), p.y(), p.z()});
  return result;
}

Point_set point_set(const Cloud& cloud)
{
  Point_set result(true);
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const auto &p = cloud.points[i], &n = cloud.normals[i];
    result.insert({p[0], p[1], p[2]}, {n[0], n[1], n[2]});
  }
  return result;
}

// Returns a cloud whose points deviate by up to a fraction of the spacing.
Point_set rough(const Cloud& cloud, double spacing, double level)
{
  return point_set(with_noise(cloud, std::vector<double>(cloud.size(), spacing), level, 1));
}

// A hilly square with a hole. The density on the left is 17 times that on the right.
Cloud uneven_hills()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  Cloud result;
  while(result.size() < 8000)
  {
    const double u = unit(random), x = 0.2 * u + 0.8 * u * u * u * u, y = unit(random);
    if(std::hypot(x - 0.3, y - 0.5) < 0.15)
      continue;
    const double height = 0.05 * std::sin(9. * x) * std::cos(8. * y);
    result.add({x, y, height}, GP::internal::unit({-0.45 * std::cos(9. * x) * std::cos(8. * y),
                                                   0.4 * std::sin(9. * x) * std::sin(8. * y), 1.}));
  }
  return result;
}

// The unit sphere with normally distributed noise: points deviate by 1.7 times their spacing, and
// normals by 18 degrees.
Point_set noisy_sphere(std::size_t n)
{
  const double spacing = std::sqrt(4. * CGAL_PI / double(n));
  std::mt19937 random(1);
  std::normal_distribution<double> offset(0., 1.7 * spacing), slope(0., 0.27);
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
  {
    const GP::internal::Vec3 p = on_spiral(i, n);
    const auto [u, v] = GP::internal::tangent_frame(p);
    cloud.add((1. + offset(random)) * p,
              GP::internal::unit(p + slope(random) * u + slope(random) * v));
  }
  return point_set(cloud);
}

// Appends a scan with normals, which are estimated if the file has none, if the file exists.
void add_scan(std::vector<std::pair<std::string, Point_set>>& scans, const std::string& name)
{
  Point_set points;
  const std::string file = model("points/" + name);
  if(file.empty())
    return;
  if(!CGAL::IO::read_point_set(file, points))
    throw std::runtime_error("Not readable: " + name);
  if(!points.has_normal_map())
  {
    points.add_normal_map();
    const auto normals = GP::internal::estimate_surfels(coordinates(points), 18, 0.).normals;
    for(std::size_t i = 0; i < normals.size(); ++i)
      points.normal(*(points.begin() + i)) = {normals[i][0], normals[i][1], normals[i][2]};
  }
  scans.emplace_back(name, std::move(points));
}

// Checks random paths and calls `visit(path)`. The distance of path points to the nearest surfel
// must not exceed the 95th percentile of the local spacing.
template <typename Visit>
void expect_path_points_near_surfels(const Point_set& points, int number_of_paths,
                                     const Visit& visit)
{
  std::vector<GP::internal::Vec3> points_of_cloud = coordinates(points);
  std::vector<GP::internal::Index> order;
  const GP::internal::Kd_tree tree(points_of_cloud, order);
  std::vector<GP::internal::Kd_tree::Neighbor> neighbors;
  // Spacing is the distance to the sixth neighbor, as many as a surfel of a uniform cloud has.
  std::vector<double> spacing;
  for(const auto& p : points_of_cloud)
  {
    tree.nearest(points_of_cloud, p, 7, neighbors);
    spacing.push_back(std::sqrt(neighbors.back().squared_distance));
  }
  GP::Surfel_path_finder<Point_set> finder(points, GP::parameters::number_of_threads(2));
  std::mt19937 random(1);
  for(int i = 0; i < number_of_paths; ++i)
  {
    const auto path = finder(*(points.begin() + random() % points.size()),
                             *(points.begin() + random() % points.size()));
    EXPECT_LE(path.front_distance, path.initial_length * (1. + round_off));
    for(const auto& p : path.points)
    {
      tree.nearest(points_of_cloud, {p.x(), p.y(), p.z()}, 60, neighbors);
      std::vector<double> spacings;
      for(const auto& neighbor : neighbors)
        spacings.push_back(spacing[neighbor.point]);
      std::nth_element(spacings.begin(), spacings.begin() + 57, spacings.end());
      EXPECT_LE(std::sqrt(neighbors.front().squared_distance), spacings[57]);
    }
    visit(path);
  }
}

TEST(Surfel_path_finder, stays_near_surfels_of_scans)
{
  std::vector<std::pair<std::string, Point_set>> scans;
  scans.emplace_back("torus", rough(torus_cloud(8000, 0.4), 0.045, 0.3));
  scans.emplace_back("ellipsoid", rough(ellipsoid_cloud(6000, {1., 1.5, 0.6}), 0.05, 0.3));
  for(const char* const name :
      {"bunny_scan_bun000_40k.ply", "ball_31k.ply", "kitten_normals_5k.xyz"})
    add_scan(scans, name);
  for(const auto& scan : scans)
  {
    SCOPED_TRACE(scan.first);
    const Point_set& points = scan.second;
    expect_path_points_near_surfels(points, 10,
                                    [&](const auto& path)
                                    {
                                      // Between consecutive surfels the normal turns, but does not
                                      // flip to the opposite side.
                                      for(std::size_t k = 1; k < path.points.size(); ++k)
                                      {
                                        EXPECT_GT(points.normal(path.locations[k - 1].surfel) *
                                                      points.normal(path.locations[k].surfel),
                                                  0.);
                                      }
                                    });
  }
}

TEST(Surfel_path_finder, stays_near_surfels_of_uneven_scans)
{
  // An aerial scan, a noisy scan of a quarry, a scan from one viewpoint with a density ratio of
  // hundreds, and a scan with holes.
  std::vector<std::pair<std::string, Point_set>> scans;
  scans.emplace_back("hills", point_set(uneven_hills()));
  scans.emplace_back("stripes", point_set(scanned_square(40, 200, 1)));
  for(const char* const name :
      {"b9_aerial_22k.ply", "isprs_samp53_34k_utm.ply", "radar_21k.ply", "hippo1_6k.ply"})
    add_scan(scans, name);
  for(const auto& [name, points] : scans)
  {
    SCOPED_TRACE(name);
    expect_path_points_near_surfels(points, 6, [](const auto&) {});
  }
}

TEST(Surfel_path_finder, is_robust_to_strong_noise)
{
  // Points deviate from a unit sphere by 1.7 times their spacing. Normals deviate by 18 degrees in
  // the median.
  std::vector<std::pair<std::string, Point_set>> scans;
  scans.emplace_back("noisy sphere", noisy_sphere(21000));
  add_scan(scans, "sphere_21k_normals.ply");
  for(const auto& [name, points] : scans)
  {
    SCOPED_TRACE(name);
    GP::Surfel_path_finder<Point_set> finder(points);
    EXPECT_GT(finder.noise(), 0.5);
    std::mt19937 random(1);
    double sum = 0.;
    constexpr int number_of_paths = 30;
    for(int i = 0; i < number_of_paths; ++i)
    {
      const auto from = *(points.begin() + random() % points.size()),
                 to = *(points.begin() + random() % points.size());
      const auto direction = [&](const auto& surfel)
      {
        const auto v = finder.point(surfel) - CGAL::ORIGIN;
        return v / std::sqrt(v.squared_length());
      };
      const double expected = std::acos(direction(from) * direction(to));
      sum += std::pow(finder(from, to).front_distance / expected - 1., 2);
    }
    // End points are off by 0.005 of the radius. Distances are 1.6 in the mean, some only 0.4.
    EXPECT_LT(std::sqrt(sum / number_of_paths), 0.01);
  }
}

TEST(Surfel_path_finder, returns_minimizers_if_guarantees_are_not_enforced)
{
  const Cloud sphere = octahedron_sphere(4);
  // The radius is the distance of the 8th neighbor divided by the square root of two.
  const Point_set points =
      point_set(with_noise(sphere, std::vector<double>(sphere.size(), 0.11), 1., 1));
  const auto np = GP::parameters::surfel_noise(GP::Surfel_noise::kept)
                      .surfel_path_method(GP::Surfel_path_method::projected_planes);
  GP::Surfel_path_finder<Point_set> enforced(points, np),
      minimizing(points, np.do_enforce_guarantees(false));
  std::size_t number_of_longer_paths = 0;
  for(std::size_t to = 100; to < sphere.size(); to += 90)
  {
    const auto from_surfel = *points.begin(), to_surfel = *(points.begin() + to);
    const auto path = enforced(from_surfel, to_surfel);
    EXPECT_LE(path.front_distance, path.initial_length * (1. + round_off));
    const auto minimizer = minimizing(from_surfel, to_surfel);
    number_of_longer_paths += minimizer.front_distance > minimizer.initial_length;
  }
  EXPECT_GT(number_of_longer_paths, 0u); // planes fitted to few surfels follow the noise
}

TEST(Surfel_path_finder, copies_share_fitted_cloud)
{
  const Surfels surfels = sphere_surfels(2);
  GP::Surfel_path_finder<Surfels> finder(surfels, maps.surfel_graph(GP::Surfel_graph::nearest)
                                                      .number_of_threads(2)
                                                      .surfel_noise(GP::Surfel_noise::kept));
  auto copy = finder;
  EXPECT_EQ(&copy.kernel().fitted_cloud()->cloud(), &finder.kernel().fitted_cloud()->cloud());
  EXPECT_EQ(copy(std::size_t(1), std::size_t(90)).length,
            finder(std::size_t(1), std::size_t(90)).length);
  EXPECT_EQ(finder.noise(), 0.);
}

} // namespace Surfel_path_finder_test
