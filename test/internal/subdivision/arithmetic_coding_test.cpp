// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/arithmetic_coding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arithmetic_coding_test {

using namespace CGAL::Geodesic_processing::internal;

struct Bits
{
  std::vector<bool> bits;
  std::vector<std::uint8_t> bytes;
};

// Encodes random bits in three contexts; every fifth bit has probability 1/2 instead.
Bits random_bits(std::size_t number, double probability, unsigned seed)
{
  Bits result;
  std::mt19937 random(seed);
  std::bernoulli_distribution distribution(probability);
  Bit_encoder encoder;
  Bit_model models[3];
  for(std::size_t i = 0; i < number; ++i)
  {
    result.bits.push_back(distribution(random));
    if(i % 5 == 4)
      encoder.put(result.bits.back());
    else
      encoder.put(result.bits.back(), models[i % 3]);
  }
  result.bytes = encoder.finish();
  return result;
}

// Returns the number of bits that are decoded until the decoder is exhausted, and expects that they
// are correct.
std::size_t count_decoded_bits(const Bits& bits_and_bytes, std::size_t bytes, bool is_complete)
{
  Bit_decoder decoder(bits_and_bytes.bytes.data(), bytes, is_complete);
  Bit_model models[3];
  for(std::size_t i = 0; i < bits_and_bytes.bits.size(); ++i)
  {
    const bool bit = i % 5 == 4 ? decoder.get() : decoder.get(models[i % 3]);
    if(decoder.is_exhausted())
      return i;
    EXPECT_EQ(bit, bits_and_bytes.bits[i]);
  }
  return bits_and_bytes.bits.size();
}

TEST(Arithmetic_coding, decodes_encoded_bits)
{
  for(const double probability : {0., 0.001, 0.2, 0.5, 0.97, 1.})
    for(const std::size_t number : {0u, 1u, 7u, 100u, 20000u})
    {
      const Bits bits = random_bits(number, probability, unsigned(number));
      EXPECT_EQ(count_decoded_bits(bits, bits.bytes.size(), true), number);
    }
}

// A longer prefix decodes at least as many bits.
TEST(Arithmetic_coding, prefixes_decode_without_wrong_bits)
{
  const Bits bits = random_bits(2000, 0.2, 1);
  std::size_t last = 0;
  for(std::size_t size = 0; size <= bits.bytes.size(); ++size)
  {
    const std::size_t number_of_decoded_bits = count_decoded_bits(bits, size, false);
    EXPECT_GE(number_of_decoded_bits, last);
    last = number_of_decoded_bits;
  }
  EXPECT_GT(last, 1900u); // the last bits depend on the missing end of the interval
}

TEST(Arithmetic_coding, size_is_close_to_entropy)
{
  for(const double p : {0.01, 0.1, 0.3})
  {
    std::mt19937 random(1);
    std::bernoulli_distribution distribution(p);
    Bit_encoder encoder;
    Bit_model model;
    const int n = 100000;
    for(int i = 0; i < n; ++i)
      encoder.put(distribution(random), model);
    const double entropy = -(p * std::log2(p) + (1. - p) * std::log2(1. - p));
    // The uncertainty of the mean of 60 bits costs about 1 / (2 * 60 ln 2) bits per bit.
    EXPECT_LT(8. * double(encoder.finish().size()) / n, entropy + 0.015);
  }
}

TEST(Arithmetic_coding, terminates_on_random_bytes)
{
  std::mt19937 random(1);
  for(int i = 0; i < 100; ++i)
  {
    std::vector<std::uint8_t> bytes;
    for(unsigned k = random() % 50; k > 0; --k)
      bytes.push_back(std::uint8_t(random()));
    Bit_decoder decoder(bytes.data(), bytes.size(), false);
    Bit_model model;
    std::size_t number_of_decoded_bits = 0;
    for(; !decoder.is_exhausted() && number_of_decoded_bits < 100000; ++number_of_decoded_bits)
      decoder.get(model);
    EXPECT_LT(number_of_decoded_bits, 100000u);
  }
}

} // namespace arithmetic_coding_test
