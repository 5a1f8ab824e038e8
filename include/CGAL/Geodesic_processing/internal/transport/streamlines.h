// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_STREAMLINES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_STREAMLINES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/transport/continuous_flow.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A grain of mass where it starts.
struct Streamline_seed
{
  Surface_location location;
  double right_fraction =
      0.5; // at a site of a cloud: how much of its mass lies on the right of the grain
  Index source_vertex =
      none; // the site whose mass it is part of, where that is a point and was spread
};

struct Streamline
{
  std::vector<Surface_location>
      locations;            // at least one; consecutive ones in a common triangle, of a cloud at
                            //   least joined by an arc; no point twice in a row
  bool has_arrived = false; // whether mass is missing where it ends
};

// The masses that a flow moves: the difference is its divergence.  None is negative.
struct Moved_masses
{
  Vector source_masses, target_masses; // #sites
  // Whether they are points, where lines begin and end; else they are spread around the sites.
  bool has_point_sources = false, has_point_targets = false;
  std::vector<Surface_location> source_locations,
      target_locations; // of points in triangles, shared by the corners
};

// Lines along which a flow moves masses in a unit of time, as Dacorogna and Moser (1990) have it: at the
// time s, where there is (1 - s) times what was and s times what will be, with the speed that flow over
// mass is.  Where there is no mass that takes no time.
//
// On a mesh masses and the flow are spread over triangles as those of a Continuous_flow are.  The lines
// are straight in each triangle then, where they are and when has a closed form, and no mass is lost or
// doubled on the way.  On a cloud the flow is one along arcs, with the same divergence at sites: what
// comes to a site leaves it in the same order, the right of it on the right.
class CGAL_GEODESIC_PROCESSING_EXPORT Streamlines
{
public:
  // On a mesh.  O(n)
  Streamlines(std::shared_ptr<const Surface_arrays> triangles, const Continuous_flow& flow,
              Moved_masses masses);
  // On a cloud: flow  #triangles, whose divergence() is what is missing.  O(n log n)
  Streamlines(std::shared_ptr<const Surface_arrays> triangles, const Operators& operators,
              const Field& flow, Moved_masses masses);
  ~Streamlines();
  Streamlines(Streamlines&&) noexcept;

  // As many grains of equal mass, spread over all that moves; none of nothing.
  std::vector<Streamline_seed> seeds(std::size_t number) const;

  // The line of a grain from the time 0 to 1; from where nothing is before, along the flow as far as it
  // goes.  Where the flow turns in circles it ends without arriving.
  // O(triangles crossed), on a cloud sites and their arcs.
  Streamline operator()(const Streamline_seed& seed) const;

private:
  class Tracer;
  class Mesh_tracer;
  class Cloud_tracer;

  std::unique_ptr<const Tracer> m_tracer;
};

// Makes the lines of best flows what they are without the triangles: shortest paths.
class CGAL_GEODESIC_PROCESSING_EXPORT Line_shortener
{
public:
  explicit Line_shortener(std::shared_ptr<const Surface_arrays> triangles);

  // The line pulled taut.  On a mesh, where that is more than a percent longer than `least`, in the
  // domain's scale, it is compared with the path of a Path_finder, and gives way to that if it is shorter:
  // it may have strayed to the other side of a hill.
  // least  such as the growth of a potential: no path is shorter
  std::vector<Surface_location> operator()(const std::vector<Surface_location>& line,
                                           double lower_bound);

private:
  std::shared_ptr<const Surface_arrays> m_triangles;
  std::optional<Path_finder> m_finder; // once it is needed
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_STREAMLINES_H
