// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// How many of the nearest surfels each looks at: half of them on each side of a thin sheet still
// make a star.  Random samples of a plane need 28 on average before their Voronoi cell is certain;
// the cells that need more ask for up to `max_number_of_neighbors`.
constexpr std::size_t number_of_neighbors = 24;
constexpr std::size_t max_number_of_neighbors = 64;

double distance(const Vec3& a, const Vec3& b) { return norm(a - b); }

// The Voronoi cell of the origin of the plane, cut from a square by one half-plane after another.
class Voronoi_cell
{
public:
  explicit Voronoi_cell(double half_width)
  {
    m_corners = {{half_width, -half_width, none},
                 {half_width, half_width, none},
                 {-half_width, half_width, none},
                 {-half_width, -half_width, none}};
    m_squared_radius = 2. * half_width * half_width;
  }

  // Of the corner farthest from the origin.
  double squared_radius() const { return m_squared_radius; }

  // Keeps what lies on this side of the line x q = offset; a new edge gets the label.
  void clip(double qx, double qy, double offset, Index label)
  {
    const std::size_t n = m_corners.size();
    std::size_t outside = 0, any_outside = n;
    m_signed_distances.resize(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_signed_distances[i] = m_corners[i].x * qx + m_corners[i].y * qy - offset;
      if(m_signed_distances[i] > 0.)
      {
        ++outside;
        any_outside = i;
      }
    }
    if(outside == 0 || outside == n)
      return;
    // The corners outside are consecutive: from `begin` up to before `end`.
    std::size_t end = any_outside, begin = any_outside;
    while(m_signed_distances[end] > 0.)
      end = end + 1 == n ? 0 : end + 1;
    while(m_signed_distances[begin == 0 ? n - 1 : begin - 1] > 0.)
      begin = begin == 0 ? n - 1 : begin - 1;
    const std::size_t last_inside = begin == 0 ? n - 1 : begin - 1;
    const std::size_t last_outside = end == 0 ? n - 1 : end - 1;

    m_clipped.clear();
    for(std::size_t i = end;; i = i + 1 == n ? 0 : i + 1)
    {
      m_clipped.push_back(m_corners[i]);
      if(i == last_inside)
        break;
    }
    m_clipped.push_back(intersection(last_inside, begin, label));
    m_clipped.push_back(intersection(end, last_outside, m_corners[last_outside].edge));
    std::swap(m_corners, m_clipped);
    m_squared_radius = 0.;
    for(const Corner& c : m_corners)
      m_squared_radius = std::max(m_squared_radius, c.x * c.x + c.y * c.y);
  }

  struct Corner
  {
    double x, y;
    Index edge; // label of the edge to the next corner, counterclockwise
  };
  const std::vector<Corner>& corners() const { return m_corners; }

private:
  Corner intersection(std::size_t inside, std::size_t outside, Index edge) const
  {
    const Corner &a = m_corners[inside], &b = m_corners[outside];
    const double t =
        m_signed_distances[inside] / (m_signed_distances[inside] - m_signed_distances[outside]);
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), edge};
  }

  std::vector<Corner> m_corners, m_clipped;
  std::vector<double> m_signed_distances;
  double m_squared_radius;
};

// A number in [0, 1) for each site, without pattern.
double pseudo_random(Index v)
{
  std::uint64_t x = (v + 1ull) * 0x9e3779b97f4a7c15ull;
  x = (x ^ x >> 31) * 0xbf58476d1ce4e5b9ull;
  return static_cast<double>(x >> 11) * 0x1p-53;
}

// The sites that are no copies: all that the search for neighbours sees.
struct Distinct_surfels
{
  const std::vector<Vec3>& point;
  const std::vector<Vec3>& normal;
  const Kd_tree& tree;
  Compatibility_test compatibility_test;
  unsigned threads;

  std::size_t size() const { return tree.size(); }
  Compatibility compatibility(Index a, Index b) const
  {
    return compatibility_test(point[a], normal[a], point[b], normal[b]);
  }
};

// For each site the ends of its triangles, counterclockwise: a b and b c for triangles with the
// sides ab and bc, `none` between two that make no triangle, and after the last one if it makes
// none with the first.
Ragged_rows find_rings(const Distinct_surfels& surfels, const Ragged_rows& neighbors,
                       const std::vector<double>& search_radius, const std::vector<double>& radius)
{
  // Cocircular neighbours (lattices) get the same diagonal seen from each of them when the squared
  // distances are those of a power diagram, with weights far below what matters and far above
  // rounding.
  std::vector<double> weight(surfels.size(), 0.);
  for(Index i = 0; i < surfels.size(); ++i)
    if(neighbors.begin(i) != neighbors.end(i))
    {
      const double nearest = distance(surfels.point[i], surfels.point[*neighbors.begin(i)]);
      weight[i] = 1e-9 * pseudo_random(i) * nearest * nearest;
    }
  Ragged_rows rings(surfels.size());
  for_each_block(
      surfels.size(), surfel_block_size, surfels.threads,
      [&](std::size_t block, std::size_t begin, std::size_t end)
      {
        std::vector<Kd_tree::Neighbor> farther_neighbors;
        std::vector<Index> steep_neighbors;
        std::vector<Index>& ring = rings.buffer(block);
        for(Index i = static_cast<Index>(begin); i < end; rings.end_row(block, i++))
        {
          const double max_circumradius = max_circumradius_ratio * radius[i];
          if(!(max_circumradius > 0.))
            continue;
          const Vec3 center = surfels.point[i];
          const auto [u, v] = tangent_frame(surfels.normal[i]);
          const auto project = [&, &u = u, &v = v](Index j) -> std::array<double, 2>
          {
            const Vec3 chord = surfels.point[j] - center;
            return {dot(chord, u), dot(chord, v)};
          };
          Voronoi_cell cell(max_circumradius);
          const auto& corners = cell.corners();
          const auto has_triangle = [&](std::size_t corner)
          {
            const Voronoi_cell::Corner& c = corners[corner];
            const Index a = corners[corner == 0 ? corners.size() - 1 : corner - 1].edge, b = c.edge;
            if(a == none || b == none)
              return false;
            const double max_radius =
                max_circumradius_ratio * std::min({radius[i], radius[a], radius[b]});
            return c.x * c.x + c.y * c.y <= max_radius * max_radius &&
                   surfels.compatibility(a, b) != Compatibility::incompatible;
          };
          // Whether a triangle of the gentle neighbours lies in this direction.
          const auto is_covered = [&](const std::array<double, 2>& q)
          {
            for(std::size_t k = 0; k < corners.size(); ++k)
              if(has_triangle(k))
              {
                const auto a = project(corners[k == 0 ? corners.size() - 1 : k - 1].edge);
                const auto b = project(corners[k].edge);
                if(a[0] * q[1] >= a[1] * q[0] && q[0] * b[1] >= q[1] * b[0])
                  return true;
              }
            return false;
          };
          const auto clip = [&](Index j, bool only_in_gaps)
          {
            const auto q = project(j);
            const double squared_length = q[0] * q[0] + q[1] * q[1];
            // Enlarged: a line through a corner may cut it for the sake of the weights.
            if(squared_length <= 4.000001 * cell.squared_radius() &&
               !(only_in_gaps && is_covered(q)))
              cell.clip(q[0], q[1], (squared_length + weight[i] - weight[j]) / 2., j);
          };
          steep_neighbors.clear();
          const auto add_neighbor = [&](Index j)
          {
            const Compatibility compatibility = surfels.compatibility(i, j);
            if(compatibility == Compatibility::gentle)
              clip(j, false);
            else if(compatibility == Compatibility::steep)
              steep_neighbors.push_back(j);
          };
          std::for_each(neighbors.begin(i), neighbors.end(i), add_neighbor);
          const double needed_squared_radius =
              4.000001 * std::min(cell.squared_radius(), max_circumradius * max_circumradius);
          if(needed_squared_radius > search_radius[i] * search_radius[i])
          {
            surfels.tree.nearest(surfels.point, center, max_number_of_neighbors, farther_neighbors,
                                 needed_squared_radius);
            for(std::size_t k = std::min(number_of_neighbors + 1, farther_neighbors.size());
                k < farther_neighbors.size(); ++k)
              add_neighbor(farther_neighbors[k].point);
          }
          for(const Index j : steep_neighbors)
          {
            // Seen too steeply, a place in the plane means nothing.
            const auto q = project(j);
            const Vec3 chord = surfels.point[j] - center;
            if(16. * (q[0] * q[0] + q[1] * q[1]) > dot(chord, chord))
              clip(j, true);
          }

          const std::size_t n = corners.size(), ring_begin = ring.size();
          // Start behind a gap where there is one.
          std::size_t start = 0;
          while(start < n && has_triangle(start))
            ++start;
          if(start == n)
          {
            for(const Voronoi_cell::Corner& c : corners)
              ring.push_back(c.edge);
            continue;
          }
          for(std::size_t k = 1; k < n; ++k)
          {
            const std::size_t corner = (start + k) % n;
            if(!has_triangle(corner))
              continue;
            const Index a = corners[corner == 0 ? n - 1 : corner - 1].edge;
            if(ring.size() == ring_begin || ring.back() != a)
            {
              if(ring.size() != ring_begin)
                ring.push_back(none);
              ring.push_back(a);
            }
            ring.push_back(corners[corner].edge);
          }
          if(ring.size() != ring_begin)
            ring.push_back(none);
        }
      });
  rings.join();
  return rings;
}

// Whether the ring of a site has the triangle with the side from a to b.
bool ring_has_edge(const Ragged_rows& rings, Index vertex, Index a, Index b)
{
  const Index *begin = rings.begin(vertex), *end = rings.end(vertex);
  const Index* it = std::find(begin, end, a);
  if(it == end)
    return false;
  // An end may come twice: at the last and the first triangle of two fans.
  for(; it != end; it = std::find(it + 1, end, a))
    if((it + 1 == end ? *begin : it[1]) == b)
      return true;
  return false;
}

// Each triangle once, at the first site that found it.
void collect_triangles(const Ragged_rows& rings, unsigned threads, Surface_arrays& t)
{
  const std::size_t n = rings.row_begin.size() - 1;
  Ragged_rows corners(n);
  std::vector<std::vector<float>> weights((n + surfel_block_size - 1) / surfel_block_size);
  for_each_block(n, surfel_block_size, threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(const Index* it = rings.begin(i); it != rings.end(i); ++it)
                     {
                       const Index a = *it, b = it + 1 == rings.end(i) ? *rings.begin(i) : it[1];
                       if(a == none || b == none)
                         continue;
                       const bool is_in_ring_of_a = ring_has_edge(rings, a, b, i),
                                  is_in_ring_of_b = ring_has_edge(rings, b, i, a);
                       if((is_in_ring_of_a && a < i) || (is_in_ring_of_b && b < i))
                         continue;
                       corners.buffer(block).insert(corners.buffer(block).end(), {i, a, b});
                       weights[block].push_back(is_in_ring_of_a && is_in_ring_of_b
                                                    ? 1.f
                                                    : (1 + is_in_ring_of_a + is_in_ring_of_b) /
                                                          3.f);
                     }
                 });
  corners.join();
  t.corner = std::move(corners.entries);
  t.weight.reserve(t.corner.size() / 3);
  for(const auto& block_weights : weights)
    t.weight.insert(t.weight.end(), block_weights.begin(), block_weights.end());
}

// Arcs of the originals between spheres that meet and along the sides of triangles; copies hang at
// their originals.  Leaves `none` in `near` where two spheres do not meet.
void build_graph(const Distinct_surfels& surfels, Ragged_rows& neighbors,
                 const std::vector<double>& radius, const std::vector<Index>& original,
                 Surface_arrays& t)
{
  const std::size_t n = t.point.size(), m = surfels.size();
  for_each_block(m, surfel_block_size, surfels.threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(Index k = neighbors.row_begin[i]; k < neighbors.row_begin[i + 1]; ++k)
                     {
                       Index& j = neighbors.entries[k];
                       if(distance(t.point[i], t.point[j]) > radius[i] + radius[j] ||
                          surfels.compatibility(i, j) != Compatibility::gentle)
                         j = none;
                     }
                 });
  // Half of the arcs, some of them twice.
  std::vector<Index> row_begin(n + 1, 0), target;
  const auto for_each_edge = [&](const auto& visit)
  {
    for(Index i = 0; i < m; ++i)
      for(const Index* j = neighbors.begin(i); j != neighbors.end(i); ++j)
        if(*j != none)
          visit(i, *j);
    for(Index h = 0; h < t.corner.size(); ++h)
      visit(t.corner[h], t.corner[next_halfedge(h)]);
    for(Index i = static_cast<Index>(m); i < n; ++i)
      visit(i, original[i]);
  };
  for_each_edge([&](Index a, Index b) { ++row_begin[a + 1], ++row_begin[b + 1]; });
  std::partial_sum(row_begin.begin(), row_begin.end(), row_begin.begin());
  target.resize(row_begin.back());
  {
    std::vector<Index> end(row_begin.begin(), row_begin.end() - 1);
    for_each_edge([&](Index a, Index b) { target[end[a]++] = b, target[end[b]++] = a; });
  }
  Ragged_rows edges(n);
  for_each_block(n, surfel_block_size, surfels.threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   std::vector<Index>& buffer = edges.buffer(block);
                   for(std::size_t i = begin; i < end; ++i)
                   {
                     const auto row = target.begin() + row_begin[i],
                                row_end = target.begin() + row_begin[i + 1];
                     std::sort(row, row_end);
                     buffer.insert(buffer.end(), row, std::unique(row, row_end));
                     edges.end_row(block, i);
                   }
                 });
  edges.join();
  t.graph.begin = std::move(edges.row_begin);
  t.graph.target = std::move(edges.entries);
}

// Lengths of arcs and sides, the longest of all brought to [1, 2) together with all other lengths.
void compute_lengths(Surfel_arrays& surfels, unsigned threads)
{
  Surface_arrays& t = surfels.arrays;
  const std::size_t n = t.point.size();
  t.graph.length.resize(t.graph.target.size());
  for_each_block(n, surfel_block_size, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(std::size_t i = begin; i < end; ++i)
                     for(Index e = t.graph.begin[i]; e < t.graph.begin[i + 1]; ++e)
                       t.graph.length[e] = distance(t.point[i], t.point[t.graph.target[e]]);
                 });
  double longest = 0.;
  for(const double length : t.graph.length)
    longest = std::max(longest, length);
  // Sides are arcs.
  const int exponent = longest > 0. ? std::ilogb(longest) : 0;
  const double factor = std::ldexp(1., -exponent);
  for(double& length : t.graph.length)
    length *= factor;
  for(double& radius : surfels.radius)
    radius *= factor;
  surfels.tree.scale(factor);
  for(Vec3& point : t.point)
    for(double& x : point)
      x *= factor;
  t.scale = std::ldexp(t.scale, exponent);
  t.length.resize(t.corner.size());
  for(Index h = 0; h < t.corner.size(); ++h)
    t.length[h] = distance(t.point[t.corner[h]], t.point[t.corner[next_halfedge(h)]]);
}

void build_rings(Surface_arrays& t)
{
  t.ring_begin.assign(t.point.size() + 1, 0);
  for(const Index v : t.corner)
    ++t.ring_begin[v + 1];
  std::partial_sum(t.ring_begin.begin(), t.ring_begin.end(), t.ring_begin.begin());
  std::vector<Index> end(t.ring_begin.begin(), t.ring_begin.end() - 1);
  t.ring.resize(t.corner.size());
  for(Index corner = 0; corner < t.corner.size(); ++corner)
    t.ring[end[t.corner[corner]]++] = corner;
}

} // namespace

Surfel_arrays build_surfel_arrays(std::vector<std::array<double, 3>> points,
                                  std::vector<std::array<double, 3>> normals,
                                  const std::vector<double>& radii, const Surfel_options& options)
{
  const std::size_t n = points.size();
  check_sizes(n, normals.size(), radii.size());
  if(!(options.maximum_angle > 0.) || options.maximum_angle > std::acos(-1.) || options.rank == 0)
    throw Invalid_argument_error("The angle between neighbours must lie between 0 and pi, and the "
                                 "rank of the neighbour that gives the radius above 0.");
  Surfel_arrays result;
  Surface_arrays& t = result.arrays;
  const Compatibility_test compatibility_test = {std::cos(options.maximum_angle)};
  normalize(normals);
  Sorted_surfels sorted =
      sort_surfels(std::move(points), normals, compatibility_test.cosine, options.threads);
  t.origin = sorted.frame.origin;
  t.scale = sorted.frame.scale;
  Neighbor_distances distances;
  Ragged_rows neighbors =
      find_neighbors(sorted.point, sorted.normal, sorted.tree, &compatibility_test,
                     number_of_neighbors, options.threads, distances);
  neighbors.join();
  result.radius = surfel_radii(sorted, radii, neighbors, options.rank, options.threads);

  result.tree = std::move(sorted.tree);
  t.point = std::move(sorted.point);
  t.normal = std::move(sorted.normal);
  result.internal_vertex = std::move(sorted.internal_vertex);
  result.caller_vertex = std::move(sorted.caller_vertex);

  // Behind the sites of the tree come copies of them.
  std::vector<Index> copy_of(n);
  for(Index i = 0; i < n; ++i)
    if(Index& vertex = result.internal_vertex[i]; result.caller_vertex[vertex] != i)
    {
      const auto copy = static_cast<Index>(t.point.size());
      copy_of[copy] = vertex;
      t.point.push_back(t.point[vertex]);
      t.normal.push_back(normals[i]);
      result.radius.push_back(result.radius[vertex]);
      result.caller_vertex.push_back(i);
      vertex = copy;
    }
  const Distinct_surfels surfels = {t.point, t.normal, result.tree, compatibility_test,
                                    options.threads};
  {
    const Ragged_rows rings =
        find_rings(surfels, neighbors, distances.search_radius, result.radius);
    distances = {};
    collect_triangles(rings, options.threads, t);
  }
  build_graph(surfels, neighbors, result.radius, copy_of, t);
  compute_lengths(result, options.threads);
  build_rings(t);
  return result;
}

Tangent_location locate(const Kd_tree& tree, const std::vector<Vec3>& points,
                        const std::vector<Vec3>& normals, const std::vector<double>& radii,
                        const Frame& frame, const std::array<double, 3>& point)
{
  if(tree.size() == 0)
    throw Invalid_argument_error("There is nothing to locate a point on: the surface is empty.");
  Vec3 query;
  for(int k = 0; k < 3; ++k)
  {
    if(!std::isfinite(point[k]))
      throw Invalid_argument_error("The coordinates of the point to locate are not finite.");
    // So far away that only the direction matters, and squares still do not overflow.
    query[k] = std::clamp(std::ldexp(point[k], -std::ilogb(frame.scale)) -
                              std::ldexp(frame.origin[k], -std::ilogb(frame.scale)),
                          -1e100, 1e100);
  }
  Tangent_location location;
  location.vertex = tree.nearest(points, query);
  const Vec3 offset = query - points[location.vertex];
  const auto [u, v] = tangent_frame(normals[location.vertex]);
  const double x = dot(offset, u), y = dot(offset, v), length = std::hypot(x, y);
  const double max_offset = max_circumradius_ratio * radii[location.vertex];
  const double shrink_factor = length > max_offset ? max_offset / length : 1.;
  location.offset = {shrink_factor * x, shrink_factor * y};
  return location;
}

Surface_location to_surface_location(const Surface_arrays& t, const Tangent_location& location)
{
  Surface_location result;
  result.vertex = location.vertex;
  if(location.offset[0] == 0. && location.offset[1] == 0.)
    return result;
  const auto frame = tangent_frame(t.normal[location.vertex]);
  double min_distance = infinity;
  const auto try_triangle = [&](Index triangle)
  {
    const std::array<Index, 3> corners = {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
    std::array<std::array<double, 2>, 3> p; // seen from the location
    for(int k = 0; k < 3; ++k)
    {
      const Vec3 offset_vector = t.point[t.corner[corners[k]]] - t.point[location.vertex];
      p[k] = {dot(offset_vector, frame.first) - location.offset[0],
              dot(offset_vector, frame.second) - location.offset[1]};
    }
    const auto doubled_area = [&](int i, int j) { return p[i][0] * p[j][1] - p[i][1] * p[j][0]; };
    std::array<double, 3> barycentric = {doubled_area(1, 2), doubled_area(2, 0),
                                         doubled_area(0, 1)};
    const double area = barycentric[0] + barycentric[1] + barycentric[2];
    if(!(area > 0.))
      return;
    double distance_outside = 0.;
    if(barycentric[0] < 0. || barycentric[1] < 0. || barycentric[2] < 0.)
    {
      // The nearest place on the three sides.
      distance_outside = infinity;
      for(int k = 0; k < 3; ++k)
      {
        const int next = (k + 1) % 3;
        const double dx = p[next][0] - p[k][0], dy = p[next][1] - p[k][1];
        const double squared_length = dx * dx + dy * dy;
        const double fraction =
            squared_length > 0.
                ? std::clamp(-(p[k][0] * dx + p[k][1] * dy) / squared_length, 0., 1.)
                : 0.;
        const double distance = std::hypot(p[k][0] + fraction * dx, p[k][1] + fraction * dy);
        if(distance < distance_outside)
        {
          distance_outside = distance;
          barycentric = {0., 0., 0.};
          barycentric[k] = 1. - fraction;
          barycentric[next] = fraction;
        }
      }
    }
    else
      for(double& x : barycentric)
        x /= area;
    if(distance_outside < min_distance)
    {
      min_distance = distance_outside;
      result = {triangle, none, barycentric};
    }
  };
  for(Index i = t.ring_begin[location.vertex]; i < t.ring_begin[location.vertex + 1]; ++i)
    try_triangle(t.ring[i] / 3);
  // Delaunay triangles around a place need not have the site that is the nearest to it as a corner.
  if(min_distance > 0.)
    for(Index i = t.graph.begin[location.vertex]; i < t.graph.begin[location.vertex + 1]; ++i)
    {
      const Index neighbor = t.graph.target[i];
      for(Index k = t.ring_begin[neighbor]; k < t.ring_begin[neighbor + 1]; ++k)
        try_triangle(t.ring[k] / 3);
    }
  return result;
}

Tangent_location to_tangent_location(const Surface_arrays& t, const Surface_location& location)
{
  if(location.triangle == none)
    return {location.vertex, {0., 0.}};
  const auto& b = location.barycentric;
  const Index largest = static_cast<Index>(std::max_element(b.begin(), b.end()) - b.begin());
  Tangent_location result;
  result.vertex = t.corner[3 * location.triangle + largest];
  const auto [u, v] = tangent_frame(t.normal[result.vertex]);
  for(Index k = 0; k < 3; ++k)
  {
    const Vec3 edge_vector = t.point[t.corner[3 * location.triangle + k]] - t.point[result.vertex];
    result.offset[0] += b[k] * dot(edge_vector, u);
    result.offset[1] += b[k] * dot(edge_vector, v);
  }
  return result;
}

std::array<double, 3> position(const Surface_arrays& t, const Tangent_location& location)
{
  const auto [u, v] = tangent_frame(t.normal[location.vertex]);
  std::array<double, 3> result = t.point[location.vertex];
  for(int k = 0; k < 3; ++k)
    result[k] += location.offset[0] * u[k] + location.offset[1] * v[k];
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
