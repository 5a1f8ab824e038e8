// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/feature_masses.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <cstddef>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A location of a feature with its length, which is zero for a point.
struct Feature_node
{
  Surface_location location;
  double length;
  double count; // number of points; less than one for a corner of a blocked triangle
};

// Adds a node. If the triangle of the location is blocked, its corners can be in different
// components. The node is then divided between them.
void add_node(const Surface_arrays& t, const std::vector<double>& area, const Feature_node& node,
              std::vector<Feature_node>& result)
{
  const Surface_location& location = node.location;
  if(location.triangle == none || area[location.triangle] > 0.)
  {
    result.push_back(node);
    return;
  }
  for(std::size_t k = 0; k < 3; ++k)
    if(const double weight = location.barycentric[k]; weight > 0.)
      result.push_back({{none, t.corner[3 * std::size_t(location.triangle) + k], {}},
                        weight * node.length,
                        weight * node.count});
}

std::vector<Feature_node> feature_nodes(const Surface_arrays& t, const std::vector<double>& area,
                                        const std::vector<std::vector<Surface_location>>& polylines)
{
  std::vector<Feature_node> result;
  for(const std::vector<Surface_location>& polyline : polylines)
    for(std::size_t i = 0; i < polyline.size(); ++i)
    {
      double length = 0.;
      if(i > 0)
        length += 0.5 * polyline_length(t, {polyline[i - 1], polyline[i]});
      if(i + 1 < polyline.size())
        length += 0.5 * polyline_length(t, {polyline[i], polyline[i + 1]});
      add_node(t, area, {polyline[i], length, 1.}, result);
    }
  return result;
}

} // namespace

Feature_masses uniform_feature_masses(const Surface_arrays& triangles,
                                      const std::vector<Metric_tensor>& metric,
                                      const std::vector<std::vector<Surface_location>>& polylines)
{
  const Operators o = metric_operators(triangles, metric);
  Feature_masses result;
  std::size_t number_of_components = 0;
  std::tie(result.component, number_of_components) = components(o);
  const std::vector<Feature_node> nodes = feature_nodes(triangles, o.area, polylines);
  const auto component_of = [&](const Surface_location& location)
  {
    return result.component[location.triangle == none
                                ? location.vertex
                                : triangles.corner[3 * std::size_t(location.triangle)]];
  };
  std::vector<double> length(number_of_components, 0.), count(number_of_components, 0.);
  for(const Feature_node& node : nodes)
  {
    length[component_of(node.location)] += node.length;
    count[component_of(node.location)] += node.count;
  }
  for(const double number : count)
    result.has_feature.push_back(number > 0.);

  result.surface.density = Vector::Zero(Eigen::Index(triangles.number_of_vertices()));
  for(Index vertex = 0; vertex < result.component.size(); ++vertex)
    if(result.has_feature[result.component[vertex]])
      result.surface.density[vertex] = 1.;
  const Vector mass = masses_at_vertices(triangles, o.area, result.surface);
  std::vector<double> total(number_of_components, 0.);
  for(Index vertex = 0; vertex < result.component.size(); ++vertex)
    total[result.component[vertex]] += mass[vertex];
  for(const Feature_node& node : nodes)
  {
    const Index c = component_of(node.location);
    const double fraction = length[c] > 0. ? node.length / length[c] : node.count / count[c];
    result.feature.at_locations.emplace_back(node.location, total[c] * fraction);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
