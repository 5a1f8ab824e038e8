// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PREFETCH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PREFETCH_H

namespace CGAL::Geodesic_processing::internal {

// Whether prefetch() has an effect. WebAssembly has no such instruction. Loads whose results are not
// used are no replacement: with them, fronts take as long as without.
#if defined(__GNUC__) && !defined(__wasm__)
inline constexpr bool has_prefetch = true;
#else
inline constexpr bool has_prefetch = false;
#endif

// Starts to load the cache line of an address, which need not be valid.
inline void prefetch([[maybe_unused]] const void* address)
{
#if defined(__GNUC__) && !defined(__wasm__)
  __builtin_prefetch(address);
  // Otherwise gcc drops the calls of functions that only prefetch: they have no effect on results.
  // Without the prefetches, fronts take 20 % longer.
  __asm__ volatile("");
#endif
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PREFETCH_H
