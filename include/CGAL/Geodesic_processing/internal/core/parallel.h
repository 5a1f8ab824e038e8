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

// Calls body(i) for all i < size, for blocks of consecutive i at a time. The calls for different i
// must be independent.
template <typename Body>
void for_each_index(std::size_t size, unsigned number_of_threads, const Body& body)
{
  for_each_block(size, std::size_t(1) << 14, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(std::size_t i = begin; i < end; ++i)
                     body(i);
                 });
}

// Returns whether predicate(i) is true for all i < size.
template <typename Predicate>
bool is_true_for_all(std::size_t size, unsigned number_of_threads, const Predicate& predicate)
{
  std::atomic<bool> result{true};
  for_each_block(size, std::size_t(1) << 14, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(std::size_t i = begin; i < end; ++i)
                     if(!predicate(i))
                     {
                       result = false;
                       return;
                     }
                 });
  return result;
}

// Calls two functions at the same time if there are several threads.
template <typename First, typename Second>
void run_both(unsigned number_of_threads, const First& first, const Second& second)
{
  for_each_block(2, 1, number_of_threads,
                 [&](std::size_t block, std::size_t, std::size_t)
                 {
                   if(block == 0)
                     first();
                   else
                     second();
                 });
}

// Returns the size of blocks such that each thread has one.
inline std::size_t block_size_of_threads(std::size_t size, unsigned number_of_threads)
{
  const std::size_t count = std::max(1u, number_of_threads);
  return std::max<std::size_t>(1, (size + count - 1) / count);
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PARALLEL_H
