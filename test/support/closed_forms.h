// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_CLOSED_FORMS_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_CLOSED_FORMS_H

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

// Integral closed 1-forms of a mesh. Their integrals along closed curves tell homology classes
// apart.

namespace CGAL::Geodesic_processing::test {

// One number for each halfedge, with the opposite sign for its twin. The sum in each triangle is
// zero.
using Closed_form = std::vector<double>;

// Returns integral closed 1-forms whose classes are a basis of the first cohomology group with
// integer coefficients. Each one counts the crossings with a dual curve, from the boundary to the
// boundary or closed, in a spanning tree of triangles and across one more edge.
inline std::vector<Closed_form> closed_forms(const Surface_arrays& t)
{
  using namespace internal;
  const Index n = Index(t.number_of_triangles());
  // The tree of triangles grows depth first from the last triangle, or from the exterior of the
  // boundary, which is triangle n.
  std::vector<Index> parent_halfedge(n, none);
  std::vector<bool> is_reached(n, false), is_crossed(t.corner.size(), false);
  const auto cross = [&](Index h)
  {
    is_crossed[h] = true;
    if(t.twin[h] != none)
      is_crossed[t.twin[h]] = true;
  };
  const auto grow = [&](Index root)
  {
    std::vector<Index> stack = {root};
    is_reached[root] = true;
    while(!stack.empty())
    {
      const Index f = stack.back();
      stack.pop_back();
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(t.twin[h] != none && !is_reached[t.twin[h] / 3])
        {
          is_reached[t.twin[h] / 3] = true;
          parent_halfedge[t.twin[h] / 3] = t.twin[h];
          cross(h);
          stack.push_back(t.twin[h] / 3);
        }
    }
  };
  for(Index h = Index(t.corner.size()); h-- > 0;)
    if(t.twin[h] == none && !is_reached[h / 3])
    {
      parent_halfedge[h / 3] = h;
      cross(h);
      grow(h / 3);
    }
  for(Index f = n; f-- > 0;)
    if(!is_reached[f])
      grow(f);
  // The tree of vertices joins sets of vertices along edges that are not crossed.
  std::vector<Index> set(t.number_of_vertices());
  for(Index v = 0; v < set.size(); ++v)
    set[v] = v;
  const auto set_of = [&](Index v)
  {
    while(set[v] != v)
      v = set[v] = set[set[v]];
    return v;
  };
  std::vector<Closed_form> result;
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    if(is_crossed[h] || (t.twin[h] != none && t.twin[h] < h))
      continue;
    const Index a = set_of(t.corner[h]), b = set_of(t.corner[next_halfedge(h)]);
    if(a != b)
    {
      set[a] = b;
      continue;
    }
    Closed_form form(t.corner.size(), 0.);
    const auto add = [&](Index crossed, double amount)
    {
      form[crossed] += amount;
      if(t.twin[crossed] != none)
        form[t.twin[crossed]] -= amount;
    };
    const auto add_crossings_to_root = [&](Index from, double amount)
    {
      while(from != none && parent_halfedge[from / 3] != none)
      {
        add(parent_halfedge[from / 3], amount);
        from = t.twin[parent_halfedge[from / 3]];
      }
    };
    add(h, 1.);
    add_crossings_to_root(h, -1.);
    add_crossings_to_root(t.twin[h], 1.);
    result.push_back(std::move(form));
  }
  return result;
}

// Returns the integral of a closed 1-form along a path. It is linear in each triangle.
inline double integral(const Surface_arrays& t, const Closed_form& form,
                       const std::vector<Surface_location>& path)
{
  using namespace internal;
  double result = 0.;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Surface_location from = canonical(t, path[i]), to = canonical(t, path[i + 1]);
    const Index f = common_triangle(t, from, to);
    const auto b = *barycentric_in(t, f, from), c = *barycentric_in(t, f, to);
    result += form[3 * f] * (c[1] - b[1]) + (form[3 * f] + form[3 * f + 1]) * (c[2] - b[2]);
  }
  return result;
}

// Returns the integral along a closed curve, an integer.
inline double period(const Surface_arrays& t, const Closed_form& form,
                     const std::vector<Surface_location>& loop)
{
  std::vector<Surface_location> closed = loop;
  closed.push_back(loop.front());
  return integral(t, form, closed);
}

// Returns the determinant of the periods of loops.
inline double determinant_of_periods(const Surface_arrays& t, const std::vector<Closed_form>& forms,
                                     const std::vector<std::vector<Surface_location>>& loops)
{
  Eigen::MatrixXd periods(forms.size(), loops.size());
  for(std::size_t i = 0; i < forms.size(); ++i)
    for(std::size_t j = 0; j < loops.size(); ++j)
      periods(i, j) = std::round(period(t, forms[i], loops[j]));
  return periods.size() == 0 ? 1. : periods.determinant();
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_CLOSED_FORMS_H
