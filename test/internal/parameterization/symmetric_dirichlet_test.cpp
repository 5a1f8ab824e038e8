// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>
#include <CGAL/Geodesic_processing/internal/parameterization/tutte_map.h>
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace symmetric_dirichlet_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

Triangulation dome(std::size_t n)
{
  return grid(
      n, n,
      [](double s, double t) -> Point
      {
        const double x = 2. * s - 1., y = 2. * t - 1.;
        return {x, y, 1.5 * std::exp(-3. * (x * x + y * y))};
      },
      0.2);
}

// Computes the energy independently, from singular values.
double energy(const Surface_arrays& t, const std::vector<Vec2>& image)
{
  double area = 0., result = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Singular_values s = singular_values(
        {t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]},
        {image[t.corner[3 * f]], image[t.corner[3 * f + 1]], image[t.corner[3 * f + 2]]});
    area += s.area;
    result += s.area * (s.sigma_1 * s.sigma_1 + s.sigma_2 * s.sigma_2 +
                        1. / (s.sigma_1 * s.sigma_1) + 1. / (s.sigma_2 * s.sigma_2));
  }
  return result / area;
}

TEST(symmetric_dirichlet, counts_flips)
{
  const Array_surface surface(square(4));
  std::vector<Vec2> image(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    image[surface.vertex(i)] = {surface.point(i)[0], surface.point(i)[1]};
  EXPECT_EQ(number_of_flips(surface.t(), image), 0u);
  // Moves an interior vertex across edges of its one-ring.
  image[surface.vertex(12)][0] += 0.6;
  const std::size_t number_flipped = number_of_flips(surface.t(), image);
  EXPECT_GT(number_flipped, 0u);
  for(Vec2& p : image)
    p[0] = -p[0];
  EXPECT_EQ(number_of_flips(surface.t(), image),
            surface.t().number_of_triangles() - number_flipped);
}

TEST(symmetric_dirichlet, planar_patch_becomes_isometric)
{
  const Array_surface surface(square(15, 0.25));
  std::vector<Vec2> image = tutte_map(surface.t());
  const Minimization_result found = minimize_symmetric_dirichlet(surface.t(), image, 200);
  EXPECT_TRUE(found.is_complete);
  EXPECT_EQ(number_of_flips(surface.t(), image), 0u);
  // The last step decreased the energy by less than 1e-6, and Newton's method converges
  // quadratically.
  EXPECT_NEAR(found.energy, 4., 1e-6);
  EXPECT_NEAR(energy(surface.t(), image), found.energy, 1e-9);
}

TEST(symmetric_dirichlet, result_is_a_local_minimum)
{
  const Array_surface surface(dome(15));
  std::vector<Vec2> image = tutte_map(surface.t());
  const Minimization_result found = minimize_symmetric_dirichlet(surface.t(), image, 200);
  EXPECT_EQ(number_of_flips(surface.t(), image), 0u);
  EXPECT_NEAR(energy(surface.t(), image), found.energy, 1e-9 * found.energy); // round-off errors
  EXPECT_GT(found.energy, 4.);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for(int attempt = 0; attempt < 20; ++attempt)
    for(const double size : {1e-4, 1e-3, 1e-2})
    {
      // Smooth perturbations, to which the energy is least sensitive.
      Vec2 a, b, c;
      for(int axis = 0; axis < 2; ++axis)
      {
        a[axis] = normal(random);
        b[axis] = normal(random);
        c[axis] = normal(random);
      }
      std::vector<Vec2> moved = image;
      for(Vec2& p : moved)
        p = p + size * Vec2{std::sin(dot(a, p)), std::cos(dot(b, p) + c[0])};
      // The last step decreased the energy by less than the fraction 1e-6.
      EXPECT_GE(energy(surface.t(), moved), found.energy * (1. - 1e-6)) << size;
    }
}

TEST(symmetric_dirichlet, cancelled_result_has_no_flips)
{
  const Array_surface surface(dome(10));
  std::vector<Vec2> image = tutte_map(surface.t());
  const Minimization_result found = minimize_symmetric_dirichlet(
      surface.t(), image, 200, [](double done) { return done < 0.01; });
  EXPECT_FALSE(found.is_complete);
  EXPECT_LT(found.number_of_iterations, 4u);
  EXPECT_EQ(number_of_flips(surface.t(), image), 0u);
}

} // namespace symmetric_dirichlet_test
