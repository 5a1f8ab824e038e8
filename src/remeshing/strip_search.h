// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_STRIP_SEARCH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_STRIP_SEARCH_H

#include "mesh/Split_mesh.h"

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Factors of the path length outside of the cells of an edge's two end vertices: `near` in the
// cells of the two vertices opposite to the edge, `far` in all other cells. A path around the back
// of a limb can be shorter, but it blocks the edges that belong there.
struct Detour_factors
{
  double near, far;
  bool can_pass_samples; // whether shortening may move the path across samples

  // If true, no edge leaves the cells of its end vertices.
  bool is_confined() const { return far == infinity; }
};

// Finds triangle strips for the edges of a base mesh, one after the other, on a mesh that is split
// along each of them. A strip does not cross labeled edges. The search is A* (Hart, Nilsson and
// Raphael 1968) on three points per edge. O(k log k) for k visited points.
class CGAL_GEODESIC_PROCESSING_EXPORT Strip_search
{
public:
  // cells: #vertices, the base vertex to whose cell each vertex belongs, or none
  // max_visits: limit of the number of points visited in all searches together
  Strip_search(const Split_mesh& mesh, const Detour_factors& factors, std::vector<Index> cells,
               std::size_t max_visits)
      : m_mesh(mesh), m_factors(factors), m_cell(std::move(cells)), m_visits_left(max_visits)
  {}

  // Sets the base vertices of the two triangles incident to the edge: its end vertices, then the
  // vertices opposite to it.
  void set_nearby_cells(const std::array<Index, 4>& cells) { m_nearby_cells = cells; }

  // Returns the halfedges that a short path crosses, each in the triangle that the path leaves. The
  // path starts in one of the triangles of `start_corners` and ends at the vertex `to` in one of
  // the triangles of `goal_corners`. Returns an empty strip if there is no path, or if the limit of
  // visits is reached.
  std::vector<Index> find(const std::vector<Index>& start_corners,
                          const std::vector<Index>& goal_corners, Index to);

  // Assigns a cell to the next vertex of the mesh. Must be called before each edge split.
  void add_vertex_on(Index h, double fraction) { m_cell.push_back(cell_on(h, fraction)); }

private:
  struct Node
  {
    double distance = infinity;
    Index run = 0;         // the search that set this node
    Index from = none;     // the previous node
    Index halfedge = none; // the crossed halfedge, in the triangle of the previous node
  };
  using Entry = std::pair<double, Index>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  bool is_end_cell(Index cell) const;
  double detour_factor(Index vertex) const;
  double detour_factor_across(Index h) const;
  Index cell_on(Index h, double fraction) const;
  Vec3 point(Index node) const;
  void reach(Index h, const Vec3& from, double distance, Index previous);

  const Split_mesh& m_mesh;
  Detour_factors m_factors;
  std::vector<Index> m_cell; // #vertices
  std::array<Index, 4> m_nearby_cells = {};
  std::vector<Node> m_nodes;
  Queue m_queue;
  Vec3 m_goal_point = {0., 0., 0.};
  Index m_run = 0;
  std::size_t m_visits_left;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_STRIP_SEARCH_H
