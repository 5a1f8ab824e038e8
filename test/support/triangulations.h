// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TRIANGULATIONS_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TRIANGULATIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Small triangulated surfaces. Triangles are counterclockwise seen from outside or from above.

namespace CGAL::Geodesic_processing::test {

using internal::Index;
using internal::Mesh_arrays;
using internal::none;
using internal::pi;
using internal::Surface_arrays;
using internal::Surface_location;

using Point = std::array<double, 3>;

struct Triangulation
{
  std::vector<Point> points;
  std::vector<Index> corners; // 3 #triangles
};

inline Mesh_arrays arrays_of(const Triangulation& surface)
{
  return internal::build_mesh_arrays(
      surface.points, surface.corners,
      internal::twins_of_soup(surface.points.size(), surface.corners));
}

inline Triangulation one_triangle()
{
  return {{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {0, 1, 2}};
}

inline Triangulation tetrahedron()
{
  return {{{1., 1., 1.}, {1., -1., -1.}, {-1., 1., -1.}, {-1., -1., 1.}},
          {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2}};
}

// A grid of columns x rows squares, each divided by a diagonal. Corner (i, j) is point i +
// (columns + 1) j at position(i / columns, j / rows). If `jitter` is positive, diagonals are
// random and inner points are moved by up to `jitter` times the size of a square.
inline Triangulation grid(std::size_t columns, std::size_t rows,
                          const std::function<Point(double, double)>& position, double jitter = 0.,
                          unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-jitter, jitter);
  Triangulation result;
  for(std::size_t j = 0; j <= rows; ++j)
    for(std::size_t i = 0; i <= columns; ++i)
    {
      const bool inner = i > 0 && i < columns && j > 0 && j < rows;
      const double dx = offset(random), dy = offset(random);
      result.points.push_back(
          position((i + (inner ? dx : 0.)) / columns, (j + (inner ? dy : 0.)) / rows));
    }
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      const Index a = Index(i + (columns + 1) * j), b = a + 1, d = Index(a + columns + 1),
                  c = d + 1;
      if(jitter > 0. && random() % 2 == 0)
        result.corners.insert(result.corners.end(), {a, b, d, b, c, d});
      else
        result.corners.insert(result.corners.end(), {a, b, c, a, c, d});
    }
  return result;
}

// The unit square in the plane. Up to a jitter of 0.25 no triangle is inverted.
inline Triangulation square(std::size_t n, double jitter = 0., unsigned seed = 1)
{
  return grid(
      n, n,
      [](double u, double v) {
        return Point{u, v, 0.};
      },
      jitter, seed);
}

// A rectangle of size n - 1 by n, whose middle column of triangles has no area: it joins the edges
// of both halves, which are displaced by half an edge.
inline Triangulation rectangle_with_slit(std::size_t n)
{
  return grid(n, n,
              [n](double u, double v)
              {
                const double x = u * double(n), y = v * double(n);
                return u > 0.5 ? Point{x - 1., y + 0.5, 0.} : Point{x, y, 0.};
              });
}

// A flat unit square of jittered triangles that become wider from left to right, up to 80 times.
inline Triangulation graded_square(std::size_t n)
{
  return grid(
      n, n,
      [](double u, double v) {
        return Point{u * u * u * u, v, 0.};
      },
      0.2, 5);
}

// Circles around an axis of n points each. Circle j has the radius radius(j / number_of_rings) and
// the height height(j / number_of_rings), and is rotated by j * twist steps. Open at both ends.
inline Triangulation rings(std::size_t n, std::size_t number_of_rings,
                           const std::function<double(double)>& radius,
                           const std::function<double(double)>& height, double twist = 0.5)
{
  Triangulation result;
  for(std::size_t j = 0; j <= number_of_rings; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double s = double(j) / number_of_rings, angle = 2. * pi * (i + j * twist) / n;
      result.points.push_back(
          {radius(s) * std::cos(angle), radius(s) * std::sin(angle), height(s)});
    }
  for(std::size_t j = 0; j < number_of_rings; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const Index a = Index(j * n + i), b = Index(j * n + (i + 1) % n), c = Index(a + n),
                  d = Index(b + n);
      result.corners.insert(result.corners.end(), {a, b, c, b, d, c});
    }
  return result;
}

// A flat annulus: shortest paths must pass around the hole.
inline Triangulation annulus(std::size_t n, std::size_t number_of_rings, double inner, double outer)
{
  Triangulation result = rings(
      n, number_of_rings, [=](double s) { return outer + s * (inner - outer); },
      [](double) { return 0.; });
  return result;
}

inline Triangulation cylinder(std::size_t n, std::size_t number_of_rings, double radius,
                              double height)
{
  return rings(
      n, number_of_rings, [=](double) { return radius; }, [=](double s) { return s * height; });
}

// A fan of n congruent triangles with the total angle `total` and edges of length 1 at point 0,
// surrounded by rings of the same shape. It is intrinsically flat except at the center. For total
// < 2 pi it is a cone; otherwise a saddle that is folded up and down alternately (n must be even).
//
// Point 0 is the center; point 1 + n j + i has the direction i and the distance j + 1.
inline Triangulation cone(std::size_t n, std::size_t number_of_rings, double total)
{
  // Directions with equal angles total / n between neighbors: the colatitude alternates by `fold`.
  const double step = total / n, turn = 2. * pi / n;
  double colatitude = 0., fold = 0.;
  if(total <= 2. * pi) // sin(step/2) = sin(colatitude) sin(turn/2)
    colatitude = std::asin(std::min(1., std::sin(step / 2.) / std::sin(turn / 2.)));
  else // cos(step) = cos^2(fold) cos(turn) - sin^2(fold)
  {
    colatitude = pi / 2.;
    fold = std::acos(std::sqrt((1. + std::cos(step)) / (1. + std::cos(turn))));
  }
  Triangulation result;
  result.points.push_back({0., 0., 0.});
  for(std::size_t j = 0; j < number_of_rings; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double c = colatitude + (i % 2 == 0 ? fold : -fold), a = turn * i, r = j + 1.;
      result.points.push_back(
          {r * std::sin(c) * std::cos(a), r * std::sin(c) * std::sin(a), r * std::cos(c)});
    }
  for(std::size_t i = 0; i < n; ++i)
  {
    const Index a = Index(1 + i), b = Index(1 + (i + 1) % n);
    result.corners.insert(result.corners.end(), {0, a, b});
    for(std::size_t j = 0; j + 1 < number_of_rings; ++j)
    {
      const Index low = Index(n * j), high = Index(n * (j + 1));
      result.corners.insert(result.corners.end(),
                            {low + a, high + a, high + b, low + a, high + b, low + b});
    }
  }
  return result;
}

// The unit sphere: an icosahedron whose triangles are subdivided 1-to-4 `level` times.
inline Triangulation icosphere(unsigned level)
{
  const double g = (1. + std::sqrt(5.)) / 2.;
  Triangulation result{{{-1, g, 0},
                        {1, g, 0},
                        {-1, -g, 0},
                        {1, -g, 0},
                        {0, -1, g},
                        {0, 1, g},
                        {0, -1, -g},
                        {0, 1, -g},
                        {g, 0, -1},
                        {g, 0, 1},
                        {-g, 0, -1},
                        {-g, 0, 1}},
                       {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                        4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                        6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1}};
  const auto normalize = [](Point& p)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for(double& x : p)
      x /= length;
  };
  for(Point& p : result.points)
    normalize(p);
  for(unsigned i = 0; i < level; ++i)
  {
    std::map<std::pair<Index, Index>, Index> midpoint;
    const auto between = [&](Index a, Index b)
    {
      const auto [entry, is_new] =
          midpoint.try_emplace(std::minmax(a, b), Index(result.points.size()));
      if(is_new)
      {
        Point p;
        for(int k = 0; k < 3; ++k)
          p[k] = result.points[a][k] + result.points[b][k];
        normalize(p);
        result.points.push_back(p);
      }
      return entry->second;
    };
    std::vector<Index> corners;
    for(std::size_t c = 0; c < result.corners.size(); c += 3)
    {
      const Index p = result.corners[c], q = result.corners[c + 1], r = result.corners[c + 2];
      const Index a = between(p, q), b = between(q, r), d = between(r, p);
      corners.insert(corners.end(), {p, a, d, a, q, b, d, b, r, a, b, d});
    }
    result.corners = std::move(corners);
  }
  return result;
}

// The boundary of the union of unit cubes of a grid of nx x ny x nz. It can have any genus, and is
// nonmanifold if two cubes meet only in an edge or a vertex.
inline Triangulation blocks(int nx, int ny, int nz,
                            const std::function<bool(int, int, int)>& is_full)
{
  Triangulation result;
  std::map<std::array<int, 3>, Index> index;
  const auto corner = [&](const std::array<int, 3>& p)
  {
    const auto [entry, is_new] = index.try_emplace(p, Index(result.points.size()));
    if(is_new)
      result.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return entry->second;
  };
  const auto full = [&](const std::array<int, 3>& p)
  {
    return p[0] >= 0 && p[0] < nx && p[1] >= 0 && p[1] < ny && p[2] >= 0 && p[2] < nz &&
           is_full(p[0], p[1], p[2]);
  };
  for(int k = 0; k < nz; ++k)
    for(int j = 0; j < ny; ++j)
      for(int i = 0; i < nx; ++i)
        for(int axis = 0; axis < 3 && full({i, j, k}); ++axis)
          for(const int end : {0, 1})
          {
            std::array<int, 3> p = {i, j, k}, next = p;
            next[axis] += 2 * end - 1;
            if(full(next))
              continue;
            p[axis] += end;
            // The two other axes, ordered counterclockwise around the outward axis.
            const int u = (axis + (end == 1 ? 1 : 2)) % 3, v = 3 - axis - u;
            auto q = p, r = p, s = p;
            ++q[u];
            ++r[u];
            ++r[v];
            ++s[v];
            const Index a = corner(p), b = corner(q), c = corner(r), d = corner(s);
            result.corners.insert(result.corners.end(), {a, b, c, a, c, d});
          }
  return result;
}

// A plate with two square holes, of genus 2.
inline Triangulation double_torus(int size = 4)
{
  return blocks(5 * size, 3 * size, size,
                [=](int i, int j, int)
                { return j / size != 1 || (i / size != 1 && i / size != 3); });
}

inline Triangulation scaled(Triangulation surface, double factor)
{
  for(Point& p : surface.points)
    for(double& x : p)
      x *= factor;
  return surface;
}

// Moves each point by up to `amount` in each coordinate.
inline Triangulation jittered(Triangulation surface, double amount, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-amount, amount);
  for(Point& p : surface.points)
    for(double& x : p)
      x += offset(random);
  return surface;
}

// A torus with radii 1 and 0.4, n points around the axis and m points around the tube.
inline Triangulation torus(Index n, Index m)
{
  Triangulation result;
  for(Index j = 0; j < m; ++j)
    for(Index i = 0; i < n; ++i)
    {
      const double u = 2. * pi * i / n, v = 2. * pi * j / m, r = 1. + 0.4 * std::cos(v);
      result.points.push_back({r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)});
      const Index a = i + n * j, b = (i + 1) % n + n * j, c = i + n * ((j + 1) % m),
                  d = (i + 1) % n + n * ((j + 1) % m);
      result.corners.insert(result.corners.end(), {a, b, d, a, d, c});
    }
  return result;
}

// The disjoint union of two surfaces.
inline Triangulation disjoint_union(Triangulation a, const Triangulation& b)
{
  const Index first = Index(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const Index corner : b.corners)
    a.corners.push_back(first + corner);
  return a;
}

// Reads a file in OFF format with triangles only. Returns an empty surface if the file does not
// exist.
inline Triangulation read_off(const std::string& file)
{
  Triangulation result;
  std::ifstream in(file);
  if(!in)
    return result;
  std::string header;
  std::size_t points = 0, faces = 0, edges = 0;
  in >> header >> points >> faces >> edges;
  result.points.resize(points);
  for(Point& p : result.points)
    in >> p[0] >> p[1] >> p[2];
  for(std::size_t f = 0; f < faces; ++f)
  {
    Index n, a, b, c;
    in >> n >> a >> b >> c;
    if(!in || n != 3 || a >= points || b >= points || c >= points)
      throw std::runtime_error("Not triangles in OFF: " + file);
    result.corners.insert(result.corners.end(), {a, b, c});
  }
  if(result.points.empty())
    throw std::runtime_error("Not a surface in OFF: " + file);
  return result;
}

// Returns a random location in a random triangle.
inline Surface_location random_location(const Surface_arrays& triangles, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0., 1.);
  double a = unit(random), b = unit(random);
  if(a + b > 1.)
  {
    a = 1. - a;
    b = 1. - b;
  }
  Surface_location result;
  result.triangle = Index(random() % triangles.number_of_triangles());
  result.barycentric = {1. - a - b, a, b};
  return result;
}

// Returns the position of a location in the coordinates of the caller.
inline Point point_at(const Surface_arrays& triangles, const Surface_location& location)
{
  Point result = {0., 0., 0.};
  for(int k = 0; k < 3; ++k)
  {
    if(location.triangle == none)
      result[k] = triangles.point[location.vertex][k];
    else
      for(int i = 0; i < 3; ++i)
        result[k] += location.barycentric[i] *
                     triangles.point[triangles.corner[3 * location.triangle + i]][k];
    result[k] = triangles.origin[k] + triangles.scale * result[k];
  }
  return result;
}

inline double distance(const Point& p, const Point& q)
{
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                   (p[2] - q[2]) * (p[2] - q[2]));
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TRIANGULATIONS_H
