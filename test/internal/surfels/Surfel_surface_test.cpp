// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_surface.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace Surfel_surface_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Surfel_cloud cloud_of(const Cloud& cloud) { return make_cloud(cloud.points, cloud.normals); }

// A surface whose coverage is that of the same cloud.
struct Surface
{
  Surface(const Surfel_cloud& cloud, Surfel_fit fit)
      : coverage(cloud), surface(cloud, fit, coverage, original_vertex)
  {}
  Projection project(const Vec3& point, Index near) const { return surface.project(point, near); }

  Surfel_coverage coverage;
  std::vector<Index> original_vertex;
  Surfel_surface surface;
};

TEST(Surfel_surface, reproduces_spheres)
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
      const Index vertex = Index(random() % sphere.size());
      const Vec3 p = cloud.point[vertex] + Vec3{offset(random), offset(random), offset(random)};
      const Projection projection = surface.project(p, vertex);
      const Vec3 center = (-1. / cloud.frame.scale) * cloud.frame.origin;
      const Vec3 radial = p - center, expected = 1. / cloud.frame.scale * unit(radial);
      // Round-off errors of sums of 20 terms.
      EXPECT_LT(norm(projection.point - center - expected), 1e-13);
      EXPECT_NEAR(std::abs(dot(projection.normal, unit(radial))), 1., 1e-13);
    }
  }
}

// Returns the root mean squared distance from a torus of the projections of points on the edges of
// the graph.
double error_on_torus(std::size_t n, Surfel_fit fit)
{
  const Surfel_cloud cloud = cloud_of(torus_cloud(n, 0.4));
  const Surface surface(cloud, fit);
  double sum = 0.;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  for(int i = 0; i < 500; ++i)
  {
    const Index a = Index(random() % cloud.number_of_vertices());
    const Index e =
        cloud.graph.begin[a] + Index(random() % (cloud.graph.begin[a + 1] - cloud.graph.begin[a]));
    const double t = uniform(random);
    const Vec3 p = (1. - t) * cloud.point[a] + t * cloud.point[cloud.graph.target[e]];
    const Vec3 q = cloud.frame.origin + cloud.frame.scale * surface.project(p, a).point;
    const double d = std::hypot(std::hypot(q[0], q[1]) - 1., q[2]) - 0.4;
    sum += d * d;
  }
  return std::sqrt(sum / 500.);
}

TEST(Surfel_surface, converges_on_a_torus)
{
  // Half of the spacing divides the error by 4 for planes and spheres (second order), and by up to
  // 16 for quadrics (fourth order).
  for(const auto& [fit, factor] :
      {std::pair(Surfel_fit::planes, 2.5), std::pair(Surfel_fit::spheres, 3.),
       std::pair(Surfel_fit::robust_spheres, 3.), std::pair(Surfel_fit::quadrics, 8.)})
    EXPECT_GT(error_on_torus(2000, fit), factor * error_on_torus(8000, fit)) << int(fit);
}

// Returns the root mean squared distance from the unit sphere, divided by the radius, of the
// projections of `samples`, which lie on the sphere.
double error_on_sphere(const Cloud& cloud, const Cloud& samples, double radius, Surfel_fit fit)
{
  const Surfel_cloud c = cloud_of(cloud);
  const Surface surface(c, fit);
  double sum = 0.;
  for(std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vec3 p = 1. / c.frame.scale * (samples.points[i] - c.frame.origin);
    const Projection projection = surface.project(p, c.internal_vertex[i]);
    sum += std::pow(norm(c.frame.origin + c.frame.scale * projection.point) - 1., 2);
  }
  return std::sqrt(sum / double(samples.size())) / radius;
}

TEST(Surfel_surface, robust_weights_reject_outliers)
{
  const Cloud sphere = octahedron_sphere(4);
  const Surfel_cloud clean = cloud_of(sphere);
  std::vector<double> radii;
  for(const Index vertex : clean.internal_vertex)
    radii.push_back(clean.frame.scale * clean.radius[vertex]);
  const auto errors = [&](double level, Surfel_fit fit)
  {
    const Cloud noisy = level > 0. ? with_noise(sphere, radii, level, 1) : sphere;
    const Cloud noisy_with_outliers = with_outliers(noisy, sphere, radii, 0.05, 2., 2);
    return std::pair(error_on_sphere(noisy, sphere, radii[0], fit),
                     error_on_sphere(noisy_with_outliers, sphere, radii[0], fit));
  };
  for(const double level : {0.5, 1.})
  {
    const auto [plain, plain_with_outliers] = errors(level, Surfel_fit::spheres);
    const auto [robust, robust_with_outliers] = errors(level, Surfel_fit::robust_spheres);
    // The outliers below the threshold add 1 to 2 % to the variance, which is half as much of the
    // error. The remaining difference is random.
    EXPECT_LT(robust_with_outliers, 1.05 * robust);
    // Without robust weights, the fit only uses the few graph neighbors, which have a similar
    // height as the nearest surfel.
    EXPECT_LT(robust, 0.6 * plain);
    EXPECT_LT(robust_with_outliers, 0.6 * plain_with_outliers);
  }
  // Without noise, only the outliers below 5 % of the spacing have a positive weight: 1 in 50.
  const auto [plain, plain_with_outliers] = errors(0., Surfel_fit::spheres);
  const auto [robust, robust_with_outliers] = errors(0., Surfel_fit::robust_spheres);
  EXPECT_LT(plain, 1e-13); // round-off errors of sums of 20 terms, in radii
  EXPECT_LT(robust, 1e-13);
  EXPECT_LT(robust_with_outliers, 0.1 * plain_with_outliers);
}

TEST(Surfel_surface, projects_to_disks)
{
  const Surfel_cloud cloud = cloud_of(square_cloud(11));
  const Surface surface(cloud, Surfel_fit::disks);
  // In the interior, the projection is that to the plane. Beyond the corner, it is the closest
  // point of the last disk. The radius of this disk is the mean of the neighbors' radii.
  const Projection inside = surface.project(cloud.point[60] + Vec3{0.01, 0.02, 0.05}, 60);
  EXPECT_LT(norm(inside.point - cloud.point[60] - Vec3{0.01, 0.02, 0.}), 1e-15);
  Index corner = 0;
  for(Index i = 0; i < 121; ++i)
    if(cloud.point[i][0] + cloud.point[i][1] > cloud.point[corner][0] + cloud.point[corner][1])
      corner = i;
  const Vec3 away = unit({1., 1., 0.});
  const Projection outside = surface.project(cloud.point[corner] + 5. * away, corner);
  double sum = cloud.radius[corner], number = 1.;
  for(Index e = cloud.graph.begin[corner]; e < cloud.graph.begin[corner + 1]; ++e, ++number)
    sum += cloud.radius[cloud.graph.target[e]];
  EXPECT_LT(sum / number, cloud.radius[corner]);
  // Round-off errors of a mean of some radii.
  EXPECT_LT(norm(outside.point - cloud.point[corner] - sum / number * away), 1e-14);
}

TEST(Surfel_surface, ends_at_boundary)
{
  const Surfel_cloud cloud = cloud_of(square_cloud(11));
  const Surface surface(cloud, Surfel_fit::quadrics);
  for(Index i = 0; i < 121; ++i)
    if(std::abs(cloud.point[i][0]) > 0.99 * std::abs(cloud.point[0][0]))
    {
      const double side = cloud.point[i][0] > 0. ? 1. : -1.;
      const Projection projection = surface.project(cloud.point[i] + Vec3{side, 0., 0.01}, i);
      // Round-off errors; all surfels have the same plane.
      EXPECT_LE(norm(projection.point - cloud.point[i]), 1.5 * cloud.radius[i] * (1. + 1e-12));
      EXPECT_NEAR(dot(projection.conormal, {side, 0., 0.}), 1., 1e-12);
      // All surfels have the plane z = 0.
      EXPECT_NEAR(projection.point[2], 0., 1e-14);
    }
}

TEST(Surfel_surface, keeps_hole_open_around_isolated_surfel)
{
  // A square lattice with a hole of 6 steps in radius around the central surfel.
  Cloud square;
  for(int i = -12; i <= 12; ++i)
    for(int j = -12; j <= 12; ++j)
      if(i * i + j * j == 0 || i * i + j * j >= 36)
        square.add({double(i), double(j), 0.}, {0., 0., 1.});
  const Surfel_cloud cloud = cloud_of(square);
  const Surface surface(cloud, Surfel_fit::quadrics);
  Index middle = 0;
  for(Index vertex = 0; vertex < cloud.number_of_vertices(); ++vertex)
    if(cloud.radius[vertex] > cloud.radius[middle])
      middle = vertex;
  double max_neighbor_radius = 0.;
  const Proximity_graph& graph = cloud.graph;
  for(Index e = graph.begin[middle]; e < graph.begin[middle + 1]; ++e)
    max_neighbor_radius = std::max(max_neighbor_radius, cloud.radius[graph.target[e]]);
  EXPECT_LT(2. * max_neighbor_radius, cloud.radius[middle]);
  const Projection projection =
      surface.project(cloud.point[middle] + Vec3{2. * max_neighbor_radius, 0., 0.}, middle);
  EXPECT_EQ(projection.vertex, middle);
  // The last factor allows for round-off errors.
  EXPECT_LE(norm(projection.point - cloud.point[middle]), 1.3 * max_neighbor_radius * (1. + 1e-12));
}

TEST(Surfel_surface, has_no_holes_in_sparse_spots)
{
  // The surface contains the covered points of sparse spots.
  const Cloud sphere = random_sphere(4000);
  const Surfel_cloud cloud = cloud_of(sphere);
  const Surface surface(cloud, Surfel_fit::quadrics);
  std::mt19937 random(1);
  std::normal_distribution<double> coordinate;
  int number_of_holes = 0;
  for(int i = 0; i < 50000; ++i)
  {
    const Vec3 p = unit(Vec3{coordinate(random), coordinate(random), coordinate(random)});
    const Vec3 query = 1. / cloud.frame.scale * (p - cloud.frame.origin);
    const Index nearest = cloud.tree.nearest(cloud.point, query);
    if(!surface.coverage.is_covered(query, nearest))
      continue;
    const Projection projection = surface.project(query, nearest);
    number_of_holes += norm(projection.conormal) > 0.;
    // Fits reproduce spheres. In sparse spots, fits to few surfels amplify round-off errors.
    if(norm(projection.conormal) == 0.)
    {
      EXPECT_LT(norm(projection.point - query), 1e-9);
    }
  }
  // A few points are not surrounded. The extents of the nearest surfels alone leave tens of points
  // in holes.
  EXPECT_LE(number_of_holes, 3);
}

TEST(Surfel_surface, stays_inside_coverage)
{
  // Two strips of surfels whose radii exceed the gap between them.
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
    for(Index vertex = 0; vertex < cloud.number_of_vertices(); ++vertex)
      for(const double distance : {0.5, 2., 3.})
      {
        const double side = cloud.point[vertex][1] < 0. ? 1. : -1.;
        const Projection projection = surface.project(
            cloud.point[vertex] + Vec3{0., side * distance / cloud.frame.scale, 0.}, vertex);
        EXPECT_TRUE(surface.coverage.is_covered(projection.point, projection.vertex));
        EXPECT_EQ(surface.surface.clamped_to_coverage(projection.point, projection.vertex),
                  projection.point);
      }
  }
}

TEST(Surfel_surface, walk_length_follows_graph)
{
  // A square with a slit from its boundary to the center. The slit is 5 steps wide, so that no
  // edge crosses it.
  const Cloud square = part_of(square_cloud(41), [](const Vec3& p)
                               { return std::abs(p[0] - 0.5) > 0.06 || p[1] > 0.5; });
  const Surfel_cloud cloud = cloud_of(square);
  const Surface surface(cloud, Surfel_fit::quadrics);
  const auto nearest_vertex = [&](double x, double y)
  {
    Index best = 0;
    const Vec3 p = 1. / cloud.frame.scale * (Vec3{x, y, 0.} - cloud.frame.origin);
    for(Index i = 0; i < cloud.number_of_vertices(); ++i)
      if(norm(cloud.point[i] - p) < norm(cloud.point[best] - p))
        best = i;
    return best;
  };
  const auto walk_length = [&](Index from, Index to)
  { return cloud.frame.scale * surface.surface.walk_length(from, to); };
  // Round-off errors of sums of some tens of lengths.
  const double round_off = 1e-12;
  EXPECT_EQ(walk_length(nearest_vertex(0.1, 0.1), nearest_vertex(0.1, 0.1)), 0.);
  // The walk is at most as long as the path along both axes of the lattice.
  EXPECT_GE(walk_length(nearest_vertex(0.1, 0.1), nearest_vertex(0.4, 0.3)),
            std::hypot(0.3, 0.2) - round_off);
  EXPECT_LE(walk_length(nearest_vertex(0.1, 0.1), nearest_vertex(0.4, 0.3)), 0.5 + round_off);
  EXPECT_NEAR(walk_length(nearest_vertex(0.4, 0.7), nearest_vertex(0.6, 0.7)), 0.2, round_off);
  EXPECT_EQ(walk_length(nearest_vertex(0.4, 0.1), nearest_vertex(0.6, 0.1)), infinity);
}

TEST(Surfel_surface, preserves_sharp_edges)
{
  const Cloud cube = cube_cloud(10);
  const Surfel_cloud cloud = cloud_of(cube);
  const double half = 0.5 / cloud.frame.scale;
  for(const Surfel_fit fit :
      {Surfel_fit::planes, Surfel_fit::spheres, Surfel_fit::robust_spheres, Surfel_fit::quadrics})
  {
    const Surface surface(cloud, fit);
    for(Index i = 0; i < cloud.number_of_vertices(); ++i)
    {
      // The projection lies in the plane of the nearest surfel's face.
      const auto [u, v] = tangent_frame(cloud.normal[i]);
      const Projection projection =
          surface.project(cloud.point[i] + 0.02 * u + 0.01 * v + 0.01 * cloud.normal[i], i);
      // A few round-off errors.
      EXPECT_NEAR(std::abs(dot(projection.point, cloud.normal[projection.vertex])), half, 1e-14);
    }
  }
}

} // namespace Surfel_surface_test
