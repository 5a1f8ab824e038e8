// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/Log_engine.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "log_map/base_refinement.h"
#include "log_map/gradient_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns a single source at a location.
std::vector<Front_source> point_source(const Surface_location& at) { return {Front_source{{at}}}; }

using Engine = std::variant<Gradient_engine, Exact_log_engine, Discrete_exponential_engine>;

Engine make_engine(const Log_kind& kind, std::shared_ptr<const Surface_arrays> triangles)
{
  switch(kind.method)
  {
  case Log_method::exact:
    return Engine(std::in_place_type<Exact_log_engine>, std::move(triangles));
  case Log_method::discrete_exponential:
    return Engine(std::in_place_type<Discrete_exponential_engine>, std::move(triangles));
  default:
    return Engine(std::in_place_type<Gradient_engine>, kind.distances, std::move(triangles));
  }
}

// On spheres of 2,562 vertices, no error decreases further after 100 steps; see the benchmark
// `logmap`.
constexpr std::size_t max_smoothing_steps = 1000;
// With eight refinements, the mesh around the stencil has 4^8 times as many faces.
constexpr std::size_t max_base_refinements = 8;
// Width in edge lengths of the ring of shorter edges around the stencil. On a sphere of 2,562
// vertices with noise of 5 % of an edge length, the error of fast marching with three refinements
// is 1.5, 1.2 and 0.9 degrees for widths of 2, 4 and 8, and 3.4 degrees without refinements. A
// further refinement costs about as much as the width of 8 and has an error of 1.1 degrees.
constexpr double refinement_margin = 4.;

// Computes distances from single locations, on the surface of an engine or on a refinement of it.
// Locations, vertices and lengths are those of the surface before it is refined.
class Point_distances
{
public:
  explicit Point_distances(Distance_engine& engine) : m_engine(engine) {}
  Point_distances(Distance_engine& engine, const Base_refinement& refinement)
      : m_engine(engine), m_refinement(&refinement), m_unit(refinement.unit_size())
  {}

  // Returns the locations that run() accepts. O(#triangles) if the surface is refined.
  std::vector<Surface_location> sources(const std::vector<Surface_location>& locations) const
  {
    return m_refinement ? to_fine(m_refinement->refinement, locations) : locations;
  }

  void run(const Surface_location& source, double maximum_distance)
  {
    Front_limits limits;
    limits.maximum_distance = maximum_distance / m_unit;
    m_engine.run(point_source(source), limits);
  }

  std::vector<Index> reached() const
  {
    if(!m_refinement)
      return m_engine.reached();
    std::vector<Index> result;
    for(const Index fine : m_engine.reached())
      if(const Index vertex = m_refinement->coarse_vertex[fine]; vertex != none)
        result.push_back(vertex);
    return result;
  }

  double distance(Index vertex) const
  {
    if(!m_refinement)
      return m_engine.distance(vertex);
    return m_unit * m_engine.distance(m_refinement->fine_vertex[vertex]);
  }

private:
  Distance_engine& m_engine;
  const Base_refinement* m_refinement = nullptr;
  double m_unit = 1.;
};

} // namespace

Gradient_engine::Gradient_engine(Distance_method method,
                                 std::shared_ptr<const Surface_arrays> triangles)
    : m_method(method), m_triangles(triangles), m_engine(method, std::move(triangles))
{}

void Gradient_engine::run(const Tangent_plane& plane, const Log_map_options& options,
                          const Log_visitor& visit)
{
  const Surface_arrays& t = *m_triangles;
  const double edge_length = mean_edge_length(t, plane.location());
  const double length = options.stencil_length > 0. ? options.stencil_length
                                                    : stencil_length_ratio(plane) * edge_length;
  std::optional<Base_refinement> refinement;
  std::optional<Distance_engine> refined_engine;
  if(options.number_of_base_refinements > 0)
  {
    refinement =
        refine_around_base(m_triangles, plane.location(), length, refinement_margin * edge_length,
                           options.number_of_base_refinements);
    refined_engine.emplace(m_method, refinement->refinement.triangles);
  }
  Point_distances from =
      refinement ? Point_distances(*refined_engine, *refinement) : Point_distances(m_engine);

  from.run(from.sources({plane.location()}).front(), options.maximum_distance);
  const std::vector<Index> vertices = from.reached();
  std::vector<double> distances;
  for(const Index vertex : vertices)
    distances.push_back(from.distance(vertex));

  const Stencil stencil = make_stencil(plane, vertices, distances, length, options.stencil_size);
  const std::size_t size = stencil.locations.size();
  const std::vector<Surface_location> sources = from.sources(stencil.locations);
  std::vector<double> stencil_distances(vertices.size() * size);
  for(std::size_t j = 0; j < size; ++j)
  {
    from.run(sources[j], options.maximum_distance + length);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      stencil_distances[i * size + j] = from.distance(vertices[i]);
  }
  const Log_map_fit fit(stencil.vectors);
  std::vector<Vec2> vectors;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    vectors.push_back(fit.gradient(distances[i], stencil_distances.data() + i * size));
  if(options.number_of_smoothing_steps > 0)
    smooth_gradients(t, vertices, distances, options.number_of_smoothing_steps, vectors);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    visit(vertices[i], Log_map_fit::with_length(vectors[i], distances[i]));
}

// Returns the length of the stencil divided by the mean length of the edges around the base point.
//
// A longer stencil averages the errors of the distances, but is more affected by curvature. The
// best ratio is proportional to one over the square root of the mean angle between adjacent
// normals. On a sphere of 10,000 vertices, the error of tangent vectors is 0.044 %, and 0.11 %
// with a ratio of 0.6. On the armadillo of 26,000 vertices, a rough mesh, the median error of
// directions is 0.92 degrees; it is 0.87 degrees with a ratio of 0.6, and 1.4 degrees with twice
// the length. On a cloud, the stencil must reach surfels in all directions.
double Gradient_engine::stencil_length_ratio(const Tangent_plane& plane) const
{
  if(m_triangles->is_cloud())
    return 2.5;
  return std::clamp(0.35 / std::sqrt(mean_normal_angle(*m_triangles, plane.location())), 0.6, 4.);
}

// Returns a straightest stencil on a mesh, and a stencil of surfels on a cloud.
Stencil Gradient_engine::make_stencil(const Tangent_plane& plane,
                                      const std::vector<Index>& vertices,
                                      const std::vector<double>& distances, double length,
                                      std::size_t size) const
{
  return m_triangles->is_cloud()
             ? vertex_stencil(*m_triangles, plane, vertices, distances, length, size)
             : straightest_stencil(plane, length, size);
}

Exact_log_engine::Exact_log_engine(std::shared_ptr<const Surface_arrays> triangles)
    : m_windows(std::move(triangles))
{}

void Exact_log_engine::run(const Tangent_plane& plane, const Log_map_options& options,
                           const Log_visitor& visit)
{
  Front_limits limits;
  limits.maximum_distance = options.maximum_distance;
  m_windows.run(point_source(plane.location()), limits);
  for(const Index vertex : m_windows.reached())
  {
    const double angle = plane.tangent_angle(m_windows.polar_angle_of_departure(vertex));
    visit(vertex, m_windows.distance(vertex) * Vec2{std::cos(angle), std::sin(angle)});
  }
}

Discrete_exponential_engine::Discrete_exponential_engine(
    std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(triangles), m_front(std::move(triangles), Front_kind::dijkstra),
      m_vectors(m_triangles->number_of_vertices())
{}

void Discrete_exponential_engine::run(const Tangent_plane& plane, const Log_map_options& options,
                                      const Log_visitor& visit)
{
  Front_limits limits;
  limits.maximum_distance = options.maximum_distance;
  m_front.run(point_source(plane.location()), limits);
  for(const Index vertex : m_front.reached())
    m_vectors[vertex] = {std::numeric_limits<double>::quiet_NaN(), 0.};
  for(const Index vertex : m_front.reached())
  {
    accumulate_steps(plane, vertex);
    visit(vertex, m_vectors[vertex]);
  }
}

// Computes the vectors of a vertex and of all its predecessors.
void Discrete_exponential_engine::accumulate_steps(const Tangent_plane& plane, Index vertex)
{
  const Surface_arrays& t = *m_triangles;
  std::vector<Index> path; // from the vertex back to the first one with a known vector
  for(; vertex != none && std::isnan(m_vectors[vertex][0]); vertex = m_front.predecessor(vertex))
    path.push_back(vertex);
  for(; !path.empty(); path.pop_back())
  {
    const Index next = path.back();
    m_vectors[next] = vertex == none
                          ? transported_step(plane, plane.normal(), t.point[next] - plane.point())
                          : m_vectors[vertex] + transported_step(plane, vertex_normal(t, vertex),
                                                                 t.point[next] - t.point[vertex]);
    vertex = next;
  }
}

Log_engine::Log_engine(const Log_kind& kind, std::shared_ptr<const Surface_arrays> triangles)
    : m_is_cloud(triangles->is_cloud()), m_engine(make_engine(kind, std::move(triangles)))
{}

void Log_engine::check(const Log_map_options& options) const
{
  if(options.number_of_smoothing_steps > max_smoothing_steps)
    throw Invalid_argument_error("The number of smoothing steps must be at most 1000.");
  if(options.number_of_base_refinements > max_base_refinements)
    throw Invalid_argument_error("The number of base refinements must be at most 8.");
  const bool is_gradient = std::holds_alternative<Gradient_engine>(m_engine);
  if(options.number_of_smoothing_steps > 0 && !is_gradient)
    throw Unsupported_surface_error(
        "Smoothing requires the method Gradient, because other methods have no distance maps.");
  if(options.number_of_base_refinements > 0 && !is_gradient)
    throw Unsupported_surface_error("Base refinements require the method Gradient.");
  if(options.number_of_base_refinements > 0 && m_is_cloud)
    throw Unsupported_surface_error("Base refinements require a mesh, whose edges are split.");
}

void Log_engine::run(const Tangent_plane& plane, const Log_map_options& options,
                     const Log_visitor& visit)
{
  std::visit([&](auto& engine) { engine.run(plane, options, visit); }, m_engine);
}

} // namespace CGAL::Geodesic_processing::internal
