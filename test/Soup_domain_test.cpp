// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/earth_movers_distance.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>
#include <CGAL/Geodesic_processing/texture_atlas.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <optional>
#include <random>
#include <thread>
#include <vector>

namespace soup_domain_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Point_3 = Kernel::Point_3;

struct Soup
{
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

Soup soup_of(const Triangulation& surface)
{
  Soup soup;
  for(const Point& p : surface.points)
    soup.points.emplace_back(p[0], p[1], p[2]);
  for(std::size_t i = 0; i < surface.corners.size(); i += 3)
    soup.polygons.push_back({surface.corners[i], surface.corners[i + 1], surface.corners[i + 2]});
  return soup;
}

template <typename Method, typename Surface>
std::vector<double> distances(const Surface& surface, std::size_t number_of_points,
                              std::size_t source)
{
  std::vector<double> result(number_of_points, -1.);
  GP::geodesic_distances<Method>(surface, Vertex(Mesh::size_type(source)),
                                 CGAL::make_property_map(result));
  return result;
}

// Checks that the faces and points of a domain are those of its mesh.
void expect_faces_of_mesh(const GP::Soup_domain<Point_3>& domain,
                          const std::vector<Point_3>& points)
{
  std::vector<std::array<std::size_t, 3>> corners; // read before the mesh is built
  for(std::size_t f = 0; f < domain.number_of_faces(); ++f)
    corners.push_back(domain.corners(Mesh::Face_index(Mesh::size_type(f))));
  const auto expect_points = [&]
  {
    for(std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(domain.point(Mesh::Vertex_index(Mesh::size_type(i))), points[i]);
  };
  expect_points();
  const Mesh& mesh = domain.mesh();
  expect_points();
  ASSERT_EQ(mesh.number_of_faces(), corners.size());
  ASSERT_EQ(mesh.number_of_vertices(), points.size());
  for(const Mesh::Face_index face : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(face);
    const std::array<std::size_t, 3> expected = {mesh.source(h), mesh.target(h),
                                                 mesh.target(mesh.next(h))};
    EXPECT_EQ(corners[face], expected);
  }
  for(const Mesh::Vertex_index v : mesh.vertices())
    EXPECT_EQ(mesh.point(v), points[v]);
}

TEST(Soup_domain, corners_are_those_of_mesh_built_later)
{
  Soup soup = soup_of(jittered(icosphere(2), 0.05));
  expect_faces_of_mesh(GP::make_domain(soup.points, soup.polygons), soup.points);
  // A reversed triangle, and one whose corners are copies of its points.
  std::swap(soup.polygons[5][0], soup.polygons[5][1]);
  for(std::size_t& corner : soup.polygons[9])
  {
    soup.points.push_back(soup.points[corner]);
    corner = soup.points.size() - 1;
  }
  expect_faces_of_mesh(GP::make_domain(soup.points, soup.polygons), soup.points);
  const auto merged =
      GP::make_domain(soup.points, soup.polygons, GP::parameters::merge_tolerance(0.));
  EXPECT_EQ(merged.report().number_of_merged_points, 3u);
  EXPECT_EQ(merged.report().number_of_reversed_triangles, 1u);
  expect_faces_of_mesh(merged, soup.points);
}

TEST(Soup_domain, builds_one_mesh_for_all_threads_and_copies)
{
  const Soup soup = soup_of(icosphere(3));
  const auto domain = GP::make_domain(soup.points, soup.polygons);
  std::vector<const Mesh*> meshes(4, nullptr);
  std::vector<std::thread> threads;
  for(const Mesh*& mesh : meshes)
    threads.emplace_back([&mesh, copy = domain] { mesh = &copy.mesh(); });
  for(std::thread& thread : threads)
    thread.join();
  for(const Mesh* mesh : meshes)
    EXPECT_EQ(mesh, &domain.mesh());
  EXPECT_EQ(domain.mesh().number_of_faces(), soup.polygons.size());
}

TEST(Soup_domain, of_clean_soup_has_results_of_mesh)
{
  const Triangulation surface = jittered(icosphere(2), 0.05);
  const Soup soup = soup_of(surface);
  const auto domain = GP::make_domain(soup.points, soup.polygons);
  EXPECT_FALSE(domain.report().is_changed());
  EXPECT_TRUE(domain.report().is_manifold());
  EXPECT_EQ(domain.report().number_of_components, 1u);
  EXPECT_EQ(domain.report().genus, 0u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(domain.mesh()));
  const std::size_t n = soup.points.size();
  const Mesh& mesh = domain.mesh();
  EXPECT_EQ(distances<GP::Exact>(domain, n, 7), distances<GP::Exact>(mesh, n, 7));
  EXPECT_EQ(distances<GP::Heat>(domain, n, 7), distances<GP::Heat>(mesh, n, 7));
  EXPECT_EQ(distances<GP::Euclidean_front>(domain, n, 7),
            distances<GP::Euclidean_front>(mesh, n, 7));
  // In a mesh that CGAL builds, faces begin with another corner. This changes round-off errors of
  // sums of some tens of lengths.
  const double round_off = 1e-13;
  const auto d = distances<GP::Exact>(domain, n, 7),
             expected = distances<GP::Exact>(mesh_of(surface), n, 7);
  for(std::size_t i = 0; i < n; ++i)
    EXPECT_NEAR(d[i], expected[i], round_off);
}

TEST(Soup_domain, has_results_of_mesh_in_spite_of_orientation_and_separate_points)
{
  const Triangulation surface = jittered(icosphere(2), 0.05);
  const std::size_t n = surface.points.size();
  const std::vector<double> expected = distances<GP::Exact>(mesh_of(surface), n, 7);
  std::mt19937 random(2);
  for(const double scale : {1e-6, 1., 1e6})
  {
    // Each triangle has its own points, at most 1e-9 from the vertices, and any orientation.
    std::uniform_real_distribution<double> offset(-0.5e-9, 0.5e-9);
    Soup soup;
    std::vector<Index> vertex;
    std::size_t source = 0;
    for(std::size_t i = 0; i < surface.corners.size(); i += 3)
    {
      for(std::size_t k = 0; k < 3; ++k)
      {
        const Index corner = surface.corners[i + k];
        const Point& p = surface.points[corner];
        if(corner == 7)
          source = vertex.size(); // any of the copies
        vertex.push_back(corner);
        soup.points.emplace_back(scale * (p[0] + offset(random)), scale * (p[1] + offset(random)),
                                 scale * (p[2] + offset(random)));
      }
      soup.polygons.push_back({i, i + 1, i + 2});
      if(random() % 4 == 0)
        std::swap(soup.polygons.back()[1], soup.polygons.back()[2]);
    }
    const auto domain =
        GP::make_domain(soup.points, soup.polygons, GP::parameters::merge_tolerance(1e-8 * scale));
    EXPECT_EQ(domain.number_of_vertices(), n);
    EXPECT_EQ(domain.mesh().number_of_vertices(), soup.points.size());
    EXPECT_EQ(domain.report().number_of_merged_points, soup.points.size() - n);
    EXPECT_GT(domain.report().number_of_reversed_triangles, 0u);
    EXPECT_TRUE(domain.report().is_manifold());
    EXPECT_EQ(domain.report().number_of_boundary_cycles, 0u);
    const auto d = distances<GP::Exact>(domain, soup.points.size(), source);
    for(std::size_t i = 0; i < d.size(); ++i)
      EXPECT_NEAR(d[i] / scale, expected[vertex[i]], 1e-7); // about 50 edges, each changed by 1e-9
  }
}

TEST(Soup_domain, distances_continue_at_split_edge_with_bounded_error)
{
  // Three half planes that meet at the x-axis, each a grid. The shortest path between two points
  // of different half planes is a segment after both are unfolded to one plane.
  const int columns = 8, rows = 4;
  for(const int refinement : {1, 2, 4})
  {
    const int m = columns * refinement, k = rows * refinement;
    const double h = 1. / refinement; // length of an edge
    Soup soup;
    const auto point = [&](int sheet, int i, int j)
    { return std::size_t(j == 0 ? i : (m + 1) * (1 + sheet * k + j - 1) + i); };
    soup.points.resize(std::size_t((m + 1) * (1 + 3 * k)));
    for(int sheet = 0; sheet < 3; ++sheet)
    {
      const double angle = 2. * CGAL_PI / 3. * sheet;
      for(int j = 0; j <= k; ++j)
        for(int i = 0; i <= m; ++i)
          soup.points[point(sheet, i, j)] =
              Point_3(h * i, h * j * std::cos(angle), h * j * std::sin(angle));
      for(int j = 0; j < k; ++j)
        for(int i = 0; i < m; ++i)
          soup.polygons.push_back({point(sheet, i, j), point(sheet, i + 1, j),
                                   point(sheet, i + 1, j + 1), point(sheet, i, j + 1)});
    }
    const auto domain = GP::make_domain(soup.points, soup.polygons);
    EXPECT_EQ(domain.report().number_of_split_edges, std::size_t(m));
    EXPECT_EQ(domain.report().number_of_nonmanifold_points, std::size_t(m + 1));
    EXPECT_EQ(domain.report().number_of_components, 3u);
    EXPECT_EQ(domain.report().number_of_triangulated_polygons, soup.polygons.size());
    // The source (2, 2) of sheet 0
    const auto d =
        distances<GP::Exact>(domain, soup.points.size(), point(0, 2 * refinement, 2 * refinement));
    for(int i = 0; i <= m; ++i)
      for(int j = 1; j <= k; ++j)
      {
        const double exact = std::hypot(h * i - 2., h * j + 2.), found = d[point(1, i, j)];
        EXPECT_GE(found, exact - 1e-12); // round-off errors of lengths up to 10
        EXPECT_LE(found, exact + h);
        EXPECT_NEAR(found, d[point(2, i, j)], 1e-12); // by symmetry
      }
  }
}

TEST(Soup_domain, path_crosses_nonmanifold_vertex)
{
  // Two triangles that share a vertex.
  const std::vector<Point_3> points = {{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}};
  const std::vector<std::vector<int>> triangles = {{0, 2, 1}, {0, 4, 3}};
  const auto domain = GP::make_domain(points, triangles);
  EXPECT_EQ(domain.report().number_of_nonmanifold_points, 1u);
  EXPECT_EQ(domain.report().number_of_boundary_cycles, 2u);
  const auto path = GP::geodesic_path(domain, Vertex(1), Vertex(3));
  EXPECT_NEAR(path.length, 2. * std::sqrt(2.), 1e-15); // two edges
  EXPECT_EQ(domain.mesh().degree(Vertex(0)), 4u);
}

TEST(Soup_domain, keeps_its_mesh_and_data_alive)
{
  const Soup soup = soup_of(icosphere(1));
  std::optional<GP::Geodesic_distance_solver<Mesh>> solver;
  {
    const auto domain = GP::make_domain(soup.points, soup.polygons);
    const GP::Soup_domain<Point_3> copy = domain;
    EXPECT_EQ(&copy.mesh(), &domain.mesh());
    solver.emplace(copy);
  }
  solver->compute(Vertex(0));
  EXPECT_EQ(solver->distance(Vertex(0)), 0.);
  EXPECT_GT(solver->distance(Vertex(1)), 0.);
}

TEST(Soup_domain, names_polygon_of_each_face)
{
  // Two squares and a degenerate polygon between them.
  const std::vector<Point_3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                       {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  const std::list<std::vector<unsigned>> polygons = {{0, 1, 2, 3}, {2, 2, 1}, {1, 4, 5, 2}};
  const auto domain = GP::make_domain(points, polygons);
  EXPECT_EQ(domain.report().number_of_degenerate_faces, 1u);
  ASSERT_EQ(domain.mesh().number_of_faces(), 4u);
  for(const Face face : domain.mesh().faces())
  {
    const Point_3 p = domain.point({face, {0.25, 0.25, 0.5}});
    EXPECT_EQ(domain.polygon(face), p.x() < 1. ? 0u : 2u);
  }
}

TEST(Soup_domain, of_remeshing_and_atlas_refer_to_its_mesh)
{
  // A sphere in which three triangles meet at one edge.
  Triangulation surface = icosphere(2);
  const std::size_t n = surface.points.size();
  surface.points.push_back({2., 0., 0.});
  surface.corners.insert(surface.corners.end(), {surface.corners[0], surface.corners[1], Index(n)});
  const Soup soup = soup_of(surface);
  const auto domain = GP::make_domain(soup.points, soup.polygons);
  EXPECT_EQ(domain.report().number_of_split_edges, 1u);

  Mesh output;
  auto location = output.add_property_map<Vertex, GP::Location<Mesh>>("v:location").first;
  GP::geodesic_delaunay_remeshing(
      domain, 50, output, GP::parameters::location_map(location).number_of_relaxation_steps(0));
  ASSERT_GE(output.number_of_vertices(), 50u);
  for(const Vertex v : output.vertices())
    // Round-off errors of coordinates up to two
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(output.point(v), domain.point(location[v]))), 0.,
                1e-12);

  Mesh mesh = domain.mesh();
  const std::array<double, 2> unset = {-1., -1.};
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, std::array<double, 2>>("h:uv", unset).first;
  GP::texture_atlas(domain, 50, uv);
  for(const Face face : mesh.faces())
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(face), mesh))
      for(const double x : uv[h])
        EXPECT_TRUE(x >= 0. && x <= 1.);
}

struct Sample
{
  double x, y, z;
  int color;
};
struct Sample_map
{
  using key_type = Sample;
  using value_type = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;
  friend value_type get(const Sample_map&, const Sample& s) { return {s.x, s.y, s.z}; }
};

TEST(Soup_domain, reads_points_of_any_type_by_point_map)
{
  const std::vector<Sample> samples = {{0, 0, 0, 1}, {3, 0, 0, 2}, {0, 4, 0, 3}};
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 2}};
  const auto domain = GP::make_domain(samples, triangles, GP::parameters::point_map(Sample_map()));
  std::vector<double> d(3);
  GP::geodesic_distances(domain, CGAL::SM_Vertex_index(1), CGAL::make_property_map(d));
  EXPECT_EQ(d, (std::vector<double>{3., 0., 5.}));
}

TEST(Soup_domain, of_random_polygons_is_accepted)
{
  std::mt19937 random(3);
  for(int round = 0; round < 100; ++round)
  {
    Soup soup;
    for(int i = 0; i < 8; ++i)
      soup.points.emplace_back(random() % 1000 / 1e3, random() % 1000 / 1e3, random() % 1000 / 1e3);
    soup.polygons.resize(1 + round / 4);
    for(auto& polygon : soup.polygons)
      for(std::size_t k = random() % 5; k > 0; --k)
        polygon.push_back(random() % 8);
    const auto domain = GP::make_domain(soup.points, soup.polygons);
    const Mesh& mesh = domain.mesh();
    ASSERT_EQ(mesh.number_of_vertices(), 8u);
    for(const auto h : mesh.halfedges())
    {
      EXPECT_EQ(mesh.prev(mesh.next(h)), h);
      EXPECT_EQ(mesh.target(h), mesh.source(mesh.next(h)));
    }
    for(const Face face : mesh.faces())
      EXPECT_EQ(mesh.degree(face), 3u);
    const auto d = distances<GP::Exact>(domain, 8, 0), e = distances<GP::Dijkstra>(domain, 8, 0);
    EXPECT_EQ(d[0], 0.);
    for(std::size_t i = 0; i < 8; ++i)
    {
      EXPECT_LE(d[i], e[i] + 1e-12); // round-off errors of a sum of at most seven lengths
      EXPECT_EQ(d[i] < infinity, e[i] < infinity);
    }
  }
}

TEST(Soup_domain, without_points_or_polygons_is_accepted)
{
  const std::vector<std::vector<int>> no_polygons;
  const auto empty = GP::make_domain(std::vector<Point_3>(), no_polygons);
  EXPECT_EQ(empty.number_of_vertices(), 0u);
  const auto domain = GP::make_domain(std::vector<Point_3>{{0, 0, 0}, {1, 0, 0}}, no_polygons);
  EXPECT_EQ(distances<GP::Exact>(domain, 2, 1), (std::vector<double>{infinity, 0.}));
}

TEST(Soup_domain, rejects_invalid_input)
{
  const std::vector<Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  using Polygons = std::vector<std::vector<int>>;
  EXPECT_THROW(GP::make_domain(points, Polygons{{0, 1, 3}}), GP::Invalid_argument_error);
  EXPECT_THROW(GP::make_domain(points, Polygons{{0, 1, -1}}), GP::Invalid_argument_error);
  EXPECT_THROW(GP::make_domain(points, Polygons{{0, 1, 2}}, GP::parameters::merge_tolerance(-1.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::make_domain(std::vector<Point_3>{{0, std::nan(""), 0}}, Polygons()),
               GP::Invalid_argument_error);
  // A vertex of another mesh
  const auto domain = GP::make_domain(points, Polygons{{0, 1, 2}});
  EXPECT_THROW(distances<GP::Exact>(domain, 3, 5), GP::Invalid_argument_error);
}

} // namespace soup_domain_test
