// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_READ_SURFACE_H
#define GEODESIC_PYTHON_READ_SURFACE_H

#include "readers/Surface_file.h"

#include <pybind11/pybind11.h>

#include <string>

namespace python {

namespace py = pybind11;

// Return the surface of the content of a file. Throw the exceptions of make_domain().
py::object mesh_of_file(const program::Surface_file& file);
py::object cloud_of_file(const program::Surface_file& file);

// Reads a file of any format of the readers: a mesh if it has faces, otherwise a cloud. Throws
// File_error.
py::object read_surface(const std::string& path);

} // namespace python

#endif // GEODESIC_PYTHON_READ_SURFACE_H
