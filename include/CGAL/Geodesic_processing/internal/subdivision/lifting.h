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

// How the values of midpoints are foretold by those of the level before.
enum class Prediction
{
  linear, // the mean of the two ends
  butterfly // the modified butterfly scheme (Zorin, Schröder and Sweldens 1996): smooth values from eight or
  //   more; along borders the scheme of four points, beside them the surface goes on by reflection
};

// Weights of vertices of a level, for each midpoint a row.
struct Prediction_stencils
{
  std::vector<Index> begin; // #midpoints + 1
  std::vector<Index> vertex;
  std::vector<double> weight; // those of a row sum up to one
};

// The rows of all midpoints of a level, in their order.  O(n) for bounded valence.
CGAL_GEODESIC_PROCESSING_EXPORT
Prediction_stencils prediction_stencils(const Subdivision& subdivision, std::size_t level,
                                        Prediction prediction);

// Wavelets over a subdivision by lifting (Sweldens 1998; Schröder and Sweldens 1995): a level's midpoints become
// details, what their prediction lacks; then, on request, the other vertices are updated by them so that the
// weighted sum of the values does not change from level to level: the wavelets have a vanishing moment.
// Both steps can be undone, so that synthesis is the inverse of analysis but for rounding.
class CGAL_GEODESIC_PROCESSING_EXPORT Lifting
{
public:
  // Every vertex of the finest level weighs one.
  Lifting(std::shared_ptr<const Subdivision> subdivision, Prediction prediction, bool use_update);

  const Subdivision& subdivision() const { return *m_subdivision; }

  // values: channels of vertex 0, of vertex 1, ...; those of the coarsest level stay values, details take the
  // place of the others.  With three channels that are places details may be turned into local frames: along
  // the normal of the coarser surface, along the edge, and across it.  O(n).
  void analyze(std::vector<double>& values, std::size_t channels, bool is_in_frames) const;
  void synthesize(std::vector<double>& values, std::size_t channels, bool is_in_frames) const;

  // #vertices of a level: the weight of each in the sum that updates keep.
  const std::vector<double>& weights(std::size_t level) const { return m_weights[level]; }

private:
  void update(std::vector<double>& values, std::size_t channels, std::size_t level,
              double sign) const;
  void predict(std::vector<double>& values, std::size_t channels, std::size_t level,
               double sign) const;
  void rotate_details(std::vector<double>& values, std::size_t level, bool is_forward) const;

  std::shared_ptr<const Subdivision> m_subdivision;
  std::vector<Prediction_stencils> m_stencils; // of each level but the last
  std::vector<std::vector<double>> m_weights;
  bool m_use_update;
};

// By what the details of each vertex are to be multiplied such that equal numbers change the sum of the squares of
// the values about equally: 2 for each level that is finer than theirs.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> detail_norms(const Subdivision& subdivision);

// Sets all details but the largest `number` of them to zero, by the lengths of their channels times their norms;
// values of the coarsest level stay.
CGAL_GEODESIC_PROCESSING_EXPORT
void keep_largest(std::vector<double>& values, std::size_t channels, const Subdivision& subdivision,
                  std::size_t number);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_LIFTING_H
