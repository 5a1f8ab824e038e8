// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_DECODE_WAVELETS_H
#define CGAL_GEODESIC_PROCESSING_DECODE_WAVELETS_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/subdivision/zerotree.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingWavelets
/// how much of a stream was read.
struct Wavelet_stream
{
  std::size_t number_of_levels = 0;
  std::size_t number_of_bit_planes = 0; ///< that were read as a whole
  bool is_complete = false;             ///< these are all
  bool is_damaged = false; ///< what follows them is not what was written, and was left out
};

/// \ingroup PkgGeodesicProcessingWavelets
///
/// adds the mesh that a stream of `Subdivision_wavelet::encode()` holds, or as good a one as a prefix of it
/// makes. Vertices and faces are in the order of levels, so that the mesh can be analyzed again.
///
/// Bytes that were changed are noticed by checksums: what stands before them counts.  Only within a bit plane that is cut
/// off can they pass unnoticed; vertices are finite all the same.
///
/// \param bytes a contiguous range of `std::uint8_t`
/// \param output a model of `MutableFaceGraph`
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number_of_vertices}
///     \cgalParamDescription{more are refused, since a few bytes can ask for any number of them}
///     \cgalParamDefault{2<SUP>24</SUP>} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error when the bytes are no such stream of places, when they end before the base mesh
///         does or are damaged there, and when there are too many vertices; the output is untouched
///
/// O(n) for each bit plane.
template <typename ByteRange, typename OutputMesh,
          typename NamedParameters = internal::Default_parameters>
Wavelet_stream decode_wavelets(const ByteRange& bytes, OutputMesh& output,
                               const NamedParameters& np = NamedParameters())
{
  using Vertex = typename boost::graph_traits<OutputMesh>::vertex_descriptor;
  const internal::Decoded_wavelets decoded = internal::decode(
      std::data(bytes), std::size(bytes),
      internal::parameter(np, internal_np::maximum_number_of_vertices, std::size_t(1) << 24));
  const internal::Wavelet_signal& signal = decoded.signal;
  if(signal.channels != 3)
    throw Invalid_argument_error("The stream of wavelets has no places of vertices.");
  if(!internal::is_halfedge_mesh(decoded.subdivision->levels.front()))
    throw Invalid_argument_error("The surface of the stream touches itself where no mesh can.");
  const std::vector<double> values = internal::decoded_values(decoded);

  const auto points = get(CGAL::vertex_point, output);
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  std::vector<Vertex> vertices;
  for(std::size_t i = 0; i < values.size(); i += 3)
  {
    vertices.push_back(add_vertex(output));
    put(points, vertices.back(), Point(values[i], values[i + 1], values[i + 2]));
  }
  // One by one: at once they could not meet in a vertex alone.
  for(const auto& t : decoded.subdivision->finest().triangles)
    CGAL::Euler::add_face(std::array<Vertex, 3>{vertices[t[0]], vertices[t[1]], vertices[t[2]]},
                          output);

  Wavelet_stream result;
  result.number_of_levels = decoded.subdivision->levels.size() - 1;
  result.number_of_bit_planes = decoded.planes;
  result.is_complete = decoded.planes == decoded.total_planes;
  result.is_damaged = decoded.is_damaged;
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_DECODE_WAVELETS_H
