// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_TRANSPORT_ARGUMENTS_H
#define GEODESIC_PYTHON_TRANSPORT_ARGUMENTS_H

#include "python/Surface.h"

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace python {

// Not public: Solvers accept masses and densities as property maps of different types. The
// arguments of Python select one of them at run time.
using GP::internal::Mass_distribution;

// Returns a positive number of iterations. Throws Invalid_argument_error if it is not.
unsigned max_iterations(const py::handle& object);

// Returns the tuple of a cost.
py::tuple cost_tuple(const GP::Earth_movers_cost& cost);

// Reads weights, one for each of several objects; by default 1 for each.
std::vector<double> weights_of(const py::object& weights, std::size_t size);

// Returns whether an object is a range of real numbers that are not integers.
bool is_range_of_reals(const py::object& object);

// Reads a mass distribution: whether it is a density, and an array of numbers, or vertices or
// locations.
template <typename Domain>
Mass_distribution mass_distribution(const Surface<Domain>& surface, const py::tuple& pair,
                                    const std::string& name)
{
  using GP::internal::masses; // Not public: This function returns a Mass_distribution.
  const bool is_density = pair[0].cast<bool>();
  const py::object object = pair[1];
  if(!is_density && !is_range_of_reals(object))
    return surface.with_positions(surface.vertices_or_locations(object, name),
                                  [&](const auto& locations)
                                  { return masses(surface.domain(), locations); });
  const Numbers numbers(object, name, {py::ssize_t(surface.number_of_points())});
  const Number_map<typename Surface<Domain>::Vertex> map{&numbers};
  return is_density ? masses(surface.domain(), GP::mass_density(map))
                    : masses(surface.domain(), map);
}

// A readable property map of matrices: the rows of an array of 9 numbers each.
template <typename Key>
struct Matrix_map
{
  using key_type = Key;
  using value_type = Eigen::Matrix3d;
  using reference = Eigen::Matrix3d;
  using category = boost::readable_property_map_tag;

  const Numbers* matrices;

  friend Eigen::Matrix3d get(const Matrix_map& map, Key key)
  {
    Eigen::Matrix3d result;
    for(std::size_t k = 0; k < 9; ++k)
      result(Eigen::Index(k / 3), Eigen::Index(k % 3)) = (*map.matrices)(std::size_t(key), k);
    return result;
  }
};

// The named parameters of the constructors of solvers for transport.
template <typename Domain>
class Transport_setup
{
  using Surface_type = Surface<Domain>;
  using Vertex = typename Surface_type::Vertex;

public:
  // Reads speeds, speeds of faces, metrics, metrics of faces, and the number of refinements.
  Transport_setup(const Surface_type& surface, const py::tuple& arguments)
  {
    const auto points = py::ssize_t(surface.number_of_points());
    const auto faces = py::ssize_t(surface.number_of_faces());
    if(Surface_type::is_cloud &&
       !(py::object(arguments[1]).is_none() && py::object(arguments[3]).is_none()))
      reject("A cloud has no faces; pass speeds and metrics of surfels.");
    read(m_speed, arguments[0], "speed", {points});
    read(m_face_speed, arguments[1], "face_speed", {faces});
    read(m_metric, arguments[2], "metric", {points, 9});
    read(m_face_metric, arguments[3], "face_metric", {faces, 9});
    if(m_speed && m_face_speed)
      reject("speed and face_speed cannot be combined.");
    if(m_metric && m_face_metric)
      reject("metric and face_metric cannot be combined.");
    if(const py::object refinements = arguments[4]; !refinements.is_none())
      m_refinements = unsigned(index(refinements, "number of refinements", 31));
  }

  // Calls f with the named parameters. Those without a value are omitted.
  template <typename Function>
  void with_parameters(const Function& f) const
  {
    const auto np = GP::parameters::do_normalize(false); // the first one of a chain
    if(m_refinements)
      with_speed(np.number_of_refinements(*m_refinements), f);
    else
      with_speed(np, f);
  }

private:
  static void read(std::optional<Numbers>& numbers, const py::object& object,
                   const std::string& name, const Shape& shape)
  {
    if(!object.is_none())
      numbers.emplace(object, name, shape);
  }
  template <typename NamedParameters, typename Function>
  void with_speed(const NamedParameters& np, const Function& f) const
  {
    if constexpr(!Surface_type::is_cloud)
      if(m_face_speed)
        return with_metric(np.face_speed_map(Number_map<Mesh::Face_index>{&*m_face_speed}), f);
    with_metric(np.speed_map(Surface_type::speed_map(m_speed)), f);
  }
  template <typename NamedParameters, typename Function>
  void with_metric(const NamedParameters& np, const Function& f) const
  {
    if constexpr(!Surface_type::is_cloud)
      if(m_face_metric)
        return f(np.face_metric_map(Matrix_map<Mesh::Face_index>{&*m_face_metric}));
    if(m_metric)
      return f(np.metric_map(Matrix_map<Vertex>{&*m_metric}));
    f(np);
  }

  std::optional<Numbers> m_speed, m_face_speed, m_metric, m_face_metric;
  std::optional<unsigned> m_refinements;
};

// The arguments of a query of a solver.
class Transport_query
{
public:
  // Reads the method, the tolerance, the maximum number of iterations, and whether masses are
  // normalized and whether the distance is bounded from above.
  explicit Transport_query(const py::tuple& arguments);

  // Calls solver.compute<Method>(masses..., np).
  template <typename Solver, typename... Masses>
  GP::Earth_movers_cost compute(Solver& solver, Computation& computation,
                                const Masses&... masses) const
  {
    const auto np = GP::parameters::tolerance(m_tolerance)
                        .maximum_number_of_iterations(m_max_iterations)
                        .do_normalize(m_do_normalize)
                        .do_bound_from_above(m_do_bound_from_above)
                        .callback(computation.callback());
    switch(m_method)
    {
    case Method::alternating_directions:
      return solver.template compute<GP::Alternating_directions>(masses..., np);
    case Method::weiszfeld:
      return solver.template compute<GP::Weiszfeld>(masses..., np);
    case Method::interior_point:
      break;
    }
    return solver.template compute<GP::Interior_point>(masses..., np);
  }

private:
  enum class Method
  {
    interior_point,
    alternating_directions,
    weiszfeld
  };
  static Method parse_method(const py::object& name);

  Method m_method;
  double m_tolerance;
  unsigned m_max_iterations;
  bool m_do_normalize, m_do_bound_from_above;
};

} // namespace python

#endif // GEODESIC_PYTHON_TRANSPORT_ARGUMENTS_H
