// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/cloud_paths.h"
#include "io/errors.h"

namespace program {

namespace {

struct Karcher_mean_options
{
  std::string points;                 // "V,V,..."
  std::vector<std::string> points_at; // "x,y,z" each
  std::vector<double> weights;        // empty: 1 each
  std::string initial, initial_at;    // the initial location: "V" or "x,y,z"
  std::optional<double> tolerance;
  std::size_t max_iterations = 100;
};

struct Karcher_mean_result
{
  Point mean;
  std::string location;
  double value = 0., gradient_norm = 0.;
  bool is_converged = false;
  std::size_t number_of_iterations = 0;
  std::vector<std::vector<Point>> paths; // from the points to the mean, if requested
  std::vector<double> objective;         // #vertices, if a picture is requested
  // Of a cloud, if a picture is requested:
  std::vector<std::uint32_t> triangles;
  Surface_file surfels;
};

// Returns the location of a vertex or surfel. Throws Input_error if a vertex has no face.
template <typename Domain>
typename Domain::Location vertex_location(const Domain& domain, std::size_t number, const Job& job)
{
  using Surface_type = typename Domain::Surface;
  // Not public: No public function returns the location of a vertex. The faces of a repaired mesh
  // can be degenerate, so a location in an arbitrary incident face may not exist.
  const auto location = domain.outer(domain.inner_vertex(vertex_at<Surface_type>(number)));
  if constexpr(is_mesh<Surface_type>)
    if(location.first == Mesh::null_face())
      fail(job.input(), "vertex " + std::to_string(number) + " has no face");
  return location;
}

// Computes shortest paths from the points to the mean.
template <typename Domain>
void compute_paths([[maybe_unused]] const Domain& domain, const typename Domain::Location& mean,
                   const std::vector<typename Domain::Location>& points, Job& job,
                   Karcher_mean_result& result)
{
  const auto append = [&](const auto& path)
  {
    // A point of weight zero can be in another component. Its path is empty.
    if(!path.points.empty())
      result.paths.push_back(coordinates_of(path.points));
  };
  if constexpr(is_mesh<typename Domain::Surface>)
  {
    Distance_solver<Mesh> solver(domain, GP::parameters::method(Distance_method::exact));
    solver.compute(mean, GP::parameters::targets(points));
    for(const auto& point : points)
      append(solver.path(point));
  }
  else
  {
    const Cloud cloud = make_cloud(job.surface());
    Path_finder finder = make_path_finder(cloud, Cloud_path_options(), job);
    for(const auto& point : points)
      append(finder(point, mean));
    if(!job.picture().empty())
      result.surfels = denoised_surfels(cloud, finder);
  }
}

// Computes the mean and, if they are requested, the paths and the sums of squared distances.
template <typename Domain>
Karcher_mean_result find_mean(const Domain& domain, const Karcher_mean_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  std::vector<typename Domain::Location> points;
  if(!options.points.empty())
    for(const std::size_t vertex : parse_indices(options.points, "--points"))
      points.push_back(vertex_location(domain, vertex, job));
  for(const std::string& point : options.points_at)
    points.push_back(locate(domain, point, "--point-at"));
  std::vector<double> weights = options.weights;
  if(weights.empty())
    weights.assign(points.size(), 1.);

  job.begin_stage("query");
  // The defaults of the library
  const double tolerance = options.tolerance.value_or(is_mesh<Surface_type> ? 1e-8 : 1e-5);
  const auto np = GP::parameters::weights(weights)
                      .tolerance(tolerance)
                      .maximum_number_of_iterations(options.max_iterations)
                      .number_of_threads(job.threads())
                      .callback(job.progress_callback("mean"));
  std::optional<typename Domain::Location> initial;
  if(!options.initial.empty())
    initial = vertex_location(domain, parse_indices(options.initial, "--initial").front(), job);
  else if(!options.initial_at.empty())
    initial = locate(domain, options.initial_at, "--initial-at");
  const GP::Karcher_mean<Surface_type> mean =
      initial ? GP::karcher_mean(domain, points, np.initial_location(*initial))
              : GP::karcher_mean(domain, points, np);

  Karcher_mean_result result;
  result.mean = coordinates(mean.point);
  result.location = location_text(domain, mean.location);
  result.value = mean.value;
  result.gradient_norm = mean.gradient_norm;
  result.is_converged = mean.is_converged;
  result.number_of_iterations = mean.number_of_iterations;
  if(!job.output().empty() || !job.picture().empty())
    compute_paths(domain, mean.location, points, job, result);
  if(!job.picture().empty())
  {
    result.objective.resize(job.surface().file.points.size());
    using Vertex = typename Domain::Vertex;
    GP::geodesic_barycenter<GP::Euclidean_front>(
        domain, points,
        GP::parameters::weights(weights).objective_map(Value_map<Vertex>{&result.objective}));
    result.triangles = picture_triangles(domain, job);
  }
  return result;
}

// Throws Usage_error if an option is invalid.
void check(const Karcher_mean_options& options)
{
  std::size_t number = options.points_at.size();
  if(!options.points.empty())
    number += parse_indices(options.points, "--points").size();
  if(number == 0)
    throw Usage_error("karcher-mean: --points or --point-at is required.");
  for(const std::string& point : options.points_at)
    parse_point(point, "--point-at");
  if(!options.weights.empty() && options.weights.size() != number)
    throw Usage_error("--weight: the number of weights is " +
                      std::to_string(options.weights.size()) + ", but the number of points is " +
                      std::to_string(number) + ".");
  if(!options.initial.empty() && !options.initial_at.empty())
    throw Usage_error("karcher-mean: --initial cannot be combined with --initial-at.");
  if(!options.initial.empty() && parse_indices(options.initial, "--initial").size() != 1)
    throw Usage_error("--initial: exactly one vertex is required.");
  if(!options.initial_at.empty())
    parse_point(options.initial_at, "--initial-at");
  if(options.tolerance && !(*options.tolerance >= 0.))
    throw Usage_error("--tolerance: the tolerance must not be negative.");
}

void run_karcher_mean(Job& job, const Karcher_mean_options& options)
{
  check(options);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  if(!options.points.empty())
    for(const std::size_t vertex : parse_indices(options.points, "--points"))
      check_vertex(surface, vertex);
  if(!options.initial.empty())
    check_vertex(surface, parse_indices(options.initial, "--initial").front());

  job.begin_stage("prepare");
  Karcher_mean_result result;
  visit_domain(job, [&](const auto& domain) { result = find_mean(domain, options, job); });
  job.result()["mean"] = result.mean;
  job.result()["value"] = json_number(result.value);
  job.result()["gradient_norm"] = json_number(result.gradient_norm);
  job.result()["converged"] = result.is_converged;
  job.result()["iterations"] = result.number_of_iterations;
  job.print_line("mean               " + rounded_text(result.mean[0]) + " " +
                 rounded_text(result.mean[1]) + " " + rounded_text(result.mean[2]));
  job.print_line("squared distances  " + rounded_text(result.value));
  job.print_line("gradient norm      " + rounded_text(result.gradient_norm));
  if(!result.is_converged)
    job.print_warning("the norm of the gradient exceeds --tolerance");

  job.begin_stage("write");
  job.write_values([&] { return result.location + '\n'; });
  if(!job.picture().empty())
  {
    Picture picture{surface.is_mesh() ? &surface.file : &result.surfels};
    picture.values = result.objective;
    picture.title = "squared distances";
    picture.polylines = result.paths;
    for(const std::vector<Point>& path : result.paths)
    {
      picture.markers.push_back(path.front());
      picture.markers.push_back(path.back());
    }
    picture.triangles = result.triangles;
    draw(job.picture(), picture);
  }
  write_polylines(job, result.paths);
  job.finish();
}

} // namespace

void add_karcher_mean(CLI::App& program)
{
  Command command(program, "karcher-mean",
                  "compute the Karcher mean of points: a location with a local minimum of the sum "
                  "of squared distances");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the shortest paths to the mean: .ply .obj .vtp");
  const auto options = std::make_shared<Karcher_mean_options>();
  command.add("--points", options->points, "V[,V...]", "indices of vertices");
  command.add("--point-at", options->points_at, "x,y,z",
              "location closest to a point; can be repeated");
  command.add("--weight", options->weights, "W",
              "weight of a point; repeated in the order of the points, first --points, then "
              "--point-at (default 1)");
  command.add("--initial", options->initial, "V",
              "start the iteration at a vertex, to select one of several minima");
  command.add("--initial-at", options->initial_at, "x,y,z",
              "start the iteration at the location closest to a point");
  command.add("--tolerance", options->tolerance, "T",
              "maximum norm of the gradient, relative to the distance to the farthest point "
              "(default 1e-8 on a mesh, 1e-5 on a cloud)");
  command.add("--iterations", options->max_iterations, "N", "maximum number of iterations")
      .shows_default();
  command.set_callback([job, options] { run_karcher_mean(*job, *options); });
}

} // namespace program
