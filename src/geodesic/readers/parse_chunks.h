// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_PARSE_CHUNKS_H
#define GEODESIC_PROGRAM_READERS_PARSE_CHUNKS_H

#include "readers/count_lines.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace program {

// Returns the number of chunks that a file is divided into. A chunk has at least 2^20 bytes.
inline std::size_t number_of_chunks(std::size_t size, unsigned number_of_threads)
{
  return std::min<std::size_t>(number_of_threads, size >> 20);
}

// Splits a text behind line feeds into chunks of similar size.
inline std::vector<std::string_view> split_lines(std::string_view text, std::size_t count)
{
  std::vector<std::string_view> chunks;
  for(; count > 1; --count)
  {
    const std::size_t end = text.find('\n', text.size() / count);
    if(end == std::string_view::npos)
      break;
    chunks.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  chunks.push_back(text);
  return chunks;
}

// Calls parse(i) for all i < count, in parallel. Returns whether all calls return true. Exceptions
// count as false: the caller then parses the whole file, which reports the first error.
template <typename Parse>
bool parse_chunks(std::size_t count, Parse parse)
{
  std::vector<char> is_parsed(count, 0);
  const auto call = [&](std::size_t i) noexcept
  {
    try
    {
      is_parsed[i] = parse(i) ? 1 : 0;
    }
    catch(...)
    {}
  };
  std::vector<std::thread> threads;
  threads.reserve(count);
  for(std::size_t i = 1; i < count; ++i)
    try
    {
      threads.emplace_back(call, i);
    }
    catch(const std::system_error&) // There are too many threads.
    {
      call(i);
    }
  call(0);
  for(std::thread& thread : threads)
    thread.join();
  return std::all_of(is_parsed.begin(), is_parsed.end(), [](char c) { return c != 0; });
}

// Returns the number of lines before each chunk, and of all lines.
inline std::vector<std::size_t> first_lines(const std::vector<std::string_view>& chunks)
{
  std::vector<std::size_t> result(chunks.size() + 1, 0);
  parse_chunks(chunks.size(),
               [&](std::size_t i)
               {
                 result[i + 1] = number_of_lines(chunks[i]);
                 return true;
               });
  std::partial_sum(result.begin(), result.end(), result.begin());
  return result;
}

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_PARSE_CHUNKS_H
