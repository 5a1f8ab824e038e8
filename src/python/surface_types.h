// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_SURFACE_TYPES_H
#define GEODESIC_PYTHON_SURFACE_TYPES_H

#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/Surfel_domain.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>

namespace python {

namespace GP = CGAL::Geodesic_processing;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// The range of the surfels of a cloud: numbers from 0 to size - 1.
struct Cloud
{
  using iterator = boost::counting_iterator<std::size_t>;

  iterator begin() const { return iterator(0); }
  iterator end() const { return iterator(size); }

  std::size_t size = 0;
};

} // namespace python

template <>
struct CGAL::Geodesic_processing::Surfel_kernel<python::Cloud>
{
  using type = python::Kernel;
};

namespace python {

using Mesh_domain = GP::Soup_domain<Kernel::Point_3>;
using Cloud_domain = GP::Surfel_domain<Cloud>;

} // namespace python

#endif // GEODESIC_PYTHON_SURFACE_TYPES_H
