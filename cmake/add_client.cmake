# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
include_guard(GLOBAL)

# Parsing the headers of meshes takes most of the compile time of a short program, so programs use a
# precompiled header.  Each source nevertheless includes all headers that it uses, so that it compiles
# with CMAKE_DISABLE_PRECOMPILE_HEADERS.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/client_headers.cpp CONTENT "")
add_library(client_headers OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/client_headers.cpp)
target_link_libraries(client_headers PRIVATE Geodesic_processing)
target_compile_options(client_headers PRIVATE ${GEODESIC_PROCESSING_CLIENT_OPTIONS})
target_precompile_headers(client_headers PRIVATE ${CMAKE_CURRENT_LIST_DIR}/client_headers.h)

add_library(client_instances STATIC EXCLUDE_FROM_ALL
            ${CMAKE_CURRENT_LIST_DIR}/client_instances.cpp)
target_link_libraries(client_instances PRIVATE Geodesic_processing)
target_compile_options(client_instances PRIVATE ${GEODESIC_PROCESSING_CLIENT_OPTIONS})
target_precompile_headers(client_instances REUSE_FROM client_headers)

# Adds a program with one source file, which is compiled like the code of a user of the library.
function(add_client name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE client_instances Geodesic_processing)
  target_compile_options(${name} PRIVATE ${GEODESIC_PROCESSING_CLIENT_OPTIONS})
  target_precompile_headers(${name} REUSE_FROM client_headers)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()
