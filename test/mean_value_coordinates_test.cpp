// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/mean_value_coordinates.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <map>

namespace mean_value_coordinates_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Sums of some hundred angles.
constexpr double round_off = 1e-12;

TEST(mean_value_coordinates, reproduce_point)
{
  Mesh mesh = mesh_of(jittered(icosphere(2), 0.05));
  const auto coordinates = vertex_map(mesh);
  for(const Kernel::Point_3& point : {Kernel::Point_3(0.1, 0.3, -0.2), Kernel::Point_3(1., 2., 0.)})
  {
    GP::mean_value_coordinates(GP::make_domain(mesh), point, coordinates);
    double sum = 0.;
    Kernel::Vector_3 weighted_sum(0., 0., 0.);
    for(const Vertex v : mesh.vertices())
    {
      sum += coordinates[v];
      weighted_sum += coordinates[v] * (mesh.point(v) - CGAL::ORIGIN);
    }
    EXPECT_NEAR(sum, 1., round_off);
    EXPECT_LT((weighted_sum - (point - CGAL::ORIGIN)).squared_length(), round_off * round_off);
  }
}

// With four vertices, barycentric coordinates are unique.
template <typename AnyMesh, typename Point>
void expect_barycentric(const Point& point)
{
  Numbered<AnyMesh> shape;
  fill(shape, tetrahedron());
  std::map<typename boost::graph_traits<AnyMesh>::vertex_descriptor, double> found;
  GP::mean_value_coordinates(shape.mesh, point, boost::make_assoc_property_map(found));
  for(std::size_t i = 0; i < 4; ++i)
  {
    const auto p = tetrahedron().points[i];
    EXPECT_NEAR(found[shape.vertices[i]],
                0.25 +
                    0.25 * (p[0] * CGAL::to_double(point.x()) + p[1] * CGAL::to_double(point.y()) +
                            p[2] * CGAL::to_double(point.z())),
                round_off);
  }
}

TEST(mean_value_coordinates, accept_all_meshes_and_kernels)
{
  expect_barycentric<Mesh>(Kernel::Point_3(0.1, 0.2, -0.3));
  expect_barycentric<CGAL::Polyhedron_3<Kernel>>(Kernel::Point_3(2., -1., 0.5));
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  expect_barycentric<OpenMesh::TriMesh_ArrayKernelT<>>(Kernel::Point_3(0.1, 0.2, -0.3));
#endif
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  expect_barycentric<Mesh>(Exact::Point_3(0.25, 0.5, 0.125));
}

TEST(mean_value_coordinates, throws_on_open_meshes)
{
  Mesh mesh = mesh_of(square(3));
  EXPECT_THROW(GP::mean_value_coordinates(mesh, Kernel::Point_3(0., 0., 1.), vertex_map(mesh)),
               GP::Unsupported_surface_error);
}

} // namespace mean_value_coordinates_test
