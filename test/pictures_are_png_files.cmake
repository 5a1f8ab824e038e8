# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if a picture of the manual is not a complete PNG file: it begins with the signature, and ends
# with an IEND chunk and its checksum.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
file(GLOB pictures ${root}/doc/fig/*.png)
if(NOT pictures)
  message(FATAL_ERROR "doc/fig has no pictures")
endif()
foreach(picture IN LISTS pictures)
  file(READ ${picture} bytes HEX)
  if(NOT bytes MATCHES "^89504e470d0a1a0a.*0000000049454e44ae426082$")
    message(SEND_ERROR "${picture} is not a PNG file")
  endif()
endforeach()
