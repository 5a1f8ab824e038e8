// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include "core/unfold.h"
#include "remeshing/Refined_surface.h"
#include "remeshing/dual.h"
#include "remeshing/feature_sampling.h"
#include "remeshing/mesh_optimization.h"
#include "remeshing/smoothing.h"
#include "remeshing/topology_repair.h"
#include "sampling/relaxation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Edges longer than this fraction of the sample spacing are split. A cell then has about four
// vertices.
constexpr double max_edge_ratio = 0.65;
// If samples are relaxed, slightly longer edges suffice and save time.
constexpr double max_edge_ratio_relaxed = 0.75;
// After many relaxation steps shorter edges pay off. On six models, they increase the mean of the
// minimum angles by 0.1 degrees and its first percentile by 0.4 degrees. They reduce the distance
// of fitted vertices by up to a tenth. They take a tenth to three quarters more time.
constexpr double max_edge_ratio_well_relaxed = 0.5;

// Refinement stops if at most one halfedge in 50 is too long, by a factor of at most 1.5. Otherwise
// all arrays would be rebuilt for a few edges.
constexpr std::size_t few_edges_divisor = 50;
constexpr double long_edge_factor = 1.5;
// Bounds of the number of vertices after refinement. A mesh of needles would be split into a larger
// mesh of longer needles.
constexpr std::size_t max_vertices_per_input_vertex = 4, max_vertices_per_sample = 32;
// If samples are relaxed, one in two is placed by stratified random sampling, all by one front.
// Farthest point sampling then fills the gaps. With one in twenty, sampling takes three times as
// long and the mean of the minimum angles after twelve steps is 0.2 degrees larger.
constexpr std::size_t stratified_ratio = 2;
// Smoothing steps after the relaxation take as long as six relaxation steps. After twelve
// relaxation steps they increase the mean of the minimum angles by 1.2 degrees. Half as many steps
// give 0.3 degrees less, twice as many 0.5 degrees more.
constexpr int number_of_smoothing_steps = 20;
// Rounds in which samples are added at self-intersections. On models without self-intersections of
// their own at most five were needed (in the folds of a brain).
constexpr int max_intersection_rounds = 10;
// Rounds in which edges are split because all vertices of an invalid cell are samples. Two edges
// with the same end vertices need one or two. Two feature edges need one more round each time that
// their distance is halved.
constexpr int max_refinements = 20;
// These rounds end if there are at least that many vertices, and four times as many as before the
// first round. Otherwise two triangles without area have 10^5 vertices after five rounds: the
// distance between their boundary edges is zero, so that vertices between them do not help.
constexpr std::size_t max_repaired_vertices = 20000, max_repaired_vertices_ratio = 4;

// Rounds in which samples are added to invalid cells. In the first ones, each invalid cell gets one
// sample; 60 scans and CAD models need at most 25. On chains of needles, each round moves the
// violation to the next cell. Therefore the number of samples per cell then doubles regularly.
constexpr std::size_t max_single_repairs = 64, repairs_per_doubling = 16, max_repairs = 400;

class Remesher
{
public:
  Remesher(const std::shared_ptr<const Surface_arrays>& triangles, const Remeshing_options& options)
      : m_options(options), m_surface(triangles, options), m_optimization(m_surface, options)
  {}

  Remeshing run()
  {
    set_spacing();
    m_surface.split_duplicate_faces();
    refine();
    m_max_repaired_vertices =
        std::max(max_repaired_vertices, max_repaired_vertices_ratio * t().number_of_vertices());
    start_sampling();
    m_result.is_finished = place_samples() && relax() && enforce_topology();
    return std::move(m_result);
  }

private:
  const Surface_arrays& t() const { return m_surface.triangles(); }
  double slowness(Index triangle) const { return m_surface.slowness(triangle); }
  bool report_progress(double done) const
  {
    return !m_options.callback || m_options.callback(done);
  }
  std::vector<double> spacing_on_features() const
  {
    return feature_spacing(m_surface, m_spacing, m_options.feature_spacing);
  }

  // Returns twice the area of a triangle in the metric that measures travel times.
  double twice_weighted_area(Index f) const
  {
    const double* const l = &t().length[3 * std::size_t(f)];
    return slowness(f) * slowness(f) * twice_area(l[0], l[1], l[2]);
  }

  // Sets the distance between adjacent samples to that of a honeycomb with the same number of cells
  // and the same area. Cells at the boundary are half cells.
  void set_spacing()
  {
    double area = 0., boundary_length = 0.;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
    {
      const double* const l = &t().length[3 * std::size_t(f)];
      area += 0.5 * slowness(f) * slowness(f) * twice_area(l[0], l[1], l[2]);
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(t().twin[h] == none)
          boundary_length += slowness(f) * t().length[h];
    }
    const double n = double(std::max<std::size_t>(m_options.number_of_samples, 1));
    const double quarter = boundary_length / 4.;
    m_spacing =
        std::max((quarter + std::sqrt(quarter * quarter + 2. / std::sqrt(3.) * area * n)) / n,
                 boundary_length / n);
    m_spacing *= m_surface.unit_size();
  }

  double target_edge_ratio() const
  {
    if(m_options.number_of_relaxation_steps == 0)
      return max_edge_ratio;
    return m_options.number_of_relaxation_steps < many_relaxation_steps
               ? max_edge_ratio_relaxed
               : max_edge_ratio_well_relaxed;
  }

  void refine()
  {
    const std::size_t max_vertices =
        max_vertices_per_input_vertex * t().number_of_vertices() +
        max_vertices_per_sample *
            (m_options.number_of_samples +
             number_requested_on_features(m_surface, m_options.feature_spacing));
    for(;;)
    {
      const auto [is_long, is_fine_enough] = find_long_edges();
      if(is_fine_enough || t().number_of_vertices() >= max_vertices)
        return;
      m_surface.split(is_long);
    }
  }

  struct Long_edges
  {
    std::vector<bool> is_long; // 3 #triangles
    bool is_fine_enough = true;
  };

  Long_edges find_long_edges() const
  {
    const double ratio = target_edge_ratio();
    const double max_length = ratio * m_spacing / m_surface.unit_size();
    const std::vector<double> spacing =
        m_options.feature_spacing.empty() ? std::vector<double>() : spacing_on_features();
    Long_edges result;
    result.is_long.assign(t().corner.size(), false);
    std::size_t number_of_long = 0;
    for(Index h = 0; h < result.is_long.size(); ++h)
    {
      const double length = slowness(h / 3) * t().length[h];
      const bool is_long_feature =
          !spacing.empty() && m_surface.is_feature()[h] && t().length[h] > ratio * spacing[h];
      if(!(length > max_length) && !is_long_feature)
        continue;
      ++number_of_long;
      result.is_fine_enough =
          result.is_fine_enough && !is_long_feature && length <= long_edge_factor * max_length;
      mark_edge(t(), h, result.is_long);
    }
    result.is_fine_enough =
        result.is_fine_enough && number_of_long * few_edges_divisor <= result.is_long.size();
    return result;
  }

  void start_sampling()
  {
    m_front.emplace(m_surface.shared_triangles(), Front_kind::euclidean);
    m_sampling.emplace(m_surface.shared_triangles(), *m_front, Sample_location::triangle,
                       m_surface.slowness());
  }

  bool place_samples()
  {
    std::vector<Surface_location> initial_samples =
        to_fine(m_surface.refinement(), m_options.first_samples);
    const std::vector<Surface_location> on_features =
        sample_feature_polylines(t(), spacing_on_features());
    initial_samples.insert(initial_samples.end(), on_features.begin(), on_features.end());
    m_number_of_fixed = initial_samples.size();
    if(!initial_samples.empty())
      m_sampling->add(initial_samples);
    if(m_options.number_of_relaxation_steps > 0 &&
       initial_samples.size() < m_options.number_of_samples)
      m_sampling->add(stratified_samples((m_options.number_of_samples - initial_samples.size()) /
                                         stratified_ratio));
    const std::size_t number = m_sampling->samples().size();
    return add_farthest(m_options.number_of_samples - std::min(m_options.number_of_samples, number),
                        0., 0.4);
  }

  // Returns the centroids of the triangles in which the accumulated area passes a multiple of the
  // stratum. Triangles are in Morton order, so that consecutive triangles are close to each other.
  // Triangles whose first vertex is within the spacing of an existing sample are skipped.
  std::vector<Surface_location> stratified_samples(std::size_t number) const
  {
    double total = 0.;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      total += twice_weighted_area(f);
    const double stratum = total / double(number);
    std::vector<Surface_location> result;
    double sum = stratum * double(std::mt19937(m_options.seed)()) / 0x1p32;
    for(Index f = 0; f < t().number_of_triangles() && number > 0; ++f)
    {
      sum += twice_weighted_area(f);
      if(!(sum >= stratum))
        continue;
      sum = std::fmod(sum, stratum);
      if(m_sampling->distances()[t().corner[3 * f]] > m_spacing / m_surface.unit_size())
        result.push_back({f, none, {1. / 3., 1. / 3., 1. / 3.}});
    }
    return result;
  }

  // Adds `number` farthest samples, and further ones until each connected component has a sample.
  // Progress is reported from `begin` to `end`. Returns false if the callback cancelled.
  bool add_farthest(std::size_t number, double begin, double end)
  {
    Sampling_options options;
    options.seed = m_options.seed;
    options.number_of_samples = number;
    if(m_options.callback)
      options.callback = [&](double done)
      { return m_options.callback(begin + (end - begin) * done); };
    const auto ignore = [](double) {};
    if(number > 0 && !sample_farthest_points(*m_sampling, options, ignore))
      return false;
    options.number_of_samples = 1;
    while(m_sampling->covering_radius() == infinity)
      if(!sample_farthest_points(*m_sampling, options, ignore))
        return false;
    return true;
  }

  // Moves samples that are not fixed to the centroids of their cells, first on the surface
  // (`Relaxation`), then in the triangulation of the samples (`Smoothing`).
  bool relax()
  {
    const std::size_t steps = m_options.number_of_relaxation_steps;
    if(steps == 0)
      return true;
    const std::vector<Surface_location>& samples = m_sampling->samples();
    std::vector<bool> is_fixed;
    for(std::size_t i = 0; i < samples.size(); ++i)
      is_fixed.push_back(i < m_number_of_fixed || m_surface.is_on_feature(samples[i]));
    Relaxation relaxation(m_surface.shared_triangles(), m_surface.slowness(), samples,
                          m_sampling->labels(), is_fixed);
    for(std::size_t step = 0; step < steps; ++step)
    {
      if(!report_progress(0.4 + 0.4 * double(step) / double(steps)))
        return false;
      relaxation.step(step + 1 == steps);
    }
    Smoothing smoothing(t(), m_surface.slowness().get(), relaxation.samples(),
                        compute_dual_triangles(t(), relaxation.labels()), is_fixed,
                        m_surface.is_feature());
    for(int step = 0; step < number_of_smoothing_steps; ++step)
    {
      if(!report_progress(0.8))
        return false;
      smoothing.step();
    }
    start_sampling();
    m_sampling->add(smoothing.samples());
    return true;
  }

  // Adds samples until the dual of the cells is valid and meets the geometric goals.
  bool enforce_topology()
  {
    for(;;)
    {
      if(!report_progress(0.9))
        return false;
      const Cells cells = connected_cells(t(), *m_sampling);
      // Samples whose cell contains no vertex are lost and must be replaced.
      if(cells.samples.size() < m_options.number_of_samples && m_sampling->covering_radius() > 0.)
      {
        if(!add_farthest(m_options.number_of_samples - cells.samples.size(), 0.8, 0.9))
          return false;
        continue;
      }
      Topology_check check = check_topology(m_surface, *m_sampling, cells);
      const bool is_final = check.is_valid() ? optimize(cells, std::move(check.dual.triangles))
                                             : !repair(cells, check);
      if(is_final)
        return true;
    }
  }

  // Adds samples, or splits edges if there are no candidates. Returns false if a limit is reached
  // and the result is therefore final.
  bool repair(const Cells& cells, const Topology_check& check)
  {
    if(++m_number_of_repairs > max_repairs)
      return stop_repairs();
    const std::size_t number_of_additional =
        m_number_of_repairs <= max_single_repairs
            ? 0
            : std::size_t(1) << (m_number_of_repairs - max_single_repairs) / repairs_per_doubling;
    const Topology_repair found =
        repair_topology(m_surface, *m_sampling, cells, check, number_of_additional);
    if(!found.samples.empty())
      m_sampling->add(found.samples);
    else if(++m_number_of_refinements > max_refinements ||
            t().number_of_vertices() >= m_max_repaired_vertices)
      return stop_repairs();
    else
      refine_unresolved(cells, found.unresolved);
    return true;
  }

  // Stores the valid mesh before samples were added at self-intersections as the result. Throws if
  // there is none. Returns false.
  bool stop_repairs()
  {
    if(!m_fallback)
      throw Unsupported_surface_error("The samples cannot be triangulated with the topology of "
                                      "the mesh, even after refinement.");
    m_result = std::move(*m_fallback);
    return false;
  }

  // Builds the mesh of valid cells. Returns true if it is the result; otherwise adds samples.
  bool optimize(const Cells& cells, std::vector<std::array<Index, 3>> dual_triangles)
  {
    Coarse_mesh mesh = m_optimization.build_mesh(cells, *m_sampling, dual_triangles);
    std::vector<Surface_location> more = m_optimization.far_locations(cells, *m_sampling, mesh);
    if(more.empty())
    {
      Remeshing candidate = build_result(cells, std::move(mesh), std::move(dual_triangles));
      if(m_options.does_avoid_self_intersections)
        more = m_optimization.locations_at_intersections(cells, *m_sampling, candidate);
      if(accept_result(std::move(candidate), more.empty()))
        return true;
    }
    m_sampling->add(more);
    return false;
  }

  // Splits the edges of all triangles at the given cells. Needed if all vertices of these cells are
  // samples, and their dual is still no surface, because two edges have the same end vertices or
  // two feature edges are close to each other.
  void refine_unresolved(const Cells& cells, const std::vector<Index>& unresolved)
  {
    std::vector<bool> is_unresolved(cells.samples.size(), false),
        is_split(t().corner.size(), false);
    for(const Index cell : unresolved)
      is_unresolved[cell] = true;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      for(Index k = 0; k < 3; ++k)
        if(is_unresolved[cells.labels[t().corner[3 * f + k]]])
          for(Index h = 3 * f; h < 3 * f + 3; ++h)
            mark_edge(t(), h, is_split);
    std::vector<Surface_location> samples;
    for(const Surface_location& sample : m_sampling->samples())
      samples.push_back(to_coarse(m_surface.refinement(), sample));
    m_surface.split(is_split);
    start_sampling();
    m_sampling->add(to_fine(m_surface.refinement(), samples));
  }

  // Stores the result if it is final, and returns true if so. `is_last`: no samples are to be
  // added. If samples were added at self-intersections without reducing their number, the candidate
  // before these samples is the result.
  bool accept_result(Remeshing candidate, bool is_last)
  {
    const bool is_given_up = !is_last && ++m_intersection_rounds > max_intersection_rounds;
    if(is_given_up ||
       (is_last && m_fallback &&
        m_fallback->number_of_self_intersections <= candidate.number_of_self_intersections))
      m_result = std::move(*m_fallback);
    else if(is_last)
      m_result = std::move(candidate);
    else if(!m_fallback)
      m_fallback = std::move(candidate);
    return is_last || is_given_up;
  }

  // Returns the mesh with its samples on the input triangles and its points in the coordinates of
  // the caller.
  Remeshing build_result(const Cells& cells, Coarse_mesh mesh,
                         std::vector<std::array<Index, 3>> dual_triangles) const
  {
    const Surface_arrays& coarse = m_surface.coarse();
    Remeshing result;
    for(std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      result.samples.push_back(canonical(
          coarse, to_coarse(m_surface.refinement(), m_sampling->samples()[cells.samples[i]])));
      result.points.push_back(m_options.does_fit_to_input
                                  ? t().origin + t().scale * mesh.points[i]
                                  : coordinates(coarse, result.samples.back()));
    }
    result.triangles = std::move(mesh.triangles);
    result.surface = m_surface.refinement();
    result.cells = cells.labels;
    result.dual_triangles = std::move(dual_triangles);
    return result;
  }

  const Remeshing_options& m_options;
  Refined_surface m_surface;
  Mesh_optimization m_optimization;
  double m_spacing = 0.; // of samples, in the scale of the coarse mesh

  std::optional<Front> m_front;
  std::optional<Sampling> m_sampling;
  std::size_t m_number_of_fixed = 0; // number of first samples that must not move
  Remeshing m_result;

  std::size_t m_max_repaired_vertices = 0;
  int m_number_of_refinements = 0, m_intersection_rounds = 0;
  std::size_t m_number_of_repairs = 0;
  std::optional<Remeshing> m_fallback; // before samples were added at self-intersections
};

} // namespace

Remeshing remesh(const std::shared_ptr<const Surface_arrays>& triangles,
                 const Remeshing_options& options)
{
  if(options.number_of_samples > max_number_of_vertices)
    throw Invalid_argument_error(
        "The number of samples is too large: the result would have more than 2^31 halfedges.");
  return Remesher(triangles, options).run();
}

} // namespace CGAL::Geodesic_processing::internal
