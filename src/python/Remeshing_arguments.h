// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_REMESHING_ARGUMENTS_H
#define GEODESIC_PYTHON_REMESHING_ARGUMENTS_H

#include "python/Surface.h"
#include "python/edge_maps.h"

namespace python {

// The arguments that all functions for meshes from samples share.
template <typename Domain>
class Remeshing_arguments
{
  using Surface_type = Surface<Domain>;

public:
  // The elements of `arguments` are n, keep_sharp, curve_spacing, relaxation_steps, first, speed,
  // constrained_edges, edge_spacing, seed and callback. Throws Invalid_argument_error if one of
  // them is invalid.
  Remeshing_arguments(const Surface_type& surface, const py::tuple& arguments)
      : m_number(index(arguments[0], "number of vertices", std::size_t(1) << 31)),
        m_number_of_steps(index(arguments[3], "number of steps", std::size_t(1) << 31)),
        m_curve_spacing(number(arguments[2], "curve_spacing")),
        m_first_samples(surface.targets(arguments[4], "first")),
        m_speeds(surface.vertex_speeds(arguments[5])),
        m_edges(constrained_edges(surface, arguments[6], arguments[7])),
        m_seed(parse_seed(arguments[8])), m_computation(arguments[9])
  {
    if(const py::object angle = arguments[1]; !angle.is_none())
      m_sharp_angle = number(angle, "keep_sharp");
  }

  // The requested number of vertices.
  std::size_t number_of_samples() const { return m_number; }

  // Calls f(np) with the named parameters, without the GIL.
  template <typename Function>
  void run(const Function& f)
  {
    Surface_type::with_targets(m_first_samples,
                               [&](const auto& first_samples)
                               {
                                 const auto np = GP::parameters::sharp_angle(m_sharp_angle)
                                                     .curve_spacing(m_curve_spacing)
                                                     .number_of_relaxation_steps(m_number_of_steps)
                                                     .first_samples(first_samples)
                                                     .speed_map(Surface_type::speed_map(m_speeds))
                                                     .random_seed(m_seed)
                                                     .callback(m_computation.callback());
                                 m_computation.run([&] { f(with_edges(np)); });
                               });
  }

private:
  // A cloud has no edges.
  struct No_edges
  {};
  using Edges = std::conditional_t<Surface_type::is_cloud, No_edges, Constrained_edges>;

  static Edges constrained_edges(const Surface_type& surface, const py::object& edges,
                                 const py::object& spacing)
  {
    if constexpr(Surface_type::is_cloud)
    {
      if(!edges.is_none() || !spacing.is_none())
        reject("A cloud has no edges; constrained_edges and edge_spacing need a mesh.");
      return {};
    }
    else
      return {surface, edges, spacing};
  }
  template <typename NamedParameters>
  auto with_edges(const NamedParameters& np) const
  {
    if constexpr(Surface_type::is_cloud)
      return np;
    else
      return np.edge_is_constrained_map(m_edges.is_constrained_map())
          .edge_spacing_map(m_edges.spacing_map());
  }

  std::size_t m_number, m_number_of_steps;
  double m_curve_spacing, m_sharp_angle = 180.;
  std::vector<typename Surface_type::Vertex_or_location> m_first_samples;
  std::optional<Numbers> m_speeds;
  Edges m_edges;
  unsigned m_seed;
  Computation m_computation;
};

} // namespace python

#endif // GEODESIC_PYTHON_REMESHING_ARGUMENTS_H
