// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle_list = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangle_list::const_iterator>;
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 to_point(const Vec3& p) { return {p[0], p[1], p[2]}; }

} // namespace

struct Triangle_tree::Tree
{
  std::vector<Index> index; // of each listed triangle: triangles without area are omitted
  Triangle_list triangles;
  Aabb_tree tree;
};

Triangle_tree::Triangle_tree(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(std::move(triangles))
{
  const Surface_arrays& t = *m_triangles;
  auto data = std::make_shared<Tree>();
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Vec3 &a = t.point[t.corner[3 * f]], &b = t.point[t.corner[3 * f + 1]],
               &c = t.point[t.corner[3 * f + 2]];
    const Vec3 normal = cross(b - a, c - a);
    if(!(dot(normal, normal) > 0.))
      continue;
    data->index.push_back(f);
    data->triangles.emplace_back(to_point(a), to_point(b), to_point(c));
  }
  data->tree.rebuild(data->triangles.cbegin(), data->triangles.cend());
  data->tree.build(); // otherwise the first query builds it, which is not thread-safe
  m_tree = std::move(data);
}

Surface_location Triangle_tree::nearest(const std::array<double, 3>& point) const
{
  const Surface_arrays& t = *m_triangles;
  for(const double x : point)
    if(!std::isfinite(x))
      throw Invalid_argument_error("A coordinate of the point to locate is not finite.");
  if(t.number_of_vertices() == 0)
    throw Invalid_argument_error("A point cannot be located on an empty surface.");
  // Clamp distant points, so that squared distances cannot overflow.
  Vec3 p;
  for(int k = 0; k < 3; ++k)
    p[k] = std::clamp((point[k] - t.origin[k]) / t.scale, -1e100, 1e100);
  if(m_tree->triangles.empty())
  {
    const auto nearest =
        std::min_element(t.point.begin(), t.point.end(),
                         [&](const Vec3& q, const Vec3& r) { return norm(q - p) < norm(r - p); });
    return vertex_location(t, static_cast<Index>(nearest - t.point.begin()));
  }
  const auto hit = m_tree->tree.closest_point_and_primitive(to_point(p));
  const Index f = m_tree->index[hit.second - m_tree->triangles.cbegin()];
  return canonical(t, {f, none,
                       nearest_in_triangle(t.point[t.corner[3 * f]], t.point[t.corner[3 * f + 1]],
                                           t.point[t.corner[3 * f + 2]], p)});
}

} // namespace CGAL::Geodesic_processing::internal
