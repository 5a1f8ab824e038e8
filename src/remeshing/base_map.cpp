// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_map.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "mesh/Split_mesh.h"
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include "core/exact_predicates.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Barycentric = std::array<double, 3>;

// Minimum weight of a neighbor in a convex combination, relative to the sum. With smaller weights
// vertices coincide up to round-off errors, and triangles are inverted.
constexpr double min_weight = 1e-7;
// A triangle counts as inverted if its image is flatter than the triangle by this factor. Round-off
// errors of 1e-16 in the image then are errors of 1e-8 edge lengths on the mesh, the tolerance of
// inverse().
constexpr double min_height_ratio = 1e-8;
// Minimum distance of consecutive vertices of a path, relative to its length, in the
// parameterization of the base edge.
constexpr double min_step_ratio = 1e-12;
// Maximum tangent of half an angle in mean value weights. It is exceeded by needles only.
constexpr double max_tangent = 1e4;
// Maximum number of times that samples are added in regions with inverted triangles.
constexpr unsigned max_rounds = 10;

// Sorts indices by group: the members of group g are items[offsets[g]], ..., items[offsets[g + 1] -
// 1].
void group(const std::vector<Index>& group_of, std::size_t number, std::vector<Index>& offsets,
           std::vector<Index>& items)
{
  offsets.assign(number + 1, 0);
  for(const Index g : group_of)
    ++offsets[g + 1];
  for(std::size_t g = 0; g < number; ++g)
    offsets[g + 1] += offsets[g];
  items.resize(group_of.size());
  std::vector<Index> next(offsets.begin(), offsets.end() - 1);
  for(Index i = 0; i < group_of.size(); ++i)
    items[next[group_of[i]]++] = i;
}

// Returns barycentric coordinates with negative values set to zero and the sum normalized to one.
Barycentric clamp_barycentric(Barycentric b)
{
  double sum = 0.;
  for(double& x : b)
    sum += x = std::max(x, 0.);
  for(double& x : b)
    x /= sum;
  return b;
}

Barycentric interpolate(const Barycentric& b, const std::array<Barycentric, 3>& corner)
{
  Barycentric result;
  for(std::size_t j = 0; j < 3; ++j)
    result[j] = b[0] * corner[0][j] + b[1] * corner[1][j] + b[2] * corner[2][j];
  return result;
}

using Image = std::array<Barycentric, 3>; // of the corners of a triangle

// Returns the corners of an image in affine coordinates that have small round-off errors.
std::array<Vec2, 3> planar_image(const Image& image)
{
  const std::size_t k = dominant_coordinate(image), i = (k + 1) % 3, j = (k + 2) % 3;
  return {{{image[0][i], image[0][j]}, {image[1][i], image[1][j]}, {image[2][i], image[2][j]}}};
}

bool is_inverted(const Image& image)
{
  const auto [a, b, c] = planar_image(image);
  return orientation(a, b, c) <= 0;
}

} // namespace

class Base_map::Builder
{
public:
  Builder(Base_map& result, Base_coordinates kind, bool does_repair)
      : m_result(result), m_base(*result.m_base), m_fine(m_base.fine), m_kind(kind),
        m_does_repair(does_repair), m_local_index(m_fine.number_of_vertices(), none)
  {
    compute_edge_parameters();
    if(kind == Base_coordinates::heron)
      compute_distances();
    for(Index f = 0; f < m_base.triangles.size(); ++f)
      map_region(f);
  }

private:
  // Computes the arc length parameter in [0, 1] of each vertex on a base edge; -1 for other
  // vertices.
  void compute_edge_parameters()
  {
    m_edge_parameter.assign(m_fine.number_of_vertices(), -1.);
    for(const std::vector<Index>& path : m_base.path)
    {
      const auto step = [&](std::size_t i)
      { return norm(m_fine.point[path[i + 1]] - m_fine.point[path[i]]); };
      m_length.push_back(0.);
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
        m_length.back() += step(i);
      std::vector<double> length = {0.};
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
        length.push_back(length.back() + std::max(step(i), min_step_ratio * m_length.back()));
      const double total_length = length.back();
      for(std::size_t i = 0; i < path.size(); ++i)
        m_edge_parameter[path[i]] =
            total_length > 0. ? length[i] / total_length : double(i) / double(path.size() - 1);
    }
  }

  // Computes the exact geodesic distances from each base vertex in the union of the regions around
  // it.
  void compute_distances()
  {
    m_distances.assign(m_fine.corner.size(), {infinity, infinity, infinity});
    std::vector<std::vector<Index>> regions_around(m_base.vertex.size());
    for(Index f = 0; f < m_base.triangles.size(); ++f)
      for(const Index base_vertex : m_base.triangles[f])
        regions_around[base_vertex].push_back(f);
    std::vector<Index> triangles, local_index(m_fine.number_of_triangles(), none), vertices;
    for(Index base_vertex = 0; base_vertex < regions_around.size(); ++base_vertex)
    {
      triangles.clear();
      for(const Index region : regions_around[base_vertex])
        triangles.insert(triangles.end(),
                         m_result.m_triangles_by_region.begin() + m_result.m_region_begin[region],
                         m_result.m_triangles_by_region.begin() +
                             m_result.m_region_begin[region + 1]);
      const auto ring = std::make_shared<const Surface_arrays>(
          extract_triangles(triangles, local_index, vertices));
      Window_propagation windows(ring);
      const auto source = std::find(vertices.begin(), vertices.end(), m_base.vertex[base_vertex]);
      windows.run({{{{none, Index(source - vertices.begin()), {}}}, 0., 0}});
      for(Index i = 0; i < triangles.size(); ++i)
      {
        const Index f = triangles[i], region = m_base.region[f];
        const auto& corners = m_base.triangles[region];
        const std::size_t k =
            std::size_t(std::find(corners.begin(), corners.end(), base_vertex) - corners.begin());
        for(Index j = 0; j < 3; ++j)
          m_distances[3 * f + j][k] = windows.distance(ring->corner[3 * i + j]);
      }
    }
  }
  // Returns a submesh of the fine mesh. Vertex i of the submesh is vertices[i] of the fine mesh.
  Surface_arrays extract_triangles(const std::vector<Index>& triangles,
                                   std::vector<Index>& local_index, std::vector<Index>& vertices)
  {
    Surface_arrays result;
    vertices.clear();
    for(Index i = 0; i < triangles.size(); ++i)
      local_index[triangles[i]] = i;
    for(const Index f : triangles)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index vertex = m_fine.corner[h], twin = m_fine.twin[h];
        if(m_local_index[vertex] == none)
        {
          m_local_index[vertex] = Index(vertices.size());
          vertices.push_back(vertex);
        }
        result.corner.push_back(m_local_index[vertex]);
        result.length.push_back(m_fine.length[h]);
        const bool is_inside = twin != none && local_index[twin / 3] != none;
        result.twin.push_back(is_inside ? 3 * local_index[twin / 3] + twin % 3 : none);
      }
    for(const Index f : triangles)
      local_index[f] = none;
    for(const Index vertex : vertices)
      m_local_index[vertex] = none;
    build_rings(result, vertices.size());
    return result;
  }

  // Computes the coordinates of a region, and falls back to mean value and uniform coordinates if
  // triangles are inverted.
  void map_region(Index region)
  {
    collect_vertices(region);
    const bool is_heron = m_kind == Base_coordinates::heron;
    const bool does_repair = m_does_repair && m_kind != Base_coordinates::uniform;
    if(is_heron)
      heron(region);
    else
      compute_convex_combination(m_kind);
    bool is_valid = store_coordinates(does_repair) == 0;
    if(!is_valid && does_repair)
    {
      ++m_result.m_number_of_repaired_regions;
      if(is_heron)
      {
        compute_convex_combination(Base_coordinates::mean_value);
        is_valid = store_coordinates(true) == 0;
      }
      if(!is_valid)
      {
        compute_convex_combination(Base_coordinates::uniform);
        is_valid = store_coordinates(false) == 0;
      }
    }
    if(!is_valid)
    {
      m_result.m_number_of_flips += store_coordinates(false);
      add_center(region);
    }
    for(const Index vertex : m_vertices)
      m_local_index[vertex] = none;
  }

  // Adds the vertex of the current region that is farthest from the base edges, unless all vertices
  // are on these.
  void add_center(Index region)
  {
    if(m_number_of_interior == 0)
      return;
    std::vector<bool> is_seen(m_vertices.size(), false);
    std::vector<Index> queue;
    for(std::size_t i = m_number_of_interior; i < m_vertices.size(); ++i)
    {
      queue.push_back(Index(i));
      is_seen[i] = true;
    }
    for(std::size_t next = 0; next < queue.size(); ++next)
    {
      const Index vertex = m_vertices[queue[next]];
      for(Index i = m_fine.ring_begin[vertex]; i < m_fine.ring_begin[vertex + 1]; ++i)
        if(m_base.region[m_fine.ring[i] / 3] == region)
          for(const Index corner :
              {next_halfedge(m_fine.ring[i]), previous_halfedge(m_fine.ring[i])})
            if(const Index other = m_local_index[m_fine.corner[corner]]; !is_seen[other])
            {
              is_seen[other] = true;
              queue.push_back(other);
            }
    }
    const Index corner = m_fine.ring[m_fine.ring_begin[m_vertices[queue.back()]]];
    m_result.m_centers_of_inverted_regions.push_back(
        {m_base.parent[corner / 3], none, m_base.barycentric[corner]});
  }

  // Collects the vertices of a region, the interior ones first, and sets the coordinates of those
  // on base edges.
  void collect_vertices(Index region)
  {
    const auto begin = m_result.m_triangles_by_region.begin();
    m_triangles.assign(begin + m_result.m_region_begin[region],
                       begin + m_result.m_region_begin[region + 1]);
    m_vertices.clear();
    for(const bool is_inside : {true, false})
    {
      for(const Index f : m_triangles)
        for(Index c = 3 * f; c < 3 * f + 3; ++c)
          if(const Index vertex = m_fine.corner[c];
             m_local_index[vertex] == none && (m_edge_parameter[vertex] < 0.) == is_inside)
          {
            m_local_index[vertex] = Index(m_vertices.size());
            m_vertices.push_back(vertex);
          }
      if(is_inside)
        m_number_of_interior = m_vertices.size();
    }
    m_image.assign(m_vertices.size(), {0., 0., 0.});
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * region + k, edge = m_base.edge[h];
      const std::vector<Index>& path = m_base.path[edge];
      for(std::size_t i = 1; i + 1 < path.size(); ++i)
      {
        Barycentric& image = m_image[m_local_index[path[i]]];
        const bool is_forward = m_base.halfedge[edge] == h;
        image[is_forward ? k : (k + 1) % 3] = 1. - m_edge_parameter[path[i]];
        image[is_forward ? (k + 1) % 3 : k] = m_edge_parameter[path[i]];
      }
      m_image[m_local_index[m_base.vertex[m_base.triangles[region][k]]]] = barycentric_at_corner(k);
    }
  }

  using Edge_table = std::vector<std::pair<double, double>>;

  // Computes the heron coordinates of the interior vertices (Peyré and Cohen 2003, section 4.2).
  // The deviation from the arc length parameterization on each edge is interpolated and subtracted.
  void heron(Index region)
  {
    const std::vector<Barycentric> raw = area_coordinates(region);
    const std::array<Edge_table, 3> table = edge_tables(raw);
    for(std::size_t i = 0; i < m_number_of_interior; ++i)
    {
      Barycentric image = raw[i];
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t from = (k + 1) % 3, to = (k + 2) % 3;
        const double sum = raw[i][from] + raw[i][to];
        if(!(sum > 0.))
          continue;
        const double fraction = raw[i][to] / sum,
                     correction = sum * (interpolate_table(table[k], fraction) - fraction);
        image[from] -= correction;
        image[to] += correction;
      }
      m_image[i] = image;
    }
  }

  // Returns the coordinates of each vertex of a region (#m_vertices) from the areas of the planar
  // triangles between its distances to two corners and the edge of these corners.
  std::vector<Barycentric> area_coordinates(Index region) const
  {
    std::array<double, 3> length; // of the edge opposite to each corner
    for(Index k = 0; k < 3; ++k)
      length[k] = m_length[m_base.edge[3 * region + (k + 1) % 3]];
    std::vector<Barycentric> raw(m_vertices.size());
    for(const Index f : m_triangles)
      for(Index j = 0; j < 3; ++j)
      {
        const std::size_t i = m_local_index[m_fine.corner[3 * f + j]];
        Barycentric d = m_distances[3 * f + j];
        // On a base edge the distances to its end vertices are those along the edge.
        for(std::size_t k = 0; k < 3 && i >= m_number_of_interior; ++k)
          if(m_image[i][k] == 0.)
          {
            d[(k + 1) % 3] = m_image[i][(k + 2) % 3] * length[k];
            d[(k + 2) % 3] = m_image[i][(k + 1) % 3] * length[k];
          }
        raw[i] = normalized_areas(length, d);
      }
    return raw;
  }

  static Barycentric normalized_areas(const std::array<double, 3>& length, const Barycentric& d)
  {
    Barycentric result;
    double sum = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      sum += result[k] = twice_area(length[k], d[(k + 1) % 3], d[(k + 2) % 3]);
    if(!(sum > 0.))
      return {1. / 3., 1. / 3., 1. / 3.};
    for(double& x : result)
      x /= sum;
    return result;
  }

  // Returns for each edge the sorted pairs of the parameter from areas and the arc length
  // parameter.
  std::array<Edge_table, 3> edge_tables(const std::vector<Barycentric>& raw) const
  {
    std::array<Edge_table, 3> table;
    for(std::size_t i = m_number_of_interior; i < m_vertices.size(); ++i)
      for(std::size_t k = 0; k < 3; ++k)
        if(m_image[i][k] == 0.)
        {
          const double sum = raw[i][(k + 1) % 3] + raw[i][(k + 2) % 3];
          const double fraction = m_image[i][(k + 2) % 3];
          table[k].emplace_back(fraction == 0. || fraction == 1. || !(sum > 0.)
                                    ? fraction
                                    : raw[i][(k + 2) % 3] / sum,
                                fraction);
        }
    for(auto& entries : table)
      std::sort(entries.begin(), entries.end());
    return table;
  }

  // Interpolates linearly in a table of sorted pairs. Returns x itself outside of the table.
  static double interpolate_table(const Edge_table& table, double x)
  {
    const auto upper = std::upper_bound(table.begin(), table.end(), std::pair(x, infinity));
    if(upper == table.begin() || upper == table.end())
      return x;
    const auto lower = upper - 1;
    const double width = upper->first - lower->first;
    return width > 0. ? lower->second + (x - lower->first) / width * (upper->second - lower->second)
                      : lower->second;
  }

  // Solves for interior vertices that are weighted means of their neighbors. The images of vertices
  // on the base edges are fixed.
  void compute_convex_combination(Base_coordinates kind)
  {
    if(m_number_of_interior == 0)
      return;
    std::vector<std::vector<std::pair<Index, double>>> row(m_number_of_interior);
    for(const Index f : m_triangles)
      for(Index c = 3 * f; c < 3 * f + 3; ++c)
      {
        const Index i = m_local_index[m_fine.corner[c]];
        if(i >= m_number_of_interior)
          continue;
        const double tangent =
            kind == Base_coordinates::uniform
                ? 1.
                : std::min(std::tan(0.5 * interior_angle(m_fine, c)), max_tangent);
        for(const auto& [corner, h] :
            {std::pair(next_halfedge(c), c), std::pair(previous_halfedge(c), previous_halfedge(c))})
          row[i].emplace_back(m_local_index[m_fine.corner[corner]],
                              kind == Base_coordinates::uniform ? 1. : tangent / m_fine.length[h]);
      }
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(Eigen::Index(m_number_of_interior), 3);
    for(Index i = 0; i < m_number_of_interior; ++i)
    {
      double sum = 0.;
      for(const auto& [j, weight] : row[i])
        sum += weight;
      double total = 0.;
      // If all angles are zero, weight / sum is NaN. With the arguments in this order, std::max()
      // returns min_weight for it.
      for(auto& [j, weight] : row[i])
        total += weight = std::max(min_weight, weight / sum);
      entries.emplace_back(i, i, 1.);
      for(const auto& [j, weight] : row[i])
        if(j < m_number_of_interior)
          entries.emplace_back(i, j, -weight / total);
        else
          for(std::size_t k = 0; k < 3; ++k)
            rhs(i, Eigen::Index(k)) += weight / total * m_image[j][k];
    }
    const Eigen::Index n = Eigen::Index(m_number_of_interior);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
    if(solver.info() != Eigen::Success)
      return;
    const Eigen::MatrixXd found = solver.solve(rhs);
    for(Index i = 0; i < m_number_of_interior; ++i)
      m_image[i] = {found(i, 0), found(i, 1), found(i, 2)};
  }

  Image image_of(Index f) const
  {
    const Barycentric* const corner = &m_result.m_coordinates[3 * std::size_t(f)];
    return {corner[0], corner[1], corner[2]};
  }

  // Returns true if the image of a triangle is much flatter than the triangle.
  bool is_flat(Index f) const
  {
    const std::array<Vec2, 3> image = planar_image(image_of(f));
    double longest = 0., longest_image = 0.;
    std::array<Vec2, 3> edges;
    for(Index k = 0; k < 3; ++k)
    {
      edges[k] = image[(k + 1) % 3] - image[k];
      longest = std::max(longest, m_fine.length[3 * f + k]);
      longest_image = std::max(longest_image, norm(edges[k]));
    }
    return cross(edges[0], edges[1]) < min_height_ratio * longest * longest_image;
  }

  // Writes the images to the result. Returns the number of inverted triangles of the region,
  // including flat ones if `does_count_flat` is true.
  std::size_t store_coordinates(bool does_count_flat)
  {
    std::size_t number_of_flips = 0;
    for(const Index f : m_triangles)
    {
      for(Index c = 3 * f; c < 3 * f + 3; ++c)
        m_result.m_coordinates[c] = m_image[m_local_index[m_fine.corner[c]]];
      number_of_flips += is_inverted(image_of(f)) || (does_count_flat && is_flat(f));
    }
    return number_of_flips;
  }

  Base_map& m_result;
  const Base_mesh& m_base;
  const Surface_arrays& m_fine;
  Base_coordinates m_kind;
  bool m_does_repair;
  std::vector<double> m_length;         // #edges
  std::vector<double> m_edge_parameter; // #vertices: on their base edge, -1 inside regions
  std::vector<Barycentric> m_distances; // 3 #triangles: to the three corners of the region

  // The current region.
  std::vector<Index> m_triangles, m_vertices;
  std::size_t m_number_of_interior = 0; // number of first m_vertices inside the region
  std::vector<Barycentric> m_image;     // #m_vertices: coordinates in the base triangle
  std::vector<Index> m_local_index;     // #vertices of the fine mesh: index in m_vertices, or none
};

Base_map::Base_map(std::shared_ptr<const Base_mesh> base, Base_coordinates kind, bool does_repair)
    : m_base(std::move(base)), m_coordinates(m_base->fine.corner.size())
{
  Index number_of_parents = 0;
  for(const Index parent : m_base->parent)
    number_of_parents = std::max(number_of_parents, parent + 1);
  group(m_base->parent, number_of_parents, m_parent_begin, m_triangles_by_parent);
  group(m_base->region, m_base->triangles.size(), m_region_begin, m_triangles_by_region);
  Builder(*this, kind, does_repair);
}

Base_location Base_map::operator()(const Surface_location& location) const
{
  const Base_mesh& base = *m_base;
  Base_location result;
  double best_min = -infinity;
  for(Index i = m_parent_begin[location.triangle]; i < m_parent_begin[location.triangle + 1]; ++i)
  {
    const Index f = m_triangles_by_parent[i];
    const Barycentric* const corner = &base.barycentric[3 * std::size_t(f)];
    const Barycentric b =
        subtriangle_coordinates({corner[0], corner[1], corner[2]}, location.barycentric);
    const double smallest = std::min({b[0], b[1], b[2]});
    if(!(smallest > best_min))
      continue;
    best_min = smallest;
    const Barycentric* const image = &m_coordinates[3 * std::size_t(f)];
    result = {base.region[f], interpolate(clamp_barycentric(b), {image[0], image[1], image[2]})};
  }
  return result;
}

Surface_location Base_map::inverse(const Base_location& location) const
{
  const Base_mesh& base = *m_base;
  Surface_location result;
  double best_min = -infinity;
  for(Index i = m_region_begin[location.triangle]; i < m_region_begin[location.triangle + 1]; ++i)
  {
    const Index f = m_triangles_by_region[i];
    const Barycentric* const image = &m_coordinates[3 * std::size_t(f)];
    const Barycentric b =
        subtriangle_coordinates({image[0], image[1], image[2]}, location.barycentric);
    const double smallest = std::min({b[0], b[1], b[2]});
    // In images whose area is nearly zero, coordinates can be infinite.
    if(!(smallest > best_min) || std::max({b[0], b[1], b[2]}) == infinity)
      continue;
    best_min = smallest;
    result.triangle = base.parent[f];
    const Barycentric* const corner = &base.barycentric[3 * std::size_t(f)];
    result.barycentric = interpolate(clamp_barycentric(b), {corner[0], corner[1], corner[2]});
  }
  return result;
}

std::shared_ptr<const Base_map>
build_base_map(const std::shared_ptr<const Surface_arrays>& triangles, Remeshing_options options,
               Base_coordinates kind)
{
  std::shared_ptr<const Base_map> best;
  for(unsigned round = 0; round <= max_rounds; ++round)
  {
    std::shared_ptr<const Base_map> map;
    try
    {
      auto base = std::make_shared<const Base_mesh>(build_base_mesh(triangles, options));
      if(!base->is_finished)
        return nullptr;
      map = std::make_shared<const Base_map>(std::move(base), kind);
    }
    catch(const Unsupported_surface_error&)
    {
      // The edges between the additional samples cannot be traced.
      if(!best)
        throw;
      break;
    }
    if(!best || map->number_of_flips() < best->number_of_flips())
      best = map;
    if(map->centers_of_inverted_regions().empty())
      break;
    for(const Surface_location& center : map->centers_of_inverted_regions())
      options.first_samples.push_back(canonical(*triangles, center));
    if(round == 0 && options.callback)
      options.callback = [callback = options.callback](double) { return callback(1.); };
  }
  return best;
}

} // namespace CGAL::Geodesic_processing::internal
