// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_surface.h>

#include "numerics/Quadric_fit.h"
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// On a torus, a support ratio of 3 increases the error by a factor of 2.3.
constexpr double support_ratio = 2.3;
constexpr double extent_ratio = 1.5, neighbor_extent_ratio = 1.3; // see the header
// The minimum support divided by the distance to the nearest surfel: that at the extent.
constexpr double support_to_distance_ratio = support_ratio / extent_ratio;

// Weights decrease to zero between these cosines of the angle between the normals.
constexpr double full_weight_cosine = 0.76604444311897804 /* 40 degrees */,
                 zero_weight_cosine = 0.5 /* 60 degrees */;

// The number of nearest surfels that can surround a point, and of surfels of a robust fit.
constexpr std::size_t number_of_nearest_surfels = 24;
// The maximum angle between adjacent surfels around a surrounded point. At a concave corner of the
// boundary, the angle is larger.
constexpr double max_surrounding_gap = 0.5 * pi;

// For robust weights: the height of an outlier divided by the
// standard deviation, and the minimum standard deviation divided by the spacing. Below the
// minimum, noise is negligible.
constexpr double outlier_tolerance = 2.5, min_deviation = 0.02;
constexpr double deviation_to_median_ratio = 1.4826; // of a normal distribution (MAD)

// Weighted sums over surfels, relative to the query point.
struct Weighted_sums
{
  double weight = 0., point_normal = 0., point_point = 0.;
  Vec3 point = {0., 0., 0.}, normal = {0., 0., 0.};

  void add(double w, const Vec3& p, const Vec3& n)
  {
    weight += w;
    point_normal += w * dot(p, n);
    point_point += w * dot(p, p);
    point = point + w * p;
    normal = normal + w * n;
  }
};

// A sphere, represented by the projection of the origin to it, which is height * normal.
struct Sphere
{
  double height, curvature; // the curvature is positive if the normal points away from the center
  Vec3 normal;
};

// Fits the algebraic sphere constant + linear x + quadratic x^2 = 0. First its gradient is fitted
// to the normals, then its value to the points (Guennebaud, Germann and Gross 2008, Eq. 5).
Sphere fit_sphere(const Weighted_sums& s)
{
  const double inverse_weight = 1. / s.weight;
  const double point_variance = s.point_point - inverse_weight * dot(s.point, s.point);
  const double quadratic =
      point_variance > 0.
          ? 0.5 * (s.point_normal - inverse_weight * dot(s.point, s.normal)) / point_variance
          : 0.;
  const Vec3 linear = inverse_weight * (s.normal - 2. * quadratic * s.point);
  const double constant = -inverse_weight * (dot(linear, s.point) + quadratic * s.point_point);
  const double gradient_norm = norm(linear);
  const double discriminant = gradient_norm * gradient_norm - 4. * constant * quadratic;
  // If there is no real sphere, or the origin is within half a radius of its center, the projection
  // is unstable: use the weighted mean plane.
  if(!(discriminant > 0.) || !(gradient_norm * gradient_norm > 0.25 * discriminant))
    return {dot(s.point, unit(s.normal)) * inverse_weight, 0., unit(s.normal)};
  return {-2. * constant / (gradient_norm + std::sqrt(discriminant)),
          2. * quadratic / std::sqrt(discriminant), (1. / gradient_norm) * linear};
}

// Computes the factor of the robust weight of each vertex (#vertices, in [0, 1]): Tukey's biweight
// of its median height over its neighbors.
std::vector<double> robust_weights(const Surfel_cloud& cloud)
{
  std::vector<Kd_tree::Neighbor> neighbors;
  std::vector<double> values;
  // Returns the median of value(other) over the nearest surfels with compatible normals.
  const auto local_median = [&](Index vertex, const auto& value)
  {
    cloud.tree.nearest(cloud.point, cloud.point[vertex], number_of_nearest_surfels, neighbors);
    values.clear();
    for(const Kd_tree::Neighbor& neighbor : neighbors)
      if(dot(cloud.normal[vertex], cloud.normal[neighbor.point]) > zero_weight_cosine)
        values.push_back(value(neighbor.point));
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  std::vector<double> height(cloud.number_of_vertices()), weight(cloud.number_of_vertices());
  for(Index vertex = 0; vertex < height.size(); ++vertex)
  {
    // Heights along the mean of both normals are zero on planes and spheres.
    const Vec3 &point = cloud.point[vertex], &normal = cloud.normal[vertex];
    height[vertex] = std::abs(local_median(
        vertex, [&](Index other)
        { return 0.5 * dot(normal + cloud.normal[other], cloud.point[other] - point); }));
  }
  for(Index vertex = 0; vertex < height.size(); ++vertex)
  {
    const double deviation =
        std::max(deviation_to_median_ratio *
                     local_median(vertex, [&](Index other) { return height[other]; }),
                 min_deviation * cloud.spacing[vertex]);
    const double ratio = deviation > 0. ? height[vertex] / (outlier_tolerance * deviation) : 0.;
    weight[vertex] = ratio < 1. ? (1. - ratio * ratio) * (1. - ratio * ratio) : 0.;
  }
  return weight;
}

} // namespace

Surfel_surface::Surfel_surface(const Surfel_cloud& cloud, Surfel_fit fit,
                               const Surfel_coverage& coverage,
                               const std::vector<Index>& original_vertex)
    : m_cloud(cloud), m_fit(fit), m_coverage(coverage), m_original_vertex(original_vertex),
      m_squared_support(cloud.number_of_vertices()), m_disk_radius(cloud.number_of_vertices()),
      m_extent(cloud.number_of_vertices()),
      m_robust_weight(fit == Surfel_fit::robust_spheres ? robust_weights(cloud)
                                                        : std::vector<double>())
{
  const Proximity_graph& graph = cloud.graph;
  std::vector<double> neighbor_radii;
  for(Index vertex = 0; vertex < m_squared_support.size(); ++vertex)
  {
    neighbor_radii = {cloud.radius[vertex]};
    for(Index e = graph.begin[vertex]; e < graph.begin[vertex + 1]; ++e)
      neighbor_radii.push_back(cloud.radius[graph.target[e]]);
    const double mean = std::accumulate(neighbor_radii.begin(), neighbor_radii.end(), 0.) /
                        double(neighbor_radii.size());
    m_squared_support[vertex] = support_ratio * mean * (support_ratio * mean);
    m_disk_radius[vertex] = std::min(mean, cloud.radius[vertex]);
    if(original_vertex.empty())
      m_disk_radius[vertex] = std::min(m_disk_radius[vertex], coverage.radius(vertex));
    m_extent[vertex] = extent_ratio * cloud.radius[vertex];
    if(neighbor_radii.size() > 1)
    {
      const double max_neighbor_radius =
          *std::max_element(neighbor_radii.begin() + 1, neighbor_radii.end());
      m_extent[vertex] = std::min(m_extent[vertex], neighbor_extent_ratio * max_neighbor_radius);
    }
  }
}

Index Surfel_surface::nearest(const Vec3& point, Index near_vertex) const
{
  const Proximity_graph& graph = m_cloud.graph;
  const auto squared_distance = [&](Index v)
  {
    if(!m_robust_weight.empty() && m_robust_weight[v] == 0.)
      return infinity;
    const Vec3 offset = m_cloud.point[v] - point;
    return dot(offset, offset);
  };
  double min_squared_distance = squared_distance(near_vertex);
  for(Index v = none; v != near_vertex;)
  {
    v = near_vertex;
    for(Index e = graph.begin[v]; e < graph.begin[v + 1]; ++e)
      if(const double d = squared_distance(graph.target[e]); d < min_squared_distance)
      {
        min_squared_distance = d;
        near_vertex = graph.target[e];
      }
  }
  return near_vertex;
}

double Surfel_surface::walk_length(Index from, Index to) const
{
  const Proximity_graph& graph = m_cloud.graph;
  double length = 0.;
  while(from != to)
  {
    Index next = none;
    double min_distance = norm(m_cloud.point[to] - m_cloud.point[from]);
    for(Index e = graph.begin[from]; e < graph.begin[from + 1]; ++e)
      if(const double d = norm(m_cloud.point[to] - m_cloud.point[graph.target[e]]);
         d < min_distance || graph.target[e] == to)
      {
        min_distance = d;
        next = graph.target[e];
      }
    if(next == none)
      return infinity;
    length += norm(m_cloud.point[next] - m_cloud.point[from]);
    from = next;
  }
  return length;
}

Projection Surfel_surface::project_to_disk(const Vec3& point, Index vertex) const
{
  const Vec3 offset = point - m_cloud.point[vertex], normal = m_cloud.normal[vertex];
  const Vec3 tangent = offset - dot(offset, normal) * normal;
  const double length = norm(tangent), radius = m_disk_radius[vertex];
  Projection projection = {m_cloud.point[vertex] + tangent, normal, {0., 0., 0.}, vertex};
  if(length > radius)
    projection.point = m_cloud.point[vertex] + (radius / length) * tangent;
  return projection;
}

// Calls v(weight, other) for the surfels with positive weight in the fit at a point. `vertex` is
// the nearest surfel of the point.
template <typename Visit>
void Surfel_surface::visit_neighbors(const Vec3& point, Index vertex, Visit v) const
{
  // In a sparse spot, all other surfels can be beyond the support of the nearest one. A fit to one
  // surfel would be its tangent plane.
  const Vec3 nearest_offset = support_to_distance_ratio * (m_cloud.point[vertex] - point);
  const double inverse_squared_support =
      1. / std::max(m_squared_support[vertex], dot(nearest_offset, nearest_offset));
  const auto consider = [&](Index other, double factor)
  {
    const Vec3 offset = m_cloud.point[other] - point;
    const double falloff = 1. - inverse_squared_support * dot(offset, offset);
    const double cosine = dot(m_cloud.normal[vertex], m_cloud.normal[other]);
    if(!(falloff > 0.) || cosine <= zero_weight_cosine)
      return;
    const double weight = factor * falloff * falloff * falloff * falloff;
    v(cosine < full_weight_cosine
          ? weight * (cosine - zero_weight_cosine) / (full_weight_cosine - zero_weight_cosine)
          : weight,
      other);
  };
  if(m_fit != Surfel_fit::robust_spheres)
  {
    const Proximity_graph& graph = m_cloud.graph;
    consider(vertex, 1.);
    for(Index e = graph.begin[vertex]; e < graph.begin[vertex + 1]; ++e)
      consider(graph.target[e], 1.);
    return;
  }
  thread_local std::vector<Kd_tree::Neighbor> neighbors;
  m_cloud.tree.nearest(m_cloud.point, point, number_of_nearest_surfels, neighbors);
  for(const Kd_tree::Neighbor& neighbor : neighbors)
    consider(neighbor.point, m_robust_weight[neighbor.point]);
}

// Projects a point to the surface that is fitted at it. Returns false if all weights are zero.
bool Surfel_surface::project_step(Projection& projection) const
{
  Weighted_sums sums;
  visit_neighbors(
      projection.point, projection.vertex,
      [&](double weight, Index other)
      { sums.add(weight, m_cloud.point[other] - projection.point, m_cloud.normal[other]); });
  if(!(sums.weight > 0.))
    return false;
  if(m_fit == Surfel_fit::planes)
  {
    projection.normal = unit(sums.normal);
    projection.point =
        projection.point + dot(sums.point, projection.normal) / sums.weight * projection.normal;
    return true;
  }
  const Sphere sphere = fit_sphere(sums);
  const Projection from = projection;
  projection.normal = sphere.normal;
  projection.point = projection.point + sphere.height * projection.normal;
  if(m_fit == Surfel_fit::quadrics)
    add_quadric_correction(from, sphere.curvature, projection);
  return true;
}

// Fits a quadric to the residuals of the heights and slopes of a fitted sphere, and corrects the
// projection to the sphere by it. The weights are those at `from`, the point at which the sphere
// was fitted.
void Surfel_surface::add_quadric_correction(const Projection& from, double curvature,
                                            Projection& projection) const
{
  Vec3 &point = projection.point, &normal = projection.normal;
  const auto [u, v] = tangent_frame(normal);
  const double unit_length = std::sqrt(m_squared_support[projection.vertex]) / support_ratio;
  const double inverse_length = 1. / unit_length, scaled_curvature = curvature * unit_length;
  Quadric_fit residual_fit;
  visit_neighbors(
      from.point, from.vertex,
      [&, &u = u, &v = v](double weight, Index other)
      {
        const Vec3 offset = inverse_length * (m_cloud.point[other] - point),
                   n = m_cloud.normal[other];
        const double x = dot(offset, u), y = dot(offset, v), normal_cosine = dot(n, normal);
        const double squared_cosine = 1. - scaled_curvature * scaled_curvature * (x * x + y * y);
        if(!(squared_cosine > 0.04) || !(normal_cosine > 0.2))
          return;
        // On a sphere: height = (cosine - 1) / curvature, slope = -curvature (x, y) / cosine.
        const double cosine = std::sqrt(squared_cosine), slope = scaled_curvature / cosine;
        const Quadric_fit::Moments monomials = {x, y, x * x, x * y, y * y};
        residual_fit.add_height(
            weight, monomials,
            dot(offset, normal) + scaled_curvature * (monomials.xx + monomials.yy) / (1. + cosine));
        residual_fit.add_slopes(weight, monomials, slope * x - dot(n, u) / normal_cosine,
                                slope * y - dot(n, v) / normal_cosine);
      });
  if(residual_fit.factorize() < 6)
    return;
  const Quadric_fit::Coefficients c = residual_fit.coefficients(6);
  const Vec3 tilted_normal = normal - c[1] * u - c[2] * v;
  normal = unit(tilted_normal);
  point = point + unit_length * c[0] * dot(normal, tilted_normal) /
                      dot(tilted_normal, tilted_normal) * normal;
}

// Returns true if the surfels nearest to a point lie on all sides of it. `vertex` is the nearest
// one, in whose tangent plane directions are compared.
bool Surfel_surface::is_surrounded(const Vec3& point, Index vertex) const
{
  thread_local std::vector<Kd_tree::Neighbor> neighbors;
  thread_local std::vector<double> angles;
  m_cloud.tree.nearest(m_cloud.point, point, number_of_nearest_surfels, neighbors);
  const Vec3& normal = m_cloud.normal[vertex];
  const auto [u, v] = tangent_frame(normal);
  angles.clear();
  for(const Kd_tree::Neighbor& neighbor : neighbors)
    if(dot(m_cloud.normal[neighbor.point], normal) > zero_weight_cosine)
    {
      const Vec3 offset = m_cloud.point[neighbor.point] - point;
      angles.push_back(std::atan2(dot(offset, v), dot(offset, u)));
    }
  if(angles.empty())
    return false;
  std::sort(angles.begin(), angles.end());
  double max_gap = angles.front() + 2. * pi - angles.back();
  for(std::size_t i = 0; i + 1 < angles.size(); ++i)
    max_gap = std::max(max_gap, angles[i + 1] - angles[i]);
  return max_gap < max_surrounding_gap;
}

// If a query point is beyond the boundary, moves it along the tangent plane towards its nearest
// surfel into the first extent, and sets the conormal.
void Surfel_surface::clamp_to_boundary(Projection& query) const
{
  const Index vertex = query.vertex;
  const Vec3 offset = query.point - m_cloud.point[vertex];
  const Vec3 tangent = offset - dot(offset, query.normal) * query.normal;
  const double length = norm(tangent);
  double displacement = length - m_extent[vertex];
  if(!(displacement > 0.))
    return;
  const Vec3 conormal = (1. / length) * tangent;
  const Proximity_graph& graph = m_cloud.graph;
  for(Index e = graph.begin[vertex]; e < graph.begin[vertex + 1]; ++e)
  {
    // The extents of neighbors are balls, because neighbors can have other tangent planes.
    const Index other = graph.target[e];
    const Vec3 other_offset = query.point - m_cloud.point[other];
    const double middle = dot(other_offset, conormal);
    const double discriminant =
        middle * middle - dot(other_offset, other_offset) + m_extent[other] * m_extent[other];
    if(discriminant >= 0. && middle + std::sqrt(discriminant) >= 0.)
      displacement = std::min(displacement, middle - std::sqrt(discriminant));
  }
  if(displacement > 0. && !is_surrounded(query.point, vertex))
  {
    query.conormal = conormal;
    query.point = query.point - displacement * conormal;
  }
}

Vec3 Surfel_surface::clamped_to_coverage(const Vec3& point, Index near_vertex) const
{
  return m_coverage.clamped_to_coverage(point, original_vertex(near_vertex));
}

Projection Surfel_surface::project(const Vec3& query, Index near_vertex) const
{
  Projection projection = project_unclamped(query, near_vertex);
  const Vec3 covered_point = clamped_to_coverage(projection.point, projection.vertex);
  if(covered_point != projection.point)
  {
    const Vec3 offset = projection.point - covered_point;
    projection.conormal = unit(offset - dot(offset, projection.normal) * projection.normal);
    projection.point = covered_point;
  }
  return projection;
}

Projection Surfel_surface::project_unclamped(const Vec3& query, Index near_vertex) const
{
  const Index vertex = nearest(query, near_vertex);
  if(m_fit == Surfel_fit::disks)
  {
    const Proximity_graph& graph = m_cloud.graph;
    Projection best = project_to_disk(query, vertex);
    double min_distance = norm(query - best.point);
    for(Index e = graph.begin[vertex]; e < graph.begin[vertex + 1]; ++e)
    {
      const Projection projection = project_to_disk(query, graph.target[e]);
      if(const double distance = norm(query - projection.point); distance < min_distance)
      {
        min_distance = distance;
        best = projection;
      }
    }
    return best;
  }

  Projection projection = {query, m_cloud.normal[vertex], {0., 0., 0.}, vertex};
  clamp_to_boundary(projection);
  // The fit at a distant query point uses wrong weights. Iterate from the projection until it
  // converges.
  for(int i = 0; i < 4; ++i)
  {
    const Vec3 previous_point = projection.point;
    if(!project_step(projection))
    {
      projection.point = m_cloud.point[vertex];
      continue;
    }
    const Vec3 displacement = projection.point - previous_point;
    if(dot(displacement, displacement) < 1e-4 * m_squared_support[vertex])
      break;
  }
  return projection;
}

} // namespace CGAL::Geodesic_processing::internal
