// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>

#include "numerics/dense_solvers.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Matrix = Eigen::MatrixXd;
using Row = Eigen::RowVector2d;

// Added to a Gram matrix, relative to its trace. It is far above round-off errors, and a plane is
// reproduced to within 1e-6.
constexpr double regularization = 1e-9;

// The neighbors of a base point, embedded in a plane with this point as the origin: the first two
// eigenvectors of the Gram matrix of their distances.
struct Local_chart
{
  std::vector<Index> neighbor;
  std::vector<double> squared_distance; // to the base point
  std::vector<Vec2> position;
};

std::vector<Local_chart> build_local_charts(const Base_points& base, std::size_t neighbors)
{
  std::vector<Local_chart> result(base.size());
  for(Index i = 0; i < base.size(); ++i)
  {
    Local_chart& chart = result[i];
    const std::size_t begin = base.number_of_nearest * base.vertices[i];
    for(std::size_t k = begin; k < begin + std::min(base.number_of_nearest, neighbors + 1); ++k)
      if(base.neighbor[k] != none && base.neighbor[k] != i)
      {
        const double distance = base.distance_between(i, base.neighbor[k]);
        chart.neighbor.push_back(base.neighbor[k]);
        chart.squared_distance.push_back(distance * distance);
      }
    const auto number_of_neighbors = Eigen::Index(chart.neighbor.size());
    Matrix gram(number_of_neighbors, number_of_neighbors);
    for(Eigen::Index j = 0; j < number_of_neighbors; ++j)
      for(Eigen::Index k = 0; k < number_of_neighbors; ++k)
      {
        const double pair_distance =
            std::min(base.distance_between(chart.neighbor[j], chart.neighbor[k]),
                     std::sqrt(chart.squared_distance[j]) + std::sqrt(chart.squared_distance[k]));
        gram(j, k) = 0.5 * (chart.squared_distance[j] + chart.squared_distance[k] -
                            pair_distance * pair_distance);
      }
    const Eigen_system eigen = eigen_system(gram);
    chart.position.assign(chart.neighbor.size(), Vec2{0., 0.});
    for(Eigen::Index c = number_of_neighbors - 1; c >= 0 && c >= number_of_neighbors - 2; --c)
      for(Eigen::Index j = 0; j < number_of_neighbors; ++j)
        chart.position[j][number_of_neighbors - 1 - c] =
            std::sqrt(std::max(0., eigen.values[c])) * eigen.vectors(j, c);
  }
  return result;
}

// Returns whether the graph of neighbors, as an undirected graph, is connected.
bool is_connected(const Base_points& base, std::size_t neighbors)
{
  boost::disjoint_sets_with_storage<> groups(base.size());
  std::size_t number_of_groups = base.size();
  for(Index i = 0; i < base.size(); ++i)
  {
    const std::size_t begin = base.number_of_nearest * base.vertices[i];
    for(std::size_t k = begin; k < begin + std::min(base.number_of_nearest, neighbors + 1); ++k)
      if(const Index neighbor = base.neighbor[k];
         neighbor != none && groups.find_set(i) != groups.find_set(neighbor))
      {
        groups.link(groups.find_set(i), groups.find_set(neighbor));
        --number_of_groups;
      }
  }
  return number_of_groups == 1;
}

// Returns the smallest number of neighbors, at least `neighbors`, for which the graph of neighbors
// is connected, or zero if it exceeds the length of the lists.
std::size_t connecting_number(const Base_points& base, std::size_t neighbors)
{
  // Fewer base points have no more neighbors than all others.
  while(!is_connected(base, neighbors))
    if(++neighbors >= base.number_of_nearest)
      return 0;
  return neighbors;
}

// Returns the position of a base point in the chart of `center`, or null if it is not in the chart.
const Vec2* position_in(const Local_chart& chart, Index center, Index neighbor)
{
  static constexpr Vec2 origin = {0., 0.};
  if(neighbor == center)
    return &origin;
  const auto found = std::find(chart.neighbor.begin(), chart.neighbor.end(), neighbor);
  return found == chart.neighbor.end() ? nullptr : &chart.position[found - chart.neighbor.begin()];
}

// Reflects charts so that adjacent ones have the same orientation. Traverses a spanning tree in
// which edges of the best agreement come first.
void orient_consistently(std::vector<Local_chart>& charts)
{
  struct Chart_edge
  {
    double score; // negative: mirrored
    Index from, to;
    bool operator<(const Chart_edge& other) const
    {
      return std::abs(score) < std::abs(other.score) ||
             (std::abs(score) == std::abs(other.score) && to > other.to);
    }
  };
  const auto agreement = [&](Index i, Index j)
  {
    std::vector<std::pair<Vec2, Vec2>> common;
    const auto add_common = [&](Index neighbor)
    {
      const Vec2 *p = position_in(charts[i], i, neighbor), *q = position_in(charts[j], j, neighbor);
      if(p && q)
        common.emplace_back(*p, *q);
    };
    add_common(i);
    for(const Index neighbor : charts[i].neighbor)
      add_common(neighbor);
    Vec2 p = {0., 0.}, q = {0., 0.};
    for(const auto& [a, b] : common)
    {
      p = p + (1. / double(common.size())) * a;
      q = q + (1. / double(common.size())) * b;
    }
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    for(const auto& [a, b] : common)
      covariance += Eigen::Vector2d(a[0] - p[0], a[1] - p[1]) * Row(b[0] - q[0], b[1] - q[1]);
    const double squared_norm = covariance.squaredNorm();
    return squared_norm > 0. ? covariance.determinant() / squared_norm : 0.;
  };
  std::vector<bool> is_done(charts.size(), false);
  for(Index start = 0; start < charts.size(); ++start)
  {
    if(is_done[start])
      continue;
    std::priority_queue<Chart_edge> queue;
    for(queue.push({1., none, start}); !queue.empty();)
    {
      const Chart_edge edge = queue.top();
      queue.pop();
      if(is_done[edge.to])
        continue;
      is_done[edge.to] = true;
      if(edge.from != none && agreement(edge.from, edge.to) < 0.)
        for(Vec2& p : charts[edge.to].position)
          p[1] = -p[1];
      for(const Index next : charts[edge.to].neighbor)
        if(!is_done[next])
          queue.push({agreement(edge.to, next), edge.to, next});
    }
  }
}

// Computes weights that sum to one and whose weighted mean of the points is the origin. They
// minimize the sum of their squares divided by `inverse_square`. If the points are an embedding of
// a Gram matrix of rank two, these are the weights of its regularized inverse.
std::vector<double> reconstruction_weights(const std::vector<Vec2>& position,
                                           const std::vector<double>& inverse_square,
                                           double regularization)
{
  double a = 0., b = 0., c = 0., u = 0., v = 0.;
  for(std::size_t j = 0; j < position.size(); ++j)
  {
    a += inverse_square[j] * position[j][0] * position[j][0];
    b += inverse_square[j] * position[j][0] * position[j][1];
    c += inverse_square[j] * position[j][1] * position[j][1];
    u += inverse_square[j] * position[j][0];
    v += inverse_square[j] * position[j][1];
  }
  const double ridge = regularization * (a + c);
  a += ridge;
  c += ridge;
  const double determinant = a * c - b * b;
  Vec2 gradient = {0., 0.};
  if(determinant > 0.)
    gradient = {(c * u - b * v) / determinant, (a * v - b * u) / determinant};
  std::vector<double> result(position.size());
  double sum = 0.;
  for(std::size_t j = 0; j < position.size(); ++j)
    sum += result[j] = inverse_square[j] * (1. - dot(gradient, position[j]));
  for(double& w : result)
    w /= sum;
  return result;
}

// Computes the two smallest nonconstant eigenvectors of (I - W)^T (I - W). The rows of W reproduce
// each point from its neighbors (Roweis and Saul 2000).
Matrix spectral_embedding(const std::vector<Local_chart>& charts)
{
  const auto n = Eigen::Index(charts.size());
  Matrix residual = Matrix::Identity(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    std::vector<double> inverse_square;
    for(const double squared_distance : charts[i].squared_distance)
      inverse_square.push_back(1. / squared_distance);
    const auto w = reconstruction_weights(charts[i].position, inverse_square, regularization);
    for(std::size_t j = 0; j < w.size(); ++j)
      residual(i, charts[i].neighbor[j]) -= w[j];
  }
  const Eigen_system eigen = eigen_system(small_transposed_product(residual, residual));
  // The constant vector is in the span of the three lowest eigenvectors, but need not be one of
  // them.
  Matrix lowest = eigen.vectors.leftCols(3);
  lowest.rowwise() -= lowest.colwise().mean();
  const Eigen_system centered = eigen_system(small_transposed_product(lowest, lowest));
  return small_product(lowest, centered.vectors.rightCols(2));
}

// Applies the linear map that fits the squared distances of neighbors to those on the surface by
// least squares.
Matrix fit_metric(const std::vector<Local_chart>& charts, const Matrix& f)
{
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
  for(std::size_t i = 0; i < charts.size(); ++i)
    for(std::size_t j = 0; j < charts[i].neighbor.size(); ++j)
    {
      const Row e = f.row(charts[i].neighbor[j]) - f.row(Eigen::Index(i));
      const Eigen::Vector3d row = Eigen::Vector3d(e[0] * e[0], 2. * e[0] * e[1], e[1] * e[1]) /
                                  charts[i].squared_distance[j];
      normal += row * row.transpose();
      rhs += row;
    }
  const Eigen::Vector3d s = normal.ldlt().solve(rhs);
  Eigen::Matrix2d metric;
  metric << s[0], s[1], s[1], s[2];
  const Eigen_system solver = eigen_system(metric);
  Eigen::Vector2d root;
  for(int k = 0; k < 2; ++k)
    root[k] = std::sqrt(std::max(solver.values[k], 1e-6 * solver.values[1]));
  const Eigen::Matrix2d axes = solver.vectors;
  return f * (axes * root.asDiagonal() * axes.transpose());
}

// Computes classical scaling of the graph distances between base points (Isomap, Tenenbaum, de
// Silva and Langford 2000).
Matrix isomap_embedding(const Base_points& base)
{
  const auto n = Eigen::Index(base.size());
  Matrix squares = Matrix::Zero(n, n);
  for(Eigen::Index start = 0; start < n; ++start)
  {
    std::vector<double> length(std::size_t(n), infinity);
    std::vector<bool> is_finalized(std::size_t(n), false);
    length[start] = 0.;
    for(;;)
    {
      Eigen::Index current = -1;
      for(Eigen::Index k = 0; k < n; ++k)
        if(!is_finalized[k] && length[k] < infinity && (current < 0 || length[k] < length[current]))
          current = k;
      if(current < 0)
        break;
      is_finalized[current] = true;
      for(Eigen::Index k = 0; k < n; ++k)
        length[k] = std::min(length[k], length[current] + base.distance_between(current, k));
    }
    for(Eigen::Index k = 0; k < n; ++k)
      squares(start, k) = length[k] * length[k];
  }
  return classical_scaling(squares);
}

// Fits positions of the base points so that the neighbors of each are a rotated copy of its chart,
// by weighted least squares relative to the squared distances. Rotations and positions are
// optimized alternately (as rigid as possible, Sorkine and Alexa 2007). Reflections are not
// allowed, so that folds increase the energy.
class Arap_fit
{
public:
  Arap_fit(const std::vector<Local_chart>& charts, std::size_t number_of_steps)
      : m_charts(charts), m_solver(stiffness_matrix(charts)), m_number_of_steps(number_of_steps)
  {}

  // Returns the positions fitted from an initial embedding, and the remaining energy.
  Matrix fit(Matrix f, double& energy) const
  {
    std::size_t mirrored = 0;
    for(std::size_t i = 0; i < m_charts.size(); ++i)
      mirrored += covariance(i, f).determinant() < 0.;
    if(2 * mirrored > m_charts.size())
      f.col(1) = -f.col(1);
    for(std::size_t step = 0; step <= m_number_of_steps; ++step)
    {
      Matrix rhs = Matrix::Zero(f.rows(), 2);
      energy = 0.;
      for(std::size_t i = 0; i < m_charts.size(); ++i)
      {
        const Local_chart& chart = m_charts[i];
        const Eigen::Matrix2d c = covariance(i, f);
        double cosine = c(0, 0) + c(1, 1), sine = c(0, 1) - c(1, 0);
        const double size = std::hypot(cosine, sine);
        if(size > 0.)
        {
          cosine /= size;
          sine /= size;
        }
        for(std::size_t j = 0; j < chart.neighbor.size(); ++j)
        {
          const Vec2 p = rotated(chart.position[j], {cosine, sine});
          const double w = 1. / chart.squared_distance[j];
          const Row rotated_edge(p[0], p[1]);
          energy +=
              w * (f.row(chart.neighbor[j]) - f.row(Eigen::Index(i)) - rotated_edge).squaredNorm();
          rhs.row(chart.neighbor[j]) += w * rotated_edge;
          rhs.row(Eigen::Index(i)) -= w * rotated_edge;
        }
      }
      if(step < m_number_of_steps)
        f = m_solver.solve(rhs);
    }
    return f;
  }

private:
  // Returns the Laplacian, with one vertex pinned.
  static Matrix stiffness_matrix(const std::vector<Local_chart>& charts)
  {
    const auto n = Eigen::Index(charts.size());
    Matrix laplacian = Matrix::Zero(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
      for(std::size_t j = 0; j < charts[i].neighbor.size(); ++j)
      {
        const double w = 1. / charts[i].squared_distance[j];
        const auto k = Eigen::Index(charts[i].neighbor[j]);
        laplacian(i, i) += w;
        laplacian(k, k) += w;
        laplacian(i, k) -= w;
        laplacian(k, i) -= w;
      }
    laplacian(0, 0) *= 2.;
    return laplacian;
  }

  // Computes the covariance of a chart and its image.
  Eigen::Matrix2d covariance(std::size_t i, const Matrix& f) const
  {
    const Local_chart& chart = m_charts[i];
    Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
    for(std::size_t j = 0; j < chart.neighbor.size(); ++j)
      result += Eigen::Vector2d(chart.position[j][0], chart.position[j][1]) *
                (f.row(chart.neighbor[j]) - f.row(Eigen::Index(i))) / chart.squared_distance[j];
    return result;
  }

  const std::vector<Local_chart>& m_charts;
  Symmetric_solver m_solver;
  std::size_t m_number_of_steps;
};

} // namespace

Matrix classical_scaling(const Matrix& squares)
{
  const Matrix sum = 0.5 * (squares + squares.transpose());
  const Eigen::RowVectorXd mean = sum.colwise().mean();
  Matrix gram = -0.5 * sum;
  gram.rowwise() += 0.5 * mean;
  gram.colwise() += 0.5 * mean.transpose();
  gram.array() -= 0.5 * mean.mean();
  const Eigen_system eigen = eigen_system(gram);
  Matrix result = eigen.vectors.rightCols(2);
  for(int k = 0; k < 2; ++k)
    result.col(k) *= std::sqrt(std::max(0., eigen.values[gram.rows() - 2 + k]));
  return result;
}

std::vector<Vec2> embed_base_points(const Base_points& base, std::size_t neighbors,
                                    const Embedding_options& options)
{
  if(base.size() < 3)
    return {};
  // With few neighbors, groups of points can be disconnected.
  neighbors = connecting_number(base, neighbors);
  if(neighbors == 0)
    return {};
  std::vector<Local_chart> local_charts = build_local_charts(base, neighbors);
  orient_consistently(local_charts);
  const Arap_fit arap(local_charts, options.number_of_rigid_steps);
  double min_energy = infinity;
  Matrix best_positions;
  const auto try_start = [&](const Matrix& start)
  {
    double energy;
    const Matrix f = arap.fit(start, energy);
    if(energy < min_energy)
    {
      min_energy = energy;
      best_positions = f;
    }
  };
  if(options.use_lle)
    try_start(fit_metric(local_charts, spectral_embedding(local_charts)));
  if(options.use_isomap)
    try_start(isomap_embedding(base));
  std::vector<Vec2> result(base.size());
  for(Eigen::Index i = 0; i < best_positions.rows(); ++i)
    result[i] = {best_positions(i, 0), best_positions(i, 1)};
  return result;
}

Embedded_base_points embed_samples(const Surface_arrays& triangles, const Sampling& sampling,
                                   const Front& front, std::size_t neighbors, bool can_grow,
                                   const std::function<bool(double)>& callback,
                                   const Embedding_options& options)
{
  Embedded_base_points result;
  const auto embed = [&]
  {
    result.base = nearest_base_points(triangles, sampling, front,
                                      number_of_nearest_for(result.neighbors), callback);
    result.positions = embed_base_points(result.base, result.neighbors, options);
  };
  result.neighbors = neighbors;
  embed();
  if(!result.positions.empty() || !can_grow)
    return result;
  std::size_t connecting = 0;
  // If each base point has all others as neighbors, the graph is connected.
  while(connecting == 0 && result.base.number_of_nearest < result.base.size())
  {
    const std::size_t begin = result.base.number_of_nearest;
    result.base = nearest_base_points(triangles, sampling, front, 2 * begin, callback);
    connecting = connecting_number(result.base, begin);
  }
  if(connecting == 0)
    return result; // too few base points, or the callback cancelled
  // The nearest neighbor in another group connects it, but several are needed to orient the groups
  // consistently.
  result.neighbors = std::min(connecting + neighbors, result.base.size() - 1);
  embed();
  return result;
}

namespace {

// Maps a vertex to the affine combination of the images of its nearest base points that
// reconstructs it.
class Embedding_extension
{
public:
  Embedding_extension(const Base_points& base, const std::vector<Vec2>& images,
                      std::size_t neighbors)
      : m_base(base), m_images(images), m_limit(std::min(base.number_of_nearest, neighbors + 1))
  {}

  // Returns the image of a vertex with at least one base point.
  Vec2 operator()(std::size_t vertex)
  {
    m_neighbor = &m_base.neighbor[m_base.number_of_nearest * vertex];
    m_distance = &m_base.distance[m_base.number_of_nearest * vertex];
    if(m_distance[0] == 0.)
      return m_images[m_neighbor[0]];
    compute_offsets(choose_neighbors());
    compute_positions();
    const auto w = reconstruction_weights(m_position, m_inverse_square, regularization);
    Vec2 image = {0., 0.};
    for(std::size_t j = 0; j < m_number_of_neighbors; ++j)
      image = image + w[j] * m_images[m_neighbor[j]];
    return image;
  }

private:
  // Counts the base points with a positive weight. Returns the radius of the weights: the distance
  // to the next base point, unless all have the same distance.
  double choose_neighbors()
  {
    m_number_of_neighbors = 0;
    while(m_number_of_neighbors < m_limit && m_neighbor[m_number_of_neighbors] != none)
      ++m_number_of_neighbors;
    if(m_number_of_neighbors == m_limit && m_limit < m_base.size() &&
       m_distance[0] < m_distance[m_number_of_neighbors - 1])
      return m_distance[--m_number_of_neighbors];
    return infinity;
  }

  // Computes the weighted offsets of the images from their weighted mean.
  void compute_offsets(double radius)
  {
    m_offset.resize(m_number_of_neighbors);
    m_squared_distance.resize(m_number_of_neighbors);
    m_inverse_square.resize(m_number_of_neighbors);
    Vec2 center = {0., 0.};
    double sum = 0.;
    for(std::size_t j = 0; j < m_number_of_neighbors; ++j)
    {
      m_squared_distance[j] = m_distance[j] * m_distance[j];
      // Smooth, and zero at the radius, where the set of neighbors changes.
      const double fade = std::max(0., 1. - m_squared_distance[j] / (radius * radius)),
                   weight = fade * fade;
      m_inverse_square[j] = weight * m_squared_distance[0] / m_squared_distance[j];
      center = center + m_inverse_square[j] * m_images[m_neighbor[j]];
      sum += m_inverse_square[j];
      m_offset[j] = {weight, 0.};
    }
    center = (1. / sum) * center;
    for(std::size_t j = 0; j < m_number_of_neighbors; ++j)
      m_offset[j] = m_offset[j][0] * (m_images[m_neighbor[j]] - center);
  }

  // Computes positions of the base points relative to the vertex, up to a linear map. If the Gram
  // matrix C has rank two, these are the columns of C X for any X.  With the offsets as X no
  // eigenproblem per vertex is required, and the result is smooth.
  void compute_positions()
  {
    m_position.assign(m_number_of_neighbors, {0., 0.});
    for(std::size_t j = 0; j < m_number_of_neighbors; ++j)
      for(std::size_t k = 0; k <= j; ++k)
      {
        const double pair_distance = std::min(m_base.distance_between(m_neighbor[j], m_neighbor[k]),
                                              m_distance[j] + m_distance[k]);
        const double c =
            0.5 * (m_squared_distance[j] + m_squared_distance[k] - pair_distance * pair_distance);
        m_position[j] = m_position[j] + c * m_offset[k];
        if(k < j)
          m_position[k] = m_position[k] + c * m_offset[j];
      }
  }

  const Base_points& m_base;
  const std::vector<Vec2>& m_images;
  std::size_t m_limit;

  // The current vertex.
  const Index* m_neighbor = nullptr;
  const double* m_distance = nullptr;
  std::size_t m_number_of_neighbors = 0;
  std::vector<Vec2> m_offset, m_position;
  std::vector<double> m_squared_distance, m_inverse_square;
};

} // namespace

std::vector<Vec2> extend_embedding(const Base_points& base, const std::vector<Vec2>& images,
                                   std::size_t neighbors)
{
  const std::size_t number_of_vertices =
      base.number_of_nearest > 0 ? base.neighbor.size() / base.number_of_nearest : 0;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec2> result(number_of_vertices, Vec2{unknown, unknown});
  Embedding_extension image_of(base, images, neighbors);
  for(std::size_t vertex = 0; vertex < number_of_vertices; ++vertex)
    if(base.neighbor[base.number_of_nearest * vertex] != none)
      result[vertex] = image_of(vertex);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
