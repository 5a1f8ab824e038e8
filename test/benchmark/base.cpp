// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do base meshes distort, by areas of geodesic distances and by mean values, how many triangles would
// fold, how near are semi-regular meshes, and what does all that cost?
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
#include <cstring>
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

const std::vector<std::string> names = {
    "bunny_37k",       "armadillo_26k",       "kitten_9k",        "elephant_2k8",
    "fandisk_6k5",     "nefertiti_35k",       "knot1_3k",         "eight_5k",
    "plane_holes_8k5", "mech_holes_shark_5k", "bunny_zipper_36k", "retinal_3k6"};

// Of angles, of areas, and the symmetric Dirichlet energy: means over some of the base triangles, each laid
// out with the lengths of its edges.
struct Distortion
{
  double angles = 0., areas = 0., dirichlet = 0.;
  std::size_t faces = 0;
};

Distortion distortion(const Base_map& map, const std::vector<bool>& is_left_out)
{
  const Base_mesh& base = map.base();
  const Glued_triangles& t = base.fine;
  std::vector<double> length;
  for(const auto& path : base.path)
  {
    length.push_back(0.);
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
      length.back() += norm(t.point[path[i + 1]] - t.point[path[i]]);
  }
  std::vector<std::vector<Index>> parts(base.triangles.size());
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    parts[base.region[f]].push_back(f);
  Distortion result;
  for(Index region = 0; region < parts.size(); ++region)
  {
    const Index* edge = &base.edge[3 * std::size_t(region)];
    const double a = length[edge[0]], b = length[edge[1]], c = length[edge[2]];
    if(is_left_out[region] || !(twice_area(a, b, c) > 0.))
      continue;
    const std::array<Planar, 3> corner = {Planar{0., 0.}, Planar{a, 0.}, third_corner(a, c, b)};
    const auto stretch = [&](Index f)
    {
      std::array<Planar, 3> image;
      for(Index k = 0; k < 3; ++k)
        image[k] = unfolded_point(corner, map.coordinates()[3 * f + k]);
      return singular_values({t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]}, image);
    };
    double area = 0., planar = 0., angles = 0., areas = 0., dirichlet = 0.;
    for(const Index f : parts[region])
      if(const auto s = stretch(f); s.area > 0. && std::isfinite(s.most))
      {
        area += s.area;
        planar += s.area / (s.most * s.least);
      }
    const double scale = std::sqrt(planar / area);
    for(const Index f : parts[region])
      if(auto s = stretch(f); s.area > 0. && std::isfinite(s.most))
      {
        const double m = s.most * scale, l = s.least * scale, share = s.area / area;
        angles += share * (m / l + l / m - 2.);
        areas += share * (m * l + 1. / (m * l) - 2.);
        dirichlet += share * (m * m + l * l + 1. / (m * m) + 1. / (l * l));
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

double diagonal(const Glued_triangles& t)
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

// The farthest that one of 10,000 random places comes back from itself, as a part of the diagonal.
double round_trip(const Base_map& map, const Glued_triangles& t)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  double worst = 0.;
  for(int i = 0; i < 10000; ++i)
  {
    const double x = std::sqrt(uniform(random)), y = uniform(random);
    const Location there{
        Index(random() % t.number_of_triangles()), none, {1. - x, x * (1. - y), x * y}};
    const Location back = map.inverse(map(there));
    worst = std::max(worst, norm(scaled_coordinates(t, there) - scaled_coordinates(t, back)));
  }
  return worst / diagonal(t);
}

// #base triangles: those whose coordinates have been repaired.
std::vector<bool> repaired(const Base_map& raw, const Base_map& map)
{
  std::vector<bool> result(map.base().triangles.size(), false);
  for(std::size_t c = 0; c < map.coordinates().size(); ++c)
    if(raw.coordinates()[c] != map.coordinates()[c])
      result[map.base().region[c / 3]] = true;
  return result;
}

// The largest difference between the shares of base vertices on both sides of base edges.
double largest_jump(const Base_map& map)
{
  const Base_mesh& base = map.base();
  const auto share = [&](Index corner, Index vertex)
  {
    const auto& f = base.triangles[base.region[corner / 3]];
    const auto k = std::find(f.begin(), f.end(), vertex) - f.begin();
    return k < 3 ? map.coordinates()[corner][std::size_t(k)] : 0.;
  };
  double result = 0.;
  for(Index side = 0; side < base.fine.corner.size(); ++side)
  {
    const Index twin = base.fine.twin[side];
    if(base.edge_of_side[side] == none || twin == none)
      continue;
    for(const auto& [mine, other] :
        {std::pair(side, next_side(twin)), std::pair(next_side(side), twin)})
      for(const Index region : {base.region[mine / 3], base.region[other / 3]})
        for(const Index vertex : base.triangles[region])
          result = std::max(result, std::abs(share(mine, vertex) - share(other, vertex)));
  }
  return result;
}

bool has_same_topology(const Base_mesh& base, const Glued_triangles& t)
{
  std::vector<Index> corners;
  for(const auto& f : base.triangles)
    corners.insert(corners.end(), f.begin(), f.end());
  return GP::test::topology(corners) == GP::test::topology(t.corner);
}

std::string small(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

void maps(bool is_quick)
{
  std::printf(
      "Coordinates of Heron's areas (H) and mean values (M): triangles that fold before "
      "repair, base faces repaired,\njumps of shares across base edges, whether the base has the "
      "characteristic and the borders of the model; angles, areas and\nsymmetric Dirichlet "
      "energy as means over the base faces that are not repaired; seconds\n\n");
  Table table({"model", "base", "folds H", "repaired", "folds", "round trip", "jump", "topology",
               "Ec H", "Ea H", "SD H", "Ec M", "Ea M", "SD M", "s base", "s map"});
  for(const std::string& name : names)
  {
    const auto mesh = model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 6000))
      continue;
    const auto domain = GP::make_domain(*mesh);
    for(const std::size_t number : {100, 200, 500})
    {
      Remeshing_goal goal;
      goal.number = number;
      std::shared_ptr<const Base_mesh> base;
      const double to_base = seconds(
          [&] { base = std::make_shared<const Base_mesh>(base_mesh(domain.triangles(), goal)); });
      const Base_map raw(base, Base_coordinates::heron, false);
      std::optional<Base_map> map;
      const double to_map = seconds([&] { map.emplace(base, Base_coordinates::heron); });
      const Base_map other(base, Base_coordinates::mean_value);
      const std::vector<bool> is_repaired = repaired(raw, *map);
      const Distortion h = distortion(*map, is_repaired), m = distortion(other, is_repaired);
      table.add({name, std::to_string(base->samples.size()), std::to_string(raw.folds()),
                 std::to_string(map->repaired()) + "/" + std::to_string(base->triangles.size()),
                 std::to_string(map->folds() + other.folds()),
                 small(round_trip(*map, *domain.triangles())),
                 small(std::max(largest_jump(*map), largest_jump(other))),
                 has_same_topology(*base, *domain.triangles()) ? "same" : "other", digits(h.angles),
                 digits(h.areas), benchmarks::number(h.dirichlet, 2), digits(m.angles),
                 digits(m.areas), benchmarks::number(m.dirichlet, 2),
                 benchmarks::number(to_base, 2), benchmarks::number(to_map, 2)});
    }
  }
  table.print();
  std::printf("Wanted: no folds; round trips below 1e-6; no jumps; the same topology.\n\n");
}

void semi_regular_meshes(bool is_quick)
{
  std::printf(
      "Semi-regular meshes of 500 base vertices at level 4: distance of face centres to the "
      "input as a part of the\ndiagonal, and angles\n\n");
  Table table({"model", "faces", "mean distance", "largest", "angles in 20..120", "seconds"});
  for(const std::string& name : names)
  {
    const auto mesh = model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 6000))
      continue;
    for(const auto kind : {Base_coordinates::heron, Base_coordinates::mean_value})
    {
      Mesh output;
      const double cost = seconds(
          [&] {
            GP::semi_regular_remeshing(*mesh, 500, 4, output,
                                       GP::parameters::base_coordinates(kind));
          });
      const auto domain = GP::make_domain(*mesh);
      const Triangle_tree tree(domain.triangles());
      double sum = 0., area = 0., largest = 0.;
      std::size_t good = 0;
      for(const auto f : output.faces())
      {
        std::array<Spatial, 3> p;
        std::size_t k = 0;
        for(const auto v : vertices_around_face(output.halfedge(f), output))
        {
          const auto& q = output.point(v);
          p[k++] = {q.x(), q.y(), q.z()};
        }
        const Spatial centre = (1. / 3.) * (p[0] + p[1] + p[2]);
        const double distance =
            norm(centre - coordinates(*domain.triangles(), tree.nearest(centre)));
        const double size = norm(cross(p[1] - p[0], p[2] - p[0]));
        sum += size * distance;
        area += size;
        largest = std::max(largest, distance);
        for(k = 0; k < 3; ++k)
        {
          const Spatial u = p[(k + 1) % 3] - p[k], v = p[(k + 2) % 3] - p[k];
          const double angle = std::atan2(norm(cross(u, v)), dot(u, v)) * 180. / pi;
          good += angle >= 20. && angle <= 120.;
        }
      }
      const double whole = diagonal(*domain.triangles()) * domain.triangles()->scale;
      table.add(
          {name + (kind == Base_coordinates::heron ? " H" : " M"),
           std::to_string(num_faces(output)),
           benchmarks::number(100. * sum / area / whole, 4) + " %",
           benchmarks::number(100. * largest / whole, 3) + " %",
           benchmarks::number(100. * double(good) / (3. * double(num_faces(output))), 1) + " %",
           benchmarks::number(cost, 2)});
    }
  }
  table.print();
  std::printf("Wanted: 0.05 %% in the mean, 95 %% of the angles, and 5 s at 35,000 vertices.\n");
}

} // namespace

int main(int argc, char** argv)
{
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  maps(is_quick);
  semi_regular_meshes(is_quick);
}
