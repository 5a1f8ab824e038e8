// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "operators/eigenfunctions.h"
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

template <typename Scalar>
using Column = Eigen::Array<Scalar, Eigen::Dynamic, 1>;

// Lengths of the vectors of a column, whose second components follow the first ones.
template <typename Vectors>
auto lengths(const Vectors& column)
{
  const Eigen::Index n = column.size() / 2;
  return (column.head(n).array().square() + column.tail(n).array().square()).sqrt();
}

// Many problems of one basis: for each column p, the least sum of weight |w| over all w in p + span Q,
// where Q are orthonormal columns that are orthogonal to p.  By the alternating direction method of
// multipliers (Boyd et al. 2011, section 6), in which the step for the coefficients is a product with
// the transpose of Q.
template <typename Matrix_type>
class Group_lasso
{
public:
  using Scalar = typename Matrix_type::Scalar;

  Group_lasso(const Matrix_type& basis, const Column<Scalar>& weight, Matrix_type particular)
      : m_basis(basis), m_sqrt_area(weight), m_particular(std::move(particular)),
        m_primal(m_particular), m_dual(Matrix_type::Zero(m_primal.rows(), m_primal.cols())),
        m_threshold(m_primal.cols())
  {
    const Scalar area = m_sqrt_area.square().sum();
    for(Eigen::Index j = 0; j < m_primal.cols(); ++j)
      m_threshold[j] = threshold_factor * m_particular.col(j).norm() / std::sqrt(area);
  }

  Eigen::Index columns() const { return m_particular.cols(); }

  void advance()
  {
    m_argument = m_primal - m_dual;
    transposed_product(m_basis, m_argument, m_coefficients);
    product(m_basis, m_coefficients, m_field);
    m_field += m_particular;
    const Eigen::Index n = m_sqrt_area.size();
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
      factor = (1 - m_threshold[j] * m_sqrt_area / factor).max(Scalar(0));
      m_primal.col(j).head(n) = (factor * x).matrix();
      m_primal.col(j).tail(n) = (factor * y).matrix();
      m_dual.col(j).head(n) = ((1 - factor) * x).matrix();
      m_dual.col(j).tail(n) = ((1 - factor) * y).matrix();
    }
  }

  // Of the last step, with which p + Q c is what it found.
  const Matrix_type& coefficients() const { return m_coefficients; }

  auto sum(Eigen::Index j) const { return m_field.col(j); }
  Scalar upper(Eigen::Index j) const { return (m_sqrt_area * lengths(m_field.col(j))).sum(); }
  // What the step took away is orthogonal to Q.
  Scalar lower(Eigen::Index j) const
  {
    const Column<Scalar> slope = (m_field.col(j) - m_argument.col(j)).array();
    const Scalar max_slope = (lengths(slope) / m_sqrt_area.max(min_length)).maxCoeff();
    return max_slope > 0 ? m_particular.col(j).dot(slope.matrix()) / max_slope : 0;
  }

  // Drops a column: the last one takes its place.
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
  // Times the mean square of the particular field's vectors; of a tenth to eight the quickest.
  static constexpr Scalar threshold_factor = Scalar(0.4);
  static constexpr Scalar min_length = std::numeric_limits<Scalar>::min();

  const Matrix_type& m_basis;
  const Column<Scalar>& m_sqrt_area;
  Matrix_type m_particular, m_primal, m_dual, m_argument, m_field, m_coefficients;
  Column<Scalar> m_threshold;
};

// Makes columns orthonormal; those that the others span are dropped.  Returns what they were multiplied
// with.
Matrix orthonormalize(Matrix& columns)
{
  Matrix gram, result;
  transposed_product(columns, columns, gram);
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(gram);
  const Eigen::Index n = gram.rows();
  Eigen::Index rank = 0;
  while(rank < n && solver.eigenvalues()[n - 1 - rank] > 1e-10 * solver.eigenvalues()[n - 1])
    ++rank;
  const Matrix factor = solver.eigenvectors().rightCols(rank) *
                        solver.eigenvalues().tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
  product(columns, factor, result);
  columns = std::move(result);
  return factor;
}

// Asks a callback, from several threads, one at a time.
class Progress
{
public:
  Progress(const std::function<bool(double)>& callback, std::size_t steps)
      : m_callback(callback), m_steps(steps)
  {}

  // False when the rest need not be done.
  bool should_continue()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_callback && !m_is_cancelled)
      m_is_cancelled = !m_callback(double(m_number_of_calls) / double(m_steps));
    ++m_number_of_calls;
    return !m_is_cancelled;
  }
  bool is_cancelled() const { return m_is_cancelled; }

private:
  const std::function<bool(double)>& m_callback;
  std::size_t m_steps, m_number_of_calls = 0;
  std::mutex m_mutex;
  std::atomic<bool> m_is_cancelled{false};
};

// Closes the bounds of columns, whose upper ones are those of the particular fields, as far as is asked
// for.  improved(j, w) gets whatever is shorter than what was known of column j; should_continue(i) is asked before
// each iteration.
template <typename On_improvement, typename Should_continue>
std::vector<Transport_bounds>
solve_group_lasso(const Matrix& basis, const Column<double>& weight, Matrix particular,
                  const Spectral_transport_options& options, const On_improvement& on_improvement,
                  const Should_continue& should_continue)
{
  std::vector<Transport_bounds> result(std::size_t(particular.cols()));
  for(std::size_t j = 0; j < result.size(); ++j)
  {
    const auto column = particular.col(Eigen::Index(j));
    on_improvement(j, column);
    result[j].upper = (weight * lengths(column)).sum();
    result[j].lower = basis.cols() == 0 ? result[j].upper : 0.;
  }
  if(basis.cols() == 0)
    return result;
  std::vector<std::size_t> column_index(result.size()); // of the columns that are left
  std::iota(column_index.begin(), column_index.end(), std::size_t(0));
  Group_lasso<Matrix> sums(basis, weight, std::move(particular));
  for(unsigned i = 1;
      i <= options.maximum_iterations && !column_index.empty() && should_continue(i); ++i)
  {
    sums.advance();
    if(i % 4 != 0)
      continue;
    for(Eigen::Index j = sums.columns() - 1; j >= 0; --j)
    {
      Transport_bounds& bounds = result[column_index[std::size_t(j)]];
      bounds.iterations = i;
      if(const double upper = sums.upper(j); upper < bounds.upper)
      {
        bounds.upper = upper;
        on_improvement(column_index[std::size_t(j)], sums.sum(j));
      }
      bounds.lower = std::min(std::max(bounds.lower, sums.lower(j)), bounds.upper);
      if(!bounds.are_within(options.tolerance))
        continue;
      sums.remove_column(j);
      column_index[std::size_t(j)] = column_index.back();
      column_index.pop_back();
    }
  }
  return result;
}

constexpr std::size_t columns_per_block = 32;

} // namespace

// Groups of triangles around sites that are no neighbours of each other, eight or nine in each, with a
// plane for each group.
struct Spectral_transport::Clusters
{
  std::vector<Index> cluster; // #triangles
  std::vector<Vec2>
      frame_rotation;      // #triangles: what a vector is multiplied with as a complex number
  Float_matrix full_basis; // the family's basis
  Float_matrix basis;      // of mean vectors in clusters, orthonormal
  Float_matrix to_full_coefficients; // coefficients of that basis to those of the whole one
  Column<float> weight;              // #clusters: roots of areas

  Clusters(const Surface_arrays& triangles, const Operators& operators, const Matrix& family_basis)
      : full_basis(family_basis.cast<float>())
  {
    std::size_t number = assign_clusters(triangles, operators);
    // Few of them could not tell the basis's functions apart.
    if(number < 3 * std::size_t(family_basis.cols()))
    {
      number = cluster.size();
      std::iota(cluster.begin(), cluster.end(), Index(0));
    }
    weight = Column<float>::Zero(Eigen::Index(number));
    std::vector<double> area(number, 0.);
    for(std::size_t f = 0; f < cluster.size(); ++f)
      area[cluster[f]] += operators.area[f];
    for(std::size_t c = 0; c < number; ++c)
      weight[Eigen::Index(c)] = float(std::sqrt(area[c]));
    align_frames(triangles, operators, area);
    Matrix means = this->means(family_basis);
    to_full_coefficients = orthonormalize(means).cast<float>();
    basis = means.cast<float>();
  }

  // The mean vector in each cluster, times the root of its area.
  template <typename Matrix_type>
  Matrix_type means(const Matrix_type& columns) const
  {
    const Eigen::Index n = Eigen::Index(cluster.size()), m = weight.size();
    Matrix_type result = Matrix_type::Zero(2 * m, columns.cols());
    for(Eigen::Index j = 0; j < columns.cols(); ++j)
      for(Eigen::Index f = 0; f < n; ++f)
      {
        using Scalar = typename Matrix_type::Scalar;
        const Vec2& s = frame_rotation[f];
        const Scalar a = Scalar(s[0]), b = Scalar(s[1]), x = columns(f, j), y = columns(n + f, j);
        result(cluster[f], j) += a * x - b * y;
        result(m + cluster[f], j) += b * x + a * y;
      }
    return result;
  }

private:
  std::size_t assign_clusters(const Surface_arrays& triangles, const Operators& operators)
  {
    const std::size_t n = operators.number_of_triangles();
    cluster.assign(n, none);
    std::size_t number = 0;
    if(triangles.point.empty()) // no planes: each triangle has its own
    {
      for(Index f = 0; f < n; ++f)
        cluster[f] = Index(number++);
      return number;
    }
    std::vector<Index> cluster_of(operators.number_of_vertices,
                                  none); // that of the site or a neighbour
    for(Index vertex = 0; vertex < cluster_of.size(); ++vertex)
    {
      if(cluster_of[vertex] != none ||
         triangles.ring_begin[vertex] == triangles.ring_begin[vertex + 1])
        continue;
      const Index own = Index(number++);
      for(Index k = triangles.ring_begin[vertex]; k < triangles.ring_begin[vertex + 1]; ++k)
      {
        const Index f = triangles.ring[k] / 3;
        cluster[f] = own;
        for(Index c = 3 * f; c < 3 * f + 3; ++c)
          if(cluster_of[triangles.corner[c]] == none)
            cluster_of[triangles.corner[c]] = own;
      }
      cluster_of[vertex] = own;
    }
    for(Index f = 0; f < n; ++f)
      if(cluster[f] == none)
        cluster[f] = cluster_of[triangles.corner[3 * f]];
    return number;
  }

  void align_frames(const Surface_arrays& triangles, const Operators& operators,
                    const std::vector<double>& area)
  {
    const std::size_t n = cluster.size();
    frame_rotation.assign(n, Vec2{0., 0.});
    std::vector<Vec3> first(n), second(n), normal(area.size(), Vec3{0., 0., 0.});
    for(std::size_t f = 0; f < n && !triangles.point.empty(); ++f)
    {
      const Vec3& p = triangles.point[triangles.corner[3 * f]];
      const Vec3 a = triangles.point[triangles.corner[3 * f + 1]] - p;
      const Vec3 b = triangles.point[triangles.corner[3 * f + 2]] - p;
      const Vec3 doubled_normal = cross(a, b);
      if(!(operators.area[f] > 0.) || !(norm(doubled_normal) > 0.))
        continue;
      first[f] = unit(a);
      second[f] = cross(unit(doubled_normal), first[f]);
      normal[cluster[f]] = normal[cluster[f]] + doubled_normal;
    }
    std::vector<Index> reference_triangle(area.size(),
                                          none); // a triangle whose first axis is the plane's
    for(Index f = 0; f < n; ++f)
    {
      if(!(operators.area[f] > 0.))
        continue;
      const std::size_t c = cluster[f];
      Vec2 rotation = {1., 0.};
      if(!triangles.point.empty() && norm(normal[c]) > 0.)
      {
        if(reference_triangle[c] == none)
          reference_triangle[c] = f;
        const Vec3 unit_normal = unit(normal[c]);
        const Vec3 y = cross(unit_normal, first[reference_triangle[c]]), x = cross(y, unit_normal);
        // The nearest rotation to the projection.
        rotation = {dot(first[f], x) + dot(second[f], y), dot(first[f], y) - dot(second[f], x)};
        const double size = norm(rotation);
        rotation = size > 0. ? (1. / size) * rotation : Vec2{1., 0.};
      }
      frame_rotation[f] = std::sqrt(operators.area[f] / area[c]) * rotation;
    }
  }
};

Spectral_transport::Spectral_transport(std::shared_ptr<const Surface_arrays> triangles,
                                       std::size_t k, Particular_field kind)
    : m_triangles(std::move(triangles)), m_operators(internal::operators(*m_triangles))
{
  if(std::none_of(m_operators.area.begin(), m_operators.area.end(),
                  [](double area) { return area > 0.; }))
    throw Unsupported_surface_error("The surface has no triangle with an area to move masses on.");
  m_number_of_components = components(m_operators).second;
  m_particular = std::make_unique<Particular_fields>(*m_triangles, m_operators, kind, k > 0);
  const auto n = Eigen::Index(m_operators.number_of_triangles());
  m_sqrt_area.resize(n);
  for(Eigen::Index f = 0; f < n; ++f)
    m_sqrt_area[f] = std::sqrt(m_operators.area[f]);
  m_basis.resize(2 * n, 0);
  if(k == 0)
    return;

  const Eigenfunctions eigen = eigenfunctions(*m_triangles, m_operators, k);
  m_basis_size = std::size_t(eigen.value.size());
  const Matrix slopes =
      gradients(m_operators, eigen.function * eigen.value.cwiseSqrt().cwiseInverse().asDiagonal());
  const Matrix& harmonic = m_particular->harmonic_fields();
  m_basis.resize(2 * n, slopes.cols() + harmonic.cols());
  m_basis.topLeftCorner(n, slopes.cols()) = -slopes.bottomRows(n);
  m_basis.bottomLeftCorner(n, slopes.cols()) = slopes.topRows(n);
  m_basis.rightCols(harmonic.cols()) = harmonic;
  if(m_triangles->is_cloud())
    m_basis = m_particular->without_gradients(m_basis);
  if(m_basis.cols() == 0)
    return;
  orthonormalize(m_basis);
  m_clusters = std::make_unique<Clusters>(*m_triangles, m_operators, m_basis);
}

Spectral_transport::~Spectral_transport() = default;

// What is missing on each component, and there in all.
std::vector<double> Spectral_transport::column_masses(const Masses& masses,
                                                      Eigen::Index column) const
{
  std::vector<double> result(m_number_of_components, 0.);
  for(Masses::InnerIterator it(masses, column); it; ++it)
    result[m_particular->component()[it.row()]] += it.value();
  return result;
}

bool Spectral_transport::is_balanced(const Masses& differences, Eigen::Index column) const
{
  double size = 0.;
  for(Masses::InnerIterator it(differences, column); it; ++it)
    size += std::abs(it.value());
  const std::vector<double> missing = column_masses(differences, column);
  return std::all_of(missing.begin(), missing.end(),
                     [&](double mass) { return std::abs(mass) <= 1e-9 * size; });
}

std::vector<Transport_bounds>
Spectral_transport::distances(const Masses& differences,
                              const Spectral_transport_options& options) const
{
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  const auto columns = std::size_t(differences.cols());
  std::vector<Transport_bounds> result(columns);
  Progress progress(options.callback, (columns + columns_per_block - 1) / columns_per_block);
  const auto solve = [&](std::size_t, std::size_t begin, std::size_t end)
  {
    if(!progress.should_continue())
      return;
    std::vector<std::size_t> column_index;
    std::vector<Eigen::Triplet<double>> entries;
    for(std::size_t j = begin; j < end; ++j)
    {
      if(!is_balanced(differences, Eigen::Index(j)))
      {
        result[j] = {infinity, infinity};
        continue;
      }
      for(Masses::InnerIterator it(differences, Eigen::Index(j)); it; ++it)
        entries.emplace_back(it.row(), Eigen::Index(column_index.size()), it.value());
      column_index.push_back(j);
    }
    if(column_index.empty())
      return;
    Masses masses(differences.rows(), Eigen::Index(column_index.size()));
    masses.setFromTriplets(entries.begin(), entries.end());
    const std::vector<Transport_bounds> bounds = solve_group_lasso(
        m_basis, m_sqrt_area.array(), m_particular->fields(masses), options,
        [](std::size_t, const auto&) {}, [](unsigned) { return true; });
    for(std::size_t i = 0; i < column_index.size(); ++i)
      result[column_index[i]] = bounds[i];
  };
  for_each_block(columns, columns_per_block, options.threads, solve);
  if(progress.is_cancelled())
    result.clear();
  return result;
}

Transport_result Spectral_transport::transport(const Vector& masses,
                                               const Spectral_transport_options& options) const
{
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  Transport_result result;
  const Masses column = masses.sparseView();
  Transport_bounds bounds = {infinity, infinity};
  if(is_balanced(column, 0))
  {
    Vector flow;
    bounds = solve_group_lasso(
                 m_basis, m_sqrt_area.array(), m_particular->fields(column), options,
                 [&](std::size_t, const auto& shorter_field) { flow = shorter_field; },
                 [&](unsigned i) {
                   return !options.callback ||
                          options.callback(double(i) / double(options.maximum_iterations));
                 })
                 .front();
    result.flow = as_field(m_operators, flow);
    if(const double moved = 0.5 * masses.lpNorm<1>(); moved > 0.)
      result.residual =
          (minus_divergence(m_operators, result.flow) - m_particular->balanced(masses))
              .lpNorm<Eigen::Infinity>() /
          moved;
  }
  result.lower = bounds.lower;
  result.upper = bounds.upper;
  result.value = result.estimate = bounds.value();
  result.iterations = bounds.iterations;
  result.converged = bounds.are_within(options.tolerance);
  return result;
}

Matrix Spectral_transport::all_pairs(const Masses& masses,
                                     const Spectral_transport_options& options) const
{
  const Eigen::Index n = masses.cols();
  Matrix result = Matrix::Zero(n, n);
  if(m_basis.cols() > 0)
  {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::Index pair = 0;
    for(Eigen::Index i = 0; i < n; ++i)
      for(Eigen::Index j = 0; j < i; ++j, ++pair)
      {
        for(Masses::InnerIterator it(masses, i); it; ++it)
          entries.emplace_back(it.row(), pair, it.value());
        for(Masses::InnerIterator it(masses, j); it; ++it)
          entries.emplace_back(it.row(), pair, -it.value());
      }
    Masses differences(masses.rows(), pair);
    differences.setFromTriplets(entries.begin(), entries.end());
    const std::vector<Transport_bounds> bounds = distances(differences, options);
    if(bounds.empty())
      return pair > 0 ? Matrix() : result;
    pair = 0;
    for(Eigen::Index i = 0; i < n; ++i)
      for(Eigen::Index j = 0; j < i; ++j, ++pair)
        result(i, j) = result(j, i) = bounds[pair].value();
    return result;
  }

  // Fields times areas, so that a difference's length is all that is summed.
  const Eigen::Index triangles = m_sqrt_area.size();
  Float_matrix fields(2 * triangles, n);
  Progress progress(options.callback, std::size_t(n) / columns_per_block + 17);
  for_each_block(std::size_t(n), columns_per_block, options.threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   if(!progress.should_continue())
                     return;
                   const Eigen::Index size = Eigen::Index(end - begin);
                   Matrix block =
                       m_particular->fields(masses.middleCols(Eigen::Index(begin), size));
                   block.topRows(triangles).array().colwise() *= m_sqrt_area.array();
                   block.bottomRows(triangles).array().colwise() *= m_sqrt_area.array();
                   fields.middleCols(Eigen::Index(begin), size) = block.cast<float>();
                 });
  // Few triangles at once stay in the cache for all pairs.  Sums of parts are added in their order.
  constexpr std::size_t triangles_per_block = 1024;
  const std::size_t number_of_blocks =
      (std::size_t(triangles) + triangles_per_block - 1) / triangles_per_block;
  constexpr std::size_t number_of_slices = 16;
  std::vector<Matrix> sums(number_of_slices);
  for_each_block(
      number_of_slices, 1, options.threads,
      [&](std::size_t slice, std::size_t, std::size_t)
      {
        if(!progress.should_continue())
          return;
        Matrix& sum = sums[slice];
        sum = Matrix::Zero(n, n);
        for(std::size_t block = slice * number_of_blocks / number_of_slices;
            block < (slice + 1) * number_of_blocks / number_of_slices; ++block)
        {
          const Eigen::Index begin = Eigen::Index(block * triangles_per_block);
          const Eigen::Index size = std::min(Eigen::Index(triangles_per_block), triangles - begin);
          const auto x = fields.middleRows(begin, size).array();
          const auto y = fields.middleRows(triangles + begin, size).array();
          for(Eigen::Index j = 0; j < n; ++j)
            for(Eigen::Index i = 0; i < j; ++i)
              sum(i, j) += double(
                  ((x.col(i) - x.col(j)).square() + (y.col(i) - y.col(j)).square()).sqrt().sum());
        }
      });
  if(progress.is_cancelled())
    return {};
  for(const Matrix& sum : sums)
    result += sum;
  std::vector<std::vector<double>> mass;
  for(Eigen::Index j = 0; j < n; ++j)
    mass.push_back(column_masses(masses, j));
  for(Eigen::Index j = 0; j < n; ++j)
    for(Eigen::Index i = 0; i < j; ++i)
    {
      for(std::size_t c = 0; c < m_number_of_components; ++c)
        if(std::abs(mass[i][c] - mass[j][c]) > 1e-9)
          result(i, j) = infinity;
      result(j, i) = result(i, j);
    }
  return result;
}

Vector Spectral_transport::one_to_all(const Masses& source,
                                      const Spectral_transport_options& options) const
{
  const std::size_t n = m_operators.number_of_vertices;
  Vector result = Vector::Constant(Eigen::Index(n), infinity);
  const std::vector<double> mass = column_masses(source, 0);
  const Vector area = lumped_mass(m_operators);
  std::vector<Index> targets;
  for(Index vertex = 0; vertex < n; ++vertex)
    if(area[vertex] > 0. && std::abs(mass[m_particular->component()[vertex]] - 1.) <= 1e-9)
      targets.push_back(vertex);
  const Vector from = m_particular->fields(source);
  const auto length = [&](const auto& field)
  { return (m_sqrt_area.array() * lengths(field)).sum(); };
  Progress progress(options.callback, (targets.size() + columns_per_block - 1) / columns_per_block);
  const auto solve = [&](std::size_t, std::size_t begin, std::size_t end)
  {
    if(!progress.should_continue())
      return;
    Masses masses(Eigen::Index(n), Eigen::Index(end - begin));
    for(std::size_t i = begin; i < end; ++i)
      masses.insert(targets[i], Eigen::Index(i - begin)) = 1.;
    Vector field;
    if(!m_clusters)
      return m_particular->for_each_field(masses, [&](Eigen::Index j, const Vector& column)
                                          { result[targets[begin + j]] = length(column - from); });
    Float_matrix fields(from.size(), masses.cols());
    m_particular->for_each_field(masses, [&](Eigen::Index j, const Vector& column)
                                 { fields.col(j) = (column - from).cast<float>(); });
    fields += coarse_correction(fields);
    for(std::size_t i = begin; i < end; ++i)
    {
      field = fields.col(Eigen::Index(i - begin)).cast<double>();
      result[targets[i]] = length(field);
    }
  };
  for_each_block(targets.size(), columns_per_block, options.threads, solve);
  for(Masses::InnerIterator it(source, 0); it; ++it)
    if(it.value() == 1.)
      result[it.row()] = 0.;
  if(progress.is_cancelled())
    result.resize(0);
  return result;
}

// For columns p, what of the basis makes their sums nearly the least.
Float_matrix Spectral_transport::coarse_correction(const Float_matrix& fields) const
{
  Float_matrix particular = m_clusters->means(fields), coarse_coefficients, projected, result;
  transposed_product(m_clusters->basis, particular, coarse_coefficients);
  product(m_clusters->basis, coarse_coefficients, projected);
  particular -= projected;
  Group_lasso<Float_matrix> sums(m_clusters->basis, m_clusters->weight, std::move(particular));
  for(int i = 0; i < 32; ++i) // more gain less than clusters lose
    sums.advance();
  const Float_matrix coefficients =
      m_clusters->to_full_coefficients * (sums.coefficients() - coarse_coefficients);
  product(m_clusters->full_basis, coefficients, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
