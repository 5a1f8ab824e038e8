// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_base_mesh.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace geodesic_base_mesh_test {

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace GP::test;

TEST(geodesic_base_mesh, regions_are_disks)
{
  for(const Triangulation& surface : {icosphere(3), torus(24, 16), annulus(24, 8, 1., 3.)})
  {
    const Mesh mesh = mesh_of(surface);
    Mesh base, divided;
    const auto base_face = divided.add_property_map<Face, Face>("f:base").first;
    const auto result = GP::geodesic_base_mesh(mesh, 30, base, divided, base_face);
    EXPECT_EQ(num_vertices(base), 30 + result.number_of_added_vertices);
    EXPECT_TRUE(base.is_valid());
    EXPECT_TRUE(divided.is_valid());
    const auto characteristic = [](const Mesh& m)
    { return int(num_vertices(m)) - int(num_edges(m)) + int(num_faces(m)); };
    EXPECT_EQ(characteristic(base), characteristic(mesh));
    EXPECT_EQ(characteristic(divided), characteristic(mesh));
    const double area = PMP::area(mesh);
    EXPECT_NEAR(PMP::area(divided), area, 1e-12 * area); // sums of some hundred areas
    // The traced edges divide the surface into as many pieces as there are base faces.
    std::map<Face, int> faces;
    for(const Face f : divided.faces())
      ++faces[base_face[f]];
    EXPECT_EQ(faces.size(), num_faces(base));
    const auto is_between = divided.add_property_map<Mesh::Edge_index, bool>("e:between").first;
    for(const auto e : divided.edges())
      is_between[e] = !divided.is_border(e) && base_face[divided.face(divided.halfedge(e, 0))] !=
                                                   base_face[divided.face(divided.halfedge(e, 1))];
    const auto component = divided.add_property_map<Face, std::size_t>("f:piece").first;
    EXPECT_EQ(PMP::connected_components(divided, component,
                                        CGAL::parameters::edge_is_constrained_map(is_between)),
              num_faces(base));
  }
}

TEST(geodesic_base_mesh, divides_reconstructed_cloud)
{
  const Surfels surfels = sphere_surfels(3);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  Mesh base, divided;
  const auto base_face = divided.add_property_map<Face, Face>("f:base").first;
  GP::geodesic_base_mesh(surfels, 30, base, divided, base_face, maps);
  EXPECT_EQ(num_faces(base), 2 * num_vertices(base) - 4); // a sphere
  EXPECT_EQ(num_faces(divided), 2 * num_vertices(divided) - 4);
  for(const auto& m : {base, divided})
    for(const Vertex v : m.vertices())
    {
      const double radius = std::sqrt((m.point(v) - CGAL::ORIGIN).squared_length());
      EXPECT_LE(radius, 1. + 1e-14); // round-off errors
      EXPECT_GT(radius, 0.99);       // triangles between 642 surfels are 0.006 below the sphere
    }
}

TEST(geodesic_base_mesh, writes_nothing_when_cancelled)
{
  const std::function<bool(double)> cancel = [](double) { return false; };
  Mesh base, divided;
  const auto base_face = divided.add_property_map<Face, Face>("f:base").first;
  EXPECT_THROW(GP::geodesic_base_mesh(mesh_of(icosphere(2)), 20, base, divided, base_face,
                                      GP::parameters::callback(cancel)),
               GP::Cancelled);
  EXPECT_EQ(num_vertices(base) + num_vertices(divided), 0u);
}

TEST(geodesic_base_mesh, throws_without_triangles)
{
  Mesh base, divided;
  const auto base_face = divided.add_property_map<Face, Face>("f:base").first;
  EXPECT_THROW(GP::geodesic_base_mesh(Mesh(), 20, base, divided, base_face),
               GP::Invalid_argument_error);
}

} // namespace geodesic_base_mesh_test
