// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ARITHMETIC_CODING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ARITHMETIC_CODING_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The probability of a bit in one context, learnt from those that came before: at first the mean of all of them,
// then mostly of the last ones.  In integers, so that it is the same on every machine.
struct Bit_model
{
  std::uint16_t probability = 1u << 15; // that the bit is set, of 2^16
  std::uint16_t number_of_bits = 0;

  CGAL_GEODESIC_PROCESSING_EXPORT void update(bool bit);
};

// Bits to bytes, by an interval of 32 bits that shrinks by the probability of each (Witten, Neal and Cleary 1987).
class CGAL_GEODESIC_PROCESSING_EXPORT Bit_encoder
{
public:
  void put(bool bit, Bit_model& model);
  void put(bool bit); // either as likely

  // All bytes; nothing can be put afterwards.
  std::vector<std::uint8_t> finish();

private:
  void put(bool bit, std::uint32_t probability);

  std::uint32_t m_low = 0, m_high = 0xffffffff;
  std::vector<std::uint8_t> m_bytes;
};

// The way back.  Of a prefix of the bytes it gives just the bits that all continuations share.
class CGAL_GEODESIC_PROCESSING_EXPORT Bit_decoder
{
public:
  // is_complete: the bytes are all that the encoder made
  Bit_decoder(const std::uint8_t* bytes, std::size_t size, bool is_complete);

  bool get(Bit_model& model);
  bool get();

  // True when a bit was asked for that the bytes do not tell; that and all later ones are zero.
  bool is_exhausted() const { return m_is_exhausted; }

private:
  bool get(std::uint32_t probability);
  void read_byte();

  const std::uint8_t *m_next, *m_end;
  bool m_is_complete, m_is_exhausted = false;
  std::uint32_t m_low = 0, m_high = 0xffffffff;
  std::uint32_t m_min_code = 0, m_max_code = 0; // what the code may be, as far as it is known
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ARITHMETIC_CODING_H
