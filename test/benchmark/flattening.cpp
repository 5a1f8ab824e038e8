// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How do flattenings distort, and what do they cost?  Beside CGAL's conformal, authalic and
// as-rigid-as-possible maps.  And texture atlases.
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "report.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;
using UV = Kernel::Point_2;
using UV_map = Mesh::Property_map<Vertex, UV>;

UV_map new_map(Mesh& mesh) { return mesh.add_property_map<Vertex, UV>().first; }

template <typename Parameterizer>
bool parameterize(Mesh& mesh, UV_map uv, Parameterizer parameterizer)
{
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  return SMP::parameterize(mesh, parameterizer, border, uv) == SMP::OK;
}

// The integral of the absolute Gaussian curvature, as a part of 2 pi.
double curvature(const Mesh& mesh)
{
  double result = 0.;
  for(const Vertex v : mesh.vertices())
  {
    if(mesh.is_isolated(v) || mesh.is_border(v))
      continue;
    double angle = 2. * CGAL_PI;
    for(const auto h : CGAL::halfedges_around_target(v, mesh))
    {
      const auto a = mesh.point(mesh.source(h)) - mesh.point(v),
                 b = mesh.point(mesh.target(mesh.next(h))) - mesh.point(v);
      const auto normal = cross_product(a, b);
      angle -= std::atan2(std::sqrt(normal * normal), a * b);
    }
    result += std::abs(angle);
  }
  return result / (2. * CGAL_PI);
}

void add_row(Table& table, const std::string& name, const std::string& method,
             const GP::Flattening_distortion& d)
{
  table.add({name, method, digits(d.conformal), digits(d.authalic),
             digits(d.conformal + d.authalic), number(d.symmetric_dirichlet, 4),
             digits(d.l2_stretch), digits(d.linf_stretch), std::to_string(d.number_of_flips)});
}

void distortion(bool is_quick)
{
  std::printf("Distortion: conformal and authalic, their sum, symmetric Dirichlet, "
              "stretch\n\n");
  Table table({"patch", "method", "Ec", "Ea", "Ec + Ea", "Dirichlet", "L2", "Linf", "flips"});
  Table few(
      {"patch: Dirichlet", "5", "10", "20", "100 base points", "20, injective", "100, injective"});
  std::size_t patches = 0, gentle = 0, unturned = 0, compared = 0, least = 0, between = 0,
              below = 0, injective = 0, near_arap = 0, with_arap = 0, settled = 0,
              settled_injective = 0;
  for(const std::string name :
      {"alligator_3k", "bff_face_17k", "bff_maze_6k", "camelhead_11k",
       "cylinder_locally_refined_8k", "disk_5k", "hemisphere_2k", "mannequin_devil_13k",
       "mushroom_2k", "nefertiti_299", "patch_01_735", "terrain_st_helens_149k", "three_peaks_2k"})
  {
    auto mesh = model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 4000))
      continue;
    ++patches;
    const auto measured = [&](const std::string& method, const UV_map& uv)
    {
      const auto found = GP::flattening_distortion(*mesh, uv);
      add_row(table, method == "glle" ? name : "", method, found);
      return found;
    };
    const UV_map uv = new_map(*mesh), other = new_map(*mesh);
    GP::geodesic_lle(*mesh, uv);
    const double bent = curvature(*mesh);
    table.add({name + ": curvature " + digits(bent) + " * 2 pi", "", "", "", "", "", "", "", ""});
    const auto glle = measured("glle", uv);
    gentle += bent <= 1.;
    unturned += bent <= 1. && glle.number_of_flips == 0;
    GP::geodesic_mds(*mesh, other);
    measured("mds", other);
    std::map<std::string, GP::Flattening_distortion> peers;
    if(parameterize(*mesh, other, SMP::LSCM_parameterizer_3<Mesh>()))
      peers["lscm"] = measured("CGAL lscm", other);
    if(parameterize(*mesh, other, SMP::Discrete_authalic_parameterizer_3<Mesh>()))
      peers["authalic"] = measured("CGAL authalic", other);
    GP::minimize_distortion(*mesh, uv);
    const auto flat = measured("injective", uv);
    injective += flat.number_of_flips == 0;
    if(num_vertices(*mesh) < 50000 && parameterize(*mesh, other, SMP::ARAP_parameterizer_3<Mesh>()))
    {
      const auto arap = measured("CGAL arap", other);
      with_arap += arap.number_of_flips == 0;
      near_arap +=
          arap.number_of_flips == 0 && flat.symmetric_dirichlet <= 1.05 * arap.symmetric_dirichlet;
    }
    const auto sum = [](const GP::Flattening_distortion& d) { return d.conformal + d.authalic; };
    const auto is_between = [](double x, double a, double b)
    { return std::min(a, b) <= x && x <= std::max(a, b); };
    if(peers.size() == 2)
    {
      const auto &lscm = peers["lscm"], &authalic = peers["authalic"];
      ++compared;
      least += sum(glle) <= 1.001 * std::min(sum(lscm), sum(authalic)) || sum(glle) <= 1e-6;
      between += is_between(glle.conformal, lscm.conformal, authalic.conformal) &&
                 is_between(glle.authalic, lscm.authalic, authalic.authalic);
      below += glle.conformal <= std::max(lscm.conformal, authalic.conformal) &&
               glle.authalic <= std::max(lscm.authalic, authalic.authalic);
    }
    std::vector<std::string> row = {name};
    std::vector<double> energies;
    for(const std::size_t base : {5, 10, 20, 100})
    {
      GP::geodesic_lle(*mesh, other, GP::parameters::number_of_base_points(base));
      energies.push_back(GP::flattening_distortion(*mesh, other).symmetric_dirichlet);
      row.push_back(digits(energies.back()));
    }
    settled += energies[2] <= 1.2 * energies[3];
    for(const std::size_t base : {20, 100})
    {
      GP::geodesic_lle(*mesh, other, GP::parameters::number_of_base_points(base));
      GP::minimize_distortion(*mesh, other);
      energies.push_back(GP::flattening_distortion(*mesh, other).symmetric_dirichlet);
      row.push_back(number(energies.back(), 4));
    }
    settled_injective += energies[4] <= 1.2 * energies[5];
    few.add(row);
  }
  table.print();
  std::printf(
      "Of %zu patches: glle without flips on %zu of %zu whose curvature is 2 pi at most (all); "
      "Ec + Ea of glle at most 1.001 times\nthat of lscm and of authalic, or below 1e-6, on %zu "
      "(wanted: 10 of 13) of %zu where both have a map, and both between\nthose of the two on %zu, "
      "and neither above the larger one on %zu; "
      "injective without flips on %zu (all), with at most 1.05 times the symmetric Dirichlet "
      "energy\nof arap on %zu of %zu where that has no flips (all).\n\n",
      patches, unturned, gentle, least, compared, between, below, injective, near_arap, with_arap);
  few.print();
  std::printf(
      "With 20 at most 1.2 times what it is with 100 on %zu, of injective maps on %zu (all).\n\n",
      settled, settled_injective);
}

// is_patient: CGAL's as-rigid-as-possible map of large patches too, which takes many minutes.
void time(bool is_quick, bool is_patient)
{
  std::printf("Seconds, from the mesh to the map\n\n");
  Table table({"patch", "vertices", "glle", "over n log n [ns]", "mds", "injective", "CGAL lscm",
               "over glle", "CGAL arap", "over glle"});
  std::vector<std::pair<std::string, Mesh>> meshes = {{"square", jittered_square(32)}};
  if(auto mesh = model("camelhead_11k"))
    meshes.emplace_back("camelhead_11k", *mesh);
  if(!is_quick)
  {
    meshes.emplace_back("square", jittered_square(317));
    if(auto mesh = model("terrain_st_helens_149k"))
    {
      meshes.emplace_back("terrain_st_helens_149k", *mesh);
      meshes.emplace_back("  cut once", refined(*mesh));
    }
  }
  for(auto& [name, mesh] : meshes)
  {
    const UV_map uv = new_map(mesh);
    const std::size_t n = num_vertices(mesh);
    const double mds = seconds([&] { GP::geodesic_mds(mesh, uv); });
    const double glle = seconds([&] { GP::geodesic_lle(mesh, uv); });
    const double injective =
        n > 200000 ? std::nan("") : seconds([&] { GP::minimize_distortion(mesh, uv); });
    const double lscm = seconds([&] { parameterize(mesh, uv, SMP::LSCM_parameterizer_3<Mesh>()); });
    const double arap =
        n > 50000 && !is_patient
            ? std::nan("")
            : seconds([&] { parameterize(mesh, uv, SMP::ARAP_parameterizer_3<Mesh>()); });
    table.add({name, std::to_string(n), number(glle, 2),
               number(1e9 * glle / (double(n) * std::log2(double(n))), 0), number(mds, 2),
               number(injective, 2), number(lscm, 2), number(lscm / glle, 1), number(arap, 2),
               number(arap / glle, 1)});
  }
  table.print();
  std::printf(
      "Wanted of glle at 10,000, 100,000 and 600,000 vertices: 0.3, 1.5 and 11 s, a tenth of the "
      "others at 600,000.\n\n");
}

// How many middles of texels lie inside of two faces or more.
std::size_t texels_taken_twice(const Mesh& mesh, const std::vector<UV>& uv, std::size_t size)
{
  std::vector<unsigned char> times(size * size, 0);
  std::size_t result = 0;
  for(const auto face : mesh.faces())
  {
    const auto h = mesh.halfedge(face);
    std::array<UV, 3> p = {uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]};
    for(UV& corner : p)
      corner = UV(corner.x() * double(size), corner.y() * double(size));
    const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [low, high] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for(auto y = std::size_t(low); y < size && double(y) < high; ++y)
      for(auto x = std::size_t(left); x < size && double(x) < right; ++x)
      {
        const UV middle(double(x) + 0.5, double(y) + 0.5);
        if(CGAL::left_turn(p[0], p[1], middle) && CGAL::left_turn(p[1], p[2], middle) &&
           CGAL::left_turn(p[2], p[0], middle))
          result += ++times[y * size + x] == 2;
      }
  }
  return result;
}

void atlas(bool is_quick)
{
  std::printf("Texture atlases of 2,048 texels, on two threads\n\n");
  Table table({"model", "vertices", "asked for", "charts", "flips", "overlaps",
               "texels taken twice", "coverage", "watch [s]", "processor [s]"});
  const auto add = [&](const std::string& name, const Mesh& mesh, std::size_t number)
  {
    std::vector<UV> uv(mesh.number_of_halfedges());
    const auto map =
        boost::make_iterator_property_map(uv.begin(), get(boost::halfedge_index, mesh));
    GP::Texture_atlas found;
    double processor = 0.;
    const double watch = seconds_on_a_watch(
        [&]
        {
          processor = seconds(
              [&]
              {
                found = GP::texture_atlas<GP::Euclidean_front, CGAL::Parallel_tag>(
                    mesh, number, map, GP::parameters::texture_size(2048).threads(2));
              });
        });
    table.add({name, std::to_string(num_vertices(mesh)), std::to_string(number),
               std::to_string(found.number_of_charts), std::to_string(found.number_of_flips),
               std::to_string(found.number_of_overlaps),
               std::to_string(texels_taken_twice(mesh, uv, 4096)),
               benchmarks::number(found.coverage, 3), benchmarks::number(watch, 1),
               benchmarks::number(processor, 1)});
  };
  if(auto mesh = model("bunny_37k"))
  {
    add("bunny_37k", *mesh, 50);
    if(!is_quick)
      add("  cut twice", refined(refined(*mesh)), 100);
  }
  if(auto mesh = model("armadillo_26k"))
    add("armadillo_26k", *mesh, 50);
  if(!is_quick)
    if(auto mesh = model("mni152_grey_matter_533k"))
      add("mni152_grey_matter_533k", *mesh, 200);
  table.print();
  std::printf("Wanted: 30 s for half a million vertices, no flips and no overlaps.\n\n");
}

} // namespace

int main(int argc, char** argv)
{
  const auto has = [&](const char* option)
  {
    return std::any_of(argv + 1, argv + argc,
                       [&](const char* a) { return !std::strcmp(a, option); });
  };
  const bool is_quick = has("--quick");
  time(is_quick, has("--patient"));
  atlas(is_quick);
  distortion(is_quick);
}
