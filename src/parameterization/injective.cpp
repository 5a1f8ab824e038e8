// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/injective.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The side after a side along its border: turned around the corner where it ends.
Index next_on_border(const Glued_triangles& t, Index side)
{
  for(side = next_side(side); t.twin[side] != none;)
    side = next_side(t.twin[side]);
  return side;
}

// A triangle in its own plane.
struct Rest
{
  double area = 0.;               // as a part of all
  std::array<Planar, 3> gradient; // of the function that is one at a corner and zero at the others
};

// What makes the energy finite where triangles are turned round but little.
constexpr double least_softness = 1e-3;

// No triangle is flatter than this: height over longest side.
constexpr double least_height = 1e-7;

std::vector<Rest> rest_shapes(const Glued_triangles& t)
{
  std::vector<Rest> result(t.number_of_triangles());
  double sum = 0.;
  for(Index f = 0; f < result.size(); ++f)
  {
    // The longest side first, so that a height is what a needle lacks.
    const Index first = 3 * f;
    Index longest = first;
    for(Index side = first + 1; side < first + 3; ++side)
      if(t.length[side] > t.length[longest])
        longest = side;
    double base = t.length[longest];
    if(base <= 0.)
      base = 1e-12;
    Planar top = third_corner(base, t.length[previous_side(longest)], t.length[next_side(longest)]);
    top[1] = std::max(top[1], least_height * base);
    top[0] = std::clamp(top[0], 0., base);
    const double twice = base * top[1];
    const std::array<Planar, 3> gradient = {Planar{-top[1] / twice, (top[0] - base) / twice},
                                            Planar{top[1] / twice, -top[0] / twice},
                                            Planar{0., base / twice}};
    for(Index k = 0, side = longest; k < 3; ++k, side = next_side(side))
      result[f].gradient[side - first] = gradient[k];
    result[f].area = 0.5 * twice;
    sum += result[f].area;
  }
  for(Rest& rest : result)
    rest.area /= sum;
  return result;
}

// The Jacobian of a map on a triangle and its parts: J = U diag(s) V^T, U and V rotations.
struct Stretch
{
  std::array<double, 2> s;
  Planar u, v; // the first columns
};

Stretch stretch(const Rest& rest, const std::array<Planar, 3>& image)
{
  double a = 0., b = 0., c = 0., d = 0.;
  for(int k = 0; k < 3; ++k)
  {
    a += image[k][0] * rest.gradient[k][0];
    b += image[k][0] * rest.gradient[k][1];
    c += image[k][1] * rest.gradient[k][0];
    d += image[k][1] * rest.gradient[k][1];
  }
  const Planar turning = {0.5 * (a + d), 0.5 * (c - b)}, mirroring = {0.5 * (a - d), 0.5 * (c + b)};
  const double p = std::hypot(turning[0], turning[1]), q = std::hypot(mirroring[0], mirroring[1]);
  const double sum = std::atan2(mirroring[1], mirroring[0]),
               difference = std::atan2(turning[1], turning[0]);
  const double alpha = 0.5 * (sum + difference), beta = 0.5 * (sum - difference);
  // The determinant over the larger one keeps the digits of the smaller one.
  const double determinant = a * d - b * c;
  return {{p + q, p + q > 0. ? determinant / (p + q) : 0.},
          {std::cos(alpha), std::sin(alpha)},
          {std::cos(beta), std::sin(beta)}};
}

// The square of the Frobenius norm of J, q, times 1 + 1/c^2, where c is the determinant d; or, to be finite and to
// fall where that is negative, too, c = (d + sqrt(d^2 + softness^2)) / 2 (Garanzha and others 2021).
struct Energy
{
  Energy(const Stretch& j, double softness) : square(j.s[0] * j.s[0] + j.s[1] * j.s[1])
  {
    const double d = j.s[0] * j.s[1], root = std::hypot(d, softness);
    // Without loss of digits where d is negative.
    const double c = d > 0. ? 0.5 * (d + root) : 0.5 * softness * softness / (root - d);
    inverse = 1. / (c * c);
    // -1/2 of the derivatives of 1/c^2.
    const double slope = c / root, bend = 0.5 * softness * softness / (root * root * root);
    first = inverse / c * slope;
    second = inverse / c * (bend - 3. * slope * slope / c);
  }
  double value() const { return square * (1. + inverse); }

  double square, inverse, first, second;
};

// The part of a symmetric matrix of two rows, a, b, c, whose eigenvalues are not negative.
std::array<double, 3> definite(double a, double b, double c)
{
  const double mean = 0.5 * (a + c), half = 0.5 * (a - c), radius = std::hypot(half, b);
  if(mean - radius >= 0.)
    return {a, b, c};
  if(mean + radius <= 0.)
    return {0., 0., 0.};
  const double share = 0.5 * (mean + radius) / radius;
  return {share * (radius + half), share * b, share * (radius - half)};
}

class Symmetric_dirichlet
{
public:
  Symmetric_dirichlet(const Glued_triangles& t, const std::vector<bool>& is_held)
      : m_t(t), m_rest(rest_shapes(t)), m_is_held(is_held)
  {
    // The lower triangle of the Hessian; two unknowns a site.
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(21 * m_rest.size() + 2 * t.number_of_sites());
    for(int i = 0; i < 2 * int(t.number_of_sites()); ++i)
      entries.emplace_back(i, i, 0.);
    for(Index f = 0; f < m_rest.size(); ++f)
      for(int r = 0; r < 6; ++r)
        for(int c = 0; c < 6; ++c)
          if(unknown(f, r) >= unknown(f, c))
            entries.emplace_back(unknown(f, r), unknown(f, c), 0.);
    const auto n = 2 * Eigen::Index(t.number_of_sites());
    m_hessian.resize(n, n);
    m_hessian.setFromTriplets(entries.begin(), entries.end());
    m_hessian.makeCompressed();
  }

  double energy(const std::vector<Planar>& image) const
  {
    double result = 0.;
    for(Index f = 0; f < m_rest.size(); ++f)
    {
      const Stretch j = stretch(m_rest[f], corners(image, f));
      if(!is_soft() && !(twice_area_of_image(m_t, image, f) > 0. && j.s[1] > 0.))
        return infinity;
      result += m_rest[f].area * Energy(j, m_softness).value();
    }
    return result;
  }

  // Sets the Hessian, made definite, and returns the gradient.
  Vector differentiate(const std::vector<Planar>& image)
  {
    Vector gradient = Vector::Zero(m_hessian.rows());
    double* value = m_hessian.valuePtr();
    std::fill_n(value, m_hessian.nonZeros(), 0.);
    for(Index f = 0; f < m_rest.size(); ++f)
    {
      const Rest& rest = m_rest[f];
      const Stretch j = stretch(rest, corners(image, f));
      const Energy e(j, m_softness);
      const double d = j.s[0] * j.s[1], q = e.square;
      std::array<double, 2> first, second;
      for(int i = 0; i < 2; ++i)
      {
        const double s = j.s[i], other = j.s[1 - i];
        first[i] = 2. * s * (1. + e.inverse) - 2. * q * other * e.first;
        second[i] = 2. * (1. + e.inverse) - 8. * d * e.first - 2. * q * other * other * e.second;
      }
      const double mixed = -6. * q * e.first - 2. * q * d * e.second;
      // Modes: stretch along either axis, turn, and the one that mirrors, whose factor is never negative.
      const double turn = std::max(0., 2. * (1. + e.inverse) - 2. * q * e.first);
      const double mirror = 2. * (1. + e.inverse) + 2. * q * e.first;
      const std::array<double, 3> stretching = definite(second[0], mixed, second[1]);
      const Planar u = j.u, u2 = turned_left(u), v = j.v, v2 = turned_left(v);
      std::array<std::array<double, 6>, 4> mode;
      for(int k = 0; k < 3; ++k)
      {
        const double g = dot(rest.gradient[k], v), g2 = dot(rest.gradient[k], v2);
        for(int axis = 0; axis < 2; ++axis)
        {
          mode[0][2 * k + axis] = g * u[axis];
          mode[1][2 * k + axis] = g2 * u2[axis];
          mode[2][2 * k + axis] = g * u2[axis] - g2 * u[axis];
          mode[3][2 * k + axis] = g * u2[axis] + g2 * u[axis];
        }
      }
      for(int r = 0; r < 6; ++r)
      {
        gradient[unknown(f, r)] += rest.area * (first[0] * mode[0][r] + first[1] * mode[1][r]);
        for(int c = 0; c < 6; ++c)
        {
          const int row = unknown(f, r), column = unknown(f, c);
          if(row < column)
            continue;
          const double sum =
              stretching[0] * mode[0][r] * mode[0][c] + stretching[2] * mode[1][r] * mode[1][c] +
              stretching[1] * (mode[0][r] * mode[1][c] + mode[1][r] * mode[0][c]) +
              0.5 * turn * mode[2][r] * mode[2][c] + 0.5 * mirror * mode[3][r] * mode[3][c];
          value[place(row, column)] += rest.area * sum;
        }
      }
    }
    // Nothing holds the map in its place, nor turns it.
    double trace = 0.;
    for(int i = 0; i < m_hessian.rows(); ++i)
      trace += value[place(i, i)];
    const double ridge = 1e-9 * trace / double(m_hessian.rows());
    for(int i = 0; i < m_hessian.rows(); ++i)
      value[place(i, i)] += ridge;
    if(!m_is_held.empty())
      hold(gradient);
    return gradient;
  }

  // The energy is infinite where a triangle is flipped, unless this is positive.
  void set_softness(double softness) { m_softness = softness; }
  bool is_soft() const { return m_softness > 0.; }
  // Of a Jacobian.
  double least_determinant(const std::vector<Planar>& image) const
  {
    double result = infinity;
    for(Index f = 0; f < m_rest.size(); ++f)
    {
      const Stretch j = stretch(m_rest[f], corners(image, f));
      result = std::min(result, j.s[0] * j.s[1]);
    }
    return result;
  }

  const Sparse_matrix& hessian() const { return m_hessian; }

  // How far a map may move until the first triangle has no area, where that matters.
  double way_to_flip(const std::vector<Planar>& image, const std::vector<Planar>& step) const
  {
    double result = infinity;
    if(is_soft())
      return result;
    for(Index f = 0; f < m_rest.size(); ++f)
    {
      const auto p = corners(image, f), s = corners(step, f);
      const Planar a = p[1] - p[0], b = p[2] - p[0], da = s[1] - s[0], db = s[2] - s[0];
      // x + y t + z t^2 = 0
      const double x = cross(a, b), y = cross(a, db) + cross(da, b), z = cross(da, db);
      const double discriminant = y * y - 4. * x * z;
      if(discriminant < 0.)
        continue;
      const double q = -0.5 * (y + std::copysign(std::sqrt(discriminant), y));
      for(const double root : {z != 0. ? q / z : infinity, q != 0. ? x / q : infinity})
        if(root > 0.)
          result = std::min(result, root);
    }
    return result;
  }

private:
  // Steps of what is held are zero, whatever the others are.
  void hold(Vector& gradient)
  {
    for(int column = 0; column < m_hessian.cols(); ++column)
      for(Sparse_matrix::InnerIterator entry(m_hessian, column); entry; ++entry)
        if(m_is_held[std::size_t(entry.row()) / 2] || m_is_held[std::size_t(column) / 2])
          entry.valueRef() = entry.row() == column ? 1. : 0.;
    for(int i = 0; i < gradient.size(); ++i)
      if(m_is_held[std::size_t(i) / 2])
        gradient[i] = 0.;
  }

  int unknown(Index f, int i) const { return int(2 * m_t.corner[3 * f + Index(i) / 2]) + i % 2; }
  std::array<Planar, 3> corners(const std::vector<Planar>& image, Index f) const
  {
    const Index* c = &m_t.corner[3 * std::size_t(f)];
    return {image[c[0]], image[c[1]], image[c[2]]};
  }
  std::size_t place(int row, int column) const
  {
    const int* begin = m_hessian.innerIndexPtr() + m_hessian.outerIndexPtr()[column];
    const int* end = m_hessian.innerIndexPtr() + m_hessian.outerIndexPtr()[column + 1];
    return std::size_t(std::lower_bound(begin, end, row) - m_hessian.innerIndexPtr());
  }

  const Glued_triangles& m_t;
  std::vector<Rest> m_rest;
  const std::vector<bool>& m_is_held; // #sites, or none
  double m_softness = 0.;
  Sparse_matrix m_hessian;
};

// Newton's method from an image that it moves.
class Descent
{
public:
  Descent(Symmetric_dirichlet& problem, std::vector<Planar>& image)
      : m_problem(problem), m_image(image), m_step(image.size()), m_moved(image.size()),
        m_tried(image.size())
  {}

  // What a step takes off the energy, whatever that has been made since the last one; zero at the end.
  double step()
  {
    const double before = m_problem.energy(m_image);
    const Vector gradient = m_problem.differentiate(m_image);
    if(!(before < infinity) || !gradient.allFinite() || !factorize())
      return 0.;
    const Vector way = m_solver->solve(-gradient);
    const double slope = gradient.dot(way);
    if(!(slope < 0.))
      return 0.;
    for(std::size_t site = 0; site < m_image.size(); ++site)
      m_step[site] = {way[2 * Eigen::Index(site)], way[2 * Eigen::Index(site) + 1]};
    // The first share that lowers it enough; of a softened energy, which bends much, a shorter one that lowers it
    // more.
    double least = before;
    double share = std::min(1., 0.9 * m_problem.way_to_flip(m_image, m_step));
    for(int attempt = 0; attempt < 60; ++attempt, share *= 0.5)
    {
      for(std::size_t site = 0; site < m_image.size(); ++site)
        m_tried[site] = m_image[site] + share * m_step[site];
      const double energy = m_problem.energy(m_tried);
      const bool is_found = least < before;
      if(is_found ? energy < least : energy <= before + 1e-4 * share * slope)
      {
        least = energy;
        m_moved.swap(m_tried);
        if(!m_problem.is_soft())
          break;
      }
      else if(is_found)
        break;
    }
    if(least < before)
      m_image.swap(m_moved);
    return before - least;
  }

private:
  // False when rounding has left the matrix indefinite.
  bool factorize()
  {
    if(m_solver)
      return m_solver->factorize(m_problem.hessian());
    try
    {
      m_solver = std::make_unique<Sparse_solver>(m_problem.hessian(), Elimination::sparse);
    }
    catch(const Unsupported_surface_error&)
    {}
    return m_solver != nullptr;
  }

  Symmetric_dirichlet& m_problem;
  std::vector<Planar>&m_image, m_step, m_moved, m_tried;
  std::unique_ptr<Sparse_solver> m_solver;
};

} // namespace

double scale_to_area(const Glued_triangles& t, const std::vector<Planar>& image)
{
  double area = 0., area_of_image = 0.; // twice
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    area += twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]);
    area_of_image += twice_area_of_image(t, image, f);
  }
  const double result = std::sqrt(area / area_of_image);
  return result > 0. && result < infinity ? result : 0.;
}

std::size_t number_of_flips(const Glued_triangles& t, const std::vector<Planar>& image)
{
  std::size_t result = 0;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    result += !(twice_area_of_image(t, image, f) > 0.);
  return result;
}

std::vector<std::vector<Index>> borders(const Glued_triangles& t)
{
  std::vector<std::vector<Index>> result;
  std::vector<bool> is_seen(t.corner.size(), false);
  std::vector<double> length;
  for(Index start = 0; start < t.corner.size(); ++start)
  {
    if(t.twin[start] != none || is_seen[start])
      continue;
    result.emplace_back();
    length.push_back(0.);
    for(Index side = start; !is_seen[side]; side = next_on_border(t, side))
    {
      is_seen[side] = true;
      result.back().push_back(side);
      length.back() += t.length[side];
    }
  }
  if(!result.empty())
    std::swap(result.front(),
              result[std::size_t(std::max_element(length.begin(), length.end()) - length.begin())]);
  return result;
}

void check_is_disk(const Glued_triangles& t)
{
  std::size_t sites = 0, sides = 0;
  for(Index site = 0; site < t.number_of_sites(); ++site)
    sites += t.first[site] < t.first[site + 1];
  for(Index side = 0; side < t.twin.size(); ++side)
    sides += t.twin[side] == none || side < t.twin[side];
  // One component: a walk across the sides reaches all triangles.
  std::vector<bool> is_reached(t.number_of_triangles(), false);
  std::vector<Index> stack;
  std::size_t reached = 0;
  if(!is_reached.empty())
  {
    stack.push_back(0);
    is_reached[0] = true;
  }
  while(!stack.empty())
  {
    const Index f = stack.back();
    stack.pop_back();
    ++reached;
    for(Index side = 3 * f; side < 3 * f + 3; ++side)
      if(t.twin[side] != none && !is_reached[t.twin[side] / 3])
      {
        is_reached[t.twin[side] / 3] = true;
        stack.push_back(t.twin[side] / 3);
      }
  }
  if(reached == 0 || reached < t.number_of_triangles())
    throw Unsupported_surface_error("The surface is not one piece.");
  const std::size_t loops = borders(t).size();
  if(loops == 0)
    throw Unsupported_surface_error(
        "The surface has no border, and must be cut before it is flat.");
  if(sites + t.number_of_triangles() + loops != sides + 2)
    throw Unsupported_surface_error(
        "The surface has handles, or touches itself at a vertex, and must "
        "be cut before it is flat.");
}

std::vector<Planar> tutte_map(const Glued_triangles& t)
{
  const auto loops = borders(t);
  std::vector<Planar> image(t.number_of_sites(), Planar{0., 0.});
  std::vector<bool> is_held(t.number_of_sites(), false);
  double length = 0., so_far = 0.;
  for(const Index side : loops.front())
    length += t.length[side];
  // A border of no length is divided evenly.
  for(std::size_t i = 0; i < loops.front().size(); ++i)
  {
    const Index side = loops.front()[i];
    const double even = double(i) / double(loops.front().size());
    const double angle = 2. * pi * (length > 0. ? 0.99 * so_far / length + 0.01 * even : even);
    so_far += t.length[side];
    image[t.corner[side]] = {std::cos(angle), std::sin(angle)};
    is_held[t.corner[side]] = true;
  }

  std::vector<int> unknown(t.number_of_sites(), -1);
  int number = 0;
  for(Index site = 0; site < t.number_of_sites(); ++site)
    if(!is_held[site] && t.first[site] < t.first[site + 1])
      unknown[site] = number++;
  std::vector<Eigen::Triplet<double>> entries;
  const int holes = int(loops.size()) - 1;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(number + holes, 2);
  const auto join = [&](int i, const Planar& p, int j)
  {
    entries.emplace_back(i, i, 1.);
    if(j < 0)
      right.row(i) += Eigen::RowVector2d(p[0], p[1]);
    else if(j < i)
      entries.emplace_back(i, j, -1.);
  };
  const auto join_sites = [&](Index a, Index b)
  {
    if(unknown[a] >= 0)
      join(unknown[a], image[b], unknown[b]);
    if(unknown[b] >= 0)
      join(unknown[b], image[a], unknown[a]);
  };
  for(Index side = 0; side < t.corner.size(); ++side)
    if(t.twin[side] == none || side < t.twin[side])
      join_sites(t.corner[side], t.corner[next_side(side)]);
  for(int hole = 0; hole < holes; ++hole)
    for(const Index side : loops[std::size_t(hole) + 1])
    {
      const Index site = t.corner[side];
      join(number + hole, image[site], unknown[site]);
      if(unknown[site] >= 0)
        join(unknown[site], {}, number + hole);
    }
  if(number + holes > 0)
  {
    Sparse_matrix matrix(number + holes, number + holes);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Sparse_solver(matrix).solve_columns(right);
  }
  for(Index site = 0; site < t.number_of_sites(); ++site)
    if(unknown[site] >= 0)
      image[site] = {right(unknown[site], 0), right(unknown[site], 1)};
  if(const double scale = scale_to_area(t, image); scale > 0.)
    for(Planar& p : image)
      p = scale * p;
  return image;
}

Flattest minimize_symmetric_dirichlet(const Glued_triangles& t, std::vector<Planar>& image,
                                      std::size_t most_steps,
                                      const std::function<bool(double)>& callback,
                                      double least_progress, const std::vector<bool>& is_held)
{
  Symmetric_dirichlet problem(t, is_held);
  Descent descent(problem, image);
  Flattest result;
  result.energy = problem.energy(image);
  for(; result.steps < most_steps; ++result.steps)
  {
    if(callback && !callback(double(result.steps) / double(most_steps)))
    {
      result.is_complete = false;
      break;
    }
    const double progress = descent.step();
    if(progress == 0.)
      break;
    result.energy -= progress;
    if(progress < least_progress * result.energy)
    {
      ++result.steps;
      break;
    }
  }
  return result;
}

bool turn_back(const Glued_triangles& t, std::vector<Planar>& image, std::size_t most_steps,
               const std::vector<bool>& is_held)
{
  Symmetric_dirichlet problem(t, is_held);
  Descent descent(problem, image);
  std::size_t flips = number_of_flips(t, image);
  for(std::size_t step = 0; flips > 0 && step < most_steps; ++step)
  {
    // As soft as what is turned round the most asks for.
    problem.set_softness(std::max(least_softness, std::abs(problem.least_determinant(image))));
    if(descent.step() == 0.)
      break;
    flips = number_of_flips(t, image);
  }
  return flips == 0;
}

} // namespace CGAL::Geodesic_processing::internal
