// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "client_headers.h"

namespace CGAL {

template Client_mesh::Surface_mesh();
template Client_mesh& Client_mesh::operator=(const Client_mesh&);
template class Geodesic_processing::Mesh_domain<Client_mesh>;
template class Geodesic_processing::Surfel_domain<Client_cloud>;
template bool IO::read_polygon_mesh(const std::string&, Client_mesh&,
                                    const parameters::Default_named_parameters&);
template bool IO::write_polygon_mesh(const std::string&, Client_mesh&,
                                     const parameters::Default_named_parameters&);

} // namespace CGAL
