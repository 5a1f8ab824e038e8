// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_CLOUDS_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_CLOUDS_H

#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>
#include "surfels/normals.h"
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Surfel clouds of analytic surfaces, and the noise of Ruggeri, Darom, Saupe and Kiryati 2006,
// section 4.

namespace CGAL::Geodesic_processing::test {

// Vec3 is an alias of a standard type: its operators are not found by argument-dependent lookup.
using internal::operator+;
using internal::operator*;
using internal::Vec3;

struct Cloud
{
  std::vector<Vec3> points, normals; // unit normals

  std::size_t size() const { return points.size(); }
  void add(const Vec3& point, const Vec3& normal)
  {
    points.push_back(point);
    normals.push_back(normal);
  }
};

// The unit sphere: an octahedron whose triangles are subdivided 1-to-4 `level` times; 4^(level + 1)
// + 2 surfels.
inline Cloud octahedron_sphere(unsigned level)
{
  std::vector<Vec3> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<std::size_t, 3>> triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                       {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for(unsigned i = 0; i < level; ++i)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoint;
    const auto between = [&](std::size_t a, std::size_t b)
    {
      const auto [entry, is_new] = midpoint.try_emplace(std::minmax(a, b), points.size());
      if(is_new)
        points.push_back(internal::unit(points[a] + points[b]));
      return entry->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for(const auto& [a, b, c] : triangles)
    {
      const std::size_t d = between(a, b), e = between(b, c), f = between(c, a);
      finer.insert(finer.end(), {{a, d, f}, {d, b, e}, {f, e, c}, {d, e, f}});
    }
    triangles = std::move(finer);
  }
  return {points, points};
}

// The unit square as a grid of n x n surfels.
inline Cloud square_cloud(std::size_t n)
{
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
      cloud.add({double(i) / double(n - 1), double(j) / double(n - 1), 0.}, {0., 0., 1.});
  return cloud;
}

// A cylinder with equal angles around the z-axis and equal steps along it.
inline Cloud cylinder_cloud(std::size_t around, std::size_t along, double radius, double height)
{
  Cloud cloud;
  for(std::size_t j = 0; j < along; ++j)
    for(std::size_t i = 0; i < around; ++i)
    {
      const double a = 2. * internal::pi * double(i) / double(around);
      cloud.add(
          {radius * std::cos(a), radius * std::sin(a), height * double(j) / double(along - 1)},
          {std::cos(a), std::sin(a), 0.});
    }
  return cloud;
}

// Independent, uniformly distributed points of the unit sphere.
inline Cloud random_sphere(std::size_t n)
{
  std::mt19937 random(5);
  std::normal_distribution<double> coordinate;
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vec3 p = internal::unit(Vec3{coordinate(random), coordinate(random), coordinate(random)});
    cloud.add(p, p);
  }
  return cloud;
}

// Returns point i of n evenly distributed points of the unit sphere (Fibonacci spiral).
inline Vec3 on_spiral(std::size_t i, std::size_t n)
{
  const double z = 1. - (2. * double(i) + 1.) / double(n), r = std::sqrt(1. - z * z);
  const double a = double(i) * internal::pi * (3. - std::sqrt(5.));
  return {r * std::cos(a), r * std::sin(a), z};
}

inline Cloud ellipsoid_cloud(std::size_t n, const Vec3& axes)
{
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vec3 p = on_spiral(i, n);
    cloud.add({axes[0] * p[0], axes[1] * p[1], axes[2] * p[2]},
              internal::unit({p[0] / axes[0], p[1] / axes[1], p[2] / axes[2]}));
  }
  return cloud;
}

// A torus of about n surfels around the z-axis, with radii 1 and `tube`, in circles of equal steps.
inline Cloud torus_cloud(std::size_t n, double tube)
{
  const double step = std::sqrt(4. * internal::pi * internal::pi * tube / double(n));
  const auto rings = std::size_t(std::lround(2. * internal::pi * tube / step));
  Cloud cloud;
  for(std::size_t j = 0; j < rings; ++j)
  {
    const double v = 2. * internal::pi * double(j) / double(rings);
    const double radius = 1. + tube * std::cos(v);
    const auto around = std::size_t(std::lround(2. * internal::pi * radius / step));
    for(std::size_t i = 0; i < around; ++i)
    {
      const double u = 2. * internal::pi * (double(i) + 0.5 * double(j % 2)) / double(around);
      cloud.add({radius * std::cos(u), radius * std::sin(u), tube * std::sin(v)},
                {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)});
    }
  }
  return cloud;
}

// The surface of a unit cube centered at the origin, with n x n surfels per face at half a step
// from the edges.
inline Cloud cube_cloud(std::size_t n)
{
  Cloud cloud;
  for(int axis = 0; axis < 3; ++axis)
    for(const double sign : {-1., 1.})
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < n; ++j)
        {
          Vec3 point, normal = {0., 0., 0.};
          normal[axis] = sign;
          point[axis] = 0.5 * sign;
          point[(axis + 1) % 3] = (double(i) + 0.5) / double(n) - 0.5;
          point[(axis + 2) % 3] = (double(j) + 0.5) / double(n) - 0.5;
          cloud.add(point, normal);
        }
  return cloud;
}

// Returns the surfels whose points satisfy `keep`.
template <typename Keep>
Cloud part_of(const Cloud& cloud, const Keep& keep)
{
  Cloud result;
  for(std::size_t i = 0; i < cloud.size(); ++i)
    if(keep(cloud.points[i]))
      result.add(cloud.points[i], cloud.normals[i]);
  return result;
}

// Moves each surfel along its normal by up to `level` times its radius, and rotates its normal by
// up to 10 degrees in a random direction.
inline Cloud with_noise(Cloud cloud, const std::vector<double>& radii, double level, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-level, level), polar(0., internal::pi / 18.),
      azimuth(0., 2. * internal::pi);
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    Vec3& normal = cloud.normals[i];
    cloud.points[i] = cloud.points[i] + offset(random) * radii[i] * normal;
    const auto [u, v] = internal::tangent_frame(normal);
    const double a = azimuth(random), b = polar(random);
    normal = std::cos(b) * normal + std::sin(b) * (std::cos(a) * u + std::sin(a) * v);
  }
  return cloud;
}

// Adds copies of a random fraction of the clean surfels with noise of the given level.
inline Cloud with_outliers(Cloud cloud, const Cloud& clean, const std::vector<double>& radii,
                           double fraction, double level, unsigned seed)
{
  std::mt19937 random(seed);
  Cloud outliers;
  std::vector<double> outlier_radii;
  for(std::size_t i = 0; i < std::size_t(fraction * double(clean.size())); ++i)
  {
    const std::size_t j = random() % clean.size();
    outliers.add(clean.points[j], clean.normals[j]);
    outlier_radii.push_back(radii[j]);
  }
  outliers = with_noise(std::move(outliers), outlier_radii, level, seed + 1);
  cloud.points.insert(cloud.points.end(), outliers.points.begin(), outliers.points.end());
  cloud.normals.insert(cloud.normals.end(), outliers.normals.begin(), outliers.normals.end());
  return cloud;
}

// A simulated scan of the unit square by a laser stripe scanner: n stripes of m points. Each point
// has an error of its own, an error of its stripe, and an error from the pixels of the camera, in
// total about a tenth of the spacing. Normals are estimated. Seed 0 yields the exact square.
inline Cloud scanned_square(std::size_t n, std::size_t m, unsigned seed)
{
  const double spacing = 1. / double(n - 1);
  std::mt19937 random(seed);
  std::normal_distribution<double> stripe(0., 0.04 * spacing), point(0., 0.08 * spacing);
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double offset = seed == 0 ? 0. : stripe(random);
    for(std::size_t j = 0; j < m; ++j)
    {
      const double height = seed == 0 ? 0. : offset + point(random);
      cloud.add({spacing * double(i), double(j) / double(m - 1),
                 0.04 * spacing * std::round(height / (0.04 * spacing))},
                {0., 0., 1.});
    }
  }
  if(seed != 0)
    cloud.normals = internal::estimate_normals(cloud.points, 18, true);
  return cloud;
}

// Returns whether a path of length at most `max_length` in the proximity graph joins two vertices.
inline bool is_connected_within(const internal::Surfel_cloud& cloud, internal::Index from,
                                internal::Index to, double max_length)
{
  using namespace internal;
  const Proximity_graph& graph = cloud.graph;
  std::map<Index, double> distance = {{from, 0.}};
  std::vector<Index> queue = {from};
  for(std::size_t i = 0; i < queue.size() && distance.count(to) == 0; ++i)
    for(Index edge = graph.begin[queue[i]]; edge < graph.begin[queue[i] + 1]; ++edge)
      if(const double d =
             distance[queue[i]] + norm(cloud.point[graph.target[edge]] - cloud.point[queue[i]]);
         d <= max_length)
        if(const auto [entry, is_new] = distance.try_emplace(graph.target[edge], d);
           is_new || d < entry->second)
        {
          entry->second = d;
          queue.push_back(entry->first);
        }
  return distance.count(to) > 0;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_CLOUDS_H
