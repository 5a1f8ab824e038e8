// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_TRANSPORT_UTILITIES_H
#define GEODESIC_PROGRAM_COMMANDS_TRANSPORT_UTILITIES_H

#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "commands/speed_options.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Utilities shared by the commands that transport mass

namespace program {

struct Transport_options
{
  std::string from, to;
  bool density = false, normalize = false, bound_above = false, hodge = false;
  std::string method = "interior-point";
  double tolerance = 1e-3;
  std::optional<std::size_t> refine;
  Speed_options speed_options;
};

void add_options(Command& command, Transport_options& options);
// Adds only the options of a query, without those of the solver and without speeds.
void add_query_options(Command& command, Transport_options& options);

// Throws Usage_error if an option is invalid.
void check(const Transport_options& options);
// Throws Input_error if an option is not supported for this surface.
void check(const Transport_options& options, const Surface& surface);

// A mass distribution: masses of vertices, or mass per area.
struct Masses
{
  std::vector<double> values; // #vertices
  bool is_density = false;
  std::vector<std::size_t> vertices; // if not empty, the only vertices with mass
};

struct Transport_result
{
  GP::Earth_movers_cost cost;
  std::vector<double> potential;                     // #vertices, or empty
  std::vector<double> arrivals;                      // #vertices, or empty
  std::vector<std::vector<Point>> feature_polylines; // of a region: polylines, or single points
  std::map<std::string, std::vector<Point>> fields;  // #faces of a mesh, #vertices of a cloud
  std::vector<std::uint32_t> triangles;              // of a cloud
};

// Adds the region's polylines and points to a picture.
void add_feature_polylines(const Transport_result& result, Picture& picture);

// Returns whether the text is a list of vertices.
bool is_vertex_list(const std::string& text);

// Reads a mass distribution: vertices that share mass 1 equally, a property, or a file. Throws
// Input_error.
Masses read_masses(const std::string& text, const std::string& option,
                   const Transport_options& options, const Surface& surface);

// Returns the listed vertices, or the vertices with a positive value of a property. Throws
// Input_error.
std::vector<std::size_t> region_vertices(const std::string& text, const std::string& option,
                                         const Surface& surface);

// Sources of a region in addition to vertices: locations closest to points, and shortest paths.
struct Region_options
{
  std::vector<std::string> at;    // "x,y,z" each
  std::vector<std::string> paths; // vertices each
  std::string at_option, path_option;

  bool empty() const { return at.empty() && paths.empty(); }
};

void add_region_options(Command& command, Region_options& options, const std::string& prefix);
// The first overload throws Usage_error. The second throws Input_error if a vertex does not exist
// or the surface is a cloud.
void check(const Region_options& options);
void check(const Region_options& options, const Surface& surface);

// Appends one source per point and path to the region, and their polylines to the result. Throws
// Input_error if no path connects two vertices.
template <typename Domain>
void add_sources(const Domain& domain, const Region_options& options, const Surface& surface,
                 std::vector<GP::Source<typename Domain::Surface>>& region,
                 Transport_result& result);

// Writable property map: one vector for each face or surfel.
template <typename Key>
struct Vector_map
{
  using key_type = Key;
  using value_type = Kernel::Vector_3;
  using reference = Kernel::Vector_3;
  using category = boost::read_write_property_map_tag;

  std::vector<Point>* vectors;
  friend void put(const Vector_map& map, const Key& key, const Kernel::Vector_3& v)
  {
    (*map.vectors)[static_cast<std::size_t>(key)] = {v.x(), v.y(), v.z()};
  }
  friend Kernel::Vector_3 get(const Vector_map& map, const Key& key)
  {
    const Point& v = (*map.vectors)[static_cast<std::size_t>(key)];
    return {v[0], v[1], v[2]};
  }
};

// Returns a property map of vectors for faces of a mesh or surfels.
template <typename Domain>
auto vector_map(std::vector<Point>& vectors, const Domain& domain)
{
  if constexpr(is_mesh<typename Domain::Surface>)
  {
    // Not public: The mesh of a soup, which knows its size, would be built for this.
    vectors.resize(domain.triangles()->number_of_triangles());
    return Vector_map<Mesh::Face_index>{&vectors};
  }
  else
  {
    vectors.resize(domain.number_of_vertices());
    return Vector_map<Cloud::Index>{&vectors};
  }
}

// Not public: Solvers accept masses and densities as property maps of different types, and the
// arguments of a command select one of them at run time.
using GP::internal::Mass_distribution;

// Converts masses or densities to a Mass_distribution.
template <typename Domain>
Mass_distribution distribution(const Domain& domain, const Masses& masses);

// Returns the named parameters of a solver's constructor: refinements and speeds.
template <typename Domain>
auto preparation(const Domain& domain, const Transport_options& options,
                 const std::vector<double>& speeds)
{
  // Not public: Named parameters are types, so a command cannot omit number_of_refinements at run
  // time.
  const unsigned default_number = GP::internal::default_number_of_refinements(*domain.triangles());
  const unsigned refinements =
      options.refine ? static_cast<unsigned>(std::min<std::size_t>(*options.refine, 30))
                     : default_number;
  return GP::parameters::number_of_refinements(refinements)
      .speed_map(speed_map<typename Domain::Vertex>(speeds));
}

// Returns the named parameters of a query.
inline auto query_parameters(const Transport_options& options, Job& job)
{
  return GP::parameters::tolerance(options.tolerance)
      .do_normalize(options.normalize)
      .do_bound_from_above(options.bound_above)
      .callback(job.progress_callback("transport"));
}

// Runs a query of a solver by the method with the given name.
template <typename Solver, typename... Arguments>
GP::Earth_movers_cost compute_cost(Solver& solver, const std::string& method,
                                   const Arguments&... arguments)
{
  if(method == "admm")
    return solver.template compute<GP::Alternating_directions>(arguments...);
  if(method == "weiszfeld")
    return solver.template compute<GP::Weiszfeld>(arguments...);
  return solver.template compute<GP::Interior_point>(arguments...);
}

// Copies the solution of a solver's last query to the result.
template <typename Domain>
void copy_solution(const Domain& domain,
                   const GP::Transport_solution<typename Domain::Surface>& solution, const Job& job,
                   Transport_result& result);

// Adds the components of the flow if the decomposition is requested: the gradient, the rotation and
// the harmonic field on a mesh, the gradient and the remainder on a cloud.
template <typename Domain>
void add_hodge_decomposition(const Domain& domain, const Transport_options& options,
                             Transport_result& result);

// Reports the cost in the JSON result and on standard output.
void report(Job& job, const Transport_options& options, const GP::Earth_movers_cost& cost,
            const std::string& title);

// Writes the potential and the flow to the outputs that are requested. Vectors are stored per
// face, or per surfel as three properties. The picture also shows the marked vertices. Throws
// Output_error.
void write_transport(const Job& job, const Transport_result& result,
                     const std::vector<std::size_t>& marked_vertices);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_TRANSPORT_UTILITIES_H
