// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_ISOLINE_TUPLES_H
#define GEODESIC_PYTHON_ISOLINE_TUPLES_H

#include "python/Mesh_surface.h"

#include <CGAL/Geodesic_processing/isolines.h>

#include <vector>

namespace python {

// Returns for each isoline the value, whether it is closed, points, faces, barycentric coordinates
// and length.
inline py::list isoline_tuples(const std::vector<GP::Isoline<Mesh>>& lines)
{
  py::list result;
  for(const auto& line : lines)
  {
    const py::tuple locations = Mesh_surface::location_arrays(line.locations);
    result.append(py::make_tuple(line.value, line.is_closed, point_array(line.points), locations[0],
                                 locations[1], line.length));
  }
  return result;
}

} // namespace python

#endif // GEODESIC_PYTHON_ISOLINE_TUPLES_H
