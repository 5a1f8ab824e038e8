// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/volumetric.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns true if all triangles are in one component. An isolated vertex is ignored, because it has
// no mass.
bool is_connected(const Surface_arrays& t)
{
  const auto component = components(operators(t, Degenerate_triangles::thickened)).first;
  return std::all_of(t.corner.begin(), t.corner.end(),
                     [&](Index vertex) { return component[vertex] == component[t.corner[0]]; });
}

// Returns an order of the points in which every prefix is evenly distributed. The points are sorted
// along a space-filling curve; strides are halved from level to level.
std::vector<std::size_t> coarse_to_fine(const std::vector<Vec3>& points)
{
  Vec3 low = points[0], high = low;
  for(const Vec3& p : points)
    for(int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  constexpr int bits = 21;
  std::vector<std::pair<std::uint64_t, std::size_t>> codes; // Morton codes
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    std::uint64_t code = 0;
    for(int c = 0; c < 3; ++c)
    {
      const double relative_position = size > 0. ? (points[i][c] - low[c]) / size : 0.;
      const auto cell = std::uint64_t(relative_position * ((1 << bits) - 1));
      for(int bit = 0; bit < bits; ++bit)
        code |= (cell >> bit & 1) << (3 * bit + c);
    }
    codes.emplace_back(code, i);
  }
  std::sort(codes.begin(), codes.end());
  std::vector<std::size_t> result;
  std::size_t stride = 1;
  while(2 * stride <= points.size())
    stride *= 2;
  for(std::size_t first = 0; stride > 0; first = stride /= 2)
    for(std::size_t i = first; i < points.size(); i += first == 0 ? stride : 2 * stride)
      result.push_back(codes[i].second);
  return result;
}

// The solution for one point.
struct Pivot
{
  Vec3 point;
  Vector potential;
  // in single precision: round-off errors are corrected at each use
  std::vector<std::array<float, 2>> flow;
};

constexpr std::size_t max_number_of_pivots = 6; // in an interpolation

// With a bounded size, Eigen expands products in place. Its kernels for large matrices take seconds
// to compile.
using Small_vector =
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_number_of_pivots, 1>;

// Returns weights that sum to 1. The weighted mean of the pivots is close to the point, and the
// weight of a distant pivot is small.
Small_vector interpolation_weights(const std::vector<const Pivot*>& pivots, const Vec3& point)
{
  const auto n = Eigen::Index(pivots.size());
  Small_vector size(n);
  for(Eigen::Index i = 0; i < n; ++i)
    size[i] = norm(pivots[std::size_t(i)]->point - point);
  const double unit = std::max(size.maxCoeff(), std::numeric_limits<double>::min());
  size = size.cwiseMax(1e-6 * unit) / unit;
  // for weights times distances
  Eigen::Matrix<double, 4, Eigen::Dynamic, Eigen::ColMajor, 4, max_number_of_pivots>
      moment_equations(4, n);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    const Vec3 direction = (1. / unit) * (pivots[std::size_t(i)]->point - point);
    moment_equations.col(i) =
        Eigen::Vector4d(1., direction[0], direction[1], direction[2]) / size[i];
  }
  // The pivots can be coplanar or collinear: regularize.
  Eigen::Matrix4d normal_matrix = moment_equations * moment_equations.transpose();
  normal_matrix.diagonal().array() += 1e-6 * normal_matrix.trace();
  Small_vector result =
      (moment_equations.transpose() * normal_matrix.ldlt().solve(Eigen::Vector4d(1., 0., 0., 0.)))
          .cwiseQuotient(size);
  return result / result.sum();
}

// Distances from one point to many. Solved points are pivots, from which those of other points are
// interpolated.
class One_to_many_query
{
public:
  One_to_many_query(const Volumetric_distances& distances, const Transport_solver& solver,
                    double scale, const Vec3& from, double tolerance)
      : m_distances(distances), m_solver(solver), m_scale(scale), m_tolerance(tolerance),
        m_from(from), m_from_coordinates(distances.coordinates(from))
  {
    const std::vector<double>& area = operators().area;
    m_area = std::accumulate(area.begin(), area.end(), 0.);
  }

  // Returns the bounds for a point. If it has to be solved, its solution is returned in `pivot`.
  Volumetric_bounds bounds(const Vec3& to, std::unique_ptr<Pivot>& pivot) const
  {
    Vector masses = Vector::Zero(Eigen::Index(operators().number_of_vertices));
    const Vector difference = m_distances.coordinates(to) - m_from_coordinates;
    masses.head(difference.size()) = difference;
    Volumetric_bounds result;
    result.lower = m_distances.euclidean_bound(m_from, to, difference) / m_scale;
    result.upper = infinity;
    if(!m_pivots.empty())
      interpolate(to, masses, result);
    if(!is_within_tolerance(result))
      solve(to, masses, result, pivot);
    result.lower = m_scale * std::min(result.lower, result.upper);
    result.upper *= m_scale;
    return result;
  }

  void add(std::unique_ptr<Pivot> pivot) { m_pivots.push_back(std::move(pivot)); }

private:
  static constexpr unsigned max_steps = 12;

  const Operators& operators() const { return m_solver.operators(); }

  bool is_within_tolerance(const Volumetric_bounds& bounds) const
  {
    return bounds.lower >= (1. - m_tolerance) * bounds.upper;
  }

  double cost(const Field& flow) const { return integrated_length(operators(), flow); }

  // Projects the flow onto the flows that balance the masses.
  void correct(const Vector& masses, Field& flow) const
  {
    const Field correction =
        m_solver.least_squares_flow(masses - minus_divergence(operators(), flow));
    for(std::size_t f = 0; f < flow.size(); ++f)
      flow[f] = flow[f] + correction[f];
  }

  std::vector<const Pivot*> nearest_pivots(const Vec3& point) const
  {
    std::vector<std::pair<double, std::size_t>> distances_to_all;
    for(std::size_t i = 0; i < m_pivots.size(); ++i)
      distances_to_all.emplace_back(norm(m_pivots[i]->point - point), i);
    const std::size_t number = std::min(max_number_of_pivots, distances_to_all.size());
    std::partial_sort(distances_to_all.begin(), distances_to_all.begin() + std::ptrdiff_t(number),
                      distances_to_all.end());
    std::vector<const Pivot*> result;
    for(std::size_t i = 0; i < number; ++i)
      result.push_back(m_pivots[distances_to_all[i].second].get());
    return result;
  }

  // Computes bounds from the nearest pivots: the best of their potentials, and an interpolated and
  // corrected flow.
  void interpolate(const Vec3& to, const Vector& masses, Volumetric_bounds& bounds) const
  {
    const std::vector<const Pivot*> pivots = nearest_pivots(to);
    const Pivot* best = pivots[0];
    double max_bound = -infinity;
    for(const Pivot* pivot : pivots)
      if(const double value = pivot->potential.dot(masses); value > max_bound)
      {
        max_bound = value;
        best = pivot;
      }
    bounds.lower = std::max(bounds.lower, max_bound);

    const Small_vector weight = interpolation_weights(pivots, to);
    Field flow(operators().number_of_triangles(), Vec2{0., 0.});
    for(std::size_t i = 0; i < pivots.size(); ++i)
      for(std::size_t f = 0; f < flow.size(); ++f)
        for(std::size_t c = 0; c < 2; ++c)
          flow[f][c] += weight[Eigen::Index(i)] * pivots[i]->flow[f][c];
    correct(masses, flow);
    bounds.upper = cost(flow);
    // The iterations reduce the gap by a factor of at most 4: try only if that suffices.
    if(!is_within_tolerance(bounds) &&
       bounds.upper - bounds.lower < 4. * m_tolerance * bounds.upper)
      refine(masses, best->potential, std::move(flow), bounds);
  }

  // Applies the splitting method, starting from an approximate flow and potential.
  void refine(const Vector& masses, const Vector& potential, Field flow,
              Volumetric_bounds& bounds) const
  {
    const double threshold = std::sqrt(inner_product(operators(), flow, flow) / m_area) * 0.3;
    Field scaled_dual = gradient(operators(), potential);
    for(Vec2& vector : scaled_dual)
      vector = threshold * vector;
    Field projected(flow.size());
    for(unsigned step = 0; step < max_steps && !is_within_tolerance(bounds); ++step)
    {
      for(std::size_t f = 0; f < flow.size(); ++f)
        projected[f] = flow[f] - scaled_dual[f];
      correct(masses, projected);
      bounds.upper = std::min(bounds.upper, cost(projected));
      for(std::size_t f = 0; f < flow.size(); ++f)
      {
        const Vec2 w = 1.7 * projected[f] + (-0.7) * flow[f] + scaled_dual[f];
        const double size = norm(w);
        flow[f] = size > threshold ? (1. - threshold / size) * w : Vec2{0., 0.};
        scaled_dual[f] = w - flow[f];
      }
      ++bounds.number_of_iterations;
    }
  }

  // Solves the transport problem of a point, and stores its solution as a pivot.
  void solve(const Vec3& to, const Vector& masses, Volumetric_bounds& bounds,
             std::unique_ptr<Pivot>& pivot) const
  {
    Transport_options options;
    // the remaining tolerance is for interpolated points nearby
    options.tolerance = 0.2 * m_tolerance;
    const Transport_result found = m_solver.solve(masses, options);
    bounds.lower = std::max(bounds.lower, found.lower);
    bounds.upper = std::min(bounds.upper, found.upper);
    bounds.number_of_iterations = found.number_of_iterations;
    bounds.is_solved = true;
    pivot = std::make_unique<Pivot>();
    pivot->point = to;
    pivot->potential = found.potential;
    for(const Vec2& vector : found.flow)
      pivot->flow.push_back({float(vector[0]), float(vector[1])});
  }

  const Volumetric_distances& m_distances;
  const Transport_solver& m_solver;
  double m_scale, m_tolerance, m_area;
  Vec3 m_from;
  Vector m_from_coordinates;
  std::vector<std::unique_ptr<Pivot>> m_pivots;
};

} // namespace

Vector checked_coordinates(const Surface_arrays& t, const Vec3& point, Vector weights)
{
  // Coordinates that follow from iterative solutions have such errors.
  constexpr double tolerance = 1e-6;
  if(weights.size() != Eigen::Index(t.number_of_vertices()))
    throw Invalid_argument_error("The number of barycentric coordinates is not that of vertices.");
  const double size = weights.lpNorm<1>(), sum = weights.sum();
  if(!std::isfinite(size))
    throw Invalid_argument_error("A barycentric coordinate is not finite.");
  if(!(std::abs(sum - 1.) <= tolerance * size))
    throw Invalid_argument_error("The barycentric coordinates do not sum to one.");
  weights /= sum;
  double extent = 0.;
  for(const Index vertex : t.corner)
    extent = std::max(extent, norm(t.point[vertex] - t.point[t.corner[0]]));
  Vec3 error = {0., 0., 0.};
  bool is_vertex = false;
  double weight_at_point = 0.; // of the vertices there
  for(Index i = 0; i < t.number_of_vertices(); ++i)
  {
    const bool is_isolated = t.ring_begin[i] == t.ring_begin[i + 1];
    if(is_isolated && weights[i] != 0.)
      throw Invalid_argument_error("A vertex without faces has a barycentric coordinate.");
    const Vec3 offset = t.point[i] - (1. / t.scale) * (point - t.origin);
    error = error + weights[i] * offset;
    if(!is_isolated && norm(offset) <= 1e-12 * extent) // round-off errors of scaled coordinates
    {
      is_vertex = true;
      weight_at_point += weights[i];
    }
  }
  if(!(norm(error) <= tolerance * extent * size))
    throw Invalid_argument_error("The barycentric coordinates do not reproduce the point.");
  if(is_vertex && !(std::abs(weight_at_point - 1.) <= tolerance && size <= 1. + 3. * tolerance))
    throw Invalid_argument_error("The barycentric coordinates of a vertex are not those of it.");
  return weights;
}

Volumetric_distances::Volumetric_distances(std::shared_ptr<const Surface_arrays> triangles,
                                           unsigned refinements,
                                           Coordinate_function coordinate_function)
    : m_triangles(triangles), m_mean_value_coordinates(triangles),
      m_transport_solver(triangles, refinements), m_tree(triangles)
{
  if(coordinate_function)
    m_coordinate_function = [function = std::move(coordinate_function),
                             mutex = std::make_shared<std::mutex>()](const Vec3& point)
    {
      const std::lock_guard<std::mutex> lock(*mutex);
      return function(point);
    };
  if(!is_connected(*triangles))
    throw Unsupported_surface_error(
        "The mesh has several components, but no mass can move between components.");
}

Vector Volumetric_distances::coordinates(const Vec3& point) const
{
  if(!m_coordinate_function)
    return m_mean_value_coordinates(point);
  for(const double coordinate : point)
    if(!std::isfinite(coordinate))
      throw Invalid_argument_error("A coordinate of a point is not finite.");
  return checked_coordinates(*m_triangles, point, m_coordinate_function(point));
}

// Coordinates of the caller can have errors. The bound is then the distance of the points that they
// reproduce, because it is the change of a linear function.
double Volumetric_distances::euclidean_bound(const Vec3& from, const Vec3& to,
                                             const Vector& difference) const
{
  if(!m_coordinate_function)
    return norm(to - from);
  Vec3 result = {0., 0., 0.};
  for(Eigen::Index i = 0; i < difference.size(); ++i)
    result = result + difference[i] * m_triangles->point[std::size_t(i)];
  return m_triangles->scale * norm(result);
}

Transport_result Volumetric_distances::cost(const Vec3& from, const Vec3& to,
                                            const Transport_options& options) const
{
  Mass_distribution before, after;
  before.at_vertices = coordinates(from);
  after.at_vertices = coordinates(to);
  Transport_result result = m_transport_solver.solve(before, after, options);
  result.lower = std::min(
      result.upper,
      std::max(result.lower, euclidean_bound(from, to, after.at_vertices - before.at_vertices)));
  result.value = 0.5 * (result.lower + result.upper);
  return result;
}

std::vector<Volumetric_bounds>
Volumetric_distances::one_to_many(const Vec3& from, const std::vector<Vec3>& to,
                                  const Volumetric_options& options) const
{
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance must be positive.");
  One_to_many_query query(*this, m_transport_solver.finest_level_solver(),
                          m_transport_solver.finest_level_scale(), from, options.tolerance);
  std::vector<Volumetric_bounds> result(to.size());
  if(to.empty())
    return result;
  const std::vector<std::size_t> order = coarse_to_fine(to);
  // Points of one batch do not use each other's solutions, so that they can be solved in parallel.
  for(std::size_t begin = 0, end; begin < order.size(); begin = end)
  {
    if(options.callback && !options.callback(double(begin) / double(order.size())))
      return {};
    end = std::min(order.size(), begin + std::clamp<std::size_t>(begin / 4, 1, 256));
    std::vector<std::unique_ptr<Pivot>> found(end - begin);
    for_each_block(end - begin, 1, options.number_of_threads,
                   [&](std::size_t i, std::size_t, std::size_t)
                   { result[order[begin + i]] = query.bounds(to[order[begin + i]], found[i]); });
    for(std::unique_ptr<Pivot>& pivot : found)
      if(pivot)
        query.add(std::move(pivot));
  }
  return result;
}

double Volumetric_distances::distance_to_surface(const Vec3& point) const
{
  return norm(offset_from_surface(point));
}

// Returns the vector from the closest point of the surface.
Vec3 Volumetric_distances::offset_from_surface(const Vec3& point) const
{
  return point - internal::coordinates(*m_triangles, m_tree.nearest(point));
}

// Computes the gradient of the sum of potential times coordinates, by central differences.
Vec3 Volumetric_distances::potential_gradient(const Vector& potential, const Vec3& point,
                                              double step) const
{
  Vec3 result;
  for(std::size_t c = 0; c < 3; ++c)
  {
    Vec3 before = point, after = point;
    before[c] -= step;
    after[c] += step;
    const Vector change = coordinates(after) - coordinates(before);
    result[c] = potential.head(change.size()).dot(change) / (after[c] - before[c]);
  }
  return result;
}

// Descends with a clearance of at least `clearance_target` if possible. Returns true if the path
// arrives.
bool Volumetric_distances::descend(const Vec3& to, double clearance_target,
                                   unsigned maximum_number_of_solutions,
                                   Volumetric_path& path) const
{
  const Transport_solver& solver = m_transport_solver.finest_level_solver();
  const Vector target = coordinates(to);
  const double end_clearance = distance_to_surface(to);
  Vec3 point = path.points.back();
  double min_upper = infinity;
  unsigned number_of_stalls = 0;
  while(path.number_of_solutions < maximum_number_of_solutions && number_of_stalls < 10)
  {
    Vector masses = Vector::Zero(Eigen::Index(solver.operators().number_of_vertices));
    masses.head(target.size()) = target - coordinates(point);
    Transport_options options;
    options.tolerance = 5e-3;
    const Transport_result found = solver.solve(masses, options);
    ++path.number_of_solutions;
    number_of_stalls = found.upper < 0.999 * min_upper ? 0 : number_of_stalls + 1;
    min_upper = std::min(min_upper, found.upper);
    Vec3 offset = offset_from_surface(point);
    // The optimal potential changes slowly: use it over this distance.
    const double max_travel =
        std::max(0.5 * norm(offset), 0.02 * m_transport_solver.finest_level_scale() * found.upper);
    for(double traveled = 0.; traveled < max_travel;)
    {
      const double clearance = norm(offset);
      if(norm(to - point) < std::max(clearance, end_clearance))
      {
        path.points.push_back(to);
        return true;
      }
      const double step = std::min(0.4 * clearance, max_travel - traveled + 1e-3 * max_travel);
      Vec3 direction = unit(potential_gradient(found.potential, point, 1e-3 * clearance));
      const Vec3 outward_direction = unit(offset);
      if(clearance < 1.5 * clearance_target && dot(direction, outward_direction) < 0.)
        direction = direction - dot(direction, outward_direction) * outward_direction;
      if(clearance < clearance_target)
        direction =
            direction + (clearance_target - clearance) / clearance_target * outward_direction;
      point = point + step * direction;
      offset = offset_from_surface(point);
      traveled += step;
      path.points.push_back(point);
    }
  }
  return false;
}

Volumetric_path Volumetric_distances::path(const Vec3& from, const Vec3& to,
                                           unsigned maximum_number_of_solutions) const
{
  const double clearance_target = std::min(distance_to_surface(from), distance_to_surface(to));
  if(!(clearance_target > 0.))
    throw Invalid_argument_error("A path in space cannot begin or end on the surface.");
  if(!m_mean_value_coordinates.are_on_same_side(from, to))
    throw Invalid_argument_error("The ends of a path are on different sides of the surface.");
  Volumetric_path result;
  result.points.push_back(from);
  // If a passage is narrow, try a smaller clearance.
  for(double clearance_ratio = 0.25; clearance_ratio > 1e-3 && !result.has_arrived;
      clearance_ratio *= 0.2)
    result.has_arrived =
        descend(to, clearance_ratio * clearance_target, maximum_number_of_solutions, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
