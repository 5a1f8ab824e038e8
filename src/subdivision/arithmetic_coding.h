// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ARITHMETIC_CODING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ARITHMETIC_CODING_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// An adaptive estimate of the probability of a bit in one context. It is the mean of the previous
// bits, and from the 60th bit on an exponentially weighted mean. Uses integers, so that it is the
// same on all machines.
struct Bit_model
{
  std::uint16_t probability = 1u << 15; // that the bit is set, times 2^16
  std::uint16_t number_of_bits = 0;     // at most 60

  CGAL_GEODESIC_PROCESSING_EXPORT void update(bool bit);
};

// A binary arithmetic encoder with a 32-bit interval (Witten, Neal and Cleary 1987).
class CGAL_GEODESIC_PROCESSING_EXPORT Bit_encoder
{
public:
  void put(bool bit, Bit_model& model);
  void put(bool bit); // with probability 1/2

  // Returns all bytes. The encoder cannot be used afterwards.
  std::vector<std::uint8_t> finish();

private:
  void put(bool bit, std::uint32_t probability);

  std::uint32_t m_low = 0, m_high = 0xffffffff;
  std::vector<std::uint8_t> m_bytes;
};

// The decoder. From a prefix of the bytes, it decodes exactly the bits that are the same for all
// continuations.
class CGAL_GEODESIC_PROCESSING_EXPORT Bit_decoder
{
public:
  // is_complete  the bytes are the whole output of the encoder, not a prefix
  Bit_decoder(const std::uint8_t* bytes, std::size_t size, bool is_complete);

  bool get(Bit_model& model);
  bool get();

  // Returns true if a requested bit was not determined by the bytes. This bit and all later ones
  // are returned as false.
  bool is_exhausted() const { return m_is_exhausted; }

private:
  bool get(std::uint32_t probability);
  void read_byte();

  const std::uint8_t *m_next, *m_end;
  bool m_is_complete, m_is_exhausted = false;
  std::uint32_t m_low = 0, m_high = 0xffffffff;
  std::uint32_t m_min_code = 0, m_max_code = 0; // range of the code, given the bytes
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ARITHMETIC_CODING_H
