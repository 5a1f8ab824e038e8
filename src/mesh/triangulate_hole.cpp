// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/triangulate_hole.h>

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Delaunay triangulations need exact predicates.
using Hole_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Hole_mesh = CGAL::Surface_mesh<Hole_point>;
using Hole_halfedge = Hole_mesh::Halfedge_index;
using Hole_vertex = Hole_mesh::Vertex_index;

// The search over all triangulations takes cubic time: 0.1 s for 200 edges.
constexpr std::size_t max_edges_for_cubic_search = 200;
// The Delaunay triangulation of some boundary cycles has quadratic size.
constexpr std::size_t max_edges_for_delaunay = 1000;
// The recursion depth of the function that creates the triangles equals the number of edges.
constexpr std::size_t max_edges_for_projection = 5000;

struct Out_of_steps
{};

// Stops the search if it exceeds a limit of steps. A step takes about 0.1 microseconds. An edge of
// the Delaunay triangulation counts as 100 steps. A typical boundary cycle of n edges has 4 n
// Delaunay edges; the maximum is about n^2 / 2.
struct Step_limit_visitor : CGAL::Polygon_mesh_processing::Hole_filling::Default_visitor
{
  double* steps_left;

  explicit Step_limit_visitor(double& steps) : steps_left(&steps) {}
  void quadratic_step() const { consume(100.); }
  void start_cubic_phase(int steps) const { consume(steps); }

private:
  void consume(double steps) const
  {
    if(steps > *steps_left)
      throw Out_of_steps();
    *steps_left -= steps;
  }
};

// Returns the points divided by a power of two, so that products of coordinates do not overflow.
std::vector<Hole_point> scaled_points(const std::vector<Vec3>& points, int exponent)
{
  std::vector<Hole_point> result;
  for(const Vec3& p : points)
    result.emplace_back(std::ldexp(p[0], -exponent), std::ldexp(p[1], -exponent),
                        std::ldexp(p[2], -exponent));
  return result;
}

int exponent_of(const std::vector<Vec3>& points)
{
  double largest = 0.;
  for(const Vec3& p : points)
    for(const double x : p)
      largest = std::max(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

// Returns the halfedge from point i to point i + 1 of the boundary in the following mesh.
Hole_halfedge boundary_halfedge(const Hole_mesh& mesh, std::size_t i)
{
  return mesh.halfedge(Hole_mesh::Edge_index(static_cast<Hole_mesh::size_type>(3 * i)));
}

// Builds a mesh with the edges that the search considers: the boundary of the hole, one triangle at
// each edge of it, and the existing edges, which have no faces. Vertex i is point i.
Hole_mesh mesh_around(const Hole_boundary& hole)
{
  const std::size_t n = hole.points.size();
  const int exponent = exponent_of(hole.points);
  Hole_mesh mesh;
  for(const auto& points : {&hole.points, &hole.apexes})
    for(const Hole_point& p : scaled_points(*points, exponent))
      mesh.add_vertex(p);
  const auto vertex = [](std::size_t i) { return Hole_vertex(Hole_mesh::size_type(i)); };
  const auto edge = [&](std::size_t from, std::size_t to)
  {
    const Hole_halfedge h = mesh.add_edge(vertex(from), vertex(to));
    mesh.set_halfedge(vertex(to), h);
    return h;
  };
  std::vector<Hole_halfedge> boundary, to_apex, from_apex;
  for(std::size_t i = 0; i < n; ++i)
  {
    boundary.push_back(edge(i, (i + 1) % n));
    to_apex.push_back(edge(i, n + i));
    from_apex.push_back(edge(n + i, (i + 1) % n));
    const auto face = mesh.add_face();
    const Hole_halfedge cycle[] = {mesh.opposite(boundary[i]), to_apex[i], from_apex[i]};
    for(std::size_t k = 0; k < 3; ++k)
    {
      mesh.set_face(cycle[k], face);
      mesh.set_next(cycle[k], cycle[(k + 1) % 3]);
    }
    mesh.set_halfedge(face, cycle[0]);
  }
  // The last halfedge without a face that ends at each vertex. Existing edges follow each other
  // between the triangles at the vertex.
  std::vector<Hole_halfedge> last;
  for(std::size_t i = 0; i < n; ++i)
  {
    mesh.set_next(boundary[i], boundary[(i + 1) % n]);
    mesh.set_next(mesh.opposite(from_apex[i]), mesh.opposite(to_apex[i]));
    mesh.set_halfedge(vertex(i), boundary[(i + n - 1) % n]);
    mesh.set_halfedge(vertex(n + i), mesh.opposite(from_apex[i]));
    last.push_back(mesh.opposite(to_apex[i]));
  }
  for(const auto& [i, j] : hole.edges)
    if(i < j)
    {
      const Hole_halfedge h = edge(i, j);
      mesh.set_halfedge(vertex(j), boundary[(j + n - 1) % n]);
      mesh.set_next(last[i], h);
      mesh.set_next(last[j], mesh.opposite(h));
      last[i] = mesh.opposite(h);
      last[j] = h;
    }
  for(std::size_t i = 0; i < n; ++i)
    mesh.set_next(last[i], mesh.opposite(from_apex[(i + n - 1) % n]));
  return mesh;
}

} // namespace

Hole_triangles checked_triangles(const Hole_boundary& hole, Hole_triangles triangles)
{
  const int exponent = exponent_of(hole.points);
  const std::vector<Hole_point> points = scaled_points(hole.points, exponent);
  for(const auto& triangle : triangles)
  {
    if(CGAL::collinear(points[triangle[0]], points[triangle[1]], points[triangle[2]]))
      return {};
    for(std::size_t k = 0; k < 3; ++k)
      if(std::binary_search(hole.edges.begin(), hole.edges.end(),
                            std::array{triangle[k], triangle[(k + 1) % 3]}))
        return {};
  }
  return triangles;
}

Hole_triangles triangulate_hole(const Hole_boundary& hole, double& steps_left)
{
  const std::size_t n = hole.points.size();
  if(n < 3 || n > max_edges_for_projection)
    return {};
  Hole_mesh mesh = mesh_around(hole);
  // The search must start at an edge of positive length. If the first and last points are equal, it
  // assumes that the first vertex is repeated.
  Hole_halfedge start = Hole_mesh::null_halfedge();
  for(std::size_t i = n; i-- > 0 && start == Hole_mesh::null_halfedge();)
    if(hole.points[i] != hole.points[(i + 1) % n])
      start = boundary_halfedge(mesh, i);
  if(start == Hole_mesh::null_halfedge())
    return {};
  std::vector<Hole_mesh::Face_index> faces;
  const Step_limit_visitor visitor(steps_left);
  const bool has_steps = steps_left > 0.;
  try
  {
    CGAL::Polygon_mesh_processing::triangulate_hole(
        mesh, start, std::back_inserter(faces),
        CGAL::parameters::visitor(visitor)
            .use_2d_constrained_delaunay_triangulation(n > max_edges_for_cubic_search)
            .use_delaunay_triangulation(n <= max_edges_for_delaunay && has_steps)
            .do_not_use_cubic_algorithm(n > max_edges_for_cubic_search || !has_steps));
  }
  catch(const Out_of_steps&)
  {
    steps_left = 0.;
    return {};
  }
  Hole_triangles triangles;
  for(const auto face : faces)
  {
    const Hole_halfedge h = mesh.halfedge(face);
    triangles.push_back({static_cast<Index>(mesh.source(h).idx()),
                         static_cast<Index>(mesh.target(h).idx()),
                         static_cast<Index>(mesh.target(mesh.next(h)).idx())});
  }
  return triangles;
}

} // namespace CGAL::Geodesic_processing::internal
