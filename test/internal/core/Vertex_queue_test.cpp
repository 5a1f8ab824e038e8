// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace Vertex_queue_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(Vertex_queue, pops_smallest_key_after_updates)
{
  const Index n = 500;
  std::mt19937 random(1);
  Vertex_queue queue(n);
  std::map<Index, double> expected;
  for(int step = 0; step < 20000; ++step)
  {
    const Index vertex = Index(random() % n);
    if(random() % 3 != 0 || queue.empty())
    {
      const double key = double(random() % 1000); // ties are common
      queue.push(vertex, key);
      expected[vertex] = key;
      EXPECT_TRUE(queue.contains(vertex));
      continue;
    }
    double smallest = infinity;
    for(const auto& [other, key] : expected)
      smallest = std::min(smallest, key);
    EXPECT_EQ(queue.front().key, smallest);
    const Vertex_queue::Entry entry = queue.pop();
    EXPECT_EQ(entry.key, smallest);
    ASSERT_EQ(expected.count(entry.vertex), 1u);
    EXPECT_EQ(expected[entry.vertex], smallest);
    expected.erase(entry.vertex);
    EXPECT_FALSE(queue.contains(entry.vertex));
  }
  double previous_key = 0.;
  for(; !queue.empty(); expected.erase(queue.pop().vertex))
  {
    EXPECT_GE(queue.front().key, previous_key);
    previous_key = queue.front().key;
  }
  EXPECT_TRUE(expected.empty());
}

TEST(Vertex_queue, is_empty_after_clear)
{
  Vertex_queue queue(10);
  for(Index vertex = 0; vertex < 10; ++vertex)
    queue.push(vertex, 1. + vertex);
  queue.clear();
  EXPECT_TRUE(queue.empty());
  for(Index vertex = 0; vertex < 10; ++vertex)
    EXPECT_FALSE(queue.contains(vertex));
  queue.push(3, 2.);
  EXPECT_EQ(queue.pop().vertex, 3u);
}

} // namespace Vertex_queue_test
