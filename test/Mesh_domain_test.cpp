// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Mesh_domain.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include "meshes.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <limits>

namespace Mesh_domain_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Checks that the domain of a mesh equals the triangulation: vertices at its points, triangles at
// its faces.
// tolerance  the precision of coordinates
template <typename Mesh>
void expect_domain(const Triangulation& surface, double tolerance)
{
  Numbered<Mesh> mesh;
  fill(mesh, surface);
  const Mesh_domain<Mesh> domain(mesh.mesh);
  const internal::Surface_arrays& t = *domain.triangles();
  ASSERT_EQ(domain.number_of_vertices(), surface.points.size());
  ASSERT_EQ(t.number_of_triangles(), mesh.faces.size());
  std::size_t boundary_halfedges = 0;
  for(const internal::Index twin : t.twin)
    boundary_halfedges += twin == none;
  std::size_t bgl_border_halfedges = 0;
  for(const auto h : halfedges(mesh.mesh))
    bgl_border_halfedges += CGAL::is_border(h, mesh.mesh);
  EXPECT_EQ(boundary_halfedges, bgl_border_halfedges);
  for(std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const auto vertex = domain.index(mesh.vertices[i]);
    EXPECT_EQ(domain.vertex(vertex), mesh.vertices[i]);
    EXPECT_LT(
        distance(to_array(domain.point(domain.inner_vertex(mesh.vertices[i]))), surface.points[i]),
        tolerance);
  }
  std::mt19937 random(1);
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const test::Surface_location local = random_location(t, random);
    const auto location = location_in(mesh, surface, f, local.barycentric);
    const auto inner = domain.inner(location);
    EXPECT_EQ(domain.face(inner.triangle), mesh.faces[f]);
    EXPECT_EQ(domain.outer(inner), location);
    Point p = {0., 0., 0.};
    for(int k = 0; k < 3; ++k)
      for(int i = 0; i < 3; ++i)
        p[i] += local.barycentric[k] * surface.points[surface.corners[3 * f + k]][i];
    EXPECT_LT(distance(to_array(domain.point(inner)), p), tolerance);
  }
}

const Triangulation& shapes(int i)
{
  static const std::vector<Triangulation> all = {
      one_triangle(), square(7, 0.24), jittered(icosphere(2), 0.03), annulus(12, 3, 1., 2.),
      disjoint_union(square(3), tetrahedron())};
  return all[i];
}

// Round-off errors of coordinates below 4.
constexpr double rounding = 1e-14;

TEST(Mesh_domain, represents_surface_mesh)
{
  for(int i = 0; i < 5; ++i)
    expect_domain<Surface_mesh>(shapes(i), rounding);
}

TEST(Mesh_domain, represents_polyhedron)
{
  for(int i = 0; i < 5; ++i)
    expect_domain<CGAL::Polyhedron_3<Kernel>>(shapes(i), rounding);
}

TEST(Mesh_domain, accepts_exact_and_single_precision_kernels)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  for(int i = 0; i < 5; ++i)
  {
    expect_domain<CGAL::Surface_mesh<Exact::Point_3>>(shapes(i), rounding);
    // Round-off errors of single precision.
    expect_domain<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(shapes(i), 1e-6);
  }
}

#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
TEST(Mesh_domain, represents_openmesh)
{
  // Single precision.
  for(int i = 0; i < 5; ++i)
    expect_domain<OpenMesh::TriMesh_ArrayKernelT<>>(shapes(i), 1e-6);
}
#endif

TEST(Mesh_domain, skips_removed_elements)
{
  Numbered<Surface_mesh> mesh;
  const Triangulation shape = square(6, 0.24);
  fill(mesh, shape);
  for(const std::size_t f : {3u, 20u, 21u, 40u})
    CGAL::Euler::remove_face(halfedge(mesh.faces[f], mesh.mesh), mesh.mesh);
  mesh.mesh.remove_vertex(mesh.mesh.add_vertex(Kernel::Point_3(0., 0., 0.)));
  ASSERT_TRUE(mesh.mesh.has_garbage());
  const Mesh_domain<Surface_mesh> domain(mesh.mesh);
  EXPECT_EQ(domain.number_of_vertices(), mesh.mesh.number_of_vertices());
  EXPECT_EQ(domain.triangles()->number_of_triangles(), 68u);
  for(const auto vertex : mesh.mesh.vertices())
    EXPECT_EQ(domain.vertex(domain.index(vertex)), vertex);
  for(const auto face : mesh.mesh.faces())
    EXPECT_EQ(domain.face(domain.triangle(face)), face);
}

TEST(Mesh_domain, reads_vertex_point_map)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, square(4));
  auto points = mesh.mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_3>("p").first;
  for(const auto vertex : mesh.mesh.vertices())
  {
    const auto& p = mesh.mesh.point(vertex);
    points[vertex] = Kernel::Point_3(3. * p.x(), p.y(), 7.);
  }
  const Mesh_domain<Surface_mesh> domain(mesh.mesh, CGAL::parameters::vertex_point_map(points));
  for(const auto vertex : mesh.mesh.vertices())
    EXPECT_LT(
        distance(to_array(domain.point(domain.inner_vertex(vertex))), to_array(points[vertex])),
        rounding);
}

TEST(Mesh_domain, returns_points_of_locations)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Numbered<Surface_mesh> mesh;
    fill(mesh, icosphere(1));
    for(const auto v : mesh.mesh.vertices())
      mesh.mesh.point(v) = CGAL::ORIGIN + scale * (mesh.mesh.point(v) - CGAL::ORIGIN);
    const Mesh_domain<Surface_mesh> domain(mesh.mesh);
    for(const auto face : mesh.mesh.faces())
    {
      const Mesh_domain<Surface_mesh>::Location location = {face, {0.2, 0.5, 0.3}};
      const auto p = CGAL::Polygon_mesh_processing::construct_point(location, mesh.mesh);
      // A few round-off errors.
      EXPECT_LT(CGAL::squared_distance(domain.point(location), p), 1e-28 * scale * scale);
    }
    EXPECT_THROW(domain.point({Surface_mesh::null_face(), {1., 0., 0.}}), Invalid_argument_error);
  }
}

TEST(Mesh_domain, writes_values_to_matching_vertices)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, icosphere(2));
  const Mesh_domain<Surface_mesh> domain(mesh.mesh);
  auto map = mesh.mesh.add_property_map<Surface_mesh::Vertex_index, float>("value").first;
  domain.write([](internal::Index i) { return 0.5 * i; }, map);
  for(const auto vertex : mesh.mesh.vertices())
    EXPECT_EQ(map[vertex], 0.5f * domain.index(vertex));
}

template <typename T>
std::size_t bytes(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

TEST(Mesh_domain, uses_at_most_200_bytes_per_vertex)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, icosphere(5));
  const Mesh_domain<Surface_mesh> domain(mesh.mesh);
  const internal::Surface_arrays& t = *domain.triangles();
  const std::size_t triangles = bytes(t.corner) + bytes(t.twin) + bytes(t.length) +
                                bytes(t.ring_begin) + bytes(t.ring) + bytes(t.weight) +
                                bytes(t.graph.begin) + bytes(t.graph.target) +
                                bytes(t.graph.length) + bytes(t.point) + bytes(t.normal);
  // Maps from descriptors to indices and from indices to descriptors, 4 bytes per entry.
  const std::size_t descriptors = 8 * (num_vertices(mesh.mesh) + num_faces(mesh.mesh));
  EXPECT_LE(triangles + descriptors, 200 * num_vertices(mesh.mesh));
}

TEST(Mesh_domain, outlives_the_mesh)
{
  std::unique_ptr<Mesh_domain<Surface_mesh>> domain;
  {
    Numbered<Surface_mesh> mesh;
    fill(mesh, square(4));
    domain = std::make_unique<Mesh_domain<Surface_mesh>>(mesh.mesh);
  }
  EXPECT_EQ(domain->index(domain->vertex(7)), 7u);
}

TEST(Mesh_domain, throws_on_nontriangular_faces)
{
  Surface_mesh quads;
  CGAL::make_grid(3, 3, quads);
  EXPECT_THROW((Mesh_domain<Surface_mesh>(quads)), Unsupported_surface_error);
}

TEST(Mesh_domain, throws_on_nonfinite_coordinates)
{
  for(const double bad :
      {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Numbered<Surface_mesh> mesh;
    fill(mesh, tetrahedron());
    mesh.mesh.point(mesh.vertices[2]) = Kernel::Point_3(0., bad, 0.);
    EXPECT_THROW((Mesh_domain<Surface_mesh>(mesh.mesh)), Invalid_argument_error);
  }
}

TEST(Mesh_domain, throws_on_invalid_locations)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  const Mesh_domain<Surface_mesh> domain(mesh.mesh);
  using Location = Mesh_domain<Surface_mesh>::Location;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const std::array<double, 3>& bad :
      {std::array<double, 3>{0.5, 0.6, -0.1}, {0.5, 0.5, 0.5}, {nan, 0.5, 0.5}, {0., 0., 0.}})
    EXPECT_THROW(domain.inner(Location{mesh.faces[0], bad}), Invalid_argument_error);
  EXPECT_THROW(domain.inner(Location{Surface_mesh::null_face(), {1., 0., 0.}}),
               Invalid_argument_error);
  using Face = Surface_mesh::Face_index;
  using Vertex = Surface_mesh::Vertex_index;
  EXPECT_THROW(domain.inner(Location{Face(1000), {1., 0., 0.}}), Invalid_argument_error);
  EXPECT_THROW(domain.inner_vertex(Vertex(1000)), Invalid_argument_error);
  const Surface_mesh nothing;
  EXPECT_THROW(Mesh_domain<Surface_mesh>(nothing).inner_vertex(Vertex(0)), Invalid_argument_error);
  EXPECT_THROW(Mesh_domain<Surface_mesh>(nothing).inner(Location{Face(0), {1., 0., 0.}}),
               Invalid_argument_error);
  // Round-off errors in barycentric coordinates are repaired.
  EXPECT_NO_THROW(domain.inner(Location{mesh.faces[0], {0.5, 0.5 + 1e-12, -1e-12}}));
}

TEST(Mesh_domain, accepts_empty_mesh)
{
  const Mesh_domain<Surface_mesh> domain{Surface_mesh()};
  EXPECT_EQ(domain.number_of_vertices(), 0u);
}

} // namespace Mesh_domain_test
