// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Five functions give the same results on all models of surfaces.
#include <CGAL/Geodesic_processing/earth_movers_distance.h>
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>
#include <CGAL/Geodesic_processing/logarithmic_map.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace surface_models_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using UV = std::array<double, 2>;

// The results of five functions on a surface of n vertices.
struct Results
{
  std::vector<double> distances;     // from vertex 0
  std::vector<Point> path;           // from vertex n / 2 to vertex 0
  std::vector<std::size_t> samples;  // vertices
  std::vector<UV> logarithmic_map;   // of vertex 0; NaN beyond the maximum distance
  double earth_movers_distance = 0.; // from vertex 0 to vertex n / 2
};

template <typename Domain, typename Vertices>
Results results_on(const Domain& domain, const Vertices& vertices)
{
  using Vertex = typename Domain::Vertex;
  const Kernel::Vector_3 up(0.3, 0.5, 0.8);
  Results result;
  const Vertex first = vertices[0], middle = vertices[vertices.size() / 2];
  std::map<Vertex, double> distance;
  GP::geodesic_distances(domain, first, boost::make_assoc_property_map(distance));
  for(const auto& p : GP::geodesic_path(domain, middle, first).points)
    result.path.push_back(to_array(p));
  std::vector<Vertex> samples;
  GP::farthest_vertex_sampling(domain, 8, std::back_inserter(samples));
  for(const Vertex& sample : samples)
    result.samples.push_back(
        std::size_t(std::find(vertices.begin(), vertices.end(), sample) - vertices.begin()));
  std::map<Vertex, UV> uv;
  // The direction makes the axes independent of the first halfedge of the vertex.
  GP::logarithmic_map(domain, first, boost::make_assoc_property_map(uv),
                      GP::parameters::maximum_distance(1.).up_direction(up));
  for(const Vertex& v : vertices)
  {
    result.distances.push_back(distance.at(v));
    result.logarithmic_map.push_back(uv.at(v));
  }
  result.earth_movers_distance = GP::earth_movers_distance(domain, first, middle).value;
  return result;
}

// The order of the corners of faces changes the order of sums.
constexpr double round_off = 1e-11;

// path_tolerance  the precision of the points of paths
void expect_equal(const Results& found, const Results& expected, double path_tolerance)
{
  EXPECT_EQ(found.samples, expected.samples);
  // The solver stops at a relative gap of 1e-6.
  EXPECT_NEAR(found.earth_movers_distance, expected.earth_movers_distance,
              1e-6 * expected.earth_movers_distance);
  ASSERT_EQ(found.distances.size(), expected.distances.size());
  for(std::size_t i = 0; i < found.distances.size(); ++i)
  {
    EXPECT_NEAR(found.distances[i], expected.distances[i], round_off);
    for(const std::size_t k : {0u, 1u})
      if(std::isnan(expected.logarithmic_map[i][k]))
        EXPECT_TRUE(std::isnan(found.logarithmic_map[i][k]));
      else
        EXPECT_NEAR(found.logarithmic_map[i][k], expected.logarithmic_map[i][k], round_off);
  }
  ASSERT_EQ(found.path.size(), expected.path.size());
  for(std::size_t i = 0; i < found.path.size(); ++i)
    EXPECT_LT(distance(found.path[i], expected.path[i]), path_tolerance);
}

// A sphere without symmetries, so that there are no ties. Its coordinates have type float, so that
// all kernels represent them.
Triangulation sphere()
{
  Triangulation result = jittered(icosphere(2), 0.02);
  for(Point& p : result.points)
    for(double& x : p)
      x = double(float(x));
  return result;
}

Results expected_on_meshes()
{
  Numbered<Mesh> mesh;
  fill(mesh, sphere());
  return results_on(GP::make_domain(mesh.mesh), mesh.vertices);
}

template <typename AnyMesh>
void expect_same_results(double path_tolerance)
{
  Numbered<AnyMesh> mesh;
  fill(mesh, sphere());
  const AnyMesh& constant = mesh.mesh;
  expect_equal(results_on(GP::make_domain(constant), mesh.vertices), expected_on_meshes(),
               path_tolerance);
}

TEST(surface_models, mesh_types_give_equal_results)
{
  expect_same_results<CGAL::Polyhedron_3<Kernel>>(round_off);
  expect_same_results<
      CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>>(round_off);
  expect_same_results<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(1e-6);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  expect_same_results<OpenMesh::TriMesh_ArrayKernelT<>>(1e-6); // its coordinates are of type float
#endif
}

#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
TEST(surface_models, handles_that_add_vertex_returns_are_vertices)
{
  // Since version 9, they are of a class that is derived from VertexHandle.
  using Open_mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  Open_mesh mesh;
  const auto a = mesh.add_vertex({0.f, 0.f, 0.f}), b = mesh.add_vertex({1.f, 0.f, 0.f}),
             c = mesh.add_vertex({0.f, 1.f, 0.f});
  mesh.add_face(a, b, c);
  std::map<Open_mesh::VertexHandle, double> distances;
  GP::geodesic_distances(mesh, a, boost::make_assoc_property_map(distances));
  EXPECT_EQ(distances[b], 1.);
  EXPECT_EQ(GP::geodesic_path(mesh, c, a).length, 1.);
  EXPECT_NEAR(GP::earth_movers_distance(mesh, a, b).value, 1., 1e-3); // the gap
}
#endif

TEST(surface_models, filtered_graph_gives_results_of_its_faces)
{
  Numbered<Mesh> mesh;
  const Triangulation surface = sphere();
  fill(mesh, disjoint_union(surface, icosphere(1)));
  mesh.faces.resize(surface.corners.size() / 3);
  mesh.vertices.resize(surface.points.size());
  const CGAL::Face_filtered_graph<Mesh> filtered(mesh.mesh, mesh.faces);
  ASSERT_EQ(num_faces(filtered), mesh.faces.size());
  expect_equal(results_on(GP::make_domain(filtered), mesh.vertices), expected_on_meshes(),
               round_off);
}

template <typename AnyKernel>
Results results_on_range()
{
  std::vector<std::pair<typename AnyKernel::Point_3, typename AnyKernel::Vector_3>> surfels;
  std::vector<std::size_t> vertices;
  for(const Point& p : sphere().points)
  {
    vertices.push_back(surfels.size());
    surfels.emplace_back(typename AnyKernel::Point_3(p[0], p[1], p[2]),
                         typename AnyKernel::Vector_3(p[0], p[1], p[2]));
  }
  using Surfel = typename decltype(surfels)::value_type;
  return results_on(
      GP::make_domain(surfels, GP::parameters::point_map(CGAL::First_of_pair_property_map<Surfel>())
                                   .normal_map(CGAL::Second_of_pair_property_map<Surfel>())),
      vertices);
}

TEST(surface_models, cloud_types_give_equal_results)
{
  const Results expected = results_on_range<Kernel>();
  expect_equal(results_on_range<CGAL::Exact_predicates_exact_constructions_kernel>(), expected,
               round_off);
  expect_equal(results_on_range<CGAL::Simple_cartesian<float>>(), expected, 1e-6);
  CGAL::Point_set_3<Kernel::Point_3> cloud;
  cloud.add_normal_map();
  std::vector<CGAL::Point_set_3<Kernel::Point_3>::Index> vertices;
  for(const Point& p : sphere().points)
    vertices.push_back(
        *cloud.insert(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(p[0], p[1], p[2])));
  expect_equal(results_on(GP::make_domain(cloud), vertices), expected, round_off);
}

} // namespace surface_models_test
