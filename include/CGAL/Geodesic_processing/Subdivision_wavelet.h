// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SUBDIVISION_WAVELET_H
#define CGAL_GEODESIC_PROCESSING_SUBDIVISION_WAVELET_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/channels.h>
#include <CGAL/Geodesic_processing/internal/subdivision/hierarchy.h>
#include <CGAL/Geodesic_processing/internal/subdivision/zerotree.h>
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
/// how wavelets foretell the value at the middle of an edge.
enum class Wavelet_prediction
{
  linear,   ///< as the mean of its two ends
  butterfly ///< by the modified butterfly scheme \cgalCite{cgal:zss-ismat-96}. Of smooth values details are smaller
};

/// \ingroup PkgGeodesicProcessingWavelets
/// the values of a coarse mesh, and the details that finer ones add: what `Subdivision_wavelet::analyze()` makes.
/// Numbers may be changed before they are put together again.
struct Wavelet_details
{
  std::size_t number_of_channels = 0; ///< numbers for each vertex
  bool is_in_frames = false;          ///< details are along the normal, the edge, and across it
  /// of all vertices of the hierarchy, `number_of_channels` each: those of the coarsest level, then details.
  std::vector<double> values;
};

/// \ingroup PkgGeodesicProcessingWavelets
///
/// wavelets on a mesh with subdivision connectivity, by lifting. \cgalCite{cgal:s-lscsg-98} \cgalCite{cgal:ss-swers-95}
/// Any values of its vertices become those of a coarse mesh and details, most of which are small, and
/// come back from these.
///
/// The mesh is one whose triangles were cut into four, again and again, whatever the order of its vertices and
/// faces: coarser levels are found from the connectivity alone.  \cgalCite{cgal:t-drscg-02}
/// Vertices that are not in any face are in the coarsest level.
///
/// It knows the mesh's descriptors, but not the mesh: that may be destroyed, not be changed.  About 250 bytes per
/// vertex.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <typename TriangleMesh>
class Subdivision_wavelet
{
public:
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// finds the levels.  O(n).
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{number_of_levels} \cgalParamDescription{how many are taken off at most}
  ///     \cgalParamDefault{as many as there are} \cgalParamNEnd
  ///   \cgalParamNBegin{wavelet_prediction} \cgalParamDescription{a `Wavelet_prediction`}
  ///     \cgalParamDefault{`Wavelet_prediction::butterfly`} \cgalParamNEnd
  ///   \cgalParamNBegin{do_update}
  ///     \cgalParamDescription{whether coarser values have the same sum, each weighted by what stems from it: wavelets
  ///       have a vanishing moment, and the error of leaving details out is smaller}
  ///     \cgalParamDefault{`true`} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Unsupported_surface_error when a face is not a triangle, two vertices are joined by two edges, or there
  ///         is no coarser level
  template <typename NamedParameters = internal::Default_parameters>
  explicit Subdivision_wavelet(const TriangleMesh& mesh,
                               const NamedParameters& np = NamedParameters());

  /// \name Levels
  /// @{
  /// without the coarsest, which is level 0.
  std::size_t number_of_levels() const { return subdivision().levels.size() - 1; }
  std::size_t number_of_vertices(std::size_t level) const
  {
    return subdivision().levels[level].number_of_vertices;
  }
  std::size_t number_of_vertices() const { return m_vertices.size(); }
  /// in the order of details: those of a level before those of all finer ones.
  Vertex vertex(std::size_t i) const { return m_vertices[i]; }
  /// two places in that order: the ends of the edge whose midpoint the vertex is; in the coarsest level, itself.
  std::array<std::size_t, 2> parents(std::size_t i) const
  {
    return {subdivision().parents[i][0], subdivision().parents[i][1]};
  }
  /// those of a level: three places in that order for each.
  std::vector<std::array<std::size_t, 3>> triangles(std::size_t level) const
  {
    std::vector<std::array<std::size_t, 3>> result;
    for(const auto& t : subdivision().levels[level].triangles)
      result.push_back({t[0], t[1], t[2]});
    return result;
  }
  /// @}

  /// \name Transforms
  /// each O(n).
  /// @{

  /// the details of values of vertices: numbers, arrays of them, points or vectors.
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{do_use_frames}
  ///     \cgalParamDescription{whether details of places are turned into frames of the coarser surface: then those
  ///       along the surface, which it hardly shows, are apart from those along its normal}
  ///     \cgalParamDefault{`false`} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error when a value is not finite, or frames are asked for other than three numbers
  template <typename VertexMap, typename NamedParameters = internal::Default_parameters>
  Wavelet_details analyze(VertexMap map, const NamedParameters& np = NamedParameters()) const;

  /// writes the values that details make: the same as were analyzed, but for rounding, if the details are.
  ///
  /// \throws Invalid_argument_error when the details are of another mesh, or of other values
  template <typename VertexMap>
  void synthesize(const Wavelet_details& details, VertexMap map) const;

  /// sets all details to zero but the largest `number` of them, measured by what they change on the whole surface.
  /// O(n).
  void keep_largest(Wavelet_details& details, std::size_t number) const
  {
    check(details, details.number_of_channels);
    internal::keep_largest(details.values, details.number_of_channels, subdivision(), number);
  }
  /// @}

  /// \name Files
  /// @{

  /// the mesh and its details as bytes, the most important ones first: every prefix that has the base mesh can be read by
  /// `decode_wavelets()`, and longer ones are better.  Embedded zerotrees \cgalCite{cgal:kss-pgc-00}, arithmetically coded.
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{number_of_bit_planes}
  ///     \cgalParamDescription{1 to 48: the error at the end is about the largest number divided by 2 as often}
  ///     \cgalParamDefault{24} \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_bytes} \cgalParamDescription{where to stop}
  ///     \cgalParamDefault{nowhere} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error when the details are of another mesh, not finite, of more than 16 channels, or
  ///         the number of planes is none
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
      throw Invalid_argument_error("The details are of another mesh, or of other values.");
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
  const auto index = get(dynamic_vertex_property_t<Index>(), mesh);
  std::vector<Vertex> input_vertices;
  for(const Vertex vertex : vertices(mesh))
  {
    put(index, vertex, Index(input_vertices.size()));
    input_vertices.push_back(vertex);
  }
  std::vector<internal::Triangle> triangles;
  for(const auto face : faces(mesh))
  {
    const auto first_halfedge = halfedge(face, mesh);
    auto h = first_halfedge;
    internal::Triangle t;
    for(Index& v : t)
    {
      v = get(index, target(h, mesh)); // the first one that the face was made of
      h = next(h, mesh);
    }
    if(h != first_halfedge)
      throw Unsupported_surface_error("A face is not a triangle.");
    triangles.push_back(t);
  }
  constexpr std::size_t max_number_of_levels = 15; // of 2^31 half-edges
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
    throw Unsupported_surface_error("The mesh has no coarser level: its triangles are not those of "
                                    "larger ones, each cut into four.");
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
