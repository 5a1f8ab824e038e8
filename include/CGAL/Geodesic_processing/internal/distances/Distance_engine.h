// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_ENGINE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_ENGINE_H

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/distances/heat.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

template <typename Method>
inline constexpr bool is_front =
    std::is_same_v<Method, Dijkstra> || std::is_same_v<Method, Fast_marching> ||
    std::is_same_v<Method, Euclidean_front>;

// Whether a method never computes exact distances.
template <typename Method>
inline constexpr bool is_approximate = is_front<Method> || std::is_same_v<Method, Heat>;

// Returns the method that a tag stands for.
template <typename Method>
constexpr Distance_method distance_method()
{
  if constexpr(std::is_same_v<Method, Dijkstra>)
    return Distance_method::dijkstra;
  else if constexpr(std::is_same_v<Method, Fast_marching>)
    return Distance_method::fast_marching;
  else if constexpr(std::is_same_v<Method, Euclidean_front>)
    return Distance_method::euclidean_front;
  else if constexpr(std::is_same_v<Method, Exact>)
    return Distance_method::exact;
  else if constexpr(std::is_same_v<Method, Heat>)
    return Distance_method::heat;
  else
  {
    static_assert(
        std::is_same_v<Method, Automatic>,
        "The method must be Automatic, Exact, Euclidean_front, Fast_marching, Dijkstra or Heat.");
    return Distance_method::automatic;
  }
}

// Returns the kind of front of a tag for which is_front is true.
template <typename Method>
constexpr Front_kind front_kind()
{
  static_assert(is_front<Method>);
  return std::is_same_v<Method, Dijkstra>        ? Front_kind::dijkstra
         : std::is_same_v<Method, Fast_marching> ? Front_kind::planar
                                                 : Front_kind::euclidean;
}

// Returns the kind of front of a method; the Euclidean front if it is automatic. Throws
// Invalid_argument_error if the method is not a front.
CGAL_GEODESIC_PROCESSING_EXPORT Front_kind front_kind(Distance_method method);

// What computes the rows of a matrix; each thread has a copy.
using Row_engine = std::variant<const Front*, const Window_propagation*, const Heat_solver*>;

// Computes distances by a method that is chosen at run time. Adaptors that hold it are instantiated
// once for all methods. The dispatch is outside of the loops of the kernels.
class CGAL_GEODESIC_PROCESSING_EXPORT Distance_engine
{
public:
  // heat_time_step  as time_step of Heat_solver; empty for its default
  // callback        as that of Heat_solver; the other kernels do not call it
  //
  // Throws Unsupported_surface_error if there is a time step and the method is not heat, or if the
  // method is exact on a cloud.
  Distance_engine(Distance_method method, std::shared_ptr<const Surface_arrays> triangles,
                  std::optional<double> heat_time_step = {},
                  const std::function<bool(double)>& callback = {});

  // Selects the kernel that admits the speeds, if the method is automatic. run() calls it. Throws
  // Unsupported_surface_error if there is a relative tolerance and the kernel is not exact, or if
  // the kernel does not admit the speeds. Then the last result remains.
  void select(const Front_limits& limits);
  // As those of Front.
  bool run(const std::vector<Front_source>& sources, const Front_limits& limits = {});
  double distance(Index vertex) const;
  double distance(const Surface_location& location) const;
  std::vector<double> distances(const std::vector<Surface_location>& locations) const;
  Index source(Index vertex) const;
  Index predecessor(Index vertex) const;
  const std::vector<Index>& reached() const;
  // Returns the slowness of the last query, or null if it was the same everywhere.
  const std::vector<double>* slowness() const { return m_slowness.get(); }

  // Calls visitor(kernel) with the kernel of the method, so that a loop over all vertices has one
  // dispatch.
  template <typename Visitor>
  void visit(const Visitor& visitor) const
  {
    std::visit(visitor, m_kernel);
  }
  // Returns the exact kernel, or null if the last query used another one.
  const Window_propagation* windows() const { return std::get_if<Window_propagation>(&m_kernel); }
  // Returns the kernel for the rows of a matrix, which bypasses the dispatch. Requires select().
  Row_engine row_engine() const;

private:
  Distance_method m_method;
  std::shared_ptr<const Surface_arrays> m_triangles;
  std::variant<Front, Window_propagation, Heat_solver> m_kernel;
  std::shared_ptr<const std::vector<double>> m_slowness;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_ENGINE_H
