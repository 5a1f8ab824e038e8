// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/centroids.h>

#include <CGAL/Geodesic_processing/internal/path_locations.h>

#include <algorithm>
#include <array>

namespace CGAL::Geodesic_processing::internal {

namespace {

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
};

struct Mass
{
  double mass = 0.;
  Spatial moment = {0., 0., 0.};

  void add(const Spatial& a, const Spatial& b, const Spatial& c, double density)
  {
    const double here = density * norm(cross(b - a, c - a));
    mass += here;
    moment = moment + (here / 3.) * (a + b + c);
  }
  void add(const Mass& other, double times)
  {
    mass += times * other.mass;
    moment = moment + times * other.moment;
  }
};

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
    near += at[k] <= 0. ? 1 : 0;
  }
  if(near == 0)
    return {};
  if(near == 3)
    return whole;
  int alone = 0;
  while((at[alone] <= 0.) != (near == 1))
    ++alone;
  const int next = (alone + 1) % 3, previous = (alone + 2) % 3;
  const double to_next = at[alone] / (at[alone] - at[next]),
               to_previous = at[alone] / (at[alone] - at[previous]);
  const Spatial& tip = corners[alone];
  Mass corner;
  corner.mass = to_next * to_previous * whole.mass;
  corner.moment = corner.mass * (tip + (to_next / 3.) * (corners[next] - tip) +
                                 (to_previous / 3.) * (corners[previous] - tip));
  if(near == 1)
    return corner;
  Mass rest = whole;
  rest.add(corner, -1.);
  return rest;
}

bool is_obstacle(const std::vector<double>* slowness, Index triangle)
{
  return slowness && !((*slowness)[triangle] < infinity);
}

bool has_area(const Spatial& a, const Spatial& b, const Spatial& c)
{
  return norm(cross(b - a, c - a)) > 0.;
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
         label != none && std::find(begin(), end(), label) == end())
        labels[size++] = label;
  }
  const Index* begin() const { return labels.data(); }
  const Index* end() const { return labels.data() + size; }
};

// What is nearest to a point, found from triangle to triangle; nowhere where that leads to a border, to a
// corner, to an obstacle or out of the cell.
Location nearest_from(const Glued_triangles& t, const std::vector<Index>& labels, Index label,
                      Index triangle, const Spatial& p, const std::vector<double>* slowness)
{
  Index last = none;
  for(int steps = 0; triangle != none && steps < 10; ++steps)
  {
    const Index* const corner = &t.corner[3 * std::size_t(triangle)];
    const Labels here(corner, labels);
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    if(std::find(here.begin(), here.end(), label) == here.end() || !has_area(a, b, c) ||
       is_obstacle(slowness, triangle))
      return {};
    const auto nearest = nearest_in_triangle(a, b, c, p);
    const auto zeros = std::count(nearest.begin(), nearest.end(), 0.);
    if(zeros == 0)
      return {triangle, none, nearest};
    if(zeros > 1)
      return {};
    const auto behind = std::find(nearest.begin(), nearest.end(), 0.) - nearest.begin();
    const Index twin = t.twin[next_side(3 * triangle + Index(behind))];
    if(twin == none)
      return {};
    // On an edge where the surface bulges.
    if(twin / 3 == last)
      return {triangle, none, nearest};
    last = triangle;
    triangle = twin / 3;
  }
  return {};
}

} // namespace

std::vector<Location> centroids(const Glued_triangles& t, const std::vector<Index>& labels,
                                const std::vector<Location>& samples,
                                const std::vector<double>* slowness, double way,
                                const std::vector<Spatial>& onward)
{
  std::vector<Spatial> centre;
  for(const Location& sample : samples)
    centre.push_back(scaled_coordinates(t, sample));
  std::vector<Mass> mass(samples.size());
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    if(is_obstacle(slowness, f))
      continue;
    const double square = slowness ? (*slowness)[f] * (*slowness)[f] : 1.;
    const Labels here(corner, labels);
    // The last one has what the others leave.
    Mass rest;
    if(here.size > 0)
      rest.add(a, b, c, square * square);
    if(here.size == 1)
    {
      mass[here.labels[0]].add(rest, 1.);
      continue;
    }
    const double whole = rest.mass;
    if(here.size == 2)
    {
      const Mass first =
          nearer_part({a, b, c}, rest, centre[here.labels[0]], centre[here.labels[1]]);
      mass[here.labels[0]].add(first, 1.);
      rest.add(first, -1.);
    }
    for(int k = 0; here.size == 3 && k < 2; ++k)
    {
      Polygon part{{a, b, c}, 3};
      for(const Index other : here)
        if(other != here.labels[k])
          part.cut(centre[here.labels[k]], centre[other]);
      Mass inside;
      for(int i = 2; i < part.size; ++i)
        inside.add(part.points[0], part.points[i - 1], part.points[i], square * square);
      mass[here.labels[k]].add(inside, 1.);
      rest.add(inside, -1.);
    }
    // What is left by rounding has no centre.
    if(here.size > 0 && rest.mass > 1e-12 * whole)
      mass[here.labels[here.size - 1]].add(rest, 1.);
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
  for(Index i = 0; i < samples.size(); ++i)
    if(mass[i].mass > 0.)
    {
      result[i] = nearest_from(t, labels, i, triangle_at(t, samples[i]), centre[i], slowness);
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
