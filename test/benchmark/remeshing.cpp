// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the quality of remeshed surfaces, compared with CGAL's isotropic remeshing. Verifies
// that their topology is preserved.
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "report.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <cstring>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

std::vector<double> min_angles(const Mesh& mesh)
{
  std::vector<double> result;
  for(const Face f : mesh.faces())
  {
    double min_angle = 180.;
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      min_angle = std::min(
          min_angle, CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                             mesh.point(mesh.target(mesh.next(h)))));
    result.push_back(min_angle);
  }
  std::sort(result.begin(), result.end());
  return result;
}

double mean(const std::vector<double>& values)
{
  double sum = 0.;
  for(const double x : values)
    sum += x;
  return sum / double(values.size());
}

// Returns the distances of 100,000 random points of one mesh to another mesh.
std::vector<double> distances(const Mesh& from, const Mesh& to)
{
  std::vector<Kernel::Point_3> samples;
  PMP::sample_triangle_mesh(from, std::back_inserter(samples),
                            CGAL::parameters::use_random_uniform_sampling(true)
                                .number_of_points_on_faces(100000)
                                .do_sample_vertices(false)
                                .do_sample_edges(false)
                                .random_seed(1));
  Tree tree(faces(to).first, faces(to).second, to);
  tree.accelerate_distance_queries();
  std::vector<double> result;
  for(const auto& p : samples)
    result.push_back(std::sqrt(tree.squared_distance(p)));
  return result;
}

double diagonal(const Mesh& mesh)
{
  const auto box = PMP::bbox(mesh);
  return std::sqrt(std::pow(box.xmax() - box.xmin(), 2) + std::pow(box.ymax() - box.ymin(), 2) +
                   std::pow(box.zmax() - box.zmin(), 2));
}

std::size_t self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Face, Face>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

void add_quality(Table& table, const std::string& name, std::size_t requested,
                 const std::string& how, const Mesh& input, const Mesh& output, double time)
{
  const std::vector<double> angles = min_angles(output);
  const double percent = 100. / diagonal(input);
  std::vector<double> back = distances(input, output);
  for(double& x : back)
    x *= x;
  table.add({name, std::to_string(requested), how, std::to_string(num_vertices(output)),
             format_fixed(mean(angles), 1), format_fixed(angles[angles.size() / 100], 1),
             format_fixed(angles.front(), 1),
             format_fixed(percent * mean(distances(output, input)), 4),
             format_fixed(percent * std::sqrt(mean(back)), 4),
             std::to_string(self_intersections(output)), format_fixed(time, 2)});
}

// Runs CGAL's isotropic remeshing. The edge length is adjusted in at most six attempts, until the
// number of vertices agrees to within one percent. Returns the mesh and the seconds of the last
// attempt.
std::pair<Mesh, double> isotropic_remesh(const Mesh& input, std::size_t vertices)
{
  double length = std::sqrt(PMP::area(input) * 2. / std::sqrt(3.) / double(vertices));
  std::pair<Mesh, double> result;
  for(int attempt = 0; attempt < 6; ++attempt)
  {
    result.first = input;
    result.second = cpu_seconds(
        [&]
        {
          PMP::isotropic_remeshing(faces(result.first), length, result.first,
                                   CGAL::parameters::number_of_iterations(3));
        });
    result.first.collect_garbage();
    const double ratio = double(num_vertices(result.first)) / double(vertices);
    if(std::fabs(ratio - 1.) < 0.01)
      break;
    length *= std::sqrt(ratio);
  }
  return result;
}

void print_quality(bool quick)
{
  std::printf(
      "Quality: minimum angles of faces in degrees, distances in percent of the bounding box "
      "diagonal\n");
  Table table("quality", {"model", "requested vertices", "remeshing", "vertices", "mean angle",
                          "1st percentile", "smallest", "mean to input %", "RMS from input %",
                          "self-intersections", "time [s]"});
  std::vector<std::string> names = {"elephant_2k8"};
  if(!quick)
    names = {"bunny_37k", "armadillo_26k", "fandisk_6k5",
             "kitten_9k", "elephant_2k8",  "nefertiti_35k"};
  for(const std::string& name : names)
    for(const std::size_t vertices : {std::size_t(1000), std::size_t(5000)})
    {
      const auto input = load_model(name);
      if(!input)
        continue;
      const auto add =
          [&](const std::string& how, std::size_t steps, bool do_fit, double sharp_angle)
      {
        Mesh output;
        const double time = cpu_seconds(
            [&]
            {
              GP::geodesic_delaunay_remeshing(
                  *input, vertices, output,
                  GP::parameters::number_of_relaxation_steps(steps).do_fit(do_fit).sharp_angle(
                      sharp_angle));
            });
        add_quality(table, name, vertices, how, *input, output, time);
      };
      add("0 steps", 0, false, 180.);
      add("12 steps", 12, false, 180.);
      add("12 steps, fitted", 12, true, 180.);
      add("30 steps", 30, false, 180.);
      add("30 steps, fitted", 30, true, 180.);
      add("60 steps, fitted", 60, true, 180.);
      if(name == "fandisk_6k5")
        add("60 steps, fitted, sharp edges kept", 60, true, 40.);
      const auto [output, time] = isotropic_remesh(*input, vertices);
      add_quality(table, name, vertices, "CGAL", *input, output, time);
    }
  table.print();
  std::printf("Target: angles and distances at least as good as those of CGAL, in less time.\n\n");
}

struct Topology
{
  std::size_t components, borders;
  std::ptrdiff_t characteristic;
  bool operator==(const Topology& other) const
  {
    return components == other.components && borders == other.borders &&
           characteristic == other.characteristic;
  }
};

Topology topology_of(Mesh mesh)
{
  const auto isolated = std::count_if(mesh.vertices().begin(), mesh.vertices().end(),
                                      [&](Vertex v) { return mesh.is_isolated(v); });
  const auto component = mesh.add_property_map<Face, std::size_t>("f:component").first;
  std::vector<boost::graph_traits<Mesh>::halfedge_descriptor> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  return {PMP::connected_components(mesh, component), borders.size(),
          std::ptrdiff_t(num_vertices(mesh) + num_faces(mesh)) - isolated -
              std::ptrdiff_t(num_edges(mesh))};
}

bool has_repeated_faces(const Mesh& mesh)
{
  std::set<std::array<Vertex, 3>> seen;
  for(const Face f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    std::array<Vertex, 3> corners = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
    std::sort(corners.begin(), corners.end());
    if(!seen.insert(corners).second)
      return true;
  }
  return false;
}

void print_topology(bool quick)
{
  std::printf(
      "Topology: number of vertices added to 200, 1,000 and 5,000 requested ones, and pairs of "
      "intersecting faces\n");
  Table table("topology",
              {"mesh", "vertices", "genus", "components", "boundary cycles", "same topology",
               "200: added", "200: intersections", "1000: added", "1000: intersections",
               "5000: added", "5000: intersections", "time [s]"});
  std::set<std::filesystem::path> files;
  const std::filesystem::path folder = std::filesystem::path(GEODESIC_PROCESSING_DATA) / "meshes";
  if(exists(folder))
    for(const auto& entry : std::filesystem::directory_iterator(folder))
      files.insert(entry.path());
  for(const auto& file : files)
  {
    if(quick && file_size(file) > 300000)
      continue;
    const auto mesh = load_model(file.stem().string());
    if(!mesh || !CGAL::is_triangle_mesh(*mesh))
      continue;
    const Topology topology = topology_of(*mesh);
    const std::ptrdiff_t twice_genus = 2 * std::ptrdiff_t(topology.components) -
                                       std::ptrdiff_t(topology.borders) - topology.characteristic;
    bool is_kept = true;
    double time = 0.;
    std::vector<std::string> found;
    for(const std::size_t number_of_vertices : {200, 1000, 5000})
    {
      Mesh output;
      GP::Remeshing_result result;
      time += cpu_seconds(
          [&] { result = GP::geodesic_delaunay_remeshing(*mesh, number_of_vertices, output); });
      std::vector<Face> degenerate;
      PMP::degenerate_faces(output, std::back_inserter(degenerate));
      is_kept = is_kept && CGAL::is_valid_polygon_mesh(output) && topology_of(output) == topology &&
                !has_repeated_faces(output) && degenerate.empty();
      found.push_back(std::to_string(result.number_of_added_vertices));
      found.push_back(std::to_string(self_intersections(output)));
    }
    std::vector<std::string> row = {file.stem().string(),
                                    std::to_string(num_vertices(*mesh)),
                                    std::to_string(twice_genus / 2),
                                    std::to_string(topology.components),
                                    std::to_string(topology.borders),
                                    is_kept ? "yes" : "NO"};
    row.insert(row.end(), found.begin(), found.end());
    row.push_back(format_fixed(time, 2));
    table.add(row);
  }
  table.print();
  std::printf("Targets: always the same topology; no intersections with 1,000 vertices or more if "
              "the input has none.\n\n");
}

// Measures estimated Hausdorff distances between a part with creases and its remeshings, at equal
// numbers of vertices.
void print_densities()
{
  const auto input = load_model("fandisk_6k5");
  if(!input)
    return;
  std::printf(
      "Densities: Hausdorff distances of a part with creases, in percent of the bounding box "
      "diagonal\n");
  Table table("densities", {"fandisk_6k5", "vertices", "to input", "from input", "uniform / this"});
  Mesh mesh = *input;
  const auto speed = mesh.add_property_map<Vertex, double>("v:speed", 1.).first;
  const double percent = 100. / diagonal(mesh);
  double uniform_error = 0.;
  const auto add =
      [&](const char* name, std::size_t number_of_vertices, double sharp_angle, double deviation)
  {
    Mesh output;
    GP::geodesic_delaunay_remeshing(
        mesh, number_of_vertices, output,
        GP::parameters::speed_map(speed).sharp_angle(sharp_angle).maximum_deviation(deviation));
    const std::vector<double> there = distances(output, mesh), back = distances(mesh, output);
    const double to = percent * *std::max_element(there.begin(), there.end()),
                 from = percent * *std::max_element(back.begin(), back.end());
    if(uniform_error == 0.)
      uniform_error = std::max(to, from);
    table.add({name, std::to_string(num_vertices(output)), format_fixed(to, 3),
               format_fixed(from, 3), format_fixed(uniform_error / std::max(to, from), 1)});
  };
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  add("even", 1000, 180., unbounded);
  add("uniform, sharp edges above 40 degrees kept", 1000, 40., unbounded);
  // 984 yields about 1,000 vertices: vertices are added at the ends of creases with small angles.
  add("uniform, sharp edges above 20 degrees kept", 984, 20., unbounded);
  GP::curvature_speeds(mesh, speed);
  add("by curvature", 1000, 180., unbounded);
  add("by curvature, sharp edges above 40 degrees kept", 1000, 40., unbounded);
  add("by curvature, sharp edges above 20 degrees kept", 995, 20., unbounded);
  // The deviation adds vertices to the first 300.
  add("by curvature, sharp edges above 40 degrees kept, maximum deviation", 300, 40.,
      0.002 * diagonal(mesh));
  table.print();
  std::printf("Target: a ratio of 3 by curvature, at equal numbers of vertices.\n\n");
}

void print_times(bool quick)
{
  std::printf("Processor times of remeshing\n");
  Table table("times", {"mesh", "vertices", "output vertices", "one front [s]", "no relaxation [s]",
                        "12 steps, fitted [s]", "per step [s]", "CGAL [s]"});
  const auto add = [&](const std::string& name, const Mesh& mesh, std::size_t vertices)
  {
    GP::Geodesic_distance_solver<Mesh, GP::Euclidean_front> solver(mesh);
    const double front_time = cpu_seconds([&] { solver.compute(Vertex(0)); });
    const auto remesh = [&](std::size_t steps, bool do_fit)
    {
      Mesh output;
      return cpu_seconds(
          [&]
          {
            GP::geodesic_delaunay_remeshing(
                mesh, vertices, output,
                GP::parameters::number_of_relaxation_steps(steps).do_fit(do_fit));
          });
    };
    // Steps are timed as a difference, because the initial samples cost less if relaxation follows.
    const double unrelaxed_time = remesh(0, false), fitted_time = remesh(12, true),
                 time_of_5_steps = remesh(5, false), time_of_15_steps = remesh(15, false);
    table.add({name, std::to_string(num_vertices(mesh)), std::to_string(vertices),
               format_fixed(front_time, 3), format_fixed(unrelaxed_time, 2),
               format_fixed(fitted_time, 2),
               format_fixed((time_of_15_steps - time_of_5_steps) / 10., 3),
               format_fixed(isotropic_remesh(mesh, vertices).second, 2)});
  };
  add("Sphere", icosphere(quick ? 4 : 6), 1000);
  for(const std::string name : {"nefertiti_35k", "bunny_37k"})
    if(const auto mesh = quick ? std::nullopt : load_model(name))
    {
      add(name, *mesh, 5000);
      if(name == "bunny_37k")
        add(name + ", refined once", refined(*mesh), 5000);
    }
  table.print();
  std::printf(
      "Target: less time than CGAL, which took 0.8 s from 43,000 to 5,000 vertices and 2.5 s "
      "from 134,000.\n\n");
}

} // namespace

int main(int argc, char* argv[])
{
  bool quick = false;
  for(int i = 1; i < argc; ++i)
    quick = quick || std::strcmp(argv[i], "--quick") == 0;
  print_times(quick);
  print_quality(quick);
  print_densities();
  print_topology(quick);
}
