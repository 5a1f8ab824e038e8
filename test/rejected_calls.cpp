// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls that must not compile. The compiler must print the sentence in the comment above each call;
// supported_surfaces.cmake checks it. Without REJECTED, the file compiles.
#include <CGAL/Geodesic_processing/earth_movers_distance.h>
#include <CGAL/Geodesic_processing/exponential_map.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>
#include <CGAL/Geodesic_processing/karcher_mean.h>
#include <CGAL/Geodesic_processing/texture_atlas.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace GP = CGAL::Geodesic_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3>;

void call(Mesh& mesh, Cloud& cloud)
{
  const Mesh::Vertex_index v(0);
  const auto distances = mesh.add_property_map<Mesh::Vertex_index, double>().first;
  const auto of_faces = mesh.add_property_map<Mesh::Face_index, double>().first;
  const auto of_edges = mesh.add_property_map<Mesh::Edge_index, bool>().first;
  const auto of_surfels = cloud.add_property_map<double>("distance").first;
  const auto uv = cloud.add_property_map<std::array<double, 2>>("uv").first;
  std::vector<Kernel::Point_3> points;
  std::vector<double> numbers;
#ifdef REJECTED
  // REASON: Pass speeds of faces as face_speed_map
  GP::geodesic_distances(mesh, v, distances, GP::parameters::speed_map(of_faces));
  // REASON: Pass speeds of vertices as speed_map
  GP::geodesic_distances(mesh, v, distances, GP::parameters::face_speed_map(distances));
  // REASON: face_speed_map is a property map with faces as keys
  GP::geodesic_distances(mesh, v, distances, GP::parameters::face_speed_map(numbers));
  // REASON: speed_map is a property map with vertices or surfels as keys
  GP::geodesic_distances(mesh, v, distances, GP::parameters::speed_map(numbers));
  // REASON: locate_on_surface() returns the location of a point
  GP::geodesic_path(mesh, points[0], points[1]);
  // REASON: CGAL::make_property_map() makes a map of a vector of masses
  GP::earth_movers_distance(mesh, numbers, numbers);
  // REASON: corner_uv_map is a property map with halfedges as keys
  GP::texture_atlas(mesh, 10, distances);
  // REASON: An output map is a property map with vertices as keys
  GP::geodesic_distances(mesh, v, of_faces);
  // REASON: An output map is a property map with surfels as keys
  GP::geodesic_distances(cloud, *cloud.begin(), numbers);
  // REASON: The values of an output map must be constructible from the results
  GP::geodesic_distances(mesh, v, mesh.add_property_map<Mesh::Vertex_index, std::string>().first);
  // REASON: This query requires the method Exact, which needs a mesh
  GP::Geodesic_distance_solver<Cloud>(cloud).lower(*cloud.begin());
  // REASON: karcher_mean() does not support speeds
  GP::karcher_mean(mesh, v, GP::parameters::speed_map(distances));
  // REASON: A tangent vector has two components
  GP::exponential_map(mesh, v, Kernel::Vector_3(1., 0., 0.));
  // REASON: A cloud has no faces
  GP::geodesic_distances(cloud, *cloud.begin(), of_surfels,
                         GP::parameters::face_speed_map(of_faces));
  // REASON: it does not use index maps
  GP::make_domain(mesh, GP::parameters::vertex_index_map(distances));
  // REASON: The kernel is that of the vertex point map: geom_traits is not used
  GP::make_domain(mesh, GP::parameters::geom_traits(Kernel()));
  // REASON: The kernel is that of the range, see Surfel_kernel: geom_traits is not used
  GP::make_domain(cloud, GP::parameters::geom_traits(Kernel()));
  // REASON: A range of surfels requires the named parameter normal_map
  GP::make_domain(points);
  // REASON: pass the mesh or make_domain(points, polygons) instead
  GP::geodesic_distances(points, std::vector<std::vector<int>>(), distances);
  // REASON: Exact distances need a mesh
  GP::geodesic_distances<GP::Exact>(cloud, *cloud.begin(), of_surfels);
  // REASON: pass a mesh that receives the reconstructed surface
  GP::texture_atlas(cloud, 10, uv);
  // REASON: The value of a UV map is a Point_2, a Vector_2 or a std::array of two numbers
  GP::texture_atlas(mesh, 10, mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_3>().first);
  // REASON: callback is a function that takes the completed fraction
  GP::geodesic_distances(mesh, v, distances, GP::parameters::callback([](double) {}));
  // REASON: The last argument of a function is a chain of named parameters
  GP::geodesic_distances(mesh, v, distances, of_faces);
  // REASON: The template argument Surface is the mesh or the cloud
  GP::Geodesic_distance_solver<GP::Mesh_domain<Mesh>> solver(mesh);
  // REASON: An edge map requires a mesh, because a cloud has no edges
  GP::geodesic_delaunay_remeshing(cloud, 10, mesh,
                                  GP::parameters::edge_is_constrained_map(of_edges));
#endif
}
