# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Compiles calls without output.  A rejected call must not compile, and the compiler must print the
# reason.
#
# COMPILER  the compiler
# OPTIONS   its options, separated by semicolons
# CALLS     meshes, clouds: the calls that is_supported_v admits; functions: one call of each
#           function that rejects meshes or clouds; arguments: the calls of rejected_calls.cpp
set(folder ${CMAKE_CURRENT_LIST_DIR})
function(compile file)
  execute_process(COMMAND ${COMPILER} -std=c++17 -fsyntax-only ${OPTIONS} ${ARGN} ${folder}/${file}
                  RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
  set(result ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()
function(expect_compiles)
  compile(${ARGN})
  if(NOT result EQUAL 0)
    string(SUBSTRING "${output}" 0 3000 output)
    message(FATAL_ERROR "${ARGN} does not compile:\n${output}")
  endif()
endfunction()
function(expect_rejected reason)
  compile(${ARGN})
  string(FIND "${output}" "${reason}" position)
  if(result EQUAL 0 OR position EQUAL -1 OR reason STREQUAL "")
    message(FATAL_ERROR "${ARGN} is not rejected with the reason: ${reason}")
  endif()
endfunction()
# The number of rejected calls guards against a pattern that finds none.
function(expect_at_least minimum number)
  if(number LESS minimum)
    message(FATAL_ERROR "Only ${number} rejected calls were found.")
  endif()
endfunction()

set(number 0)
if(CALLS STREQUAL functions)
  file(READ ${folder}/../include/CGAL/Geodesic_processing/is_supported.h text)
  string(REGEX MATCHALL "(MESHES|CLOUDS)\\([A-Za-z_]+,[^\"]*\"[^\"]+\"" rejections "${text}")
  foreach(rejection IN LISTS rejections)
    string(REGEX MATCH "\\(([A-Za-z_]+),[^\"]*\"([^\"]+)\"" match "${rejection}")
    expect_rejected("${CMAKE_MATCH_2}" supported_surfaces.cpp -DREJECTED=${CMAKE_MATCH_1})
    math(EXPR number "${number} + 1")
  endforeach()
  expect_at_least(12 ${number})
elseif(CALLS STREQUAL arguments)
  expect_compiles(rejected_calls.cpp -DCALL=0 -w)
  file(STRINGS ${folder}/rejected_calls.cpp calls REGEX "CALL == ")
  foreach(call IN LISTS calls)
    string(REGEX MATCH "CALL == ([0-9]+) +// (.+)" match "${call}")
    expect_rejected("${CMAKE_MATCH_2}" rejected_calls.cpp -DCALL=${CMAKE_MATCH_1})
    math(EXPR number "${number} + 1")
  endforeach()
  expect_at_least(10 ${number})
else()
  string(TOUPPER ${CALLS} calls)
  expect_compiles(supported_surfaces.cpp -D${calls})
endif()
