// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/reconstruction.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

// Gaps are closed by the search over all triangulations. CGAL need not instantiate the others.
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = Exact_predicates_inexact_constructions_kernel;
using Face = std::array<std::size_t, 3>;

// Limit of the number of triangles that the front can evaluate. Clean clouds need 30 to 60
// evaluations per surfel, noise at least 110. On noise, the front starts thousands of components,
// and evaluates all triangles before each.
constexpr double base_query_limit = 2e5, queries_per_surfel = 60.;

// Larger boundary cycles are never closed.
constexpr std::size_t max_number_of_gap_edges = 16;
// Boundary cycles with at most this number of edges are closed regardless of the circumradii: their
// diameter is at most three edges of small triangles. Random samples of a surface have one such
// cycle in about 10,000 surfels.
constexpr std::size_t always_closed_gap_edges = 6;
// The sine of 20 degrees. Let the angle of a normal be measured from the plane of the triangle. A
// triangle is admitted if no normal of its corners is below -20 degrees and at least one is above
// 20 degrees, for one of both orientations. The tolerance admits the mean normals at creases.
constexpr double normal_sine_tolerance = 0.34;

// Returns the minimum and the maximum of the products of the triangle's unit normal with the
// normals of its corners.
std::pair<double, double> normal_cosine_range(const Surface_arrays& t, const Face& face)
{
  const Vec3& origin = t.point[face[0]];
  const Vec3 normal = unit(cross(t.point[face[1]] - origin, t.point[face[2]] - origin));
  const auto [min_cosine, max_cosine] =
      std::minmax({dot(t.normal[face[0]], normal), dot(t.normal[face[1]], normal),
                   dot(t.normal[face[2]], normal)});
  return {min_cosine, max_cosine};
}

// Returns true if the circumradius of a triangle is at most `max_circumradius_ratio` times the
// smallest radius of its corners.
bool is_small(const Surfel_arrays& surfels, const Face& face)
{
  const std::vector<Vec3>& point = surfels.arrays.point;
  const Vec3 &p = point[face[0]], &q = point[face[1]], &r = point[face[2]];
  const double radius =
      std::min({surfels.radius[face[0]], surfels.radius[face[1]], surfels.radius[face[2]]});
  return norm(q - p) * norm(r - q) * norm(p - r) <=
         2. * max_circumradius_ratio * radius * norm(cross(q - p, r - p));
}

// The priority of a triangle in the advancing front: the radius of its smallest empty sphere, or
// infinity if the triangle is not admissible.
struct Triangle_priority
{
  const Surfel_arrays* surfels;
  double* remaining_queries;

  template <typename Advancing_front, typename Cell_handle>
  double operator()(const Advancing_front& front, const Cell_handle& cell, int index) const
  {
    if(--*remaining_queries < 0.)
      throw Unsupported_surface_error(
          "The cloud is too noisy: the surface through its surfels has too many components.");
    const double size = front.smallest_radius_delaunay_sphere(cell, index);
    // The triangulation has auxiliary vertices that are not surfels.
    if(!(size < infinity))
      return infinity;
    const Face face = {cell->vertex((index + 1) & 3)->info(), cell->vertex((index + 2) & 3)->info(),
                       cell->vertex((index + 3) & 3)->info()};
    const auto [min_cosine, max_cosine] = normal_cosine_range(surfels->arrays, face);
    const bool is_in_sheet =
        (min_cosine >= -normal_sine_tolerance && max_cosine > normal_sine_tolerance) ||
        (max_cosine <= normal_sine_tolerance && min_cosine < -normal_sine_tolerance);
    return is_in_sheet && is_small(*surfels, face) ? size : infinity;
  }
};

// Returns the vertices of all corners (3 #triangles).
std::vector<Index> corners_of(const std::vector<Face>& faces)
{
  std::vector<Index> result;
  for(const Face& face : faces)
    for(const std::size_t v : face)
      result.push_back(Index(v));
  return result;
}

// Flips each component whose sum of normal products over all triangles is negative. The sums are
// taken in the order of the faces, so that they do not depend on the orientation.
void orient(const Surface_arrays& t, std::vector<Face>& faces)
{
  const std::vector<Index> twins = twins_of_soup(t.number_of_vertices(), corners_of(faces));
  std::vector<bool> is_reached(faces.size(), false);
  std::vector<Index> component;
  for(Index seed = 0; seed < faces.size(); ++seed)
  {
    if(is_reached[seed])
      continue;
    component = {seed};
    is_reached[seed] = true;
    for(std::size_t i = 0; i < component.size(); ++i)
      for(Index h = 3 * component[i]; h < 3 * component[i] + 3; ++h)
        if(const Index twin = twins[h]; twin != none && !is_reached[twin / 3])
        {
          is_reached[twin / 3] = true;
          component.push_back(twin / 3);
        }
    std::sort(component.begin(), component.end());
    double cosine_sum = 0.;
    for(const Index face : component)
    {
      const auto [min_cosine, max_cosine] = normal_cosine_range(t, faces[face]);
      cosine_sum += min_cosine + max_cosine;
    }
    if(cosine_sum < 0.)
      for(const Index face : component)
        std::swap(faces[face][0], faces[face][1]);
  }
}

// Returns the boundary cycles with at most `max_number_of_gap_edges` edges. The vertices of a
// cycle are in the order in which new triangles inside the gap must traverse them.
std::vector<std::vector<Index>> find_gaps(std::size_t number_of_vertices,
                                          const std::vector<Face>& faces)
{
  const std::vector<Index> corners = corners_of(faces);
  const std::vector<Index> twins = twins_of_soup(number_of_vertices, corners);
  std::vector<Index> next(number_of_vertices, none); // along the boundary, against the halfedges
  for(Index h = 0; h < corners.size(); ++h)
    if(twins[h] == none)
      next[corners[next_halfedge(h)]] = corners[h];
  std::vector<std::vector<Index>> result;
  std::vector<Index> gap;
  for(Index begin = 0; begin < number_of_vertices; ++begin)
  {
    gap.clear();
    for(Index v = begin; v != none && gap.size() < max_number_of_gap_edges;)
    {
      gap.push_back(v);
      v = std::exchange(next[v], none);
      if(v == begin)
      {
        result.push_back(gap);
        break;
      }
    }
  }
  return result;
}

using Edge = std::array<std::size_t, 2>; // sorted vertices

// Calls use(edge) for the three edges of a face.
template <typename Use>
void for_each_edge(const Face& face, const Use& use)
{
  for(int k = 0; k < 3; ++k)
    use(Edge{std::min(face[k], face[(k + 1) % 3]), std::max(face[k], face[(k + 1) % 3])});
}

// Closes small gaps by triangulations with the smallest maximum dihedral angle, then minimum area.
// A gap is only closed if all new triangles are small and agree with the normals. Their edges must
// not exist already, except on the boundary cycle.
void close_gaps(const Surfel_arrays& surfels, const std::vector<Kernel::Point_3>& points,
                std::vector<Face>& faces)
{
  std::set<Edge> edges;
  for(const Face& face : faces)
    for_each_edge(face, [&](const Edge& edge) { edges.insert(edge); });
  for(const std::vector<Index>& gap : find_gaps(points.size(), faces))
  {
    std::vector<Kernel::Point_3> boundary_loop;
    for(const Index v : gap)
      boundary_loop.push_back(points[v]);
    std::vector<Triple<int, int, int>> triples;
    Polygon_mesh_processing::triangulate_hole_polyline(
        boundary_loop, std::back_inserter(triples),
        CGAL::parameters::use_delaunay_triangulation(false));
    std::vector<Face> new_faces;
    std::size_t number_of_existing_edges = 0; // at most those of the boundary cycle
    for(const auto& triple : triples)
    {
      new_faces.push_back({gap[triple.first], gap[triple.second], gap[triple.third]});
      for_each_edge(new_faces.back(),
                    [&](const Edge& edge) { number_of_existing_edges += edges.count(edge); });
    }
    const bool is_in_surface =
        std::all_of(new_faces.begin(), new_faces.end(),
                    [&](const Face& face)
                    {
                      return (gap.size() <= always_closed_gap_edges || is_small(surfels, face)) &&
                             normal_cosine_range(surfels.arrays, face).second > 0.;
                    });
    if(number_of_existing_edges > gap.size() || !is_in_surface)
      continue;
    for(const Face& face : new_faces)
      for_each_edge(face, [&](const Edge& edge) { edges.insert(edge); });
    faces.insert(faces.end(), new_faces.begin(), new_faces.end());
  }
}

// Returns the points of the tree, randomly displaced in their tangent planes by up to 5e-5 radii.
// So no four points are cocircular: the front orders equal triangles by their addresses, which
// would make the result nondeterministic.
std::vector<Kernel::Point_3> in_general_position(const Surfel_arrays& surfels)
{
  const Surface_arrays& t = surfels.arrays;
  std::mt19937 random;
  const auto random_offset = [&] { return 1e-4 * (double(random()) / double(random.max()) - 0.5); };
  std::vector<Kernel::Point_3> result;
  for(std::size_t i = 0; i < surfels.tree.size(); ++i)
  {
    const auto [u, v] = tangent_frame(t.normal[i]);
    const double a = random_offset() * surfels.radius[i], b = random_offset() * surfels.radius[i];
    const Vec3 p = t.point[i] + a * u + b * v;
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

// Returns true if all points lie on one line, or if there are no points.
bool are_collinear(const std::vector<Kernel::Point_3>& points)
{
  const auto other = std::find_if(points.begin(), points.end(),
                                  [&](const Kernel::Point_3& p) { return p != points.front(); });
  return other == points.end() || std::all_of(other, points.end(),
                                              [&](const Kernel::Point_3& p)
                                              { return collinear(points.front(), *other, p); });
}

} // namespace

Mesh_arrays reconstruct_surface(const Surfel_arrays& surfels)
{
  const Surface_arrays& t = surfels.arrays;
  std::vector<Kernel::Point_3> points;
  for(std::size_t v = 0; v < surfels.tree.size(); ++v)
    points.emplace_back(t.point[v][0], t.point[v][1], t.point[v][2]);
  std::vector<Face> faces;
  double query_limit = base_query_limit + queries_per_surfel * double(points.size());
  if(!are_collinear(points)) // CGAL prints a message for collinear points
  {
    const std::vector<Kernel::Point_3> perturbed_points = in_general_position(surfels);
    advancing_front_surface_reconstruction(perturbed_points.begin(), perturbed_points.end(),
                                           std::back_inserter(faces),
                                           Triangle_priority{&surfels, &query_limit});
  }
  // The order and the orientation of the output depend on addresses. Sort the faces first by their
  // vertices, then, once they are oriented, by their corners.
  const auto vertices_of = [](Face face)
  {
    std::sort(face.begin(), face.end());
    return face;
  };
  std::sort(faces.begin(), faces.end(),
            [&](const Face& a, const Face& b) { return vertices_of(a) < vertices_of(b); });
  orient(t, faces);
  for(Face& face : faces)
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  std::sort(faces.begin(), faces.end());
  close_gaps(surfels, points, faces);
  std::vector<std::array<double, 3>> positions;
  for(const Vec3& p : t.point)
    positions.push_back(t.origin + t.scale * p);
  const std::vector<Index> corners = corners_of(faces);
  return build_mesh_arrays(std::move(positions), corners,
                           twins_of_soup(t.number_of_vertices(), corners));
}

} // namespace CGAL::Geodesic_processing::internal
