// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Picture.h"
#include "Scanner.h"
#include "commands.h"
#include "densities.h"
#include "read_bytes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <optional>

namespace program {

namespace {

constexpr const char* complete = "complete";

struct Emd_options
{
  std::string from, to;
  bool density = false, normalize = false, bound_above = false, hodge = false;
  std::string method = "interior-point";
  std::string basis = complete;
  double tolerance = 1e-3;
  std::optional<std::size_t> refine;
  Density_options densities;
};

// What one side has: at vertices, or per area.
struct Masses
{
  std::vector<double> values; // #vertices
  bool are_density = false;
  std::vector<std::size_t> vertices; // where it is at these alone
};

struct Result
{
  GP::Earth_movers_cost cost;
  std::vector<double> potential;                    // #vertices
  std::map<std::string, std::vector<Point>> fields; // of a mesh #faces, of a cloud #vertices
  std::vector<std::uint32_t> triangles;             // of a cloud
};

bool are_vertices(const std::string& text)
{
  return !text.empty() && text.find_first_not_of("0123456789,") == std::string::npos;
}

// One number a line.
std::vector<double> masses_of_file(const std::string& name, std::size_t number)
{
  const std::string bytes = read_bytes(name);
  Scanner scanner(bytes, name, '#');
  std::vector<double> result;
  while(scanner.next_line())
  {
    result.push_back(scanner.coordinate(scanner.word()));
    if(!scanner.line_is_empty())
      scanner.fail("there is more than one number");
  }
  if(result.size() != number)
    fail(name, "it has " + std::to_string(result.size()) + " masses for " + std::to_string(number) +
                   " vertices");
  return result;
}

Masses masses(const std::string& text, const std::string& option, const Emd_options& options,
              const Surface& surface)
{
  Masses result;
  const std::size_t n = surface.file.points.size();
  if(are_vertices(text))
  {
    result.vertices = parse_integers(text, option);
    result.values.assign(n, 0.);
    for(const std::size_t vertex : result.vertices)
    {
      check_vertex(surface, vertex);
      result.values[vertex] += 1. / static_cast<double>(result.vertices.size());
    }
    return result;
  }
  result.are_density = options.density;
  const bool is_property = surface.file.properties.count(text) > 0;
  result.values =
      !is_property && std::ifstream(text) ? masses_of_file(text, n) : property(surface, text);
  return result;
}

// A vector for each face or surfel, written like a map of the library.
template <typename Key>
struct Vector_map
{
  using key_type = Key;
  using value_type = Kernel::Vector_3;
  using reference = Kernel::Vector_3;
  using category = boost::read_write_property_map_tag;

  std::vector<Point>* vectors;
  friend void put(const Vector_map& map, const Key& key, const Kernel::Vector_3& v)
  {
    (*map.vectors)[static_cast<std::size_t>(key)] = {v.x(), v.y(), v.z()};
  }
  friend Kernel::Vector_3 get(const Vector_map& map, const Key& key)
  {
    const Point& v = (*map.vectors)[static_cast<std::size_t>(key)];
    return {v[0], v[1], v[2]};
  }
};

std::size_t basis_size(const Emd_options& options)
{
  const std::optional<long long> result = to_integer(options.basis);
  if(!result || *result < 0)
    throw Usage_error("--basis " + shown(options.basis) + ": it is a number, or complete.");
  return std::size_t(*result);
}

// Calls f with what the library takes as masses on both sides.
template <typename Site, typename Function>
auto with_masses(const Masses& from, const Masses& to, Function f)
{
  const auto with = [](const Masses& masses, const auto& f)
  {
    const Property_map<Site> map{&masses.values};
    return masses.are_density ? f(GP::mass_density(map)) : f(map);
  };
  return with(from, [&](const auto& before)
              { return with(to, [&](const auto& after) { return f(before, after); }); });
}

// Among the flows of a basis.
template <typename Domain, typename FlowMap>
GP::Earth_movers_cost least_cost(const Domain& domain, std::size_t basis, const Masses& from,
                                 const Masses& to, const Emd_options& options, FlowMap flow,
                                 Job& job)
{
  const GP::Transport_metric<typename Domain::Surface> metric(domain, basis);
  job.result()["basis"] = metric.basis_size();
  job.stage("query");
  return with_masses<typename Domain::Site>(
      from, to,
      [&](const auto& before, const auto& after)
      {
        return metric.cost(before, after,
                           GP::parameters::tolerance(options.tolerance)
                               .do_normalize(options.normalize)
                               .flow_map(flow)
                               .callback(job.progress("earth mover's distance")));
      });
}

// Among all flows.
template <typename Domain, typename FlowMap>
GP::Earth_movers_cost least_cost(const Domain& domain, const Masses& from, const Masses& to,
                                 const Emd_options& options, FlowMap flow,
                                 std::vector<double>& potential, Job& job)
{
  using Surface_type = typename Domain::Surface;
  using Site = typename Domain::Site;
  const std::vector<double> speed = speeds(domain, options.densities, job);
  std::optional<GP::Earth_movers_solver<Surface_type>> solver;
  const auto prepare = [&](const auto& np) { solver.emplace(domain, np); };
  if(options.refine)
    with_speeds<Site>(speed,
                      GP::parameters::number_of_refinements(
                          static_cast<unsigned>(std::min<std::size_t>(*options.refine, 30))),
                      prepare);
  else
    with_speeds<Site>(speed, GP::parameters::threads(job.threads()), prepare);
  job.stage("query");
  const auto np = GP::parameters::tolerance(options.tolerance)
                      .do_normalize(options.normalize)
                      .do_bound_from_above(options.bound_above)
                      .callback(job.progress("earth mover's distance"));
  const GP::Earth_movers_cost result = with_masses<Site>(
      from, to,
      [&](const auto& before, const auto& after)
      {
        if(options.method == "admm")
          return solver->template compute<GP::Alternating_directions>(before, after, np);
        if(options.method == "weiszfeld")
          return solver->template compute<GP::Weiszfeld>(before, after, np);
        return solver->compute(before, after, np);
      });
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    potential.push_back(solver->potential(site<Surface_type>(i)));
  solver->write_flow(flow);
  return result;
}

// The library's part.
template <typename Surface_type>
Result find_transport(const Surface_type& surface, const Masses& from, const Masses& to,
                      const Emd_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  Result result;
  const auto map = [&]([[maybe_unused]] std::vector<Point>& vectors)
  {
    if constexpr(is_mesh<Surface_type>)
    {
      vectors.resize(surface.number_of_faces());
      return Vector_map<Mesh::Face_index>{&vectors};
    }
    else
    {
      vectors.resize(job.surface().file.points.size());
      return Vector_map<Cloud::Index>{&vectors};
    }
  };
  const auto flow = map(result.fields["flow"]);
  result.cost = options.basis == complete
                    ? least_cost(domain, from, to, options, flow, result.potential, job)
                    : least_cost(domain, basis_size(options), from, to, options, flow, job);
  if constexpr(is_mesh<Surface_type>)
    if(options.hodge)
      GP::hodge_decomposition(domain, flow, map(result.fields["gradient"]),
                              map(result.fields["rotation"]), map(result.fields["harmonic"]));
  result.triangles = picture_triangles(domain, job);
  return result;
}

void check(const Emd_options& options, const Job& job)
{
  if(options.from.empty() || options.to.empty())
    throw Usage_error("emd: give --from and --to.");
  if(!(options.tolerance > 0.))
    throw Usage_error("--tolerance: it is positive.");
  if(options.method != "interior-point" && options.method != "admm" &&
     options.method != "weiszfeld")
    throw Usage_error("--method " + shown(options.method) +
                      ": the methods are interior-point, admm and weiszfeld.");
  check(options.densities);
  if(options.basis == complete)
    return;
  basis_size(options);
  if(options.refine || options.bound_above || options.method != "interior-point" ||
     options.densities.are_given() || !job.values().empty())
    throw Usage_error(
        "--basis: --method, --refine, --bound-above, speeds and --values, the potential, "
        "are for the complete one.");
}

double norm(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

// Lines along the flow, at some of the places, longer where it is stronger.
std::vector<std::vector<Point>> arrows(const Surface_file& file, const std::vector<Point>& flow)
{
  constexpr std::size_t most = 4000;
  Point low = file.points[0], high = low;
  for(const Point& p : file.points)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  const double size = norm({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  std::vector<double> strength;
  for(const Point& v : flow)
    strength.push_back(norm(v));
  std::vector<double> sorted = strength;
  std::sort(sorted.begin(), sorted.end());
  const double strong = sorted[sorted.size() - 1 - sorted.size() / 50]; // one in fifty is stronger
  std::vector<std::vector<Point>> result;
  const std::size_t step = std::max<std::size_t>(1, flow.size() / most);
  for(std::size_t i = 0; i < flow.size(); i += step)
  {
    if(!(strength[i] > 0.02 * strong))
      continue;
    Point p = file.points[std::min(i, file.points.size() - 1)];
    if(!file.corners.empty())
      for(std::size_t c = 0; c < 3; ++c)
        p[c] = (file.points[file.corners[3 * i]][c] + file.points[file.corners[3 * i + 1]][c] +
                file.points[file.corners[3 * i + 2]][c]) /
               3.;
    const double length = 0.02 * size * std::min(1., strength[i] / strong) / strength[i];
    Point q = p;
    for(std::size_t c = 0; c < 3; ++c)
      q[c] += length * flow[i][c];
    result.push_back({p, q});
  }
  return result;
}

void draw_transport(const Job& job, const Masses& from, const Masses& to, const Result& result)
{
  Picture picture{&job.surface().file};
  picture.values = result.potential;
  picture.title = "potential";
  picture.triangles = result.triangles;
  picture.chains = arrows(job.surface().file, result.fields.at("flow"));
  for(const Masses* side : {&from, &to})
    for(const std::size_t vertex : side->vertices)
      picture.markers.push_back(job.surface().file.points[vertex]);
  draw(job.picture(), picture);
}

// The potential of vertices, and the flow: of faces, or of surfels by three numbers each.
void write_transport(const Job& job, const Result& result)
{
  Surface_file file = job.surface().file;
  if(!result.potential.empty())
    file.properties["potential"] = result.potential;
  if(!file.corners.empty())
    file.vectors = result.fields;
  else
    for(const auto& [name, vectors] : result.fields)
      for(std::size_t c = 0; c < 3; ++c)
      {
        std::vector<double>& values = file.properties[name + "_" + "xyz"[c]];
        for(const Point& v : vectors)
          values.push_back(v[c]);
      }
  write_surface_file(job.output(), file);
}

void run_emd(Job& job, const Emd_options& options)
{
  check(options, job);
  const Surface& surface = job.read({"ply", "vtp"});
  const Masses from = masses(options.from, "--from", options, surface);
  const Masses to = masses(options.to, "--to", options, surface);
  if(!surface.is_mesh() && (options.bound_above || options.hodge))
    fail(surface.name, "--bound-above and --hodge need a mesh");

  job.stage("prepare");
  Result result;
  on_surface(surface, [&](const auto& mesh_or_cloud)
             { result = find_transport(mesh_or_cloud, from, to, options, job); });
  const GP::Earth_movers_cost& cost = result.cost;
  job.result()["value"] = json_number(cost.value);
  job.result()["lower"] = json_number(cost.lower);
  job.result()["upper"] = json_number(cost.upper);
  if(options.bound_above)
    job.result()["upper_continuous"] = json_number(cost.upper_continuous);
  if(options.basis == complete)
    job.result()["estimate"] = json_number(cost.estimate);
  job.result()["iterations"] = cost.iterations;
  job.result()["residual"] = json_number(cost.residual);
  job.result()["converged"] = cost.converged;
  job.say("earth mover's distance  " + readable(cost.value));
  job.say("bounds                  " + readable(cost.lower) + " to " + readable(cost.upper));
  if(options.bound_above)
    job.say("on the surface          at most " + readable(cost.upper_continuous));
  if(!cost.converged)
    job.note("the bounds are farther apart than --tolerance");

  job.stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(const double x : result.potential)
          text += number_text(x) + '\n';
        return text;
      });
  if(!job.picture().empty())
    draw_transport(job, from, to, result);
  if(!job.output().empty())
    write_transport(job, result);
  job.finish();
}

} // namespace

void add_emd(CLI::App& program)
{
  Command command(program, "emd", "what it costs to move masses along the surface");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Emd_options>();
  command.add(
      "--from", options->from, "X",
      "vertices V[,V...] by their place in the file, which share a mass of one; a property of "
      "the vertices; or a file with a mass on each line");
  command.add("--to", options->to, "X", "likewise");
  command.add_flag("--density", options->density, "properties and files have mass per area");
  command.add_flag("--normalize", options->normalize, "scale both sides so that each sums to one");
  command
      .add("--method", options->method, "NAME",
           "interior-point; admm, for gaps of a percent; or weiszfeld")
      .shows_default();
  command.add("--tolerance", options->tolerance, "T", "of the gap between the bounds, relative")
      .shows_default();
  command
      .add(
          "--basis", options->basis, "K",
          "seek among turned gradients of so many eigenfunctions alone, rounded up to the next gap "
          "between eigenvalues, which has no potential; or complete")
      .shows_default();
  command.add(
      "--refine", options->refine, "N",
      "divide each triangle in four so often: less is lost where flows are narrow (default 1 "
      "up to 5,000 vertices, 0 above)");
  command.add_flag("--bound-above", options->bound_above,
                   "also a bound from above for flows on the surface itself");
  command.add_flag("--hodge", options->hodge,
                   "also write the flow's gradient, rotation and harmonic part");
  add_density_options(command, options->densities);
  command.set_run([job, options] { run_emd(*job, *options); });
}

} // namespace program
