// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the methods that fill holes, on models with holes and on models from which the faces
// around random vertices are removed.
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "report.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace benchmarks;

struct Result
{
  std::size_t holes = 0, failed = 0, intersections = 0;
  double mean_angle = 0., largest_dihedral_angle = 0., seconds = 0.; // angles in degrees
};

std::size_t number_of_self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Face, Face>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

double smallest_angle(const Mesh& mesh, Face face)
{
  double result = 180.;
  for(const auto h : mesh.halfedges_around_face(mesh.halfedge(face)))
    result = std::min(result, CGAL::approximate_angle(mesh.point(mesh.source(h)),
                                                      mesh.point(mesh.target(h)),
                                                      mesh.point(mesh.target(mesh.next(h)))));
  return result;
}

// Returns the angle between the normals of the faces of an edge, which is zero if it is flat.
double dihedral_angle(const Mesh& mesh, Mesh::Halfedge_index h)
{
  const auto o = mesh.opposite(h);
  if(mesh.is_border(h) || mesh.is_border(o))
    return 0.;
  const double angle = CGAL::approximate_dihedral_angle(
      mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))),
      mesh.point(mesh.target(mesh.next(o))));
  return 180. - std::fabs(angle);
}

Result fill(Mesh mesh, GP::Hole_filling_method method)
{
  Result result;
  const std::size_t before = number_of_self_intersections(mesh);
  std::vector<Face> faces;
  GP::Hole_filling_result filled;
  result.seconds = cpu_seconds(
      [&]
      {
        filled = GP::fill_holes(mesh, GP::parameters::hole_filling_method(method).face_output(
                                          std::back_inserter(faces)));
      });
  result.holes = filled.number_of_filled;
  result.failed = filled.number_of_failed;
  for(const Face face : faces)
  {
    result.mean_angle += smallest_angle(mesh, face) / double(faces.size());
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(face)))
      result.largest_dihedral_angle =
          std::max(result.largest_dihedral_angle, dihedral_angle(mesh, h));
  }
  result.intersections = number_of_self_intersections(mesh) - before;
  return result;
}

// Removes the faces within `radius` edges of a vertex.
void remove_faces(Mesh& mesh, Vertex center, unsigned radius)
{
  std::set<Vertex> ring = {center};
  std::set<Face> faces;
  for(unsigned i = 0; i < radius; ++i)
  {
    for(const Vertex v : ring)
      for(const Face face : mesh.faces_around_target(mesh.halfedge(v)))
        if(face != Mesh::null_face())
          faces.insert(face);
    ring.clear();
    for(const Face face : faces)
      for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
        ring.insert(v);
  }
  for(const Face face : faces)
    CGAL::Euler::remove_face(mesh.halfedge(face), mesh);
  mesh.collect_garbage();
}

constexpr std::pair<const char*, GP::Hole_filling_method> methods[] = {
    {"minimal_dihedral_angles", GP::Hole_filling_method::minimal_dihedral_angles},
    {"unfolding", GP::Hole_filling_method::unfolding}};

void add_row(Table& table, const std::string& name, const char* method, const Result& result)
{
  table.add({name, method, std::to_string(result.holes), std::to_string(result.failed),
             format_fixed(result.mean_angle, 1), format_fixed(result.largest_dihedral_angle, 0),
             std::to_string(result.intersections), format_significant(result.seconds)});
}

// Adds a row for each method: sums and means over holes of the same size in several models.
void add_removed(Table& table, const std::vector<std::string>& names, unsigned radius,
                 std::size_t holes_per_model)
{
  std::mt19937 random(1);
  std::vector<Mesh> meshes;
  for(const std::string& name : names)
    if(const auto model = load_model(name))
      for(std::size_t i = 0; i < holes_per_model; ++i)
      {
        Mesh mesh = *model;
        remove_faces(mesh, Vertex(Mesh::size_type(random() % num_vertices(mesh))), radius);
        meshes.push_back(std::move(mesh));
      }
  for(const auto& [name, method] : methods)
  {
    Result sum;
    for(const Mesh& mesh : meshes)
    {
      const Result result = fill(mesh, method);
      sum.holes += result.holes;
      sum.failed += result.failed;
      sum.intersections += result.intersections;
      sum.mean_angle += result.mean_angle / double(meshes.size());
      sum.largest_dihedral_angle += result.largest_dihedral_angle / double(meshes.size());
      sum.seconds = std::max(sum.seconds, result.seconds);
    }
    add_row(table, "radius of " + std::to_string(radius) + " edges", name, sum);
  }
}

} // namespace

// holes [--quick]
int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  Table table("holes", {"holes", "method", "filled", "failed", "mean smallest angle [degrees]",
                        "largest dihedral angle [degrees]", "new intersecting pairs", "time [s]"});
  for(const std::string& name :
      is_quick ? std::vector<std::string>{"pig_468"}
               : std::vector<std::string>{"bunny_zipper_36k", "plane_holes_8k5",
                                          "mech_holes_shark_5k", "blade_8k", "pig_468"})
    if(const auto mesh = load_model(name))
      for(const auto& [method_name, method] : methods)
        add_row(table, name, method_name, fill(*mesh, method));
  const std::vector<std::string> names =
      is_quick ? std::vector<std::string>{"cow_2k9"}
               : std::vector<std::string>{"bunny_37k", "armadillo_26k", "elephant_2k8",
                                          "fandisk_6k5", "cow_2k9"};
  for(const unsigned radius : {2u, 4u, 7u, 12u})
    add_removed(table, names, radius, is_quick ? 2 : 20);
  std::printf("Filled holes: the mean over the new faces of their smallest angles, and the largest "
              "dihedral angle of new\nfaces (0 if flat). Rows with a radius: faces within so many "
              "edges of a random vertex are removed; angles are\nmeans over the meshes, times the "
              "largest.\n");
  table.print();
}
