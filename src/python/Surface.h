// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_SURFACE_H
#define GEODESIC_PYTHON_SURFACE_H

#include "python/Computation.h"
#include "python/arrays.h"
#include "python/surface_types.h"

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/geodesic_distance_matrix.h>
#include <CGAL/Geodesic_processing/geodesic_voronoi_diagram.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>
#include <CGAL/Geodesic_processing/write_geodesic_distance_matrix.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace python {

// One class of Python has all methods.
using GP::Distance_method;
using GP::Runtime_method;

// Returns the method of a name. Throws Invalid_argument_error if it is unknown.
Distance_method parse_method(const py::object& name);
// Returns a number of threads; by default, that of the hardware. Throws Invalid_argument_error if it
// is not between 1 and 1024.
unsigned parse_threads(const py::object& threads);
// Returns a seed of random numbers. Throws Invalid_argument_error if it is not between 0 and
// 2^32 - 1.
unsigned parse_seed(const py::object& seed);

// A readable property map of numbers.
template <typename Key>
struct Number_map
{
  using key_type = Key;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const Numbers* numbers;

  friend double get(const Number_map& map, Key key) { return (*map.numbers)(std::size_t(key)); }
};

// A readable property map of labels.
template <typename Key>
struct Label_map
{
  using key_type = Key;
  using value_type = std::int64_t;
  using reference = std::int64_t;
  using category = boost::readable_property_map_tag;

  const Integers* labels;

  friend std::int64_t get(const Label_map& map, Key key) { return (*map.labels)(std::size_t(key)); }
};

// A writable property map: the values are converted to `Number` and written to an array.
template <typename Key, typename Number>
struct Output_map
{
  using key_type = Key;
  using value_type = Number;
  using reference = Number&;
  using category = boost::writable_property_map_tag;

  Number* data;
  std::ptrdiff_t stride; // a number of elements

  friend void put(const Output_map& map, Key key, Number value)
  {
    map.data[std::ptrdiff_t(std::size_t(key)) * map.stride] = value;
  }
};

// Returns a new array of integers, and its map. The largest std::size_t becomes -1.
template <typename Key>
Output_map<Key, std::int64_t> label_map(py::array_t<std::int64_t>& labels)
{
  return {labels.mutable_data(), 1};
}

// Returns the coordinates of points, one row each.
template <typename Point>
py::array_t<double> point_array(const std::vector<Point>& points)
{
  py::array_t<double> result(Shape{py::ssize_t(points.size()), 3});
  double* next = result.mutable_data();
  for(const Point& p : points)
    for(int k = 0; k < 3; ++k)
      *next++ = p[k];
  return result;
}

// Returns a range of numbers.
inline py::array_t<double> number_array(const std::vector<double>& numbers)
{
  return py::array_t<double>(py::ssize_t(numbers.size()), numbers.data());
}

// Returns a range of vertices, faces, surfels or labels. The largest std::size_t becomes -1.
template <typename Range>
py::array_t<std::int64_t> index_array(const Range& range)
{
  py::array_t<std::int64_t> result(py::ssize_t(range.size()));
  std::int64_t* next = result.mutable_data();
  for(const auto element : range)
    *next++ = std::int64_t(std::size_t(element));
  return result;
}

// A surface as Python sees it. It is immutable except for a cached path finder, which it guards.
//
// Domain  Mesh_domain or Cloud_domain
template <typename Domain>
class Surface
{
public:
  using Input = GP::Surface_of<Domain>; // Mesh or Cloud
  using Traits = GP::Source<Input>;
  using Vertex = typename Traits::Vertex;
  using Location = typename Traits::Location;
  using Vertex_or_location = std::variant<Vertex, Location>;
  using Source = GP::Source<Input>;
  static constexpr bool is_cloud = std::is_same_v<Input, Cloud>;
  static constexpr std::size_t number_of_coordinates = is_cloud ? 2 : 3; // of a location

  Surface(Domain domain, std::size_t number_of_points)
      : m_domain(std::move(domain)), m_number_of_points(number_of_points)
  {}

  const Domain& domain() const { return m_domain; }
  std::size_t number_of_points() const { return m_number_of_points; }
  std::size_t number_of_faces() const
  {
    if constexpr(is_cloud)
      return 0;
    else
      return m_domain.number_of_faces();
  }

  // ---- Arguments

  // Reads a vertex, or a pair of a face (a surfel on clouds) and coordinates.
  Vertex_or_location vertex_or_location(const py::handle& object) const
  {
    if(is_integer(object))
      return vertex(index(object, "vertex", m_number_of_points));
    if(!py::isinstance<py::tuple>(object) || py::len(object) != 2)
      reject("A location is neither a vertex nor a pair of a face and barycentric coordinates, or "
             "of a surfel and an offset.");
    const auto pair = py::reinterpret_borrow<py::tuple>(object);
    const std::size_t i = index(pair[0], element_name, number_of_elements());
    const Numbers coordinates(pair[1], is_cloud ? "An offset" : "A list of barycentric coordinates",
                              {py::ssize_t(number_of_coordinates)});
    Location result = location(i);
    for(std::size_t k = 0; k < number_of_coordinates; ++k)
    {
      if(!std::isfinite(coordinates(k)))
        reject("A coordinate of a location is not finite.");
      coordinate(result, k) = coordinates(k);
    }
    (void)m_domain.point(result); // throws if the location is invalid
    return result;
  }

  // Reads a vertex or location, or a non-empty range of them.
  std::vector<Vertex_or_location> vertices_or_locations(const py::object& object,
                                                        const std::string& name) const
  {
    std::vector<Vertex_or_location> result;
    if(is_single(object))
    {
      result.push_back(vertex_or_location(object));
      return result;
    }
    if(py::isinstance<py::array>(object))
    {
      const Integers vertices(object, name, {any});
      result.reserve(vertices.size());
      for(std::size_t i = 0; i < vertices.size(); ++i)
        result.emplace_back(vertex(checked_index(vertices(i), "vertex", m_number_of_points)));
      return result;
    }
    if(py::isinstance<py::str>(object) || py::isinstance<py::bytes>(object) ||
       !py::hasattr(object, "__iter__"))
      reject(name + " are neither vertices nor locations.");
    for(const py::handle item : object)
      result.push_back(vertex_or_location(item));
    if(result.empty())
      reject(name + " are empty.");
    return result;
  }

  // Reads sources with optional offsets, one for each source. A source is a vertex, a location or a
  // polyline.
  std::vector<Source> sources(const py::object& object, const py::object& offsets) const
  {
    std::vector<Source> result;
    if(is_polyline(object))
      result.emplace_back(polyline(object));
    else if(is_single(object) || py::isinstance<py::array>(object) ||
            !py::hasattr(object, "__iter__"))
      result = make_sources(vertices_or_locations(object, "sources"));
    else
      result = source_list(object);
    if(offsets.is_none())
      return result;
    const Numbers values(offsets, "offsets", Shape{py::ssize_t(result.size())});
    for(std::size_t i = 0; i < result.size(); ++i)
      std::visit([&](const auto& position) { result[i] = Source(position, values(i)); },
                 result[i].location());
    return result;
  }
  static std::vector<Source> make_sources(const std::vector<Vertex_or_location>& positions)
  {
    std::vector<Source> result;
    result.reserve(positions.size());
    for(const Vertex_or_location& any_position : positions)
      std::visit([&](const auto& position) { result.emplace_back(position); }, any_position);
    return result;
  }
  // Returns the vertices and locations of sources. Throws Invalid_argument_error if a source is a
  // polyline.
  static std::vector<Vertex_or_location> positions(const std::vector<Source>& sources)
  {
    std::vector<Vertex_or_location> result;
    result.reserve(sources.size());
    for(const Source& source : sources)
      if(const Vertex* vertex = std::get_if<Vertex>(&source.location()))
        result.emplace_back(*vertex);
      else if(std::get<1>(source.location()).size() == 1)
        result.emplace_back(std::get<1>(source.location()).front());
      else
        reject("targets are required if a source is a polyline.");
    return result;
  }
  std::vector<Vertex> all_vertices() const
  {
    std::vector<Vertex> result;
    result.reserve(m_number_of_points);
    for(std::size_t i = 0; i < m_number_of_points; ++i)
      result.push_back(vertex(i));
    return result;
  }

  // Reads targets; empty for None. `name` is that of the argument.
  std::vector<Vertex_or_location> targets(const py::object& object,
                                          const std::string& name = "targets") const
  {
    return object.is_none() ? std::vector<Vertex_or_location>()
                            : vertices_or_locations(object, name);
  }
  // Calls f with a vector of vertices, or with one of locations. Throws Invalid_argument_error if
  // there are both. `name` is that of the argument.
  template <typename Function>
  static void with_targets(const std::vector<Vertex_or_location>& positions, const Function& f,
                           const std::string& name = "targets")
  {
    std::vector<Vertex> vertices;
    std::vector<Location> locations;
    for(const Vertex_or_location& position : positions)
      if(std::holds_alternative<Vertex>(position))
        vertices.push_back(std::get<Vertex>(position));
      else
        locations.push_back(std::get<Location>(position));
    if(!vertices.empty() && !locations.empty())
      reject(name + " are vertices and locations. They must be either vertices or locations.");
    if(locations.empty())
      return f(vertices);
    f(locations);
  }

  // Calls f with a vector of vertices if all positions are vertices, otherwise with a vector of
  // locations. Throws Invalid_argument_error if there are both and a vertex has no face.
  template <typename Function>
  auto with_positions(const std::vector<Vertex_or_location>& positions, const Function& f) const
  {
    std::vector<Vertex> vertices;
    for(const Vertex_or_location& position : positions)
      if(const Vertex* const vertex = std::get_if<Vertex>(&position))
        vertices.push_back(*vertex);
    if(vertices.size() == positions.size())
      return f(vertices);
    std::vector<Location> locations;
    for(const Vertex_or_location& position : positions)
      if(const Vertex* const vertex = std::get_if<Vertex>(&position))
        locations.push_back(location_of_vertex(*vertex));
      else
        locations.push_back(std::get<Location>(position));
    return f(locations);
  }

  // ---- Results

  // Returns the arrays of a range of locations: faces or surfels, and coordinates. The face of an
  // isolated vertex is -1.
  static py::tuple location_arrays(const std::vector<Location>& locations)
  {
    const auto size = py::ssize_t(locations.size());
    py::array_t<std::int64_t> indices(size);
    py::array_t<double> coordinates(Shape{size, py::ssize_t(number_of_coordinates)});
    std::int64_t* next_index = indices.mutable_data();
    double* next_coordinate = coordinates.mutable_data();
    for(Location location : locations)
    {
      *next_index++ = element(location);
      for(std::size_t k = 0; k < number_of_coordinates; ++k)
        *next_coordinate++ = coordinate(location, k);
    }
    return py::make_tuple(indices, coordinates);
  }

  // Returns points, indices, coordinates, length, lower bound and distance of a path.
  template <typename Path>
  static py::tuple path_arrays(const Path& path)
  {
    const py::tuple locations = location_arrays(path.locations);
    return py::make_tuple(point_array(path.points), locations[0], locations[1], path.length,
                          path.lower, path.front_distance);
  }

  // ---- Queries

  // Returns the location closest to each point.
  py::tuple locate(const py::object& points)
  {
    const Numbers numbers(points, "points", {any, 3});
    std::vector<Location> result;
    Computation computation;
    const auto callback = computation.callback();
    computation.run(
        [&]
        {
          std::call_once(m_locator_flag, [&] { m_locator.emplace(m_domain); });
          result.reserve(numbers.size());
          for(std::size_t i = 0; i < numbers.size(); ++i)
          {
            if(!callback(double(i) / double(numbers.size())))
              throw GP::Cancelled();
            result.push_back(
                (*m_locator)(Kernel::Point_3(numbers(i, 0), numbers(i, 1), numbers(i, 2))));
          }
        });
    return location_arrays(result);
  }

  // Returns the points of locations.
  py::array_t<double> points(const py::object& locations) const
  {
    std::vector<Kernel::Point_3> result;
    for(const Vertex_or_location& position : vertices_or_locations(locations, "locations"))
      if(std::holds_alternative<Location>(position))
        result.push_back(m_domain.point(std::get<Location>(position)));
      else
        result.push_back(point(std::get<Vertex>(position)));
    return point_array(result);
  }
  // Returns the points of all vertices.
  py::array_t<double> vertices() const
  {
    py::array_t<double> result(Shape{py::ssize_t(m_number_of_points), 3});
    double* next = result.mutable_data();
    Computation().run(
        [&]
        {
          for(std::size_t i = 0; i < m_number_of_points; ++i)
          {
            const Kernel::Point_3 p = point(vertex(i));
            for(int k = 0; k < 3; ++k)
              *next++ = p[k];
          }
        });
    return result;
  }

  // Calls f with the path finder, which the first call constructs. No other thread uses it at the
  // same time. Requires that the GIL is not held.
  template <typename Function>
  void use_finder(const Function& f)
  {
    const std::lock_guard<Guard> lock(m_finder_guard);
    if(!m_finder)
      m_finder.emplace(m_domain);
    f(*m_finder);
  }

  // Returns the paths between pairs of vertices or locations.
  py::list paths(const py::object& pairs, const py::object& callback)
  {
    std::vector<std::array<Vertex_or_location, 2>> ends;
    if(!py::hasattr(pairs, "__iter__"))
      reject("pairs are not a list of pairs of vertices or locations.");
    for(const py::handle pair : pairs)
    {
      if(!py::isinstance<py::sequence>(pair) || py::len(pair) != 2)
        reject("pairs contain an element that is not a pair of vertices or locations.");
      const auto two = py::reinterpret_borrow<py::sequence>(pair);
      ends.push_back(
          {vertex_or_location(py::object(two[0])), vertex_or_location(py::object(two[1]))});
    }
    if(ends.empty())
      reject("pairs are empty.");
    py::list result;
    Computation computation(callback);
    for(std::size_t i = 0; i < ends.size(); ++i)
    {
      const std::function<bool(double)> progress =
          [fraction = double(i) / double(ends.size()), report = computation.callback()](double)
      { return report(fraction); };
      GP::Geodesic_path<Input> path;
      computation.run([&] { path = this->path(ends[i], progress); });
      result.append(path_arrays(path));
    }
    return result;
  }

  // Returns the matrix of distances: `out`, or a new array. Rows are sources or, if they are None,
  // all vertices or their regions. Columns are targets or, if they are None, the sources, or the
  // regions of all vertices.
  py::array distance_matrix(const py::object& source_list, const py::object& target_list,
                            const py::object& maximum, const py::object& region_labels,
                            bool do_average, const py::object& type, const py::object& out,
                            const py::object& method, const py::object& threads,
                            const py::object& callback) const
  {
    const auto kind = parse_method(method);
    const double maximum_distance = number(maximum, "max_distance");
    const unsigned number_of_threads = parse_threads(threads);
    std::optional<Integers> regions;
    std::size_t number_of_regions = 0;
    if(!region_labels.is_none())
    {
      regions.emplace(region_labels, "regions", Shape{py::ssize_t(m_number_of_points)});
      number_of_regions = count_regions(*regions);
    }
    using Regions = std::optional<Label_map<Vertex>>;
    const auto regions_of = [&](const py::object& list)
    { return regions && list.is_none() ? Regions(Label_map<Vertex>{&*regions}) : Regions(); };
    const Regions row_regions = regions_of(source_list), column_regions = regions_of(target_list);
    if(regions && !row_regions && !column_regions)
      reject("regions cannot be combined with sources and targets.");

    const std::vector<Vertex> vertices = all_vertices();
    const std::vector<Source> given =
        source_list.is_none() ? std::vector<Source>() : sources(source_list, py::none());
    const auto columns = !target_list.is_none() ? targets(target_list)
                         : given.empty() || column_regions
                             ? std::vector<Vertex_or_location>(vertices.begin(), vertices.end())
                             : positions(given);
    const std::size_t number_of_rows = row_regions     ? number_of_regions
                                       : given.empty() ? vertices.size()
                                                       : given.size();
    const py::array result =
        matrix_output(out,
                      {py::ssize_t(number_of_rows),
                       py::ssize_t(column_regions ? number_of_regions : columns.size())},
                      type);

    Computation computation(callback);
    const auto write = [&](const auto& from, const auto& np)
    {
      if(py::isinstance<py::array_t<double>>(result))
        write_matrix<double>(computation, from, result, np);
      else
        write_matrix<float>(computation, from, result, np);
    };
    const auto write_rows = [&](const auto& np)
    {
      if(given.empty())
        write(vertices, np.row_region_map(row_regions));
      else
        write(given, np);
    };
    with_targets(columns,
                 [&](const auto& positions)
                 {
                   const auto np = GP::parameters::method(kind)
                                       .targets(positions)
                                       .maximum_distance(maximum_distance)
                                       .do_average_regions(do_average)
                                       .number_of_threads(number_of_threads)
                                       .callback(computation.callback());
                   if constexpr(std::is_same_v<decltype(positions), const std::vector<Vertex>&>)
                     write_rows(np.region_map(column_regions));
                   else
                     write_rows(np);
                 });
    return result;
  }

  // Returns the entries, their columns and the beginnings of the rows of the sparse matrix of the
  // distances between vertices, or between all vertices for None.
  py::tuple sparse_distance_matrix(const py::object& vertex_list, const py::object& maximum,
                                   const py::object& method, const py::object& threads,
                                   const py::object& callback) const
  {
    const auto kind = parse_method(method);
    const double maximum_distance = number(maximum, "max_distance");
    const unsigned number_of_threads = parse_threads(threads);
    std::vector<Vertex> vertices;
    if(vertex_list.is_none())
      vertices = all_vertices();
    else
      for(const Vertex_or_location& position : vertices_or_locations(vertex_list, "vertices"))
        if(const Vertex* const vertex = std::get_if<Vertex>(&position))
          vertices.push_back(*vertex);
        else
          reject("vertices contain a location. A sparse matrix is one of vertices.");
    Computation computation(callback);
    auto result = std::make_unique<Eigen::SparseMatrix<double, Eigen::RowMajor>>();
    const auto np = GP::parameters::method(kind)
                        .number_of_threads(number_of_threads)
                        .callback(computation.callback());
    computation.run_beside(
        [&]
        {
          *result = GP::sparse_geodesic_distance_matrix<Runtime_method, CGAL::Parallel_tag>(
              m_domain, vertices, maximum_distance, np);
        });
    // The arrays refer to the matrix.
    auto* const matrix = result.release();
    const py::capsule owner(
        matrix, [](void* data)
        { delete static_cast<Eigen::SparseMatrix<double, Eigen::RowMajor>*>(data); });
    const auto size = py::ssize_t(matrix->nonZeros());
    return py::make_tuple(py::array_t<double>(size, matrix->valuePtr(), owner),
                          py::array_t<int>(size, matrix->innerIndexPtr(), owner),
                          py::array_t<int>(matrix->rows() + 1, matrix->outerIndexPtr(), owner));
  }

  // Returns the locations of samples, the covering radius after each of them, and the sample of
  // each vertex.
  py::tuple farthest_points(const py::object& count, const py::object& radius,
                            const py::object& first, const py::object& method,
                            const py::object& speed, const py::object& callback) const
  {
    std::vector<Location> samples;
    const auto [radii, labels] = sample(count, radius, first, method, speed, callback,
                                        [&](std::size_t size, const auto& np) {
                                          GP::farthest_point_sampling<Runtime_method>(
                                              m_domain, size, std::back_inserter(samples), np);
                                        });
    const py::tuple locations = location_arrays(samples);
    return py::make_tuple(locations[0], locations[1], radii, labels);
  }
  // Returns the same for samples at vertices.
  py::tuple farthest_vertices(const py::object& count, const py::object& radius,
                              const py::object& first, const py::object& method,
                              const py::object& speed, const py::object& callback) const
  {
    std::vector<Vertex> samples;
    const auto [radii, labels] = sample(count, radius, first, method, speed, callback,
                                        [&](std::size_t size, const auto& np) {
                                          GP::farthest_vertex_sampling<Runtime_method>(
                                              m_domain, size, std::back_inserter(samples), np);
                                        });
    return py::make_tuple(index_array(samples), radii, labels);
  }

  // ---- For solvers

  // Reads the speeds of vertices; empty for None.
  std::optional<Numbers> vertex_speeds(const py::object& speed) const
  {
    if(speed.is_none())
      return std::nullopt;
    return Numbers(speed, "speed", {py::ssize_t(m_number_of_points)});
  }
  static std::optional<Number_map<Vertex>> speed_map(const std::optional<Numbers>& speeds)
  {
    if(!speeds)
      return std::nullopt;
    return Number_map<Vertex>{&*speeds};
  }

  static Vertex vertex(std::size_t i)
  {
    if constexpr(is_cloud)
      return i;
    else
      return Vertex(typename Mesh::size_type(i));
  }

  // Returns whether an object is a vertex or a location, and not a range. A tuple of two integers
  // is a range of vertices.
  static bool is_single(const py::object& object)
  {
    if(is_integer(object))
      return true;
    if(!py::isinstance<py::tuple>(object) || py::len(object) != 2)
      return false;
    const auto pair = py::reinterpret_borrow<py::tuple>(object);
    return is_integer(pair[0]) && is_row(pair[1]);
  }

private:
  // Reads the arguments of farthest point sampling, and calls f(size, np). Returns the covering
  // radii and the labels of vertices.
  template <typename Function>
  std::pair<py::array_t<double>, py::array_t<std::int64_t>>
  sample(const py::object& count, const py::object& radius, const py::object& first,
         const py::object& method, const py::object& speed, const py::object& callback,
         const Function& f) const
  {
    const auto kind = parse_method(method);
    std::size_t size = std::numeric_limits<std::size_t>::max();
    if(!count.is_none())
      size = index(count, "number of samples", std::size_t(1) << 31);
    else if(radius.is_none())
      reject("n or radius is required.");
    const double covering_radius = radius.is_none() ? 0. : number(radius, "radius");
    const std::optional<Numbers> speeds = vertex_speeds(speed);
    std::vector<double> radii;
    py::array_t<std::int64_t> labels{Shape{py::ssize_t(m_number_of_points)}};
    Computation computation(callback);
    with_targets(targets(first, "first"),
                 [&](const auto& first_samples)
                 {
                   const auto np = GP::parameters::method(kind)
                                       .covering_radius(covering_radius)
                                       .first_samples(first_samples)
                                       .covering_radius_output(std::back_inserter(radii))
                                       .source_label_map(label_map<Vertex>(labels))
                                       .speed_map(speed_map(speeds))
                                       .callback(computation.callback());
                   computation.run([&] { f(size, np); });
                 });
    return {number_array(radii), labels};
  }

  Kernel::Point_3 point(Vertex vertex) const
  {
    if constexpr(is_cloud)
      return m_domain.point({vertex, {0., 0.}});
    else
      return m_domain.point(vertex);
  }

  static constexpr const char* element_name = is_cloud ? "surfel" : "face";

  // Returns whether an object is a Polyline, a class of Python.
  static bool is_polyline(const py::handle& object)
  {
    return py::isinstance(object,
                          py::module_::import("geodesic_processing._types").attr("Polyline"));
  }
  // Reads a Polyline.
  typename Source::Polyline polyline(const py::handle& object) const
  {
    typename Source::Polyline result;
    for(const py::handle item : object)
      result.push_back(std::get<Location>(vertex_or_location(item)));
    if(result.empty())
      reject("A polyline has no location.");
    return result;
  }
  // Reads a range that is not an array.
  std::vector<Source> source_list(const py::object& object) const
  {
    if(py::isinstance<py::str>(object) || py::isinstance<py::bytes>(object))
      reject("sources are neither vertices nor locations nor polylines.");
    std::vector<Source> result;
    for(const py::handle item : object)
      if(is_polyline(item))
        result.emplace_back(polyline(item));
      else
        std::visit([&](const auto& position) { result.emplace_back(position); },
                   vertex_or_location(item));
    if(result.empty())
      reject("sources are empty.");
    return result;
  }

  // Returns the number of regions of a label for each vertex. Throws Invalid_argument_error if
  // there is none, or if a label is not smaller than the number of vertices.
  static std::size_t count_regions(const Integers& labels)
  {
    std::int64_t last = -1;
    for(std::size_t i = 0; i < labels.size(); ++i)
      last = std::max(last, labels(i));
    if(last < 0)
      reject("regions contain no vertex.");
    return checked_index(last, "region", labels.size()) + 1;
  }

  template <typename Number, typename From, typename NamedParameters>
  void write_matrix(Computation& computation, const From& from, py::array result,
                    const NamedParameters& np) const
  {
    using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<Matrix> matrix(static_cast<Number*>(result.mutable_data()), result.shape(0),
                              result.shape(1));
    computation.run_beside(
        [&]
        {
          GP::write_geodesic_distance_matrix<Runtime_method, CGAL::Parallel_tag>(m_domain, from,
                                                                                 matrix, np);
        });
  }

  GP::Geodesic_path<Input> path(const std::array<Vertex_or_location, 2>& ends,
                                const std::function<bool(double)>& callback)
  {
    if(!callback(0.))
      throw GP::Cancelled();
    GP::Geodesic_path<Input> result;
    use_finder(
        [&](auto& finder)
        {
          result = std::visit([&](const auto& a, const auto& b)
                              { return finder(a, b, GP::parameters::callback(callback)); },
                              ends[0], ends[1]);
        });
    return result;
  }

  std::size_t number_of_elements() const
  {
    return is_cloud ? m_number_of_points : number_of_faces();
  }
  static Location location(std::size_t i)
  {
    if constexpr(is_cloud)
      return {i, {0., 0.}};
    else
      return {Mesh::Face_index(Mesh::size_type(i)), {0., 0., 0.}};
  }
  Location location_of_vertex(Vertex v) const
  {
    if constexpr(is_cloud)
      return location(v);
    else
    {
      // Not public: No public function returns the location of a vertex.
      const Location result = m_domain.outer(m_domain.inner_vertex(v));
      if(result.first == Mesh::null_face())
        reject("The vertex " + std::to_string(std::size_t(v)) +
               " has no face. It cannot be combined with other locations.");
      return result;
    }
  }
  static double& coordinate(Location& location, std::size_t k)
  {
    if constexpr(is_cloud)
      return location.offset[k];
    else
      return location.second[k];
  }
  // Returns the surfel or face of a location; -1 for a vertex without faces.
  static std::int64_t element(const Location& location)
  {
    if constexpr(is_cloud)
      return std::int64_t(location.surfel);
    else
      return location.first == Mesh::null_face() ? -1 : std::int64_t(std::size_t(location.first));
  }

  Domain m_domain;
  std::size_t m_number_of_points;
  std::once_flag m_locator_flag;
  std::optional<GP::Surface_locator<Input>> m_locator;
  Guard m_finder_guard;
  std::optional<GP::Geodesic_path_finder<Input>> m_finder;
};

// Defined in mesh.cpp and cloud.cpp, which are compiled separately.
void bind_mesh(py::module_& module);
void bind_cloud(py::module_& module);

} // namespace python

#endif // GEODESIC_PYTHON_SURFACE_H
