// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/centroids.h>

#include <CGAL/Geodesic_processing/internal/path_locations.h>
#include <CGAL/Geodesic_processing/internal/walk.h>

#include <algorithm>
#include <array>

namespace CGAL::Geodesic_processing::internal {

namespace {

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
      result.add(points[0], points[i - 1], points[i], density);
    return result;
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

// What three samples have of a triangle each, where every corner is nearest to its own one and they
// meet inside: three quadrangles about that place.  In coordinates of the triangle, with corner k as
// the origin.  False where it is otherwise.
bool three_parts(const std::array<Spatial, 3>& corners, double whole,
                 const std::array<Spatial, 3>& centres, std::array<Mass, 3>& parts)
{
  // Squared distances to the first sample less those to the second and to the third one.
  std::array<double, 3> second, third;
  const Spatial to_second = centres[1] - centres[0], to_third = centres[2] - centres[0];
  const Spatial middle_second = 0.5 * (centres[0] + centres[1]),
                middle_third = 0.5 * (centres[0] + centres[2]);
  for(int k = 0; k < 3; ++k)
  {
    second[k] = dot(corners[k] - middle_second, to_second);
    third[k] = dot(corners[k] - middle_third, to_third);
  }
  if(!(second[0] < 0. && third[0] < 0. && second[1] > 0. && second[1] > third[1] && third[2] > 0. &&
       third[2] > second[2]))
    return false;
  const Spatial meeting = cross(second, third);
  const double sum = meeting[0] + meeting[1] + meeting[2];
  const std::array<double, 3> place = {meeting[0] / sum, meeting[1] / sum, meeting[2] / sum};
  if(!(place[0] > 0. && place[1] > 0. && place[2] > 0.))
    return false;
  // How far along each side two meet, and that the other one is farther there.
  const double from_second = second[1] - third[1], from_third = third[2] - second[2];
  const std::array<double, 3> share = {second[0] / (second[0] - second[1]),
                                       from_second / (from_second + from_third),
                                       third[2] / (third[2] - third[0])};
  if(!(third[0] + share[0] * (third[1] - third[0]) < 0. &&
       second[1] + share[1] * (second[2] - second[1]) > 0. &&
       second[2] + share[2] * (second[0] - second[2]) < 0.))
    return false;
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3, previous = (k + 2) % 3;
    const double along = share[k], back = 1. - share[previous];
    const double first = along * place[previous], last = back * place[next];
    const double to_next = (first * (along + place[next]) + last * place[next]) / 3.,
                 to_previous = (first * place[previous] + last * (place[previous] + back)) / 3.;
    parts[k].mass = whole * (first + last);
    parts[k].moment = whole * ((first + last - to_next - to_previous) * corners[k] +
                               to_next * corners[next] + to_previous * corners[previous]);
  }
  return true;
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
    if(here.size == 0)
      continue;
    // The last one has what the others leave.
    Mass rest = {masses[f], (masses[f] / 3.) * (a + b + c)};
    if(here.size == 2)
    {
      const Mass first =
          nearer_part({a, b, c}, rest, centre[here.labels[0]], centre[here.labels[1]]);
      mass[here.labels[0]].add(first, 1.);
      rest.add(first, -1.);
    }
    else if(here.size == 3)
    {
      std::array<Mass, 3> parts;
      if(!three_parts({a, b, c}, masses[f],
                      {centre[here.labels[0]], centre[here.labels[1]], centre[here.labels[2]]},
                      parts))
        for(int k = 0; k < 2; ++k)
        {
          Polygon part{{a, b, c}, 3};
          for(const Index other : here)
            if(other != here.labels[k])
              part.cut(centre[here.labels[k]], centre[other]);
          parts[k] = part.mass(masses[f] / norm(cross(b - a, c - a)));
        }
      for(int k = 0; k < 2; ++k)
      {
        mass[here.labels[k]].add(parts[k], 1.);
        rest.add(parts[k], -1.);
      }
    }
    // What is left by rounding has no centre.
    if(rest.mass > 1e-12 * masses[f])
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
