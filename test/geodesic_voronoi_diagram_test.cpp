// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_voronoi_diagram.h>

#include <CGAL/Geodesic_processing/farthest_point_sampling.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include "Array_surface.h"
#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <set>

namespace geodesic_voronoi_diagram_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Bisectors = std::vector<GP::Voronoi_bisector<Mesh>>;

const std::size_t unreached = std::numeric_limits<std::size_t>::max();

// Round-off errors of coordinates of a unit square.
constexpr double round_off = 1e-12;

TEST(Geodesic_voronoi_diagram, bisector_of_two_square_corners_is_the_diagonal)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation plane = scaled(square(20, 0.2), scale);
    Mesh mesh = mesh_of(plane);
    auto label = vertex_map<std::size_t>(mesh);
    const auto face_label = mesh.add_property_map<Face, std::size_t>("f:label").first;
    Bisectors bisectors;
    GP::geodesic_voronoi_diagram(
        mesh, std::vector<Vertex>{Vertex(0), Vertex(440)}, label,
        GP::parameters::face_label_map(face_label).bisector_output(std::back_inserter(bisectors)));
    // The bisector is the diagonal up to round-off errors.
    ASSERT_EQ(bisectors.size(), 1u);
    EXPECT_EQ(bisectors[0].locations.size(), bisectors[0].points.size());
    for(std::size_t i = 0; i < bisectors[0].points.size(); ++i)
    {
      const Point p = to_array(bisectors[0].points[i]);
      EXPECT_NEAR(p[0] + p[1], scale, round_off * scale);
      EXPECT_LT(distance(p, point_of(mesh, bisectors[0].locations[i])), round_off * scale);
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

TEST(Geodesic_voronoi_diagram, respects_labels_and_maximum_distance)
{
  Mesh mesh = mesh_of(disjoint_union(square(20, 0.2), tetrahedron()));
  auto label = vertex_map<std::size_t>(mesh);
  const auto face_label = mesh.add_property_map<Face, std::size_t>("f:label").first;
  Bisectors bisectors;
  // Two corners share a label, and a third one has another label.
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

TEST(Geodesic_voronoi_diagram, accepts_polyhedron_and_samples)
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

  // On a sphere, three bisectors meet at each Voronoi vertex and cells are disks: 3 (n - 2)
  // bisectors.
  Mesh mesh = mesh_of(icosphere(4));
  const auto domain = GP::make_domain(mesh);
  std::vector<GP::Location<Mesh>> samples;
  GP::farthest_point_sampling(domain, 30, std::back_inserter(samples));
  Bisectors bisectors;
  GP::geodesic_voronoi_diagram(domain, samples, vertex_map<std::size_t>(mesh),
                               GP::parameters::bisector_output(std::back_inserter(bisectors)));
  EXPECT_EQ(bisectors.size(), 84u);
}

TEST(Geodesic_voronoi_diagram, labels_surfels_of_a_cloud)
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
    double min_distance = GP::internal::infinity;
    for(const std::size_t seed : seeds)
      min_distance = std::min(min_distance, to(seed));
    ASSERT_LT(label[i], 4u);
    // A front over local triangles errs by one or two percent.
    EXPECT_NEAR(to(seeds[label[i]]), min_distance, 0.02);
  }
}

TEST(Geodesic_voronoi_diagram, throws_on_invalid_arguments_and_can_be_cancelled)
{
  Mesh mesh = mesh_of(square(20));
  auto label = vertex_map<std::size_t>(mesh);
  EXPECT_THROW(GP::geodesic_voronoi_diagram(mesh, std::vector<Vertex>(), label),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_voronoi_diagram(mesh, Vertex(1000), label), GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_voronoi_diagram(mesh, Vertex(0), label,
                                            GP::parameters::callback(std::function<bool(double)>(
                                                [](double) { return false; }))),
               GP::Cancelled);
}

using Cells = std::map<std::size_t, double>; // areas of the cells by label

// Returns the area of each cell of a cut mesh.
template <typename CutMesh, typename LabelMap>
Cells areas(const CutMesh& cut, const LabelMap& label)
{
  Cells result;
  for(const auto f : faces(cut))
    result[get(label, f)] += CGAL::Polygon_mesh_processing::face_area(f, cut);
  return result;
}

TEST(Geodesic_voronoi_cells, two_cells_are_halves_of_square)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation plane = scaled(square(20, 0.2), scale);
    const Mesh mesh = mesh_of(plane);
    Mesh cut;
    const auto label = cut.add_property_map<Face, std::size_t>("f:label").first;
    GP::geodesic_voronoi_cells(mesh, std::vector<Vertex>{Vertex(0), Vertex(440)}, cut, label);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cut));
    EXPECT_TRUE(CGAL::is_triangle_mesh(cut));
    const Cells found = areas(cut, label);
    ASSERT_EQ(found.size(), 2u);
    // As exact as the diagonal in the bisector test above.
    EXPECT_NEAR(found.at(0) / scale / scale, 0.5, round_off);
    EXPECT_NEAR(found.at(1) / scale / scale, 0.5, round_off);
    for(const Face f : cut.faces())
      for(const Vertex v : vertices_around_face(cut.halfedge(f), cut))
      {
        const double sum = (cut.point(v).x() + cut.point(v).y()) / scale;
        EXPECT_LT(get(label, f) == 0 ? sum : 2. - sum, 1. + round_off);
      }
  }
}

TEST(Geodesic_voronoi_cells, preserve_area_and_topology)
{
  const Mesh mesh = mesh_of(disjoint_union(jittered(icosphere(3), 0.01), square(6, 0.2)));
  std::vector<GP::Location<Mesh>> seeds;
  GP::farthest_point_sampling(mesh, 20, std::back_inserter(seeds));
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  Polyhedron cut;
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, std::size_t> label;
  GP::geodesic_voronoi_cells<GP::Fast_marching>(mesh, seeds, cut,
                                                boost::make_assoc_property_map(label));
  EXPECT_TRUE(cut.is_valid());
  const Cells found = areas(cut, boost::make_assoc_property_map(label));
  EXPECT_EQ(found.size(), 20u);
  double sum = 0.;
  for(const auto& [cell, area] : found)
    sum += area;
  const double total_area = CGAL::Polygon_mesh_processing::area(mesh);
  EXPECT_NEAR(sum, total_area, 1e-12 * total_area); // round-off errors
  const auto euler = [](const auto& m)
  { return long(num_vertices(m)) - long(num_edges(m)) + long(num_faces(m)); };
  EXPECT_EQ(euler(cut), euler(mesh));

  // If no front arrives, there is no cell and no gap.
  Mesh near;
  const auto near_label = near.add_property_map<Face, std::size_t>("f:label").first;
  GP::geodesic_voronoi_cells(GP::make_domain(mesh), seeds[0], near, near_label,
                             GP::parameters::maximum_distance(0.3));
  EXPECT_EQ(near.number_of_faces(), mesh.number_of_faces());
  std::set<std::size_t> labels;
  for(const Face f : near.faces())
    labels.insert(get(near_label, f));
  EXPECT_EQ(labels, (std::set<std::size_t>{0, unreached}));
  EXPECT_THROW(GP::geodesic_voronoi_cells(mesh, Vertex(100000), near, near_label),
               GP::Invalid_argument_error);
}

TEST(Geodesic_voronoi_cells, handle_pinched_mesh)
{
  // Two squares that share a corner.
  Triangulation pair = square(4);
  const Index shared = 24, first = Index(pair.points.size());
  Triangulation other = square(4);
  for(std::size_t i = 1; i < other.points.size(); ++i)
    pair.points.push_back({other.points[i][0] + 1., other.points[i][1] + 1., 0.});
  for(const Index corner : other.corners)
    pair.corners.push_back(corner == 0 ? shared : first + corner - 1);
  const Mesh mesh = mesh_of(pair);
  Mesh cut;
  const auto label = cut.add_property_map<Face, std::size_t>("f:label").first;
  GP::geodesic_voronoi_cells(mesh, std::vector<Vertex>{Vertex(0), Vertex(48)}, cut, label);
  const Cells found = areas(cut, label);
  EXPECT_NEAR(found.at(0) + found.at(1), 2., round_off);
}

} // namespace geodesic_voronoi_diagram_test
