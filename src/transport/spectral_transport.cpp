// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "numerics/dense_solvers.h"
#include "operators/eigenfunctions.h"
#include "transport/Group_lasso.h"
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Makes the columns orthonormal and removes linearly dependent ones. Returns the factor F with
// result = columns F.
Matrix orthonormalize(Matrix& columns)
{
  Matrix gram, result;
  transposed_product(columns, columns, gram);
  const Eigen_system solver = eigen_system(gram);
  const Eigen::Index n = gram.rows();
  Eigen::Index rank = 0;
  while(rank < n && solver.values[n - 1 - rank] > 1e-10 * solver.values[n - 1])
    ++rank;
  const Matrix factor = solver.vectors.rightCols(rank) *
                        solver.values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
  product(columns, factor, result);
  columns = std::move(result);
  return factor;
}

// Calls a callback from several threads, one at a time.
class Progress
{
public:
  Progress(const std::function<bool(double)>& callback, std::size_t steps)
      : m_callback(callback), m_steps(steps)
  {}

  // Returns false if the callback has cancelled.
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

// Computes bounds for each column of particular fields. The iteration ends for a column when its
// bounds are within the tolerance. Calls on_improvement(j, field) when a shorter field of column j
// is found, and should_continue(i) before iteration i.
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
  // the columns that are not yet within the tolerance
  std::vector<std::size_t> column_index(result.size());
  std::iota(column_index.begin(), column_index.end(), std::size_t(0));
  Group_lasso<Matrix> solver(basis, weight, std::move(particular));
  for(unsigned i = 1;
      i <= options.maximum_iterations && !column_index.empty() && should_continue(i); ++i)
  {
    solver.advance();
    if(i % 4 != 0)
      continue;
    for(Eigen::Index j = solver.columns() - 1; j >= 0; --j)
    {
      Transport_bounds& bounds = result[column_index[std::size_t(j)]];
      bounds.number_of_iterations = i;
      if(const double upper = solver.upper(j); upper < bounds.upper)
      {
        bounds.upper = upper;
        on_improvement(column_index[std::size_t(j)], solver.field(j));
      }
      bounds.lower = std::min(std::max(bounds.lower, solver.lower(j)), bounds.upper);
      if(!bounds.are_within(options.tolerance))
        continue;
      solver.remove_column(j);
      column_index[std::size_t(j)] = column_index.back();
      column_index.pop_back();
    }
  }
  return result;
}

constexpr std::size_t columns_per_block = 32;

// The number of partial sums is fixed, so that results do not depend on the number of threads.
constexpr std::size_t number_of_slices = 16;

// Returns column i minus column j for each pair j < i, in the order of i, then j.
Masses pairwise_differences(const Masses& masses)
{
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Index pair = 0;
  for(Eigen::Index i = 0; i < masses.cols(); ++i)
    for(Eigen::Index j = 0; j < i; ++j, ++pair)
    {
      for(Masses::InnerIterator it(masses, i); it; ++it)
        entries.emplace_back(it.row(), pair, it.value());
      for(Masses::InnerIterator it(masses, j); it; ++it)
        entries.emplace_back(it.row(), pair, -it.value());
    }
  Masses result(masses.rows(), pair);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// Returns the particular fields times the square root of the area, in single precision. With this
// weight, the integral of a length is a sum of lengths.
Float_matrix area_weighted_fields(const Particular_fields& particular, const Vector& sqrt_area,
                                  const Masses& masses, unsigned number_of_threads,
                                  Progress& progress)
{
  const Eigen::Index triangles = sqrt_area.size();
  Float_matrix result(2 * triangles, masses.cols());
  for_each_block(std::size_t(masses.cols()), columns_per_block, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   if(!progress.should_continue())
                     return;
                   const Eigen::Index size = Eigen::Index(end - begin);
                   Matrix block = particular.fields(masses.middleCols(Eigen::Index(begin), size));
                   block.topRows(triangles).array().colwise() *= sqrt_area.array();
                   block.bottomRows(triangles).array().colwise() *= sqrt_area.array();
                   result.middleCols(Eigen::Index(begin), size) = block.cast<float>();
                 });
  return result;
}

// Returns for columns i < j the sum over all triangles of the length of the difference vector.
// Blocks of triangles stay in the cache for all pairs. The partial sums are added in a fixed order.
Matrix pairwise_sums_of_lengths(const Float_matrix& fields, unsigned number_of_threads,
                                Progress& progress)
{
  constexpr std::size_t triangles_per_block = 1024;
  const Eigen::Index n = fields.cols(), triangles = fields.rows() / 2;
  const std::size_t number_of_blocks =
      (std::size_t(triangles) + triangles_per_block - 1) / triangles_per_block;
  std::vector<Matrix> sums(number_of_slices);
  for_each_block(
      number_of_slices, 1, number_of_threads,
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
  Matrix result = Matrix::Zero(n, n);
  if(!progress.is_cancelled())
    for(const Matrix& sum : sums)
      result += sum;
  return result;
}

} // namespace

// Clusters of triangles around center vertices. Two centers are never adjacent. The mean size is
// eight to nine triangles. Each cluster has a plane, in which the vectors of its triangles are
// averaged.
struct Spectral_transport::Clusters
{
  std::vector<Index> cluster; // #triangles
  // #triangles: complex factor of a vector: the rotation to the frame of the cluster, times the
  // square root of the relative area
  std::vector<Vec2> frame_rotation;
  Float_matrix full_basis;           // the basis B, in single precision
  Float_matrix basis;                // mean vectors of the basis in the clusters, orthonormalized
  Float_matrix to_full_coefficients; // maps coefficients of the cluster basis to those of B
  Column<float> weight;              // #clusters: square roots of areas

  Clusters(const Surface_arrays& triangles, const Operators& operators,
           const Matrix& original_basis)
      : full_basis(original_basis.cast<float>())
  {
    std::size_t number = assign_clusters(triangles, operators);
    // With fewer clusters, the means of the basis could be linearly dependent. Then each triangle
    // is a cluster.
    if(number < 3 * std::size_t(original_basis.cols()))
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
    Matrix means = this->means(original_basis);
    to_full_coefficients = orthonormalize(means).cast<float>();
    basis = means.cast<float>();
  }

  // Returns the mean vector in each cluster times the square root of its area, for each column.
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
  // Assigns each triangle to a cluster. Returns the number of clusters.
  std::size_t assign_clusters(const Surface_arrays& triangles, const Operators& operators)
  {
    const std::size_t n = operators.number_of_triangles();
    cluster.assign(n, none);
    std::size_t number = 0;
    if(triangles.point.empty()) // without coordinates, each triangle is a cluster
    {
      for(Index f = 0; f < n; ++f)
        cluster[f] = Index(number++);
      return number;
    }
    std::vector<Index> cluster_of(operators.number_of_vertices,
                                  // #vertices: the cluster around the vertex or an adjacent one
                                  none);
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

  // Computes `frame_rotation`. The plane of a cluster is orthogonal to the sum of its area-weighted
  // normals.
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
                                          // #clusters: the triangle whose first axis is projected
                                          // to that of the plane
                                          none);
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
        // The rotation closest to the projection onto the plane.
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
    : m_triangles(std::move(triangles)),
      m_operators(internal::operators(*m_triangles, Degenerate_triangles::thickened))
{
  require_area(*m_triangles);
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
  if(slopes.cols() > 0) // otherwise slopes.data() is null
  {
    m_basis.topLeftCorner(n, slopes.cols()) = -slopes.bottomRows(n);
    m_basis.bottomLeftCorner(n, slopes.cols()) = slopes.topRows(n);
  }
  m_basis.rightCols(harmonic.cols()) = harmonic;
  if(m_triangles->is_cloud())
    m_basis = m_particular->without_gradients(m_basis);
  if(m_basis.cols() > 0)
    orthonormalize(m_basis);
  // If no triangle has an area, the basis can be zero.
  if(m_basis.cols() == 0)
    return;
  m_clusters = std::make_unique<Clusters>(*m_triangles, m_operators, m_basis);
}

Spectral_transport::~Spectral_transport() = default;

// Returns the sum of a column on each component.
std::vector<double> Spectral_transport::column_masses(const Masses& masses,
                                                      Eigen::Index column) const
{
  std::vector<double> result(m_number_of_components, 0.);
  for(Masses::InnerIterator it(masses, column); it; ++it)
    result[m_particular->component()[it.row()]] += it.value();
  return result;
}

// Returns true if a column sums to zero on each component, up to a relative 1e-9.
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
    throw Invalid_argument_error("The tolerance must be positive.");
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
  for_each_block(columns, columns_per_block, options.number_of_threads, solve);
  if(progress.is_cancelled())
    result.clear();
  return result;
}

Transport_result Spectral_transport::transport(const Vector& masses,
                                               const Spectral_transport_options& options) const
{
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance must be positive.");
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
  result.number_of_iterations = bounds.number_of_iterations;
  result.is_converged = bounds.are_within(options.tolerance);
  return result;
}

Matrix Spectral_transport::all_pairs(const Masses& masses,
                                     const Spectral_transport_options& options) const
{
  const Eigen::Index n = masses.cols();
  if(m_basis.cols() > 0)
  {
    const Masses differences = pairwise_differences(masses);
    const std::vector<Transport_bounds> bounds = distances(differences, options);
    if(bounds.empty() && differences.cols() > 0)
      return {};
    Matrix result = Matrix::Zero(n, n);
    std::size_t pair = 0;
    for(Eigen::Index i = 0; i < n; ++i)
      for(Eigen::Index j = 0; j < i; ++j, ++pair)
        result(i, j) = result(j, i) = bounds[pair].value();
    return result;
  }

  Progress progress(options.callback, std::size_t(n) / columns_per_block + 1 + number_of_slices);
  const Float_matrix fields =
      area_weighted_fields(*m_particular, m_sqrt_area, masses, options.number_of_threads, progress);
  Matrix result = pairwise_sums_of_lengths(fields, options.number_of_threads, progress);
  if(progress.is_cancelled())
    return {};
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
  for_each_block(targets.size(), columns_per_block, options.number_of_threads, solve);
  for(Masses::InnerIterator it(source, 0); it; ++it)
    if(it.value() == 1.)
      result[it.row()] = 0.;
  if(progress.is_cancelled())
    result.resize(0);
  return result;
}

// Returns, for each column p, a combination of B for which the integral of the sum is almost
// minimal.
Float_matrix Spectral_transport::coarse_correction(const Float_matrix& fields) const
{
  Float_matrix particular = m_clusters->means(fields), coarse_coefficients, projected, result;
  transposed_product(m_clusters->basis, particular, coarse_coefficients);
  product(m_clusters->basis, coarse_coefficients, projected);
  particular -= projected;
  Group_lasso<Float_matrix> solver(m_clusters->basis, m_clusters->weight, std::move(particular));
  for(int i = 0; i < 32; ++i) // more iterations gain less than the clustering loses
    solver.advance();
  const Float_matrix coefficients =
      m_clusters->to_full_coefficients * (solver.coefficients() - coarse_coefficients);
  product(m_clusters->full_basis, coefficients, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
