// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_LOCATE_ON_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_LOCATE_ON_SURFACE_H

#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/number_utils.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDomain
///
/// Computes the closest locations on one surface to points in space. It uses a tree of triangles on
/// a mesh, and of surfels on a cloud. Copies share the tree.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Surface_locator
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Location = typename Domain::Location;

  /// Constructs the tree of a `domain` in O(n log n) time on a mesh. On a cloud it uses the tree of
  /// the domain.
  explicit Surface_locator(const Domain& domain) : m_domain(domain), m_tree(tree(domain)) {}
  /// Constructs the domain of a surface and its tree in O(n log n) time.
  /// \param surface the surface
  /// \param np the named parameters of `make_domain()`
  /// \throws as `make_domain()`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Surface_locator(const Surface& surface, const NamedParameters& np = NamedParameters())
      : Surface_locator(Domain(surface, np))
  {}

  /// Returns the location that is closest to a point. O(log n) on most inputs.
  /// \tparam Point a `Point_3` of any kernel
  /// \param point the point
  /// \throws Invalid_argument_error if a coordinate is not finite or the surface is empty
  template <typename Point>
  Location operator()(const Point& point) const
  {
    const std::array<double, 3> p = {CGAL::to_double(point.x()), CGAL::to_double(point.y()),
                                     CGAL::to_double(point.z())};
    if constexpr(internal::Is_cloud<Surface>::value)
    {
      const internal::Tangent_location tangent_location = internal::locate(m_domain.surfels(), p);
      const double scale = m_domain.triangles()->scale;
      return {m_domain.vertex(tangent_location.vertex),
              {scale * tangent_location.offset[0], scale * tangent_location.offset[1]}};
    }
    else
      return m_domain.outer(m_tree.nearest(p));
  }

private:
  struct Empty
  {};
  using Tree =
      std::conditional_t<internal::Is_cloud<Surface>::value, Empty, internal::Triangle_tree>;
  static Tree tree([[maybe_unused]] const Domain& domain)
  {
    if constexpr(internal::Is_cloud<Surface>::value)
      return Empty();
    else
      return internal::Triangle_tree(domain.triangles());
  }

  Domain m_domain;
  Tree m_tree;
};

/// \ingroup PkgGeodesicProcessingDomain
///
/// Returns the location on a surface that is closest to a point in space. For many points, use a
/// `Surface_locator`.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Point a `Point_3` of any kernel
/// \param surface as for `geodesic_distances()`
/// \param point a `Point_3` of any kernel
/// \param np named parameters of `make_domain()`
/// \returns the location of the closest point
/// \throws Invalid_argument_error if a coordinate is not finite or the surface is empty
///
/// O(n log n) time for the search tree.
template <typename Surface, typename Point, typename NamedParameters = internal::Default_parameters>
Location<Surface_of<Surface>> locate_on_surface(const Surface& surface, const Point& point,
                                                const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  return Surface_locator<typename decltype(domain)::Surface>(domain)(point);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_LOCATE_ON_SURFACE_H
