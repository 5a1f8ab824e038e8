// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `TriangulatedGeodesicDomain` describes a domain that has triangles between its sites, of
which the lengths of the sides are known. Fronts and finite elements need no more.

On a mesh each side has at most one twin, and the triangles form a surface. On a cloud they overlap,
and each has a weight. What unfolds strips of triangles, such as
`CGAL::Geodesic_processing::straightest_geodesic()`, needs a surface, and does not compile with a
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
  /// returns the triangles, their gluing and the lengths of their sides: what algorithms work on.
  std::shared_ptr<const Triangles> triangles() const;
};
