// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>

#include "Array_surface.h"
#include "pockets.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <set>

namespace remeshing_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Remeshing remeshed(const Array_surface& surface, std::size_t number, std::size_t relaxation = 0)
{
  Remeshing_options options;
  options.number_of_samples = number;
  options.number_of_relaxation_steps = relaxation;
  return remesh(surface.triangles(), options);
}

std::vector<Index> corners_of(const Remeshing& mesh)
{
  std::vector<Index> result;
  for(const auto& f : mesh.triangles)
    result.insert(result.end(), f.begin(), f.end());
  return result;
}

std::vector<Point> points_of(const Array_surface& surface, const Remeshing& mesh)
{
  std::vector<Point> result;
  for(const Surface_location& sample : mesh.samples)
    result.push_back(coordinates(surface.t(), sample));
  return result;
}

Point normal_of(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

double area(const std::vector<Point>& points, const std::vector<Index>& corners)
{
  double result = 0.;
  for(std::size_t f = 0; f < corners.size(); f += 3)
    result +=
        0.5 * norm(normal_of(points[corners[f]], points[corners[f + 1]], points[corners[f + 2]]));
  return result;
}

// Expects the topology of the input, no isolated vertices, and samples with valid coordinates.
void expect_same_topology(const Array_surface& surface, const Remeshing& mesh, std::size_t number)
{
  EXPECT_TRUE(mesh.is_finished);
  EXPECT_GE(mesh.samples.size(), number);
  const std::vector<Index> corners = corners_of(mesh);
  EXPECT_EQ(topology(corners), topology(make_refinement(surface.triangles()).triangles->corner));
  const std::set<Index> used(corners.begin(), corners.end());
  EXPECT_EQ(used.size(), mesh.samples.size());
  EXPECT_TRUE(used.empty() || *used.rbegin() + 1 == used.size());
  for(const Surface_location& sample : mesh.samples)
  {
    ASSERT_LT(sample.triangle, surface.t().number_of_triangles());
    double sum = 0.;
    for(const double b : sample.barycentric)
    {
      EXPECT_GE(b, 0.);
      sum += b;
    }
    EXPECT_NEAR(sum, 1., 1e-15); // one or two round-off errors
  }
}

TEST(Remeshing, preserves_topology)
{
  for(const Triangulation& surface :
      {icosphere(4), torus(60, 24), cylinder(40, 60, 0.3, 3.), square(30, 0.2),
       annulus(60, 10, 0.5, 1.), double_torus(4), disjoint_union(icosphere(3), square(9)),
       tetrahedron(), disjoint_union(torus(30, 12), cylinder(20, 20, 1., 1.)), one_triangle(),
       cone(6, 5, 8.)})
  {
    const Array_surface arrays(surface);
    for(const std::size_t number : {0u, 10u, 100u, 400u})
      for(const std::size_t relaxation : {0u, 2u})
      {
        SCOPED_TRACE(std::to_string(surface.points.size()) + " points, " + std::to_string(number) +
                     " samples");
        expect_same_topology(arrays, remeshed(arrays, number, relaxation), number);
      }
  }
}

TEST(Remeshing, has_requested_number_of_samples)
{
  for(const Triangulation& surface : {icosphere(4), square(40, 0.2), torus(60, 24)})
    EXPECT_EQ(remeshed(Array_surface(surface), 300).samples.size(), 300u);
}

TEST(Remeshing, can_be_finer_than_input)
{
  for(const Triangulation& surface : {icosphere(2), tetrahedron(), square(3), cone(6, 2, 8.)})
  {
    const Array_surface arrays(surface);
    const Remeshing mesh = remeshed(arrays, 1000);
    expect_same_topology(arrays, mesh, 1000);
    EXPECT_LE(mesh.samples.size(), 1010u);
  }
}

TEST(Remeshing, preserves_orientation)
{
  const Array_surface surface(icosphere(4));
  for(const std::size_t number : {50u, 300u})
  {
    const Remeshing mesh = remeshed(surface, number);
    const std::vector<Point> points = points_of(surface, mesh);
    for(const auto& f : mesh.triangles)
    {
      const Point &a = points[f[0]], &b = points[f[1]], &c = points[f[2]];
      EXPECT_GT(dot(normal_of(a, b, c), a + b + c), 0.);
    }
  }
}

TEST(Remeshing, covers_square_exactly)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(const std::size_t relaxation : {0u, 3u})
      for(const std::size_t number : {20u, 200u})
      {
        const Triangulation plane = scaled(square(30, 0.2), scale);
        const Array_surface surface(plane);
        const Remeshing mesh = remeshed(surface, number, relaxation);
        const std::vector<Point> points = points_of(surface, mesh);
        double signed_area = 0.;
        for(const auto& f : mesh.triangles)
        {
          const double triangle_area = 0.5 * normal_of(points[f[0]], points[f[1]], points[f[2]])[2];
          EXPECT_GT(triangle_area, 0.);
          signed_area += triangle_area;
        }
        // Round-off errors of a sum of a few hundred terms.
        EXPECT_NEAR(signed_area, scale * scale, 1e-12 * scale * scale);
      }
}

TEST(Remeshing, preserves_boundary)
{
  const Array_surface surface(cylinder(48, 48, 1., 1.));
  for(const std::size_t number : {20u, 300u})
  {
    const Remeshing mesh = remeshed(surface, number);
    const std::vector<Point> points = points_of(surface, mesh);
    std::set<std::pair<Index, Index>> directed_edges;
    for(const auto& f : mesh.triangles)
      for(int k = 0; k < 3; ++k)
        directed_edges.insert({f[k], f[(k + 1) % 3]});
    std::size_t number_of_boundary_edges = 0;
    for(const auto& [a, b] : directed_edges)
      if(directed_edges.count({b, a}) == 0)
      {
        ++number_of_boundary_edges;
        EXPECT_TRUE(points[a][2] == 0. || points[a][2] == 1.);
        EXPECT_EQ(points[a][2], points[b][2]);
      }
    EXPECT_GE(number_of_boundary_edges, 6u);
  }
}

TEST(Remeshing, preserves_feature_edges)
{
  const int size = 8;
  const Array_surface cube(blocks(size, size, size, [](int, int, int) { return true; }));
  Remeshing_options options;
  options.is_feature = boundary_and_sharp_halfedges(cube.t(), 60.);
  for(const std::size_t relaxation : {0u, 3u})
    for(const std::size_t number : {8u, 100u, 400u})
    {
      options.number_of_samples = number;
      options.number_of_relaxation_steps = relaxation;
      const Remeshing mesh = remesh(cube.triangles(), options);
      expect_same_topology(cube, mesh, number);
      // Each triangle lies in one of the six faces of the cube, so that the areas are equal up to
      // round-off errors.
      const std::vector<Point> points = points_of(cube, mesh);
      EXPECT_NEAR(area(points, corners_of(mesh)), 6. * size * size, 1e-9);
      for(const auto& f : mesh.triangles)
      {
        std::size_t common_planes = 0;
        for(int k = 0; k < 3; ++k)
          for(const double x : {0., double(size)})
            common_planes += std::all_of(
                f.begin(), f.end(), [&](Index i) { return std::abs(points[i][k] - x) < 1e-12; });
        EXPECT_EQ(common_planes, 1u);
      }
    }
}

TEST(Remeshing, respects_feature_spacing)
{
  const Array_surface surface(square(12));
  Remeshing_options options;
  options.number_of_samples = 60;
  options.is_feature = boundary_and_sharp_halfedges(surface.t());
  for(const double spacing : {0.02, 0.1, 1e300})
  {
    // The spacing is given on the lower edge of the square only.
    options.feature_spacing.assign(surface.t().corner.size(), 0.);
    for(Index h = 0; h < options.feature_spacing.size(); ++h)
      if(options.is_feature[h] &&
         coordinates(surface.t(), {h / 3, none, barycentric_on_halfedge(h, 0.5)})[1] == 0.)
        options.feature_spacing[h] = spacing / surface.scale();
    const Remeshing result = remesh(surface.triangles(), options);
    std::vector<Index> corners;
    for(const auto& f : result.triangles)
      corners.insert(corners.end(), f.begin(), f.end());
    EXPECT_EQ(topology(corners), (Topology{true, {{1, 1}}}));
    if(spacing > 1.)
      continue; // the topology requires more samples than this spacing
    // Coordinates in [0, 1] with round-off errors.
    std::vector<double> low;
    for(const Point& p : result.points)
      if(p[1] < 1e-14)
        low.push_back(p[0]);
    std::sort(low.begin(), low.end());
    const std::size_t steps = std::size_t(std::round(1. / spacing));
    ASSERT_EQ(low.size(), steps + 1);
    for(std::size_t i = 0; i <= steps; ++i)
      // Round-off errors of coordinates near 1.
      EXPECT_NEAR(low[i], double(i) / double(steps), 1e-14);
  }
  options.feature_spacing.assign(options.feature_spacing.size(), 1e-12);
  EXPECT_THROW(remesh(surface.triangles(), options),
               CGAL::Geodesic_processing::Invalid_argument_error);
}

// Samples on a straight feature that are much closer to each other than other samples are the
// corners of triangles without area, unless their edges beside the feature are flipped.
TEST(Remeshing, dense_feature_samples_yield_no_flat_faces)
{
  const int size = 8;
  const Array_surface cube(blocks(size, size, size, [](int, int, int) { return true; }));
  Remeshing_options options;
  options.number_of_samples = 100; // at distances of about 2
  options.is_feature = boundary_and_sharp_halfedges(cube.t(), 60.);
  for(const double spacing : {0.25, 0.5, 1.})
  {
    options.feature_spacing.assign(cube.t().corner.size(), spacing / cube.scale());
    const Remeshing mesh = remesh(cube.triangles(), options);
    expect_same_topology(cube, mesh, 100);
    const std::vector<Point> points = points_of(cube, mesh);
    EXPECT_NEAR(area(points, corners_of(mesh)), 6. * size * size, 1e-9); // round-off errors
    for(const auto& f : mesh.triangles)
    {
      const Point &a = points[f[0]], &b = points[f[1]], &c = points[f[2]];
      const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
      // Faces at the feature join points on it to one at a distance of about 1.
      EXPECT_GT(norm(normal_of(a, b, c)), 0.01 * longest * longest);
    }
  }
}

TEST(Remeshing, relaxation_improves_angles)
{
  const Array_surface surface(icosphere(4));
  const auto mean_min_angle = [&](std::size_t number, std::size_t relaxation)
  {
    const Remeshing mesh = remeshed(surface, number, relaxation);
    const std::vector<Point> points = points_of(surface, mesh);
    double sum = 0.;
    for(const auto& f : mesh.triangles)
    {
      double min_angle = pi;
      for(int k = 0; k < 3; ++k)
      {
        const Point u = points[f[(k + 1) % 3]] - points[f[k]],
                    v = points[f[(k + 2) % 3]] - points[f[k]];
        min_angle = std::min(min_angle, std::atan2(norm(cross(u, v)), dot(u, v)));
      }
      sum += min_angle;
    }
    return sum / double(mesh.triangles.size()) * 180. / pi;
  };
  const double initial = mean_min_angle(200, 0), relaxed = mean_min_angle(200, 20);
  EXPECT_GT(relaxed, initial);
  // With many cells the mean is at least 53 degrees. The upper bound is 60 degrees.
  EXPECT_GT(relaxed, 50.);
  // The smoothing after the relaxation makes up for most of the missing steps.
  EXPECT_GT(mean_min_angle(1000, 2), 50.);
  EXPECT_GT(mean_min_angle(1000, 20), 52.5);
}

TEST(Remeshing, density_follows_slowness)
{
  const Array_surface surface(square(30, 0.2));
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] < 0.5)
      slowness[f] = 5.;
  for(const std::size_t relaxation : {0u, 3u})
  {
    Remeshing_options options;
    options.number_of_samples = 260;
    options.number_of_relaxation_steps = relaxation;
    options.slowness = std::make_shared<const std::vector<double>>(slowness);
    const Remeshing mesh = remesh(surface.triangles(), options);
    expect_same_topology(surface, mesh, 260);
    const std::vector<Point> points = points_of(surface, mesh);
    const auto left =
        std::count_if(points.begin(), points.end(), [](const Point& p) { return p[0] < 0.5; });
    // The left half has 25/26 of the area in the metric of travel times. Samples on the boundary
    // change this by less than 10 %.
    EXPECT_NEAR(double(left), 250., 25.);
  }
}

TEST(Remeshing, respects_maximum_deviation)
{
  for(const Triangulation& surface : {icosphere(4), double_torus(6), torus(60, 24)})
    for(const double scale : {1e-6, 1.})
    {
      const Triangulation large = scaled(surface, scale);
      const Array_surface arrays(large);
      std::vector<std::size_t> numbers;
      for(const double deviation : {0.1, 0.03, 0.01})
      {
        Remeshing_options options;
        options.number_of_samples = 30;
        options.maximum_deviation = deviation * scale / arrays.scale();
        const Remeshing mesh = remesh(arrays.triangles(), options);
        expect_same_topology(arrays, mesh, 30);
        numbers.push_back(mesh.samples.size());
        const std::vector<Point> points = points_of(arrays, mesh);
        for(const Point& p : large.points)
        {
          double min_distance = infinity;
          for(const auto& f : mesh.triangles)
          {
            const Point &a = points[f[0]], &b = points[f[1]], &c = points[f[2]];
            const auto nearest = nearest_in_triangle(a, b, c, p);
            min_distance = std::min(min_distance,
                                    distance(nearest[0] * a + nearest[1] * b + nearest[2] * c, p));
          }
          EXPECT_LE(min_distance, deviation * scale * (1. + 1e-9)); // round-off errors
        }
      }
      EXPECT_GT(numbers.back(), numbers.front());
    }
}

TEST(Remeshing, keeps_first_samples)
{
  const Array_surface surface(icosphere(3));
  Remeshing_options options;
  options.number_of_samples = 100;
  options.number_of_relaxation_steps = 3;
  for(const Index i : {7u, 100u, 300u})
    options.first_samples.push_back(canonical(surface.t(), surface.at(i)));
  options.first_samples.push_back(surface.in(11, {0.25, 0.25, 0.5}));
  const Remeshing mesh = remesh(surface.triangles(), options);
  expect_same_topology(surface, mesh, 100);
  for(std::size_t i = 0; i < options.first_samples.size(); ++i)
    EXPECT_TRUE(is_same_point(surface.t(), mesh.samples[i], options.first_samples[i]));
  // A repeated first sample counts once.
  options.first_samples.assign(2, options.first_samples[0]);
  EXPECT_EQ(remesh(surface.triangles(), options).samples.size(), 100u);
}

TEST(Remeshing, is_deterministic_for_a_seed)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const auto with = [&](unsigned seed)
  {
    Remeshing_options options;
    options.number_of_samples = 60;
    options.seed = seed;
    const Remeshing mesh = remesh(surface.triangles(), options);
    return std::pair(points_of(surface, mesh), mesh.triangles);
  };
  EXPECT_EQ(with(1), with(1));
  EXPECT_NE(with(1), with(2));
}

TEST(Remeshing, handles_degenerate_input)
{
  // Coinciding points, triangles without area, two triangles with the same vertices, a nonmanifold
  // vertex, isolated vertices, needles.
  Triangulation flat = square(6);
  for(Point& p : flat.points)
    p[1] = 0.;
  Triangulation one_point = icosphere(1);
  for(Point& p : one_point.points)
    p = {1., 2., 3.};
  Triangulation lens = one_triangle();
  lens.corners.insert(lens.corners.end(), {0, 2, 1});
  Triangulation pinched = tetrahedron();
  for(const Point& p : {Point{3., 1., 1.}, Point{3., 3., 1.}, Point{3., 1., 3.}})
    pinched.points.push_back(p);
  pinched.corners.insert(pinched.corners.end(), {0, 4, 5, 0, 5, 6, 0, 6, 4, 4, 6, 5});
  Triangulation isolated = square(4);
  isolated.points.push_back({9., 9., 9.});
  const Triangulation needles = grid(3, 200,
                                     [](double u, double v) {
                                       return Point{1000. * u, v, 0.};
                                     });
  for(const Triangulation& surface : {flat, one_point, pinched, isolated, needles})
    for(const std::size_t number : {0u, 10u, 200u})
    {
      SCOPED_TRACE(std::to_string(surface.points.size()) + " points, " + std::to_string(number) +
                   " samples");
      const Array_surface arrays(surface);
      expect_same_topology(arrays, remeshed(arrays, number), 0);
    }
  for(const std::size_t number : {0u, 10u, 200u})
    EXPECT_EQ(topology(corners_of(remeshed(Array_surface(lens), number))),
              (Topology{true, {{2, 0}}}));
  EXPECT_TRUE(remeshed(Array_surface({{{0., 0., 0.}}, {}}), 10).samples.empty());
  EXPECT_TRUE(remeshed(Array_surface(Triangulation()), 10).triangles.empty());
}

TEST(Remeshing, preserves_topology_at_vertices_of_two_faces)
{
  for(const std::size_t number_of_pockets : {1u, 5u, 20u})
  {
    const auto surface = with_pockets(icosphere(1), number_of_pockets);
    for(const double sharp_angle : {30., infinity})
      for(const std::size_t number : {10u, 200u})
      {
        SCOPED_TRACE(std::to_string(number_of_pockets) + " pockets, " + std::to_string(number) +
                     " samples");
        Remeshing_options options;
        options.number_of_samples = number;
        options.is_feature = boundary_and_sharp_halfedges(*surface, sharp_angle);
        // All vertices are samples, so that no cell can contain two vertices of a pocket.
        for(Index i = 0; i < surface->number_of_vertices(); ++i)
          options.first_samples.push_back({none, i, {}});
        EXPECT_EQ(topology(corners_of(remesh(surface, options))), (Topology{true, {{2, 0}}}));
      }
  }
}

// Two copies of a flat triangle. One has further vertices, some of them very close to edges. Faces
// of the result intersect. The samples that are added there cannot be triangulated.
TEST(Remeshing, keeps_valid_mesh_if_further_samples_fail)
{
  const Array_surface surface({{{0.087626334994670693, -0.16393173899850538, -0.41633638244042892},
                                {0.77667372548431124, -0.93322222540096378, -0.0098262906296432764},
                                {-1.1453571020931228, 1.2375496040228495, 0.57683202861173721},
                                {0.54950155169115655, -0.67886596791999465, -0.093515957493400081},
                                {0.011359440299681929, -0.069397021176356224, 0.1869702788415421},
                                {0.55991048793894516, -0.69050862932333423, -0.088863649390810429},
                                {0.56172900677787474, -0.69254488919841939, -0.088202813419911208},
                                {0.63265815891166943, -0.77196547188549647, -0.062338036010649273},
                                {0.77558313432569093, -0.93200107136698984, -0.010223947753467012}},
                               {0, 1, 3, 0, 2, 1, 1, 2, 4, 2, 0, 3, 2, 3, 4, 3, 1, 6, 1, 4, 5,
                                4, 3, 5, 1, 5, 8, 5, 3, 6, 5, 6, 7, 6, 1, 7, 5, 7, 8, 7, 1, 8}});
  Remeshing_options options;
  options.number_of_samples = 20;
  options.is_feature = boundary_and_sharp_halfedges(surface.t(), 30.);
  for(const bool does_avoid : {false, true})
  {
    options.does_avoid_self_intersections = does_avoid;
    expect_same_topology(surface, remesh(surface.triangles(), options), 20);
  }
}

// The vertices of two triangles are on a line. The distance between their edges is zero, so that
// refinement does not separate the cells. The bound of the number of vertices ends it early.
TEST(Remeshing, gives_up_early_without_area)
{
  const Array_surface surface(
      {{{0.1, 0.2, 0.3}, {0.2, 0.3, 0.4}, {0.3, 0.4, 0.5}, {0.4, 0.5, 0.6}}, {0, 1, 2, 1, 0, 3}});
  Remeshing_options options;
  options.number_of_samples = 50;
  std::size_t number_of_calls = 0;
  options.callback = [&](double) { return ++number_of_calls < 150; };
  EXPECT_THROW(remesh(surface.triangles(), options),
               CGAL::Geodesic_processing::Unsupported_surface_error);
}

TEST(Remeshing, can_be_cancelled)
{
  const Array_surface surface(icosphere(4));
  Remeshing_options options;
  options.number_of_samples = 200;
  options.number_of_relaxation_steps = 3;
  double last = 0.;
  bool is_monotone = true;
  options.callback = [&](double done)
  {
    is_monotone = is_monotone && done >= last && done <= 1.;
    last = done;
    return true;
  };
  EXPECT_TRUE(remesh(surface.triangles(), options).is_finished);
  EXPECT_TRUE(is_monotone);
  for(const double end : {0.1, 0.5, 0.85})
  {
    options.callback = [&](double done) { return done < end; };
    const Remeshing mesh = remesh(surface.triangles(), options);
    EXPECT_FALSE(mesh.is_finished);
    EXPECT_TRUE(mesh.triangles.empty());
  }
}

} // namespace remeshing_test
