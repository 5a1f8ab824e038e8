// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_QUADRIC_FIT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_QUADRIC_FIT_H

#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

// Fits a quadric
//
//   height(x, y) = c_0 + c_1 x + c_2 y + c_3 x^2 / 2 + c_4 x y + c_5 y^2 / 2
//
// to weighted heights and slopes over a plane, by least squares.
class Quadric_fit
{
public:
  using Coefficients = std::array<double, 6>;

  // The monomials of a point, or their means over several points.
  struct Moments
  {
    double x, y, xx, xy, yy;
  };

  static double height(const Coefficients& c, const Moments& p)
  {
    return c[0] + c[1] * p.x + c[2] * p.y + 0.5 * (c[3] * p.xx + c[5] * p.yy) + c[4] * p.xy;
  }

  void add_height(double weight, const Moments& p, double height)
  {
    const Coefficients row = {1., p.x, p.y, 0.5 * p.xx, p.xy, 0.5 * p.yy};
    for(int i = 0; i < 6; ++i)
    {
      const double factor = weight * row[i];
      for(int j = 0; j <= i; ++j)
        m_matrix[i][j] += factor * row[j];
      m_rhs[i] += factor * height;
    }
  }

  void add_slopes(double weight, const Moments& p, double slope_x, double slope_y)
  {
    // The rows of the two slopes are 0 1 0 x y 0 and 0 0 1 0 x y.
    const double x = weight * p.x, y = weight * p.y;
    m_matrix[1][1] += weight;
    m_matrix[2][2] += weight;
    m_matrix[3][1] += x;
    m_matrix[4][1] += y;
    m_matrix[4][2] += x;
    m_matrix[5][2] += y;
    m_matrix[3][3] += x * p.x;
    m_matrix[4][3] += x * p.y;
    m_matrix[4][4] += x * p.x + y * p.y;
    m_matrix[5][4] += x * p.y;
    m_matrix[5][5] += y * p.y;
    m_rhs[1] += weight * slope_x;
    m_rhs[2] += weight * slope_y;
    m_rhs[3] += x * slope_x;
    m_rhs[4] += y * slope_x + x * slope_y;
    m_rhs[5] += y * slope_y;
  }

  // Computes the Cholesky factor of the normal equations. Returns the number of coefficients that
  // the data determine: 6, 3 (a plane) or 0. A pivot below 1e-12 of its diagonal entry counts as
  // zero.
  int factorize()
  {
    m_factor = m_matrix;
    for(int i = 0; i < 6; ++i)
      for(int j = 0; j <= i; ++j)
      {
        double sum = m_matrix[i][j];
        for(int k = 0; k < j; ++k)
          sum -= m_factor[i][k] * m_factor[j][k];
        if(i == j && !(sum > 1e-12 * m_matrix[i][i]))
          return i < 3 ? 0 : 3;
        m_factor[i][j] = i == j ? std::sqrt(sum) : sum / m_factor[j][j];
      }
    return 6;
  }

  // Returns the fit with the first `number_of_coefficients` coefficients; the others are zero. The
  // function factorize() must be called before.
  Coefficients coefficients(int number_of_coefficients) const
  {
    return solve(m_rhs, number_of_coefficients);
  }

  // Returns the variance of c_i, i < 3, if the weights are inverse variances.
  double variance(int i, int number_of_coefficients) const
  {
    Coefficients unit = {};
    unit[i] = 1.;
    return solve(unit, number_of_coefficients)[i];
  }

private:
  Coefficients solve(Coefficients c, int number_of_coefficients) const
  {
    for(int i = 0; i < number_of_coefficients; ++i)
    {
      for(int k = 0; k < i; ++k)
        c[i] -= m_factor[i][k] * c[k];
      c[i] /= m_factor[i][i];
    }
    for(int i = number_of_coefficients - 1; i >= 0; --i)
    {
      for(int k = i + 1; k < number_of_coefficients; ++k)
        c[i] -= m_factor[k][i] * c[k];
      c[i] /= m_factor[i][i];
    }
    for(int i = number_of_coefficients; i < 6; ++i)
      c[i] = 0.;
    return c;
  }

  std::array<Coefficients, 6> m_matrix = {}, m_factor = {}; // lower triangles
  Coefficients m_rhs = {};
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_QUADRIC_FIT_H
