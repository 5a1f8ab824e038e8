// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/degenerate_triangles.h"

#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The smallest difference of the triangle inequality, as a fraction of the longest edge.
constexpr double min_difference = 1e-15;
// Longer edges can make adjacent triangles degenerate. Two passes repair the parts and scans that
// have degenerate triangles; more are needed only in strips of them.
constexpr int max_lengthening_passes = 50;

// Returns the length by which both edges a and b must grow in a triangle whose longest edge is c.
double missing_length(double a, double b, double c)
{
  const double missing = (1. + min_difference) * c - (a + b);
  // Adds the difference once more, so that round-off errors do not matter.
  return missing > 0. ? 0.5 * (missing + min_difference * c) : 0.;
}

// Returns the longest edge of a triangle.
Index longest_edge(const std::vector<double>& length, Index triangle)
{
  Index result = 3 * triangle;
  for(Index h = result + 1; h < 3 * triangle + 3; ++h)
    if(length[h] > length[result])
      result = h;
  return result;
}

// Returns the length that is missing in a triangle.
double missing_length(const std::vector<double>& length, Index longest)
{
  return missing_length(length[next_halfedge(longest)], length[previous_halfedge(longest)],
                        length[longest]);
}

} // namespace

std::shared_ptr<const Surface_arrays>
without_degenerate_triangles(std::shared_ptr<const Surface_arrays> mesh)
{
  const Index number_of_triangles = Index(mesh->number_of_triangles());
  std::vector<Index> degenerate;
  for(Index triangle = 0; triangle < number_of_triangles; ++triangle)
    if(missing_length(mesh->length, longest_edge(mesh->length, triangle)) > 0.)
      degenerate.push_back(triangle);
  if(degenerate.empty())
    return mesh;

  auto result = std::make_shared<Surface_arrays>(*mesh);
  std::vector<double>& length = result->length;
  for(int pass = 0; pass < max_lengthening_passes && !degenerate.empty(); ++pass)
  {
    std::vector<Index> next;
    for(const Index triangle : degenerate)
    {
      const Index longest = longest_edge(length, triangle);
      const double missing = missing_length(length, longest);
      if(!(missing > 0.))
        continue;
      for(const Index h : {next_halfedge(longest), previous_halfedge(longest)})
      {
        length[h] += missing;
        if(const Index twin = mesh->twin[h]; twin != none)
        {
          length[twin] = length[h];
          next.push_back(twin / 3);
        }
      }
    }
    degenerate = std::move(next);
  }
  return result;
}

namespace {

// Returns the largest height of triangles with a longest edge c: that of the isosceles triangle.
//
// difference  that of the sum of the other edges and c
double max_height(double c, double difference)
{
  return std::sqrt(0.5 * c * std::max(difference, 0.) + 0.25 * difference * difference);
}

} // namespace

Distance_error distance_error_of_thin_triangles(const Surface_arrays& mesh)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon(), max_aspect_ratio = 30.;
  const double max_error = std::sqrt(10. * epsilon);
  // Longer edges are those of the input: min_edge_length was scaled by less than this.
  constexpr double max_lengthened = 1e6 * min_edge_length;
  Distance_error result;
  for(Index triangle = 0; triangle < mesh.number_of_triangles(); ++triangle)
  {
    const Index longest = longest_edge(mesh.length, triangle);
    const double a = mesh.length[next_halfedge(longest)],
                 b = mesh.length[previous_halfedge(longest)], c = mesh.length[longest],
                 difference = a + b - c;
    if(difference < 1e-14 * c)
    {
      result.excess += max_height(c, difference);
      result.shortfall += max_height(c, difference + 4. * epsilon * c);
    }
    else if(const double height = twice_area(a, b, c) / c; c > max_aspect_ratio * height)
    {
      const double error = std::min(10. * epsilon * c * (c / height), max_error * c);
      result.excess += error;
      result.shortfall += error;
    }
    if(!mesh.point.empty())
      for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
        if(mesh.length[h] < max_lengthened)
          result.excess +=
              std::max(0., mesh.length[h] - norm(mesh.point[mesh.corner[h]] -
                                                 mesh.point[mesh.corner[next_halfedge(h)]]));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
