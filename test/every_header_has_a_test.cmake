# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if a public header, or a kernel (an internal or private header with a source of the same
# name), has no test of the same name.
include(${CMAKE_CURRENT_LIST_DIR}/../cmake/folders.cmake)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
set(include ${root}/include/CGAL/Geodesic_processing)
set(missing "")

file(GLOB headers ${include}/*.h)
foreach(header IN LISTS headers)
  cmake_path(GET header STEM name)
  if(NOT EXISTS ${root}/test/${name}_test.cpp)
    string(APPEND missing "  test/${name}_test.cpp\n")
  endif()
endforeach()

foreach(folder IN LISTS kernel_folders)
  file(GLOB headers ${include}/internal/${folder}/*.h ${root}/src/${folder}/*.h)
  foreach(header IN LISTS headers)
    cmake_path(GET header STEM name)
    if(EXISTS ${root}/src/${folder}/${name}.cpp
       AND NOT EXISTS ${root}/test/internal/${folder}/${name}_test.cpp)
      string(APPEND missing "  test/internal/${folder}/${name}_test.cpp\n")
    endif()
  endforeach()
endforeach()

if(missing)
  message(FATAL_ERROR "headers without a test; these files are missing:\n${missing}")
endif()
