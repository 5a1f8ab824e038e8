// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Mesh_surface.h"
#include "python/Vector_map.h"
#include "python/transport_arguments.h"

#include <CGAL/Geodesic_processing/Volumetric_metric.h>

namespace python {

namespace {

Kernel::Point_3 point_of(const py::object& object, const std::string& name)
{
  const std::vector<double> p = numbers_of(object, name, 3);
  return {p[0], p[1], p[2]};
}

// Calls a function of Python that returns barycentric coordinates. It is copied and called without
// the GIL.
class Coordinate_function
{
public:
  Coordinate_function(const py::object& function, std::size_t number_of_points)
      : m_function(new py::object(function),
                   [](py::object* object)
                   {
                     py::gil_scoped_acquire gil;
                     delete object;
                   }),
        m_number_of_points(py::ssize_t(number_of_points))
  {
    if(!PyCallable_Check(function.ptr()))
      reject("barycentric_coordinates is not a function.");
  }
  std::vector<double> operator()(const Kernel::Point_3& point) const
  {
    py::gil_scoped_acquire gil;
    py::array_t<double> coordinates(3);
    for(int k = 0; k < 3; ++k)
      coordinates.mutable_at(k) = point[k];
    return numbers_of((*m_function)(coordinates), "The result of barycentric_coordinates",
                      m_number_of_points);
  }

private:
  std::shared_ptr<py::object> m_function;
  py::ssize_t m_number_of_points;
};

// A metric as Python sees it. It is immutable, so that several threads can use it.
class Metric
{
public:
  Metric(std::shared_ptr<Mesh_surface> surface, const py::object& number_of_refinements,
         const py::object& barycentric_coordinates)
      : m_surface(std::move(surface))
  {
    construct(GP::parameters::number_of_refinements(refinements(number_of_refinements)),
              barycentric_coordinates);
  }

  // Returns the cost, the potential and the flow of a transport between two points.
  py::tuple cost(const py::object& from, const py::object& to, const py::object& tolerance,
                 const py::object& maximum, bool do_bound_from_above,
                 const py::object& callback) const
  {
    const Kernel::Point_3 a = point_of(from, "a"), b = point_of(to, "b");
    py::array_t<double> potential(py::ssize_t(m_surface->number_of_points()));
    py::array_t<double> flow = vector_array(m_surface->number_of_faces());
    GP::Earth_movers_cost result;
    Computation computation(callback);
    const auto np =
        GP::parameters::tolerance(number(tolerance, "tolerance"))
            .maximum_number_of_iterations(max_iterations(maximum))
            .do_bound_from_above(do_bound_from_above)
            .potential_map(Output_map<Mesh_surface::Vertex, double>{potential.mutable_data(), 1})
            .flow_map(Vector_output_map<Mesh::Face_index>{flow.mutable_data()})
            .callback(computation.callback());
    computation.run([&] { result = m_metric->cost(a, b, np); });
    return py::make_tuple(cost_tuple(result), potential, flow);
  }

  // Returns the values, the bounds, the numbers of iterations, and which bounds are within the
  // tolerance, one for each point.
  py::tuple costs(const py::object& from, const py::object& points, const py::object& tolerance,
                  const py::object& threads, const py::object& callback) const
  {
    const Kernel::Point_3 a = point_of(from, "a");
    const Numbers numbers(points, "points", {any, 3});
    std::vector<Kernel::Point_3> targets;
    for(std::size_t i = 0; i < numbers.size(); ++i)
      targets.emplace_back(numbers(i, 0), numbers(i, 1), numbers(i, 2));
    std::vector<GP::Earth_movers_cost> found;
    Computation computation(callback);
    const auto np = GP::parameters::tolerance(number(tolerance, "tolerance"))
                        .number_of_threads(parse_threads(threads))
                        .callback(computation.callback());
    computation.run_beside([&] { found = m_metric->costs<CGAL::Parallel_tag>(a, targets, np); });
    const auto size = py::ssize_t(found.size());
    py::array_t<double> values(size), lower(size), upper(size);
    py::array_t<std::int64_t> iterations(size);
    py::array_t<bool> is_converged(size);
    for(py::ssize_t i = 0; i < size; ++i)
    {
      const GP::Earth_movers_cost& cost = found[std::size_t(i)];
      values.mutable_at(i) = cost.value;
      lower.mutable_at(i) = cost.lower;
      upper.mutable_at(i) = cost.upper;
      iterations.mutable_at(i) = cost.number_of_iterations;
      is_converged.mutable_at(i) = cost.is_converged;
    }
    return py::make_tuple(values, lower, upper, iterations, is_converged);
  }

  // Returns the points of a path, and whether it reaches its end.
  py::tuple path(const py::object& from, const py::object& to, const py::object& maximum) const
  {
    const Kernel::Point_3 a = point_of(from, "a"), b = point_of(to, "b");
    const unsigned iterations = max_iterations(maximum);
    std::vector<Kernel::Point_3> points;
    bool has_arrived = false;
    Computation().run(
        [&]
        {
          has_arrived =
              m_metric->write_path(a, b, std::back_inserter(points),
                                   GP::parameters::maximum_number_of_iterations(iterations));
        });
    return py::make_tuple(point_array(points), has_arrived);
  }

private:
  template <typename NamedParameters>
  void construct(const NamedParameters& np, const py::object& barycentric_coordinates)
  {
    if(barycentric_coordinates.is_none())
      return Computation().run([&] { m_metric.emplace(m_surface->domain(), np); });
    const Coordinate_function function(barycentric_coordinates, m_surface->number_of_points());
    Computation().run(
        [&] { m_metric.emplace(m_surface->domain(), np.barycentric_coordinates(function)); });
  }

  std::shared_ptr<Mesh_surface> m_surface;
  std::optional<GP::Volumetric_metric<Mesh>> m_metric;
};

} // namespace

void bind_volumes(py::module_& module, Mesh_class& mesh)
{
  py::class_<Metric>(module, "Volumetric_metric")
      .def("cost", &Metric::cost)
      .def("costs", &Metric::costs)
      .def("path", &Metric::path);
  mesh.def("volumetric_metric",
           [](const std::shared_ptr<Mesh_surface>& self, const py::object& number_of_refinements,
              const py::object& barycentric_coordinates) {
             return std::make_unique<Metric>(self, number_of_refinements, barycentric_coordinates);
           });
}

} // namespace python
