// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_H
#define CGAL_GEODESIC_PROCESSING_H

#include <CGAL/Geodesic_processing/Biharmonic_metric.h>
#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/Mesh_domain.h>
#include <CGAL/Geodesic_processing/Region_transport_solver.h>
#include <CGAL/Geodesic_processing/Source.h>
#include <CGAL/Geodesic_processing/Streamline_tracer.h>
#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/Surfel_domain.h>
#include <CGAL/Geodesic_processing/Surfel_path_finder.h>
#include <CGAL/Geodesic_processing/Transport_barycenter_solver.h>
#include <CGAL/Geodesic_processing/Transport_metric.h>
#include <CGAL/Geodesic_processing/Volumetric_metric.h>
#include <CGAL/Geodesic_processing/decal.h>
#include <CGAL/Geodesic_processing/distortion.h>
#include <CGAL/Geodesic_processing/earth_movers_distance.h>
#include <CGAL/Geodesic_processing/estimate_surfels.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/exponential_map.h>
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/feature_distance.h>
#include <CGAL/Geodesic_processing/geodesic_barycenter.h>
#include <CGAL/Geodesic_processing/fuzzy_geodesic.h>
#include <CGAL/Geodesic_processing/geodesic_centroidal_tessellation.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/geodesic_distance_matrix.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/geodesic_lle.h>
#include <CGAL/Geodesic_processing/geodesic_mds.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>
#include <CGAL/Geodesic_processing/geodesic_voronoi_diagram.h>
#include <CGAL/Geodesic_processing/hodge_decomposition.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>
#include <CGAL/Geodesic_processing/logarithmic_map.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/mean_value_coordinates.h>
#include <CGAL/Geodesic_processing/minimize_distortion.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/principal_curvatures.h>
#include <CGAL/Geodesic_processing/shorten_polyline.h>
#include <CGAL/Geodesic_processing/speeds.h>
#include <CGAL/Geodesic_processing/straightest_geodesic.h>
#include <CGAL/Geodesic_processing/surfel_geodesic_path.h>
#include <CGAL/Geodesic_processing/surfel_variants.h>
#include <CGAL/Geodesic_processing/tags.h>
#include <CGAL/Geodesic_processing/transport_barycenter.h>
#include <CGAL/Geodesic_processing/transport_streamlines.h>
#include <CGAL/Geodesic_processing/transport_to_region.h>
#include <CGAL/Geodesic_processing/volumetric_distance.h>

#endif // CGAL_GEODESIC_PROCESSING_H
