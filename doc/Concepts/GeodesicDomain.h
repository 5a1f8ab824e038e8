// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `GeodesicDomain` describes what is measured along: sites (the vertices of a mesh, or the
surfels of a cloud) and the triangles between them, with the length of each side.

A domain is made by `CGAL::Geodesic_processing::make_domain()`, cheap to copy (copies share the data)
and never changes. It is the first argument of every function of this package, in place of the
surface that it was made from.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Geodesic_processing::Mesh_domain<TriangleMesh>`}
\cgalHasModels{`CGAL::Geodesic_processing::Surfel_domain<Cloud>`}
\cgalHasModelsEnd
*/
class GeodesicDomain
{
public:
  /// returns the number of vertices or surfels.
  std::size_t number_of_sites() const;

  /// puts `values[i]`, the value of the i-th site, into `map` at the caller's descriptor of the site.
  template <typename Values, typename WritablePropertyMap>
  void write(const Values& values, WritablePropertyMap map) const;
};
