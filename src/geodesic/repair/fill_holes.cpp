// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/fill_holes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace program {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Halfedge = Mesh::Halfedge_index;
using Vertex = Mesh::Vertex_index;
// Delaunay triangulations need exact predicates.
using Exact_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

// The search over all triangulations takes cubic time: 0.1 s for 200 edges.
constexpr std::size_t max_edges_for_cubic_search = 200;
// The Delaunay triangulation of some boundary cycles has quadratic size.
constexpr std::size_t max_edges_for_delaunay = 1000;
// The recursion depth of the function that creates the triangles equals the number of edges.
constexpr std::size_t max_edges_for_planar = 5000;

struct Out_of_steps
{};

// Stops the search if all holes together exceed a limit of steps. A step takes about 0.1
// microseconds. An edge of the Delaunay triangulation counts as 100 steps. A typical boundary
// cycle of n edges has 4 n Delaunay edges; the maximum is about n^2 / 2.
struct Step_limit_visitor : PMP::Hole_filling::Default_visitor
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

struct Hole
{
  Halfedge last;
  std::size_t number_of_edges = 0;
};

// Returns the next boundary halfedge in the same fan of triangles.
Halfedge next_in_fan(const Mesh& mesh, Halfedge h)
{
  do
    h = mesh.prev(mesh.opposite(h));
  while(!mesh.is_border(mesh.opposite(h)));
  return mesh.opposite(h);
}

// Splits the boundary into cycles that visit each vertex at most once, and returns them as holes.
// At vertices with several fans, each cycle stays in its fan, so that parts that only touch are
// not connected. If a cycle revisits a vertex, the halfedges between the two visits become a
// separate cycle.
std::vector<Hole> split_boundaries(Mesh& mesh)
{
  std::vector<Hole> holes;
  std::vector<bool> is_visited(mesh.num_halfedges(), false);
  std::vector<std::size_t> position(mesh.num_vertices(),
                                    0); // in `boundary`, 1-based; 0: not visited
  std::vector<Halfedge> boundary;
  for(const Halfedge begin : mesh.halfedges())
  {
    if(!mesh.is_border(begin) || is_visited[begin])
      continue;
    for(Halfedge h = begin; !is_visited[h];)
    {
      is_visited[h] = true;
      const Halfedge next = next_in_fan(mesh, h);
      const std::size_t previous_position = position[mesh.target(h)];
      boundary.push_back(h);
      if(previous_position == 0)
      {
        position[mesh.target(h)] = boundary.size();
        mesh.set_next(h, next);
      }
      else
      {
        const Halfedge first = boundary[previous_position - 1];
        holes.push_back({h, boundary.size() - previous_position});
        mesh.set_next(h, mesh.next(first));
        mesh.set_next(first, next);
        for(; boundary.size() > previous_position; boundary.pop_back())
          if(boundary.back() != h)
            position[mesh.target(boundary.back())] = 0;
      }
      h = next;
    }
    holes.push_back({boundary.back(), boundary.size()});
    for(; !boundary.empty(); boundary.pop_back())
      position[mesh.target(boundary.back())] = 0;
  }
  return holes;
}

// Returns whether the hole is the boundary of an isolated triangle.
bool is_component_of_one_triangle(const Mesh& mesh, const Hole& hole)
{
  const Halfedge inner = mesh.opposite(hole.last);
  return hole.number_of_edges == 3 && mesh.is_border(mesh.opposite(mesh.next(inner))) &&
         mesh.is_border(mesh.opposite(mesh.prev(inner)));
}

// Returns an edge of positive length, or the null halfedge if all vertices coincide. The search
// must start there. If the first and last points are equal, it assumes that the first vertex is
// repeated.
template <typename Points>
Halfedge find_nondegenerate_edge(const Mesh& mesh, const Points& points, const Hole& hole)
{
  Halfedge h = hole.last;
  for(std::size_t i = 0; i < hole.number_of_edges; ++i, h = mesh.next(h))
    if(get(points, mesh.source(h)) != get(points, mesh.target(h)))
      return h;
  return Mesh::null_halfedge();
}

// Returns the points divided by a power of two, so that products of coordinates do not overflow.
Mesh::Property_map<Vertex, Exact_point> scaled_points(Mesh& mesh)
{
  double largest = 0.;
  for(const Kernel::Point_3& p : mesh.points())
    for(int c = 0; c < 3; ++c)
      largest = std::max(largest, std::abs(p[c]));
  int exponent = 0;
  std::frexp(largest, &exponent);
  const auto scaled = [exponent](double x) { return std::ldexp(x, -exponent); };
  const auto result = mesh.add_property_map<Vertex, Exact_point>("v:scaled_point").first;
  for(const Vertex v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    result[v] = {scaled(p.x()), scaled(p.y()), scaled(p.z())};
  }
  return result;
}

} // namespace

Hole_filling_result fill_holes(Mesh& mesh, std::size_t max_edges)
{
  std::vector<Hole> holes = split_boundaries(mesh);
  // Small holes are filled first, so that a large hole does not exhaust their steps.
  std::stable_sort(holes.begin(), holes.end(),
                   [](const Hole& a, const Hole& b)
                   { return a.number_of_edges < b.number_of_edges; });
  auto points = scaled_points(mesh);
  // Sufficient if half of the vertices are on typical boundary cycles.
  double steps = 1e7 + 500. * static_cast<double>(mesh.number_of_vertices());
  const Step_limit_visitor step_visitor(steps);
  Hole_filling_result result;
  for(const Hole& hole : holes)
  {
    if(hole.number_of_edges > max_edges)
      continue;
    std::vector<Mesh::Face_index> faces;
    const Halfedge start = find_nondegenerate_edge(mesh, points, hole);
    if(start != Mesh::null_halfedge() && hole.number_of_edges >= 3 &&
       hole.number_of_edges <= max_edges_for_planar && !is_component_of_one_triangle(mesh, hole))
      try
      {
        PMP::triangulate_hole(
            mesh, start, std::back_inserter(faces),
            CGAL::parameters::vertex_point_map(points)
                .visitor(step_visitor)
                .use_2d_constrained_delaunay_triangulation(hole.number_of_edges >
                                                           max_edges_for_cubic_search)
                .use_delaunay_triangulation(hole.number_of_edges <= max_edges_for_delaunay &&
                                            steps > 0.)
                .do_not_use_cubic_algorithm(hole.number_of_edges > max_edges_for_cubic_search ||
                                            steps <= 0.));
      }
      catch(const Out_of_steps&)
      {
        steps = 0.;
      }
    ++(faces.empty() ? result.number_of_left : result.number_of_filled);
  }
  mesh.remove_property_map(points);
  return result;
}

} // namespace program
