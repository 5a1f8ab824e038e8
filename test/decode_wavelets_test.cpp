// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/decode_wavelets.h>

#include <CGAL/Geodesic_processing/Subdivision_wavelet.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "openmesh.h"
#include "subdivided_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace decode_wavelets_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Bytes = std::vector<std::uint8_t>;

Bytes stream_of(const Mesh& mesh, unsigned planes = 24)
{
  const GP::Subdivision_wavelet<Mesh> wavelet(mesh);
  return wavelet.encode(wavelet.analyze(mesh.points(), GP::parameters::do_use_frames(true)),
                        GP::parameters::number_of_bit_planes(planes));
}

double root_mean_square(const Mesh& a, const Mesh& b)
{
  double sum = 0.;
  for(const Vertex v : a.vertices())
    sum += (a.point(v) - b.point(v)).squared_length();
  return std::sqrt(sum / double(a.number_of_vertices()));
}

template <typename AnyMesh>
void expect_the_same(const Bytes& bytes, const Mesh& mesh)
{
  AnyMesh decoded;
  const GP::Wavelet_stream stream = GP::decode_wavelets(bytes, decoded);
  EXPECT_TRUE(stream.is_complete);
  EXPECT_FALSE(stream.is_damaged);
  EXPECT_EQ(stream.number_of_levels, 3u);
  EXPECT_EQ(stream.number_of_bit_planes, 24u);
  ASSERT_EQ(num_faces(decoded), mesh.number_of_faces());
  const auto points = get(CGAL::vertex_point, decoded);
  Mesh::size_type i = 0;
  for(const auto v : vertices(decoded))
  {
    const auto& p = mesh.point(Vertex(i++));
    for(int k = 0; k < 3; ++k)
      EXPECT_NEAR(get(points, v)[k], p[k],
                  1e-5); // 24 bit planes below 16; tangential coefficients have 22
  }
}

TEST(decode_wavelets, supports_all_mesh_types)
{
  const Mesh mesh = mesh_of(finest(icosphere(0), 3, onto_bumpy_sphere));
  const Bytes bytes = stream_of(mesh);
  expect_the_same<Mesh>(bytes, mesh);
  expect_the_same<CGAL::Polyhedron_3<Kernel>>(bytes, mesh);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  expect_the_same<OpenMesh::TriMesh_ArrayKernelT<>>(bytes, mesh);
#endif
}

// A mesh with pinched vertices and boundary.
TEST(decode_wavelets, supports_pinched_boundary_vertices)
{
  const Triangulation bow = {
      {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {-1., 0., 0.}, {-1., -1., 0.}},
      {0, 1, 2, 0, 3, 4}};
  const Mesh mesh = mesh_of(finest(bow, 2));
  Mesh decoded;
  EXPECT_TRUE(GP::decode_wavelets(stream_of(mesh), decoded).is_complete);
  EXPECT_EQ(decoded.number_of_faces(), mesh.number_of_faces());
  EXPECT_EQ(decoded.number_of_vertices(), mesh.number_of_vertices());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(decoded));
}

TEST(decode_wavelets, is_idempotent)
{
  const Mesh mesh = mesh_of(finest(square(2), 3));
  Mesh once, twice;
  GP::decode_wavelets(stream_of(mesh), once);
  GP::decode_wavelets(stream_of(once), twice);
  EXPECT_LT(root_mean_square(once, twice), 1e-6); // 24 bit planes for coefficients below 8
}

TEST(decode_wavelets, handles_truncated_and_damaged_streams)
{
  const Mesh mesh = mesh_of(finest(tetrahedron(), 2, onto_bumpy_sphere));
  const Bytes bytes = stream_of(mesh, 10);
  std::size_t meshes = 0;
  for(std::size_t i = 0; i < bytes.size(); ++i)
  {
    Bytes cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(i)), flipped = bytes;
    flipped[i] ^= 0x10;
    for(const Bytes& each : {cut, flipped})
    {
      Mesh decoded;
      try
      {
        const GP::Wavelet_stream stream = GP::decode_wavelets(each, decoded);
        EXPECT_FALSE(stream.is_complete);
        EXPECT_EQ(decoded.number_of_vertices(), mesh.number_of_vertices());
        ++meshes;
      }
      catch(const GP::Invalid_argument_error&)
      {
        EXPECT_EQ(decoded.number_of_vertices(), 0u);
      }
      for(const Vertex v : decoded.vertices())
        ASSERT_TRUE(
            std::isfinite(decoded.point(v).x() + decoded.point(v).y() + decoded.point(v).z()));
    }
  }
  EXPECT_GT(meshes, bytes.size()); // most of the bytes belong to bit planes
}

TEST(decode_wavelets, throws_on_invalid_streams)
{
  Mesh mesh = mesh_of(finest(icosphere(0), 2, onto_bumpy_sphere)), decoded;
  const Bytes bytes = stream_of(mesh);
  EXPECT_THROW(GP::decode_wavelets(bytes, decoded,
                                   GP::parameters::maximum_number_of_vertices(std::size_t(161))),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::decode_wavelets(Bytes(), decoded), GP::Invalid_argument_error);
  EXPECT_THROW(GP::decode_wavelets(Bytes(100, 'G'), decoded), GP::Invalid_argument_error);
  const auto scalar = vertex_map<double>(mesh);
  const GP::Subdivision_wavelet<Mesh> wavelet(mesh);
  EXPECT_THROW(GP::decode_wavelets(wavelet.encode(wavelet.analyze(scalar)), decoded),
               GP::Invalid_argument_error);
  EXPECT_EQ(decoded.number_of_vertices(), 0u);
}

} // namespace decode_wavelets_test
