// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Matrix_file.h>

#include "distances/File_descriptor.h"
#include "distances/Matrix_record.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fcntl.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr char magic[] = "\x93NUMPY\x01"; // and a zero: version 1.0
constexpr std::size_t magic_size = 8, length_size = 2, header_alignment = 64;
constexpr std::string_view unfinished_suffix = ".unfinished", record_suffix = ".tiles";

std::string with_suffix(const std::string& path, std::string_view suffix)
{
  return path + std::string(suffix);
}

bool is_little_endian()
{
  const std::uint16_t one = 1;
  unsigned char first_byte = 0;
  std::memcpy(&first_byte, &one, 1);
  return first_byte == 1;
}

std::string number_name(Number_format format)
{
  return std::string(is_little_endian() ? "<" : ">") +
         (format == Number_format::float32 ? "f4" : "f8");
}

// Returns a range of rows as a sentence names it.
std::string rows_text(std::size_t begin, std::size_t end)
{
  return std::to_string(begin) + ':' + std::to_string(end);
}

// Returns the header of a .npy file, whose size is a multiple of 64 bytes.
std::string header_of(const Matrix_layout& layout, const Matrix_key& key)
{
  std::string text = "{'descr': '" + number_name(layout.format) +
                     "', 'fortran_order': False, 'shape': (" + std::to_string(layout.rows) + ", " +
                     std::to_string(layout.columns) + "), }";
  if(layout.is_part())
  {
    char keys[80];
    std::snprintf(keys, sizeof keys, ", surface %016" PRIx64 ", arguments %016" PRIx64, key.surface,
                  key.arguments);
    text += " # from row " + std::to_string(layout.first_row) + " of " +
            std::to_string(layout.total_rows) + keys;
  }
  const std::size_t unpadded_size = magic_size + length_size + text.size() + 1;
  text.append((header_alignment - unpadded_size % header_alignment) % header_alignment, ' ');
  text += '\n';
  std::string result(magic, magic_size);
  result += static_cast<char>(text.size() % 256);
  result += static_cast<char>(text.size() / 256);
  return result + text;
}

struct Matrix_header
{
  Matrix_layout layout;
  Matrix_key key; // zero if the file has all rows
  std::size_t size = 0;
};

// Reads a header as this package writes it.
Matrix_header read_header(std::ifstream& file, const std::string& path)
{
  std::string begin(magic_size + length_size, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if(!file || begin.compare(0, magic_size, std::string(magic, magic_size)) != 0)
    throw_file_error(path, "it is not a .npy file of version 1.0");
  const std::size_t length = static_cast<unsigned char>(begin[magic_size]) +
                             256 * std::size_t{static_cast<unsigned char>(begin[magic_size + 1])};
  std::string text(length, '\0');
  file.read(text.data(), static_cast<std::streamsize>(length));
  char descr[4] = "";
  Matrix_header result;
  Matrix_layout& layout = result.layout;
  const int count =
      std::sscanf(text.c_str(),
                  "{'descr': '%3s', 'fortran_order': False, 'shape': (%zu, %zu), } # from row %zu "
                  "of %zu, surface %" SCNx64 ", arguments %" SCNx64,
                  descr, &layout.rows, &layout.columns, &layout.first_row, &layout.total_rows,
                  &result.key.surface, &result.key.arguments);
  if(!file || (count != 3 && count != 7))
    throw_file_error(path, "its header is not that of a matrix of this package");
  if(count == 3)
    layout.total_rows = layout.rows;
  layout.format = descr == number_name(Number_format::float32) ? Number_format::float32
                                                               : Number_format::float64;
  if(descr != number_name(layout.format))
    throw_file_error(path, "its numbers are not floating-point numbers of this machine");
  result.size = begin.size() + length;
  return result;
}

// Throws if finishing a file of this name would fail after a long computation.
void check_name(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if(std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw_file_error(path, "it exists and is not a regular file");
}

// Creates the unfinished file of a matrix with a header and space for the rows. A file of this name
// that is no matrix is not replaced.
std::unique_ptr<File_descriptor> create_unfinished(const std::string& path,
                                                   const std::string& header, std::size_t size)
{
  const std::string name = with_suffix(path, unfinished_suffix);
  std::unique_ptr<File_descriptor> file = std::make_unique<File_descriptor>(name, O_CREAT);
  const std::string begin = file->read(magic_size, 0);
  if(!begin.empty() && begin != std::string(magic, magic_size))
    throw_file_error(name, "it exists and is not a .npy file");
  try
  {
    file->resize(0); // frees its space
    // If the process ends while the space is reserved, the header shows that the file is a matrix.
    file->write(header.data(), header.size(), 0);
    file->reserve(size);
    file->synchronize();
  }
  catch(...)
  {
    remove_file(name);
    throw;
  }
  return file;
}

// Returns the file to which symbolic links lead, even if it does not exist, so that renaming a file
// keeps the links.
std::string resolve_links(const std::string& path)
{
  constexpr int max_number_of_links = 40; // as Linux
  std::filesystem::path result = path;
  std::error_code error;
  for(int i = 0; i < max_number_of_links && std::filesystem::is_symlink(result, error); ++i)
    result = result.parent_path() / std::filesystem::read_symlink(result, error);
  return result.string();
}

} // namespace

Matrix_file::Matrix_file(const std::string& path, const Matrix_layout& layout,
                         std::size_t tile_size, const Matrix_key& key)
    : m_path(resolve_links(path)), m_layout(layout)
{
  check_name(m_path);
  const std::string header = header_of(layout, key);
  m_header_size = header.size();
  m_record = std::make_unique<Matrix_record>(with_suffix(m_path, record_suffix));
  Recorded_tiles tiles;
  if(m_record->read(layout, key, tiles))
  {
    m_rows_per_tile = tiles.rows_per_tile;
    m_is_finished = std::move(tiles.is_finished);
    open(header.size() + layout.rows * layout.row_size());
  }
  else
    create(header, tile_size, key);
}

Matrix_file::~Matrix_file() = default;

std::size_t Matrix_file::end_row(std::size_t tile) const
{
  return std::min(m_layout.rows, first_row(tile) + m_rows_per_tile);
}

void Matrix_file::create(const std::string& header, std::size_t tile_size, const Matrix_key& key)
{
  const std::size_t row_size = std::max<std::size_t>(1, m_layout.row_size());
  m_rows_per_tile = std::clamp<std::size_t>(tile_size / row_size, 1, max_rows_per_tile);
  m_is_finished.assign((m_layout.rows + m_rows_per_tile - 1) / m_rows_per_tile, false);
  try
  {
    m_file = create_unfinished(m_path, header, header.size() + m_layout.rows * m_layout.row_size());
    m_record->begin(m_layout, key, m_rows_per_tile);
  }
  catch(...)
  {
    if(m_file)
      remove_file(m_file->path());
    m_record->remove();
    throw;
  }
}

void Matrix_file::open(std::size_t size)
{
  const std::string name = with_suffix(m_path, unfinished_suffix);
  const auto has_size = [size](const std::string& file)
  {
    std::error_code error;
    return std::filesystem::file_size(file, error) == size && !error;
  };
  // The computation was interrupted after the file was renamed.
  std::error_code error;
  if(!std::filesystem::exists(name, error) && has_size(m_path) &&
     std::find(m_is_finished.begin(), m_is_finished.end(), false) == m_is_finished.end())
    return;
  if(!has_size(name))
    throw_file_error(name, "its size is not that of its record. Remove " +
                               with_suffix(m_path, record_suffix) + " to begin anew");
  m_file = std::make_unique<File_descriptor>(name);
}

void Matrix_file::write(std::size_t tile, const std::vector<char>& rows)
{
  m_file->write(rows.data(), rows.size(), m_header_size + first_row(tile) * m_layout.row_size());
  m_file->synchronize();
  m_record->add(tile);
  m_is_finished[tile] = true;
}

void Matrix_file::finish()
{
  if(m_file)
    rename_file(m_file->path(), m_path);
  m_file.reset();
  m_record->remove();
}

void Matrix_file::discard()
{
  if(m_file)
    remove_file(m_file->path());
  m_file.reset();
  m_record->remove();
}

namespace {

struct Matrix_part
{
  std::string path;
  Matrix_header header;

  std::size_t first_row() const { return header.layout.first_row; }
  std::size_t end_row() const { return header.layout.first_row + header.layout.rows; }
};

Matrix_part read_part(const std::string& path)
{
  std::error_code error;
  const bool has_unfinished_name = path.size() >= unfinished_suffix.size() &&
                                   path.compare(path.size() - unfinished_suffix.size(),
                                                std::string::npos, unfinished_suffix) == 0;
  if(has_unfinished_name || (!std::filesystem::exists(path, error) &&
                             std::filesystem::exists(with_suffix(path, unfinished_suffix), error)))
    throw_file_error(path, "it is not complete");
  std::ifstream file(path, std::ios::binary);
  if(!file)
    throw_file_error(path, "it cannot be opened for reading");
  const Matrix_header header = read_header(file, path);
  const Matrix_layout& layout = header.layout;
  if(std::filesystem::file_size(path, error) != header.size + layout.rows * layout.row_size())
    throw_file_error(path, "its size is not that of its header");
  return {path, header};
}

// Throws if two files are not parts of the same matrix.
void check_same_matrix(const Matrix_part& part, const Matrix_part& first)
{
  const Matrix_layout &a = part.header.layout, &b = first.header.layout;
  if(!a.is_part() || !b.is_part())
    throw_file_error((a.is_part() ? first : part).path, "it has all rows and is not a part");
  if(a.columns != b.columns || a.format != b.format)
    throw_file_error(part.path, "it has other columns or numbers than " + first.path);
  if(part.header.key.surface != first.header.key.surface)
    throw_file_error(part.path, "it belongs to another surface than " + first.path);
  if(a.total_rows != b.total_rows || part.header.key.arguments != first.header.key.arguments)
    throw_file_error(part.path, "it belongs to other arguments than " + first.path);
}

// Throws if parts in the order of their rows do not have each row exactly once.
void check_rows(const std::vector<Matrix_part>& parts, const std::string& merged)
{
  const auto check_gap = [&](std::size_t begin, std::size_t end)
  {
    if(begin < end)
      throw_file_error(merged, "the rows " + rows_text(begin, end) + " are in no part");
  };
  const Matrix_part* last = nullptr; // the part with the previous row
  for(const Matrix_part& part : parts)
  {
    const std::size_t end = last ? last->end_row() : 0;
    if(part.first_row() < end && part.first_row() < part.end_row())
      throw_file_error(merged, "the rows " +
                                   rows_text(part.first_row(), std::min(end, part.end_row())) +
                                   " are both in " + last->path + " and in " + part.path);
    check_gap(end, part.first_row());
    if(!last || part.end_row() > end)
      last = &part;
  }
  check_gap(last->end_row(), parts[0].header.layout.total_rows);
}

// Reads the rows of a part that are in a range of rows of the whole matrix. `rows` begins with the
// row `begin`.
void read_rows(const Matrix_part& part, std::size_t begin, std::size_t end, std::vector<char>& rows)
{
  const std::size_t first = std::max(begin, part.first_row()), last = std::min(end, part.end_row()),
                    row_size = part.header.layout.row_size();
  if(first >= last)
    return;
  std::ifstream file(part.path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(part.header.size + (first - part.first_row()) * row_size));
  if(!file.read(rows.data() + (first - begin) * row_size,
                static_cast<std::streamsize>((last - first) * row_size)))
    throw_file_error(part.path, "it cannot be read");
}

} // namespace

void merge_matrix_files(const std::vector<std::string>& paths, const std::string& merged)
{
  const std::string output = resolve_links(merged);
  if(paths.empty())
    throw_file_error(output, "there are no parts");
  check_name(output);
  std::vector<Matrix_part> parts;
  for(const std::string& path : paths)
  {
    std::error_code error;
    if(std::filesystem::equivalent(path, output, error))
      throw_file_error(output, "it is one of the parts");
    parts.push_back(read_part(path));
    if(parts.size() > 1)
      check_same_matrix(parts.back(), parts[0]);
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Matrix_part& a, const Matrix_part& b)
                   { return a.first_row() < b.first_row(); });
  check_rows(parts, output);

  Matrix_layout layout = parts[0].header.layout;
  layout.first_row = 0;
  layout.rows = layout.total_rows;
  constexpr std::size_t tile_size = std::size_t{1} << 26;
  Matrix_file file(output, layout, tile_size, parts[0].header.key);
  std::vector<char> rows;
  for(std::size_t tile = 0; tile < file.number_of_tiles(); ++tile)
    if(!file.is_finished(tile))
    {
      const std::size_t begin = file.first_row(tile), end = file.end_row(tile);
      rows.resize((end - begin) * layout.row_size());
      for(const Matrix_part& part : parts)
        read_rows(part, begin, end, rows);
      file.write(tile, rows);
    }
  file.finish();
}

} // namespace CGAL::Geodesic_processing::internal
