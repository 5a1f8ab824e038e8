# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if the page of the manual about the papers names an example, a demo, a benchmark or a picture
# that does not exist, or a status that it does not define.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
file(READ ${root}/demo/run.sh pictures)
file(STRINGS ${root}/doc/manual/papers.txt rows REGEX "^\\| [^:]")
set(failures "")

foreach(row IN LISTS rows)
  if(NOT row MATCHES "\\| (item|as in the paper|different: |absent)" OR row MATCHES "\\| different: \\|")
    string(APPEND failures "  status: ${row}\n")
  endif()
  string(REGEX MATCH "[^|]*\\|$" cell "${row}")
  string(REGEX MATCHALL "(example|demo|gallery|benchmark|test)|`[^`]+`" tokens "${cell}")
  set(kind "")
  foreach(token IN LISTS tokens)
    if(NOT token MATCHES "^`(.*)`$")
      set(kind ${token})
      continue()
    endif()
    set(name ${CMAKE_MATCH_1})
    set(folder_example doc/examples)
    set(folder_demo demo)
    set(folder_benchmark test/benchmark)
    if(kind STREQUAL gallery)
      # The names of pictures in loops end with a variable.
      string(REGEX REPLACE "-[0-9.]+$" "-$" prefix ${name})
      string(FIND "${pictures}" "picture ${name} " position)
      string(FIND "${pictures}" "picture ${prefix}" position_in_loop)
      if(position LESS 0 AND (prefix STREQUAL name OR position_in_loop LESS 0))
        string(APPEND failures "  picture ${name}\n")
      endif()
    elseif(NOT DEFINED folder_${kind} OR NOT EXISTS ${root}/${folder_${kind}}/${name}.cpp)
      string(APPEND failures "  ${kind} ${name}\n")
    endif()
  endforeach()
endforeach()

if(failures)
  message(FATAL_ERROR "doc/manual/papers.txt has errors:\n${failures}")
endif()
