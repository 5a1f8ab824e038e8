// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_FILE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_FILE_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The numbers of a matrix in a file.
enum class Number_format
{
  float32,
  float64
};

struct Matrix_layout
{
  std::size_t rows = 0, columns = 0;
  Number_format format = Number_format::float64;

  std::size_t row_size() const // bytes
  {
    return columns * (format == Number_format::float32 ? sizeof(float) : sizeof(double));
  }
};

// A matrix in a file of the format .npy of NumPy, version 1.0, in row-major order. It is written in
// tiles: groups of consecutive rows.
//
// A text file beside it, with .tiles appended to the name, records the finished tiles. Its first
// line has the key of the computation and the rows per tile, and each other line a tile. A tile is
// recorded after the matrix was synchronized with the disk, so that an interrupted computation can
// be continued. A line without an end, from an interrupted write, is ignored. The record is removed
// when the matrix is complete.
class CGAL_GEODESIC_PROCESSING_EXPORT Matrix_file
{
public:
  // Creates the file in its final size, or opens it if its record has the same key. The tiles are
  // then those of the record. `key` identifies everything on which the matrix depends.
  //
  // tile_size: bytes; a tile has at least one row
  //
  // Throws File_error if the record has another key, if the disk has too little space, or if a file
  // cannot be written.
  Matrix_file(const std::string& path, const Matrix_layout& layout, std::size_t tile_size,
              std::uint64_t key);
  ~Matrix_file();
  Matrix_file(const Matrix_file&) = delete;
  Matrix_file& operator=(const Matrix_file&) = delete;

  const Matrix_layout& layout() const { return m_layout; }
  std::size_t number_of_tiles() const { return m_is_finished.size(); }
  bool is_finished(std::size_t tile) const { return m_is_finished[tile]; }
  std::size_t first_row(std::size_t tile) const { return tile * m_rows_per_tile; }
  std::size_t end_row(std::size_t tile) const;

  // Writes the rows of a tile, synchronizes, and records the tile. Throws File_error.
  void write(std::size_t tile, const std::vector<char>& rows);

  // Removes the record. All tiles must be finished. Throws File_error.
  void finish();

private:
  void create(std::uint64_t key);
  // Reads the record. Returns false if there is none.
  bool read_record(std::uint64_t key);

  std::string m_path;
  Matrix_layout m_layout;
  std::size_t m_rows_per_tile;
  std::vector<bool> m_is_finished; // #tiles
  std::size_t m_header_size = 0;
  int m_file = -1, m_record = -1; // POSIX file descriptors
};

// Writes the rows of several .npy files, in the order of the files, to one file. Reads one block at
// a time. Throws File_error if a file cannot be read or written, if it is no matrix of this
// package, if it is not complete, or if the files differ in columns or format.
CGAL_GEODESIC_PROCESSING_EXPORT
void merge_matrix_files(const std::vector<std::string>& paths, const std::string& merged);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_FILE_H
