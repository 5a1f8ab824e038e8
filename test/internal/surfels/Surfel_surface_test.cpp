// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_surface.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Surfel_cloud cloud_of(const Cloud& cloud) { return make_cloud(cloud.points, cloud.normals); }

// As it is where the cloud is the one that was given.
struct Surface
{
  Surface(const Surfel_cloud& cloud, Surfel_fit fit)
      : vicinity(cloud), surface(cloud, fit, vicinity, home)
  {}
  Foot foot(const Spatial& point, Index near) const { return surface.foot(point, near); }

  Surfel_vicinity vicinity;
  std::vector<Index> home;
  Surfel_surface surface;
};

TEST(Surfel_surface, is_a_sphere_where_surfels_are)
{
  const Cloud sphere = octahedron_sphere(4);
  const Surfel_cloud cloud = cloud_of(sphere);
  for(const Surfel_fit fit :
      {Surfel_fit::spheres, Surfel_fit::robust_spheres, Surfel_fit::quadrics})
  {
    const Surface surface(cloud, fit);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> offset(-0.03, 0.03);
    for(int i = 0; i < 200; ++i)
    {
      const Index site = Index(random() % sphere.size());
      const Spatial p = cloud.point[site] + Spatial{offset(random), offset(random), offset(random)};
      const Foot foot = surface.foot(p, site);
      const Spatial centre = (-1. / cloud.frame.scale) * cloud.frame.origin;
      const Spatial way = p - centre, expected = 1. / cloud.frame.scale * unit(way);
      EXPECT_LT(norm(foot.point - centre - expected), 1e-13); // rounding of sums of twenty
      EXPECT_NEAR(std::abs(dot(foot.normal, unit(way))), 1., 1e-13);
    }
  }
}

// The largest distance from a torus of feet of points near it.
double error_on_torus(std::size_t n, Surfel_fit fit)
{
  const Surfel_cloud cloud = cloud_of(torus_cloud(n, 0.4));
  const Surface surface(cloud, fit);
  double sum = 0.;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0., 1.);
  for(int i = 0; i < 500; ++i)
  {
    const Index a = Index(random() % cloud.number_of_sites());
    const Index arc =
        cloud.graph.first[a] + Index(random() % (cloud.graph.first[a + 1] - cloud.graph.first[a]));
    const double t = share(random);
    const Spatial p = (1. - t) * cloud.point[a] + t * cloud.point[cloud.graph.target[arc]];
    const Spatial q = cloud.frame.origin + cloud.frame.scale * surface.foot(p, a).point;
    const double d = std::hypot(std::hypot(q[0], q[1]) - 1., q[2]) - 0.4;
    sum += d * d;
  }
  return std::sqrt(sum / 500.);
}

TEST(Surfel_surface, comes_nearer_to_a_torus_with_more_surfels)
{
  // Four times as many surfels, half of the spacing: second order for disks, planes and spheres, up to
  // fourth for quadrics.
  for(const auto& [fit, factor] :
      {std::pair(Surfel_fit::planes, 2.5), std::pair(Surfel_fit::spheres, 3.),
       std::pair(Surfel_fit::robust_spheres, 3.), std::pair(Surfel_fit::quadrics, 8.)})
    EXPECT_GT(error_on_torus(2000, fit), factor * error_on_torus(8000, fit)) << int(fit);
}

// The root mean squared distance from the unit sphere, in radii, of the feet of `places` on it.
double error_on_sphere(const Cloud& cloud, const Cloud& places, double radius, Surfel_fit fit)
{
  const Surfel_cloud c = cloud_of(cloud);
  const Surface surface(c, fit);
  double sum = 0.;
  for(std::size_t i = 0; i < places.size(); ++i)
  {
    const Spatial p = 1. / c.frame.scale * (places.points[i] - c.frame.origin);
    const Foot foot = surface.foot(p, c.site_of_surfel[i]);
    sum += std::pow(norm(c.frame.origin + c.frame.scale * foot.point) - 1., 2);
  }
  return std::sqrt(sum / double(places.size())) / radius;
}

TEST(Surfel_surface, bears_outliers_by_robust_weights)
{
  const Cloud sphere = octahedron_sphere(4);
  const Surfel_cloud given = cloud_of(sphere);
  std::vector<double> radii;
  for(const Index site : given.site_of_surfel)
    radii.push_back(given.frame.scale * given.radius[site]);
  const auto errors = [&](double level, Surfel_fit fit)
  {
    const Cloud noisy = level > 0. ? with_noise(sphere, radii, level, 1) : sphere;
    const Cloud worse = with_outliers(noisy, sphere, radii, 0.05, 2., 2);
    return std::pair(error_on_sphere(noisy, sphere, radii[0], fit),
                     error_on_sphere(worse, sphere, radii[0], fit));
  };
  for(const double level : {0.5, 1.})
  {
    const auto [plain, plain_worse] = errors(level, Surfel_fit::spheres);
    const auto [robust, robust_worse] = errors(level, Surfel_fit::robust_spheres);
    // With the weights that heights between 0 and where they do not count have in the mean, outliers
    // add one or two percent to the variance, half as much to the error; the rest is chance.
    EXPECT_LT(robust_worse, 1.05 * robust);
    // Plain weights see the few surfels that arcs join to the nearest one, which lie as high as it does.
    EXPECT_LT(robust, 0.6 * plain);
    EXPECT_LT(robust_worse, 0.6 * plain_worse);
  }
  // Without noise those outliers count that are no higher than a twentieth of the spacing: one in fifty.
  const auto [plain, plain_worse] = errors(0., Surfel_fit::spheres);
  const auto [robust, robust_worse] = errors(0., Surfel_fit::robust_spheres);
  EXPECT_LT(plain, 1e-13); // rounding of sums of twenty, in radii
  EXPECT_LT(robust, 1e-13);
  EXPECT_LT(robust_worse, 0.1 * plain_worse);
}

TEST(Surfel_surface, has_disks)
{
  const Surfel_cloud cloud = cloud_of(square_cloud(11));
  const Surface surface(cloud, Surfel_fit::disks);
  // Above the inside the nearest point of the plane; beyond the border that of the last disk, whose
  // neighbours are smaller than it is at the corner.
  const Foot inside = surface.foot(cloud.point[60] + Spatial{0.01, 0.02, 0.05}, 60);
  EXPECT_LT(norm(inside.point - cloud.point[60] - Spatial{0.01, 0.02, 0.}), 1e-15);
  Index corner = 0;
  for(Index i = 0; i < 121; ++i)
    if(cloud.point[i][0] + cloud.point[i][1] > cloud.point[corner][0] + cloud.point[corner][1])
      corner = i;
  const Spatial away = unit({1., 1., 0.});
  const Foot outside = surface.foot(cloud.point[corner] + 5. * away, corner);
  double sum = cloud.radius[corner], number = 1.;
  for(Index arc = cloud.graph.first[corner]; arc < cloud.graph.first[corner + 1]; ++arc, ++number)
    sum += cloud.radius[cloud.graph.target[arc]];
  EXPECT_LT(sum / number, cloud.radius[corner]);
  EXPECT_LT(norm(outside.point - cloud.point[corner] - sum / number * away), 1e-14);
}

TEST(Surfel_surface, ends_with_its_surfels)
{
  const Surfel_cloud cloud = cloud_of(square_cloud(11));
  const Surface surface(cloud, Surfel_fit::quadrics);
  for(Index i = 0; i < 121; ++i)
    if(std::abs(cloud.point[i][0]) > 0.99 * std::abs(cloud.point[0][0]))
    {
      const double side = cloud.point[i][0] > 0. ? 1. : -1.;
      const Foot foot = surface.foot(cloud.point[i] + Spatial{side, 0., 0.01}, i);
      EXPECT_LE(norm(foot.point - cloud.point[i]), 1.5 * cloud.radius[i] * (1. + 1e-12));
      EXPECT_NEAR(dot(foot.rim, {side, 0., 0.}), 1., 1e-12);
      EXPECT_NEAR(foot.point[2], 0., 1e-14);
    }
}

TEST(Surfel_surface, leaves_a_hole_open_around_a_surfel_alone_in_it)
{
  // A square lattice, without what is nearer than six steps to its middle.
  Cloud square;
  for(int i = -12; i <= 12; ++i)
    for(int j = -12; j <= 12; ++j)
      if(i * i + j * j == 0 || i * i + j * j >= 36)
        square.add({double(i), double(j), 0.}, {0., 0., 1.});
  const Surfel_cloud cloud = cloud_of(square);
  const Surface surface(cloud, Surfel_fit::quadrics);
  Index middle = 0;
  for(Index site = 0; site < cloud.number_of_sites(); ++site)
    if(cloud.radius[site] > cloud.radius[middle])
      middle = site;
  double around = 0.;
  const Site_graph& graph = cloud.graph;
  for(Index arc = graph.first[middle]; arc < graph.first[middle + 1]; ++arc)
    around = std::max(around, cloud.radius[graph.target[arc]]);
  EXPECT_LT(2. * around, cloud.radius[middle]);
  const Foot foot = surface.foot(cloud.point[middle] + Spatial{2. * around, 0., 0.}, middle);
  EXPECT_EQ(foot.site, middle);
  EXPECT_LE(norm(foot.point - cloud.point[middle]), 1.3 * around * (1. + 1e-12));
}

TEST(Surfel_surface, ends_where_surfels_are_no_longer_near)
{
  // Two rows of surfels far apart, of radii that reach over the gap.
  Cloud rows;
  for(const double y : {0., 6.})
    for(int i = 0; i < 40; ++i)
      for(int j = 0; j < 3; ++j)
        rows.add({double(i), y + (y > 0. ? j : -j), 0.}, {0., 0., 1.});
  const Surfel_cloud cloud =
      make_cloud(rows.points, rows.normals, std::vector<double>(rows.size(), 6.));
  for(const Surfel_fit fit : {Surfel_fit::disks, Surfel_fit::planes, Surfel_fit::spheres,
                              Surfel_fit::robust_spheres, Surfel_fit::quadrics})
  {
    const Surface surface(cloud, fit);
    for(Index site = 0; site < cloud.number_of_sites(); ++site)
      for(const double out : {0.5, 2., 3.})
      {
        const double side = cloud.point[site][1] < 0. ? 1. : -1.;
        const Foot foot =
            surface.foot(cloud.point[site] + Spatial{0., side * out / cloud.frame.scale, 0.}, site);
        EXPECT_TRUE(surface.vicinity.is_near(foot.point, foot.site));
        EXPECT_EQ(surface.surface.drawn_near(foot.point, foot.site), foot.point);
      }
  }
}

TEST(Surfel_surface, walks_over_arcs)
{
  // A square with a cut from one side to its middle: of 5 steps, which no arc bridges.
  const Cloud square = part_of(square_cloud(41), [](const Spatial& p)
                               { return std::abs(p[0] - 0.5) > 0.06 || p[1] > 0.5; });
  const Surfel_cloud cloud = cloud_of(square);
  const Surface surface(cloud, Surfel_fit::quadrics);
  const auto site = [&](double x, double y)
  {
    Index best = 0;
    const Spatial p = 1. / cloud.frame.scale * (Spatial{x, y, 0.} - cloud.frame.origin);
    for(Index i = 0; i < cloud.number_of_sites(); ++i)
      if(norm(cloud.point[i] - p) < norm(cloud.point[best] - p))
        best = i;
    return best;
  };
  const auto walk = [&](Index from, Index to)
  { return cloud.frame.scale * surface.surface.walk(from, to); };
  EXPECT_EQ(walk(site(0.1, 0.1), site(0.1, 0.1)), 0.);
  // At most by steps along both sides of the square's cells.
  EXPECT_GE(walk(site(0.1, 0.1), site(0.4, 0.3)), std::hypot(0.3, 0.2) - 1e-9);
  EXPECT_LE(walk(site(0.1, 0.1), site(0.4, 0.3)), 0.5 + 1e-9);
  EXPECT_NEAR(walk(site(0.4, 0.7), site(0.6, 0.7)), 0.2, 1e-9);
  EXPECT_EQ(walk(site(0.4, 0.1), site(0.6, 0.1)), infinity);
}

TEST(Surfel_surface, has_sharp_edges)
{
  const Cloud cube = cube_cloud(10);
  const Surfel_cloud cloud = cloud_of(cube);
  const double half = 0.5 / cloud.frame.scale;
  for(const Surfel_fit fit :
      {Surfel_fit::planes, Surfel_fit::spheres, Surfel_fit::robust_spheres, Surfel_fit::quadrics})
  {
    const Surface surface(cloud, fit);
    for(Index i = 0; i < cloud.number_of_sites(); ++i)
    {
      // Where the nearest surfel is on this side, the foot is in its plane.
      const auto [u, v] = tangent_frame(cloud.normal[i]);
      const Foot foot =
          surface.foot(cloud.point[i] + 0.02 * u + 0.01 * v + 0.01 * cloud.normal[i], i);
      EXPECT_NEAR(std::abs(dot(foot.point, cloud.normal[foot.site])), half, 1e-14);
    }
  }
}

} // namespace
