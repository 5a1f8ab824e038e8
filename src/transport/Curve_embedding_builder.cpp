// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Curve_embedding.h>

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "transport/uniform_refinement.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Barycentric = std::array<double, 3>;

// Closer points on an edge, or inside a triangle, are the same (barycentric coordinates).
constexpr double snapping_tolerance = 1e-10;

struct Vertex_info
{
  Index vertex = none; // none for crossings that the triangulation inserted
  Barycentric barycentric = {};
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Constrained_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<Vertex_info, Kernel>,
        CGAL::Constrained_triangulation_face_base_2<Kernel>>,
    CGAL::Exact_intersections_tag>;

using Vertex_handle = Constrained_triangulation::Vertex_handle;
using Face_handle = Constrained_triangulation::Face_handle;

// Returns the point with barycentric coordinates b, normalized without round-off errors.
Kernel::Point_2 exact_point(const std::array<Vec2, 3>& corners, const Barycentric& b)
{
  Kernel::FT x = 0, y = 0, sum = 0;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const Kernel::FT weight(b[k]);
    x += weight * Kernel::FT(corners[k][0]);
    y += weight * Kernel::FT(corners[k][1]);
    sum += weight;
  }
  return Kernel::Point_2(x / sum, y / sum);
}

Barycentric mean_coordinates(std::initializer_list<Barycentric> points)
{
  Barycentric result = {0., 0., 0.};
  for(const Barycentric& b : points)
    for(std::size_t k = 0; k < 3; ++k)
      result[k] += b[k] / double(points.size());
  return result;
}

// Returns the edges of a triangle that contain a point: bit k for edge k.
unsigned incident_edge_mask(const Barycentric& b)
{
  return (b[2] == 0. ? 1u : 0u) | (b[0] == 0. ? 2u : 0u) | (b[1] == 0. ? 4u : 0u);
}

// Returns the edge, 0 to 2, that contains both points, or none.
Index common_edge(const Barycentric& p, const Barycentric& q)
{
  const unsigned both = incident_edge_mask(p) & incident_edge_mask(q);
  return both & 1u ? 0 : both & 2u ? 1 : both & 4u ? 2 : none;
}

// Returns for each halfedge the first halfedge of its edge. On a cloud, an edge consists of all
// halfedges with the same ends.
std::vector<Index> first_halfedges(const Surface_arrays& t)
{
  std::vector<Index> result = edge_midpoints(t);
  std::vector<Index> first(result.size(), none); // of each midpoint
  for(Index h = 0; h < result.size(); ++h)
  {
    Index& edge = first[result[h] - t.number_of_vertices()];
    edge = std::min(edge, h);
    result[h] = edge;
  }
  return result;
}

} // namespace

class Curve_embedding::Builder
{
public:
  Builder(Curve_embedding& result, const std::vector<std::vector<Surface_location>>& curves,
          const std::vector<Index>& region_vertices)
      : m_result(result), m_coarse(*result.m_coarse), m_canonical(first_halfedges(m_coarse)),
        m_vertex_kind(m_coarse.number_of_vertices(), Vertex_kind::free)
  {
    for(const Index vertex : region_vertices)
      m_vertex_kind[vertex] = Vertex_kind::region;
    m_result.m_vertices.resize(curves.size());
    for(std::size_t i = 0; i < curves.size(); ++i)
      add_curve(i, curves[i]);
    split_edges();
    split_triangles();
    connect_subtriangles();
  }

private:
  enum class Vertex_kind : char
  {
    free,
    region,
    curve
  };

  // A point on an edge. The parameter is relative to the canonical halfedge, from its source.
  struct Edge_point
  {
    double parameter;
    Index vertex;
  };
  struct Edge_data
  {
    std::vector<Edge_point> points;                 // without the ends
    std::vector<std::pair<double, double>> covered; // intervals on curves
  };

  // A segment of a curve through a triangle.
  struct Segment
  {
    std::size_t curve;
    std::array<Index, 2> vertex;
  };
  struct Interior
  {
    std::vector<std::pair<Barycentric, Index>> points;
    std::vector<Segment> segments;
  };

  // The canonical halfedge of an edge stands for all of its halfedges.
  Index canonical(Index h) const { return m_canonical[h]; }
  // Returns true if a halfedge and its canonical halfedge have opposite directions.
  bool is_reversed(Index h) const
  {
    return m_coarse.is_cloud() ? m_coarse.corner[h] != m_coarse.corner[canonical(h)]
                               : h != canonical(h);
  }

  Index add_new_vertex(const Surface_location& location, Vertex_kind kind)
  {
    m_result.m_new_locations.push_back(location);
    m_vertex_kind.push_back(kind);
    return Index(m_vertex_kind.size() - 1);
  }

  Index add_edge_point(Index h, double parameter, Vertex_kind kind)
  {
    if(is_reversed(h))
      parameter = 1. - parameter;
    h = canonical(h);
    std::vector<Edge_point>& points = m_edges[h].points;
    for(const Edge_point& point : points)
      if(std::abs(point.parameter - parameter) < snapping_tolerance)
        return point.vertex;
    points.push_back(
        {parameter, add_new_vertex({h / 3, none, barycentric_on_halfedge(h, parameter)}, kind)});
    return points.back().vertex;
  }

  // Returns the vertex at a location. A new vertex is added if needed.
  Index add(const Surface_location& location)
  {
    if(const Index vertex = vertex_of(m_coarse, location); vertex != none)
    {
      if(m_vertex_kind[vertex] == Vertex_kind::free)
        m_vertex_kind[vertex] = Vertex_kind::curve;
      return vertex;
    }
    if(const Index h = halfedge_of(location); h != none)
      return add_edge_point(h, location.barycentric[next_halfedge(h) % 3], Vertex_kind::curve);
    auto& points = m_interiors[location.triangle].points;
    for(const auto& [coordinates, vertex] : points)
      if(max_difference(coordinates, location.barycentric) < snapping_tolerance)
        return vertex;
    points.emplace_back(location.barycentric, add_new_vertex(location, Vertex_kind::curve));
    return points.back().second;
  }

  static double max_difference(const Barycentric& a, const Barycentric& b)
  {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
  }

  Surface_location snap(const Surface_location& location) const
  {
    Surface_location result = internal::canonical(m_coarse, location);
    for(double& b : result.barycentric)
      if(b < snapping_tolerance)
        b = 0.;
    return internal::canonical(m_coarse, result);
  }

  void add_curve(std::size_t curve, const std::vector<Surface_location>& polyline)
  {
    Surface_location last;
    Index last_vertex = none;
    for(const Surface_location& location : polyline)
    {
      const Surface_location next = snap(location);
      const Index vertex = add(next);
      m_result.m_vertices[curve].push_back(vertex);
      if(last_vertex != none && last_vertex != vertex)
        add_segment(curve, last, last_vertex, next, vertex);
      last = next;
      last_vertex = vertex;
    }
  }

  // Stores a segment between two consecutive vertices of a curve: as an interval of an edge if it
  // lies on one, otherwise as a constraint of the triangle.
  void add_segment(std::size_t curve, const Surface_location& p, Index p_vertex,
                   const Surface_location& q, Index q_vertex)
  {
    const Index triangle = common_triangle(m_coarse, p, q);
    const Barycentric a = *barycentric_in(m_coarse, triangle, p),
                      b = *barycentric_in(m_coarse, triangle, q);
    const Index k = common_edge(a, b);
    if(k == none)
    {
      m_interiors[triangle].segments.push_back({curve, {p_vertex, q_vertex}});
      return;
    }
    const Index h = 3 * triangle + k;
    double from = a[(k + 1) % 3], to = b[(k + 1) % 3];
    if(is_reversed(h))
    {
      from = 1. - from;
      to = 1. - to;
    }
    m_edges[canonical(h)].covered.push_back(std::minmax(from, to));
    m_covered_edges.push_back({curve, canonical(h), std::minmax(from, to)});
  }

  // Returns true if an edge between a and b must be split, because both are on curves or one is on
  // a curve and the other in a region.
  bool must_split_edge(Index a, Index b) const
  {
    return m_vertex_kind[a] != Vertex_kind::free && m_vertex_kind[b] != Vertex_kind::free &&
           !(m_vertex_kind[a] == Vertex_kind::region && m_vertex_kind[b] == Vertex_kind::region);
  }

  // Splits edges whose ends must not be connected, and sorts the points on all edges.
  void split_edges()
  {
    for(Index h = 0; h < m_coarse.corner.size(); ++h)
    {
      if(canonical(h) != h)
        continue;
      const Index from = m_coarse.corner[h], to = m_coarse.corner[next_halfedge(h)];
      const auto found = m_edges.find(h);
      if(found == m_edges.end())
      {
        if(must_split_edge(from, to))
          add_edge_point(h, 0.5, Vertex_kind::free);
        continue;
      }
      const Edge_data edge_data = found->second;
      std::vector<Edge_point> points = edge_data.points;
      points.push_back({0., from});
      points.push_back({1., to});
      std::sort(points.begin(), points.end(),
                [](const Edge_point& a, const Edge_point& b) { return a.parameter < b.parameter; });
      for(std::size_t i = 1; i < points.size(); ++i)
      {
        const double midpoint = 0.5 * (points[i - 1].parameter + points[i].parameter);
        const bool is_covered =
            std::any_of(edge_data.covered.begin(), edge_data.covered.end(),
                        [&](const auto& interval)
                        { return interval.first < midpoint && midpoint < interval.second; });
        if(!is_covered && must_split_edge(points[i - 1].vertex, points[i].vertex))
          add_edge_point(h, midpoint, Vertex_kind::free);
      }
    }
    for(auto& [h, edge_data] : m_edges)
      std::sort(edge_data.points.begin(), edge_data.points.end(),
                [](const Edge_point& a, const Edge_point& b) { return a.parameter < b.parameter; });
    // Adds the vertices of other curves on the same edge.
    for(const auto& [curve, h, interval] : m_covered_edges)
      for(const Edge_point& point : m_edges[h].points)
        if(interval.first <= point.parameter && point.parameter <= interval.second)
          m_result.m_vertices[curve].push_back(point.vertex);
  }

  bool is_split(Index triangle) const
  {
    if(m_interiors.count(triangle) > 0)
      return true;
    const Index* corner = &m_coarse.corner[3 * std::size_t(triangle)];
    for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
      if(const auto found = m_edges.find(canonical(h));
         found != m_edges.end() && !found->second.points.empty())
        return true;
    return must_split_triangle({corner[0], corner[1], corner[2]});
  }

  // Returns true if a triangle must be split: its corners are on curves or in regions, and at least
  // one is on a curve.
  bool must_split_triangle(const std::array<Index, 3>& corner) const
  {
    return m_vertex_kind[corner[0]] != Vertex_kind::free &&
           m_vertex_kind[corner[1]] != Vertex_kind::free &&
           m_vertex_kind[corner[2]] != Vertex_kind::free &&
           std::any_of(corner.begin(), corner.end(),
                       [&](Index vertex) { return m_vertex_kind[vertex] == Vertex_kind::curve; });
  }

  void split_triangles()
  {
    m_fine = m_coarse;
    m_fine.point.clear();
    m_fine.normal.clear();
    m_fine.ring.clear();
    m_fine.twin.resize(m_fine.corner.size(), none); // empty on a cloud
    for(Index triangle = 0; triangle < m_coarse.number_of_triangles(); ++triangle)
      if(is_split(triangle))
        triangulate(triangle);
    for(std::vector<Index>& vertices : m_result.m_vertices)
    {
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
  }

  // Computes the constrained Delaunay triangulation of a triangle with the curve segments. The
  // predicates and constructions are exact, so that points on an edge stay there.
  void triangulate(Index triangle)
  {
    auto corners = unfolded(m_coarse, triangle);
    if(!(corners[2][1] > 1e-7 * corners[1][0]))
      corners = {Vec2{0., 0.}, Vec2{1., 0.}, Vec2{0., 1.}};
    Constrained_triangulation triangulation;
    const std::map<Index, Vertex_handle> handles = insert_points(triangle, corners, triangulation);
    const std::vector<Segment>& segments = m_interiors[triangle].segments;
    for(const Segment& segment : segments)
      triangulation.insert_constraint(handles.at(segment.vertex[0]), handles.at(segment.vertex[1]));
    number_crossings(triangle, corners, triangulation);
    for(const Segment& segment : segments)
      list_vertices_on(
          {handles.at(segment.vertex[0])->point(), handles.at(segment.vertex[1])->point()},
          triangulation, m_result.m_vertices[segment.curve]);
    while(const auto point = find_split_point(triangulation))
      number_vertex(triangle, triangulation.insert(point->first), point->second, Vertex_kind::free);
    add_subtriangles(triangle, triangulation);
  }

  // Inserts the corners, the points on edges and the interior points. Returns the vertex handle of
  // each index.
  std::map<Index, Vertex_handle> insert_points(Index triangle, const std::array<Vec2, 3>& corners,
                                               Constrained_triangulation& triangulation) const
  {
    std::map<Index, Vertex_handle> handles;
    const auto insert = [&](const Barycentric& b, Index vertex)
    {
      const Vertex_handle v = triangulation.insert(exact_point(corners, b));
      v->info() = {vertex, b};
      handles.emplace(vertex, v);
    };
    for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
      insert(barycentric_at_corner(h), m_coarse.corner[h]);
    for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
      if(const auto found = m_edges.find(canonical(h)); found != m_edges.end())
        for(const Edge_point& point : found->second.points)
          insert(
              barycentric_on_halfedge(h, is_reversed(h) ? 1. - point.parameter : point.parameter),
              point.vertex);
    if(const auto found = m_interiors.find(triangle); found != m_interiors.end())
      for(const auto& [point, vertex] : found->second.points)
        insert(point, vertex);
    return handles;
  }

  void number_vertex(Index triangle, Vertex_handle v, const Barycentric& b, Vertex_kind kind)
  {
    v->info() = {add_new_vertex({triangle, none, b}, kind), b};
  }

  // Assigns indices to the crossings of segments, which the triangulation inserted.
  void number_crossings(Index triangle, const std::array<Vec2, 3>& corners,
                        const Constrained_triangulation& triangulation)
  {
    for(const Vertex_handle v : triangulation.finite_vertex_handles())
    {
      if(v->info().vertex != none)
        continue;
      const double last = to_double(v->point().y()) / corners[2][1];
      const double second = (to_double(v->point().x()) - last * corners[2][0]) / corners[1][0];
      number_vertex(triangle, v, {1. - last - second, second, last}, Vertex_kind::curve);
    }
  }

  // Appends the vertices on a segment.
  static void list_vertices_on(const Kernel::Segment_2& segment,
                               const Constrained_triangulation& triangulation,
                               std::vector<Index>& vertices)
  {
    for(const Vertex_handle v : triangulation.finite_vertex_handles())
      if(segment.has_on(v->point()))
        vertices.push_back(v->info().vertex);
  }

  // Returns the midpoint of an edge that must be split, or else the centroid of a triangle that
  // must be split. It is exact: if two vertices are very close, a rounded midpoint could coincide
  // with one.
  std::optional<std::pair<Kernel::Point_2, Barycentric>>
  find_split_point(const Constrained_triangulation& triangulation) const
  {
    for(const Constrained_triangulation::Edge& edge : triangulation.finite_edges())
    {
      const auto& [face, i] = edge;
      const auto a = face->vertex(Constrained_triangulation::ccw(i)),
                 b = face->vertex(Constrained_triangulation::cw(i));
      if(!triangulation.is_constrained(edge) && !triangulation.is_infinite(face) &&
         !triangulation.is_infinite(face->neighbor(i)) &&
         must_split_edge(a->info().vertex, b->info().vertex))
        return std::pair(CGAL::midpoint(a->point(), b->point()),
                         mean_coordinates({a->info().barycentric, b->info().barycentric}));
    }
    for(const Face_handle face : triangulation.finite_face_handles())
    {
      const auto a = face->vertex(0), b = face->vertex(1), c = face->vertex(2);
      if(must_split_triangle({a->info().vertex, b->info().vertex, c->info().vertex}))
        return std::pair(CGAL::centroid(a->point(), b->point(), c->point()),
                         mean_coordinates({a->info().barycentric, b->info().barycentric,
                                           c->info().barycentric}));
    }
    return std::nullopt;
  }

  // Copies the faces of the triangulation to the arrays. The twins of halfedges on the edges of the
  // parent are set later, by connect_subtriangles().
  void add_subtriangles(Index parent, const Constrained_triangulation& triangulation)
  {
    const auto parent_corners = unfolded(m_coarse, parent);
    std::map<Face_handle, Index> triangle_of_face;
    m_result.m_subtriangles_begin[parent] = m_result.m_subtriangles.size();
    for(const Face_handle face : triangulation.finite_face_handles())
    {
      const bool is_new = !triangle_of_face.empty();
      const Index triangle = is_new ? Index(m_fine.number_of_triangles()) : parent;
      triangle_of_face[face] = triangle;
      if(is_new)
      {
        m_fine.corner.resize(m_fine.corner.size() + 3);
        m_fine.length.resize(m_fine.corner.size());
        m_fine.twin.resize(m_fine.corner.size());
      }
      Subtriangle subtriangle;
      subtriangle.triangle = triangle;
      subtriangle.parent = parent;
      std::array<Vec2, 3> corners;
      for(int k = 0; k < 3; ++k)
      {
        const Vertex_info& info = face->vertex(k)->info();
        m_fine.corner[3 * triangle + Index(k)] = info.vertex;
        subtriangle.corner[k] = info.barycentric;
        corners[k] = unfolded_point(parent_corners, info.barycentric);
      }
      for(std::size_t k = 0; k < 3; ++k)
        m_fine.length[3 * triangle + k] =
            std::max(norm(corners[(k + 1) % 3] - corners[k]), min_edge_length);
      const Vec2 first_edge = corners[1] - corners[0];
      const double length = norm(first_edge);
      subtriangle.axis = length > 0. ? (1. / length) * first_edge : Vec2{1., 0.};
      m_result.m_subtriangles.push_back(subtriangle);
    }
    connect_faces(parent, triangulation, triangle_of_face);
  }

  // Sets the twins inside of a parent. Stores halfedges on its edges in m_subedges.
  void connect_faces(Index parent, const Constrained_triangulation& triangulation,
                     const std::map<Face_handle, Index>& triangle_of_face)
  {
    for(const auto& [face, triangle] : triangle_of_face)
      for(int k = 0; k < 3; ++k)
      {
        const Index h = 3 * triangle + Index(k);
        const auto neighbor = face->neighbor((k + 2) % 3);
        if(!triangulation.is_infinite(neighbor))
          m_fine.twin[h] =
              3 * triangle_of_face.at(neighbor) + (Index(neighbor->index(face)) + 1) % 3;
        else
        {
          const Barycentric &from = face->vertex(k)->info().barycentric,
                            &to = face->vertex((k + 1) % 3)->info().barycentric;
          const Index j = common_edge(from, to);
          m_subedges[3 * parent + j].emplace_back(from[(j + 1) % 3], h);
        }
      }
  }

  // Connects the halfedges on both sides of each edge, which are sorted by parameter. Twins get the
  // larger one of their rounded lengths. On a cloud there are no twins.
  void connect_subtriangles()
  {
    if(m_coarse.is_cloud())
    {
      m_fine.twin.assign(m_fine.corner.size(), none);
      build_rings(m_fine, m_vertex_kind.size());
      m_fine.twin.clear();
      m_fine.graph = {std::vector<Index>(m_vertex_kind.size() + 1, 0), {}, {}};
      m_fine.weight.resize(m_fine.number_of_triangles());
      for(const Subtriangle& subtriangle : m_result.m_subtriangles)
        m_fine.weight[subtriangle.triangle] = m_coarse.weight[subtriangle.parent];
      m_result.m_fine = std::make_shared<const Surface_arrays>(std::move(m_fine));
      return;
    }
    for(auto& [h, subedges] : m_subedges)
      std::sort(subedges.begin(), subedges.end());
    for(const auto& [h, subedges] : m_subedges)
    {
      const Index twin = m_coarse.twin[h];
      const auto twin_subedges = m_subedges.find(twin);
      for(std::size_t i = 0; i < subedges.size(); ++i)
      {
        const Index subedge = subedges[i].second;
        const Index other = twin == none ? none
                            : twin_subedges == m_subedges.end()
                                ? twin
                                : twin_subedges->second[subedges.size() - 1 - i].second;
        m_fine.twin[subedge] = other;
        if(other == none)
          continue;
        m_fine.twin[other] = subedge;
        m_fine.length[subedge] = m_fine.length[other] =
            std::max(m_fine.length[subedge], m_fine.length[other]);
      }
    }
    build_rings(m_fine, m_vertex_kind.size());
    m_result.m_fine = std::make_shared<const Surface_arrays>(std::move(m_fine));
  }

  struct Covered_edge
  {
    std::size_t curve;
    Index h;
    std::pair<double, double> interval;
  };

  Curve_embedding& m_result;
  const Surface_arrays& m_coarse;
  std::vector<Index> m_canonical;         // #halfedges: the first halfedge of the edge
  std::vector<Vertex_kind> m_vertex_kind; // #vertices, new ones included
  std::map<Index, Edge_data> m_edges;     // key: the canonical halfedge of an edge
  std::map<Index, Interior> m_interiors;  // key: triangle
  std::vector<Covered_edge> m_covered_edges;
  std::map<Index, std::vector<std::pair<double, Index>>> m_subedges;
  Surface_arrays m_fine;
};

Curve_embedding::Curve_embedding(std::shared_ptr<const Surface_arrays> triangles,
                                 const std::vector<std::vector<Surface_location>>& curves,
                                 const std::vector<Index>& region_vertices)
    : m_coarse(std::move(triangles))
{
  Builder(*this, curves, region_vertices);
}

} // namespace CGAL::Geodesic_processing::internal
