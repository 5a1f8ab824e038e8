# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if a file of the program uses internals of the library without a reason: a comment that
# begins with "Not public: ".
set(folder ${CMAKE_CURRENT_LIST_DIR}/../src/geodesic)
file(GLOB_RECURSE sources ${folder}/*.h ${folder}/*.cpp)
set(errors "")
set(number 0)
foreach(source IN LISTS sources)
  file(READ ${source} text)
  if(text MATCHES "internal::|/internal/|namespace internal")
    math(EXPR number "${number} + 1")
    if(NOT text MATCHES "// Not public: [^\n]+")
      string(APPEND errors "  ${source}\n")
    endif()
  endif()
endforeach()
if(errors OR number EQUAL 0)
  message(FATAL_ERROR "${number} files use internals; without a reason:\n${errors}")
endif()
