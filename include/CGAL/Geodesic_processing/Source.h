// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SOURCE_H
#define CGAL_GEODESIC_PROCESSING_SOURCE_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/mesh_of.h>
#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/is_supported.h>

#include <cmath>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingSources
///
/// Represents a source of distances: a vertex or surfel, a location, or a polyline on the surface.
/// A source also has an offset, which is its own distance, and a label.
///
/// Consecutive locations of a polyline must be in a common face. A polyline is closed if its first
/// location is repeated at the end.
///
/// Constructors copy or move their arguments and check nothing. Functions that take sources throw
/// if a location or an offset is invalid. All members take O(1) time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Source
{
public:
  using Vertex = typename internal::Surface_traits<Surface>::Vertex; ///< a vertex or a surfel
  /// A location on the surface
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Polyline = std::vector<Location>; ///< consecutive locations

  /// Constructs a source at a vertex or surfel.
  /// \param vertex a vertex or surfel
  /// \param offset the distance of the source itself, in the unit of the coordinates; can be
  ///        negative
  /// \param label the label; if it is not given, the position in the range of sources
  Source(Vertex vertex, double offset = 0., std::optional<std::size_t> label = std::nullopt)
      : m_location(vertex), m_offset(offset), m_has_label(label.has_value()),
        m_label(label.value_or(0))
  {}
  /// Constructs a source at a `location`. `offset` and `label` are as for a vertex.
  Source(Location location, double offset = 0., std::optional<std::size_t> label = std::nullopt)
      : m_location(Polyline{std::move(location)}), m_offset(offset), m_has_label(label.has_value()),
        m_label(label.value_or(0))
  {}
  /// Constructs a source along a `polyline`. `offset` and `label` are as for a vertex.
  Source(Polyline polyline, double offset = 0., std::optional<std::size_t> label = std::nullopt)
      : m_location(std::move(polyline)), m_offset(offset), m_has_label(label.has_value()),
        m_label(label.value_or(0))
  {}

  /// Returns the vertex or the polyline. A single location is a polyline of one location.
  const std::variant<Vertex, Polyline>& location() const { return m_location; }
  /// Returns the offset, in the unit of the coordinates.
  double offset() const { return m_offset; }
  /// Returns the label, or `position` if no label was given.
  std::size_t label(std::size_t position) const { return m_has_label ? m_label : position; }

private:
  std::variant<Vertex, Polyline> m_location;
  double m_offset;
  bool m_has_label;
  std::size_t m_label;
};

/// \ingroup PkgGeodesicProcessingSources
///
/// Writes a `Source` for each boundary cycle of a triangle mesh: a closed polyline. O(n + b log b)
/// for b halfedges on the boundary.
///
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam OutputIterator a model of `OutputIterator` for `Source` objects of the mesh
/// \param mesh_or_domain the mesh, or its domain
/// \param out receives the sources, in the order of the halfedges
/// \returns the output iterator past the last source
template <typename Mesh, typename OutputIterator>
OutputIterator border_sources(const Mesh& mesh_or_domain, OutputIterator out)
{
  using TriangleMesh = Surface_of<Mesh>;
  static_assert(internal::require_support<Function::border_sources, Mesh>());
  const TriangleMesh& mesh = internal::mesh_of(mesh_or_domain);
  using Graph = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Graph::halfedge_descriptor;
  // Returns the location of the target vertex of a boundary halfedge, in the face of the opposite
  // halfedge.
  const auto location_at_end = [&](Halfedge h)
  {
    const Halfedge inner = opposite(h, mesh); // starts at that vertex
    typename Source<TriangleMesh>::Location location;
    location.first = face(inner, mesh);
    Halfedge k = halfedge(location.first, mesh);
    for(double& coordinate : location.second)
    {
      coordinate = k == inner ? 1. : 0.;
      k = next(k, mesh);
    }
    return location;
  };
  std::set<Halfedge> visited;
  for(const Halfedge first : halfedges(mesh))
  {
    if(face(first, mesh) != Graph::null_face() || visited.count(first) != 0)
      continue;
    typename Source<TriangleMesh>::Polyline polyline;
    for(Halfedge h = first; polyline.empty() || h != first; h = next(h, mesh))
    {
      visited.insert(h);
      polyline.push_back(location_at_end(h));
    }
    polyline.push_back(polyline.front());
    *out++ = Source<TriangleMesh>(std::move(polyline));
  }
  return out;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SOURCE_H
