// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/denoise.h"

#include "numerics/Quadric_fit.h"
#include <CGAL/Geodesic_processing/internal/mesh/locality.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::size_t neighbors = 24;

// Radii of fits in spacings: the first holds 24 surfels of a plane.
constexpr int scales = 12;
constexpr double first_radius = 2.8, growth = 1.25;
// From this one on surfels are taken in clusters.
constexpr int first_clustered = 5;
constexpr Index cluster_size = 8;

// In standard deviations: how far the heights and the slopes of estimates may be apart, and surfels from
// a fit.  Slopes of scans are not independent: with 3 for them as well, paths on a scanned plane are off
// by 0.060 % instead of 0.046 %.
constexpr double agreement = 3., slope_agreement = 5., outlying = 3.5;

constexpr double normals_agree = 0.5; // 60 degrees: the other side of a thin sheet does not count

template <typename Value>
Value median(std::vector<Value>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The means over several surfels.
struct Sample
{
  Spatial point = {0., 0., 0.}, normal = {0., 0., 0.};
  std::array<double, 6> spread = {}; // of the points around their mean: xx, yy, zz, yz, zx, xy
};

// A quadratic form of the spread.
double spread_along(const std::array<double, 6>& s, const Spatial& p, const Spatial& q)
{
  return s[0] * p[0] * q[0] + s[1] * p[1] * q[1] + s[2] * p[2] * q[2] +
         s[3] * (p[1] * q[2] + p[2] * q[1]) + s[4] * (p[2] * q[0] + p[0] * q[2]) +
         s[5] * (p[0] * q[1] + p[1] * q[0]);
}

// Surfels in the order of their tree, and what is known of each.
struct Scan
{
  Frame frame;
  std::vector<Spatial> point, normal;
  std::vector<Index> order;
  Kd_tree tree;
  Rows near;                   // the nearest ones with normals that agree, and itself
  std::vector<Spatial> up;     // the mean of their normals
  std::vector<double> spacing; // the side of a square for each surfel
  std::vector<double> rise;    // the median of the neighbours, in spacings

  Scan(std::vector<Spatial> points, std::vector<Spatial> normals, unsigned threads);
  std::size_t size() const { return point.size(); }
};

Scan::Scan(std::vector<Spatial> points, std::vector<Spatial> normals, unsigned threads)
    : frame(unit_frame(points)), point(std::move(points)), near(point.size()), up(point.size()),
      spacing(point.size()), rise(point.size())
{
  check_sizes(point.size(), normals.size(), 0);
  normalize(normals);
  to_frame(point, frame);
  tree = Kd_tree(point, order, threads);
  for(const Index i : order)
    normal.push_back(normals[i]);
  visit_nearest(
      point, tree, neighbors, threads,
      [&](std::size_t block, Index i, const std::vector<Kd_tree::Neighbor>& found)
      {
        std::vector<double> rises = {0.};
        Spatial sum = normal[i];
        near.part(block).push_back(i);
        for(const auto& [square, j] : found)
          if(j != i && dot(normal[i], normal[j]) > normals_agree)
          {
            near.part(block).push_back(j);
            sum = sum + normal[j];
            rises.push_back(0.5 * std::abs(dot(normal[i] + normal[j], point[j] - point[i])));
          }
        near.end_row(block, i);
        up[i] = unit(sum);
        spacing[i] =
            std::sqrt(pi * found.back().squared_distance / std::max<double>(1., found.size() - 1.));
        rise[i] = spacing[i] > 0. ? median(rises) / spacing[i] : 0.;
      });
  near.join();
}

struct Surfel
{
  Spatial point, normal;
};

// The surface over the plane of a surfel, in its spacings.
class Chart
{
public:
  Chart(const Scan& scan, Index i)
      : m_origin(scan.point[i]), m_up(scan.up[i]), m_over(1. / scan.spacing[i])
  {
    std::tie(m_u, m_v) = tangent_frame(m_up);
  }

  struct Seen
  {
    Quadric_fit::Place place;
    double height, slope_x, slope_y;
  };
  // False where the normal does not agree.
  bool see(const Spatial& point, const Spatial& normal, Seen& seen) const
  {
    const double up = dot(normal, m_up);
    if(!(up > normals_agree))
      return false;
    const Spatial way = m_over * (point - m_origin);
    const double x = dot(way, m_u), y = dot(way, m_v);
    seen = {{x, y, x * x, x * y, y * y},
            dot(way, m_up),
            -dot(normal, m_u) / up,
            -dot(normal, m_v) / up};
    return true;
  }
  bool see(const Sample& sample, Seen& seen) const
  {
    if(!see(sample.point, sample.normal, seen))
      return false;
    const double square = m_over * m_over;
    seen.place.xx += square * spread_along(sample.spread, m_u, m_u);
    seen.place.xy += square * spread_along(sample.spread, m_u, m_v);
    seen.place.yy += square * spread_along(sample.spread, m_v, m_v);
    return true;
  }

  // Takes from what is seen how much it rises beyond the second order where the surface goes on
  // bending as the fit says: with the Hessian H by  x H x / (1 + sqrt(1 - |H x|^2))  in all, which is
  // right for spheres and cylinders.
  static void straighten(const Quadric_fit::Coefficients& c, Seen& seen)
  {
    const Quadric_fit::Place& p = seen.place;
    const double x = c[3] * p.x + c[4] * p.y, y = c[4] * p.x + c[5] * p.y;
    const double cosine = std::sqrt(1. - std::min(x * x + y * y, steepest));
    seen.height -= (c[3] * p.xx + 2. * c[4] * p.xy + c[5] * p.yy) * (1. / (1. + cosine) - 0.5);
    seen.slope_x -= x * (1. / cosine - 1.);
    seen.slope_y -= y * (1. / cosine - 1.);
  }

  // What a fit suggests for a surfel nearby.
  Surfel moved(const Spatial& point, const Quadric_fit::Coefficients& c) const
  {
    const Spatial way = m_over * (point - m_origin);
    const double x = dot(way, m_u), y = dot(way, m_v);
    const double rise = Quadric_fit::height(c, {x, y, x * x, x * y, y * y}) - dot(way, m_up);
    const Spatial upward =
        m_up - (c[1] + c[3] * x + c[4] * y) * m_u - (c[2] + c[4] * x + c[5] * y) * m_v;
    const double slope = norm(upward);
    return {point + rise / (m_over * slope * slope) * upward, (1. / slope) * upward};
  }

private:
  // Of the squared sine of the slope: normals that differ by more do not agree.
  static constexpr double steepest = 1. - normals_agree * normals_agree;

  Spatial m_origin, m_up, m_u, m_v;
  double m_over;
};

// Variances of heights, in squared spacings, and of slopes.
struct Variances
{
  std::vector<double> height, slope; // #surfels
};

// What fits to the nearest surfels leave, with these weights of slopes.
Variances left_by_fits(const Scan& scan, double slope_weight, unsigned threads)
{
  Variances result = {std::vector<double>(scan.size(), 0.), std::vector<double>(scan.size(), 0.)};
  for_each_block(scan.size(), surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   std::vector<Chart::Seen> all;
                   for(Index i = Index(begin); i < end; ++i)
                   {
                     if(!(scan.spacing[i] > 0.))
                       continue;
                     const Chart chart(scan, i);
                     Quadric_fit fit;
                     all.clear();
                     Chart::Seen seen;
                     for(const Index* j = scan.near.begin(i); j != scan.near.end(i); ++j)
                       if(chart.see(scan.point[*j], scan.normal[*j], seen))
                       {
                         all.push_back(seen);
                         fit.add_height(1., seen.place, seen.height);
                         fit.add_slopes(slope_weight, seen.place, seen.slope_x, seen.slope_y);
                       }
                     if(fit.factorize() < 6)
                       continue;
                     const Quadric_fit::Coefficients c = fit.coefficients(6);
                     double heights = 0., slopes = 0.;
                     for(const auto& [p, height, slope_x, slope_y] : all)
                     {
                       const double h = height - Quadric_fit::height(c, p);
                       const double a = slope_x - c[1] - c[3] * p.x - c[4] * p.y;
                       const double b = slope_y - c[2] - c[4] * p.x - c[5] * p.y;
                       heights += h * h;
                       slopes += a * a + b * b;
                     }
                     // Six of the numbers are used up, about half of them by the heights.
                     const double n = double(all.size());
                     result.height[i] = heights / std::max(1., n - 3.);
                     result.slope[i] = slopes / std::max(1., 2. * n - 3.);
                   }
                 });
  return result;
}

// The medians over the neighbours.
Variances variances(const Scan& scan, unsigned threads)
{
  // At first as if heights were known as well as slopes are over one spacing.
  Variances rough = left_by_fits(scan, 1., threads);
  const double slope = median(rough.slope), height = median(rough.height);
  const Variances fine = left_by_fits(scan, slope > 0. ? height / slope : 1., threads);
  for_each_block(scan.size(), surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   std::vector<double> heights, slopes;
                   for(Index i = Index(begin); i < end; ++i)
                   {
                     heights.clear();
                     slopes.clear();
                     for(const Index* j = scan.near.begin(i); j != scan.near.end(i); ++j)
                     {
                       const double ratio = scan.spacing[*j] / scan.spacing[i];
                       heights.push_back(ratio * ratio * fine.height[*j]);
                       slopes.push_back(fine.slope[*j]);
                     }
                     rough.height[i] = median(heights);
                     rough.slope[i] = median(slopes);
                   }
                 });
  return rough;
}

// Means of surfels that are neighbours in the order of the tree, but for those on different sheets.
struct Clusters
{
  std::vector<Sample> samples;
  std::vector<Spatial> point; // their means, in the order of a tree of their own
  Kd_tree tree;
};

Clusters clusters(const Scan& scan, unsigned threads)
{
  std::vector<Sample> samples;
  Clusters result;
  constexpr double part = 1. / cluster_size;
  for(Index begin = 0; begin + cluster_size <= scan.size(); begin += cluster_size)
  {
    const Index end = begin + cluster_size;
    Sample mean;
    double spacing = 0.;
    for(Index i = begin; i < end; ++i)
    {
      mean.point = mean.point + part * scan.point[i];
      mean.normal = mean.normal + part * scan.normal[i];
      spacing = std::max(spacing, scan.spacing[i]);
    }
    bool is_one = true;
    for(Index i = begin; i < end; ++i)
    {
      const Spatial way = scan.point[i] - mean.point;
      is_one =
          is_one && norm(way) < 5. * spacing && dot(scan.normal[i], mean.normal) > normals_agree;
      for(int k = 0; k < 3; ++k)
      {
        mean.spread[k] += part * way[k] * way[k];
        mean.spread[3 + k] += part * way[(k + 1) % 3] * way[(k + 2) % 3];
      }
    }
    if(is_one)
    {
      samples.push_back(mean);
      result.point.push_back(mean.point);
    }
  }
  std::vector<Index> order;
  result.tree = Kd_tree(result.point, order, threads);
  for(const Index i : order)
    result.samples.push_back(samples[i]);
  return result;
}

// A fit: its radius, and how many of its coefficients count.
struct Choice
{
  int scale = 0, number = 3;

  friend bool operator==(const Choice& a, const Choice& b)
  {
    return a.scale == b.scale && a.number == b.number;
  }
  // By how sure they are: a plane is as sure as a quadric through four times as many surfels.
  friend bool operator<(const Choice& a, const Choice& b)
  {
    const int rank_a = a.scale + (a.number == 3 ? 3 : 0),
              rank_b = b.scale + (b.number == 3 ? 3 : 0);
    return rank_a != rank_b ? rank_a < rank_b : a.scale < b.scale;
  }
};

class Denoiser
{
public:
  // What a thread works with.
  struct Scratch
  {
    std::vector<Index> found;
    std::array<std::vector<Index>, scales> rings;
  };

  Denoiser(const Scan& scan, unsigned threads)
      : m_scan(scan), m_variances(variances(scan, threads)), m_clusters(clusters(scan, threads))
  {
    for(int k = 0; k < scales; ++k)
      m_squared_radius[k] = std::pow(first_radius * std::pow(growth, k), 2);
  }

  // The surest fit that agrees with all that are less sure.
  Quadric_fit::Coefficients choose(Index i, Scratch& scratch, Choice& choice) const
  {
    Quadric_fit::Coefficients result = {};
    choice = {};
    if(!is_noisy(i))
      return result;
    std::array<Estimate, 2 * scales> estimates;
    std::size_t size = 0;
    double least = infinity;
    visit_fits(i, scratch,
               [&](int scale, const Quadric_fit& fit, int number)
               {
                 bool is_any = number < 6;
                 for(const int n : {6, 3})
                 {
                   if(n > number)
                     continue;
                   const Quadric_fit::Coefficients c = fit.coefficients(n);
                   const Estimate e = {
                       {c[0], c[1], c[2]},
                       {fit.variance(0, n), fit.variance(1, n), fit.variance(2, n)}};
                   if(!std::all_of(estimates.begin(), estimates.begin() + size,
                                   [&](const Estimate& other) { return agree(e, other); }))
                     continue;
                   is_any = true;
                   estimates[size++] = e;
                   if(e.variance[0] < least)
                   {
                     least = e.variance[0];
                     choice = {scale, n};
                     result = c;
                   }
                 }
                 return is_any;
               });
    return result;
  }

  // The fit that is chosen.
  Quadric_fit::Coefficients fit(Index i, Scratch& scratch, const Choice& choice) const
  {
    Quadric_fit::Coefficients result = {};
    if(is_noisy(i))
      visit_fits(i, scratch,
                 [&](int scale, const Quadric_fit& fit, int number)
                 {
                   if(scale < choice.scale)
                     return true;
                   if(number > 0)
                     result = fit.coefficients(std::min(number, choice.number));
                   return false;
                 });
    return result;
  }

  // The mean of what the neighbours' fits suggest, such that no step is left between surfels.
  Surfel blended(Index i, const std::vector<Quadric_fit::Coefficients>& fits) const
  {
    const Spatial& point = m_scan.point[i];
    double farthest = 0., weights = 0.;
    for(const Index* j = m_scan.near.begin(i); j != m_scan.near.end(i); ++j)
      farthest = std::max(farthest, norm(m_scan.point[*j] - point));
    Surfel sum = {{0., 0., 0.}, {0., 0., 0.}};
    for(const Index* j = m_scan.near.begin(i); j != m_scan.near.end(i); ++j)
    {
      if(!is_noisy(*j))
        continue;
      const double ratio = farthest > 0. ? norm(m_scan.point[*j] - point) / farthest : 0.;
      const double weight = std::pow(1. - 0.9 * ratio * ratio, 2);
      const Surfel one = Chart(m_scan, *j).moved(point, fits[*j]);
      sum.point = sum.point + weight * one.point;
      sum.normal = sum.normal + weight * one.normal;
      weights += weight;
    }
    if(!(weights > 0.))
      return {point, m_scan.up[i]};
    return {(1. / weights) * sum.point, unit(sum.normal)};
  }

private:
  // Of the height and the slopes.
  struct Estimate
  {
    std::array<double, 3> value, variance;
  };

  // Whether the difference of two estimates, one of which has used what the other has, is chance.
  static bool agree(const Estimate& a, const Estimate& b)
  {
    for(int k = 0; k < 3; ++k)
    {
      const double difference = a.value[k] - b.value[k];
      const double most = k == 0 ? agreement : slope_agreement;
      if(difference * difference > most * most * std::abs(a.variance[k] - b.variance[k]))
        return false;
    }
    return true;
  }

  bool is_noisy(Index i) const
  {
    return m_scan.spacing[i] > 0. && m_variances.height[i] > 0. && m_variances.slope[i] > 0.;
  }

  // Sorts the surfels, or the clusters, between two scales into rings.
  void find_rings(Index i, int begin, int end, Scratch& scratch) const
  {
    const bool is_clustered = begin >= first_clustered;
    const double square = m_scan.spacing[i] * m_scan.spacing[i];
    const std::vector<Spatial>& points = is_clustered ? m_clusters.point : m_scan.point;
    (is_clustered ? m_clusters.tree : m_scan.tree)
        .within(points, m_scan.point[i], square * m_squared_radius[end - 1], scratch.found);
    for(int scale = begin; scale < end; ++scale)
      scratch.rings[scale].clear();
    for(const Index j : scratch.found)
    {
      const Spatial way = points[j] - m_scan.point[i];
      const double distance = dot(way, way) / square;
      if(begin > 0 && distance <= m_squared_radius[begin - 1])
        continue;
      int ring = begin;
      while(ring + 1 < end && distance > m_squared_radius[ring])
        ++ring;
      scratch.rings[ring].push_back(j);
    }
  }

  // The fits at all radii, from the first one on, until visit(scale, fit, number) is false: with so
  // many coefficients.
  template <typename Visit>
  void visit_fits(Index i, Scratch& scratch, Visit visit) const
  {
    const Chart chart(m_scan, i);
    const double most = outlying * std::sqrt(m_variances.height[i]);
    const double height_weight = 1. / m_variances.height[i],
                 slope_weight = 1. / m_variances.slope[i];
    Quadric_fit fit;
    Quadric_fit::Coefficients last = {};
    bool has_last = false;
    int known = 0; // scales whose rings are found
    for(int scale = 0; scale < scales; ++scale)
    {
      if(scale == known)
      {
        known = scale < first_clustered ? first_clustered : std::min(scale + 3, scales);
        find_rings(i, scale, known, scratch);
      }
      for(const Index j : scratch.rings[scale])
      {
        Chart::Seen seen;
        const double number = scale < first_clustered ? 1. : double(cluster_size);
        if(!(scale < first_clustered ? chart.see(m_scan.point[j], m_scan.normal[j], seen)
                                     : chart.see(m_clusters.samples[j], seen)))
          continue;
        if(has_last)
          Chart::straighten(last, seen);
        if(has_last && std::abs(seen.height - Quadric_fit::height(last, seen.place)) > most)
          continue;
        fit.add_height(number * height_weight, seen.place, seen.height);
        fit.add_slopes(number * slope_weight, seen.place, seen.slope_x, seen.slope_y);
      }
      const int number = fit.factorize();
      if(number == 6)
      {
        last = fit.coefficients(6);
        has_last = true;
      }
      if(!visit(scale, fit, number))
        return;
    }
  }

  const Scan& m_scan;
  Variances m_variances;
  Clusters m_clusters;
  std::array<double, scales> m_squared_radius; // in spacings
};

} // namespace

double noise_level(const std::vector<Spatial>& points, std::vector<Spatial> normals,
                   unsigned threads)
{
  Scan scan(points, std::move(normals), threads);
  return scan.size() == 0 ? 0. : median(scan.rise);
}

void denoise(std::vector<Spatial>& points, std::vector<Spatial>& normals, unsigned threads)
{
  const Scan scan(points, normals, threads);
  const std::size_t n = scan.size();
  if(n == 0)
    return;
  const Denoiser denoiser(scan, threads);
  std::vector<Choice> choices(n);
  std::vector<Quadric_fit::Coefficients> fits(n);
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   Denoiser::Scratch scratch;
                   for(Index i = Index(begin); i < end; ++i)
                     fits[i] = denoiser.choose(i, scratch, choices[i]);
                 });
  // Chance makes some of the choices too small: of the neighbours' the median counts.
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   Denoiser::Scratch scratch;
                   std::vector<Choice> around;
                   for(Index i = Index(begin); i < end; ++i)
                   {
                     around.clear();
                     for(const Index* j = scan.near.begin(i); j != scan.near.end(i); ++j)
                       around.push_back(choices[*j]);
                     const Choice choice = median(around);
                     if(!(choice == choices[i]))
                       fits[i] = denoiser.fit(i, scratch, choice);
                   }
                 });
  std::vector<Surfel> surfels(n);
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index i = Index(begin); i < end; ++i)
                     surfels[i] = denoiser.blended(i, fits);
                 });
  const int exponent = std::ilogb(scan.frame.scale);
  for(std::size_t i = 0; i < n; ++i)
  {
    Spatial& point = points[scan.order[i]];
    for(int k = 0; k < 3; ++k)
      point[k] += std::ldexp(surfels[i].point[k] - scan.point[i][k], exponent);
    normals[scan.order[i]] = surfels[i].normal;
  }
}

} // namespace CGAL::Geodesic_processing::internal
