// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/transport_arguments.h"

#include <limits>

namespace python {

unsigned max_iterations(const py::handle& object)
{
  const std::size_t result =
      index(object, "maximum number of iterations", std::numeric_limits<int>::max());
  if(result == 0)
    reject("The maximum number of iterations is zero.");
  return unsigned(result);
}

std::optional<unsigned> refinements(const py::object& object)
{
  if(object.is_none())
    return std::nullopt;
  return unsigned(index(object, "number of refinements", 31));
}

py::tuple cost_tuple(const GP::Earth_movers_cost& cost)
{
  return py::make_tuple(cost.value, cost.lower, cost.upper, cost.upper_continuous, cost.estimate,
                        cost.number_of_iterations, cost.residual, cost.is_converged);
}

std::vector<double> weights_of(const py::object& weights, std::size_t size)
{
  return weights.is_none() ? std::vector<double>(size, 1.)
                           : numbers_of(weights, "weights", py::ssize_t(size));
}

bool is_range_of_reals(const py::object& object)
{
  if(py::isinstance<py::array>(object))
    return py::reinterpret_borrow<py::array>(object).dtype().kind() == 'f';
  return is_row(object) && py::len(object) > 0 &&
         PyFloat_Check(py::object(object[py::int_(0)]).ptr());
}

Transport_query::Transport_query(const py::tuple& arguments)
    : m_method(parse_transport_method(arguments[0])),
      m_tolerance(number(arguments[1], "tolerance")),
      m_max_iterations(max_iterations(arguments[2])), m_do_normalize(arguments[3].cast<bool>()),
      m_do_bound_from_above(arguments[4].cast<bool>())
{}

Transport_method parse_transport_method(const py::object& name)
{
  return choice<Transport_method>(name, "method",
                                  {{"interior-point", Transport_method::interior_point},
                                   {"admm", Transport_method::alternating_directions},
                                   {"weiszfeld", Transport_method::weiszfeld}});
}

} // namespace python
