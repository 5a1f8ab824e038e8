// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FOR_EACH_ROW_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FOR_EACH_ROW_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Copies of an engine, at most one per thread, that are used again.
template <typename Engine>
class Engine_pool
{
public:
  explicit Engine_pool(const Engine& engine) : m_engine(engine) {}

  std::unique_ptr<Engine> take()
  {
    {
      const std::lock_guard lock(m_mutex);
      if(!m_idle.empty())
      {
        std::unique_ptr<Engine> result = std::move(m_idle.back());
        m_idle.pop_back();
        return result;
      }
    }
    return std::make_unique<Engine>(m_engine);
  }
  void give_back(std::unique_ptr<Engine> engine)
  {
    const std::lock_guard lock(m_mutex);
    m_idle.push_back(std::move(engine));
  }

private:
  const Engine& m_engine;
  std::mutex m_mutex;
  std::vector<std::unique_ptr<Engine>> m_idle;
};

// Calls row(i, engine, limits) for each row i, on several threads; each thread has a copy of the
// engine. If a row only runs its engine within the limits and writes its own entries, the results
// do not depend on the number of threads. The callback of the limits receives the fraction of the
// rows done, before and during each row, from one thread at a time. Returns false if it cancelled.
template <typename Engine, typename Row>
bool for_each_row(Engine_pool<Engine>& engines, std::size_t number_of_rows, Front_limits limits,
                  unsigned number_of_threads, const Row& row)
{
  std::mutex mutex;
  std::size_t number_done = 0;
  std::atomic<bool> is_cancelled{false};
  const std::function<bool(double)> callback = std::exchange(limits.callback, nullptr);
  // Requires that this thread has locked the mutex.
  const auto report = [&]
  {
    if(!callback || is_cancelled)
      return;
    try
    {
      is_cancelled = !callback(double(number_done) / double(number_of_rows));
    }
    catch(...)
    {
      is_cancelled = true; // ends the rows of the other threads
      throw;
    }
  };
  if(callback)
    limits.callback = [&](double)
    {
      // If another thread reports, this thread does not wait for it.
      if(const std::unique_lock lock(mutex, std::try_to_lock); lock)
        report();
      return !is_cancelled;
    };

  for_each_block(number_of_rows, 1, number_of_threads,
                 [&](std::size_t i, std::size_t, std::size_t)
                 {
                   {
                     const std::lock_guard lock(mutex);
                     report();
                     if(is_cancelled)
                       return;
                   }
                   std::unique_ptr<Engine> engine = engines.take();
                   row(i, *engine, std::as_const(limits));
                   engines.give_back(std::move(engine));
                   const std::lock_guard lock(mutex);
                   ++number_done;
                 });
  return !is_cancelled;
}

template <typename Engine, typename Row>
bool for_each_row(const Engine& engine, std::size_t number_of_rows, const Front_limits& limits,
                  unsigned number_of_threads, const Row& row)
{
  Engine_pool<Engine> engines(engine);
  return for_each_row(engines, number_of_rows, limits, number_of_threads, row);
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FOR_EACH_ROW_H
