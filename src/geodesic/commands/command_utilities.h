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

// What the commands that measure along the surface share: from words on the command line to the
// library's types.
namespace program {

namespace GP = CGAL::Geodesic_processing;

// Calls f with the mesh or the cloud that a surface is.
template <typename Function>
void visit_surface(const Surface& surface, Function f)
{
  if(surface.is_mesh())
    f(make_mesh(surface));
  else
    f(make_cloud(surface));
}

template <typename Surface_type>
inline constexpr bool is_mesh = std::is_same_v<Surface_type, Mesh>;

// The vertex or surfel with a number.
template <typename Surface_type>
typename GP::Source<Surface_type>::Vertex vertex_at(std::size_t number)
{
  if constexpr(is_mesh<Surface_type>)
    return Mesh::Vertex_index(static_cast<Mesh::size_type>(number));
  else
    return Cloud::Index(number);
}

// The method of a word; throws Usage_error with a sentence for other words, and Input_error where the
// surface is not what the method needs.
void check_method(const std::string& method);
void check_method(const std::string& method, const Surface& surface);

// The method of a word that passed the check.
GP::internal::Distance_method to_method(const std::string& method);

// Solvers whose method is chosen at run time: commands are compiled once for all methods.
template <typename Surface_type>
using Distance_solver = GP::Geodesic_distance_solver<Surface_type, GP::internal::Runtime_method>;

// What all commands measure on.
using Mesh_domain = GP::Mesh_domain<Mesh>;
using Cloud_domain = GP::Surfel_domain<Cloud>;
Mesh_domain make_domain(const Mesh& mesh, const Job& job);
Cloud_domain make_domain(const Cloud& cloud, const Job& job);

// Distances by transport of masses, and the one that they are compared with.
bool is_metric(const std::string& method);

// Throws Usage_error where the method has no basis.
void check_basis(const std::string& method, const std::optional<std::size_t>& basis_size);

// Calls f with the metric of a word.
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

// The place on the surface nearest to a point "x,y,z".
template <typename Domain>
typename Domain::Location locate(const Domain& domain, const std::string& text,
                                 const std::string& option);

// Corners of the triangles that a picture of a cloud draws lines on: as many as fit side by side.
std::vector<std::uint32_t> picture_triangles(const GP::internal::Surfel_arrays& surfels);

// The same of a domain, where a picture is wanted; nothing of a mesh, which has its own.
template <typename Domain>
std::vector<std::uint32_t> picture_triangles([[maybe_unused]] const Domain& domain,
                                             [[maybe_unused]] const Job& job)
{
  if constexpr(!is_mesh<typename Domain::Surface>)
    if(!job.picture().empty())
      return picture_triangles(domain.surfels());
  return {};
}

// One value for each vertex, read like a map of the library.
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

// Values of vertices, faces or surfels, read and written like a map of the library.
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

// The speeds of the vertices as a map of the library; none where they are 1 everywhere.
template <typename Vertex>
std::optional<Property_map<Vertex>> speed_map(const std::vector<double>& speeds)
{
  if(speeds.empty())
    return std::nullopt;
  return Property_map<Vertex>{&speeds};
}

// Tells how many have the label -1.
void report_unreached(Job& job, const std::vector<long long>& labels);

// A line for each label.
std::string labels_text(const std::vector<long long>& labels);

// Labels as the library writes them, at vertices, faces or surfels by their numbers.
template <typename Key>
struct Label_map
{
  using key_type = Key;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::writable_property_map_tag;

  std::vector<long long>* labels;
  // The largest number, which stands for no label, becomes -1.
  friend void put(const Label_map& map, const Key& key, std::size_t label)
  {
    (*map.labels)[static_cast<std::size_t>(key)] = static_cast<long long>(label);
  }
};

// Vertices that lie in a triangle, or surfels, each as far as can be from those before it.  Fewer than
// asked for when no vertex is left at a distance.
template <typename Domain>
std::vector<std::size_t> farthest_vertices(const Domain& domain, std::size_t number, Job& job,
                                           const std::vector<double>& speeds = {});

// A line of coordinates for each point.
std::string points_text(const std::vector<Point>& points);

// A surfel by its place in the file; a place in a triangle by its vertices and their shares.
template <typename Surface_type, typename Location>
std::string location_text([[maybe_unused]] const Surface_type& surface, const Location& location)
{
  if constexpr(is_mesh<Surface_type>)
  {
    const auto h = surface.halfedge(location.first);
    std::string text;
    for(const auto vertex : {surface.source(h), surface.target(h), surface.target(surface.next(h))})
      text += std::to_string(std::size_t(vertex)) + ' ';
    for(std::size_t k = 0; k < 3; ++k)
      text += (k > 0 ? " " : "") + number_text(location.second[k]);
    return text;
  }
  else
    return std::to_string(std::size_t(location.surfel));
}

// Throws Input_error, with the names that there are, when the file has no such property.
const std::vector<double>& property(const Surface& surface, const std::string& name);

// Says how large distances are, and how many are infinite; returns the largest of the others.
double report_distances(Job& job, const std::vector<double>& distances);

// Writes the input with one value for each vertex, as the kind of file allows: a property; in OBJ a
// texture coordinate u = value / size; in OFF a colour.
void write_result(const Job& job, const std::string& name, const std::vector<double>& values,
                  double size);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_COMMAND_UTILITIES_H
