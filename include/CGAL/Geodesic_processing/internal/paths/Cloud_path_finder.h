// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_CLOUD_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_CLOUD_PATH_FINDER_H

#include <CGAL/Geodesic_processing/internal/paths/Graph_search.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_surface.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_coverage.h>
#include <CGAL/Geodesic_processing/internal/paths/path_energy.h>
#include <CGAL/Geodesic_processing/internal/surfels/vertex_regions.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Cloud_path_options
{
  Surfel_cloud_options cloud;
  Surfel_path_method method = Surfel_path_method::projected_quadrics;
  Surfel_noise noise = Surfel_noise::removed_when_found;
  Surfel_search search = Surfel_search::coarse_to_fine;
  Path_options path; // what holds it follows from the method
};

// A cloud, and the surface fitted to it, that any number of finders share.
class CGAL_GEODESIC_PROCESSING_EXPORT Fitted_cloud
{
public:
  // Points, normals and radii as for make_cloud().
  Fitted_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
               const std::vector<double>& radii, const Cloud_path_options& options);
  Fitted_cloud(const Fitted_cloud&) = delete;

  const Surfel_cloud& cloud() const { return m_cloud; }
  // None where the search needs none.
  const Vertex_regions* regions() const { return m_regions.size() == 0 ? nullptr : &m_regions; }
  const Surfel_surface& surface() const { return m_surface; }
  const Surfel_surface& disks() const { return m_disks; }
  const Cloud_path_options& options() const { return m_options; }
  double noise() const { return m_noise; }

  // The foot of a place in a surfel's tangent plane, in the cloud's scale.
  Projection project(const Tangent_location& location) const;
  // Where a point of a path lies in the tangent plane of the caller's surfel, in the cloud's scale.
  Tangent_location location(const Projection& projection) const;

private:
  const Surfel_cloud& given_cloud() const
  {
    return m_given_cloud.number_of_vertices() == 0 ? m_cloud : m_given_cloud;
  }
  Index given_vertex(Index vertex) const
  {
    return m_given_vertex.empty() ? vertex : m_given_vertex[vertex];
  }

  void limit_displacements(std::vector<Vec3>& points, unsigned threads) const;

  double m_noise = 0.; // as noise_level() says
  Cloud_path_options m_options;
  // What the caller has given, without arcs, and the place of each site there; empty where they are the
  // cloud's own.
  Surfel_cloud m_given_cloud;
  std::unique_ptr<Surfel_coverage> m_coverage;
  Surfel_cloud m_cloud;
  std::vector<Index> m_given_vertex;
  Vertex_regions m_regions;
  Surfel_surface m_surface, m_disks;
};

struct Cloud_path
{
  Shortened_path path;      // in the cloud's scale; no points when there is none
  std::vector<Index> start; // the sites of the chain of arcs
  double start_length = 0.; // of that chain, along arcs
};

// Finds paths, one pair after the other; copies share the cloud, and may search at the same time.
class CGAL_GEODESIC_PROCESSING_EXPORT Cloud_path_finder
{
public:
  explicit Cloud_path_finder(std::shared_ptr<const Fitted_cloud> cloud);

  const std::shared_ptr<const Fitted_cloud>& fitted_cloud() const { return m_cloud; }

  // Never longer than the chain of arcs that it starts from: where it would be, it is drawn to the disks
  // of the surfels, and where that is longer as well, it is the chain.
  // All its points are near surfels, as Surfel_coverage says, and consecutive ones at surfels that a
  // short chain of arcs joins: it crosses neither a gap nor to another sheet.
  Cloud_path operator()(const Tangent_location& from, const Tangent_location& to);

private:
  bool reroute_over_gaps(Shortened_path& path);

  std::shared_ptr<const Fitted_cloud> m_cloud;
  Graph_search m_search;
};

// A path for each pair; the same for any number of threads.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Cloud_path>
find_paths(const Cloud_path_finder& finder,
           const std::vector<std::pair<Tangent_location, Tangent_location>>& pairs,
           unsigned threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_CLOUD_PATH_FINDER_H
