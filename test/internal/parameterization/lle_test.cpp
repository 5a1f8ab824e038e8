// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lle_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

struct Flattening
{
  Base_points base;
  std::vector<Vec2> positions, image;
};

Flattening flatten(const Array_surface& surface, std::size_t number, std::size_t neighbors = 10,
                   const Embedding_options& embedding_options = {})
{
  const Front front(surface.triangles(), Front_kind::euclidean);
  Sampling sampling(surface.triangles(), front, Sample_location::vertex);
  Sampling_options options;
  options.number_of_samples = number;
  sample_farthest_points(sampling, options, [](double) {});
  Flattening result;
  result.base = nearest_base_points(surface.t(), sampling, front, number_of_nearest_for(neighbors));
  result.positions = embed_base_points(result.base, neighbors, embedding_options);
  result.image = extend_embedding(result.base, result.positions, neighbors);
  return result;
}

// Returns the maximum difference between distances in the image and in space, from two points to
// all others.
double error_in_plane(const Array_surface& surface, const std::vector<Vec2>& image)
{
  double result = 0.;
  for(const Index a : {Index(0), surface.size() / 2})
    for(Index b = 0; b < surface.size(); ++b)
      result = std::max(result, std::abs(surface.scale() * norm(image[surface.vertex(b)] -
                                                                image[surface.vertex(a)]) -
                                         distance(surface.point(a), surface.point(b))));
  return result;
}

TEST(lle, is_isometric_on_planar_patch)
{
  const Array_surface surface(square(40, 0.25));
  // Round-off errors of the front and of the least squares system, whose condition numbers are
  // large. Measured: 1.4e-7.
  for(const std::size_t number : {4u, 20u, 100u})
    EXPECT_LT(error_in_plane(surface, flatten(surface, number).image), 1e-6) << number;
}

TEST(lle, is_isometric_on_developable_patch)
{
  // A quarter of a cylinder. Chords are shorter than arcs by the fraction h^2 / 24, where the edge
  // length h is 0.052. The sum is 2e-4.
  const Array_surface surface(grid(
      30, 30,
      [](double s, double t) -> Point {
        return {std::cos(0.5 * pi * s), std::sin(0.5 * pi * s), t};
      },
      0.2));
  const Flattening flattening = flatten(surface, 100);
  double max_error = 0.;
  for(Index a = 0; a < surface.size(); ++a)
  {
    const Point &p = surface.point(a), &q = surface.point(0);
    const double arc_length = std::atan2(p[1], p[0]) - std::atan2(q[1], q[0]);
    max_error =
        std::max(max_error, std::abs(surface.scale() * norm(flattening.image[surface.vertex(a)] -
                                                            flattening.image[surface.vertex(0)]) -
                                     std::hypot(arc_length, p[2] - q[2])));
  }
  // Twice the deficit of the chords.
  EXPECT_LT(max_error, 4e-4);
}

// A start alone, without rigid steps.
constexpr Embedding_options lle_alone = {true, false, 0}, isomap_alone = {false, true, 0};

TEST(lle, alone_is_isometric_on_planar_patch)
{
  const Array_surface surface(square(40, 0.25));
  for(const std::size_t number : {20u, 100u})
    // Errors of the front and the regularization of the weights. Measured: 3.4e-7. With uniform
    // weights the errors are above 0.5, with the next eigenvectors above 1.2.
    EXPECT_LT(error_in_plane(surface, flatten(surface, number, 10, lle_alone).image), 1e-6)
        << number;
}

// Returns the maximum error of distances from the first point in an image of a patch that unfolds
// to given points of the plane.
double error_of_unfolding(const Array_surface& surface, const std::vector<Vec2>& image,
                          const std::vector<Vec2>& unfolded)
{
  double result = 0.;
  for(Index a = 0; a < surface.size(); ++a)
    result = std::max(result, std::abs(surface.scale() * norm(image[surface.vertex(a)] -
                                                              image[surface.vertex(0)]) -
                                       norm(unfolded[a] - unfolded[0])));
  return result;
}

TEST(lle, alone_is_isometric_on_developable_patches)
{
  // A quarter of a cylinder with radius 1, and a sector of a cone with slope 1, whose apex angle is
  // 90 degrees in the plane. Both have sizes between 1 and 2.
  const auto cylinder_point = [](double s, double t) -> Point {
    return {std::cos(0.5 * pi * s), std::sin(0.5 * pi * s), t};
  };
  const auto cone_point = [](double s, double t) -> Point
  {
    const double radius = 1. + t, angle = std::sqrt(2.) * 0.5 * pi * s;
    return {radius * std::cos(angle) / std::sqrt(2.), radius * std::sin(angle) / std::sqrt(2.),
            radius / std::sqrt(2.)};
  };
  for(const bool is_cone : {false, true})
  {
    const Triangulation shape =
        is_cone ? grid(30, 30, cone_point, 0.2) : grid(30, 30, cylinder_point, 0.2);
    const Array_surface surface(shape);
    std::vector<Vec2> unfolded;
    for(const Point& p : shape.points)
    {
      const double angle = std::atan2(p[1], p[0]);
      const double radius = norm(p), planar_angle = angle / std::sqrt(2.);
      unfolded.push_back(
          is_cone ? Vec2{radius * std::cos(planar_angle), radius * std::sin(planar_angle)}
                  : Vec2{angle, p[2]});
    }
    const double error =
        error_of_unfolding(surface, flatten(surface, 100, 10, lle_alone).image, unfolded);
    // The chords of the cylinder are shorter than arcs by 2e-4. The flat faces of the cone, whose
    // edges span up to a tenth of a radian, have angle defects. Measured: 1.7e-4 and 0.0020. With
    // uniform weights the errors are above 0.8, with the next eigenvectors above 1.4.
    EXPECT_LT(error, is_cone ? 4e-3 : 4e-4);
  }
}

TEST(lle, isomap_alone_is_nearly_isometric_on_planar_patch)
{
  const Array_surface surface(square(40, 0.25));
  // Chains of base points are longer than lines, by similar fractions everywhere. Measured: 0.0038.
  const double error = error_in_plane(surface, flatten(surface, 100, 10, isomap_alone).image);
  EXPECT_LT(error, 0.01);
  EXPECT_GT(error, error_in_plane(surface, flatten(surface, 100, 10, lle_alone).image));
}

TEST(lle, interpolates_base_points_continuously)
{
  Triangulation cap = icosphere(4);
  Triangulation half;
  half.points = cap.points;
  for(std::size_t c = 0; c < cap.corners.size(); c += 3)
    if(cap.points[cap.corners[c]][2] > 0. && cap.points[cap.corners[c + 1]][2] > 0. &&
       cap.points[cap.corners[c + 2]][2] > 0.)
      half.corners.insert(half.corners.end(), cap.corners.begin() + std::ptrdiff_t(c),
                          cap.corners.begin() + std::ptrdiff_t(c) + 3);
  const Array_surface surface(half);
  const Flattening flattening = flatten(surface, 60);
  for(std::size_t i = 0; i < flattening.base.size(); ++i)
    EXPECT_EQ(flattening.image[flattening.base.vertices[i]], flattening.positions[i]);
  // On a hemisphere lengths change by less than a factor of two.
  const Surface_arrays& t = surface.t();
  for(Index h = 0; h < t.corner.size(); ++h)
    EXPECT_LT(norm(flattening.image[t.corner[next_halfedge(h)]] - flattening.image[t.corner[h]]),
              2. * t.length[h]);
}

TEST(lle, classical_scaling_recovers_known_positions)
{
  const Eigen::MatrixXd positions = Eigen::MatrixXd::Random(12, 2);
  Eigen::MatrixXd squares(12, 12);
  for(int i = 0; i < 12; ++i)
    for(int j = 0; j < 12; ++j)
      squares(i, j) = (positions.row(i) - positions.row(j)).squaredNorm();
  const Eigen::MatrixXd found = classical_scaling(squares);
  for(int i = 0; i < 12; ++i)
    for(int j = 0; j < 12; ++j)
      // round-off errors
      EXPECT_NEAR((found.row(i) - found.row(j)).squaredNorm(), squares(i, j), 1e-12);
}

} // namespace lle_test
