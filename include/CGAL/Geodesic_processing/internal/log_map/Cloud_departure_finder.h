// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_CLOUD_DEPARTURE_FINDER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_CLOUD_DEPARTURE_FINDER_H

#include <CGAL/Geodesic_processing/internal/core/Path_surface.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A geodesic to a location on a cloud, in the frame of the cloud.
struct Cloud_departure
{
  // The tangent vector at the source whose geodesic ends at the location: its logarithm.
  Vec3 vector = {0., 0., 0.};
  bool is_connected = false;
  // The displacement of the end across the geodesic, divided by that in the plane, if the direction
  // changes. On a sphere it is sin(d) / d.
  double spreading = 1.;
};

// The motion of a source along a geodesic: its step, and the axes that are transported parallel.
struct Cloud_motion
{
  Vec3 step = {0., 0., 0.};
  Vec3 from_x, from_y; // an orthonormal frame at the beginning
  Vec3 to_x, to_y;     // the same frame at the end

  Vec3 transported(const Vec3& vector) const
  {
    return dot(vector, from_x) * to_x + dot(vector, from_y) * to_y;
  }
};

// Computes geodesics from one location on a fitted cloud to many by shooting: the end of a traced
// geodesic (trace_on_surface()) is corrected by the method of false position.
//
// The first guess is the path of a Cloud_path_finder, or the result at a source nearby. If a
// geodesic misses its location by more than 1e-3 of its length, for example because it is bent by
// the boundary, the path of the Cloud_path_finder is used instead.
class CGAL_GEODESIC_PROCESSING_EXPORT Cloud_departure_finder
{
public:
  // to  in the frame of the cloud
  Cloud_departure_finder(const Cloud_path_finder& finder, std::vector<Tangent_location> to,
                         unsigned number_of_threads);

  const Fitted_cloud& fitted_cloud() const { return *m_finder.fitted_cloud(); }

  // Returns the geodesics from a location on the surface. They begin with shortest paths.
  std::vector<Cloud_departure> operator()(const Projection& from) const;
  // Returns the geodesics after a motion to this location. They begin with those before it.
  std::vector<Cloud_departure> operator()(const Projection& from,
                                          const std::vector<Cloud_departure>& before,
                                          const Cloud_motion& motion) const;

  // Traces a geodesic from a location on the surface. Sets the motion and returns its end.
  Projection move(const Projection& from, const Vec3& step, Cloud_motion& motion) const;

private:
  bool shoot(const Projection& from, const Projection& to, Cloud_departure& departure) const;
  std::vector<Cloud_departure> by_paths(const Projection& from,
                                        const std::vector<std::size_t>& targets) const;
  double max_step(Index vertex) const;

  Cloud_path_finder m_finder;
  std::vector<Tangent_location> m_to;
  std::vector<Projection> m_ends; // #to: on the surface
  unsigned m_number_of_threads;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_CLOUD_DEPARTURE_FINDER_H
