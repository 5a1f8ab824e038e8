# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if the program uses an internal header, an internal name, or a member that gives kernels
# access to an object, without a comment that begins with "// Not public: " and states the reason.
# The comment is on the same line or before a group of such lines.
include(${CMAKE_CURRENT_LIST_DIR}/../cmake/folders.cmake)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
if(NOT FOLDER)
  set(FOLDER ${root}/src/geodesic)
endif()
list(JOIN kernel_folders "|" folders)
set(internal_header "^# *include (<.*/internal/|\"(${folders}|adaptors)/)")
set(internal_name "(^|[^A-Za-z0-9_])internal([^A-Za-z0-9_]|$)")
set(kernel_access "[.>]((arrays|inner|inner_vertex|map|outer|surfel_input|surfels)\\(|triangles\\(\\))")
set(reason "// Not public: [A-Za-z]")

set(found "")
set(number_of_exceptions 0)
file(GLOB_RECURSE files ${FOLDER}/*.h ${FOLDER}/*.cpp)
foreach(file IN LISTS files)
  # Lines become elements of a list, in which these characters have a meaning.
  file(READ ${file} text)
  string(REGEX REPLACE "[][;\\\\]" " " text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  set(has_reason FALSE)
  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    string(REGEX REPLACE "//.*$" "" code "${line}")
    if(code MATCHES "${internal_header}|${internal_name}|${kernel_access}")
      math(EXPR number_of_exceptions "${number_of_exceptions} + 1")
      if(NOT has_reason AND NOT line MATCHES "${reason}")
        string(APPEND found "  ${file}:${number}: ${line}\n")
      endif()
    elseif(line MATCHES "^ *${reason}")
      set(has_reason TRUE)
    elseif(NOT line MATCHES "^ *//")
      set(has_reason FALSE)
    endif()
  endforeach()
endforeach()

if(found)
  message(FATAL_ERROR "The program uses internals without a comment \"// Not public: \":\n${found}")
endif()
# Without exceptions, the patterns or the folder are wrong.
if(number_of_exceptions EQUAL 0)
  message(FATAL_ERROR "No exception was found in ${FOLDER}.")
endif()
