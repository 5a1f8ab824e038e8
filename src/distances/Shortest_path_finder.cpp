// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Shortest_path_finder.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include <utility>

namespace CGAL::Geodesic_processing::internal {

Shortest_path_finder::Shortest_path_finder(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(std::move(triangles)), m_finder(m_triangles)
{}

Bounded_path Shortest_path_finder::locally_shortest_path(const Surface_location& from,
                                                         const Surface_location& to)
{
  return {shorten_path(*m_triangles, m_finder(from, to)),
          straight_distance(*m_triangles, from, to)};
}

Bounded_path Shortest_path_finder::shorten(const std::vector<Surface_location>& polyline)
{
  if(polyline.size() < 2)
    throw Invalid_argument_error("A polyline has fewer than two points.");
  std::vector<Surface_location> path;
  for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
  {
    const std::vector<Surface_location> part = m_finder(polyline[i], polyline[i + 1]);
    if(part.empty())
      return {};
    path.insert(path.end(), part.begin(), part.end());
  }
  return {shorten_path(*m_triangles, path),
          straight_distance(*m_triangles, polyline.front(), polyline.back())};
}

Bounded_path Shortest_path_finder::shortest_path(const Surface_location& from,
                                                 const Surface_location& to,
                                                 const std::function<bool(double)>& callback)
{
  Bounded_path first = locally_shortest_path(from, to);
  if(m_triangles->is_cloud() || first.locations.size() < 2)
    return first;
  if(!m_windows)
    m_windows.emplace(m_triangles);
  Bounded_path shorter =
      m_windows->path_between(from, to, path_length(*m_triangles, first.locations), callback);
  if(shorter.locations.empty())
    shorter.locations = std::move(first.locations);
  return shorter;
}

} // namespace CGAL::Geodesic_processing::internal
