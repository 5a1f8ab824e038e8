# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
include_guard(GLOBAL)

# Parsing the headers of meshes takes most of the compile time of a short program, so programs use
# a precompiled header.  Each source nevertheless includes all headers that it uses, so that it
# compiles with CMAKE_DISABLE_PRECOMPILE_HEADERS.
add_library(client_instances STATIC EXCLUDE_FROM_ALL
            ${CMAKE_CURRENT_LIST_DIR}/client_instances.cpp)
target_link_libraries(client_instances PRIVATE Geodesic_processing)
target_compile_options(client_instances PRIVATE ${GEODESIC_PROCESSING_CLIENT_OPTIONS})
target_precompile_headers(client_instances PRIVATE ${CMAKE_CURRENT_LIST_DIR}/client_headers.h)

# Adds a program, which is compiled like the code of a user of the library.
function(add_client name sources)
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE client_instances Geodesic_processing)
  target_compile_options(${name} PRIVATE ${GEODESIC_PROCESSING_CLIENT_OPTIONS})
  target_precompile_headers(${name} REUSE_FROM client_instances)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()

# add_joined_clients(NAME SOURCE...) adds one program for many sources that have a function main.
# `NAME STEM ARGUMENT...` calls the function of STEM.cpp.  Eight sources are compiled together, each
# in a namespace of its own.  They share the instances of templates, so this takes a third of the
# time.
function(add_joined_clients name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
  set(sources ${ARGN})
  set(declarations "")
  set(calls "")
  set(units "")
  while(sources)
    list(LENGTH units number)
    list(SUBLIST sources 0 8 batch)
    list(REMOVE_ITEM sources ${batch})
    set(includes "")
    set(code "")
    foreach(source IN LISTS batch)
      cmake_path(GET source STEM stem)
      # Headers are included before the namespaces: their include guards then skip them inside.
      file(STRINGS ${source} lines REGEX "^#include")
      list(APPEND includes ${lines})
      set(main "int main()")
      set(arguments "")
      file(STRINGS ${source} has_arguments REGEX "^int main\\(int")
      if(has_arguments)
        set(main "int main(int, char*[])")
        set(arguments "argc - 1, argv + 1")
      endif()
      string(APPEND code "namespace ${stem} {\n#include \"${source}\"\n}\n")
      string(APPEND declarations "namespace ${stem} { ${main}; }\n")
      string(APPEND calls "  if(name == \"${stem}\")\n    return ${stem}::main(${arguments});\n")
    endforeach()
    list(REMOVE_DUPLICATES includes)
    list(JOIN includes "\n" includes)
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/${name}_${number}.cpp)
    file(CONFIGURE OUTPUT ${unit} CONTENT "${includes}\n${code}" @ONLY)
    list(APPEND units ${unit})
  endwhile()
  set(main ${CMAKE_CURRENT_BINARY_DIR}/${name}_main.cpp)
  file(CONFIGURE OUTPUT ${main} @ONLY CONTENT
"#include <string_view>\n\n${declarations}
int main(int argc, char* argv[])
{
  const std::string_view name = argc > 1 ? argv[1] : \"\";
${calls}  return 1;
}
")
  set_source_files_properties(${main} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  add_client(${name} "${units};${main}")
endfunction()
