// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing.h>

#include "Mesh_of.h"
#include "allocation/expect_safe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

// Queries that reach few surfels of a large cloud allocate memory for these only.

namespace bounded_query_test {

namespace GP = CGAL::Geodesic_processing;
namespace params = GP::parameters;
using namespace GP::test;
using allocation_test::allocated_bytes;
using Domain = GP::Surfel_domain<Surfels>;

constexpr std::size_t number_of_surfels = 200000;
// Less than a byte for each surfel.
constexpr std::size_t max_bytes = 150000;
// Less than an index for each surfel. Paths are shortened in a mesh of the triangles around them.
constexpr std::size_t max_bytes_of_path = 4 * number_of_surfels;

// Random surfels of the unit sphere; one domain for all tests.
const Domain& domain()
{
  static const Domain result = []
  {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> height(-1., 1.), angle(0., 2. * std::acos(-1.));
    Surfels surfels;
    for(std::size_t i = 0; i < number_of_surfels; ++i)
    {
      const double z = height(random), a = angle(random), r = std::sqrt(1. - z * z);
      surfels.emplace_back(Kernel::Point_3(r * std::cos(a), r * std::sin(a), z),
                           Kernel::Vector_3(r * std::cos(a), r * std::sin(a), z));
    }
    return Domain(surfels, params::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  }();
  return result;
}

// A radius that contains about 100 surfels.
const double radius = std::sqrt(4. * 100. / double(number_of_surfels));

template <typename Method>
void expect_bounded_solver()
{
  GP::Geodesic_distance_solver<Surfels, Method> solver(domain());
  const auto limits = params::maximum_distance(radius);
  solver.compute(std::size_t(1), limits);
  // The arrays that grow with the number of reached surfels are reused.
  EXPECT_LT(allocated_bytes([&] { solver.compute(std::size_t(500), limits); }), max_bytes);
  EXPECT_GT(solver.reached().size(), 50u);
  EXPECT_LT(solver.reached().size(), 200u);
  const std::size_t target = solver.reached().back();
  EXPECT_LT(allocated_bytes([&] { solver.path(target); }), max_bytes_of_path);
  EXPECT_LT(
      allocated_bytes([&] { solver.compute(std::size_t(1), params::targets(std::size_t(1))); }),
      max_bytes);
}

TEST(Bounded_query, of_distances_is_local)
{
  expect_bounded_solver<GP::Dijkstra>();
  expect_bounded_solver<GP::Fast_marching>();
  expect_bounded_solver<GP::Euclidean_front>();
}

template <typename Method>
void expect_bounded_map()
{
  GP::Logarithmic_map<Surfels, Method> map(domain());
  const auto limits = params::maximum_distance(radius);
  EXPECT_LT(allocated_bytes([&] { map.compute(std::size_t(1), limits); }), max_bytes);
  EXPECT_LT(allocated_bytes([&] { map.compute(std::size_t(500), limits); }), max_bytes);
  EXPECT_GT(map.reached().size(), 50u);
}

TEST(Bounded_query, of_logarithmic_map_is_local)
{
  expect_bounded_map<GP::Gradient<>>();
  expect_bounded_map<GP::Discrete_exponential>();
}

TEST(Bounded_query, of_decal_is_local)
{
  GP::Decal_placer<Surfels> placer(domain());
  for(const std::size_t center : {1u, 500u})
  {
    std::size_t size = 0;
    EXPECT_LT(allocated_bytes([&] { size = placer.place(center, radius, radius).vertices.size(); }),
              max_bytes);
    EXPECT_GT(size, 10u);
  }
}

TEST(Bounded_query, of_path_is_local)
{
  GP::Geodesic_distance_solver<Surfels> solver(domain());
  solver.compute(std::size_t(500), params::maximum_distance(radius));
  const std::size_t target = solver.reached().back();
  GP::Surfel_path_finder<Surfels> find_path(domain(), params::surfel_noise(GP::Surfel_noise::kept));
  GP::Geodesic_path_finder<Surfels> find_shortest_path(domain());
  std::size_t size = 0;
  const auto query = [&]
  {
    size = find_path(std::size_t(500), target).points.size();
    size += find_shortest_path(std::size_t(500), target).points.size();
  };
  query(); // the first search allocates the arrays of all searches
  EXPECT_LT(allocated_bytes(query), max_bytes_of_path);
  EXPECT_GT(size, 4u);
}

} // namespace bounded_query_test
