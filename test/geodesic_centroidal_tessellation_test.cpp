// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_centroidal_tessellation.h>

#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "meshes.h"
#include "openmesh.h"
#include "rough_surfaces.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace geodesic_centroidal_tessellation_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

const std::size_t no_label = std::numeric_limits<std::size_t>::max();

// Returns the corners of the faces of each cell.
std::map<std::size_t, std::vector<Index>> patches(const Triangulation& surface,
                                                  const std::vector<std::size_t>& label)
{
  std::map<std::size_t, std::vector<Index>> result;
  for(std::size_t f = 0; f < label.size(); ++f)
    for(int k = 0; k < 3; ++k)
      result[label[f]].push_back(surface.corners[3 * f + k]);
  return result;
}

template <typename Surface, typename NamedParameters>
std::vector<std::size_t> labels(const Numbered<Surface>& surface, std::size_t number,
                                const NamedParameters& np, std::size_t& cells)
{
  std::map<typename Numbered<Surface>::Face, std::size_t> map;
  cells = GP::geodesic_centroidal_tessellation(surface.mesh, number,
                                               boost::make_assoc_property_map(map), np);
  std::vector<std::size_t> result;
  for(const auto face : surface.faces)
    result.push_back(map.at(face));
  return result;
}

template <typename Surface>
void expect_disks(const Triangulation& triangulation, std::size_t number)
{
  Numbered<Surface> surface;
  fill(surface, triangulation);
  std::vector<double> energies;
  std::size_t cells = 0;
  const auto label = labels(
      surface, number,
      GP::parameters::do_make_discs(true).energy_output(std::back_inserter(energies)), cells);
  const Topology disk = {true, {{1, 1}}};
  const auto found = patches(triangulation, label);
  EXPECT_EQ(found.size(), cells);
  EXPECT_GE(cells, number);
  for(const auto& [cell, corners] : found)
  {
    EXPECT_LT(cell, cells);
    EXPECT_EQ(topology(corners), disk) << cell;
  }
  EXPECT_TRUE(std::is_sorted(energies.rbegin(), energies.rend()));
}

using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;

TEST(Geodesic_centroidal_tessellation, patches_are_disks_on_all_mesh_types)
{
  for(const std::size_t number : {1, 4, 20})
    for(const Triangulation& surface :
        {icosphere(3), jittered(torus(24, 12), 0.02), cylinder(16, 9, 1., 3.), square(12, 0.2)})
    {
      expect_disks<Mesh>(surface, number);
      expect_disks<Polyhedron>(surface, number);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
      expect_disks<OpenMesh::TriMesh_ArrayKernelT<>>(surface, number);
#endif
    }
}

TEST(Geodesic_centroidal_tessellation, is_scale_invariant)
{
  std::vector<std::size_t> first;
  double energy = 0.;
  for(const double scale : {1., 0x1p-20, 0x1p20})
  {
    Numbered<Mesh> surface;
    fill(surface, scaled(jittered(icosphere(3), 0.03), scale));
    std::vector<double> energies;
    std::size_t cells = 0;
    const auto label =
        labels(surface, 15, GP::parameters::energy_output(std::back_inserter(energies)), cells);
    EXPECT_EQ(cells, 15u);
    if(first.empty())
    {
      first = label;
      energy = energies.back();
    }
    // Scaling by powers of two is exact.
    EXPECT_EQ(label, first);
    EXPECT_EQ(energies.back(), std::pow(scale, 4) * energy);
  }
}

TEST(Geodesic_centroidal_tessellation, faces_belong_to_nearest_center)
{
  Mesh mesh = mesh_of(icosphere(4));
  const auto label = mesh.add_property_map<Face, std::size_t>("f:label").first;
  std::vector<GP::Location<Mesh>> centers;
  const std::size_t cells = GP::geodesic_centroidal_tessellation(
      mesh, 12, label, GP::parameters::center_output(std::back_inserter(centers)));
  ASSERT_EQ(cells, 12u);
  ASSERT_EQ(centers.size(), 12u);
  std::vector<double> area(12, 0.);
  for(const Face f : mesh.faces())
  {
    ASSERT_LT(get(label, f), 12u);
    const Point p = point_of(mesh, GP::Location<Mesh>(f, {1. / 3., 1. / 3., 1. / 3.}));
    std::vector<double> distances;
    for(const auto& center : centers)
      distances.push_back(distance(p, point_of(mesh, center)));
    // The tolerance is the longest edge of this icosphere, because faces are assigned with their
    // corners.
    EXPECT_LT(distances[get(label, f)],
              *std::min_element(distances.begin(), distances.end()) + 0.0812);
    area[get(label, f)] += 1. / double(mesh.number_of_faces());
  }
  // Twelve cells of nearly equal area. The initial farthest point samples have cells whose areas
  // differ by a factor of two.
  for(const double fraction : area)
    EXPECT_NEAR(fraction, 1. / 12., 0.25 / 12.);
}

TEST(Geodesic_centroidal_tessellation, cloud_result_is_independent_of_threads)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::Point_set_3<Kernel::Point_3> cloud;
  cloud.add_normal_map();
  const Triangulation sphere = icosphere(4);
  for(const Point& p : sphere.points)
    cloud.insert({p[0], p[1], p[2]}, {p[0], p[1], p[2]});
  std::vector<std::vector<std::size_t>> found;
  for(const unsigned number_of_threads : {1u, 2u})
  {
    const auto label = cloud.add_property_map<std::size_t>("label", no_label).first;
    const std::size_t cells =
        GP::geodesic_centroidal_tessellation<GP::Euclidean_front, CGAL::Parallel_tag>(
            cloud, 20, label, GP::parameters::number_of_threads(number_of_threads));
    EXPECT_EQ(cells, 20u);
    found.emplace_back();
    for(const auto& surfel : cloud)
      found.back().push_back(get(label, surfel));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(std::set<std::size_t>(found[0].begin(), found[0].end()).size(), 20u);
}

TEST(Geodesic_centroidal_tessellation, respects_method_speed_and_iteration_limit)
{
  Mesh mesh = mesh_of(square(20, 0.2));
  const auto label = mesh.add_property_map<Face, std::size_t>("f:label").first;
  const auto speed = mesh.add_property_map<Vertex, double>("v:speed", 1.).first;
  for(const Vertex v : mesh.vertices())
    put(speed, v, mesh.point(v).x() < 0.5 ? 1. : 0.25);
  std::vector<GP::Location<Mesh>> centers;
  GP::geodesic_centroidal_tessellation<GP::Fast_marching>(
      mesh, 30, label, GP::parameters::speed_map(speed).center_output(std::back_inserter(centers)));
  const auto slow =
      std::count_if(centers.begin(), centers.end(),
                    [&](const auto& center) { return point_of(mesh, center)[0] > 0.5; });
  // In the limit of small cells, the right half has sixteen cells per cell on the left.
  EXPECT_GT(slow, 24);

  std::vector<double> energies;
  GP::geodesic_centroidal_tessellation<GP::Dijkstra>(
      mesh, 10, label,
      GP::parameters::maximum_number_of_iterations(2u).energy_output(std::back_inserter(energies)));
  EXPECT_EQ(energies.size(), 3u);
  EXPECT_THROW(GP::geodesic_centroidal_tessellation(mesh, 0, label), GP::Invalid_argument_error);
  // If more cells are requested than there are vertices, the result has at most one cell per
  // vertex.
  Mesh small = mesh_of(tetrahedron());
  const auto small_label = small.add_property_map<Face, std::size_t>("f:label").first;
  const std::size_t cells = GP::geodesic_centroidal_tessellation(small, 100, small_label);
  EXPECT_LE(cells, 4u);
  EXPECT_GE(cells, 1u);
}

TEST(Geodesic_centroidal_tessellation, patches_are_disks_on_rough_surfaces)
{
  // Each surface is connected. The knot and the rotor have handles, and the shark's boundary cycles
  // are holes.
  std::vector<std::pair<std::string, Triangulation>> surfaces = {
      {"animal", animal()}, {"knot", knot(200, 16)}, {"bone", bone()}};
  add_models(surfaces, {"meshes/fandisk_6k5.off", "meshes/rotor_2k4.off",
                        "meshes/mech_holes_shark_5k.off", "meshes/elephant_2k8.off"});
  for(const auto& [name, surface] : surfaces)
  {
    SCOPED_TRACE(name);
    expect_disks<Mesh>(surface, 30);
  }
}

} // namespace geodesic_centroidal_tessellation_test
