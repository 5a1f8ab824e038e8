// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/wavelet_stream.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

namespace wavelet_stream_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;

Stream_header example_header()
{
  Stream_header header;
  header.channels = 3;
  header.vertices = 4;
  header.triangles = 4;
  header.levels = 5;
  header.planes = 17;
  header.tangent_shift = 2;
  header.prediction = Prediction::linear;
  header.use_update = true;
  header.exponent = -300;
  header.origin = {1.5, -2e100, 0.};
  return header;
}

Stream_reader reader_of(const Bytes& bytes) { return {bytes.data(), bytes.data() + bytes.size()}; }

TEST(Wavelet_stream, header_survives_round_trip)
{
  const Stream_header header = example_header();
  const Bytes bytes = encode_header(header);
  Stream_reader reader = reader_of(bytes);
  const Stream_header found = read_header(reader);
  EXPECT_EQ(reader.remaining_size(), 0u);
  EXPECT_EQ(found.channels, header.channels);
  EXPECT_EQ(found.vertices, header.vertices);
  EXPECT_EQ(found.triangles, header.triangles);
  EXPECT_EQ(found.levels, header.levels);
  EXPECT_EQ(found.planes, header.planes);
  EXPECT_EQ(found.tangent_shift, header.tangent_shift);
  EXPECT_EQ(found.prediction, header.prediction);
  EXPECT_EQ(found.use_update, header.use_update);
  EXPECT_EQ(found.is_in_frames, header.is_in_frames);
  EXPECT_EQ(found.exponent, header.exponent);
  EXPECT_EQ(found.origin, header.origin);
}

TEST(Wavelet_stream, throws_on_truncated_or_damaged_header)
{
  const Bytes bytes = encode_header(example_header());
  for(std::size_t i = 0; i < bytes.size(); ++i)
  {
    Stream_reader truncated = {bytes.data(), bytes.data() + i};
    EXPECT_THROW(read_header(truncated), Invalid_argument_error);
    Bytes damaged = bytes;
    damaged[i] ^= 1;
    Stream_reader reader = reader_of(damaged);
    EXPECT_THROW(read_header(reader), Invalid_argument_error);
  }
}

TEST(Wavelet_stream, throws_on_header_out_of_range)
{
  const auto expect_throws = [](const Stream_header& header)
  {
    const Bytes bytes = encode_header(header);
    Stream_reader reader = reader_of(bytes);
    EXPECT_THROW(read_header(reader), Invalid_argument_error);
  };
  Stream_header header = example_header();
  header.planes = 49;
  expect_throws(header);
  header = example_header();
  header.exponent = 960;
  expect_throws(header);
  header = example_header();
  header.origin[0] = infinity;
  expect_throws(header);
  header = example_header();
  header.channels = 0;
  header.origin.clear();
  expect_throws(header);
}

TEST(Wavelet_stream, packets_are_complete_truncated_or_damaged)
{
  Bytes bytes;
  append_packet(bytes, {1, 2, 3});
  append_packet(bytes, {});
  Stream_reader reader = reader_of(bytes);
  const Packet first = read_packet(reader), second = read_packet(reader), end = read_packet(reader);
  EXPECT_EQ(Bytes(first.bytes, first.bytes + first.size), (Bytes{1, 2, 3}));
  EXPECT_TRUE(first.is_complete && !first.is_damaged);
  EXPECT_TRUE(second.is_complete && !second.is_damaged);
  EXPECT_EQ(second.size, 0u);
  EXPECT_EQ(end.bytes, nullptr);
  EXPECT_FALSE(end.is_complete);

  Stream_reader truncated = {bytes.data(), bytes.data() + 10};
  const Packet part = read_packet(truncated);
  EXPECT_EQ(part.size, 2u);
  EXPECT_FALSE(part.is_complete || part.is_damaged);

  bytes[9] ^= 1;
  reader = reader_of(bytes);
  EXPECT_TRUE(read_packet(reader).is_damaged);
}

TEST(Wavelet_stream, triangles_survive_round_trip)
{
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 0, 3}, {6, 2, 5}, {4, 5, 6}};
  Bytes bytes;
  append_packet(bytes, encode_triangles(triangles, 7));
  Stream_header header = example_header();
  header.vertices = 7;
  header.triangles = 4;
  Stream_reader reader = reader_of(bytes);
  const Packet packet = read_packet(reader);
  EXPECT_EQ(decode_triangles(packet, header), triangles);
  Packet incomplete = packet;
  incomplete.is_complete = false;
  EXPECT_THROW(decode_triangles(incomplete, header), Invalid_argument_error);
  header.triangles = 1000; // more corners than bits
  EXPECT_THROW(decode_triangles(packet, header), Invalid_argument_error);
}

} // namespace wavelet_stream_test
