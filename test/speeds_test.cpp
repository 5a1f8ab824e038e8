// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/speeds.h>

#include <CGAL/Geodesic_processing/farthest_point_sampling.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <map>

namespace speeds_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::internal::operator*;

template <typename Speed = GP::Edge_attractive,
          typename NamedParameters = GP::internal::Default_parameters>
std::vector<double> speeds_of(const Triangulation& shape,
                              const NamedParameters& np = NamedParameters())
{
  Mesh mesh = mesh_of(shape);
  auto speed = vertex_map(mesh);
  GP::curvature_speeds<Speed>(mesh, speed, np);
  return values(mesh, speed);
}

TEST(Curvature_speeds, are_one_half_and_two_on_spheres)
{
  for(const double scale : {1., 1e-6, 1e6})
  {
    const Triangulation sphere = scaled(icosphere(4), scale);
    // Curvatures are accurate to 5 %, as in the kernel's test. The sum in the formula halves this
    // error.
    const double error = 0.025;
    for(const double speed : speeds_of(sphere))
      EXPECT_NEAR(speed, 0.5, error * 0.5);
    for(const double speed : speeds_of<GP::Edge_repulsive>(sphere))
      EXPECT_NEAR(speed, 2., error * 2.);
  }
}

TEST(Curvature_speeds, depend_on_strength)
{
  const Triangulation shape = jittered(icosphere(2), 0.1);
  for(const double speed : speeds_of(shape, GP::parameters::strength(0)))
    EXPECT_EQ(speed, 1.);
  const auto slow = speeds_of(shape, GP::parameters::strength(0.3)),
             fast = speeds_of<GP::Edge_repulsive>(shape, GP::parameters::strength(0.3)),
             faster = speeds_of<GP::Edge_repulsive>(shape, GP::parameters::strength(0.6));
  for(std::size_t i = 0; i < slow.size(); ++i)
  {
    EXPECT_LT(slow[i], 1.);
    EXPECT_NEAR(slow[i] * fast[i], 1., 1e-14); // round-off errors
    EXPECT_NEAR(faster[i] - 1., 2. * (fast[i] - 1.), 1e-13 * faster[i]);
  }
  // Smoothed over a ball that contains most of the surface, curvature is nearly constant.
  const auto smooth = speeds_of(shape, GP::parameters::ball_radius(1.5).strength(0.3));
  const auto spread = [](const std::vector<double>& x)
  { return *std::max_element(x.begin(), x.end()) / *std::min_element(x.begin(), x.end()); };
  EXPECT_LT(spread(smooth), spread(slow));
}

TEST(Curvature_speeds, agree_on_meshes_and_clouds)
{
  const Triangulation sphere = icosphere(4);
  const auto on_mesh = speeds_of(sphere);
  Numbered<CGAL::Polyhedron_3<Kernel>> polyhedron;
  fill(polyhedron, sphere);
  std::map<Numbered<CGAL::Polyhedron_3<Kernel>>::Vertex, double> on_polyhedron;
  GP::curvature_speeds<GP::Edge_attractive, CGAL::Parallel_tag>(
      polyhedron.mesh, boost::make_assoc_property_map(on_polyhedron),
      GP::parameters::number_of_threads(2));
  for(Index i = 0; i < sphere.points.size(); ++i)
    EXPECT_EQ(on_polyhedron[polyhedron.vertices[i]], on_mesh[i]);

  const Surfels surfels = sphere_surfels(4);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  std::vector<double> on_cloud(surfels.size());
  GP::curvature_speeds(surfels, CGAL::make_property_map(on_cloud), maps);
  // The curvature fit loses 1 %, and the area of the local triangles 1 %.
  for(const double speed : on_cloud)
    EXPECT_NEAR(speed, 0.5, 0.01);
}

// A torus has its largest curvature on the outer equator. Speeds are high near vertices with the
// base's curvature.
TEST(Similar_curvature_speeds, decrease_with_mean_curvature_difference)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation shape = scaled(torus(60, 30), scale);
    Mesh mesh = mesh_of(shape);
    auto speed = vertex_map(mesh);
    const auto radius = [&](Vertex v)
    { return std::hypot(mesh.point(v).x(), mesh.point(v).y()) / scale; };
    Vertex outside(0), inside(0);
    for(const Vertex v : mesh.vertices())
    {
      outside = radius(v) > radius(outside) ? v : outside;
      inside = radius(v) < radius(inside) ? v : inside;
    }
    for(const Vertex base : {outside, inside})
    {
      GP::similar_curvature_speeds(mesh, base, speed);
      EXPECT_EQ(speed[base], 1.);
      const Vertex other = base == outside ? inside : outside;
      EXPECT_LT(speed[other], 0.75);
      for(const Vertex v : mesh.vertices())
      {
        EXPECT_GT(speed[v], 0.);
        EXPECT_LE(speed[v], 1.);
        if(std::abs(radius(v) - radius(base)) < 1e-9)
        {
          EXPECT_GT(speed[v], 0.95); // the curvature tensors of a ring differ by a few percent
        }
      }
    }
    const auto before = values(mesh, speed);
    GP::similar_curvature_speeds<CGAL::Parallel_tag>(mesh, inside, speed,
                                                     GP::parameters::number_of_threads(2));
    EXPECT_EQ(values(mesh, speed), before);
    GP::similar_curvature_speeds(mesh, inside, speed, GP::parameters::strength(0));
    EXPECT_EQ(speed[outside], 1.);
    EXPECT_THROW(GP::similar_curvature_speeds(mesh, inside, speed, GP::parameters::strength(-1)),
                 GP::Invalid_argument_error);
    EXPECT_THROW(GP::similar_curvature_speeds(mesh, Vertex(1u << 30), speed),
                 GP::Invalid_argument_error);
  }
}

// Returns how many of 120 samples of a sheet lie within 0.1 of the crease along its center line.
template <typename SpeedMap>
std::size_t samples_at_crease(const Mesh& mesh, SpeedMap speed)
{
  std::vector<GP::Location<Mesh>> samples;
  GP::farthest_point_sampling(mesh, 120, std::back_inserter(samples),
                              GP::parameters::speed_map(speed));
  return std::count_if(samples.begin(), samples.end(),
                       [&](const auto& sample)
                       { return std::abs(point_of(mesh, sample)[0] - 0.5) < 0.1; });
}

TEST(Curvature_speeds, attract_or_repel_samples_at_creases)
{
  Mesh mesh = mesh_of(grid(40, 40,
                           [](double u, double v) {
                             return Point{u, v, std::abs(u - 0.5)};
                           }));
  auto speed = vertex_map(mesh);
  GP::curvature_speeds(mesh, speed, GP::parameters::strength(0.));
  const std::size_t plain = samples_at_crease(mesh, speed);
  GP::curvature_speeds(mesh, speed);
  EXPECT_GT(samples_at_crease(mesh, speed), 2 * plain);
  GP::curvature_speeds<GP::Edge_repulsive>(mesh, speed);
  EXPECT_LT(3 * samples_at_crease(mesh, speed), 2 * plain);
}

TEST(Image_speeds, are_exact_for_linear_images)
{
  Mesh mesh = mesh_of(square(10, 0.2));
  auto speed = vertex_map(mesh), image = vertex_map(mesh);
  auto color = vertex_map<CGAL::IO::Color>(mesh);
  for(const Vertex v : mesh.vertices())
  {
    put(image, v, 3. * mesh.point(v).x() + 4. * mesh.point(v).y() - 2.);
    put(color, v, CGAL::IO::Color(7, 7, 7));
  }
  for(const double strength : {0., 1., 20.})
  {
    GP::image_speeds(mesh, image, speed, GP::parameters::strength(strength));
    for(const double x : values(mesh, speed))
      EXPECT_NEAR(x, 1. / (1. + strength), 1e-12); // round-off errors
  }
  GP::image_speeds(mesh, color, speed);
  for(const double x : values(mesh, speed))
    EXPECT_EQ(x, 1.);
}

TEST(Image_speeds, are_scale_invariant)
{
  std::vector<std::vector<double>> all;
  for(const double scale : {1., 1e-6, 1e6})
  {
    const Triangulation sheet = scaled(square(20, 0.2), scale);
    Mesh mesh = mesh_of(sheet);
    auto speed = vertex_map(mesh), image = vertex_map(mesh);
    for(const Vertex v : mesh.vertices())
      put(image, v, std::sin(6. * mesh.point(v).x() / scale) / scale);
    GP::image_speeds(mesh, image, speed);
    all.push_back(values(mesh, speed));
  }
  for(std::size_t i = 0; i < all[0].size(); ++i)
    for(const std::size_t k : {1u, 2u})
      EXPECT_NEAR(all[k][i], all[0][i], 1e-11); // round-off errors in slopes of differences
}

TEST(Image_speeds, support_colors_and_clouds)
{
  // Black, then red. Speed is low at the color change and depends on the strength and the size of
  // the change.
  const Surfels surfels = flat_surfels(2000);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  std::vector<CGAL::IO::Color> color;
  for(const auto& [point, normal] : surfels)
    color.emplace_back(point.x() < 0.5 ? 0 : 255, 0, 0);
  std::vector<double> speed(surfels.size());
  GP::image_speeds(surfels, CGAL::make_property_map(color), CGAL::make_property_map(speed), maps);
  EXPECT_NEAR(*std::min_element(speed.begin(), speed.end()), 1. / 21., 1e-12); // round-off errors
  for(std::size_t i = 0; i < surfels.size(); ++i)
    // Triangles are smaller than 0.1, because there are about 45 surfels in a row.
    if(std::abs(surfels[i].first.x() - 0.5) > 0.1)
    {
      EXPECT_EQ(speed[i], 1.);
    }
}

TEST(Image_speeds, support_polyhedra)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Numbered<Polyhedron> polyhedron;
  fill(polyhedron, square(10));
  std::map<Numbered<Polyhedron>::Vertex, double> image, speed;
  for(const auto v : polyhedron.vertices)
    image[v] = std::max(0., v->point().x() - 0.5);
  GP::image_speeds(polyhedron.mesh, boost::make_assoc_property_map(image),
                   boost::make_assoc_property_map(speed), GP::parameters::strength(3.));
  for(const auto v : polyhedron.vertices)
    if(std::abs(v->point().x() - 0.5) > 0.01)
    {
      EXPECT_NEAR(speed[v], v->point().x() < 0.5 ? 1. : 0.25, 1e-12); // round-off errors
    }
}

TEST(Speeds, throws_on_invalid_input)
{
  Mesh mesh = mesh_of(tetrahedron());
  auto speed = vertex_map(mesh), image = vertex_map(mesh);
  for(const double invalid : {-1., std::nan(""), GP::internal::infinity})
  {
    EXPECT_THROW(GP::curvature_speeds(mesh, speed, GP::parameters::strength(invalid)),
                 GP::Invalid_argument_error);
    EXPECT_THROW(GP::image_speeds(mesh, image, speed, GP::parameters::strength(invalid)),
                 GP::Invalid_argument_error);
  }
  EXPECT_THROW(GP::curvature_speeds(mesh, speed, GP::parameters::ball_radius(-1.)),
               GP::Invalid_argument_error);
  put(image, Vertex(2), std::nan(""));
  EXPECT_THROW(GP::image_speeds(mesh, image, speed), GP::Invalid_argument_error);
}

} // namespace speeds_test
