// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>

#include "Glued_surface.h"
#include "path_checks.h"

#include <memory>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr double rounding = 1e-12; // a few hundred roundings of lengths below 10

TEST(Path_finder, joins_any_two_locations)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
  const Glued_triangles& t = surface.t();
  Path_finder find(surface.triangles());
  std::mt19937 random(1);
  for(int i = 0; i < 300; ++i)
  {
    Location from = random_location(t, random), to = random_location(t, random);
    if(i % 3 == 0)
      from.barycentric = {0.5, 0., 0.5};
    if(i % 5 == 0)
      to = at_site(t, Index(random() % t.number_of_sites()));
    const auto path = find(from, to);
    expect_path_on_surface(t, path, from, to);
    const double length = straighten(t, path).length * t.scale;
    EXPECT_GE(length, distance(point_at(t, from), point_at(t, to)) - rounding);
    // The other way round the length is the same, unless two ways are equally long up to 1 %.
    EXPECT_NEAR(straighten(t, find(to, from)).length * t.scale, length, 0.02 * length);
  }
}

TEST(Path_finder, starts_straightening_on_the_right_side_of_a_sphere)
{
  const Glued_surface surface(icosphere(4));
  const Glued_triangles& t = surface.t();
  Path_finder find(surface.triangles());
  std::mt19937 random(2);
  const double h = 2. / 16.; // about the length of a side
  for(int i = 0; i < 100; ++i)
  {
    const Index a = Index(random() % 2562), b = Index(random() % 2562);
    const Point p = point_at(t, surface.at(a)), q = point_at(t, surface.at(b));
    const double angle = 2. * std::asin(std::min(1., distance(p, q) / 2.));
    const double length = straighten(t, find(surface.at(a), surface.at(b))).length * t.scale;
    // Great circles on the sphere; the polyhedron lies inside, by less than h^2 / 8 of the radius.
    EXPECT_LE(length, angle * (1. + rounding) + rounding);
    EXPECT_GE(length, angle * (1. - h * h / 4.) - rounding);
  }
}

TEST(Path_finder, gives_one_location_or_two_where_these_are_enough)
{
  const Glued_surface surface(square(5, 0.2));
  Path_finder find(surface.triangles());
  std::mt19937 random(3);
  Location p = random_location(surface.t(), random), q = p;
  q.barycentric = {0.1, 0.1, 0.8};
  EXPECT_EQ(find(p, p).size(), 1u);
  EXPECT_EQ(find(p, q).size(), 2u);
  EXPECT_EQ(find(surface.at(7), surface.at(7)).size(), 1u);
  EXPECT_EQ(find(surface.at(7), surface.at(8)).size(), 2u);
}

TEST(Path_finder, says_when_there_is_no_way)
{
  Triangulation two = apart(square(4), icosphere(1));
  two.points.push_back({5., 5., 5.});
  const Glued_surface surface(two);
  const Index isolated = Index(two.points.size() - 1);
  Path_finder find(surface.triangles());
  for(int pass = 0; pass < 2; ++pass)
  {
    EXPECT_TRUE(find(surface.at(0), surface.at(30)).empty());
    EXPECT_TRUE(find(surface.at(30), surface.at(isolated)).empty());
    EXPECT_TRUE(find(surface.at(isolated), surface.at(30)).empty());
    EXPECT_EQ(find(surface.at(isolated), surface.at(isolated)).size(), 1u);
    EXPECT_FALSE(find(surface.at(1), surface.at(23)).empty());
    find.add_landmarks(4);
  }
}

TEST(Path_finder, needs_no_points)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
  auto bare = std::make_shared<Glued_triangles>(surface.t());
  bare->point.clear();
  Path_finder find(surface.triangles()), find_bare(bare);
  for(Index k = 1; k < 600; k += 37)
  {
    const auto a = find(surface.at(0), surface.at(k)), b = find_bare(surface.at(0), surface.at(k));
    // Both are shortest along the same hops, which are kept as floats.
    EXPECT_NEAR(straighten(surface.t(), a).length, straighten(surface.t(), b).length, 1e-2);
    EXPECT_LE(find.visited(), find_bare.visited());
  }
}

TEST(Path_finder, visits_little_for_near_locations_and_less_with_landmarks)
{
  const Glued_surface surface(shaken(icosphere(5), 0.002));
  Path_finder find(surface.triangles()), guided(surface.triangles());
  guided.add_landmarks(3);
  guided.add_landmarks(5);
  Path_finder guided_more = guided;
  guided_more.add_landmarks(8);
  std::mt19937 random(4);
  std::size_t visited = 0, visited_guided_more = 0;
  for(int i = 0; i < 50; ++i)
  {
    const Location from = random_location(surface.t(), random),
                   to = random_location(surface.t(), random);
    const double a = straighten(surface.t(), find(from, to)).length;
    const double b = straighten(surface.t(), guided(from, to)).length;
    // A search visits the sites from which the bound is less than what remains; landmarks raise it.
    EXPECT_LE(guided.visited(), find.visited());
    guided_more(from, to);
    EXPECT_LE(guided_more.visited(), guided.visited());
    visited += find.visited();
    visited_guided_more += guided_more.visited();
    // Ways whose lengths differ by less than floats tell apart may be exchanged.
    EXPECT_NEAR(a, b, 1e-2 * a);
  }
  // A landmark tells what remains where it lies about straight behind.  A sphere has no far ends
  // behind which most paths are: eight landmarks, a right angle apart, leave two thirds of the
  // visits, sixteen less than half.
  EXPECT_LT(2 * visited_guided_more, visited);
  const Index site = 17, corner = surface.t().star[surface.t().first[site]];
  find(at_site(surface.t(), site), at_site(surface.t(), surface.t().corner[next_side(corner)]));
  EXPECT_EQ(find.visited(), 0u); // a side joins them
}

TEST(Path_finder, answers_each_query_as_if_it_were_the_first)
{
  const Glued_surface surface(shaken(icosphere(3), 0.05));
  Path_finder find(surface.triangles());
  std::mt19937 random(5);
  for(int i = 0; i < 50; ++i)
  {
    const Location from = random_location(surface.t(), random),
                   to = random_location(surface.t(), random);
    const auto used = find(from, to);
    const auto fresh = Path_finder(surface.triangles())(from, to);
    ASSERT_EQ(used.size(), fresh.size());
    for(std::size_t k = 0; k < used.size(); ++k)
      EXPECT_TRUE(is_same_point(surface.t(), used[k], fresh[k]));
  }
}

TEST(Path_finder, follows_the_arcs_of_a_cloud)
{
  //  0 - 1 - 2        4 is alone
  //    \     |
  //      ----3
  Glued_triangles cloud;
  cloud.first.assign(6, 0);
  cloud.point = {{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}, {2., -1., 0.}, {5., 0., 0.}};
  cloud.normal.assign(5, {0., 0., 1.});
  cloud.graph.first = {0, 2, 4, 6, 8, 8};
  cloud.graph.target = {1, 3, 0, 2, 1, 3, 0, 2};
  const double slant = std::sqrt(5.);
  cloud.graph.length = {1., slant, 1., 1., 1., 1., slant, 1.};
  Path_finder find(std::make_shared<const Glued_triangles>(cloud));
  const auto sites = [&](Index a, Index b)
  {
    std::vector<Index> result;
    for(const Location& location : find(at_site(cloud, a), at_site(cloud, b)))
      result.push_back(location.site);
    return result;
  };
  EXPECT_EQ(sites(0, 2), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(sites(3, 0), (std::vector<Index>{3, 0}));
  EXPECT_EQ(sites(1, 3), (std::vector<Index>{1, 2, 3}));
  EXPECT_EQ(sites(1, 1), (std::vector<Index>{1}));
  EXPECT_TRUE(sites(1, 4).empty());
}

} // namespace
