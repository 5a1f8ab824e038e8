// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_OPERATORS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_OPERATORS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A vector for each triangle, in the plane where unfolded() lays it out: the first corner at the
// origin, side 0 along the first axis.  Functions are given by a value for each site, and are linear
// in each triangle.
using Field = std::vector<Vec2>;

// A symmetric tensor of a triangle's plane: xx, xy, yy.
using Metric_tensor = std::array<double, 3>;

inline Vec2 product(const Metric_tensor& tensor, const Vec2& p)
{
  return {tensor[0] * p[0] + tensor[1] * p[1], tensor[1] * p[0] + tensor[2] * p[1]};
}

inline Metric_tensor inverse(const Metric_tensor& a)
{
  const double determinant = a[0] * a[2] - a[1] * a[1];
  return {a[2] / determinant, -a[1] / determinant, a[0] / determinant};
}

// What becomes of triangles whose height is less than 1e-7 of their shortest side: left out, they have
// area zero, and no function has a gradient there; or raised to that height, so that what lies on both
// sides of them stays joined.  (Corners on one line have lengths that pretend a height of up to 1e-8, the
// root of rounding; a needle whose short side is tiny is kept, as it joins sites.)
enum class Degenerate_triangles
{
  skipped,
  thickened
};

// What gradient, divergence and Laplacian are made of, on a mesh as on the overlapping triangles of a
// cloud.
struct Operators
{
  std::vector<Index> corner; // 3 #triangles: the site at each corner
  std::vector<double> area;  // #triangles: times the weight, or zero
  Field hat_gradient;        // 3 #triangles: gradient of what is 1 at the corner and linear
  std::size_t number_of_vertices = 0; // also those of no triangle

  std::size_t number_of_triangles() const { return area.size(); }
};

CGAL_GEODESIC_PROCESSING_EXPORT
Operators operators(const Surface_arrays& triangles,
                    Degenerate_triangles degenerate = Degenerate_triangles::skipped);

// Whether nothing may pass where lengths are measured so.
inline bool is_blocked(const Metric_tensor& metric)
{
  return !std::isfinite(metric[0] + metric[2]);
}

// Where the length of a vector is that of its product with a tensor A, those of the field that is measured,
// A J: its divergence is that of J, and the length of a function's gradient what it changes by per
// measured length.  Triangles through which nothing may pass have no area; flat ones are raised.
// measure: #triangles, or empty: lengths as they are
CGAL_GEODESIC_PROCESSING_EXPORT
Operators metric_operators(const Surface_arrays& triangles,
                           const std::vector<Metric_tensor>& metric);

// G: #sites to #triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
void gradient(const Operators& operators, const Vector& function, Field& result);
CGAL_GEODESIC_PROCESSING_EXPORT
Field gradient(const Operators& operators, const Vector& function);

// The transpose of G times the areas: at each site the integral of the field times the gradient of the
// site's hat function, which is minus the divergence, integrated.  #triangles to #sites; the sum over
// each component is zero, and no field flows through a border.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector minus_divergence(const Operators& operators, const Field& field);

// R: a quarter turn to the left in each triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
Field rotated_left(Field field);

// The integral of the product of two fields.
CGAL_GEODESIC_PROCESSING_EXPORT
double inner_product(const Operators& operators, const Field& a, const Field& b);

// Returns the integral of the length of a field, added to `initial`.
CGAL_GEODESIC_PROCESSING_EXPORT
double integrated_length(const Operators& operators, const Field& field, double initial = 0.);

// The integral of each hat function: the sum is the area.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector lumped_mass(const Operators& operators);

// At each site the mean of the lengths of a field's vectors, weighted by areas; zero at sites of no triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector mean_magnitudes(const Surface_arrays& triangles, const Field& field);

// Sites joined by triangles that have area: a label for each site, and how many labels there are.
// Between components nothing flows.  Sites of no such triangle are components of their own.
CGAL_GEODESIC_PROCESSING_EXPORT
std::pair<std::vector<Index>, std::size_t> components(const Operators& operators);

// The Laplacian, positive semidefinite: the divergence of K times the gradient, K a tensor for each
// triangle.  The lower triangle of a matrix whose pattern is found once.
class CGAL_GEODESIC_PROCESSING_EXPORT Laplacian
{
public:
  // O(n log n).
  explicit Laplacian(const Operators& operators);

  // K the identity.
  Sparse_matrix matrix(const Operators& operators) const;

  // Overwrites the entries of such a matrix.  O(n)
  void assemble(const Operators& operators, const std::vector<Metric_tensor>& tensors,
                Sparse_matrix& matrix) const;

  // Makes it definite: it does not see the constants of a component.  Solutions vanish at one site of
  // each then, and solve the system as it was, when the right side sums to zero on each component.
  //
  // is_definite: of the first components, which need not be held
  void pin(Sparse_matrix& matrix, const std::vector<bool>& is_definite = {}) const;

private:
  Sparse_matrix m_pattern; // all entries zero
  std::vector<std::array<Index, 6>>
      m_entries;               // #triangles: entries of corners 0, 1, 2 and of sides
  std::vector<Index> m_pinned; // #components: the entry of a site
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_OPERATORS_H
