// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which picture shows best that samples gather where a picture varies?  Rings, as a grey PNG file.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

std::string big_endian(std::uint32_t x)
{
  return {static_cast<char>(x >> 24), static_cast<char>(x >> 16), static_cast<char>(x >> 8),
          static_cast<char>(x)};
}

// The length of a part, its name and bytes, and their remainder.
std::string chunk(const std::string& bytes)
{
  std::uint32_t remainder = ~0u;
  for(const unsigned char byte : bytes)
  {
    remainder ^= byte;
    for(int bit = 0; bit < 8; ++bit)
      remainder = remainder >> 1 ^ (remainder & 1 ? 0xedb88320u : 0u);
  }
  return big_endian(static_cast<std::uint32_t>(bytes.size() - 4)) + bytes + big_endian(~remainder);
}

int main(int argc, char* argv[])
{
  constexpr int size = 200; // so that all pixels fit into one block, which is not compressed
  std::string rows;
  for(int j = 0; j < size; ++j)
  {
    rows += '\0';
    for(int i = 0; i < size; ++i)
      rows += std::fmod(std::hypot(i - size / 2, j - size / 2), 50.) < 25. ? '\xff' : '\0';
  }
  std::uint32_t a = 1, b = 0;
  for(const unsigned char byte : rows)
  {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  const auto n = static_cast<std::uint16_t>(rows.size());
  const std::string length = {static_cast<char>(n & 255), static_cast<char>(n >> 8),
                              static_cast<char>(~n & 255), static_cast<char>(~n >> 8 & 255)};
  std::ofstream file(argc > 1 ? argv[1] : "rings.png", std::ios::binary);
  file << "\x89PNG\r\n\x1a\n"
       << chunk("IHDR" + big_endian(size) + big_endian(size) + std::string("\x08\0\0\0\0", 5))
       << chunk("IDAT\x78\x01\x01" + length + rows + big_endian(b << 16 | a)) << chunk("IEND");
  return file ? EXIT_SUCCESS : EXIT_FAILURE;
}
