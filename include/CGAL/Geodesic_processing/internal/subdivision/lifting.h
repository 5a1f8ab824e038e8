// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_LIFTING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_LIFTING_H

#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// How the values of midpoints are predicted from the values of the coarser level.
enum class Prediction
{
  linear, // the mean of both ends of the edge
  // the modified butterfly scheme (Zorin, Schröder and Sweldens 1996) with eight or more vertices;
  // the four-point scheme on the boundary; next to it, missing vertices are replaced by reflections
  butterfly
};

// The weights of the vertices of a level that predict its midpoints: a sparse matrix with one row
// per midpoint.
struct Prediction_stencils
{
  std::vector<Index> begin; // #midpoints + 1
  std::vector<Index> vertex;
  std::vector<double> weight; // the sum of each row is one
};

// Computes the stencils of all midpoints of a level. O(n) for bounded valence.
CGAL_GEODESIC_PROCESSING_EXPORT
Prediction_stencils prediction_stencils(const Subdivision& subdivision, std::size_t level,
                                        Prediction prediction);

// The wavelet transform on a subdivision by lifting (Sweldens 1998; Schröder and Sweldens 1995).
// From the finest level to the coarsest, two steps are applied:
// - Predict: the value of each midpoint is replaced by its detail, the difference from its
//   prediction.
// - Update (optional): the values of the coarser vertices are changed by the details, such that the
//   weighted sum of the values is the same on all levels. So the wavelets have one vanishing
//   moment.
// Both steps are invertible, so that synthesis is the inverse of analysis up to round-off errors.
class CGAL_GEODESIC_PROCESSING_EXPORT Lifting
{
public:
  // Precomputes the stencils, and the weights of the sum; all vertices of the finest level have
  // weight one. O(n).
  Lifting(std::shared_ptr<const Subdivision> subdivision, Prediction prediction, bool use_update);

  const Subdivision& subdivision() const { return *m_subdivision; }

  // Transforms values in place. O(n).
  //
  // values        #vertices * channels, all channels of a vertex together. On return, the vertices
  //               of the coarsest level have values, and all others details.
  // is_in_frames  the three channels are coordinates. Each detail is expressed in a local frame:
  //               the normal of the coarser surface, the direction of the edge, and their cross
  //               product.
  void analyze(std::vector<double>& values, std::size_t channels, bool is_in_frames) const;
  // Inverts analyze(). O(n).
  void synthesize(std::vector<double>& values, std::size_t channels, bool is_in_frames) const;

  // Returns the weights (#vertices of the level) of the sum that the update steps preserve.
  const std::vector<double>& weights(std::size_t level) const { return m_weights[level]; }

private:
  void update(std::vector<double>& values, std::size_t channels, std::size_t level,
              double sign) const;
  void predict(std::vector<double>& values, std::size_t channels, std::size_t level,
               double sign) const;
  void rotate_details(std::vector<double>& values, std::size_t level, bool is_forward) const;

  std::shared_ptr<const Subdivision> m_subdivision;
  std::vector<Prediction_stencils> m_stencils; // of each level except the last
  std::vector<std::vector<double>> m_weights;
  bool m_use_update;
};

// Returns the norm of the wavelet of each vertex (#vertices): 2^k if the vertex exists on k levels
// besides the finest one. A change of a detail, multiplied by its norm, changes the root of the
// sum of squared values by approximately the same amount on all levels.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> detail_norms(const Subdivision& subdivision);

// Keeps the `number` vertices with the largest details and sets all other details to zero. The
// size of a detail is the Euclidean length of its channels times its norm. The values of the
// coarsest level remain unchanged. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
void keep_largest(std::vector<double>& values, std::size_t channels, const Subdivision& subdivision,
                  std::size_t number);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_LIFTING_H
