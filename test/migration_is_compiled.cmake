# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if the example migration.cpp does not contain a call in C++ that the tables of the page
# "Migration" recommend.  test/python/migration_test.py runs the other rows.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
file(READ ${root}/doc/examples/migration.cpp example)
string(REGEX REPLACE "[ \n]+" " " example "${example}")
file(READ ${root}/doc/manual/migration.txt page)
string(REGEX REPLACE "\\\\section GP_Migration_potpourri3d.*" "" page "${page}")
# A semicolon would split the list of rows.
string(REPLACE ";" ":" page "${page}")
string(REGEX MATCHALL "\n\\|[^\n]*\\|" rows "${page}")

set(number 0)
set(failures "")
foreach(row IN LISTS rows)
  string(REGEX MATCH "[^|]*\\|$" cell "${row}")
  string(REGEX MATCHALL "`[^`]+`" calls "${cell}")
  foreach(call IN LISTS calls)
    string(REPLACE "`" "" call "${call}")
    string(FIND "${example}" "${call}" position)
    math(EXPR number "${number} + 1")
    if(position LESS 0)
      string(APPEND failures "  ${call}\n")
    endif()
  endforeach()
endforeach()

# The page has more rows than this.
if(number LESS 40)
  message(FATAL_ERROR "Only ${number} calls were found in doc/manual/migration.txt.")
endif()
if(failures)
  message(FATAL_ERROR "doc/examples/migration.cpp does not contain these calls:\n${failures}")
endif()
