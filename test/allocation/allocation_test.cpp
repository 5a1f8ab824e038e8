// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing.h>

#include "Mesh_of.h"
#include "allocation/expect_safe.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// Queries of each public class, in which an allocation fails.

namespace allocation_test {

namespace GP = CGAL::Geodesic_processing;
namespace params = GP::parameters;
using namespace GP::test;
using Vector_3 = Kernel::Vector_3;
using Point_3 = Kernel::Point_3;
using Point_2 = Kernel::Point_2;

// Checks queries of a new object and queries of an object that exists.
template <typename Make, typename Query>
void expect_safe(const Make& make, const Query& query)
{
  expect_safe(
      [&]
      {
        auto object = make();
        return query(object);
      });
  auto object = make();
  expect_safe([&] { return query(object); });
}

template <typename Path>
void append_path(const Path& path, Values& values)
{
  for(const auto& p : path.points)
    values.insert(values.end(), {p.x(), p.y(), p.z()});
}

Values values_of(const Eigen::MatrixXd& matrix)
{
  return Values(matrix.data(), matrix.data() + matrix.size());
}

Values points_of(const Mesh& mesh)
{
  Values result;
  for(const Vertex v : mesh.vertices())
    result.insert(result.end(), {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  return result;
}

Values cost_values(const GP::Earth_movers_cost& cost)
{
  return {cost.value, cost.lower, cost.upper};
}

const auto surfel_maps = params::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());

const std::vector<Vertex> some_vertices = {Vertex(0), Vertex(7), Vertex(20), Vertex(33)};

Mesh sphere() { return mesh_of(icosphere(1)); }
Mesh sheet() { return mesh_of(square(6, 0.02)); }

TEST(Allocation, domain_of_mesh)
{
  const Mesh mesh = sphere();
  expect_safe([&] { return Values(GP::make_domain(mesh).triangles()->length); });
}

TEST(Allocation, domain_of_soup)
{
  const Triangulation shape = icosphere(1);
  std::vector<Point_3> points;
  for(const auto& p : shape.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for(std::size_t c = 0; c < shape.corners.size(); c += 3)
    polygons.push_back({shape.corners[c], shape.corners[c + 1], shape.corners[c + 2]});
  // Something to repair: a duplicate triangle, an inverted one and a second fan at a vertex.
  polygons.push_back(polygons[3]);
  std::swap(polygons[5][0], polygons[5][1]);
  points.insert(points.end(), {{3., 0., 0.}, {3., 1., 0.}, {3., 1., 1.}});
  polygons.push_back({0, points.size() - 3, points.size() - 2, points.size() - 1});
  expect_safe([&] { return Values(GP::make_domain(points, polygons).triangles()->length); });
}

TEST(Allocation, domain_of_cloud)
{
  const Surfels surfels = sphere_surfels(1);
  expect_safe([&] { return Values(GP::make_domain(surfels, surfel_maps).triangles()->length); });
  expect_safe(
      [&]
      {
        const auto np = surfel_maps.number_of_threads(2u);
        return Values(GP::make_domain<CGAL::Parallel_tag>(surfels, np).triangles()->length);
      });
}

template <typename Method, typename Surface, typename Location, typename NamedParameters>
void expect_safe_solver(const Surface& surface, const Location& location, const NamedParameters& np)
{
  expect_safe([&] { return GP::Geodesic_distance_solver<Surface, Method>(surface, np); },
              [&](auto& solver)
              {
                solver.compute(typename std::decay_t<decltype(solver)>::Vertex(3));
                Values result = {solver.distance(location)};
                for(const auto vertex : solver.reached())
                  result.push_back(solver.distance(vertex));
                append_path(solver.path(location), result);
                return result;
              });
}

TEST(Allocation, distance_solver_on_mesh)
{
  const Mesh mesh = sphere();
  const auto location = location_of(40, {0.2, 0.3, 0.5});
  const auto np = params::default_values();
  expect_safe_solver<GP::Dijkstra>(mesh, location, np);
  expect_safe_solver<GP::Fast_marching>(mesh, location, np);
  expect_safe_solver<GP::Euclidean_front>(mesh, location, np);
  expect_safe_solver<GP::Exact>(mesh, location, np);
  expect_safe_solver<GP::Heat>(mesh, location, np);
}

TEST(Allocation, distance_solver_on_cloud)
{
  const Surfels surfels = sphere_surfels(1);
  const std::size_t surfel = 30;
  expect_safe_solver<GP::Dijkstra>(surfels, surfel, surfel_maps);
  expect_safe_solver<GP::Fast_marching>(surfels, surfel, surfel_maps);
  expect_safe_solver<GP::Euclidean_front>(surfels, surfel, surfel_maps);
  expect_safe_solver<GP::Heat>(surfels, surfel, surfel_maps);
}

TEST(Allocation, path_finder)
{
  const Mesh mesh = sphere();
  expect_safe(
      [&]
      {
        GP::Geodesic_path_finder<Mesh> find(mesh);
        find.add_landmarks(2);
        return find;
      },
      [&](auto& find)
      {
        Values result;
        append_path(find(Vertex(0), location_of(40, {0.2, 0.3, 0.5})), result);
        append_path(find.locally_shortest_path(Vertex(0), Vertex(40)), result);
        return result;
      });
}

TEST(Allocation, locator)
{
  const Mesh mesh = sphere();
  expect_safe([&] { return GP::Surface_locator<Mesh>(mesh); },
              [&](auto& locate)
              {
                Values result;
                for(const double x : {0., 0.3, 2.})
                {
                  const auto location = locate(Point_3(x, 1., -x));
                  result.push_back(double(location.first));
                  result.insert(result.end(), location.second.begin(), location.second.end());
                }
                return result;
              });
}

TEST(Allocation, surfel_path_finder)
{
  const Surfels surfels = sphere_surfels(1);
  expect_safe([&] { return GP::Surfel_path_finder<Surfels>(surfels, surfel_maps); },
              [&](auto& find)
              {
                Values result;
                append_path(find(std::size_t(0), std::size_t(35)), result);
                return result;
              });
}

TEST(Allocation, farthest_point_sampling)
{
  const Mesh mesh = sphere();
  expect_safe(
      [&]
      {
        std::vector<GP::Location<Mesh>> samples;
        GP::farthest_point_sampling(mesh, 8, std::back_inserter(samples));
        Values result;
        for(const auto& [face, barycentric] : samples)
          result.insert(result.end(), {double(face), barycentric[0], barycentric[1]});
        return result;
      });
}

TEST(Allocation, distance_matrix)
{
  const Mesh mesh = sphere();
  for(const unsigned threads : {1u, 2u})
  {
    const auto np = params::number_of_threads(threads);
    expect_safe(
        [&]
        {
          return values_of(
              GP::geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(mesh, some_vertices, np));
        });
    expect_safe(
        [&]
        {
          return values_of(
              GP::geodesic_distance_matrix<GP::Heat, CGAL::Parallel_tag>(mesh, some_vertices, np));
        });
  }
}

TEST(Allocation, logarithmic_map)
{
  const Mesh mesh = sphere();
  expect_safe([&] { return GP::Logarithmic_map<Mesh>(mesh); },
              [&](auto& map)
              {
                map.compute(Vertex(5), params::maximum_distance(1.));
                Values result;
                for(const Vertex v : map.reached())
                  result.insert(result.end(), map(v).begin(), map(v).end());
                return result;
              });
}

TEST(Allocation, decal)
{
  const Mesh mesh = sphere();
  expect_safe([&] { return GP::Decal_placer<Mesh>(mesh); },
              [&](auto& placer)
              {
                const auto decal = placer.place(Vertex(20), 0.5, 0.5);
                Values result;
                for(const auto& [vertex, uv] : decal.vertices)
                  result.insert(result.end(), uv.begin(), uv.end());
                return result;
              });
}

TEST(Allocation, flattening)
{
  Mesh mesh = sheet();
  const auto uv = vertex_map<Point_2>(mesh);
  const auto values = [&]
  {
    Values result;
    for(const Vertex v : mesh.vertices())
      result.insert(result.end(), {uv[v].x(), uv[v].y()});
    return result;
  };
  const auto np = params::number_of_base_points(10);
  expect_safe([&] { return GP::geodesic_mds(mesh, uv, np), values(); });
  expect_safe([&] { return GP::geodesic_lle(mesh, uv, np), values(); });
  const Values before = values();
  expect_safe(
      [&]
      {
        for(const Vertex v : mesh.vertices())
          uv[v] = Point_2(before[2 * v], before[2 * v + 1]);
        GP::minimize_distortion(mesh, uv);
        return values();
      });
}

TEST(Allocation, texture_atlas)
{
  Mesh mesh = sphere();
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, std::array<double, 2>>().first;
  expect_safe(
      [&]
      {
        GP::texture_atlas(mesh, 3, uv, params::texture_size(64).gutter_width(2));
        Values result;
        for(const auto h : mesh.halfedges())
          result.insert(result.end(), uv[h].begin(), uv[h].end());
        return result;
      });
}

TEST(Allocation, remeshing)
{
  const Mesh mesh = sphere();
  expect_safe(
      [&]
      {
        Mesh output;
        GP::geodesic_delaunay_remeshing(mesh, 20, output);
        return points_of(output);
      });
  expect_safe(
      [&]
      {
        Mesh output;
        GP::semi_regular_remeshing(mesh, 10, 1, output);
        return points_of(output);
      });
}

TEST(Allocation, base_parameterization)
{
  const Mesh mesh = sphere();
  expect_safe([&] { return GP::Base_parameterization<Mesh>(mesh, 10); },
              [&](auto& base)
              {
                Values result;
                for(const Vertex v : mesh.vertices())
                {
                  const auto location = base(v);
                  result.push_back(double(location.face));
                  result.insert(result.end(), location.barycentric.begin(),
                                location.barycentric.end());
                }
                return result;
              });
}

TEST(Allocation, wavelets)
{
  const Mesh mesh = mesh_of(icosphere(2));
  expect_safe([&] { return GP::Subdivision_wavelet<Mesh>(mesh); },
              [&](auto& wavelet)
              {
                const auto details = wavelet.analyze(mesh.points(), params::do_use_frames(true));
                const auto stream = wavelet.encode(details);
                Mesh decoded;
                GP::decode_wavelets(stream, decoded);
                return points_of(decoded);
              });
}

TEST(Allocation, earth_movers_solver)
{
  const Mesh mesh = sphere();
  const auto np = params::number_of_refinements(0u);
  expect_safe([&] { return GP::Earth_movers_solver<Mesh>(mesh, np); },
              [&](auto& solver) { return cost_values(solver.compute(Vertex(3), Vertex(30))); });
  auto solver = GP::Earth_movers_solver<Mesh>(mesh, np);
  expect_safe(
      [&]
      {
        return cost_values(solver.template compute<GP::Alternating_directions>(
            some_vertices, Vertex(30), params::do_normalize(true)));
      });
}

TEST(Allocation, streamline_tracer)
{
  const Mesh mesh = sphere();
  GP::Earth_movers_solver<Mesh> solver(mesh, params::number_of_refinements(0u));
  solver.compute(some_vertices, Vertex(30), params::do_normalize(true));
  expect_safe([&] { return solver.streamlines(); },
              [&](auto& trace)
              {
                std::vector<GP::Streamline<Mesh>> lines;
                trace(5, std::back_inserter(lines));
                Values result;
                for(const auto& line : lines)
                  append_path(line, result);
                return result;
              });
}

TEST(Allocation, region_transport_solver)
{
  const Mesh mesh = sphere();
  const std::vector<double> capacities = {0.4, 0.4, 0.3, 0.3};
  const auto np = params::capacities(capacities);
  expect_safe([&] { return GP::Region_transport_solver<Mesh>(mesh, some_vertices, np); },
              [&](auto& solver) { return cost_values(solver.compute(Vertex(30))); });
}

TEST(Allocation, transport_barycenter_solver)
{
  const Mesh mesh = sphere();
  expect_safe(
      [&]
      { return GP::Transport_barycenter_solver<Mesh>(mesh, params::number_of_refinements(0u)); },
      [&](auto& solver)
      {
        solver.compute(std::vector<Vertex>{Vertex(3), Vertex(30)});
        Values result;
        for(const Vertex v : mesh.vertices())
          result.push_back(solver.mass(v));
        return result;
      });
}

TEST(Allocation, biharmonic_metric)
{
  const Mesh mesh = sphere();
  expect_safe([&] { return GP::Biharmonic_metric<Mesh>(mesh); },
              [&](auto& metric) { return values_of(metric.distance_matrix(some_vertices)); });
}

TEST(Allocation, transport_metric)
{
  const Mesh mesh = sphere();
  for(const std::size_t k : {0u, 3u})
    expect_safe([&] { return GP::Transport_metric<Mesh>(mesh, k); },
                [](const auto& metric) -> Values
                { return cost_values(metric.cost(Vertex(0), Vertex(7))); });
}

TEST(Allocation, volumetric_metric)
{
  const Mesh mesh = sphere();
  const std::vector<Point_3> points = {Point_3(0., 0., 0.5), Point_3(0.1, 0.2, 0.)};
  expect_safe([&] { return GP::Volumetric_metric<Mesh>(mesh, params::number_of_refinements(0u)); },
              [&](auto& metric)
              {
                Values result;
                for(const auto& cost : metric.costs(Point_3(-0.3, 0.1, 0.), points))
                  result.push_back(cost.value);
                return result;
              });
}

TEST(Allocation, hodge_decomposition)
{
  Mesh mesh = mesh_of(torus(8, 6));
  const auto add = [&](const char* name)
  { return mesh.add_property_map<Face, Vector_3>(name, Vector_3(0., 0., 0.)).first; };
  const auto field = add("f:field"), gradient = add("f:gradient"), rotation = add("f:rotation"),
             harmonic = add("f:harmonic");
  for(const Face f : mesh.faces())
  {
    const Point_3 p = mesh.point(mesh.target(mesh.halfedge(f)));
    field[f] = Vector_3(-p.y() + p.z(), p.x() * p.x(), 0.3);
  }
  expect_safe(
      [&]
      {
        GP::hodge_decomposition(mesh, field, gradient, rotation, harmonic);
        Values result;
        for(const Face f : mesh.faces())
          for(const Vector_3& v : {gradient[f], rotation[f], harmonic[f]})
            result.insert(result.end(), {v.x(), v.y(), v.z()});
        return result;
      });
}

} // namespace allocation_test
