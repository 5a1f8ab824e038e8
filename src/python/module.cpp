// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Surface.h"
#include "python/read_surface.h"

#include "readers/Input_error.h"

#include <algorithm>
#include <string>
#include <thread>
#include <utility>

namespace python {

Distance_method parse_method(const py::object& name)
{
  return choice<Distance_method>(name, "method",
                                 {{"auto", Distance_method::automatic},
                                  {"exact", Distance_method::exact},
                                  {"euclidean", Distance_method::euclidean_front},
                                  {"fast-marching", Distance_method::fast_marching},
                                  {"dijkstra", Distance_method::dijkstra},
                                  {"heat", Distance_method::heat}});
}

unsigned parse_threads(const py::object& threads)
{
  if(threads.is_none())
    return std::max(1u, std::thread::hardware_concurrency());
  const std::size_t result = index(threads, "number of threads", 1025);
  if(result == 0)
    reject("The number of threads is zero.");
  return unsigned(result);
}

unsigned parse_seed(const py::object& seed)
{
  return unsigned(index(seed, "seed", std::size_t(1) << 32));
}

py::object read_surface(const std::string& path)
{
  program::Surface_file file;
  try
  {
    Computation().run(
        [&]
        {
          file = program::read_surface_file(path, {}, std::thread::hardware_concurrency());
          check(file, path);
        });
  }
  catch(const program::Input_error& error)
  {
    throw GP::File_error(error.what());
  }
  return file.number_of_polygons() > 0 ? mesh_of_file(file) : cloud_of_file(file);
}

namespace {

// Registers an exception under the public name.
template <typename Exception>
void bind_exception(py::module_& module, const char* name, const py::handle& base)
{
  py::register_exception<Exception>(module, name, base).attr("__module__") = "geodesic_processing";
}

} // namespace

} // namespace python

PYBIND11_MODULE(_core, module)
{
  using namespace python;
  bind_exception<GP::Invalid_argument_error>(module, "InvalidArgumentError", PyExc_ValueError);
  bind_exception<GP::Unsupported_surface_error>(module, "UnsupportedSurfaceError",
                                                PyExc_ValueError);
  bind_exception<GP::File_error>(
      module, "FileError", py::make_tuple(py::handle(PyExc_OSError), py::handle(PyExc_ValueError)));
  bind_exception<GP::Cancelled>(module, "Cancelled", PyExc_Exception);
  py::class_<Cancellation>(module, "Cancellation")
      .def(py::init<>())
      .def("call", &Cancellation::call)
      .def("cancel", &Cancellation::cancel);
  bind_mesh(module);
  bind_cloud(module);
  module.def("read", &read_surface);
  module.def("output", [](const py::object& out, std::size_t size)
             { return output(out, {py::ssize_t(size)}); });
}
