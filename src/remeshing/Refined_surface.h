// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_REFINED_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_REFINED_SURFACE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The input mesh of a remeshing, refined by edge splits, with the feature edges and the slowness of
// the current triangles. Lengths of `triangles()` are in its own scale; `unit_size()` converts them
// to the scale of the input mesh.
class CGAL_GEODESIC_PROCESSING_EXPORT Refined_surface
{
public:
  // Reads `is_feature` and `slowness` of the options. If `is_feature` is empty, the boundary edges
  // are the features. O(n).
  Refined_surface(const std::shared_ptr<const Surface_arrays>& triangles,
                  const Remeshing_options& options);

  const Surface_arrays& triangles() const { return *m_refinement.triangles; }
  const std::shared_ptr<const Surface_arrays>& shared_triangles() const
  {
    return m_refinement.triangles;
  }
  const Surface_arrays& coarse() const { return *m_refinement.coarse; }
  const Refinement& refinement() const { return m_refinement; }

  // Returns the length unit of `triangles()` divided by that of `coarse()`, a power of two.
  double unit_size() const { return triangles().scale / coarse().scale; }

  double slowness(Index triangle) const { return m_slowness ? (*m_slowness)[triangle] : 1.; }
  // #triangles of triangles(), or null if the slowness is 1.
  const std::shared_ptr<const std::vector<double>>& slowness() const { return m_slowness; }

  bool has_features() const { return m_has_features; }
  // 3 #triangles and #vertices of triangles().
  const std::vector<bool>& is_feature() const { return m_is_feature; }
  const std::vector<bool>& is_feature_vertex() const { return m_is_feature_vertex; }
  // 3 #triangles of coarse().
  const std::vector<bool>& is_coarse_feature() const { return m_is_coarse_feature; }
  // Returns true if the location is a feature vertex or lies on a feature edge of triangles().
  bool is_on_feature(const Surface_location& location) const;

  // Splits the marked edges at their midpoints. `is_split` (3 #triangles) must have the same value
  // for both halfedges of an edge. O(n).
  void split(const std::vector<bool>& is_split);
  // Splits the edges of each pair of triangles that share two edges: samples at their three common
  // vertices could not distinguish the two triangles. Afterwards, each vertex that is not on the
  // boundary has at least three faces, also after further splits. O(n).
  void split_duplicate_faces();

private:
  // Calls `visit` with the halfedges of both faces of each interior vertex that has two faces. The
  // first halfedge ends at the vertex, and the second one is its twin.
  template <typename Visitor>
  void for_each_vertex_of_two_faces(const Visitor& visit) const;
  void set_refinement(Refinement refinement);
  void mark_features();

  const std::shared_ptr<const std::vector<double>> m_coarse_slowness;
  const std::vector<bool> m_is_coarse_feature;
  const bool m_has_features;
  Refinement m_refinement;
  std::vector<bool> m_is_feature, m_is_feature_vertex;
  std::shared_ptr<const std::vector<double>> m_slowness;
};

// Marks both halfedges of an edge in an array of shape 3 #triangles.
inline void mark_edge(const Surface_arrays& triangles, Index h, std::vector<bool>& is_marked)
{
  is_marked[h] = true;
  if(triangles.twin[h] != none)
    is_marked[triangles.twin[h]] = true;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_REFINED_SURFACE_H
