// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROCESSING_CLIENT_HEADERS_H
#define GEODESIC_PROCESSING_CLIENT_HEADERS_H

#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

// The precompiled header of the program's commands, demo programs and examples. They use the kernel
// Simple_cartesian<double>: parsing the headers of kernels with exact predicates takes twice as
// long.

namespace CGAL {

using Client_kernel = Simple_cartesian<double>;
using Client_mesh = Surface_mesh<Client_kernel::Point_3>;
using Client_cloud = Point_set_3<Client_kernel::Point_3>;

// Meshes, domains, and the readers and writers of all formats take most of the compile time of a
// demo program. They are instantiated once, in client_instances.cpp.
extern template Client_mesh::Surface_mesh();
extern template Client_mesh& Client_mesh::operator=(const Client_mesh&);
extern template class Geodesic_processing::Mesh_domain<Client_mesh>;
extern template class Geodesic_processing::Surfel_domain<Client_cloud>;
extern template bool IO::read_polygon_mesh(const std::string&, Client_mesh&,
                                           const parameters::Default_named_parameters&);
extern template bool IO::write_polygon_mesh(const std::string&, Client_mesh&,
                                            const parameters::Default_named_parameters&);

} // namespace CGAL

#endif // GEODESIC_PROCESSING_CLIENT_HEADERS_H
