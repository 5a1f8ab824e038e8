// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/wavelet_stream.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include "subdivision/arithmetic_coding.h"

#include <boost/crc.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr char magic[] = {'G', 'P', 'W', '1'};
constexpr unsigned max_number_of_levels = 15;

// Appends the `size` lowest bytes of a number, least significant byte first.
void append(Bytes& bytes, std::uint64_t number, int size)
{
  for(int i = 0; i < size; ++i)
    bytes.push_back(std::uint8_t(number >> (8 * i)));
}

void append(Bytes& bytes, double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  append(bytes, bits, 8);
}

// Returns the CRC-32.
std::uint32_t checksum(const std::uint8_t* bytes, std::size_t size)
{
  boost::crc_32_type crc;
  crc.process_bytes(bytes, size);
  return crc.checksum();
}

// Returns the number of bits without leading zeros.
unsigned bit_width(std::size_t number)
{
  unsigned result = 0;
  for(; number > 0; number >>= 1)
    ++result;
  return result;
}

} // namespace

std::uint64_t Stream_reader::read_integer(int size)
{
  if(remaining_size() < std::size_t(size))
    throw Invalid_argument_error("The wavelet stream ends within its header.");
  std::uint64_t result = 0;
  for(int i = 0; i < size; ++i)
    result |= std::uint64_t(*next++) << (8 * i);
  return result;
}

double Stream_reader::read_double()
{
  const std::uint64_t bits = read_integer(8);
  double result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

void append_packet(Bytes& bytes, const Bytes& packet)
{
  append(bytes, packet.size(), 4);
  append(bytes, checksum(packet.data(), packet.size()), 4);
  bytes.insert(bytes.end(), packet.begin(), packet.end());
}

Packet read_packet(Stream_reader& reader)
{
  Packet result;
  if(reader.remaining_size() < 8)
  {
    reader.next = reader.end;
    return result;
  }
  const std::size_t size = reader.read_integer(4), expected_checksum = reader.read_integer(4);
  result.bytes = reader.next;
  result.size = std::min(size, reader.remaining_size());
  result.is_complete = result.size == size;
  result.is_damaged =
      result.is_complete && checksum(result.bytes, result.size) != expected_checksum;
  reader.next += result.size;
  return result;
}

Bytes encode_header(const Stream_header& h)
{
  Bytes result(std::begin(magic), std::end(magic));
  append(result, h.channels, 1);
  append(result,
         unsigned(h.prediction == Prediction::butterfly) | unsigned(h.use_update) << 1 |
             unsigned(h.is_in_frames) << 2,
         1);
  append(result, h.levels, 1);
  append(result, h.planes, 1);
  append(result, h.tangent_shift, 1);
  append(result, std::uint64_t(h.exponent + 32768), 2);
  append(result, h.vertices, 4);
  append(result, h.triangles, 4);
  for(const double x : h.origin)
    append(result, x);
  append(result, checksum(result.data(), result.size()), 4);
  return result;
}

Stream_header read_header(Stream_reader& reader)
{
  const std::uint8_t* const begin = reader.next;
  for(const char letter : magic)
    if(reader.read_integer(1) != std::uint8_t(letter))
      throw Invalid_argument_error("The bytes are not a wavelet stream.");
  Stream_header h;
  h.channels = std::size_t(reader.read_integer(1));
  const std::uint64_t flags = reader.read_integer(1);
  h.prediction = (flags & 1) != 0 ? Prediction::butterfly : Prediction::linear;
  h.use_update = (flags & 2) != 0;
  h.is_in_frames = (flags & 4) != 0;
  h.levels = unsigned(reader.read_integer(1));
  h.planes = unsigned(reader.read_integer(1));
  h.tangent_shift = unsigned(reader.read_integer(1));
  h.exponent = int(reader.read_integer(2)) - 32768;
  h.vertices = std::size_t(reader.read_integer(4));
  h.triangles = std::size_t(reader.read_integer(4));
  for(std::size_t c = 0; c < h.channels; ++c)
    h.origin.push_back(reader.read_double());
  const std::uint32_t expected_checksum = checksum(begin, std::size_t(reader.next - begin));
  // Synthesis adds a few hundred numbers below 2^exponent; the bounds ensure that sums are finite.
  const bool is_valid =
      reader.read_integer(4) == expected_checksum && h.channels > 0 && h.channels <= max_channels &&
      flags < 8 && h.levels <= max_number_of_levels && h.planes > 0 && h.planes <= max_planes &&
      h.tangent_shift <= max_planes && std::abs(h.exponent) < 960 &&
      (!h.is_in_frames || h.channels == 3) &&
      std::all_of(h.origin.begin(), h.origin.end(), [](double x) { return std::abs(x) < 1e300; });
  if(!is_valid)
    throw Invalid_argument_error("The header of the wavelet stream is damaged.");
  return h;
}

Bytes encode_triangles(const std::vector<Triangle>& triangles, std::size_t number_of_vertices)
{
  Bit_encoder encoder;
  std::size_t next = 0;
  for(const Triangle& t : triangles)
    for(const Index v : t)
    {
      encoder.put(v == next);
      if(v == next)
        ++next;
      else
        for(unsigned bit = bit_width(number_of_vertices - 1); bit-- > 0;)
          encoder.put(((v >> bit) & 1) != 0);
    }
  return encoder.finish();
}

std::vector<Triangle> decode_triangles(const Packet& packet, const Stream_header& header)
{
  const char* const message = "The base mesh of the wavelet stream is damaged or incomplete.";
  // Each corner takes at least one bit. This bounds the memory that a damaged header can request.
  if(!packet.is_complete || packet.is_damaged || 3 * header.triangles > 8 * packet.size)
    throw Invalid_argument_error(message);
  Bit_decoder decoder(packet.bytes, packet.size, true);
  std::vector<Triangle> result(header.triangles);
  Index next = 0;
  for(Triangle& t : result)
    for(Index& v : t)
    {
      if(decoder.get())
        v = next++;
      else
      {
        v = 0;
        for(unsigned bit = bit_width(header.vertices - 1); bit-- > 0;)
          v = 2 * v + Index(decoder.get());
      }
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
