// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/lifting.h>

#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Level = Subdivision::Level;

// What is known of the vertices of a level.
struct Vicinity
{
  std::vector<Index> valence; // #vertices: edges
  std::vector<bool> is_on_border;

  // A ring that is not that of the regular triangulation.
  bool is_extraordinary(Index vertex) const
  {
    return !is_on_border[vertex] && valence[vertex] != 6;
  }
};

Vicinity vicinity(const Level& level)
{
  Vicinity result;
  result.valence.assign(level.number_of_vertices, 0);
  result.is_on_border.assign(level.number_of_vertices, false);
  for(Index side = 0; side < level.twin.size(); ++side)
  {
    if(!is_first_of_edge(level, side))
      continue;
    for(const Index end : ends(level, side))
    {
      ++result.valence[end];
      if(level.twin[side] == none)
        result.is_on_border[end] = true;
    }
  }
  return result;
}

class Stencil_builder
{
public:
  Stencil_builder(const Level& level, Prediction prediction)
      : m_level(level), m_prediction(prediction), m_vicinity(vicinity(level))
  {
    m_result.first.push_back(0);
  }

  void add(Index side)
  {
    const auto [a, b] = ends(m_level, side);
    const Index twin = m_level.twin[side];
    if(m_prediction == Prediction::linear)
      put_halves(side);
    else if(twin == none)
      put_border(side);
    else if(const bool at_a = m_vicinity.is_extraordinary(a), at_b = m_vicinity.is_extraordinary(b);
            at_a || at_b)
    {
      const double share = at_a && at_b ? 0.5 : 1.;
      if(at_a)
        put_ring(side, share);
      if(at_b)
        put_ring(twin, share);
    }
    else
    {
      put_halves(side);
      put_wings(side);
      put_wings(twin);
    }
    m_result.first.push_back(Index(m_result.vertex.size()));
  }

  Stencils result() { return std::move(m_result); }

private:
  void put(Index vertex, double weight)
  {
    m_result.vertex.push_back(vertex);
    m_result.weight.push_back(weight);
  }

  void put_halves(Index side, double share = 1.)
  {
    for(const Index end : ends(m_level, side))
      put(end, 0.5 * share);
  }

  // Four points at equal steps along the border.
  void put_border(Index side)
  {
    Index before = previous_side(side), after = next_side(side);
    while(m_level.twin[before] != none)
      before = previous_side(m_level.twin[before]);
    while(m_level.twin[after] != none)
      after = next_side(m_level.twin[after]);
    for(const Index end : ends(m_level, side))
      put(end, 9. / 16.);
    put(ends(m_level, before)[0], -1. / 16.);
    put(ends(m_level, after)[1], -1. / 16.);
  }

  // The part of the eight points on one side of an edge.  A wing beyond the border is the reflection of the corner
  // across, so that linear values are still met.
  void put_wings(Index side)
  {
    put(opposite(m_level, side), 1. / 8.);
    for(const Index wing : {next_side(side), previous_side(side)})
      if(m_level.twin[wing] != none)
        put(opposite(m_level, m_level.twin[wing]), -1. / 16.);
      else
      {
        for(const Index end : ends(m_level, wing))
          put(end, -1. / 16.);
        put(opposite(m_level, wing), 1. / 16.);
      }
  }

  // The vertex that a side starts from, and its ring (Zorin and others 1996, section 3).
  void put_ring(Index side, double share)
  {
    std::vector<Index> ring;
    Index at = side;
    do
    {
      ring.push_back(corner(m_level, next_side(at)));
      at = m_level.twin[previous_side(at)];
    } while(at != none && at != side);
    const std::size_t k = ring.size();
    if(at == none || k < 3)
      return put_halves(side, share);
    put(corner(m_level, side), 0.75 * share);
    for(std::size_t i = 0; i < k; ++i)
    {
      double weight = 0.;
      if(k == 3)
        weight = i == 0 ? 5. / 12. : -1. / 12.;
      else if(k == 4)
        weight = i == 0 ? 3. / 8. : i == 2 ? -1. / 8. : 0.;
      else
      {
        const double angle = 2. * pi * double(i) / double(k);
        weight = (0.25 + std::cos(angle) + 0.5 * std::cos(2. * angle)) / double(k);
      }
      put(ring[i], weight * share);
    }
  }

  const Level& m_level;
  Prediction m_prediction;
  Vicinity m_vicinity;
  Stencils m_result;
};

// One side for each midpoint of a level, in their order.
template <typename Use>
void for_each_midpoint(const Level& level, const Use& use)
{
  for(Index side = 0; side < level.twin.size(); ++side)
    if(is_first_of_edge(level, side))
      use(side);
}

Spatial place(const std::vector<double>& values, Index vertex)
{
  return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
}

using Frame = std::array<Spatial, 3>; // normal, along the edge, across

// Of the coarser surface at an edge.  Where its triangles have angles below half a degree, rounding would turn the
// frame: there the axes of space serve.
Frame frame(const Level& level, const std::vector<double>& values, Index side)
{
  constexpr double least_sine = 0.01;
  const Frame axes = {Spatial{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}};
  const auto [a, b] = ends(level, side);
  const Spatial along = place(values, b) - place(values, a);
  const double length = norm(along);
  Spatial normal = {0., 0., 0.};
  for(const Index s : {side, level.twin[side]})
  {
    if(s == none)
      continue;
    const Spatial first = place(values, ends(level, s)[1]) - place(values, ends(level, s)[0]),
                  second = place(values, opposite(level, s)) - place(values, ends(level, s)[0]);
    const Spatial turn = cross(first, second);
    const double size = norm(first) * norm(second);
    if(!(norm(turn) > least_sine * size && size > 1e-280 && size < 1e280))
      return axes;
    normal = normal + (1. / norm(turn)) * turn;
  }
  const double size = norm(normal);
  if(!(size > least_sine))
    return axes;
  normal = (1. / size) * normal;
  const Spatial tangent = (1. / length) * along;
  return {normal, tangent, cross(normal, tangent)};
}

} // namespace

Stencils stencils(const Subdivision& subdivision, std::size_t level, Prediction prediction)
{
  Stencil_builder builder(subdivision.levels[level], prediction);
  for_each_midpoint(subdivision.levels[level], [&](Index side) { builder.add(side); });
  return builder.result();
}

Lifting::Lifting(std::shared_ptr<const Subdivision> subdivision, Prediction prediction,
                 bool is_updating)
    : m_subdivision(std::move(subdivision)), m_weights(m_subdivision->levels.size()),
      m_is_updating(is_updating)
{
  const std::size_t last = m_subdivision->levels.size() - 1;
  for(std::size_t level = 0; level < last; ++level)
    m_stencils.push_back(stencils(*m_subdivision, level, prediction));
  // Integrals of the scaling functions: a midpoint's weight goes where it is foretold from.
  m_weights[last].assign(m_subdivision->number_of_vertices(), 1.);
  for(std::size_t level = last; level-- > 0;)
  {
    const Stencils& rows = m_stencils[level];
    const Index n = m_subdivision->levels[level].number_of_vertices;
    const std::vector<double>& fine = m_weights[level + 1];
    std::vector<double>& coarse = m_weights[level];
    coarse.assign(fine.begin(), fine.begin() + n);
    for(Index m = n; m < fine.size(); ++m)
      for(Index i = rows.first[m - n]; i < rows.first[m - n + 1]; ++i)
        coarse[rows.vertex[i]] += rows.weight[i] * fine[m];
  }
}

void Lifting::predict(std::vector<double>& values, std::size_t channels, std::size_t level,
                      double sign) const
{
  const Stencils& rows = m_stencils[level];
  double* midpoint = &values[channels * m_subdivision->levels[level].number_of_vertices];
  for(std::size_t m = 0; m + 1 < rows.first.size(); ++m, midpoint += channels)
    for(std::size_t c = 0; c < channels; ++c)
    {
      double sum = 0.;
      for(Index i = rows.first[m]; i < rows.first[m + 1]; ++i)
        sum += rows.weight[i] * values[channels * rows.vertex[i] + c];
      midpoint[c] += sign * sum;
    }
}

void Lifting::update(std::vector<double>& values, std::size_t channels, std::size_t level,
                     double sign) const
{
  if(!m_is_updating)
    return;
  const std::vector<double>&coarse = m_weights[level], &fine = m_weights[level + 1];
  for(Index m = Index(coarse.size()); m < fine.size(); ++m)
    for(const Index end : m_subdivision->parents[m])
    {
      // Weights are not small but at rings of odd shapes, where an update would blow details up.
      const double weight = 0.5 * fine[m] / coarse[end];
      if(!(weight > 0. && weight < 1.))
        continue;
      for(std::size_t c = 0; c < channels; ++c)
        values[channels * end + c] += sign * weight * values[channels * m + c];
    }
}

void Lifting::turn(std::vector<double>& values, std::size_t level, bool is_into_frames) const
{
  const Level& coarse = m_subdivision->levels[level];
  for_each_midpoint(coarse,
                    [&](Index side)
                    {
                      const Frame axes = frame(coarse, values, side);
                      const Index m = coarse.midpoint[side];
                      const Spatial detail = place(values, m);
                      Spatial turned = {0., 0., 0.};
                      for(std::size_t k = 0; k < 3; ++k)
                        if(is_into_frames)
                          turned[k] = dot(axes[k], detail);
                        else
                          turned = turned + detail[k] * axes[k];
                      std::copy(turned.begin(), turned.end(), &values[3 * std::size_t(m)]);
                    });
}

void Lifting::analyze(std::vector<double>& values, std::size_t channels, bool is_in_frames) const
{
  for(std::size_t level = m_stencils.size(); level-- > 0;)
  {
    predict(values, channels, level, -1.);
    update(values, channels, level, 1.);
    if(is_in_frames)
      turn(values, level, true);
  }
}

void Lifting::synthesize(std::vector<double>& values, std::size_t channels, bool is_in_frames) const
{
  for(std::size_t level = 0; level < m_stencils.size(); ++level)
  {
    if(is_in_frames)
      turn(values, level, false);
    update(values, channels, level, -1.);
    predict(values, channels, level, 1.);
  }
}

std::vector<double> detail_norms(const Subdivision& subdivision)
{
  std::vector<double> result(subdivision.number_of_vertices(), 1.);
  for(std::size_t level = 0; level + 1 < subdivision.levels.size(); ++level)
    for(Index v = 0; v < subdivision.levels[level].number_of_vertices; ++v)
      result[v] *= 2.;
  return result;
}

void keep_largest(std::vector<double>& values, std::size_t channels, const Subdivision& subdivision,
                  std::size_t number)
{
  const Index coarsest = subdivision.levels.front().number_of_vertices;
  const std::vector<double> norms = detail_norms(subdivision);
  std::vector<Index> order(subdivision.number_of_vertices() - coarsest);
  std::iota(order.begin(), order.end(), coarsest);
  if(number >= order.size())
    return;
  std::vector<double> size(subdivision.number_of_vertices());
  for(const Index v : order)
  {
    for(std::size_t c = 0; c < channels; ++c)
      size[v] = std::hypot(size[v], values[channels * v + c]);
    size[v] *= norms[v];
  }
  // Of equal ones the first: the same for every machine.
  std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(number), order.end(),
                   [&](Index a, Index b)
                   { return size[a] > size[b] || (size[a] == size[b] && a < b); });
  for(auto v = order.begin() + std::ptrdiff_t(number); v != order.end(); ++v)
    std::fill_n(&values[channels * *v], channels, 0.);
}

} // namespace CGAL::Geodesic_processing::internal
