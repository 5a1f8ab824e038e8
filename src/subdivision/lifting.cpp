// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/lifting.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Level = Subdivision::Level;

// Valences and boundary flags of the vertices of a level.
struct Vertex_types
{
  std::vector<Index> valence; // #vertices: number of edges
  std::vector<bool> is_on_boundary;

  // Returns true for interior vertices whose valence is not 6.
  bool is_extraordinary(Index vertex) const
  {
    return !is_on_boundary[vertex] && valence[vertex] != 6;
  }
};

// Computes the valence of each vertex, and whether it lies on the boundary.
Vertex_types classify_vertices(const Level& level)
{
  Vertex_types result;
  result.valence.assign(level.number_of_vertices, 0);
  result.is_on_boundary.assign(level.number_of_vertices, false);
  for(Index h = 0; h < level.twin.size(); ++h)
  {
    if(!is_edge_representative(level, h))
      continue;
    for(const Index end : edge_vertices(level, h))
    {
      ++result.valence[end];
      if(level.twin[h] == none)
        result.is_on_boundary[end] = true;
    }
  }
  return result;
}

// Builds the stencils of the midpoints of a level, one halfedge at a time.
class Stencil_builder
{
public:
  Stencil_builder(const Level& level, Prediction prediction)
      : m_level(level), m_prediction(prediction), m_vertex_types(classify_vertices(level))
  {
    m_result.begin.push_back(0);
  }

  // Appends the stencil of the midpoint of a halfedge.
  void add(Index h)
  {
    const auto [a, b] = edge_vertices(m_level, h);
    const Index twin = m_level.twin[h];
    if(m_prediction == Prediction::linear)
      add_midpoint_weights(h);
    else if(twin == none)
      add_boundary_weights(h);
    else if(const bool is_a_extraordinary = m_vertex_types.is_extraordinary(a),
            is_b_extraordinary = m_vertex_types.is_extraordinary(b);
            is_a_extraordinary || is_b_extraordinary)
    {
      const double factor = is_a_extraordinary && is_b_extraordinary ? 0.5 : 1.;
      if(is_a_extraordinary)
        add_ring_weights(h, factor);
      if(is_b_extraordinary)
        add_ring_weights(twin, factor);
    }
    else
    {
      add_midpoint_weights(h);
      add_butterfly_wings(h);
      add_butterfly_wings(twin);
    }
    m_result.begin.push_back(Index(m_result.vertex.size()));
  }

  Prediction_stencils result() { return std::move(m_result); }

private:
  void add_weight(Index vertex, double weight)
  {
    m_result.vertex.push_back(vertex);
    m_result.weight.push_back(weight);
  }

  void add_midpoint_weights(Index h, double factor = 1.)
  {
    for(const Index end : edge_vertices(m_level, h))
      add_weight(end, 0.5 * factor);
  }

  // The four-point scheme along the boundary.
  void add_boundary_weights(Index h)
  {
    Index previous_boundary = previous_halfedge(h), next_boundary = next_halfedge(h);
    while(m_level.twin[previous_boundary] != none)
      previous_boundary = previous_halfedge(m_level.twin[previous_boundary]);
    while(m_level.twin[next_boundary] != none)
      next_boundary = next_halfedge(m_level.twin[next_boundary]);
    for(const Index end : edge_vertices(m_level, h))
      add_weight(end, 9. / 16.);
    add_weight(edge_vertices(m_level, previous_boundary)[0], -1. / 16.);
    add_weight(edge_vertices(m_level, next_boundary)[1], -1. / 16.);
  }

  // Adds the three butterfly vertices in the direction of the triangle of h. If a wing does not
  // exist, it is replaced by the reflection of the opposite corner across the midpoint of its edge,
  // so that linear functions are still reproduced.
  void add_butterfly_wings(Index h)
  {
    add_weight(opposite_vertex(m_level, h), 1. / 8.);
    for(const Index wing : {next_halfedge(h), previous_halfedge(h)})
      if(m_level.twin[wing] != none)
        add_weight(opposite_vertex(m_level, m_level.twin[wing]), -1. / 16.);
      else
      {
        for(const Index end : edge_vertices(m_level, wing))
          add_weight(end, -1. / 16.);
        add_weight(opposite_vertex(m_level, wing), 1. / 16.);
      }
  }

  // Adds the stencil of an extraordinary vertex, the source of h, and its ring (Zorin and others
  // 1996, section 3). If its fan is not closed, adds the midpoint weights instead.
  void add_ring_weights(Index h, double factor)
  {
    std::vector<Index> ring;
    Index current = h;
    do
    {
      ring.push_back(source_vertex(m_level, next_halfedge(current)));
      current = m_level.twin[previous_halfedge(current)];
    } while(current != none && current != h);
    const std::size_t k = ring.size();
    if(current == none || k < 3)
      return add_midpoint_weights(h, factor);
    add_weight(source_vertex(m_level, h), 0.75 * factor);
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
      add_weight(ring[i], weight * factor);
    }
  }

  const Level& m_level;
  Prediction m_prediction;
  Vertex_types m_vertex_types;
  Prediction_stencils m_result;
};

// Calls use(h) for one halfedge of each edge, in the order of the midpoints.
template <typename Use>
void for_each_midpoint(const Level& level, const Use& use)
{
  for(Index h = 0; h < level.twin.size(); ++h)
    if(is_edge_representative(level, h))
      use(h);
}

// Returns the three channels of a vertex as a vector.
Vec3 position(const std::vector<double>& values, Index vertex)
{
  return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
}

using Local_frame = std::array<Vec3, 3>; // normal, tangent along the edge, their cross product

// Returns the frame of the coarser surface at an edge. If the sine of an angle is below 0.01 (half
// a degree), the frame would depend on round-off errors: then returns the coordinate axes.
Local_frame local_frame(const Level& level, const std::vector<double>& values, Index h)
{
  constexpr double min_sine = 0.01;
  const Local_frame axes = {Vec3{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}};
  const auto [a, b] = edge_vertices(level, h);
  const Vec3 edge = position(values, b) - position(values, a);
  const double length = norm(edge);
  Vec3 normal = {0., 0., 0.};
  for(const Index g : {h, level.twin[h]})
  {
    if(g == none)
      continue;
    const Vec3 u = position(values, edge_vertices(level, g)[1]) -
                   position(values, edge_vertices(level, g)[0]),
               w = position(values, opposite_vertex(level, g)) -
                   position(values, edge_vertices(level, g)[0]);
    const Vec3 area_vector = cross(u, w);
    const double size = norm(u) * norm(w);
    if(!(norm(area_vector) > min_sine * size && size > 1e-280 && size < 1e280))
      return axes;
    normal = normal + (1. / norm(area_vector)) * area_vector;
  }
  const double size = norm(normal);
  if(!(size > min_sine))
    return axes;
  normal = (1. / size) * normal;
  const Vec3 tangent = (1. / length) * edge;
  return {normal, tangent, cross(normal, tangent)};
}

} // namespace

Prediction_stencils prediction_stencils(const Subdivision& subdivision, std::size_t level,
                                        Prediction prediction)
{
  Stencil_builder builder(subdivision.levels[level], prediction);
  for_each_midpoint(subdivision.levels[level], [&](Index h) { builder.add(h); });
  return builder.result();
}

Lifting::Lifting(std::shared_ptr<const Subdivision> subdivision, Prediction prediction,
                 bool use_update)
    : m_subdivision(std::move(subdivision)), m_weights(m_subdivision->levels.size()),
      m_use_update(use_update)
{
  const std::size_t last = m_subdivision->levels.size() - 1;
  for(std::size_t level = 0; level < last; ++level)
    m_stencils.push_back(prediction_stencils(*m_subdivision, level, prediction));
  // The weights are the integrals of the scaling functions: the weight of a midpoint is distributed
  // to the vertices of its stencil.
  m_weights[last].assign(m_subdivision->number_of_vertices(), 1.);
  for(std::size_t level = last; level-- > 0;)
  {
    const Prediction_stencils& rows = m_stencils[level];
    const Index n = m_subdivision->levels[level].number_of_vertices;
    const std::vector<double>& fine = m_weights[level + 1];
    std::vector<double>& coarse = m_weights[level];
    coarse.assign(fine.begin(), fine.begin() + n);
    for(Index m = n; m < fine.size(); ++m)
      for(Index i = rows.begin[m - n]; i < rows.begin[m - n + 1]; ++i)
        coarse[rows.vertex[i]] += rows.weight[i] * fine[m];
  }
}

// Adds the predictions of the midpoints to their values if sign is 1; subtracts them if it is -1.
void Lifting::predict(std::vector<double>& values, std::size_t channels, std::size_t level,
                      double sign) const
{
  const Prediction_stencils& rows = m_stencils[level];
  double* midpoint = &values[channels * m_subdivision->levels[level].number_of_vertices];
  for(std::size_t m = 0; m + 1 < rows.begin.size(); ++m, midpoint += channels)
    for(std::size_t c = 0; c < channels; ++c)
    {
      double sum = 0.;
      for(Index i = rows.begin[m]; i < rows.begin[m + 1]; ++i)
        sum += rows.weight[i] * values[channels * rows.vertex[i] + c];
      midpoint[c] += sign * sum;
    }
}

// Adds (sign is 1) or subtracts (sign is -1) weighted details at both ends of the edges.
void Lifting::update(std::vector<double>& values, std::size_t channels, std::size_t level,
                     double sign) const
{
  if(!m_use_update)
    return;
  const std::vector<double>&coarse = m_weights[level], &fine = m_weights[level + 1];
  for(Index m = Index(coarse.size()); m < fine.size(); ++m)
    for(const Index end : m_subdivision->parents[m])
    {
      // Coarse weights are only small or negative at irregular rings, where an update would amplify
      // details.
      const double weight = 0.5 * fine[m] / coarse[end];
      if(!(weight > 0. && weight < 1.))
        continue;
      for(std::size_t c = 0; c < channels; ++c)
        values[channels * end + c] += sign * weight * values[channels * m + c];
    }
}

// Expresses the details of a level in local frames, or returns them to coordinates.
void Lifting::rotate_details(std::vector<double>& values, std::size_t level, bool is_forward) const
{
  const Level& coarse = m_subdivision->levels[level];
  for_each_midpoint(coarse,
                    [&](Index h)
                    {
                      const Local_frame axes = local_frame(coarse, values, h);
                      const Index m = coarse.midpoint[h];
                      const Vec3 detail = position(values, m);
                      Vec3 rotated = {0., 0., 0.};
                      for(std::size_t k = 0; k < 3; ++k)
                        if(is_forward)
                          rotated[k] = dot(axes[k], detail);
                        else
                          rotated = rotated + detail[k] * axes[k];
                      std::copy(rotated.begin(), rotated.end(), &values[3 * std::size_t(m)]);
                    });
}

void Lifting::analyze(std::vector<double>& values, std::size_t channels, bool is_in_frames) const
{
  for(std::size_t level = m_stencils.size(); level-- > 0;)
  {
    predict(values, channels, level, -1.);
    update(values, channels, level, 1.);
    if(is_in_frames)
      rotate_details(values, level, true);
  }
}

void Lifting::synthesize(std::vector<double>& values, std::size_t channels, bool is_in_frames) const
{
  for(std::size_t level = 0; level < m_stencils.size(); ++level)
  {
    if(is_in_frames)
      rotate_details(values, level, false);
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
  // Ties are resolved by index, so that the result is the same on all machines.
  std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(number), order.end(),
                   [&](Index a, Index b)
                   { return size[a] > size[b] || (size[a] == size[b] && a < b); });
  for(auto v = order.begin() + std::ptrdiff_t(number); v != order.end(); ++v)
    std::fill_n(&values[channels * *v], channels, 0.);
}

} // namespace CGAL::Geodesic_processing::internal
