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
  Path_options path; // its constraint and do_fit_curve follow from the other options
  bool do_enforce_guarantees = true; // see Cloud_path_finder::operator()
};

// A surfel cloud and the surface fitted to it. It can be shared by several finders.
class CGAL_GEODESIC_PROCESSING_EXPORT Fitted_cloud
{
public:
  // Builds the proximity graph of a cloud. If requested, estimates and removes noise.
  //
  // points, normals, radii  as for make_cloud()
  //
  // Throws Invalid_argument_error if an option is invalid or the arrays differ in size.
  Fitted_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
               const std::vector<double>& radii, const Cloud_path_options& options);
  Fitted_cloud(const Fitted_cloud&) = delete;

  const Surfel_cloud& cloud() const { return m_cloud; }
  // Returns the regions for coarse-to-fine search, or null if the search does not use them.
  const Vertex_regions* regions() const { return m_regions.size() == 0 ? nullptr : &m_regions; }
  const Surfel_surface& surface() const { return m_surface; }
  const Surfel_surface& disks() const { return m_disks; }
  const Cloud_path_options& options() const { return m_options; }
  // Returns the estimated noise level, see noise_level(); zero if noise is kept.
  double noise() const { return m_noise; }

  // Returns the projection of a location in a surfel's tangent plane to the surface, in the cloud's
  // scale.
  Projection project(const Tangent_location& location) const;
  // Returns the location of a path's point in the tangent plane of the caller's surfel, in the
  // cloud's scale.
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

  // Sets m_noise and returns the cloud, without noise if requested. Sets m_given_cloud and
  // m_coverage if they differ from those of the result.
  Surfel_cloud build_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
                           const std::vector<double>& radii, const Cloud_path_options& options);
  void store_given_cloud(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                         unsigned number_of_threads);
  void limit_displacements(std::vector<Vec3>& points, unsigned number_of_threads) const;

  double m_noise = 0.;
  Cloud_path_options m_options;
  // The caller's cloud, without a graph. It is empty if it is the same as m_cloud; then so is
  // m_given_vertex, the vertex of m_given_cloud for each vertex of m_cloud.
  Surfel_cloud m_given_cloud;
  std::unique_ptr<Surfel_coverage> m_coverage;
  Surfel_cloud m_cloud;
  std::vector<Index> m_given_vertex;
  Vertex_regions m_regions;
  Surfel_surface m_surface, m_disks;
};

struct Cloud_path
{
  Shortened_path path;             // in the cloud's scale; has no points if there is no path
  std::vector<Index> initial_path; // the vertices of the graph path that is shortened
  double initial_length = 0.;      // length of the smooth curve along it; infinite if there is none
};

// Finds shortest paths on a surfel cloud between pairs of locations.
//
// A path in the proximity graph is computed by Graph_search and shortened by shorten_path().
// Copies share the cloud; different copies can be used concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Cloud_path_finder
{
public:
  explicit Cloud_path_finder(std::shared_ptr<const Fitted_cloud> cloud);

  const std::shared_ptr<const Fitted_cloud>& fitted_cloud() const { return m_cloud; }

  // Returns the path between two locations.
  //
  // The path is not longer than the graph path from which it starts. If it would be, it is
  // recomputed on the disks of the surfels. If that path is longer too, the result is a curve
  // along the graph path. All points are covered by surfels, see Surfel_coverage. The surfels of
  // consecutive points are joined by short graph paths, so that the path neither crosses gaps nor
  // jumps between sheets.
  //
  // If guarantees are not enforced, the path is the polyline of the control points that minimizes
  // the energy of the method.
  Cloud_path operator()(const Tangent_location& from, const Tangent_location& to)
  {
    return shorten({from, to});
  }
  // Returns the path between the ends of a polyline that results from shortening the polyline.
  // Graph paths join consecutive locations, of which there are at least two.
  Cloud_path shorten(const std::vector<Tangent_location>& polyline);

private:
  bool append_initial_path(const std::vector<Tangent_location>& polyline, Cloud_path& result,
                           std::vector<Projection>& chain);
  bool reroute_over_gaps(Shortened_path& path);

  std::shared_ptr<const Fitted_cloud> m_cloud;
  Graph_search m_search;
};

// Finds a path for each pair of locations. The result does not depend on the number of threads.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Cloud_path>
find_paths(const Cloud_path_finder& finder,
           const std::vector<std::pair<Tangent_location, Tangent_location>>& pairs,
           unsigned number_of_threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_CLOUD_PATH_FINDER_H
