// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_GROUP_LASSO_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_GROUP_LASSO_H

#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

template <typename Scalar>
using Column = Eigen::Array<Scalar, Eigen::Dynamic, 1>;

// Returns the lengths of the vectors of a column, whose second components follow the first
// components.
template <typename Vectors>
auto lengths(const Vectors& column)
{
  const Eigen::Index n = column.size() / 2;
  return (column.head(n).array().square() + column.tail(n).array().square()).sqrt();
}

// Solves group lasso problems with a common basis: for each column p, minimizes the sum of weight
// |w| over all fields w in p + span Q. The columns of Q must be orthonormal and orthogonal to p.
// The method is ADMM (Boyd et al. 2011, section 6); its linear step is a product with the transpose
// of Q.
template <typename Matrix_type>
class Group_lasso
{
public:
  using Scalar = typename Matrix_type::Scalar;

  Group_lasso(const Matrix_type& basis, const Column<Scalar>& weight, Matrix_type particular)
      : m_basis(basis), m_weight(weight), m_particular(std::move(particular)),
        m_primal(m_particular), m_dual(Matrix_type::Zero(m_primal.rows(), m_primal.cols())),
        m_threshold(m_primal.cols())
  {
    const Scalar squared_weight = m_weight.square().sum();
    for(Eigen::Index j = 0; j < m_primal.cols(); ++j)
      m_threshold[j] = threshold_factor * m_particular.col(j).norm() / std::sqrt(squared_weight);
  }

  Eigen::Index columns() const { return m_particular.cols(); }

  // Performs one ADMM iteration with over-relaxation.
  void advance()
  {
    m_argument = m_primal - m_dual;
    transposed_product(m_basis, m_argument, m_coefficients);
    product(m_basis, m_coefficients, m_field);
    m_field += m_particular;
    const Eigen::Index n = m_weight.size();
    Column<Scalar> x(n), y(n), factor(n);
    for(Eigen::Index j = 0; j < columns(); ++j)
    {
      const auto relaxed = [&](Eigen::Index from)
      {
        return relaxation_factor * m_field.col(j).segment(from, n).array() +
               (1 - relaxation_factor) * m_primal.col(j).segment(from, n).array() +
               m_dual.col(j).segment(from, n).array();
      };
      x = relaxed(0);
      y = relaxed(n);
      factor = (x.square() + y.square()).sqrt().max(min_length);
      factor = (1 - m_threshold[j] * m_weight / factor).max(Scalar(0));
      m_primal.col(j).head(n) = (factor * x).matrix();
      m_primal.col(j).tail(n) = (factor * y).matrix();
      m_dual.col(j).head(n) = ((1 - factor) * x).matrix();
      m_dual.col(j).tail(n) = ((1 - factor) * y).matrix();
    }
  }

  // Returns c of the last iteration: the current field is p + Q c.
  const Matrix_type& coefficients() const { return m_coefficients; }

  auto field(Eigen::Index j) const { return m_field.col(j); }
  // Returns the cost of the current field, an upper bound of the minimum.
  Scalar upper(Eigen::Index j) const { return (m_weight * lengths(m_field.col(j))).sum(); }
  // Returns a lower bound by duality: the residual of the linear step is orthogonal to Q.
  Scalar lower(Eigen::Index j) const
  {
    const Column<Scalar> slope = (m_field.col(j) - m_argument.col(j)).array();
    const Scalar max_slope = (lengths(slope) / m_weight.max(min_length)).maxCoeff();
    return max_slope > 0 ? m_particular.col(j).dot(slope.matrix()) / max_slope : 0;
  }

  // Removes column j and moves the last column to its index.
  void remove_column(Eigen::Index j)
  {
    const Eigen::Index last = columns() - 1;
    for(Matrix_type* m :
        {&m_particular, &m_primal, &m_dual, &m_argument, &m_field, &m_coefficients})
    {
      m->col(j).swap(m->col(last));
      m->conservativeResize(Eigen::NoChange, last);
    }
    m_threshold[j] = m_threshold[last];
  }

private:
  static constexpr Scalar relaxation_factor = Scalar(1.7);
  // Threshold relative to the root mean square of the particular field. Among values from 0.1 to 8,
  // this one needs the fewest iterations.
  static constexpr Scalar threshold_factor = Scalar(0.4);
  static constexpr Scalar min_length = std::numeric_limits<Scalar>::min();

  const Matrix_type& m_basis;
  const Column<Scalar>& m_weight;
  Matrix_type m_particular, m_primal, m_dual, m_argument, m_field, m_coefficients;
  Column<Scalar> m_threshold;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_GROUP_LASSO_H
