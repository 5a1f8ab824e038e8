// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_RECORD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_RECORD_H

#include <CGAL/Geodesic_processing/internal/distances/Matrix_file.h>

#include "distances/File_descriptor.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The tiles of a matrix that are finished.
struct Recorded_tiles
{
  std::size_t rows_per_tile = 0;
  std::vector<bool> is_finished; // #tiles
};

// A text file that records the finished tiles of a matrix, so that its computation can be
// continued. The first line identifies the matrix, and each other line a tile. A line ends with a
// checksum of its text and of the first line. A line whose checksum is wrong, from an interrupted
// write, is ignored.
//
// The file is locked as long as the object exists: only one process writes a matrix. All functions
// throw File_error.
class CGAL_GEODESIC_PROCESSING_EXPORT Matrix_record
{
public:
  // Opens the record, or creates an empty one. Throws File_error if it is locked.
  explicit Matrix_record(const std::string& path);

  // Reads the tiles. Returns false if the record is empty or its first line was not written
  // completely. Throws File_error if it is the record of another matrix, or no record.
  bool read(const Matrix_layout& layout, const Matrix_key& key, Recorded_tiles& tiles);
  // Replaces the content by a record without tiles.
  void begin(const Matrix_layout& layout, const Matrix_key& key, std::size_t rows_per_tile);
  // Records a tile after read() or begin(), and waits until that is on the disk.
  void add(std::size_t tile);
  void remove();

private:
  void append(const std::string& text);

  std::string m_path;
  std::unique_ptr<File_descriptor> m_file;
  std::size_t m_size = 0;       // of the lines that were written completely
  std::uint32_t m_checksum = 0; // of the first line
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_RECORD_H
