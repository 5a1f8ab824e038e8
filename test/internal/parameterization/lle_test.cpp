// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

struct Flat
{
  Base_points base;
  std::vector<Planar> places, image;
};

Flat flattened(const Glued_surface& surface, std::size_t number, std::size_t neighbors = 10)
{
  const Front front(surface.triangles(), Front_kind::euclidean);
  Sampling sampling(surface.triangles(), front, Sample_place::site);
  Sampling_goal goal;
  goal.number = number;
  sample_farthest(sampling, goal, [](double) {});
  Flat result;
  result.base = nearest_base_points(surface.t(), sampling, front, nearest_for(neighbors));
  result.places = embedded(result.base, neighbors);
  result.image = extended(result.base, result.places, neighbors);
  return result;
}

// The largest difference of a distance in the image from that in space, of pairs with the first point.
double error_in_plane(const Glued_surface& surface, const std::vector<Planar>& image)
{
  double result = 0.;
  for(const Index a : {Index(0), surface.size() / 2})
    for(Index b = 0; b < surface.size(); ++b)
      result = std::max(
          result, std::abs(surface.scale() * norm(image[surface.site(b)] - image[surface.site(a)]) -
                           distance(surface.point(a), surface.point(b))));
  return result;
}

TEST(lle, keeps_a_piece_of_the_plane)
{
  const Glued_surface surface(square(40, 0.25));
  // Rounding and fronts' ends, some millionths.
  for(const std::size_t number : {4u, 20u, 100u})
    EXPECT_LT(error_in_plane(surface, flattened(surface, number).image), 2e-5) << number;
}

TEST(lle, keeps_what_unrolls_into_a_plane)
{
  // A quarter of a cylinder: chords are shorter than arcs, by less than a ten-thousandth.
  const Glued_surface surface(grid(
      30, 30,
      [](double s, double t) -> Point {
        return {std::cos(0.5 * pi * s), std::sin(0.5 * pi * s), t};
      },
      0.2));
  const Flat flat = flattened(surface, 100);
  double worst = 0.;
  for(Index a = 0; a < surface.size(); ++a)
  {
    const Point &p = surface.point(a), &q = surface.point(0);
    const double along = std::atan2(p[1], p[0]) - std::atan2(q[1], q[0]);
    worst = std::max(worst, std::abs(surface.scale() * norm(flat.image[surface.site(a)] -
                                                            flat.image[surface.site(0)]) -
                                     std::hypot(along, p[2] - q[2])));
  }
  EXPECT_LT(worst, 2e-3);
}

TEST(lle, is_exact_at_base_points_and_continuous)
{
  Triangulation cap = icosphere(4);
  Triangulation half;
  half.points = cap.points;
  for(std::size_t c = 0; c < cap.corners.size(); c += 3)
    if(cap.points[cap.corners[c]][2] > 0. && cap.points[cap.corners[c + 1]][2] > 0. &&
       cap.points[cap.corners[c + 2]][2] > 0.)
      half.corners.insert(half.corners.end(), cap.corners.begin() + std::ptrdiff_t(c),
                          cap.corners.begin() + std::ptrdiff_t(c) + 3);
  const Glued_surface surface(half);
  const Flat flat = flattened(surface, 60);
  for(std::size_t i = 0; i < flat.base.size(); ++i)
    EXPECT_EQ(flat.image[flat.base.sites[i]], flat.places[i]);
  // Over a hemisphere lengths change by half at most.
  const Glued_triangles& t = surface.t();
  for(Index side = 0; side < t.corner.size(); ++side)
    EXPECT_LT(norm(flat.image[t.corner[next_side(side)]] - flat.image[t.corner[side]]),
              2. * t.length[side]);
}

TEST(lle, scales_known_places_classically)
{
  const Eigen::MatrixXd places = Eigen::MatrixXd::Random(12, 2);
  Eigen::MatrixXd squares(12, 12);
  for(int i = 0; i < 12; ++i)
    for(int j = 0; j < 12; ++j)
      squares(i, j) = (places.row(i) - places.row(j)).squaredNorm();
  const Eigen::MatrixXd found = classical_scaling(squares);
  for(int i = 0; i < 12; ++i)
    for(int j = 0; j < 12; ++j)
      EXPECT_NEAR((found.row(i) - found.row(j)).squaredNorm(), squares(i, j), 1e-12); // roundings
}

} // namespace
