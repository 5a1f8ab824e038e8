// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace parallel_test {

using CGAL::Geodesic_processing::internal::for_each_block;

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

} // namespace parallel_test
