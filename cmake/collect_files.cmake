# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
include_guard(GLOBAL)

# collect_files(RESULT PATTERN...): the files that match the patterns.  A pattern without any match
# fails the configuration: otherwise a renamed folder would silently drop its sources or tests.
function(collect_files result)
  set(all_files "")
  foreach(pattern IN LISTS ARGN)
    file(GLOB files CONFIGURE_DEPENDS ${pattern})
    if(NOT files)
      message(FATAL_ERROR "No file matches ${pattern}.")
    endif()
    list(APPEND all_files ${files})
  endforeach()
  set(${result} ${all_files} PARENT_SCOPE)
endfunction()
