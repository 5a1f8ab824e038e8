// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares four paths on a cloud with noise and outliers, and the path after denoising.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/IO/read_points.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Cloud = CGAL::Point_set_3<Point, Vector>;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;

// Returns two unit vectors that are perpendicular to each other and to `normal`.
std::pair<Vector, Vector> tangents(const Vector& normal)
{
  const Vector axis = std::abs(normal.x()) < 0.6 ? Vector(1., 0., 0.) : Vector(0., 1., 0.);
  Vector u = CGAL::cross_product(normal, axis);
  u /= std::sqrt(u.squared_length());
  return {u, CGAL::cross_product(normal, u)};
}

// Returns a surfel's point, moved along the normal by up to `offset`, and a normal, rotated by up
// to 10 degrees.
std::pair<Point, Vector> displaced(const Point& point, const Vector& normal, double offset,
                                   std::mt19937& random)
{
  std::uniform_real_distribution<double> shift(-offset, offset), angle(0., CGAL_PI / 18.),
      azimuth(0., 2. * CGAL_PI);
  const auto [u, v] = tangents(normal);
  const double a = angle(random), b = azimuth(random);
  const Point moved = point + shift(random) * normal;
  return {moved, std::cos(a) * normal + std::sin(a) * (std::cos(b) * u + std::sin(b) * v)};
}

// The surfels as small hexagons and the paths as tubes. The property `path` of a vertex is the
// number of its path; it is not a number on surfels.
class Drawing
{
public:
  void add_surfel(const Point& center, const Vector& normal, double radius)
  {
    const auto [u, v] = tangents(normal);
    std::vector<Mesh::Vertex_index> corner;
    for(int i = 0; i < 6; ++i)
      corner.push_back(m_mesh.add_vertex(center + radius * std::cos(CGAL_PI / 3. * i) * u +
                                         radius * std::sin(CGAL_PI / 3. * i) * v));
    for(int i = 1; i < 5; ++i)
      m_mesh.add_face(corner[0], corner[i], corner[i + 1]);
  }
  void add_path(const std::vector<Point>& points, double number, double radius)
  {
    constexpr int sides = 8;
    std::vector<Mesh::Vertex_index> ring;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      Vector direction = points[(std::min)(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1];
      direction /= std::sqrt(direction.squared_length());
      // The axis of the previous ring, projected, so that the tube is not twisted.
      Vector u = i == 0 ? tangents(direction).first : m_axis;
      u = u - (u * direction) * direction;
      m_axis = u / std::sqrt(u.squared_length());
      const Vector v = CGAL::cross_product(direction, m_axis);
      std::vector<Mesh::Vertex_index> next;
      for(int k = 0; k < sides; ++k)
      {
        const double a = 2. * CGAL_PI * k / sides;
        next.push_back(
            m_mesh.add_vertex(points[i] + radius * (std::cos(a) * m_axis + std::sin(a) * v)));
        m_path[next.back()] = number;
      }
      for(int k = 0; i > 0 && k < sides; ++k)
      {
        m_mesh.add_face(ring[k], ring[(k + 1) % sides], next[(k + 1) % sides]);
        m_mesh.add_face(ring[k], next[(k + 1) % sides], next[k]);
      }
      ring = next;
    }
  }
  // Marks a point by a short edge.
  void add_marker(const Point& point, double length)
  {
    const Vector half(0.5 * length, 0., 0.);
    for(const Point& end : {point - half, point + half})
      m_edges += std::to_string(Mesh::size_type(m_mesh.add_vertex(end))) + ' ';
    ++m_number_of_edges;
  }
  bool write(const char* file) const
  {
    std::ostringstream ply;
    CGAL::IO::write_PLY(ply, m_mesh);
    std::string text = ply.str();
    text.insert(text.find("end_header"), "element edge " + std::to_string(m_number_of_edges) +
                                             "\nproperty int vertex1\nproperty int vertex2\n");
    return bool(std::ofstream(file) << text << m_edges);
  }

private:
  Mesh m_mesh;
  Mesh::Property_map<Mesh::Vertex_index, double> m_path =
      m_mesh
          .add_property_map<Mesh::Vertex_index, double>("v:path",
                                                        std::numeric_limits<double>::quiet_NaN())
          .first;
  std::string m_edges;
  int m_number_of_edges = 0;
  Vector m_axis;
};

int main(int argc, char* argv[])
{
  Cloud cloud;
  if(argc != 5 || !CGAL::IO::read_point_set(argv[1], cloud) || cloud.empty())
    return std::cerr << "usage: noisy_cloud_paths CLOUD FROM TO RESULT.ply\n", EXIT_FAILURE;
  if(!cloud.has_normal_map())
  {
    cloud.add_normal_map();
    GP::estimate_surfels(cloud);
  }
  const Cloud::Index from(Cloud::Index::size_type(std::stoul(argv[2]))),
      to(Cloud::Index::size_type(std::stoul(argv[3])));
  GP::Surfel_path_finder<Cloud> clean_finder(cloud);
  const auto clean_path = clean_finder(from, to);
  const double distance = clean_path.front_distance;

  // Noise of one radius, and 5 % of outliers with twice as much noise. The ends have no noise, so
  // that all lengths can be compared.
  std::mt19937 random(1);
  Cloud noisy(true);
  for(const Cloud::Index& i : cloud)
  {
    const double offset = i == from || i == to ? 0. : clean_finder.radius(i);
    const auto [point, normal] =
        displaced(clean_finder.point(i), clean_finder.normal(i), offset, random);
    noisy.insert(point, normal);
  }
  for(std::size_t k = 0; k < cloud.size() / 20; ++k)
  {
    const Cloud::Index i = *(cloud.begin() + random() % cloud.size());
    const auto [point, normal] = displaced(clean_finder.point(i), clean_finder.normal(i),
                                           2. * clean_finder.radius(i), random);
    noisy.insert(point, normal);
  }

  Drawing drawing;
  // Only the surfels around the path are drawn.
  for(const Cloud::Index& i : noisy)
    for(const Point& p : clean_path.points)
      if(CGAL::squared_distance(noisy.point(i), p) < std::pow(0.25 * distance, 2))
      {
        drawing.add_surfel(noisy.point(i), noisy.normal(i), 0.2 * clean_finder.radius(from));
        break;
      }
  for(const Point& end : {noisy.point(from), noisy.point(to)})
    drawing.add_marker(end, 0.1 * clean_finder.radius(from));
  const double tube = 0.004 * distance;
  std::cout << "Length relative to the path on the clean cloud:\n";
  double number = 0.;
  const auto add = [&](const std::vector<Point>& points, double length, const char* name)
  {
    drawing.add_path(points, ++number, tube);
    std::cout << number << ". " << name << ": " << length / distance << '\n';
  };
  const auto add_minimum =
      [&](GP::Surfel_path_method method, GP::Surfel_noise noise, const char* name)
  {
    GP::Surfel_path_finder<Cloud> find(
        noisy, GP::parameters::surfel_path_method(method).surfel_noise(noise).do_enforce_guarantees(
                   noise != GP::Surfel_noise::kept));
    const auto path = find(from, to);
    if(number == 0.)
    {
      std::vector<Point> chain;
      for(const Cloud::Index& i : path.initial_path)
        chain.push_back(noisy.point(i));
      add(chain, path.initial_length, "initial path");
    }
    add(path.points, path.front_distance, name);
  };
  add_minimum(GP::Surfel_path_method::projected_planes, GP::Surfel_noise::kept,
              "projected to fitted planes");
  add_minimum(GP::Surfel_path_method::planes, GP::Surfel_noise::kept, "attracted to fitted planes");
  add_minimum(GP::Surfel_path_method::disks, GP::Surfel_noise::kept,
              "attracted to the disks of the surfels");
  add_minimum(GP::Surfel_path_method::projected_quadrics, GP::Surfel_noise::removed_when_found,
              "after denoising");
  return drawing.write(argv[4]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
