// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace voronoi_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Kind = Front_kind;
using Sources = std::vector<internal::Front_source>;

Voronoi_diagram voronoi(const std::shared_ptr<const Surface_arrays>& triangles,
                        const Sources& sources, const Front_limits& limits = {},
                        Kind kind = Kind::euclidean)
{
  Index cells = 0;
  for(const internal::Front_source& source : sources)
    cells = std::max(cells, source.label + 1);
  return Voronoi_diagram(triangles, Front(triangles, kind), sources, cells, limits);
}

Sources sources_at(const std::vector<Surface_location>& locations)
{
  Sources result;
  for(const Surface_location& location : locations)
    result.push_back({{location}, 0., Index(result.size())});
  return result;
}

Sources farthest_sources(const std::shared_ptr<const Surface_arrays>& triangles, std::size_t number)
{
  return sources_at(farthest_points(triangles, number));
}

void expect_continuous_bisectors(const Surface_arrays& t, const Voronoi_diagram& cells)
{
  for(const Voronoi_diagram::Bisector& bisector : cells.bisectors())
  {
    EXPECT_NE(bisector.left, bisector.right);
    ASSERT_GE(bisector.polyline.size(), 2u);
    for(std::size_t i = 1; i < bisector.polyline.size(); ++i)
      EXPECT_NE(common_triangle(t, canonical(t, bisector.polyline[i - 1]),
                                canonical(t, bisector.polyline[i])),
                none);
  }
}

// Expects that bisectors end at Voronoi vertices or at the boundary of the reached triangles, and
// that exactly one of them crosses each edge between two cells.
void expect_consistent(const Surface_arrays& t, const Voronoi_diagram& cells)
{
  expect_continuous_bisectors(t, cells);
  std::size_t crossed = 0, triple = 0;
  for(Index h = 0; h < t.corner.size(); ++h)
    crossed += (t.twin[h] == none || t.twin[h] > h) &&
               cells.labels()[t.corner[h]] != cells.labels()[t.corner[next_halfedge(h)]];
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    triple += std::set<Index>{cells.labels()[t.corner[3 * f]], cells.labels()[t.corner[3 * f + 1]],
                              cells.labels()[t.corner[3 * f + 2]]}
                  .size() == 3;
  std::size_t crossings = 0, ends = 0;
  for(const Voronoi_diagram::Bisector& bisector : cells.bisectors())
  {
    const std::vector<Surface_location>& polyline = bisector.polyline;
    const auto is_inside = [](const Surface_location& location)
    { return location.barycentric[0] * location.barycentric[1] * location.barycentric[2] > 0.; };
    const std::size_t inside = is_inside(polyline.front()) + is_inside(polyline.back());
    const bool is_loop = inside == 0 && is_same_point(t, canonical(t, polyline.front()),
                                                      canonical(t, polyline.back()));
    crossings += polyline.size() - inside - is_loop;
    ends += inside;
  }
  EXPECT_EQ(crossings, crossed);
  EXPECT_EQ(ends, 3 * triple);
}

TEST(Voronoi_diagram, bisector_of_two_square_corners_is_the_diagonal)
{
  const Triangulation plane = square(20, 0.2, 4);
  const Array_surface surface(plane);
  // The sources are opposite corners, and the bisector is the other diagonal.
  const Voronoi_diagram cells =
      voronoi(surface.triangles(), sources_at({surface.at(0), surface.at(440)}));
  expect_consistent(surface.t(), cells);
  const auto bisectors = cells.bisectors();
  ASSERT_EQ(bisectors.size(), 1u);
  // Round-off errors of a sum of some tens of lengths.
  EXPECT_NEAR(surface.scale() * path_length(surface.t(), bisectors[0].polyline), std::sqrt(2.),
              1e-12);
  const auto u = coordinates(surface.t(), bisectors[0].polyline.front()),
             v = coordinates(surface.t(), bisectors[0].polyline.back());
  // The cell of the first source at (0, 0) is to the left if the bisector is followed upwards.
  const bool is_up = v[1] > u[1];
  EXPECT_EQ(bisectors[0].left, is_up ? 0u : 1u);
  EXPECT_EQ(bisectors[0].right, is_up ? 1u : 0u);
  for(const Surface_location& location : bisectors[0].polyline)
  {
    const auto p = coordinates(surface.t(), location);
    EXPECT_NEAR(p[0] + p[1], 1., 1e-14); // round-off error, measured 2e-16
  }
}

TEST(Voronoi_diagram, matches_euclidean_diagram_in_plane)
{
  const Triangulation plane = square(50, 0.2, 3);
  const Array_surface surface(plane);
  for(int trial = 0; trial < 5; ++trial)
  {
    const Sources sources = farthest_sources(surface.triangles(), 6 + 5 * trial);
    const Voronoi_diagram cells = voronoi(surface.triangles(), sources);
    EXPECT_TRUE(cells.is_finished());
    expect_consistent(surface.t(), cells);
    std::vector<Point> seeds;
    for(const internal::Front_source& source : sources)
      seeds.push_back(scaled_coordinates(surface.t(), source.polyline[0]));
    const double edge_length = 1. / 50. / surface.scale();
    // Round-off errors of differences of squared distances of about 50 edges.
    const double round_off_tolerance = 1e-10 * edge_length;
    double sum = 0.;
    std::size_t count = 0;
    for(const Voronoi_diagram::Bisector& bisector : cells.bisectors())
      for(const Surface_location& location : bisector.polyline)
      {
        const Point p = scaled_coordinates(surface.t(), location);
        const double to_left = distance(p, seeds[bisector.left]),
                     to_right = distance(p, seeds[bisector.right]);
        double min_distance = infinity;
        for(const Point& seed : seeds)
          min_distance = std::min(min_distance, distance(p, seed));
        // At a crossing of an edge, both sources have the same distance.
        if(corner_of(location) == none && halfedge_of(location) != none)
        {
          EXPECT_NEAR(to_left, to_right, round_off_tolerance);
        }
        // A Voronoi vertex is located up to one triangle, whose edges have length at most two.
        EXPECT_LT(std::max(to_left, to_right) - min_distance, 2. * edge_length);
        sum += std::max(to_left, to_right) - min_distance;
        ++count;
      }
    // Only Voronoi vertices have an error, and few locations are Voronoi vertices.
    EXPECT_LT(sum, 0.05 * edge_length * double(count));
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
    {
      double min_distance = infinity;
      for(const Point& seed : seeds)
        min_distance = std::min(min_distance, distance(seed, surface.t().point[vertex]));
      EXPECT_NEAR(cells.distances()[vertex], min_distance, round_off_tolerance);
      EXPECT_NEAR(distance(seeds[cells.labels()[vertex]], surface.t().point[vertex]), min_distance,
                  round_off_tolerance);
    }
    for(Index f = 0; f < surface.t().number_of_triangles(); ++f)
    {
      const Point center = scaled_coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}});
      double min_distance = infinity;
      for(const Point& seed : seeds)
        min_distance = std::min(min_distance, distance(seed, center));
      // A cell that contains the centroid but no corner of a triangle is not detected.
      EXPECT_NEAR(distance(seeds[cells.triangle_label(f)], center), min_distance, edge_length);
    }
  }
}

TEST(Voronoi_diagram, satisfies_euler_formula_on_sphere)
{
  const Array_surface surface(jittered(icosphere(4), 0.01));
  for(const std::size_t n : {4u, 10u, 40u})
  {
    const Voronoi_diagram cells =
        voronoi(surface.triangles(), farthest_sources(surface.triangles(), n));
    expect_consistent(surface.t(), cells);
    std::size_t ends = 0;
    const auto bisectors = cells.bisectors();
    for(const Voronoi_diagram::Bisector& bisector : bisectors)
      ends += 2 - 2 * is_same_point(surface.t(), canonical(surface.t(), bisector.polyline.front()),
                                    canonical(surface.t(), bisector.polyline.back()));
    // All cells are disks here, and three bisectors meet at each Voronoi vertex.
    EXPECT_EQ(ends, 2 * bisectors.size());
    EXPECT_EQ(n - bisectors.size() + ends / 3, 2u);
  }
}

TEST(Voronoi_diagram, bisector_of_two_poles_is_closed)
{
  const Triangulation sphere = icosphere(4);
  const Array_surface surface(sphere);
  const Point pole = sphere.points[0];
  Index opposite = 0;
  for(Index i = 0; i < surface.size(); ++i)
    if(distance(sphere.points[i], -1. * pole) < 1e-9)
      opposite = i;
  const Voronoi_diagram cells =
      voronoi(surface.triangles(), sources_at({surface.at(0), surface.at(opposite)}));
  expect_consistent(surface.t(), cells);
  const auto bisectors = cells.bisectors();
  ASSERT_EQ(bisectors.size(), 1u);
  EXPECT_TRUE(is_same_point(surface.t(), canonical(surface.t(), bisectors[0].polyline.front()),
                            canonical(surface.t(), bisectors[0].polyline.back())));
  // The bisector is the equator. Its chords lie below the sphere, and fronts on the triangles have
  // an error of about 0.1 %.
  for(const Surface_location& location : bisectors[0].polyline)
    EXPECT_NEAR(test::dot(coordinates(surface.t(), location), pole), 0., 2e-3);
}

TEST(Voronoi_diagram, cell_may_have_several_sources)
{
  const Triangulation plane = square(20, 0.2, 4);
  const Array_surface surface(plane);
  Sources sources = sources_at({surface.at(0), surface.at(440), surface.at(20)});
  sources[2].label = 0;
  const Voronoi_diagram cells = voronoi(surface.triangles(), sources);
  expect_consistent(surface.t(), cells);
  for(const Index label : cells.labels())
    EXPECT_LT(label, 2u);
  // The bisector consists of two segments, from the midpoint of the left or upper edge to that of
  // the right edge.
  double length = 0.;
  for(const auto& bisector : cells.bisectors())
    length += surface.scale() * path_length(surface.t(), bisector.polyline);
  // The bisector bends inside a triangle where the fronts of the two sources of one cell meet.
  EXPECT_NEAR(length, 0.5 + std::sqrt(0.5), 0.05);
}

TEST(Voronoi_diagram, respects_distance_limit_and_obstacles)
{
  const Triangulation plane = square(30, 0.2, 4);
  const Array_surface surface(plane);
  Front_limits limits;
  limits.maximum_distance = 0.4 / surface.scale();
  const Voronoi_diagram near = voronoi(
      surface.triangles(), sources_at({surface.at(5 * 31 + 10), surface.at(5 * 31 + 20)}), limits);
  std::size_t unreached = 0;
  for(Index vertex = 0; vertex < surface.size(); ++vertex)
  {
    EXPECT_EQ(near.labels()[vertex] == none, near.distances()[vertex] == infinity);
    unreached += near.labels()[vertex] == none;
  }
  EXPECT_GT(unreached, 0u);
  ASSERT_EQ(near.bisectors().size(), 1u);

  // An obstacle separates two halves, so that each cell fills one of them.
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(std::abs(scaled_coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0]) *
           surface.scale() <
       0.06)
      slowness[f] = infinity;
  limits.maximum_distance = infinity;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  const Voronoi_diagram apart = voronoi(
      surface.triangles(), sources_at({surface.at(15 * 31), surface.at(15 * 31 + 30)}), limits);
  for(Index i = 0; i < surface.size(); ++i)
    if(const Index label = apart.labels()[surface.vertex(i)]; label != none)
    {
      EXPECT_EQ(label, plane.points[i][0] < 0.5 ? 0u : 1u);
    }
}

TEST(Voronoi_diagram, bisector_moves_with_speed_and_offset)
{
  const Triangulation plane = square(40, 0.2, 4);
  const Array_surface surface(plane);
  const std::vector<Surface_location> ends = {surface.at(20 * 41), surface.at(20 * 41 + 40)};
  // Returns the crossing of the bisector with the line between two points at distance one.
  const auto crossing = [&](const Voronoi_diagram& cells)
  {
    double x = infinity, smallest_offset = infinity;
    for(const auto& bisector : cells.bisectors())
      for(const Surface_location& location : bisector.polyline)
        if(const auto p = coordinates(surface.t(), location);
           std::abs(p[1] - 0.5) < smallest_offset)
        {
          smallest_offset = std::abs(p[1] - 0.5);
          x = p[0];
        }
    return x;
  };
  Sources later = sources_at(ends);
  later[1].offset = 0.2 / surface.scale();
  // Bisectors are known at edges. The closest crossing is within one edge, 1/40.
  EXPECT_NEAR(crossing(voronoi(surface.triangles(), later)), 0.6, 0.02);

  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(scaled_coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] > 0.)
      slowness[f] = 2.;
  Front_limits limits;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  // The travel time is 0.5 + 2 (x - 0.5) from the left and 2 (1 - x) from the right. The planar
  // front has an error of 1 %.
  EXPECT_NEAR(crossing(voronoi(surface.triangles(), sources_at(ends), limits)), 0.625, 0.02);
}

// Returns the area of a triangle of the cut mesh, in the scale of the arrays.
double cut_triangle_area(const Surface_arrays& t, const Voronoi_diagram::Cut_mesh& cut,
                         std::size_t triangle)
{
  std::array<Vec3, 3> p;
  for(std::size_t k = 0; k < 3; ++k)
    p[k] = scaled_coordinates(t, cut.vertices[cut.corners[3 * triangle + k]]);
  return 0.5 * norm(internal::cross(p[1] - p[0], p[2] - p[0]));
}

TEST(Voronoi_diagram, cut_preserves_area_and_topology)
{
  const std::vector<Triangulation> surfaces = {square(20, 0.2, 4), jittered(icosphere(3), 0.01),
                                               annulus(24, 5, 0.3, 1.)};
  for(const Triangulation& triangulation : surfaces)
    for(const std::size_t number : {2u, 9u, 40u})
    {
      const Array_surface surface(triangulation);
      const Surface_arrays& t = surface.t();
      const Voronoi_diagram cells =
          voronoi(surface.triangles(), farthest_sources(surface.triangles(), number));
      const Voronoi_diagram::Cut_mesh cut = cells.cut();
      double total_area = 0., cut_area = 0.;
      for(Index f = 0; f < t.number_of_triangles(); ++f)
        total_area += 0.5 * twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]);
      for(std::size_t f = 0; f < cut.labels.size(); ++f)
      {
        cut_area += cut_triangle_area(t, cut, f);
        ASSERT_LT(cut.labels[f], number);
        // A vertex of the mesh belongs to triangles of its own cell only.
        for(std::size_t k = 0; k < 3; ++k)
          if(const Index vertex = cut.corners[3 * f + k]; vertex < surface.size())
          {
            EXPECT_EQ(cut.labels[f], cells.labels()[vertex]);
          }
      }
      EXPECT_NEAR(cut_area, total_area, 1e-12 * total_area); // round-off errors

      // Each directed edge occurs at most once. Boundary edges are those of the mesh, split at
      // crossings. The Euler characteristic is that of the mesh.
      std::set<std::pair<Index, Index>> directed_edges;
      for(std::size_t c = 0; c < cut.corners.size(); ++c)
        EXPECT_TRUE(
            directed_edges.insert({cut.corners[c], cut.corners[next_halfedge(Index(c))]}).second);
      const auto euler = [](std::size_t vertices, std::size_t corners,
                            std::size_t number_of_boundary_halfedges) {
        return long(vertices) - long(corners + number_of_boundary_halfedges) / 2 +
               long(corners) / 3;
      };
      std::size_t number_of_boundary_halfedges = 0, boundary_halfedges_before = 0, crossed = 0;
      for(const auto& [a, b] : directed_edges)
        number_of_boundary_halfedges += directed_edges.count({b, a}) == 0;
      for(Index h = 0; h < t.corner.size(); ++h)
        if(t.twin[h] == none)
        {
          ++boundary_halfedges_before;
          crossed += cells.labels()[t.corner[h]] != cells.labels()[t.corner[next_halfedge(h)]];
        }
      EXPECT_EQ(number_of_boundary_halfedges, boundary_halfedges_before + crossed);
      EXPECT_EQ(euler(cut.vertices.size(), cut.corners.size(), number_of_boundary_halfedges),
                euler(surface.size(), t.corner.size(), boundary_halfedges_before));
    }
}

TEST(Voronoi_diagram, cut_of_square_has_two_equal_halves)
{
  const Array_surface surface(square(20, 0.2, 4));
  const Voronoi_diagram cells =
      voronoi(surface.triangles(), sources_at({surface.at(0), surface.at(440)}));
  const Voronoi_diagram::Cut_mesh cut = cells.cut();
  double halves[2] = {0., 0.};
  for(std::size_t f = 0; f < cut.labels.size(); ++f)
    halves[cut.labels[f]] += cut_triangle_area(surface.t(), cut, f);
  const double square_of_scale = surface.scale() * surface.scale();
  EXPECT_NEAR(halves[0] * square_of_scale, 0.5,
              1e-9); // the tolerance of the bisector in its own test
  EXPECT_NEAR(halves[1] * square_of_scale, 0.5, 1e-13); // round-off error of a sum, measured 1e-16
}

TEST(Voronoi_diagram, cut_is_watertight_with_distance_limit)
{
  const Array_surface surface(square(30, 0.2, 4));
  Front_limits limits;
  limits.maximum_distance = 0.3 / surface.scale();
  const Voronoi_diagram::Cut_mesh cut =
      voronoi(surface.triangles(), sources_at({surface.at(15 * 31 + 12), surface.at(15 * 31 + 18)}),
              limits)
          .cut();
  EXPECT_EQ(std::set<Index>(cut.labels.begin(), cut.labels.end()), (std::set<Index>{0, 1, none}));
  std::set<std::pair<Index, Index>> directed_edges;
  for(std::size_t c = 0; c < cut.corners.size(); ++c)
    EXPECT_TRUE(
        directed_edges.insert({cut.corners[c], cut.corners[next_halfedge(Index(c))]}).second);
  // Only the boundary edges of the square have no opposite halfedge.
  std::size_t number_of_boundary_halfedges = 0;
  for(const auto& [a, b] : directed_edges)
    number_of_boundary_halfedges += directed_edges.count({b, a}) == 0;
  EXPECT_EQ(number_of_boundary_halfedges, 120u);
}

TEST(Voronoi_diagram, is_scale_invariant)
{
  std::vector<std::vector<double>> all;
  for(const double scale : {1., 0x1p-20, 0x1p20})
  {
    const Triangulation sphere = scaled(icosphere(3), scale);
    const Array_surface surface(sphere);
    all.emplace_back();
    for(const auto& bisector :
        voronoi(surface.triangles(), farthest_sources(surface.triangles(), 20)).bisectors())
      all.back().push_back(path_length(surface.t(), bisector.polyline));
  }
  EXPECT_EQ(all[1], all[0]);
  EXPECT_EQ(all[2], all[0]);
}

TEST(Voronoi_diagram, handles_degenerate_input)
{
  // More cells than the triangles can resolve, two sources at the same location, and needles; all
  // of these also with obstacles.
  const std::vector<Triangulation> surfaces = {one_triangle(), tetrahedron(), square(4),
                                               grid(
                                                   12, 12,
                                                   [](double u, double v) {
                                                     return Point{u, 1e-4 * v, 0.};
                                                   },
                                                   0.24, 3),
                                               grid(4, 4,
                                                    [](double u, double) {
                                                      return Point{u, u, 0.};
                                                    })};
  for(const Triangulation& triangulation : surfaces)
  {
    const Array_surface surface(triangulation);
    Sources sources;
    for(Index i = 0; i < surface.size(); ++i)
      sources.push_back(surface.source(i / 2 * 2, 0., i));
    for(const Kind kind : {Kind::dijkstra, Kind::planar, Kind::euclidean})
    {
      expect_continuous_bisectors(surface.t(), voronoi(surface.triangles(), sources, {}, kind));
      Front_limits limits;
      std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
      slowness[0] = infinity;
      limits.slowness = std::make_shared<const std::vector<double>>(slowness);
      const Voronoi_diagram cells = voronoi(surface.triangles(), sources, limits, kind);
      for(const auto& bisector : cells.bisectors())
        for(const Surface_location& location : bisector.polyline)
          for(const double b : location.barycentric)
            EXPECT_TRUE(b >= 0. && b <= 1.);
    }
  }
}

TEST(Voronoi_diagram, can_be_cancelled)
{
  const Array_surface surface(square(20));
  double last = 0.;
  Front_limits limits;
  limits.callback = [&](double done)
  {
    EXPECT_GE(done, last);
    last = done;
    return done < 0.5;
  };
  EXPECT_FALSE(
      voronoi(surface.triangles(), farthest_sources(surface.triangles(), 9), limits).is_finished());
}

TEST(Voronoi_diagram, labels_surfels_of_a_cloud)
{
  const Triangulation sphere = icosphere(3);
  const auto cloud_arrays =
      std::make_shared<const Surfel_arrays>(build_surfel_arrays(sphere.points, sphere.points));
  const std::shared_ptr<const Surface_arrays> triangles(cloud_arrays, &cloud_arrays->arrays);
  const Sources sources = farthest_sources(triangles, 12);
  const Voronoi_diagram cells = voronoi(triangles, sources);
  for(Index vertex = 0; vertex < triangles->number_of_vertices(); ++vertex)
  {
    double min_distance = infinity;
    const Point p = sphere.points[cloud_arrays->caller_vertex[vertex]];
    const auto to = [&](const internal::Front_source& source) {
      return great_circle(p, sphere.points[cloud_arrays->caller_vertex[source.polyline[0].vertex]]);
    };
    for(const internal::Front_source& source : sources)
      min_distance = std::min(min_distance, to(source));
    ASSERT_LT(cells.labels()[vertex], 12u);
    // A front on the local triangles of a cloud has an error of 1 to 2 %.
    EXPECT_NEAR(to(sources[cells.labels()[vertex]]), min_distance, 0.02);
  }
}

} // namespace voronoi_test
