// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls that must not compile, one for each value of CALL. The compiler must print the sentence
// beside the call; supported_surfaces.cmake checks it.
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/texture_atlas.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
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
#if CALL == 1 // pass speeds of faces as face_speed_map
  GP::geodesic_distances(mesh, v, distances, GP::parameters::speed_map(of_faces));
#elif CALL == 2  // pass speeds of vertices as speed_map
  GP::geodesic_distances(mesh, v, distances, GP::parameters::face_speed_map(distances));
#elif CALL == 3  // A cloud has no faces
  GP::geodesic_distances(cloud, *cloud.begin(), of_surfels,
                         GP::parameters::face_speed_map(of_faces));
#elif CALL == 4  // it does not use index maps
  GP::make_domain(mesh, GP::parameters::vertex_index_map(distances));
#elif CALL == 5  // geom_traits is not used
  GP::make_domain(mesh, GP::parameters::geom_traits(Kernel()));
#elif CALL == 6  // geom_traits is not used
  GP::make_domain(cloud, GP::parameters::geom_traits(Kernel()));
#elif CALL == 7  // A range of surfels requires the named parameter normal_map
  GP::make_domain(points);
#elif CALL == 8  // Exact distances need a mesh
  GP::geodesic_distances<GP::Exact>(cloud, *cloud.begin(), of_surfels);
#elif CALL == 9  // pass a mesh that receives the reconstructed surface
  GP::texture_atlas(cloud, 10, uv);
#elif CALL == 10 // An edge map requires a mesh, because a cloud has no edges
  GP::geodesic_delaunay_remeshing(cloud, 10, mesh,
                                  GP::parameters::edge_is_constrained_map(of_edges));
#elif CALL != 0
#  error "There is no such call."
#endif
}
