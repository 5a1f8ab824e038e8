// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Cloud_tracer.h>

#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_on_surface.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The length of a step divided by the distance to the sixth nearest surfel. On a torus, steps of
// half or twice this length change the mean error by 5 %: the error of the fit dominates.
constexpr double step_ratio = 0.5;
// Seven coincident surfels have the distance zero. The extent of the cloud is about one.
constexpr double min_step = 1e-6;

Cloud_path_options tracing_options(unsigned number_of_threads)
{
  Cloud_path_options result;
  result.cloud.number_of_threads = number_of_threads;
  result.search = Surfel_search::a_star; // no regions are built
  return result;
}

} // namespace

Cloud_tracer::Cloud_tracer(std::vector<Vec3> points, std::vector<Vec3> normals,
                           const std::vector<double>& radii, unsigned number_of_threads)
    : m_cloud(std::make_shared<const Fitted_cloud>(std::move(points), std::move(normals), radii,
                                                   tracing_options(number_of_threads)))
{}

Traced_path Cloud_tracer::operator()(const Tangent_location& from, const Vec3& direction,
                                     double length) const
{
  const Surfel_cloud& cloud = m_cloud->cloud();
  const auto& [origin, scale] = cloud.frame;
  const Index vertex = cloud.internal_vertex[from.vertex];
  const Surfel_surface& surface = m_cloud->surface();
  // A surfel itself is projected as well, because it is not necessarily on the surface.
  const Projection start =
      from.offset == std::array<double, 2>{0., 0.}
          ? surface.project(cloud.point[vertex], vertex)
          : m_cloud->project({vertex, {from.offset[0] / scale, from.offset[1] / scale}});
  const Traced_curve curve = trace_on_surface(
      surface, [&](Index v) { return std::max(min_step, step_ratio * cloud.spacing[v]); }, start,
      direction, length / scale);

  Traced_path result;
  for(const Projection& projection : curve.points)
  {
    const Tangent_location location = m_cloud->location(projection);
    result.locations.push_back({cloud.caller_vertex[location.vertex],
                                {scale * location.offset[0], scale * location.offset[1]}});
    result.points.push_back(origin + scale * projection.point);
  }
  result.length = scale * curve.length;
  result.is_cut_by_boundary = curve.is_cut_by_boundary;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
