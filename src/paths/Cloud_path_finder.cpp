// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "surfels/denoise.h"
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <cmath>
#include <mutex>

namespace CGAL::Geodesic_processing::internal {

namespace {

// How often noise is removed, until the level is this.
constexpr int most_denoisings = 3;
constexpr double noise_left = 0.05;

// How often a path that steps over gaps is drawn again with twice as many control points: a third time
// changes nothing.
constexpr int finer_paths = 2;

// Up to here the shortest chain of all is found in less time than the path is drawn from it.
constexpr std::size_t small_cloud = 50000;

Surfel_fit fit_of(Surfel_path_method method)
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

Path_hold hold_of(Surfel_path_method method)
{
  return method == Surfel_path_method::projected_quadrics ||
                 method == Surfel_path_method::projected_spheres ||
                 method == Surfel_path_method::projected_planes
             ? Path_hold::projected
             : Path_hold::energy;
}

Cloud_path_options checked(Cloud_path_options options)
{
  const Path_options& path = options.path;
  if(!(path.alpha >= 0.) || !(path.beta >= 0.) || !std::isfinite(path.alpha + path.beta))
    throw Invalid_argument_error("A weight of the energy is negative or not finite.");
  if(path.control_points == 0)
    throw Invalid_argument_error("A path needs a control point.");
  if(!(path.tolerance >= 0.))
    throw Invalid_argument_error("The tolerance is negative or not a number.");
  options.path.hold = hold_of(options.method);
  return options;
}

} // namespace

Prepared_cloud::Prepared_cloud(std::vector<Spatial> points, std::vector<Spatial> normals,
                               const std::vector<double>& radii, const Cloud_path_options& options)
    : m_options(checked(options)),
      m_cloud(
          [&]
          {
            const unsigned threads = options.cloud.threads;
            const auto keep_given = [&]
            {
              Cloud_options plain;
              plain.threads = threads;
              m_given = make_cloud(points, normals, {}, plain);
              m_vicinity = std::make_unique<Surfel_vicinity>(m_given, threads);
              m_given.graph = {};
            };
            const auto make = [&](const Frame* frame) {
              return make_cloud(std::move(points), std::move(normals), radii, options.cloud, frame);
            };
            check_sizes(points.size(), normals.size(), radii.size());
            if(options.noise != Surfel_noise::kept)
              m_noise = noise_level(points, normals, threads);
            const bool is_asked = options.noise == Surfel_noise::removed_when_found;
            if(options.noise == Surfel_noise::kept || (is_asked && m_noise < noise_that_matters))
            {
              // Arcs of another kind, or by the caller's radii, do not tell who is near.
              if(options.cloud.graph != Surfel_graph::extended_spheres || !radii.empty())
                keep_given();
              return make(m_given.number_of_sites() == 0 ? nullptr : &m_given.frame);
            }
            keep_given();
            // Where there is much noise, normals are wrong by so much that a second time finds more.
            double level = m_noise;
            for(int i = 0; i < most_denoisings && (i == 0 || level > noise_left); ++i)
            {
              denoise(points, normals, threads);
              level = noise_level(points, normals, threads);
            }
            draw_near(points, threads);
            return make(&m_given.frame);
          }()),
      m_home(
          [&]
          {
            std::vector<Index> home;
            if(m_given.number_of_sites() > 0)
              for(const Index surfel : m_cloud.surfel_of_site)
                home.push_back(m_given.site_of_surfel[surfel]);
            else
              m_vicinity = std::make_unique<Surfel_vicinity>(m_cloud, options.cloud.threads);
            return home;
          }()),
      m_surface(m_cloud, fit_of(options.method), *m_vicinity, m_home),
      m_disks(m_cloud, Surfel_fit::disks, *m_vicinity, m_home)
{
  if(options.search == Surfel_search::coarse_to_fine && m_cloud.number_of_sites() > small_cloud)
    m_regions = make_regions(m_cloud.graph, m_cloud.point, m_cloud.component);
}

// Moves surfels, where noise has been removed, no farther than paths may be.
void Prepared_cloud::draw_near(std::vector<Spatial>& points, unsigned threads) const
{
  const auto& [origin, scale] = m_given.frame;
  for_each_block(
      points.size(), surfel_block, threads,
      [&, &origin = origin, &scale = scale](std::size_t, std::size_t begin, std::size_t end)
      {
        for(std::size_t i = begin; i < end; ++i)
        {
          const Spatial seen = 1. / scale * (points[i] - origin);
          const Spatial near = m_vicinity->drawn_near(seen, m_given.site_of_surfel[i]);
          if(near != seen)
            points[i] = origin + scale * near;
        }
      });
}

Foot Prepared_cloud::foot(const Tangent_location& location) const
{
  const Index site = location.site;
  if(location.offset == std::array<double, 2>{0., 0.})
    return {m_cloud.point[site], m_cloud.normal[site], {0., 0., 0.}, site};
  const auto [u, v] = tangent_frame(given().normal[home(site)]);
  const Spatial place = given().point[home(site)] + location.offset[0] * u + location.offset[1] * v;
  Foot foot = m_surface.foot(place, site);
  foot.point = m_surface.drawn_near(foot.point, foot.site);
  return foot;
}

Tangent_location Prepared_cloud::location(const Foot& foot) const
{
  const Index own = home(foot.site);
  const auto [u, v] = tangent_frame(given().normal[own]);
  const Spatial way = foot.point - given().point[own];
  return {foot.site, {dot(way, u), dot(way, v)}};
}

Cloud_path_finder::Cloud_path_finder(std::shared_ptr<const Prepared_cloud> cloud)
    : m_cloud(std::move(cloud)),
      m_search(m_cloud->cloud().graph, m_cloud->cloud().point, m_cloud->regions())
{}

// Where a curve goes to a surfel that no short chain of arcs joins to the one before, over a gap or to
// another sheet, it takes the shortest one.  Returns whether there are such places.
bool Cloud_path_finder::keep_to_arcs(Shortened_path& path)
{
  const Surfel_cloud& cloud = m_cloud->cloud();
  std::vector<Foot> points;
  for(const Foot& foot : path.points)
  {
    const Foot last = points.empty() ? foot : points.back();
    const double longest = 2. * norm(foot.point - last.point) +
                           3. * (cloud.radius[last.site] + cloud.radius[foot.site]);
    const Surfel_surface& surface = m_cloud->surface();
    if(surface.walk(last.site, foot.site) > longest && surface.walk(foot.site, last.site) > longest)
    {
      const std::vector<Index> chain = m_search(last.site, foot.site, Surfel_search::a_star);
      double length = 0.;
      for(std::size_t i = 0; i + 1 < chain.size(); ++i)
        length += norm(cloud.point[chain[i + 1]] - cloud.point[chain[i]]);
      if(length > longest)
        for(std::size_t i = 1; i + 1 < chain.size(); ++i)
          points.push_back(m_cloud->foot({chain[i], {0., 0.}}));
    }
    points.push_back(foot);
  }
  if(points.size() == path.points.size())
    return false;
  path.points = std::move(points);
  path.length = length_along_arcs(path.points);
  path.polyline_length = polyline_length(path.points);
  return true;
}

Cloud_path Cloud_path_finder::operator()(const Tangent_location& from, const Tangent_location& to)
{
  const Surfel_cloud& cloud = m_cloud->cloud();
  Cloud_path result;
  result.start = m_search(from.site, to.site, m_cloud->options().search);
  if(result.start.empty())
  {
    result.start_length = infinity;
    return result;
  }
  const Foot first = m_cloud->foot(from), last = m_cloud->foot(to);
  std::vector<Foot> chain = {first};
  const auto add = [&](const Foot& foot)
  {
    if(foot.point != chain.back().point)
      chain.push_back(foot);
  };
  for(const Index site : result.start)
    add({cloud.point[site], cloud.normal[site], {0., 0., 0.}, site});
  add(last);
  for(std::size_t i = 0; i + 1 < chain.size(); ++i)
    result.start_length += length_of_arc(chain[i], chain[i + 1]);

  Path_options options = m_cloud->options().path;
  options.spacing = 0.5 * cloud.radius[from.site];
  result.path = shortened(m_cloud->surface(), options, chain);
  bool is_torn = keep_to_arcs(result.path);
  // Control points nearer to each other see the gap.
  Path_options finer = options;
  for(int i = 0; i < finer_paths && is_torn; ++i)
  {
    finer.control_points *= 2;
    Shortened_path again = shortened(m_cloud->surface(), finer, result.path.points);
    is_torn = keep_to_arcs(again);
    if(again.length < result.path.length)
      result.path = std::move(again);
  }
  if(result.path.length > result.start_length)
  {
    // Noise and narrow valleys make arcs shorter than the surface below them.
    Shortened_path start = result.path;
    draw_curve(m_cloud->surface(), chain, start);
    keep_to_arcs(start);
    result.start_length = start.length;
    // Where surfels are too far apart for what they show, fits jump from one to the next; disks overlap.
    if(result.path.length > start.length)
    {
      options.hold = Path_hold::energy;
      result.path = shortened(m_cloud->disks(), options, chain);
      keep_to_arcs(result.path);
    }
    if(result.path.length > start.length)
      result.path = start;
  }
  return result;
}

std::vector<Cloud_path>
find_paths(const Cloud_path_finder& finder,
           const std::vector<std::pair<Tangent_location, Tangent_location>>& pairs,
           unsigned threads)
{
  std::vector<Cloud_path> result(pairs.size());
  std::mutex mutex;
  std::vector<std::unique_ptr<Cloud_path_finder>> idle;
  for_each_block(pairs.size(), 1, threads,
                 [&](std::size_t i, std::size_t, std::size_t)
                 {
                   std::unique_ptr<Cloud_path_finder> own;
                   {
                     const std::lock_guard lock(mutex);
                     if(!idle.empty())
                     {
                       own = std::move(idle.back());
                       idle.pop_back();
                     }
                   }
                   if(!own)
                     own = std::make_unique<Cloud_path_finder>(finder);
                   result[i] = (*own)(pairs[i].first, pairs[i].second);
                   const std::lock_guard lock(mutex);
                   idle.push_back(std::move(own));
                 });
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
