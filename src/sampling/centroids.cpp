// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/centroids.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "mesh/locate_by_walking.h"

#include <algorithm>
#include <array>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Mass and first moment (mass times centroid) of a region.
struct Mass
{
  double mass = 0.;
  Vec3 moment = {0., 0., 0.};

  Mass operator-(const Mass& other) const { return {mass - other.mass, moment - other.moment}; }
  void add(const Mass& other)
  {
    mass += other.mass;
    moment = moment + other.moment;
  }
};

// A convex polygon: a triangle clipped by at most two half-planes.
struct Polygon
{
  std::array<Vec3, 5> points;
  int size = 0;

  // Clips the polygon to the points that are closer to p than to q.
  void cut(const Vec3& p, const Vec3& q)
  {
    const Vec3 direction = q - p, midpoint = 0.5 * (p + q);
    Polygon result;
    for(int i = 0; i < size; ++i)
    {
      const Vec3 &a = points[i], &b = points[(i + 1) % size];
      const double at_a = dot(a - midpoint, direction), at_b = dot(b - midpoint, direction);
      if(at_a <= 0. && result.size < 5)
        result.points[result.size++] = a;
      if((at_a < 0.) != (at_b < 0.) && at_a != 0. && at_b != 0. && result.size < 5)
        result.points[result.size++] = a + (at_a / (at_a - at_b)) * (b - a);
    }
    *this = result;
  }

  Mass mass(double density) const
  {
    Mass result;
    for(int i = 2; i < size; ++i)
    {
      const Vec3 &a = points[0], &b = points[i - 1], &c = points[i];
      const double triangle_mass = density * norm(cross(b - a, c - a));
      result.add({triangle_mass, (triangle_mass / 3.) * (a + b + c)});
    }
    return result;
  }
};

// Returns the mass of the corner triangle k that is cut off at the given fractions of the two
// edges.
// whole: mass of the entire triangle
Mass corner_mass(const std::array<Vec3, 3>& corners, const Mass& whole, int k, double to_next,
                 double to_previous)
{
  const Vec3& tip = corners[k];
  const double mass = to_next * to_previous * whole.mass;
  return {mass, mass * (tip + (to_next / 3.) * (corners[(k + 1) % 3] - tip) +
                        (to_previous / 3.) * (corners[(k + 2) % 3] - tip))};
}

// Returns the mass of the part of a triangle that is closer to p than to q. The bisector cuts off
// one corner, which is this part or its complement.
Mass closer_mass(const std::array<Vec3, 3>& corners, const Mass& whole, const Vec3& p,
                 const Vec3& q)
{
  const Vec3 direction = q - p, midpoint = 0.5 * (p + q);
  std::array<double, 3> signed_distance;
  int closer_mask = 0;
  for(int k = 0; k < 3; ++k)
  {
    signed_distance[k] = dot(corners[k] - midpoint, direction);
    closer_mask |= int(signed_distance[k] <= 0.) << k;
  }
  if(closer_mask == 0)
    return {};
  if(closer_mask == 7)
    return whole;
  constexpr std::array<int, 8> single_corner = {0, 0, 1, 2, 2, 1, 0, 0};
  const int k = single_corner[closer_mask];
  const Mass corner = corner_mass(
      corners, whole, k, signed_distance[k] / (signed_distance[k] - signed_distance[(k + 1) % 3]),
      signed_distance[k] / (signed_distance[k] - signed_distance[(k + 2) % 3]));
  return closer_mask == 1 << k ? corner : whole - corner;
}

using Cell_masses = std::array<Mass, 3>;

// Splits any triangle among three centers: two regions by clipping, the third as the remainder.
Cell_masses split_by_clipping(const std::array<Vec3, 3>& corners, const Mass& whole,
                              const std::array<Vec3, 3>& centers)
{
  const double area = norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
  Cell_masses masses;
  for(int k = 0; k < 2; ++k)
  {
    Polygon polygon{{corners[0], corners[1], corners[2]}, 3};
    polygon.cut(centers[k], centers[1 - k]);
    polygon.cut(centers[k], centers[2]);
    masses[k] = polygon.mass(whole.mass / area);
  }
  masses[2] = whole - masses[0] - masses[1];
  return masses;
}

// Splits a triangle into three quads that meet at an interior point.
// fraction: parameter on each edge of the point common to two quads
Cell_masses split_at_point(const Vec3& barycentric, const std::array<double, 3>& fraction,
                           const std::array<Vec3, 3>& corners, const Mass& whole)
{
  Cell_masses masses;
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    const double fraction_next = fraction[k], fraction_previous = 1. - fraction[previous];
    const double first_area = fraction_next * barycentric[previous],
                 last_area = fraction_previous * barycentric[next];
    const double weight_next = (first_area * (fraction_next + barycentric[next]) +
                                last_area * barycentric[next]) /
                               3.,
                 weight_previous = (first_area * barycentric[previous] +
                                    last_area * (barycentric[previous] + fraction_previous)) /
                                   3.;
    masses[k].mass = whole.mass * (first_area + last_area);
    masses[k].moment =
        whole.mass * ((first_area + last_area - weight_next - weight_previous) * corners[k] +
                      weight_next * corners[next] + weight_previous * corners[previous]);
  }
  return masses;
}

// Splits a triangle into the Voronoi regions of three centers.
Cell_masses split_among_three(const std::array<Vec3, 3>& corners, const Mass& whole,
                              const std::array<Vec3, 3>& centers)
{
  // difference[i][k]: half of the squared distance of corner k to center i, minus that to center 0.
  std::array<std::array<double, 3>, 3> difference{};
  for(int i = 1; i < 3; ++i)
  {
    const Vec3 direction = centers[i] - centers[0], midpoint = 0.5 * (centers[i] + centers[0]);
    for(int k = 0; k < 3; ++k)
      difference[i][k] = -dot(corners[k] - midpoint, direction);
  }
  bool is_closest_to_own = true;  // each corner is closest to its own center
  std::array<double, 3> fraction; // on each edge: the point equidistant to the centers of its ends
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    is_closest_to_own = is_closest_to_own && difference[k][k] < difference[next][k] &&
                        difference[k][k] < difference[previous][k];
    const double here = difference[next][k] - difference[k][k],
                 there = difference[k][next] - difference[next][next];
    fraction[k] = here / (here + there);
  }
  if(!is_closest_to_own)
    return split_by_clipping(corners, whole, centers);
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    const auto there = [&](int i)
    { return difference[i][k] + fraction[k] * (difference[i][next] - difference[i][k]); };
    if(there(k) < there(previous))
      continue;
    // The region of the third center separates the regions of the other two, which are corners.
    const auto difference_to_third = [&](int i, int corner)
    { return difference[previous][corner] - difference[i][corner]; };
    Cell_masses masses;
    masses[k] = corner_mass(corners, whole, k,
                            difference_to_third(k, k) /
                                (difference_to_third(k, k) - difference_to_third(k, next)),
                            1. - fraction[previous]);
    masses[next] = corner_mass(corners, whole, next, fraction[next],
                               difference_to_third(next, next) / (difference_to_third(next, next) -
                                                                  difference_to_third(next, k)));
    masses[previous] = whole - masses[k] - masses[next];
    return masses;
  }
  const Vec3 intersection = cross(difference[1], difference[2]);
  return split_at_point((1. / (intersection[0] + intersection[1] + intersection[2])) * intersection,
                        fraction, corners, whole);
}

bool is_obstacle(const std::vector<double>* slowness, Index triangle)
{
  return slowness && !((*slowness)[triangle] < infinity);
}

// The distinct cells of the corners of a triangle.
struct Corner_labels
{
  std::array<Index, 3> labels;
  int size = 0;

  Corner_labels(const Index* corner, const std::vector<Index>& vertex_labels)
  {
    for(int k = 0; k < 3; ++k)
      if(const Index label = vertex_labels[corner[k]];
         label != none && !(size > 0 && labels[0] == label) && !(size > 1 && labels[1] == label))
        labels[size++] = label;
  }
  const Index* begin() const { return labels.data(); }
  const Index* end() const { return labels.data() + size; }
};

// Adds the mass of a triangle to its cells, split between their samples.
void add_triangle_mass(const std::array<Vec3, 3>& corners, double triangle_mass,
                       const Corner_labels& cells, const std::vector<Vec3>& center,
                       std::vector<Mass>& mass)
{
  const Mass whole = {triangle_mass, (triangle_mass / 3.) * (corners[0] + corners[1] + corners[2])};
  // A remainder that consists of round-off errors has no meaningful centroid.
  const auto add_mass = [&](int k, const Mass& piece)
  {
    if(piece.mass > 1e-12 * triangle_mass)
      mass[cells.labels[k]].add(piece);
  };
  if(cells.size == 1)
    add_mass(0, whole);
  else if(cells.size == 2)
  {
    const Mass first =
        closer_mass(corners, whole, center[cells.labels[0]], center[cells.labels[1]]);
    add_mass(0, first);
    add_mass(1, whole - first);
  }
  else if(cells.size == 3)
  {
    const std::array<Mass, 3> pieces = split_among_three(
        corners, whole,
        {center[cells.labels[0]], center[cells.labels[1]], center[cells.labels[2]]});
    for(int k = 0; k < 3; ++k)
      add_mass(k, pieces[k]);
  }
}

std::array<Vec3, 3> corner_points(const Surface_arrays& t, Index f)
{
  const Index* const corner = &t.corner[3 * std::size_t(f)];
  return {t.point[corner[0]], t.point[corner[1]], t.point[corner[2]]};
}

// Sets the location of each marked cell to the point of its triangles that is closest to `target`.
void project_to_cells(const Surface_arrays& t, const std::vector<Index>& labels,
                      const std::vector<Vec3>& target, const std::vector<double>* slowness,
                      const std::vector<bool>& is_unplaced, std::vector<Surface_location>& result)
{
  std::vector<double> min_distance(target.size(), infinity);
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const auto [a, b, c] = corner_points(t, f);
    for(const Index label : Corner_labels(&t.corner[3 * std::size_t(f)], labels))
    {
      if(!is_unplaced[label] || min_distance[label] == 0. || !has_area(a, b, c) ||
         is_obstacle(slowness, f))
        continue;
      const auto nearest = nearest_in_triangle(a, b, c, target[label]);
      const double distance =
          norm(nearest[0] * a + nearest[1] * b + nearest[2] * c - target[label]);
      if(distance < min_distance[label])
      {
        min_distance[label] = distance;
        result[label] = {f, none, nearest};
      }
    }
  }
}

// Moves samples of cells with mass to the point of their cells that is closest to `target`, and
// returns all samples in canonical form.
std::vector<Surface_location>
move_samples(const Surface_arrays& t, const std::vector<Index>& labels,
             const std::vector<Surface_location>& samples, const std::vector<Vec3>& target,
             const std::vector<Mass>& mass, const std::vector<double>* slowness)
{
  std::vector<Surface_location> result = samples;
  std::vector<bool> is_unplaced(samples.size(), false);
  bool has_unplaced = false;
  const auto is_wall = [](Index) { return false; };
  for(Index i = 0; i < samples.size(); ++i)
    if(mass[i].mass > 0.)
    {
      const auto is_in_cell = [&](Index f)
      {
        const Index* const corner = &t.corner[3 * std::size_t(f)];
        return !is_obstacle(slowness, f) &&
               (labels[corner[0]] == i || labels[corner[1]] == i || labels[corner[2]] == i);
      };
      result[i] = locate_by_walking(t, triangle_at(t, samples[i]), target[i], is_in_cell, is_wall);
      if(result[i].triangle != none)
        continue;
      result[i] = samples[i];
      is_unplaced[i] = has_unplaced = true;
    }
  // Walking fails rarely, so that a search of all triangles of the cell is affordable.
  if(has_unplaced)
    project_to_cells(t, labels, target, slowness, is_unplaced, result);
  for(Surface_location& location : result)
    location = canonical(t, location);
  return result;
}

} // namespace

std::vector<double> triangle_masses(const Surface_arrays& t, const std::vector<double>* slowness)
{
  std::vector<double> result(t.number_of_triangles(), 0.);
  for(Index f = 0; f < result.size(); ++f)
  {
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Vec3 &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    if(is_obstacle(slowness, f))
      continue;
    const double square = slowness ? (*slowness)[f] * (*slowness)[f] : 1.;
    result[f] = square * square * norm(cross(b - a, c - a));
  }
  return result;
}

std::vector<Surface_location> centroids(const Surface_arrays& t, const std::vector<double>& masses,
                                        const std::vector<Index>& labels,
                                        const std::vector<Surface_location>& samples,
                                        const std::vector<double>* slowness,
                                        const Centroid_step& step)
{
  std::vector<Vec3> center;
  center.reserve(samples.size());
  for(const Surface_location& sample : samples)
    center.push_back(scaled_coordinates(t, sample));
  std::vector<Mass> mass(samples.size());
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    if(masses[f] > 0.)
      add_triangle_mass(corner_points(t, f), masses[f],
                        Corner_labels(&t.corner[3 * std::size_t(f)], labels), center, mass);
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(mass[i].mass > 0.)
    {
      center[i] = (1. - step.factor) * center[i] + (step.factor / mass[i].mass) * mass[i].moment;
      if(step.momentum)
        center[i] = center[i] + (*step.momentum)[i];
    }
  return move_samples(t, labels, samples, center, mass, slowness);
}

} // namespace CGAL::Geodesic_processing::internal
