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
/// The extent to which a stream was decoded.
struct Wavelet_stream
{
  std::size_t number_of_levels = 0;     ///< number of levels without the base mesh
  std::size_t number_of_bit_planes = 0; ///< number of bit planes that were decoded completely
  bool is_complete = false;             ///< whether these are all bit planes of the encoder
  bool is_damaged = false; ///< whether a checksum differs; later bit planes were ignored
};

/// \ingroup PkgGeodesicProcessingWavelets
///
/// Decodes a stream of `Subdivision_wavelet::encode()`, or a prefix of one, and adds its mesh to
/// `output`. A prefix decodes to an approximation. Vertices and faces are added in the order of
/// levels, so that the mesh can be analyzed again.
///
/// Damaged bytes are detected by checksums; then only the bit planes before them are used. Damage
/// in a truncated bit plane can remain undetected, but vertices are always finite.
///
/// \tparam ByteRange a range of `std::uint8_t`
/// \tparam OutputMesh a model of `MutableFaceGraph`
/// \param bytes a contiguous range of `std::uint8_t`
/// \param output the mesh to which the result is added, a model of `MutableFaceGraph`
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_number_of_vertices}
///     \cgalParamDescription{the maximum number of vertices of the decoded mesh. It protects
///       against short damaged streams that encode arbitrarily many vertices}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{2<SUP>24</SUP>}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the extent to which the stream was decoded
/// \throws Invalid_argument_error if the bytes are not a stream of vertex positions, if the base
///         mesh is incomplete or damaged, or if there are too many vertices. Then `output` is
///         unchanged.
///
/// O(n) time for each bit plane.
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
    throw Invalid_argument_error("The wavelet stream does not contain vertex positions.");
  if(!internal::is_halfedge_mesh(decoded.subdivision->levels.front()))
    throw Invalid_argument_error(
        "The wavelet stream has a nonmanifold vertex that a halfedge mesh cannot represent.");
  const std::vector<double> values = internal::decoded_values(decoded);

  const auto points = get(CGAL::vertex_point, output);
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  std::vector<Vertex> vertices;
  for(std::size_t i = 0; i < values.size(); i += 3)
  {
    vertices.push_back(add_vertex(output));
    put(points, vertices.back(), Point(values[i], values[i + 1], values[i + 2]));
  }
  // Faces are added one by one, because adding all at once does not support faces that meet only in
  // a vertex.
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
