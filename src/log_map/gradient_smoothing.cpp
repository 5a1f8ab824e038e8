// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_map/gradient_smoothing.h"

#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A neighbor of a vertex in counterclockwise order, and the angle to the next one.
struct Star_neighbor
{
  Index vertex;
  double length, angle;
};

// The maximum angle between adjacent neighbors of a surfel in the interior of a cloud. Surfels on
// a straight boundary have an angle of pi up to noise.
constexpr double max_sector_angle = 3.;

// Returns the one-ring of a vertex; empty at the boundary and at a nonmanifold vertex.
std::vector<Star_neighbor> star_on_mesh(const Surface_arrays& t, Index vertex)
{
  std::vector<Star_neighbor> star;
  const Index begin = t.ring_begin[vertex], end = t.ring_begin[vertex + 1];
  for(Index i = begin; i < end; ++i)
  {
    const Index corner = t.ring[i];
    if(next_corner_ccw(t, corner) != t.ring[i + 1 < end ? i + 1 : begin])
      return {};
    star.push_back({t.corner[next_halfedge(corner)], t.length[corner], interior_angle(t, corner)});
  }
  return star;
}

// Returns the neighbors of a surfel, projected to its tangent plane; empty at the boundary.
std::vector<Star_neighbor> star_on_cloud(const Surface_arrays& t, Index vertex)
{
  const auto [x, y] = tangent_frame(t.normal[vertex]);
  std::vector<Star_neighbor> star; // `angle` is the polar angle until the star is sorted
  for(Index i = t.graph.begin[vertex]; i < t.graph.begin[vertex + 1]; ++i)
  {
    const Vec3 offset = t.point[t.graph.target[i]] - t.point[vertex];
    const Vec2 projected = {dot(offset, x), dot(offset, y)};
    if(norm(projected) > 0.)
      star.push_back({t.graph.target[i], norm(projected), std::atan2(projected[1], projected[0])});
  }
  if(star.empty())
    return {};
  std::sort(star.begin(), star.end(),
            [](const Star_neighbor& a, const Star_neighbor& b)
            { return a.angle < b.angle || (a.angle == b.angle && a.vertex < b.vertex); });
  const double first = star.front().angle;
  for(std::size_t i = 0; i < star.size(); ++i)
  {
    star[i].angle = (i + 1 < star.size() ? star[i + 1].angle : first + 2. * pi) - star[i].angle;
    if(star[i].angle > max_sector_angle)
      return {};
  }
  return star;
}

// Returns whether a map is discontinuous between adjacent vertices. The distance of the images
// exceeds four edge lengths as in is_cut(), and the directions differ by more than 60 degrees. The
// second condition admits the errors of Dijkstra's distances, which exceed four edge lengths far
// from the base point.
bool is_discontinuous(const Vec2& a, const Vec2& b, double length)
{
  return norm(b - a) > 4. * length && dot(a, b) < 0.5 * norm(a) * norm(b);
}

// The weights of the neighbors of each vertex in compressed rows. The row of a vertex that is not
// smoothed is empty.
struct Smoothing_weights
{
  std::vector<Index> begin = {0}; // #vertices + 1
  std::vector<Index> neighbor;    // positions in the array of vertices
  std::vector<double> weight;     // of the neighbors; the sum of a row is one
};

void add_row(const std::vector<Star_neighbor>& star,
             const std::unordered_map<Index, Index>& position, const std::vector<Vec2>& vectors,
             Index i, Smoothing_weights& rows)
{
  const std::size_t begin = rows.neighbor.size();
  double sum = 0.;
  bool is_smoothed = true;
  for(std::size_t k = 0; k < star.size() && is_smoothed; ++k)
  {
    const auto found = position.find(star[k].vertex);
    is_smoothed = found != position.end() &&
                  !is_discontinuous(vectors[i], vectors[found->second], star[k].length);
    if(!is_smoothed)
      break;
    const double previous_angle = star[k > 0 ? k - 1 : star.size() - 1].angle;
    rows.neighbor.push_back(found->second);
    rows.weight.push_back((std::tan(previous_angle / 2.) + std::tan(star[k].angle / 2.)) /
                          star[k].length);
    sum += rows.weight.back();
  }
  if(!is_smoothed || !(sum > 0.) || !std::isfinite(sum))
  {
    rows.neighbor.resize(begin);
    rows.weight.resize(begin);
  }
  for(std::size_t k = begin; k < rows.weight.size(); ++k)
    rows.weight[k] /= sum;
}

} // namespace

void smooth_gradients(const Surface_arrays& t, const std::vector<Index>& vertices,
                      const std::vector<double>& distances, std::size_t number_of_steps,
                      std::vector<Vec2>& vectors)
{
  std::unordered_map<Index, Index> position;
  for(Index i = 0; i < vertices.size(); ++i)
  {
    position.emplace(vertices[i], i);
    if(!(distances[i] > 0.))
      vectors[i] = {0., 0.};
  }
  Smoothing_weights rows;
  for(Index i = 0; i < vertices.size(); ++i)
  {
    if(distances[i] > 0.)
      add_row(t.is_cloud() ? star_on_cloud(t, vertices[i]) : star_on_mesh(t, vertices[i]), position,
              vectors, i, rows);
    rows.begin.push_back(Index(rows.neighbor.size()));
  }
  std::vector<Vec2> next = vectors;
  for(std::size_t step = 0; step < number_of_steps; ++step)
  {
    for(Index i = 0; i < vertices.size(); ++i)
    {
      if(rows.begin[i] == rows.begin[i + 1])
        continue;
      Vec2 mean = {0., 0.};
      for(Index k = rows.begin[i]; k < rows.begin[i + 1]; ++k)
        mean = mean + rows.weight[k] * vectors[rows.neighbor[k]];
      next[i] = 0.5 * (vectors[i] + mean);
    }
    std::swap(vectors, next);
  }
}

} // namespace CGAL::Geodesic_processing::internal
