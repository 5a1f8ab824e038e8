// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Matrix = Eigen::MatrixXd;
using Row = Eigen::RowVector2d;

// What is added to a Gram matrix, as a part of its trace: far above rounding, and so little that a plane is
// reproduced to a millionth.
constexpr double regularization = 1e-9;

// Steps of the rigid fit: on scans its energy falls by less than a hundredth in the last one.
constexpr std::size_t rigid_steps = 30;

// The neighbours of a base point, and where they are in a plane about it that keeps distances as well as it
// can: the first two eigenvectors of their Gram matrix.
struct Chart
{
  std::vector<Index> point;
  std::vector<double> square; // of distances
  std::vector<Planar> place;
};

std::vector<Chart> charts(const Base_points& base, std::size_t neighbors)
{
  std::vector<Chart> result(base.size());
  for(Index i = 0; i < base.size(); ++i)
  {
    Chart& chart = result[i];
    const std::size_t begin = base.nearest * base.sites[i];
    for(std::size_t k = begin; k < begin + std::min(base.nearest, neighbors + 1); ++k)
      if(base.point[k] != none && base.point[k] != i)
      {
        const double distance = base.distance_between(i, base.point[k]);
        chart.point.push_back(base.point[k]);
        chart.square.push_back(distance * distance);
      }
    const auto number = Eigen::Index(chart.point.size());
    Matrix gram(number, number);
    for(Eigen::Index j = 0; j < number; ++j)
      for(Eigen::Index k = 0; k < number; ++k)
      {
        const double between = std::min(base.distance_between(chart.point[j], chart.point[k]),
                                        std::sqrt(chart.square[j]) + std::sqrt(chart.square[k]));
        gram(j, k) = 0.5 * (chart.square[j] + chart.square[k] - between * between);
      }
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(gram);
    chart.place.assign(chart.point.size(), Planar{0., 0.});
    for(Eigen::Index c = number - 1; c >= 0 && c >= number - 2; --c)
      for(Eigen::Index j = 0; j < number; ++j)
        chart.place[j][number - 1 - c] =
            std::sqrt(std::max(0., eigen.eigenvalues()[c])) * eigen.eigenvectors()(j, c);
  }
  return result;
}

// Whether points are joined by whatever is a neighbour of what.
bool is_connected(const std::vector<Chart>& charts)
{
  boost::disjoint_sets_with_storage<> groups(charts.size());
  std::size_t number = charts.size();
  for(Index i = 0; i < charts.size(); ++i)
    for(const Index point : charts[i].point)
      if(groups.find_set(i) != groups.find_set(point))
      {
        groups.link(groups.find_set(i), groups.find_set(point));
        --number;
      }
  return number == 1;
}

// Where a point is in the chart of another one; that of its own is the origin.
const Planar* place_in(const Chart& chart, Index own, Index point)
{
  static constexpr Planar origin = {0., 0.};
  if(point == own)
    return &origin;
  const auto found = std::find(chart.point.begin(), chart.point.end(), point);
  return found == chart.point.end() ? nullptr : &chart.place[found - chart.point.begin()];
}

// Turns charts over such that they agree about the points they have in common, those first that agree best.
void orient(std::vector<Chart>& charts)
{
  struct Link
  {
    double trust; // negative: mirrored
    Index from, to;
    bool operator<(const Link& other) const
    {
      return std::abs(trust) < std::abs(other.trust) ||
             (std::abs(trust) == std::abs(other.trust) && to > other.to);
    }
  };
  const auto agreement = [&](Index i, Index j)
  {
    std::vector<std::pair<Planar, Planar>> common;
    const auto take = [&](Index point)
    {
      const Planar *p = place_in(charts[i], i, point), *q = place_in(charts[j], j, point);
      if(p && q)
        common.emplace_back(*p, *q);
    };
    take(i);
    for(const Index point : charts[i].point)
      take(point);
    Planar p = {0., 0.}, q = {0., 0.};
    for(const auto& [a, b] : common)
    {
      p = p + (1. / double(common.size())) * a;
      q = q + (1. / double(common.size())) * b;
    }
    Eigen::Matrix2d product = Eigen::Matrix2d::Zero();
    for(const auto& [a, b] : common)
      product += Eigen::Vector2d(a[0] - p[0], a[1] - p[1]) * Row(b[0] - q[0], b[1] - q[1]);
    const double size = product.squaredNorm();
    return size > 0. ? product.determinant() / size : 0.;
  };
  std::vector<bool> is_done(charts.size(), false);
  for(Index start = 0; start < charts.size(); ++start)
  {
    if(is_done[start])
      continue;
    std::priority_queue<Link> queue;
    for(queue.push({1., none, start}); !queue.empty();)
    {
      const Link link = queue.top();
      queue.pop();
      if(is_done[link.to])
        continue;
      is_done[link.to] = true;
      if(link.from != none && agreement(link.from, link.to) < 0.)
        for(Planar& p : charts[link.to].place)
          p[1] = -p[1];
      for(const Index next : charts[link.to].point)
        if(!is_done[next])
          queue.push({agreement(link.to, next), link.to, next});
    }
  }
}

// The weights of points about the origin that sum to one and whose mean is there, as small as can be in
// the sum of their squares over `inverse`: where the places are those of a Gram matrix of rank two, these
// are the weights of its inverse with a little on its diagonal.
std::vector<double> weights(const std::vector<Planar>& place, const std::vector<double>& inverse,
                            double regularization)
{
  double a = 0., b = 0., c = 0., u = 0., v = 0.;
  for(std::size_t j = 0; j < place.size(); ++j)
  {
    a += inverse[j] * place[j][0] * place[j][0];
    b += inverse[j] * place[j][0] * place[j][1];
    c += inverse[j] * place[j][1] * place[j][1];
    u += inverse[j] * place[j][0];
    v += inverse[j] * place[j][1];
  }
  const double ridge = regularization * (a + c);
  a += ridge;
  c += ridge;
  const double determinant = a * c - b * b;
  Planar slope = {0., 0.};
  if(determinant > 0.)
    slope = {(c * u - b * v) / determinant, (a * v - b * u) / determinant};
  std::vector<double> result(place.size());
  double sum = 0.;
  for(std::size_t j = 0; j < place.size(); ++j)
    sum += result[j] = inverse[j] * (1. - dot(slope, place[j]));
  for(double& w : result)
    w /= sum;
  return result;
}

// Of the matrix (I - W)^T (I - W), whose rows reproduce each point from its neighbours, the two lowest
// eigenvectors above the constant one (Roweis and Saul 2000).
Matrix spectral(const std::vector<Chart>& charts)
{
  const auto n = Eigen::Index(charts.size());
  Matrix residual = Matrix::Identity(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    std::vector<double> inverse;
    for(const double square : charts[i].square)
      inverse.push_back(1. / square);
    const auto w = weights(charts[i].place, inverse, regularization);
    for(std::size_t j = 0; j < w.size(); ++j)
      residual(i, charts[i].point[j]) -= w[j];
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(Matrix(residual.transpose() * residual));
  // The constant is one of the three lowest ones, in whatever basis of theirs.
  Matrix low = eigen.eigenvectors().leftCols(3);
  low.rowwise() -= low.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Matrix> inner(Matrix(low.transpose() * low));
  return low * inner.eigenvectors().rightCols(2);
}

// The linear map after which squared distances between neighbours are the surface's, by least squares.
Matrix metric_fit(const std::vector<Chart>& charts, const Matrix& f)
{
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for(std::size_t i = 0; i < charts.size(); ++i)
    for(std::size_t j = 0; j < charts[i].point.size(); ++j)
    {
      const Row e = f.row(charts[i].point[j]) - f.row(Eigen::Index(i));
      const Eigen::Vector3d row =
          Eigen::Vector3d(e[0] * e[0], 2. * e[0] * e[1], e[1] * e[1]) / charts[i].square[j];
      normal += row * row.transpose();
      right += row;
    }
  const Eigen::Vector3d s = normal.ldlt().solve(right);
  Eigen::Matrix2d metric;
  metric << s[0], s[1], s[1], s[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> split(metric);
  Eigen::Vector2d root;
  for(int k = 0; k < 2; ++k)
    root[k] = std::sqrt(std::max(split.eigenvalues()[k], 1e-6 * split.eigenvalues()[1]));
  return f * (split.eigenvectors() * root.asDiagonal() * split.eigenvectors().transpose());
}

// Classical scaling of the distances along chains of base points (Tenenbaum, de Silva and Langford 2000).
Matrix scaled_by_chains(const Base_points& base)
{
  const auto n = Eigen::Index(base.size());
  Matrix square = Matrix::Zero(n, n);
  for(Eigen::Index start = 0; start < n; ++start)
  {
    std::vector<double> length(std::size_t(n), infinity);
    std::vector<bool> is_done(std::size_t(n), false);
    length[start] = 0.;
    for(;;)
    {
      Eigen::Index at = -1;
      for(Eigen::Index k = 0; k < n; ++k)
        if(!is_done[k] && length[k] < infinity && (at < 0 || length[k] < length[at]))
          at = k;
      if(at < 0)
        break;
      is_done[at] = true;
      for(Eigen::Index k = 0; k < n; ++k)
        length[k] = std::min(length[k], length[at] + base.distance_between(at, k));
    }
    for(Eigen::Index k = 0; k < n; ++k)
      square(start, k) = length[k] * length[k];
  }
  return classical_scaling(square);
}

// Places of base points for which each one's neighbours are a turned copy of its chart, by least squares
// relative to their distances: turns and places are found by turns (Sorkine and Alexa 2007).  Nothing is
// mirrored, so that folds cost.
class Rigid
{
public:
  explicit Rigid(const std::vector<Chart>& charts) : m_charts(charts)
  {
    const auto n = Eigen::Index(charts.size());
    Matrix laplacian = Matrix::Zero(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
      for(std::size_t j = 0; j < charts[i].point.size(); ++j)
      {
        const double w = 1. / charts[i].square[j];
        const auto k = Eigen::Index(charts[i].point[j]);
        laplacian(i, i) += w;
        laplacian(k, k) += w;
        laplacian(i, k) -= w;
        laplacian(k, i) -= w;
      }
    laplacian(0, 0) *= 2.;
    m_solver.compute(laplacian);
  }

  // From a first guess; and what is left of the sum of squares.
  Matrix fit(Matrix f, double& energy) const
  {
    std::size_t mirrored = 0;
    for(std::size_t i = 0; i < m_charts.size(); ++i)
      mirrored += product(i, f).determinant() < 0.;
    if(2 * mirrored > m_charts.size())
      f.col(1) = -f.col(1);
    for(std::size_t step = 0; step <= rigid_steps; ++step)
    {
      Matrix right = Matrix::Zero(f.rows(), 2);
      energy = 0.;
      for(std::size_t i = 0; i < m_charts.size(); ++i)
      {
        const Chart& chart = m_charts[i];
        const Eigen::Matrix2d c = product(i, f);
        double cosine = c(0, 0) + c(1, 1), sine = c(0, 1) - c(1, 0);
        const double size = std::hypot(cosine, sine);
        if(size > 0.)
        {
          cosine /= size;
          sine /= size;
        }
        for(std::size_t j = 0; j < chart.point.size(); ++j)
        {
          const Planar p = turned(chart.place[j], {cosine, sine});
          const double w = 1. / chart.square[j];
          const Row way(p[0], p[1]);
          energy += w * (f.row(chart.point[j]) - f.row(Eigen::Index(i)) - way).squaredNorm();
          right.row(chart.point[j]) += w * way;
          right.row(Eigen::Index(i)) -= w * way;
        }
      }
      if(step < rigid_steps)
        f = m_solver.solve(right);
    }
    return f;
  }

private:
  // Of places and their images.
  Eigen::Matrix2d product(std::size_t i, const Matrix& f) const
  {
    const Chart& chart = m_charts[i];
    Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
    for(std::size_t j = 0; j < chart.point.size(); ++j)
      result += Eigen::Vector2d(chart.place[j][0], chart.place[j][1]) *
                (f.row(chart.point[j]) - f.row(Eigen::Index(i))) / chart.square[j];
    return result;
  }

  const std::vector<Chart>& m_charts;
  Eigen::LDLT<Matrix> m_solver;
};

} // namespace

Matrix classical_scaling(const Matrix& squares)
{
  const Matrix sum = 0.5 * (squares + squares.transpose());
  const Eigen::RowVectorXd mean = sum.colwise().mean();
  Matrix gram = -0.5 * sum;
  gram.rowwise() += 0.5 * mean;
  gram.colwise() += 0.5 * mean.transpose();
  gram.array() -= 0.5 * mean.mean();
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(gram);
  Matrix result = eigen.eigenvectors().rightCols(2);
  for(int k = 0; k < 2; ++k)
    result.col(k) *= std::sqrt(std::max(0., eigen.eigenvalues()[gram.rows() - 2 + k]));
  return result;
}

std::vector<Planar> embedded(const Base_points& base, std::size_t neighbors)
{
  if(base.size() < 3)
    return {};
  std::vector<Chart> chart = charts(base, neighbors);
  // With few neighbours groups of points may know only themselves.
  while(!is_connected(chart))
  {
    if(++neighbors >= base.nearest)
      return {};
    chart = charts(base, neighbors);
  }
  orient(chart);
  const Rigid rigid(chart);
  double least = infinity;
  Matrix best;
  const auto offer = [&](const Matrix& start)
  {
    double energy;
    const Matrix f = rigid.fit(start, energy);
    if(energy < least)
    {
      least = energy;
      best = f;
    }
  };
  offer(metric_fit(chart, spectral(chart)));
  offer(scaled_by_chains(base));
  std::vector<Planar> result(base.size());
  for(Eigen::Index i = 0; i < best.rows(); ++i)
    result[i] = {best(i, 0), best(i, 1)};
  return result;
}

std::vector<Planar> extended(const Base_points& base, const std::vector<Planar>& images,
                             std::size_t neighbors)
{
  const std::size_t sites = base.nearest > 0 ? base.point.size() / base.nearest : 0;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<Planar> result(sites, Planar{unknown, unknown});
  const std::size_t limit = std::min(base.nearest, neighbors + 1);
  std::vector<Planar> offset, place;
  std::vector<double> square, inverse;
  for(std::size_t y = 0; y < sites; ++y)
  {
    const Index* point = &base.point[base.nearest * y];
    const double* distance = &base.distance[base.nearest * y];
    if(point[0] == none)
      continue;
    if(distance[0] == 0.)
    {
      result[y] = images[point[0]];
      continue;
    }
    // The last one says how far the others are seen, unless all are equally far.
    std::size_t number = 0;
    while(number < limit && point[number] != none)
      ++number;
    double radius = infinity;
    if(number == limit && limit < base.size() && distance[0] < distance[number - 1])
      radius = distance[--number];
    offset.resize(number);
    place.assign(number, {0., 0.});
    square.resize(number);
    inverse.resize(number);
    Planar centre = {0., 0.};
    double sum = 0.;
    for(std::size_t j = 0; j < number; ++j)
    {
      square[j] = distance[j] * distance[j];
      // Smooth, and zero where another base point comes instead.
      const double fade = std::max(0., 1. - square[j] / (radius * radius)), cut = fade * fade;
      inverse[j] = cut * square[0] / square[j];
      centre = centre + inverse[j] * images[point[j]];
      sum += inverse[j];
      offset[j] = {cut, 0.};
    }
    centre = (1. / sum) * centre;
    // A Gram matrix C of rank two has the columns of C X as coordinates, whatever X is but for a linear map: the
    // images of the base points spare an eigenproblem for each site, and change smoothly.
    for(std::size_t j = 0; j < number; ++j)
      offset[j] = offset[j][0] * (images[point[j]] - centre);
    for(std::size_t j = 0; j < number; ++j)
      for(std::size_t k = 0; k <= j; ++k)
      {
        const double between =
            std::min(base.distance_between(point[j], point[k]), distance[j] + distance[k]);
        const double c = 0.5 * (square[j] + square[k] - between * between);
        place[j] = place[j] + c * offset[k];
        if(k < j)
          place[k] = place[k] + c * offset[j];
      }
    const auto w = weights(place, inverse, regularization);
    Planar image = {0., 0.};
    for(std::size_t j = 0; j < number; ++j)
      image = image + w[j] * images[point[j]];
    result[y] = image;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
