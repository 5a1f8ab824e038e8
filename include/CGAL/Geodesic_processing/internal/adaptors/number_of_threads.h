// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_NUMBER_OF_THREADS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_NUMBER_OF_THREADS_H

#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <thread>
#include <type_traits>

namespace CGAL::Geodesic_processing::internal {

// Returns the number of threads: 1 if `Concurrency_tag` is `Sequential_tag`, otherwise the named
// parameter `number_of_threads`, by default the number of hardware threads.
template <typename Concurrency_tag, typename NamedParameters>
unsigned number_of_threads(const NamedParameters& np)
{
  if constexpr(std::is_same_v<Concurrency_tag, Sequential_tag>)
    return 1;
  else
    return parameter(np, internal_np::number_of_threads,
                     (std::max)(1u, std::thread::hardware_concurrency()));
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_NUMBER_OF_THREADS_H
