// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/transport_family.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>
#include "transport/flat_refinement.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>
#include <CGAL/Geodesic_processing/internal/transport/transport.h>

#include "Glued_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of sums of some thousand terms in double, and with fields in float.
constexpr double rounding = 1e-9, float_rounding = 1e-5;

constexpr Particular_field both[] = {Particular_field::gradient, Particular_field::raviart_thomas};

Family_options within(double tolerance, unsigned threads = 1)
{
  Family_options result;
  result.tolerance = tolerance;
  result.threads = threads;
  return result;
}

Masses unit(std::size_t sites, Index site)
{
  Masses result(Eigen::Index(sites), 1);
  result.insert(site, 0) = 1.;
  return result;
}

// A unit from the first to the second site of each pair.
Masses differences(std::size_t sites, const std::vector<std::array<Index, 2>>& pairs)
{
  Masses result(Eigen::Index(sites), Eigen::Index(pairs.size()));
  for(std::size_t j = 0; j < pairs.size(); ++j)
  {
    result.coeffRef(pairs[j][0], Eigen::Index(j)) -= 1.;
    result.coeffRef(pairs[j][1], Eigen::Index(j)) += 1.;
  }
  return result;
}

std::vector<std::array<Index, 2>> random_pairs(std::size_t sites, std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::array<Index, 2>> result(number);
  for(auto& pair : result)
    pair = {Index(random() % sites), Index(random() % sites)};
  return result;
}

// A square with a square hole.
Triangulation frame(std::size_t n)
{
  Triangulation result = square(n, 0.2), rest = result;
  rest.corners.clear();
  for(std::size_t f = 0; f < result.corners.size(); f += 3)
  {
    const std::size_t cell = f / 6, i = cell % n, j = cell / n;
    if(i < n / 4 || i >= n - n / 4 || j < n / 4 || j >= n - n / 4)
      rest.corners.insert(rest.corners.end(), &result.corners[f], &result.corners[f] + 3);
  }
  return rest;
}

std::vector<Triangulation> surfaces()
{
  return {shaken(icosphere(2), 0.03), frame(12),     square(12, 0.24),
          cylinder(16, 10, 1., 2.),   torus(20, 10), double_ring(2)};
}

// Sites inside of a frame's hole are in no triangle.
bool is_used(const Glued_triangles& t, Index site) { return t.first[site] < t.first[site + 1]; }

std::vector<std::array<Index, 2>> used_pairs(const Glued_triangles& t, std::size_t number,
                                             unsigned seed)
{
  std::vector<std::array<Index, 2>> result;
  while(result.size() < number)
    for(const auto& pair : random_pairs(t.number_of_sites(), number, ++seed))
      if(is_used(t, pair[0]) && is_used(t, pair[1]) && pair[0] != pair[1] && result.size() < number)
        result.push_back(pair);
  return result;
}

TEST(Transport_family, has_a_closed_form_without_a_basis)
{
  for(const Triangulation& shape : surfaces())
    for(const Particular_field kind : both)
    {
      const Glued_surface surface(shape);
      const Transport_family family(surface.triangles(), 0, kind);
      const Operators& o = family.operators();
      const auto pairs = used_pairs(surface.t(), 10, 1);
      const Masses masses = differences(surface.size(), pairs);
      const std::vector<Bounds> bounds = family.distances(masses, within(1e-3));
      const Particular_fields particular(surface.t(), o, kind);
      for(std::size_t j = 0; j < pairs.size(); ++j)
      {
        const Field field = as_field(o, particular.fields(masses).col(Eigen::Index(j)));
        double sum = 0.;
        for(std::size_t f = 0; f < field.size(); ++f)
          sum += o.area[f] * norm(field[f]);
        EXPECT_EQ(bounds[j].lower, bounds[j].upper);
        EXPECT_NEAR(bounds[j].upper, sum, rounding * sum);

        const Vector all = family.one_to_all(unit(surface.size(), pairs[j][0]), within(1e-3));
        EXPECT_NEAR(all[pairs[j][1]], sum, rounding * sum);
        EXPECT_EQ(all[pairs[j][0]], 0.);
        Masses two(Eigen::Index(surface.size()), 2);
        two.insert(pairs[j][0], 0) = two.insert(pairs[j][1], 1) = 1.;
        const Matrix matrix = family.all_pairs(two, within(1e-3));
        EXPECT_NEAR(matrix(0, 1), sum, float_rounding * sum);
        EXPECT_EQ(matrix(0, 1), matrix(1, 0));
        EXPECT_EQ(matrix(0, 0), 0.);
      }
    }
}

// 1,200 pairs, around holes and along borders.
TEST(Transport_family, never_grows_with_its_basis)
{
  for(const Triangulation& shape : surfaces())
    for(const Particular_field kind : both)
    {
      const Glued_surface surface(shape);
      const Masses masses = differences(surface.size(), used_pairs(surface.t(), 100, 7));
      std::vector<Bounds> before(100, {infinity, infinity});
      std::size_t size = 0;
      for(const std::size_t k : {0, 1, 5, 20, 60})
      {
        const Transport_family family(surface.triangles(), k, kind);
        EXPECT_GE(family.basis_size(), std::max(k, size));
        size = family.basis_size();
        const std::vector<Bounds> bounds = family.distances(masses, within(1e-3));
        ASSERT_EQ(bounds.size(), before.size());
        for(std::size_t j = 0; j < bounds.size(); ++j)
        {
          EXPECT_LE(bounds[j].upper - bounds[j].lower, 1e-3 * bounds[j].upper);
          EXPECT_LE(bounds[j].lower, before[j].upper * (1. + rounding));
        }
        before = bounds;
      }
    }
}

// All flows of the family with gradients are flows of the complete formulation.
TEST(Transport_family, lies_above_the_complete_formulation)
{
  for(const Triangulation& shape : surfaces())
  {
    const Glued_surface surface(shape);
    const Transport_solver complete(operators(surface.t()));
    const Transport_family family(surface.triangles(), 60, Particular_field::gradient);
    const auto pairs = used_pairs(surface.t(), 10, 3);
    const Masses masses = differences(surface.size(), pairs);
    const std::vector<Bounds> bounds = family.distances(masses, within(1e-3));
    for(std::size_t j = 0; j < pairs.size(); ++j)
    {
      const Transport transport = complete.solve(Matrix(masses).col(Eigen::Index(j)));
      EXPECT_GE(bounds[j].upper, transport.lower);
      EXPECT_LT(bounds[j].upper, 2. * transport.upper); // far below that of no basis
    }
  }
}

// 1,000 random triples for each k.
TEST(Transport_family, obeys_the_triangle_inequality)
{
  const Glued_surface surface(double_ring(2));
  std::mt19937 random(1);
  Masses places(Eigen::Index(surface.size()), 24);
  for(Eigen::Index j = 0; j < places.cols(); ++j)
    places.insert(Eigen::Index(random() % surface.size()), j) = 1.;
  for(const Particular_field kind : both)
    for(const std::size_t k : {0, 10, 100})
    {
      const double tolerance = 1e-3;
      const Transport_family family(surface.triangles(), k, kind);
      const Matrix d = family.all_pairs(places, within(tolerance));
      EXPECT_EQ(d, Matrix(d.transpose()));
      // Middles of bounds that are apart by that part of the upper one.
      const double slack = k == 0 ? float_rounding : 0.51 * tolerance;
      for(int i = 0; i < 1000; ++i)
      {
        const Eigen::Index p = random() % 24, q = random() % 24, r = random() % 24;
        EXPECT_LE(d(p, r) * (1. - slack), (d(p, q) + d(q, r)) * (1. + slack));
      }
    }
}

// Each refinement halves the sides, and with them what distances of points change, up to higher orders: on
// these coarse surfaces it is at most 0.72 times as much.
TEST(Transport_family, settles_on_refined_surfaces)
{
  for(const Triangulation& shape : surfaces())
    for(const std::size_t k : {0, 5})
    {
      const Glued_surface surface(shape);
      const auto pairs = used_pairs(surface.t(), 20, 11);
      std::vector<std::vector<double>> values;
      auto triangles = surface.triangles();
      for(int level = 0; level < 3; ++level)
      {
        if(level > 0)
          triangles = std::make_shared<const Glued_triangles>(refined(*triangles));
        const Transport_family family(triangles, k, Particular_field::gradient);
        values.emplace_back();
        for(const Bounds& bounds :
            family.distances(differences(triangles->number_of_sites(), pairs), within(1e-4)))
          values.back().push_back(0.5 * triangles->scale * (bounds.lower + bounds.upper));
      }
      std::vector<double> change(2, 0.);
      for(std::size_t j = 0; j < pairs.size(); ++j)
        for(int level = 0; level < 2; ++level)
          change[level] += std::abs(values[level + 1][j] / values[level][j] - 1.) / 20.;
      EXPECT_LT(change[1], 0.8 * change[0]);
    }
}

TEST(Transport_family, is_symmetric_to_the_last_bit)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  for(const Particular_field kind : both)
    for(const std::size_t k : {0, 15})
    {
      const Transport_family family(surface.triangles(), k, kind);
      for(const auto& [p, q] : random_pairs(surface.size(), 10, 5))
      {
        const Bounds there =
            family.distances(differences(surface.size(), {{p, q}}), within(1e-3)).front();
        const Bounds back =
            family.distances(differences(surface.size(), {{q, p}}), within(1e-3)).front();
        EXPECT_EQ(there.lower, back.lower);
        EXPECT_EQ(there.upper, back.upper);
      }
    }
}

TEST(Transport_family, finds_all_distances_of_a_site_within_a_percent)
{
  for(const Triangulation& shape : {shaken(icosphere(3), 0.02), torus(40, 20), square(24, 0.24)})
    for(const Particular_field kind : both)
    {
      const Glued_surface surface(shape);
      const Transport_family family(surface.triangles(), 20, kind);
      const Vector all = family.one_to_all(unit(surface.size(), 0), within(1e-3));
      std::vector<std::array<Index, 2>> pairs;
      for(Index site = 1; site < surface.size(); site += 11)
        pairs.push_back({0, site});
      const std::vector<Bounds> bounds =
          family.distances(differences(surface.size(), pairs), within(1e-3));
      double sum = 0.;
      for(std::size_t j = 0; j < pairs.size(); ++j)
      {
        EXPECT_GE(all[pairs[j][1]], bounds[j].lower * (1. - float_rounding));
        sum += all[pairs[j][1]] / bounds[j].lower - 1.;
      }
      EXPECT_LT(sum / double(pairs.size()), 0.01);
    }
}

TEST(Transport_family, does_not_depend_on_threads)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
  const Masses masses = differences(surface.size(), random_pairs(surface.size(), 80, 1));
  Masses places(Eigen::Index(surface.size()), 70);
  for(Eigen::Index j = 0; j < 70; ++j)
    places.insert(9 * j, j) = 1.;
  for(const std::size_t k : {0, 10})
  {
    const Transport_family family(surface.triangles(), k, Particular_field::raviart_thomas);
    const auto alone = family.distances(masses, within(0.01)),
               together = family.distances(masses, within(0.01, 3));
    for(std::size_t j = 0; j < alone.size(); ++j)
    {
      EXPECT_EQ(alone[j].lower, together[j].lower);
      EXPECT_EQ(alone[j].upper, together[j].upper);
    }
    EXPECT_EQ(family.one_to_all(unit(surface.size(), 3), within(0.01)),
              family.one_to_all(unit(surface.size(), 3), within(0.01, 3)));
    if(k == 0) // others are distances(), as above
    {
      EXPECT_EQ(family.all_pairs(places, within(0.01)), family.all_pairs(places, within(0.01, 3)));
    }
  }
}

// A basis of which a group of repeated values was cut would prefer some directions: symmetries of the
// triangulation tell.
TEST(Transport_family, is_the_same_in_symmetric_directions)
{
  for(const std::size_t k : {1, 5, 10})
  {
    // Of a sphere's vertices, those that are as far from a pole.
    const Glued_surface sphere(icosphere(2));
    const Transport_family family(sphere.triangles(), k, Particular_field::gradient);
    const Masses from = unit(sphere.size(), sphere.site(0));
    std::map<long, std::vector<std::array<Index, 2>>> rings;
    for(Index i = 1; i < sphere.size(); ++i)
      rings[std::lround(1e6 * test::distance(sphere.point(0), sphere.point(i)))].push_back(
          {sphere.site(0), sphere.site(i)});
    for(const auto& [distance, ring] : rings)
    {
      const auto bounds = family.distances(differences(sphere.size(), ring), within(1e-4));
      for(std::size_t j = 0; j < bounds.size() && ring.size() == 5; ++j) // turns around the pole
      {
        EXPECT_LE(bounds[j].lower, bounds[0].upper);
        EXPECT_GE(bounds[j].upper, bounds[0].lower);
      }
    }
    // Both sides of a square's diagonal.
    const Glued_surface plane(square(12));
    const Transport_family in_plane(plane.triangles(), k, Particular_field::gradient);
    const auto point = [&](Index i, Index j) { return plane.site(i + 13 * j); };
    std::vector<std::array<Index, 2>> pairs;
    for(Index i = 0; i < 13; ++i)
      for(Index j = 0; j < i; j += 2)
      {
        pairs.push_back({point(6, 6), point(i, j)});
        pairs.push_back({point(6, 6), point(j, i)});
      }
    const auto bounds = in_plane.distances(differences(plane.size(), pairs), within(1e-4));
    for(std::size_t j = 0; j < bounds.size(); j += 2)
    {
      EXPECT_LE(bounds[j].lower, bounds[j + 1].upper);
      EXPECT_GE(bounds[j].upper, bounds[j + 1].lower);
    }
  }
}

// Far from the source, along a pipe, where Green's functions fall evenly, d_0 is the height: the
// coefficient of variation of |gradient d(p, .)| is less than half of that of biharmonic distances.
TEST(Transport_family, is_even_along_a_pipe)
{
  const Glued_surface surface(cylinder(16, 80, 1., 30.));
  const Transport_family family(surface.triangles(), 0, Particular_field::gradient);
  const Biharmonic_distances biharmonic(surface.t());
  const Operators& o = family.operators();
  for(const Index from : {0u, surface.size() / 3, surface.size() / 2})
  {
    const auto variation = [&](const Vector& function)
    {
      double area = 0., sum = 0., squares = 0.;
      const Field slope = gradient(o, function);
      for(std::size_t f = 0; f < slope.size(); ++f)
      {
        const Index corner = surface.point_of_site(o.corner[3 * f]);
        if(std::abs(surface.point(corner)[2] - surface.point(from)[2]) < 2. * pi) // once around
          continue;
        area += o.area[f];
        sum += o.area[f] * norm(slope[f]);
        squares += o.area[f] * dot(slope[f], slope[f]);
      }
      return std::sqrt(squares * area / (sum * sum) - 1.);
    };
    const Masses source = unit(surface.size(), surface.site(from));
    EXPECT_LT(variation(family.one_to_all(source, {})),
              0.5 * variation(biharmonic.one_to_all(source, 1)));
  }
}

// Along each row, column and diagonal of the square the distance falls and then rises.
TEST(Transport_family, has_convex_level_sets_on_a_square)
{
  const int n = 32;
  const Glued_surface surface(square(n));
  const Transport_family family(surface.triangles(), 0, Particular_field::gradient);
  for(const auto& [u, v] : {std::pair(n / 2, n / 2), std::pair(n / 4, n / 3)})
  {
    const Vector d =
        family.one_to_all(unit(surface.size(), surface.site(Index(u + (n + 1) * v))), {});
    const auto at = [&](int i, int j) { return d[surface.site(Index(i + (n + 1) * j))]; };
    const auto expect_a_valley = [&](int i, int j, int di, int dj)
    {
      double highest = 0.;
      bool rises = false;
      double before = at(i, j);
      for(; i >= 0 && j >= 0 && i <= n && j <= n; i += di, j += dj)
      {
        // The diagonals of the cells all go one way, which turns level sets by a part of a cell.
        rises = rises || at(i, j) > before + 0.02 / n;
        highest = rises ? std::max(highest, at(i, j)) : 0.;
        EXPECT_GE(at(i, j), highest - 0.02 / n) << i << ' ' << j;
        before = at(i, j);
      }
    };
    for(int i = 0; i <= n; ++i)
    {
      expect_a_valley(i, 0, 0, 1);
      expect_a_valley(0, i, 1, 0);
      expect_a_valley(i, 0, 1, 1);
      expect_a_valley(0, i, 1, 1);
      expect_a_valley(i, 0, -1, 1);
      expect_a_valley(n, i, -1, 1);
    }
  }
}

TEST(Transport_family, takes_clouds)
{
  const Cloud cloud = octahedron_sphere(3);
  const auto sphere =
      std::make_shared<Glued_triangles>(glue_surfels(cloud.points, cloud.normals).triangles);
  const Transport_family spectral(sphere, 0, Particular_field::raviart_thomas);
  const Transport_family family(sphere, 20, Particular_field::raviart_thomas);
  EXPECT_EQ(family.kind(), Particular_field::gradient);
  EXPECT_GE(family.basis_size(), 20u);
  const Masses masses = differences(cloud.size(), random_pairs(cloud.size(), 30, 1));
  const auto above = spectral.distances(masses, within(1e-3));
  const auto bounds = family.distances(masses, within(1e-3));
  const Transport_solver complete(family.operators());
  double sum = 0., sum_of_complete = 0.;
  for(std::size_t j = 0; j < bounds.size(); ++j)
  {
    EXPECT_LE(bounds[j].lower, above[j].upper);
    const Transport transport = complete.solve(Matrix(masses).col(Eigen::Index(j)));
    EXPECT_GE(bounds[j].upper, transport.lower);
    sum += bounds[j].upper;
    sum_of_complete += transport.upper;
  }
  EXPECT_LT(sum, 2. * sum_of_complete); // as on meshes
}

TEST(Transport_family, is_infinite_between_components)
{
  const Glued_surface surface(apart(icosphere(1), torus(9, 6)));
  const Index ball = surface.site(0), ring = surface.site(50), other = surface.site(60);
  Masses places(Eigen::Index(surface.size()), 3);
  places.insert(ball, 0) = places.insert(ring, 1) = places.insert(other, 2) = 1.;
  for(const std::size_t k : {0, 5})
  {
    const Transport_family family(surface.triangles(), k, Particular_field::raviart_thomas);
    const auto bounds = family.distances(
        differences(surface.size(), {{ball, ring}, {ring, other}, {ring, ring}}), within(1e-3));
    EXPECT_EQ(bounds[0].lower, infinity);
    EXPECT_EQ(bounds[0].upper, infinity);
    EXPECT_LT(bounds[1].upper, 10.);
    EXPECT_EQ(bounds[2].upper, 0.);
    const Matrix matrix = family.all_pairs(places, within(1e-3));
    EXPECT_EQ(matrix(0, 1), infinity);
    EXPECT_EQ(matrix(2, 0), infinity);
    EXPECT_LT(matrix(1, 2), 10.);
    const Vector all = family.one_to_all(unit(surface.size(), ring), {});
    EXPECT_EQ(all[ball], infinity);
    EXPECT_EQ(all[ring], 0.);
    EXPECT_LT(all[other], 10.);
  }
}

TEST(Transport_family, can_be_cancelled)
{
  const Glued_surface surface(icosphere(2));
  const Transport_family family(surface.triangles(), 3, Particular_field::gradient);
  const Transport_family spectral(surface.triangles(), 0, Particular_field::gradient);
  Family_options options;
  options.callback = [](double) { return false; };
  const Masses masses = differences(surface.size(), {{0, 1}});
  EXPECT_TRUE(family.distances(masses, options).empty());
  EXPECT_EQ(family.one_to_all(unit(surface.size(), 0), options).size(), 0);
  Masses two(Eigen::Index(surface.size()), 2);
  two.insert(3, 0) = two.insert(7, 1) = 1.;
  EXPECT_EQ(family.all_pairs(two, options).size(), 0);
  EXPECT_EQ(spectral.all_pairs(two, options).size(), 0);
  double last = -1.;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.);
    last = done;
    return true;
  };
  EXPECT_EQ(family.distances(masses, options).size(), 1u);
  last = -1.;
  EXPECT_EQ(spectral.all_pairs(two, options).rows(), 2);
}

TEST(Transport_family, refuses_what_it_cannot_do)
{
  EXPECT_THROW(Transport_family(std::make_shared<Glued_triangles>(), 0, Particular_field::gradient),
               Unsupported_surface_error);
  const Glued_surface surface(icosphere(1));
  const Transport_family family(surface.triangles(), 0, Particular_field::gradient);
  EXPECT_THROW(family.distances(differences(surface.size(), {{0, 1}}), within(0.)),
               Invalid_argument_error);
}

} // namespace
