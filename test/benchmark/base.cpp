// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the distortion, the inverted triangles and the time of base mesh coordinates, for areas
// from geodesic distances and for mean values. Also measures the distance of semi-regular meshes to
// the input, and the times of section 5 of Peyre and Cohen 2003. The argument --paper selects the
// latter.
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/semi_regular_remeshing.h>

#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>
#include "core/unfold.h"

#include "models.h"
#include "report.h"
#include "topology.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
using namespace GP::internal;

const std::vector<std::string> model_names = {
    "bunny_37k",       "armadillo_26k",       "kitten_9k",        "elephant_2k8",
    "fandisk_6k5",     "nefertiti_35k",       "knot1_3k",         "eight_5k",
    "plane_holes_8k5", "mech_holes_shark_5k", "bunny_zipper_36k", "retinal_3k6"};

// Angle distortion, area distortion and symmetric Dirichlet energy: means over the base triangles
// that are not excluded. Each base triangle is laid out with its edge lengths.
struct Distortion
{
  double angles = 0., areas = 0., dirichlet = 0.;
  std::size_t faces = 0;
};

Distortion distortion(const Base_map& map, const std::vector<bool>& is_excluded)
{
  const Base_mesh& base = map.base();
  const Surface_arrays& t = base.fine;
  std::vector<double> length;
  for(const auto& path : base.path)
  {
    length.push_back(0.);
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
      length.back() += norm(t.point[path[i + 1]] - t.point[path[i]]);
  }
  std::vector<std::vector<Index>> faces_of_region(base.triangles.size());
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    faces_of_region[base.region[f]].push_back(f);
  Distortion result;
  for(Index region = 0; region < faces_of_region.size(); ++region)
  {
    const Index* edge = &base.edge[3 * std::size_t(region)];
    const double a = length[edge[0]], b = length[edge[1]], c = length[edge[2]];
    if(is_excluded[region] || !(twice_area(a, b, c) > 0.))
      continue;
    const std::array<Vec2, 3> corner = {Vec2{0., 0.}, Vec2{a, 0.}, third_corner(a, c, b)};
    const auto stretch = [&](Index f)
    {
      std::array<Vec2, 3> image;
      for(Index k = 0; k < 3; ++k)
        image[k] = unfolded_point(corner, map.coordinates()[3 * f + k]);
      return singular_values({t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]}, image);
    };
    double area = 0., planar = 0., angles = 0., areas = 0., dirichlet = 0.;
    for(const Index f : faces_of_region[region])
      if(const auto s = stretch(f); s.area > 0. && std::isfinite(s.sigma_1))
      {
        area += s.area;
        planar += s.area / (s.sigma_1 * s.sigma_2);
      }
    const double scale = std::sqrt(planar / area);
    for(const Index f : faces_of_region[region])
      if(auto s = stretch(f); s.area > 0. && std::isfinite(s.sigma_1))
      {
        const double sigma_1 = s.sigma_1 * scale, sigma_2 = s.sigma_2 * scale,
                     weight = s.area / area;
        angles += weight * (sigma_1 / sigma_2 + sigma_2 / sigma_1 - 2.);
        areas += weight * (sigma_1 * sigma_2 + 1. / (sigma_1 * sigma_2) - 2.);
        dirichlet += weight * (sigma_1 * sigma_1 + sigma_2 * sigma_2 + 1. / (sigma_1 * sigma_1) +
                               1. / (sigma_2 * sigma_2));
      }
    result.angles += std::sqrt(std::max(angles, 0.));
    result.areas += std::sqrt(std::max(areas, 0.));
    result.dirichlet += dirichlet;
    ++result.faces;
  }
  result.angles /= double(result.faces);
  result.areas /= double(result.faces);
  result.dirichlet /= double(result.faces);
  return result;
}

double diagonal(const Surface_arrays& t)
{
  std::array<double, 3> low = t.point[0], high = low;
  for(const auto& p : t.point)
    for(std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  return norm(high - low);
}

// Returns the largest distance of 10,000 random points to their images under the map and its
// inverse, divided by the bounding box diagonal.
double round_trip(const Base_map& map, const Surface_arrays& t)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  double max_error = 0.;
  for(int i = 0; i < 10000; ++i)
  {
    const double x = std::sqrt(uniform(random)), y = uniform(random);
    const Surface_location location{
        Index(random() % t.number_of_triangles()), none, {1. - x, x * (1. - y), x * y}};
    const Surface_location back = map.inverse(map(location));
    max_error =
        std::max(max_error, norm(scaled_coordinates(t, location) - scaled_coordinates(t, back)));
  }
  return max_error / diagonal(t);
}

// Returns flags of the base triangles whose coordinates have been repaired (shape: #base
// triangles).
std::vector<bool> repaired_regions(const Base_map& unrepaired_map, const Base_map& map)
{
  std::vector<bool> result(map.base().triangles.size(), false);
  for(std::size_t c = 0; c < map.coordinates().size(); ++c)
    if(unrepaired_map.coordinates()[c] != map.coordinates()[c])
      result[map.base().region[c / 3]] = true;
  return result;
}

// Returns the largest difference of barycentric coordinates across a base edge.
double largest_jump(const Base_map& map)
{
  const Base_mesh& base = map.base();
  const auto coordinate = [&](Index corner, Index vertex)
  {
    const auto& f = base.triangles[base.region[corner / 3]];
    const auto k = std::find(f.begin(), f.end(), vertex) - f.begin();
    return k < 3 ? map.coordinates()[corner][std::size_t(k)] : 0.;
  };
  double result = 0.;
  for(Index h = 0; h < base.fine.corner.size(); ++h)
  {
    const Index twin = base.fine.twin[h];
    if(base.edge_of_halfedge[h] == none || twin == none)
      continue;
    for(const auto& [corner_here, corner_there] :
        {std::pair(h, next_halfedge(twin)), std::pair(next_halfedge(h), twin)})
      for(const Index region : {base.region[corner_here / 3], base.region[corner_there / 3]})
        for(const Index vertex : base.triangles[region])
          result = std::max(
              result, std::abs(coordinate(corner_here, vertex) - coordinate(corner_there, vertex)));
  }
  return result;
}

bool has_same_topology(const Base_mesh& base, const Surface_arrays& t)
{
  std::vector<Index> corners;
  for(const auto& f : base.triangles)
    corners.insert(corners.end(), f.begin(), f.end());
  return GP::test::topology(corners) == GP::test::topology(t.corner);
}

std::string format_scientific(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

void print_maps(bool is_quick)
{
  std::printf(
      "Barycentric coordinates on base faces, from geodesic distances by Heron's formula (H)\n"
      "and from mean values (M). folds H: inverted triangles before repair; folds: after repair,\n"
      "H and M; jump: maximum difference of coordinates across base edges; topology: Euler\n"
      "characteristic and boundary cycles; Ec, Ea, SD: angle distortion, area distortion and\n"
      "symmetric Dirichlet energy, means over the base faces that are not repaired.\n\n");
  Table table("base meshes",
              {"model", "base", "folds H", "repaired faces", "folds", "round trip", "jump",
               "topology", "Ec H", "Ea H", "SD H", "Ec M", "Ea M", "SD M", "base [s]", "map [s]"});
  for(const std::string& name : model_names)
  {
    const auto mesh = load_model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 6000))
      continue;
    const auto domain = GP::make_domain(*mesh);
    for(const std::size_t number : {100, 200, 500})
    {
      Remeshing_options options;
      options.number_of_samples = number;
      std::shared_ptr<const Base_mesh> base;
      const double base_seconds = cpu_seconds(
          [&] {
            base = std::make_shared<const Base_mesh>(build_base_mesh(domain.triangles(), options));
          });
      const Base_map unrepaired_map(base, Base_coordinates::heron, false);
      std::optional<Base_map> map;
      const double map_seconds = cpu_seconds([&] { map.emplace(base, Base_coordinates::heron); });
      const Base_map other(base, Base_coordinates::mean_value);
      const std::vector<bool> is_repaired = repaired_regions(unrepaired_map, *map);
      const Distortion h = distortion(*map, is_repaired), m = distortion(other, is_repaired);
      table.add({name, std::to_string(base->samples.size()),
                 std::to_string(unrepaired_map.number_of_flips()),
                 std::to_string(map->number_of_repaired_regions()) + "/" +
                     std::to_string(base->triangles.size()),
                 std::to_string(map->number_of_flips() + other.number_of_flips()),
                 format_scientific(round_trip(*map, *domain.triangles())),
                 format_scientific(std::max(largest_jump(*map), largest_jump(other))),
                 has_same_topology(*base, *domain.triangles()) ? "same" : "different",
                 format_significant(h.angles), format_significant(h.areas),
                 benchmarks::format_fixed(h.dirichlet, 2), format_significant(m.angles),
                 format_significant(m.areas), benchmarks::format_fixed(m.dirichlet, 2),
                 benchmarks::format_fixed(base_seconds, 2),
                 benchmarks::format_fixed(map_seconds, 2)});
    }
  }
  table.print();
  std::printf("Targets: no folds, round trips below 1e-6, no jumps, the same topology.\n\n");
}

void print_semi_regular_meshes(bool is_quick)
{
  std::printf(
      "Semi-regular meshes with 500 base vertices and 4 levels: distance of face centers to "
      "the input,\nrelative to the bounding box diagonal, and angles in degrees\n\n");
  Table table("semi-regular meshes", {"model", "faces", "mean distance", "maximum distance",
                                      "angles in 20..120", "time [s]"});
  for(const std::string& name : model_names)
  {
    const auto mesh = load_model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 6000))
      continue;
    for(const auto kind : {Base_coordinates::heron, Base_coordinates::mean_value})
    {
      Mesh output;
      const double cost = cpu_seconds(
          [&] {
            GP::semi_regular_remeshing(*mesh, 500, 4, output,
                                       GP::parameters::base_coordinates(kind));
          });
      const auto domain = GP::make_domain(*mesh);
      const Triangle_tree tree(domain.triangles());
      double sum = 0., area = 0., largest = 0.;
      std::size_t number_of_good_angles = 0;
      for(const auto f : output.faces())
      {
        std::array<Vec3, 3> p;
        std::size_t k = 0;
        for(const auto v : vertices_around_face(output.halfedge(f), output))
        {
          const auto& q = output.point(v);
          p[k++] = {q.x(), q.y(), q.z()};
        }
        const Vec3 center = (1. / 3.) * (p[0] + p[1] + p[2]);
        const double distance =
            norm(center - coordinates(*domain.triangles(), tree.nearest(center)));
        const double size = norm(cross(p[1] - p[0], p[2] - p[0]));
        sum += size * distance;
        area += size;
        largest = std::max(largest, distance);
        for(k = 0; k < 3; ++k)
        {
          const Vec3 u = p[(k + 1) % 3] - p[k], v = p[(k + 2) % 3] - p[k];
          const double angle = std::atan2(norm(cross(u, v)), dot(u, v)) * 180. / pi;
          number_of_good_angles += angle >= 20. && angle <= 120.;
        }
      }
      const double bounding_diagonal = diagonal(*domain.triangles()) * domain.triangles()->scale;
      table.add({name + (kind == Base_coordinates::heron ? " H" : " M"),
                 std::to_string(num_faces(output)),
                 benchmarks::format_fixed(100. * sum / area / bounding_diagonal, 4) + " %",
                 benchmarks::format_fixed(100. * largest / bounding_diagonal, 3) + " %",
                 benchmarks::format_fixed(
                     100. * double(number_of_good_angles) / (3. * double(num_faces(output))), 1) +
                     " %",
                 benchmarks::format_fixed(cost, 2)});
    }
  }
  table.print();
  std::printf("Targets: mean distance 0.05 %%, 95 %% of the angles, 5 s at 35,000 vertices.\n");
}

// Measures the steps whose times are stated in section 5 of Peyre and Cohen 2003. The paper states
// neither its models nor its machine.
void print_paper_times()
{
  std::printf(
      "Section 5 of Peyre and Cohen 2003: processor times in seconds, medians of five "
      "rounds, paper in parentheses.\nThe base mesh includes its own sampling. The complete "
      "model is a semi-regular mesh of four levels.\n\n");
  Table table("steps of the paper",
              {"model", "vertices (5000)", "500 points (10)", "500 more (almost immediate)",
               "base mesh (about 10)", "parameterization (about 10)",
               "complete model (less than 60)"});
  for(const std::string name : {"eight_5k", "mech_holes_shark_5k", "fandisk_6k5"})
  {
    const auto mesh = load_model(name);
    if(!mesh)
      continue;
    std::vector<double> few, more, base_times, map_times, complete;
    const auto sample = [&](std::size_t number)
    {
      std::vector<GP::Location<Mesh>> samples;
      return cpu_seconds(
          [&] {
            GP::farthest_point_sampling<GP::Fast_marching>(*mesh, number,
                                                           std::back_inserter(samples));
          });
    };
    for(int round = 0; round < 5; ++round)
    {
      few.push_back(sample(500));
      more.push_back(sample(1000) - few.back());
      const auto domain = GP::make_domain(*mesh);
      Remeshing_options options;
      options.number_of_samples = 500;
      std::shared_ptr<const Base_mesh> base;
      base_times.push_back(cpu_seconds(
          [&] {
            base = std::make_shared<const Base_mesh>(build_base_mesh(domain.triangles(), options));
          }));
      map_times.push_back(cpu_seconds([&] { Base_map(base, Base_coordinates::heron); }));
      Mesh output;
      complete.push_back(cpu_seconds([&] { GP::semi_regular_remeshing(*mesh, 500, 4, output); }));
    }
    std::vector<std::string> row = {name, std::to_string(num_vertices(*mesh))};
    for(const auto& times : {few, more, base_times, map_times, complete})
      row.push_back(benchmarks::format_fixed(benchmarks::median(times), 3));
    table.add(row);
  }
  table.print();
}

} // namespace

// base [--quick | --paper]
int main(int argc, char** argv)
{
  if(argc > 1 && std::strcmp(argv[1], "--paper") == 0)
  {
    print_paper_times();
    return EXIT_SUCCESS;
  }
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  print_maps(is_quick);
  print_semi_regular_meshes(is_quick);
  print_paper_times();
}
