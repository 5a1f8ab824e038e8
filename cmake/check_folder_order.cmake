# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if a file includes a header of a folder that folders.cmake does not list for its own folder,
# if a reader includes a header of a library that is not listed there, if a folder is empty, or if src
# holds a file outside of the folders.
cmake_minimum_required(VERSION 3.24)
include(${CMAKE_CURRENT_LIST_DIR}/folders.cmake)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
set(internal ${root}/include/CGAL/Geodesic_processing/internal)
set(violations "")

# Appends the includes of `folder`'s files that name one of `known` but neither `folder` nor its uses.
function(check_folder folder known)
  foreach(file IN LISTS ARGN)
    file(STRINGS ${file} lines REGEX "^#include")
    foreach(line IN LISTS lines)
      if(NOT line MATCHES "[<\"/](CGAL/Geodesic_processing/internal/)?([a-z_]+)/[A-Za-z_]+\\.h[>\"]")
        continue()
      endif()
      set(included ${CMAKE_MATCH_2})
      if(included IN_LIST known AND NOT included STREQUAL folder
         AND NOT included IN_LIST ${folder}_uses)
        cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${root} OUTPUT_VARIABLE name)
        string(APPEND violations "  ${name}: ${line}\n")
      endif()
    endforeach()
  endforeach()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

foreach(folder IN LISTS kernel_folders ITEMS adaptors)
  file(GLOB files ${root}/src/${folder}/* ${internal}/${folder}/*)
  if(NOT files)
    string(APPEND violations "  ${folder}: no files\n")
  endif()
  check_folder(${folder} "${kernel_folders};adaptors" ${files})
endforeach()
foreach(folder IN LISTS program_folders)
  file(GLOB files ${root}/src/geodesic/${folder}/*)
  if(NOT files)
    string(APPEND violations "  geodesic/${folder}: no files\n")
  endif()
  check_folder(${folder} "${program_folders}" ${files})
endforeach()

file(GLOB files ${root}/src/geodesic/readers/*)
foreach(file IN LISTS files)
  file(STRINGS ${file} lines REGEX "^ *# *include")
  foreach(line IN LISTS lines)
    # Headers of the standard library have neither a folder nor an extension.
    string(REGEX REPLACE "^ *# *include *[<\"](.*)[>\"].*$" "\\1" header ${line})
    if(NOT header MATCHES "^(readers/[A-Za-z0-9_]+\\.h|[a-z0-9_]+)$" AND NOT header IN_LIST reader_headers)
      cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${root} OUTPUT_VARIABLE name)
      string(APPEND violations "  ${name}: ${line}\n")
    endif()
  endforeach()
endforeach()

file(GLOB entries RELATIVE ${root}/src ${root}/src/*)
foreach(entry IN LISTS entries)
  if(NOT entry MATCHES "^(geodesic|python|view)$" AND NOT entry IN_LIST kernel_folders)
    string(APPEND violations "  src/${entry}: not a folder of folders.cmake\n")
  endif()
endforeach()

if(violations)
  message(FATAL_ERROR "The folder order of cmake/folders.cmake is violated:\n${violations}")
endif()
