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

constexpr std::size_t max_centers = 8;

// The distances from a selected location to the vertices that its front reached.
struct Center_distances
{
  std::size_t location;
  std::vector<std::pair<Index, double>> vertices;
  std::vector<double> locations; // #locations
  double weight = 0.;            // of the locations that it replaces
};

Center_distances distances_from(Front& front, const std::vector<Surface_location>& locations,
                                std::size_t center, const std::function<bool(double)>& callback)
{
  Front_limits limits;
  limits.targets = locations;
  limits.callback = callback;
  if(!front.run({{{locations[center]}, 0., 0}}, limits))
    throw Cancelled();
  Center_distances result = {center, {}, {}, 0.};
  for(const Index vertex : front.reached())
    result.vertices.emplace_back(vertex, front.distance(vertex));
  for(const Surface_location& location : locations)
    result.locations.push_back(front.distance(location));
  return result;
}

} // namespace

Surface_location coarse_mean(std::shared_ptr<const Surface_arrays> triangles,
                             const std::vector<Surface_location>& locations,
                             const std::vector<double>& weights,
                             const std::function<bool(double)>& callback)
{
  const std::size_t number_of_vertices = triangles->number_of_vertices();
  Front front(std::move(triangles), Front_kind::euclidean);
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

  std::vector<double> sum(number_of_vertices, 0.);
  std::vector<std::size_t> number_of_terms(number_of_vertices, 0);
  for(const Center_distances& center : centers)
    for(const auto& [vertex, distance] : center.vertices)
    {
      sum[vertex] += center.weight * distance * distance;
      ++number_of_terms[vertex];
    }
  Surface_location best;
  double smallest_sum = infinity;
  for(Index vertex = 0; vertex < number_of_vertices; ++vertex)
    if(number_of_terms[vertex] == centers.size() && sum[vertex] < smallest_sum)
    {
      smallest_sum = sum[vertex];
      best = {none, vertex, {}};
    }
  for(const Center_distances& center : centers)
  {
    double sum_at_center = 0.;
    for(const Center_distances& other : centers)
    {
      const double distance = other.locations[center.location];
      sum_at_center += other.weight * distance * distance;
    }
    if(sum_at_center < smallest_sum)
    {
      smallest_sum = sum_at_center;
      best = locations[center.location];
    }
  }
  return best;
}

} // namespace CGAL::Geodesic_processing::internal
