// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time of decal placement and baking on large meshes.
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "report.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;

constexpr std::size_t target_faces = 2000;

// Returns the edge length of a square with the area of `number` faces of mean area.
double square_side(const Mesh& mesh, std::size_t number)
{
  double area = 0.;
  for(const Face f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    area += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                         mesh.point(mesh.target(mesh.next(h)))));
  }
  return std::sqrt(area * double(number) / double(num_faces(mesh)));
}

template <typename Method>
void add_row(Table& table, const std::string& name, const std::string& method, const Mesh& mesh,
             const GP::Mesh_domain<Mesh>& domain)
{
  const double side = square_side(mesh, target_faces);
  std::mt19937 random(1);
  const auto random_vertex = [&] { return Vertex(Mesh::size_type(random() % num_vertices(mesh))); };

  // Times new placers separately, because the first image of a placer also touches its memory for
  // the first time.
  std::vector<double> prepare, first_times, times, per_face, faces;
  for(int i = 0; i < 5; ++i)
  {
    std::optional<GP::Decal_placer<Mesh, Method>> new_placer;
    prepare.push_back(1000. * cpu_seconds([&] { new_placer.emplace(domain); }));
    first_times.push_back(1000. *
                          cpu_seconds([&] { new_placer->place(random_vertex(), side, side); }));
  }
  GP::Decal_placer<Mesh, Method> placer(domain);
  placer.place(random_vertex(), side, side);
  for(int i = 0; i < 41; ++i)
  {
    const Vertex middle = random_vertex();
    GP::Decal<Mesh> decal;
    times.push_back(1000. * cpu_seconds([&] { decal = placer.place(middle, side, side); }));
    faces.push_back(double(decal.faces.size()));
    per_face.push_back(times.back() / faces.back());
  }
  const double bake = cpu_seconds(
      [&, decal = placer.place(random_vertex(), side, side)]
      {
        const GP::Decal_image plain = [](const auto&) { return GP::Decal_color{1., 0., 0., 0.5}; };
        GP::bake_decals<Mesh>({{decal, plain}}, 8);
      });
  table.add({name, std::to_string(num_vertices(mesh)), method, format_fixed(median(faces), 0),
             format_fixed(median(times), 2),
             format_fixed(*std::max_element(times.begin(), times.end()), 2),
             format_fixed(double(target_faces) * median(per_face), 2),
             format_fixed(median(prepare), 2), format_fixed(median(first_times), 2),
             format_fixed(1000. * bake, 1)});
}

void add_rows(Table& table, const std::string& name, const Mesh& mesh)
{
  const auto domain = GP::make_domain(mesh);
  add_row<GP::Gradient<>>(table, name, "gradient", mesh, domain);
  add_row<GP::Exact>(table, name, "exact", mesh, domain);
}

} // namespace

int main(int argc, char** argv)
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  Table table("placement",
              {"mesh", "vertices", "method", "faces", "placement [ms]", "maximum [ms]",
               "per 2,000 faces [ms]", "new placer [ms]", "first placement [ms]", "bake [ms]"});
  add_rows(table, "icosphere 5", icosphere(5));
  if(const auto mesh = load_model("bunny_37k"))
    add_rows(table, "bunny_37k", *mesh);
  if(!quick)
  {
    add_rows(table, "icosphere 7", icosphere(7));
    if(const auto mesh = load_model("mni152_grey_matter_533k"))
      add_rows(table, "mni152_grey_matter_533k", *mesh);
  }
  std::printf("Placement of images that cover about %zu faces, at random vertices of an existing "
              "domain.\nMedian processor times of one thread.\n",
              target_faces);
  table.print();
  std::printf("Targets on mni152: at most 10 ms per placement, 30 ms for the first of a placer.\n");
}
