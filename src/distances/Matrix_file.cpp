// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Matrix_file.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr char magic[] = "\x93NUMPY\x01"; // and a zero: version 1.0
constexpr std::size_t magic_size = 8, length_size = 2, header_alignment = 64;

[[noreturn]] void fail(const std::string& path, const std::string& reason)
{
  throw File_error(path + ": " + reason + ".");
}

[[noreturn]] void fail_by_system(const std::string& path, const std::string& what)
{
  fail(path, what + " (" + std::generic_category().message(errno) + ")");
}

std::string record_path(const std::string& path) { return path + ".tiles"; }

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

// Returns the header of a .npy file, whose size is a multiple of 64 bytes.
std::string header_of(const Matrix_layout& layout)
{
  std::string text = "{'descr': '" + number_name(layout.format) +
                     "', 'fortran_order': False, 'shape': (" + std::to_string(layout.rows) + ", " +
                     std::to_string(layout.columns) + "), }";
  const std::size_t unpadded_size = magic_size + length_size + text.size() + 1;
  text.append((header_alignment - unpadded_size % header_alignment) % header_alignment, ' ');
  text += '\n';
  std::string result(magic, magic_size);
  result += static_cast<char>(text.size() % 256);
  result += static_cast<char>(text.size() / 256);
  return result + text;
}

// Reads a header as this package writes it. Returns its size.
std::size_t read_header(std::ifstream& file, const std::string& path, Matrix_layout& layout)
{
  std::string begin(magic_size + length_size, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if(!file || begin.compare(0, magic_size, std::string(magic, magic_size)) != 0)
    fail(path, "it is not a .npy file of version 1.0");
  const std::size_t length = static_cast<unsigned char>(begin[magic_size]) +
                             256 * std::size_t{static_cast<unsigned char>(begin[magic_size + 1])};
  std::string text(length, '\0');
  file.read(text.data(), static_cast<std::streamsize>(length));
  char descr[4] = "";
  std::size_t rows = 0, columns = 0;
  if(!file ||
     std::sscanf(text.c_str(), "{'descr': '%3s', 'fortran_order': False, 'shape': (%zu, %zu), }",
                 descr, &rows, &columns) != 3)
    fail(path, "its header is not that of a matrix of this package");
  layout.rows = rows;
  layout.columns = columns;
  layout.format = descr == number_name(Number_format::float32) ? Number_format::float32
                                                               : Number_format::float64;
  if(descr != number_name(layout.format))
    fail(path, "its numbers are not floating-point numbers of this machine");
  return begin.size() + length;
}

void write_all(int file, const char* bytes, std::size_t size, std::size_t position,
               const std::string& path)
{
  while(size > 0)
  {
    const ssize_t written = ::pwrite(file, bytes, size, static_cast<off_t>(position));
    if(written < 0 && errno == EINTR)
      continue;
    if(written <= 0)
      fail_by_system(path, "it cannot be written");
    bytes += written;
    size -= static_cast<std::size_t>(written);
    position += static_cast<std::size_t>(written);
  }
}

void synchronize(int file, const std::string& path)
{
  if(::fsync(file) != 0)
    fail_by_system(path, "it cannot be synchronized with the disk");
}

int open_file(const std::string& path, int flags)
{
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  if(file < 0)
    fail_by_system(path, "it cannot be opened for writing");
  return file;
}

// Fails with a sentence before a long computation if a file of this size does not fit.
void check_space(const std::string& path, std::size_t size)
{
  std::error_code error;
  std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if(!error && space.available < size)
    fail(path, "it needs " + std::to_string(size) + " bytes, but the disk has only " +
                   std::to_string(space.available));
}

void reserve(int file, std::size_t size, const std::string& path)
{
  if(const int error =
         ::posix_fallocate(file, 0, static_cast<off_t>(std::max<std::size_t>(size, 1)));
     error != 0)
  {
    errno = error;
    fail_by_system(path, "the disk has no space for " + std::to_string(size) + " bytes");
  }
}

} // namespace

Matrix_file::Matrix_file(const std::string& path, const Matrix_layout& layout,
                         std::size_t tile_size, std::uint64_t key)
    : m_path(path), m_layout(layout),
      m_rows_per_tile(
          std::max<std::size_t>(1, tile_size / std::max<std::size_t>(1, layout.row_size())))
{
  m_header_size = header_of(layout).size();
  try
  {
    if(!read_record(key))
      create(key);
  }
  catch(...)
  {
    if(m_file >= 0)
      ::close(m_file);
    if(m_record >= 0)
      ::close(m_record);
    throw;
  }
}

Matrix_file::~Matrix_file()
{
  ::close(m_file);
  if(m_record >= 0)
    ::close(m_record);
}

std::size_t Matrix_file::end_row(std::size_t tile) const
{
  return std::min(m_layout.rows, first_row(tile) + m_rows_per_tile);
}

void Matrix_file::create(std::uint64_t key)
{
  const std::string header = header_of(m_layout);
  const std::size_t size = header.size() + m_layout.rows * m_layout.row_size();
  m_is_finished.assign((m_layout.rows + m_rows_per_tile - 1) / m_rows_per_tile, false);
  std::error_code error;
  if(std::filesystem::is_regular_file(m_path, error))
    std::filesystem::remove(m_path, error); // frees its space
  check_space(m_path, size);
  m_file = open_file(m_path, O_RDWR | O_CREAT | O_TRUNC);
  reserve(m_file, size, m_path);
  write_all(m_file, header.data(), header.size(), 0, m_path);
  synchronize(m_file, m_path);

  char line[80];
  std::snprintf(line, sizeof line, "tiles %016" PRIx64 " %zu\n", key, m_rows_per_tile);
  m_record = open_file(record_path(m_path), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND);
  write_all(m_record, line, std::strlen(line), 0, record_path(m_path));
  synchronize(m_record, record_path(m_path));
}

bool Matrix_file::read_record(std::uint64_t key)
{
  std::ifstream record(record_path(m_path), std::ios::binary);
  if(!record)
    return false;
  std::stringstream content;
  content << record.rdbuf();
  std::string text = content.str();
  text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  std::istringstream lines(text);
  std::string line;
  std::uint64_t recorded_key = 0;
  std::size_t rows_per_tile = 0;
  // Without a complete first line, no tile is finished.
  if(!std::getline(lines, line))
    return false;
  if(std::sscanf(line.c_str(), "tiles %" SCNx64 " %zu", &recorded_key, &rows_per_tile) != 2 ||
     rows_per_tile == 0)
    fail(record_path(m_path), "it is not a record of finished tiles");
  if(recorded_key != key)
    fail(record_path(m_path),
         "it belongs to another computation. Remove it and " + m_path + " to begin anew");
  std::error_code error;
  if(std::filesystem::file_size(m_path, error) !=
         m_header_size + m_layout.rows * m_layout.row_size() ||
     error)
    fail(m_path, "its size is not that of its record. Remove both to begin anew");

  m_rows_per_tile = rows_per_tile;
  m_is_finished.assign((m_layout.rows + m_rows_per_tile - 1) / m_rows_per_tile, false);
  while(std::getline(lines, line))
  {
    std::size_t tile = 0;
    if(std::sscanf(line.c_str(), "%zu", &tile) != 1 || tile >= number_of_tiles())
      fail(record_path(m_path), "'" + line.substr(0, 30) + "' is not a tile");
    m_is_finished[tile] = true;
  }
  m_file = open_file(m_path, O_RDWR);
  m_record = open_file(record_path(m_path), O_WRONLY | O_APPEND);
  // Removes a line without an end, so that the next one begins on a new line.
  if(::ftruncate(m_record, static_cast<off_t>(text.size())) != 0)
    fail_by_system(record_path(m_path), "it cannot be written");
  return true;
}

void Matrix_file::write(std::size_t tile, const std::vector<char>& rows)
{
  write_all(m_file, rows.data(), rows.size(), m_header_size + first_row(tile) * m_layout.row_size(),
            m_path);
  synchronize(m_file, m_path);
  const std::string line = std::to_string(tile) + '\n';
  // The record is opened for appending, for which the position has no effect.
  write_all(m_record, line.data(), line.size(), 0, record_path(m_path));
  synchronize(m_record, record_path(m_path));
  m_is_finished[tile] = true;
}

void Matrix_file::finish()
{
  std::error_code error;
  std::filesystem::remove(record_path(m_path), error);
  if(error)
    fail(record_path(m_path), "it cannot be removed (" + error.message() + ")");
}

void merge_matrix_files(const std::vector<std::string>& paths, const std::string& merged)
{
  Matrix_layout layout;
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    std::error_code error;
    if(std::filesystem::equivalent(paths[i], merged, error))
      fail(merged, "it is one of the files to be merged");
    if(std::filesystem::exists(record_path(paths[i]), error))
      fail(paths[i], "it is not complete, because it has a record of finished tiles");
    std::ifstream file(paths[i], std::ios::binary);
    if(!file)
      fail(paths[i], "it cannot be opened for reading");
    Matrix_layout part;
    const std::size_t header_size = read_header(file, paths[i], part);
    if(std::filesystem::file_size(paths[i], error) != header_size + part.rows * part.row_size())
      fail(paths[i], "its size is not that of its header");
    if(i > 0 && (part.columns != layout.columns || part.format != layout.format))
      fail(paths[i], "it has other columns or numbers than " + paths[0]);
    const std::size_t rows = layout.rows + part.rows;
    layout = part;
    layout.rows = rows;
  }

  const std::string header = header_of(layout);
  check_space(merged, header.size() + layout.rows * layout.row_size());
  const int output = open_file(merged, O_WRONLY | O_CREAT | O_TRUNC);
  try
  {
    write_all(output, header.data(), header.size(), 0, merged);
    std::size_t position = header.size();
    std::vector<char> block(std::size_t{1} << 20);
    for(const std::string& path : paths)
    {
      std::ifstream file(path, std::ios::binary);
      Matrix_layout part;
      read_header(file, path, part);
      for(std::size_t rest = part.rows * part.row_size(); rest > 0;)
      {
        const std::size_t size = std::min(rest, block.size());
        if(!file.read(block.data(), static_cast<std::streamsize>(size)))
          fail(path, "it cannot be read");
        write_all(output, block.data(), size, position, merged);
        position += size;
        rest -= size;
      }
    }
    synchronize(output, merged);
  }
  catch(...)
  {
    ::close(output);
    throw;
  }
  if(::close(output) != 0)
    fail_by_system(merged, "it cannot be written");
}

} // namespace CGAL::Geodesic_processing::internal
