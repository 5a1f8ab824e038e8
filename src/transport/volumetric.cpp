// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/volumetric.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sites of no triangle count for nothing: they have no mass.
bool is_one_piece(const Glued_triangles& t)
{
  const auto component = components(operators(t, Flat_triangles::raised)).first;
  return std::all_of(t.corner.begin(), t.corner.end(),
                     [&](Index site) { return component[site] == component[t.corner[0]]; });
}

// Such that each part of them from the first one on is spread over all: along a curve that fills space,
// of which first one in many is taken, then those in between.
std::vector<std::size_t> coarse_to_fine(const std::vector<Spatial>& points)
{
  Spatial low = points[0], high = low;
  for(const Spatial& p : points)
    for(int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  constexpr int bits = 21;
  std::vector<std::pair<std::uint64_t, std::size_t>> places; // along the curve of Morton
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    std::uint64_t code = 0;
    for(int c = 0; c < 3; ++c)
    {
      const double share = size > 0. ? (points[i][c] - low[c]) / size : 0.;
      const auto cell = std::uint64_t(share * ((1 << bits) - 1));
      for(int bit = 0; bit < bits; ++bit)
        code |= (cell >> bit & 1) << (3 * bit + c);
    }
    places.emplace_back(code, i);
  }
  std::sort(places.begin(), places.end());
  std::vector<std::size_t> result;
  std::size_t stride = 1;
  while(2 * stride <= points.size())
    stride *= 2;
  for(std::size_t first = 0; stride > 0; first = stride /= 2)
    for(std::size_t i = first; i < points.size(); i += first == 0 ? stride : 2 * stride)
      result.push_back(places[i].second);
  return result;
}

// What was found for a point.
struct Pivot
{
  Spatial place;
  Vector potential;
  std::vector<std::array<float, 2>> flow; // what is rounded off is corrected where it is used
};

// Weights that sum to one, and with which the places of pivots sum to one about, small where they are far.
Eigen::VectorXd interpolation(const std::vector<const Pivot*>& pivots, const Spatial& place)
{
  const auto n = Eigen::Index(pivots.size());
  Eigen::VectorXd size(n);
  for(Eigen::Index i = 0; i < n; ++i)
    size[i] = norm(pivots[std::size_t(i)]->place - place);
  const double unit = std::max(size.maxCoeff(), std::numeric_limits<double>::min());
  size = size.cwiseMax(1e-6 * unit) / unit;
  Eigen::MatrixXd equations(4, n); // of weights times sizes
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const Spatial way = (1. / unit) * (pivots[std::size_t(i)]->place - place);
    equations.col(i) = Eigen::Vector4d(1., way[0], way[1], way[2]) / size[i];
  }
  // Places may lie on one plane or line.
  Eigen::Matrix4d squares = equations * equations.transpose();
  squares.diagonal().array() += 1e-6 * squares.trace();
  Eigen::VectorXd result =
      (equations.transpose() * squares.ldlt().solve(Eigen::Vector4d(1., 0., 0., 0.)))
          .cwiseQuotient(size);
  return result / result.sum();
}

class One_to_many
{
public:
  One_to_many(const Mean_value_coordinates& coordinates, const Transport_solver& solver,
              double scale, const Spatial& from, double tolerance)
      : m_coordinates(coordinates), m_solver(solver), m_scale(scale), m_tolerance(tolerance),
        m_from(from), m_from_coordinates(coordinates(from))
  {
    const std::vector<double>& area = operators().area;
    m_area = std::accumulate(area.begin(), area.end(), 0.);
  }

  // Bounds of a point, and a pivot if it had to be solved.
  Volumetric_bounds bounds(const Spatial& to, std::unique_ptr<Pivot>& pivot) const
  {
    Vector masses = Vector::Zero(Eigen::Index(operators().number_of_sites));
    masses.head(m_from_coordinates.size()) = m_coordinates(to) - m_from_coordinates;
    Volumetric_bounds result;
    result.lower = norm(to - m_from) / m_scale;
    result.upper = infinity;
    if(!m_pivots.empty())
      interpolate(to, masses, result);
    if(!is_close(result))
      solve(to, masses, result, pivot);
    result.lower = m_scale * std::min(result.lower, result.upper);
    result.upper *= m_scale;
    return result;
  }

  void add(std::unique_ptr<Pivot> pivot) { m_pivots.push_back(std::move(pivot)); }

private:
  static constexpr std::size_t neighbors = 6;
  static constexpr unsigned steps = 12;

  const Operators& operators() const { return m_solver.operators(); }

  bool is_close(const Volumetric_bounds& bounds) const
  {
    return bounds.lower >= (1. - m_tolerance) * bounds.upper;
  }

  double cost(const Field& flow) const
  {
    double result = 0.;
    for(std::size_t f = 0; f < flow.size(); ++f)
      result += operators().area[f] * norm(flow[f]);
    return result;
  }

  // To the nearest field that moves the masses.
  void correct(const Vector& masses, Field& flow) const
  {
    const Field missing = m_solver.least_flow(masses - divergence(operators(), flow));
    for(std::size_t f = 0; f < flow.size(); ++f)
      flow[f] = flow[f] + missing[f];
  }

  std::vector<const Pivot*> nearest_pivots(const Spatial& place) const
  {
    std::vector<std::pair<double, std::size_t>> far;
    for(std::size_t i = 0; i < m_pivots.size(); ++i)
      far.emplace_back(norm(m_pivots[i]->place - place), i);
    const std::size_t number = std::min(neighbors, far.size());
    std::partial_sort(far.begin(), far.begin() + std::ptrdiff_t(number), far.end());
    std::vector<const Pivot*> result;
    for(std::size_t i = 0; i < number; ++i)
      result.push_back(m_pivots[far[i].second].get());
    return result;
  }

  void interpolate(const Spatial& to, const Vector& masses, Volumetric_bounds& bounds) const
  {
    const std::vector<const Pivot*> pivots = nearest_pivots(to);
    const Pivot* best = pivots[0];
    double highest = -infinity;
    for(const Pivot* pivot : pivots)
      if(const double value = pivot->potential.dot(masses); value > highest)
      {
        highest = value;
        best = pivot;
      }
    bounds.lower = std::max(bounds.lower, highest);

    const Eigen::VectorXd weight = interpolation(pivots, to);
    Field flow(operators().number_of_triangles(), Planar{0., 0.});
    for(std::size_t i = 0; i < pivots.size(); ++i)
      for(std::size_t f = 0; f < flow.size(); ++f)
        for(std::size_t c = 0; c < 2; ++c)
          flow[f][c] += weight[Eigen::Index(i)] * pivots[i]->flow[f][c];
    correct(masses, flow);
    bounds.upper = cost(flow);
    // Some steps bring it to a quarter, no more.
    if(!is_close(bounds) && bounds.upper - bounds.lower < 4. * m_tolerance * bounds.upper)
      shorten(masses, best->potential, std::move(flow), bounds);
  }

  // As in Splitting, from a flow and a potential that are close to the best ones.
  void shorten(const Vector& masses, const Vector& potential, Field flow,
               Volumetric_bounds& bounds) const
  {
    const double threshold = std::sqrt(inner_product(operators(), flow, flow) / m_area) * 0.3;
    Field excess = gradient(operators(), potential);
    for(Planar& vector : excess)
      vector = threshold * vector;
    Field nearest(flow.size());
    for(unsigned step = 0; step < steps && !is_close(bounds); ++step)
    {
      for(std::size_t f = 0; f < flow.size(); ++f)
        nearest[f] = flow[f] - excess[f];
      correct(masses, nearest);
      bounds.upper = std::min(bounds.upper, cost(nearest));
      for(std::size_t f = 0; f < flow.size(); ++f)
      {
        const Planar w = 1.7 * nearest[f] + (-0.7) * flow[f] + excess[f];
        const double size = norm(w);
        flow[f] = size > threshold ? (1. - threshold / size) * w : Planar{0., 0.};
        excess[f] = w - flow[f];
      }
      ++bounds.iterations;
    }
  }

  void solve(const Spatial& to, const Vector& masses, Volumetric_bounds& bounds,
             std::unique_ptr<Pivot>& pivot) const
  {
    Transport_options options;
    options.tolerance = 0.2 * m_tolerance; // the rest is for the points around
    const Transport found = m_solver.solve(masses, options);
    bounds.lower = std::max(bounds.lower, found.lower);
    bounds.upper = std::min(bounds.upper, found.upper);
    bounds.iterations = found.iterations;
    bounds.is_solved = true;
    pivot = std::make_unique<Pivot>();
    pivot->place = to;
    pivot->potential = found.potential;
    for(const Planar& vector : found.flow)
      pivot->flow.push_back({float(vector[0]), float(vector[1])});
  }

  const Mean_value_coordinates& m_coordinates;
  const Transport_solver& m_solver;
  double m_scale, m_tolerance, m_area;
  Spatial m_from;
  Vector m_from_coordinates;
  std::vector<std::unique_ptr<Pivot>> m_pivots;
};

} // namespace

Volumetric_distances::Volumetric_distances(std::shared_ptr<const Glued_triangles> triangles,
                                           unsigned refinements)
    : m_triangles(triangles), m_coordinates(triangles), m_transport(triangles, refinements),
      m_tree(triangles)
{
  if(!is_one_piece(*triangles))
    throw Unsupported_surface_error(
        "The mesh has several pieces, and no mass can move from one to another.");
}

Earth_movers_result Volumetric_distances::cost(const Spatial& from, const Spatial& to,
                                               const Earth_movers_options& options) const
{
  Mass_distribution before, after;
  before.at_sites = m_coordinates(from);
  after.at_sites = m_coordinates(to);
  Earth_movers_result result = m_transport.solve(before, after, options);
  result.lower = std::min(result.upper, std::max(result.lower, norm(to - from)));
  result.value = 0.5 * (result.lower + result.upper);
  return result;
}

std::vector<Volumetric_bounds>
Volumetric_distances::one_to_many(const Spatial& from, const std::vector<Spatial>& to,
                                  const Volumetric_options& options) const
{
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  One_to_many query(m_coordinates, m_transport.finest_solver(), m_transport.finest_scale(), from,
                    options.tolerance);
  std::vector<Volumetric_bounds> result(to.size());
  if(to.empty())
    return result;
  const std::vector<std::size_t> order = coarse_to_fine(to);
  // Points of one part do not help each other, so that they may be found at the same time.
  for(std::size_t begin = 0, end; begin < order.size(); begin = end)
  {
    if(options.callback && !options.callback(double(begin) / double(order.size())))
      return {};
    end = std::min(order.size(), begin + std::clamp<std::size_t>(begin / 4, 1, 256));
    std::vector<std::unique_ptr<Pivot>> found(end - begin);
    for_each_block(end - begin, 1, options.threads,
                   [&](std::size_t i, std::size_t, std::size_t)
                   { result[order[begin + i]] = query.bounds(to[order[begin + i]], found[i]); });
    for(std::unique_ptr<Pivot>& pivot : found)
      if(pivot)
        query.add(std::move(pivot));
  }
  return result;
}

double Volumetric_distances::distance_to_surface(const Spatial& point) const
{
  return norm(from_surface(point));
}

// From the nearest point of the surface.
Spatial Volumetric_distances::from_surface(const Spatial& point) const
{
  return point - internal::coordinates(*m_triangles, m_tree.nearest(point));
}

// The gradient of the sum of potentials times coordinates, by differences.
Spatial Volumetric_distances::ascent(const Vector& potential, const Spatial& place,
                                     double step) const
{
  Spatial result;
  for(std::size_t c = 0; c < 3; ++c)
  {
    Spatial before = place, after = place;
    before[c] -= step;
    after[c] += step;
    const Vector change = m_coordinates(after) - m_coordinates(before);
    result[c] = potential.head(change.size()).dot(change) / (after[c] - before[c]);
  }
  return result;
}

// At a distance from the surface of at least `room`, as far as may be.
bool Volumetric_distances::descend(const Spatial& to, double room, unsigned maximum_solutions,
                                   Volumetric_path& path) const
{
  const Transport_solver& solver = m_transport.finest_solver();
  const Vector target = m_coordinates(to);
  const double room_at_end = distance_to_surface(to);
  Spatial place = path.points.back();
  double least = infinity;
  unsigned vain = 0;
  while(path.solutions < maximum_solutions && vain < 10)
  {
    Vector masses = Vector::Zero(Eigen::Index(solver.operators().number_of_sites));
    masses.head(target.size()) = target - m_coordinates(place);
    Transport_options options;
    options.tolerance = 5e-3;
    const Transport found = solver.solve(masses, options);
    ++path.solutions;
    vain = found.upper < 0.999 * least ? 0 : vain + 1;
    least = std::min(least, found.upper);
    Spatial away = from_surface(place);
    // Nearly the same potential is the best one somewhat farther on.
    const double reach =
        std::max(0.5 * norm(away), 0.02 * m_transport.finest_scale() * found.upper);
    for(double gone = 0.; gone < reach;)
    {
      const double clearance = norm(away);
      if(norm(to - place) < std::max(clearance, room_at_end))
      {
        path.points.push_back(to);
        return true;
      }
      const double step = std::min(0.4 * clearance, reach - gone + 1e-3 * reach);
      Spatial way = unit(ascent(found.potential, place, 1e-3 * clearance));
      const Spatial out = unit(away);
      if(clearance < 1.5 * room && dot(way, out) < 0.)
        way = way - dot(way, out) * out;
      if(clearance < room)
        way = way + (room - clearance) / room * out;
      place = place + step * way;
      away = from_surface(place);
      gone += step;
      path.points.push_back(place);
    }
  }
  return false;
}

Volumetric_path Volumetric_distances::path(const Spatial& from, const Spatial& to,
                                           unsigned maximum_solutions) const
{
  const double room = std::min(distance_to_surface(from), distance_to_surface(to));
  if(!(room > 0.))
    throw Invalid_argument_error("A path in space cannot begin or end on the surface.");
  if(!m_coordinates.are_on_one_side(from, to))
    throw Invalid_argument_error("The ends of a path are on different sides of the surface.");
  Volumetric_path result;
  result.points.push_back(from);
  // Where the way is narrow it goes closer to the surface.
  for(double part = 0.25; part > 1e-3 && !result.arrives; part *= 0.2)
    result.arrives = descend(to, part * room, maximum_solutions, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
