// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include "distances/circular_front.h"
#include "distances/front_relaxation.h"
#include "numerics/simd.h"

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

// The triangles of a cloud have no twins. Directions are stored in the tangent planes of the
// surfels and rotated into the plane of each triangle.

namespace {

// Applies to a vector perpendicular to the unit vector `from` the smallest rotation that takes
// `from` to the line of the unit vector `to`. This unfolds across a sharp edge, where a projection
// would turn the vector towards the edge.
Vec3 rotated_between(const Vec3& v, const Vec3& from, const Vec3& to)
{
  const double cosine = dot(from, to);
  const Vec3 axis = cosine < 0. ? -1. * to : to;
  return v - (dot(v, axis) / (1. + std::abs(cosine))) * (from + axis);
}

// The plane of the triangle (from, along, target): `from` is the origin and `along` is on the first
// axis.
struct Triangle_frame
{
  double base; // length of the edge from `from` to `along`
  Vec2 target;
  Vec3 axis_1, axis_2, normal;
  Vec2 source; // projection of the direction to the source, after unfolding

  bool is_degenerate() const { return !(base > 0. && target[1] > 0.); }
};

// Most surfels have at most 8 triangles, each with two choices of `along`.
constexpr std::size_t max_frames = 16;

template <typename Number>
struct Vector
{
  Number x, y, z;
};

// The frames of several triangles, as arrays for SIMD.
struct Triangle_frames
{
  template <std::size_t N>
  using Coordinates = std::array<std::array<double, max_frames>, N>;

  Coordinates<3> along, target; // vectors from `from`; input
  std::array<double, max_frames> base;
  Coordinates<2> planar_target, source;
  Coordinates<3> axis_1, axis_2, normal;

  void set_triangle(std::size_t i, const Vec3& to_along, const Vec3& to_target)
  {
    for(std::size_t k = 0; k < 3; ++k)
    {
      along[k][i] = to_along[k];
      target[k][i] = to_target[k];
    }
  }
  Triangle_frame operator[](std::size_t i) const
  {
    return {base[i],
            {planar_target[0][i], planar_target[1][i]},
            {axis_1[0][i], axis_1[1][i], axis_1[2][i]},
            {axis_2[0][i], axis_2[1][i], axis_2[2][i]},
            {normal[0][i], normal[1][i], normal[2][i]},
            {source[0][i], source[1][i]}};
  }
};

template <typename Pack>
GEODESIC_PROCESSING_INLINE Vector<Pack> load_vector(const Triangle_frames::Coordinates<3>& from,
                                                    std::size_t i)
{
  Vector<Pack> result;
  load(from[0].data() + i, result.x);
  load(from[1].data() + i, result.y);
  load(from[2].data() + i, result.z);
  return result;
}
template <typename Pack>
GEODESIC_PROCESSING_INLINE void store_vector(const Vector<Pack>& v,
                                             Triangle_frames::Coordinates<3>& to, std::size_t i)
{
  store(v.x, to[0].data() + i);
  store(v.y, to[1].data() + i);
  store(v.z, to[2].data() + i);
}

// Results of packs are parameters, because registers of AVX cannot be returned without AVX.
template <typename P, typename Q, typename Pack>
GEODESIC_PROCESSING_INLINE void multiply(const Vector<P>& p, const Vector<Q>& q, Pack& product)
{
  product = p.x * q.x + p.y * q.y + p.z * q.z;
}

template <typename Pack>
GEODESIC_PROCESSING_INLINE void compute_length(const Vector<Pack>& v, Pack& length)
{
  multiply(v, v, length);
  double values[sizeof(Pack) / sizeof(double)];
  store(length, values);
  for(double& value : values)
    value = std::sqrt(value);
  load(values, length);
}

// Computes the first `size` frames, with the operations of the functions on Vec3.
//
// n       the normal at `from`
// source  the direction in space to the source
template <typename Pack>
GEODESIC_PROCESSING_INLINE void compute_frames(const Vec3& n, const Vec3& source, std::size_t size,
                                               Triangle_frames& frames)
{
  const Vector<double> from = {n[0], n[1], n[2]}, v = {source[0], source[1], source[2]};
  for(std::size_t i = 0; i < size; i += sizeof(Pack) / sizeof(double))
  {
    const Vector<Pack> edge = load_vector<Pack>(frames.along, i),
                       target = load_vector<Pack>(frames.target, i);
    Pack base, y_0, y_1, cosine, along_axis, source_0, source_1;
    compute_length(edge, base);
    const Pack inverse_base = 1. / base;
    const Vector<Pack> axis_1 = {inverse_base * edge.x, inverse_base * edge.y,
                                 inverse_base * edge.z};
    multiply(target, axis_1, y_0);
    const Vector<Pack> perpendicular = {target.x - y_0 * axis_1.x, target.y - y_0 * axis_1.y,
                                        target.z - y_0 * axis_1.z};
    compute_length(perpendicular, y_1);
    const Pack inverse_y_1 = 1. / y_1;
    const Vector<Pack> axis_2 = {inverse_y_1 * perpendicular.x, inverse_y_1 * perpendicular.y,
                                 inverse_y_1 * perpendicular.z};
    const Vector<Pack> normal = {axis_1.y * axis_2.z - axis_1.z * axis_2.y,
                                 axis_1.z * axis_2.x - axis_1.x * axis_2.z,
                                 axis_1.x * axis_2.y - axis_1.y * axis_2.x};
    // rotated_between(source, n, normal)
    multiply(from, normal, cosine);
    const Pack sign = cosine < 0. ? Pack() - 1. : Pack() + 1.;
    const Vector<Pack> axis = {sign * normal.x, sign * normal.y, sign * normal.z};
    multiply(v, axis, along_axis);
    const Pack factor = along_axis / (1. + sign * cosine);
    const Vector<Pack> unfolded = {v.x - factor * (from.x + axis.x),
                                   v.y - factor * (from.y + axis.y),
                                   v.z - factor * (from.z + axis.z)};
    multiply(unfolded, axis_1, source_0);
    multiply(unfolded, axis_2, source_1);
    store(base, frames.base.data() + i);
    store(y_0, frames.planar_target[0].data() + i);
    store(y_1, frames.planar_target[1].data() + i);
    store(source_0, frames.source[0].data() + i);
    store(source_1, frames.source[1].data() + i);
    store_vector(axis_1, frames.axis_1, i);
    store_vector(axis_2, frames.axis_2, i);
    store_vector(normal, frames.normal, i);
  }
}

void compute_frames_baseline(const Vec3& n, const Vec3& source, std::size_t size,
                             Triangle_frames& frames)
{
  compute_frames<Baseline_pack<double>>(n, source, size, frames);
}
GEODESIC_PROCESSING_TARGET_AVX2
void compute_frames_avx2(const Vec3& n, const Vec3& source, std::size_t size,
                         Triangle_frames& frames)
{
  compute_frames<Avx2_pack<double>>(n, source, size, frames);
}

const auto dispatched_compute_frames = has_avx2() ? compute_frames_avx2 : compute_frames_baseline;

// Computes the circular front at `from` in the plane of a triangle. If `from` is tentative, the
// direction to the source is fitted to the distances of both ends of the edge. Returns false if
// there is no such front.
bool front_in_triangle(const Front_state& front, Index from, Index along,
                       const Triangle_frame& frame, Circular_front& circle)
{
  const Front_vertex& x = front.vertices[from];
  const Front_vertex& z = front.vertices[along];
  const bool is_same = front.have_same_source(from, along);
  const double difference = z.distance - x.distance;
  circle.curvature =
      (x.state | z.state) & straight_flag ? 0. : 1. / (x.distance - front.offset_at(from));
  if(x.state & tentative_flag)
    return is_same && fit_source_direction(frame.base, difference, circle);
  const double size = norm(frame.source);
  if(size == 0. || frame.source[1] > 0.)
    return false;
  circle.source = (1. / size) * frame.source;
  if(is_same)
    circle.curvature = fitted_curvature(circle.curvature, frame.base, difference, circle.source[0],
                                        x.distance - front.offset_at(from));
  return true;
}

// Relaxes `target` by the circular front that passes `from` and crosses the edge from `from` to
// `along`.
void update_on_cloud(Front_state& front, Index from, Index along, Index target,
                     const Triangle_frames& frames, std::size_t i)
{
  const Surface_arrays& t = *front.triangles;
  const Front_vertex& x = front.vertices[from];
  const Front_vertex& z = front.vertices[along];
  const bool is_tentative = (z.state & (tentative_flag | final_flag)) == tentative_flag;
  if(!(z.distance < infinity) || is_tentative)
    return;
  const Triangle_frame frame = frames[i];
  Circular_front circle;
  if(frame.is_degenerate() || !front_in_triangle(front, from, along, frame, circle))
    return;
  double gain;
  Vec2 backward;
  if(!cross_edge(circle, frame.base, frame.target, gain, backward))
    return;
  const double distance = x.distance + gain;
  // A predecessor is closer to the source than the target. Otherwise two vertices could be the
  // predecessors of each other.
  const bool is_from_closer = x.distance < distance;
  const bool is_along_closer = front.have_same_source(from, along) && z.distance < distance;
  if(!(distance < front.vertices[target].distance) || !(is_from_closer || is_along_closer))
    return;
  const double y_0 = frame.target[0];
  const bool is_along_predecessor =
      is_along_closer && (!is_from_closer || std::abs(y_0) >= std::abs(frame.base - y_0));
  const Vec3 direction = rotated_between(backward[0] * frame.axis_1 + backward[1] * frame.axis_2,
                                         frame.normal, t.normal[target]);
  relax(front, target,
        {distance, tangent_coordinates(front, target, direction),
         is_along_predecessor ? along : from, (x.state | z.state) & straight_flag, 0.},
        front.sources[from]);
}

// Relaxes a surfel with the length of the edge from `v`.
void relax_cloud_edge(Front_state& front, Index v, const Front_vertex& from, Index target,
                      double length)
{
  const Surface_arrays& t = *front.triangles;
  const double distance = from.distance + length;
  const Front_vertex& to = front.vertices[target];
  // The same distance replaces a tentative one only. Each edge of two triangles is relaxed twice.
  if(!(distance < to.distance || (distance == to.distance && to.state & tentative_flag)))
    return;
  const Vec3 backward = t.point[v] - t.point[target];
  // The length of an edge alone determines no direction: the target is tentative.
  const Index straight = from.state & straight_flag;
  Index flags = from.state & source_flag && !straight ? 0 : tentative_flag | straight;
  // A copy of the surfel has the same position.
  if(length == 0.)
    flags = from.state & arrival_flags;
  relax(front, target,
        {distance, tangent_coordinates(front, target, backward), v, flags,
         flags & tentative_flag ? length : 0.},
        front.sources[v]);
}

} // namespace

Vec2 tangent_coordinates(const Front_state& front, Index vertex, const Vec3& direction)
{
  const auto [axis_1, axis_2] = tangent_frame(front.triangles->normal[vertex]);
  const Vec2 result = {dot(direction, axis_1), dot(direction, axis_2)};
  const double size = norm(result);
  return size > 0. ? (1. / size) * result : Vec2{1., 0.};
}

void propagate_on_cloud(Front_state& front, Index v)
{
  const Surface_arrays& t = *front.triangles;
  const Front_vertex from = front.vertices[v];
  const auto [axis_1, axis_2] = tangent_frame(t.normal[v]);
  const Vec3 source = front.directions[v][0] * axis_1 + front.directions[v][1] * axis_2;
  // Edges of the proximity graph connect different components of triangles only. Inside a
  // component, these longer edges would arrive before the front through the triangles.
  const Proximity_graph& edges = *front.component_edges;
  if(!edges.begin.empty())
    for(Index i = edges.begin[v]; i < edges.begin[v + 1]; ++i)
      relax_cloud_edge(front, v, from, edges.target[i],
                       norm(t.point[v] - t.point[edges.target[i]]));
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
  {
    const Index corner = t.ring[i], previous_corner = previous_halfedge(corner);
    relax_cloud_edge(front, v, from, t.corner[next_halfedge(corner)], t.length[corner]);
    relax_cloud_edge(front, v, from, t.corner[previous_corner], t.length[previous_corner]);
  }
  if(from.state & source_flag)
    return;
  Triangle_frames frames;
  constexpr Index chunk_size = max_frames / 2;
  for(Index chunk = t.ring_begin[v]; chunk < t.ring_begin[v + 1]; chunk += chunk_size)
  {
    const Index size = std::min(chunk_size, t.ring_begin[v + 1] - chunk);
    for(Index i = 0; i < size; ++i)
    {
      const Index corner = t.ring[chunk + i];
      const Vec3 a = t.point[t.corner[next_halfedge(corner)]] - t.point[v],
                 b = t.point[t.corner[previous_halfedge(corner)]] - t.point[v];
      frames.set_triangle(2 * i, a, b);
      frames.set_triangle(2 * i + 1, b, a);
    }
    dispatched_compute_frames(t.normal[v], source, 2 * size, frames);
    for(Index i = 0; i < size; ++i)
    {
      const Index corner = t.ring[chunk + i], a = t.corner[next_halfedge(corner)],
                  b = t.corner[previous_halfedge(corner)];
      update_on_cloud(front, v, a, b, frames, 2 * i);
      update_on_cloud(front, v, b, a, frames, 2 * i + 1);
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal
