// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures whether paths on scans stay near the surfels and on one sheet.
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_estimation.h>

#include "clouds.h"
#include "report.h"

#include <CGAL/IO/read_points.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Reads a cloud with its normals. If it has none, they are computed by estimate_surfels().
Cloud load_scan(const std::filesystem::path& file)
{
  CGAL::Point_set_3<CGAL::Simple_cartesian<double>::Point_3> points;
  Cloud cloud;
  if(!CGAL::IO::read_point_set(file.string(), points))
    return cloud;
  const auto spatial = [](const auto& p) -> Vec3 { return {p.x(), p.y(), p.z()}; };
  for(const auto& index : points)
    cloud.add(spatial(points.point(index)),
              points.has_normal_map() ? spatial(points.normal(index)) : Vec3{0., 0., 1.});
  if(!points.has_normal_map())
    cloud.normals = estimate_surfels(cloud.points, 18, 0., 1).normals;
  return cloud;
}

// Statistics of paths on a scan.
struct Path_adherence
{
  std::size_t pairs = 0, points = 0, number_outside = 0, crossings = 0, longer = 0;
  double max_distance = 0.; // largest distance divided by the local spacing
};

// Counts path points outside of the cloud, and path steps between separate sheets.
//
// A point is outside if its distance to the nearest surfel exceeds the local spacing. The local
// spacing is the 95th percentile, over the 60 nearest surfels, of the distance to the sixth
// neighbor.
//
// Two surfels agree if their normals differ by less than 100 degrees, and if their chord rises
// above neither of them by more than that difference. Two surfels are on separate sheets if no
// short chain connects them in which each surfel agrees with the next. A chain is short if its
// length is at most twice the step plus three radii of each surfel. A step of a path crosses if its
// two surfels are on separate sheets. The surfels are the smoothed ones of the path finder. Their
// neighbors are selected by normals, regardless of the graph of the path. Therefore paths that
// start in a graph without normals reveal if the cloud has such sheets. If normals are random, as
// between trees, chains lead around nearly everything but gaps and walls.
Path_adherence measure_adherence(const Cloud& cloud, std::size_t max_pairs, unsigned seed,
                                 Surfel_graph graph)
{
  constexpr std::size_t number_of_neighbors = 60, percentile_index = 57;
  std::vector<Vec3> cloud_points = cloud.points;
  std::vector<Index> order;
  const Kd_tree tree(cloud_points, order);
  std::vector<Kd_tree::Neighbor> near;
  std::vector<double> spacing, local_spacing;
  for(const Vec3& p : cloud_points)
  {
    tree.nearest(cloud_points, p, 7, near);
    spacing.push_back(std::sqrt(near.back().squared_distance));
  }
  Cloud_path_options options;
  options.cloud.graph = graph;
  const auto fitted_cloud = std::make_shared<const Fitted_cloud>(cloud.points, cloud.normals,
                                                                 std::vector<double>(), options);
  Cloud_path_finder finder(fitted_cloud);
  const Surfel_cloud& c = fitted_cloud->cloud();
  const Surfel_cloud sheet_cloud = make_cloud(c.point, c.normal);
  const auto crosses_sheets = [&](const Projection& from, const Projection& to)
  {
    const Index a = sheet_cloud.internal_vertex[from.vertex],
                b = sheet_cloud.internal_vertex[to.vertex];
    const double max_path_length = 2. * norm(to.point - from.point) / sheet_cloud.frame.scale +
                                   3. * (sheet_cloud.radius[a] + sheet_cloud.radius[b]);
    return !is_connected_within(sheet_cloud, a, b, max_path_length);
  };
  Path_adherence result;
  std::mt19937 random(seed);
  while(result.pairs < max_pairs)
  {
    const Index a = c.internal_vertex[random() % cloud.size()],
                b = c.internal_vertex[random() % cloud.size()];
    if(a == b || c.component[a] != c.component[b])
      continue;
    ++result.pairs;
    const Cloud_path found = finder({a, {0., 0.}}, {b, {0., 0.}});
    const std::vector<Projection>& points = found.path.points;
    result.longer += found.path.length > found.initial_length * (1. + 1e-12); // round-off error
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      tree.nearest(cloud_points, c.frame.origin + c.frame.scale * points[i].point,
                   number_of_neighbors, near);
      local_spacing.clear();
      for(const Kd_tree::Neighbor& neighbor : near)
        local_spacing.push_back(spacing[neighbor.point]);
      std::nth_element(local_spacing.begin(), local_spacing.begin() + percentile_index,
                       local_spacing.end());
      const double ratio =
          std::sqrt(near.front().squared_distance) / local_spacing[percentile_index];
      ++result.points;
      result.number_outside += ratio > 1.;
      result.max_distance = std::max(result.max_distance, ratio);
      result.crossings += i > 0 && crosses_sheets(points[i - 1], points[i]);
    }
  }
  return result;
}

void print_scans(unsigned seed)
{
  std::printf(
      "Scans: distances of paths to the cloud, and steps between separate sheets (seed %u)\n",
      seed);
  Table table("scans", {"scan", "surfels", "paths", "points", "outside", "maximum distance",
                        "longer", "crossings", "without normals"});
  std::vector<std::filesystem::path> files;
  const auto folder = std::filesystem::path(GEODESIC_PROCESSING_DATA) / "points";
  if(exists(folder))
    files.assign(std::filesystem::directory_iterator(folder), {});
  std::sort(files.begin(), files.end());
  for(const auto& file : files)
    if(const Cloud cloud = load_scan(file); cloud.size() > 60)
    {
      const Path_adherence k = measure_adherence(cloud, 60, seed, Surfel_graph::extended_spheres),
                           without_normals =
                               measure_adherence(cloud, 60, seed, Surfel_graph::nearest);
      table.add({file.stem().string(), std::to_string(cloud.size()), std::to_string(k.pairs),
                 std::to_string(k.points), std::to_string(k.number_outside),
                 format_fixed(k.max_distance, 3), std::to_string(k.longer),
                 std::to_string(k.crossings), std::to_string(without_normals.crossings)});
    }
  table.print();
  std::printf("Targets: no point outside, no path longer than its initial path, no crossings (some "
              "are allowed without normals).\n\n");
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string argument = argc > 1 ? argv[1] : "";
  print_scans(argument == "--seed" && argc > 2 ? unsigned(std::stoul(argv[2])) : 1);
}
