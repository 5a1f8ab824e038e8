// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/denoise.h>

#include <CGAL/Geodesic_processing/internal/Quadric_fit.h>
#include <CGAL/Geodesic_processing/internal/locality.h>
#include <CGAL/Geodesic_processing/internal/planar.h>
#include <CGAL/Geodesic_processing/internal/surfel_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstdio>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

double env(const char* n, double d)
{
  const char* s = std::getenv(n);
  return s ? std::atof(s) : d;
}

constexpr std::size_t neighbors = 24;

// Radii of fits in spacings: the first holds 24 surfels of a plane.
const int scales = int(env("SCALES", 12));
constexpr double first_radius = 2.8, growth = 1.25;
// From this one on surfels are taken in clusters.
const int first_clustered = int(env("FIRSTC", 5));
constexpr std::size_t cluster_size = 8;

// In standard deviations: how far estimates may be apart, and surfels from a fit.
const double agreement = env("GAMMA", 3.);
constexpr double outlying = 3.5;

constexpr double normals_agree = 0.5; // 60 degrees: the other side of a thin sheet does not count

double median(std::vector<double>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A surfel, or the means over several.
struct Sample
{
  Spatial point, normal;
  std::array<double, 6> spread = {}; // of the points around their mean: xx, yy, zz, yz, zx, xy
  double number = 1.;
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
  bool see(const Sample& sample, Seen& seen) const
  {
    const double up = dot(sample.normal, m_up);
    if(!(up > normals_agree * norm(sample.normal)))
      return false;
    const Spatial way = m_over * (sample.point - m_origin);
    const double x = dot(way, m_u), y = dot(way, m_v);
    seen = {{x, y, x * x, x * y, y * y},
            dot(way, m_up),
            -dot(sample.normal, m_u) / up,
            -dot(sample.normal, m_v) / up};
    if(sample.number > 1.)
    {
      const double square = m_over * m_over;
      seen.place.xx += square * spread_along(sample.spread, m_u, m_u);
      seen.place.xy += square * spread_along(sample.spread, m_u, m_v);
      seen.place.yy += square * spread_along(sample.spread, m_v, m_v);
    }
    return true;
  }

  // The surfel that the fit suggests.
  void move(const Quadric_fit::Coefficients& c, Spatial& point, Spatial& normal) const
  {
    const Spatial upward = m_up - c[1] * m_u - c[2] * m_v;
    normal = unit(upward);
    point = m_origin + c[0] / m_over * dot(normal, m_up) / norm(upward) * normal;
  }

private:
  Spatial m_origin, m_up, m_u, m_v;
  double m_over;
};

Sample sample(const Scan& scan, Index i) { return {scan.point[i], scan.normal[i]}; }

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
                       if(chart.see(sample(scan, *j), seen))
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

// Means of surfels that are neighbours in the order of the tree; not of those on different sheets.
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
  for(Index begin = 0; begin < scan.size(); begin += cluster_size)
  {
    const Index end = Index(std::min<std::size_t>(scan.size(), begin + cluster_size));
    Sample mean = {{0., 0., 0.}, {0., 0., 0.}, {}, double(end - begin)};
    const double part = 1. / mean.number;
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

// Which fit is taken: the radius, and how many coefficients.
struct Choice
{
  int scale = 0, number = 3;
  // A plane is as sure as a quadric with four times as many surfels.
  int rank() const { return scale + (number == 3 ? 3 : 0); }
};

class Denoiser
{
public:
  Denoiser(const Scan& scan, unsigned threads)
      : m_scan(scan), m_variances(variances(scan, threads)), m_clusters(clusters(scan, threads))
  {}

  // The fits at all radii, from the first one on, until visit(scale, fit) is false.
  template <typename Visit>
  void fits(Index i, Visit visit) const
  {
    const Chart chart(m_scan, i);
    const double spacing = m_scan.spacing[i];
    const double height_weight = 1. / m_variances.height[i],
                 deviation = std::sqrt(m_variances.height[i]);
    const double slope_weight = 1. / m_variances.slope[i];
    Quadric_fit fit;
    Quadric_fit::Coefficients last = {};
    bool has_last = false;
    std::array<std::vector<Sample>, 32> rings;
    double inner = 0., radius = first_radius * spacing;
    std::vector<Index> found;
    for(int scale = 0; scale < scales; ++scale, radius *= growth)
    {
      const bool is_clustered = scale >= first_clustered;
      // The rings of a few radii at a time
      if(scale == 0 || scale == first_clustered ||
         (is_clustered && (scale - first_clustered) % 3 == 0))
      {
        const int number = is_clustered ? 3 : first_clustered;
        const double outer = radius * std::pow(growth, number - 1);
        (is_clustered ? m_clusters.tree : m_scan.tree)
            .within(is_clustered ? m_clusters.point : m_scan.point, m_scan.point[i], outer * outer,
                    found);
        for(const Index j : found)
        {
          const Sample one = is_clustered ? m_clusters.samples[j] : sample(m_scan, j);
          const double distance = norm(one.point - m_scan.point[i]);
          if(is_clustered && distance <= inner)
            continue;
          int ring = scale;
          for(double r = radius; distance > r && ring + 1 < scale + number; r *= growth)
            ++ring;
          rings[ring].push_back(one);
        }
        inner = outer;
      }
      Chart::Seen seen;
      for(const Sample& one : rings[scale])
      {
        if(!chart.see(one, seen))
          continue;
        if(has_last &&
           std::abs(seen.height - Quadric_fit::height(last, seen.place)) > outlying * deviation)
          continue;
        fit.add_height(one.number * height_weight, seen.place, seen.height);
        fit.add_slopes(one.number * slope_weight, seen.place, seen.slope_x, seen.slope_y);
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

  Choice choose(Index i) const
  {
    struct Estimate
    {
      double height, variance;
    };
    std::vector<Estimate> good;
    Choice best;
    double least = infinity;
    if(!is_noisy(i))
      return best;
    fits(i,
         [&](int scale, const Quadric_fit& fit, int number)
         {
           bool any = false;
           std::vector<Estimate> next;
           for(const int n : {6, 3})
           {
             if(n > number)
               continue;
             const Estimate e = {fit.coefficients(n)[0], fit.variance(n)};
             bool agrees = true;
             for(const Estimate& other : good)
               if(other.variance > e.variance &&
                  std::abs(other.height - e.height) >
                      agreement * std::sqrt(other.variance - e.variance))
                 agrees = false;
             for(const Estimate& other : next)
               if(std::abs(other.height - e.height) >
                  agreement * std::sqrt(std::max(0., other.variance - e.variance)))
                 agrees = false;
             if(!agrees)
               continue;
             any = true;
             next.push_back(e);
             if(e.variance < least)
             {
               least = e.variance;
               best = {scale, n};
             }
           }
           good.insert(good.end(), next.begin(), next.end());
           return any || number < 6;
         });
    return best;
  }

  bool is_noisy(Index i) const
  {
    return m_scan.spacing[i] > 0. && m_variances.height[i] > 0. && m_variances.slope[i] > 0.;
  }

  void move(Index i, const Choice& choice, Spatial& point, Spatial& normal) const
  {
    point = m_scan.point[i];
    normal = m_scan.up[i];
    if(is_noisy(i))
      fits(i,
           [&](int scale, const Quadric_fit& fit, int number)
           {
             if(scale < choice.scale)
               return true;
             if(number > 0)
               Chart(m_scan, i).move(fit.coefficients(std::min(number, choice.number)), point,
                                     normal);
             return false;
           });
  }

private:
  const Scan& m_scan;
  Variances m_variances;
  Clusters m_clusters;
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
  const Denoiser denoiser(scan, threads);
  const std::size_t n = scan.size();
  std::vector<Choice> choice(n), smooth(n);
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index i = Index(begin); i < end; ++i)
                     choice[i] = denoiser.choose(i);
                 });
  std::vector<Spatial> moved(n), turned(n);
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   std::vector<Choice> around;
                   for(Index i = Index(begin); i < end; ++i)
                   {
                     // Of the neighbours' choices the median: chance makes some of them too small.
                     around.clear();
                     for(const Index* j = scan.near.begin(i); j != scan.near.end(i); ++j)
                       around.push_back(choice[*j]);
                     const auto middle = around.begin() + std::ptrdiff_t(around.size() / 2);
                     std::nth_element(around.begin(), middle, around.end(),
                                      [](const Choice& a, const Choice& b) {
                                        return std::make_pair(a.rank(), a.scale) <
                                               std::make_pair(b.rank(), b.scale);
                                      });
                     smooth[i] = *middle;
                     denoiser.move(i, *middle, moved[i], turned[i]);
                   }
                 });
  if(env("VERB", 0))
  {
    std::vector<int> hist(scales * 2);
    for(auto k : smooth)
      ++hist[k.scale * 2 + (k.number == 3)];
    std::printf("noise %g scales:", median(const_cast<Scan&>(scan).rise));
    for(int h : hist)
      std::printf(" %d", h);
    std::printf("\n");
  }
  const int exponent = std::ilogb(scan.frame.scale);
  for(std::size_t i = 0; i < n; ++i)
  {
    Spatial& point = points[scan.order[i]];
    for(int k = 0; k < 3; ++k)
      point[k] += std::ldexp(moved[i][k] - scan.point[i][k], exponent);
    normals[scan.order[i]] = turned[i];
  }
}

} // namespace CGAL::Geodesic_processing::internal
