// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/split_at_isolines.h>

#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/isolines.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

namespace split_at_isolines_test {

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace GP::test;
using Edge = Mesh::Edge_index;
using Areas = std::map<std::size_t, double>; // by label

// Round-off errors of coordinates of order one; measured are at most 2e-15.
constexpr double round_off = 1e-13;
constexpr std::size_t no_label = std::numeric_limits<std::size_t>::max();

// A split mesh with all outputs.
struct Split
{
  Mesh mesh;
  Mesh::Property_map<Face, std::size_t> label =
      mesh.add_property_map<Face, std::size_t>("f:label").first;
  Mesh::Property_map<Edge, bool> is_isoline =
      mesh.add_property_map<Edge, bool>("e:is_isoline").first;
  Mesh::Property_map<Vertex, GP::Location<Mesh>> location =
      mesh.add_property_map<Vertex, GP::Location<Mesh>>("v:location").first;

  Areas areas() const
  {
    Areas result;
    for(const Face f : mesh.faces())
      result[label[f]] += PMP::face_area(f, mesh);
    return result;
  }
};

template <typename Surface, typename ValueMap>
void split_at(const Surface& surface, ValueMap values, const std::vector<double>& isovalues,
              Split& split, bool do_fit_circles = false)
{
  GP::split_at_isolines(surface, values, isovalues, split.mesh, split.label,
                        GP::parameters::do_fit_circles(do_fit_circles)
                            .edge_is_constrained_map(split.is_isoline)
                            .location_map(split.location));
}

template <typename TriangleMesh>
long euler_characteristic(const TriangleMesh& mesh)
{
  return long(num_vertices(mesh)) - long(num_edges(mesh)) + long(num_faces(mesh));
}

TEST(split_at_isolines, strips_of_square_have_exact_areas)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Mesh mesh = mesh_of(scaled(square(12, 0.2), scale));
    auto x = vertex_map(mesh);
    for(const Vertex v : mesh.vertices())
      x[v] = mesh.point(v).x();
    Split split;
    split_at(mesh, x, {0.7 * scale, 0.2 * scale}, split);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
    EXPECT_TRUE(CGAL::is_triangle_mesh(split.mesh));
    EXPECT_EQ(euler_characteristic(split.mesh), 1);
    Areas areas = split.areas();
    EXPECT_EQ(areas.size(), 3u);
    EXPECT_NEAR(areas[0] / scale / scale, 0.2, round_off);
    EXPECT_NEAR(areas[1] / scale / scale, 0.5, round_off);
    EXPECT_NEAR(areas[2] / scale / scale, 0.3, round_off);
    // The vertices of the mesh come first, in their order.
    for(const Vertex v : mesh.vertices())
      EXPECT_LT(distance(to_array(split.mesh.point(v)), to_array(mesh.point(v))),
                round_off * scale);
    // Isolines have the isovalues, and each divides a length of one.
    double length = 0.;
    for(const Edge e : split.mesh.edges())
      if(split.is_isoline[e])
      {
        length += PMP::edge_length(e, split.mesh);
        for(int i = 0; i < 2; ++i)
        {
          const double value = split.mesh.point(split.mesh.vertex(e, i)).x() / scale;
          EXPECT_LT(std::min(std::abs(value - 0.2), std::abs(value - 0.7)), round_off);
        }
      }
    EXPECT_NEAR(length, 2. * scale, round_off * scale);
  }
}

TEST(split_at_isolines, edges_on_isolines_have_their_length)
{
  Mesh mesh = mesh_of(icosphere(3));
  auto values = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    values[v] = mesh.point(v).x() * mesh.point(v).y();
  const std::vector<double> isovalues = {-0.3, 0.1, 0.25};
  std::vector<GP::Isoline<Mesh>> lines;
  GP::isolines(mesh, values, isovalues, std::back_inserter(lines));
  std::map<double, double> expected, found;
  for(const auto& line : lines)
    expected[line.value] += line.length;
  Split split;
  split_at(mesh, values, isovalues, split);
  for(const Vertex v : split.mesh.vertices())
    EXPECT_LT(distance(to_array(split.mesh.point(v)), point_of(mesh, split.location[v])),
              round_off);
  for(const Edge e : split.mesh.edges())
  {
    const auto h = split.mesh.halfedge(e);
    const std::size_t left = split.label[split.mesh.face(h)],
                      right = split.label[split.mesh.face(split.mesh.opposite(h))];
    // No vertex has an isovalue: isolines are the boundaries between labels.
    EXPECT_EQ(split.is_isoline[e], left != right);
    if(left != right)
      found[isovalues[std::min(left, right)]] += PMP::edge_length(e, split.mesh);
  }
  ASSERT_EQ(found.size(), 3u);
  for(const auto& [value, length] : expected)
    EXPECT_NEAR(found[value], length, round_off);
}

// With circles, the part of the plane within a distance is an inscribed polygon of a disk.
TEST(split_at_isolines, disks_around_point_are_inscribed_polygons)
{
  Mesh mesh = mesh_of(square(40, 0.2));
  const Vertex center(20 * 41 + 20);
  auto distance_map = vertex_map(mesh);
  GP::geodesic_distances(mesh, center, distance_map);
  Split split;
  split_at(mesh, distance_map, {0.15, 0.35}, split, true);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
  double longest = 0.;
  for(const Edge e : split.mesh.edges())
    if(split.is_isoline[e])
    {
      longest = std::max(longest, PMP::edge_length(e, split.mesh));
      for(int i = 0; i < 2; ++i)
      {
        const double radius = distance(to_array(split.mesh.point(split.mesh.vertex(e, i))),
                                       to_array(mesh.point(center)));
        EXPECT_LT(std::min(std::abs(radius - 0.15), std::abs(radius - 0.35)), round_off);
      }
    }
  Areas areas = split.areas();
  // Segments of length c cut off at most a fraction of c^2 / (6 r^2) of a disk of radius r.
  const double disks[2] = {areas[0], areas[0] + areas[1]}, radii[2] = {0.15, 0.35};
  for(int i = 0; i < 2; ++i)
  {
    const double full = pi * radii[i] * radii[i];
    EXPECT_LE(disks[i], full * (1. + round_off));
    EXPECT_GE(disks[i], full - pi * longest * longest / 5.9);
  }
  EXPECT_NEAR(disks[1] + areas[2], 1., round_off);
}

TEST(split_at_isolines, caps_of_sphere_have_known_areas)
{
  const std::vector<double> radii = {0.5, 1.2, 2.2};
  for(const unsigned level : {3u, 4u})
  {
    Mesh mesh = mesh_of(icosphere(level));
    auto distance_map = vertex_map(mesh);
    GP::geodesic_distances(mesh, Vertex(0), distance_map);
    Split split;
    split_at(mesh, distance_map, radii, split, true);
    Areas areas = split.areas();
    ASSERT_EQ(areas.size(), 4u);
    const double h = 1.33 / double(1u << level); // more than the longest edge
    for(std::size_t i = 0; i < 4; ++i)
    {
      const double begin = i == 0 ? 0. : radii[i - 1], end = i == 3 ? pi : radii[i];
      // The error of the distance, 0.5 h^2 as in the test of isolines(), moves both isolines, and
      // the inscribed polyhedron has a smaller area.
      EXPECT_NEAR(areas[i] / (2. * pi * (std::cos(begin) - std::cos(end))), 1., 2. * h * h);
    }
  }
}

TEST(split_at_isolines, unreached_faces_are_not_labeled)
{
  Mesh mesh = mesh_of(disjoint_union(square(20, 0.2), tetrahedron()));
  auto distance_map = vertex_map(mesh);
  GP::geodesic_distances(mesh, Vertex(0), distance_map, GP::parameters::maximum_distance(0.5));
  distance_map[Vertex(21 * 3 + 3)] = std::nan("");
  Split split;
  split_at(mesh, distance_map, {0.2, 0.4, 0.9}, split);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(split.mesh));
  EXPECT_EQ(euler_characteristic(split.mesh), euler_characteristic(mesh));
  double area = 0.;
  for(const auto& [label, part] : split.areas())
  {
    EXPECT_TRUE(label <= 2 || label == no_label);
    area += part;
  }
  EXPECT_NEAR(area, PMP::area(mesh), round_off * area);
  EXPECT_GT(split.areas()[no_label], 1.); // in particular the tetrahedron
}

TEST(split_at_isolines, keeps_isolated_vertices)
{
  Mesh mesh;
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(5., 5., 5.));
  mesh += mesh_of(square(2));
  auto x = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    x[v] = mesh.point(v).x();
  Split split;
  split_at(mesh, x, {0.25}, split);
  EXPECT_TRUE(split.mesh.is_isolated(isolated));
  EXPECT_EQ(split.mesh.point(isolated), mesh.point(isolated));
  EXPECT_EQ(split.location[isolated].first, Mesh::null_face());
  EXPECT_EQ(split.mesh.number_of_vertices(), 10u + 5u);
}

template <typename TriangleMesh>
void expect_bands_of_sphere(double tolerance)
{
  const Triangulation surface = icosphere(2);
  Numbered<TriangleMesh> numbered;
  fill(numbered, surface);
  using Graph = boost::graph_traits<TriangleMesh>;
  std::map<typename Graph::vertex_descriptor, double> heights;
  for(std::size_t i = 0; i < surface.points.size(); ++i)
    heights[numbered.vertices[i]] = surface.points[i][2];
  TriangleMesh split;
  std::map<typename Graph::face_descriptor, std::size_t> label;
  GP::split_at_isolines(numbered.mesh, boost::make_assoc_property_map(heights),
                        std::vector<double>{-0.5, 0.1, 0.7}, split,
                        boost::make_assoc_property_map(label));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split));
  EXPECT_TRUE(CGAL::is_closed(split));
  EXPECT_EQ(euler_characteristic(split), 2);
  const auto points = get(CGAL::vertex_point, split);
  const double levels[] = {-1., -0.5, 0.1, 0.7, 1.};
  double area = 0., expected = 0.;
  for(const auto f : faces(split))
  {
    area += CGAL::to_double(PMP::face_area(f, split));
    for(const auto v : CGAL::vertices_around_face(halfedge(f, split), split))
    {
      EXPECT_GE(CGAL::to_double(get(points, v)[2]), levels[label.at(f)] - tolerance);
      EXPECT_LE(CGAL::to_double(get(points, v)[2]), levels[label.at(f) + 1] + tolerance);
    }
  }
  for(const auto f : faces(numbered.mesh))
    expected += CGAL::to_double(PMP::face_area(f, numbered.mesh));
  EXPECT_NEAR(area, expected, tolerance * expected);
}

TEST(split_at_isolines, accepts_all_mesh_types)
{
  expect_bands_of_sphere<Mesh>(round_off);
  expect_bands_of_sphere<CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>>(
      round_off);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  // Its coordinates are of type float.
  expect_bands_of_sphere<OpenMesh::TriMesh_ArrayKernelT<>>(1e-6);
#endif
}

TEST(split_at_isolines, accepts_soups)
{
  // A soup of single triangles
  const Triangulation surface = icosphere(2);
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> polygons;
  for(std::size_t c = 0; c < surface.corners.size(); ++c)
  {
    const Point& p = surface.points[surface.corners[c]];
    points.emplace_back(p[0], p[1], p[2]);
    if(c % 3 == 2)
      polygons.push_back({c - 2, c - 1, c});
  }
  const auto domain = GP::make_domain(points, polygons, GP::parameters::merge_tolerance(0.));
  std::map<Vertex, double> heights;
  for(const Vertex v : domain.mesh().vertices())
    heights[v] = domain.mesh().point(v).z();
  Split split;
  split_at(domain, boost::make_assoc_property_map(heights), {0.1, 0.7}, split);
  EXPECT_TRUE(CGAL::is_closed(split.mesh));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
  const Areas areas = split.areas();
  EXPECT_EQ(areas.size(), 3u);
  double area = 0.;
  for(const auto& [label, part] : areas)
    area += part;
  EXPECT_NEAR(area, PMP::area(mesh_of(surface)), round_off * area);
}

TEST(split_at_isolines, keeps_vertices_with_several_fans)
{
  // Two squares that share a corner, on an isoline
  Triangulation pair = square(4);
  const Index shared = 24, first = Index(pair.points.size());
  const Triangulation other = square(4);
  for(std::size_t i = 1; i < other.points.size(); ++i)
    pair.points.push_back({other.points[i][0] + 1., other.points[i][1] + 1., 0.});
  for(const Index corner : other.corners)
    pair.corners.push_back(corner == 0 ? shared : first + corner - 1);
  Mesh mesh = mesh_of(pair);
  auto values = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    values[v] = mesh.point(v).x();
  Split split;
  split_at(mesh, values, {0.6, 1., 1.4}, split);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
  EXPECT_EQ(euler_characteristic(split.mesh), 1);
  const double expected[] = {0.6, 0.4, 0.4, 0.6};
  Areas areas = split.areas();
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(areas[i], expected[i], round_off);
}

TEST(split_at_isolines, keeps_faces_with_the_same_vertices)
{
  Mesh mesh = mesh_of({{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {0, 1, 2, 0, 2, 1}});
  auto x = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    x[v] = mesh.point(v).x();
  Split split;
  split_at(mesh, x, {0.5}, split);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
  EXPECT_TRUE(CGAL::is_closed(split.mesh));
  EXPECT_EQ(euler_characteristic(split.mesh), 2);
  Areas areas = split.areas();
  EXPECT_NEAR(areas[0], 0.75, round_off);
  EXPECT_NEAR(areas[1], 0.25, round_off);
}

TEST(split_at_isolines, adds_to_the_output)
{
  Mesh mesh = mesh_of(square(4, 0.2));
  auto values = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    values[v] = mesh.point(v).y();
  Split split;
  // Without isovalues the result is a copy.
  split_at(mesh, values, {}, split);
  EXPECT_EQ(split.mesh.number_of_vertices(), 25u);
  EXPECT_EQ(split.mesh.number_of_faces(), 32u);
  split_at(mesh, values, {0.3}, split);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split.mesh));
  Areas areas = split.areas();
  EXPECT_NEAR(areas[0], 1.3, round_off);
  EXPECT_NEAR(areas[1], 0.7, round_off);
}

TEST(split_at_isolines, throws_on_invalid_isovalues)
{
  Mesh mesh = mesh_of(square(2));
  Split split;
  for(const double value : {double(infinity), std::nan("")})
    EXPECT_THROW(split_at(mesh, vertex_map(mesh), {0., value}, split), GP::Invalid_argument_error);
  EXPECT_TRUE(split.mesh.is_empty());
  split_at(Mesh(), vertex_map(mesh), {1.}, split);
  EXPECT_TRUE(split.mesh.is_empty());
}

} // namespace split_at_isolines_test
