// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_mesh.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/curves.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>
#include "paths/taut_strip.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <queue>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Places on each side among which paths are searched, before they are straight.
constexpr Index places = 3;
// How much longer ways are made, for the first search, off the cells of an edge's ends: across those of
// the corners opposite to it, and elsewhere.  A path around the other side of a limb can be shorter, but
// leaves no room for the edges that belong there.
struct Detours
{
  double near, far;
  bool are_samples_passed; // when paths are straightened
};
// One after the other, until there is a way for each edge: cells are coarse where sites are few.
constexpr std::array<Detours, 3> all_detours = {Detours{2., 16., false}, Detours{1., 1., true},
                                                Detours{2., 4., true}};
// No edge leaves the cells of its ends.
constexpr Detours no_detours = {infinity, infinity, false};
// Far below what distances tell apart.
constexpr double shortest_side = 0x1p-36;
// Places looked at, for each side of the mesh and each edge to be drawn, before it is given up: in webs of
// needles each edge drawn makes the next one longer.
constexpr std::size_t most_for_a_side = 50, most_for_an_edge = 1500;
constexpr Index curve = Divided_mesh::curve;

// The base of some samples, and the lines of its edges while they are drawn.
class Builder
{
public:
  Builder(const Glued_triangles& coarse, const std::vector<Location>& samples,
          const std::vector<std::array<Index, 3>>& triangles, const std::vector<bool>& is_curve,
          const Detours& detours, const std::vector<Index>& cells)
      : m_mesh(coarse, is_curve), m_detours(detours)
  {
    m_result.triangles = triangles;
    number_edges(samples.size());
    for(const Location& sample : samples)
    {
      m_result.site.push_back(m_mesh.insert(sample));
      m_result.samples.push_back(m_mesh.locations()[m_result.site.back()]);
    }
    m_base_vertex.assign(m_mesh.locations().size(), none);
    for(Index i = 0; i < m_result.site.size(); ++i)
      m_base_vertex[m_result.site[i]] = i;
    m_is_barred.assign(m_mesh.locations().size(), keeps_to_cells());
    for(const Index site : m_result.site)
      m_is_barred[site] = !detours.are_samples_passed;
    m_cell = m_base_vertex;
    for(Index site = 0; site < coarse.number_of_sites(); ++site)
      if(m_cell[site] == none)
        m_cell[site] = cells[site];
    m_visits_left =
        most_for_a_side * coarse.corner.size() + most_for_an_edge * m_result.side.size();
  }

  // Nothing where an edge finds no way.
  std::optional<Base_mesh> run()
  {
    if(!follow_curves() || !connect_all())
      return std::nullopt;
    open_shortcuts();
    if(!fill_regions())
      return std::nullopt;
    finish();
    return std::move(m_result);
  }

private:
  const Glued_triangles& t() const { return m_mesh.triangles(); }

  void number_edges(std::size_t number_of_samples)
  {
    std::vector<Index> corners;
    for(const auto& f : m_result.triangles)
      corners.insert(corners.end(), f.begin(), f.end());
    m_result.twin = twins_of_soup(number_of_samples, corners);
    m_result.edge.assign(corners.size(), none);
    for(Index side = 0; side < corners.size(); ++side)
    {
      const Index twin = m_result.twin[side];
      if(twin != none && twin < side)
        continue;
      const Index edge = Index(m_result.side.size());
      m_result.edge[side] = edge;
      if(twin != none)
        m_result.edge[twin] = edge;
      m_result.side.push_back(side);
      m_edge_between[std::minmax(corners[side], corners[next_side(side)])] = edge;
    }
    m_result.path.resize(m_result.side.size());
  }

  Index base_corner(Index side) const { return m_result.triangles[side / 3][side % 3]; }

  void bar(Index site)
  {
    if(m_is_barred.size() <= site)
      m_is_barred.resize(t().point.size(), false);
    m_is_barred[site] = true;
  }

  // Gives curves the labels of the edges that follow them.
  bool follow_curves()
  {
    const std::vector<Index>& label = m_mesh.labels();
    for(Index vertex = 0; vertex < m_result.site.size(); ++vertex)
      for(const Index first : m_mesh.sides_around(m_result.site[vertex]))
      {
        if(label[first] != curve)
          continue;
        std::vector<Index> path = {m_result.site[vertex]}, sides = {first};
        for(;;)
        {
          const Index side = sides.back(), last = path.back();
          const Index next =
              m_mesh.source(side) == last ? m_mesh.target(side) : m_mesh.source(side);
          path.push_back(next);
          if(m_base_vertex[next] != none)
            break;
          Index on = none;
          for(const Index other : m_mesh.sides_around(next))
            if(label[other] == curve && other != side && t().twin[other] != side)
              on = other;
          if(on == none || path.size() > t().point.size())
            return false;
          sides.push_back(on);
        }
        const auto found = m_edge_between.find(std::minmax(vertex, m_base_vertex[path.back()]));
        if(found == m_edge_between.end() || !m_result.path[found->second].empty())
          return false;
        for(const Index side : sides)
          m_mesh.set_label(side, found->second);
        keep(found->second, std::move(path));
      }
    return std::none_of(label.begin(), label.end(), [](Index l) { return l == curve; });
  }

  void keep(Index edge, std::vector<Index> path)
  {
    for(const Index site : path)
      bar(site);
    if(m_base_vertex[path.front()] != base_corner(m_result.side[edge]))
      std::reverse(path.begin(), path.end());
    m_result.path[edge] = std::move(path);
  }

  bool connect_all()
  {
    std::vector<Index> sorted, order, others;
    std::vector<double> length;
    boost::disjoint_sets_with_storage<> parts(m_result.site.size());
    const auto joins_parts = [&](Index edge)
    {
      const Index side = m_result.side[edge];
      const auto p = parts.find_set(base_corner(side)),
                 q = parts.find_set(base_corner(next_side(side)));
      if(p != q)
        parts.link(p, q);
      return p != q;
    };
    for(Index edge = 0; edge < m_result.side.size(); ++edge)
    {
      const Index side = m_result.side[edge];
      length.push_back(m_mesh.between(m_result.site[base_corner(side)],
                                      m_result.site[base_corner(next_side(side))]));
      if(m_result.path[edge].empty())
        sorted.push_back(edge);
      else
        joins_parts(edge);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](Index a, Index b) { return length[a] < length[b]; });
    for(const Index edge : sorted)
      (joins_parts(edge) ? order : others).push_back(edge);
    order.insert(order.end(), others.begin(), others.end());
    return std::all_of(order.begin(), order.end(), [&](Index edge) { return connect(edge); });
  }

  // The corners of a base vertex between the edges, of those already drawn, that are next to the edge of
  // a side that leaves it.
  std::vector<Index> sector(Index side) const
  {
    const std::vector<Index> corners = m_mesh.corners_around(m_result.site[base_corner(side)]);
    Index right = side;
    do
    {
      const Index twin = m_result.twin[right];
      right = twin == none ? none : next_side(twin);
    } while(right != none && right != side && m_result.path[m_result.edge[right]].empty());
    if(right == side || right == none)
      return corners;
    const std::vector<Index>& label = m_mesh.labels();
    const auto begin = std::find_if(corners.begin(), corners.end(),
                                    [&](Index c) { return label[c] == m_result.edge[right]; });
    std::vector<Index> result;
    if(begin == corners.end())
      return result;
    for(std::size_t i = std::size_t(begin - corners.begin()), n = 0; n < corners.size(); ++n)
    {
      result.push_back(corners[i]);
      if(label[previous_side(corners[i])] != none)
        break;
      i = (i + 1) % corners.size();
    }
    return result;
  }

  bool connect(Index edge)
  {
    const Index side = m_result.side[edge], twin = m_result.twin[side];
    if(twin == none)
      return false;
    const Index from = m_result.site[base_corner(side)], to = m_result.site[base_corner(twin)];
    const std::vector<Index> starts = sector(side), goals = sector(twin);
    const auto is_goal = [&](Index corner)
    { return std::find(goals.begin(), goals.end(), corner) != goals.end(); };
    for(const Index corner : starts)
      if(m_mesh.target(corner) == to && m_mesh.labels()[corner] == none &&
         is_goal(next_side(corner)))
      {
        m_mesh.set_label(corner, edge);
        keep(edge, {from, to});
        return true;
      }
    m_near = {base_corner(side), base_corner(twin), base_corner(previous_side(side)),
              base_corner(previous_side(twin))};
    const std::vector<Index> rough = search(starts, goals, to);
    if(rough.empty())
      return false;
    m_is_barred.resize(t().point.size(), false);
    const Taut_strip strip = taut_strip(m_mesh, m_is_barred, from, to, rough);
    return !strip.sides.empty() && draw(edge, from, to, strip);
  }

  bool keeps_to_cells() const { return m_detours.far == infinity; }
  bool is_at_ends(Index cell) const { return cell == m_near[0] || cell == m_near[1]; }
  double how_far(Index site) const
  {
    const Index cell = m_cell[site];
    return is_at_ends(cell) || cell == none         ? 1.
           : cell == m_near[2] || cell == m_near[3] ? m_detours.near
                                                    : m_detours.far;
  }
  // Across a side: next to a site of a cell one is still in it.
  double how_far_across(Index side) const
  {
    const double from = how_far(m_mesh.source(side)), to = how_far(m_mesh.target(side));
    return keeps_to_cells() ? std::min(from, to) : 0.5 * (from + to);
  }
  // The cell of a new site on a side.
  Index cell_on(Index side, double share) const
  {
    const Index from = m_cell[m_mesh.source(side)], to = m_cell[m_mesh.target(side)];
    if(keeps_to_cells() && is_at_ends(from) != is_at_ends(to))
      return is_at_ends(from) ? from : to;
    return share < 0.5 ? from : to;
  }

  // The sides that a short path crosses: the shortest through some places on each (A*, Hart, Nilsson and
  // Raphael 1968).  Empty when there is none.
  std::vector<Index> search(const std::vector<Index>& starts, const std::vector<Index>& goals,
                            Index to)
  {
    ++m_run;
    m_nodes.resize(places * t().corner.size());
    const Spatial& goal = t().point[to];
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto point = [&](Index node)
    {
      const Index side = node / places;
      const double share = double(node % places + 1) / double(places + 1);
      return (1. - share) * t().point[m_mesh.source(side)] + share * t().point[m_mesh.target(side)];
    };
    const auto reach = [&](Index side, const Spatial& from, double distance, Index last)
    {
      if(m_mesh.labels()[side] != none || t().twin[side] == none)
        return;
      const double far = how_far_across(side);
      if(far == infinity)
        return;
      for(Index i = 0; i < places; ++i)
      {
        const Index number = places * m_mesh.first(side) + i;
        const Spatial place = point(number);
        const double length = distance + far * norm(place - from);
        Node& node = m_nodes[number];
        if(node.run == m_run && !(length < node.distance))
          continue;
        node = {length, m_run, last, side};
        queue.emplace(length + norm(goal - place), number);
      }
    };
    for(const Index corner : starts)
      reach(next_side(corner), t().point[m_mesh.source(corner)], 0., none);
    double best = infinity;
    Index end = none;
    while(!queue.empty() && queue.top().first < best)
    {
      const auto [key, number] = queue.top();
      queue.pop();
      if(m_visits_left == 0)
        return {};
      --m_visits_left;
      const Node node = m_nodes[number];
      const Spatial place = point(number);
      if(key > node.distance + norm(goal - place))
        continue;
      const Index entry = t().twin[node.side], far = previous_side(entry);
      if(m_mesh.source(far) == to && node.distance + norm(goal - place) < best &&
         std::find(goals.begin(), goals.end(), far) != goals.end())
      {
        best = node.distance + norm(goal - place);
        end = number;
      }
      reach(next_side(entry), place, node.distance, number);
      reach(far, place, node.distance, number);
    }
    std::vector<Index> result;
    for(Index node = end; node != none; node = m_nodes[node].from)
      result.push_back(m_nodes[node].side);
    std::reverse(result.begin(), result.end());
    return result;
  }

  // Divides the triangles of a strip along a path.
  bool draw(Index edge, Index from, Index to, const Taut_strip& strip)
  {
    const std::vector<Index>& sides = strip.sides;
    const std::vector<double>& shares = strip.shares;
    std::vector<bool> turns;
    for(std::size_t i = 0; i + 1 < sides.size(); ++i)
      turns.push_back(sides[i + 1] == next_side(t().twin[sides[i]]));
    std::vector<Index> path = {from};
    Index side = sides.front();
    for(std::size_t i = 0; i < sides.size(); ++i)
    {
      if(m_mesh.apex(side) != path.back())
        return false;
      const Index entry = t().twin[side];
      m_cell.push_back(cell_on(side, shares[i]));
      path.push_back(m_mesh.split_side(side, shares[i]));
      m_mesh.set_label(next_side(side), edge);
      if(i + 1 < sides.size())
        // Of v u x are left v p x and, glued to the first part, p u x.
        side = turns[i] ? next_side(t().twin[side]) : previous_side(entry);
      else
      {
        if(m_mesh.apex(entry) != to)
          return false;
        m_mesh.set_label(next_side(entry), edge);
      }
    }
    path.push_back(to);
    keep(edge, std::move(path));
    return true;
  }

  // Halves sides that join two sites of one edge, without being a part of it.
  void open_shortcuts()
  {
    std::vector<std::vector<Index>> edges(t().point.size());
    for(Index edge = 0; edge < m_result.path.size(); ++edge)
      for(const Index site : m_result.path[edge])
        edges[site].push_back(edge);
    // Those that a cut moves come later.
    for(Index side = 0; side < t().corner.size(); ++side)
    {
      if(m_mesh.labels()[side] != none || t().twin[side] < side)
        continue;
      const Index p = m_mesh.source(side), q = m_mesh.target(side);
      if(p >= edges.size() || q >= edges.size())
        continue;
      const auto& of_q = edges[q];
      if(std::any_of(edges[p].begin(), edges[p].end(),
                     [&](Index edge)
                     { return std::find(of_q.begin(), of_q.end(), edge) != of_q.end(); }))
        m_mesh.split_side(side, 0.5);
    }
  }

  // Whether the triangles of each region form a disc between the edges of its triangle of the base.
  bool fill_regions()
  {
    const std::vector<Index>& label = m_mesh.labels();
    m_result.region.assign(t().number_of_triangles(), none);
    std::vector<Index> waiting, seen(t().point.size(), none);
    for(Index f = 0; f < m_result.triangles.size(); ++f)
    {
      for(const Index corner : m_mesh.corners_around(m_result.site[m_result.triangles[f][0]]))
        if(label[corner] == m_result.edge[3 * f])
          waiting.push_back(corner / 3);
      if(waiting.size() != 1 || m_result.region[waiting[0]] != none)
        return false;
      m_result.region[waiting[0]] = f;
      std::size_t triangles = 0, sides = 0, border = 0, sites = 0;
      while(!waiting.empty())
      {
        const Index part = waiting.back();
        waiting.pop_back();
        ++triangles;
        for(Index side = 3 * part; side < 3 * part + 3; ++side)
        {
          if(seen[m_mesh.source(side)] != f)
          {
            seen[m_mesh.source(side)] = f;
            ++sites;
          }
          ++sides;
          if(label[side] != none)
          {
            const Index* edge = &m_result.edge[3 * std::size_t(f)];
            if(std::find(edge, edge + 3, label[side]) == edge + 3)
              return false;
            ++border;
            continue;
          }
          const Index other = t().twin[side] / 3;
          if(m_result.region[other] == none)
          {
            m_result.region[other] = f;
            waiting.push_back(other);
          }
        }
      }
      std::size_t perimeter = 0;
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
        perimeter += m_result.path[m_result.edge[side]].size() - 1;
      if(border != perimeter || sites + triangles != (sides + border) / 2 + 1)
        return false;
    }
    return std::find(m_result.region.begin(), m_result.region.end(), none) == m_result.region.end();
  }

  void finish()
  {
    Glued_triangles& fine = m_result.fine;
    fine = m_mesh.triangles();
    for(Index side = 0; side < fine.corner.size(); ++side)
      fine.length.push_back(std::max(m_mesh.length(side), shortest_side));
    build_stars(fine, fine.point.size());
    for(Index side = 0; side < fine.corner.size(); ++side)
      m_result.barycentric.push_back(m_mesh.barycentric(side / 3, fine.corner[side]));
    m_result.whole = m_mesh.wholes();
    m_result.edge_of_side = m_mesh.labels();
  }

  struct Node
  {
    double distance = infinity;
    Index run = 0;
    Index from = none; // the place before
    Index side = none; // seen from there
  };

  Divided_mesh m_mesh;
  Detours m_detours;
  Base_mesh m_result;
  std::map<std::pair<Index, Index>, Index> m_edge_between;
  std::vector<Index> m_base_vertex; // #sites without those of paths
  std::vector<bool> m_is_barred;    // #sites: on edges, or samples
  std::vector<Index> m_cell;        // #sites: the sample of each
  std::array<Index, 4> m_near = {}; // corners of the two triangles at the edge that is sought
  std::vector<Node> m_nodes;
  Index m_run = 0;
  std::size_t m_visits_left = 0;
};

// The nearest sample of each site.
std::vector<Index> cells_of(const Glued_triangles& coarse, const std::vector<Location>& samples)
{
  std::vector<Source> sources;
  for(Index i = 0; i < samples.size(); ++i)
    sources.push_back({{samples[i]}, 0., i});
  Front front(std::shared_ptr<const Glued_triangles>(&coarse, [](const Glued_triangles*) {}),
              Front_kind::euclidean);
  front.run(sources);
  std::vector<Index> result;
  for(Index site = 0; site < coarse.number_of_sites(); ++site)
    result.push_back(front.source(site));
  return result;
}

// A base of a finer surface as that of the mesh which this is a refinement of.
void make_coarse(const Refinement& surface, Base_mesh& base)
{
  if(surface.parent.empty())
    return;
  for(Location& sample : base.samples)
    sample = to_coarse(surface, sample);
  for(Index side = 0; side < base.barycentric.size(); ++side)
    base.barycentric[side] =
        to_coarse(surface, {base.whole[side / 3], none, base.barycentric[side]}).barycentric;
  for(Index& whole : base.whole)
    whole = surface.parent[whole];
  Glued_triangles& fine = base.fine;
  const double unit = fine.scale / surface.coarse->scale; // a power of two
  for(Spatial& point : fine.point)
    point = unit * point;
  for(double& length : fine.length)
    length = std::max(unit * length, shortest_side);
  fine.scale = surface.coarse->scale;
}

// On the finer surface: where none of the sites around a sample is of its cell, the nearest one that is.
std::vector<Location> samples_in_cells(const Remeshing& found)
{
  const Glued_triangles& t = *found.surface.triangles;
  std::vector<Location> result = to_fine(found.surface, found.samples);
  std::vector<bool> is_beside(result.size(), true);
  for(Index i = 0; i < result.size(); ++i)
    for(const Index f : triangles_at(t, result[i]))
      for(Index k = 0; k < 3; ++k)
        if(found.cells[t.corner[3 * f + k]] == i)
          is_beside[i] = false;
  std::vector<double> least(result.size(), infinity);
  const std::vector<Location> samples = result;
  for(Index site = 0; site < found.cells.size(); ++site)
    if(const Index cell = found.cells[site]; cell != none && is_beside[cell])
      if(const double distance = norm(t.point[site] - scaled_coordinates(t, samples[cell]));
         distance < least[cell])
      {
        least[cell] = distance;
        result[cell] = at_site(t, site);
      }
  return result;
}

// The base that has an edge where two cells meet: as each is a disc, and they meet in an arc, there is
// room for it in both.
std::optional<Base_mesh> base_mesh_in_cells(const Remeshing& found,
                                            const std::vector<bool>& is_curve)
{
  const Refinement& surface = found.surface;
  const std::vector<Index> coarse = coarse_sides(surface);
  std::vector<bool> is_fine_curve;
  for(const Index side : coarse)
    is_fine_curve.push_back(side != none && is_curve[side]);
  auto result = Builder(*surface.triangles, samples_in_cells(found), found.between_cells,
                        is_fine_curve, no_detours, found.cells)
                    .run();
  if(result)
    make_coarse(surface, *result);
  return result;
}

} // namespace

std::optional<Base_mesh> base_mesh(const Glued_triangles& coarse,
                                   const std::vector<Location>& samples,
                                   const std::vector<std::array<Index, 3>>& triangles,
                                   const std::vector<bool>& is_curve)
{
  const std::vector<Index> cells = cells_of(coarse, samples);
  for(const Detours& detours : all_detours)
    if(auto result = Builder(coarse, samples, triangles, is_curve, detours, cells).run())
      return result;
  return std::nullopt;
}

Base_mesh base_mesh(const std::shared_ptr<const Glued_triangles>& triangles,
                    const Remeshing_goal& goal)
{
  const std::vector<bool> is_curve =
      goal.is_curve.empty() ? border_and_sharp_sides(*triangles) : goal.is_curve;
  const Remeshing found = remeshing(triangles, goal);
  if(!found.is_finished)
  {
    Base_mesh nothing;
    nothing.is_finished = false;
    return nothing;
  }
  auto result = base_mesh(*triangles, found.samples, found.triangles, is_curve);
  if(!result)
    result = base_mesh_in_cells(found, is_curve);
  if(!result)
    throw Unsupported_surface_error(
        "The edges of no base mesh can be drawn on the surface: it is too thin or too coarse.");
  return std::move(*result);
}

} // namespace CGAL::Geodesic_processing::internal
