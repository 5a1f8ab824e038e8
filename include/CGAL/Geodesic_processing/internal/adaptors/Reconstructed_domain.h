// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_RECONSTRUCTED_DOMAIN_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_RECONSTRUCTED_DOMAIN_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/surfels/reconstruction.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The domain of a cloud for algorithms that require a manifold surface: the surface of
// reconstruct_surface() replaces the triangles of the cloud. Vertices and locations in the
// interface are those of the cloud.
template <typename SurfelRange>
class Reconstructed_domain
{
  using Cloud = Surfel_domain<SurfelRange>;

public:
  using Surface = SurfelRange;
  using Vertex = typename Cloud::Vertex;
  using Location = typename Cloud::Location;
  using Point_3 = typename Cloud::Point_3;

  // Throws Unsupported_surface_error if the reconstructed surface has no triangles.
  explicit Reconstructed_domain(const Cloud& cloud)
      : Reconstructed_domain(cloud, reconstruct_surface(cloud.surfels()))
  {}

  const std::shared_ptr<const Surface_arrays>& triangles() const { return m_triangles; }
  std::size_t number_of_vertices() const { return m_cloud.number_of_vertices(); }
  Vertex vertex(Index index) const { return m_cloud.vertex((*m_vertex_of_cloud)[index]); }

  // Returns the closest location on the reconstructed surface. Not every surfel is a vertex of it.
  internal::Surface_location inner(const Location& location) const
  {
    return m_tree.nearest(coordinates(*m_cloud.triangles(), m_cloud.inner(location)));
  }
  internal::Surface_location inner_vertex(Vertex surfel) const
  {
    return inner(m_cloud.outer(m_cloud.inner_vertex(surfel)));
  }
  // Returns the location on the cloud that is closest to a location of the reconstructed surface.
  Location outer(const internal::Surface_location& location) const
  {
    return m_cloud_locator(point(location));
  }
  Point_3 point(const internal::Surface_location& location) const
  {
    const auto p = coordinates(*m_triangles, location);
    return Point_3(p[0], p[1], p[2]);
  }

  // Computes the slowness of each triangle from the speeds of the surfels.
  template <typename SpeedMap>
  std::vector<double> slowness(SpeedMap speed) const
  {
    std::vector<double> values;
    for(Index i = 0; i < number_of_vertices(); ++i)
      values.push_back(get(speed, vertex(i)));
    return mean_over_corners(*m_triangles, slowness_of(std::move(values)));
  }

private:
  Reconstructed_domain(const Cloud& cloud, Mesh_arrays mesh)
      : m_cloud(cloud), m_cloud_locator(cloud),
        m_vertex_of_cloud(
            std::make_shared<const std::vector<Index>>(std::move(mesh.caller_vertex))),
        m_triangles(std::make_shared<const Surface_arrays>(std::move(mesh.arrays))),
        m_tree(m_triangles)
  {
    if(m_triangles->number_of_triangles() == 0)
      throw Unsupported_surface_error(
          "No surface can be reconstructed: no three surfels are close enough to each other.");
  }

  Cloud m_cloud;
  Surface_locator<Surface> m_cloud_locator;
  std::shared_ptr<const std::vector<Index>> m_vertex_of_cloud; // #vertices
  std::shared_ptr<const Surface_arrays> m_triangles;
  Triangle_tree m_tree;
};

// The domain of a surface for algorithms that require a manifold.
template <typename Surface>
using Manifold_domain_of = std::conditional_t<Is_cloud<Surface>::value,
                                              Reconstructed_domain<Surface>, Mesh_domain<Surface>>;

// Returns the domain of a mesh itself, or the reconstructed domain of a cloud.
template <typename TriangleMesh>
const Mesh_domain<TriangleMesh>& manifold_domain(const Mesh_domain<TriangleMesh>& domain)
{
  return domain;
}
template <typename SurfelRange>
Reconstructed_domain<SurfelRange> manifold_domain(const Surfel_domain<SurfelRange>& domain)
{
  return Reconstructed_domain<SurfelRange>(domain);
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_RECONSTRUCTED_DOMAIN_H
