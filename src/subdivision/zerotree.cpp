// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/zerotree.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "subdivision/arithmetic_coding.h"

#include <boost/crc.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr char magic[] = {'G', 'P', 'W', '1'};
constexpr unsigned max_planes = 48, max_number_of_levels = 15;
constexpr std::size_t max_channels = 16;

// ------------------------------------------------------------------------------------- bytes

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

std::uint32_t checksum(const std::uint8_t* bytes, std::size_t size)
{
  boost::crc_32_type crc;
  crc.process_bytes(bytes, size);
  return crc.checksum();
}

void append_packet(Bytes& bytes, const Bytes& packet)
{
  append(bytes, packet.size(), 4);
  append(bytes, checksum(packet.data(), packet.size()), 4);
  bytes.insert(bytes.end(), packet.begin(), packet.end());
}

struct Reader
{
  const std::uint8_t *next, *end;

  std::size_t remaining_size() const { return std::size_t(end - next); }
  std::uint64_t read_integer(int size)
  {
    if(remaining_size() < std::size_t(size))
      throw Invalid_argument_error("The stream of wavelets ends in its header.");
    std::uint64_t result = 0;
    for(int i = 0; i < size; ++i)
      result |= std::uint64_t(*next++) << (8 * i);
    return result;
  }
  double read_double()
  {
    const std::uint64_t bits = read_integer(8);
    double result;
    std::memcpy(&result, &bits, sizeof result);
    return result;
  }
};

struct Packet
{
  const std::uint8_t* bytes = nullptr;
  std::size_t size = 0;
  bool is_complete = false, is_damaged = false;
};

// What is there of the next one.
Packet read_packet(Reader& reader)
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

// ------------------------------------------------------------------------------------ header

struct Header
{
  std::size_t channels = 0, vertices = 0, triangles = 0;
  unsigned levels = 0, planes = 0, tangent_shift = 0;
  Prediction prediction = Prediction::butterfly;
  bool use_update = false, is_in_frames = false;
  int exponent = 0;           // all numbers are below 2^exponent
  std::vector<double> origin; // #channels: what the values of the base mesh are counted from
};

Bytes encode_header(const Header& h)
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

Header read_header(Reader& reader)
{
  const std::uint8_t* const begin = reader.next;
  for(const char letter : magic)
    if(reader.read_integer(1) != std::uint8_t(letter))
      throw Invalid_argument_error("The bytes are no stream of wavelets.");
  Header h;
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
  // Numbers stay finite: below 2^exponent, of a few hundred of them each.
  const bool is_valid =
      reader.read_integer(4) == expected_checksum && h.channels > 0 && h.channels <= max_channels &&
      flags < 8 && h.levels <= max_number_of_levels && h.planes > 0 && h.planes <= max_planes &&
      h.tangent_shift <= max_planes && std::abs(h.exponent) < 960 &&
      (!h.is_in_frames || h.channels == 3) &&
      std::all_of(h.origin.begin(), h.origin.end(), [](double x) { return std::abs(x) < 1e300; });
  if(!is_valid)
    throw Invalid_argument_error("The header of the stream of wavelets is damaged.");
  return h;
}

// ------------------------------------------------------------------------------ base triangles

unsigned bit_width(std::size_t number)
{
  unsigned result = 0;
  for(; number > 0; number >>= 1)
    ++result;
  return result;
}

// A corner is the next vertex that none has named yet, or one of those before it.
Bytes encode_triangles(const std::vector<Triangle>& triangles, std::size_t vertices)
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
        for(unsigned bit = bit_width(vertices - 1); bit-- > 0;)
          encoder.put(((v >> bit) & 1) != 0);
    }
  return encoder.finish();
}

std::vector<Triangle> decode_triangles(const Packet& packet, const Header& header)
{
  const char* const message = "The base mesh of the stream of wavelets is damaged or incomplete.";
  // Each corner takes a bit.
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

// ---------------------------------------------------------------------------------------- trees

// Edges as the details of their midpoints.
struct Zerotrees
{
  std::vector<std::array<Index, 4>> children;  // #vertices: of those of the coarsest level none
  std::vector<std::array<Index, 4>> neighbors; // #vertices: the other edges of both triangles
  std::vector<Index> parent;                   // #vertices, or none
  std::vector<bool> is_root;                   // #vertices: base vertices and base edges
};

Zerotrees build_zerotrees(const Subdivision& s)
{
  const std::size_t n = s.number_of_vertices();
  Zerotrees result;
  result.children.assign(n, {none, none, none, none});
  result.neighbors.assign(n, {none, none, none, none});
  result.parent.assign(n, none);
  result.is_root.assign(n, false);
  std::fill_n(result.is_root.begin(), s.levels.front().number_of_vertices, true);
  for(std::size_t j = 0; j + 1 < s.levels.size(); ++j)
  {
    const Subdivision::Level &level = s.levels[j], &next = s.levels[j + 1];
    for(Index h = 0; h < level.twin.size(); ++h)
    {
      const Index m = level.midpoint[h], k = h % 3;
      const bool is_first = is_edge_representative(level, h);
      if(j == 0)
        result.is_root[m] = true;
      auto& neighbors = result.neighbors[m];
      neighbors[is_first ? 0 : 2] = level.midpoint[next_halfedge(h)];
      neighbors[is_first ? 1 : 3] = level.midpoint[previous_halfedge(h)];
      if(next.midpoint.empty())
        continue;
      // Side k of each child at a corner is a half of this one, or parallel to it.
      auto& children = result.children[m];
      const auto child_edge = [&](Index child)
      { return next.midpoint[3 * (4 * (h / 3) + child % 3) + k]; };
      if(is_first)
      {
        children[0] = child_edge(k);
        children[1] = child_edge(k + 1);
        children[2] = child_edge(k + 2);
      }
      else
        children[3] = child_edge(k + 2);
      for(const Index child : children)
        if(child != none)
          result.parent[child] = m;
    }
  }
  return result;
}

// ---------------------------------------------------------------------------------------- planes

// What encoder and decoder both know of one channel.
struct Channel_state
{
  std::vector<std::uint8_t>
      significance; // #vertices: 0 as long as it is not significant, then 1 and more
  std::vector<std::uint8_t> has_significant_descendant; // #vertices: whether a descendant is
  std::vector<std::uint8_t> is_coded; // #vertices: whether it is told about at all
  std::vector<Bit_model> significance_models, descendant_models, refinement_models;
};

// One plane after the other, by a coder: a struct with bit(Bit_model&, known) and sign(known), of which
// the encoder returns what it knows, the decoder what it reads.
class Bitplane_coder
{
public:
  Bitplane_coder(const Subdivision& subdivision, std::size_t channels)
      : m_zerotrees(build_zerotrees(subdivision)), m_channels(channels)
  {
    const std::size_t n = subdivision.number_of_vertices();
    for(Channel_state& state : m_channels)
    {
      state.significance.assign(n, 0);
      state.has_significant_descendant.assign(n, 0);
      state.is_coded.assign(m_zerotrees.is_root.begin(), m_zerotrees.is_root.end());
      state.significance_models.resize(4 * 6 * 3 * 2);
      state.descendant_models.resize(4 * 5 * 3);
      state.refinement_models.resize(3);
    }
  }

  const Zerotrees& zerotrees() const { return m_zerotrees; }

  // False when the coder is at its end.
  template <typename Coder>
  bool code_plane(Coder& coder)
  {
    const Index n = Index(m_zerotrees.parent.size());
    for(Index v = 0; v < n; ++v)
      for(std::size_t c = 0; c < m_channels.size(); ++c)
        if(m_channels[c].is_coded[v] && !code_coefficient(coder, v, c))
          return false;
    for(Channel_state& state : m_channels)
      for(std::uint8_t& significance : state.significance)
        if(significance > 0 && significance < 3)
          ++significance;
    return true;
  }

private:
  template <typename Coder>
  bool code_coefficient(Coder& coder, Index v, std::size_t c)
  {
    Channel_state& state = m_channels[c];
    if(state.significance[v] == 0)
    {
      const bool is_significant = coder.bit(state.significance_models[significance_context(v, c)],
                                            [&] { return coder.is_significant(v, c); });
      if(coder.is_at_end())
        return false;
      if(is_significant)
      {
        const bool is_negative = coder.sign([&] { return coder.is_negative(v, c); });
        if(coder.is_at_end())
          return false;
        state.significance[v] = 1;
        coder.begin(v, c, is_negative);
      }
    }
    else
    {
      const bool is_set = coder.bit(state.refinement_models[state.significance[v] - 1],
                                    [&] { return coder.is_set(v, c); });
      if(coder.is_at_end())
        return false;
      coder.refine(v, c, is_set);
    }
    if(m_zerotrees.children[v][0] == none || state.has_significant_descendant[v])
      return true;
    const bool has_significant_descendant =
        coder.bit(state.descendant_models[descendant_context(v, c)],
                  [&] { return coder.has_significant_descendant(v, c); });
    if(coder.is_at_end())
      return false;
    if(has_significant_descendant)
    {
      state.has_significant_descendant[v] = 1;
      for(const Index child : m_zerotrees.children[v])
        if(child != none)
          state.is_coded[child] = 1;
    }
    return true;
  }

  // Large numbers have large parents and neighbours, and large numbers in the other channels.
  std::size_t significance_context(Index v, std::size_t c) const
  {
    const Channel_state& state = m_channels[c];
    const Index parent = m_zerotrees.parent[v];
    const std::size_t parent_significance = parent == none ? 0 : state.significance[parent];
    std::size_t neighbor_significance = 0, other_channels = 0;
    for(const Index w : m_zerotrees.neighbors[v])
      if(w != none)
        neighbor_significance += state.significance[w];
    for(const Channel_state& other : m_channels)
      if(&other != &state)
        other_channels += other.significance[v] > 0;
    const bool is_base = parent == none;
    return ((std::min<std::size_t>((neighbor_significance + 1) / 2, 5) * 4 + parent_significance) *
                3 +
            std::min<std::size_t>(other_channels, 2)) *
               2 +
           is_base;
  }

  std::size_t descendant_context(Index v, std::size_t c) const
  {
    const Channel_state& state = m_channels[c];
    std::size_t neighbor_significance = 0, other_channels = 0;
    for(const Index w : m_zerotrees.neighbors[v])
      if(w != none)
        neighbor_significance += state.has_significant_descendant[w];
    for(const Channel_state& other : m_channels)
      if(&other != &state)
        other_channels += other.has_significant_descendant[v];
    return (neighbor_significance * 4 + state.significance[v]) * 3 +
           std::min<std::size_t>(other_channels, 2);
  }

  Zerotrees m_zerotrees;
  std::vector<Channel_state> m_channels;
};

// By what numbers are multiplied before they are cut into planes.
std::vector<double> scale_factors(const Subdivision& s, const Header& header)
{
  const std::vector<double> norms = detail_norms(s);
  const double tangent_factor = std::ldexp(1., -int(header.tangent_shift));
  std::vector<double> result;
  for(Index v = 0; v < norms.size(); ++v)
    for(std::size_t c = 0; c < header.channels; ++c)
    {
      const bool is_tangent =
          header.is_in_frames && c > 0 && v >= s.levels.front().number_of_vertices;
      result.push_back(is_tangent ? tangent_factor * norms[v] : norms[v]);
    }
  return result;
}

struct Plane_encoder
{
  const std::vector<std::uint64_t>& magnitude;      // #vertices * channels
  const std::vector<std::uint64_t>& max_descendant; // the same: of all descendants
  const std::vector<bool>& negative;
  std::size_t channels;
  unsigned plane = 0;
  Bit_encoder bits{};

  template <typename Get_value>
  bool bit(Bit_model& model, const Get_value& get_value)
  {
    const bool result = get_value();
    bits.put(result, model);
    return result;
  }
  template <typename Get_value>
  bool sign(const Get_value& get_value)
  {
    const bool result = get_value();
    bits.put(result);
    return result;
  }
  bool is_significant(Index v, std::size_t c) const
  {
    return magnitude[channels * v + c] >> plane != 0;
  }
  bool is_negative(Index v, std::size_t c) const { return negative[channels * v + c]; }
  bool is_set(Index v, std::size_t c) const
  {
    return ((magnitude[channels * v + c] >> plane) & 1) != 0;
  }
  bool has_significant_descendant(Index v, std::size_t c) const
  {
    return max_descendant[channels * v + c] >> plane != 0;
  }
  bool is_at_end() const { return false; }
  void begin(Index, std::size_t, bool) {}
  void refine(Index, std::size_t, bool) {}
};

struct Plane_decoder
{
  std::vector<double>& values; // in the middle of what each may be, in units of the first plane
  std::size_t channels;
  double unit;
  Bit_decoder bits;

  template <typename Get_value>
  bool bit(Bit_model& model, const Get_value&)
  {
    return bits.get(model);
  }
  template <typename Get_value>
  bool sign(const Get_value&)
  {
    return bits.get();
  }
  // Never called: the encoder's knowledge.
  bool is_significant(Index, std::size_t) const { return false; }
  bool is_negative(Index, std::size_t) const { return false; }
  bool is_set(Index, std::size_t) const { return false; }
  bool has_significant_descendant(Index, std::size_t) const { return false; }
  bool is_at_end() const { return bits.is_exhausted(); }
  void begin(Index v, std::size_t c, bool is_negative)
  {
    values[channels * v + c] = (is_negative ? -1.5 : 1.5) * unit;
  }
  void refine(Index v, std::size_t c, bool is_set)
  {
    double& value = values[channels * v + c];
    value += std::copysign(0.5 * unit, is_set == (value > 0.) ? 1. : -1.);
  }
};

} // namespace

std::vector<std::uint8_t> encode(const Subdivision& s, const Wavelet_signal& signal,
                                 unsigned planes, unsigned tangent_shift,
                                 std::size_t max_number_of_bytes)
{
  const std::size_t n = s.number_of_vertices(), channels = signal.channels;
  const Index number_of_base_vertices = s.levels.front().number_of_vertices;
  if(n == 0 || channels == 0 || channels > max_channels)
    throw Invalid_argument_error("There are no values to encode, or too many for each vertex.");
  if(planes == 0 || planes > max_planes || tangent_shift > max_planes)
    throw Invalid_argument_error("A stream of wavelets has 1 to 48 bit planes.");
  if(signal.is_in_frames && channels != 3)
    throw Invalid_argument_error("Local frames are for three channels.");

  Header header;
  header.channels = channels;
  header.vertices = number_of_base_vertices;
  header.triangles = s.levels.front().triangles.size();
  header.levels = unsigned(s.levels.size() - 1);
  header.planes = planes;
  header.tangent_shift = tangent_shift;
  header.prediction = signal.prediction;
  header.use_update = signal.use_update;
  header.is_in_frames = signal.is_in_frames;

  std::vector<double> values = signal.values;
  for(std::size_t c = 0; c < channels; ++c)
  {
    double low = infinity, high = -infinity;
    for(Index v = 0; v < number_of_base_vertices; ++v)
    {
      low = std::min(low, values[channels * v + c]);
      high = std::max(high, values[channels * v + c]);
    }
    header.origin.push_back(0.5 * low + 0.5 * high);
    for(Index v = 0; v < number_of_base_vertices; ++v)
      values[channels * v + c] -= header.origin[c];
  }
  const std::vector<double> factor = scale_factors(s, header);
  double max_magnitude = 0.;
  for(std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] *= factor[i];
    if(!(std::abs(values[i]) < 1e280))
      throw Invalid_argument_error("A value is not finite, or too large to be encoded.");
    max_magnitude = std::max(max_magnitude, std::abs(values[i]));
  }
  header.exponent = max_magnitude > 1e-280 ? std::ilogb(max_magnitude) + 1 : -930;

  std::vector<std::uint64_t> magnitude, max_descendant(values.size(), 0);
  std::vector<bool> negative;
  for(const double value : values)
  {
    magnitude.push_back(std::uint64_t(std::ldexp(std::abs(value), int(planes) - header.exponent)));
    negative.push_back(value < 0.);
  }
  Bitplane_coder bitplane_coder(s, channels);
  // Children come after their parents.
  for(std::size_t v = n; v-- > 0;)
    if(const Index parent = bitplane_coder.zerotrees().parent[v]; parent != none)
      for(std::size_t c = 0; c < channels; ++c)
        max_descendant[channels * parent + c] =
            std::max({max_descendant[channels * parent + c], max_descendant[channels * v + c],
                      magnitude[channels * v + c]});

  Bytes result = encode_header(header);
  append_packet(result, encode_triangles(s.levels.front().triangles, number_of_base_vertices));
  for(unsigned plane = planes; plane-- > 0 && result.size() < max_number_of_bytes;)
  {
    Plane_encoder coder{magnitude, max_descendant, negative, channels, plane};
    bitplane_coder.code_plane(coder);
    append_packet(result, coder.bits.finish());
  }
  if(result.size() > max_number_of_bytes)
    result.resize(max_number_of_bytes);
  return result;
}

Decoded_wavelets decode(const std::uint8_t* bytes, std::size_t size,
                        std::size_t max_number_of_vertices)
{
  Reader reader{bytes, bytes + size};
  const Header header = read_header(reader);
  // A triangle of the finest level has no more than three vertices of its own.
  const double number_of_finest_triangles =
      std::ldexp(double(header.triangles), 2 * int(header.levels));
  if(double(header.vertices) > double(max_number_of_vertices) ||
     number_of_finest_triangles > 2.5 * double(max_number_of_vertices))
    throw Invalid_argument_error("The stream of wavelets has more vertices than are allowed.");
  if(header.vertices == 0)
    throw Invalid_argument_error("The stream of wavelets has no vertices.");
  Decoded_wavelets result;
  result.subdivision = std::make_shared<Subdivision>(subdivide(
      decode_triangles(read_packet(reader), header), Index(header.vertices), header.levels));
  const Subdivision& s = *result.subdivision;
  if(s.number_of_vertices() > max_number_of_vertices)
    throw Invalid_argument_error("The stream of wavelets has more vertices than are allowed.");

  Wavelet_signal& signal = result.signal;
  signal.channels = header.channels;
  signal.prediction = header.prediction;
  signal.use_update = header.use_update;
  signal.is_in_frames = header.is_in_frames;
  signal.values.assign(header.channels * s.number_of_vertices(), 0.);
  result.total_planes = header.planes;
  Bitplane_coder bitplane_coder(s, header.channels);
  for(unsigned plane = 0; plane < header.planes; ++plane)
  {
    const Packet packet = read_packet(reader);
    result.is_damaged = packet.is_damaged;
    if(packet.bytes == nullptr || packet.is_damaged)
      break;
    Plane_decoder coder{signal.values, header.channels, std::ldexp(1., -int(plane) - 1),
                        Bit_decoder(packet.bytes, packet.size, packet.is_complete)};
    if(!bitplane_coder.code_plane(coder) || !packet.is_complete)
      break;
    ++result.planes;
  }
  const std::vector<double> factor = scale_factors(s, header);
  for(std::size_t i = 0; i < signal.values.size(); ++i)
    signal.values[i] = std::ldexp(signal.values[i], header.exponent) / factor[i];
  for(Index v = 0; v < s.levels.front().number_of_vertices; ++v)
    for(std::size_t c = 0; c < header.channels; ++c)
      signal.values[header.channels * v + c] += header.origin[c];
  return result;
}

std::vector<double> decoded_values(const Decoded_wavelets& decoding)
{
  const Wavelet_signal& signal = decoding.signal;
  std::vector<double> result = signal.values;
  Lifting(decoding.subdivision, signal.prediction, signal.use_update)
      .synthesize(result, signal.channels, signal.is_in_frames);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
