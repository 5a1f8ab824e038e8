// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "app/commands.h"
#include "io/errors.h"

#include <iterator>

namespace program {

namespace {

struct Loop_options
{
  std::string through, through_at; // the location of a shortest noncontractible loop, as text
  std::string along;               // "V,V,...": shorten a loop through these vertices
  bool use_edges = false;          // do not shorten the basis
};

using Geodesic_loop = GP::Geodesic_loop<Mesh>;

// Computes the loops that the options select. There is none if all loops are contractible.
std::vector<Geodesic_loop> find_loops(const Mesh_domain& domain, const Loop_options& options,
                                      Job& job)
{
  std::vector<Geodesic_loop> result;
  const auto add = [&](Geodesic_loop loop)
  {
    if(!loop.empty())
      result.push_back(std::move(loop));
  };
  if(!options.through.empty())
    add(GP::shortest_noncontractible_loop(
        domain, vertex_at<Mesh>(parse_indices(options.through, "--through").front())));
  else if(!options.through_at.empty())
    add(GP::shortest_noncontractible_loop(domain,
                                          locate(domain, options.through_at, "--through-at")));
  else if(!options.along.empty())
  {
    std::vector<Mesh::Vertex_index> vertices;
    for(const std::size_t vertex : parse_indices(options.along, "--along"))
      vertices.push_back(vertex_at<Mesh>(vertex));
    add(GP::shorten_loop(domain, vertices));
    if(result.empty())
      fail(job.input(), "no loop passes the vertices, which are in different components");
  }
  else
    GP::loop_basis(domain, std::back_inserter(result),
                   GP::parameters::do_shorten(!options.use_edges));
  return result;
}

void check(const Loop_options& options)
{
  const int number_of_tasks =
      !options.through.empty() + !options.through_at.empty() + !options.along.empty();
  if(number_of_tasks > 1)
    throw Usage_error("loops: only one of --through, --through-at and --along is allowed.");
  if(number_of_tasks > 0 && options.use_edges)
    throw Usage_error("--edges: this option is for a basis of loops only.");
  if(!options.through.empty() && parse_indices(options.through, "--through").size() != 1)
    throw Usage_error("--through: exactly one vertex is required.");
  if(!options.through_at.empty())
    parse_point(options.through_at, "--through-at");
  if(!options.along.empty())
    parse_indices(options.along, "--along");
}

void run_loops(Job& job, const Loop_options& options)
{
  check(options);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  if(!surface.is_mesh())
    fail(surface.name, "loops need a mesh, because the triangles of a cloud overlap");
  for(const auto& [vertices, option] :
      {std::pair(&options.through, "--through"), {&options.along, "--along"}})
    if(!vertices->empty())
      for(const std::size_t vertex : parse_indices(*vertices, option))
        check_vertex(surface, vertex);

  job.begin_stage("query");
  const std::vector<Geodesic_loop> loops = find_loops(*surface.domain, options, job);
  std::vector<std::vector<Point>> polylines;
  std::vector<double> lengths;
  double length = 0.;
  for(const Geodesic_loop& loop : loops)
  {
    polylines.push_back(coordinates_of(loop.points));
    lengths.push_back(loop.length);
    length += loop.length;
  }
  job.result()["loops"] = loops.size();
  job.result()["lengths"] = lengths;
  job.result()["length"] = json_number(length);
  job.print_line("loops           " + std::to_string(loops.size()));
  job.print_line("length          " + rounded_text(length));

  job.begin_stage("write");
  job.write_values([&] { return number_lines(lengths); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.polylines = polylines;
    picture.is_transparent = true;
    if(!options.through.empty() || !options.through_at.empty())
      for(const std::vector<Point>& polyline : polylines)
        picture.markers.push_back(polyline.front());
    draw(job.picture(), picture);
  }
  write_polylines(job, std::move(polylines));
  job.finish();
}

} // namespace

void add_loops(CLI::App& program)
{
  Command command(program, "loops",
                  "compute a basis of closed curves that cannot be contracted, or one such curve");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the loops: .ply .obj .vtp");
  command.describe("--values", "write the length of each loop");
  const auto options = std::make_shared<Loop_options>();
  command.add("--through", options->through, "V",
              "a shortest noncontractible loop through the vertex with this index");
  command.add("--through-at", options->through_at, "x,y,z",
              "a shortest noncontractible loop through the location closest to a point");
  command.add("--along", options->along, "V[,V...]",
              "shorten the loop through vertices, in this order");
  command.add_flag("--edges", options->use_edges, "do not shorten the loops of the basis");
  command.set_callback([job, options] { run_loops(*job, *options); });
}

} // namespace program
