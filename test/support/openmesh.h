// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_OPENMESH_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_OPENMESH_H

// OpenMesh's mesh types, if it is installed.
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
#  if defined(__GNUC__) && !defined(__clang__)
// OpenMesh's properties append a T() that this compiler regards as uninitialized.
#    pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#  endif
#  include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#  include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_OPENMESH_H
