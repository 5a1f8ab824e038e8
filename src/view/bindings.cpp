// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Queries.h"

// Not public: The test of the page checks the predicates that all queries depend on.
#include "core/exact_predicates.h"
#include "readers/Input_error.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <chrono>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>

// The functions that the worker of the page calls. Each returns an object. If the query failed, it
// has the member `error`, a sentence.
namespace view {

namespace {

using emscripten::val;
namespace GP = CGAL::Geodesic_processing;

std::unique_ptr<const program::Surface> surface; // exists as long as its queries
std::unique_ptr<Queries> queries;

// Returns a copy of an array as a typed array.
template <typename Number>
val typed_array(const std::vector<Number>& numbers)
{
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}
// Returns the coordinates of points as one Float64Array.
template <std::size_t dimension>
val typed_array(const std::vector<std::array<double, dimension>>& points)
{
  const double* const first = points.empty() ? nullptr : points.front().data();
  return val(emscripten::typed_memory_view(dimension * points.size(), first)).call<val>("slice");
}

// Calls f with the object that it returns, and converts exceptions to its member `error`.
template <typename Function>
val guarded(const Function& f)
{
  val result = val::object();
  try
  {
    f(result);
  }
  catch(const GP::Cancelled&)
  {
    result.set("error", "The query was ended, because it took too long.");
  }
  catch(const std::bad_alloc&)
  {
    result.set("error", "There is not enough memory.");
  }
  catch(const std::exception& error)
  {
    result.set("error", std::string(error.what()));
  }
  return result;
}

Place to_place(const val& object)
{
  Place place;
  place.is_in_face = object.hasOwnProperty("face");
  place.element = object[place.is_in_face ? "face" : "vertex"].as<std::uint32_t>();
  if(place.is_in_face)
    for(std::size_t k = 0; k < 3; ++k)
      place.weights[k] = object["weights"][k].as<double>();
  return place;
}
val to_object(const Place& place)
{
  val object = val::object();
  object.set(place.is_in_face ? "face" : "vertex", double(place.element));
  if(place.is_in_face)
    object.set("weights",
               typed_array(std::vector<double>(place.weights.begin(), place.weights.end())));
  return object;
}
std::vector<Place> to_places(const val& list)
{
  std::vector<Place> result;
  for(unsigned i = 0, size = list["length"].as<unsigned>(); i < size; ++i)
    result.push_back(to_place(list[i]));
  return result;
}
Point to_point(const val& list)
{
  return {list[0].as<double>(), list[1].as<double>(), list[2].as<double>()};
}

// Returns a callback that ends a computation after a number of seconds.
Callback deadline(double seconds)
{
  using Clock = std::chrono::steady_clock;
  return [=, begin = Clock::now()](double)
  { return std::chrono::duration<double>(Clock::now() - begin).count() < seconds; };
}

Queries& loaded()
{
  if(!queries)
    throw std::runtime_error("No surface is loaded.");
  return *queries;
}

// Reads a file of the virtual file system, repairs the surface and prepares its queries. If it
// fails, the last surface remains.
val load(const std::string& filename)
{
  return guarded(
      [&](val& result)
      {
        auto loaded = std::make_unique<const program::Surface>(
            program::repair(program::read_surface_file(filename), filename));
        queries = loaded->is_mesh() ? mesh_queries(*loaded) : cloud_queries(*loaded);
        surface = std::move(loaded);
        result.set("isMesh", surface->is_mesh());
        result.set("isRepaired", surface->is_repaired);
        result.set("points", typed_array(surface->file.points));
        result.set("normals", typed_array(surface->file.normals));
        result.set("triangles", typed_array(queries->triangles()));
      });
}

val distances(const val& sources, const std::string& method, double limit, double seconds)
{
  return guarded(
      [&](val& result)
      {
        result.set("values", typed_array(loaded().distances(to_places(sources), method, limit,
                                                            deadline(seconds))));
      });
}

// Returns polylines as `points` and, for each, the number of points up to its end.
val isolines(const val& values, const val& isovalues)
{
  return guarded(
      [&](val& result)
      {
        std::vector<Point> points;
        std::vector<std::uint32_t> ends;
        for(const auto& line :
            loaded().isolines(emscripten::convertJSArrayToNumberVector<double>(values),
                              emscripten::convertJSArrayToNumberVector<double>(isovalues)))
        {
          points.insert(points.end(), line.begin(), line.end());
          ends.push_back(static_cast<std::uint32_t>(points.size()));
        }
        result.set("points", typed_array(points));
        result.set("ends", typed_array(ends));
      });
}

val path(const val& from, const val& to, bool is_shortest)
{
  return guarded(
      [&](val& result)
      {
        const Path path = loaded().path(to_place(from), to_place(to), is_shortest);
        result.set("points", typed_array(path.points));
        result.set("length", path.length);
      });
}

val voronoi(const val& seeds, double seconds)
{
  return guarded(
      [&](val& result)
      {
        const Cells cells = loaded().voronoi(to_places(seeds), deadline(seconds));
        result.set("labels", typed_array(cells.labels));
        result.set("points", typed_array(cells.points));
        result.set("triangles", typed_array(cells.corners));
        result.set("triangleLabels", typed_array(cells.triangle_labels));
      });
}

val samples(unsigned number, double seconds)
{
  return guarded(
      [&](val& result)
      {
        const Samples samples = loaded().samples(number, deadline(seconds));
        val places = val::array();
        for(const Place& place : samples.places)
          places.call<void>("push", to_object(place));
        result.set("places", places);
        result.set("points", typed_array(samples.points));
        result.set("radii", typed_array(samples.radii));
      });
}

val decal(const val& center, const val& up, double width, double height)
{
  return guarded(
      [&](val& result)
      {
        const Decal decal = loaded().decal(to_place(center), to_point(up), width, height);
        result.set("faces", typed_array(decal.faces));
        result.set("cornerUv", typed_array(decal.corner_uv));
        result.set("vertices", typed_array(decal.vertices));
        result.set("vertexUv", typed_array(decal.vertex_uv));
      });
}

// Returns the orientation of each triangle in the plane, given by six coordinates.
val orientations(const val& coordinates)
{
  return guarded(
      [&](val& result)
      {
        const auto x = emscripten::convertJSArrayToNumberVector<double>(coordinates);
        std::vector<std::int8_t> signs;
        for(std::size_t i = 0; i + 6 <= x.size(); i += 6)
          signs.push_back(static_cast<std::int8_t>(GP::internal::orientation(
              {x[i], x[i + 1]}, {x[i + 2], x[i + 3]}, {x[i + 4], x[i + 5]})));
        result.set("signs", typed_array(signs));
      });
}

} // namespace

EMSCRIPTEN_BINDINGS(viewer)
{
  emscripten::function("load", &load);
  emscripten::function("distances", &distances);
  emscripten::function("isolines", &isolines);
  emscripten::function("path", &path);
  emscripten::function("voronoi", &voronoi);
  emscripten::function("samples", &samples);
  emscripten::function("decal", &decal);
  emscripten::function("orientations", &orientations);
}

} // namespace view
