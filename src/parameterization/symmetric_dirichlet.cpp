// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A triangle in its plane.
struct Rest_triangle
{
  double area = 0.;             // fraction of the total area
  std::array<Vec2, 3> gradient; // of the hat functions of the corners
};

// Minimum regularization of the energy. It is active if triangles are only slightly inverted.
constexpr double min_regularization = 1e-3;

// Minimum height of a triangle relative to its longest edge. Flatter triangles get this height.
constexpr double min_height_ratio = 1e-7;

std::vector<Rest_triangle> rest_triangles(const Surface_arrays& t)
{
  std::vector<Rest_triangle> result(t.number_of_triangles());
  double sum = 0.;
  for(Index f = 0; f < result.size(); ++f)
  {
    // Relative to the longest edge, only the height of a needle is small.
    const Index first_halfedge = 3 * f;
    Index longest = first_halfedge;
    for(Index h = first_halfedge + 1; h < first_halfedge + 3; ++h)
      if(t.length[h] > t.length[longest])
        longest = h;
    double base = t.length[longest];
    if(base <= 0.)
      base = 1e-12;
    Vec2 apex =
        third_corner(base, t.length[previous_halfedge(longest)], t.length[next_halfedge(longest)]);
    apex[1] = std::max(apex[1], min_height_ratio * base);
    apex[0] = std::clamp(apex[0], 0., base);
    const double double_area = base * apex[1];
    const std::array<Vec2, 3> gradient = {
        Vec2{-apex[1] / double_area, (apex[0] - base) / double_area},
        Vec2{apex[1] / double_area, -apex[0] / double_area}, Vec2{0., base / double_area}};
    for(Index k = 0, h = longest; k < 3; ++k, h = next_halfedge(h))
      result[f].gradient[h - first_halfedge] = gradient[k];
    result[f].area = 0.5 * double_area;
    sum += result[f].area;
  }
  for(Rest_triangle& rest : result)
    rest.area /= sum;
  return result;
}

// The signed singular value decomposition of a Jacobian: J = U diag(s) V^T with rotations U and V.
struct Jacobian_svd
{
  std::array<double, 2> s;
  Vec2 u, v; // the first columns
};

Jacobian_svd jacobian_svd(const Rest_triangle& rest, const std::array<Vec2, 3>& image)
{
  double a = 0., b = 0., c = 0., d = 0.;
  for(int k = 0; k < 3; ++k)
  {
    a += image[k][0] * rest.gradient[k][0];
    b += image[k][0] * rest.gradient[k][1];
    c += image[k][1] * rest.gradient[k][0];
    d += image[k][1] * rest.gradient[k][1];
  }
  const Vec2 rotation_part = {0.5 * (a + d), 0.5 * (c - b)},
             reflection_part = {0.5 * (a - d), 0.5 * (c + b)};
  const double p = std::hypot(rotation_part[0], rotation_part[1]),
               q = std::hypot(reflection_part[0], reflection_part[1]);
  const double sum = std::atan2(reflection_part[1], reflection_part[0]),
               difference = std::atan2(rotation_part[1], rotation_part[0]);
  const double alpha = 0.5 * (sum + difference), beta = 0.5 * (sum - difference);
  // The smaller singular value keeps its digits as the determinant divided by the larger one.
  const double determinant = a * d - b * c;
  return {{p + q, p + q > 0. ? determinant / (p + q) : 0.},
          {std::cos(alpha), std::sin(alpha)},
          {std::cos(beta), std::sin(beta)}};
}

// The energy |J|^2 (1 + 1/c^2) of a triangle, with the Frobenius norm of J and c = det J.  With
// regularization r, c = (d + sqrt(d^2 + r^2)) / 2 with d = det J: the energy is finite, and
// decreases if d increases, also for d < 0 (Garanzha et al. 2021).
struct Regularized_energy
{
  Regularized_energy(const Jacobian_svd& j, double regularization)
      : square(j.s[0] * j.s[0] + j.s[1] * j.s[1])
  {
    const double d = j.s[0] * j.s[1], root = std::hypot(d, regularization);
    // The second formula avoids cancellation for negative d.
    const double c = d > 0. ? 0.5 * (d + root) : 0.5 * regularization * regularization / (root - d);
    inverse = 1. / (c * c);
    // -1/2 times the first and second derivatives of 1/c^2.
    const double slope = c / root,
                 bend = 0.5 * regularization * regularization / (root * root * root);
    first = inverse / c * slope;
    second = inverse / c * (bend - 3. * slope * slope / c);
  }
  double value() const { return square * (1. + inverse); }

  double square, inverse, first, second;
};

// Returns the positive semidefinite part of the symmetric matrix with rows (a, b) and (b, c).
std::array<double, 3> project_to_psd(double a, double b, double c)
{
  const double mean = 0.5 * (a + c), half = 0.5 * (a - c), radius = std::hypot(half, b);
  if(mean - radius >= 0.)
    return {a, b, c};
  if(mean + radius <= 0.)
    return {0., 0., 0.};
  const double scale = 0.5 * (mean + radius) / radius;
  return {scale * (radius + half), scale * b, scale * (radius - half)};
}

// The derivatives of the energy of a triangle, with the eigenvalues of its projected Hessian.
struct Energy_derivatives
{
  Energy_derivatives(const Jacobian_svd& j, double regularization)
  {
    const Regularized_energy e(j, regularization);
    const double d = j.s[0] * j.s[1], q = e.square;
    std::array<double, 2> second;
    for(int i = 0; i < 2; ++i)
    {
      const double s = j.s[i], other = j.s[1 - i];
      first[i] = 2. * s * (1. + e.inverse) - 2. * q * other * e.first;
      second[i] = 2. * (1. + e.inverse) - 8. * d * e.first - 2. * q * other * other * e.second;
    }
    const double mixed_derivative = -6. * q * e.first - 2. * q * d * e.second;
    // The eigenvalue of the reflection is never negative.
    twist_eigenvalue = std::max(0., 2. * (1. + e.inverse) - 2. * q * e.first);
    flip_eigenvalue = 2. * (1. + e.inverse) + 2. * q * e.first;
    stretch_hessian = project_to_psd(second[0], mixed_derivative, second[1]);
  }

  std::array<double, 2> first;           // by the singular values
  std::array<double, 3> stretch_hessian; // by the singular values: rows (a, b) and (b, c)
  double twist_eigenvalue, flip_eigenvalue;
};

// Returns the eigenmodes in the coordinates of the corners: stretching along both singular
// directions, rotation (twist) and reflection (flip).
std::array<std::array<double, 6>, 4> eigenmodes(const Rest_triangle& rest, const Jacobian_svd& j)
{
  const Vec2 u = j.u, u2 = rotated_left(u), v = j.v, v2 = rotated_left(v);
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
  return mode;
}

class Symmetric_dirichlet
{
public:
  Symmetric_dirichlet(const Surface_arrays& t, const std::vector<bool>& is_fixed)
      : m_t(t), m_rest_triangles(rest_triangles(t)), m_is_fixed(is_fixed)
  {
    // The sparsity pattern of the lower triangle of the Hessian, with two unknowns per vertex.
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(21 * m_rest_triangles.size() + 2 * t.number_of_vertices());
    for(int i = 0; i < 2 * int(t.number_of_vertices()); ++i)
      entries.emplace_back(i, i, 0.);
    for(Index f = 0; f < m_rest_triangles.size(); ++f)
      for(int r = 0; r < 6; ++r)
        for(int c = 0; c < 6; ++c)
          if(unknown(f, r) >= unknown(f, c))
            entries.emplace_back(unknown(f, r), unknown(f, c), 0.);
    const auto n = 2 * Eigen::Index(t.number_of_vertices());
    m_hessian.resize(n, n);
    m_hessian.setFromTriplets(entries.begin(), entries.end());
    m_hessian.makeCompressed();
  }

  double energy(const std::vector<Vec2>& image) const
  {
    double result = 0.;
    for(Index f = 0; f < m_rest_triangles.size(); ++f)
    {
      const Jacobian_svd j = jacobian_svd(m_rest_triangles[f], corners(image, f));
      if(!is_regularized() && !(twice_area_of_image(m_t, image, f) > 0. && j.s[1] > 0.))
        return infinity;
      result += m_rest_triangles[f].area * Regularized_energy(j, m_regularization).value();
    }
    return result;
  }

  // Computes the projected Hessian and returns the gradient.
  Vector differentiate(const std::vector<Vec2>& image)
  {
    Vector gradient = Vector::Zero(m_hessian.rows());
    double* value = m_hessian.valuePtr();
    std::fill_n(value, m_hessian.nonZeros(), 0.);
    for(Index f = 0; f < m_rest_triangles.size(); ++f)
    {
      const Rest_triangle& rest = m_rest_triangles[f];
      const Jacobian_svd j = jacobian_svd(rest, corners(image, f));
      const Energy_derivatives e(j, m_regularization);
      const std::array<std::array<double, 6>, 4> mode = eigenmodes(rest, j);
      for(int r = 0; r < 6; ++r)
      {
        gradient[unknown(f, r)] += rest.area * (e.first[0] * mode[0][r] + e.first[1] * mode[1][r]);
        for(int c = 0; c < 6; ++c)
        {
          const int row = unknown(f, r), column = unknown(f, c);
          if(row < column)
            continue;
          const double sum =
              e.stretch_hessian[0] * mode[0][r] * mode[0][c] +
              e.stretch_hessian[2] * mode[1][r] * mode[1][c] +
              e.stretch_hessian[1] * (mode[0][r] * mode[1][c] + mode[1][r] * mode[0][c]) +
              0.5 * e.twist_eigenvalue * mode[2][r] * mode[2][c] +
              0.5 * e.flip_eigenvalue * mode[3][r] * mode[3][c];
          value[entry_index(row, column)] += rest.area * sum;
        }
      }
    }
    // Translations and rotations are in the null space of the Hessian.
    double trace = 0.;
    for(int i = 0; i < m_hessian.rows(); ++i)
      trace += value[entry_index(i, i)];
    const double ridge = 1e-9 * trace / double(m_hessian.rows());
    for(int i = 0; i < m_hessian.rows(); ++i)
      value[entry_index(i, i)] += ridge;
    if(!m_is_fixed.empty())
      fix_vertices(gradient);
    return gradient;
  }

  // If the regularization is zero, the energy of an inverted triangle is infinite.
  void set_regularization(double regularization) { m_regularization = regularization; }
  bool is_regularized() const { return m_regularization > 0.; }
  // Returns the minimum determinant of the Jacobians.
  double min_determinant(const std::vector<Vec2>& image) const
  {
    double result = infinity;
    for(Index f = 0; f < m_rest_triangles.size(); ++f)
    {
      const Jacobian_svd j = jacobian_svd(m_rest_triangles[f], corners(image, f));
      result = std::min(result, j.s[0] * j.s[1]);
    }
    return result;
  }

  const Sparse_matrix& hessian() const { return m_hessian; }

  // Returns the step size at which the first triangle loses its area. With regularization there is
  // no bound.
  double max_flip_free_step(const std::vector<Vec2>& image, const std::vector<Vec2>& step) const
  {
    double result = infinity;
    if(is_regularized())
      return result;
    for(Index f = 0; f < m_rest_triangles.size(); ++f)
    {
      const auto p = corners(image, f), s = corners(step, f);
      const Vec2 a = p[1] - p[0], b = p[2] - p[0], da = s[1] - s[0], db = s[2] - s[0];
      // The area is proportional to x + y t + z t^2.
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
  // Replaces the equations of fixed vertices by identities, so that their step is zero.
  void fix_vertices(Vector& gradient)
  {
    for(int column = 0; column < m_hessian.cols(); ++column)
      for(Sparse_matrix::InnerIterator entry(m_hessian, column); entry; ++entry)
        if(m_is_fixed[std::size_t(entry.row()) / 2] || m_is_fixed[std::size_t(column) / 2])
          entry.valueRef() = entry.row() == column ? 1. : 0.;
    for(int i = 0; i < gradient.size(); ++i)
      if(m_is_fixed[std::size_t(i) / 2])
        gradient[i] = 0.;
  }

  int unknown(Index f, int i) const { return int(2 * m_t.corner[3 * f + Index(i) / 2]) + i % 2; }
  std::array<Vec2, 3> corners(const std::vector<Vec2>& image, Index f) const
  {
    const Index* c = &m_t.corner[3 * std::size_t(f)];
    return {image[c[0]], image[c[1]], image[c[2]]};
  }
  std::size_t entry_index(int row, int column) const
  {
    const int* begin = m_hessian.innerIndexPtr() + m_hessian.outerIndexPtr()[column];
    const int* end = m_hessian.innerIndexPtr() + m_hessian.outerIndexPtr()[column + 1];
    return std::size_t(std::lower_bound(begin, end, row) - m_hessian.innerIndexPtr());
  }

  const Surface_arrays& m_t;
  std::vector<Rest_triangle> m_rest_triangles;
  const std::vector<bool>& m_is_fixed; // #vertices, or empty
  double m_regularization = 0.;
  Sparse_matrix m_hessian;
};

// Newton's method with line search, for an image that it changes.
class Newton_descent
{
public:
  Newton_descent(Symmetric_dirichlet& problem, std::vector<Vec2>& image)
      : m_problem(problem), m_image(image), m_step(image.size()), m_best(image.size()),
        m_trial(image.size())
  {}

  // Takes one step and returns the decrease of the energy, zero if none was found. The
  // regularization can change between steps.
  double step()
  {
    const double before = m_problem.energy(m_image);
    const Vector gradient = m_problem.differentiate(m_image);
    if(!(before < infinity) || !gradient.allFinite() || !factorize())
      return 0.;
    const Vector direction = m_solver->solve(-gradient);
    const double slope = gradient.dot(direction);
    if(!(slope < 0.))
      return 0.;
    for(std::size_t vertex = 0; vertex < m_image.size(); ++vertex)
      m_step[vertex] = {direction[2 * Eigen::Index(vertex)],
                        direction[2 * Eigen::Index(vertex) + 1]};
    // Backtracking to the first step that decreases the energy enough. The regularized energy is
    // strongly curved: shorter steps are tried as long as they decrease it more.
    double best_energy = before;
    double step_size = std::min(1., 0.9 * m_problem.max_flip_free_step(m_image, m_step));
    for(int attempt = 0; attempt < 60; ++attempt, step_size *= 0.5)
    {
      for(std::size_t vertex = 0; vertex < m_image.size(); ++vertex)
        m_trial[vertex] = m_image[vertex] + step_size * m_step[vertex];
      const double energy = m_problem.energy(m_trial);
      const bool is_found = best_energy < before;
      if(is_found ? energy < best_energy : energy <= before + 1e-4 * step_size * slope)
      {
        best_energy = energy;
        m_best.swap(m_trial);
        if(!m_problem.is_regularized())
          break;
      }
      else if(is_found)
        break;
    }
    if(best_energy < before)
      m_image.swap(m_best);
    return before - best_energy;
  }

private:
  // Returns false if the matrix is indefinite due to round-off errors.
  bool factorize()
  {
    if(m_solver)
      return m_solver->factorize(m_problem.hessian());
    try
    {
      m_solver = std::make_unique<Sparse_solver>(m_problem.hessian(), Elimination_order::low_fill);
    }
    catch(const Unsupported_surface_error&)
    {}
    return m_solver != nullptr;
  }

  Symmetric_dirichlet& m_problem;
  std::vector<Vec2>&m_image, m_step, m_best, m_trial;
  std::unique_ptr<Sparse_solver> m_solver;
};

} // namespace

double scale_to_area(const Surface_arrays& t, const std::vector<Vec2>& image)
{
  double area = 0., area_of_image = 0.; // twice the areas
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    area += twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]);
    area_of_image += twice_area_of_image(t, image, f);
  }
  const double result = std::sqrt(area / area_of_image);
  return result > 0. && result < infinity ? result : 0.;
}

std::size_t number_of_flips(const Surface_arrays& t, const std::vector<Vec2>& image)
{
  std::size_t result = 0;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    result += !(twice_area_of_image(t, image, f) > 0.);
  return result;
}

Minimization_result minimize_symmetric_dirichlet(const Surface_arrays& t, std::vector<Vec2>& image,
                                                 std::size_t max_steps,
                                                 const std::function<bool(double)>& callback,
                                                 double energy_tolerance,
                                                 const std::vector<bool>& is_fixed)
{
  Symmetric_dirichlet problem(t, is_fixed);
  Newton_descent descent(problem, image);
  Minimization_result result;
  result.energy = problem.energy(image);
  for(; result.number_of_iterations < max_steps; ++result.number_of_iterations)
  {
    if(callback && !callback(double(result.number_of_iterations) / double(max_steps)))
    {
      result.is_complete = false;
      break;
    }
    const double decrease = descent.step();
    if(decrease == 0.)
      break;
    result.energy -= decrease;
    if(decrease < energy_tolerance * result.energy)
    {
      ++result.number_of_iterations;
      break;
    }
  }
  return result;
}

bool unflip(const Surface_arrays& t, std::vector<Vec2>& image, std::size_t max_steps,
            const std::vector<bool>& is_fixed)
{
  Symmetric_dirichlet problem(t, is_fixed);
  Newton_descent descent(problem, image);
  std::size_t flips = number_of_flips(t, image);
  for(std::size_t step = 0; flips > 0 && step < max_steps; ++step)
  {
    // The regularization is the size of the most negative determinant.
    problem.set_regularization(
        std::max(min_regularization, std::abs(problem.min_determinant(image))));
    if(descent.step() == 0.)
      break;
    flips = number_of_flips(t, image);
  }
  return flips == 0;
}

} // namespace CGAL::Geodesic_processing::internal
