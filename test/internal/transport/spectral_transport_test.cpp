// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>
#include "transport/uniform_refinement.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include "Array_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace spectral_transport_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums of some thousand terms, with fields in double and in single precision.
constexpr double round_off = 1e-9, float_round_off = 1e-5;

constexpr Particular_field all_kinds[] = {Particular_field::gradient,
                                          Particular_field::raviart_thomas};

Spectral_transport_options with_tolerance(double tolerance, unsigned number_of_threads = 1)
{
  Spectral_transport_options result;
  result.tolerance = tolerance;
  result.number_of_threads = number_of_threads;
  return result;
}

Masses unit(std::size_t number_of_vertices, Index vertex)
{
  Masses result(Eigen::Index(number_of_vertices), 1);
  result.insert(vertex, 0) = 1.;
  return result;
}

// Returns one column for each pair: a unit mass moves from the first to the second vertex.
Masses differences(std::size_t number_of_vertices, const std::vector<std::array<Index, 2>>& pairs)
{
  Masses result(Eigen::Index(number_of_vertices), Eigen::Index(pairs.size()));
  for(std::size_t j = 0; j < pairs.size(); ++j)
  {
    result.coeffRef(pairs[j][0], Eigen::Index(j)) -= 1.;
    result.coeffRef(pairs[j][1], Eigen::Index(j)) += 1.;
  }
  return result;
}

std::vector<std::array<Index, 2>> random_pairs(std::size_t number_of_vertices, std::size_t number,
                                               unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::array<Index, 2>> result(number);
  for(auto& pair : result)
    pair = {Index(random() % number_of_vertices), Index(random() % number_of_vertices)};
  return result;
}

// Returns a square with a square hole.
Triangulation square_annulus(std::size_t n)
{
  Triangulation result = square(n, 0.2), kept = result;
  kept.corners.clear();
  for(std::size_t f = 0; f < result.corners.size(); f += 3)
  {
    const std::size_t cell = f / 6, i = cell % n, j = cell / n;
    if(i < n / 4 || i >= n - n / 4 || j < n / 4 || j >= n - n / 4)
      kept.corners.insert(kept.corners.end(), &result.corners[f], &result.corners[f] + 3);
  }
  return kept;
}

std::vector<Triangulation> surfaces()
{
  return {jittered(icosphere(2), 0.03), square_annulus(12), square(12, 0.24),
          cylinder(16, 10, 1., 2.),     torus(20, 10),      double_torus(2)};
}

// Returns false for an isolated vertex, as in the hole of square_annulus().
bool has_triangle(const Surface_arrays& t, Index vertex)
{
  return t.ring_begin[vertex] < t.ring_begin[vertex + 1];
}

std::vector<std::array<Index, 2>> random_vertex_pairs(const Surface_arrays& t, std::size_t number,
                                                      unsigned seed)
{
  std::vector<std::array<Index, 2>> result;
  while(result.size() < number)
    for(const auto& pair : random_pairs(t.number_of_vertices(), number, ++seed))
      if(has_triangle(t, pair[0]) && has_triangle(t, pair[1]) && pair[0] != pair[1] &&
         result.size() < number)
        result.push_back(pair);
  return result;
}

TEST(Spectral_transport, empty_basis_has_closed_form)
{
  for(const Triangulation& shape : surfaces())
    for(const Particular_field kind : all_kinds)
    {
      const Array_surface surface(shape);
      const Spectral_transport metric(surface.triangles(), 0, kind);
      const Operators& o = metric.operators();
      const auto pairs = random_vertex_pairs(surface.t(), 10, 1);
      const Masses masses = differences(surface.size(), pairs);
      const std::vector<Transport_bounds> bounds = metric.distances(masses, with_tolerance(1e-3));
      const Particular_fields particular(surface.t(), o, kind);
      for(std::size_t j = 0; j < pairs.size(); ++j)
      {
        const Field field = as_field(o, particular.fields(masses).col(Eigen::Index(j)));
        double sum = 0.;
        for(std::size_t f = 0; f < field.size(); ++f)
          sum += o.area[f] * norm(field[f]);
        EXPECT_EQ(bounds[j].lower, bounds[j].upper);
        EXPECT_NEAR(bounds[j].upper, sum, round_off * sum);

        const Vector all =
            metric.one_to_all(unit(surface.size(), pairs[j][0]), with_tolerance(1e-3));
        EXPECT_NEAR(all[pairs[j][1]], sum, round_off * sum);
        EXPECT_EQ(all[pairs[j][0]], 0.);
        Masses two(Eigen::Index(surface.size()), 2);
        two.insert(pairs[j][0], 0) = two.insert(pairs[j][1], 1) = 1.;
        const Matrix matrix = metric.all_pairs(two, with_tolerance(1e-3));
        EXPECT_NEAR(matrix(0, 1), sum, float_round_off * sum);
        EXPECT_EQ(matrix(0, 1), matrix(1, 0));
        EXPECT_EQ(matrix(0, 0), 0.);
      }
    }
}

// 1,200 pairs, on surfaces with handles and with a boundary.
TEST(Spectral_transport, decreases_with_basis_size)
{
  for(const Triangulation& shape : surfaces())
    for(const Particular_field kind : all_kinds)
    {
      const Array_surface surface(shape);
      const Masses masses = differences(surface.size(), random_vertex_pairs(surface.t(), 100, 7));
      std::vector<Transport_bounds> before(100, {infinity, infinity});
      std::size_t size = 0;
      for(const std::size_t k : {0, 1, 5, 20, 60})
      {
        const Spectral_transport metric(surface.triangles(), k, kind);
        EXPECT_GE(metric.basis_size(), std::max(k, size));
        size = metric.basis_size();
        const std::vector<Transport_bounds> bounds = metric.distances(masses, with_tolerance(1e-3));
        ASSERT_EQ(bounds.size(), before.size());
        for(std::size_t j = 0; j < bounds.size(); ++j)
        {
          EXPECT_LE(bounds[j].upper - bounds[j].lower, 1e-3 * bounds[j].upper); // the requested gap
          EXPECT_LE(bounds[j].lower, before[j].upper * (1. + round_off));
        }
        before = bounds;
      }
    }
}

// With gradients, each flow v + B c is feasible for the full transport problem.
TEST(Spectral_transport, is_at_least_full_transport)
{
  for(const Triangulation& shape : surfaces())
  {
    const Array_surface surface(shape);
    const Transport_solver complete(operators(surface.t()));
    const Spectral_transport metric(surface.triangles(), 60, Particular_field::gradient);
    const auto pairs = random_vertex_pairs(surface.t(), 10, 3);
    const Masses masses = differences(surface.size(), pairs);
    const std::vector<Transport_bounds> bounds = metric.distances(masses, with_tolerance(1e-3));
    for(std::size_t j = 0; j < pairs.size(); ++j)
    {
      const Transport_result transport = complete.solve(Matrix(masses).col(Eigen::Index(j)));
      EXPECT_GE(bounds[j].upper, transport.lower);
      EXPECT_LT(bounds[j].upper, 2. * transport.upper); // the values without a basis are far above
    }
  }
}

// 1,000 random triples for each k.
TEST(Spectral_transport, satisfies_triangle_inequality)
{
  const Array_surface surface(double_torus(2));
  std::mt19937 random(1);
  Masses point_masses(Eigen::Index(surface.size()), 24);
  for(Eigen::Index j = 0; j < point_masses.cols(); ++j)
    point_masses.insert(Eigen::Index(random() % surface.size()), j) = 1.;
  for(const Particular_field kind : all_kinds)
    for(const std::size_t k : {0, 10, 100})
    {
      const double tolerance = 1e-3;
      const Spectral_transport metric(surface.triangles(), k, kind);
      const Matrix d = metric.all_pairs(point_masses, with_tolerance(tolerance));
      EXPECT_EQ(d, Matrix(d.transpose()));
      // The mean of both bounds has an error of at most half the tolerance.
      const double tolerance_factor = k == 0 ? float_round_off : 0.51 * tolerance;
      for(int i = 0; i < 1000; ++i)
      {
        const Eigen::Index p = random() % 24, q = random() % 24, r = random() % 24;
        EXPECT_LE(d(p, r) * (1. - tolerance_factor), (d(p, q) + d(q, r)) * (1. + tolerance_factor));
      }
    }
}

// One refinement halves the edges, and asymptotically halves the change of a distance. On these
// coarse surfaces the maximum ratio of two changes is 0.72.
TEST(Spectral_transport, converges_under_refinement)
{
  for(const Triangulation& shape : surfaces())
    for(const std::size_t k : {0, 5})
    {
      const Array_surface surface(shape);
      const auto pairs = random_vertex_pairs(surface.t(), 20, 11);
      std::vector<std::vector<double>> values;
      auto triangles = surface.triangles();
      for(int level = 0; level < 3; ++level)
      {
        if(level > 0)
          triangles = std::make_shared<const Surface_arrays>(refined(*triangles));
        const Spectral_transport metric(triangles, k, Particular_field::gradient);
        values.emplace_back();
        for(const Transport_bounds& bounds : metric.distances(
                differences(triangles->number_of_vertices(), pairs), with_tolerance(1e-4)))
          values.back().push_back(0.5 * triangles->scale * (bounds.lower + bounds.upper));
      }
      std::vector<double> change(2, 0.);
      for(std::size_t j = 0; j < pairs.size(); ++j)
        for(int level = 0; level < 2; ++level)
          change[level] += std::abs(values[level + 1][j] / values[level][j] - 1.) / 20.;
      EXPECT_LT(change[1], 0.8 * change[0]);
    }
}

TEST(Spectral_transport, is_exactly_symmetric)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  for(const Particular_field kind : all_kinds)
    for(const std::size_t k : {0, 15})
    {
      const Spectral_transport metric(surface.triangles(), k, kind);
      for(const auto& [p, q] : random_pairs(surface.size(), 10, 5))
      {
        const Transport_bounds forward =
            metric.distances(differences(surface.size(), {{p, q}}), with_tolerance(1e-3)).front();
        const Transport_bounds backward =
            metric.distances(differences(surface.size(), {{q, p}}), with_tolerance(1e-3)).front();
        EXPECT_EQ(forward.lower, backward.lower);
        EXPECT_EQ(forward.upper, backward.upper);
      }
    }
}

TEST(Spectral_transport, one_to_all_error_is_below_one_percent)
{
  for(const Triangulation& shape : {jittered(icosphere(3), 0.02), torus(40, 20), square(24, 0.24)})
    for(const Particular_field kind : all_kinds)
    {
      const Array_surface surface(shape);
      const Spectral_transport metric(surface.triangles(), 20, kind);
      const Vector all = metric.one_to_all(unit(surface.size(), 0), with_tolerance(1e-3));
      std::vector<std::array<Index, 2>> pairs;
      for(Index vertex = 1; vertex < surface.size(); vertex += 11)
        pairs.push_back({0, vertex});
      const std::vector<Transport_bounds> bounds =
          metric.distances(differences(surface.size(), pairs), with_tolerance(1e-3));
      double sum = 0.;
      for(std::size_t j = 0; j < pairs.size(); ++j)
      {
        EXPECT_GE(all[pairs[j][1]], bounds[j].lower * (1. - float_round_off));
        sum += all[pairs[j][1]] / bounds[j].lower - 1.;
      }
      // Measured are at most 0.4 %.
      EXPECT_LT(sum / double(pairs.size()), 0.01);
    }
}

TEST(Spectral_transport, is_independent_of_threads)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const Masses masses = differences(surface.size(), random_pairs(surface.size(), 80, 1));
  Masses point_masses(Eigen::Index(surface.size()), 70);
  for(Eigen::Index j = 0; j < 70; ++j)
    point_masses.insert(9 * j, j) = 1.;
  for(const std::size_t k : {0, 10})
  {
    const Spectral_transport metric(surface.triangles(), k, Particular_field::raviart_thomas);
    const auto sequential = metric.distances(masses, with_tolerance(0.01)),
               parallel = metric.distances(masses, with_tolerance(0.01, 3));
    for(std::size_t j = 0; j < sequential.size(); ++j)
    {
      EXPECT_EQ(sequential[j].lower, parallel[j].lower);
      EXPECT_EQ(sequential[j].upper, parallel[j].upper);
    }
    EXPECT_EQ(metric.one_to_all(unit(surface.size(), 3), with_tolerance(0.01)),
              metric.one_to_all(unit(surface.size(), 3), with_tolerance(0.01, 3)));
    if(k == 0) // if k > 0, all_pairs() calls distances()
    {
      EXPECT_EQ(metric.all_pairs(point_masses, with_tolerance(0.01)),
                metric.all_pairs(point_masses, with_tolerance(0.01, 3)));
    }
  }
}

// If the basis contained a part of an eigenspace, it would prefer some directions. The distances
// would not have the symmetries of the triangulation.
TEST(Spectral_transport, respects_symmetry)
{
  for(const std::size_t k : {1, 5, 10})
  {
    // The vertices of a sphere with the same distance from a pole.
    const Array_surface sphere(icosphere(2));
    const Spectral_transport metric(sphere.triangles(), k, Particular_field::gradient);
    const Masses from = unit(sphere.size(), sphere.vertex(0));
    std::map<long, std::vector<std::array<Index, 2>>> rings;
    for(Index i = 1; i < sphere.size(); ++i)
      rings[std::lround(1e6 * test::distance(sphere.point(0), sphere.point(i)))].push_back(
          {sphere.vertex(0), sphere.vertex(i)});
    for(const auto& [distance, ring] : rings)
    {
      const auto bounds = metric.distances(differences(sphere.size(), ring), with_tolerance(1e-4));
      // rotations around the pole
      for(std::size_t j = 0; j < bounds.size() && ring.size() == 5; ++j)
      {
        EXPECT_LE(bounds[j].lower, bounds[0].upper);
        EXPECT_GE(bounds[j].upper, bounds[0].lower);
      }
    }
    // Pairs of points that are symmetric to a diagonal of the square.
    const Array_surface square_surface(square(12));
    const Spectral_transport square_transport(square_surface.triangles(), k,
                                              Particular_field::gradient);
    const auto point = [&](Index i, Index j) { return square_surface.vertex(i + 13 * j); };
    std::vector<std::array<Index, 2>> pairs;
    for(Index i = 0; i < 13; ++i)
      for(Index j = 0; j < i; j += 2)
      {
        pairs.push_back({point(6, 6), point(i, j)});
        pairs.push_back({point(6, 6), point(j, i)});
      }
    const auto bounds =
        square_transport.distances(differences(square_surface.size(), pairs), with_tolerance(1e-4));
    for(std::size_t j = 0; j < bounds.size(); j += 2)
    {
      EXPECT_LE(bounds[j].lower, bounds[j + 1].upper);
      EXPECT_GE(bounds[j].upper, bounds[j + 1].lower);
    }
  }
}

// In a long cylinder, Green's functions are linear far from the source, so that d_0 is linear in
// the height. The coefficient of variation of |gradient d(p, .)| must be less than half of that of
// biharmonic distances.
TEST(Spectral_transport, gradient_is_uniform_along_cylinder)
{
  const Array_surface surface(cylinder(16, 80, 1., 30.));
  const Spectral_transport metric(surface.triangles(), 0, Particular_field::gradient);
  const Biharmonic_distances biharmonic(surface.t());
  const Operators& o = metric.operators();
  for(const Index from : {0u, surface.size() / 3, surface.size() / 2})
  {
    const auto variation = [&](const Vector& function)
    {
      double area = 0., sum = 0., squares = 0.;
      const Field slope = gradient(o, function);
      for(std::size_t f = 0; f < slope.size(); ++f)
      {
        const Index corner = surface.caller_vertex(o.corner[3 * f]);
        // less than one circumference from the source
        if(std::abs(surface.point(corner)[2] - surface.point(from)[2]) < 2. * pi)
          continue;
        area += o.area[f];
        sum += o.area[f] * norm(slope[f]);
        squares += o.area[f] * dot(slope[f], slope[f]);
      }
      return std::sqrt(squares * area / (sum * sum) - 1.);
    };
    const Masses source = unit(surface.size(), surface.vertex(from));
    EXPECT_LT(variation(metric.one_to_all(source, {})),
              0.5 * variation(biharmonic.one_to_all(source, 1)));
  }
}

// Along each row, column and diagonal of the square, the distance must decrease and then increase.
TEST(Spectral_transport, level_sets_are_convex_on_square)
{
  const int n = 32;
  const Array_surface surface(square(n));
  const Spectral_transport metric(surface.triangles(), 0, Particular_field::gradient);
  for(const auto& [u, v] : {std::pair(n / 2, n / 2), std::pair(n / 4, n / 3)})
  {
    const Vector d =
        metric.one_to_all(unit(surface.size(), surface.vertex(Index(u + (n + 1) * v))), {});
    const auto at = [&](int i, int j) { return d[surface.vertex(Index(i + (n + 1) * j))]; };
    const auto expect_valley = [&](int i, int j, int di, int dj)
    {
      // All cells have the same diagonal. This rotates level sets by a fraction of a cell.
      const double tolerance = 0.02 / n;
      double highest = 0.;
      bool is_rising = false;
      double before = at(i, j);
      for(; i >= 0 && j >= 0 && i <= n && j <= n; i += di, j += dj)
      {
        is_rising = is_rising || at(i, j) > before + tolerance;
        highest = is_rising ? std::max(highest, at(i, j)) : 0.;
        EXPECT_GE(at(i, j), highest - tolerance) << i << ' ' << j;
        before = at(i, j);
      }
    };
    for(int i = 0; i <= n; ++i)
    {
      expect_valley(i, 0, 0, 1);
      expect_valley(0, i, 1, 0);
      expect_valley(i, 0, 1, 1);
      expect_valley(0, i, 1, 1);
      expect_valley(i, 0, -1, 1);
      expect_valley(n, i, -1, 1);
    }
  }
}

TEST(Spectral_transport, works_on_clouds)
{
  const Cloud cloud = octahedron_sphere(3);
  const auto sphere =
      std::make_shared<Surface_arrays>(build_surfel_arrays(cloud.points, cloud.normals).arrays);
  const Spectral_transport spectral(sphere, 0, Particular_field::raviart_thomas);
  const Spectral_transport metric(sphere, 20, Particular_field::raviart_thomas);
  EXPECT_EQ(metric.kind(), Particular_field::gradient);
  EXPECT_GE(metric.basis_size(), 20u);
  const Masses masses = differences(cloud.size(), random_pairs(cloud.size(), 30, 1));
  const auto without_basis = spectral.distances(masses, with_tolerance(1e-3));
  const auto bounds = metric.distances(masses, with_tolerance(1e-3));
  const Transport_solver complete(metric.operators());
  double sum = 0., sum_of_complete = 0.;
  for(std::size_t j = 0; j < bounds.size(); ++j)
  {
    EXPECT_LE(bounds[j].lower, without_basis[j].upper);
    const Transport_result transport = complete.solve(Matrix(masses).col(Eigen::Index(j)));
    EXPECT_GE(bounds[j].upper, transport.lower);
    sum += bounds[j].upper;
    sum_of_complete += transport.upper;
  }
  EXPECT_LT(sum, 2. * sum_of_complete); // the same factor as on meshes
}

TEST(Spectral_transport, is_infinite_between_components)
{
  const Array_surface surface(disjoint_union(icosphere(1), torus(9, 6)));
  const Index ball = surface.vertex(0), ring = surface.vertex(50), other = surface.vertex(60);
  Masses point_masses(Eigen::Index(surface.size()), 3);
  point_masses.insert(ball, 0) = point_masses.insert(ring, 1) = point_masses.insert(other, 2) = 1.;
  for(const std::size_t k : {0, 5})
  {
    const Spectral_transport metric(surface.triangles(), k, Particular_field::raviart_thomas);
    const auto bounds =
        metric.distances(differences(surface.size(), {{ball, ring}, {ring, other}, {ring, ring}}),
                         with_tolerance(1e-3));
    EXPECT_EQ(bounds[0].lower, infinity);
    EXPECT_EQ(bounds[0].upper, infinity);
    EXPECT_LT(bounds[1].upper, 10.);
    EXPECT_EQ(bounds[2].upper, 0.);
    const Matrix matrix = metric.all_pairs(point_masses, with_tolerance(1e-3));
    EXPECT_EQ(matrix(0, 1), infinity);
    EXPECT_EQ(matrix(2, 0), infinity);
    EXPECT_LT(matrix(1, 2), 10.);
    const Vector all = metric.one_to_all(unit(surface.size(), ring), {});
    EXPECT_EQ(all[ball], infinity);
    EXPECT_EQ(all[ring], 0.);
    EXPECT_LT(all[other], 10.);
  }
}

TEST(Spectral_transport, can_be_cancelled)
{
  const Array_surface surface(icosphere(2));
  const Spectral_transport metric(surface.triangles(), 3, Particular_field::gradient);
  const Spectral_transport spectral(surface.triangles(), 0, Particular_field::gradient);
  Spectral_transport_options options;
  options.callback = [](double) { return false; };
  const Masses masses = differences(surface.size(), {{0, 1}});
  EXPECT_TRUE(metric.distances(masses, options).empty());
  EXPECT_EQ(metric.one_to_all(unit(surface.size(), 0), options).size(), 0);
  Masses two(Eigen::Index(surface.size()), 2);
  two.insert(3, 0) = two.insert(7, 1) = 1.;
  EXPECT_EQ(metric.all_pairs(two, options).size(), 0);
  EXPECT_EQ(spectral.all_pairs(two, options).size(), 0);
  double last = -1.;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.);
    last = done;
    return true;
  };
  EXPECT_EQ(metric.distances(masses, options).size(), 1u);
  last = -1.;
  EXPECT_EQ(spectral.all_pairs(two, options).rows(), 2);
}

TEST(Spectral_transport, throws_on_invalid_input)
{
  EXPECT_THROW(
      Spectral_transport(std::make_shared<Surface_arrays>(), 0, Particular_field::gradient),
      Unsupported_surface_error);
  const Array_surface surface(icosphere(1));
  const Spectral_transport metric(surface.triangles(), 0, Particular_field::gradient);
  EXPECT_THROW(metric.distances(differences(surface.size(), {{0, 1}}), with_tolerance(0.)),
               Invalid_argument_error);
}

} // namespace spectral_transport_test
