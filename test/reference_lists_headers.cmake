# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if the front page of the reference does not name the function or class of a public header.
cmake_minimum_required(VERSION 3.24)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
file(READ ${root}/doc/manual/reference.txt page)
file(GLOB headers RELATIVE ${root}/include/CGAL/Geodesic_processing
     ${root}/include/CGAL/Geodesic_processing/*.h)

# These headers contain several functions or classes, none of which has the name of the header.
set(functions_decal composite_decal)
set(functions_distortion face_distortion)
set(functions_exceptions Cancelled)
set(functions_geodesic_curves geodesic_spline)
set(functions_geodesic_loops loop_basis)
set(functions_is_supported is_supported_v)
set(functions_speeds curvature_speeds)
set(functions_tags Automatic)
# These headers contain results and options of other functions.
set(other_headers Location Surface_path parameters surfel_variants transport_costs)

set(missing "")
foreach(header IN LISTS headers)
  cmake_path(GET header STEM name)
  if(DEFINED functions_${name})
    set(name ${functions_${name}})
  endif()
  if(NOT name IN_LIST other_headers AND NOT page MATCHES "`${name}(\\(\\))?`")
    string(APPEND missing "  ${name}\n")
  endif()
endforeach()

if(NOT headers)
  message(FATAL_ERROR "There are no public headers.")
endif()
if(missing)
  message(FATAL_ERROR "The front page of the reference does not name:\n${missing}")
endif()
