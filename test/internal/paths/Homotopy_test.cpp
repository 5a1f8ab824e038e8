// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/Homotopy.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include "Array_surface.h"
#include "closed_forms.h"

#include <gtest/gtest.h>

#include <random>

namespace homotopy_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns a random walk over triangles that is closed by its own reversal up to `begin`, so that it
// is contractible; or a random closed walk.
std::vector<Index> random_walk(const Surface_arrays& t, std::size_t length, std::mt19937& random,
                               Index triangle)
{
  std::vector<Index> result;
  while(result.size() < length)
  {
    const Index h = 3 * triangle + Index(random() % 3);
    if(t.twin[h] == none)
      continue;
    result.push_back(h);
    triangle = t.twin[h] / 3;
  }
  return result;
}

std::vector<Index> reversed(const Surface_arrays& t, const std::vector<Index>& walk)
{
  std::vector<Index> result;
  for(auto h = walk.rbegin(); h != walk.rend(); ++h)
    result.push_back(t.twin[*h]);
  return result;
}

void append(std::vector<Index>& walk, const std::vector<Index>& other)
{
  walk.insert(walk.end(), other.begin(), other.end());
}

struct Case
{
  Triangulation surface;
  std::size_t number_of_generators;
};

std::vector<Case> cases()
{
  return {{icosphere(2), 0},
          {square(5), 0},
          {cylinder(12, 4, 1., 1.), 1},
          {torus(12, 8), 2},
          {double_torus(1), 4},
          {double_torus(2), 4},
          // plates with three, four and five holes
          {blocks(7, 3, 1, [](int i, int j, int) { return j != 1 || i % 2 == 0; }), 6},
          {blocks(9, 3, 1, [](int i, int j, int) { return j != 1 || i % 2 == 0; }), 8}};
}

TEST(Homotopy, has_minimum_number_of_generators)
{
  for(const auto& [surface, number] : cases())
    EXPECT_EQ(Homotopy(Array_surface(surface).t()).number_of_generators(), number);
  EXPECT_EQ(Homotopy(Array_surface(disjoint_union(torus(12, 8), double_torus(1))).t())
                .number_of_generators(),
            6u);
}

// A product of conjugates of circles around vertices is contractible. The walk is as long as many
// relators.
TEST(Homotopy, products_of_conjugates_of_circles_around_vertices_are_contractible)
{
  std::mt19937 random(1);
  for(const Case& c : cases())
  {
    const Array_surface surface(c.surface);
    const Surface_arrays& t = surface.t();
    const Homotopy homotopy(t);
    for(int repetition = 0; repetition < 30; ++repetition)
    {
      const Index start = Index(random() % t.number_of_triangles());
      std::vector<Index> walk;
      for(int factor = 0; factor < 5; ++factor)
      {
        const std::vector<Index> stem = random_walk(t, 100, random, start);
        // A closed walk around an interior vertex, if its first corner has one.
        std::vector<Index> circle;
        for(Index corner = t.twin[stem.back()];;)
        {
          circle.push_back(previous_halfedge(corner));
          corner = next_corner_ccw(t, corner);
          if(corner == none)
            circle.clear();
          if(corner == none || corner == t.twin[stem.back()])
            break;
        }
        append(walk, stem);
        append(walk, factor % 2 == 0 ? circle : reversed(t, circle));
        append(walk, reversed(t, stem));
      }
      EXPECT_TRUE(homotopy.is_contractible(walk));
    }
  }
}

// A closed walk with a period other than zero is not contractible.
TEST(Homotopy, walks_with_period_are_not_contractible)
{
  std::mt19937 random(1);
  for(const Case& c : cases())
  {
    const Array_surface surface(c.surface);
    const Surface_arrays& t = surface.t();
    const Homotopy homotopy(t);
    const auto forms = closed_forms(t);
    EXPECT_EQ(forms.size(), c.number_of_generators);
    int number_of_walks = 0;
    for(int repetition = 0; repetition < 100; ++repetition)
    {
      // A random walk until it comes back to its first triangle.
      const Index start = Index(random() % t.number_of_triangles());
      std::vector<Index> walk = random_walk(t, 2000, random, start);
      std::size_t size = walk.size();
      while(size > 0 && t.twin[walk[size - 1]] / 3 != start)
        --size;
      walk.resize(size);
      std::vector<Surface_location> path;
      for(const Index h : walk)
      {
        Surface_location location;
        location.triangle = h / 3;
        location.barycentric = barycentric_on_halfedge(h, 0.5);
        path.push_back(location);
      }
      bool has_period = false;
      for(const Closed_form& form : forms)
        has_period |= !path.empty() && std::abs(period(t, form, path)) > 0.5;
      if(has_period)
      {
        ++number_of_walks;
        EXPECT_FALSE(homotopy.is_contractible(walk));
      }
      else if(c.number_of_generators <= 2) // the group is commutative
      {
        EXPECT_TRUE(homotopy.is_contractible(walk));
      }
    }
    if(c.number_of_generators > 0)
    {
      EXPECT_GT(number_of_walks, 10);
    }
  }
}

// The commutator of the two loops of a handle separates a surface of genus 2. It has no period, but
// is not contractible. On a torus it is contractible.
TEST(Homotopy, commutator_is_contractible_on_torus_only)
{
  std::mt19937 random(1);
  for(const bool is_torus : {true, false})
  {
    const Array_surface surface(is_torus ? torus(12, 8) : double_torus(2));
    const Surface_arrays& t = surface.t();
    const Homotopy homotopy(t);
    const auto forms = closed_forms(t);
    int number_of_commutators = 0;
    for(int repetition = 0; repetition < 200; ++repetition)
    {
      std::vector<std::vector<Index>> walks;
      while(walks.size() < 2)
      {
        std::vector<Index> walk = random_walk(t, 1000, random, 0);
        while(!walk.empty() && t.twin[walk.back()] / 3 != 0)
          walk.pop_back();
        if(!homotopy.is_contractible(walk))
          walks.push_back(walk);
      }
      std::vector<Index> commutator = walks[0];
      append(commutator, walks[1]);
      append(commutator, reversed(t, walks[0]));
      append(commutator, reversed(t, walks[1]));
      if(!homotopy.is_contractible(commutator))
        ++number_of_commutators;
    }
    // Two elements of the group of genus 2 commute only if they are powers of the same element.
    if(is_torus)
    {
      EXPECT_EQ(number_of_commutators, 0);
    }
    else
    {
      EXPECT_GT(number_of_commutators, 150);
    }
  }
}

TEST(Homotopy, path_through_two_fans_of_vertex_has_no_crossings)
{
  // Two tetrahedra that share vertex 0.
  Triangulation surface = tetrahedron();
  for(const Index i : tetrahedron().corners)
    surface.corners.push_back(i == 0 ? 0 : i + 3);
  for(int i = 1; i < 4; ++i)
  {
    Point p = surface.points[i];
    for(double& x : p)
      x = 2. * surface.points[0][&x - p.data()] - x;
    surface.points.push_back(p);
  }
  const Array_surface arrays(surface);
  EXPECT_FALSE(crossed_halfedges(arrays.t(), arrays.along({0, 1, 2, 0, 4, 5, 0})).has_value());
  EXPECT_TRUE(crossed_halfedges(arrays.t(), arrays.along({1, 2, 0, 1})).has_value());
}

} // namespace homotopy_test
