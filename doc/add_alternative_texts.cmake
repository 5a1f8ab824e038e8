# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Adds alternative texts to the pictures of the HTML pages in FOLDER: the caption of each picture.
# Doxygen writes `alt=""`, and SVG pictures as `object`, which has no such attribute.  Fails if a page
# has a picture without text.
set(caption "\n<div class=\"caption\">\n([^<\"]*)</div>")
set(new_caption "\n<div class=\"caption\">\n\\2</div>")

set(failures "")
set(number 0)
file(GLOB pages ${FOLDER}/*.html)
foreach(page IN LISTS pages)
  file(READ ${page} text)
  set(described "${text}")
  string(REGEX REPLACE "<img src=\"([^\"]*)\" alt=\"\"/>${caption}"
         "<img src=\"\\1\" alt=\"\\2\"/>${new_caption}" described "${described}")
  string(REGEX REPLACE "<object type=\"image/svg.xml\" data=\"([^\"]*)\"[^>]*></object>${caption}"
         "<img src=\"\\1\" alt=\"\\2\"/>${new_caption}" described "${described}")
  if(NOT described STREQUAL text)
    math(EXPR number "${number} + 1")
    file(WRITE ${page} "${described}")
  endif()
  # Texts can contain semicolons, which separate the elements of a list.
  string(REPLACE ";" "," described "${described}")
  string(REGEX MATCHALL "<(img|object)[^>]*>" pictures "${described}")
  foreach(picture IN LISTS pictures)
    if(NOT picture MATCHES " alt=\"[^\"]")
      string(APPEND failures "  ${page}: ${picture}\n")
    endif()
  endforeach()
endforeach()
if(failures OR number EQUAL 0)
  message(FATAL_ERROR "${number} pages have captions; pictures without a text:\n${failures}")
endif()
