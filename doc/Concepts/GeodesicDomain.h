// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `GeodesicDomain` describes a surface as a graph with edge lengths. Its vertices are the
vertices of a mesh or the surfels of a cloud. This documentation calls both a vertex if the
difference does not matter.

`CGAL::Geodesic_processing::make_domain()` computes a domain from a surface. A domain is immutable and
can be copied at no cost, because copies share their data. It can be passed to a function instead of
the surface. If a function must access the mesh itself, such as
`CGAL::Geodesic_processing::texture_atlas()`, pass the mesh.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Geodesic_processing::Mesh_domain<TriangleMesh>`}
\cgalHasModels{`CGAL::Geodesic_processing::Surfel_domain<SurfelRange>`}
\cgalHasModelsEnd
*/
class GeodesicDomain
{
public:
  /// The type of the mesh or the cloud.
  using Surface = unspecified_type;
  /// The descriptor of a vertex of the mesh, or the index of a surfel.
  using Vertex = unspecified_type;
  /// The type of a point on the surface.
  using Location = unspecified_type;

  /// Returns the number of vertices of the mesh, or of surfels of the cloud.
  std::size_t number_of_vertices() const;

  /// Writes one value for each vertex to a property map.
  ///
  /// \param values a function that returns the value of the vertex with index `i`, for `i` from 0 to
  ///        `number_of_vertices()` - 1
  /// \param map a writable property map whose key type is `Site`
  template <typename Values, typename WritablePropertyMap>
  void write(const Values& values, WritablePropertyMap map) const;
};
