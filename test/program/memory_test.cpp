// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/memory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <string>

#if defined(__linux__)
#  include <sys/resource.h>
#endif

namespace memory_test {

using namespace program;

TEST(Memory, lack_is_reported_with_both_sizes)
{
  EXPECT_EQ(lack_of_memory("the method exact", 4.84e9, 2e9),
            "the method exact needs about 4.84 GB of memory, but only 2.00 GB are available");
  EXPECT_EQ(lack_of_memory("the method exact", 2e9, 2e9), "");
  EXPECT_EQ(lack_of_memory("the method exact", 4e30, std::nullopt), "");
}

#if defined(__linux__)
TEST(Memory, available_memory_is_bounded_by_limit_of_address_space)
{
  const std::optional<double> without_limit = available_memory();
  ASSERT_TRUE(without_limit.has_value());
  EXPECT_GT(*without_limit, 0.);
  EXPECT_LT(*without_limit, 1e16); // more than any machine has
  rlim_t number_of_pages = 0;
  std::ifstream("/proc/self/statm") >> number_of_pages;
  rlimit limit;
  ASSERT_EQ(getrlimit(RLIMIT_AS, &limit), 0);
  const rlimit old_limit = limit;
  constexpr rlim_t margin = 64 << 20;
  limit.rlim_cur = number_of_pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + margin;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &limit), 0);
  const std::optional<double> with_limit = available_memory();
  ASSERT_EQ(setrlimit(RLIMIT_AS, &old_limit), 0);
  ASSERT_TRUE(with_limit.has_value());
  EXPECT_LE(*with_limit, double(margin));
  EXPECT_GT(*with_limit, 0.);
}
#endif

} // namespace memory_test
