// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Intrinsic_triangulation.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include "core/edges.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Edges are flipped if the opposite angles sum to more than pi by this angle. Fronts are inaccurate
// on needles and caps, not on triangles that are nearly Delaunay. On 47 scans, patches and CAD
// models with 10 sources, no mean or largest error is more than 2 % larger than without flips. With
// 10 degrees, the mean error is 7 % larger on one of them; with 20, the largest one is 33 % larger
// on another.
constexpr double usual_flip_tolerance = 18. * pi / 180.;
// The tolerance on meshes with large triangles. On 610 public meshes, mostly CAD models, the
// largest error was at most 5 % on 581; with 15 degrees on 579, and with 20 on 576.
constexpr double flip_tolerance_for_large_triangles = 10. * pi / 180.;
// Triangles with long edges cover at least this share of the area of such a mesh. With half of it
// and twice of it, the geometric means of the errors on the 47 meshes differ by less than 1 %.
constexpr double min_share_of_large_triangles = 0.1;
// Edges are bisected if they are longer than this multiple of the root of the area per vertex;
// edges of equilateral triangles have 1.07. Fronts are inaccurate on triangles that are much
// larger than the mean. On 70 public meshes that were bisected before the flips, the largest error
// was at most 5 % on 57 % of them without bisections; on 94 % with 4, and the time grew to 1.4
// (median); on 99 % with 3 and 1.8; and on 99 % with 2 and 3.1.
constexpr double max_relative_edge_length = 3.;
// No edge is bisected if none is longer than this. Meshes of uniformly stretched triangles keep
// their vertices: on one of them, bisections took a front 2.3 times as long.
constexpr double min_longest_edge_length = 5.;
// The area per vertex is that of a mesh with at least this number of vertices. With 1000, the
// front is slower than exact distances on many meshes of less than 100 vertices.
constexpr double min_number_of_vertices = 500.;
// The triangulation has at most this multiple of the same number of vertices. This limits the time
// on needles, whose edges are all long: a front on a cylinder of 18,000 vertices takes 2.6 times as
// long as fast marching, and many times as long with a multiple of 8. The errors on public meshes
// are equal.
constexpr double max_refinement = 2.;

// The history of the flips takes 48 bytes for each of them. On 60 scans and CAD models there
// are at most 1.3 flips per halfedge, and 4.3 on a model of needles.
constexpr std::size_t max_flips_per_halfedge = 8;

double number_of_vertices_for_area(const Surface_arrays& mesh)
{
  return std::max(double(mesh.number_of_vertices()), min_number_of_vertices);
}

double triangle_area(const Surface_arrays& mesh, Index triangle)
{
  const Index h = 3 * triangle;
  return twice_area(mesh.length[h], mesh.length[h + 1], mesh.length[h + 2]) / 2.;
}

double longest_edge(const Surface_arrays& mesh, Index triangle)
{
  const Index h = 3 * triangle;
  return std::max({mesh.length[h], mesh.length[h + 1], mesh.length[h + 2]});
}

// Which edges of a mesh are flipped and bisected.
struct Limits
{
  double flip_tolerance;
  double max_length; // of edges; infinity if no edge is bisected
};

Limits limits(const Surface_arrays& mesh)
{
  double area = 0., longest = 0.;
  for(Index t = 0; t < mesh.number_of_triangles(); ++t)
  {
    area += triangle_area(mesh, t);
    longest = std::max(longest, longest_edge(mesh, t));
  }
  const double unit = std::sqrt(area / number_of_vertices_for_area(mesh));
  if(!(longest > min_longest_edge_length * unit))
    return {usual_flip_tolerance, infinity};
  double area_of_large_triangles = 0.;
  for(Index t = 0; t < mesh.number_of_triangles(); ++t)
    if(longest_edge(mesh, t) > min_longest_edge_length * unit)
      area_of_large_triangles += triangle_area(mesh, t);
  const bool has_large_triangles = area_of_large_triangles >= min_share_of_large_triangles * area;
  return {has_large_triangles ? flip_tolerance_for_large_triangles : usual_flip_tolerance,
          max_relative_edge_length * unit};
}

// The weights of a location in a triangle with an edge that is flipped: of the ends of the edge and
// of the third vertex.
struct Edge_weights
{
  double a, b, third;
};

Edge_weights weights_at_edge(const Edge_flip& flip, Index triangle,
                             const std::array<double, 3>& weights)
{
  if(triangle == flip.halfedge / 3)
    return {weights[flip.halfedge % 3], weights[next_halfedge(flip.halfedge) % 3],
            weights[previous_halfedge(flip.halfedge) % 3]};
  return {weights[next_halfedge(flip.twin) % 3], weights[flip.twin % 3],
          weights[previous_halfedge(flip.twin) % 3]};
}

// Returns a function that is linear in the location, positive on the side of b of the diagonal cd,
// and negative on the side of a.
double side_of_diagonal(const Edge_flip& flip, const Edge_weights& weights)
{
  return weights.b * (1. - flip.on_edge) - weights.a * flip.on_edge;
}

// Returns a point of a segment, in barycentric coordinates.
std::array<double, 3> interpolated(const std::array<double, 3>& begin,
                                   const std::array<double, 3>& end, double parameter)
{
  std::array<double, 3> result;
  for(int k = 0; k < 3; ++k)
    result[k] = (1. - parameter) * begin[k] + parameter * end[k];
  return result;
}

} // namespace

Intrinsic_triangulation::Intrinsic_triangulation(const Surface_arrays& mesh,
                                                 Bisected_edges bisected)
{
  const auto [flip_tolerance, max_length] = limits(mesh);
  const bool is_bisected = bisected != Bisected_edges::none && max_length < infinity;
  if(!is_bisected && is_delaunay(mesh, flip_tolerance))
    return;
  auto triangles = std::make_shared<Surface_arrays>(mesh);
  append(flip_to_delaunay(*triangles, flip_tolerance, max_flips_per_halfedge));
  std::size_t number_of_vertices = mesh.number_of_vertices();
  if(is_bisected)
  {
    std::vector<Bisection> bisections;
    number_of_vertices = bisect_long_edges(
        *triangles, number_of_vertices, max_length,
        std::size_t(max_refinement * number_of_vertices_for_area(mesh)), bisections);
    append(bisections);
    append(flip_to_delaunay(*triangles, flip_tolerance, max_flips_per_halfedge));
  }
  triangles->point.clear(); // an edge is not a segment in space
  triangles->point.shrink_to_fit();
  build_rings(*triangles, number_of_vertices);
  m_triangles = std::move(triangles);
  link_steps(mesh.number_of_triangles());
  find_removed_edges(mesh);
}

void Intrinsic_triangulation::append(const std::vector<Edge_flip>& flips)
{
  for(const Edge_flip& flip : flips)
    m_steps.push_back({flip, false, {none, none}});
}

void Intrinsic_triangulation::append(const std::vector<Bisection>& bisections)
{
  for(const auto& [halfedge, new_triangle] : bisections)
    m_steps.push_back({{halfedge, 3 * new_triangle + halfedge % 3, 0.5, 0.}, true, {none, none}});
}

// Finds the first step of each triangle of the mesh, and the next ones of the triangles of a step.
void Intrinsic_triangulation::link_steps(std::size_t number_of_triangles)
{
  m_first_step.assign(m_triangles->number_of_triangles(), none);
  for(Index i = Index(m_steps.size()); i-- > 0;)
  {
    const Index triangles_of_step[2] = {m_steps[i].flip.halfedge / 3, m_steps[i].flip.twin / 3};
    for(const int k : {0, 1})
      m_steps[i].next[k] = std::exchange(m_first_step[triangles_of_step[k]], i);
  }
  m_first_step.resize(number_of_triangles);
}

void Intrinsic_triangulation::find_removed_edges(const Surface_arrays& mesh)
{
  const Index n = Index(mesh.number_of_vertices());
  // The length of the shortest edge between the current vertex and each of its neighbors.
  std::vector<double> length(m_triangles->number_of_vertices(), infinity);
  m_removed_begin.reserve(n + 1);
  for(Index vertex = 0; vertex < n; ++vertex)
  {
    m_removed_begin.push_back(Index(m_removed_edges.size()));
    const auto is_changed = [&](Index corner) { return m_first_step[corner / 3] != none; };
    const auto ring = mesh.ring.begin();
    if(std::none_of(ring + mesh.ring_begin[vertex], ring + mesh.ring_begin[vertex + 1], is_changed))
      continue;
    for_each_edge(*m_triangles, nullptr, vertex,
                  [&](Index end, double l) { length[end] = std::min(length[end], l); });
    for_each_edge(mesh, nullptr, vertex,
                  [&](Index end, double l)
                  {
                    if(length[end] <= l)
                      return;
                    m_removed_edges.push_back({end, l});
                    length[end] = l; // an edge of two triangles is visited twice
                  });
    if(m_removed_begin.back() < m_removed_edges.size())
      m_vertices_with_removed_edges.push_back(vertex);
    for(const Surface_arrays* const t : {&mesh, m_triangles.get()})
      for_each_edge(*t, nullptr, vertex, [&](Index end, double) { length[end] = infinity; });
  }
  m_removed_begin.push_back(Index(m_removed_edges.size()));
}

// Returns a function that is linear in the location and at least zero beyond the new edge of a
// step.
double Intrinsic_triangulation::side(const Step& step, Index triangle,
                                     const std::array<double, 3>& weights)
{
  const Edge_flip& flip = step.flip;
  if(step.is_bisection)
    return weights[next_halfedge(flip.halfedge) % 3] - weights[flip.halfedge % 3];
  return side_of_diagonal(flip, weights_at_edge(flip, triangle, weights));
}

// Moves a location over a flip. It is moved to the triangle at b, if it is beyond the diagonal as
// seen from a, or to that at a. Its weights there follow from the crossing x of edge and diagonal:
// a is a combination of x and b, and x one of c and d.
Intrinsic_triangulation::Place
Intrinsic_triangulation::follow_flip(const Step& step, Index triangle, bool is_beyond,
                                     std::array<double, 3>& weights) const
{
  const Edge_flip& flip = step.flip;
  const auto [a, b, third] = weights_at_edge(flip, triangle, weights);
  const double replaced = is_beyond ? a : b, kept = is_beyond ? b : a;
  const double fraction = is_beyond ? 1. - flip.on_edge : flip.on_edge;
  const double crossing = replaced > 0. ? replaced / fraction : 0.;
  const double weight_of_kept = std::max(0., kept - (crossing - replaced));
  const double third_of_c = triangle == flip.halfedge / 3 ? third : 0.;
  const double weight_of_c = crossing * (1. - flip.on_diagonal) + third_of_c,
               weight_of_d = crossing * flip.on_diagonal + (third - third_of_c);
  const Index h = is_beyond ? flip.halfedge : flip.twin;
  weights[h % 3] = is_beyond ? weight_of_c : weight_of_d;
  weights[next_halfedge(h) % 3] = is_beyond ? weight_of_d : weight_of_c;
  weights[previous_halfedge(h) % 3] = weight_of_kept;
  return {h / 3, step.next[is_beyond ? 0 : 1]};
}

// Moves a location over the next step. Of a bisection, the triangle beyond is that at b: there a
// is twice the midpoint minus b.
Intrinsic_triangulation::Place Intrinsic_triangulation::follow(const Place& place, bool is_beyond,
                                                               std::array<double, 3>& weights) const
{
  const Step& step = m_steps[place.next_step];
  if(!step.is_bisection)
    return follow_flip(step, place.triangle, is_beyond, weights);
  double &a = weights[step.flip.halfedge % 3], &b = weights[next_halfedge(step.flip.halfedge) % 3];
  if(!is_beyond)
  {
    a = std::max(0., a - b);
    b *= 2.;
    return {step.flip.halfedge / 3, step.next[0]};
  }
  b = std::max(0., b - a);
  a *= 2.;
  return {step.flip.twin / 3, step.next[1]};
}

Surface_location Intrinsic_triangulation::locate(const Surface_location& location) const
{
  if(location.triangle == none)
    return vertex_location(*m_triangles, location.vertex);
  Place place = first_place(location.triangle);
  std::array<double, 3> weights = location.barycentric;
  while(place.next_step != none)
  {
    const bool is_beyond = side(m_steps[place.next_step], place.triangle, weights) >= 0.;
    place = follow(place, is_beyond, weights);
  }
  return canonical(*m_triangles, {place.triangle, none, weights});
}

std::vector<Intrinsic_triangulation::Segment>
Intrinsic_triangulation::locate_segment(Index triangle, const std::array<double, 3>& begin,
                                        const std::array<double, 3>& end) const
{
  struct Piece
  {
    Place place;
    std::array<double, 3> begin, end;
  };
  std::vector<Segment> result;
  std::vector<Piece> stack = {{first_place(triangle), begin, end}};
  while(!stack.empty())
  {
    Piece piece = stack.back();
    stack.pop_back();
    if(piece.place.next_step == none)
    {
      result.emplace_back(canonical(*m_triangles, {piece.place.triangle, none, piece.begin}),
                          canonical(*m_triangles, {piece.place.triangle, none, piece.end}));
      continue;
    }
    const Step& step = m_steps[piece.place.next_step];
    const double at_begin = side(step, piece.place.triangle, piece.begin),
                 at_end = side(step, piece.place.triangle, piece.end);
    const auto push = [&](bool is_beyond, std::array<double, 3> from, std::array<double, 3> to)
    {
      follow(piece.place, is_beyond, from);
      const Place place = follow(piece.place, is_beyond, to);
      stack.push_back({place, from, to});
    };
    if((at_begin >= 0. && at_end >= 0.) || (at_begin <= 0. && at_end <= 0.))
    {
      push(at_begin + at_end >= 0., piece.begin, piece.end);
      continue;
    }
    const auto crossing = interpolated(piece.begin, piece.end, at_begin / (at_begin - at_end));
    push(at_begin > 0., piece.begin, crossing);
    push(at_end > 0., crossing, piece.end);
  }
  return result;
}

std::shared_ptr<const Intrinsic_triangulation>
shared_intrinsic_triangulation(const Surface_arrays& mesh, Bisected_edges bisected)
{
  const std::lock_guard<std::mutex> lock(mesh.shared.mutex);
  auto& stored = mesh.shared.intrinsic_triangulations[bisected == Bisected_edges::none ? 0 : 1];
  std::shared_ptr<const Intrinsic_triangulation> result = stored.lock();
  if(!result)
    stored = result = std::make_shared<const Intrinsic_triangulation>(mesh, bisected);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
