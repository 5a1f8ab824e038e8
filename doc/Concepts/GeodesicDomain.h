// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `GeodesicDomain` describes what is measured along: sites (the vertices of a mesh, or the
surfels of a cloud) and the arcs between them, each with a length.

A domain is made by `CGAL::Geodesic_processing::make_domain()`, cheap to copy (copies share the data)
and never changes. It is the first argument of every function of this package, in place of the
surface that it was made from.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Geodesic_processing::Mesh_domain<TriangleMesh>`}
\cgalHasModels{`CGAL::Geodesic_processing::Surfel_domain<SurfelRange>`}
\cgalHasModelsEnd
*/
class GeodesicDomain
{
public:
  /// the type of the mesh or the cloud.
  using Surface = unspecified_type;
  /// the caller's descriptor of a site.
  using Site = unspecified_type;
  /// a place anywhere on the surface.
  using Location = unspecified_type;

  /// returns the number of vertices or surfels.
  std::size_t number_of_sites() const;

  /// puts `values(i)`, for `i` from zero up to the number of sites, into `map` at the caller's
  /// descriptor of the domain's i-th site.
  template <typename Values, typename WritablePropertyMap>
  void write(const Values& values, WritablePropertyMap map) const;
};
