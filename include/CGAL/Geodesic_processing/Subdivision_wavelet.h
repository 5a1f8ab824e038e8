// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SUBDIVISION_WAVELET_H
#define CGAL_GEODESIC_PROCESSING_SUBDIVISION_WAVELET_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/channels.h>
#include <CGAL/Geodesic_processing/internal/adaptors/read_triangles.h>
#include <CGAL/Geodesic_processing/internal/subdivision/hierarchy.h>
#include <CGAL/Geodesic_processing/internal/subdivision/zerotree.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingWavelets
/// The prediction of the value at the midpoint of an edge.
enum class Wavelet_prediction
{
  linear, ///< the mean of the values at both endpoints
  /// The modified butterfly scheme \cgalCite{cgal:zss-ismat-96}. If the values are smooth, details
  /// are smaller.
  butterfly
};

/// \ingroup PkgGeodesicProcessingWavelets
/// The wavelet coefficients of vertex values: the result of `Subdivision_wavelet::analyze()`. They
/// are the values of the coarsest mesh and the details of the finer levels. They can be modified
/// before synthesis.
struct Wavelet_details
{
  std::size_t number_of_channels = 0; ///< number of components of each vertex's value
  /// Whether details are components along the normal, the edge, and their cross product.
  bool is_in_frames = false;
  /// `number_of_channels` numbers for each vertex of the hierarchy: first the values of the
  /// coarsest level, then the details of the finer levels.
  std::vector<double> values;
};

/// \ingroup PkgGeodesicProcessingWavelets
///
/// The wavelet transform on a mesh with subdivision connectivity, by lifting.
/// \cgalCite{cgal:s-lscsg-98} \cgalCite{cgal:ss-swers-95}
/// Analysis transforms vertex values to the values of a coarse mesh and details, most of which are
/// small. Synthesis inverts it.
///
/// The mesh must be the result of repeated uniform refinement (1-to-4) of a coarse triangle mesh.
/// The coarser levels are recovered from the connectivity only, so that the order of vertices and
/// faces is arbitrary. \cgalCite{cgal:t-drscg-02}
/// Isolated vertices belong to the coarsest level.
///
/// The object stores the descriptors of the mesh, but no reference to it. The mesh can be
/// destroyed. If it is modified, the object becomes invalid. The object takes about 250 bytes per
/// vertex. Members that do not state their time take O(1) time.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <typename TriangleMesh>
class Subdivision_wavelet
{
  static_assert(internal::require_support<Function::Subdivision_wavelet, TriangleMesh>());

public:
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// Recovers the levels from the connectivity. O(n) time.
  ///
  /// \param mesh a triangle mesh
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{number_of_levels}
  ///     \cgalParamDescription{the maximum number of levels above the coarsest one}
  ///     \cgalParamType{`std::size_t`}
  ///     \cgalParamDefault{all levels of the mesh}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{wavelet_prediction}
  ///     \cgalParamDescription{the prediction of the values at new vertices}
  ///     \cgalParamType{`Wavelet_prediction`}
  ///     \cgalParamDefault{`Wavelet_prediction::butterfly`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_update}
  ///     \cgalParamDescription{whether the update step of lifting is applied, which preserves the
  ///       weighted sum of the values on all levels. Then wavelets have one vanishing moment, and
  ///       the error due to omitted details is smaller}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`true`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Unsupported_surface_error if a face is not a triangle, if two vertices are joined by
  ///         two edges, or if there is no coarser level
  template <typename NamedParameters = internal::Default_parameters>
  explicit Subdivision_wavelet(const TriangleMesh& mesh,
                               const NamedParameters& np = NamedParameters());
  /// Recovers the levels of the mesh of a `domain`. The time and `np` are as for a mesh.
  /// \throws Unsupported_surface_error as for a mesh
  template <typename NamedParameters = internal::Default_parameters>
  explicit Subdivision_wavelet(const Mesh_domain<TriangleMesh>& domain,
                               const NamedParameters& np = NamedParameters())
      : Subdivision_wavelet(domain.mesh(), np)
  {}

  /// \name Levels
  /// @{
  /// Returns the number of levels without the coarsest one, which is level 0.
  std::size_t number_of_levels() const { return subdivision().levels.size() - 1; }
  /// Returns the number of vertices of a `level`.
  /// \pre `level` is at most `number_of_levels()`.
  std::size_t number_of_vertices(std::size_t level) const
  {
    return subdivision().levels[level].number_of_vertices;
  }
  /// Returns the number of vertices of the finest level, which is the mesh.
  std::size_t number_of_vertices() const { return m_vertices.size(); }
  /// Returns vertex `i` in the order of the details: the vertices of a level precede the vertices
  /// that finer levels add.
  /// \pre `i` is less than `number_of_vertices()`.
  Vertex vertex(std::size_t i) const { return m_vertices[i]; }
  /// Returns two indices in that order: the endpoints of the edge whose midpoint is vertex `i`.
  /// For a vertex of the coarsest level, both are `i`.
  /// \pre `i` is less than `number_of_vertices()`.
  std::array<std::size_t, 2> parents(std::size_t i) const
  {
    return {subdivision().parents[i][0], subdivision().parents[i][1]};
  }
  /// Returns the triangles of a `level`, with three vertex indices in that order for each.
  /// Takes linear time in their number.
  /// \pre `level` is at most `number_of_levels()`.
  std::vector<std::array<std::size_t, 3>> triangles(std::size_t level) const
  {
    std::vector<std::array<std::size_t, 3>> result;
    for(const auto& t : subdivision().levels[level].triangles)
      result.push_back({t[0], t[1], t[2]});
    return result;
  }
  /// @}

  /// \name Transforms
  /// Each transform takes O(n) time.
  /// @{

  /// Computes the wavelet coefficients of vertex values. O(n) time.
  ///
  /// \tparam VertexMap a model of `ReadablePropertyMap` with vertices as keys
  /// \param map a readable property map of vertices, whose values are numbers, arrays of numbers,
  ///        points or vectors
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{do_use_frames}
  ///     \cgalParamDescription{whether details of positions are expressed in local frames of the
  ///       coarser surface. This separates tangential details, which hardly affect the shape, from
  ///       normal ones}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \pre The property map has a value for each vertex, and all values have the same size.
  /// \returns the coefficients
  /// \throws Invalid_argument_error if a value is not finite, or if `do_use_frames` is true and
  ///         values do not have three components
  template <typename VertexMap, typename NamedParameters = internal::Default_parameters>
  Wavelet_details analyze(VertexMap map, const NamedParameters& np = NamedParameters()) const;

  /// Computes vertex values from wavelet coefficients and writes them to a property map. If the
  /// coefficients are unmodified, these are the analyzed values up to round-off errors. O(n) time.
  ///
  /// \tparam VertexMap a model of `WritablePropertyMap` with vertices as keys
  /// \param details the result of `analyze()`, possibly modified
  /// \param map receives a value for each vertex
  /// \throws Invalid_argument_error if the details do not match the mesh or the value type of `map`
  template <typename VertexMap>
  void synthesize(const Wavelet_details& details, VertexMap map) const;

  /// Keeps the `number` vertices with the largest details and sets all other details to zero. The
  /// size of a detail is its norm, weighted by its effect on the values of the finest level. O(n)
  /// time.
  /// \param details the result of `analyze()`, which is modified
  /// \throws Invalid_argument_error if the details do not match the mesh
  void keep_largest(Wavelet_details& details, std::size_t number) const
  {
    check(details, details.number_of_channels);
    internal::keep_largest(details.values, details.number_of_channels, subdivision(), number);
  }
  /// @}

  /// \name Files
  /// @{

  /// Encodes the mesh and its details as a progressive stream of bytes, by embedded zerotrees
  /// \cgalCite{cgal:kss-pgc-00} and arithmetic coding. `decode_wavelets()` can read every prefix
  /// that contains the base mesh. Longer prefixes decode to better approximations. Takes O(n)
  /// time for each bit plane.
  ///
  /// \param details the result of `analyze()`, possibly modified
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{number_of_bit_planes}
  ///     \cgalParamDescription{the number of bits of the largest coefficient, 1 to 48. Coefficients
  ///       are weighted by their effect on the finest level. If c is half of the range of the
  ///       coarse values, the largest error with p planes and L levels was one to three times
  ///       2<SUP>L-p</SUP> c on tori, and 4 to 11 times with `do_use_frames`}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{24}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_bytes}
  ///     \cgalParamDescription{the size to which the stream is truncated}
  ///     \cgalParamType{`std::size_t`}
  ///     \cgalParamDefault{unlimited}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \returns the stream
  /// \throws Invalid_argument_error if the details do not match the mesh, are not finite, or have
  ///         more than 16 channels, or if the number of bit planes is not in the range 1 to 48
  template <typename NamedParameters = internal::Default_parameters>
  std::vector<std::uint8_t> encode(const Wavelet_details& details,
                                   const NamedParameters& np = NamedParameters()) const;
  /// @}

private:
  const internal::Subdivision& subdivision() const { return m_lifting->subdivision(); }
  void check(const Wavelet_details& details, std::size_t channels) const
  {
    if(details.number_of_channels != channels || channels == 0 ||
       details.values.size() != channels * m_vertices.size() ||
       (details.is_in_frames && channels != 3))
      throw Invalid_argument_error("The details do not match the mesh or the value type.");
  }

  std::vector<Vertex> m_vertices;
  std::shared_ptr<const internal::Lifting> m_lifting;
  bool m_use_update = true;
  internal::Prediction m_prediction = internal::Prediction::butterfly;
};

template <typename TriangleMesh>
template <typename NamedParameters>
Subdivision_wavelet<TriangleMesh>::Subdivision_wavelet(const TriangleMesh& mesh,
                                                       const NamedParameters& np)
{
  using internal::Index;
  std::vector<Vertex> input_vertices;
  const std::vector<internal::Triangle> triangles = internal::read_triangles(mesh, input_vertices);
  constexpr std::size_t max_number_of_levels = 15; // sufficient for 2^31 halfedges
  const std::size_t requested_levels =
      internal::parameter(np, internal_np::number_of_levels, max_number_of_levels);
  internal::Hierarchy hierarchy;
  try
  {
    hierarchy =
        internal::recover_hierarchy(triangles, Index(input_vertices.size()),
                                    unsigned((std::min)(requested_levels, max_number_of_levels)));
  }
  catch(const Invalid_argument_error& error)
  {
    throw Unsupported_surface_error(error.what());
  }
  if(hierarchy.subdivision->levels.size() < 2)
    throw Unsupported_surface_error("The mesh has no coarser level: it is not the uniform (1-to-4) "
                                    "refinement of another mesh.");
  for(const Index v : hierarchy.input_vertex)
    m_vertices.push_back(input_vertices[v]);
  const bool is_linear =
      internal::parameter(np, internal_np::wavelet_prediction, Wavelet_prediction::butterfly) ==
      Wavelet_prediction::linear;
  m_prediction = is_linear ? internal::Prediction::linear : internal::Prediction::butterfly;
  m_use_update = internal::parameter(np, internal_np::do_update, true);
  m_lifting =
      std::make_shared<const internal::Lifting>(hierarchy.subdivision, m_prediction, m_use_update);
}

template <typename TriangleMesh>
template <typename VertexMap, typename NamedParameters>
Wavelet_details Subdivision_wavelet<TriangleMesh>::analyze(VertexMap map,
                                                           const NamedParameters& np) const
{
  Wavelet_details result;
  result.is_in_frames = internal::parameter(np, internal_np::do_use_frames, false);
  for(const Vertex vertex : m_vertices)
    internal::append_channels(result.values, get(map, vertex));
  if(!std::all_of(result.values.begin(), result.values.end(),
                  [](double x) { return std::isfinite(x); }))
    throw Invalid_argument_error("A value is not finite.");
  result.number_of_channels = result.values.size() / m_vertices.size();
  check(result, result.number_of_channels);
  m_lifting->analyze(result.values, result.number_of_channels, result.is_in_frames);
  return result;
}

template <typename TriangleMesh>
template <typename VertexMap>
void Subdivision_wavelet<TriangleMesh>::synthesize(const Wavelet_details& details,
                                                   VertexMap map) const
{
  using Value = typename boost::property_traits<VertexMap>::value_type;
  constexpr std::size_t channels = internal::number_of_channels<Value>;
  check(details, channels);
  std::vector<double> values = details.values;
  m_lifting->synthesize(values, channels, details.is_in_frames);
  for(std::size_t i = 0; i < m_vertices.size(); ++i)
    put(map, m_vertices[i], internal::from_channels<Value>(&values[channels * i]));
}

template <typename TriangleMesh>
template <typename NamedParameters>
std::vector<std::uint8_t> Subdivision_wavelet<TriangleMesh>::encode(const Wavelet_details& details,
                                                                    const NamedParameters& np) const
{
  check(details, details.number_of_channels);
  return internal::encode(
      subdivision(),
      {details.number_of_channels, m_prediction, m_use_update, details.is_in_frames,
       details.values},
      internal::parameter(np, internal_np::number_of_bit_planes, 24u), 2,
      internal::parameter(np, internal_np::maximum_number_of_bytes, static_cast<std::size_t>(-1)));
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SUBDIVISION_WAVELET_H
