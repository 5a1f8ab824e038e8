# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if a file states another version than CMakeLists.txt.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
set(number "[0-9]+\\.[0-9]+\\.[0-9]+")

# version_of(FILE PATTERN RESULT): the number after the first text that matches the pattern.
function(version_of name pattern result)
  file(READ ${root}/${name} text)
  if(NOT text MATCHES "${pattern}(${number})")
    message(FATAL_ERROR "${name} has no version after ${pattern}")
  endif()
  set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()

version_of(CMakeLists.txt "project\\(Geodesic_processing VERSION " expected)
set(pattern_pyproject.toml "\nversion = \"")
set(pattern_CITATION.cff "\nversion: ")
set(pattern_CHANGES.md "\n## ")
set(pattern_src/geodesic/app/run.cpp "\"geodesic ")
foreach(name IN ITEMS pyproject.toml CITATION.cff CHANGES.md src/geodesic/app/run.cpp)
  version_of(${name} "${pattern_${name}}" version)
  if(NOT version STREQUAL expected)
    message(FATAL_ERROR "${name} has version ${version}, CMakeLists.txt has version ${expected}")
  endif()
endforeach()
