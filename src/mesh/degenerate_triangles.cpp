// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/degenerate_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The smallest difference of the triangle inequality, as a fraction of the longest edge.
constexpr double min_difference = 1e-15;
// Longer edges can make adjacent triangles degenerate.  Two passes repair the parts and scans that
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

double total_height_of_degenerate_triangles(const Surface_arrays& mesh)
{
  double result = 0.;
  for(Index triangle = 0; triangle < mesh.number_of_triangles(); ++triangle)
  {
    const Index longest = longest_edge(mesh.length, triangle);
    const double c = mesh.length[longest];
    const double a = mesh.length[next_halfedge(longest)],
                 b = mesh.length[previous_halfedge(longest)];
    const double difference = a + b - c;
    // The height is at most that of the isosceles triangle.
    if(difference < 1e-14 * c)
      result += std::sqrt(0.5 * c * std::max(difference, 0.) + 0.25 * difference * difference);
    // The input can have an edge of length zero instead. It can have become slightly longer.
    if(std::min(a, b) < 2. * min_edge_length)
      result += min_edge_length;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
