// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/mean_value.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Triple = std::array<double, 3>;

constexpr int next_corner(int k) { return k == 2 ? 0 : k + 1; }
constexpr int previous_corner(int k) { return k == 0 ? 2 : k - 1; }

// Returns angle / sin(angle) - 1. The argument is q = tan(angle / 2)^2.
double angle_over_sine_minus_one(double q)
{
  if(q > 1. / 64.)
  {
    const double t = std::sqrt(q);
    return (1. + q) * std::atan(t) / t - 1.;
  }
  // The series (1 + q) (1 - q/3 + q^2/5 - ...) - 1, whose next term is below the round-off error.
  double sum = 0.;
  for(int n = 9; n > 0; --n)
    sum = 2. / (4. * n * n - 1.) - q * sum;
  return q * sum;
}

// A vertex as seen from the point.
struct Ray
{
  Vec3 offset; // vertex minus point
  double length;
  Vec3 unit;
};

// A triangle as seen from the point, projected to the unit sphere. In this struct, edge k is
// opposite of corner k.
struct Spherical_triangle
{
  std::array<const Ray*, 3> ray;
  Triple squared_tangent;     // squared tangents of half the edges
  std::array<Vec3, 3> normal; // normals of the planes through edges; lengths are sines of edges
  Vec3 normal_sum;
  double determinant;

  explicit Spherical_triangle(const std::array<const Ray*, 3>& rays) : ray(rays)
  {
    std::array<Vec3, 3> difference;
    for(int k = 0; k < 3; ++k)
    {
      const Ray &a = *ray[next_corner(k)], &b = *ray[previous_corner(k)];
      // The difference of unit vectors, without cancellation if they are close.
      const Vec3 edge = b.offset - a.offset, sum = a.unit + b.unit;
      const double length_difference = dot(edge, a.offset + b.offset) / (a.length + b.length);
      difference[k] = (1. / b.length) * (edge - length_difference * a.unit);
      squared_tangent[k] = dot(difference[k], difference[k]) / dot(sum, sum);
      normal[k] = cross(a.unit, difference[k]);
    }
    normal_sum = cross(difference[2], difference[0]);
    determinant = dot(ray[0]->unit, normal_sum);
  }

  // Returns true if the point is, within precision, in the plane of the triangle or close to an
  // edge.
  bool is_thin() const
  {
    const Triple size = {dot(normal[0], normal[0]), dot(normal[1], normal[1]),
                         dot(normal[2], normal[2])};
    const double largest = std::max({size[0] * size[1], size[1] * size[2], size[2] * size[0]});
    return determinant * determinant <= 1e-6 * largest;
  }

  Vec3 plane_normal() const
  {
    const Vec3& a = ray[0]->offset;
    return cross(ray[1]->offset - a, ray[2]->offset - a);
  }

  // Returns the barycentric coordinates of the point if it is on the triangle, otherwise no value.
  std::optional<Triple> coordinates_of_point(const Vec3& plane_normal, double tolerance) const
  {
    const Vec3 &a = ray[0]->offset, &b = ray[1]->offset, &c = ray[2]->offset;
    if(!(std::abs(dot(a, plane_normal)) <= tolerance * norm(plane_normal)))
      return std::nullopt;
    const Triple result = nearest_in_triangle(a, b, c, {0., 0., 0.});
    if(!(norm(result[0] * a + result[1] * b + result[2] * c) <= tolerance))
      return std::nullopt;
    return result;
  }

  // Returns the integral of all unit vectors of the spherical triangle, as coefficients of its
  // corners. The integral is half the sum of edge lengths times unit normals of their planes.
  Triple vertex_coefficients() const
  {
    Vec3 doubled_integral = normal_sum;
    for(int k = 0; k < 3; ++k)
      doubled_integral =
          doubled_integral + angle_over_sine_minus_one(squared_tangent[k]) * normal[k];
    Triple result;
    for(int k = 0; k < 3; ++k)
      result[k] = dot(doubled_integral, normal[k]) / (2. * determinant);
    return result;
  }

  // Returns the same for a small determinant, for which the sum above cancels. Half-angle formulas
  // compute small terms as products.
  Triple thin_vertex_coefficients() const
  {
    Triple edge, sine;
    for(int k = 0; k < 3; ++k)
    {
      edge[k] = 2. * std::atan(std::sqrt(squared_tangent[k]));
      sine[k] = norm(normal[k]);
      if(!(sine[k] > 0.))
        return {0., 0., 0.};
    }
    const double half_sum = 0.5 * (edge[0] + edge[1] + edge[2]);
    Triple half_sum_minus_edge;
    for(int k = 0; k < 3; ++k)
      half_sum_minus_edge[k] =
          std::max(0., 0.5 * (edge[next_corner(k)] + edge[previous_corner(k)] - edge[k]));
    // If one edge is almost the sum of the others, the determinant gives the difference more
    // precisely.
    const int smallest =
        int(std::min_element(half_sum_minus_edge.begin(), half_sum_minus_edge.end()) -
            half_sum_minus_edge.begin());
    const double product_of_sines = 4. * std::sin(half_sum) *
                                    std::sin(half_sum_minus_edge[next_corner(smallest)]) *
                                    std::sin(half_sum_minus_edge[previous_corner(smallest)]);
    if(const double squared_determinant = determinant * determinant;
       squared_determinant < 1e-3 * product_of_sines)
      half_sum_minus_edge[smallest] = std::asin(squared_determinant / product_of_sines);
    Triple deviation; // of the cosine of the angle from 1 or -1
    Triple sign;
    for(int k = 0; k < 3; ++k)
    {
      const double product = sine[next_corner(k)] * sine[previous_corner(k)];
      const double sine_of_half = std::sin(half_sum_minus_edge[next_corner(k)]) *
                                  std::sin(half_sum_minus_edge[previous_corner(k)]) / product;
      const double cosine_of_half = std::sin(half_sum) * std::sin(half_sum_minus_edge[k]) / product;
      sign[k] = sine_of_half < cosine_of_half ? 1. : -1.;
      deviation[k] = 2. * std::min(sine_of_half, cosine_of_half);
    }
    Triple result;
    for(int k = 0; k < 3; ++k)
    {
      const int i = next_corner(k), j = previous_corner(k);
      // Computes edge[k] - edge[i] cos(angle[j]) - edge[j] cos(angle[i]).
      const double sum = (sign[i] > 0. && sign[j] > 0.)   ? -2. * half_sum_minus_edge[k]
                         : (sign[i] > 0. && sign[j] < 0.) ? 2. * half_sum_minus_edge[j]
                         : (sign[i] < 0. && sign[j] > 0.) ? 2. * half_sum_minus_edge[i]
                                                          : 2. * half_sum;
      result[k] = sine[k] *
                  (sum + edge[i] * sign[j] * deviation[j] + edge[j] * sign[i] * deviation[i]) /
                  (2. * determinant);
    }
    return result;
  }
};

// Computes the rays to all vertices. Returns the vertex at the point if there is one, otherwise
// none.
Index cast_rays(const Surface_arrays& t, const Vec3& point, double tolerance,
                std::vector<Ray>& rays)
{
  for(Index vertex = 0; vertex < rays.size(); ++vertex)
  {
    const Vec3 offset = t.point[vertex] - point;
    const double length = norm(offset);
    if(length <= tolerance && t.ring_begin[vertex] != t.ring_begin[vertex + 1])
      return vertex;
    rays[vertex] = {offset, length, (1. / length) * offset};
  }
  return none;
}

} // namespace

Mean_value_coordinates::Mean_value_coordinates(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(std::move(triangles))
{
  const Surface_arrays& t = *m_triangles;
  if(t.number_of_triangles() == 0 || std::find(t.twin.begin(), t.twin.end(), none) != t.twin.end())
    throw Unsupported_surface_error(t.number_of_triangles() == 0
                                        ? "The mesh has no triangles."
                                        : "The mesh is not closed: it has a boundary.");
  Vec3 lower_corner = t.point[t.corner[0]], upper_corner = lower_corner;
  for(const Index vertex : t.corner)
    for(int c = 0; c < 3; ++c)
    {
      lower_corner[c] = std::min(lower_corner[c], t.point[vertex][c]);
      upper_corner[c] = std::max(upper_corner[c], t.point[vertex][c]);
    }
  m_distance_tolerance = 1e-12 * norm(upper_corner - lower_corner);
}

std::pair<Vector, double> Mean_value_coordinates::weights(const Vec3& point) const
{
  const Surface_arrays& t = *m_triangles;
  for(const double x : point)
    if(!std::isfinite(x))
      throw Invalid_argument_error("The coordinates of a point must be finite.");
  const Vec3 point_in_domain = (1. / t.scale) * (point - t.origin);
  Vector result = Vector::Zero(Eigen::Index(t.number_of_vertices()));

  std::vector<Ray> rays(t.number_of_vertices());
  if(const Index vertex = cast_rays(t, point_in_domain, m_distance_tolerance, rays); vertex != none)
  {
    result[vertex] = 1.;
    return {result, infinity};
  }

  double sum_of_absolute_weights = 0.;
  for(std::size_t f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index* corner = &t.corner[3 * f];
    const Spherical_triangle triangle({&rays[corner[0]], &rays[corner[1]], &rays[corner[2]]});
    const bool is_thin = triangle.is_thin();
    if(is_thin)
    {
      const Vec3 normal = triangle.plane_normal();
      if(!(dot(normal, normal) > 0.))
        continue;
      if(const auto coordinates = triangle.coordinates_of_point(normal, m_distance_tolerance))
      {
        result.setZero();
        for(int k = 0; k < 3; ++k)
          result[corner[k]] = (*coordinates)[k];
        return {result, infinity};
      }
      if(triangle.determinant == 0.)
        continue;
    }
    const Triple coefficients =
        is_thin ? triangle.thin_vertex_coefficients() : triangle.vertex_coefficients();
    for(int k = 0; k < 3; ++k)
    {
      const double weight = coefficients[k] / rays[corner[k]].length;
      result[corner[k]] += weight;
      sum_of_absolute_weights += std::abs(weight);
    }
  }
  const double sum = result.sum();
  if(!(std::abs(sum) > 1e-10 * sum_of_absolute_weights))
    throw Unsupported_surface_error("A point has no mean value coordinates: the mesh encloses no "
                                    "volume, or the point is too far away.");
  return {result, sum};
}

Vector Mean_value_coordinates::operator()(const Vec3& point) const
{
  auto [result, sum] = weights(point);
  if(sum != infinity)
    result /= sum;
  return result;
}

bool Mean_value_coordinates::are_on_same_side(const Vec3& p, const Vec3& q) const
{
  return (weights(p).second > 0.) == (weights(q).second > 0.);
}

} // namespace CGAL::Geodesic_processing::internal
