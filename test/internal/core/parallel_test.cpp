// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace parallel_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(Parallel, blocks_partition_range)
{
  for(const unsigned number_of_threads : {1u, 3u, 16u})
    for(const std::size_t size : {0u, 1u, 7u, 8u, 9u, 1000u})
    {
      std::vector<std::size_t> block_of(size, size);
      for_each_block(size, 8, number_of_threads,
                     [&](std::size_t block, std::size_t begin, std::size_t end)
                     {
                       for(std::size_t i = begin; i < end; ++i)
                         block_of[i] = block;
                     });
      for(std::size_t i = 0; i < size; ++i)
        EXPECT_EQ(block_of[i], i / 8);
    }
}

TEST(Parallel, exception_is_rethrown)
{
  for(const unsigned number_of_threads : {1u, 4u})
    EXPECT_THROW(for_each_block(100, 1, number_of_threads,
                                [](std::size_t block, std::size_t, std::size_t)
                                {
                                  if(block == 50)
                                    throw std::runtime_error("block 50");
                                }),
                 std::runtime_error);
}

TEST(Parallel, each_index_is_visited_once)
{
  for(const unsigned number_of_threads : {1u, 3u})
    for(const std::size_t size : {0u, 1u, 100000u})
    {
      std::vector<int> number_of_visits(size, 0);
      for_each_index(size, number_of_threads, [&](std::size_t i) { ++number_of_visits[i]; });
      EXPECT_EQ(number_of_visits, std::vector<int>(size, 1));
    }
}

TEST(Parallel, predicate_is_false_for_one_index)
{
  constexpr std::size_t size = 100000;
  for(const unsigned number_of_threads : {1u, 3u})
  {
    for(const std::size_t exception : {std::size_t(0), size / 2, size - 1})
      EXPECT_FALSE(
          is_true_for_all(size, number_of_threads, [&](std::size_t i) { return i != exception; }));
    EXPECT_TRUE(is_true_for_all(size, number_of_threads, [](std::size_t i) { return i < size; }));
    EXPECT_TRUE(is_true_for_all(0, number_of_threads, [](std::size_t) { return false; }));
  }
}

TEST(Parallel, both_functions_are_called)
{
  for(const unsigned number_of_threads : {1u, 2u})
  {
    int first = 0, second = 0;
    run_both(
        number_of_threads, [&] { ++first; }, [&] { ++second; });
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 1);
  }
}

TEST(Parallel, each_thread_has_one_block)
{
  for(const unsigned number_of_threads : {1u, 2u, 7u})
    for(const std::size_t size : {0u, 1u, 6u, 7u, 8u, 1000u})
    {
      const std::size_t block_size = block_size_of_threads(size, number_of_threads);
      EXPECT_GE(block_size, 1u);
      EXPECT_GE(block_size * number_of_threads, size);
      EXPECT_LT((block_size - 1) * number_of_threads, std::max<std::size_t>(size, 1));
    }
  EXPECT_EQ(block_size_of_threads(5, 0), 5u);
}

} // namespace parallel_test
