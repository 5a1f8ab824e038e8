// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>
#include "mesh/self_intersections.h"
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>
#include "remeshing/dual.h"
#include "remeshing/fitting.h"
#include "mesh/flips.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>
#include "sampling/relaxation.h"
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include "remeshing/smoothing.h"
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sides longer than this part of the spacing of samples are halved: then a cell has some four sites.
constexpr double max_edge_ratio = 0.65;
// Where samples move, a little longer ones, which saves time.
constexpr double max_edge_ratio_relaxed = 0.75;
// But not with so many steps: a tenth to three quarters more time for 0.1 degrees of the mean of the least angles, 0.4 of
// their first percentile, and a distance of fitted vertices that is up to a tenth smaller, on six models.
constexpr std::size_t many_steps = 30;
constexpr double max_edge_ratio_well_relaxed = 0.5;

// Of a fit after many steps: nearer by 2 to 5 percent.
constexpr int angle_preserving_steps = 3;
// One in so many may be longer, by this factor at most: else all triangles would be glued anew for the sake of
// the last few sides.
constexpr std::size_t few_edges_divisor = 50;
constexpr double long_edge_factor = 1.5;
// But not beyond so many sites for each there was and for each sample: webs of needles would become
// webs of longer ones.
constexpr std::size_t max_vertices_per_input_vertex = 4, max_vertices_per_sample = 32;
// Each has six half-edges.
constexpr std::size_t max_number_of_vertices = (std::size_t(1) << 31) / 6;
// Of so many samples one is strewn where they are moved anyway: these take one front together, and what is
// farthest from all of them then fills the gaps.  With one of twenty the samples take three times as long,
// for 0.2 degrees of the mean of the least angles after twelve steps.
constexpr std::size_t stratified_ratio = 2;
// After samples have moved on the surface, between each other: as long as six steps there take, for 1.2 degrees of the
// mean of the least angles after twelve of these.  Half as many give 0.3 degrees less, twice as many 0.5 more.
constexpr int number_of_smoothing_steps = 20;
// Farther than any curve is long, in the domain's scale: it has less than 2^31 sides.
constexpr double max_feature_length = 0x1p32;
// How often samples are added where triangles cross: on the models whose surfaces do not cross themselves
// five times are the most that were seen, in the folds of a brain.
constexpr int max_intersection_rounds = 10;
// How often sides are halved where all sites are samples: once or twice is enough for two triangles of
// the same corners.
constexpr int max_refinements = 20;

// The cells of samples, numbered: those that come to a site.
struct Cells
{
  std::vector<Index> labels;  // #sites: the cell of each, none where there is no triangle
  std::vector<Index> samples; // #cells: the sample of each
};

// The cells that a sampling knows, each in one part: where fronts were wrong by a rounding, or came
// around others, sites go over to a cell next to them.
Cells connected_cells(const Surface_arrays& t, const Sampling& sampling)
{
  const std::vector<double>& distances = sampling.distances();
  std::vector<Index> nearest(sampling.samples().size(), none); // the site of each sample
  for(const Index vertex : sampling.sampled_vertices())
    if(Index& known = nearest[sampling.labels()[vertex]];
       known == none || distances[vertex] < distances[known])
      known = vertex;

  Cells result;
  result.labels.assign(t.number_of_vertices(), none);
  std::vector<Index> reached;
  for(Index sample = 0; sample < nearest.size(); ++sample)
  {
    if(nearest[sample] == none)
      continue;
    const Index cell = Index(result.samples.size());
    result.samples.push_back(sample);
    reached = {nearest[sample]};
    result.labels[nearest[sample]] = cell;
    while(!reached.empty())
    {
      const Index vertex = reached.back();
      reached.pop_back();
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
        for(const Index corner : {next_halfedge(t.ring[i]), previous_halfedge(t.ring[i])})
          if(const Index next = t.corner[corner];
             result.labels[next] == none && sampling.labels()[next] == sample)
          {
            result.labels[next] = cell;
            reached.push_back(next);
          }
    }
  }

  std::vector<Index> disconnected;
  for(const Index vertex : sampling.sampled_vertices())
    if(result.labels[vertex] == none)
      disconnected.push_back(vertex);
  while(!disconnected.empty())
  {
    std::vector<std::pair<Index, Index>> found; // site and cell
    std::vector<Index> remaining;
    for(const Index vertex : disconnected)
    {
      Index best = none;
      double min_distance = infinity;
      const auto visit = [&](Index next, double length)
      {
        if(result.labels[next] != none && distances[next] + length < min_distance)
        {
          best = result.labels[next];
          min_distance = distances[next] + length;
        }
      };
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      {
        const Index corner = t.ring[i], previous = previous_halfedge(corner);
        visit(t.corner[next_halfedge(corner)], t.length[corner]);
        visit(t.corner[previous], t.length[previous]);
      }
      if(best == none)
        remaining.push_back(vertex);
      else
        found.emplace_back(vertex, best);
    }
    for(const auto& [vertex, cell] : found)
      result.labels[vertex] = cell;
    disconnected = std::move(remaining);
  }
  return result;
}

class Remesher
{
public:
  Remesher(const std::shared_ptr<const Surface_arrays>& triangles, const Remeshing_options& options)
      : m_options(options),
        m_coarse_features(options.is_feature.empty() ? boundary_and_sharp_halfedges(*triangles)
                                                     : options.is_feature),
        m_has_features(std::find(m_coarse_features.begin(), m_coarse_features.end(), true) !=
                       m_coarse_features.end())
  {
    set_surface(make_refinement(triangles));
  }

  Remeshing run()
  {
    set_spacing();
    split_duplicate_faces();
    refine();
    start_sampling();
    m_result.is_finished = place_samples() && relax() && enforce_topology();
    return std::move(m_result);
  }

private:
  const Surface_arrays& t() const { return *m_surface.triangles; }
  double slowness(Index triangle) const { return m_slowness ? (*m_slowness)[triangle] : 1.; }
  // The size of our unit in that of the coarse triangles: a power of two.
  double unit_size() const { return t().scale / m_surface.coarse->scale; }
  bool report_progress(double done) const
  {
    return !m_options.callback || m_options.callback(done);
  }

  void set_surface(Refinement surface)
  {
    m_surface = std::move(surface);
    // Where all sites are one point no site is farther than others: any lengths will do.
    if(std::all_of(t().length.begin(), t().length.end(), [](double l) { return l == 0.; }))
    {
      Surface_arrays uniform = t();
      std::fill(uniform.length.begin(), uniform.length.end(), 1.);
      m_surface.triangles = std::make_shared<const Surface_arrays>(std::move(uniform));
    }
    m_is_feature.assign(t().corner.size(), false);
    m_is_feature_vertex.assign(t().number_of_vertices(), false);
    if(m_has_features)
      mark_features();
    m_slowness = m_options.slowness;
    if(m_slowness && !m_surface.parent.empty())
    {
      std::vector<double> slownesses;
      for(const Index parent : m_surface.parent)
        slownesses.push_back((*m_options.slowness)[parent]);
      m_slowness = std::make_shared<const std::vector<double>>(std::move(slownesses));
    }
  }

  void mark_features()
  {
    const std::vector<Index> coarse = coarse_halfedges(m_surface);
    for(Index h = 0; h < coarse.size(); ++h)
      if(coarse[h] != none && m_coarse_features[coarse[h]])
      {
        m_is_feature[h] = true;
        for(const Index corner : {h, next_halfedge(h)})
          m_is_feature_vertex[t().corner[corner]] = true;
      }
  }

  // Of a honeycomb of so many cells, those at the border halved by it, that covers as much.
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
    m_spacing *= unit_size();
  }

  // Halves the sides of two triangles of the same corners, which no samples at these can tell apart.
  void split_duplicate_faces()
  {
    std::vector<bool> is_halved(t().corner.size(), false);
    bool has_duplicates = false;
    for(Index h = 0; h < is_halved.size(); ++h)
    {
      const Index other = t().twin[h], next = t().twin[next_halfedge(h)];
      if(other == none || next == none || other / 3 != next / 3 || other / 3 == h / 3)
        continue;
      has_duplicates = true;
      for(Index k = 0; k < 3; ++k)
        for(const Index marked : {3 * (h / 3) + k, 3 * (other / 3) + k})
        {
          is_halved[marked] = true;
          if(t().twin[marked] != none)
            is_halved[t().twin[marked]] = true;
        }
    }
    if(has_duplicates)
      set_surface(split_edges(m_surface, is_halved));
  }

  double target_edge_ratio() const
  {
    if(m_options.number_of_relaxation_steps == 0)
      return max_edge_ratio;
    return m_options.number_of_relaxation_steps < many_steps ? max_edge_ratio_relaxed
                                                             : max_edge_ratio_well_relaxed;
  }

  void refine()
  {
    const std::size_t max_vertices =
        max_vertices_per_input_vertex * t().number_of_vertices() +
        max_vertices_per_sample * (m_options.number_of_samples + number_requested_on_features());
    const double ratio = target_edge_ratio();
    for(;;)
    {
      const double max_length = ratio * m_spacing / unit_size();
      const std::vector<double> spacing =
          m_options.feature_spacing.empty() ? std::vector<double>() : feature_spacing();
      std::vector<bool> is_long(t().corner.size(), false);
      std::size_t number_of_long = 0;
      bool is_fine_enough = true;
      for(Index h = 0; h < is_long.size(); ++h)
      {
        const double length = slowness(h / 3) * t().length[h];
        const bool is_long_feature =
            !spacing.empty() && m_is_feature[h] && t().length[h] > ratio * spacing[h];
        if(!(length > max_length) && !is_long_feature)
          continue;
        ++number_of_long;
        is_fine_enough =
            is_fine_enough && !is_long_feature && length <= long_edge_factor * max_length;
        is_long[h] = true;
        if(t().twin[h] != none)
          is_long[t().twin[h]] = true;
      }
      is_fine_enough = is_fine_enough && number_of_long * few_edges_divisor <= is_long.size();
      if(is_fine_enough || t().number_of_vertices() >= max_vertices)
        return;
      set_surface(split_edges(m_surface, is_long));
    }
  }

  void start_sampling()
  {
    m_front.emplace(m_surface.triangles, Front_kind::euclidean);
    m_sampling.emplace(m_surface.triangles, *m_front, Sample_location::triangle, m_slowness);
  }

  bool place_samples()
  {
    std::vector<Surface_location> initial_samples = to_fine(m_surface, m_options.first_samples);
    const std::vector<Surface_location> on_features =
        sample_feature_polylines(t(), feature_spacing());
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

  // Places after equal parts of the area, in the order of triangles, which have near numbers where they are
  // neighbours; none nearer to other samples than all will be.
  std::vector<Surface_location> stratified_samples(std::size_t number) const
  {
    const auto triangle_area = [&](Index f)
    {
      const double* const l = &t().length[3 * std::size_t(f)];
      return slowness(f) * slowness(f) * twice_area(l[0], l[1], l[2]);
    };
    double total = 0.;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      total += triangle_area(f);
    const double stratum = total / double(number);
    std::vector<Surface_location> result;
    double sum = stratum * double(std::mt19937(m_options.seed)()) / 0x1p32;
    for(Index f = 0; f < t().number_of_triangles() && number > 0; ++f)
    {
      sum += triangle_area(f);
      if(!(sum >= stratum))
        continue;
      sum = std::fmod(sum, stratum);
      if(m_sampling->distances()[t().corner[3 * f]] > m_spacing / unit_size())
        result.push_back({f, none, {1. / 3., 1. / 3., 1. / 3.}});
    }
    return result;
  }

  // At most: both sides of an edge count.
  std::size_t number_requested_on_features() const
  {
    double result = 0.;
    const std::vector<double>& spacing = m_options.feature_spacing;
    for(Index h = 0; h < spacing.size(); ++h)
      if(m_coarse_features[h] && spacing[h] > 0.)
        result += m_surface.coarse->length[h] / spacing[h];
    if(!(result <= double(max_number_of_vertices)))
      throw Invalid_argument_error(
          "A mesh with vertices so near to each other along curves has more "
          "than 2^31 half-edges.");
    return std::size_t(result);
  }

  // #sides: the one asked for, or that of all samples; zero off the curves.
  std::vector<double> feature_spacing() const
  {
    std::vector<double> result(t().corner.size(), 0.);
    if(!m_has_features)
      return result;
    const std::vector<Index> coarse = coarse_halfedges(m_surface);
    for(Index h = 0; h < result.size(); ++h)
    {
      if(!m_is_feature[h])
        continue;
      const double requested =
          m_options.feature_spacing.empty() ? 0. : m_options.feature_spacing[coarse[h]];
      const Index twin = t().twin[h];
      const double min_slowness =
          twin == none ? slowness(h / 3) : std::min(slowness(h / 3), slowness(twin / 3));
      const double spacing = (requested > 0. ? requested : m_spacing / min_slowness) / unit_size();
      result[h] = std::min(spacing, max_feature_length);
    }
    return result;
  }

  // Adds so many, and more where no sample has come yet.
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

  // Moves samples to the centroids of their cells.
  bool relax()
  {
    const std::size_t steps = m_options.number_of_relaxation_steps;
    if(steps == 0)
      return true;
    const std::vector<Surface_location>& samples = m_sampling->samples();
    std::vector<bool> is_fixed;
    for(std::size_t i = 0; i < samples.size(); ++i)
      is_fixed.push_back(i < m_number_of_fixed || is_on_feature(samples[i]));
    Relaxation relaxation(m_surface.triangles, m_slowness, samples, m_sampling->labels(), is_fixed);
    for(std::size_t step = 0; step < steps; ++step)
    {
      if(!report_progress(0.4 + 0.4 * double(step) / double(steps)))
        return false;
      relaxation.step(step + 1 == steps);
    }
    Smoothing smoothing(t(), m_slowness.get(), relaxation.samples(),
                        compute_dual_triangles(t(), relaxation.labels()), is_fixed, m_is_feature);
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

  bool is_on_feature(const Surface_location& sample) const
  {
    const Surface_location clean = canonical(t(), sample);
    if(const Index vertex = vertex_of(t(), clean); vertex != none)
      return m_is_feature_vertex[vertex];
    const Index h = halfedge_of(clean);
    return h != none && m_is_feature[h];
  }

  bool enforce_topology()
  {
    for(;;)
    {
      if(!report_progress(0.9))
        return false;
      const Cells cells = connected_cells(t(), *m_sampling);
      // Some samples came to no site.
      if(cells.samples.size() < m_options.number_of_samples && m_sampling->covering_radius() > 0.)
      {
        if(!add_farthest(m_options.number_of_samples - cells.samples.size(), 0.8, 0.9))
          return false;
        continue;
      }
      Dual found = dual(t(), cells.labels, Index(cells.samples.size()), m_is_feature);
      const std::vector<Index> off_feature_cells = find_off_feature_cells(cells);
      m_unresolved = cells_without_own_sample(cells);
      if(found.is_closed_ball() && off_feature_cells.empty() && m_unresolved.empty())
      {
        Coarse_mesh mesh = build_mesh(cells, found.triangles);
        std::vector<Surface_location> more = far_locations(cells, mesh);
        if(more.empty())
        {
          Remeshing candidate = build_result(cells, std::move(mesh), std::move(found.triangles));
          if(m_options.does_avoid_self_intersections)
            more = locations_at_intersections(cells, candidate);
          if(accept_result(std::move(candidate), more.empty()))
            return true;
        }
        m_sampling->add(more);
        continue;
      }
      m_is_handled.assign(cells.samples.size(), false);
      const std::vector<Surface_location> more = locations_to_add(cells, found, off_feature_cells);
      if(!more.empty())
        m_sampling->add(more);
      else
        refine_unresolved(cells);
    }
  }

  // Cells that come to a curve, on which their sample is not.
  std::vector<Index> find_off_feature_cells(const Cells& cells) const
  {
    std::vector<bool> touches_feature(cells.samples.size(), false);
    for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
      if(m_is_feature_vertex[vertex] && cells.labels[vertex] != none)
        touches_feature[cells.labels[vertex]] = true;
    std::vector<Index> result;
    for(Index cell = 0; cell < cells.samples.size(); ++cell)
      if(touches_feature[cell] && !is_on_feature(m_sampling->samples()[cells.samples[cell]]))
        result.push_back(cell);
    return result;
  }

  // Cells whose sample is on a curve, on none of whose sites there they are, and those that are there.
  std::vector<Index> cells_without_own_sample(const Cells& cells) const
  {
    std::vector<Index> result;
    for(Index cell = 0; cell < cells.samples.size(); ++cell)
    {
      const Surface_location& sample = m_sampling->samples()[cells.samples[cell]];
      if(!is_on_feature(sample))
        continue;
      const Surface_location clean = canonical(t(), sample);
      const Index vertex = vertex_of(t(), clean), h = halfedge_of(clean);
      const std::array<Index, 2> ends = {vertex != none ? vertex : t().corner[h],
                                         vertex != none ? vertex : t().corner[next_halfedge(h)]};
      const Index a = cells.labels[ends[0]], b = cells.labels[ends[1]];
      if(a != cell && b != cell)
        for(const Index c : {cell, a, b})
          result.push_back(c);
    }
    return result;
  }

  // Samples at the farthest sites where something is wrong, if they are not samples already; one for
  // several faults next to each other.
  std::vector<Surface_location> locations_to_add(const Cells& cells, const Dual& found,
                                                 const std::vector<Index>& off_feature_cells)
  {
    const std::size_t n = cells.samples.size();
    const std::vector<double>& distances = m_sampling->distances();
    std::vector<Index> farthest(n, none), farthest_on_feature(n, none), nearest_on_feature(n, none);
    const auto keep_farthest = [&](Index& best, Index vertex)
    {
      if(best == none || distances[vertex] > distances[best])
        best = vertex;
    };
    for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
      if(const Index cell = cells.labels[vertex]; cell != none)
      {
        keep_farthest(farthest[cell], vertex);
        if(!m_is_feature_vertex[vertex])
          continue;
        keep_farthest(farthest_on_feature[cell], vertex);
        Index& nearest = nearest_on_feature[cell];
        if(nearest == none || distances[vertex] < distances[nearest])
          nearest = vertex;
      }
    std::vector<Index> at_interface(found.disconnected_interfaces.size(), none),
        at_boundary_crossing(found.repeated_boundary_crossings.size(), none),
        at_triple_point(found.repeated_triple_points.size(), none);
    std::vector<bool> is_disconnected(n, false), is_repeated(n, false);
    for(const auto* contacts : {&found.disconnected_interfaces, &found.repeated_boundary_crossings})
      for(const auto& contact : *contacts)
        for(const Index cell : contact)
          is_disconnected[cell] = true;
    for(const auto& triple_point : found.repeated_triple_points)
      for(const Index cell : triple_point)
        is_repeated[cell] = true;
    const auto find_index = [](const auto& list, const auto& element)
    {
      const auto position = std::lower_bound(list.begin(), list.end(), element);
      return position != list.end() && *position == element ? std::size_t(position - list.begin())
                                                            : list.size();
    };
    for(Index h = 0; h < t().corner.size(); ++h)
    {
      const Index x = t().corner[h], z = t().corner[next_halfedge(h)];
      const Index a = cells.labels[x], b = cells.labels[z];
      if(a == b || !is_disconnected[a] || !is_disconnected[b])
        continue;
      const std::array<Index, 2> cell_pair = {std::min(a, b), std::max(a, b)};
      if(const auto i = find_index(found.disconnected_interfaces, cell_pair);
         i < at_interface.size())
      {
        keep_farthest(at_interface[i], x);
        keep_farthest(at_interface[i], z);
      }
      if(const auto i = find_index(found.repeated_boundary_crossings, cell_pair);
         i < at_boundary_crossing.size() && m_is_feature[h])
      {
        keep_farthest(at_boundary_crossing[i], x);
        keep_farthest(at_boundary_crossing[i], z);
      }
    }
    for(Index f = 0; f < t().number_of_triangles() && !at_triple_point.empty(); ++f)
    {
      std::array<Index, 3> cells_around;
      for(Index k = 0; k < 3; ++k)
        cells_around[k] = cells.labels[t().corner[3 * f + k]];
      if(!is_repeated[cells_around[0]] || !is_repeated[cells_around[1]] ||
         !is_repeated[cells_around[2]])
        continue;
      std::sort(cells_around.begin(), cells_around.end());
      if(const auto i = find_index(found.repeated_triple_points, cells_around);
         i < at_triple_point.size())
        for(Index k = 0; k < 3; ++k)
          keep_farthest(at_triple_point[i], t().corner[3 * f + k]);
    }

    std::vector<Surface_location> result;
    const auto add = [&](std::initializer_list<Index> cells_around, Index vertex)
    {
      if(std::any_of(cells_around.begin(), cells_around.end(),
                     [&](Index c) { return m_is_handled[c]; }))
        return;
      // Else anywhere in these cells.
      for(const Index cell : cells_around)
        if(distances[vertex] == 0.)
          vertex = farthest[cell];
      for(const Index cell : cells_around)
        m_is_handled[cell] = true;
      if(distances[vertex] > 0.)
        result.push_back({none, vertex, {}});
      else
        m_unresolved.insert(m_unresolved.end(), cells_around);
    };
    for(const Index cell : found.disconnected_boundaries)
      add({cell}, farthest_on_feature[cell]);
    for(const Index cell : off_feature_cells)
      add({cell}, nearest_on_feature[cell]);
    for(const Index cell : found.non_disks)
      add({cell}, farthest[cell]);
    for(std::size_t i = 0; i < at_boundary_crossing.size(); ++i)
      add({found.repeated_boundary_crossings[i][0], found.repeated_boundary_crossings[i][1]},
          at_boundary_crossing[i]);
    for(std::size_t i = 0; i < at_interface.size(); ++i)
      add({found.disconnected_interfaces[i][0], found.disconnected_interfaces[i][1]},
          at_interface[i]);
    for(std::size_t i = 0; i < at_triple_point.size(); ++i)
      add({found.repeated_triple_points[i][0], found.repeated_triple_points[i][1],
           found.repeated_triple_points[i][2]},
          at_triple_point[i]);
    return result;
  }

  // Where each site is a sample and the triangles are no surface of their own yet: two that share
  // their corners.
  void refine_unresolved(const Cells& cells)
  {
    if(++m_number_of_refinements > max_refinements)
      throw Unsupported_surface_error(
          "The mesh folds onto itself so that samples cannot be joined.");
    std::vector<bool> is_unresolved(cells.samples.size(), false),
        is_halved(t().corner.size(), false);
    for(const Index cell : m_unresolved)
      is_unresolved[cell] = true;
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      for(Index k = 0; k < 3; ++k)
        if(is_unresolved[cells.labels[t().corner[3 * f + k]]])
          for(Index h = 3 * f; h < 3 * f + 3; ++h)
          {
            is_halved[h] = true;
            if(t().twin[h] != none)
              is_halved[t().twin[h]] = true;
          }
    std::vector<Surface_location> samples;
    for(const Surface_location& sample : m_sampling->samples())
      samples.push_back(to_coarse(m_surface, sample));
    set_surface(split_edges(m_surface, is_halved));
    start_sampling();
    m_sampling->add(to_fine(m_surface, samples));
  }

  // Where four cells almost meet in one place, sites do not tell which two do.
  Coarse_mesh build_mesh(const Cells& cells, std::vector<std::array<Index, 3>> triangles) const
  {
    Coarse_mesh result{{}, std::move(triangles)};
    std::vector<bool> is_fixed;
    const bool has_max_deviation = m_options.maximum_deviation < infinity;
    const std::vector<Index> farthest =
        has_max_deviation ? farthest_vertices(cells) : std::vector<Index>();
    for(Index cell = 0; cell < cells.samples.size(); ++cell)
    {
      const Surface_location& sample = m_sampling->samples()[cells.samples[cell]];
      result.points.push_back(scaled_coordinates(t(), sample));
      // Where no sample can be added, the surface is what it was.
      is_fixed.push_back(is_on_feature(sample) || (has_max_deviation && farthest[cell] == none));
    }
    flip_to_larger_angles(result.points, is_fixed, result.triangles);
    if(m_options.does_fit_to_input)
      fit(t(), cells.labels, is_fixed, result, m_options.maximum_deviation / unit_size(),
          m_options.number_of_relaxation_steps < many_steps ? 0 : angle_preserving_steps);
    return result;
  }

  // Of each cell the site farthest from its sample; none where all are samples.
  std::vector<Index> farthest_vertices(const Cells& cells) const
  {
    std::vector<Index> result(cells.samples.size(), none);
    const std::vector<double>& distances = m_sampling->distances();
    for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
      if(const Index cell = cells.labels[vertex];
         cell != none && distances[vertex] > 0. &&
         (result[cell] == none || distances[vertex] > distances[result[cell]]))
        result[cell] = vertex;
    return result;
  }

  // Sites that are farther from the mesh than they may be, or else those of its triangles that are
  // farther from the surface; no samples, which fitting moves by no more than they may be off.
  std::vector<Surface_location> far_locations(const Cells& cells, const Coarse_mesh& mesh)
  {
    if(!(m_options.maximum_deviation < infinity))
      return {};
    const std::vector<double>& distances = m_sampling->distances();
    std::vector<Index> labels = cells.labels;
    for(Index vertex = 0; vertex < labels.size(); ++vertex)
      if(distances[vertex] == 0.)
        labels[vertex] = none;
    std::vector<Index> vertices =
        far_vertices(t(), labels, mesh, m_options.maximum_deviation / unit_size());
    if(vertices.empty())
    {
      const std::vector<Index> farthest = farthest_vertices(cells);
      for(const auto& f : mesh.triangles)
      {
        Index best = none;
        for(const Index cell : f)
          if(const Index vertex = farthest[cell];
             vertex != none && (best == none || distances[vertex] > distances[best]))
            best = vertex;
        if(best != none && is_far(mesh, f))
          vertices.push_back(best);
      }
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
    std::vector<Surface_location> result;
    for(const Index vertex : vertices)
      result.push_back({none, vertex, {}});
    return result;
  }

  // Whether the middle of a triangle or of a side is farther from the surface than it may be.
  bool is_far(const Coarse_mesh& mesh, const std::array<Index, 3>& triangle)
  {
    if(!m_tree)
      m_tree.emplace(m_surface.coarse);
    const Surface_arrays& coarse = *m_surface.coarse;
    const auto is_point_far = [&](const Vec3& p)
    {
      const Vec3 point = t().origin + t().scale * p;
      return norm(point - coordinates(coarse, m_tree->nearest(point))) >
             m_options.maximum_deviation * coarse.scale;
    };
    const Vec3 &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]],
               &c = mesh.points[triangle[2]];
    return is_point_far((1. / 3.) * (a + b + c)) || is_point_far(0.5 * (a + b)) ||
           is_point_far(0.5 * (b + c)) || is_point_far(0.5 * (c + a));
  }

  // Where triangles cross and the surface does not, some of them are too far from it.
  std::vector<Surface_location> locations_at_intersections(const Cells& cells, Remeshing& candidate)
  {
    const std::size_t max_pairs = candidate.triangles.size();
    const auto intersections = self_intersections(candidate.points, candidate.triangles, max_pairs);
    candidate.number_of_self_intersections = intersections.size();
    // So many are not for want of samples.
    if(intersections.empty() || intersections.size() == max_pairs)
      return {};
    const std::vector<bool> is_self_intersecting = self_intersecting_cells(cells);
    std::vector<bool> is_affected(cells.samples.size(), false);
    for(const auto& triangle_pair : intersections)
    {
      const auto is_intersection_free = [&](Index f)
      {
        const auto& corners = candidate.triangles[f];
        return !is_self_intersecting[corners[0]] && !is_self_intersecting[corners[1]] &&
               !is_self_intersecting[corners[2]];
      };
      if(is_intersection_free(triangle_pair[0]) || is_intersection_free(triangle_pair[1]))
        for(const Index f : triangle_pair)
          for(const Index cell : candidate.triangles[f])
            is_affected[cell] = true;
    }
    const std::vector<Index> farthest = farthest_vertices(cells);
    std::vector<Surface_location> result;
    for(Index cell = 0; cell < farthest.size(); ++cell)
      if(is_affected[cell] && farthest[cell] != none)
        result.push_back({none, farthest[cell], {}});
    return result;
  }

  // Whether it is settled what comes out: this, or what there was before samples were added at crossings
  // in vain.
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

  // Cells in which the surface itself crosses a part of it: no samples would help.
  std::vector<bool> self_intersecting_cells(const Cells& cells)
  {
    if(!m_is_self_intersecting)
    {
      const Surface_arrays& coarse = *m_surface.coarse;
      std::vector<std::array<Index, 3>> corners(coarse.number_of_triangles());
      for(Index f = 0; f < corners.size(); ++f)
        std::copy_n(&coarse.corner[3 * std::size_t(f)], 3, corners[f].begin());
      m_is_self_intersecting.emplace(corners.size(), false);
      for(const auto& triangle_pair : self_intersections(coarse.point, corners, corners.size()))
        for(const Index f : triangle_pair)
          (*m_is_self_intersecting)[f] = true;
    }
    std::vector<bool> result(cells.samples.size(), false);
    for(Index f = 0; f < t().number_of_triangles(); ++f)
      if((*m_is_self_intersecting)[m_surface.parent.empty() ? f : m_surface.parent[f]])
        for(Index k = 0; k < 3; ++k)
          result[cells.labels[t().corner[3 * f + k]]] = true;
    return result;
  }

  // On the triangles that were given.
  Remeshing build_result(const Cells& cells, Coarse_mesh mesh,
                         std::vector<std::array<Index, 3>> dual_triangles) const
  {
    Remeshing result;
    for(std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      result.samples.push_back(canonical(
          *m_surface.coarse, to_coarse(m_surface, m_sampling->samples()[cells.samples[i]])));
      result.points.push_back(m_options.does_fit_to_input
                                  ? t().origin + t().scale * mesh.points[i]
                                  : coordinates(*m_surface.coarse, result.samples.back()));
    }
    result.triangles = std::move(mesh.triangles);
    result.surface = m_surface;
    result.cells = cells.labels;
    result.dual_triangles = std::move(dual_triangles);
    return result;
  }

  const Remeshing_options& m_options;
  std::vector<bool> m_coarse_features;
  bool m_has_features;
  double m_spacing = 0.; // in the unit of the coarse triangles

  Refinement m_surface;
  std::vector<bool> m_is_feature, m_is_feature_vertex; // #sides, #sites
  std::shared_ptr<const std::vector<double>> m_slowness;
  std::optional<Front> m_front;
  std::optional<Sampling> m_sampling;
  std::size_t m_number_of_fixed = 0; // samples, the first ones
  Remeshing m_result;

  // Of a round
  std::vector<bool> m_is_handled;  // #cells
  std::vector<Index> m_unresolved; // cells that have a fault and no site left
  int m_number_of_refinements = 0, m_intersection_rounds = 0;
  std::optional<Remeshing> m_fallback; // before any samples were added at crossings
  std::optional<std::vector<bool>>
      m_is_self_intersecting;          // #coarse triangles, once some of the result do
  std::optional<Triangle_tree> m_tree; // of the coarse triangles, once it is asked
};

} // namespace

Remeshing remesh(const std::shared_ptr<const Surface_arrays>& triangles,
                 const Remeshing_options& options)
{
  if(options.number_of_samples > max_number_of_vertices)
    throw Invalid_argument_error("A mesh of so many vertices has more than 2^31 half-edges.");
  return Remesher(triangles, options).run();
}

} // namespace CGAL::Geodesic_processing::internal
