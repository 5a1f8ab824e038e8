// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/centroids.h>

#include <CGAL/Geodesic_processing/internal/path_locations.h>
#include <CGAL/Geodesic_processing/internal/spatial.h>

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
};

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

} // namespace

std::vector<Location> centroids(const Glued_triangles& t, const std::vector<Index>& labels,
                                const std::vector<Location>& samples,
                                const std::vector<double>* slowness, double way)
{
  std::vector<Spatial> centre;
  for(const Location& sample : samples)
    centre.push_back(scaled_coordinates(t, sample));
  std::vector<Mass> mass(samples.size());
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    const double square = slowness ? (*slowness)[f] * (*slowness)[f] : 1.;
    const Labels here(corner, labels);
    for(const Index label : here)
    {
      Polygon part{{a, b, c}, 3};
      for(const Index other : here)
        if(other != label)
          part.cut(centre[label], centre[other]);
      for(int i = 2; i < part.size; ++i)
        mass[label].add(part.points[0], part.points[i - 1], part.points[i], square * square);
    }
  }
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(mass[i].mass > 0.)
      centre[i] = (1. - way) * centre[i] + (way / mass[i].mass) * mass[i].moment;

  std::vector<Location> result = samples;
  std::vector<double> least(samples.size(), infinity);
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    if(norm(cross(b - a, c - a)) == 0.)
      continue;
    for(const Index label : Labels(corner, labels))
    {
      if(!(mass[label].mass > 0.))
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
