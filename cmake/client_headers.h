// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROCESSING_CLIENT_HEADERS_H
#define GEODESIC_PROCESSING_CLIENT_HEADERS_H

#include <CGAL/Geodesic_processing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

// The precompiled header of the program's commands, demo programs, examples and tests.

// Readers and writers of all formats take most of the compile time of a demo program.  They are
// instantiated once, in client_instances.cpp, for the two types of meshes that clients use.
#define GEODESIC_PROCESSING_CLIENT_INSTANCES(EXTERN, KERNEL)                                       \
  namespace CGAL::IO {                                                                             \
  EXTERN template bool read_polygon_mesh(const std::string&, Surface_mesh<KERNEL::Point_3>&,       \
                                         const parameters::Default_named_parameters&);             \
  EXTERN template bool write_polygon_mesh(const std::string&, Surface_mesh<KERNEL::Point_3>&,      \
                                          const parameters::Default_named_parameters&);            \
  }

GEODESIC_PROCESSING_CLIENT_INSTANCES(extern, CGAL::Epick)
GEODESIC_PROCESSING_CLIENT_INSTANCES(extern, CGAL::Simple_cartesian<double>)

#endif // GEODESIC_PROCESSING_CLIENT_HEADERS_H
