# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if a public function has a deduced return type: the reference could not show it.  The named
# parameters are an exception, since their types are those of a chain.
set(folder ${CMAKE_CURRENT_LIST_DIR}/../include/CGAL/Geodesic_processing)
file(GLOB headers ${folder}/*.h)
list(FILTER headers EXCLUDE REGEX "/parameters\\.h$")
set(found "")
foreach(header IN LISTS headers)
  file(READ ${header} text)
  string(REGEX MATCHALL "\n *(static |inline |constexpr )*auto [a-z_0-9]+\\([^;]" declarations "${text}")
  if(declarations)
    string(APPEND found "${header}:${declarations}\n")
  endif()
endforeach()
list(LENGTH headers number)
if(found OR number LESS 55)
  message(FATAL_ERROR "Deduced return types in ${number} headers:\n${found}")
endif()
