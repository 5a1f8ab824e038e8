# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Compiles supported_surfaces.cpp without output: the calls that is_supported_v admits, on meshes or on
# clouds, or each call that it rejects.  A rejected call must not compile, and the compiler must print
# the reason.
#
# COMPILER  the compiler
# OPTIONS   its options, separated by semicolons
# CALLS     meshes, clouds or rejected
set(folder ${CMAKE_CURRENT_LIST_DIR})
function(compile)
  execute_process(COMMAND ${COMPILER} -std=c++17 -fsyntax-only ${OPTIONS} ${ARGN}
                          ${folder}/supported_surfaces.cpp
                  RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
  set(result ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

if(NOT CALLS STREQUAL rejected)
  string(TOUPPER ${CALLS} calls)
  compile(-D${calls})
  if(NOT result EQUAL 0)
    string(SUBSTRING "${output}" 0 3000 output)
    message(FATAL_ERROR "A call on ${CALLS} does not compile:\n${output}")
  endif()
  return()
endif()

file(READ ${folder}/../include/CGAL/Geodesic_processing/is_supported.h text)
string(REGEX MATCHALL "(MESHES|CLOUDS)\\([A-Za-z_]+,[^\"]*\"[^\"]+\"" rejections "${text}")
set(number 0)
foreach(rejection IN LISTS rejections)
  string(REGEX MATCH "\\(([A-Za-z_]+),[^\"]*\"([^\"]+)\"" match "${rejection}")
  set(name ${CMAKE_MATCH_1})
  set(reason "${CMAKE_MATCH_2}")
  compile(-DREJECTED=${name})
  string(FIND "${output}" "${reason}" position)
  if(result EQUAL 0 OR position EQUAL -1)
    message(FATAL_ERROR "${name}() is not rejected with the reason: ${reason}")
  endif()
  math(EXPR number "${number} + 1")
endforeach()
if(number LESS 12)
  message(FATAL_ERROR "Only ${number} functions that reject a surface were found.")
endif()
