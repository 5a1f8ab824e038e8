// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/zerotree.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "subdivision/arithmetic_coding.h"
#include "subdivision/wavelet_stream.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// ---------------------------------------------------------------------------------------- trees

// The trees of coefficients. The coefficient of an edge is the detail of its midpoint.
struct Zerotrees
{
  std::vector<std::array<Index, 4>> children;  // #vertices: none for vertices of the base mesh
  std::vector<std::array<Index, 4>> neighbors; // #vertices: the other edges of both triangles
  std::vector<Index> parent;                   // #vertices: none for roots
  std::vector<bool> is_root; // #vertices: true for vertices and edges of the base mesh
};

// Computes the trees of a subdivision. O(n).
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
      // Edge k of each corner child is a half of this edge, or parallel to it.
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

// The state of one channel, which is the same in encoder and decoder.
struct Channel_state
{
  std::vector<std::uint8_t>
      significance; // #vertices: 0 if not significant, then 1 to 3, growing with each plane
  std::vector<std::uint8_t>
      has_significant_descendant; // #vertices: true if a descendant is significant
  std::vector<std::uint8_t>
      is_coded; // #vertices: true for roots and if the parent has significant descendants
  std::vector<Bit_model> significance_models, descendant_models, refinement_models;
};

// Codes bit planes. The template parameter Coder encodes or decodes single bits: its functions
// bit(model, get_value) and sign(get_value) return the bit. The encoder calls get_value() and
// writes the bit; the decoder reads it.
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

  // Codes the next plane. Returns false if a decoder has no more bits.
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
  // Codes one bit of the coefficient of vertex v in channel c, and its sign if it becomes
  // significant. Then codes whether it has significant descendants. Returns false if a decoder
  // has no more bits.
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

  // Magnitudes of a coefficient, its parent, its neighbors and the other channels are correlated.
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

  // Uses the descendants of the neighbors, the significance of the coefficient, and the descendants
  // in the other channels.
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

// Returns the factors (#vertices * channels) that are applied to coefficients before quantization.
std::vector<double> scale_factors(const Subdivision& s, const Stream_header& header)
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

// Coefficients as integers below 2^planes: #vertices * channels.
struct Quantized_coefficients
{
  std::vector<std::uint64_t> magnitude;
  std::vector<std::uint64_t> max_descendant; // the largest magnitude of all descendants
  std::vector<bool> negative;
};

// Encodes the bits of one plane.
struct Plane_encoder
{
  const Quantized_coefficients& coefficients;
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
    return coefficients.magnitude[channels * v + c] >> plane != 0;
  }
  bool is_negative(Index v, std::size_t c) const { return coefficients.negative[channels * v + c]; }
  bool is_set(Index v, std::size_t c) const
  {
    return ((coefficients.magnitude[channels * v + c] >> plane) & 1) != 0;
  }
  bool has_significant_descendant(Index v, std::size_t c) const
  {
    return coefficients.max_descendant[channels * v + c] >> plane != 0;
  }
  bool is_at_end() const { return false; }
  void begin(Index, std::size_t, bool) {}
  void refine(Index, std::size_t, bool) {}
};

// Decodes the bits of one plane.
struct Plane_decoder
{
  std::vector<double>& values; // midpoints of the intervals known so far, divided by 2^exponent
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
  // Required by Bitplane_coder, never called.
  bool is_significant(Index, std::size_t) const { return false; }
  bool is_negative(Index, std::size_t) const { return false; }
  bool is_set(Index, std::size_t) const { return false; }
  bool has_significant_descendant(Index, std::size_t) const { return false; }
  bool is_at_end() const { return bits.is_exhausted(); }
  void begin(Index v, std::size_t c, bool is_negative)
  {
    values[channels * v + c] = (is_negative ? -1.5 : 1.5) * unit;
  }
  // Moves the value to the midpoint of the half of its interval that the bit selects.
  void refine(Index v, std::size_t c, bool is_set)
  {
    double& value = values[channels * v + c];
    value += std::copysign(0.5 * unit, is_set == (value > 0.) ? 1. : -1.);
  }
};

Stream_header make_header(const Subdivision& s, const Wavelet_signal& signal, unsigned planes,
                          unsigned tangent_shift)
{
  Stream_header header;
  header.channels = signal.channels;
  header.vertices = s.levels.front().number_of_vertices;
  header.triangles = s.levels.front().triangles.size();
  header.levels = unsigned(s.levels.size() - 1);
  header.planes = planes;
  header.tangent_shift = tangent_shift;
  header.prediction = signal.prediction;
  header.use_update = signal.use_update;
  header.is_in_frames = signal.is_in_frames;
  return header;
}

// Returns the scaled coefficients (#vertices * channels). The values of the base vertices are
// centered first. Sets the origin and the exponent of the header.
std::vector<double> scaled_coefficients(const Subdivision& s, const Wavelet_signal& signal,
                                        Stream_header& header)
{
  const std::size_t channels = header.channels;
  std::vector<double> values = signal.values;
  for(std::size_t c = 0; c < channels; ++c)
  {
    double low = infinity, high = -infinity;
    for(Index v = 0; v < header.vertices; ++v)
    {
      low = std::min(low, values[channels * v + c]);
      high = std::max(high, values[channels * v + c]);
    }
    header.origin.push_back(0.5 * low + 0.5 * high);
    for(Index v = 0; v < header.vertices; ++v)
      values[channels * v + c] -= header.origin[c];
  }
  const std::vector<double> factor = scale_factors(s, header);
  double max_magnitude = 0.;
  for(std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] *= factor[i];
    if(!(std::abs(values[i]) < 1e280))
      throw Invalid_argument_error("A value is not finite or exceeds 1e280.");
    max_magnitude = std::max(max_magnitude, std::abs(values[i]));
  }
  header.exponent = max_magnitude > 1e-280 ? std::ilogb(max_magnitude) + 1 : -930;
  return values;
}

// Rounds the scaled coefficients toward zero to integers, and computes the maxima of all subtrees.
Quantized_coefficients quantize(const std::vector<double>& values, const Stream_header& header,
                                const Zerotrees& zerotrees)
{
  const std::size_t channels = header.channels;
  Quantized_coefficients result;
  for(const double value : values)
  {
    result.magnitude.push_back(
        std::uint64_t(std::ldexp(std::abs(value), int(header.planes) - header.exponent)));
    result.negative.push_back(value < 0.);
  }
  // Children have larger indices than their parents.
  result.max_descendant.assign(values.size(), 0);
  for(std::size_t v = zerotrees.parent.size(); v-- > 0;)
    if(const Index parent = zerotrees.parent[v]; parent != none)
      for(std::size_t c = 0; c < channels; ++c)
        result.max_descendant[channels * parent + c] =
            std::max({result.max_descendant[channels * parent + c],
                      result.max_descendant[channels * v + c], result.magnitude[channels * v + c]});
  return result;
}

} // namespace

std::vector<std::uint8_t> encode(const Subdivision& s, const Wavelet_signal& signal,
                                 unsigned planes, unsigned tangent_shift,
                                 std::size_t max_number_of_bytes)
{
  const std::size_t channels = signal.channels;
  if(s.number_of_vertices() == 0 || channels == 0 || channels > max_channels)
    throw Invalid_argument_error(
        "The number of vertices must be positive, and the number of channels between 1 and 16.");
  if(planes == 0 || planes > max_planes || tangent_shift > max_planes)
    throw Invalid_argument_error(
        "The number of bit planes must be 1 to 48, and the tangent shift at most 48.");
  if(signal.is_in_frames && channels != 3)
    throw Invalid_argument_error("Local frames require three channels.");

  Stream_header header = make_header(s, signal, planes, tangent_shift);
  const std::vector<double> values = scaled_coefficients(s, signal, header);
  Bitplane_coder bitplane_coder(s, channels);
  const Quantized_coefficients coefficients = quantize(values, header, bitplane_coder.zerotrees());

  Bytes result = encode_header(header);
  append_packet(result, encode_triangles(s.levels.front().triangles, header.vertices));
  for(unsigned plane = planes; plane-- > 0 && result.size() < max_number_of_bytes;)
  {
    Plane_encoder coder{coefficients, channels, plane};
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
  Stream_reader reader{bytes, bytes + size};
  const Stream_header header = read_header(reader);
  // Reject sizes before memory is allocated. The number of finest triangles is at most about twice
  // the number of vertices.
  const double number_of_finest_triangles =
      std::ldexp(double(header.triangles), 2 * int(header.levels));
  if(double(header.vertices) > double(max_number_of_vertices) ||
     number_of_finest_triangles > 2.5 * double(max_number_of_vertices))
    throw Invalid_argument_error("The wavelet stream has more vertices than are allowed.");
  if(header.vertices == 0)
    throw Invalid_argument_error("The wavelet stream has no vertices.");
  Decoded_wavelets result;
  result.subdivision = std::make_shared<Subdivision>(subdivide(
      decode_triangles(read_packet(reader), header), Index(header.vertices), header.levels));
  const Subdivision& s = *result.subdivision;
  if(s.number_of_vertices() > max_number_of_vertices)
    throw Invalid_argument_error("The wavelet stream has more vertices than are allowed.");

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
