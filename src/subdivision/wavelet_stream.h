// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_WAVELET_STREAM_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_WAVELET_STREAM_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/subdivision/lifting.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// The container of the wavelet stream: header, packets and the base triangles. Integers are stored
// with the least significant byte first.
namespace CGAL::Geodesic_processing::internal {

using Bytes = std::vector<std::uint8_t>;

constexpr unsigned max_planes = 48;
constexpr std::size_t max_channels = 16;

struct Stream_header
{
  std::size_t channels = 0, vertices = 0, triangles = 0; // of the base mesh
  unsigned levels = 0, planes = 0, tangent_shift = 0;
  Prediction prediction = Prediction::butterfly;
  bool use_update = false, is_in_frames = false;
  int exponent = 0;           // all scaled coefficients are below 2^exponent
  std::vector<double> origin; // #channels: subtracted from the values of the base vertices
};

// A position in a stream of bytes.
struct CGAL_GEODESIC_PROCESSING_EXPORT Stream_reader
{
  const std::uint8_t *next, *end;

  std::size_t remaining_size() const { return std::size_t(end - next); }

  // Throws Invalid_argument_error if fewer than `size` bytes remain.
  std::uint64_t read_integer(int size);
  double read_double();
};

struct Packet
{
  const std::uint8_t* bytes = nullptr; // null if not even the length and the checksum are present
  std::size_t size = 0;                // number of bytes present
  bool is_complete = false;
  bool is_damaged = false; // complete, but with a different checksum
};

// Returns the header with the magic number and a checksum (CRC-32).
CGAL_GEODESIC_PROCESSING_EXPORT
Bytes encode_header(const Stream_header& header);

// Throws Invalid_argument_error if the header is truncated, damaged, or has values out of range.
CGAL_GEODESIC_PROCESSING_EXPORT
Stream_header read_header(Stream_reader& reader);

// Appends the length of a packet, its checksum (CRC-32) and its bytes.
CGAL_GEODESIC_PROCESSING_EXPORT
void append_packet(Bytes& bytes, const Bytes& packet);

// Reads the next packet, which can be truncated.
CGAL_GEODESIC_PROCESSING_EXPORT
Packet read_packet(Stream_reader& reader);

// Encodes the vertices of all corners. One bit states if a vertex is the next new one in the order
// of the indices. If it is not, the bits of its index follow.
CGAL_GEODESIC_PROCESSING_EXPORT
Bytes encode_triangles(const std::vector<Triangle>& triangles, std::size_t number_of_vertices);

// Decodes the result of encode_triangles(). Vertices are not validated.
// Throws Invalid_argument_error if the packet is damaged or incomplete.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Triangle> decode_triangles(const Packet& packet, const Stream_header& header);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_WAVELET_STREAM_H
