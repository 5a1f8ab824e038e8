// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `TriangulatedGeodesicDomain` describes a domain with triangles whose edge lengths are known.
Fronts and finite elements require this concept.

On a mesh, each halfedge has at most one twin, and the triangles form a surface. On a cloud, triangles
overlap, and each has a weight. If a function must unfold strips of triangles, such as
`CGAL::Geodesic_processing::straightest_geodesic()`, it requires a mesh and does not compile with a
cloud.

\cgalRefines{`GeodesicDomain`}

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Geodesic_processing::Mesh_domain<TriangleMesh>`}
\cgalHasModels{`CGAL::Geodesic_processing::Surfel_domain<SurfelRange>`}
\cgalHasModelsEnd
*/
class TriangulatedGeodesicDomain
{
public:
  /// Returns the surface arrays that all algorithms use: the triangles, the twin of each halfedge, and the
  /// edge lengths.
  std::shared_ptr<const Triangles> triangles() const;
};
