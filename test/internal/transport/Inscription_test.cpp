// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Inscription.h>

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include "core/unfold.h"

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of some hundred sums.
constexpr double rounding = 1e-11;

using Curves = std::vector<std::vector<Location>>;

// Where a linear function is zero: a piece in each triangle.
template <typename Function>
Curves zeros(const Glued_surface& surface, const Function& function)
{
  Curves result;
  const Glued_triangles& t = surface.t();
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    std::vector<Location> piece;
    for(Index side = 3 * f; side < 3 * f + 3; ++side)
    {
      const double a = function(surface.point(surface.point_of_site(t.corner[side]))),
                   b = function(surface.point(surface.point_of_site(t.corner[next_side(side)])));
      if(a * b < 0.)
        piece.push_back({f, none, on_side(side, a / (a - b))});
    }
    if(piece.size() == 2)
      result.push_back(piece);
  }
  return result;
}

Curves level(const Glued_surface& surface, double height)
{
  return zeros(surface, [height](const Point& p) { return p[2] - height; });
}

// Pieces between two random places of each of some triangles, which cross one another.
Curves scratches(const Glued_surface& surface, unsigned number)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0., 1.);
  std::uniform_int_distribution<Index> any(0, Index(surface.t().number_of_triangles() / 4));
  Curves result;
  for(unsigned i = 0; i < number; ++i)
  {
    const Index f = any(random);
    std::vector<Location> piece;
    for(int j = 0; j < 3; ++j)
    {
      std::array<double, 3> b = {share(random), share(random), share(random)};
      if(i % 3 == 0 && j == 1)
        b[i % 2] = 0.;
      const double sum = b[0] + b[1] + b[2];
      piece.push_back({f, none, {b[0] / sum, b[1] / sum, b[2] / sum}});
    }
    result.push_back(piece);
  }
  return result;
}

double length(const Glued_triangles& t, const Curves& curves)
{
  double result = 0.;
  for(const auto& curve : curves)
    for(std::size_t i = 1; i < curve.size(); ++i)
      result += distance_in_triangle(t, curve[i].triangle, curve[i - 1].barycentric,
                                     curve[i].barycentric);
  return result;
}

// The length of all sides that join two of the curves' sites.
double length_between(const Inscription& drawn)
{
  const Glued_triangles& t = *drawn.triangles();
  std::vector<bool> is_there(t.number_of_sites(), false);
  for(const std::vector<Index>& sites : drawn.sites())
    for(const Index site : sites)
      is_there[site] = true;
  double result = 0.;
  for(Index side = 0; side < t.corner.size(); ++side)
    if((t.twin[side] == none || side < t.twin[side]) && is_there[t.corner[side]] &&
       is_there[t.corner[next_side(side)]])
      result += t.length[side];
  return result;
}

void expect_glued(const Glued_triangles& t)
{
  std::vector<Index> count(t.number_of_sites(), 0);
  for(Index side = 0; side < t.corner.size(); ++side)
  {
    ++count[t.corner[side]];
    if(const Index twin = t.twin[side]; twin != none)
    {
      ASSERT_EQ(t.twin[twin], side);
      EXPECT_EQ(t.corner[side], t.corner[next_side(twin)]);
      EXPECT_EQ(t.length[side], t.length[twin]);
    }
  }
  for(Index site = 0; site < t.number_of_sites(); ++site)
  {
    EXPECT_EQ(t.first[site + 1] - t.first[site], count[site]);
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      EXPECT_EQ(t.corner[t.star[i]], site);
    }
  }
}

double area(const Glued_triangles& t)
{
  const std::vector<double> areas = operators(t).area;
  return std::accumulate(areas.begin(), areas.end(), 0.);
}

TEST(Inscription, keeps_the_surface)
{
  for(const Triangulation& shape :
      {shaken(icosphere(2), 0.05), square(6, 0.24), cylinder(8, 3, 1., 2.), one_triangle()})
  {
    const Glued_surface surface(shape);
    for(const Curves& curves : {level(surface, 0.13), scratches(surface, 40)})
    {
      const Inscription drawn(surface.triangles(), curves, {});
      const auto& fine = drawn.triangles();
      expect_glued(*fine);
      EXPECT_EQ(std::count_if(fine->twin.begin(), fine->twin.end(),
                              [](Index twin) { return twin == none; }) > 0,
                std::count(surface.t().twin.begin(), surface.t().twin.end(), none) > 0);
      EXPECT_NEAR(area(*fine), area(surface.t()), rounding * area(surface.t()));
      Window_propagation coarse_windows(surface.triangles()), fine_windows(fine);
      coarse_windows.run({surface.source(Index(0))});
      fine_windows.run({surface.source(Index(0))});
      for(Index site = 0; site < surface.size(); ++site)
      {
        // What exact distances promise, on flat sides through which windows are cut anew.
        EXPECT_NEAR(fine_windows.distance(site), coarse_windows.distance(site), 1e-9);
      }
    }
  }
}

TEST(Inscription, runs_along_sides_and_joins_nothing_else)
{
  const Glued_surface sphere(shaken(icosphere(2), 0.05)), plane(square(6, 0.24));
  for(const double height : {0.13, 0.61, 0.97})
  {
    const Curves curves = level(sphere, height);
    const double exact = length(sphere.t(), curves);
    EXPECT_NEAR(length_between({sphere.triangles(), curves, {}}), exact, rounding * exact);
  }
  for(const double angle : {0.1, 0.7, 1.6, 2.9})
  {
    const Curves curves =
        zeros(plane, [&](const Point& p)
              { return std::cos(angle) * (p[0] - 0.52) + std::sin(angle) * (p[1] - 0.47); });
    const double exact = length(plane.t(), curves);
    EXPECT_NEAR(length_between({plane.triangles(), curves, {}}), exact, rounding * exact);
  }
  const Curves curves = scratches(sphere, 60);
  const double exact = length(sphere.t(), curves);
  EXPECT_NEAR(length_between({sphere.triangles(), curves, {}}), exact, rounding * exact);
  // Points alone: no length.
  Curves points;
  for(const auto& curve : curves)
    points.push_back({curve[0]});
  for(Index i = 0; i < sphere.size(); ++i)
    points.push_back({sphere.at(i)});
  EXPECT_EQ(length_between({sphere.triangles(), points, {}}), 0.);
  // All around a triangle, and along half of a side.
  const Curves around = {sphere.along({0, 0})};
  const Index* corner = &sphere.t().corner[0];
  const std::vector<Location> loop = {
      {none, corner[0], {}}, {none, corner[1], {}}, {none, corner[2], {}}, {none, corner[0], {}}};
  const double rim = sphere.t().length[0] + sphere.t().length[1] + sphere.t().length[2];
  const Inscription enclosed(sphere.triangles(), {loop}, {});
  EXPECT_NEAR(length_between(enclosed), rim, rounding);
  EXPECT_GT(enclosed.triangles()->number_of_triangles(), sphere.t().number_of_triangles());
  const std::vector<Location> half = {{0, none, {1., 0., 0.}}, {0, none, {0.5, 0.5, 0.}}};
  EXPECT_NEAR(length_between({sphere.triangles(), {half}, {}}), 0.5 * sphere.t().length[0],
              rounding);
  // Between sites that are whole a side may stay, beside others not.
  const Inscription whole(sphere.triangles(), {half}, {corner[1], corner[2]});
  EXPECT_EQ(whole.triangles()->twin[sphere.t().twin[1]] == none, false);
}

TEST(Inscription, lists_what_lies_on_a_curve)
{
  const Glued_surface surface(one_triangle());
  const auto at = [](double a, double b, double c) { return Location{0, none, {a, b, c}}; };
  // A cross, a point on one of them, and its end on a side.
  const Curves curves = {{at(0.5, 0.25, 0.25), at(0.25, 0.5, 0.25)},
                         {at(0.5, 0.5, 0.), at(0.25, 0.25, 0.5)},
                         {at(0.375, 0.375, 0.25)},
                         {at(0.5, 0.5, 0.), at(1., 0., 0.)}};
  const Inscription drawn(surface.triangles(), curves, {});
  ASSERT_EQ(drawn.sites().size(), 4u);
  EXPECT_EQ(drawn.sites()[0].size(), 3u);
  EXPECT_EQ(drawn.sites()[1].size(), 3u);
  EXPECT_EQ(drawn.sites()[2].size(), 1u);
  EXPECT_EQ(drawn.sites()[3].size(), 2u);
  const Index crossing = drawn.sites()[2][0];
  for(const std::size_t i : {0u, 1u})
    EXPECT_EQ(std::count(drawn.sites()[i].begin(), drawn.sites()[i].end(), crossing), 1);
}

TEST(Inscription, keeps_functions_masses_and_fields)
{
  const Glued_surface surface(shaken(icosphere(1), 0.1));
  Curves curves = scratches(surface, 30);
  for(auto& curve : level(surface, 0.3))
    curves.push_back(curve);
  const Inscription drawn(surface.triangles(), curves, {});
  const Glued_triangles &coarse = surface.t(), &fine = *drawn.triangles();
  const Vector function = Vector::Random(Eigen::Index(coarse.number_of_sites()));
  const Vector refined = drawn.refined(function);
  const auto value = [](const Glued_triangles& t, const Vector& f, const Location& location)
  {
    double result = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      result += location.barycentric[k] * f[t.corner[3 * location.triangle + k]];
    return result;
  };
  for(Index f = 0; f < coarse.number_of_triangles(); ++f)
    for(const auto& b : {std::array{0.2, 0.7, 0.1}, std::array{0.4, 0.3, 0.3},
                         std::array{0., 0.45, 0.55}, std::array{0., 0., 1.}})
    {
      const Location there = drawn.refined(Location{f, none, b});
      EXPECT_GE(*std::min_element(there.barycentric.begin(), there.barycentric.end()), 0.);
      EXPECT_NEAR(value(fine, refined, there), value(coarse, function, {f, none, b}), 1e-9);
    }

  // The same slope, also where lengths have directions.
  std::vector<Tensor> measure;
  for(Index f = 0; f < coarse.number_of_triangles(); ++f)
    measure.push_back({2. + 0.01 * f, 0.5, 1.});
  const Operators coarse_operators = measured_operators(coarse, measure),
                  fine_operators = measured_operators(fine, drawn.refined(measure));
  double whole = 0., parts = 0.;
  for(const auto& [o, f, sum] : {std::tuple{&coarse_operators, &function, &whole},
                                 std::tuple{&fine_operators, &refined, &parts}})
  {
    const Field slope = gradient(*o, *f);
    for(std::size_t i = 0; i < slope.size(); ++i)
      *sum += o->area[i] * norm(slope[i]);
  }
  EXPECT_NEAR(parts, whole, 1e-9 * whole);

  // What a field's mean brings somewhere.
  const Operators a = operators(coarse, Flat_triangles::raised),
                  b = operators(fine, Flat_triangles::raised);
  Field field = gradient(b, Vector::Random(Eigen::Index(fine.number_of_sites())));
  const Vector before = drawn.coarsened(divergence(b, field)),
               after = divergence(a, drawn.coarsened(field));
  EXPECT_LT((before - after).lpNorm<Eigen::Infinity>(), 1e-7 * before.lpNorm<Eigen::Infinity>());
  const Vector masses = Vector::Random(Eigen::Index(fine.number_of_sites()));
  EXPECT_NEAR(drawn.coarsened(masses).dot(function), masses.dot(refined), 1e-9);
}

TEST(Inscription, treats_what_is_flat_or_hardly_apart)
{
  Triangulation shape = square(3);
  for(Point& p : shape.points)
    p[1] *= 1e-13; // needles
  for(const Triangulation& each : {shape, square(3)})
  {
    const Glued_surface surface(each);
    Curves curves = scratches(surface, 20);
    for(double tiny : {1e-9, 1e-11, 1e-13, 1e-15})
      curves.push_back({{2, none, {1. - tiny, tiny, 0.}},
                        {2, none, {0.4, 0.6 - tiny, tiny}},
                        {2, none, {0.4 + tiny, 0.3, 0.3 - tiny}}});
    const Inscription drawn(surface.triangles(), curves, {});
    expect_glued(*drawn.triangles());
    EXPECT_NEAR(area(*drawn.triangles()), area(surface.t()), 1e-9); // of a surface of size one
  }
}

} // namespace
