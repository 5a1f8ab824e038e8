// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_COMMAND_UTILITIES_H
#define GEODESIC_PROGRAM_COMMANDS_COMMAND_UTILITIES_H

#include "app/Command.h"
#include "app/Job.h"
#include "io/Output_file.h"

#include <CGAL/Geodesic_processing.h>

#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// Utilities shared by the commands: conversion from command-line text to types of the library.
namespace program {

namespace GP = CGAL::Geodesic_processing;

template <typename Surface_type>
inline constexpr bool is_mesh = std::is_same_v<Surface_type, Mesh>;

// Returns the descriptor of a vertex or surfel with the given index.
template <typename Surface_type>
typename GP::Source<Surface_type>::Vertex vertex_at(std::size_t number)
{
  if constexpr(is_mesh<Surface_type>)
    return Mesh::Vertex_index(static_cast<Mesh::size_type>(number));
  else
    return Cloud::Index(number);
}

// Checks the name of a method, which must not be a metric. Throws Usage_error that names the option
// if it is unknown, and Input_error if the surface does not support the method.
void check_method(const std::string& method, const std::string& option = "--method");
void check_method(const std::string& method, const Surface& surface);

// Checks the name of a method or metric. Throws Usage_error if it is unknown.
void check_method_or_metric(const std::string& method);

// Solvers and maps have the method as template argument, and each command would be compiled once for
// each of six methods.
using GP::Distance_method;
using GP::Runtime_method;
// Not public: the methods of logarithmic maps.
using GP::internal::Log_kind;
using GP::internal::Log_method;

// Converts the name of a method that passed check_method().
Distance_method to_method(const std::string& method);

// Announces the memory that a solver of distances on a mesh needs besides its domain, or throws
// Input_error if it is not available.
void check_memory(const Job& job, const std::string& method);

// Solver whose method is selected at run time
template <typename Surface_type>
using Distance_solver = GP::Geodesic_distance_solver<Surface_type, Runtime_method>;

// Domains of all commands that compute distances. The mesh may be that of the job's surface, whose
// domain exists already.
using Mesh_domain = GP::Mesh_domain<Mesh>;
using Cloud_domain = GP::Surfel_domain<Cloud>;
Cloud_domain make_domain(const Cloud& cloud, const Job& job);

// Calls f with the domain of the mesh or the cloud of a job.
template <typename Function>
void visit_domain(const Job& job, Function f)
{
  if(job.surface().is_mesh())
    return f(Mesh_domain(*job.surface().domain));
  const Cloud cloud = make_cloud(job.surface());
  f(make_domain(cloud, job));
}

// Returns whether a method is one of the optimal transport or comparison metrics.
bool is_metric(const std::string& method);

// Throws Usage_error if a basis size is given and the method has no basis.
void check_basis(const std::string& method, const std::optional<std::size_t>& basis_size);

// Calls f with the metric that the name selects.
template <typename Surface_type, typename Domain, typename Function>
void with_metric(const Domain& domain, const std::string& method,
                 const std::optional<std::size_t>& basis_size, Job& job, Function f)
{
  if(method == "biharmonic")
    return f(GP::Biharmonic_metric<Surface_type>(domain));
  const GP::Transport_metric<Surface_type> metric(domain,
                                                  method == "emd" ? basis_size.value_or(100) : 0);
  job.result()["basis"] = metric.basis_size();
  f(metric);
}

inline Kernel::Point_3 parse_point_3(const std::string& text, const std::string& option)
{
  const Point p = parse_point(text, option);
  return {p[0], p[1], p[2]};
}

// Returns the location on the surface that is closest to the point "x,y,z".
template <typename Domain>
typename Domain::Location locate(const Domain& domain, const std::string& text,
                                 const std::string& option);

// Returns the point of a location on the surface.
template <typename Domain>
Point location_point(const Domain& domain, const typename Domain::Location& location)
{
  return coordinates(domain.point(location));
}

// Returns the corners of triangles on which a picture of a cloud draws lines. The triangles are a
// subset in which each directed halfedge occurs at most once.
std::vector<std::uint32_t> picture_triangles(const Cloud_domain& domain);

// Returns the same triangles for a domain, if a picture is requested. Returns an empty array for
// meshes, because pictures use their faces.
template <typename Domain>
std::vector<std::uint32_t> picture_triangles([[maybe_unused]] const Domain& domain,
                                             [[maybe_unused]] const Job& job)
{
  if constexpr(!is_mesh<typename Domain::Surface>)
    if(!job.picture().empty())
      return picture_triangles(domain);
  return {};
}

// Readable property map: one value for each vertex.
template <typename Key, typename Value = double>
struct Property_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = const Value&;
  using category = boost::readable_property_map_tag;

  const std::vector<Value>* values;
  friend const Value& get(const Property_map& map, const Key& key)
  {
    return (*map.values)[static_cast<std::size_t>(key)];
  }
};

// Read-write property map of values at vertices, faces or surfels.
template <typename Key, typename Value = double>
struct Value_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = const Value&;
  using category = boost::read_write_property_map_tag;

  std::vector<Value>* values;
  friend const Value& get(const Value_map& map, const Key& key)
  {
    return (*map.values)[static_cast<std::size_t>(key)];
  }
  friend void put(const Value_map& map, const Key& key, const Value& value)
  {
    (*map.values)[static_cast<std::size_t>(key)] = value;
  }
};

// Returns the speeds of the vertices as a property map, or std::nullopt if `speeds` is empty
// (speed 1 everywhere).
template <typename Vertex>
std::optional<Property_map<Vertex>> speed_map(const std::vector<double>& speeds)
{
  if(speeds.empty())
    return std::nullopt;
  return Property_map<Vertex>{&speeds};
}

// Reports the number of labels that equal -1.
void report_unreached(Job& job, const std::vector<long long>& labels);

// Returns the labels as text, one per line.
std::string labels_text(const std::vector<long long>& labels);

// Writable property map of labels at vertices, faces or surfels, by index.
template <typename Key>
struct Label_map
{
  using key_type = Key;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::writable_property_map_tag;

  std::vector<long long>* labels;
  // The largest label value, which the library uses for "no label", becomes -1.
  friend void put(const Label_map& map, const Key& key, std::size_t label)
  {
    (*map.labels)[static_cast<std::size_t>(key)] = static_cast<long long>(label);
  }
};

// Returns farthest point samples: each vertex is as far as possible from the previous ones.
// Candidates are vertices with an incident triangle, or surfels. Returns fewer than `number`
// vertices if no vertex has a positive distance to the others.
template <typename Domain>
std::vector<std::size_t> farthest_vertices(const Domain& domain, std::size_t number, Job& job,
                                           const std::vector<double>& speeds = {});

// Returns the vertices and faces of a mesh.
Surface_file to_file(const Mesh& mesh);

// Returns a copy of a mesh in which faces of different labels have no vertex in common, because
// pictures store colors at vertices. `vertex_labels` is set to the labels of its vertices. The
// largest face label, which means "no label", becomes -1.
Surface_file separate_regions(const Surface_file& mesh,
                              const std::vector<std::uint32_t>& face_labels,
                              std::vector<long long>& vertex_labels);

// Returns the coordinates of a range of points.
template <typename Points>
std::vector<Point> coordinates_of(const Points& points)
{
  std::vector<Point> result;
  for(const auto& p : points)
    result.push_back(coordinates(p));
  return result;
}

// If an output is requested, writes polylines to its file.
void write_polylines(const Job& job, std::vector<std::vector<Point>> polylines);

// Returns the coordinates as text, one point per line.
std::string points_text(const std::vector<Point>& points);

// Formats a location: the index of a surfel, or a face's vertices with barycentric coordinates.
template <typename Domain>
std::string location_text([[maybe_unused]] const Domain& domain,
                          const typename Domain::Location& location)
{
  if constexpr(is_mesh<typename Domain::Surface>)
  {
    const std::size_t first_corner = 3 * std::size_t{domain.triangle(location.first)};
    std::string text;
    for(std::size_t k = 0; k < 3; ++k)
    {
      // Not public: The mesh of a soup, which knows the corners, would be built for this.
      const auto vertex = domain.vertex(domain.triangles()->corner[first_corner + k]);
      text += std::to_string(std::size_t(vertex)) + ' ';
    }
    for(std::size_t k = 0; k < 3; ++k)
      text += (k > 0 ? " " : "") + number_text(location.second[k]);
    return text;
  }
  else
    return std::to_string(std::size_t(location.surfel));
}

// Returns a vertex property of the file. If it does not exist, throws Input_error that lists the
// existing properties.
const std::vector<double>& property(const Surface& surface, const std::string& name);

// Reports the largest finite distance and the number of infinite ones. Returns the largest finite
// distance.
double report_distances(Job& job, const std::vector<double>& distances);

// Writes the input with one value per vertex, in a form that the file format supports. Formats
// other than OBJ and OFF store a property. OBJ stores the texture coordinate u = value / size,
// clamped to [0, 1], and OFF stores a color.
void write_result(const Job& job, const std::string& name, const std::vector<double>& values,
                  double size);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_COMMAND_UTILITIES_H
