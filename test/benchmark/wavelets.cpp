// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the error of a mesh that is reconstructed from few wavelet coefficients, or from few
// bits per vertex.
//
// The meshes are semi-regular remeshings of models with 250 relaxed base vertices, and "smooth"
// meshes. For the latter, a coarse mesh of 250 vertices is refined by splitting each face into
// four. At each level it is projected to the model and smoothed along it. Errors are root mean
// squares over vertices, in ten thousandths of the diagonal.
#include <CGAL/Geodesic_processing.h>

#include "Error_plot.h"
#include "models.h"
#include "report.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Wavelet = GP::Subdivision_wavelet<Mesh>;
using Bytes = std::vector<std::uint8_t>;

constexpr std::array<GP::Wavelet_prediction, 2> predictions = {GP::Wavelet_prediction::linear,
                                                               GP::Wavelet_prediction::butterfly};
const char* name_of(GP::Wavelet_prediction p)
{
  return p == GP::Wavelet_prediction::linear ? "linear" : "butterfly";
}

double diagonal(const Mesh& mesh)
{
  const auto box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

Mesh build_semi_regular_mesh(const Mesh& input, unsigned levels)
{
  Mesh result;
  GP::semi_regular_remeshing(input, 250, levels, result,
                             GP::parameters::number_of_relaxation_steps(std::size_t(10)));
  return result;
}

// Returns a subdivision that approximates a parameterization without kinks between base faces.
Mesh projected_subdivision(const Mesh& input, unsigned levels)
{
  Tree tree(faces(input).first, faces(input).second, input);
  tree.accelerate_distance_queries();
  Mesh result;
  GP::geodesic_delaunay_remeshing(input, 250, result,
                                  GP::parameters::number_of_relaxation_steps(std::size_t(10)));
  for(unsigned level = 0; level < levels; ++level)
  {
    result = refined(result);
    for(int step = 0; step < 10; ++step)
    {
      std::vector<Kernel::Point_3> positions;
      for(const Vertex v : result.vertices())
      {
        Kernel::Vector_3 sum(0., 0., 0.);
        std::size_t count = 0;
        if(!result.is_border(v))
          for(const auto h : CGAL::halfedges_around_target(v, result))
          {
            sum = sum + (result.point(result.source(h)) - result.point(v));
            ++count;
          }
        positions.push_back(
            tree.closest_point(result.point(v) + (count > 0 ? 0.5 / double(count) : 0.) * sum));
      }
      for(const Vertex v : result.vertices())
        result.point(v) = positions[v];
    }
  }
  return result;
}

struct Errors
{
  double vertices = 0., surface = 0.; // to the same vertex, and to the nearest point
};

Errors errors(const Mesh& mesh, const Tree& tree, const std::vector<Kernel::Point_3>& points)
{
  Errors result;
  for(const Vertex v : mesh.vertices())
  {
    result.vertices += squared_distance(mesh.point(v), points[v]);
    result.surface += tree.squared_distance(points[v]);
  }
  const double unit = 1e-4 * diagonal(mesh), n = double(num_vertices(mesh));
  return {std::sqrt(result.vertices / n) / unit, std::sqrt(result.surface / n) / unit};
}

// Decodes `bytes` and returns the positions of the vertices in the order of the input mesh.
std::vector<Kernel::Point_3> decode(const Wavelet& wavelet, const Bytes& bytes)
{
  Mesh mesh;
  GP::decode_wavelets(bytes, mesh);
  std::vector<Kernel::Point_3> result(num_vertices(mesh));
  for(std::size_t i = 0; i < result.size(); ++i)
    result[wavelet.vertex(i)] = mesh.point(Vertex(Mesh::size_type(i)));
  return result;
}

std::vector<Kernel::Point_3> with_details(const Wavelet& wavelet, const Mesh& mesh, double percent)
{
  Mesh copy = mesh;
  auto details = wavelet.analyze(mesh.points(), GP::parameters::do_use_frames(true));
  wavelet.keep_largest(details, std::size_t(percent / 100. * double(num_vertices(mesh))) -
                                    wavelet.number_of_vertices(0));
  wavelet.synthesize(details, copy.points());
  return {copy.points().begin(), copy.points().end()};
}

// Keeps the first `percent` of the vertices in the order of levels. Each other vertex is the
// midpoint of its parents.
std::vector<Kernel::Point_3> samples(const Wavelet& wavelet, const Mesh& mesh, double percent)
{
  std::vector<Kernel::Point_3> result(mesh.points().begin(), mesh.points().end());
  for(std::size_t i = std::size_t(percent / 100. * double(result.size())); i < result.size(); ++i)
  {
    const auto [a, b] = wavelet.parents(i);
    result[wavelet.vertex(i)] = midpoint(result[wavelet.vertex(a)], result[wavelet.vertex(b)]);
  }
  return result;
}

void report(const std::string& name, const Mesh& mesh, std::vector<Panel>& panels)
{
  Tree tree(faces(mesh).first, faces(mesh).second, mesh);
  tree.accelerate_distance_queries();
  const double n = double(num_vertices(mesh));
  Table table(name,
              {"prediction", "kept", "bits per vertex", "error", "error to surface", "time [s]"});
  for(const double percent : {5., 10., 20.})
  {
    const Wavelet wavelet(mesh);
    const Errors found = errors(mesh, tree, samples(wavelet, mesh, percent));
    table.add({"samples", format_fixed(percent, 0) + " %", "", format_fixed(found.vertices, 3),
               format_fixed(found.surface, 3), ""});
    for(const auto p : predictions)
    {
      const Wavelet predicted_wavelet(mesh, GP::parameters::wavelet_prediction(p));
      const Errors kept = errors(mesh, tree, with_details(predicted_wavelet, mesh, percent));
      table.add({name_of(p), format_fixed(percent, 0) + " %", "", format_fixed(kept.vertices, 3),
                 format_fixed(kept.surface, 3), ""});
    }
  }
  Panel panel = {name, "bits per vertex", {}};
  for(const auto p : predictions)
  {
    const Wavelet wavelet(mesh, GP::parameters::wavelet_prediction(p));
    Bytes bytes;
    const double time = cpu_seconds(
        [&] {
          bytes =
              wavelet.encode(wavelet.analyze(mesh.points(), GP::parameters::do_use_frames(true)));
        });
    const std::size_t style = 1 + panel.series.size();
    const std::string name = name_of(p);
    Series vertices = {name + ", vertices", style, std::nan(""), {}},
           surface = {name + ", surface", style + 1, std::nan(""), {}};
    for(const double bits : {0.75, 1., 2., 3., 4., 6., 8., 12.})
    {
      const std::size_t size = std::min(bytes.size(), std::size_t(bits * n / 8.));
      const Errors found = errors(
          mesh, tree, decode(wavelet, Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(size))));
      table.add({name_of(p), "", format_fixed(8. * double(size) / n, 2),
                 format_fixed(found.vertices, 3), format_fixed(found.surface, 3),
                 format_fixed(time, 2)});
      vertices.points.push_back({bits, found.vertices * 1e-4});
      surface.points.push_back({bits, found.surface * 1e-4});
    }
    panel.series.push_back(vertices);
    panel.series.push_back(surface);
  }
  table.print();
  panels.push_back(panel);
}

} // namespace

int main(int argc, char** argv)
{
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::vector<Panel> panels;
  for(const char* const name : {"bunny_37k", "nefertiti_35k"})
    if(const auto mesh = load_model(name))
    {
      report(name, build_semi_regular_mesh(*mesh, is_quick ? 2 : 4), panels);
      report(name + std::string(", smooth"), projected_subdivision(*mesh, is_quick ? 2 : 4),
             panels);
    }
  if(panels.empty())
    report("sphere", icosphere(is_quick ? 4 : 6), panels);
  if(argc > 1 && !is_quick)
    write_error_plot(argv[1], panels);
}
