// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/streamlines.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A line that comes to the same side, or the same site, so often turns in circles.
constexpr unsigned most_visits = 16;

constexpr double golden = 0.6180339887498949;

// Where sums of masses reach a number: the position, and the part of it that is reached.
std::pair<std::size_t, double> found_in(const std::vector<double>& sums, double number)
{
  const auto it = std::upper_bound(sums.begin() + 1, sums.end() - 1, number);
  const auto i = std::size_t(it - sums.begin()) - 1;
  const double whole = sums[i + 1] - sums[i];
  return {i, whole > 0. ? std::clamp((number - sums[i]) / whole, 0., 1.) : 0.5};
}

template <typename Masses>
std::vector<double> sums_of(const Masses& masses)
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
  virtual bool moves() const = 0; // anything
  // Of so many that have the same mass.
  virtual Grain grain(std::size_t i, std::size_t number) const = 0;
  virtual Streamline line(const Grain& grain) const = 0;

protected:
  Tracer(std::shared_ptr<const Glued_triangles> triangles, Moved_masses masses)
      : m_triangles(std::move(triangles)), m_masses(std::move(masses)),
        m_place_before(places_of_sites(m_masses.places_before)),
        m_place_after(places_of_sites(m_masses.places_after))
  {}

  const Glued_triangles& t() const { return *m_triangles; }
  const Moved_masses& masses() const { return m_masses; }

  void add(Streamline& line, const Location& location) const
  {
    const Location clean = cleaned(t(), location);
    if(line.locations.empty() || !is_same_point(t(), line.locations.back(), clean))
      line.locations.push_back(clean);
  }

  // What stands at a site, or is shared with it.
  void begin_at(Streamline& line, Index site) const
  {
    if(const Index i = m_place_before[site]; i != none)
      add(line, m_masses.places_before[i]);
    add(line, {none, site, {}});
  }
  void end_at(Streamline& line, Index site) const
  {
    add(line, {none, site, {}});
    if(const Index i = m_place_after[site]; i != none)
      add(line, m_masses.places_after[i]);
  }

private:
  // #sites: the place in a triangle that has most to do with the site, or none.
  std::vector<Index> places_of_sites(const std::vector<Location>& places) const
  {
    std::vector<Index> result(t().number_of_sites(), none);
    std::vector<double> part(result.size(), 0.);
    for(Index i = 0; i < places.size(); ++i)
      for(std::size_t k = 0; k < 3 && places[i].triangle != none; ++k)
        if(const Index site = t().corner[3 * std::size_t(places[i].triangle) + k];
           places[i].barycentric[k] > part[site])
        {
          part[site] = places[i].barycentric[k];
          result[site] = i;
        }
    return result;
  }

  std::shared_ptr<const Glued_triangles> m_triangles;
  Moved_masses m_masses;
  std::vector<Index> m_place_before, m_place_after;
};

// In barycentric coordinates b a field of Raviart and Thomas is S b - G over twice the area, G what flows
// out through the side opposite of each corner and S its sum.  So a line from b is b + u (S b - G), all
// around it is stretched by 1 + S u, and masses are divided by the square of that.
class Streamlines::Mesh_tracer : public Tracer
{
public:
  Mesh_tracer(std::shared_ptr<const Glued_triangles> triangles, const Continuous_flow& flow,
              Moved_masses masses)
      : Tracer(std::move(triangles), std::move(masses)), m_outward(flow.outward),
        m_area(flow.missing.size()), m_star(t().number_of_sites(), 0.), m_before(m_area.size(), 0.),
        m_after(m_area.size())
  {
    for(std::size_t f = 0; f < m_area.size(); ++f)
    {
      const double* l = &t().length[3 * f];
      m_area[f] = twice_area(l[0], l[1], l[2]);
      for(std::size_t k = 0; k < 3; ++k)
        m_star[t().corner[3 * f + k]] += m_area[f];
    }
    for(std::size_t f = 0; f < m_area.size(); ++f)
    {
      for(std::size_t corner = 3 * f; corner < 3 * f + 3; ++corner)
        m_before[f] += part(corner) * this->masses().before[t().corner[corner]];
      // Fans around a site may have other parts of it.
      m_before[f] = std::max({m_before[f], -flow.missing[f], 0.});
      m_after[f] = m_before[f] + flow.missing[f];
    }
    m_sums = sums_of(m_before);
  }

  bool moves() const override { return m_sums.back() > 0.; }

  Grain grain(std::size_t i, std::size_t number) const override
  {
    const auto [f, share] = found_in(m_sums, (double(i) + 0.5) / double(number) * m_sums.back());
    // The area cut off at a corner, and along the cut multiples of the golden ratio.
    const double cut = std::sqrt(share), along = std::fmod(0.5 + golden * double(i), 1.);
    const Location place = {Index(f), none, {1. - cut, cut * (1. - along), cut * along}};
    return {place, 0.5, masses().are_points_before ? nearest_site(place, masses().before) : none};
  }

  Streamline line(const Grain& grain) const override
  {
    Streamline result;
    Location place = cleaned(t(), grain.place);
    if(grain.origin != none)
      begin_at(result, grain.origin);
    else if(const Index site = site_of(t(), place); site != none)
    {
      add(result, place);
      if(t().first[site] == t().first[site + 1])
        return result;
      place = leaving(site);
      // Rounding is no flow.
      if(ahead(3 * place.triangle + corner_at(place.triangle, site)) <= 1e-12 * m_sums.back())
      {
        result.has_arrived = masses().after[site] > 0.;
        return result;
      }
    }
    add(result, place);
    follow(result, place);
    return result;
  }

private:
  // Of the mass at a corner's site, in the triangle.
  double part(std::size_t corner) const
  {
    const Index site = t().corner[corner];
    return m_star[site] > 0. ? m_area[corner / 3] / m_star[site]
                             : 1. / double(t().first[site + 1] - t().first[site]);
  }

  // What flows out of the triangle through the side opposite of the corner.
  double ahead(Index corner) const { return m_outward[next_side(corner)]; }

  Index corner_at(Index triangle, Index site) const
  {
    Index k = 0;
    while(k < 2 && t().corner[3 * triangle + k] != site)
      ++k;
    return k;
  }

  // Among the triangles around a site: the middle of the one through which most leaves.
  Location leaving(Index site) const
  {
    Index best = t().star[t().first[site]];
    for(Index i = t().first[site]; i < t().first[site + 1]; ++i)
      if(ahead(t().star[i]) > ahead(best))
        best = t().star[i];
    return {best / 3, none, {1. / 3., 1. / 3., 1. / 3.}};
  }

  // The corner whose mass is the most of what is in a triangle there.
  Index nearest_site(const Location& place, const Vector& masses) const
  {
    Index best = none;
    double most = -1.;
    for(Index k = 0; k < 3; ++k)
    {
      const Index corner = 3 * place.triangle + k;
      const double here = place.barycentric[k] * part(corner) * masses[t().corner[corner]];
      if(here > most)
      {
        most = here;
        best = t().corner[corner];
      }
    }
    return best;
  }

  void follow(Streamline& line, const Location& from) const
  {
    std::unordered_map<Index, unsigned> visits;
    Index f = from.triangle;
    std::array<double, 3> b = from.barycentric;
    for(double time = 0.;;)
    {
      const std::array<double, 3> out = {ahead(3 * f), ahead(3 * f + 1), ahead(3 * f + 2)};
      const double sum = out[0] + out[1] + out[2];
      std::array<double, 3> direction;
      double u = infinity;
      Index opposite = none;
      for(Index k = 0; k < 3; ++k)
      {
        direction[k] = sum * b[k] - out[k];
        if(out[k] > 0. && direction[k] < 0. && -b[k] / direction[k] < u)
        {
          u = -b[k] / direction[k];
          opposite = 3 * f + k;
        }
      }
      // Where the mass is at the end of time, or where all flows to.
      const double mass = std::max(0., m_before[f] - time * sum), last = m_after[f];
      double end = last > 0. ? (1. - time) / (last + std::sqrt(mass * last)) : infinity;
      if(sum < 0.)
        end = std::min(end, -1. / sum);
      const bool is_over = end <= u;
      u = std::min(u, end);
      if(u == infinity)
        return; // nothing flows here
      for(std::size_t k = 0; k < 3; ++k)
        b[k] = std::max(0., b[k] + u * direction[k]);
      if(!is_over)
        b[opposite % 3] = 0.;
      const double total = b[0] + b[1] + b[2];
      for(double& coordinate : b)
        coordinate /= total;
      add(line, {f, none, b});
      if(is_over)
      {
        line.has_arrived = last > 0.;
        if(masses().are_points_after && line.has_arrived)
          end_at(line, nearest_site({f, none, b}, masses().after));
        return;
      }
      const double stretch = 1. + sum * u;
      time = std::min(1., time + mass * u * (1. + stretch) / (stretch * stretch));
      const Index side = next_side(opposite), twin = t().twin[side];
      if(twin == none || ++visits[side] > most_visits)
        return;
      std::array<double, 3> seen = {0., 0., 0.};
      seen[twin % 3] = b[next_side(side) % 3];
      seen[next_side(twin) % 3] = b[side % 3];
      b = seen;
      f = twin / 3;
    }
  }

  std::vector<double> m_outward;         // #sides
  std::vector<double> m_area;            // #triangles, twice
  std::vector<double> m_star;            // #sites, the sum of that around it
  std::vector<double> m_before, m_after; // #triangles
  std::vector<double> m_sums;
};

// Each triangle sends from corner to corner a third of the difference of what is missing at them.
class Streamlines::Cloud_tracer : public Tracer
{
public:
  Cloud_tracer(std::shared_ptr<const Glued_triangles> triangles, const Operators& operators,
               const Field& flow, Moved_masses masses)
      : Tracer(std::move(triangles), std::move(masses)), m_sums(sums_of(this->masses().before)),
        m_first(t().number_of_sites() + 1, 0)
  {
    std::vector<Arc> arcs; // both ways
    for(Index side = 0; side < operators.corner.size(); ++side)
    {
      const Index next = next_side(side), f = side / 3;
      const double amount =
          operators.area[f] * dot(flow[f], operators.hat[next] - operators.hat[side]) / 3.;
      arcs.push_back({operators.corner[side], operators.corner[next], amount, 0.});
      arcs.push_back({operators.corner[next], operators.corner[side], -amount, 0.});
    }
    const auto ends = [](const Arc& a, const Arc& b)
    { return std::tie(a.from, a.to) < std::tie(b.from, b.to); };
    std::stable_sort(arcs.begin(), arcs.end(), ends);
    for(const Arc& arc : arcs)
      if(m_arcs.empty() || ends(m_arcs.back(), arc))
        m_arcs.push_back(arc);
      else
        m_arcs.back().amount += arc.amount;
    for(const Arc& arc : m_arcs)
      ++m_first[arc.from + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    for(Index site = 0; site + 1 < m_first.size(); ++site)
      sort_around(site);
  }

  bool moves() const override { return m_sums.back() > 0.; }

  Grain grain(std::size_t i, std::size_t number) const override
  {
    const auto [site, share] = found_in(m_sums, (double(i) + 0.5) / double(number) * m_sums.back());
    return {{none, Index(site), {}}, share, masses().are_points_before ? Index(site) : none};
  }

  Streamline line(const Grain& grain) const override
  {
    Streamline result;
    Index site = grain.place.site;
    if(grain.origin != none)
      begin_at(result, site);
    else if(grain.place.triangle != none)
    {
      add(result, grain.place);
      const auto& b = grain.place.barycentric;
      const std::size_t k = std::size_t(std::max_element(b.begin(), b.end()) - b.begin());
      site = t().corner[3 * std::size_t(grain.place.triangle) + k];
    }

    std::vector<Index> chain = {site};
    std::unordered_map<Index, unsigned> visits;
    double before = masses().before[site];
    double place = before > 0. ? grain.share * before : 0.5; // among what comes from there
    Index from = before > 0. ? site : none;                  // itself, or none: all that comes
    while(++visits[site] <= most_visits)
    {
      const auto [next, amount] = next_of(site, from, place);
      if(next == none)
        break;
      if(next == site)
      {
        result.has_arrived = true;
        break;
      }
      // Without the loops.
      if(const auto seen = std::find(chain.begin(), chain.end(), next); seen != chain.end())
        chain.erase(seen + 1, chain.end());
      else
        chain.push_back(next);
      from = site;
      site = next;
      place = amount;
    }
    for(const Index next : chain)
      add(result, {none, next, {}});
    if(result.has_arrived && masses().are_points_after)
      end_at(result, site);
    return result;
  }

private:
  struct Arc
  {
    Index from, to;
    double amount; // that goes along it, negative if it comes
    double left;   // how far the other end lies on the left of where things go
  };

  void sort_around(Index site)
  {
    const auto begin = m_arcs.begin() + m_first[site], end = m_arcs.begin() + m_first[site + 1];
    Spatial way = {0., 0., 0.};
    for(auto arc = begin; arc != end; ++arc)
      way = way + arc->amount * unit(t().point[arc->to] - t().point[site]);
    const Spatial left = unit(cross(t().normal[site], way));
    for(auto arc = begin; arc != end; ++arc)
      arc->left = dot(left, unit(t().point[arc->to] - t().point[site]));
    std::sort(begin, end,
              [](const Arc& a, const Arc& b)
              { return std::tie(a.left, a.to) < std::tie(b.left, b.to); });
  }

  // Calls f with each site that sends to this one, or is sent to, from right to left, and how much: this
  // one itself in the middle.
  template <typename Function>
  void for_each(Index site, double sign, double own, Function f) const
  {
    bool is_own_done = false;
    for(Index i = m_first[site]; i < m_first[site + 1]; ++i)
    {
      if(!is_own_done && m_arcs[i].left >= 0.)
      {
        is_own_done = true;
        f(site, own);
      }
      if(sign * m_arcs[i].amount > 0.)
        f(m_arcs[i].to, sign * m_arcs[i].amount);
    }
    if(!is_own_done)
      f(site, own);
  }

  // Where something goes to, and its place there among what comes from here; none if nothing moves here.
  std::pair<Index, double> next_of(Index site, Index from, double place) const
  {
    double in = 0., out = 0., here = 0.;
    for_each(site, -1., masses().before[site],
             [&](Index other, double amount)
             {
               if(other == from)
                 here = in + place;
               in += amount;
             });
    for_each(site, 1., masses().after[site], [&](Index, double amount) { out += amount; });
    if(!(in > 0. || from == none) || !(out > 0.))
      return {none, 0.};
    here = from == none ? place * out : std::min(here * (out / in), out); // sums but for rounding
    std::pair<Index, double> result = {none, 0.};
    double sum = 0.;
    for_each(site, 1., masses().after[site],
             [&](Index other, double amount)
             {
               if(amount > 0. && here >= sum)
                 result = {other, std::min(here - sum, amount)};
               sum += amount;
             });
    return result;
  }

  std::vector<double> m_sums;
  std::vector<Index> m_first; // #sites + 1: where its arcs begin
  std::vector<Arc> m_arcs;    // around each site from right to left
};

Streamlines::Streamlines(std::shared_ptr<const Glued_triangles> triangles,
                         const Continuous_flow& flow, Moved_masses masses)
    : m_tracer(std::make_unique<Mesh_tracer>(std::move(triangles), flow, std::move(masses)))
{}

Streamlines::Streamlines(std::shared_ptr<const Glued_triangles> triangles,
                         const Operators& operators, const Field& flow, Moved_masses masses)
    : m_tracer(
          std::make_unique<Cloud_tracer>(std::move(triangles), operators, flow, std::move(masses)))
{}

Streamlines::~Streamlines() = default;
Streamlines::Streamlines(Streamlines&&) noexcept = default;

std::vector<Grain> Streamlines::grains(std::size_t number) const
{
  std::vector<Grain> result;
  for(std::size_t i = 0; i < number && m_tracer->moves(); ++i)
    result.push_back(m_tracer->grain(i, number));
  return result;
}

Streamline Streamlines::operator()(const Grain& grain) const { return m_tracer->line(grain); }

Line_shortener::Line_shortener(std::shared_ptr<const Glued_triangles> triangles)
    : m_triangles(std::move(triangles))
{}

std::vector<Location> Line_shortener::operator()(const std::vector<Location>& line, double least)
{
  const Glued_triangles& t = *m_triangles;
  std::vector<Location> taut = shortened(t, line);
  if(t.is_cloud() || path_length(t, taut) <= 1.01 * least)
    return taut;
  if(!m_finder)
    m_finder.emplace(m_triangles);
  std::vector<Location> other = shortened(t, (*m_finder)(taut.front(), taut.back()));
  return !other.empty() && path_length(t, other) < path_length(t, taut) ? other : taut;
}

} // namespace CGAL::Geodesic_processing::internal
