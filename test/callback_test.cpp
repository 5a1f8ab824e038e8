// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing.h>

#include "Mesh_of.h"

#include <CGAL/Point_set_3.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace callback_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Callback = std::function<bool(double)>;
using UV = std::array<double, 2>;

constexpr double untouched = -7.;

// A map of vertices to numbers whose values are all `untouched` at first.
struct Vertex_values
{
  explicit Vertex_values(const Mesh& mesh) : values(mesh.number_of_vertices(), untouched) {}

  auto map() { return CGAL::make_property_map(values); }
  bool are_untouched() const
  {
    return std::all_of(values.begin(), values.end(), [](double x) { return x == untouched; });
  }

  std::vector<double> values;
};

// Checks that a function throws Cancelled whenever its callback returns false, at the first call,
// at the last one and between them.
//
// make_outputs(): returns new outputs
// call(outputs, np): calls the function
// is_untouched(outputs): returns whether the outputs are as new ones
// max_calls: the number of calls that are made in every run. If several threads call the callback,
//   further calls are omitted while another thread is in it, so that their number varies.
template <typename Make_outputs, typename Call, typename Is_untouched>
void expect_cancellation(const std::string& name, const Make_outputs& make_outputs,
                         const Call& call, const Is_untouched& is_untouched,
                         std::size_t max_calls = std::size_t(-1))
{
  SCOPED_TRACE(name);
  std::size_t number_of_calls = 0;
  const auto count = [&](double fraction)
  {
    EXPECT_GE(fraction, 0.);
    EXPECT_LE(fraction, 1.);
    ++number_of_calls;
    return true;
  };
  auto complete = make_outputs();
  call(complete, GP::parameters::callback(Callback(count)));
  ASSERT_GT(number_of_calls, 0u);
  number_of_calls = std::min(number_of_calls, max_calls);
  for(const std::size_t last_call :
      {std::size_t(1), number_of_calls / 3 + 1, 2 * number_of_calls / 3 + 1, number_of_calls})
  {
    std::size_t calls = 0;
    const auto cancel = [&](double) { return ++calls < last_call; };
    auto outputs = make_outputs();
    EXPECT_THROW(call(outputs, GP::parameters::callback(Callback(cancel))), GP::Cancelled)
        << "at call " << last_call << " of " << number_of_calls;
    EXPECT_TRUE(is_untouched(outputs));
  }
}

// Functions without outputs, which return their result.
template <typename Call>
void expect_cancellation(const std::string& name, const Call& call,
                         std::size_t max_calls = std::size_t(-1))
{
  expect_cancellation(
      name, [] { return 0; }, [&](int, const auto& np) { call(np); }, [](int) { return true; },
      max_calls);
}

// Functions that write a number for each vertex.
template <typename Call>
void expect_cancellation_of_map(const std::string& name, const Mesh& mesh, const Call& call)
{
  expect_cancellation(
      name, [&] { return Vertex_values(mesh); },
      [&](Vertex_values& outputs, const auto& np) { call(outputs.map(), np); },
      [](const Vertex_values& outputs) { return outputs.are_untouched(); });
}

// Functions that add vertices and faces to a mesh.
template <typename Call>
void expect_cancellation_of_mesh(const std::string& name, const Call& call)
{
  expect_cancellation(
      name, [] { return Mesh(); }, [&](Mesh& output, const auto& np) { call(output, np); },
      [](const Mesh& output) { return output.number_of_vertices() == 0; });
}

TEST(Callback, cancels_distances)
{
  const Mesh mesh = mesh_of(jittered(icosphere(4), 0.01)); // fronts call it every 4,096 vertices
  const auto cancels = [&](const std::string& name, auto method)
  {
    using Method = decltype(method);
    expect_cancellation_of_map(name, mesh,
                               [&](auto map, const auto& np)
                               { GP::geodesic_distances<Method>(mesh, Vertex(3), map, np); });
    GP::Geodesic_distance_solver<Mesh, Method> solver(mesh);
    Vertex_values first(mesh), second(mesh);
    solver.compute(Vertex(3));
    solver.write_distances(first.map());
    expect_cancellation(name + ", solver", [&](const auto& np) { solver.compute(Vertex(9), np); });
    solver.compute(Vertex(3));
    solver.write_distances(second.map());
    EXPECT_EQ(first.values, second.values);
  };
  cancels("exact", GP::Exact());
  cancels("Euclidean front", GP::Euclidean_front());
  cancels("fast marching", GP::Fast_marching());
  cancels("Dijkstra", GP::Dijkstra());
  expect_cancellation_of_map(
      "by distances", mesh,
      [&](auto map, const auto& np)
      { GP::fuzzy_geodesic_by_distances(mesh, Vertex(3), Vertex(200), map, np); });
  expect_cancellation(
      "barycenter",
      [&](const auto& np) {
        GP::geodesic_barycenter(mesh, std::vector<Vertex>{Vertex(3), Vertex(7)}, np);
      });
  expect_cancellation(
      "mean",
      [&](const auto& np) {
        GP::karcher_mean(mesh, std::vector<Vertex>{Vertex(3), Vertex(70), Vertex(9)}, np);
      });
}

// Vertices whose distances are not final must not be reached after any kind of interruption.
TEST(Callback, interruption_leaves_final_distances)
{
  const Mesh mesh = mesh_of(jittered(icosphere(5), 0.005)); // 10,242 vertices
  const auto is_final = [&](auto method)
  {
    GP::Geodesic_distance_solver<Mesh, decltype(method)> complete(mesh), interrupted(mesh);
    complete.compute(Vertex(3));
    for(const bool throws : {false, true})
    {
      int number_of_calls = 0;
      const auto interrupt = [&](double)
      {
        if(++number_of_calls < 3)
          return true;
        if(throws)
          throw std::logic_error("interrupted");
        return false;
      };
      const auto compute = [&]
      { interrupted.compute(Vertex(3), GP::parameters::callback(interrupt)); };
      if(throws)
        EXPECT_THROW(compute(), std::logic_error);
      else
        EXPECT_THROW(compute(), GP::Cancelled);
      EXPECT_GT(interrupted.reached().size(), 100u);
      EXPECT_LT(interrupted.reached().size(), mesh.number_of_vertices());
      for(const Vertex v : interrupted.reached())
        EXPECT_EQ(interrupted.distance(v), complete.distance(v));
    }
  };
  is_final(GP::Exact());
  is_final(GP::Euclidean_front());
  is_final(GP::Fast_marching());
  is_final(GP::Dijkstra());
}

TEST(Callback, cancels_matrices)
{
  const Mesh mesh = mesh_of(icosphere(2));
  expect_cancellation("matrix", [&](const auto& np)
                      { GP::geodesic_distance_matrix(mesh, mesh.vertices(), np); });
  expect_cancellation(
      "matrix, threads",
      [&](const auto& np)
      {
        GP::geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(mesh, mesh.vertices(),
                                                                    np.number_of_threads(3u));
      },
      mesh.number_of_vertices()); // one call before each row is made in every run
  expect_cancellation("sparse matrix", [&](const auto& np)
                      { GP::sparse_geodesic_distance_matrix(mesh, mesh.vertices(), 0.5, np); });
  const GP::Transport_metric<Mesh> metric(mesh, 5);
  expect_cancellation("transport metric", [&](const auto& np)
                      { metric.cost(Vertex(0), Vertex(70), np.tolerance(1e-6)); });
  const std::vector<Vertex> vertices(mesh.vertices().begin(), mesh.vertices().begin() + 30);
  expect_cancellation("transport matrix",
                      [&](const auto& np) { metric.distance_matrix(vertices, np); });
  expect_cancellation_of_map("transport map", mesh,
                             [&](auto map, const auto& np)
                             { metric.write_distances(Vertex(0), map, np); });
  expect_cancellation_of_map(
      "transport map, threads", mesh,
      [&](auto map, const auto& np)
      { metric.write_distances<CGAL::Parallel_tag>(Vertex(0), map, np.number_of_threads(3u)); });
}

TEST(Callback, cancels_sampling)
{
  const Mesh mesh = mesh_of(icosphere(3));
  using Samples = std::vector<GP::Location<Mesh>>;
  expect_cancellation(
      "samples", [] { return Samples(); },
      [&](Samples& samples, const auto& np)
      { GP::farthest_point_sampling(mesh, 30, std::back_inserter(samples), np); },
      [](const Samples& samples) { return samples.empty(); });
  expect_cancellation(
      "vertices", [] { return std::vector<Vertex>(); },
      [&](std::vector<Vertex>& samples, const auto& np)
      { GP::farthest_vertex_sampling(mesh, 30, std::back_inserter(samples), np); },
      [](const std::vector<Vertex>& samples) { return samples.empty(); });
  const std::vector<Vertex> seeds = {Vertex(3), Vertex(50), Vertex(300)};
  expect_cancellation_of_map("diagram", mesh,
                             [&](auto map, const auto& np)
                             { GP::geodesic_voronoi_diagram(mesh, seeds, map, np); });
  expect_cancellation_of_mesh("cells",
                              [&](Mesh& cells, const auto& np)
                              {
                                std::map<Face, std::size_t> labels;
                                GP::geodesic_voronoi_cells(
                                    mesh, seeds, cells, boost::make_assoc_property_map(labels), np);
                              });
  expect_cancellation(
      "tessellation", [] { return std::map<Face, std::size_t>(); },
      [&](std::map<Face, std::size_t>& labels, const auto& np) {
        GP::geodesic_centroidal_tessellation(mesh, 10, boost::make_assoc_property_map(labels), np);
      },
      [](const auto& labels) { return labels.empty(); });
}

TEST(Callback, cancels_remeshing)
{
  const Mesh mesh = mesh_of(icosphere(3));
  expect_cancellation_of_mesh("remeshing",
                              [&](Mesh& output, const auto& np)
                              {
                                GP::geodesic_delaunay_remeshing(
                                    mesh, 60, output,
                                    np.number_of_relaxation_steps(std::size_t(3)));
                              });
  expect_cancellation_of_mesh("base mesh",
                              [&](Mesh& base, const auto& np)
                              {
                                Mesh divided;
                                std::map<Face, Face> base_face;
                                GP::geodesic_base_mesh(mesh, 20, base, divided,
                                                       boost::make_assoc_property_map(base_face),
                                                       np);
                              });
  expect_cancellation_of_mesh("semi-regular", [&](Mesh& output, const auto& np)
                              { GP::semi_regular_remeshing(mesh, 20, 1, output, np); });
  expect_cancellation(
      "holes", [] { return mesh_of(square(3)); },
      [](Mesh& output, const auto& np) { GP::fill_holes(output, np); },
      [](const Mesh& output) { return output.number_of_faces() == 18; });
}

TEST(Callback, cancels_flattening)
{
  Mesh plane = mesh_of(square(12, 0.2)), sphere = mesh_of(icosphere(3));
  using Values = std::map<Vertex, UV>;
  const auto is_empty = [](const auto& values) { return values.empty(); };
  expect_cancellation(
      "lle", [] { return Values(); },
      [&](Values& uv, const auto& np)
      { GP::geodesic_lle(plane, boost::make_assoc_property_map(uv), np); },
      is_empty);
  expect_cancellation(
      "mds", [] { return Values(); },
      [&](Values& uv, const auto& np)
      { GP::geodesic_mds(plane, boost::make_assoc_property_map(uv), np); },
      is_empty);
  Values sheared;
  for(const Vertex v : plane.vertices())
    sheared[v] = {3. * plane.point(v).x() + plane.point(v).y(), plane.point(v).y()};
  expect_cancellation(
      "distortion", [&] { return sheared; },
      [&](Values& uv, const auto& np)
      { GP::minimize_distortion(plane, boost::make_assoc_property_map(uv), np); },
      [&](const Values& uv) { return uv == sheared; });
  using Corner_values = std::map<Mesh::Halfedge_index, UV>;
  expect_cancellation(
      "atlas", [] { return Corner_values(); },
      [&](Corner_values& uv, const auto& np)
      { GP::texture_atlas(sphere, 6, boost::make_assoc_property_map(uv), np); },
      is_empty);
}

TEST(Callback, cancels_transport)
{
  const Mesh mesh = mesh_of(icosphere(2));
  expect_cancellation("earth mover's distance", [&](const auto& np)
                      { GP::earth_movers_distance(mesh, Vertex(0), Vertex(70), np); });
  GP::Earth_movers_solver<Mesh> solver(mesh);
  const double value = solver.compute(Vertex(0), Vertex(70)).value;
  const auto cancels = [&](const std::string& name, auto method)
  {
    expect_cancellation(
        name, [&](const auto& np)
        { solver.compute<decltype(method)>(Vertex(0), Vertex(50), np.tolerance(0.01)); });
    EXPECT_EQ(solver.compute(Vertex(0), Vertex(70)).value, value);
  };
  cancels("interior point", GP::Interior_point());
  cancels("alternating directions", GP::Alternating_directions());
  cancels("Weiszfeld", GP::Weiszfeld());
  expect_cancellation("region", [&](const auto& np)
                      { GP::transport_to_region(mesh, Vertex(0), Vertex(70), np); });
  expect_cancellation_of_map("feature", mesh,
                             [&](auto map, const auto& np)
                             { GP::feature_distance(mesh, Vertex(0), map, np); });
  const std::vector<Vertex> points = {Vertex(0), Vertex(70), Vertex(90)};
  expect_cancellation_of_map("barycenter", mesh,
                             [&](auto map, const auto& np)
                             { GP::transport_barycenter(mesh, points, map, np); });
  expect_cancellation_of_map("fuzzy", mesh,
                             [&](auto map, const auto& np)
                             { GP::fuzzy_geodesic(mesh, Vertex(0), Vertex(70), map, np); });
  const GP::Volumetric_metric<Mesh> volume(mesh, GP::parameters::number_of_refinements(0u));
  const Kernel::Point_3 from(0.1, 0.3, -0.2);
  const std::vector<Kernel::Point_3> to = {{0.2, 0.1, 0.}, {0.4, -0.1, 0.2}};
  expect_cancellation("volume",
                      [&](const auto& np) { volume.cost(from, to.front(), np.tolerance(1e-4)); });
  expect_cancellation("volume, several",
                      [&](const auto& np) { volume.costs(from, to, np.tolerance(1e-4)); });
}

TEST(Callback, cancels_construction_of_domains)
{
  const Triangulation sphere = icosphere(2);
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  for(const Point& p : sphere.points)
    points.emplace_back(p[0], p[1], p[2]);
  for(std::size_t i = 0; i < sphere.corners.size(); i += 3)
    polygons.push_back({sphere.corners[i], sphere.corners[i + 1], sphere.corners[i + 2]});
  expect_cancellation("soup", [&](const auto& np) { GP::make_domain(points, polygons, np); });
  polygons.push_back(polygons.front()); // a soup that is repaired
  expect_cancellation("repaired soup",
                      [&](const auto& np) { GP::make_domain(points, polygons, np); });
  const Surfels surfels = sphere_surfels(2);
  expect_cancellation(
      "cloud",
      [&](const auto& np) {
        GP::make_domain(surfels, np.point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
      });
  using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
  Point_set cloud;
  for(const auto& point : points)
    cloud.insert(point);
  expect_cancellation(
      "estimation of surfels", [&] { return cloud; },
      [&](Point_set& outputs, const auto& np) { GP::estimate_surfels(outputs, np); },
      [](const Point_set& outputs) { return !outputs.has_normal_map(); });
}

TEST(Callback, cancels_preparation_and_curves)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.01));
  using Heat_distances = GP::Geodesic_distance_solver<Mesh, GP::Heat>;
  expect_cancellation("heat", [&](const auto& np) { Heat_distances(mesh, np); });
  std::vector<double> heights;
  for(const Vertex v : mesh.vertices())
    heights.push_back(mesh.point(v).z());
  using Isolines = std::vector<GP::Isoline<Mesh>>;
  expect_cancellation(
      "isolines", [] { return Isolines(); },
      [&](Isolines& lines, const auto& np)
      {
        GP::isolines(mesh, CGAL::make_property_map(heights), std::vector<double>{-0.5, 0., 0.5},
                     std::back_inserter(lines), np);
      },
      [](const Isolines& lines) { return lines.empty(); });
  GP::Geodesic_path_finder<Mesh> finder(mesh);
  const double length = finder(Vertex(3), Vertex(200)).length;
  expect_cancellation("path", [&](const auto& np) { finder(Vertex(3), Vertex(200), np); });
  EXPECT_EQ(finder(Vertex(3), Vertex(200)).length, length);
}

} // namespace callback_test
