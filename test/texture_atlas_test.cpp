// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/texture_atlas.h>

#include <CGAL/Geodesic_processing/distortion.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/property_map.h>

#include "Mesh_of.h"
#include "openmesh.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace texture_atlas_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using UV = std::array<double, 2>;

// Returns the maximum number of triangles that contain the center of the same texel of a fine
// raster.
template <typename Graph, typename Map>
std::size_t max_triangle_overlap(const Graph& mesh, const Map& uv, int size)
{
  std::vector<int> count(std::size_t(size) * std::size_t(size), 0);
  for(const auto face : faces(mesh))
  {
    const auto h = halfedge(face, mesh);
    const UV p = get(uv, h), q = get(uv, next(h, mesh)), r = get(uv, prev(h, mesh));
    const auto turn = [](const UV& a, const UV& b, const UV& c)
    { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
    for(int j = 0; j < size; ++j)
      for(int i = 0; i < size; ++i)
      {
        const UV x = {(i + 0.5) / size, (j + 0.5) / size};
        count[std::size_t(j * size + i)] +=
            turn(p, q, x) > 0. && turn(q, r, x) > 0. && turn(r, p, x) > 0.;
      }
  }
  return std::size_t(*std::max_element(count.begin(), count.end()));
}

template <typename Graph>
void expect_atlas(const Triangulation& triangulation, std::size_t number)
{
  Numbered<Graph> surface;
  fill(surface, triangulation);
  using Halfedge = typename boost::graph_traits<Graph>::halfedge_descriptor;
  std::map<Halfedge, UV> values;
  std::map<typename Numbered<Graph>::Face, std::size_t> chart;
  const auto uv = boost::make_assoc_property_map(values);
  const GP::Texture_atlas atlas =
      GP::texture_atlas(surface.mesh, number, uv,
                        GP::parameters::texture_size(256).gutter_width(4).chart_map(
                            boost::make_assoc_property_map(chart)));
  EXPECT_TRUE(atlas.is_injective());
  EXPECT_GE(atlas.number_of_charts, number);
  EXPECT_EQ(values.size(), 3 * surface.faces.size());
  EXPECT_EQ(max_triangle_overlap(surface.mesh, uv, 64), 1u);
  std::set<std::size_t> charts;
  for(const auto& [face, one] : chart)
    charts.insert(one);
  EXPECT_EQ(charts.size(), atlas.number_of_charts);
  EXPECT_EQ(*charts.rbegin(), atlas.number_of_charts - 1);
  // Inside charts, the corners of a vertex have equal UV coordinates on both sides of an edge.
  for(const auto face : faces(surface.mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(face, surface.mesh), surface.mesh))
    {
      const auto twin = opposite(h, surface.mesh);
      if(CGAL::is_border(twin, surface.mesh))
        continue;
      const auto other = GP::internal::face_of(twin, surface.mesh);
      if(chart.at(face) == chart.at(other))
      {
        EXPECT_EQ(values.at(h), values.at(prev(twin, surface.mesh)));
      }
    }
  const auto distortion = GP::flattening_distortion(surface.mesh, uv);
  EXPECT_EQ(distortion.number_of_flips, 0u);
  EXPECT_LT(distortion.symmetric_dirichlet,
            5.); // 4 without distortion; cells of a sphere are slightly curved
}

TEST(texture_atlas, accepts_all_mesh_types)
{
  expect_atlas<Mesh>(icosphere(2), 6);
  expect_atlas<CGAL::Polyhedron_3<Kernel>>(icosphere(2), 6);
  expect_atlas<CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>>(
      icosphere(1), 4);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  expect_atlas<OpenMesh::TriMesh_ArrayKernelT<>>(icosphere(2), 6);
#endif
  expect_atlas<Mesh>(torus(20, 10), 8);
  expect_atlas<Mesh>(annulus(30, 4, 1., 2.), 2);
}

TEST(texture_atlas, accepts_domain)
{
  const Mesh mesh = mesh_of(torus(20, 10));
  std::map<Mesh::Halfedge_index, UV> of_mesh, of_domain;
  GP::texture_atlas(mesh, 8, boost::make_assoc_property_map(of_mesh));
  GP::texture_atlas(GP::make_domain(mesh), 8, boost::make_assoc_property_map(of_domain));
  EXPECT_EQ(of_domain, of_mesh);
}

TEST(texture_atlas, reconstructs_cloud)
{
  const Surfels surfels = sphere_surfels(3);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  Mesh output;
  std::map<Mesh::Halfedge_index, UV> uv;
  std::map<Vertex, GP::Location<Surfels>> location;
  std::map<Face, std::size_t> chart;
  const GP::Texture_atlas atlas =
      GP::texture_atlas(surfels, 8, output, boost::make_assoc_property_map(uv),
                        maps.location_map(boost::make_assoc_property_map(location))
                            .chart_map(boost::make_assoc_property_map(chart)));
  EXPECT_TRUE(atlas.is_injective());
  EXPECT_EQ(num_vertices(output), surfels.size());
  EXPECT_EQ(num_faces(output), 2 * surfels.size() - 4); // a sphere
  EXPECT_EQ(uv.size(), 3 * num_faces(output));
  EXPECT_EQ(chart.size(), num_faces(output));
  EXPECT_EQ(max_triangle_overlap(output, boost::make_assoc_property_map(uv), 64), 1u);
  for(const Vertex v : output.vertices())
    EXPECT_EQ(output.point(v), surfels[location.at(v).surfel].first);

  Mesh of_domain;
  std::map<Mesh::Halfedge_index, UV> same;
  CGAL::Unique_hash_map<Vertex, GP::Location<Surfels>> same_location;
  CGAL::Unique_hash_map<Face, std::size_t> same_chart;
  GP::texture_atlas(GP::make_domain(surfels, maps), 8, of_domain,
                    boost::make_assoc_property_map(same),
                    GP::parameters::location_map(boost::make_assoc_property_map(same_location))
                        .chart_map(boost::make_assoc_property_map(same_chart)));
  EXPECT_EQ(same, uv);
  for(const Vertex v : output.vertices())
    EXPECT_EQ(same_location[v].surfel, location.at(v).surfel);
  for(const Face f : output.faces())
    EXPECT_EQ(same_chart[f], chart.at(f));
}

TEST(texture_atlas, texel_density_follows_scale)
{
  double one = 0.;
  for(const double scale : {1., 0x1p-20, 0x1p20})
  {
    const Mesh mesh = mesh_of(scaled(icosphere(2), scale));
    std::map<Mesh::Halfedge_index, Kernel::Point_2> uv;
    const GP::Texture_atlas atlas = GP::texture_atlas(mesh, 8, boost::make_assoc_property_map(uv));
    EXPECT_TRUE(atlas.is_injective());
    one = scale == 1. ? atlas.texels_per_length : one;
    EXPECT_EQ(atlas.texels_per_length * scale, one); // scaling by powers of two is exact
    // Compares both areas, up to area distortion.
    EXPECT_NEAR(atlas.coverage * 1024. * 1024. / (atlas.texels_per_length * scale) /
                    (atlas.texels_per_length * scale),
                4. * GP::internal::pi, 0.05 * 4. * GP::internal::pi);
  }
}

TEST(texture_atlas, is_independent_of_threads)
{
  const Mesh mesh = mesh_of(icosphere(3));
  std::map<Mesh::Halfedge_index, UV> one, three;
  GP::texture_atlas(mesh, 9, boost::make_assoc_property_map(one));
  GP::texture_atlas<GP::Euclidean_front, CGAL::Parallel_tag>(
      mesh, 9, boost::make_assoc_property_map(three), GP::parameters::number_of_threads(3));
  EXPECT_EQ(one, three);
}

TEST(texture_atlas, throws_on_invalid_arguments_and_can_be_cancelled)
{
  const Mesh mesh = mesh_of(icosphere(1));
  std::map<Mesh::Halfedge_index, UV> values;
  const auto uv = boost::make_assoc_property_map(values);
  EXPECT_THROW(GP::texture_atlas(mesh, 0, uv), GP::Invalid_argument_error);
  EXPECT_THROW(GP::texture_atlas(mesh, 2, uv, GP::parameters::texture_size(8)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::texture_atlas(mesh, 40, uv, GP::parameters::texture_size(16).gutter_width(8)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::texture_atlas(mesh, 4, uv,
                                 GP::parameters::callback(
                                     std::function<bool(double)>([](double) { return false; }))),
               GP::Cancelled);
  EXPECT_TRUE(values.empty());
  const auto none = GP::texture_atlas(Mesh(), 4, uv);
  EXPECT_EQ(none.number_of_charts, 0u);
  EXPECT_TRUE(none.is_injective());
}

} // namespace texture_atlas_test
