// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/minimize_distortion.h>

#include <CGAL/Geodesic_processing/distortion.h>
#include <CGAL/Geodesic_processing/geodesic_lle.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "openmesh.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace minimize_distortion_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using UV = std::array<double, 2>;

Triangulation dome()
{
  return grid(
      12, 12,
      [](double s, double t) -> Point
      {
        const double x = 2. * s - 1., y = 2. * t - 1.;
        return {x, y, std::exp(-3. * (x * x + y * y))};
      },
      0.2);
}

TEST(minimize_distortion, result_has_no_flips)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Mesh mesh = mesh_of(scaled(dome(), scale));
    auto good = vertex_map<UV>(mesh), bad = vertex_map<UV>(mesh);
    for(const Vertex v : mesh.vertices())
    {
      good[v] = {mesh.point(v).x(), mesh.point(v).y()};
      bad[v] = {std::abs(mesh.point(v).x()), mesh.point(v).y()};
    }
    const auto from_good = GP::minimize_distortion(mesh, good);
    const auto from_bad = GP::minimize_distortion(mesh, bad);
    EXPECT_EQ(from_good.number_of_flips_before, 0u);
    EXPECT_GT(from_bad.number_of_flips_before, 0u);
    for(const auto* found : {&from_good, &from_bad})
      EXPECT_EQ(found->number_of_flips, 0u);
    // Both runs converge to the same minimum, up to the last step's relative decrease of 1e-6.
    EXPECT_NEAR(from_good.symmetric_dirichlet, from_bad.symmetric_dirichlet, 2e-5);
    const auto distortion = GP::flattening_distortion(mesh, good);
    EXPECT_EQ(distortion.number_of_flips, 0u);
    // Both use the optimal scale up to differences of areas.
    EXPECT_NEAR(distortion.symmetric_dirichlet, from_good.symmetric_dirichlet, 0.01);
  }
}

template <typename M>
double minimum_of()
{
  Numbered<M> mesh;
  fill(mesh, dome());
  auto uv = get(CGAL::dynamic_vertex_property_t<UV>(), mesh.mesh);
  GP::geodesic_lle(mesh.mesh, uv, GP::parameters::number_of_base_points(std::size_t(50)));
  const auto found = GP::minimize_distortion(mesh.mesh, uv);
  EXPECT_EQ(found.number_of_flips, 0u);
  return found.symmetric_dirichlet;
}

TEST(minimize_distortion, is_independent_of_mesh_type)
{
  const double expected = minimum_of<Mesh>();
  // Each run stops when a step decreases the energy by less than 1e-6.
  const double error = 1e-5;
  EXPECT_NEAR(minimum_of<CGAL::Polyhedron_3<Kernel>>(), expected, error);
#ifdef GEODESIC_PROCESSING_HAS_OPENMESH
  EXPECT_NEAR(minimum_of<OpenMesh::TriMesh_ArrayKernelT<>>(), expected, error);
#endif
}

TEST(minimize_distortion, throws_on_invalid_arguments)
{
  Mesh sphere = mesh_of(icosphere(1));
  EXPECT_THROW(GP::minimize_distortion(sphere, vertex_map<UV>(sphere)),
               GP::Unsupported_surface_error);
  Mesh plane = mesh_of(square(3));
  auto uv = vertex_map<UV>(plane);
  uv[Vertex(2)][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(GP::minimize_distortion(plane, uv), GP::Invalid_argument_error);
}

TEST(minimize_distortion, distortion_is_close_to_arap_on_rough_patches)
{
  // Mean symmetric Dirichlet energies of CGAL's ARAP_parameterizer_3 with default parameters, which
  // takes minutes without optimization. Its maps of these patches have no flips. The energies of
  // models were measured by test/benchmark/flattening.cpp, the others in the same way.
  struct Patch
  {
    std::string name;
    Mesh mesh;
    double arap_energy;
  };
  const auto upper_half = [](const Point& p) { return p[2] > 0.; };
  std::vector<Patch> patches = {
      {"half of a sphere", mesh_of(part_of(icosphere(4), upper_half)), 4.11965},
      {"back of an animal", mesh_of(part_of(animal(), upper_half)), 4.42972},
      {"three peaks", mesh_of(three_peaks()), 7.69481},
      {"mushroom", mesh_of(mushroom()), 5.32358}};
  for(const auto& [name, energy] :
      {std::pair("hemisphere_2k.ply", 4.14203), std::pair("patch_01_735.off", 4.2544),
       std::pair("nefertiti_299.off", 4.03724), std::pair("three_peaks_2k.off", 6.25898),
       std::pair("mushroom_2k.off", 5.86005)})
    if(Mesh mesh; read_model(std::string("patches/") + name, mesh))
      patches.push_back({name, std::move(mesh), energy});
  for(auto& [name, mesh, arap_energy] : patches)
  {
    auto uv = vertex_map<UV>(mesh);
    GP::geodesic_lle(mesh, uv);
    GP::minimize_distortion(mesh, uv);
    const auto distortion = GP::flattening_distortion(mesh, uv);
    EXPECT_EQ(distortion.number_of_flips, 0u) << name;
    EXPECT_LE(distortion.symmetric_dirichlet, 1.05 * arap_energy) << name; // the required bound
  }
}

} // namespace minimize_distortion_test
