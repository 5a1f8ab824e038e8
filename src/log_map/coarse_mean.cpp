// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/coarse_mean.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// From the results for 40 random locations on 8 models, all means are at least as good as the best
// vertex. With 8 centers, three of 24 means were worse, by up to 0.7 %.
constexpr std::size_t max_centers = 16;
constexpr std::size_t max_candidates = 8;

// The distances from a selected location to the vertices that its front reached.
struct Center_distances
{
  std::size_t location;
  std::vector<std::pair<Index, double>> vertices;
  std::vector<double> locations; // #locations
  double weight = 0.;            // of the locations that it replaces
};

// Where the sum of squared distances is small.
struct Candidate
{
  double sum;
  Surface_location location;
};

double squared(double x) { return x * x; }

void run(Front& front, const Surface_location& from, const std::vector<Surface_location>& targets,
         const std::function<bool(double)>& callback)
{
  Front_limits limits;
  limits.targets = targets;
  limits.callback = callback;
  if(!front.run({{{from}, 0., 0}}, limits))
    throw Cancelled();
}

Center_distances distances_from(Front& front, const std::vector<Surface_location>& locations,
                                std::size_t center, const std::function<bool(double)>& callback)
{
  run(front, locations[center], locations, callback);
  Center_distances result = {center, {}, {}, 0.};
  for(const Index vertex : front.reached())
    result.vertices.emplace_back(vertex, front.distance(vertex));
  for(const Surface_location& location : locations)
    result.locations.push_back(front.distance(location));
  return result;
}

// Returns the vertices whose sum of squared distances to the centers is not larger than those of
// their neighbors. Vertices that are not reached from all centers are not considered.
std::vector<Candidate> local_minima(const Surface_arrays& t,
                                    const std::vector<Center_distances>& centers)
{
  std::vector<double> sum(t.number_of_vertices(), 0.);
  std::vector<std::size_t> number_of_terms(t.number_of_vertices(), 0);
  for(const Center_distances& center : centers)
    for(const auto& [vertex, distance] : center.vertices)
    {
      sum[vertex] += center.weight * squared(distance);
      ++number_of_terms[vertex];
    }
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    if(number_of_terms[vertex] < centers.size())
      sum[vertex] = infinity;
  std::vector<Candidate> result;
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    bool is_minimum = sum[vertex] < infinity;
    for(Index i = t.ring_begin[vertex]; is_minimum && i < t.ring_begin[vertex + 1]; ++i)
      is_minimum = sum[vertex] <= sum[t.corner[next_halfedge(t.ring[i])]] &&
                   sum[vertex] <= sum[t.corner[previous_halfedge(t.ring[i])]];
    if(is_minimum)
      result.push_back({sum[vertex], {none, vertex, {}}});
  }
  return result;
}

} // namespace

Surface_location coarse_mean(const std::shared_ptr<const Surface_arrays>& triangles,
                             const std::vector<Surface_location>& locations,
                             const std::vector<double>& weights,
                             const std::function<bool(double)>& callback)
{
  Front front(triangles, Front_kind::euclidean);
  std::vector<Center_distances> centers;
  std::vector<double> nearest_distance(locations.size(), infinity);
  std::vector<std::size_t> nearest(locations.size(), 0);
  for(std::size_t next = 0; centers.size() < max_centers;)
  {
    centers.push_back(distances_from(front, locations, next, callback));
    for(std::size_t i = 0; i < locations.size(); ++i)
      if(const double distance = centers.back().locations[i]; distance < nearest_distance[i])
      {
        nearest_distance[i] = distance;
        nearest[i] = centers.size() - 1;
      }
    next = std::size_t(std::max_element(nearest_distance.begin(), nearest_distance.end()) -
                       nearest_distance.begin());
    if(!(nearest_distance[next] < infinity))
      throw Invalid_argument_error("The locations are not all in one component of the surface.");
    if(!(nearest_distance[next] > 0.))
      break;
  }
  for(std::size_t i = 0; i < locations.size(); ++i)
    centers[nearest[i]].weight += weights[i];

  std::vector<Candidate> candidates = local_minima(*triangles, centers);
  for(const Center_distances& center : centers)
  {
    double sum = 0.;
    for(const Center_distances& other : centers)
      sum += other.weight * squared(other.locations[center.location]);
    candidates.push_back({sum, locations[center.location]});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.sum < b.sum; });
  candidates.resize(std::min(candidates.size(), max_candidates));
  Surface_location best = candidates.front().location;
  if(candidates.size() == 1 || centers.size() == locations.size())
    return best;
  double smallest_sum = infinity;
  for(const Candidate& candidate : candidates)
  {
    run(front, candidate.location, locations, callback);
    double sum = 0.;
    for(std::size_t i = 0; i < locations.size(); ++i)
      sum += weights[i] * squared(front.distance(locations[i]));
    if(sum < smallest_sum)
    {
      smallest_sum = sum;
      best = candidate.location;
    }
  }
  return best;
}

} // namespace CGAL::Geodesic_processing::internal
