// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/tessellation.h>

#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>
#include "mesh/patches.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "distances/for_each_row.h"
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Stencil for the gradient. Three directions are the minimum for which even terms cancel. On a
// plane any length is exact; a longer stencil averages the errors of fronts.
constexpr std::size_t number_of_directions = 3;
constexpr double stencil_ratio = 0.25; // length relative to the radius of the cell

// Initial step length relative to the distance of the mean. Cells follow their centers, so that
// consecutive steps tend to have the same direction.
constexpr double initial_step_ratio = 1.8;

// Shorter moves of a center, relative to the radius of its cell, are omitted.
constexpr double min_move_ratio = 1e-3;

// Smaller relative decreases of the energy may be round-off errors.
constexpr double round_off_tolerance = 1e-12;

// Maximum number of rounds in which cells are added, and maximum number of cells per vertex. After
// that, patches that are not disks are split.
constexpr unsigned max_rounds = 20;
constexpr double max_cell_ratio = 0.1;

// If the topology requires this multiple of the requested number of cells, one relaxation step is
// taken. Each cell is then determined by a handle, and on surfaces with thousands of handles a step
// takes seconds.
constexpr double many_cells_ratio = 4.;

class Lloyd_relaxation
{
public:
  Lloyd_relaxation(std::shared_ptr<const Surface_arrays> triangles, const Front& front,
                   std::shared_ptr<const std::vector<double>> slowness,
                   const Tessellation_options& options)
      : m_triangles(std::move(triangles)), m_front(front), m_options(options),
        m_area(m_triangles->number_of_vertices(), 0.)
  {
    m_limits.slowness = std::move(slowness);
    const Surface_arrays& t = *m_triangles;
    for(Index f = 0; f < t.number_of_triangles(); ++f)
      if(const double s = slowness_of(f); s < infinity)
      {
        const double* const lengths = &t.length[3 * std::size_t(f)];
        const double weight = t.weight.empty() ? 1. : double(t.weight[f]);
        for(Index corner = 3 * f; corner < 3 * f + 3; ++corner)
          m_area[t.corner[corner]] +=
              weight * s * s * twice_area(lengths[0], lengths[1], lengths[2]) / 6.;
      }
  }

  Tessellation run()
  {
    m_is_finished = initialize() && (has_many_handles() || relax(m_options.max_steps));
    if(m_triangles->is_cloud())
      return {m_state.centers, m_state.cells, m_state.energies, m_is_finished};
    make_patches();
    remove_empty_patches();
    return {m_state.centers, m_state.patches, m_state.energies, m_is_finished};
  }

private:
  struct State
  {
    std::vector<Surface_location> centers;
    std::vector<double> distances; // #vertices: distance to the closest center
    std::vector<Index> cells;      // #vertices: the closest center, or none
    std::vector<Index> patches;    // #triangles of a mesh: the cell, or none
    std::vector<double> energies;
  };

  double slowness_of(Index triangle) const
  {
    return m_limits.slowness ? (*m_limits.slowness)[triangle] : 1.;
  }

  // Returns true if disks are required and the surface has more handles than cells. Two holes count
  // as one handle. Nearly every cell is then split, which makes the relaxation before it useless.
  bool has_many_handles() const
  {
    if(!m_options.does_make_disks)
      return false;
    const Surface_arrays& t = *m_triangles;
    long long euler = t.number_of_triangles();
    for(Index lengths = 0; lengths < t.twin.size(); ++lengths)
      euler -= t.twin[lengths] == none || lengths < t.twin[lengths];
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
      euler += t.ring_begin[vertex] < t.ring_begin[vertex + 1];
    return euler < -2 * static_cast<long long>(m_options.number_of_cells);
  }

  double energy() const
  {
    double sum = 0.;
    for(Index vertex = 0; vertex < m_area.size(); ++vertex)
      if(m_state.cells[vertex] != none)
        sum += m_area[vertex] * m_state.distances[vertex] * m_state.distances[vertex];
    return sum;
  }

  bool initialize()
  {
    Sampling sampling(m_triangles, m_front,
                      m_triangles->is_cloud() ? Sample_location::vertex : Sample_location::triangle,
                      m_limits.slowness);
    Sampling_options options;
    options.number_of_samples = m_options.number_of_cells;
    options.seed = m_options.seed;
    if(m_options.callback)
      options.callback = [&](double) { return m_options.callback(0.); };
    const bool is_complete = sample_farthest_points(sampling, options, [](double) {});
    m_state.centers = sampling.samples();
    m_state.distances = sampling.distances();
    m_state.cells = sampling.labels();
    m_state.energies = {energy()};
    return is_complete;
  }

  bool relax(unsigned steps)
  {
    for(unsigned step = 0; step < steps; ++step)
    {
      if(!take_step(double(step) / double(steps)))
        return false;
      if(has_converged())
        break;
    }
    return true;
  }

  bool take_step(double fraction_done)
  {
    if(m_options.callback && !m_options.callback(fraction_done))
      return false;
    move_centers();
    update_cells(0);
    m_state.energies.push_back(energy());
    return true;
  }

  bool has_converged() const
  {
    const double before = m_state.energies[m_state.energies.size() - 2];
    return !(m_state.energies.back() < (1. - m_options.energy_tolerance) * before);
  }

  // Moves all centers in parallel: each cell writes only its center and the distances of its
  // vertices.
  void move_centers()
  {
    std::vector<std::vector<Index>> vertices(m_state.centers.size());
    for(Index vertex = 0; vertex < m_area.size(); ++vertex)
      if(m_state.cells[vertex] != none && m_area[vertex] > 0.)
        vertices[m_state.cells[vertex]].push_back(vertex);
    for_each_row(m_front, vertices.size(), m_limits, m_options.number_of_threads,
                 [&](std::size_t cell, Front& front, const Front_limits& limits)
                 { move_center(m_state.centers[cell], vertices[cell], front, limits); });
  }

  // The energy of one cell as a function of its center, with the other cells fixed.
  struct Cell_energy
  {
    const std::vector<Index>& vertices;
    const std::vector<double>& area;
    Front& front;
    Front_limits limits;
    std::vector<double> distances; // #vertices of the cell: from the present center
    double mass = 0., value = 0., radius = 0.;
    double slowness = 1.; // at the present center

    Cell_energy(const std::vector<Index>& cell_vertices, const Lloyd_relaxation& relaxation,
                Front& cell_front, const Front_limits& cell_limits)
        : vertices(cell_vertices), area(relaxation.m_area), front(cell_front), limits(cell_limits)
    {
      for(const Index vertex : vertices)
      {
        distances.push_back(relaxation.m_state.distances[vertex]);
        mass += area[vertex];
        value += area[vertex] * distances.back() * distances.back();
        radius = std::max(radius, distances.back());
      }
    }

    // Returns the integral of squared distances from a location at `step_length` from the center.
    // For a vertex that the front does not reach, the path via the center is used.
    double operator()(const Surface_location& location, double step_length,
                      std::vector<double>* new_distances)
    {
      limits.maximum_distance = radius + 2. * step_length * slowness;
      front.run({Front_source{{location}}}, limits);
      double sum = 0.;
      for(std::size_t i = 0; i < vertices.size(); ++i)
      {
        double distance = front.distance(vertices[i]);
        if(!(distance < infinity))
          distance = distances[i] + step_length * slowness;
        sum += area[vertices[i]] * distance * distance;
        if(new_distances)
          (*new_distances)[i] = distance;
      }
      return sum;
    }
  };

  // Returns the mean of the logarithms of the cell, which is -g / (2 mass) for the gradient g of
  // the energy at the center. The gradient is a least squares fit of E(q) - E(0) = g q + mass |q|^2
  // to the energies on the stencil. Returns nothing if the stencil is degenerate.
  static std::optional<Vec2> mean_logarithm(const Stencil& stencil, Cell_energy& energy)
  {
    const double slowness = energy.slowness;
    double xx = 0., xy = 0., yy = 0.;
    Vec2 b = {0., 0.};
    for(std::size_t j = 0; j < stencil.locations.size(); ++j)
    {
      const Vec2& q = stencil.vectors[j];
      const double step_length = norm(q),
                   squared_time = slowness * slowness * step_length * step_length;
      const double energy_change = energy(stencil.locations[j], step_length, nullptr) -
                                   energy.value - energy.mass * squared_time;
      xx += q[0] * q[0];
      xy += q[0] * q[1];
      yy += q[1] * q[1];
      b = b + energy_change * q;
    }
    const double determinant = xx * yy - xy * xy;
    if(!(determinant > 1e-4 * (xx + yy) * (xx + yy)))
      return std::nullopt;
    const Vec2 gradient = (1. / determinant) * Vec2{yy * b[0] - xy * b[1], xx * b[1] - xy * b[0]};
    return (-0.5 / (energy.mass * slowness * slowness)) * gradient;
  }

  // Moves a center in the direction of the mean logarithm if that decreases the energy of its cell.
  // Steps are halved from the overrelaxed one, at most the radius of the cell.
  void move_center(Surface_location& center, const std::vector<Index>& vertices, Front& front,
                   const Front_limits& limits)
  {
    const Surface_arrays& t = *m_triangles;
    Cell_energy energy(vertices, *this, front, limits);
    const Surface_location start_location = t.is_cloud() ? center : canonical(t, center);
    const Index triangle = containing_triangle(start_location);
    if(!(energy.radius > 0.) || triangle == none)
      return;
    const double radius = energy.radius, slowness = slowness_of(triangle);
    if(!(slowness < infinity))
      return;
    energy.slowness = slowness;
    const Tangent_plane plane(t, start_location);
    const auto mean =
        mean_logarithm(make_stencil(plane, vertices, stencil_ratio * radius / slowness), energy);
    if(!mean)
      return;
    std::vector<double> new_distances(vertices.size());
    for(double step_length = std::min(initial_step_ratio * norm(*mean), radius / slowness);
        step_length * slowness > min_move_ratio * radius; step_length /= 2.)
    {
      const Surface_location location =
          endpoint(plane, (step_length / norm(*mean)) * *mean, vertices);
      if(energy(location, step_length, &new_distances) < (1. - round_off_tolerance) * energy.value)
      {
        center = location;
        for(std::size_t i = 0; i < vertices.size(); ++i)
          m_state.distances[vertices[i]] = new_distances[i];
        return;
      }
    }
  }

  Index containing_triangle(const Surface_location& location) const
  {
    const Surface_arrays& t = *m_triangles;
    if(!t.is_cloud())
      return triangle_at(t, location);
    return t.ring_begin[location.vertex] == t.ring_begin[location.vertex + 1]
               ? none
               : t.ring[t.ring_begin[location.vertex]] / 3;
  }

  Stencil make_stencil(const Tangent_plane& plane, const std::vector<Index>& vertices,
                       double length) const
  {
    if(!m_triangles->is_cloud())
      return straightest_stencil(plane, length, number_of_directions);
    std::vector<double> distances;
    for(const Index vertex : vertices)
      distances.push_back(m_state.distances[vertex]);
    return vertex_stencil(*m_triangles, plane, vertices, distances, length, number_of_directions);
  }

  // Returns the end point of a straightest geodesic. On a cloud: the vertex of the cell closest to
  // the end of the tangent vector.
  Surface_location endpoint(const Tangent_plane& plane, const Vec2& vector,
                            const std::vector<Index>& vertices) const
  {
    const Surface_arrays& t = *m_triangles;
    if(!t.is_cloud())
      return plane.straightest_path(std::atan2(vector[1], vector[0]), norm(vector))
          .locations.back();
    const Vec3 end = plane.point() + vector[0] * plane.x() + vector[1] * plane.y();
    const auto squared_distance = [&](Index vertex)
    {
      const Vec3 offset = t.point[vertex] - end;
      return dot(offset, offset);
    };
    Surface_location result;
    result.vertex = *std::min_element(vertices.begin(), vertices.end(),
                                      [&](Index a, Index b)
                                      { return squared_distance(a) < squared_distance(b); });
    return result;
  }

  // Assigns the vertices that are closer to a center from `first_center` on than to their own one.
  void update_cells(std::size_t first_center)
  {
    // Fronts stop at vertices with a smaller known distance. For the vertices of its own cell, a
    // center reproduces the known distances up to round-off errors, so that these must be enlarged.
    std::vector<double> known = m_state.distances;
    for(double& distance : known)
      distance *= 1. + 1e-9;
    Front_limits limits = m_limits;
    limits.known_distance = &known;
    std::vector<std::vector<std::pair<Index, double>>> closer(m_state.centers.size() -
                                                              first_center);
    for_each_row(m_front, closer.size(), limits, m_options.number_of_threads,
                 [&](std::size_t i, Front& front, const Front_limits& own_limits)
                 {
                   front.run({Front_source{{m_state.centers[first_center + i]}}}, own_limits);
                   for(const Index vertex : front.reached())
                     if(front.distance(vertex) < m_state.distances[vertex])
                       closer[i].emplace_back(vertex, front.distance(vertex));
                 });
    for(std::size_t i = 0; i < closer.size(); ++i)
      for(const auto& [vertex, distance] : closer[i])
        if(distance < m_state.distances[vertex])
        {
          m_state.distances[vertex] = distance;
          m_state.cells[vertex] = Index(first_center + i);
        }
  }

  // Labels the triangles of a mesh. If disks are required, adds centers and splits patches.
  void make_patches()
  {
    const Surface_arrays& t = *m_triangles;
    m_state.patches = merged_patches();
    if(!m_options.does_make_disks || !m_is_finished)
      return;
    // A new center at the farthest vertex splits cells that wind around a tube.
    const std::size_t number_requested = m_state.centers.size();
    for(unsigned round = 0; round < max_rounds; ++round)
    {
      const std::vector<Surface_location> new_centers = farthest_in_non_disks();
      const std::size_t number_before = m_state.centers.size();
      if(new_centers.empty() ||
         number_before + new_centers.size() > max_cell_ratio * double(m_area.size()))
        break;
      m_state.centers.insert(m_state.centers.end(), new_centers.begin(), new_centers.end());
      update_cells(number_before);
      m_state.energies.push_back(energy());
      m_state.patches = merged_patches();
    }
    if(m_state.centers.size() > number_requested)
      relax_keeping_disks(number_requested);
    for(const Index triangle : split_into_disks(t, m_state.patches, Index(m_state.centers.size())))
      m_state.centers.push_back({triangle, none, {1. / 3., 1. / 3., 1. / 3.}});
  }

  // Relaxes the centers while the number of disks does not decrease. A step that decreases it is
  // undone.
  void relax_keeping_disks(std::size_t number_requested)
  {
    const auto number_of_disks = [&]
    {
      const std::vector<bool> is_disk =
          are_disks(*m_triangles, m_state.patches, Index(m_state.centers.size()));
      return std::count(is_disk.begin(), is_disk.end(), true);
    };
    const auto number_before = number_of_disks();
    const bool has_many_more = m_state.centers.size() > many_cells_ratio * double(number_requested);
    const unsigned max_steps = std::min(has_many_more ? 1u : ~0u, m_options.max_steps);
    for(unsigned step = 0; step < max_steps; ++step)
    {
      State previous = m_state;
      m_is_finished = take_step(1.);
      if(!m_is_finished)
        break;
      m_state.patches = merged_patches();
      const bool is_worse = number_of_disks() < number_before, is_last = has_converged();
      if(is_worse)
        m_state = std::move(previous);
      if(is_worse || is_last)
        break;
    }
  }

  // Removes centers without triangles: cells that contain no vertex, and cells whose triangles all
  // joined adjacent ones.
  void remove_empty_patches()
  {
    std::vector<Index> new_index(m_state.centers.size(), none);
    for(const Index patch : m_state.patches)
      if(patch != none)
        new_index[patch] = 0;
    std::vector<Surface_location> kept;
    for(std::size_t i = 0; i < new_index.size(); ++i)
      if(new_index[i] == 0)
      {
        new_index[i] = Index(kept.size());
        kept.push_back(m_state.centers[i]);
      }
    for(Index& patch : m_state.patches)
      if(patch != none)
        patch = new_index[patch];
    m_state.centers = std::move(kept);
  }

  // Labels triangles by cell, and merges disconnected parts of a patch with adjacent patches.
  std::vector<Index> merged_patches() const
  {
    std::vector<Index> result = label_patches(*m_triangles, m_state.distances, m_state.cells);
    merge_patch_fragments(*m_triangles, result);
    return result;
  }

  // Returns the vertex of each patch that is not a disk with the largest distance to its center.
  std::vector<Surface_location> farthest_in_non_disks() const
  {
    const Surface_arrays& t = *m_triangles;
    const std::vector<bool> is_disk = are_disks(t, m_state.patches, Index(m_state.centers.size()));
    std::vector<Index> farthest(is_disk.size(), none);
    for(Index corner = 0; corner < t.corner.size(); ++corner)
      if(const Index patch = m_state.patches[corner / 3]; patch != none && !is_disk[patch])
      {
        const Index vertex = t.corner[corner];
        Index& best = farthest[patch];
        if(m_state.distances[vertex] > (best == none ? 0. : m_state.distances[best]))
          best = vertex;
      }
    std::vector<Surface_location> result;
    for(const Index vertex : farthest)
      if(vertex != none)
        result.push_back(vertex_location(t, vertex));
    return result;
  }

  std::shared_ptr<const Surface_arrays> m_triangles;
  const Front& m_front;
  const Tessellation_options& m_options;
  Front_limits m_limits;
  // #vertices: a third of the incident area, in the metric of travel times.
  std::vector<double> m_area;
  State m_state;
  bool m_is_finished = true;
};

} // namespace

Tessellation tessellate(std::shared_ptr<const Surface_arrays> triangles, const Front& front,
                        std::shared_ptr<const std::vector<double>> slowness,
                        const Tessellation_options& options)
{
  return Lloyd_relaxation(std::move(triangles), front, std::move(slowness), options).run();
}

} // namespace CGAL::Geodesic_processing::internal
