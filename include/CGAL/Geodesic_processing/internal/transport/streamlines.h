// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_STREAMLINES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_STREAMLINES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The start of a streamline.
struct Streamline_seed
{
  Surface_location location;
  double right_fraction =
      0.5; // on a cloud: the fraction of the vertex's mass on the right of the streamline
  Index source_vertex = none; // if the mass is a point mass: its vertex; otherwise none
};

// A path along the flow.
struct Streamline
{
  // At least one location, and no duplicates in a row. Consecutive locations are in a common
  // triangle; on a cloud they may also be the ends of an edge.
  std::vector<Surface_location> locations;
  bool has_arrived = false; // true if it ends at a location with target mass
};

// The masses before and after the flow, all nonnegative. Their difference is the divergence of the
// flow.
struct Moved_masses
{
  Vector source_masses, target_masses; // #vertices
  // If true, the masses are points at which streamlines begin or end. Otherwise each mass is spread
  // over the triangles around its vertex.
  bool has_point_sources = false, has_point_targets = false;
  std::vector<Surface_location> source_locations,
      target_locations; // point masses inside triangles, distributed to the corners
};

// Computes the streamlines along which a flow moves mass in unit time (Dacorogna and Moser 1990).
// At time s the density is (1 - s) source + s target, and the velocity is flow / density. If the
// density is zero, the velocity is infinite.
//
// On a mesh, masses and flow are spread over the triangles as in Continuous_flow. The streamlines
// are straight in each triangle, and their parameter is computed in closed form. The map from
// sources to targets preserves mass.
// On a cloud, the flow is converted to one along edges with the same divergence. The flow through a
// vertex preserves the order of streamlines from right to left.
class CGAL_GEODESIC_PROCESSING_EXPORT Streamlines
{
public:
  // Prepares a mesh. O(n)
  Streamlines(std::shared_ptr<const Surface_arrays> triangles, const Continuous_flow& flow,
              Moved_masses masses);
  // Prepares a cloud. O(n log n)
  //
  // flow  #triangles vectors; its minus_divergence() must be the difference of the masses
  Streamlines(std::shared_ptr<const Surface_arrays> triangles, const Operators& operators,
              const Field& flow, Moved_masses masses);
  ~Streamlines();
  Streamlines(Streamlines&&) noexcept;

  // Returns `number` seeds, each with the same mass, distributed over all source mass. The result
  // is empty if no mass moves.
  std::vector<Streamline_seed> seeds(std::size_t number) const;

  // Traces the streamline of a seed from time 0 to time 1. A seed without mass follows the flow to
  // its end. If the flow is a closed loop, the streamline ends without arriving.
  // Complexity: O(#crossed triangles); on a cloud, the number of edges at the crossed vertices.
  Streamline operator()(const Streamline_seed& seed) const;

private:
  class Tracer;
  class Mesh_tracer;
  class Cloud_tracer;

  std::unique_ptr<const Tracer> m_tracer;
};

// Shortens the streamlines of optimal flows, which depend on the triangulation, to geodesics.
class CGAL_GEODESIC_PROCESSING_EXPORT Line_shortener
{
public:
  explicit Line_shortener(std::shared_ptr<const Surface_arrays> triangles);

  // Returns a locally shortest path with the same ends. If a path on a mesh is more than 1 % longer
  // than the lower bound, a path of Path_finder is computed as well. The shorter one is returned,
  // since the streamline can pass an obstacle on the wrong side.
  //
  // lower_bound  of the length of all paths, in the unit of the edge lengths; the difference of a
  //   potential is one
  std::vector<Surface_location> operator()(const std::vector<Surface_location>& line,
                                           double lower_bound);

private:
  std::shared_ptr<const Surface_arrays> m_triangles;
  std::optional<Path_finder> m_finder; // constructed if it is needed
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_STREAMLINES_H
