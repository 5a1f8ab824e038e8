# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
include_guard(GLOBAL)

# Reading the headers of meshes takes most of the compiler's time for a short program: programs read
# them precompiled.  Each includes what it uses all the same, as CMAKE_DISABLE_PRECOMPILE_HEADERS
# shows.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/client_headers.cpp CONTENT "")
add_library(client_headers OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/client_headers.cpp)
target_link_libraries(client_headers PRIVATE Geodesic_processing)
target_compile_options(client_headers PRIVATE ${GEODESIC_PROCESSING_CLIENT_OPTIONS})
target_precompile_headers(client_headers PRIVATE
  <CGAL/Geodesic_processing.h> <CGAL/Exact_predicates_inexact_constructions_kernel.h>
  <CGAL/Surface_mesh.h> <CGAL/boost/graph/IO/polygon_mesh_io.h> <CGAL/boost/graph/generators.h>
  <iostream>)

# A program of one source that uses the library as anybody would.
function(add_client name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE Geodesic_processing)
  target_compile_options(${name} PRIVATE ${GEODESIC_PROCESSING_CLIENT_OPTIONS})
  target_precompile_headers(${name} REUSE_FROM client_headers)
endfunction()
