// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SOUP_DOMAIN_H
#define CGAL_GEODESIC_PROCESSING_SOUP_DOMAIN_H

#include <CGAL/Geodesic_processing/Mesh_domain.h>
#include <CGAL/Geodesic_processing/Soup_report.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/soup_mesh.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/mesh/polygon_soup.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/property_map.h>

#include <array>
#include <iterator>
#include <optional>
#include <type_traits>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDomain
///
/// Represents a polygon soup for all algorithms of this package: points, and polygons that refer to
/// points by their indices. It is returned by `make_domain()` and can be passed to every function
/// that accepts a mesh. The soup need not be a manifold, and its polygons need not be triangles or
/// be oriented.
///
/// The domain contains a `Surface_mesh`, on which all property maps, vertices and locations are
/// defined. It is built when `mesh()` or a function that needs its halfedges is called for the
/// first time. Vertex `i` of the mesh is point `i` of the soup, for all points. The faces of the
/// mesh are the triangles of the polygons, in the order of the polygons. `polygon()` returns the
/// polygon of a face. Outputs on faces and halfedges, for example the coordinates of a texture
/// atlas or the locations on a remeshed surface, refer to this mesh.
///
/// The surface is split at edges of three or more triangles. Where a nonorientable surface meets
/// itself, it is split as well. The vertices of such edges are not split: distances continue across
/// a vertex, as if the fans of triangles at this vertex were connected by a link of length zero.
/// Across the interior of a split edge they do not continue. A distance can therefore be too large,
/// by at most the length of the split edge for each split edge that the shortest path crosses. The
/// error disappears if these edges are subdivided. Lower bounds of distances are those on the split
/// surface.
///
/// At a vertex with several fans, the boundary halfedges of all fans form one cycle of the mesh, so
/// that circulators visit all fans that have a boundary.
///
/// The domain is immutable, and copies are cheap, since they share the data.
///
/// \tparam Point a point of a model of `Kernel`
template <typename Point>
class Soup_domain : public Mesh_domain<Surface_mesh<Point>>
{
  using Base = Mesh_domain<Surface_mesh<Point>>;
  using Index = internal::Index;

public:
  /// Constructs the domain from a polygon soup. O(n).
  ///
  /// \tparam PointRange as for `make_domain()`
  /// \tparam PolygonRange as for `make_domain()`
  /// \param points the points
  /// \param polygons the polygons: indices of points
  /// \param np named parameters of `make_domain()`
  /// \throws as `make_domain()`
  template <typename PointRange, typename PolygonRange,
            typename NamedParameters = internal::Default_parameters>
  Soup_domain(const PointRange& points, const PolygonRange& polygons,
              const NamedParameters& np = NamedParameters());

  /// Returns what was changed, and the topology of the surface. O(1).
  const Soup_report& report() const { return m_content->report; }

  /// Returns the position of the polygon that contains a face of the mesh. O(1).
  /// \param face a face of `mesh()`
  std::size_t polygon(typename Surface_mesh<Point>::Face_index face) const
  {
    return m_content->polygon.empty() ? std::size_t(face) : m_content->polygon[face];
  }

  using Base::point;
  /// Returns the point of a vertex of the mesh, a point of the soup. Does not build the mesh. O(1).
  /// \param vertex a vertex of `mesh()`
  Point point(typename Surface_mesh<Point>::Vertex_index vertex) const
  {
    const auto points = m_content->points.lock();
    return points ? (*points)[vertex] : this->mesh().point(vertex);
  }

  /// Returns the number of faces of the mesh. Does not build the mesh. O(1).
  std::size_t number_of_faces() const { return this->m_data->faces.size(); }

  /// Returns the positions of the points at the corners of a face of the mesh, in counterclockwise
  /// order. Does not build the mesh. O(1).
  /// \param face a face of `mesh()`
  std::array<std::size_t, 3> corners(typename Surface_mesh<Point>::Face_index face) const
  {
    const std::size_t first = 3 * std::size_t(this->triangle(face));
    std::array<std::size_t, 3> result;
    for(std::size_t k = 0; k < 3; ++k)
      result[k] = std::size_t(this->vertex(this->triangles()->corner[first + k]));
    return result;
  }

private:
  struct Content
  {
    Soup_report report;
    std::vector<Index> polygon;                     // #faces; see Soup_arrays
    std::weak_ptr<const std::vector<Point>> points; // deleted when the mesh is built
  };
  void initialize(std::size_t number_of_points, internal::Soup_arrays soup,
                  const std::shared_ptr<const std::vector<Point>>& points);

  std::shared_ptr<const Content> m_content;
};

template <typename Point>
template <typename PointRange, typename PolygonRange, typename NamedParameters>
Soup_domain<Point>::Soup_domain(const PointRange& points, const PolygonRange& polygons,
                                const NamedParameters& np)
{
  using Element = typename std::iterator_traits<decltype(std::begin(points))>::value_type;
  static_assert(std::is_constructible_v<Point, double, double, double>,
                "The elements of a soup are points of CGAL; pass a point_map for other types.");
  const auto point_map =
      internal::parameter(np, CGAL::internal_np::point_map, CGAL::Identity_property_map<Element>());
  internal::Polygon_soup soup;
  const auto number_of_points =
      static_cast<std::size_t>(std::distance(std::begin(points), std::end(points)));
  if(number_of_points >= internal::none)
    throw Unsupported_surface_error("The soup has more than 2^32 points.");
  const auto read_points = [&]
  {
    soup.points.reserve(number_of_points);
    for(const auto& element : points)
    {
      const auto& p = get(point_map, element);
      soup.points.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
    }
  };
  const auto read_polygons = [&]
  {
    const auto number_of_polygons =
        static_cast<std::size_t>(std::distance(std::begin(polygons), std::end(polygons)));
    soup.polygon_begin.reserve(number_of_polygons + 1);
    for(const auto& polygon : polygons)
      soup.polygon_begin.push_back(
          soup.polygon_begin.back() +
          static_cast<std::size_t>(std::distance(std::begin(polygon), std::end(polygon))));
    soup.corners.resize(soup.polygon_begin.back());
    Index* soup_corner = soup.corners.data();
    for(const auto& polygon : polygons)
      for(const auto corner : polygon)
      {
        // Negative numbers become large ones.
        const auto point = static_cast<std::size_t>(corner);
        *soup_corner++ = point < number_of_points ? static_cast<Index>(point) : internal::none;
      }
  };
  const auto number_of_threads = internal::parameter(np, internal_np::number_of_threads, 1u);
  // The points are read by one thread at a time, because numbers of a kernel with lazy evaluation
  // change when they are read.
  internal::run_both(number_of_threads, read_points, read_polygons);
  internal::Soup_options options;
  if constexpr(internal::has_parameter<NamedParameters, internal_np::merge_tolerance_t>)
    options.merge_tolerance = internal::parameter(np, internal_np::merge_tolerance, 0.);
  options.do_remove_degenerate_faces =
      internal::parameter(np, internal_np::do_remove_degenerate_faces, false);
  options.number_of_threads = number_of_threads;
  options.callback = internal::read_throwing_callback(np);
  internal::Soup_arrays arrays = internal::build_soup_arrays(std::move(soup), options);

  const auto points_of_mesh = std::make_shared<std::vector<Point>>();
  const auto copy_points = [&]
  {
    points_of_mesh->reserve(number_of_points);
    for(const auto& element : points)
      points_of_mesh->push_back(get(point_map, element));
  };
  internal::run_both(number_of_threads, copy_points,
                     [&] { initialize(number_of_points, std::move(arrays), points_of_mesh); });
  using Mesh = Surface_mesh<Point>;
  this->m_mesh_of_soup = std::make_shared<const internal::Lazy_mesh<Mesh>>(
      [points = points_of_mesh, triangles = this->m_triangles, data = this->m_data]
      { return internal::soup_mesh(*points, *triangles, data->vertices, data->faces); });
}

template <typename Point>
void Soup_domain<Point>::initialize(std::size_t number_of_points, internal::Soup_arrays soup,
                                    const std::shared_ptr<const std::vector<Point>>& points)
{
  using Mesh = Surface_mesh<Point>;
  using Vertex = typename Mesh::Vertex_index;
  using Face = typename Mesh::Face_index;
  internal::Mesh_arrays& mesh = soup.mesh;
  std::vector<Index> indices = std::move(mesh.internal_vertex);
  std::vector<Vertex> merged_vertices;
  if(!soup.replacement.empty())
  {
    // Vertices of the arrays are numbered without the points that have been replaced.
    const std::vector<Index> remaining = std::move(indices);
    std::vector<Index> position;
    indices.resize(number_of_points);
    for(Index i = 0; i < number_of_points; ++i)
    {
      if(soup.replacement[i] == i)
      {
        indices[i] = remaining[position.size()];
        position.push_back(i);
        continue;
      }
      indices[i] = indices[soup.replacement[i]];
      merged_vertices.push_back(Vertex(i));
    }
    for(Index& v : mesh.caller_vertex)
      v = position[v];
  }

  typename Base::Data data(std::move(indices), std::move(mesh.triangle_of_face));
  data.merged_vertices = std::move(merged_vertices);
  data.vertices.reserve(mesh.caller_vertex.size());
  for(const Index v : mesh.caller_vertex)
    data.vertices.push_back(Vertex(v));
  data.faces.reserve(mesh.face_of_triangle.size());
  for(const Index f : mesh.face_of_triangle)
    data.faces.push_back(Face(f));
  if(!data.vertices.empty())
    data.vertex_range = {Vertex(0), Vertex(static_cast<Index>(number_of_points - 1))};
  if(!data.faces.empty())
    data.face_range = {Face(0), Face(static_cast<Index>(data.faces.size() - 1))};
  this->m_triangles = std::make_shared<const internal::Surface_arrays>(std::move(mesh.arrays));
  this->m_data = std::make_shared<const typename Base::Data>(std::move(data));
  m_content =
      std::make_shared<const Content>(Content{soup.report, std::move(soup.polygon), points});
}

namespace internal {

// The point type of a soup: that of the point map, or of the range.
template <typename PointRange, typename NamedParameters>
using Soup_point = typename boost::property_traits<std::decay_t<decltype(parameter(
    std::declval<const NamedParameters&>(), CGAL::internal_np::point_map,
    CGAL::Identity_property_map<
        std::decay_t<decltype(*std::begin(std::declval<const PointRange&>()))>>()))>>::value_type;

} // namespace internal

/// \ingroup PkgGeodesicProcessingDomain
///
/// Constructs the domain of a polygon soup. It repairs the soup in this order: merges points,
/// triangulates polygons, removes faces that are degenerate or duplicates, reverses triangles for a
/// consistent orientation, and splits the surface at edges that have three or more triangles or no
/// consistent orientation. In a component that can be oriented, the minority of the triangles is
/// reversed. `Soup_domain::report()` has the number of each repair. A soup that needs no repair has
/// the same results as its mesh.
///
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default), or `CGAL::Parallel_tag` for
///         several threads. The results are identical.
/// \tparam PointRange a model of `Range`
/// \tparam PolygonRange a model of `Range` whose elements are ranges of integers
/// \param points the points
/// \param polygons the polygons: indices of points, in cyclic order, starting at 0
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the point of each element of `points`}
///     \cgalParamType{a model of `ReadablePropertyMap` with elements of `points` as keys and points
///       of a model of `Kernel` as values}
///     \cgalParamDefault{`CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{merge_tolerance}
///     \cgalParamDescription{Points within this distance are merged, for example 0 for a file that
///       has separate points for each triangle. Each point is replaced by the first earlier point
///       within this distance that has not been replaced itself. The results of the earlier point
///       are written for both points, and the input is read at the earlier point.}
///     \cgalParamType{`double`, the unit of the coordinates}
///     \cgalParamDefault{No points are merged.}
///   \cgalParamNEnd
///   \cgalParamNBegin{do_remove_degenerate_faces}
///     \cgalParamDescription{whether triangles without area are removed. The surface then has a
///       slit if the corners of such a triangle are different points. All functions accept
///       triangles without area.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{the number of threads. The construction of a solver with
///       `Fast_marching` on this domain uses it, too}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{1; with `CGAL::Parallel_tag`, the number of hardware threads}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with 0 between the steps of the construction;
///       if it returns false, the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The property map has a value for each element of `points`.
/// \returns the domain
/// \throws Invalid_argument_error if a coordinate is not finite, if a corner is not the index of a
///         point, if distances overflow, or if the tolerance is negative
/// \throws Unsupported_surface_error if a polygon has more than 10,000 corners, or if the triangles
///         have more than 2<SUP>31</SUP> halfedges
/// \throws Cancelled if the callback returns false
///
/// O(n) for n points of bounded degree, and O(k<SUP>2</SUP>) for a polygon of k corners. The domain
/// takes about 200 bytes per point, and its mesh, if a function needs it, about 110 more.
template <typename Concurrency_tag = Sequential_tag, typename PointRange, typename PolygonRange,
          typename NamedParameters = internal::Default_parameters,
          std::enable_if_t<!internal::is_named_parameters<PolygonRange>, int> = 0>
Soup_domain<internal::Soup_point<PointRange, NamedParameters>>
make_domain(const PointRange& points, const PolygonRange& polygons,
            const NamedParameters& np = NamedParameters())
{
  if constexpr(std::is_same_v<Concurrency_tag, Sequential_tag>)
    return {points, polygons, np};
  else
    return {
        points, polygons,
        internal::chain(np).number_of_threads(internal::number_of_threads<Concurrency_tag>(np))};
}

/// \ingroup PkgGeodesicProcessingDomain
///
/// Returns the domain of the mesh of the soup, so that functions accept a soup. O(1).
///
/// \tparam Concurrency_tag has no effect
/// \tparam Point a point of a model of `Kernel`
/// \param domain a domain
/// \returns a copy that shares the data
template <typename Concurrency_tag = Sequential_tag, typename Point,
          typename NamedParameters = internal::Default_parameters>
Mesh_domain<Surface_mesh<Point>> make_domain(const Soup_domain<Point>& domain,
                                             const NamedParameters& = NamedParameters())
{
  return domain;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SOUP_DOMAIN_H
