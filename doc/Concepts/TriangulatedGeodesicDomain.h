// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `TriangulatedGeodesicDomain` describes a domain whose triangles form a surface: each side
has at most one twin, and the triangles around each site can be walked around.

Algorithms that unfold strips of triangles (straightest geodesics, shortest paths that are exact)
need it. A surfel cloud is no model, as its triangles overlap; passing one does not compile.

\cgalRefines{`GeodesicDomain`}

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Geodesic_processing::Mesh_domain<TriangleMesh>`}
\cgalHasModelsEnd
*/
class TriangulatedGeodesicDomain
{
};
