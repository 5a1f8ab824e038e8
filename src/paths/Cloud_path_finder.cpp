// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "surfels/denoise.h"
#include <CGAL/Geodesic_processing/internal/paths/path_curve.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <cmath>
#include <mutex>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Denoising is repeated up to this number of times, until the noise level is at most this.
constexpr int max_denoising_passes = 3;
constexpr double residual_noise = 0.05;

// The maximum number of times that a path over gaps is recomputed with twice as many control
// points. A third time has no effect.
constexpr int max_refinements = 2;

// In clouds of at most this number of surfels, finding the shortest graph path takes less time than
// shortening it. No regions are used then.
constexpr std::size_t small_cloud_size = 50000;

Surfel_fit surfel_fit(Surfel_path_method method)
{
  switch(method)
  {
  case Surfel_path_method::projected_quadrics:
    return Surfel_fit::quadrics;
  case Surfel_path_method::projected_spheres:
  case Surfel_path_method::spheres:
    return Surfel_fit::spheres;
  case Surfel_path_method::robust_spheres:
    return Surfel_fit::robust_spheres;
  case Surfel_path_method::projected_planes:
  case Surfel_path_method::planes:
    return Surfel_fit::planes;
  case Surfel_path_method::disks:
    break;
  }
  return Surfel_fit::disks;
}

Path_constraint path_constraint(Surfel_path_method method)
{
  return method == Surfel_path_method::projected_quadrics ||
                 method == Surfel_path_method::projected_spheres ||
                 method == Surfel_path_method::projected_planes
             ? Path_constraint::projected
             : Path_constraint::energy;
}

// Returns the options with the constraint that follows from the method. Throws
// Invalid_argument_error if an option is invalid.
Cloud_path_options validated(Cloud_path_options options)
{
  const Path_options& path = options.path;
  if(!(path.alpha >= 0.) || !(path.beta >= 0.) || !std::isfinite(path.alpha + path.beta))
    throw Invalid_argument_error("A weight of the path energy is negative or not finite.");
  if(path.number_of_control_points == 0)
    throw Invalid_argument_error("The number of control points is zero.");
  if(!(path.tolerance >= 0.))
    throw Invalid_argument_error("The tolerance is negative or not a number.");
  options.path.constraint = path_constraint(options.method);
  options.path.do_fit_curve = options.do_enforce_guarantees;
  return options;
}

} // namespace

Fitted_cloud::Fitted_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
                           const std::vector<double>& radii, const Cloud_path_options& options)
    : m_options(validated(options)),
      m_cloud(build_cloud(std::move(points), std::move(normals), radii, options)),
      m_given_vertex(
          [&]
          {
            std::vector<Index> given_vertex;
            if(m_given_cloud.number_of_vertices() > 0)
              for(const Index surfel : m_cloud.caller_vertex)
                given_vertex.push_back(m_given_cloud.internal_vertex[surfel]);
            else
              m_coverage =
                  std::make_unique<Surfel_coverage>(m_cloud, options.cloud.number_of_threads);
            return given_vertex;
          }()),
      m_surface(m_cloud, surfel_fit(options.method), *m_coverage, m_given_vertex),
      m_disks(m_cloud, Surfel_fit::disks, *m_coverage, m_given_vertex)
{
  if(options.search == Surfel_search::coarse_to_fine &&
     m_cloud.number_of_vertices() > small_cloud_size)
    m_regions = make_regions(m_cloud.graph, m_cloud.point, m_cloud.component);
}

Surfel_cloud Fitted_cloud::build_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
                                       const std::vector<double>& radii,
                                       const Cloud_path_options& options)
{
  const unsigned number_of_threads = options.cloud.number_of_threads;
  const auto build = [&](const Frame* frame)
  { return make_cloud(std::move(points), std::move(normals), radii, options.cloud, frame); };
  check_sizes(points.size(), normals.size(), radii.size());
  if(options.noise != Surfel_noise::kept)
    m_noise = noise_level(points, normals, number_of_threads);
  const bool is_conditional = options.noise == Surfel_noise::removed_when_found;
  if(options.noise == Surfel_noise::kept || (is_conditional && m_noise < significant_noise_level))
  {
    // Coverage is defined by the graph of extended spheres with default radii.
    if(options.cloud.graph != Surfel_graph::extended_spheres || !radii.empty())
      store_given_cloud(points, normals, number_of_threads);
    return build(m_given_cloud.number_of_vertices() == 0 ? nullptr : &m_given_cloud.frame);
  }
  store_given_cloud(points, normals, number_of_threads);
  // If the noise level is high, normals are so inaccurate that one pass is not enough.
  double noise_level_left = m_noise;
  for(int i = 0; i < max_denoising_passes && (i == 0 || noise_level_left > residual_noise); ++i)
  {
    denoise(points, normals, number_of_threads);
    noise_level_left = noise_level(points, normals, number_of_threads);
  }
  limit_displacements(points, number_of_threads);
  return build(&m_given_cloud.frame);
}

void Fitted_cloud::store_given_cloud(const std::vector<Vec3>& points,
                                     const std::vector<Vec3>& normals, unsigned number_of_threads)
{
  Surfel_cloud_options default_options;
  default_options.number_of_threads = number_of_threads;
  m_given_cloud = make_cloud(points, normals, {}, default_options);
  m_coverage = std::make_unique<Surfel_coverage>(m_given_cloud, number_of_threads);
  m_given_cloud.graph = {};
}

// Limits the displacement of denoised surfels: they stay in the region covered by the given
// surfels.
void Fitted_cloud::limit_displacements(std::vector<Vec3>& points, unsigned number_of_threads) const
{
  const auto& [origin, scale] = m_given_cloud.frame;
  for_each_block(
      points.size(), surfel_block_size, number_of_threads,
      [&, &origin = origin, &scale = scale](std::size_t, std::size_t begin, std::size_t end)
      {
        for(std::size_t i = begin; i < end; ++i)
        {
          const Vec3 local_point = 1. / scale * (points[i] - origin);
          const Vec3 limited_point =
              m_coverage->clamped_to_coverage(local_point, m_given_cloud.internal_vertex[i]);
          if(limited_point != local_point)
            points[i] = origin + scale * limited_point;
        }
      });
}

Projection Fitted_cloud::project(const Tangent_location& location) const
{
  const Index vertex = location.vertex;
  if(location.offset == std::array<double, 2>{0., 0.})
    return {m_cloud.point[vertex], m_cloud.normal[vertex], {0., 0., 0.}, vertex};
  const auto [u, v] = tangent_frame(given_cloud().normal[given_vertex(vertex)]);
  const Vec3 position =
      given_cloud().point[given_vertex(vertex)] + location.offset[0] * u + location.offset[1] * v;
  Projection projection = m_surface.project(position, vertex);
  projection.point = m_surface.clamped_to_coverage(projection.point, projection.vertex);
  return projection;
}

Tangent_location Fitted_cloud::location(const Projection& projection) const
{
  const Index given_index = given_vertex(projection.vertex);
  const auto [u, v] = tangent_frame(given_cloud().normal[given_index]);
  const Vec3 offset = projection.point - given_cloud().point[given_index];
  return {projection.vertex, {dot(offset, u), dot(offset, v)}};
}

Cloud_path_finder::Cloud_path_finder(std::shared_ptr<const Fitted_cloud> cloud)
    : m_cloud(std::move(cloud)),
      m_search(m_cloud->cloud().graph, m_cloud->cloud().point, m_cloud->regions())
{}

// Replaces segments of a path that cross a gap or jump to another sheet by shortest graph paths.
// Such a segment joins two surfels between which there is no short graph path. Returns whether
// there are any.
bool Cloud_path_finder::reroute_over_gaps(Shortened_path& path)
{
  const Surfel_cloud& cloud = m_cloud->cloud();
  std::vector<Projection> points;
  for(const Projection& projection : path.points)
  {
    const Projection previous = points.empty() ? projection : points.back();
    const double max_chain_length =
        2. * norm(projection.point - previous.point) +
        3. * (cloud.radius[previous.vertex] + cloud.radius[projection.vertex]);
    const Surfel_surface& surface = m_cloud->surface();
    if(surface.walk_length(previous.vertex, projection.vertex) > max_chain_length &&
       surface.walk_length(projection.vertex, previous.vertex) > max_chain_length)
    {
      const std::vector<Index> chain =
          m_search(previous.vertex, projection.vertex, Surfel_search::a_star);
      double length = 0.;
      for(std::size_t i = 0; i + 1 < chain.size(); ++i)
        length += norm(cloud.point[chain[i + 1]] - cloud.point[chain[i]]);
      if(length > max_chain_length)
        for(std::size_t i = 1; i + 1 < chain.size(); ++i)
          points.push_back(m_cloud->project({chain[i], {0., 0.}}));
    }
    points.push_back(projection);
  }
  if(points.size() == path.points.size())
    return false;
  path.points = std::move(points);
  path.length = curve_length(path.points);
  path.polyline_length = polyline_length(path.points);
  return true;
}

// Computes the graph path along a polyline, its points and its length. Returns false if two
// consecutive locations are not connected.
bool Cloud_path_finder::append_initial_path(const std::vector<Tangent_location>& polyline,
                                            Cloud_path& result, std::vector<Projection>& chain)
{
  const Surfel_cloud& cloud = m_cloud->cloud();
  const auto add = [&](const Projection& projection)
  {
    if(chain.empty() || projection.point != chain.back().point)
      chain.push_back(projection);
  };
  for(std::size_t i = 0; i < polyline.size(); ++i)
  {
    if(i > 0)
    {
      const std::vector<Index> vertices =
          m_search(polyline[i - 1].vertex, polyline[i].vertex, m_cloud->options().search);
      if(vertices.empty())
        return false;
      for(const Index vertex : vertices)
      {
        add({cloud.point[vertex], cloud.normal[vertex], {0., 0., 0.}, vertex});
        if(result.initial_path.empty() || result.initial_path.back() != vertex)
          result.initial_path.push_back(vertex);
      }
    }
    add(m_cloud->project(polyline[i]));
  }
  for(std::size_t i = 0; i + 1 < chain.size(); ++i)
    result.initial_length += arc_length(chain[i], chain[i + 1]);
  return true;
}

Cloud_path Cloud_path_finder::shorten(const std::vector<Tangent_location>& polyline)
{
  const Surfel_cloud& cloud = m_cloud->cloud();
  Cloud_path result;
  std::vector<Projection> chain;
  if(!append_initial_path(polyline, result, chain))
  {
    result.initial_path.clear();
    result.initial_length = infinity;
    return result;
  }

  Path_options options = m_cloud->options().path;
  options.min_spacing = 0.5 * cloud.radius[polyline.front().vertex];
  result.path = shorten_path(m_cloud->surface(), options, chain);
  if(!m_cloud->options().do_enforce_guarantees)
    return result;
  bool has_gaps = reroute_over_gaps(result.path);
  // With closer control points, the projections detect the gap.
  Path_options finer_options = options;
  for(int i = 0; i < max_refinements && has_gaps; ++i)
  {
    finer_options.number_of_control_points *= 2;
    Shortened_path refined_path =
        shorten_path(m_cloud->surface(), finer_options, result.path.points);
    has_gaps = reroute_over_gaps(refined_path);
    if(refined_path.length < result.path.length)
      result.path = std::move(refined_path);
  }
  if(result.path.length > result.initial_length)
  {
    // Because of noise and narrow valleys, graph edges can be shorter than paths on the surface.
    // Compare with the curve along the graph path instead.
    Shortened_path initial = result.path;
    fit_curve(m_cloud->surface(), chain, initial);
    reroute_over_gaps(initial);
    result.initial_length = initial.length;
    // If the sampling is too sparse, the fitted surfaces of adjacent surfels do not match. Their
    // disks overlap.
    if(result.path.length > initial.length)
    {
      options.constraint = Path_constraint::energy;
      result.path = shorten_path(m_cloud->disks(), options, chain);
      reroute_over_gaps(result.path);
    }
    if(result.path.length > initial.length)
      result.path = initial;
  }
  return result;
}

std::vector<Cloud_path>
find_paths(const Cloud_path_finder& finder,
           const std::vector<std::pair<Tangent_location, Tangent_location>>& pairs,
           unsigned number_of_threads)
{
  std::vector<Cloud_path> result(pairs.size());
  std::mutex mutex;
  std::vector<std::unique_ptr<Cloud_path_finder>> idle_finders;
  for_each_block(pairs.size(), 1, number_of_threads,
                 [&](std::size_t i, std::size_t, std::size_t)
                 {
                   std::unique_ptr<Cloud_path_finder> local_finder;
                   {
                     const std::lock_guard lock(mutex);
                     if(!idle_finders.empty())
                     {
                       local_finder = std::move(idle_finders.back());
                       idle_finders.pop_back();
                     }
                   }
                   if(!local_finder)
                     local_finder = std::make_unique<Cloud_path_finder>(finder);
                   result[i] = (*local_finder)(pairs[i].first, pairs[i].second);
                   const std::lock_guard lock(mutex);
                   idle_finders.push_back(std::move(local_finder));
                 });
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
