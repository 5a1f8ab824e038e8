# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Compiles calls without output.  Rejected calls must not compile, and the compiler must print the
# reason of each of them.
#
# COMPILER  the compiler
# OPTIONS   its options, separated by semicolons
# CALLS     accepted: the calls that is_supported_v admits; rejected: those that it does not admit,
#           and the calls of rejected_calls.cpp
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

# expect_rejected(FILE PATTERN WITH_REASONS MINIMUM): compiling FILE prints each reason.  The pattern
# finds the reasons in the file WITH_REASONS, which has at least MINIMUM of them.
function(expect_rejected file pattern with_reasons minimum)
  compile(${file} -DREJECTED)
  file(READ ${folder}/${with_reasons} text)
  string(REGEX MATCHALL "${pattern}" matches "${text}")
  list(LENGTH matches number)
  if(number LESS minimum)
    message(FATAL_ERROR "Only ${number} reasons were found in ${with_reasons}.")
  endif()
  foreach(match IN LISTS matches)
    string(REGEX MATCH "${pattern}" match "${match}")
    string(FIND "${output}" "${CMAKE_MATCH_1}" position)
    if(CMAKE_MATCH_1 STREQUAL "" OR position EQUAL -1)
      message(FATAL_ERROR "${file}: a call is not rejected with the reason: ${CMAKE_MATCH_1}")
    endif()
  endforeach()
endfunction()

if(CALLS STREQUAL accepted)
  expect_compiles(supported_surfaces.cpp -DON_MESHES)
  expect_compiles(supported_surfaces.cpp -DON_CLOUDS)
  expect_compiles(rejected_calls.cpp -w)
else()
  expect_rejected(supported_surfaces.cpp "[ED]S\\([A-Za-z_]+,[^\"]*\"([^\"]+)\""
                  ../include/CGAL/Geodesic_processing/is_supported.h 12)
  expect_rejected(rejected_calls.cpp "// REASON: ([^\n]+)" rejected_calls.cpp 26)
endif()
