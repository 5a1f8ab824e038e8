// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_FRAME_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_FRAME_H

#include "numerics/Quadric_fit.h"
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

inline constexpr double min_normal_cosine =
    0.5; // 60 degrees: excludes the other side of a thin sheet

// The mean of a cluster of surfels.
struct Surfel_mean
{
  Vec3 point = {0., 0., 0.}, normal = {0., 0., 0.};
  std::array<double, 6> covariance = {}; // of the points: xx, yy, zz, yz, zx, xy
};

// Returns p^T S q for a symmetric matrix S in the order of Surfel_mean::covariance.
inline double quadratic_form(const std::array<double, 6>& s, const Vec3& p, const Vec3& q)
{
  return s[0] * p[0] * q[0] + s[1] * p[1] * q[1] + s[2] * p[2] * q[2] +
         s[3] * (p[1] * q[2] + p[2] * q[1]) + s[4] * (p[2] * q[0] + p[0] * q[2]) +
         s[5] * (p[0] * q[1] + p[1] * q[0]);
}

struct Surfel
{
  Vec3 point, normal;
};

// The coordinates in which the surface is a height field over the plane of a surfel. Their unit is
// its spacing.
class Surfel_frame
{
public:
  // The spacing must be positive.
  Surfel_frame(const Vec3& origin, const Vec3& normal, double spacing)
      : m_origin(origin), m_normal(normal), m_inverse_spacing(1. / spacing)
  {
    std::tie(m_u, m_v) = tangent_frame(m_normal);
  }

  struct Sample
  {
    Quadric_fit::Moments monomials;
    double height, slope_x, slope_y;
  };
  // Computes the coordinates and slopes of a surfel. Returns false if its normal differs by more
  // than 60 degrees.
  bool project(const Vec3& point, const Vec3& normal, Sample& sample) const
  {
    const double cosine = dot(normal, m_normal);
    if(!(cosine > min_normal_cosine))
      return false;
    const Vec3 offset = m_inverse_spacing * (point - m_origin);
    const double x = dot(offset, m_u), y = dot(offset, m_v);
    sample = {{x, y, x * x, x * y, y * y},
              dot(offset, m_normal),
              -dot(normal, m_u) / cosine,
              -dot(normal, m_v) / cosine};
    return true;
  }
  // Computes those of a cluster. The covariance is added to the second moments, so that fitting
  // the mean equals fitting all points of the cluster to second order.
  bool project(const Surfel_mean& mean, Sample& sample) const
  {
    if(!project(mean.point, mean.normal, sample))
      return false;
    const double squared_scale = m_inverse_spacing * m_inverse_spacing;
    sample.monomials.xx += squared_scale * quadratic_form(mean.covariance, m_u, m_u);
    sample.monomials.xy += squared_scale * quadratic_form(mean.covariance, m_u, m_v);
    sample.monomials.yy += squared_scale * quadratic_form(mean.covariance, m_v, m_v);
    return true;
  }

  // Subtracts the terms above the second order from the height and the slopes of a sample. Let H
  // be the Hessian of the fit. The height of the surface is assumed to be x^T H
  // x / (1 + sqrt(1 - |H x|^2)), which is exact for spheres and cylinders.
  static void remove_higher_order_terms(const Quadric_fit::Coefficients& c, Sample& sample)
  {
    const Quadric_fit::Moments& p = sample.monomials;
    const double x = c[3] * p.x + c[4] * p.y, y = c[4] * p.x + c[5] * p.y;
    const double cosine = std::sqrt(1. - std::min(x * x + y * y, max_squared_sine));
    sample.height -= (c[3] * p.xx + 2. * c[4] * p.xy + c[5] * p.yy) * (1. / (1. + cosine) - 0.5);
    sample.slope_x -= x * (1. / cosine - 1.);
    sample.slope_y -= y * (1. / cosine - 1.);
  }

  // Returns the projection (of first order) of a nearby point to a fit, and the normal of the fit
  // there.
  Surfel moved_to_fit(const Vec3& point, const Quadric_fit::Coefficients& c) const
  {
    const Vec3 offset = m_inverse_spacing * (point - m_origin);
    const double x = dot(offset, m_u), y = dot(offset, m_v);
    const double height_offset =
        Quadric_fit::height(c, {x, y, x * x, x * y, y * y}) - dot(offset, m_normal);
    const Vec3 scaled_normal =
        m_normal - (c[1] + c[3] * x + c[4] * y) * m_u - (c[2] + c[4] * x + c[5] * y) * m_v;
    const double length = norm(scaled_normal);
    return {point + height_offset / (m_inverse_spacing * length * length) * scaled_normal,
            (1. / length) * scaled_normal};
  }

private:
  // The squared sine of 60 degrees: the slope at which normals are rejected.
  static constexpr double max_squared_sine = 1. - min_normal_cosine * min_normal_cosine;

  Vec3 m_origin, m_normal, m_u, m_v;
  double m_inverse_spacing;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_FRAME_H
