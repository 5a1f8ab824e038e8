// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/Queue.h>

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing::internal;

TEST(Queue, pops_the_smallest_key_whatever_was_changed)
{
  const Index n = 500;
  std::mt19937 random(1);
  Queue queue(n);
  std::map<Index, double> truth;
  for(int step = 0; step < 20000; ++step)
  {
    const Index site = Index(random() % n);
    if(random() % 3 != 0 || queue.empty())
    {
      const double key = double(random() % 1000); // ties are common
      queue.push(site, key);
      truth[site] = key;
      EXPECT_TRUE(queue.contains(site));
      continue;
    }
    double least = infinity;
    for(const auto& [other, key] : truth)
      least = std::min(least, key);
    EXPECT_EQ(queue.front().key, least);
    const Queue::Entry entry = queue.pop();
    EXPECT_EQ(entry.key, least);
    ASSERT_EQ(truth.count(entry.site), 1u);
    EXPECT_EQ(truth[entry.site], least);
    truth.erase(entry.site);
    EXPECT_FALSE(queue.contains(entry.site));
  }
  double last = 0.;
  for(; !queue.empty(); truth.erase(queue.pop().site))
  {
    EXPECT_GE(queue.front().key, last);
    last = queue.front().key;
  }
  EXPECT_TRUE(truth.empty());
}

TEST(Queue, is_empty_once_cleared)
{
  Queue queue(10);
  for(Index site = 0; site < 10; ++site)
    queue.push(site, 1. + site);
  queue.clear();
  EXPECT_TRUE(queue.empty());
  for(Index site = 0; site < 10; ++site)
    EXPECT_FALSE(queue.contains(site));
  queue.push(3, 2.);
  EXPECT_EQ(queue.pop().site, 3u);
}

} // namespace
