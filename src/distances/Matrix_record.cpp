// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Matrix_record.h"

#include <cinttypes>
#include <cstdio>
#include <sstream>

#include <fcntl.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::string_view record_title = "geodesic_distance_matrix";
constexpr std::size_t checksum_width = 8; // hexadecimal digits

// The hash of Fowler, Noll and Vo (FNV-1a).
std::uint32_t checksum(std::string_view text, std::uint32_t seed)
{
  std::uint32_t result = 0x811c9dc5u ^ seed;
  for(const char c : text)
    result = (result ^ static_cast<unsigned char>(c)) * 0x01000193u;
  return result;
}

std::string hexadecimal(std::uint32_t number)
{
  char text[checksum_width + 1];
  std::snprintf(text, sizeof text, "%08" PRIx32, number);
  return text;
}

// Returns the text of a line without its checksum, or an empty text if the checksum is wrong.
std::string verified_text(const std::string& line, std::uint32_t seed)
{
  if(line.size() < checksum_width + 1)
    return {};
  const std::string text = line.substr(0, line.size() - checksum_width - 1);
  return line == text + ' ' + hexadecimal(checksum(text, seed)) ? text : std::string();
}

std::string identity_text(const Matrix_layout& layout, const Matrix_key& key,
                          std::size_t rows_per_tile)
{
  char keys[80];
  std::snprintf(keys, sizeof keys, " surface %016" PRIx64 " arguments %016" PRIx64, key.surface,
                key.arguments);
  return std::string(record_title) + " rows " + std::to_string(layout.first_row) + ':' +
         std::to_string(layout.first_row + layout.rows) + " of " +
         std::to_string(layout.total_rows) + " columns " + std::to_string(layout.columns) +
         " bits " + (layout.format == Number_format::float32 ? "32" : "64") + keys + " tile " +
         std::to_string(rows_per_tile);
}

} // namespace

Matrix_record::Matrix_record(const std::string& path) : m_path(path)
{
  do
  {
    m_file = std::make_unique<File_descriptor>(path, O_CREAT);
    if(!m_file->lock())
      throw_file_error(path, "another process is writing this matrix");
    // The process that held the lock before may have removed the record.
  } while(!m_file->has_name());
}

bool Matrix_record::read(const Matrix_layout& layout, const Matrix_key& key, Recorded_tiles& tiles)
{
  const std::string content = m_file->read(m_file->size(), 0);
  // The first line of an interrupted write has no end.
  if(content.find('\n') == std::string::npos &&
     content.compare(0, record_title.size(), record_title.substr(0, content.size())) == 0)
    return false;

  std::istringstream lines(content);
  std::string line;
  std::getline(lines, line);
  const std::string text = verified_text(line, 0);
  const std::size_t tile_position = text.rfind(' ') + 1;
  if(text.compare(0, record_title.size(), record_title) != 0 ||
     std::sscanf(text.c_str() + tile_position, "%zu", &tiles.rows_per_tile) != 1 ||
     tiles.rows_per_tile == 0)
    throw_file_error(m_path, "it is not a record of finished tiles. Remove it to begin anew");
  if(text != identity_text(layout, key, tiles.rows_per_tile))
  {
    char surface[32];
    std::snprintf(surface, sizeof surface, " surface %016" PRIx64, key.surface);
    throw_file_error(m_path, std::string("it belongs to ") +
                                 (text.find(surface) == std::string::npos
                                      ? "the distances of another surface"
                                      : "other rows, columns, numbers or arguments") +
                                 ". Remove it to begin anew");
  }

  m_checksum = checksum(text, 0);
  tiles.is_finished.assign((layout.rows + tiles.rows_per_tile - 1) / tiles.rows_per_tile, false);
  while(std::getline(lines, line))
  {
    std::size_t tile = 0;
    if(std::sscanf(verified_text(line, m_checksum).c_str(), "%zu", &tile) == 1 &&
       tile < tiles.is_finished.size())
      tiles.is_finished[tile] = true;
  }
  m_size = content.rfind('\n') + 1;
  return true;
}

void Matrix_record::begin(const Matrix_layout& layout, const Matrix_key& key,
                          std::size_t rows_per_tile)
{
  m_file->resize(0);
  m_size = 0;
  const std::string text = identity_text(layout, key, rows_per_tile);
  m_checksum = 0;
  append(text);
  m_checksum = checksum(text, 0);
}

void Matrix_record::add(std::size_t tile) { append(std::to_string(tile)); }

void Matrix_record::append(const std::string& text)
{
  const std::string line = text + ' ' + hexadecimal(checksum(text, m_checksum)) + '\n';
  m_file->write(line.data(), line.size(), m_size);
  m_file->synchronize();
  m_size += line.size();
}

void Matrix_record::remove() { remove_file(m_path); }

} // namespace CGAL::Geodesic_processing::internal
