// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ZEROTREE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ZEROTREE_H

#include <CGAL/Geodesic_processing/internal/subdivision/lifting.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Progressive coding of wavelet coefficients by zerotrees (Khodakovsky, Schröder and Sweldens
// 2000). The stream has the most significant bits first, so that each prefix decodes to an
// approximation.
//
// The coefficients are coded by bit planes. A plane first states which coefficients become
// significant, from the coarsest to the finest level, and adds one bit to the significant ones. If
// no descendant of a coefficient is significant, one bit states this for the whole tree. The
// coefficient of an edge has four children: its two halves, and the two edges of the next level
// parallel to it in its two triangles. Bits are coded arithmetically with contexts: the
// significance of the parent, of the other edges of both triangles, and of the other channels.
//
// Layout: a header, the base triangles, then the bit planes, each with its length and a checksum
// (CRC-32). Integers are stored with the least significant byte first. If a stream is damaged,
// the planes before the damage are decoded.

struct Wavelet_signal
{
  std::size_t channels = 0;
  Prediction prediction = Prediction::butterfly;
  bool use_update = true, is_in_frames = false;
  std::vector<double> values; // #vertices * channels: after Lifting::analyze()
};

// Encodes a subdivision and wavelet coefficients.
//
// planes               number of bits of the largest coefficient, 1 to 48
// tangent_shift        details tangential to the surface are coded this number of planes later than
//                      normal ones
// max_number_of_bytes  the stream is truncated to this size
//
// Throws Invalid_argument_error if the surface has no vertices, a number is out of range, or a
// value is not finite or exceeds 1e280. O(size of the stream + planes * n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::uint8_t> encode(const Subdivision& subdivision, const Wavelet_signal& signal,
                                 unsigned planes, unsigned tangent_shift = 2,
                                 std::size_t max_number_of_bytes = static_cast<std::size_t>(-1));

struct Decoded_wavelets
{
  std::shared_ptr<const Subdivision> subdivision;
  Wavelet_signal signal;
  std::size_t planes = 0;       // number of complete planes
  std::size_t total_planes = 0; // number of planes of the encoder
  bool is_damaged = false;      // a checksum differs: only the planes before it are used
};

// Decodes a stream or a prefix of one. Throws Invalid_argument_error if the header or the base
// mesh is incomplete or damaged, or if the surface has more than `max_number_of_vertices` vertices.
CGAL_GEODESIC_PROCESSING_EXPORT
Decoded_wavelets decode(const std::uint8_t* bytes, std::size_t size,
                        std::size_t max_number_of_vertices);

// Returns the values (#vertices * channels) that a decoded stream represents: synthesizes its
// coefficients.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> decoded_values(const Decoded_wavelets& decoding);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ZEROTREE_H
