// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls every function and class of the package on a mesh, a cloud and their domains, as far as
// is_supported_v admits it. The file is only compiled: with ON_MESHES, with ON_CLOUDS, or with
// REJECTED. The latter calls functions on surfaces that they do not accept, and the compiler must
// print the reasons.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace GP = CGAL::Geodesic_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Cloud = CGAL::Point_set_3<Point>;
using UV = std::array<double, 2>;

// A property map of any keys.
template <typename Key, typename Value>
boost::associative_property_map<std::map<Key, Value>> map_of()
{
  static std::map<Key, Value> values;
  return boost::make_assoc_property_map(values);
}

template <typename Surface>
struct Types
{
  using Plain = GP::Surface_of<Surface>; // the mesh or the cloud
  using Vertex = typename decltype(GP::make_domain(std::declval<Surface>()))::Vertex;
  using Location = GP::Location<Plain>;
  static constexpr bool is_mesh = std::is_same_v<Plain, Mesh>;
  template <typename Value>
  static auto map()
  {
    return map_of<Vertex, Value>();
  }
};

// The call of each function. A function without a call does not compile below.
template <GP::Function function>
struct Call;
#define CALL(name, ...)                                                                            \
  template <>                                                                                      \
  struct Call<GP::Function::name>                                                                  \
  {                                                                                                \
    template <typename Surface>                                                                    \
    static void run([[maybe_unused]] const Surface& surface)                                       \
    {                                                                                              \
      using T = Types<Surface>;                                                                    \
      using Plain [[maybe_unused]] = typename T::Plain;                                            \
      [[maybe_unused]] const typename T::Vertex p{}, q{};                                          \
      [[maybe_unused]] const typename T::Location location{};                                      \
      [[maybe_unused]] const std::vector<typename T::Vertex> vertices;                             \
      [[maybe_unused]] Mesh output, second_output;                                                 \
      __VA_ARGS__;                                                                                 \
    }                                                                                              \
  };

CALL(make_domain, GP::make_domain<CGAL::Parallel_tag>(surface))
CALL(locate_on_surface, GP::locate_on_surface(surface, Point()))
CALL(Surface_locator, GP::Surface_locator<Plain>{surface}(Point()))
CALL(border_sources, std::vector<GP::Source<Plain>> sources;
     GP::border_sources(surface, std::back_inserter(sources)))
CALL(geodesic_distances, GP::geodesic_distances(surface, p, T::template map<double>());
     GP::geodesic_distances<GP::Heat>(surface, location, T::template map<double>()))
CALL(Geodesic_distance_solver, GP::Geodesic_distance_solver<Plain> solver(surface);
     solver.compute(vertices); solver.distance(location))
CALL(geodesic_distance_matrix, GP::geodesic_distance_matrix(surface, vertices))
CALL(sparse_geodesic_distance_matrix, GP::sparse_geodesic_distance_matrix(surface, vertices, 1.))
CALL(write_geodesic_distance_matrix, GP::write_geodesic_distance_matrix(surface, vertices, ""))
CALL(geodesic_distance_derivatives, GP::geodesic_distance_derivatives(surface, p, location))
CALL(isolines, std::vector<GP::Isoline<Plain>> lines;
     GP::isolines(surface, T::template map<double>(), std::vector<double>(),
                  std::back_inserter(lines)))
CALL(split_at_isolines,
     GP::split_at_isolines(surface, T::template map<double>(), std::vector<double>(), output,
                           map_of<Mesh::Face_index, std::size_t>()))
CALL(geodesic_ball, GP::geodesic_ball(surface, p, 1.); GP::geodesic_ball(surface, location, 1.))
CALL(geodesic_eccentricity, GP::geodesic_eccentricity(surface, p))
CALL(geodesic_diameter, GP::geodesic_diameter(surface))
CALL(geodesic_radius, GP::geodesic_radius(surface))
CALL(geodesic_path, GP::geodesic_path(surface, location, p))
CALL(Geodesic_path_finder, GP::Geodesic_path_finder<Plain>{surface}(p, location))
CALL(shorten_polyline, GP::shorten_polyline(surface, vertices);
     GP::shorten_polyline(surface, std::vector<Point>()))
CALL(geodesic_polyline, GP::geodesic_polyline(surface, vertices))
CALL(shorten_loop, GP::shorten_loop(surface, vertices);
     GP::shorten_loop(surface, std::vector<Point>()))
CALL(loop_basis, std::vector<GP::Geodesic_loop<Plain>> loops;
     GP::loop_basis(surface, std::back_inserter(loops)))
CALL(shortest_noncontractible_loop, GP::shortest_noncontractible_loop(surface, location))
CALL(geodesic_bezier_curve, GP::geodesic_bezier_curve(surface, vertices))
CALL(geodesic_spline, GP::geodesic_spline(surface, vertices))
CALL(straightest_geodesic, GP::straightest_geodesic(surface, p, Vector(), 1.))
CALL(surfel_geodesic_path, GP::surfel_geodesic_path(surface, p, location))
CALL(Surfel_path_finder,
     GP::surfel_geodesic_paths(GP::Surfel_path_finder<Plain>(surface),
                               std::vector<std::pair<typename T::Vertex, typename T::Vertex>>()))
CALL(principal_curvatures,
     GP::principal_curvatures(surface, T::template map<GP::Principal_curvatures<Plain>>()))
CALL(curvature_speeds, GP::curvature_speeds(surface, T::template map<double>()))
CALL(similar_curvature_speeds, GP::similar_curvature_speeds(surface, p, T::template map<double>()))
CALL(image_speeds, GP::image_speeds(surface, T::template map<double>(), T::template map<double>()))
CALL(farthest_point_sampling, std::vector<typename T::Location> samples;
     GP::farthest_point_sampling(surface, 10, std::back_inserter(samples)))
CALL(farthest_vertex_sampling, std::vector<typename T::Vertex> samples;
     GP::farthest_vertex_sampling(surface, 10, std::back_inserter(samples)))
CALL(geodesic_voronoi_diagram,
     GP::geodesic_voronoi_diagram(surface, vertices, T::template map<std::size_t>()))
CALL(geodesic_voronoi_cells,
     GP::geodesic_voronoi_cells(surface, vertices, output, map_of<Mesh::Face_index, std::size_t>()))
CALL(geodesic_centroidal_tessellation,
     if constexpr(T::is_mesh)
         GP::geodesic_centroidal_tessellation(surface, 10, map_of<Mesh::Face_index, std::size_t>());
     else GP::geodesic_centroidal_tessellation(surface, 10, T::template map<std::size_t>()))
CALL(geodesic_delaunay_remeshing, GP::geodesic_delaunay_remeshing(surface, 10, output))
CALL(geodesic_base_mesh, GP::geodesic_base_mesh(surface, 10, output, second_output,
                                                map_of<Mesh::Face_index, Mesh::Face_index>()))
CALL(Base_parameterization, GP::Base_parameterization<Plain>{surface, 10}(location))
CALL(parameterize_over_base,
     GP::parameterize_over_base(surface, 10, T::template map<GP::Base_location>()))
CALL(semi_regular_remeshing, GP::semi_regular_remeshing(surface, 10, 2, output))
CALL(Subdivision_wavelet,
     GP::Subdivision_wavelet<Plain>{surface}.analyze(T::template map<double>()))
CALL(logarithmic_map, GP::logarithmic_map(surface, p, T::template map<UV>()))
CALL(Logarithmic_map, GP::Logarithmic_map<Plain>{surface}.compute(location))
CALL(exponential_map, GP::exponential_map(surface, p, {1., 0.}))
CALL(Decal_placer, GP::Decal_placer<Plain>{surface}.place(p, 1., 1.))
CALL(composite_decal, GP::composite_decal(GP::Decal_placer<Plain>{surface}.place(p, 1., 1.),
                                          GP::Decal_image(), T::template map<GP::Decal_color>()))
CALL(bake_decals, GP::bake_decals(std::vector<GP::Decal_layer<Plain>>(), 4))
CALL(geodesic_lle, GP::geodesic_lle(surface, T::template map<UV>()))
CALL(geodesic_mds, GP::geodesic_mds(surface, T::template map<UV>()))
CALL(minimize_distortion, GP::minimize_distortion(surface, T::template map<UV>()))
CALL(face_distortion, GP::face_distortion(Mesh::Face_index(), surface, T::template map<UV>()))
CALL(surface_distortion,
     GP::surface_distortion(surface, T::template map<UV>(), &GP::Face_distortion::mips))
CALL(flattening_distortion, GP::flattening_distortion(surface, T::template map<UV>()))
CALL(texture_atlas, const auto uv = map_of<Mesh::Halfedge_index, UV>();
     if constexpr(T::is_mesh) GP::texture_atlas(surface, 10, uv);
     else GP::texture_atlas(surface, 10, output, uv))
CALL(
    bake_atlas, const auto color = [](const auto&) { return GP::Decal_color(); };
    GP::bake_atlas(surface, map_of<Mesh::Halfedge_index, UV>(), color, 64))
CALL(earth_movers_distance, GP::earth_movers_distance(surface, p, location))
CALL(Earth_movers_solver, GP::Earth_movers_solver<Plain>{surface}.compute(p, q))
CALL(transport_streamlines, std::vector<GP::Streamline<Plain>> lines;
     GP::transport_streamlines(surface, p, q, vertices, std::back_inserter(lines)))
CALL(transport_to_region, GP::transport_to_region(surface, p, vertices))
CALL(Region_transport_solver,
     GP::Region_transport_solver<Plain>(surface, vertices).compute(location))
CALL(feature_distance, GP::feature_distance(surface, vertices, T::template map<double>()))
CALL(transport_barycenter, GP::transport_barycenter(surface, vertices, T::template map<double>()))
CALL(Transport_barycenter_solver, GP::Transport_barycenter_solver<Plain>{surface}.compute(vertices))
CALL(geodesic_barycenter, GP::geodesic_barycenter(surface, vertices))
CALL(karcher_mean, GP::karcher_mean(surface, vertices))
CALL(fuzzy_geodesic, GP::fuzzy_geodesic(surface, p, q, T::template map<double>()))
CALL(fuzzy_geodesic_by_distances,
     GP::fuzzy_geodesic_by_distances(surface, p, location, T::template map<double>()))
CALL(Transport_metric, GP::Transport_metric<Plain>{surface}.distance(p, q))
CALL(Biharmonic_metric, GP::Biharmonic_metric<Plain>{surface}.distance(p, location))
CALL(
    hodge_decomposition,
    if constexpr(T::is_mesh) {
      const auto field = map_of<Mesh::Face_index, Vector>();
      GP::hodge_decomposition(surface, field, field, field, field);
    } else {
      const auto field = T::template map<Vector>();
      GP::hodge_decomposition(surface, field, field, field);
    })
CALL(mean_value_coordinates,
     GP::mean_value_coordinates(surface, Point(), T::template map<double>()))
CALL(volumetric_distance, GP::volumetric_distance(surface, Point(), Point()))
CALL(Volumetric_metric, GP::Volumetric_metric<Plain>{surface}.distance(Point(), Point()))
#undef CALL

#ifdef REJECTED
void call_all(const Mesh& mesh, const Cloud& cloud)
{
#  define BOTH(name)
#  define MESHES(name, reason) Call<GP::Function::name>::run(cloud);
#  define CLOUDS(name, reason) Call<GP::Function::name>::run(mesh);
  CGAL_GEODESIC_PROCESSING_FUNCTIONS(BOTH, MESHES, CLOUDS)
#  undef CLOUDS
#  undef MESHES
#  undef BOTH
}
#else
template <typename Surface>
void call_all(const Surface& surface)
{
#  define CALL(name, ...)                                                                          \
    if constexpr(GP::is_supported_v<GP::Function::name, Surface>)                                  \
      Call<GP::Function::name>::run(surface);
  CGAL_GEODESIC_PROCESSING_FUNCTIONS(CALL, CALL, CALL)
#  undef CALL
}

#  ifdef CLOUDS
template void call_all(const Cloud&);
template void call_all(const GP::Surfel_domain<Cloud>&);
#  else
template void call_all(const Mesh&);
template void call_all(const GP::Mesh_domain<Mesh>&);
template void call_all(const GP::Soup_domain<Point>&);
#  endif
#endif
