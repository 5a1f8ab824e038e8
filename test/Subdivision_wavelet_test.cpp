// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Subdivision_wavelet.h>

#include <CGAL/Geodesic_processing/decode_wavelets.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include "Mesh_of.h"
#include "openmesh.h"
#include "subdivided_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace Subdivision_wavelet_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::parameters::do_update;
using GP::parameters::do_use_frames;
using GP::parameters::number_of_levels;
using GP::parameters::wavelet_prediction;

// Round-off errors of up to three levels of lifting steps.
constexpr double round_off = 1e-12;

double largest_difference(const std::vector<Point>& a, const std::vector<Point>& b)
{
  double result = 0.;
  for(std::size_t i = 0; i < a.size(); ++i)
    for(int k = 0; k < 3; ++k)
      result = std::max(result, std::abs(a[i][k] - b[i][k]));
  return result;
}

template <typename AnyMesh>
void expect_identity(const Triangulation& surface, double size)
{
  Numbered<AnyMesh> numbered;
  fill(numbered, surface);
  AnyMesh& mesh = numbered.mesh;
  const auto points = get(CGAL::vertex_point, mesh);
  const GP::Subdivision_wavelet<AnyMesh> wavelet(mesh);
  const GP::Wavelet_details details = wavelet.analyze(points, do_use_frames(true));
  EXPECT_EQ(details.number_of_channels, 3u);
  using Value = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  for(const auto v : numbered.vertices)
    put(points, v, Value(7., 7., 7.));
  wavelet.synthesize(details, points);
  for(std::size_t i = 0; i < surface.points.size(); ++i)
    for(int k = 0; k < 3; ++k)
      ASSERT_NEAR(get(points, numbered.vertices[i])[k], surface.points[i][k], round_off * size);
}

TEST(Subdivision_wavelet, reconstructs_all_mesh_types)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(Triangulation surface :
        {finest(icosphere(0), 3, onto_bumpy_sphere), finest(square(3, 0.2), 2)})
    {
      for(Point& p : surface.points)
        for(double& x : p)
          x *= scale;
      expect_identity<Mesh>(surface, scale);
      expect_identity<CGAL::Polyhedron_3<Kernel>>(surface, scale);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
      // OpenMesh points have single precision.
      expect_identity<OpenMesh::TriMesh_ArrayKernelT<>>(surface, 1e6 * scale);
#endif
    }
}

TEST(Subdivision_wavelet, reports_levels)
{
  const Mesh mesh = mesh_of(finest(icosphere(0), 3, onto_bumpy_sphere));
  const GP::Subdivision_wavelet<Mesh> wavelet(mesh);
  ASSERT_EQ(wavelet.number_of_levels(), 3u);
  for(std::size_t j = 0; j <= 3; ++j) // 10 4^j + 2
  {
    EXPECT_EQ(wavelet.number_of_vertices(j), (std::size_t(10) << (2 * j)) + 2);
    EXPECT_EQ(wavelet.triangles(j).size(), std::size_t(20) << (2 * j));
  }
  EXPECT_EQ(wavelet.number_of_vertices(), mesh.number_of_vertices());
  for(std::size_t i = 0; i < wavelet.number_of_vertices(); ++i)
  {
    EXPECT_EQ(wavelet.vertex(i),
              Vertex(Mesh::size_type(i))); // the vertices were created level by level
    const auto [a, b] = wavelet.parents(i);
    EXPECT_TRUE(i < 12 ? a == i && b == i : a < i && b < i && a != b);
  }
  EXPECT_EQ(GP::Subdivision_wavelet<Mesh>(mesh, number_of_levels(1)).number_of_vertices(0), 162u);
}

// Scalars, colors and points, for any order of the vertices.
TEST(Subdivision_wavelet, supports_scalars_and_arrays)
{
  Triangulation surface = finest(icosphere(0), 2, onto_bumpy_sphere);
  std::vector<Index> permutation(surface.points.size());
  std::iota(permutation.begin(), permutation.end(), 0u);
  std::shuffle(permutation.begin(), permutation.end(), std::mt19937(1));
  std::vector<Point> points(surface.points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    points[permutation[i]] = surface.points[i];
  surface.points = points;
  for(Index& c : surface.corners)
    c = permutation[c];
  Mesh mesh = mesh_of(surface);
  const auto scalar = vertex_map<double>(mesh);
  const auto color = vertex_map<std::array<double, 4>>(mesh);
  for(const Vertex v : mesh.vertices())
  {
    const auto p = mesh.point(v);
    scalar[v] = p.x() * p.y();
    color[v] = {p.x(), p.y() * p.z(), 1., scalar[v]};
  }
  const auto scalar_before = values(mesh, scalar);
  for(const auto prediction : {GP::Wavelet_prediction::linear, GP::Wavelet_prediction::butterfly})
    for(const bool use_update : {false, true})
    {
      const GP::Subdivision_wavelet<Mesh> wavelet(
          mesh, wavelet_prediction(prediction).do_update(use_update));
      const auto scalar_details = wavelet.analyze(scalar), color_details = wavelet.analyze(color);
      EXPECT_EQ(color_details.number_of_channels, 4u);
      for(std::size_t i = 0; i < wavelet.number_of_vertices(); ++i)
        EXPECT_NEAR(color_details.values[4 * i + 3], scalar_details.values[i], round_off);
      for(const Vertex v : mesh.vertices())
        scalar[v] = 0.;
      wavelet.synthesize(scalar_details, scalar);
      for(const Vertex v : mesh.vertices())
        EXPECT_NEAR(scalar[v], scalar_before[std::size_t(v)], round_off);
      EXPECT_THROW(wavelet.synthesize(color_details, scalar), GP::Invalid_argument_error);
      EXPECT_THROW(wavelet.analyze(scalar, do_use_frames(true)), GP::Invalid_argument_error);
    }
}

TEST(Subdivision_wavelet, updates_preserve_mean)
{
  // A closed surface without irregular vertices: on the regular torus, all vertices have equal
  // weight.
  const std::size_t n = 6;
  Triangulation torus;
  for(std::size_t i = 0; i < n * n; ++i)
    torus.points.push_back({double(i), double(i * i % 7), double(i % 5)});
  for(Index j = 0; j < n; ++j)
    for(Index i = 0; i < n; ++i)
    {
      const Index a = Index(n * j + i), b = Index(n * j + (i + 1) % n),
                  c = Index(n * ((j + 1) % n) + (i + 1) % n), d = Index(n * ((j + 1) % n) + i);
      torus.corners.insert(torus.corners.end(), {a, b, c, a, c, d});
    }
  const Mesh mesh = mesh_of(finest(torus, 2));
  const GP::Subdivision_wavelet<Mesh> wavelet(mesh, number_of_levels(2));
  const auto details = wavelet.analyze(mesh.points());
  double fine = 0., coarse = 0.;
  for(const Vertex v : mesh.vertices())
    fine += mesh.point(v).x() / double(mesh.number_of_vertices());
  for(std::size_t i = 0; i < wavelet.number_of_vertices(0); ++i)
    coarse += details.values[3 * i] / double(wavelet.number_of_vertices(0));
  EXPECT_NEAR(coarse, fine, round_off * 36.);
}

TEST(Subdivision_wavelet, error_decreases_with_number_of_details)
{
  Mesh mesh = mesh_of(finest(icosphere(0), 4, onto_bumpy_sphere));
  const GP::Subdivision_wavelet<Mesh> wavelet(mesh);
  const auto details = wavelet.analyze(mesh.points(), do_use_frames(true));
  std::vector<Point> before;
  for(const Vertex v : mesh.vertices())
    before.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  double last = 0.;
  for(const std::size_t number : {2550u, 1000u, 250u, 50u, 0u})
  {
    auto kept = details;
    wavelet.keep_largest(kept, number);
    wavelet.synthesize(kept, mesh.points());
    std::vector<Point> after;
    for(const Vertex v : mesh.vertices())
      after.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
    const double error = largest_difference(before, after);
    EXPECT_GT(error, last);
    last = error;
  }
  EXPECT_LT(last, 0.3); // deviation of an icosahedron from a bumpy sphere
}

TEST(Subdivision_wavelet, throws_on_invalid_input)
{
  using Wavelet = GP::Subdivision_wavelet<Mesh>;
  EXPECT_THROW(Wavelet(mesh_of(icosphere(0))), GP::Unsupported_surface_error);
  EXPECT_THROW(Wavelet(mesh_of(square(3))), GP::Unsupported_surface_error);
  EXPECT_THROW((Wavelet(Mesh())), GP::Unsupported_surface_error);
  EXPECT_THROW(Wavelet(mesh_of(finest(icosphere(0), 2)), number_of_levels(0)),
               GP::Unsupported_surface_error);
  Mesh quad;
  std::vector<Vertex> corners;
  for(int i = 0; i < 4; ++i)
    corners.push_back(quad.add_vertex(Kernel::Point_3(i / 2, i % 2, 0.)));
  quad.add_face(corners[0], corners[1], corners[3], corners[2]);
  EXPECT_THROW((Wavelet(quad)), GP::Unsupported_surface_error);

  Mesh mesh = mesh_of(finest(icosphere(0), 1));
  const Wavelet wavelet(mesh);
  auto details = wavelet.analyze(mesh.points());
  EXPECT_THROW(wavelet.encode(details, GP::parameters::number_of_bit_planes(0u)),
               GP::Invalid_argument_error);
  details.values.pop_back();
  EXPECT_THROW(wavelet.encode(details), GP::Invalid_argument_error);
  EXPECT_THROW(wavelet.keep_largest(details, 3), GP::Invalid_argument_error);
  mesh.point(Vertex(3)) = Kernel::Point_3(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  EXPECT_THROW(wavelet.analyze(mesh.points()), GP::Invalid_argument_error);
}

TEST(Subdivision_wavelet, supports_components_and_isolated_vertices)
{
  Triangulation surface = finest(icosphere(0), 2, onto_bumpy_sphere);
  const Index n = Index(surface.points.size());
  const Triangulation other = finest(one_triangle(), 3);
  surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
  for(const Index c : other.corners)
    surface.corners.push_back(n + c);
  surface.points.push_back({5., 6., 7.});
  Mesh mesh = mesh_of(surface);
  const GP::Subdivision_wavelet<Mesh> wavelet(mesh);
  EXPECT_EQ(wavelet.number_of_levels(), 2u);
  const auto details = wavelet.analyze(mesh.points());
  Mesh decoded;
  EXPECT_TRUE(GP::decode_wavelets(wavelet.encode(details), decoded).is_complete);
  EXPECT_EQ(decoded.number_of_faces(), mesh.number_of_faces());
  ASSERT_EQ(decoded.number_of_vertices(), mesh.number_of_vertices());
  for(std::size_t i = 0; i < wavelet.number_of_vertices(); ++i)
  {
    const auto difference =
        decoded.point(Vertex(Mesh::size_type(i))) - mesh.point(wavelet.vertex(i));
    // 24 bit planes for coefficients below 16 times 7.
    EXPECT_LT(std::sqrt(difference.squared_length()), 112. * std::ldexp(1., -20));
  }
}

TEST(Subdivision_wavelet, accepts_domain)
{
  const Mesh mesh = mesh_of(icosphere(2));
  const GP::Subdivision_wavelet<Mesh> of_mesh(mesh), of_domain(GP::make_domain(mesh));
  EXPECT_EQ(of_domain.number_of_levels(), of_mesh.number_of_levels());
  EXPECT_EQ(of_domain.analyze(mesh.points()).values, of_mesh.analyze(mesh.points()).values);
}

} // namespace Subdivision_wavelet_test
