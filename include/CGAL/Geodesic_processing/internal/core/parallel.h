// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PARALLEL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PARALLEL_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Calls body(block, begin, end) for all blocks of a partition of 0..size-1 into blocks of
// `block_size`. The partition does not depend on `number_of_threads`. If each call writes only to
// data of its own block, the result is the same for every number of threads.
//
// If a call throws, the remaining blocks are skipped, and the exception of the thread with the
// lowest index is rethrown. If the system cannot start a thread, the others process the blocks.
template <typename Body>
void for_each_block(std::size_t size, std::size_t block_size, unsigned number_of_threads,
                    const Body& body)
{
  const std::size_t number_of_blocks = (size + block_size - 1) / block_size;
  std::atomic<std::size_t> next_block{0};
  const auto process_blocks = [&]
  {
    for(std::size_t block; (block = next_block++) < number_of_blocks;)
      body(block, block * block_size, std::min(size, (block + 1) * block_size));
  };
  const std::size_t number_of_workers = std::min<std::size_t>(number_of_threads, number_of_blocks);
  if(number_of_workers < 2)
    return process_blocks();
  std::vector<std::exception_ptr> errors(number_of_workers);
  const auto process_guarded = [&](std::size_t thread)
  {
    try
    {
      process_blocks();
    }
    catch(...)
    {
      errors[thread] = std::current_exception();
      next_block = number_of_blocks;
    }
  };
  std::vector<std::thread> pool;
  pool.reserve(number_of_workers - 1);
  try
  {
    while(pool.size() + 1 < number_of_workers)
      pool.emplace_back(process_guarded, pool.size() + 1);
  }
  catch(const std::exception&)
  {
    // The destructor of a joinable thread would end the process, so the loop below joins them.
  }
  process_guarded(0);
  for(std::thread& thread : pool)
    thread.join();
  for(const std::exception_ptr& error : errors)
    if(error)
      std::rethrow_exception(error);
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PARALLEL_H
