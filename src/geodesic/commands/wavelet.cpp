// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/command_utilities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace program {

namespace {

struct Wavelet_options
{
  double kept_percentage = 100.; // percent
  std::optional<double> bits_per_vertex;
  std::size_t levels = std::numeric_limits<std::size_t>::max();
  std::string predictor = "butterfly";
};

void check(const Wavelet_options& options)
{
  if(options.predictor != "butterfly" && options.predictor != "linear")
    throw Usage_error("--predictor " + printable(options.predictor) +
                      ": the predictors are butterfly and linear.");
  if(!(options.kept_percentage >= 0. && options.kept_percentage <= 100.))
    throw Usage_error("--keep: the percentage must be between 0 and 100.");
  if(options.bits_per_vertex && !(*options.bits_per_vertex > 0. && *options.bits_per_vertex <= 1e6))
    throw Usage_error(
        "--bits: the number of bits per vertex must be positive and at most 1,000,000.");
}

double root_mean_square(const std::vector<Point>& a, const std::vector<Point>& b)
{
  double sum = 0.;
  for(std::size_t i = 0; i < a.size(); ++i)
  {
    const double distance = std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]);
    sum += distance * distance;
  }
  return std::sqrt(sum / double(a.size()));
}

using Wavelet = GP::Subdivision_wavelet<Mesh>;

struct Wavelet_result
{
  std::vector<Point> points; // #vertices of the input
  std::vector<std::uint8_t> stream;
};

// Approximates the mesh by its largest wavelet coefficients. If a bit rate is given, the vertices
// are decoded from the truncated stream.
Wavelet_result approximate(Mesh mesh, const Wavelet_options& options, Job& job)
{
  const auto prediction = options.predictor == "linear" ? GP::Wavelet_prediction::linear
                                                        : GP::Wavelet_prediction::butterfly;
  const Wavelet wavelet(
      mesh, GP::parameters::number_of_levels(options.levels).wavelet_prediction(prediction));
  job.begin_stage("query");
  GP::Wavelet_details details = wavelet.analyze(mesh.points(), GP::parameters::do_use_frames(true));
  const std::size_t n = wavelet.number_of_vertices(), coarsest = wavelet.number_of_vertices(0),
                    kept = std::size_t(
                        std::llround(options.kept_percentage / 100. * double(n - coarsest)));
  wavelet.keep_largest(details, kept);

  Wavelet_result result;
  const double bytes =
      options.bits_per_vertex ? std::floor(*options.bits_per_vertex * double(n) / 8.) : 1e18;
  result.stream =
      wavelet.encode(details, GP::parameters::maximum_number_of_bytes(std::size_t(bytes)));
  if(options.bits_per_vertex)
  {
    Mesh decoded;
    GP::Wavelet_stream stream;
    try
    {
      stream = GP::decode_wavelets(result.stream, decoded,
                                   GP::parameters::maximum_number_of_vertices(n));
    }
    catch(const GP::Invalid_argument_error&)
    {
      throw Input_error(job.input() + ": --bits " + rounded_text(*options.bits_per_vertex) +
                        " is too small for the coarse mesh.");
    }
    job.result()["bit_planes"] = stream.number_of_bit_planes;
    for(std::size_t i = 0; i < n; ++i)
      mesh.point(wavelet.vertex(i)) = decoded.point(Mesh::Vertex_index(Mesh::size_type(i)));
  }
  else
    wavelet.synthesize(details, mesh.points());
  for(const auto vertex : mesh.vertices())
    result.points.push_back(coordinates(mesh.point(vertex)));

  const double bits_per_vertex = 8. * double(result.stream.size()) / double(n);
  job.result()["levels"] = wavelet.number_of_levels();
  job.result()["base_vertices"] = coarsest;
  job.result()["kept"] = kept;
  job.result()["bits_per_vertex"] = bits_per_vertex;
  job.print_line("levels          " + std::to_string(wavelet.number_of_levels()) +
                 " above a base of " + std::to_string(coarsest) + " vertices");
  job.print_line("details kept    " + std::to_string(kept) + " of " + std::to_string(n - coarsest));
  job.print_line("bits per vertex " + rounded_text(bits_per_vertex));
  return result;
}

void run_wavelet(Job& job, const Wavelet_options& options)
{
  check(options);
  const Surface& surface = job.read({"ply", "off", "obj", "vtp", "gpw"});
  if(!surface.is_mesh())
    throw Input_error(job.input() + ": wavelet needs a mesh, but the input is a cloud.");
  job.begin_stage("prepare");
  const Wavelet_result result = approximate(surface.domain->mesh(), options, job);
  const double error = root_mean_square(surface.file.points, result.points);
  job.result()["rms"] = json_number(error);
  job.print_line("error           " + rounded_text(error) + " (root mean square)");

  job.begin_stage("write");
  job.write_values(
      [&]
      {
        std::vector<double> distances;
        for(std::size_t i = 0; i < result.points.size(); ++i)
          distances.push_back(root_mean_square({surface.file.points[i]}, {result.points[i]}));
        return number_lines(distances);
      });
  Surface_file file = surface.file;
  file.points = result.points;
  file.normals.clear();
  if(!job.picture().empty())
    draw(job.picture(), Picture{&file});
  if(file_extension(job.output()) == "gpw")
    write_file(job.output(),
               {reinterpret_cast<const char*>(result.stream.data()), result.stream.size()});
  else if(!job.output().empty())
    write_surface_file(job.output(), file);
  job.finish();
}

} // namespace

void add_wavelet(CLI::App& program)
{
  Command command(program, "wavelet",
                  "compress a mesh with subdivision connectivity by wavelets, optionally as a "
                  "progressive stream (.gpw)");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output",
                   "write the mesh: .ply .off .obj .vtp; or a progressive stream: .gpw");
  const auto options = std::make_shared<Wavelet_options>();
  command
      .add("--keep", options->kept_percentage, "P",
           "percentage of detail coefficients to keep, the largest first")
      .shows_default();
  command.add("--bits", options->bits_per_vertex, "B",
              "maximum number of bits per vertex of a progressive stream");
  command.add("--levels", options->levels, "J", "maximum number of decomposition levels");
  command.add("--predictor", options->predictor, "NAME", "butterfly or linear").shows_default();
  command.set_callback([job, options] { run_wavelet(*job, *options); });
}

} // namespace program
