// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the distortion and the time of flattenings, compared with CGAL's conformal, authalic and
// as-rigid-as-possible maps. Also measures texture atlases, both starts of the embedding, and the
// tables of Peyre and Cohen 2005. The argument --paper selects the latter two.
#include <CGAL/Geodesic_processing.h>

#include "Paper_embedding.h"
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
#include <iterator>
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

// Returns the integral of the absolute Gaussian curvature over the interior vertices, divided by 2
// pi.
double total_curvature(const Mesh& mesh)
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

void add_row(Table& table, const std::string& name, std::size_t number_of_vertices,
             double curvature, const std::string& method, const GP::Flattening_distortion& d)
{
  table.add({name, std::to_string(number_of_vertices), format_significant(curvature), method,
             format_significant(d.conformal), format_significant(d.authalic),
             format_significant(d.conformal + d.authalic), format_fixed(d.symmetric_dirichlet, 4),
             format_significant(d.l2_stretch), format_significant(d.linf_stretch),
             std::to_string(d.number_of_flips)});
}

// Numbers of patches on which the maps meet the bars.
struct Distortion_counts
{
  std::size_t patches = 0, low_curvature = 0, without_flips = 0, compared = 0,
              with_smallest_sum = 0, between = 0, below_larger = 0, injective = 0, near_arap = 0,
              with_arap = 0, settled = 0, settled_injective = 0;

  void add_glle(const GP::Flattening_distortion& glle, double curvature)
  {
    ++patches;
    low_curvature += curvature <= 1.;
    without_flips += curvature <= 1. && glle.number_of_flips == 0;
  }

  void add_comparison(const GP::Flattening_distortion& glle, const GP::Flattening_distortion& lscm,
                      const GP::Flattening_distortion& authalic)
  {
    const auto sum = [](const GP::Flattening_distortion& d) { return d.conformal + d.authalic; };
    const auto is_between = [](double x, double a, double b)
    { return std::min(a, b) <= x && x <= std::max(a, b); };
    ++compared;
    with_smallest_sum +=
        sum(glle) <= 1.001 * std::min(sum(lscm), sum(authalic)) || sum(glle) <= 1e-6;
    between += is_between(glle.conformal, lscm.conformal, authalic.conformal) &&
               is_between(glle.authalic, lscm.authalic, authalic.authalic);
    below_larger += glle.conformal <= std::max(lscm.conformal, authalic.conformal) &&
                    glle.authalic <= std::max(lscm.authalic, authalic.authalic);
  }

  void add_arap(const GP::Flattening_distortion& flat, const GP::Flattening_distortion& arap)
  {
    with_arap += arap.number_of_flips == 0;
    near_arap +=
        arap.number_of_flips == 0 && flat.symmetric_dirichlet <= 1.05 * arap.symmetric_dirichlet;
  }

  void print() const
  {
    std::printf(
        "%zu patches, targets in parentheses. glle has no flips on %zu of %zu patches with a "
        "curvature of at most 2 pi (all).\nPatches with maps by both lscm and authalic: Ec + Ea of "
        "glle is at most 1.001 times that of each, or below 1e-6,\non %zu of %zu (10 of 13); "
        "Ec and Ea are between both on %zu, and at most the larger one on %zu.\n"
        "injective has no flips on %zu patches (all). Its symmetric Dirichlet energy is at most "
        "1.05 times that of arap\non %zu of %zu patches on which arap has no flips (all).\n\n",
        patches, without_flips, low_curvature, with_smallest_sum, compared, between, below_larger,
        injective, near_arap, with_arap);
  }
};

// Adds a row for each map of a patch.
void add_patch_rows(Table& table, Distortion_counts& counts, const std::string& name, Mesh& mesh)
{
  const double patch_curvature = total_curvature(mesh);
  const auto add_measurement = [&](const std::string& method, const UV_map& uv)
  {
    const auto found = GP::flattening_distortion(mesh, uv);
    add_row(table, name, num_vertices(mesh), patch_curvature, method, found);
    return found;
  };
  const UV_map uv = new_map(mesh), other_uv = new_map(mesh);
  GP::geodesic_lle(mesh, uv);
  const auto glle = add_measurement("glle", uv);
  counts.add_glle(glle, patch_curvature);
  GP::geodesic_mds(mesh, other_uv);
  add_measurement("mds", other_uv);
  std::map<std::string, GP::Flattening_distortion> cgal_maps;
  if(parameterize(mesh, other_uv, SMP::LSCM_parameterizer_3<Mesh>()))
    cgal_maps["lscm"] = add_measurement("CGAL lscm", other_uv);
  if(parameterize(mesh, other_uv, SMP::Discrete_authalic_parameterizer_3<Mesh>()))
    cgal_maps["authalic"] = add_measurement("CGAL authalic", other_uv);
  if(cgal_maps.size() == 2)
    counts.add_comparison(glle, cgal_maps["lscm"], cgal_maps["authalic"]);
  GP::minimize_distortion(mesh, uv);
  const auto flat = add_measurement("injective", uv);
  counts.injective += flat.number_of_flips == 0;
  if(num_vertices(mesh) < 50000 && parameterize(mesh, other_uv, SMP::ARAP_parameterizer_3<Mesh>()))
    counts.add_arap(flat, add_measurement("CGAL arap", other_uv));
}

// Adds a row with the symmetric Dirichlet energy of a patch for several numbers of base points.
void add_base_point_row(Table& table, Distortion_counts& counts, const std::string& name,
                        Mesh& mesh)
{
  const UV_map uv = new_map(mesh);
  std::vector<std::string> row = {name};
  std::vector<double> energies;
  for(const std::size_t base : {5, 10, 20, 100})
  {
    GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(base));
    energies.push_back(GP::flattening_distortion(mesh, uv).symmetric_dirichlet);
    row.push_back(format_significant(energies.back()));
  }
  counts.settled += energies[2] <= 1.2 * energies[3];
  for(const std::size_t base : {20, 100})
  {
    GP::geodesic_lle(mesh, uv, GP::parameters::number_of_base_points(base));
    GP::minimize_distortion(mesh, uv);
    energies.push_back(GP::flattening_distortion(mesh, uv).symmetric_dirichlet);
    row.push_back(format_fixed(energies.back(), 4));
  }
  counts.settled_injective += energies[4] <= 1.2 * energies[5];
  table.add(row);
}

// The patches of the tables.
const char* const patches[] = {"alligator_3k",
                               "bff_face_17k",
                               "bff_maze_6k",
                               "camelhead_11k",
                               "cylinder_locally_refined_8k",
                               "disk_5k",
                               "hemisphere_2k",
                               "mannequin_devil_13k",
                               "mushroom_2k",
                               "nefertiti_299",
                               "patch_01_735",
                               "terrain_st_helens_149k",
                               "three_peaks_2k"};

std::vector<UV> images(const Mesh& mesh, UV_map uv)
{
  std::vector<UV> result;
  for(const Vertex v : mesh.vertices())
    result.push_back(uv[v]);
  return result;
}

// Counts the starts of geodesic_lle() that result in less energy, and compares both starts with
// locally linear embedding alone and with the formulas as printed in the paper.
void print_starts(bool is_quick)
{
  Table table("starts", {"Dirichlet energy, flips", "better start", "lle", "mds", "lle alone",
                         "centered, interpolated", "centered, Nystrom", "printed, interpolated",
                         "printed, Nystrom"});
  std::map<std::string, std::size_t> wins;
  for(const std::string name : patches)
  {
    auto mesh = load_model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 4000))
      continue;
    const UV_map uv = new_map(*mesh);
    const auto cell = [&]
    {
      const auto found = GP::flattening_distortion(*mesh, uv);
      return format_significant(found.symmetric_dirichlet) + ", " +
             std::to_string(found.number_of_flips);
    };
    GP::geodesic_lle(*mesh, uv);
    const std::vector<UV> best = images(*mesh, uv);
    using Start = GP::Flattening_start;
    std::vector<std::string> cells;
    std::string winner = "equal";
    for(const Start start : {Start::lle, Start::mds})
    {
      GP::geodesic_lle(*mesh, uv, GP::parameters::flattening_start(start));
      cells.push_back(cell());
      if(images(*mesh, uv) == best)
        winner = start == Start::lle ? "lle" : "mds";
    }
    ++wins[winner];
    GP::geodesic_lle(
        *mesh, uv,
        GP::parameters::flattening_start(Start::lle).number_of_rigid_steps(std::size_t(0)));
    cells.push_back(cell());
    const GP::Mesh_domain<Mesh> domain(*mesh);
    for(const bool use_printed_gram : {false, true})
      for(const bool use_nystrom : {false, true})
      {
        const Paper_embedding embedding(domain.triangles(),
                                        std::min<std::size_t>(200, num_vertices(*mesh)),
                                        {use_printed_gram, use_nystrom});
        for(GP::internal::Index i = 0; i < embedding.image().size(); ++i)
          uv[domain.vertex(i)] = UV(embedding.image()[i][0], embedding.image()[i][1]);
        cells.push_back(cell());
      }
    cells.insert(cells.begin(), {name, winner});
    table.add(cells);
  }
  std::printf(
      "Starts of geodesic_lle(), and the formulas of Peyre and Cohen with 200 base points\n\n");
  table.print();
  std::printf("The start lle has less energy on %zu patches, mds on %zu.\n\n", wins["lle"],
              wins["mds"]);
}

// Tables I to III of Peyre and Cohen 2005. The paper's numbers are quoted next to ours; its meshes
// are other ones, and its machine is not stated.

std::string beside(const std::string& ours, const std::string& paper)
{
  return ours + " (" + paper + ")";
}

void print_first_paper_table()
{
  Table first("table I of the paper", {"table I: seconds (paper)", "vertices", "fast marching",
                                       "sampling, 200", "Lloyd step", "mds", "glle"});
  if(auto mesh = load_model("camelhead_11k"))
  {
    const UV_map uv = new_map(*mesh);
    const auto distance = mesh->add_property_map<Vertex, double>("v:distance").first;
    const auto label = mesh->add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
    const auto seconds = [](const auto& run) { return format_fixed(cpu_seconds(run), 2); };
    std::vector<Vertex> samples;
    const auto tessellate = [&](unsigned steps)
    {
      return cpu_seconds(
          [&]
          {
            GP::geodesic_centroidal_tessellation(
                *mesh, 200, label, GP::parameters::maximum_number_of_iterations(steps));
          });
    };
    first.add(
        {"camelhead_11k (10k)", std::to_string(num_vertices(*mesh)),
         beside(seconds([&]
                        { GP::geodesic_distances<GP::Fast_marching>(*mesh, Vertex(0), distance); }),
                "2"),
         beside(seconds(
                    [&] {
                      GP::farthest_vertex_sampling<GP::Fast_marching>(*mesh, 200,
                                                                      std::back_inserter(samples));
                    }),
                "10"),
         beside(format_fixed((tessellate(5) - tessellate(1)) / 4., 2), "6"),
         beside(seconds([&] { GP::geodesic_mds(*mesh, uv); }), "55"),
         beside(seconds([&] { GP::geodesic_lle(*mesh, uv); }), "28")});
  }
  first.print();
}

void print_second_paper_table(bool is_quick)
{
  Table second("table II of the paper",
               {"table II: seconds (paper)", "vertices", "mds", "conformal", "glle"});
  const auto add_times =
      [&](const std::string& name, Mesh mesh, const std::array<std::string, 3>& paper)
  {
    const UV_map uv = new_map(mesh);
    second.add(
        {name, std::to_string(num_vertices(mesh)),
         beside(format_fixed(cpu_seconds([&] { GP::geodesic_mds(mesh, uv); }), 2), paper[0]),
         beside(format_fixed(
                    cpu_seconds([&] { parameterize(mesh, uv, SMP::LSCM_parameterizer_3<Mesh>()); }),
                    2),
                paper[1]),
         beside(format_fixed(cpu_seconds([&] { GP::geodesic_lle(mesh, uv); }), 2), paper[2])});
  };
  // The first number is hardly legible in the paper's text.
  add_times("square (1,000)", jittered_square(32), {"8 or 18", "3", "5"});
  if(auto mesh = load_model("camelhead_11k"))
    add_times("camelhead_11k (10,000)", *mesh, {"55", "25", "28"});
  if(!is_quick)
  {
    add_times("square (100,000)", jittered_square(317), {"440", "210", "150"});
    if(auto mesh = load_model("terrain_st_helens_149k"))
      add_times("terrain, refined once (700,000)", refined(*mesh), {"2,160", "1,320", "740"});
  }
  second.print();
}

void print_third_paper_table(bool is_quick)
{
  Table third("table III of the paper",
              {"table III: Ec, Ea (paper)", "conformal", "authalic", "mds", "glle", "lle alone"});
  const auto add_distortion = [&](const std::string& name, const std::array<std::string, 4>& paper)
  {
    auto mesh = load_model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 4000))
      return;
    const UV_map uv = new_map(*mesh);
    const auto cell = [&](const std::string& quoted)
    {
      const auto found = GP::flattening_distortion(*mesh, uv);
      return beside(format_significant(found.conformal) + ", " + format_significant(found.authalic),
                    quoted);
    };
    std::vector<std::string> row = {name};
    row.push_back(parameterize(*mesh, uv, SMP::LSCM_parameterizer_3<Mesh>()) ? cell(paper[0])
                                                                             : "fails");
    row.push_back(parameterize(*mesh, uv, SMP::Discrete_authalic_parameterizer_3<Mesh>())
                      ? cell(paper[1])
                      : "fails");
    GP::geodesic_mds(*mesh, uv);
    row.push_back(cell(paper[2]));
    GP::geodesic_lle(*mesh, uv);
    row.push_back(cell(paper[3]));
    GP::geodesic_lle(*mesh, uv,
                     GP::parameters::flattening_start(GP::Flattening_start::lle)
                         .number_of_rigid_steps(std::size_t(0)));
    row.push_back(cell(paper[3]));
    third.add(row);
  };
  // Heads of increasing curvature, as in the paper.
  add_distortion("nefertiti_299", {"0.9, 1.2", "1.4, 0.6", "0.8, 0.9", "1.1, 0.9"});
  add_distortion("bff_face_17k", {"1.5, 3", "3.0, 1.1", "invalid", "1.7, 1.6"});
  add_distortion("camelhead_11k", {"2.5, 10.4", "8.3, 3.5", "invalid", "6.5, 5.5"});
  third.print();
}

void print_distortion(bool is_quick)
{
  std::printf("Distortion: conformal energy Ec, authalic energy Ea, symmetric Dirichlet energy, "
              "L2 and Linf stretch\n\n");
  Table table("distortion", {"patch", "vertices", "curvature / 2 pi", "method", "Ec", "Ea",
                             "Ec + Ea", "Dirichlet", "L2", "Linf", "flips"});
  Table base_point_table("base points", {"patch: Dirichlet energy", "5 base points", "10", "20",
                                         "100", "20, injective", "100, injective"});
  Distortion_counts counts;
  for(const std::string name : patches)
  {
    auto mesh = load_model(name);
    if(!mesh || (is_quick && num_vertices(*mesh) > 4000))
      continue;
    add_patch_rows(table, counts, name, *mesh);
    add_base_point_row(base_point_table, counts, name, *mesh);
  }
  table.print();
  counts.print();
  base_point_table.print();
  std::printf(
      "The energy with 20 base points is at most 1.2 times that with 100 on %zu patches; for "
      "injective maps on %zu\n(target: all).\n\n",
      counts.settled, counts.settled_injective);
}

// Measures times. If is_patient is set, CGAL's as-rigid-as-possible map is also run on large
// patches, which takes many minutes.
void print_times(bool is_quick, bool is_patient)
{
  std::printf("Processor times in seconds, including set-up\n\n");
  Table table("times", {"patch", "vertices", "glle", "glle / n log n [ns]", "mds", "injective",
                        "CGAL lscm", "lscm / glle", "CGAL arap", "arap / glle"});
  std::vector<std::pair<std::string, Mesh>> meshes = {{"square", jittered_square(32)}};
  if(auto mesh = load_model("camelhead_11k"))
    meshes.emplace_back("camelhead_11k", *mesh);
  if(!is_quick)
  {
    meshes.emplace_back("square", jittered_square(317));
    if(auto mesh = load_model("terrain_st_helens_149k"))
    {
      meshes.emplace_back("terrain_st_helens_149k", *mesh);
      meshes.emplace_back("terrain_st_helens_149k, refined once", refined(*mesh));
    }
  }
  for(auto& [name, mesh] : meshes)
  {
    const UV_map uv = new_map(mesh);
    const std::size_t n = num_vertices(mesh);
    const double mds = cpu_seconds([&] { GP::geodesic_mds(mesh, uv); });
    const double glle = cpu_seconds([&] { GP::geodesic_lle(mesh, uv); });
    const double injective =
        n > 200000 ? std::nan("") : cpu_seconds([&] { GP::minimize_distortion(mesh, uv); });
    const double lscm =
        cpu_seconds([&] { parameterize(mesh, uv, SMP::LSCM_parameterizer_3<Mesh>()); });
    const double arap =
        n > 50000 && !is_patient
            ? std::nan("")
            : cpu_seconds([&] { parameterize(mesh, uv, SMP::ARAP_parameterizer_3<Mesh>()); });
    table.add({name, std::to_string(n), format_fixed(glle, 2),
               format_fixed(1e9 * glle / (double(n) * std::log2(double(n))), 0),
               format_fixed(mds, 2), format_fixed(injective, 2), format_fixed(lscm, 2),
               format_fixed(lscm / glle, 1), format_fixed(arap, 2), format_fixed(arap / glle, 1)});
  }
  table.print();
  std::printf(
      "Targets for glle: 0.3, 1.5 and 11 s at 10,000, 100,000 and 600,000 vertices; a tenth of "
      "CGAL's times at 600,000.\n\n");
}

// Returns the number of texels whose center is inside two or more faces.
std::size_t count_overlapping_texels(const Mesh& mesh, const std::vector<UV>& uv, std::size_t size)
{
  std::vector<unsigned char> cover_count(size * size, 0);
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
          result += ++cover_count[y * size + x] == 2;
      }
  }
  return result;
}

void print_atlases(bool is_quick)
{
  std::printf("Texture atlases with 2,048 x 2,048 texels, two threads\n\n");
  Table table("texture atlases",
              {"model", "vertices", "requested charts", "charts", "flips", "overlaps",
               "overlapping texels", "coverage", "wall-clock [s]", "processor [s]"});
  const auto add = [&](const std::string& name, const Mesh& mesh, std::size_t number)
  {
    std::vector<UV> uv(mesh.number_of_halfedges());
    const auto map =
        boost::make_iterator_property_map(uv.begin(), get(boost::halfedge_index, mesh));
    GP::Texture_atlas found;
    double processor = 0.;
    const double watch = wall_seconds(
        [&]
        {
          processor = cpu_seconds(
              [&]
              {
                found = GP::texture_atlas<GP::Euclidean_front, CGAL::Parallel_tag>(
                    mesh, number, map, GP::parameters::texture_size(2048).number_of_threads(2));
              });
        });
    table.add({name, std::to_string(num_vertices(mesh)), std::to_string(number),
               std::to_string(found.number_of_charts), std::to_string(found.number_of_flips),
               std::to_string(found.number_of_overlaps),
               std::to_string(count_overlapping_texels(mesh, uv, 4096)),
               benchmarks::format_fixed(found.coverage, 3), benchmarks::format_fixed(watch, 1),
               benchmarks::format_fixed(processor, 1)});
  };
  if(auto mesh = load_model("bunny_37k"))
  {
    add("bunny_37k", *mesh, 50);
    if(!is_quick)
      add("  refined twice", refined(refined(*mesh)), 100);
  }
  if(auto mesh = load_model("armadillo_26k"))
    add("armadillo_26k", *mesh, 50);
  if(!is_quick)
    if(auto mesh = load_model("mni152_grey_matter_533k"))
      add("mni152_grey_matter_533k", *mesh, 200);
  table.print();
  std::printf("Targets: 30 s for half a million vertices, no flips, no overlaps.\n\n");
}

} // namespace

int main(int argc, char** argv)
{
  const auto has_option = [&](const char* option)
  {
    return std::any_of(argv + 1, argv + argc,
                       [&](const char* a) { return !std::strcmp(a, option); });
  };
  const bool is_quick = has_option("--quick");
  if(!has_option("--paper"))
  {
    print_times(is_quick, has_option("--patient"));
    print_atlases(is_quick);
    print_distortion(is_quick);
  }
  print_starts(is_quick);
  print_first_paper_table();
  print_second_paper_table(is_quick);
  print_third_paper_table(is_quick);
}
