// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_FILE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_FILE_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The numbers of a matrix in a file.
enum class Number_format
{
  float32,
  float64
};

// A matrix in a file, or a part of one: consecutive rows of a larger matrix.
struct Matrix_layout
{
  std::size_t rows = 0, columns = 0; // of the file
  Number_format format = Number_format::float64;
  std::size_t first_row = 0;  // in the whole matrix
  std::size_t total_rows = 0; // of the whole matrix

  std::size_t row_size() const // bytes
  {
    return columns * (format == Number_format::float32 ? sizeof(float) : sizeof(double));
  }
  bool is_part() const { return rows < total_rows; }
};

// Hashes of everything on which the entries of the whole matrix depend.
struct Matrix_key
{
  std::uint64_t surface = 0;
  std::uint64_t arguments = 0; // sources, targets, method, ...
};

class File_descriptor;
class Matrix_record;

// A matrix in a file of the format .npy of NumPy, version 1.0, in row-major order. It is written in
// tiles: groups of consecutive rows.
//
// While it is written, the file has .unfinished appended to its name. Thus a file with the name
// itself is complete. A Matrix_record in a text file with .tiles appended records the finished
// tiles. A tile is recorded after the matrix was synchronized with the disk, so that an interrupted
// computation can be continued. The record is removed at the end.
//
// The header of a part has a comment with its rows and its key, which readers of Python ignore.
class CGAL_GEODESIC_PROCESSING_EXPORT Matrix_file
{
public:
  // A tile has at most this number of rows, so that narrow matrices are recorded often, too.
  static constexpr std::size_t max_rows_per_tile = 1024;

  // Creates the unfinished file in its final size, or opens it if there is a record. The tiles are
  // then those of the record.
  //
  // tile_size: bytes; a tile has at least one row
  //
  // Throws File_error if the record belongs to another matrix, if another process is writing the
  // matrix, if the disk has too little space, or if a file cannot be written. Files that the
  // constructor has created are then removed.
  Matrix_file(const std::string& path, const Matrix_layout& layout, std::size_t tile_size,
              const Matrix_key& key);
  ~Matrix_file();
  Matrix_file(const Matrix_file&) = delete;
  Matrix_file& operator=(const Matrix_file&) = delete;

  const Matrix_layout& layout() const { return m_layout; }
  std::size_t number_of_tiles() const { return m_is_finished.size(); }
  bool is_finished(std::size_t tile) const { return m_is_finished[tile]; }
  std::size_t first_row(std::size_t tile) const { return tile * m_rows_per_tile; }
  std::size_t end_row(std::size_t tile) const;
  std::size_t tile_size() const { return m_rows_per_tile * m_layout.row_size(); } // bytes

  // Writes the rows of a tile, synchronizes, and records the tile. Throws File_error.
  void write(std::size_t tile, const std::vector<char>& rows);

  // Renames the file, replaces an existing one, and removes the record. All tiles must be finished.
  // Throws File_error.
  void finish();

  // Removes the unfinished file and its record. Throws File_error.
  void discard();

private:
  void create(const std::string& header, std::size_t tile_size, const Matrix_key& key);
  // Opens the file of the record.
  void open(std::size_t size);

  std::string m_path;
  Matrix_layout m_layout;
  std::size_t m_rows_per_tile = 1;
  std::vector<bool> m_is_finished; // #tiles
  std::size_t m_header_size = 0;
  std::unique_ptr<Matrix_record> m_record;
  std::unique_ptr<File_descriptor> m_file; // null if it was renamed
};

// Writes the rows of the parts of a matrix to one file. The parts may be in any order. Reads one
// block at a time. Throws File_error if a file cannot be read or written, if it is no matrix of
// this package or not complete, if the files are no parts of the same matrix, and if rows are
// missing or in two parts.
CGAL_GEODESIC_PROCESSING_EXPORT
void merge_matrix_files(const std::vector<std::string>& paths, const std::string& merged);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_MATRIX_FILE_H
