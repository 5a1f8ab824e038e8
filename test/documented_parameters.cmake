# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if the documentation of a named parameter lacks its description, its type, or a default or
# an extra.
set(folder ${CMAKE_CURRENT_LIST_DIR}/../include/CGAL/Geodesic_processing)
file(GLOB headers ${folder}/*.h)
set(number 0)
set(errors "")
foreach(header IN LISTS headers)
  file(READ ${header} text)
  # Semicolons and brackets would change the list of the blocks, a backslash its elements.
  string(REGEX REPLACE "[][;\\]" " " text "${text}")
  string(REPLACE "cgalParamNBegin{" ";" blocks "${text}")
  list(POP_FRONT blocks)
  foreach(block IN LISTS blocks)
    math(EXPR number "${number} + 1")
    string(REGEX REPLACE "}.*" "" name "${block}")
    string(REGEX REPLACE "cgalParamNEnd.*" "" block "${block}")
    foreach(part IN ITEMS Description Type Default|Extra)
      if(NOT block MATCHES "cgalParam(${part}){")
        string(APPEND errors "  ${header}: ${name}: no ${part}\n")
      endif()
    endforeach()
  endforeach()
endforeach()
if(errors OR number LESS 150)
  message(FATAL_ERROR "${number} documented parameters; missing:\n${errors}")
endif()
