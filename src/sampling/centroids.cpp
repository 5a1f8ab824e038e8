// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/centroids.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "mesh/walk.h"

#include <algorithm>
#include <array>

namespace CGAL::Geodesic_processing::internal {

namespace {

struct Mass
{
  double mass = 0.;
  Spatial moment = {0., 0., 0.};

  Mass operator-(const Mass& other) const { return {mass - other.mass, moment - other.moment}; }
  void add(const Mass& other)
  {
    mass += other.mass;
    moment = moment + other.moment;
  }
};

// A convex polygon in a triangle, cut from it by up to two lines.
struct Polygon
{
  std::array<Spatial, 5> points;
  int size = 0;

  // Keeps what is nearer to p than to q.
  void cut(const Spatial& p, const Spatial& q)
  {
    const Spatial way = q - p, middle = 0.5 * (p + q);
    Polygon result;
    for(int i = 0; i < size; ++i)
    {
      const Spatial &a = points[i], &b = points[(i + 1) % size];
      const double at_a = dot(a - middle, way), at_b = dot(b - middle, way);
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
      const Spatial &a = points[0], &b = points[i - 1], &c = points[i];
      const double part = density * norm(cross(b - a, c - a));
      result.add({part, (part / 3.) * (a + b + c)});
    }
    return result;
  }
};

// The corner of a triangle that is cut off at these shares of its sides.
Mass corner_part(const std::array<Spatial, 3>& corners, const Mass& whole, int k, double to_next,
                 double to_previous)
{
  const Spatial& tip = corners[k];
  const double mass = to_next * to_previous * whole.mass;
  return {mass, mass * (tip + (to_next / 3.) * (corners[(k + 1) % 3] - tip) +
                        (to_previous / 3.) * (corners[(k + 2) % 3] - tip))};
}

// What of a triangle is nearer to p than to q: the corner that one of its corners has for itself, or the rest.
Mass nearer_part(const std::array<Spatial, 3>& corners, const Mass& whole, const Spatial& p,
                 const Spatial& q)
{
  const Spatial way = q - p, middle = 0.5 * (p + q);
  std::array<double, 3> at;
  int near = 0;
  for(int k = 0; k < 3; ++k)
  {
    at[k] = dot(corners[k] - middle, way);
    near |= int(at[k] <= 0.) << k;
  }
  if(near == 0)
    return {};
  if(near == 7)
    return whole;
  constexpr std::array<int, 8> corner_alone = {0, 0, 1, 2, 2, 1, 0, 0};
  const int k = corner_alone[near];
  const Mass corner = corner_part(corners, whole, k, at[k] / (at[k] - at[(k + 1) % 3]),
                                  at[k] / (at[k] - at[(k + 2) % 3]));
  return near == 1 << k ? corner : whole - corner;
}

using Parts = std::array<Mass, 3>;

// Of any triangle: what is cut from it for two, and the rest.
Parts cut_parts(const std::array<Spatial, 3>& corners, const Mass& whole,
                const std::array<Spatial, 3>& centres)
{
  const double area = norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
  Parts parts;
  for(int k = 0; k < 2; ++k)
  {
    Polygon part{{corners[0], corners[1], corners[2]}, 3};
    part.cut(centres[k], centres[1 - k]);
    part.cut(centres[k], centres[2]);
    parts[k] = part.mass(whole.mass / area);
  }
  parts[2] = whole - parts[0] - parts[1];
  return parts;
}

// Three quadrangles about a place in the triangle.
// share: along each side, where they meet
Parts parts_around(const Spatial& place, const std::array<double, 3>& share,
                   const std::array<Spatial, 3>& corners, const Mass& whole)
{
  Parts parts;
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    const double along = share[k], back = 1. - share[previous];
    const double first = along * place[previous], last = back * place[next];
    const double to_next = (first * (along + place[next]) + last * place[next]) / 3.,
                 to_previous = (first * place[previous] + last * (place[previous] + back)) / 3.;
    parts[k].mass = whole.mass * (first + last);
    parts[k].moment = whole.mass * ((first + last - to_next - to_previous) * corners[k] +
                                    to_next * corners[next] + to_previous * corners[previous]);
  }
  return parts;
}

// What three samples have of a triangle each.
Parts three_parts(const std::array<Spatial, 3>& corners, const Mass& whole,
                  const std::array<Spatial, 3>& centres)
{
  // Half the squared distances of the corners to each sample less those to the first.
  std::array<std::array<double, 3>, 3> at{};
  for(int i = 1; i < 3; ++i)
  {
    const Spatial way = centres[i] - centres[0], middle = 0.5 * (centres[i] + centres[0]);
    for(int k = 0; k < 3; ++k)
      at[i][k] = -dot(corners[k] - middle, way);
  }
  bool is_own = true;          // every corner is nearest to its own sample
  std::array<double, 3> share; // along each side, where two are equally near
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    is_own = is_own && at[k][k] < at[next][k] && at[k][k] < at[previous][k];
    const double here = at[next][k] - at[k][k], there = at[k][next] - at[next][next];
    share[k] = here / (here + there);
  }
  if(!is_own)
    return cut_parts(corners, whole, centres);
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    const auto there = [&](int i) { return at[i][k] + share[k] * (at[i][next] - at[i][k]); };
    if(there(k) < there(previous))
      continue;
    // The third one lies between the two, which have a corner each.
    const auto lead = [&](int i, int corner) { return at[previous][corner] - at[i][corner]; };
    Parts parts;
    parts[k] = corner_part(corners, whole, k, lead(k, k) / (lead(k, k) - lead(k, next)),
                           1. - share[previous]);
    parts[next] = corner_part(corners, whole, next, share[next],
                              lead(next, next) / (lead(next, next) - lead(next, k)));
    parts[previous] = whole - parts[k] - parts[next];
    return parts;
  }
  const Spatial meeting = cross(at[1], at[2]);
  return parts_around((1. / (meeting[0] + meeting[1] + meeting[2])) * meeting, share, corners,
                      whole);
}

bool is_obstacle(const std::vector<double>* slowness, Index triangle)
{
  return slowness && !((*slowness)[triangle] < infinity);
}

// The cells of a triangle's corners, each once.
struct Labels
{
  std::array<Index, 3> labels;
  int size = 0;

  Labels(const Index* corner, const std::vector<Index>& labels_of_sites)
  {
    for(int k = 0; k < 3; ++k)
      if(const Index label = labels_of_sites[corner[k]];
         label != none && !(size > 0 && labels[0] == label) && !(size > 1 && labels[1] == label))
        labels[size++] = label;
  }
  const Index* begin() const { return labels.data(); }
  const Index* end() const { return labels.data() + size; }
};

} // namespace

std::vector<double> triangle_masses(const Glued_triangles& t, const std::vector<double>* slowness)
{
  std::vector<double> result(t.number_of_triangles(), 0.);
  for(Index f = 0; f < result.size(); ++f)
  {
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    if(is_obstacle(slowness, f))
      continue;
    const double square = slowness ? (*slowness)[f] * (*slowness)[f] : 1.;
    result[f] = square * square * norm(cross(b - a, c - a));
  }
  return result;
}

std::vector<Location> centroids(const Glued_triangles& t, const std::vector<double>& masses,
                                const std::vector<Index>& labels,
                                const std::vector<Location>& samples,
                                const std::vector<double>* slowness, double way,
                                const std::vector<Spatial>& onward)
{
  std::vector<Spatial> centre;
  centre.reserve(samples.size());
  for(const Location& sample : samples)
    centre.push_back(scaled_coordinates(t, sample));
  std::vector<Mass> mass(samples.size());
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    if(!(masses[f] > 0.))
      continue;
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    const Labels here(corner, labels);
    const Mass whole = {masses[f], (masses[f] / 3.) * (a + b + c)};
    // What is left by rounding has no centre.
    const auto give = [&](int k, const Mass& part)
    {
      if(part.mass > 1e-12 * masses[f])
        mass[here.labels[k]].add(part);
    };
    if(here.size == 1)
      give(0, whole);
    else if(here.size == 2)
    {
      const Mass first =
          nearer_part({a, b, c}, whole, centre[here.labels[0]], centre[here.labels[1]]);
      give(0, first);
      give(1, whole - first);
    }
    else if(here.size == 3)
    {
      const std::array<Mass, 3> parts =
          three_parts({a, b, c}, whole,
                      {centre[here.labels[0]], centre[here.labels[1]], centre[here.labels[2]]});
      for(int k = 0; k < 3; ++k)
        give(k, parts[k]);
    }
  }
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(mass[i].mass > 0.)
    {
      centre[i] = (1. - way) * centre[i] + (way / mass[i].mass) * mass[i].moment;
      if(!onward.empty())
        centre[i] = centre[i] + onward[i];
    }

  // A sample mostly moves to a triangle beside its own; where it does not, all of its cell's are tried.
  std::vector<Location> result = samples;
  std::vector<double> least(samples.size(), 0.);
  bool is_open = false;
  const auto is_no_wall = [](Index) { return false; };
  for(Index i = 0; i < samples.size(); ++i)
    if(mass[i].mass > 0.)
    {
      const auto is_of_cell = [&](Index f)
      {
        const Index* const corner = &t.corner[3 * std::size_t(f)];
        return !is_obstacle(slowness, f) &&
               (labels[corner[0]] == i || labels[corner[1]] == i || labels[corner[2]] == i);
      };
      result[i] = walk_to_nearest(t, triangle_at(t, samples[i]), centre[i], is_of_cell, is_no_wall);
      if(result[i].triangle != none)
        continue;
      result[i] = samples[i];
      least[i] = infinity;
      is_open = true;
    }
  for(Index f = 0; is_open && f < t.number_of_triangles(); ++f)
  {
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    for(const Index label : Labels(corner, labels))
    {
      if(least[label] == 0. || !has_area(a, b, c) || is_obstacle(slowness, f))
        continue;
      const auto nearest = nearest_in_triangle(a, b, c, centre[label]);
      const double distance =
          norm(nearest[0] * a + nearest[1] * b + nearest[2] * c - centre[label]);
      if(distance < least[label])
      {
        least[label] = distance;
        result[label] = {f, none, nearest};
      }
    }
  }
  for(Location& location : result)
    location = cleaned(t, location);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
