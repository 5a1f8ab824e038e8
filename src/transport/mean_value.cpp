// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/mean_value.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Three = std::array<double, 3>;

constexpr int after(int k) { return k == 2 ? 0 : k + 1; }
constexpr int before(int k) { return k == 0 ? 2 : k - 1; }

// angle / sin(angle) - 1, from the square of the tangent of half the angle.
double excess_over_sine(double q)
{
  if(q > 1. / 64.)
  {
    const double t = std::sqrt(q);
    return (1. + q) * std::atan(t) / t - 1.;
  }
  // (1 + q) (1 - q/3 + q^2/5 - ...) - 1; the next term is below rounding.
  double sum = 0.;
  for(int n = 9; n > 0; --n)
    sum = 2. / (4. * n * n - 1.) - q * sum;
  return q * sum;
}

// A corner of a triangle as it is seen from the point.
struct Ray
{
  Spatial way; // the corner less the point
  double length;
  Spatial unit;
};

// A triangle as it is seen from the point: from here on on the unit sphere, side k is opposite to
// corner k.
struct Spherical_triangle
{
  std::array<const Ray*, 3> ray;
  Three square;                  // of the tangents of half the sides
  std::array<Spatial, 3> normal; // of the planes through sides: as long as the side's sine
  Spatial across;                // the sum of the normals
  double determinant;

  explicit Spherical_triangle(const std::array<const Ray*, 3>& rays) : ray(rays)
  {
    std::array<Spatial, 3> difference;
    for(int k = 0; k < 3; ++k)
    {
      const Ray &a = *ray[after(k)], &b = *ray[before(k)];
      // Of unit vectors, without cancellation where they are close.
      const Spatial side = b.way - a.way, sum = a.unit + b.unit;
      const double longer = dot(side, a.way + b.way) / (a.length + b.length);
      difference[k] = (1. / b.length) * (side - longer * a.unit);
      square[k] = dot(difference[k], difference[k]) / dot(sum, sum);
      normal[k] = cross(a.unit, difference[k]);
    }
    across = cross(difference[2], difference[0]);
    determinant = dot(ray[0]->unit, across);
  }

  // Whether the point lies in the triangle's plane, or near to an edge, as far as can be seen.
  bool is_thin() const
  {
    const Three size = {dot(normal[0], normal[0]), dot(normal[1], normal[1]),
                        dot(normal[2], normal[2])};
    const double largest = std::max({size[0] * size[1], size[1] * size[2], size[2] * size[0]});
    return determinant * determinant <= 1e-6 * largest;
  }

  // The coefficients of the integral of all unit vectors in the triangle, as a sum of those of its
  // corners: the integral is half the sum of sides times the unit normals of their planes.
  Three shares() const
  {
    Spatial twice = across;
    for(int k = 0; k < 3; ++k)
      twice = twice + excess_over_sine(square[k]) * normal[k];
    Three result;
    for(int k = 0; k < 3; ++k)
      result[k] = dot(twice, normal[k]) / (2. * determinant);
    return result;
  }

  // The same where the determinant is small, and the sum above nearly vanishes: by half-angle formulas,
  // in which what is small is a product.
  Three thin_shares() const
  {
    Three side, sine;
    for(int k = 0; k < 3; ++k)
    {
      side[k] = 2. * std::atan(std::sqrt(square[k]));
      sine[k] = norm(normal[k]);
      if(!(sine[k] > 0.))
        return {0., 0., 0.};
    }
    const double half = 0.5 * (side[0] + side[1] + side[2]);
    Three rest; // half the sum less a side
    for(int k = 0; k < 3; ++k)
      rest[k] = std::max(0., 0.5 * (side[after(k)] + side[before(k)] - side[k]));
    // Where one side is nearly the sum of the others the determinant knows better by how much not.
    const int least = int(std::min_element(rest.begin(), rest.end()) - rest.begin());
    const double others =
        4. * std::sin(half) * std::sin(rest[after(least)]) * std::sin(rest[before(least)]);
    if(const double square_of = determinant * determinant; square_of < 1e-3 * others)
      rest[least] = std::asin(square_of / others);
    Three deviation; // of the angle's cosine at a corner from one or minus one
    Three sign;
    for(int k = 0; k < 3; ++k)
    {
      const double product = sine[after(k)] * sine[before(k)];
      const double sine_of_half = std::sin(rest[after(k)]) * std::sin(rest[before(k)]) / product;
      const double cosine_of_half = std::sin(half) * std::sin(rest[k]) / product;
      sign[k] = sine_of_half < cosine_of_half ? 1. : -1.;
      deviation[k] = 2. * std::min(sine_of_half, cosine_of_half);
    }
    Three result;
    for(int k = 0; k < 3; ++k)
    {
      const int i = after(k), j = before(k);
      // side[k] - side[i] cos(angle[j]) - side[j] cos(angle[i])
      const double sum = (sign[i] > 0. && sign[j] > 0.)   ? -2. * rest[k]
                         : (sign[i] > 0. && sign[j] < 0.) ? 2. * rest[j]
                         : (sign[i] < 0. && sign[j] > 0.) ? 2. * rest[i]
                                                          : 2. * half;
      result[k] = sine[k] *
                  (sum + side[i] * sign[j] * deviation[j] + side[j] * sign[i] * deviation[i]) /
                  (2. * determinant);
    }
    return result;
  }
};

} // namespace

Mean_value_coordinates::Mean_value_coordinates(std::shared_ptr<const Glued_triangles> triangles)
    : m_triangles(std::move(triangles))
{
  const Glued_triangles& t = *m_triangles;
  if(t.number_of_triangles() == 0 || std::find(t.twin.begin(), t.twin.end(), none) != t.twin.end())
    throw Unsupported_surface_error(t.number_of_triangles() == 0
                                        ? "The mesh has no triangles that could enclose anything."
                                        : "The mesh is not closed: it has a border.");
  Spatial low = t.point[t.corner[0]], high = low;
  for(const Index site : t.corner)
    for(int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], t.point[site][c]);
      high[c] = std::max(high[c], t.point[site][c]);
    }
  m_near = 1e-12 * norm(high - low);
}

std::pair<Vector, double> Mean_value_coordinates::weights(const Spatial& point) const
{
  const Glued_triangles& t = *m_triangles;
  for(const double x : point)
    if(!std::isfinite(x))
      throw Invalid_argument_error("A coordinate of a point is not finite.");
  const Spatial place = (1. / t.scale) * (point - t.origin);
  Vector result = Vector::Zero(Eigen::Index(t.number_of_sites()));

  std::vector<Ray> rays(t.number_of_sites());
  for(Index site = 0; site < rays.size(); ++site)
  {
    const Spatial way = t.point[site] - place;
    const double length = norm(way);
    if(length <= m_near && t.first[site] != t.first[site + 1])
    {
      result[site] = 1.;
      return {result, infinity};
    }
    rays[site] = {way, length, (1. / length) * way};
  }

  double absolute = 0.;
  for(std::size_t f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index* corner = &t.corner[3 * f];
    const Spherical_triangle triangle({&rays[corner[0]], &rays[corner[1]], &rays[corner[2]]});
    const bool is_thin = triangle.is_thin();
    if(is_thin)
    {
      const Spatial &a = rays[corner[0]].way, &b = rays[corner[1]].way, &c = rays[corner[2]].way;
      const Spatial normal = cross(b - a, c - a);
      if(!(dot(normal, normal) > 0.))
        continue;
      if(std::abs(dot(a, normal)) <= m_near * norm(normal))
      {
        const Three share = nearest_in_triangle(a, b, c, {0., 0., 0.});
        if(norm(share[0] * a + share[1] * b + share[2] * c) <= m_near)
        {
          result.setZero();
          for(int k = 0; k < 3; ++k)
            result[corner[k]] = share[k];
          return {result, infinity};
        }
      }
      if(triangle.determinant == 0.)
        continue;
    }
    const Three share = is_thin ? triangle.thin_shares() : triangle.shares();
    for(int k = 0; k < 3; ++k)
    {
      const double weight = share[k] / rays[corner[k]].length;
      result[corner[k]] += weight;
      absolute += std::abs(weight);
    }
  }
  const double sum = result.sum();
  if(!(std::abs(sum) > 1e-10 * absolute))
    throw Unsupported_surface_error("A point has no mean value coordinates: the mesh encloses "
                                    "nothing that is seen from there.");
  return {result, sum};
}

Vector Mean_value_coordinates::operator()(const Spatial& point) const
{
  auto [result, sum] = weights(point);
  if(sum != infinity)
    result /= sum;
  return result;
}

bool Mean_value_coordinates::are_on_one_side(const Spatial& p, const Spatial& q) const
{
  return (weights(p).second > 0.) == (weights(q).second > 0.);
}

} // namespace CGAL::Geodesic_processing::internal
