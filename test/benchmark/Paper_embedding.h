// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_PAPER_EMBEDDING_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_PAPER_EMBEDDING_H

#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace benchmarks {

// Geodesic locally linear embedding as printed by Peyre and Cohen 2005, sections 3.3 and 3.4, for
// comparison. The variants select the Gram matrix and the extension to all vertices.
class Paper_embedding
{
public:
  // The Gram matrix as printed is centered at the mean of the neighbors. Otherwise it is centered
  // at the point. The extension as printed is the formula of Nystrom. Otherwise the package's
  // interpolation is used.
  struct Variant
  {
    bool use_printed_gram = true, use_nystrom = true;
  };

  // Computes the images of all vertices, in the indices of the arrays. Vertices without base points
  // get NaN.
  Paper_embedding(
      const std::shared_ptr<const CGAL::Geodesic_processing::internal::Surface_arrays>& triangles,
      std::size_t number_of_base_points, const Variant& variant)
      : m_variant(variant)
  {
    using namespace CGAL::Geodesic_processing::internal;
    const Front front(triangles, Front_kind::euclidean);
    Sampling sampling(triangles, front, Sample_location::vertex);
    Sampling_options options;
    options.number_of_samples = number_of_base_points;
    sample_farthest_points(sampling, options, [](double) {});
    m_base = nearest_base_points(*triangles, sampling, front,
                                 number_of_nearest_for(number_of_neighbors));
    embed();
    if(variant.use_nystrom)
      extend(triangles->number_of_vertices());
    else
    {
      std::vector<Vec2> images;
      for(Eigen::Index i = 0; i < m_positions.rows(); ++i)
        images.push_back({m_positions(i, 0), m_positions(i, 1)});
      m_image = extend_embedding(m_base, images, number_of_neighbors);
    }
    orient_positively(*triangles, m_image);
  }

  const std::vector<CGAL::Geodesic_processing::internal::Vec2>& image() const { return m_image; }

private:
  static constexpr std::size_t number_of_neighbors = 10;

  // Returns the nearest base points of a vertex, without the one at its position, and the weights
  // that reconstruct it.
  std::pair<std::vector<std::size_t>, Eigen::VectorXd> weights(std::size_t vertex) const
  {
    std::vector<std::size_t> neighbor;
    std::vector<double> square; // of the distance from the vertex
    const std::size_t begin = m_base.number_of_nearest * vertex;
    for(std::size_t k = begin; k < begin + m_base.number_of_nearest; ++k)
      if(m_base.neighbor[k] != CGAL::Geodesic_processing::internal::none &&
         m_base.distance[k] > 0. && neighbor.size() < number_of_neighbors)
      {
        neighbor.push_back(m_base.neighbor[k]);
        square.push_back(m_base.distance[k] * m_base.distance[k]);
      }
    const auto n = Eigen::Index(neighbor.size());
    Eigen::MatrixXd gram(n, n);
    for(Eigen::Index j = 0; j < n; ++j)
      for(Eigen::Index k = 0; k < n; ++k)
      {
        const auto a = std::size_t(j), b = std::size_t(k);
        // Pairs without a known distance have that of the path through the vertex.
        const double d = std::min(m_base.distance_between(neighbor[a], neighbor[b]),
                                  std::sqrt(square[a]) + std::sqrt(square[b]));
        gram(j, k) =
            m_variant.use_printed_gram ? -0.5 * d * d : 0.5 * (square[a] + square[b] - d * d);
      }
    if(m_variant.use_printed_gram)
    {
      const Eigen::VectorXd mean = gram.rowwise().mean();
      gram.colwise() -= mean;
      gram.rowwise() -= mean.transpose();
      gram.array() += mean.mean();
    }
    // The usual regularization of Roweis and Saul; the matrix is singular.
    gram.diagonal().array() += 1e-3 * gram.trace();
    Eigen::VectorXd w = gram.ldlt().solve(Eigen::VectorXd::Ones(n));
    return {neighbor, w / w.sum()};
  }

  void embed()
  {
    const auto n = Eigen::Index(m_base.size());
    Eigen::MatrixXd residual = Eigen::MatrixXd::Identity(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const auto [neighbor, w] = weights(m_base.vertices[std::size_t(i)]);
      for(std::size_t j = 0; j < neighbor.size(); ++j)
        residual(i, Eigen::Index(neighbor[j])) -= w[Eigen::Index(j)];
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(residual.transpose() * residual);
    m_positions = solver.eigenvectors().middleCols(1, 2);
    m_eigenvalues = solver.eigenvalues().segment(1, 2);
  }

  // f(y) = 1 / (1 - lambda) sum of M(x_i, y) f(x_i), where M(x_i, y) = W(y, x_i) since no base
  // point is reconstructed from y.
  void extend(std::size_t number_of_vertices)
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    m_image.assign(number_of_vertices, {unknown, unknown});
    for(std::size_t vertex = 0; vertex < number_of_vertices; ++vertex)
      if(m_base.neighbor[m_base.number_of_nearest * vertex] !=
         CGAL::Geodesic_processing::internal::none)
      {
        const auto [neighbor, w] = weights(vertex);
        Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
        for(std::size_t j = 0; j < neighbor.size(); ++j)
          sum += w[Eigen::Index(j)] * m_positions.row(Eigen::Index(neighbor[j]));
        for(Eigen::Index c = 0; c < 2; ++c)
          m_image[vertex][std::size_t(c)] = sum[c] / (1. - m_eigenvalues[c]);
      }
    for(std::size_t i = 0; i < m_base.size(); ++i)
      m_image[m_base.vertices[i]] = {m_positions(Eigen::Index(i), 0),
                                     m_positions(Eigen::Index(i), 1)};
  }

  Variant m_variant;
  CGAL::Geodesic_processing::internal::Base_points m_base;
  Eigen::MatrixXd m_positions; // #base points x 2
  Eigen::Vector2d m_eigenvalues;
  std::vector<CGAL::Geodesic_processing::internal::Vec2> m_image; // #vertices
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_PAPER_EMBEDDING_H
