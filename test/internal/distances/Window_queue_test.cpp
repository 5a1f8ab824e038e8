// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_queue.h>

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

namespace Window_queue_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(Window_queue, pops_smallest_key_with_the_windows_of_the_item)
{
  const Index n = 300;
  std::mt19937 random(1);
  Window_queue queue(n);
  std::map<Index, std::pair<double, Index>> expected; // key and position of the windows
  for(int step = 0; step < 20000; ++step)
  {
    if(random() % 3 != 0 || queue.empty())
    {
      const Index index = Index(random() % n);
      const double key = double(random() % 1000); // ties are common
      Window_queue::Waiting_windows& windows = queue.push(index, key);
      const auto [entry, is_new] = expected.emplace(index, std::pair(key, Index(step)));
      entry->second.first = key;
      if(is_new)
      {
        EXPECT_EQ(windows[0].size + windows[1].size, 0u);
        windows[1].position = Index(step);
      }
      EXPECT_EQ(windows[1].position, entry->second.second);
      continue;
    }
    double smallest = infinity;
    for(const auto& entry : expected)
      smallest = std::min(smallest, entry.second.first);
    EXPECT_EQ(queue.smallest_key(), smallest);
    const Window_queue::Item item = queue.pop();
    ASSERT_EQ(expected.count(item.index), 1u);
    EXPECT_EQ(expected[item.index].first, smallest);
    EXPECT_EQ(item.windows[1].position, expected[item.index].second);
    expected.erase(item.index);
  }
  while(!queue.empty())
    expected.erase(queue.pop().index);
  EXPECT_TRUE(expected.empty());
}

} // namespace Window_queue_test
