// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sequences of queries of transport solvers on small meshes and clouds.
#include "fuzz_library.h"

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Region_transport_solver.h>
#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/Transport_barycenter_solver.h>
#include <CGAL/Geodesic_processing/Transport_metric.h>

#include <CGAL/property_map.h>

#include <exception>
#include <iterator>
#include <optional>
#include <thread>
#include <type_traits>

namespace {

using namespace fuzz;

// Masses at vertices whose total is the same on each connected component.
struct Masses
{
  std::vector<double> from, to;
  double moved = 0.; // at most this mass
};

template <typename Surface>
class Test
{
  static constexpr bool is_mesh = std::is_same_v<Surface, Mesh>;

public:
  using Domain = typename GP::Geodesic_distance_solver<Surface>::Domain;
  using Vertex = typename Domain::Vertex;
  using Location = GP::Location<Surface>;
  using Solver = GP::Earth_movers_solver<Surface>;

  Test(Bytes& in, const Domain& domain, const Surface& surface)
      : m_in(in), m_domain(domain), m_surface(surface), m_scale(scale_of(surface)),
        m_connected(domain)
  {}

  void run()
  {
    switch(m_in.below(4))
    {
    case 0:
      test_solver();
      break;
    case 1:
      test_metric();
      break;
    case 2:
      test_barycenter();
      break;
    case 3:
      test_region();
      break;
    }
  }

private:
  // Round-off errors of sums of products of lengths and masses.
  double tolerance(double cost, double mass = 1.) const
  {
    return 1e-7 * (mass * m_scale.diameter + std::abs(cost)) + 1e-14 * mass * m_scale.magnitude;
  }

  // Returns a vertex in the connected component of another one.
  Vertex random_connected(Vertex v)
  {
    m_connected.compute(v);
    const std::vector<Vertex> reached = m_connected.reached();
    const std::size_t i = m_in.below(reached.size());
    trace("  connected vertex", reached[i]);
    return reached[i];
  }

  double exact_distance(const Vertex& from, const Vertex& to) const
  {
    GP::Geodesic_distance_solver<Surface> solver(m_domain);
    solver.compute(from);
    return solver.distance(to);
  }

  Masses random_masses()
  {
    Masses masses;
    masses.from.assign(size_of(m_surface), 0.);
    masses.to = masses.from;
    for(std::size_t number = 1 + m_in.below(3); number > 0; --number)
    {
      const double mass = m_in.one_of({1., 2., 0.5, 0.25, 3.});
      trace("  mass", mass);
      const Vertex from = random_vertex(m_in, m_surface), to = random_connected(from);
      masses.from[from] += mass;
      masses.to[to] += mass;
      masses.moved += mass;
    }
    return masses;
  }

  void check_cost(const GP::Earth_movers_cost& cost, double mass) const
  {
    trace("  cost", cost.lower, cost.upper, cost.number_of_iterations, cost.residual);
    const double epsilon = tolerance(cost.upper, mass);
    require(std::isfinite(cost.lower) && std::isfinite(cost.upper), "bounds are finite");
    require_at_most(0., cost.lower, epsilon, "lower bounds are not negative");
    require_at_most(cost.lower, cost.upper, epsilon, "the lower bound is below the upper bound");
    require_at_most(cost.lower, cost.upper_continuous, epsilon,
                    "the lower bound is below all costs");
    require_near(cost.value, 0.5 * (cost.lower + cost.upper), epsilon, "the value is the mean");
    require(cost.residual >= 0., "a residual is not negative");
    if(cost.is_converged)
      require_at_most(cost.upper - cost.lower, 0.001 * cost.upper, epsilon,
                      "the gap of a converged solver is within the tolerance");
  }

  std::vector<double> potential(const GP::Transport_solution<Surface>& solution) const
  {
    std::vector<double> result(size_of(m_surface), 0.);
    solution.write_potential(CGAL::make_property_map(result));
    return result;
  }

  // The slope of the potential is at most one, and its integral is the lower bound.
  void check_potential(const Solver& solver, const GP::Earth_movers_cost& cost,
                       const Masses& masses) const
  {
    const std::vector<double> values = potential(solver);
    double integral = 0.;
    for(std::size_t i = 0; i < values.size(); ++i)
    {
      require(std::isfinite(values[i]), "potentials are finite");
      integral += values[i] * (masses.to[i] - masses.from[i]);
    }
    require_at_most(integral, cost.upper, tolerance(cost.upper, masses.moved),
                    "the integral of the potential is a lower bound");
    if constexpr(is_mesh)
      for(const auto e : m_surface.edges())
      {
        const auto h = halfedge(e, m_surface);
        const Vertex a = source(h, m_surface), b = target(h, m_surface);
        require_at_most(std::abs(values[a] - values[b]),
                        length_of(m_surface.point(a) - m_surface.point(b)), tolerance(values[a]),
                        "the slope of the potential is at most one");
      }
  }

  std::vector<double> likelihood(const Solver& solver) const
  {
    std::vector<double> result(size_of(m_surface), 0.);
    solver.write_likelihood(CGAL::make_property_map(result));
    for(const double value : result)
      require(value >= 0. && value <= 1., "likelihoods are in [0, 1]");
    return result;
  }

  template <typename From, typename To, typename NamedParameters>
  GP::Earth_movers_cost cost(Solver& solver, const From& from, const To& to,
                             const NamedParameters& np)
  {
    switch(m_in.below(4))
    {
    case 0:
      return solver.template compute<GP::Alternating_directions>(
          from, to, np.maximum_number_of_iterations(200u));
    case 1:
      return solver.template compute<GP::Weiszfeld>(from, to, np.maximum_number_of_iterations(20u));
    default:
      return solver.compute(from, to, np);
    }
  }

  void test_solver()
  {
    std::optional<Solver> solver;
    const unsigned refinements = unsigned(m_in.below(2));
    trace("solver", refinements);
    if(!accepts([&]
                { solver.emplace(m_domain, GP::parameters::number_of_refinements(refinements)); }))
      return;
    for(int step = 0; step < 4 && (step == 0 || !m_in.empty()); ++step)
      switch(m_in.below(5))
      {
      case 0:
        test_pair(*solver);
        break;
      case 1:
        test_masses(*solver);
        break;
      case 2:
        test_errors(*solver);
        break;
      case 3:
        test_copies(*solver);
        break;
      case 4:
        test_tracer(*solver);
        break;
      }
  }

  // The cost between two vertices, and the distance on the surface.
  void test_pair(Solver& solver)
  {
    trace("pair");
    const Vertex from = random_vertex(m_in, m_surface), to = random_connected(from);
    const bool is_bounded = is_mesh && m_in.flag();
    GP::Earth_movers_cost there, back;
    if(!accepts(
           [&]
           {
             there = solver.compute(from, to, GP::parameters::do_bound_from_above(is_bounded));
             back = solver.compute(to, from);
           }))
      return;
    check_cost(there, 1.);
    check_cost(back, 1.);
    const double epsilon = tolerance(there.upper);
    require_at_most(there.lower, back.upper, epsilon, "the distance is symmetric");
    require_at_most(back.lower, there.upper, epsilon, "the distance is symmetric");
    if(from == to)
      require_near(there.upper, 0., epsilon, "the distance of a vertex to itself is zero");
    if constexpr(is_mesh)
    {
      const double distance = exact_distance(from, to);
      require_at_most(there.lower, distance, epsilon,
                      "lower bounds also hold for geodesic distances");
      if(is_bounded)
        require_at_most(distance, there.upper_continuous, epsilon,
                        "the bound for the surface is not below the distance");
    }
  }

  void test_masses(Solver& solver)
  {
    trace("masses");
    Masses masses = random_masses();
    const auto from = CGAL::make_property_map(masses.from), to = CGAL::make_property_map(masses.to);
    GP::Earth_movers_cost first;
    const bool does_start_from_last = m_in.flag();
    if(!accepts(
           [&] {
             first =
                 cost(solver, from, to, GP::parameters::do_start_from_last(does_start_from_last));
           }))
      return;
    check_cost(first, masses.moved);
    check_potential(solver, first, masses);
    likelihood(solver);
    if(m_in.flag())
      return;
    const std::vector<double> last = potential(solver);
    const bool is_stopped =
        is_canceled(m_in, [&](const Callback& callback)
                    { solver.compute(to, from, GP::parameters::callback(callback)); });
    if(is_stopped)
      require_equal(potential(solver), last, "after canceling the last results remain");
    // A query that does not start from the last one is reproducible.
    const GP::Earth_movers_cost second = solver.compute(from, to);
    const std::vector<double> potential_of_second = potential(solver);
    const GP::Earth_movers_cost third = solver.compute(from, to);
    require_equal({second.lower, second.upper}, {third.lower, third.upper},
                  "a query has the same result again");
    require_equal(potential_of_second, potential(solver), "a query has the same result again");
    check_cost(second, masses.moved);
    require_at_most(second.lower, first.upper, tolerance(first.upper, masses.moved),
                    "bounds of all methods are consistent");
    require_at_most(first.lower, second.upper, tolerance(first.upper, masses.moved),
                    "bounds of all methods are consistent");
  }

  void test_errors(Solver& solver)
  {
    trace("errors");
    Masses masses = random_masses();
    const auto from = CGAL::make_property_map(masses.from), to = CGAL::make_property_map(masses.to);
    switch(m_in.below(4))
    {
    case 0:
      masses.from[random_vertex(m_in, m_surface)] += 1.;
      require_refusal([&] { solver.compute(from, to); });
      break;
    case 1:
      masses.from[random_vertex(m_in, m_surface)] = infinity;
      require_refusal([&] { solver.compute(from, to); });
      break;
    case 2:
      require_refusal([&] { solver.compute(std::vector<Vertex>(), to); });
      break;
    case 3:
      require_refusal([&] { solver.compute(from, to, GP::parameters::tolerance(0.)); });
      break;
    }
  }

  void test_copies(Solver& solver)
  {
    trace("copies");
    Masses masses = random_masses();
    const auto from = CGAL::make_property_map(masses.from), to = CGAL::make_property_map(masses.to);
    if(!accepts([&] { solver.compute(from, to); }))
      return;
    const std::vector<double> expected = potential(solver);
    Solver copy(solver), other(solver);
    require_equal(potential(copy), expected, "a copy has the results");
    std::exception_ptr error;
    std::thread thread(
        [&]
        {
          try
          {
            copy.compute(from, to);
          }
          catch(...)
          {
            error = std::current_exception();
          }
        });
    try
    {
      other.compute(from, to);
    }
    catch(...)
    {
      thread.join();
      throw;
    }
    thread.join();
    if(error)
      std::rethrow_exception(error);
    require_equal(potential(copy), expected, "copies compute concurrently");
    require_equal(potential(other), expected, "copies compute concurrently");
    solver = std::move(copy);
    require_equal(potential(solver), expected, "an assigned solver has the results");
  }

  void test_tracer(Solver& solver)
  {
    trace("tracer");
    Masses masses = random_masses();
    const auto from = CGAL::make_property_map(masses.from), to = CGAL::make_property_map(masses.to);
    const bool does_straighten = m_in.flag();
    std::optional<GP::Streamline_tracer<Surface>> tracer;
    if(!accepts(
           [&]
           {
             solver.compute(from, to);
             tracer.emplace(solver.streamlines(GP::parameters::do_straighten(does_straighten)));
           }))
      return;
    std::vector<GP::Streamline<Surface>> lines;
    const std::size_t number = m_in.below(5);
    (*tracer)(number, std::back_inserter(lines));
    require(lines.empty() || lines.size() == number, "the number of streamlines is that requested");
    lines.push_back((*tracer)(random_vertex(m_in, m_surface)));
    if(has_locations(m_surface))
    {
      const Location location = random_location(m_in, m_surface);
      lines.push_back((*tracer)(location));
      require_valid(m_domain, tracer->destination(location));
    }
    for(const auto& line : lines)
    {
      require_valid_path(m_domain, line, tolerance(line.length));
      // The interpolated potential can be steeper inside faces.
      if(!line.empty() && is_at_vertex(line.locations.front()) &&
         is_at_vertex(line.locations.back()))
        require_at_most(line.front_distance, line.length, tolerance(line.length),
                        "no streamline is shorter than the increase of the potential");
    }
    std::vector<std::pair<Location, Location>> pairs;
    tracer->assignment(number, std::back_inserter(pairs));
    for(const auto& [start, end] : pairs)
    {
      require_valid(m_domain, start);
      require_valid(m_domain, end);
    }
  }

  void test_metric()
  {
    using Metric = GP::Transport_metric<Surface>;
    const std::size_t k = m_in.one_of<std::size_t>({0, 0, 1, 3, 6});
    const GP::Transport_flow flow =
        m_in.flag() ? GP::Transport_flow::balanced : GP::Transport_flow::gradient;
    trace("metric", k, flow == GP::Transport_flow::balanced);
    std::optional<Metric> metric;
    if(!accepts([&] { metric.emplace(m_domain, k, GP::parameters::transport_flow(flow)); }))
      return;
    require(metric->basis_size() >= k || metric->basis_size() + 8 >= size_of(m_surface) || k > 0,
            "the basis has as many functions as there are");
    for(int step = 0; step < 3 && (step == 0 || !m_in.empty()); ++step)
    {
      const Vertex a = random_vertex(m_in, m_surface), b = random_vertex(m_in, m_surface);
      m_connected.compute(a);
      const bool is_connected = m_connected.distance(b) < infinity;
      const GP::Earth_movers_cost there = metric->cost(a, b), back = metric->cost(b, a);
      require(!std::isnan(there.value), "a cost is a number");
      // A surfel at the point of another one has no triangles.
      if constexpr(is_mesh)
        require((there.value < infinity) == is_connected,
                "the distance is infinite between components only");
      // The flow of needles does not move all masses, and its cost does not contain the remaining
      // ones.
      if(has_needles(m_surface))
        continue;
      if(!is_connected)
        continue;
      check_cost(there, 1.);
      const double epsilon = tolerance(there.upper) + 1e-3 * there.upper * (k > 0 ? 1. : 0.);
      require_at_most(there.lower, back.upper, epsilon, "the distance is symmetric");
      require_at_most(back.lower, there.upper, epsilon, "the distance is symmetric");
      if(a == b)
        require_near(there.upper, 0., epsilon, "the distance of a vertex to itself is zero");
      require_equal({metric->distance(a, b)}, {there.value}, "a query has the same result again");
      std::vector<double> all(size_of(m_surface), 0.);
      const bool is_stopped =
          is_canceled(m_in,
                      [&](const Callback& callback) {
                        metric->write_distances(a, CGAL::make_property_map(all),
                                                GP::parameters::callback(callback));
                      });
      if(is_stopped)
        metric->write_distances(a, CGAL::make_property_map(all));
      if(k == 0)
        require_near(all[b], there.value, epsilon, "all distances are those of pairs");
      else
        require_at_most(there.lower, all[b], epsilon, "all distances are upper bounds");
      const auto matrix = metric->distance_matrix(std::vector<Vertex>{a, b});
      require(matrix(0, 1) == matrix(1, 0), "the matrix is symmetric");
      require_near(matrix(0, 1), there.value, epsilon, "the matrix has the distances of pairs");
    }
  }

  void test_barycenter()
  {
    using Barycenter = GP::Transport_barycenter_solver<Surface>;
    trace("barycenter");
    std::optional<Barycenter> solver;
    const unsigned refinements = unsigned(m_in.below(2));
    if(!accepts([&]
                { solver.emplace(m_domain, GP::parameters::number_of_refinements(refinements)); }))
      return;
    for(int step = 0; step < 2 && (step == 0 || !m_in.empty()); ++step)
    {
      std::vector<Vertex> vertices{random_vertex(m_in, m_surface)};
      for(std::size_t number = 1 + m_in.below(2); number > 0; --number)
        vertices.push_back(random_connected(vertices[0]));
      std::vector<double> weights;
      for(std::size_t i = 0; i < vertices.size(); ++i)
        weights.push_back(m_in.one_of({1., 2., 0.5, 0.}));
      weights[0] = 1.;
      GP::Transport_barycenter_cost cost;
      const auto np = GP::parameters::weights(weights).maximum_number_of_iterations(300u);
      if(m_in.flag())
        is_canceled(m_in, [&](const Callback& callback)
                    { cost = solver->compute(vertices, np.callback(callback)); });
      if(!accepts([&] { cost = solver->compute(vertices, np); }))
        continue;
      trace("  cost", cost.lower, cost.upper, cost.number_of_iterations, cost.residual);
      const double unit = m_scale.diameter * m_scale.diameter * double(vertices.size());
      const double epsilon = 1e-7 * (unit + cost.upper);
      require(std::isfinite(cost.lower) && std::isfinite(cost.upper), "bounds are finite");
      require_at_most(0., cost.lower, epsilon, "lower bounds are not negative");
      require_at_most(cost.lower, cost.upper, epsilon, "the lower bound is below the upper bound");
      require_near(cost.value, 0.5 * (cost.lower + cost.upper), epsilon, "the value is the mean");
      require(cost.distances.size() == vertices.size(), "each distribution has a distance");
      double sum_of_squares = 0.;
      for(std::size_t i = 0; i < vertices.size(); ++i)
        sum_of_squares += weights[i] * cost.distances[i] * cost.distances[i];
      require_near(sum_of_squares, cost.upper, epsilon,
                   "the cost is the weighted sum of squared distances");
      std::vector<double> masses(size_of(m_surface), 0.);
      solver->write_masses(CGAL::make_property_map(masses));
      double total = 0.;
      for(std::size_t i = 0; i < masses.size(); ++i)
      {
        require_at_most(-masses[i], 0., 1e-6 + cost.residual,
                        "masses of a barycenter are not negative");
        total += solver->mass(vertex_of(m_surface, i)) == masses[i] ? masses[i] : infinity;
      }
      if constexpr(!is_mesh)
        require_near(total, 1., 1e-6 + cost.residual,
                     "a barycenter has the mass of the distributions");
      const GP::Transport_barycenter_cost again = solver->compute(vertices, np);
      require_equal({cost.lower, cost.upper}, {again.lower, again.upper},
                    "a query has the same result again");
    }
  }

  void test_region()
  {
    trace("region");
    const Vertex from = random_vertex(m_in, m_surface), to = random_connected(from);
    std::vector<GP::Source<Surface>> region{to};
    if(has_locations(m_surface) && m_in.flag())
      region.push_back(random_location(m_in, m_surface));
    std::optional<GP::Region_transport_solver<Surface>> solver;
    GP::Earth_movers_cost cost;
    if(!accepts(
           [&]
           {
             solver.emplace(m_domain, region,
                            GP::parameters::number_of_refinements(unsigned(m_in.below(2))));
             cost = solver->compute(from);
           }))
      return;
    check_cost(cost, 1.);
    require(solver->is_reachable(from), "mass reaches the region");
    GP::Geodesic_distance_solver<Surface> exact(m_domain);
    exact.compute(region);
    if constexpr(is_mesh)
      require_at_most(cost.lower, exact.distance(from), tolerance(cost.upper),
                      "lower bounds also hold for geodesic distances");
    double arrived = 0.;
    for(std::size_t i = 0; i < size_of(m_surface); ++i)
      require(solver->arrival(vertex_of(m_surface, i)) >= 0., "arriving masses are not negative");
    if constexpr(!is_mesh)
    {
      for(std::size_t i = 0; i < size_of(m_surface); ++i)
        arrived += solver->arrival(vertex_of(m_surface, i));
      // On needles, a flow does not move all masses. The residual is the largest mass that is
      // missing at a vertex.
      require_near(arrived, 1., 1e-6 + double(size_of(m_surface)) * cost.residual,
                   "all mass arrives");
    }
    const std::vector<double> last = potential(*solver);
    if(is_canceled(m_in, [&](const Callback& callback)
                   { solver->compute(from, GP::parameters::callback(callback)); }))
      require_equal(potential(*solver), last, "after canceling the last results remain");
    solver->compute(from);
    require_equal(potential(*solver), last, "a query has the same result again");
  }

  Bytes& m_in;
  Domain m_domain;
  const Surface& m_surface;
  Scale m_scale;
  GP::Geodesic_distance_solver<Surface, GP::Dijkstra> m_connected;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes in(data, size);
  run_on_random_surface<Test>(
      in, 4, 20, 12, [](const Soup& soup) { return GP::make_domain(soup.points, soup.polygons); });
  return 0;
}
