// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_PARSE_CHUNKS_H
#define GEODESIC_PROGRAM_READERS_PARSE_CHUNKS_H

#include "readers/count_lines.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace program {

// Returns the number of chunks that a file is divided into. A chunk has at least 2^20 bytes. There are
// more chunks than threads, because some kinds of lines take longer than others.
inline std::size_t number_of_chunks(std::size_t size, unsigned number_of_threads)
{
  constexpr std::size_t chunks_per_thread = 4;
  return number_of_threads < 2
             ? 1
             : std::min<std::size_t>(chunks_per_thread * number_of_threads, size >> 20);
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

// Calls parse(i) for all i < count, in several threads. Returns whether all calls return true.
// Exceptions count as false: the caller then parses the whole file, which reports the first error.
template <typename Parse>
bool parse_chunks(std::size_t count, unsigned number_of_threads, Parse parse)
{
  std::atomic<std::size_t> next{0};
  std::atomic<bool> is_parsed{true};
  const auto parse_next = [&]() noexcept
  {
    for(std::size_t i; (i = next++) < count;)
      try
      {
        if(!parse(i))
          is_parsed = false;
      }
      catch(...)
      {
        is_parsed = false;
      }
  };
  std::vector<std::thread> threads;
  threads.reserve(number_of_threads);
  try
  {
    while(threads.size() + 1 < std::min<std::size_t>(number_of_threads, count))
      threads.emplace_back(parse_next);
  }
  catch(const std::system_error&) // There are too many threads. The others parse all chunks.
  {}
  parse_next();
  for(std::thread& thread : threads)
    thread.join();
  return is_parsed;
}

// Returns the number of lines before each chunk, and of all lines.
inline std::vector<std::size_t> first_lines(const std::vector<std::string_view>& chunks,
                                            unsigned number_of_threads)
{
  std::vector<std::size_t> result(chunks.size() + 1, 0);
  parse_chunks(chunks.size(), number_of_threads,
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
