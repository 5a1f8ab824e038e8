// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_energy.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

Spatial without(const Spatial& direction, const Spatial& p)
{
  return p - dot(p, direction) * direction;
}

double product(const std::vector<Spatial>& p, const std::vector<Spatial>& q)
{
  double sum = 0.;
  for(std::size_t i = 0; i < p.size(); ++i)
    sum += dot(p[i], q[i]);
  return sum;
}

// The matrix of the first sum, and `shift` on the diagonal, for the inner nodes.
class Tridiagonal
{
public:
  Tridiagonal(const std::vector<double>& share, double shift)
      : m_beside(share.size() + 1, 0.), m_over(share.size() + 1, 0.)
  {
    for(std::size_t i = 1; i < share.size(); ++i)
    {
      m_beside[i] = 2. / share[i];
      m_over[i] = 1. / (2. / share[i - 1] + 2. / share[i] + shift -
                        (i > 1 ? m_beside[i - 1] * m_beside[i - 1] * m_over[i - 1] : 0.));
    }
  }
  void solve(std::vector<Spatial>& x) const
  {
    const std::size_t n = x.size();
    for(std::size_t i = 2; i + 1 < n; ++i)
      x[i] = x[i] + m_beside[i - 1] * m_over[i - 1] * x[i - 1];
    for(std::size_t i = n - 2; i > 0; --i)
      x[i] = m_over[i] * (i + 2 < n ? x[i] + m_beside[i] * x[i + 1] : x[i]);
  }

private:
  std::vector<double> m_beside,
      m_over; // #nodes: the off-diagonal, negated, and one over the pivots
};

struct State
{
  std::vector<Spatial> points;
  std::vector<Foot> feet, middles;
  Path_energy energy;
};

class Minimizer
{
public:
  Minimizer(const Path_surface& surface, const Path_options& options,
            const std::vector<double>& share, std::vector<Foot>& path)
      : m_surface(surface), m_options(options), m_share(share), m_path(path),
        m_mean_length(polyline_length(path) / double(path.size() - 1)), m_along(share, 0.),
        m_across(share, 2. * (options.alpha + options.beta))
  {
    for(const Foot& foot : path)
      m_now.points.push_back(foot.point);
    m_now.feet = path;
    if(m_options.hold == Path_hold::energy)
      m_now.middles.assign(path.begin(), path.end() - 1);
    evaluate(m_now);
  }

  Path_energy_level operator()()
  {
    Path_energy_level level = {m_path.size() - 2, 0, m_now.energy.value, 0.};
    std::vector<Spatial> gradient = m_now.energy.gradient, step = preconditioned(gradient),
                         direction;
    double product_before = product(gradient, step), last_decrease = infinity;
    for(const Spatial& s : step)
      direction.push_back(-1. * s);
    while(level.number_of_iterations < m_options.iterations)
    {
      const double slope = product(m_now.energy.gradient, direction);
      if(!(-slope > 0.1 * m_options.tolerance * m_now.energy.value))
        break;
      const double before = m_now.energy.value;
      const bool is_straight = search(direction, slope);
      if(!is_straight && !sweep())
        break;
      ++level.number_of_iterations;
      const double decrease = before - m_now.energy.value;
      if(std::max(decrease, last_decrease) < m_options.tolerance * before)
        break;
      last_decrease = decrease;
      // Polak and Ribiere, with a fresh start where their factor is negative.
      const std::vector<Spatial> next = preconditioned(m_now.energy.gradient);
      const double product_now = product(m_now.energy.gradient, next);
      const double factor =
          is_straight ? std::max(0., (product_now - product(gradient, next)) / product_before) : 0.;
      for(std::size_t i = 0; i < direction.size(); ++i)
        direction[i] = tangential(i, factor * direction[i]) - next[i];
      if(!(product(m_now.energy.gradient, direction) < -0.01 * product_now))
        for(std::size_t i = 0; i < direction.size(); ++i)
          direction[i] = -1. * next[i];
      gradient = m_now.energy.gradient;
      product_before = product_now;
    }
    level.last_energy = m_now.energy.value;
    for(std::size_t i = 0; i < m_path.size(); ++i)
    {
      m_path[i] = m_now.feet[i];
      m_path[i].point = m_now.points[i];
    }
    return level;
  }

private:
  void evaluate(State& state) const
  {
    internal::evaluate(m_surface, m_options, m_share, m_mean_length, state.points, state.feet,
                       state.middles, state.energy);
  }

  // What a projected node can do of a step.
  Spatial tangential(std::size_t i, Spatial step) const
  {
    if(m_options.hold == Path_hold::energy)
      return step;
    const Foot& foot = m_now.feet[i];
    step = without(foot.normal, step);
    // Against the rim it can only slide.
    if(dot(m_now.energy.gradient[i], foot.rim) < 0.)
      step = without(foot.rim, step);
    return step;
  }

  std::vector<Spatial> preconditioned(const std::vector<Spatial>& gradient) const
  {
    std::vector<Spatial> step = gradient;
    if(m_options.hold == Path_hold::projected)
    {
      for(std::size_t i = 0; i < step.size(); ++i)
        step[i] = tangential(i, step[i]);
      m_along.solve(step);
      for(std::size_t i = 0; i < step.size(); ++i)
        step[i] = tangential(i, step[i]);
      return step;
    }
    // Across the surface the distances pull as well.
    std::vector<Spatial> across(step.size());
    for(std::size_t i = 0; i < step.size(); ++i)
    {
      const Spatial& normal = m_now.feet[i].normal;
      across[i] = dot(step[i], normal) * normal;
      step[i] = step[i] - across[i];
    }
    m_along.solve(step);
    m_across.solve(across);
    for(std::size_t i = 0; i < step.size(); ++i)
    {
      const Spatial& normal = m_now.feet[i].normal;
      step[i] = without(normal, step[i]) + dot(across[i], normal) * normal;
    }
    return step;
  }

  void go(const std::vector<Spatial>& direction, double share, State& state) const
  {
    state.points = m_now.points;
    state.feet = m_now.feet;
    state.middles = m_now.middles;
    for(std::size_t i = 1; i + 1 < direction.size(); ++i)
      state.points[i] = state.points[i] + share * direction[i];
    evaluate(state);
  }

  // Goes down along a direction; false where it cannot.  The preconditioner is Newton's on a plane:
  // the whole step is right where the surface hardly bends.
  bool search(const std::vector<Spatial>& direction, double slope)
  {
    constexpr double enough = 1e-4; // of what the slope promises (Armijo)
    double share = 1.;
    const double start = m_now.energy.value;
    for(int i = 0; i < 12; ++i)
    {
      go(direction, share, m_next);
      const double rise = m_next.energy.value - start;
      // The least place of the parabola through what is known.
      const double best = -0.5 * slope * share * share / (rise - slope * share);
      if(rise <= enough * share * slope)
      {
        if(best > 0. && best < 4. * share && std::abs(best - share) > 0.2 * share)
        {
          go(direction, best, m_other);
          if(m_other.energy.value < m_next.energy.value)
            std::swap(m_other, m_next);
        }
        std::swap(m_now, m_next);
        return true;
      }
      share = std::clamp(best, 0.1 * share, 0.5 * share);
    }
    return false;
  }

  // Moves one projected node after the other between its neighbours: where feet jump, at sharp edges and
  // where surfels disagree, no step of all nodes goes down although most of them could.
  bool sweep()
  {
    if(m_options.hold == Path_hold::energy)
      return false;
    m_next = m_now;
    std::vector<Spatial>& points = m_next.points;
    for(int k = 0; k < sweeps; ++k)
      for(std::size_t i = 1; i + 1 < points.size(); ++i)
      {
        const double before = 1. / m_share[i - 1], after = 1. / m_share[i];
        const auto energy = [&](const Spatial& p)
        {
          const Spatial s = p - points[i - 1], t = points[i + 1] - p;
          return before * dot(s, s) + after * dot(t, t);
        };
        const Foot foot =
            m_surface.foot(1. / (before + after) * (before * points[i - 1] + after * points[i + 1]),
                           m_next.feet[i].site);
        if(energy(foot.point) < energy(points[i]))
        {
          points[i] = foot.point;
          m_next.feet[i] = foot;
        }
      }
    evaluate(m_next);
    if(!(m_next.energy.value < m_now.energy.value))
      return false;
    std::swap(m_now, m_next);
    return true;
  }

  static constexpr int sweeps = 4;

  const Path_surface& m_surface;
  const Path_options& m_options;
  const std::vector<double>& m_share;
  std::vector<Foot>& m_path;
  double m_mean_length;
  Tridiagonal m_along, m_across;
  State m_now, m_next, m_other;
};

// The point after the share of a polyline's length.
Foot at(const std::vector<Foot>& chain, const std::vector<double>& along, double length)
{
  const std::size_t i = std::clamp<std::size_t>(
      std::lower_bound(along.begin(), along.end(), length) - along.begin(), 1, along.size() - 1);
  const double step = along[i] - along[i - 1];
  const double share = step > 0. ? (length - along[i - 1]) / step : 0.;
  Foot foot = chain[share < 0.5 ? i - 1 : i];
  foot.point = chain[i - 1].point + share * (chain[i].point - chain[i - 1].point);
  return foot;
}

std::vector<double> lengths_along(const std::vector<Foot>& chain)
{
  std::vector<double> along = {0.};
  for(std::size_t i = 0; i + 1 < chain.size(); ++i)
    along.push_back(along.back() + norm(chain[i + 1].point - chain[i].point));
  return along;
}

// The feet of evenly spaced points of a chain, and its ends.
std::vector<Foot> resampled(const Path_surface& surface, const std::vector<Foot>& chain,
                            std::size_t nodes)
{
  const std::vector<double> along = lengths_along(chain);
  std::vector<Foot> result = {chain.front()};
  for(std::size_t i = 1; i + 1 < nodes; ++i)
  {
    const Foot place = at(chain, along, along.back() * double(i) / double(nodes - 1));
    result.push_back(surface.foot(place.point, place.site));
  }
  result.push_back(chain.back());
  return result;
}

// How far a chain strays from `nodes` of its points, as a part of the distance between them.
double deviation(const std::vector<Foot>& chain, std::size_t nodes)
{
  const std::vector<double> along = lengths_along(chain);
  const double step = along.back() / double(nodes - 1);
  double most = 0.;
  Spatial from = chain.front().point, to = from;
  std::size_t next = 0;
  for(std::size_t i = 0; i < chain.size(); ++i)
  {
    while(next + 1 < nodes && along[i] >= step * double(next))
    {
      ++next;
      from = to;
      to = at(chain, along, step * double(next)).point;
    }
    const Spatial way = chain[i].point - from, segment = to - from;
    const double square = dot(segment, segment);
    const double share = square > 0. ? std::clamp(dot(way, segment) / square, 0., 1.) : 0.;
    most = std::max(most, norm(way - share * segment));
  }
  return step > 0. ? most / step : 0.;
}

double cosine_between(const Spatial& p, const Spatial& q)
{
  const double size = norm(p) * norm(q);
  return size > 0. ? dot(p, q) / size : 1.;
}

// The length of an arc over a chord, by the sine of half of its angle.
double arc_over(double chord, double sine)
{
  return chord * (sine > 1e-4 && sine < 1. ? std::asin(sine) / sine : 1. + sine * sine / 6.);
}

constexpr double corner = 0.86602540378443865; // the cosine of 30 degrees

// Normals that differ by more than 40 degrees have a sharp edge between them.
constexpr double sharp = 0.76604444311897804;

// Where the shortest way between two points passes the line in which their tangent planes meet, and
// how long it is; false where there is no sharp edge.
bool find_edge(const Foot& from, const Foot& to, Spatial& point, double& length)
{
  const Spatial chord = to.point - from.point;
  const double cosine = dot(from.normal, to.normal);
  if(cosine > sharp || cosine < -0.99 || dot(from.normal, from.normal) == 0. ||
     dot(to.normal, to.normal) == 0.)
    return false;
  const Spatial along = unit(cross(from.normal, to.normal));
  // The point of the line above `from`, in the plane of the two normals.
  const Spatial across = chord - dot(chord, along) * along;
  const double height = dot(across, to.normal), square = 1. - cosine * cosine;
  const double a = -cosine * height / square, b = height / square;
  const Spatial foot = a * from.normal + b * to.normal; // of the line, seen from `from`
  const double before = norm(foot), after = norm(foot - across);
  // An edge beside the two is not between them.
  if(before + after > 2. * norm(chord))
    return false;
  const double step = dot(chord, along);
  const double share = before + after > 0. ? before / (before + after) : 0.5;
  point = from.point + foot + share * step * along;
  length = std::hypot(before + after, step);
  return true;
}

// The same path with a point on each sharp edge.
std::vector<Foot> with_edges(const std::vector<Foot>& path)
{
  std::vector<Foot> result = {path.front()};
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    Foot edge = path[i];
    double length;
    if(find_edge(path[i], path[i + 1], edge.point, length))
      result.push_back(edge);
    result.push_back(path[i + 1]);
  }
  return result;
}

// A point between each two: on the cubic through four (Dyn, Levin and Gregory 1987) where there is
// no corner.
std::vector<Foot> subdivided(const Path_surface& surface, const std::vector<Foot>& path)
{
  std::vector<Foot> result;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Spatial &p = path[i].point, &q = path[i + 1].point;
    Spatial middle = 0.5 * (p + q);
    const auto bend = [&](std::size_t j) -> Spatial
    {
      if(j == 0 || j + 1 == path.size())
        return {0., 0., 0.};
      const Spatial before = path[j].point - path[j - 1].point,
                    after = path[j + 1].point - path[j].point;
      return cosine_between(before, after) > corner ? before - after : Spatial{0., 0., 0.};
    };
    const bool has_left = i > 0, has_right = i + 2 < path.size();
    const double weight = has_left && has_right ? 1. / 16. : 1. / 8.;
    middle = middle + weight * (bend(i) + bend(i + 1));
    result.push_back(path[i]);
    result.push_back(surface.foot(middle, path[i].site));
  }
  result.push_back(path.back());
  return result;
}

// Relative decreases of the energy at which a level with fewer control points ends.
constexpr double rough = 1e-6;

// How often segments that leave the surface are halved.
constexpr int refinements = 4;

// Inserts control points where the middle of a segment is farther from the surface than a twentieth
// of its length, or beyond the border; false where there are none.
bool refined(const Path_surface& surface, std::vector<double>& share, std::vector<Foot>& path)
{
  std::vector<Foot> result = {path.front()};
  std::vector<double> shares;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Spatial middle = 0.5 * (path[i].point + path[i + 1].point);
    const Foot foot = surface.foot(middle, path[i].site);
    const double length = norm(path[i + 1].point - path[i].point);
    if(norm(foot.point - middle) > 0.05 * length)
    {
      result.push_back(foot);
      shares.insert(shares.end(), 2, 0.5 * share[i]);
    }
    else
      shares.push_back(share[i]);
    result.push_back(path[i + 1]);
  }
  const bool is_changed = result.size() > path.size();
  path = std::move(result);
  share = std::move(shares);
  return is_changed;
}

} // namespace

void evaluate(const Path_surface& surface, const Path_options& options,
              const std::vector<double>& share, double mean_length, std::vector<Spatial>& points,
              std::vector<Foot>& feet, std::vector<Foot>& middles, Path_energy& energy)
{
  const std::size_t n = points.size();
  const bool is_drawn = options.hold == Path_hold::energy;
  energy.value = 0.;
  energy.gradient.assign(n, {0., 0., 0.});
  for(std::size_t i = 1; i + 1 < n; ++i)
  {
    feet[i] = surface.foot(points[i], feet[i].site);
    if(!is_drawn)
    {
      points[i] = feet[i].point;
      continue;
    }
    const Spatial way = points[i] - feet[i].point;
    energy.value += options.alpha * dot(way, way);
    energy.gradient[i] = 2. * options.alpha * way;
  }
  const double beta = options.beta * mean_length * mean_length;
  for(std::size_t i = 0; i + 1 < n; ++i)
  {
    const Spatial segment = points[i + 1] - points[i];
    const double square = dot(segment, segment);
    energy.value += square / share[i];
    Spatial pull = 2. / share[i] * segment; // the derivative by the segment
    if(is_drawn && beta > 0. && square > 0.)
    {
      const Spatial middle = 0.5 * (points[i] + points[i + 1]);
      middles[i] = surface.foot(middle, middles[i].site);
      const Spatial way = middle - middles[i].point;
      const double part = beta * dot(way, way) / square;
      energy.value += part;
      pull = pull - 2. * part / square * segment;
      const Spatial push = beta / square * way; // half of the derivative by the middle
      energy.gradient[i] = energy.gradient[i] + push;
      energy.gradient[i + 1] = energy.gradient[i + 1] + push;
    }
    energy.gradient[i] = energy.gradient[i] - pull;
    energy.gradient[i + 1] = energy.gradient[i + 1] + pull;
  }
  energy.gradient.front() = energy.gradient.back() = {0., 0., 0.};
}

Path_energy_level minimize(const Path_surface& surface, const Path_options& options,
                           const std::vector<double>& share, std::vector<Foot>& path)
{
  if(path.size() < 3)
    return {};
  return Minimizer(surface, options, share, path)();
}

void draw_curve(const Path_surface& surface, const std::vector<Foot>& nodes, Shortened_path& path)
{
  path.points = subdivided(surface, subdivided(surface, with_edges(nodes)));
  for(std::size_t i = 1; i + 1 < path.points.size(); ++i)
    path.points[i].point = surface.drawn_near(path.points[i].point, path.points[i].site);
  path.length = length_along_arcs(path.points);
  path.polyline_length = polyline_length(path.points);
}

double polyline_length(const std::vector<Foot>& points)
{
  double sum = 0.;
  for(std::size_t i = 0; i + 1 < points.size(); ++i)
    sum += norm(points[i + 1].point - points[i].point);
  return sum;
}

double length_of_arc(const Foot& from, const Foot& to)
{
  Spatial edge;
  double around;
  if(find_edge(from, to, edge, around))
    return around;
  const Spatial chord = to.point - from.point;
  const double length = norm(chord);
  const auto angle = [&](const Spatial& normal)
  { return length > 0. ? std::asin(std::clamp(dot(chord, normal) / length, -1., 1.)) : 0.; };
  return arc_over(length, std::sin(0.5 * std::abs(angle(from.normal) - angle(to.normal))));
}

double length_along_arcs(const std::vector<Foot>& points)
{
  const std::size_t n = points.size();
  std::vector<double> curvature(n, 0.);
  for(std::size_t i = 1; i + 1 < n; ++i)
  {
    const Spatial before = points[i].point - points[i - 1].point,
                  after = points[i + 1].point - points[i].point;
    if(cosine_between(before, after) > corner)
      curvature[i] = 2. * norm(cross(before, after)) /
                     std::max(norm(before) * norm(after) * norm(before + after), 1e-300);
  }
  if(n > 2)
  {
    curvature[0] = curvature[1];
    curvature[n - 1] = curvature[n - 2];
  }
  double sum = 0.;
  for(std::size_t i = 0; i + 1 < n; ++i)
  {
    const double chord = norm(points[i + 1].point - points[i].point);
    // Half of the angle of the arc.
    const double sine = 0.25 * (curvature[i] + curvature[i + 1]) * chord;
    sum +=
        sine > 1e-4 && sine < 1. ? chord * std::asin(sine) / sine : chord * (1. + sine * sine / 6.);
  }
  return sum;
}

namespace {

// What is known of a surface by squared distances: their gradient at p is twice the way from the foot
// to p.
class Distance_surface : public Path_surface
{
public:
  Distance_surface(const std::function<double(const Spatial&)>& squared_distance, double step)
      : m_squared_distance(squared_distance), m_step(step)
  {}

  Foot foot(const Spatial& point, Index near) const override
  {
    Foot foot;
    foot.site = near;
    Spatial half_gradient;
    for(int k = 0; k < 3; ++k)
    {
      Spatial ahead = point, behind = point;
      ahead[k] += m_step;
      behind[k] -= m_step;
      half_gradient[k] =
          (m_squared_distance(ahead) - m_squared_distance(behind)) / (2. * (ahead[k] - behind[k]));
      if(!std::isfinite(half_gradient[k]))
        throw Invalid_argument_error("A squared distance is not a finite number.");
    }
    foot.point = point - half_gradient;
    foot.normal = unit(half_gradient);
    return foot;
  }

private:
  const std::function<double(const Spatial&)>& m_squared_distance;
  double m_step;
};

} // namespace

Shortened_path shortened(const std::function<double(const Spatial&)>& squared_distance,
                         Path_options options, const std::vector<Spatial>& chain)
{
  if(chain.size() < 2)
    throw Invalid_argument_error("A polyline needs two points.");
  std::vector<Foot> feet(chain.size());
  double length = 0.;
  for(std::size_t i = 0; i < chain.size(); ++i)
  {
    feet[i].point = chain[i];
    if(i > 0)
      length += norm(chain[i] - chain[i - 1]);
    if(!std::isfinite(length) || !std::isfinite(norm(chain[i])))
      throw Invalid_argument_error("A point of the polyline is not finite.");
  }
  options.hold = Path_hold::energy;
  // A hundredth of a segment: what distances from a plane leave is rounding, and what curvature
  // leaves is as small as a hundredth of the sagitta.
  const Distance_surface surface(squared_distance,
                                 0.01 * length / double(options.control_points + 1));
  return shortened(surface, options, feet);
}

Shortened_path shortened(const Path_surface& surface, const Path_options& options,
                         const std::vector<Foot>& chain)
{
  Shortened_path result;
  const double length = polyline_length(chain);
  if(!(length > 0.))
  {
    result.points = {chain.front()};
    return result;
  }
  std::size_t most = options.control_points + 2;
  if(options.spacing > 0.)
    most = std::min<std::size_t>(most, std::size_t(std::min(length / options.spacing, 1e9)) + 9);
  // At each level half of the segments of the next one; the first follows the chain.
  std::size_t nodes = most;
  while(nodes > 16 && deviation(chain, (nodes + 1) / 2) < 0.1)
    nodes = (nodes + 1) / 2;
  std::vector<Foot> path = resampled(surface, chain, nodes);
  std::vector<double> share(nodes - 1, 1.);
  while(true)
  {
    Path_options level = options;
    if(nodes < most)
      level.tolerance = std::max(options.tolerance, rough);
    result.levels.push_back(minimize(surface, level, share, path));
    if(nodes >= most)
      break;
    path = subdivided(surface, path);
    nodes = std::min(2 * nodes - 1, most);
    path = resampled(surface, path, nodes);
    share.assign(nodes - 1, 1.);
  }
  for(int i = 0; i < refinements && refined(surface, share, path); ++i)
    result.levels.push_back(minimize(surface, options, share, path));
  result.control_points = path.size() - 2;
  if(options.hold == Path_hold::energy)
    for(std::size_t i = 1; i + 1 < path.size(); ++i)
      path[i] = surface.foot(path[i].point, path[i].site);
  draw_curve(surface, path, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
