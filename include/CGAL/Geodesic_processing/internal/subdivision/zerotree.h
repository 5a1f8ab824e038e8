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

// Details as a stream of bytes, the most important bits first (Khodakovsky, Schröder and Sweldens 2000): any prefix
// gives the values as well as so many bits can.
//
// All numbers are cut into bit planes.  A plane tells, from coarse to fine, which numbers become significant in it,
// and one more bit of those that are; where no descendant of a detail is, one bit says so for the whole tree.  The
// children of the detail of an edge are those of the four edges of the next level that it makes or that run
// parallel to it in its two triangles.  Bits are coded arithmetically, in contexts of what is known of the parent
// and of the other edges of both triangles.
//
// Layout: a header, the base triangles, then the planes, each with its length and a checksum (CRC-32), integers with
// the least byte first.  So a damaged stream gives what stands before the damage.

struct Wavelet_signal
{
  std::size_t channels = 0;
  Prediction prediction = Prediction::butterfly;
  bool use_update = true, is_in_frames = false;
  std::vector<double> values; // #vertices * channels, after analysis
};

// planes: bits of the largest number, 1 to 48
// tangent_shift: how many planes later details along the surface come than those along its normal
// max_number_of_bytes: the stream ends there, within the last plane
// Throws Invalid_argument_error when the surface has no vertices, or values are not finite.
// O(size of the stream + planes * n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::uint8_t> encode(const Subdivision& subdivision, const Wavelet_signal& signal,
                                 unsigned planes, unsigned tangent_shift = 2,
                                 std::size_t max_number_of_bytes = static_cast<std::size_t>(-1));

struct Decoded_wavelets
{
  std::shared_ptr<const Subdivision> subdivision;
  Wavelet_signal signal;
  std::size_t planes = 0;       // read as a whole
  std::size_t total_planes = 0; // that the encoder has begun with
  bool is_damaged = false; // bytes are not what the encoder wrote: only those before them are used
};

// Throws Invalid_argument_error where not even the base mesh can be read, or where the surface would have more
// vertices than `max_number_of_vertices`.
CGAL_GEODESIC_PROCESSING_EXPORT
Decoded_wavelets decode(const std::uint8_t* bytes, std::size_t size,
                        std::size_t max_number_of_vertices);

// The values that a stream stands for.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> decoded_values(const Decoded_wavelets& decoding);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_ZEROTREE_H
