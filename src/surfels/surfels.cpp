// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/locality.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// How many of the nearest surfels each looks at: half of them on each side of a thin sheet still
// make a star.  Random samples of a plane need 28 on average before their Voronoi cell is certain;
// the cells that need more ask for up to `most_neighbors`.
constexpr std::size_t neighbors = 24;
constexpr std::size_t most_neighbors = 64;

double distance(const Spatial& a, const Spatial& b) { return norm(a - b); }

// The Voronoi cell of the origin of the plane, cut from a square by one half-plane after another.
class Cell
{
public:
  explicit Cell(double half_side)
  {
    m_corners = {{half_side, -half_side, none},
                 {half_side, half_side, none},
                 {-half_side, half_side, none},
                 {-half_side, -half_side, none}};
    m_squared_radius = 2. * half_side * half_side;
  }

  // Of the corner farthest from the origin.
  double squared_radius() const { return m_squared_radius; }

  // Keeps what lies on this side of the line x q = offset; a new edge gets the label.
  void cut(double qx, double qy, double offset, Index label)
  {
    const std::size_t n = m_corners.size();
    std::size_t outside = 0, some = n;
    m_excess.resize(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_excess[i] = m_corners[i].x * qx + m_corners[i].y * qy - offset;
      if(m_excess[i] > 0.)
      {
        ++outside;
        some = i;
      }
    }
    if(outside == 0 || outside == n)
      return;
    // The corners outside are consecutive: from `begin` up to before `end`.
    std::size_t end = some, begin = some;
    while(m_excess[end] > 0.)
      end = end + 1 == n ? 0 : end + 1;
    while(m_excess[begin == 0 ? n - 1 : begin - 1] > 0.)
      begin = begin == 0 ? n - 1 : begin - 1;
    const std::size_t before = begin == 0 ? n - 1 : begin - 1;
    const std::size_t last = end == 0 ? n - 1 : end - 1;

    m_next.clear();
    for(std::size_t i = end;; i = i + 1 == n ? 0 : i + 1)
    {
      m_next.push_back(m_corners[i]);
      if(i == before)
        break;
    }
    m_next.push_back(crossing(before, begin, label));
    m_next.push_back(crossing(end, last, m_corners[last].edge));
    std::swap(m_corners, m_next);
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
  Corner crossing(std::size_t inside, std::size_t outside, Index edge) const
  {
    const Corner &a = m_corners[inside], &b = m_corners[outside];
    const double t = m_excess[inside] / (m_excess[inside] - m_excess[outside]);
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), edge};
  }

  std::vector<Corner> m_corners, m_next;
  std::vector<double> m_excess;
  double m_squared_radius;
};

// A number in [0, 1) for each site, without pattern.
double shuffled(Index site)
{
  std::uint64_t x = (site + 1ull) * 0x9e3779b97f4a7c15ull;
  x = (x ^ x >> 31) * 0xbf58476d1ce4e5b9ull;
  return static_cast<double>(x >> 11) * 0x1p-53;
}

// The sites that are no copies: all that the search for neighbours sees.
struct Sites
{
  const std::vector<Spatial>& point;
  const std::vector<Spatial>& normal;
  const Kd_tree& tree;
  Agree agree;
  unsigned threads;

  std::size_t size() const { return tree.size(); }
  Agreement agreement(Index a, Index b) const
  {
    return agree(point[a], normal[a], point[b], normal[b]);
  }
};

// For each site the ends of its triangles, counterclockwise: a b and b c for triangles with the
// sides ab and bc, `none` between two that make no triangle, and after the last one if it makes
// none with the first.
Rows find_rings(const Sites& sites, const Rows& near, const std::vector<double>& reach,
                const std::vector<double>& radius)
{
  // Cocircular neighbours (lattices) get the same diagonal seen from each of them when the squared
  // distances are those of a power diagram, with weights far below what matters and far above
  // rounding.
  std::vector<double> weight(sites.size(), 0.);
  for(Index i = 0; i < sites.size(); ++i)
    if(near.begin(i) != near.end(i))
    {
      const double nearest = distance(sites.point[i], sites.point[*near.begin(i)]);
      weight[i] = 1e-9 * shuffled(i) * nearest * nearest;
    }
  Rows rings(sites.size());
  for_each_block(
      sites.size(), surfel_block, sites.threads,
      [&](std::size_t block, std::size_t begin, std::size_t end)
      {
        std::vector<Kd_tree::Neighbor> more;
        std::vector<Index> steep;
        std::vector<Index>& ring = rings.part(block);
        for(Index i = static_cast<Index>(begin); i < end; rings.end_row(block, i++))
        {
          const double limit = largest_circumradius * radius[i];
          if(!(limit > 0.))
            continue;
          const Spatial center = sites.point[i];
          const auto [u, v] = tangent_frame(sites.normal[i]);
          const auto project = [&, &u = u, &v = v](Index j) -> std::array<double, 2>
          {
            const Spatial chord = sites.point[j] - center;
            return {dot(chord, u), dot(chord, v)};
          };
          Cell cell(limit);
          const auto& corners = cell.corners();
          const auto makes_triangle = [&](std::size_t corner)
          {
            const Cell::Corner& c = corners[corner];
            const Index a = corners[corner == 0 ? corners.size() - 1 : corner - 1].edge, b = c.edge;
            if(a == none || b == none)
              return false;
            const double most = largest_circumradius * std::min({radius[i], radius[a], radius[b]});
            return c.x * c.x + c.y * c.y <= most * most && sites.agreement(a, b) != Agreement::no;
          };
          // Whether a triangle of the gentle neighbours lies in this direction.
          const auto is_covered = [&](const std::array<double, 2>& q)
          {
            for(std::size_t k = 0; k < corners.size(); ++k)
              if(makes_triangle(k))
              {
                const auto a = project(corners[k == 0 ? corners.size() - 1 : k - 1].edge);
                const auto b = project(corners[k].edge);
                if(a[0] * q[1] >= a[1] * q[0] && q[0] * b[1] >= q[1] * b[0])
                  return true;
              }
            return false;
          };
          const auto cut = [&](Index j, bool where_open)
          {
            const auto q = project(j);
            const double square = q[0] * q[0] + q[1] * q[1];
            // Enlarged: a line through a corner may cut it for the sake of the weights.
            if(square <= 4.000001 * cell.squared_radius() && !(where_open && is_covered(q)))
              cell.cut(q[0], q[1], (square + weight[i] - weight[j]) / 2., j);
          };
          steep.clear();
          const auto consider = [&](Index j)
          {
            const Agreement agreement = sites.agreement(i, j);
            if(agreement == Agreement::gentle)
              cut(j, false);
            else if(agreement == Agreement::steep)
              steep.push_back(j);
          };
          std::for_each(near.begin(i), near.end(i), consider);
          const double needed = 4.000001 * std::min(cell.squared_radius(), limit * limit);
          if(needed > reach[i] * reach[i])
          {
            sites.tree.nearest(sites.point, center, most_neighbors, more, needed);
            for(std::size_t k = std::min(neighbors + 1, more.size()); k < more.size(); ++k)
              consider(more[k].point);
          }
          for(const Index j : steep)
          {
            // Seen too steeply, a place in the plane means nothing.
            const auto q = project(j);
            const Spatial chord = sites.point[j] - center;
            if(16. * (q[0] * q[0] + q[1] * q[1]) > dot(chord, chord))
              cut(j, true);
          }

          const std::size_t n = corners.size(), ring_begin = ring.size();
          // Start behind a gap where there is one.
          std::size_t start = 0;
          while(start < n && makes_triangle(start))
            ++start;
          if(start == n)
          {
            for(const Cell::Corner& c : corners)
              ring.push_back(c.edge);
            continue;
          }
          for(std::size_t k = 1; k < n; ++k)
          {
            const std::size_t corner = (start + k) % n;
            if(!makes_triangle(corner))
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
bool has_side(const Rows& rings, Index site, Index a, Index b)
{
  const Index *begin = rings.begin(site), *end = rings.end(site);
  const Index* at = std::find(begin, end, a);
  if(at == end)
    return false;
  // An end may come twice: at the last and the first triangle of two fans.
  for(; at != end; at = std::find(at + 1, end, a))
    if((at + 1 == end ? *begin : at[1]) == b)
      return true;
  return false;
}

// Each triangle once, at the first site that found it.
void collect_triangles(const Rows& rings, unsigned threads, Glued_triangles& t)
{
  const std::size_t n = rings.first.size() - 1;
  Rows corners(n);
  std::vector<std::vector<float>> weights((n + surfel_block - 1) / surfel_block);
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(const Index* at = rings.begin(i); at != rings.end(i); ++at)
                     {
                       const Index a = *at, b = at + 1 == rings.end(i) ? *rings.begin(i) : at[1];
                       if(a == none || b == none)
                         continue;
                       const bool by_a = has_side(rings, a, b, i), by_b = has_side(rings, b, i, a);
                       if((by_a && a < i) || (by_b && b < i))
                         continue;
                       corners.part(block).insert(corners.part(block).end(), {i, a, b});
                       weights[block].push_back(by_a && by_b ? 1.f : (1 + by_a + by_b) / 3.f);
                     }
                 });
  corners.join();
  t.corner = std::move(corners.entries);
  t.weight.reserve(t.corner.size() / 3);
  for(const auto& part : weights)
    t.weight.insert(t.weight.end(), part.begin(), part.end());
}

// Arcs of the originals between spheres that meet and along the sides of triangles; copies hang at
// their originals.  Leaves `none` in `near` where two spheres do not meet.
void build_graph(const Sites& sites, Rows& near, const std::vector<double>& radius,
                 const std::vector<Index>& original, Glued_triangles& t)
{
  const std::size_t n = t.point.size(), m = sites.size();
  for_each_block(m, surfel_block, sites.threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(Index k = near.first[i]; k < near.first[i + 1]; ++k)
                     {
                       Index& j = near.entries[k];
                       if(distance(t.point[i], t.point[j]) > radius[i] + radius[j] ||
                          sites.agreement(i, j) != Agreement::gentle)
                         j = none;
                     }
                 });
  // Half of the arcs, some of them twice.
  std::vector<Index> first(n + 1, 0), target;
  const auto each = [&](const auto& visit)
  {
    for(Index i = 0; i < m; ++i)
      for(const Index* j = near.begin(i); j != near.end(i); ++j)
        if(*j != none)
          visit(i, *j);
    for(Index side = 0; side < t.corner.size(); ++side)
      visit(t.corner[side], t.corner[next_side(side)]);
    for(Index i = static_cast<Index>(m); i < n; ++i)
      visit(i, original[i]);
  };
  each([&](Index a, Index b) { ++first[a + 1], ++first[b + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  target.resize(first.back());
  {
    std::vector<Index> end(first.begin(), first.end() - 1);
    each([&](Index a, Index b) { target[end[a]++] = b, target[end[b]++] = a; });
  }
  Rows arcs(n);
  for_each_block(n, surfel_block, sites.threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   std::vector<Index>& part = arcs.part(block);
                   for(std::size_t i = begin; i < end; ++i)
                   {
                     const auto row = target.begin() + first[i],
                                row_end = target.begin() + first[i + 1];
                     std::sort(row, row_end);
                     part.insert(part.end(), row, std::unique(row, row_end));
                     arcs.end_row(block, i);
                   }
                 });
  arcs.join();
  t.graph.first = std::move(arcs.first);
  t.graph.target = std::move(arcs.entries);
}

// Lengths of arcs and sides, the longest of all brought to [1, 2) together with all other lengths.
void measure(Glued_surfels& surfels, unsigned threads)
{
  Glued_triangles& t = surfels.triangles;
  const std::size_t n = t.point.size();
  t.graph.length.resize(t.graph.target.size());
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(std::size_t i = begin; i < end; ++i)
                     for(Index arc = t.graph.first[i]; arc < t.graph.first[i + 1]; ++arc)
                       t.graph.length[arc] = distance(t.point[i], t.point[t.graph.target[arc]]);
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
  for(Spatial& point : t.point)
    for(double& x : point)
      x *= factor;
  t.scale = std::ldexp(t.scale, exponent);
  t.length.resize(t.corner.size());
  for(Index side = 0; side < t.corner.size(); ++side)
    t.length[side] = distance(t.point[t.corner[side]], t.point[t.corner[next_side(side)]]);
}

void build_stars(Glued_triangles& t)
{
  t.first.assign(t.point.size() + 1, 0);
  for(const Index site : t.corner)
    ++t.first[site + 1];
  std::partial_sum(t.first.begin(), t.first.end(), t.first.begin());
  std::vector<Index> end(t.first.begin(), t.first.end() - 1);
  t.star.resize(t.corner.size());
  for(Index corner = 0; corner < t.corner.size(); ++corner)
    t.star[end[t.corner[corner]]++] = corner;
}

} // namespace

Glued_surfels glue_surfels(std::vector<std::array<double, 3>> points,
                           std::vector<std::array<double, 3>> normals,
                           const std::vector<double>& radii, const Surfel_options& options)
{
  const std::size_t n = points.size();
  check_sizes(n, normals.size(), radii.size());
  if(!(options.maximum_angle > 0.) || options.maximum_angle > std::acos(-1.) || options.rank == 0)
    throw Invalid_argument_error("The angle between neighbours must lie between 0 and pi, and the "
                                 "rank of the neighbour that gives the radius above 0.");
  Glued_surfels result;
  Glued_triangles& t = result.triangles;
  const Agree agree = {std::cos(options.maximum_angle)};
  normalize(normals);
  Sorted_surfels sorted = sort_surfels(std::move(points), normals, agree.cosine, options.threads);
  t.origin = sorted.frame.origin;
  t.scale = sorted.frame.scale;
  Surroundings around;
  Rows near = find_neighbors(sorted.point, sorted.normal, sorted.tree, &agree, neighbors,
                             options.threads, around);
  near.join();
  result.radius = site_radii(sorted, radii, near, options.rank, options.threads);

  result.tree = std::move(sorted.tree);
  t.point = std::move(sorted.point);
  t.normal = std::move(sorted.normal);
  result.site_of_surfel = std::move(sorted.site_of_surfel);
  result.surfel_of_site = std::move(sorted.surfel_of_site);

  // Behind the sites of the tree come copies of them.
  std::vector<Index> copy_of(n);
  for(Index i = 0; i < n; ++i)
    if(Index& site = result.site_of_surfel[i]; result.surfel_of_site[site] != i)
    {
      const auto copy = static_cast<Index>(t.point.size());
      copy_of[copy] = site;
      t.point.push_back(t.point[site]);
      t.normal.push_back(normals[i]);
      result.radius.push_back(result.radius[site]);
      result.surfel_of_site.push_back(i);
      site = copy;
    }
  const Sites sites = {t.point, t.normal, result.tree, agree, options.threads};
  {
    const Rows rings = find_rings(sites, near, around.seen, result.radius);
    around = {};
    collect_triangles(rings, options.threads, t);
  }
  build_graph(sites, near, result.radius, copy_of, t);
  measure(result, options.threads);
  build_stars(t);
  return result;
}

Tangent_location locate(const Kd_tree& tree, const std::vector<Spatial>& points,
                        const std::vector<Spatial>& normals, const std::vector<double>& radii,
                        const Frame& frame, const std::array<double, 3>& point)
{
  if(tree.size() == 0)
    throw Invalid_argument_error("There is nothing to locate a point on: the surface is empty.");
  Spatial query;
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
  location.site = tree.nearest(points, query);
  const Spatial offset = query - points[location.site];
  const auto [u, v] = tangent_frame(normals[location.site]);
  const double x = dot(offset, u), y = dot(offset, v), length = std::hypot(x, y);
  const double most = largest_circumradius * radii[location.site];
  const double shrink = length > most ? most / length : 1.;
  location.offset = {shrink * x, shrink * y};
  return location;
}

Location to_triangle(const Glued_triangles& t, const Tangent_location& location)
{
  Location result;
  result.site = location.site;
  if(location.offset[0] == 0. && location.offset[1] == 0.)
    return result;
  const auto frame = tangent_frame(t.normal[location.site]);
  double best = infinity;
  const auto try_triangle = [&](Index triangle)
  {
    const std::array<Index, 3> corners = {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
    std::array<std::array<double, 2>, 3> p; // seen from the location
    for(int k = 0; k < 3; ++k)
    {
      const Spatial way = t.point[t.corner[corners[k]]] - t.point[location.site];
      p[k] = {dot(way, frame.first) - location.offset[0],
              dot(way, frame.second) - location.offset[1]};
    }
    const auto cross = [&](int i, int j) { return p[i][0] * p[j][1] - p[i][1] * p[j][0]; };
    std::array<double, 3> share = {cross(1, 2), cross(2, 0), cross(0, 1)};
    const double area = share[0] + share[1] + share[2];
    if(!(area > 0.))
      return;
    double miss = 0.;
    if(share[0] < 0. || share[1] < 0. || share[2] < 0.)
    {
      // The nearest place on the three sides.
      miss = infinity;
      for(int k = 0; k < 3; ++k)
      {
        const int next = (k + 1) % 3;
        const double dx = p[next][0] - p[k][0], dy = p[next][1] - p[k][1];
        const double square = dx * dx + dy * dy;
        const double along =
            square > 0. ? std::clamp(-(p[k][0] * dx + p[k][1] * dy) / square, 0., 1.) : 0.;
        const double distance = std::hypot(p[k][0] + along * dx, p[k][1] + along * dy);
        if(distance < miss)
        {
          miss = distance;
          share = {0., 0., 0.};
          share[k] = 1. - along;
          share[next] = along;
        }
      }
    }
    else
      for(double& x : share)
        x /= area;
    if(miss < best)
    {
      best = miss;
      result = {triangle, none, share};
    }
  };
  for(Index i = t.first[location.site]; i < t.first[location.site + 1]; ++i)
    try_triangle(t.star[i] / 3);
  // Delaunay triangles around a place need not have the site that is the nearest to it as a corner.
  if(best > 0.)
    for(Index i = t.graph.first[location.site]; i < t.graph.first[location.site + 1]; ++i)
    {
      const Index near = t.graph.target[i];
      for(Index k = t.first[near]; k < t.first[near + 1]; ++k)
        try_triangle(t.star[k] / 3);
    }
  return result;
}

Tangent_location to_surfel(const Glued_triangles& t, const Location& location)
{
  if(location.triangle == none)
    return {location.site, {0., 0.}};
  const auto& b = location.barycentric;
  const Index largest = static_cast<Index>(std::max_element(b.begin(), b.end()) - b.begin());
  Tangent_location result;
  result.site = t.corner[3 * location.triangle + largest];
  const auto [u, v] = tangent_frame(t.normal[result.site]);
  for(Index k = 0; k < 3; ++k)
  {
    const Spatial side = t.point[t.corner[3 * location.triangle + k]] - t.point[result.site];
    result.offset[0] += b[k] * dot(side, u);
    result.offset[1] += b[k] * dot(side, v);
  }
  return result;
}

std::array<double, 3> position(const Glued_triangles& t, const Tangent_location& location)
{
  const auto [u, v] = tangent_frame(t.normal[location.site]);
  std::array<double, 3> result = t.point[location.site];
  for(int k = 0; k < 3; ++k)
    result[k] += location.offset[0] * u[k] + location.offset[1] * v[k];
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
