// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_LOCATION_H
#define CGAL_GEODESIC_PROCESSING_LOCATION_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {

template <typename Point, typename Vector>
class Point_set_3;
template <typename Point>
class Surface_mesh;

namespace Geodesic_processing {

template <typename TriangleMesh>
class Mesh_domain;
template <typename SurfelRange>
class Surfel_domain;
template <typename Point>
class Soup_domain;

/// \ingroup PkgGeodesicProcessingDomain
/// A location on a surfel cloud: a surfel and an offset in its tangent plane. The two components of
/// the offset are in the unit of the coordinates. They refer to `Surfel_domain::axes()`, and
/// `Surfel_domain::point()` returns the point.
template <typename Surfel>
struct Surfel_location
{
  Surfel surfel{};                         ///< the surfel
  std::array<double, 2> offset = {0., 0.}; ///< the components along the two axes
};

namespace internal {

// Distinguishes clouds from meshes: a range of surfels has begin(), a FaceGraph does not. No other
// code makes this distinction. The class boost::graph_traits<Point_set_3> cannot be used, since
// it does not compile.
template <typename Surface, typename = void>
struct Is_cloud : std::false_type
{};
template <typename Surface>
struct Is_cloud<Surface, std::void_t<decltype(std::declval<const Surface&>().begin())>>
    : std::true_type
{};

// The kernel of elements for which it is unknown. It compiles as long as no point is constructed.
template <typename Element>
struct Unknown_kernel
{
  struct Point_3
  {
    template <typename... Coordinates>
    Point_3(const Coordinates&...)
    {
      static_assert(sizeof...(Coordinates) > 3, "The kernel of the surfels is unknown: specialize "
                                                "CGAL::Geodesic_processing::Surfel_kernel.");
    }
  };
  using Vector_3 = Point_3;
};

template <typename Element, typename = void>
struct Element_kernel
{
  using type = Unknown_kernel<Element>;
};
template <typename Element>
struct Element_kernel<Element, std::void_t<typename Element::R>>
{
  using type = typename Element::R;
};
template <typename First, typename Second>
struct Element_kernel<std::pair<First, Second>> : Element_kernel<First>
{};
template <typename First, typename... Others>
struct Element_kernel<std::tuple<First, Others...>> : Element_kernel<First>
{};

} // namespace internal

/// \ingroup PkgGeodesicProcessingDomain
/// The kernel of the points and vectors that are computed on a range of surfels. It is the kernel
/// of the elements if they are points of \cgal, or pairs or tuples that begin with such a point, or
/// if they have a nested type `R`. For other ranges, for example of indices, specialize this struct
/// before you call a function that returns points or vectors. Distances do not need it.
template <typename SurfelRange>
struct Surfel_kernel
{
  /// A model of `Kernel`
  using type = typename internal::Element_kernel<
      std::decay_t<decltype(*std::declval<const SurfelRange&>().begin())>>::type;
};

namespace internal {

// The types of the vertices (or surfels), locations, points and vectors of a surface.
template <typename Surface, bool is_cloud = Is_cloud<Surface>::value>
struct Surface_traits
{
  using Vertex = typename boost::graph_traits<Surface>::vertex_descriptor;
  using Location =
      std::pair<typename boost::graph_traits<Surface>::face_descriptor, std::array<double, 3>>;
  using Point_3 = typename boost::property_traits<
      typename boost::property_map<Surface, vertex_point_t>::type>::value_type;
  using Vector_3 = typename Kernel_traits<Point_3>::Kernel::Vector_3;
};

// The template argument of a class is a surface, not a domain.
template <typename Domain>
struct Domain_as_surface
{
  static_assert(sizeof(Domain) == 0, "The template argument Surface is the mesh or the cloud, also "
                                     "if a domain is passed: use Surface_of<Domain>.");
};
template <typename TriangleMesh>
struct Surface_traits<Mesh_domain<TriangleMesh>, false> : Domain_as_surface<TriangleMesh>
{};
template <typename SurfelRange>
struct Surface_traits<Surfel_domain<SurfelRange>, false> : Domain_as_surface<SurfelRange>
{};
template <typename Point>
struct Surface_traits<Soup_domain<Point>, false> : Domain_as_surface<Point>
{};

template <typename SurfelRange>
struct Surface_traits<SurfelRange, true>
{
  using Vertex = std::size_t;
  using Location = Surfel_location<Vertex>;
  using Point_3 = typename Surfel_kernel<SurfelRange>::type::Point_3;
  using Vector_3 = typename Surfel_kernel<SurfelRange>::type::Vector_3;
};

template <typename Point, typename Vector>
struct Surface_traits<Point_set_3<Point, Vector>, true>
{
  using Vertex = typename Point_set_3<Point, Vector>::Index;
  using Location = Surfel_location<Vertex>;
  using Point_3 = Point;
  using Vector_3 = Vector;
};

// Whether a type is a property map that has values for descriptors of this type.
template <typename PropertyMap, typename Descriptor, typename = void>
inline constexpr bool is_keyed_by = false;
template <typename PropertyMap, typename Descriptor>
inline constexpr bool is_keyed_by<
    PropertyMap, Descriptor, std::void_t<typename boost::property_traits<PropertyMap>::key_type>> =
    std::is_convertible_v<Descriptor, typename boost::property_traits<PropertyMap>::key_type>;

template <typename Surface>
struct Surface_of_domain
{
  using type = Surface;
};
template <typename Surface>
struct Surface_of_domain<Mesh_domain<Surface>>
{
  using type = Surface;
};
template <typename Surface>
struct Surface_of_domain<Surfel_domain<Surface>>
{
  using type = Surface;
};
template <typename Point>
struct Surface_of_domain<Soup_domain<Point>>
{
  using type = Surface_mesh<Point>;
};

} // namespace internal

/// \ingroup PkgGeodesicProcessingDomain
/// The surface of a domain that `make_domain()` returns; otherwise the type itself. The type can be
/// `const`, as that of a variable is.
template <typename Surface>
using Surface_of = typename internal::Surface_of_domain<std::remove_const_t<Surface>>::type;

/// \ingroup PkgGeodesicProcessingDomain
/// A location on a surface. On a mesh it is `Polygon_mesh_processing::Face_location<Surface,
/// double>`, whatever the kernel of the mesh: a face and three barycentric coordinates. These
/// belong to the source of `halfedge(face, mesh)`, to its target, and to the third corner, in this
/// order. On a cloud it is a `Surfel_location`.
///
/// `point()` of a domain returns its point. The functions of
/// `CGAL/Polygon_mesh_processing/locate.h` also accept a location on a mesh; this file does not
/// include that header, which includes the AABB tree. A location that they return is one of this
/// package only if the number type of the kernel is `double`.
template <typename Surface>
using Location = typename internal::Surface_traits<Surface>::Location;

} // namespace Geodesic_processing
} // namespace CGAL

#endif // CGAL_GEODESIC_PROCESSING_LOCATION_H
