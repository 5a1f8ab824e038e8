// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/transport_utilities.h"
#include "io/errors.h"

namespace program {

namespace {

constexpr const char* complete_basis = "complete";

struct Emd_options : Transport_options
{
  std::string basis = complete_basis;
};

std::size_t basis_size(const Emd_options& options)
{
  const std::optional<long long> result = to_integer(options.basis);
  if(!result || *result < 0)
    throw Usage_error("--basis " + printable(options.basis) +
                      ": the value must be a number of eigenfunctions, or complete.");
  return static_cast<std::size_t>(*result);
}

void check(const Emd_options& options, const Job& job)
{
  if(options.from.empty() || options.to.empty())
    throw Usage_error("emd: --from and --to are required.");
  check(options);
  if(options.basis == complete_basis)
    return;
  basis_size(options);
  if(options.refine || options.bound_above || options.method != "interior-point" ||
     options.speed_options.is_given() || !job.values().empty())
    throw Usage_error(
        "--basis: --method, --refine, --bound-above, --values and speeds require --basis "
        "complete.");
}

// Computes the earth mover's distance and the optimal flow.
template <typename Domain>
Transport_result compute_transport(const Domain& domain, const Masses& from, const Masses& to,
                                   const Emd_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  Transport_result result;
  const auto from_masses = distribution(domain, from), to_masses = distribution(domain, to);
  if(options.basis == complete_basis)
  {
    const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
    GP::Earth_movers_solver<Surface_type> solver(domain, preparation(domain, options, speed));
    job.begin_stage("query");
    result.cost = compute_cost(solver, options.method, from_masses, to_masses,
                               query_parameters(options, job));
    job.result()["estimate"] = json_number(result.cost.estimate);
    copy_solution(domain, solver, job, result);
  }
  else
  {
    const GP::Transport_metric<Surface_type> metric(domain, basis_size(options));
    job.result()["basis"] = metric.basis_size();
    job.begin_stage("query");
    const auto flow = vector_map(result.fields["flow"], domain);
    result.cost =
        metric.cost(from_masses, to_masses, query_parameters(options, job).flow_map(flow));
  }
  add_hodge_decomposition(domain, options, result);
  result.triangles = picture_triangles(domain, job);
  return result;
}

void run_emd(Job& job, const Emd_options& options)
{
  check(options, job);
  const Surface& surface = job.read({"ply", "vtp"});
  const Masses from = read_masses(options.from, "--from", options, surface);
  const Masses to = read_masses(options.to, "--to", options, surface);
  check(options, surface);

  job.begin_stage("prepare");
  Transport_result result;
  visit_domain(job, [&](const auto& domain)
               { result = compute_transport(domain, from, to, options, job); });
  report(job, options, result.cost, "earth mover's distance");

  job.begin_stage("write");
  std::vector<std::size_t> marked_vertices = from.vertices;
  marked_vertices.insert(marked_vertices.end(), to.vertices.begin(), to.vertices.end());
  write_transport(job, result, marked_vertices);
  job.finish();
}

} // namespace

void add_emd(CLI::App& program)
{
  Command command(program, "emd",
                  "compute the earth mover's distance and the optimal flow between two mass "
                  "distributions");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the potential and the flow: .ply .vtp");
  const auto options = std::make_shared<Emd_options>();
  command.add("--from", options->from, "X",
              "mass distribution: indices V[,V...] of vertices with equal masses and total mass "
              "1, a property of the vertices, or a file with one mass per line");
  command.add("--to", options->to, "X", "mass distribution, as for --from");
  command
      .add("--basis", options->basis, "K",
           "complete, or a number of eigenfunctions: restrict the flow to the span of their "
           "rotated gradients, without potential. The number is rounded up to the next gap "
           "between eigenvalues")
      .shows_default();
  add_options(command, *options);
  command.set_callback([job, options] { run_emd(*job, *options); });
}

} // namespace program
