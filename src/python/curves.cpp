// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Mesh_surface.h"

#include <CGAL/Geodesic_processing/isolines.h>

namespace python {

namespace {

py::list isolines(const Mesh_surface& surface, const py::object& values, const py::object& levels,
                  bool do_fit_circles)
{
  const Numbers value_array(values, "values", {py::ssize_t(surface.number_of_points())});
  const Numbers level_array(levels, "levels", {any});
  std::vector<double> isovalues;
  for(std::size_t i = 0; i < level_array.size(); ++i)
    isovalues.push_back(level_array(i));
  std::vector<GP::Isoline<Mesh>> lines;
  Computation().run(
      [&]
      {
        GP::isolines(surface.domain(), Number_map<Mesh_surface::Vertex>{&value_array}, isovalues,
                     std::back_inserter(lines), GP::parameters::do_fit_circles(do_fit_circles));
      });
  py::list result;
  for(const auto& line : lines)
  {
    const py::tuple locations = Mesh_surface::location_arrays(line.locations);
    result.append(py::make_tuple(line.value, line.is_closed, point_array(line.points), locations[0],
                                 locations[1], line.length));
  }
  return result;
}

} // namespace

void bind_curves(Mesh_class& mesh) { mesh.def("isolines", &isolines); }

} // namespace python
