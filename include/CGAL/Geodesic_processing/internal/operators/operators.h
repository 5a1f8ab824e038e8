// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_OPERATORS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_OPERATORS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// One vector for each triangle, in the plane into which unfolded() maps the triangle. The first
// corner is the origin, and halfedge 0 points along the first axis. A function has one value for
// each vertex and is linear in each triangle.
using Field = std::vector<Vec2>;

// Computes the two axes of a triangle's plane in space. An axis is zero if the triangle has no
// length or no height.
inline std::array<Vec3, 2> axes(const Surface_arrays& t, Index triangle)
{
  const Index* corner = &t.corner[3 * std::size_t(triangle)];
  const Vec3 first = unit(t.point[corner[1]] - t.point[corner[0]]);
  const Vec3 edge = t.point[corner[2]] - t.point[corner[0]];
  return {first, unit(edge - dot(edge, first) * first)};
}

// Converts a vector in the plane of a triangle to a vector in space.
inline Vec3 in_space(const Surface_arrays& t, Index triangle, const Vec2& vector)
{
  const auto [u, v] = axes(t, triangle);
  return vector[0] * u + vector[1] * v;
}

// Projects a vector in space to the plane of a triangle.
inline Vec2 in_plane(const Surface_arrays& t, Index triangle, const Vec3& vector)
{
  const auto [u, v] = axes(t, triangle);
  return {dot(vector, u), dot(vector, v)};
}

// A symmetric tensor in the plane of a triangle: its entries xx, xy, yy.
using Metric_tensor = std::array<double, 3>;

// Returns the product of a symmetric tensor with a vector.
inline Vec2 product(const Metric_tensor& tensor, const Vec2& p)
{
  return {tensor[0] * p[0] + tensor[1] * p[1], tensor[1] * p[0] + tensor[2] * p[1]};
}

// Returns the inverse of a symmetric tensor, whose determinant must not be zero.
inline Metric_tensor inverse(const Metric_tensor& a)
{
  const double determinant = a[0] * a[2] - a[1] * a[1];
  return {a[2] / determinant, -a[1] / determinant, a[0] / determinant};
}

// The treatment of triangles whose height is less than 1e-7 times their shortest edge.
// - `skipped`: the area is set to zero, and all gradients vanish there.
// - `thickened`: the height is set to that limit, but at least to 1e-9, so that the adjacent
//   vertices stay connected. The longest edge of the surface has a length between 1 and 2.
//
// If the corners are collinear, round-off errors of the lengths can cause a height of up to 1e-8.
// The limit refers to the shortest edge. Hence needles with a tiny short edge are regular
// triangles, because they connect vertices.
enum class Degenerate_triangles
{
  skipped,
  thickened
};

// The arrays from which gradient, divergence and Laplacian are computed, on a mesh and on the
// overlapping triangles of a cloud.
struct Operators
{
  std::vector<Index> corner; // 3 #triangles: the vertex of each corner
  std::vector<double> area;  // #triangles: area times weight; 0 if the triangle is skipped
  Field hat_gradient;        // 3 #triangles: the gradient of the hat function of each corner
  std::size_t number_of_vertices = 0; // isolated vertices included

  std::size_t number_of_triangles() const { return area.size(); }
};

// Computes the operators of a surface. O(n)
CGAL_GEODESIC_PROCESSING_EXPORT
Operators operators(const Surface_arrays& triangles,
                    Degenerate_triangles degenerate = Degenerate_triangles::skipped);

// Throws Unsupported_surface_error if operators() skips all triangles. O(n)
CGAL_GEODESIC_PROCESSING_EXPORT
void require_area(const Surface_arrays& triangles);

// Returns true if the metric has an infinite entry on the diagonal: no path and no flow can pass.
inline bool is_blocked(const Metric_tensor& metric)
{
  return !std::isfinite(metric[0] + metric[2]);
}

// Computes operators for a metric: the length of a vector v is |A v|, where A is one symmetric
// tensor for each triangle. A field of these operators is A J, where J is the flow. Its length is
// that of J in the metric, and its minus_divergence() is that of J. The length of gradient() is the
// change of the function per length in the metric. A triangle whose metric is blocked has area
// zero. Degenerate triangles are thickened.
//
// metric  #triangles tensors A; empty for the lengths as they are
CGAL_GEODESIC_PROCESSING_EXPORT
Operators metric_operators(const Surface_arrays& triangles,
                           const std::vector<Metric_tensor>& metric);

// Computes the gradient of a function: from #vertices values to #triangles vectors.
CGAL_GEODESIC_PROCESSING_EXPORT
void gradient(const Operators& operators, const Vector& function, Field& result);
// The same, returned by value.
CGAL_GEODESIC_PROCESSING_EXPORT
Field gradient(const Operators& operators, const Vector& function);

// Computes the integrated divergence with a negative sign, from #triangles vectors to #vertices
// values. The value at a vertex is the integral of the inner product of the field with the gradient
// of the vertex's hat function. This is the adjoint of gradient(). On each component the values sum
// to zero. A field whose result is zero has no flow through the boundary.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector minus_divergence(const Operators& operators, const Field& field);

// Rotates all vectors by 90 degrees counterclockwise.
CGAL_GEODESIC_PROCESSING_EXPORT
Field rotated_left(Field field);

// Rotates all vectors by 90 degrees clockwise.
CGAL_GEODESIC_PROCESSING_EXPORT
Field rotated_right(Field field);

// Returns the integral of the inner product of two fields.
CGAL_GEODESIC_PROCESSING_EXPORT
double inner_product(const Operators& operators, const Field& a, const Field& b);

// Returns the integral of the length of a field, added to `initial`.
CGAL_GEODESIC_PROCESSING_EXPORT
double integrated_length(const Operators& operators, const Field& field, double initial = 0.);

// Returns the integral of each hat function: #vertices values, whose sum is the area.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector lumped_mass(const Operators& operators);

// Computes the area-weighted mean length of the vectors around each vertex: #vertices values. The
// value of a vertex without triangles is 0.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector mean_magnitudes(const Surface_arrays& triangles, const Field& field);

// Computes the connected components of the triangles with positive area. Returns the label of each
// vertex and the number of labels. A vertex without such a triangle is a component.
CGAL_GEODESIC_PROCESSING_EXPORT
std::pair<std::vector<Index>, std::size_t> components(const Operators& operators);

// The positive semidefinite Laplacian L f = minus_divergence(K gradient(f)), where K is one tensor
// for each triangle. A matrix stores the lower triangle. Its sparsity pattern is computed once.
class CGAL_GEODESIC_PROCESSING_EXPORT Laplacian
{
public:
  // Computes the pattern. O(n log n)
  explicit Laplacian(const Operators& operators);

  // Returns the matrix for K = identity.
  Sparse_matrix matrix(const Operators& operators) const;

  // Overwrites the entries of a matrix that matrix() has returned. O(n)
  void assemble(const Operators& operators, const std::vector<Metric_tensor>& tensors,
                Sparse_matrix& matrix) const;

  // Makes the matrix positive definite: adds a positive number to one diagonal entry of each
  // component, whose constant functions L maps to zero. If a right-hand side sums to zero on each
  // component, the solution solves the original system and vanishes at these vertices.
  //
  // is_definite  true for a component that is not pinned; missing entries are false
  void pin(Sparse_matrix& matrix, const std::vector<bool>& is_definite = {}) const;

private:
  Sparse_matrix m_pattern; // all entries are zero
  std::vector<std::array<Index, 6>>
      m_entries;               // #triangles: the entries of the three corners and the three edges
  std::vector<Index> m_pinned; // #components: the diagonal entry of one vertex
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_OPERATORS_H
