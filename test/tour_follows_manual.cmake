# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if demo/tour/tour.md names a chapter or a section that the manual does not have, if their order
# differs from that of the manual, or if a demo program is missing.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
set(failures "")

# The headings of each chapter, as "# chapter" and "# chapter## section".
file(GLOB sources ${root}/doc/manual/*.txt)
list(REMOVE_ITEM sources ${root}/doc/manual/manual.txt ${root}/doc/manual/reference.txt)
foreach(source IN LISTS sources)
  file(STRINGS ${source} headings REGEX "^.(page|(sub)?section) ")
  list(POP_FRONT headings heading)
  string(REGEX MATCH "^.page ([A-Za-z0-9_]+) (.*)$" heading "${heading}")
  set(anchor ${CMAKE_MATCH_1})
  set(chapter "# ${CMAKE_MATCH_2}")
  list(TRANSFORM headings REPLACE "^.(sub)?section [A-Za-z0-9_]+ " "${chapter}## ")
  set(headings_${anchor} "${chapter}" ${headings})
endforeach()

# The headings of the manual in its order.
file(READ ${root}/doc/manual/manual.txt main_page)
string(REGEX MATCHALL "subpage [A-Za-z0-9_]+" subpages "${main_page}")
set(manual "")
foreach(subpage IN LISTS subpages)
  string(REPLACE "subpage " "" anchor ${subpage})
  list(APPEND manual ${headings_${anchor}})
endforeach()

file(STRINGS ${root}/demo/tour/tour.md headings REGEX "^##? ")
set(previous -1)
foreach(heading IN LISTS headings)
  if(heading MATCHES "^# ")
    set(chapter "${heading}")
  else()
    set(heading "${chapter}${heading}")
  endif()
  list(FIND manual "${heading}" position)
  if(position LESS 0)
    string(APPEND failures "  ${heading}: the manual has no such chapter or section\n")
  elseif(NOT position GREATER previous)
    string(APPEND failures "  ${heading}: the order differs from the manual\n")
  endif()
  set(previous ${position})
endforeach()

# Demo programs whose names begin with "make" generate models.
file(READ ${root}/demo/tour/tour.md tour)
file(GLOB demos ${root}/demo/*.cpp)
list(FILTER demos EXCLUDE REGEX "/make_[a-z_]+\\.cpp$")
foreach(demo IN LISTS demos)
  cmake_path(GET demo STEM name)
  string(FIND "${tour}" "\n    ${name} " position)
  if(position LESS 0)
    string(APPEND failures "  demo/${name}.cpp is not called\n")
  endif()
endforeach()

if(failures)
  message(FATAL_ERROR "demo/tour/tour.md has errors:\n${failures}")
endif()
