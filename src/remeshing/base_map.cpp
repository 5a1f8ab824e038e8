// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_map.h>

#include "mesh/Divided_mesh.h"
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Barycentric = std::array<double, 3>;

// Of a site's neighbours none weighs less than this part of all: beyond it rounding tells no place from
// another, and triangles fold.
constexpr double least_weight = 1e-7;
// An image this much flatter than its triangle is as good as folded: rounding moves places by 1e-16 in it,
// and a hundred millionth of a side is what they may be wrong by.
constexpr double least_height = 1e-8;
// Of an edge: sites that are nearer to each other are put as far apart.
constexpr double least_step = 1e-12;
constexpr double largest_tangent = 1e4; // of half an angle: of needles

// The index lists of `number` groups: those of i are list[first[i]] .. list[first[i + 1]].
void group(const std::vector<Index>& group_of, std::size_t number, std::vector<Index>& first,
           std::vector<Index>& list)
{
  first.assign(number + 1, 0);
  for(const Index g : group_of)
    ++first[g + 1];
  for(std::size_t g = 0; g < number; ++g)
    first[g + 1] += first[g];
  list.resize(group_of.size());
  std::vector<Index> next(first.begin(), first.end() - 1);
  for(Index i = 0; i < group_of.size(); ++i)
    list[next[group_of[i]]++] = i;
}

// Not negative, with the sum one.
Barycentric clamped(Barycentric b)
{
  double sum = 0.;
  for(double& x : b)
    sum += x = std::max(x, 0.);
  for(double& x : b)
    x /= sum;
  return b;
}

Barycentric combined(const Barycentric& b, const std::array<Barycentric, 3>& corner)
{
  Barycentric result;
  for(std::size_t j = 0; j < 3; ++j)
    result[j] = b[0] * corner[0][j] + b[1] * corner[1][j] + b[2] * corner[2][j];
  return result;
}

bool is_folded(const Barycentric& a, const Barycentric& b, const Barycentric& c)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Barycentric& p) { return Kernel::Point_2(p[1], p[2]); };
  return CGAL::orientation(point(a), point(b), point(c)) != CGAL::LEFT_TURN;
}

} // namespace

class Base_map::Builder
{
public:
  Builder(Base_map& result, Base_coordinates kind, bool repairs)
      : m_result(result), m_base(*result.m_base), m_fine(m_base.fine), m_kind(kind),
        m_repairs(repairs), m_place(m_fine.number_of_sites(), none)
  {
    measure_edges();
    if(kind == Base_coordinates::heron)
      find_distances();
    for(Index f = 0; f < m_base.triangles.size(); ++f)
      map(f);
  }

private:
  // Where a site on an edge is, as a part of its length, and whether it is on one at all.
  void measure_edges()
  {
    m_share.assign(m_fine.number_of_sites(), -1.);
    for(const std::vector<Index>& path : m_base.path)
    {
      const auto step = [&](std::size_t i)
      { return norm(m_fine.point[path[i + 1]] - m_fine.point[path[i]]); };
      m_length.push_back(0.);
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
        m_length.back() += step(i);
      std::vector<double> length = {0.};
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
        length.push_back(length.back() + std::max(step(i), least_step * m_length.back()));
      const double whole = length.back();
      for(std::size_t i = 0; i < path.size(); ++i)
        m_share[path[i]] = whole > 0. ? length[i] / whole : double(i) / double(path.size() - 1);
    }
  }

  // The exact distances from each base vertex, in the regions around it.
  void find_distances()
  {
    m_distances.assign(m_fine.corner.size(), {infinity, infinity, infinity});
    std::vector<std::vector<Index>> around(m_base.site.size());
    for(Index f = 0; f < m_base.triangles.size(); ++f)
      for(const Index vertex : m_base.triangles[f])
        around[vertex].push_back(f);
    std::vector<Index> triangles, place(m_fine.number_of_triangles(), none), sites;
    for(Index vertex = 0; vertex < around.size(); ++vertex)
    {
      triangles.clear();
      for(const Index region : around[vertex])
        triangles.insert(triangles.end(),
                         m_result.m_of_region.begin() + m_result.m_first_of_region[region],
                         m_result.m_of_region.begin() + m_result.m_first_of_region[region + 1]);
      const auto star = std::make_shared<const Glued_triangles>(part(triangles, place, sites));
      Window_propagation windows(star);
      const auto source = std::find(sites.begin(), sites.end(), m_base.site[vertex]);
      windows.run({{{{none, Index(source - sites.begin()), {}}}, 0., 0}});
      for(Index i = 0; i < triangles.size(); ++i)
      {
        const Index f = triangles[i], region = m_base.region[f];
        const auto& corners = m_base.triangles[region];
        const std::size_t k =
            std::size_t(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
        for(Index j = 0; j < 3; ++j)
          m_distances[3 * f + j][k] = windows.distance(star->corner[3 * i + j]);
      }
    }
  }
  // Some triangles by themselves.
  Glued_triangles part(const std::vector<Index>& triangles, std::vector<Index>& place,
                       std::vector<Index>& sites)
  {
    Glued_triangles result;
    sites.clear();
    for(Index i = 0; i < triangles.size(); ++i)
      place[triangles[i]] = i;
    for(const Index f : triangles)
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
      {
        const Index site = m_fine.corner[side], twin = m_fine.twin[side];
        if(m_place[site] == none)
        {
          m_place[site] = Index(sites.size());
          sites.push_back(site);
        }
        result.corner.push_back(m_place[site]);
        result.length.push_back(m_fine.length[side]);
        const bool is_inside = twin != none && place[twin / 3] != none;
        result.twin.push_back(is_inside ? 3 * place[twin / 3] + twin % 3 : none);
      }
    for(const Index f : triangles)
      place[f] = none;
    for(const Index site : sites)
      m_place[site] = none;
    build_stars(result, sites.size());
    return result;
  }

  void map(Index region)
  {
    gather(region);
    const bool is_heron = m_kind == Base_coordinates::heron;
    const bool repairs = m_repairs && m_kind != Base_coordinates::uniform;
    if(is_heron)
      heron(region);
    else
      combine(m_kind);
    bool is_good = write(repairs) == 0;
    if(!is_good && repairs)
    {
      ++m_result.m_repaired;
      if(is_heron)
      {
        combine(Base_coordinates::mean_value);
        is_good = write(true) == 0;
      }
      if(!is_good)
      {
        combine(Base_coordinates::uniform);
        is_good = write(false) == 0;
      }
    }
    if(!is_good)
      m_result.m_folds += write(false);
    for(const Index site : m_sites)
      m_place[site] = none;
  }

  // The sites of a region, those inside first, and the coordinates of those on its edges.
  void gather(Index region)
  {
    const auto begin = m_result.m_of_region.begin();
    m_triangles.assign(begin + m_result.m_first_of_region[region],
                       begin + m_result.m_first_of_region[region + 1]);
    m_sites.clear();
    for(const bool is_inside : {true, false})
    {
      for(const Index f : m_triangles)
        for(Index c = 3 * f; c < 3 * f + 3; ++c)
          if(const Index site = m_fine.corner[c];
             m_place[site] == none && (m_share[site] < 0.) == is_inside)
          {
            m_place[site] = Index(m_sites.size());
            m_sites.push_back(site);
          }
      if(is_inside)
        m_inside = m_sites.size();
    }
    m_image.assign(m_sites.size(), {0., 0., 0.});
    for(Index k = 0; k < 3; ++k)
    {
      const Index side = 3 * region + k, edge = m_base.edge[side];
      const std::vector<Index>& path = m_base.path[edge];
      for(std::size_t i = 1; i + 1 < path.size(); ++i)
      {
        Barycentric& image = m_image[m_place[path[i]]];
        const bool is_forward = m_base.side[edge] == side;
        image[is_forward ? k : (k + 1) % 3] = 1. - m_share[path[i]];
        image[is_forward ? (k + 1) % 3 : k] = m_share[path[i]];
      }
      m_image[m_place[m_base.site[m_base.triangles[region][k]]]] = at_corner(k);
    }
  }

  // Peyré and Cohen 2003, section 4.2.
  void heron(Index region)
  {
    std::array<double, 3> length; // of the edge opposite to each corner
    for(Index k = 0; k < 3; ++k)
      length[k] = m_length[m_base.edge[3 * region + (k + 1) % 3]];
    std::vector<Barycentric> raw(m_sites.size());
    const auto area_coordinates = [&](const Barycentric& d) -> Barycentric
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
    };
    for(const Index f : m_triangles)
      for(Index j = 0; j < 3; ++j)
      {
        const std::size_t i = m_place[m_fine.corner[3 * f + j]];
        Barycentric d = m_distances[3 * f + j];
        // On an edge, along it.
        for(std::size_t k = 0; k < 3 && i >= m_inside; ++k)
          if(m_image[i][k] == 0.)
          {
            d[(k + 1) % 3] = m_image[i][(k + 2) % 3] * length[k];
            d[(k + 2) % 3] = m_image[i][(k + 1) % 3] * length[k];
          }
        raw[i] = area_coordinates(d);
      }

    // From the areas' place on each edge to that by length.
    std::array<std::vector<std::pair<double, double>>, 3> table;
    for(std::size_t i = m_inside; i < m_sites.size(); ++i)
      for(std::size_t k = 0; k < 3; ++k)
        if(m_image[i][k] == 0.)
        {
          const double sum = raw[i][(k + 1) % 3] + raw[i][(k + 2) % 3];
          const double share = m_image[i][(k + 2) % 3];
          table[k].emplace_back(
              share == 0. || share == 1. || !(sum > 0.) ? share : raw[i][(k + 2) % 3] / sum, share);
        }
    for(auto& of_edge : table)
      std::sort(of_edge.begin(), of_edge.end());
    for(std::size_t i = 0; i < m_inside; ++i)
    {
      Barycentric image = raw[i];
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t from = (k + 1) % 3, to = (k + 2) % 3;
        const double sum = raw[i][from] + raw[i][to];
        if(!(sum > 0.))
          continue;
        const double share = raw[i][to] / sum, change = sum * (at(table[k], share) - share);
        image[from] -= change;
        image[to] += change;
      }
      m_image[i] = image;
    }
  }

  static double at(const std::vector<std::pair<double, double>>& table, double x)
  {
    const auto next = std::upper_bound(table.begin(), table.end(), std::pair(x, infinity));
    if(next == table.begin() || next == table.end())
      return x;
    const auto last = next - 1;
    const double width = next->first - last->first;
    return width > 0. ? last->second + (x - last->first) / width * (next->second - last->second)
                      : last->second;
  }

  // Each site inside is a mean of its neighbours.
  void combine(Base_coordinates kind)
  {
    if(m_inside == 0)
      return;
    std::vector<std::vector<std::pair<Index, double>>> row(m_inside);
    for(const Index f : m_triangles)
      for(Index c = 3 * f; c < 3 * f + 3; ++c)
      {
        const Index i = m_place[m_fine.corner[c]];
        if(i >= m_inside)
          continue;
        const double tangent =
            kind == Base_coordinates::uniform
                ? 1.
                : std::min(std::tan(0.5 * interior_angle(m_fine, c)), largest_tangent);
        for(const auto& [corner, side] :
            {std::pair(next_side(c), c), std::pair(previous_side(c), previous_side(c))})
          row[i].emplace_back(m_place[m_fine.corner[corner]], kind == Base_coordinates::uniform
                                                                  ? 1.
                                                                  : tangent / m_fine.length[side]);
      }
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(Eigen::Index(m_inside), 3);
    for(Index i = 0; i < m_inside; ++i)
    {
      double sum = 0.;
      for(const auto& [j, weight] : row[i])
        sum += weight;
      double total = 0.;
      // What is not a number, where all angles are zero, gets the least weight in this order.
      for(auto& [j, weight] : row[i])
        total += weight = std::max(least_weight, weight / sum);
      entries.emplace_back(i, i, 1.);
      for(const auto& [j, weight] : row[i])
        if(j < m_inside)
          entries.emplace_back(i, j, -weight / total);
        else
          for(std::size_t k = 0; k < 3; ++k)
            right(i, Eigen::Index(k)) += weight / total * m_image[j][k];
    }
    const Eigen::Index n = Eigen::Index(m_inside);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
    if(solver.info() != Eigen::Success)
      return;
    const Eigen::MatrixXd found = solver.solve(right);
    for(Index i = 0; i < m_inside; ++i)
      m_image[i] = {found(i, 0), found(i, 1), found(i, 2)};
  }

  bool is_flat(Index f) const
  {
    const Barycentric* const b = &m_result.m_coordinates[3 * std::size_t(f)];
    double longest = 0., longest_image = 0.;
    std::array<Planar, 3> side;
    for(Index k = 0; k < 3; ++k)
    {
      side[k] = {b[(k + 1) % 3][1] - b[k][1], b[(k + 1) % 3][2] - b[k][2]};
      longest = std::max(longest, m_fine.length[3 * f + k]);
      longest_image = std::max(longest_image, norm(side[k]));
    }
    return cross(side[0], side[1]) < least_height * longest * longest_image;
  }

  // The number of folded triangles, or of those as good as folded.
  std::size_t write(bool counts_flat)
  {
    std::size_t folds = 0;
    for(const Index f : m_triangles)
    {
      for(Index c = 3 * f; c < 3 * f + 3; ++c)
        m_result.m_coordinates[c] = m_image[m_place[m_fine.corner[c]]];
      const Barycentric* const b = &m_result.m_coordinates[3 * std::size_t(f)];
      folds += is_folded(b[0], b[1], b[2]) || (counts_flat && is_flat(f));
    }
    return folds;
  }

  Base_map& m_result;
  const Base_mesh& m_base;
  const Glued_triangles& m_fine;
  Base_coordinates m_kind;
  bool m_repairs;
  std::vector<double> m_length;         // #edges
  std::vector<double> m_share;          // #sites: along their edge, negative inside of regions
  std::vector<Barycentric> m_distances; // 3 #triangles: from the corners of the region

  // Of a region
  std::vector<Index> m_triangles, m_sites;
  std::size_t m_inside = 0;         // so many sites, the first ones
  std::vector<Barycentric> m_image; // of its sites
  std::vector<Index> m_place;       // #sites of the fine mesh: among those of the region, or none
};

Base_map::Base_map(std::shared_ptr<const Base_mesh> base, Base_coordinates kind, bool repairs)
    : m_base(std::move(base)), m_coordinates(m_base->fine.corner.size())
{
  Index wholes = 0;
  for(const Index whole : m_base->whole)
    wholes = std::max(wholes, whole + 1);
  group(m_base->whole, wholes, m_first_part, m_part);
  group(m_base->region, m_base->triangles.size(), m_first_of_region, m_of_region);
  Builder(*this, kind, repairs);
}

Base_location Base_map::operator()(const Location& location) const
{
  const Base_mesh& base = *m_base;
  Base_location result;
  double most = -infinity;
  for(Index i = m_first_part[location.triangle]; i < m_first_part[location.triangle + 1]; ++i)
  {
    const Index f = m_part[i];
    const Barycentric* const corner = &base.barycentric[3 * std::size_t(f)];
    const Barycentric b =
        coordinates_in_part({corner[0], corner[1], corner[2]}, location.barycentric);
    const double least = std::min({b[0], b[1], b[2]});
    if(!(least > most))
      continue;
    most = least;
    const Barycentric* const image = &m_coordinates[3 * std::size_t(f)];
    result = {base.region[f], combined(clamped(b), {image[0], image[1], image[2]})};
  }
  return result;
}

Location Base_map::inverse(const Base_location& location) const
{
  const Base_mesh& base = *m_base;
  Location result;
  double most = -infinity;
  for(Index i = m_first_of_region[location.triangle]; i < m_first_of_region[location.triangle + 1];
      ++i)
  {
    const Index f = m_of_region[i];
    const Barycentric* const image = &m_coordinates[3 * std::size_t(f)];
    const Barycentric b = coordinates_in_part({image[0], image[1], image[2]}, location.barycentric);
    const double least = std::min({b[0], b[1], b[2]});
    if(!(least > most))
      continue;
    most = least;
    result.triangle = base.whole[f];
    const Barycentric* const corner = &base.barycentric[3 * std::size_t(f)];
    result.barycentric = combined(clamped(b), {corner[0], corner[1], corner[2]});
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
