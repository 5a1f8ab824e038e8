# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Adds the library of the readers, which the program and the Python module use.
find_package(nlohmann_json REQUIRED)
find_package(ZLIB REQUIRED)
find_path(LZ4_INCLUDE_DIR lz4.h)
find_library(LZ4_LIBRARY lz4)
mark_as_advanced(LZ4_INCLUDE_DIR LZ4_LIBRARY)

# The readers are a library that other programs can use.  They include no other folder and no header
# of CGAL, Boost, Eigen, VTK or CLI11: check_folder_order.cmake lists the headers that they may use.
collect_files(reader_sources ${PROJECT_SOURCE_DIR}/src/geodesic/readers/*.cpp)
add_library(geodesic_readers STATIC ${reader_sources})
target_compile_features(geodesic_readers PUBLIC cxx_std_17)
target_include_directories(geodesic_readers PUBLIC ${PROJECT_SOURCE_DIR}/src/geodesic)
target_link_libraries(geodesic_readers PRIVATE nlohmann_json::nlohmann_json ZLIB::ZLIB)
if(LZ4_INCLUDE_DIR AND LZ4_LIBRARY)
  target_compile_definitions(geodesic_readers PRIVATE GEODESIC_PROCESSING_HAS_LZ4)
  target_include_directories(geodesic_readers SYSTEM PRIVATE ${LZ4_INCLUDE_DIR})
  target_link_libraries(geodesic_readers PRIVATE ${LZ4_LIBRARY})
endif()
set_target_properties(geodesic_readers PROPERTIES POSITION_INDEPENDENT_CODE ON)
group_by_folder(geodesic_readers)
