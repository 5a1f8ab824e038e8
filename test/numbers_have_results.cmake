# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if a number of the manual has no source, or if a table of the manual cannot be generated from
# the data files of doc/results.  numbers_have_results.py describes what counts as a source.  Does
# nothing without Python.
cmake_minimum_required(VERSION 3.24)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
find_program(PYTHON python3)
if(NOT PYTHON)
  message(STATUS "No check of numbers: there is no python3.")
  return()
endif()

execute_process(COMMAND ${PYTHON} -B ${root}/test/numbers_have_results.py
                RESULT_VARIABLE status OUTPUT_VARIABLE failures ERROR_VARIABLE failures)
if(status)
  message(FATAL_ERROR "Numbers of the manual without a source:\n${failures}")
endif()
