// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/trace_on_surface.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/paths/path_curve.h>

#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A step is halved if the normal changes by more than the first angle, and crosses a sharp edge if
// it still changes by more than the second one, which is that of insert_sharp_edges().
constexpr double smooth_step_cosine = 0.96592582628906829 /* 15 degrees */,
                 sharp_step_cosine = 0.76604444311897804 /* 40 degrees */;
constexpr int max_halvings = 3;

// Normals that differ by more than this angle have opposite orientations. Adjacent surfels differ
// by at most 100 degrees.
constexpr double opposite_normal_cosine = -0.5;

// Each iteration reduces the error of the collocation by a factor of order h. The predictor has an
// error of order h^3.
constexpr int number_of_collocation_iterations = 2;

// A point of the collocation is off the surface if its projection displaces it along the tangent
// plane by more than this fraction of the step. On smooth surfaces the displacement is of order
// h^5.
constexpr double tangential_displacement_ratio = 0.1;
// The same for steps over holes and bad fits. At the boundary the ratio is one, unless the path is
// nearly parallel to it.
constexpr double max_displacement_ratio = 0.5;

// The lengths of steps over a hole or a bad fit, relative to the maximum length of a step. On
// random samples of a sphere, 10 % of the paths of length 30 end in front of a hole with ratios up
// to 2, and 1 % with ratios up to 4. The walk to the nearest surfel excludes gaps that no edge of
// the graph crosses.
constexpr double hole_step_ratios[] = {0.5, 1., 1.5, 2., 2.5, 3., 4.};

constexpr int number_of_bisections = 30, max_length_corrections = 4;

// A point of the curve and its unit tangent.
struct Curve_state
{
  Projection at;
  Vec3 tangent;
};

struct Curve_step
{
  Curve_state end;
  double length = 0.; // of the smooth curve
  bool is_on_surface = false;
};

// Returns the parallel transport of a tangent from one normal to another. `integral` is any
// multiple of the integral of the normals between them. If it is their sum, the rotation is the
// smallest one.
Vec3 parallel_transport(const Vec3& tangent, const Vec3& from_normal, const Vec3& to_normal,
                        const Vec3& integral)
{
  const auto reflected = [](const Vec3& vector, const Vec3& axis)
  {
    const double square = dot(axis, axis);
    return square > 0. ? vector - 2. * dot(axis, vector) / square * axis : vector;
  };
  const Vec3 second_axis = to_normal - reflected(from_normal, integral);
  const Vec3 result = reflected(reflected(tangent, integral), second_axis);
  return unit(result - dot(result, to_normal) * to_normal);
}

class Curve_tracer
{
public:
  explicit Curve_tracer(const Path_surface& surface) : m_surface(surface) {}

  // Advances by a length, which is reduced if the normal changes too much.
  Curve_step advance(const Curve_state& from, double& length) const
  {
    for(int i = 0;; ++i)
    {
      const Projection end = project(from, from.at.point + length * from.tangent, from.at.vertex),
                       middle =
                           project(from, from.at.point + 0.5 * length * from.tangent, end.vertex);
      const double end_cosine = dot(from.at.normal, end.normal),
                   middle_cosine = dot(from.at.normal, middle.normal);
      if(i < max_halvings &&
         !(end_cosine > smooth_step_cosine && middle_cosine > smooth_step_cosine))
      {
        length *= 0.5;
        continue;
      }
      if(!(middle_cosine > sharp_step_cosine))
        return unfold_sharp_edge(from, middle, length);
      if(!(end_cosine > sharp_step_cosine))
        return unfold_sharp_edge(from, end, length);
      return collocate(from, middle, end, length);
    }
  }

  // Advances over a hole or a bad fit, by the trapezoidal rule. It needs no point in the middle.
  Curve_step cross_hole(const Curve_state& from, double length) const
  {
    Vec3 query = from.at.point + length * from.tangent;
    Curve_step step;
    for(int i = 0;; ++i)
    {
      step.end.at = project(from, query, from.at.vertex);
      if(!(dot(from.at.normal, step.end.at.normal) > 0.))
        return step;
      step.end.tangent = parallel_transport(from.tangent, from.at.normal, step.end.at.normal,
                                            from.at.normal + step.end.at.normal);
      if(i == number_of_collocation_iterations)
        break;
      query = from.at.point + 0.5 * length * (from.tangent + step.end.tangent);
    }
    step.length = arc_length(from.at, step.end.at);
    step.is_on_surface = is_on_surface(query, step.end.at, max_displacement_ratio * length) &&
                         has_progress(step, length);
    return step;
  }

private:
  // Projects a point; the normal has the orientation of that at `from`.
  Projection project(const Curve_state& from, const Vec3& point, Index vertex) const
  {
    Projection result = m_surface.project(point, vertex);
    if(dot(result.normal, from.at.normal) < opposite_normal_cosine)
      result.normal = -1. * result.normal;
    return result;
  }

  bool is_covered(const Projection& projection) const
  {
    return projection.conormal == Vec3{0., 0., 0.} &&
           m_surface.clamped_to_coverage(projection.point, projection.vertex) == projection.point;
  }
  bool is_on_surface(const Vec3& query, const Projection& projection, double max_displacement) const
  {
    const Vec3 offset = query - projection.point;
    const Vec3 displacement = offset - dot(offset, projection.normal) * projection.normal;
    return norm(displacement) <= max_displacement && is_covered(projection);
  }
  // Returns false if the step does not advance, or if it is not finite.
  static bool has_progress(const Curve_step& step, double length)
  {
    return step.length > 0.1 * length && step.length < 10. * length;
  }

  Curve_step collocate(const Curve_state& from, Projection middle, Projection end,
                       double length) const
  {
    const Vec3 &x = from.at.point, &n = from.at.normal, &t = from.tangent;
    Vec3 middle_tangent, end_tangent, middle_query, end_query;
    // The weights are the integrals of the quadratic polynomials through three values.
    const auto transport = [&]
    {
      middle_tangent =
          parallel_transport(t, n, middle.normal, 5. * n + 8. * middle.normal - 1. * end.normal);
      end_tangent = parallel_transport(t, n, end.normal, n + 4. * middle.normal + end.normal);
    };
    for(int i = 0; i < number_of_collocation_iterations; ++i)
    {
      transport();
      middle_query = x + length / 24. * (5. * t + 8. * middle_tangent - end_tangent);
      end_query = x + length / 6. * (t + 4. * middle_tangent + end_tangent);
      middle = project(from, middle_query, middle.vertex);
      end = project(from, end_query, end.vertex);
    }
    transport();
    Curve_step step;
    step.end = {end, end_tangent};
    step.length = arc_length(from.at, middle) + arc_length(middle, end);
    const double max_displacement = tangential_displacement_ratio * length;
    step.is_on_surface = is_on_surface(middle_query, middle, max_displacement) &&
                         is_on_surface(end_query, end, max_displacement) &&
                         has_progress(step, length);
    return step;
  }

  // Crosses the sharp edge between the tangent planes at the beginning and at a point ahead.
  Curve_step unfold_sharp_edge(const Curve_state& from, const Projection& ahead,
                               double length) const
  {
    const double slope = dot(from.tangent, ahead.normal);
    const double distance = dot(ahead.point - from.at.point, ahead.normal) / slope;
    const double length_before = distance > 0. ? std::fmin(distance, length) : 0.;
    const Vec3 edge_point = from.at.point + length_before * from.tangent;
    Curve_step step;
    step.end.tangent = parallel_transport(from.tangent, from.at.normal, ahead.normal,
                                          from.at.normal + ahead.normal);
    const Vec3 query = edge_point + (length - length_before) * step.end.tangent;
    step.end.at = m_surface.project(query, ahead.vertex);
    // Next to the edge, the projection can be on the plane before it.
    if(!(dot(step.end.at.normal, ahead.normal) > sharp_step_cosine))
      step.end.at = {query, ahead.normal, {0., 0., 0.}, ahead.vertex};
    else
      step.end.tangent = parallel_transport(step.end.tangent, ahead.normal, step.end.at.normal,
                                            ahead.normal + step.end.at.normal);
    step.length = length_before + norm(step.end.at.point - edge_point);
    step.is_on_surface = is_covered(step.end.at) && has_progress(step, length);
    return step;
  }

  const Path_surface& m_surface;
};

// Changes the parameter of a step such that the length of the smooth curve is closest to `length`.
// step_of(parameter) returns a step.
template <typename Step_of>
void correct_length(const Step_of& step_of, double parameter, double length, Curve_step& step)
{
  for(int i = 0; i < max_length_corrections && step.length != length; ++i)
  {
    parameter += length - step.length;
    if(!(parameter > 0.))
      break;
    const Curve_step next = step_of(parameter);
    if(!next.is_on_surface || !(std::abs(next.length - length) < std::abs(step.length - length)))
      break;
    step = next;
  }
}

// Returns a step over a hole of the surface or a bad fit. If there is none, the result is not on
// the surface.
Curve_step step_over_hole(const Curve_tracer& tracer, const Curve_state& from, double length,
                          double max_length)
{
  Curve_step step;
  for(const double ratio : hole_step_ratios)
  {
    const double parameter = std::fmin(ratio * length, max_length);
    step = tracer.cross_hole(from, parameter);
    if(step.is_on_surface && step.length > max_length)
      correct_length([&](double p) { return tracer.cross_hole(from, p); }, parameter, max_length,
                     step);
    if(step.is_on_surface || parameter == max_length)
      break;
  }
  return step;
}

// Returns the step to the boundary, which is closer than `length`.
Curve_step step_to_boundary(const Curve_tracer& tracer, const Curve_state& from, double length)
{
  Curve_step result;
  double min_length = 0., max_length = length;
  for(int i = 0; i < number_of_bisections; ++i)
  {
    const double middle = 0.5 * (min_length + max_length);
    double reduced_length = middle;
    const Curve_step step = tracer.advance(from, reduced_length);
    if(step.is_on_surface)
    {
      result = step;
      min_length = reduced_length;
    }
    else
      max_length = reduced_length;
    if(!(min_length < max_length))
      break;
  }
  return result;
}

} // namespace

Traced_curve trace_on_surface(const Path_surface& surface,
                              const std::function<double(Index)>& max_step, const Projection& from,
                              const Vec3& direction, double length)
{
  if(!(length >= 0.) || !std::isfinite(length))
    throw Invalid_argument_error("The length of a path is negative or not finite.");
  // The square of a long or short direction overflows or underflows.
  const double size =
      std::fmax(std::abs(direction[0]), std::fmax(std::abs(direction[1]), std::abs(direction[2])));
  const Vec3 scaled = {direction[0] / size, direction[1] / size, direction[2] / size};
  const Vec3 tangent = scaled - dot(scaled, from.normal) * from.normal;
  // The projection of a normal vector consists of round-off errors.
  if(!(norm(tangent) > 1e-12))
    throw Invalid_argument_error("A direction is zero, not finite, or normal to the surface.");

  const Curve_tracer tracer(surface);
  Curve_state state = {from, unit(tangent)};
  Traced_curve curve;
  curve.points.push_back(from);
  for(double remaining = length; remaining > 1e-12 * length; remaining = length - curve.length)
  {
    // Equal steps avoid a very short last one.
    double step_length = remaining / std::ceil(remaining / max_step(state.at.vertex));
    Curve_step step = tracer.advance(state, step_length);
    if(step.is_on_surface && step_length == remaining)
      correct_length([&](double parameter) { return tracer.advance(state, parameter); }, remaining,
                     remaining, step);
    if(!step.is_on_surface)
      step = step_over_hole(tracer, state, max_step(state.at.vertex), remaining);
    if(!step.is_on_surface)
    {
      curve.is_cut_by_boundary = true;
      step = step_to_boundary(tracer, state, step_length);
    }
    if(step.is_on_surface)
    {
      state = step.end;
      curve.points.push_back(state.at);
      curve.length += step.length;
    }
    if(curve.is_cut_by_boundary)
      break;
  }
  curve.end_direction = state.tangent;
  return curve;
}

} // namespace CGAL::Geodesic_processing::internal
