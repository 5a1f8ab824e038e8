// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/streamlines.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A streamline that crosses an edge or vertex more often is in a closed loop.
constexpr unsigned max_visits = 16;

constexpr double golden_ratio = 0.6180339887498949;

// Returns the interval of cumulative sums that contains `number`, and the fraction of the interval
// below it.
std::pair<std::size_t, double> find_in_cumulative_sums(const std::vector<double>& cumulative,
                                                       double number)
{
  const auto it = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, number);
  const auto i = std::size_t(it - cumulative.begin()) - 1;
  const double interval = cumulative[i + 1] - cumulative[i];
  return {i, interval > 0. ? std::clamp((number - cumulative[i]) / interval, 0., 1.) : 0.5};
}

template <typename Masses>
std::vector<double> cumulative_sums(const Masses& masses)
{
  std::vector<double> result = {0.};
  result.reserve(masses.size() + 1);
  for(const double mass : masses)
    result.push_back(result.back() + mass);
  return result;
}

} // namespace

class Streamlines::Tracer
{
public:
  virtual ~Tracer() = default;
  virtual bool has_flow() const = 0; // true if mass moves
  // Returns seed i of `number` seeds with equal mass.
  virtual Streamline_seed seed(std::size_t i, std::size_t number) const = 0;
  virtual Streamline trace_line(const Streamline_seed& seed) const = 0;

protected:
  Tracer(std::shared_ptr<const Surface_arrays> triangles, Moved_masses masses)
      : m_triangles(std::move(triangles)), m_masses(std::move(masses)),
        m_source_location(dominant_locations(m_masses.source_locations)),
        m_target_location(dominant_locations(m_masses.target_locations))
  {}

  const Surface_arrays& t() const { return *m_triangles; }
  const Moved_masses& masses() const { return m_masses; }

  void add(Streamline& line, const Surface_location& location) const
  {
    const Surface_location cleaned_location = canonical(t(), location);
    if(line.locations.empty() || !is_same_point(t(), line.locations.back(), cleaned_location))
      line.locations.push_back(cleaned_location);
  }

  // Adds the vertex, and before it the point mass inside a triangle that is represented by the
  // vertex.
  void begin_at_vertex(Streamline& line, Index vertex) const
  {
    if(const Index i = m_source_location[vertex]; i != none)
      add(line, m_masses.source_locations[i]);
    add(line, {none, vertex, {}});
  }
  void end_at_vertex(Streamline& line, Index vertex) const
  {
    add(line, {none, vertex, {}});
    if(const Index i = m_target_location[vertex]; i != none)
      add(line, m_masses.target_locations[i]);
  }

private:
  // Returns for each vertex the point inside a triangle with the largest barycentric coordinate at
  // this vertex, or none.
  std::vector<Index> dominant_locations(const std::vector<Surface_location>& locations) const
  {
    std::vector<Index> result(t().number_of_vertices(), none);
    std::vector<double> best_coordinate(result.size(), 0.);
    for(Index i = 0; i < locations.size(); ++i)
      for(std::size_t k = 0; k < 3 && locations[i].triangle != none; ++k)
        if(const Index vertex = t().corner[3 * std::size_t(locations[i].triangle) + k];
           locations[i].barycentric[k] > best_coordinate[vertex])
        {
          best_coordinate[vertex] = locations[i].barycentric[k];
          result[vertex] = i;
        }
    return result;
  }

  std::shared_ptr<const Surface_arrays> m_triangles;
  Moved_masses m_masses;
  std::vector<Index> m_source_location, m_target_location;
};

// Streamlines on a mesh. Let b be barycentric coordinates, G_k the flux out through the edge
// opposite of corner k, and S the sum of all G_k. The Raviart-Thomas field is (S b - G) / (2 area).
// Hence a streamline from b is b + u (S b - G). Lengths around it are scaled by 1 + S u, and
// densities are divided by the square.
class Streamlines::Mesh_tracer : public Tracer
{
public:
  Mesh_tracer(std::shared_ptr<const Surface_arrays> triangles, const Continuous_flow& flow,
              Moved_masses masses)
      : Tracer(std::move(triangles), std::move(masses)), m_outward_flux(flow.outward_flux),
        m_doubled_area(flow.absorbed_mass.size()), m_ring_area(t().number_of_vertices(), 0.),
        m_source_mass(m_doubled_area.size(), 0.), m_target_mass(m_doubled_area.size())
  {
    for(std::size_t f = 0; f < m_doubled_area.size(); ++f)
    {
      const double* l = &t().length[3 * f];
      m_doubled_area[f] = twice_area(l[0], l[1], l[2]);
      for(std::size_t k = 0; k < 3; ++k)
        m_ring_area[t().corner[3 * f + k]] += m_doubled_area[f];
    }
    for(std::size_t f = 0; f < m_doubled_area.size(); ++f)
    {
      for(std::size_t corner = 3 * f; corner < 3 * f + 3; ++corner)
        m_source_mass[f] +=
            corner_fraction(corner) * this->masses().source_masses[t().corner[corner]];
      // If the vertex has several fans, they can carry different fractions of its mass.
      m_source_mass[f] = std::max({m_source_mass[f], -flow.absorbed_mass[f], 0.});
      m_target_mass[f] = m_source_mass[f] + flow.absorbed_mass[f];
    }
    m_cumulative_masses = cumulative_sums(m_source_mass);
  }

  bool has_flow() const override { return m_cumulative_masses.back() > 0.; }

  Streamline_seed seed(std::size_t i, std::size_t number) const override
  {
    const auto [f, fraction] = find_in_cumulative_sums(
        m_cumulative_masses, (double(i) + 0.5) / double(number) * m_cumulative_masses.back());
    // The square root makes the area between corner 0 and the cut proportional to the mass.
    // Multiples of the golden ratio are evenly distributed along the cut.
    const double cut_ratio = std::sqrt(fraction),
                 along = std::fmod(0.5 + golden_ratio * double(i), 1.);
    const Surface_location location = {
        Index(f), none, {1. - cut_ratio, cut_ratio * (1. - along), cut_ratio * along}};
    return {location, 0.5,
            masses().has_point_sources ? dominant_vertex(location, masses().source_masses) : none};
  }

  Streamline trace_line(const Streamline_seed& seed) const override
  {
    Streamline result;
    Surface_location location = canonical(t(), seed.location);
    if(seed.source_vertex != none)
      begin_at_vertex(result, seed.source_vertex);
    else if(const Index vertex = vertex_of(t(), location); vertex != none)
    {
      add(result, location);
      if(t().ring_begin[vertex] == t().ring_begin[vertex + 1])
        return result;
      location = outgoing_location(vertex);
      // A flux of this size is a round-off error.
      if(opposite_outflow(3 * location.triangle + corner_at(location.triangle, vertex)) <=
         1e-12 * m_cumulative_masses.back())
      {
        result.has_arrived = masses().target_masses[vertex] > 0.;
        return result;
      }
    }
    add(result, location);
    trace(result, location);
    return result;
  }

private:
  // Returns the fraction of the vertex's mass that is in the triangle of the corner.
  double corner_fraction(std::size_t corner) const
  {
    const Index vertex = t().corner[corner];
    return m_ring_area[vertex] > 0.
               ? m_doubled_area[corner / 3] / m_ring_area[vertex]
               : 1. / double(t().ring_begin[vertex + 1] - t().ring_begin[vertex]);
  }

  // Returns the flux out of the triangle through the edge opposite of the corner.
  double opposite_outflow(Index corner) const { return m_outward_flux[next_halfedge(corner)]; }

  Index corner_at(Index triangle, Index vertex) const
  {
    Index k = 0;
    while(k < 2 && t().corner[3 * triangle + k] != vertex)
      ++k;
    return k;
  }

  // Returns the centroid of the incident triangle with the largest outward flux through the edge
  // opposite of the vertex.
  Surface_location outgoing_location(Index vertex) const
  {
    Index best = t().ring[t().ring_begin[vertex]];
    for(Index i = t().ring_begin[vertex]; i < t().ring_begin[vertex + 1]; ++i)
      if(opposite_outflow(t().ring[i]) > opposite_outflow(best))
        best = t().ring[i];
    return {best / 3, none, {1. / 3., 1. / 3., 1. / 3.}};
  }

  // Returns the vertex of the triangle that contributes most mass at the location.
  Index dominant_vertex(const Surface_location& location, const Vector& masses) const
  {
    Index best = none;
    double max_mass = -1.;
    for(Index k = 0; k < 3; ++k)
    {
      const Index corner = 3 * location.triangle + k;
      const double mass =
          location.barycentric[k] * corner_fraction(corner) * masses[t().corner[corner]];
      if(mass > max_mass)
      {
        max_mass = mass;
        best = t().corner[corner];
      }
    }
    return best;
  }

  // The straight line b + u direction of a streamline in a triangle.
  struct Triangle_crossing
  {
    double sum; // total flux out of the triangle
    std::array<double, 3> direction;
    double u = infinity;   // parameter at the exit
    Index opposite = none; // corner opposite of the edge at the exit
  };

  // Computes the line from b in triangle f, and its exit.
  Triangle_crossing cross_triangle(Index f, const std::array<double, 3>& b) const
  {
    const std::array<double, 3> out = {opposite_outflow(3 * f), opposite_outflow(3 * f + 1),
                                       opposite_outflow(3 * f + 2)};
    Triangle_crossing result;
    result.sum = out[0] + out[1] + out[2];
    for(Index k = 0; k < 3; ++k)
    {
      const double direction = result.direction[k] = result.sum * b[k] - out[k];
      if(out[k] > 0. && direction < 0. && -b[k] / direction < result.u)
      {
        result.u = -b[k] / direction;
        result.opposite = 3 * f + k;
      }
    }
    return result;
  }

  // Appends the locations of a streamline from a point inside a triangle.
  void trace(Streamline& line, const Surface_location& from) const
  {
    std::unordered_map<Index, unsigned> visits;
    Index f = from.triangle;
    std::array<double, 3> b = from.barycentric;
    for(double time = 0.;;)
    {
      const Triangle_crossing crossing = cross_triangle(f, b);
      const double sum = crossing.sum;
      // The parameter at time 1. If the flow contracts, all lines meet at u = -1 / sum and end
      // there.
      const double mass = std::max(0., m_source_mass[f] - time * sum), last = m_target_mass[f];
      double end = last > 0. ? (1. - time) / (last + std::sqrt(mass * last)) : infinity;
      if(sum < 0.)
        end = std::min(end, -1. / sum);
      const bool ends_here = end <= crossing.u;
      const double u = std::min(crossing.u, end);
      if(u == infinity)
        return; // no flow
      for(std::size_t k = 0; k < 3; ++k)
        b[k] = std::max(0., b[k] + u * crossing.direction[k]);
      if(!ends_here)
        b[crossing.opposite % 3] = 0.;
      const double total = b[0] + b[1] + b[2];
      for(double& coordinate : b)
        coordinate /= total;
      add(line, {f, none, b});
      if(ends_here)
      {
        line.has_arrived = last > 0.;
        if(masses().has_point_targets && line.has_arrived)
          end_at_vertex(line, dominant_vertex({f, none, b}, masses().target_masses));
        return;
      }
      const double stretch = 1. + sum * u;
      time = std::min(1., time + mass * u * (1. + stretch) / (stretch * stretch));
      const Index h = next_halfedge(crossing.opposite), twin = t().twin[h];
      if(twin == none || ++visits[h] > max_visits)
        return;
      std::array<double, 3> coordinates = {0., 0., 0.};
      coordinates[twin % 3] = b[next_halfedge(h) % 3];
      coordinates[next_halfedge(twin) % 3] = b[h % 3];
      b = coordinates;
      f = twin / 3;
    }
  }

  std::vector<double> m_outward_flux;               // #halfedges
  std::vector<double> m_doubled_area;               // #triangles: twice the area
  std::vector<double> m_ring_area;                  // #vertices: sum over the incident triangles
  std::vector<double> m_source_mass, m_target_mass; // #triangles
  std::vector<double> m_cumulative_masses;
};

// Streamlines on a cloud. The flow along an edge is the sum over its triangles of a third of the
// difference of the divergences at both ends.
class Streamlines::Cloud_tracer : public Tracer
{
public:
  Cloud_tracer(std::shared_ptr<const Surface_arrays> triangles, const Operators& operators,
               const Field& flow, Moved_masses masses)
      : Tracer(std::move(triangles), std::move(masses)),
        m_cumulative_masses(cumulative_sums(this->masses().source_masses)),
        m_edge_begin(t().number_of_vertices() + 1, 0)
  {
    std::vector<Edge> edges; // in both directions
    for(Index h = 0; h < operators.corner.size(); ++h)
    {
      const Index next = next_halfedge(h), f = h / 3;
      const double amount = operators.area[f] *
                            dot(flow[f], operators.hat_gradient[next] - operators.hat_gradient[h]) /
                            3.;
      edges.push_back({operators.corner[h], operators.corner[next], amount, 0.});
      edges.push_back({operators.corner[next], operators.corner[h], -amount, 0.});
    }
    const auto ends = [](const Edge& a, const Edge& b)
    { return std::tie(a.from, a.to) < std::tie(b.from, b.to); };
    std::stable_sort(edges.begin(), edges.end(), ends);
    for(const Edge& edge : edges)
      if(m_edges.empty() || ends(m_edges.back(), edge))
        m_edges.push_back(edge);
      else
        m_edges.back().amount += edge.amount;
    for(const Edge& edge : m_edges)
      ++m_edge_begin[edge.from + 1];
    std::partial_sum(m_edge_begin.begin(), m_edge_begin.end(), m_edge_begin.begin());
    for(Index vertex = 0; vertex + 1 < m_edge_begin.size(); ++vertex)
      sort_edges_at(vertex);
  }

  bool has_flow() const override { return m_cumulative_masses.back() > 0.; }

  Streamline_seed seed(std::size_t i, std::size_t number) const override
  {
    const auto [vertex, fraction] = find_in_cumulative_sums(
        m_cumulative_masses, (double(i) + 0.5) / double(number) * m_cumulative_masses.back());
    return {{none, Index(vertex), {}}, fraction, masses().has_point_sources ? Index(vertex) : none};
  }

  Streamline trace_line(const Streamline_seed& seed) const override
  {
    Streamline result;
    Index vertex = seed.location.vertex;
    if(seed.source_vertex != none)
      begin_at_vertex(result, vertex);
    else if(seed.location.triangle != none)
    {
      add(result, seed.location);
      const auto& b = seed.location.barycentric;
      const std::size_t k = std::size_t(std::max_element(b.begin(), b.end()) - b.begin());
      vertex = t().corner[3 * std::size_t(seed.location.triangle) + k];
    }

    std::vector<Index> path_vertices = {vertex};
    std::unordered_map<Index, unsigned> visits;
    double before = masses().source_masses[vertex];
    // position in the flow from `from`
    double rank = before > 0. ? seed.right_fraction * before : 0.5;
    // the vertex itself if it has source mass; none for all incoming flow
    Index from = before > 0. ? vertex : none;
    while(++visits[vertex] <= max_visits)
    {
      const auto [next, amount] = next_vertex(vertex, from, rank);
      if(next == none)
        break;
      if(next == vertex)
      {
        result.has_arrived = true;
        break;
      }
      // Removes loops.
      if(const auto coordinates = std::find(path_vertices.begin(), path_vertices.end(), next);
         coordinates != path_vertices.end())
        path_vertices.erase(coordinates + 1, path_vertices.end());
      else
        path_vertices.push_back(next);
      from = vertex;
      vertex = next;
      rank = amount;
    }
    for(const Index next : path_vertices)
      add(result, {none, next, {}});
    if(result.has_arrived && masses().has_point_targets)
      end_at_vertex(result, vertex);
    return result;
  }

private:
  struct Edge
  {
    Index from, to;
    double amount; // flow from `from` to `to`; negative if it is incoming
    double left;   // sine of the angle of the edge to the left of the flow direction
  };

  // Sorts the edges of a vertex from right to left, as seen in the direction of its total flow.
  void sort_edges_at(Index vertex)
  {
    const auto begin = m_edges.begin() + m_edge_begin[vertex],
               end = m_edges.begin() + m_edge_begin[vertex + 1];
    Vec3 flow_direction = {0., 0., 0.};
    for(auto edge = begin; edge != end; ++edge)
      flow_direction =
          flow_direction + edge->amount * unit(t().point[edge->to] - t().point[vertex]);
    const Vec3 left = unit(cross(t().normal[vertex], flow_direction));
    for(auto edge = begin; edge != end; ++edge)
      edge->left = dot(left, unit(t().point[edge->to] - t().point[vertex]));
    std::sort(begin, end,
              [](const Edge& a, const Edge& b)
              { return std::tie(a.left, a.to) < std::tie(b.left, b.to); });
  }

  // Calls f(neighbor, amount) for each incoming (sign = -1) or outgoing (sign = 1) edge, from right
  // to left. At the flow direction, f(vertex, own_mass) is called.
  template <typename Function>
  void for_each_neighbor(Index vertex, double sign, double own_mass, Function f) const
  {
    bool is_own_mass_visited = false;
    for(Index i = m_edge_begin[vertex]; i < m_edge_begin[vertex + 1]; ++i)
    {
      if(!is_own_mass_visited && m_edges[i].left >= 0.)
      {
        is_own_mass_visited = true;
        f(vertex, own_mass);
      }
      if(sign * m_edges[i].amount > 0.)
        f(m_edges[i].to, sign * m_edges[i].amount);
    }
    if(!is_own_mass_visited)
      f(vertex, own_mass);
  }

  // Returns the next vertex and the position in the flow to it. Returns the vertex itself if the
  // streamline ends there, and none if nothing flows here.
  std::pair<Index, double> next_vertex(Index vertex, Index from, double rank) const
  {
    double in = 0., out = 0., rank_in_flow = 0.;
    for_each_neighbor(vertex, -1., masses().source_masses[vertex],
                      [&](Index other, double amount)
                      {
                        if(other == from)
                          rank_in_flow = in + rank;
                        in += amount;
                      });
    for_each_neighbor(vertex, 1., masses().target_masses[vertex],
                      [&](Index, double amount) { out += amount; });
    if(!(in > 0. || from == none) || !(out > 0.))
      return {none, 0.};
    // Inflow and outflow are equal up to round-off errors.
    rank_in_flow = from == none ? rank * out : std::min(rank_in_flow * (out / in), out);
    std::pair<Index, double> result = {none, 0.};
    double sum = 0.;
    for_each_neighbor(vertex, 1., masses().target_masses[vertex],
                      [&](Index other, double amount)
                      {
                        if(amount > 0. && rank_in_flow >= sum)
                          result = {other, std::min(rank_in_flow - sum, amount)};
                        sum += amount;
                      });
    return result;
  }

  std::vector<double> m_cumulative_masses;
  std::vector<Index> m_edge_begin; // #vertices + 1: first edge of each vertex
  std::vector<Edge> m_edges;       // sorted from right to left at each vertex
};

Streamlines::Streamlines(std::shared_ptr<const Surface_arrays> triangles,
                         const Continuous_flow& flow, Moved_masses masses)
    : m_tracer(std::make_unique<Mesh_tracer>(std::move(triangles), flow, std::move(masses)))
{}

Streamlines::Streamlines(std::shared_ptr<const Surface_arrays> triangles,
                         const Operators& operators, const Field& flow, Moved_masses masses)
    : m_tracer(
          std::make_unique<Cloud_tracer>(std::move(triangles), operators, flow, std::move(masses)))
{}

Streamlines::~Streamlines() = default;
Streamlines::Streamlines(Streamlines&&) noexcept = default;

std::vector<Streamline_seed> Streamlines::seeds(std::size_t number) const
{
  std::vector<Streamline_seed> result;
  for(std::size_t i = 0; i < number && m_tracer->has_flow(); ++i)
    result.push_back(m_tracer->seed(i, number));
  return result;
}

Streamline Streamlines::operator()(const Streamline_seed& seed) const
{
  return m_tracer->trace_line(seed);
}

Line_shortener::Line_shortener(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(std::move(triangles))
{}

std::vector<Surface_location> Line_shortener::operator()(const std::vector<Surface_location>& line,
                                                         double lower_bound)
{
  const Surface_arrays& t = *m_triangles;
  std::vector<Surface_location> shortened_line = shorten_path(t, line);
  if(t.is_cloud() || path_length(t, shortened_line) <= 1.01 * lower_bound)
    return shortened_line;
  if(!m_finder)
    m_finder.emplace(m_triangles);
  std::vector<Surface_location> other =
      shorten_path(t, (*m_finder)(shortened_line.front(), shortened_line.back()));
  return !other.empty() && path_length(t, other) < path_length(t, shortened_line) ? other
                                                                                  : shortened_line;
}

} // namespace CGAL::Geodesic_processing::internal
