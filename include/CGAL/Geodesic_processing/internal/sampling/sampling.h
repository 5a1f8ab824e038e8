// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_SAMPLING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_SAMPLING_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Where samples may lie: at sites, or on a mesh also inside triangles.
enum class Sample_location
{
  vertex,
  triangle,
};

// Samples of a domain, and what each site knows of the nearest one.  A sample costs in proportion to
// the sites that it is nearest to when it comes, and those next to them (Peyré and Cohen 2003,
// section 3.1).
class CGAL_GEODESIC_PROCESSING_EXPORT Sampling
{
public:
  // slowness: as in Front_limits.  Sites that no front can leave, those of a mesh that have no
  // triangle or obstacles only, are no part of what is sampled.
  Sampling(std::shared_ptr<const Surface_arrays> triangles, Front front,
           Sample_location sample_location,
           std::shared_ptr<const std::vector<double>> slowness = nullptr);

  // Several come at once, by one front.  False when the callback cancelled it: then some distances
  // are too long.
  bool add(const std::vector<Surface_location>& samples,
           const std::function<bool(double)>& callback = {});
  bool add(const Surface_location& sample, const std::function<bool(double)>& callback = {})
  {
    return add(std::vector<Surface_location>{sample}, callback);
  }

  // The site that is farthest from all samples, one where none reaches before all others; none when
  // each one holds a sample.
  Index farthest_vertex();
  // The distance of the farthest site.  It never grows, because the distance of no site does.
  double covering_radius();
  // Where to put the next sample: the farthest site, or a place beside it that is farther.  Where no
  // sample reaches, that part's site farthest from `start`, which is in it, or from its first one.
  Surface_location farthest_location(Index start = none);

  const std::vector<Surface_location>& samples() const { return m_samples; }
  // Distances to the nearest sample, and its place among the samples or none.
  const std::vector<double>& distances() const { return m_distances; }
  const std::vector<Index>& labels() const { return m_labels; }
  // The sites that are sampled.
  const std::vector<Index>& sampled_vertices() const { return m_sampled_vertices; }

private:
  struct Entry
  {
    double key; // the site's distance, as it was
    Index vertex;
    // The order among equal ones must not depend on the way.
    bool operator<(const Entry& other) const
    {
      return key < other.key || (key == other.key && vertex > other.vertex);
    }
  };

  void refill();
  Index farthest_in_component(Index start);
  Surface_location front_meeting_point(Index vertex) const;
  double distance_in_triangle(Index triangle, const std::array<double, 3>& barycentric) const;
  double slowness(Index triangle) const
  {
    return m_limits.slowness ? (*m_limits.slowness)[triangle] : 1.;
  }

  std::shared_ptr<const Surface_arrays> m_triangles;
  Front m_front;
  Front_limits m_limits;
  Sample_location m_sample_location;

  std::vector<Surface_location> m_samples;
  std::vector<bool> m_has_sample; // #triangles: a sample is inside; empty where none ever is
  std::vector<double> m_distances;
  std::vector<Index> m_labels;

  std::vector<Index> m_sampled_vertices;
  std::size_t m_first_unreached = 0; // before this place in m_sampled_vertices all are reached
  // A heap of the sites whose distance was at least the threshold, when it was last filled.
  std::vector<Entry> m_heap;
  double m_threshold = infinity;

  // While an end of a part is looked for; #sites once one has been
  std::vector<double> m_path_lengths; // along arcs
  std::vector<bool> m_is_queued;      // to be gone on from
};

// When a sampling is enough.
struct Sampling_options
{
  std::size_t number_of_samples = 0;    // of samples to add
  double covering_radius = 0.;          // or when it is down to this one
  unsigned seed = 0;                    // of the site from which the first sample is farthest
  std::function<bool(double)> callback; // told the fraction done; false cancels
};

// Adds farthest places until the goal is met, or no site is left at a distance.  After each one `out`
// is told the covering radius that it leaves.  False when the callback cancelled it.
CGAL_GEODESIC_PROCESSING_EXPORT
bool sample_farthest_points(Sampling& sampling, const Sampling_options& options,
                            const std::function<void(double)>& report_radius);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_SAMPLING_H
