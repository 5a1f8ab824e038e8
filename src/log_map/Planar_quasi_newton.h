// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_PLANAR_QUASI_NEWTON_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_PLANAR_QUASI_NEWTON_H

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

namespace CGAL::Geodesic_processing::internal {

// The approximation of the Hessian in a tangent plane by the BFGS formula. The matrix remains
// positive definite by Powell's damping (Nocedal and Wright, Numerical Optimization, 18.2).
class Planar_quasi_newton
{
public:
  void reset() { *this = Planar_quasi_newton(); }
  bool is_identity() const { return m_xx == 1. && m_yy == 1. && m_xy == 0.; }

  // Returns the step to the minimum of the quadratic model.
  Vec2 step(const Vec2& negative_gradient) const
  {
    const double determinant = m_xx * m_yy - m_xy * m_xy;
    return (1. / determinant) * Vec2{m_yy * negative_gradient[0] - m_xy * negative_gradient[1],
                                     m_xx * negative_gradient[1] - m_xy * negative_gradient[0]};
  }

  // Changes to other axes, in which a vector v becomes rotated(v, rotation).
  void rotate(const Vec2& rotation)
  {
    const Vec2 x = product(rotated_back({1., 0.}, rotation)),
               y = product(rotated_back({0., 1.}, rotation));
    const Vec2 column_x = rotated(x, rotation), column_y = rotated(y, rotation);
    m_xx = column_x[0];
    m_xy = 0.5 * (column_x[1] + column_y[0]);
    m_yy = column_y[1];
  }

  // Adds the change of the gradient by a step; both in the present axes.
  void update(const Vec2& step, const Vec2& gradient_change)
  {
    const Vec2 predicted = product(step);
    const double predicted_curvature = dot(step, predicted), curvature = dot(step, gradient_change);
    if(!(predicted_curvature > 0.))
      return;
    constexpr double min_ratio = 0.1;
    const double fraction =
        curvature >= min_ratio * predicted_curvature
            ? 1.
            : (1. - min_ratio) * predicted_curvature / (predicted_curvature - curvature);
    const Vec2 change = fraction * gradient_change + (1. - fraction) * predicted;
    const double changed_curvature = dot(step, change);
    const auto updated = [&](double entry, int i, int j)
    {
      return entry - predicted[i] * predicted[j] / predicted_curvature +
             change[i] * change[j] / changed_curvature;
    };
    const Planar_quasi_newton previous = *this;
    m_xx = updated(m_xx, 0, 0);
    m_xy = updated(m_xy, 0, 1);
    m_yy = updated(m_yy, 1, 1);
    // Round-off errors of changes between almost equal gradients.
    if(!(m_xx * m_yy - m_xy * m_xy > 1e-6 * (m_xx + m_yy) * (m_xx + m_yy)))
      *this = previous;
  }

private:
  Vec2 product(const Vec2& v) const
  {
    return {m_xx * v[0] + m_xy * v[1], m_xy * v[0] + m_yy * v[1]};
  }

  double m_xx = 1., m_xy = 0., m_yy = 1.;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_PLANAR_QUASI_NEWTON_H
