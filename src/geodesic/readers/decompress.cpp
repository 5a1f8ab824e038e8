// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/decompress.h"

#include "readers/Scanner.h"

#include <zlib.h>
#ifdef GEODESIC_PROCESSING_HAS_LZ4
#  include <lz4.h>
#endif

#include <algorithm>
#include <limits>

namespace program {

namespace {

// A stream of zlib, which is freed at the end.
class Stream
{
public:
  explicit Stream(const std::string& name)
  {
    constexpr int detect_zlib_and_gzip = 32 + MAX_WBITS;
    if(inflateInit2(&m_stream, detect_zlib_and_gzip) != Z_OK)
      fail(name, "it cannot be decompressed");
  }
  ~Stream() { inflateEnd(&m_stream); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  z_stream* operator->() { return &m_stream; }
  z_stream* get() { return &m_stream; }

private:
  z_stream m_stream{};
};

constexpr std::size_t chunk_size = std::size_t{1} << 20;

void check_expansion(std::size_t size, std::size_t compressed_size, const std::string& name)
{
  if(size > max_compression_ratio * compressed_size)
    fail(name, "its compressed data expand to more than 1,000 times their length");
}

} // namespace

std::string inflate(std::string_view bytes, const std::string& name)
{
  const std::size_t compressed_size = bytes.size();
  // VTP files have many small blocks, for which a long buffer would take longer than their content.
  const std::size_t step = std::min(8 * compressed_size + 64, chunk_size);
  Stream stream(name);
  std::string result;
  std::size_t size = 0; // of the result so far
  for(;;)
  {
    // The counts of zlib have 32 bits, so long data are passed in chunks.
    if(stream->avail_in == 0)
    {
      const std::size_t length = std::min(bytes.size(), chunk_size);
      stream->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      stream->avail_in = static_cast<uInt>(length);
      bytes.remove_prefix(length);
    }
    if(result.size() < size + step)
      result.resize(std::max(2 * result.size(), size + step));
    stream->next_out = reinterpret_cast<Bytef*>(result.data() + size);
    stream->avail_out = static_cast<uInt>(step);
    const int status = ::inflate(stream.get(), Z_NO_FLUSH);
    size += step - stream->avail_out;
    check_expansion(size, compressed_size, name);
    const bool is_at_end = stream->avail_in == 0 && bytes.empty();
    if(status == Z_STREAM_END && is_at_end)
      break;
    if(status == Z_BUF_ERROR && is_at_end)
      fail(name, "its compressed data are truncated");
    // Another member of a gzip file can follow.
    if(status == Z_STREAM_END ? inflateReset(stream.get()) != Z_OK
                              : status != Z_OK && status != Z_BUF_ERROR)
      fail(name, "its compressed data are invalid");
  }
  result.resize(size);
  return result;
}

#ifdef GEODESIC_PROCESSING_HAS_LZ4
std::string decompress_lz4(std::string_view bytes, std::size_t size, const std::string& name)
{
  constexpr std::size_t max_int = (std::numeric_limits<int>::max)();
  check_expansion(size, bytes.size(), name);
  if(bytes.size() > max_int || size > max_int)
    fail(name, "a compressed block is too long");
  std::string result(size, '\0');
  if(LZ4_decompress_safe(bytes.data(), result.data(), static_cast<int>(bytes.size()),
                         static_cast<int>(size)) != static_cast<int>(size))
    fail(name, "its compressed data are invalid");
  return result;
}
#else
std::string decompress_lz4(std::string_view, std::size_t, const std::string& name)
{
  fail(name, "its data are compressed by LZ4, which this program was built without");
}
#endif

} // namespace program
