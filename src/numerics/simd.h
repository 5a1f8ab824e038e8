// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SIMD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SIMD_H

#include <cstddef>
#include <cstring>

// Run-time SIMD dispatch. Each kernel is compiled for the baseline instruction set and for AVX2,
// and selected at run time.
// A kernel is a template of GEODESIC_PROCESSING_INLINE functions on Baseline_pack or Avx2_pack. For
// the latter, a function with GEODESIC_PROCESSING_TARGET_AVX2_FMA calls it. If the result must be
// bitwise the same as that of the baseline, use GEODESIC_PROCESSING_TARGET_AVX2. Include this
// header in source files only.

#if defined(__GNUC__)
#  define GEODESIC_PROCESSING_INLINE inline __attribute__((always_inline))
#else
#  define GEODESIC_PROCESSING_INLINE inline
#endif

#if defined(__GNUC__) && defined(__x86_64__)
#  define GEODESIC_PROCESSING_TARGET_AVX2_FMA __attribute__((target("avx2,fma")))
#  define GEODESIC_PROCESSING_TARGET_AVX2 __attribute__((target("avx2")))
#else
#  define GEODESIC_PROCESSING_TARGET_AVX2_FMA
#  define GEODESIC_PROCESSING_TARGET_AVX2
#endif

namespace CGAL::Geodesic_processing::internal {

// A register of `bytes` bytes as a vector of scalars.
template <typename Scalar, std::size_t bytes>
struct Simd_register
{
#if defined(__GNUC__)
  typedef Scalar type __attribute__((vector_size(bytes)));
#else
  using type = Scalar;
#endif
};

// Unaligned load and store.
template <typename Pack, typename Scalar>
GEODESIC_PROCESSING_INLINE void load(const Scalar* from, Pack& pack)
{
  std::memcpy(&pack, from, sizeof(Pack));
}
template <typename Pack, typename Scalar>
GEODESIC_PROCESSING_INLINE void store(const Pack& pack, Scalar* to)
{
  std::memcpy(to, &pack, sizeof(Pack));
}

template <typename Scalar>
using Baseline_pack = typename Simd_register<Scalar, 16>::type;

#if defined(__GNUC__) && defined(__x86_64__)

template <typename Scalar>
using Avx2_pack = typename Simd_register<Scalar, 32>::type;

inline bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

#else

template <typename Scalar>
using Avx2_pack = Baseline_pack<Scalar>;

inline bool has_avx2() { return false; }

#endif

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SIMD_H
