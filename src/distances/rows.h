// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ROWS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ROWS_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Calls row(i, engine, limits) for each row, on several threads, each with an engine of its own: a row
// that lets it run within the limits and writes only what is its own gives the same for any number of
// threads.  The callback of the limits is told the part of the rows that are done, by one thread at a
// time.  False when it cancelled.
template <typename Engine, typename Row>
bool for_each_row(const Engine& engine, std::size_t rows, Front_limits limits, unsigned threads,
                  const Row& row)
{
  std::mutex mutex;
  std::vector<std::unique_ptr<Engine>> idle; // engines that wait for a row
  std::size_t done = 0;
  std::atomic<bool> is_cancelled{false};
  const std::function<bool(double)> callback = std::exchange(limits.callback, nullptr);
  if(callback)
    limits.callback = [&](double) { return !is_cancelled; };

  for_each_block(rows, 1, threads,
                 [&](std::size_t i, std::size_t, std::size_t)
                 {
                   std::unique_ptr<Engine> own;
                   {
                     const std::lock_guard lock(mutex);
                     if(callback && !is_cancelled)
                       is_cancelled = !callback(double(done) / double(rows));
                     if(is_cancelled)
                       return;
                     if(!idle.empty())
                     {
                       own = std::move(idle.back());
                       idle.pop_back();
                     }
                   }
                   if(!own)
                     own = std::make_unique<Engine>(engine);
                   row(i, *own, std::as_const(limits));
                   const std::lock_guard lock(mutex);
                   idle.push_back(std::move(own));
                   ++done;
                 });
  return !is_cancelled;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ROWS_H
