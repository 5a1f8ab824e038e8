// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_TRANSPORT_ARGUMENTS_H
#define GEODESIC_PYTHON_TRANSPORT_ARGUMENTS_H

#include "python/Speeds.h"
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

// Reads a number of refinements; empty for None. More than 30 exceed the limits of every surface.
std::optional<unsigned> refinements(const py::object& object);

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
      : m_speeds(surface, arguments[0], arguments[1])
  {
    read(m_metric, arguments[2], "metric", surface.number_of_points());
    if(Surface_type::is_cloud && !py::object(arguments[3]).is_none())
      reject("A cloud has no faces; pass metrics of surfels as metric.");
    read(m_face_metric, arguments[3], "face_metric", surface.number_of_faces());
    if(m_metric && m_face_metric)
      reject("metric and face_metric cannot be combined.");
    m_refinements = refinements(arguments[4]);
  }

  // Returns the named parameters, which refer to this object. Those without a value are empty
  // optionals, so that solvers are compiled once.
  auto parameters() const
  {
    const auto np = m_speeds.add_to(
        GP::parameters::number_of_refinements(m_refinements).metric_map(map_of<Vertex>(m_metric)));
    if constexpr(Surface_type::is_cloud)
      return np;
    else
      return np.face_metric_map(map_of<Mesh::Face_index>(m_face_metric));
  }

private:
  static void read(std::optional<Numbers>& numbers, const py::object& object,
                   const std::string& name, std::size_t size)
  {
    if(!object.is_none())
      numbers.emplace(object, name, Shape{py::ssize_t(size), 9});
  }
  template <typename Key>
  static std::optional<Matrix_map<Key>> map_of(const std::optional<Numbers>& matrices)
  {
    return matrices ? std::optional(Matrix_map<Key>{&*matrices}) : std::nullopt;
  }

  Speeds<Domain> m_speeds;
  std::optional<Numbers> m_metric, m_face_metric;
  std::optional<unsigned> m_refinements;
};

enum class Transport_method
{
  interior_point,
  alternating_directions,
  weiszfeld
};

// Returns the method of a name. Throws Invalid_argument_error if it is unknown.
Transport_method parse_transport_method(const py::object& name);

// Returns f(tag) for the tag of a method.
template <typename Function>
auto with_transport_method(Transport_method method, const Function& f)
{
  switch(method)
  {
  case Transport_method::alternating_directions:
    return f(GP::Alternating_directions());
  case Transport_method::weiszfeld:
    return f(GP::Weiszfeld());
  case Transport_method::interior_point:
    break;
  }
  return f(GP::Interior_point());
}

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
    return with_transport_method(m_method, [&]([[maybe_unused]] auto tag)
                                 { return solver.template compute<decltype(tag)>(masses..., np); });
  }

private:
  Transport_method m_method;
  double m_tolerance;
  unsigned m_max_iterations;
  bool m_do_normalize, m_do_bound_from_above;
};

} // namespace python

#endif // GEODESIC_PYTHON_TRANSPORT_ARGUMENTS_H
