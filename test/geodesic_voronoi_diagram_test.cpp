// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_voronoi_diagram.h>

#include <CGAL/Geodesic_processing/farthest_point_sampling.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>

#include "Glued_surface.h"
#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <iterator>
#include <map>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Bisectors = std::vector<GP::Voronoi_bisector<Mesh>>;

const std::size_t unreached = std::numeric_limits<std::size_t>::max();

TEST(Geodesic_voronoi_diagram, of_two_corners_of_a_square)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Triangulation plane = square(20, 0.2);
    for(Point& p : plane.points)
      for(double& x : p)
        x *= scale;
    Mesh mesh = mesh_of(plane);
    auto label = vertex_map<std::size_t>(mesh);
    const auto face_label = mesh.add_property_map<Face, std::size_t>("f:label").first;
    Bisectors bisectors;
    EXPECT_TRUE(GP::geodesic_voronoi_diagram(
        mesh, std::vector<Vertex>{Vertex(0), Vertex(440)}, label,
        GP::parameters::face_label_map(face_label).bisector_output(std::back_inserter(bisectors))));
    // The diagonal, up to rounding.
    ASSERT_EQ(bisectors.size(), 1u);
    EXPECT_EQ(bisectors[0].locations.size(), bisectors[0].points.size());
    for(std::size_t i = 0; i < bisectors[0].points.size(); ++i)
    {
      const Point p = to_array(bisectors[0].points[i]);
      EXPECT_NEAR(p[0] + p[1], scale, 1e-9 * scale);
      EXPECT_LT(distance(p, point_of(mesh, bisectors[0].locations[i])), 1e-12 * scale);
    }
    const bool is_up = bisectors[0].points.back().y() > bisectors[0].points.front().y();
    EXPECT_EQ(bisectors[0].left, is_up ? 0u : 1u);
    EXPECT_EQ(bisectors[0].right, is_up ? 1u : 0u);
    for(const Vertex v : mesh.vertices())
    {
      const double sum = mesh.point(v).x() + mesh.point(v).y();
      if(std::abs(sum - scale) > 1e-9 * scale)
      {
        EXPECT_EQ(get(label, v), sum < scale ? 0u : 1u);
      }
    }
    for(const Face f : mesh.faces())
    {
      const Point p = point_of(mesh, GP::Location<Mesh>(f, {1. / 3., 1. / 3., 1. / 3.}));
      if(std::abs(p[0] + p[1] - scale) > 1e-9 * scale)
      {
        EXPECT_EQ(get(face_label, f), p[0] + p[1] < scale ? 0u : 1u);
      }
    }
  }
}

TEST(Geodesic_voronoi_diagram, takes_labels_and_limits)
{
  Mesh mesh = mesh_of(apart(square(20, 0.2), tetrahedron()));
  auto label = vertex_map<std::size_t>(mesh);
  const auto face_label = mesh.add_property_map<Face, std::size_t>("f:label").first;
  Bisectors bisectors;
  // Two corners of one label and one of another.
  const std::vector<GP::Source<Mesh>> seeds = {
      {Vertex(0), 0., 7}, {Vertex(440), 0., 5}, {Vertex(20), 0., 7}};
  GP::geodesic_voronoi_diagram(mesh, seeds, label,
                               GP::parameters::maximum_distance(0.75)
                                   .face_label_map(face_label)
                                   .bisector_output(std::back_inserter(bisectors)));
  for(const Vertex v : mesh.vertices())
  {
    const Point p = to_array(mesh.point(v));
    double near_7 = std::min(distance(p, {0., 0., 0.}), distance(p, {1., 0., 0.}));
    double near_5 = distance(p, {1., 1., 0.});
    std::size_t expected = near_5 < near_7 ? 5 : 7;
    if(std::min(near_5, near_7) > 0.75 || std::size_t(v) > 440)
      expected = unreached;
    if(std::abs(near_5 - near_7) > 1e-9 && std::abs(std::min(near_5, near_7) - 0.75) > 1e-9)
    {
      EXPECT_EQ(get(label, v), expected);
    }
  }
  ASSERT_FALSE(bisectors.empty());
  for(const auto& bisector : bisectors)
    EXPECT_EQ(bisector.left + bisector.right, 12u);
  for(const Face f : mesh.faces())
  {
    bool is_reached = true;
    for(const Vertex v : vertices_around_face(mesh.halfedge(f), mesh))
      is_reached = is_reached && get(label, v) != unreached;
    EXPECT_EQ(get(face_label, f) != unreached, is_reached);
  }
}

TEST(Geodesic_voronoi_diagram, of_other_meshes_and_of_samples)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  Polyhedron polyhedron;
  CGAL::make_icosahedron<Polyhedron, Polyhedron::Point_3>(polyhedron);
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, std::size_t> label;
  std::vector<GP::Voronoi_bisector<Polyhedron>> lines;
  GP::geodesic_voronoi_diagram<GP::Fast_marching>(
      polyhedron, *vertices(polyhedron).first, boost::make_assoc_property_map(label),
      GP::parameters::bisector_output(std::back_inserter(lines)));
  EXPECT_EQ(label.size(), 12u);
  EXPECT_TRUE(lines.empty());

  // On a sphere three lines meet at each place, cells are discs: 3 (n - 2) lines.
  Mesh mesh = mesh_of(icosphere(4));
  const auto domain = GP::make_domain(mesh);
  std::vector<GP::Location<Mesh>> samples;
  GP::farthest_point_sampling(domain, 30, std::back_inserter(samples));
  Bisectors bisectors;
  GP::geodesic_voronoi_diagram(domain, samples, vertex_map<std::size_t>(mesh),
                               GP::parameters::bisector_output(std::back_inserter(bisectors)));
  EXPECT_EQ(bisectors.size(), 84u);
}

TEST(Geodesic_voronoi_diagram, of_a_cloud_has_labels)
{
  const Surfels surfels = sphere_surfels(4);
  CGAL::Point_set_3<Kernel::Point_3> set(true);
  for(const auto& [p, n] : surfels)
    set.insert(p, n);
  const std::vector<std::size_t> seeds = {3, 500, 1000, 2000};
  const auto label = set.add_property_map<std::size_t>("label").first;
  std::vector<CGAL::Point_set_3<Kernel::Point_3>::Index> sites(seeds.begin(), seeds.end());
  GP::geodesic_voronoi_diagram(set, sites, label);
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    const auto to = [&](std::size_t j)
    { return great_circle(to_array(surfels[i].first), to_array(surfels[j].first)); };
    double least = GP::internal::infinity;
    for(const std::size_t seed : seeds)
      least = std::min(least, to(seed));
    ASSERT_LT(label[i], 4u);
    // A front over local triangles is off by a percent or two.
    EXPECT_NEAR(to(seeds[label[i]]), least, 0.02);
  }
}

TEST(Geodesic_voronoi_diagram, says_what_it_cannot_use_and_can_be_cancelled)
{
  Mesh mesh = mesh_of(square(20));
  auto label = vertex_map<std::size_t>(mesh);
  EXPECT_THROW(GP::geodesic_voronoi_diagram(mesh, std::vector<Vertex>(), label),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_voronoi_diagram(mesh, Vertex(1000), label), GP::Invalid_argument_error);
  EXPECT_FALSE(GP::geodesic_voronoi_diagram(
      mesh, Vertex(0), label,
      GP::parameters::callback(std::function<bool(double)>([](double) { return false; }))));
}

} // namespace
