// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "surfels/denoise.h"

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr double rounding = 1e-12; // sums of some hundreds of lengths near 1

class Finder
{
public:
  explicit Finder(const Cloud& cloud, const Cloud_path_options& options = {})
      : m_cloud(std::make_shared<const Prepared_cloud>(cloud.points, cloud.normals,
                                                       std::vector<double>(), options)),
        m_find(m_cloud)
  {}

  Cloud_path operator()(std::size_t from, std::size_t to) { return m_find(place(from), place(to)); }
  Tangent_location place(std::size_t surfel) const
  {
    return {m_cloud->cloud().site_of_surfel[surfel], {0., 0.}};
  }
  double scale() const { return m_cloud->cloud().frame.scale; }
  std::vector<Spatial> points(const Cloud_path& found) const
  {
    std::vector<Spatial> result;
    for(const Foot& foot : found.path.points)
      result.push_back(m_cloud->cloud().frame.origin + scale() * foot.point);
    return result;
  }
  const Prepared_cloud& prepared() const { return *m_cloud; }
  Cloud_path_finder& kernel() { return m_find; }

private:
  std::shared_ptr<const Prepared_cloud> m_cloud;
  Cloud_path_finder m_find;
};

Cloud_path_options with(Surfel_path_method method,
                        Surfel_noise noise = Surfel_noise::removed_when_found)
{
  Cloud_path_options options;
  options.method = method;
  options.noise = noise;
  return options;
}

std::size_t nearest(const Cloud& cloud, const Spatial& p)
{
  std::size_t best = 0;
  for(std::size_t i = 1; i < cloud.size(); ++i)
    if(norm(cloud.points[i] - p) < norm(cloud.points[best] - p))
      best = i;
  return best;
}

void expect_energy_falls(const Cloud_path& found)
{
  for(const Path_energy_level& level : found.path.levels)
    EXPECT_LE(level.last_energy, level.first_energy);
}

TEST(Cloud_path_finder, follows_great_circles)
{
  for(const unsigned level : {3, 5})
  {
    const Cloud sphere = octahedron_sphere(level);
    Finder find(sphere);
    EXPECT_LT(find.prepared().noise(), noise_that_matters);
    std::mt19937 random(level);
    for(int i = 0; i < 40; ++i)
    {
      const std::size_t a = random() % sphere.size(), b = random() % sphere.size();
      if(a == b)
        continue;
      const double truth =
          2. * std::asin(std::min(1., norm(sphere.points[b] - sphere.points[a]) / 2.));
      const Cloud_path found = find(a, b);
      // Spheres are fitted exactly; what is left is of fourth order in steps of a hundredth.
      EXPECT_NEAR(find.scale() * found.path.length, truth, 1e-8);
      EXPECT_LE(found.path.length, found.start_length * (1. + rounding));
      EXPECT_LE(found.path.polyline_length, found.path.length * (1. + rounding));
      for(const Spatial& p : find.points(found))
        EXPECT_NEAR(norm(p), 1., 1e-9);
      expect_energy_falls(found);
    }
  }
}

TEST(Cloud_path_finder, follows_great_circles_from_coarse_to_fine)
{
  const Cloud sphere = ellipsoid_cloud(60000, {1., 1., 1.});
  Cloud_path_options options;
  Finder find(sphere);
  EXPECT_NE(find.prepared().regions(), nullptr);
  options.search = Surfel_search::a_star;
  EXPECT_EQ(Finder(sphere, options).prepared().regions(), nullptr);
  std::mt19937 random(1);
  for(int i = 0; i < 20; ++i)
  {
    const std::size_t a = random() % sphere.size(), b = random() % sphere.size();
    const double truth =
        2. * std::asin(std::min(1., norm(sphere.points[b] - sphere.points[a]) / 2.));
    const Cloud_path found = find(a, b);
    // As above: the chain leaves no trace.
    EXPECT_NEAR(find.scale() * found.path.length, truth, 1e-8);
    EXPECT_LE(found.path.length, found.start_length * (1. + rounding));
    // Nor than the shortest chain, of which this one needs to know nothing.
    const Surfel_cloud& cloud = find.prepared().cloud();
    const std::vector<Index> shortest = Graph_search(cloud.graph, cloud.point)(
        find.place(a).site, find.place(b).site, Surfel_search::dijkstra);
    double length = 0.;
    for(std::size_t k = 1; k < shortest.size(); ++k)
      length += norm(cloud.point[shortest[k]] - cloud.point[shortest[k - 1]]);
    EXPECT_LE(found.path.length, length * (1. + rounding));
  }
}

TEST(Cloud_path_finder, unrolls_cylinders)
{
  const Cloud cylinder = cylinder_cloud(100, 30, 15., 30.);
  Finder find(cylinder);
  std::mt19937 random(1);
  for(int i = 0; i < 40; ++i)
  {
    const std::size_t a = random() % cylinder.size(), b = random() % cylinder.size();
    const Spatial &p = cylinder.points[a], &q = cylinder.points[b];
    const double turn = std::remainder(std::atan2(q[1], q[0]) - std::atan2(p[1], p[0]), 2. * pi);
    if(a == b || std::abs(turn) > 3.)
      continue; // the other way round may be as short
    const double truth = std::hypot(15. * turn, q[2] - p[2]);
    // What surfaces of second order leave is of fourth order in the step over the radius.
    EXPECT_NEAR(find.scale() * find(a, b).path.length, truth,
                0.2 * std::pow(1.03 / 15., 4) * truth);
  }
}

TEST(Cloud_path_finder, is_not_misled_by_noise)
{
  const Cloud square = square_cloud(60);
  const std::vector<double> radii(square.size(), 1. / 59.);
  const Cloud noisy = with_noise(square, radii, 1., 3);
  Finder find(noisy),
      find_kept(noisy, with(Surfel_path_method::projected_planes, Surfel_noise::kept));
  EXPECT_GT(find.prepared().noise(), 0.2);
  EXPECT_EQ(find_kept.prepared().noise(), 0.);
  double sum = 0., sum_kept = 0.;
  std::mt19937 random(1);
  for(int i = 0; i < 20; ++i)
  {
    const std::size_t a = random() % square.size(), b = random() % square.size();
    const double truth = norm(square.points[b] - square.points[a]);
    if(truth < 0.1)
      continue;
    sum += std::abs(find.scale() * find(a, b).path.length / truth - 1.);
    sum_kept += std::abs(find_kept.scale() * find_kept(a, b).path.length / truth - 1.);
  }
  // Planes fitted to the nearest surfels alone follow the noise.
  EXPECT_LT(sum, 0.05 * sum_kept);
  EXPECT_LT(sum / 20., 2e-4); // the benchmark has 1.3e-5 with four times as many surfels
}

TEST(Cloud_path_finder, bears_outliers_by_robust_weights)
{
  // On a sphere with 5 % of outliers, and a little noise or none, which is kept.
  const Cloud sphere = octahedron_sphere(4);
  const std::vector<double> radii(sphere.size(), 0.11); // the 8th neighbour's distance over sqrt(2)
  for(const double level : {0., 0.02})
  {
    const Cloud noisy = level > 0. ? with_noise(sphere, radii, level, 1) : sphere;
    const Cloud worse = with_outliers(noisy, sphere, radii, 0.05, 2., 2);
    const auto error = [&](const Cloud& cloud, Surfel_path_method method)
    {
      Finder find(cloud, with(method, Surfel_noise::kept));
      double sum = 0.;
      std::mt19937 random(1);
      for(int i = 0; i < 30; ++i)
      {
        const std::size_t a = random() % sphere.size(), b = random() % sphere.size();
        const double truth =
            2. * std::asin(std::min(1., norm(sphere.points[b] - sphere.points[a]) / 2.));
        if(truth < 0.2)
          continue;
        const Cloud_path found = find(a, b);
        EXPECT_LE(found.path.length, found.start_length * (1. + rounding));
        expect_energy_falls(found);
        sum += std::pow(find.scale() * found.path.length / truth - 1., 2);
      }
      return std::sqrt(sum / 30.);
    };
    const double robust = error(worse, Surfel_path_method::robust_spheres);
    EXPECT_LT(robust, (level > 0. ? 0.5 : 0.1) * error(worse, Surfel_path_method::spheres));
    // One outlier in fifty is as low as noise: one surfel in a thousand, and chance.
    if(level > 0.)
    {
      EXPECT_LT(robust, 1.2 * error(noisy, Surfel_path_method::robust_spheres));
    }
  }
}

TEST(Cloud_path_finder, turns_around_the_edges_of_a_cube)
{
  const Cloud cube = cube_cloud(20);
  const std::size_t from = nearest(cube, {0., 0.1, 0.5}), to = nearest(cube, {0.5, 0.1, 0.});
  const Spatial p = cube.points[from], q = cube.points[to];
  const double truth = (0.5 - p[0]) + (0.5 - q[2]);
  for(const Surfel_path_method method : {Surfel_path_method::projected_quadrics,
                                         Surfel_path_method::spheres, Surfel_path_method::disks})
  {
    Finder find(cube, with(method));
    ASSERT_EQ(find.prepared().cloud().number_of_components, 1u);
    const Cloud_path found = find(from, to);
    // A chord of the last refinement cuts the corner: 1 - sqrt(1/2) of a sixteenth of a segment of a
    // 28th.  Disks end half a spacing before the edge.
    EXPECT_NEAR(find.scale() * found.path.length, truth,
                method == Surfel_path_method::projected_quadrics ? 2e-3 : 0.02)
        << int(method);
    for(const Spatial& x : find.points(found))
      EXPECT_NEAR(std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}), 0.5, 0.02);
  }
}

TEST(Cloud_path_finder, goes_around_gaps)
{
  // A square without its middle.
  const auto is_inside = [](const Spatial& p)
  { return std::abs(p[0] - 0.5) > 0.2 || std::abs(p[1] - 0.5) > 0.2; };
  const Cloud square = part_of(square_cloud(41), is_inside);
  Finder find(square);
  const std::size_t from = nearest(square, {0.1, 0.5, 0.}), to = nearest(square, {0.9, 0.5, 0.});
  const Cloud_path found = find(from, to);
  // Around two corners of the gap, whose surfels reach 1.5 radii into it: a radius is one step, and some more at the
  // border.
  const double step = 1. / 40., reach = 1.5 * 1.3 * step;
  const double longest = 2. * std::hypot(0.1 + step, 0.2 + step) + 0.4 + 2. * step,
               shortest = 2. * std::hypot(0.1 + reach, 0.2 - reach) + 0.4 - 2. * reach;
  EXPECT_GT(find.scale() * found.path.length, shortest);
  EXPECT_LT(find.scale() * found.path.length, longest);
  const std::vector<Spatial> points = find.points(found);
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    for(int k = 0; k < 8; ++k)
    {
      const Spatial x = points[i] + k / 8. * (points[i + 1] - points[i]);
      // Nowhere deeper in the gap than a surfel reaches.
      EXPECT_LE(norm(square.points[nearest(square, x)] - x), reach * (1. + 0.01));
    }
}

// A strip folded over itself: two sheets two spacings apart, joined at one end by half a cylinder.
constexpr double fold_step = 0.025, fold_radius = fold_step;

Cloud folded_strip()
{
  Cloud fold;
  for(int j = 0; j <= 20; ++j)
  {
    for(int i = 0; i <= 40; ++i)
      for(const double side : {-1., 1.})
        fold.add({i * fold_step, j * fold_step, side * fold_radius}, {0., 0., side});
    for(int i = 1; i < 6; ++i)
    {
      const double a = 0.5 * pi + i * pi / 6.;
      fold.add({fold_radius * std::cos(a), j * fold_step, fold_radius * std::sin(a)},
               {std::cos(a), 0., std::sin(a)});
    }
  }
  return fold;
}

TEST(Cloud_path_finder, stays_on_its_sheet)
{
  const Cloud fold = folded_strip();
  Finder find(fold);
  const std::size_t from = nearest(fold, {0.5, 0.25, fold_radius}),
                    to = nearest(fold, {0.5, 0.25, -fold_radius});
  const Cloud_path found = find(from, to);
  EXPECT_NEAR(find.scale() * found.path.length, 1. + pi * fold_radius, 0.01);
}

void expect_steps_over_arcs(const Surfel_cloud& cloud, const Cloud_path& found)
{
  for(std::size_t k = 1; k < found.path.points.size(); ++k)
  {
    const Foot &last = found.path.points[k - 1], &foot = found.path.points[k];
    if(last.site == foot.site)
      continue;
    EXPECT_TRUE(are_joined(cloud, last.site, foot.site,
                           2. * norm(foot.point - last.point) +
                               3. * (cloud.radius[last.site] + cloud.radius[foot.site])));
  }
}

TEST(Cloud_path_finder, goes_around_a_fold_however_few_control_points)
{
  // Two control points slide to the ends, one above the other.
  const Cloud fold = folded_strip();
  Cloud_path_options options;
  for(const std::size_t number : {1, 2, 5})
  {
    options.path.control_points = number;
    Finder find(fold, options);
    const Cloud_path found =
        find(nearest(fold, {0.75, 0.25, fold_radius}), nearest(fold, {0.75, 0.25, -fold_radius}));
    expect_steps_over_arcs(find.prepared().cloud(), found);
    EXPECT_GT(find.scale() * found.path.length, 1.5);
    EXPECT_LE(found.path.length, found.start_length * (1. + rounding));
  }
}

TEST(Cloud_path_finder, stays_near_surfels_however_they_lie)
{
  // As a scanner sees a plain: rows farther apart than the sixth neighbour in a row, but not than the
  // twentieth, with or without noise.
  for(const double noise : {0., 1.})
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0., 1.);
    Cloud plain;
    for(int j = 0; j < 8; ++j)
      for(int i = 0; i < 200; ++i)
        plain.add({i + 0.5 * share(random), 7.6 * j + share(random), 0.}, {0., 0., 1.});
    if(noise > 0.)
      plain = with_noise(plain, std::vector<double>(plain.size(), 1.), noise, 2);
    Finder find(plain);
    EXPECT_EQ(find.prepared().noise() > noise_that_matters, noise > 0.);
    const Surfel_cloud given = make_cloud(plain.points, plain.normals);
    const Surfel_vicinity vicinity(given);
    const Surfel_cloud& cloud = find.prepared().cloud();
    ASSERT_EQ(cloud.number_of_components, 1u);
    for(int i = 0; i < 8; ++i)
    {
      const Cloud_path found = find(random() % plain.size(), random() % plain.size());
      EXPECT_LE(found.path.length, found.start_length * (1. + rounding));
      expect_steps_over_arcs(cloud, found);
      const std::vector<Spatial> points = find.points(found);
      for(std::size_t k = 0; k < points.size(); ++k)
        EXPECT_TRUE(vicinity.is_near(
            1. / given.frame.scale * (points[k] - given.frame.origin),
            given.site_of_surfel[cloud.surfel_of_site[found.path.points[k].site]]));
    }
  }
}

TEST(Cloud_path_finder, finds_nothing_between_components)
{
  Cloud two = square_cloud(10);
  const std::size_t first = two.size();
  for(std::size_t i = 0; i < first; ++i)
    two.add(two.points[i] + Spatial{5., 0., 0.}, two.normals[i]);
  Finder find(two);
  EXPECT_EQ(find.prepared().cloud().number_of_components, 2u);
  const Cloud_path found = find(0, first);
  EXPECT_TRUE(found.path.points.empty());
  EXPECT_EQ(found.start_length, infinity);
}

TEST(Cloud_path_finder, stays_where_it_is)
{
  Finder find(octahedron_sphere(3));
  const Cloud_path found = find(7, 7);
  EXPECT_EQ(found.path.points.size(), 1u);
  EXPECT_EQ(found.path.length, 0.);
  EXPECT_EQ(found.start_length, 0.);
}

TEST(Cloud_path_finder, follows_the_scale)
{
  const Cloud torus = torus_cloud(2000, 0.4);
  Finder find(torus);
  const double length = find.scale() * find(3, 1000).path.length;
  for(const double factor : {std::ldexp(1., 100), std::ldexp(1., -100)})
  {
    Cloud scaled = torus;
    for(Spatial& p : scaled.points)
      p = factor * p;
    Finder find_scaled(scaled);
    EXPECT_EQ(find_scaled.scale() * find_scaled(3, 1000).path.length, factor * length);
  }
}

TEST(Cloud_path_finder, finds_the_same_on_any_number_of_threads)
{
  const Cloud cloud = with_noise(torus_cloud(2000, 0.4), std::vector<double>(2200, 0.05), 0.5, 1);
  Cloud_path_options options;
  Finder one(cloud, options);
  options.cloud.threads = 3;
  Finder three(cloud, options);
  std::vector<std::pair<Tangent_location, Tangent_location>> pairs;
  for(std::size_t i = 0; i < 20; ++i)
    pairs.emplace_back(one.place(7 * i), one.place(cloud.size() - 1 - 11 * i));
  const auto expected = find_paths(one.kernel(), pairs, 1),
             found = find_paths(three.kernel(), pairs, 3);
  for(std::size_t i = 0; i < pairs.size(); ++i)
  {
    ASSERT_EQ(found[i].path.points.size(), expected[i].path.points.size());
    for(std::size_t k = 0; k < found[i].path.points.size(); ++k)
      EXPECT_EQ(found[i].path.points[k].point, expected[i].path.points[k].point);
  }
}

TEST(Cloud_path_finder, refuses_weights_that_are_none)
{
  Cloud_path_options options;
  options.path.alpha = -1.;
  EXPECT_THROW(Finder(square_cloud(5), options), Invalid_argument_error);
  options.path.alpha = 1.;
  options.path.control_points = 0;
  EXPECT_THROW(Finder(square_cloud(5), options), Invalid_argument_error);
}

} // namespace
