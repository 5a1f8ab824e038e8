// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/denoise.h"

#include "numerics/Quadric_fit.h"
#include "surfels/Surfel_frame.h"
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::size_t number_of_neighbors = 24;

// Radii of the fits, divided by the spacing. The smallest one contains 24 surfels of a plane.
constexpr int number_of_scales = 12;
constexpr double smallest_radius = 2.8, radius_ratio = 1.25;
// Fits at this scale and above use the means of clusters instead of single surfels.
constexpr int first_clustered_scale = 5;
constexpr Index cluster_size = 8;

// Maximum differences of heights and slopes between consistent estimates, and maximum distance of a
// surfel from a fit, in standard deviations. The slopes of scans are correlated: with a slope
// tolerance of 3, the error of paths on a simulated scan of a plane was 0.060 % instead of 0.046 %.
constexpr double height_tolerance = 3., slope_tolerance = 5., residual_tolerance = 3.5;

template <typename Value>
Value median(std::vector<Value>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A cloud in the order of its tree, with statistics of the neighborhood of each surfel (#surfels).
struct Denoising_cloud
{
  Frame frame;
  std::vector<Vec3> point, normal;
  std::vector<Index> order;
  Kd_tree tree;
  Ragged_rows neighbors;         // the surfel itself, and its nearest ones with similar normals
  std::vector<Vec3> mean_normal; // unit mean of the neighbors' normals
  std::vector<double> spacing;   // square root of the area per surfel
  std::vector<double> noise;     // median height of the neighbors, in spacings

  Denoising_cloud(std::vector<Vec3> points, std::vector<Vec3> normals, unsigned number_of_threads);
  std::size_t size() const { return point.size(); }
};

Denoising_cloud::Denoising_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
                                 unsigned number_of_threads)
    : frame(unit_frame(points)), point(std::move(points)), neighbors(point.size()),
      mean_normal(point.size()), spacing(point.size()), noise(point.size())
{
  check_sizes(point.size(), normals.size(), 0);
  normalize(normals);
  to_frame(point, frame);
  tree = Kd_tree(point, order, number_of_threads);
  for(const Index i : order)
    normal.push_back(normals[i]);
  visit_nearest(
      point, tree, number_of_neighbors, number_of_threads,
      [&](std::size_t block, Index i, const std::vector<Kd_tree::Neighbor>& found)
      {
        std::vector<double> offsets = {0.};
        Vec3 sum = normal[i];
        neighbors.buffer(block).push_back(i);
        for(const auto& [squared_distance, j] : found)
          if(j != i && dot(normal[i], normal[j]) > min_normal_cosine)
          {
            neighbors.buffer(block).push_back(j);
            sum = sum + normal[j];
            offsets.push_back(0.5 * std::abs(dot(normal[i] + normal[j], point[j] - point[i])));
          }
        neighbors.end_row(block, i);
        mean_normal[i] = unit(sum);
        spacing[i] =
            std::sqrt(pi * found.back().squared_distance / std::max<double>(1., found.size() - 1.));
        noise[i] = spacing[i] > 0. ? median(offsets) / spacing[i] : 0.;
      });
  neighbors.join();
}

// Returns the frame of surfel i, whose spacing must be positive.
Surfel_frame frame_of(const Denoising_cloud& cloud, Index i)
{
  return {cloud.point[i], cloud.mean_normal[i], cloud.spacing[i]};
}

// Variances of heights, in squared spacings, and of slopes.
struct Variances
{
  std::vector<double> height, slope; // #surfels
};

// Returns the variances of the residuals of quadrics that are fitted to the neighbors of each
// surfel. `slope_weight` is the weight of slopes relative to heights.
Variances residual_variances(const Denoising_cloud& cloud, double slope_weight,
                             unsigned number_of_threads)
{
  Variances result = {std::vector<double>(cloud.size(), 0.), std::vector<double>(cloud.size(), 0.)};
  for_each_block(
      cloud.size(), surfel_block_size, number_of_threads,
      [&](std::size_t, std::size_t begin, std::size_t end)
      {
        std::vector<Surfel_frame::Sample> samples;
        for(Index i = Index(begin); i < end; ++i)
        {
          if(!(cloud.spacing[i] > 0.))
            continue;
          const Surfel_frame surfel_frame = frame_of(cloud, i);
          Quadric_fit fit;
          samples.clear();
          Surfel_frame::Sample sample;
          for(const Index* j = cloud.neighbors.begin(i); j != cloud.neighbors.end(i); ++j)
            if(surfel_frame.project(cloud.point[*j], cloud.normal[*j], sample))
            {
              samples.push_back(sample);
              fit.add_height(1., sample.monomials, sample.height);
              fit.add_slopes(slope_weight, sample.monomials, sample.slope_x, sample.slope_y);
            }
          if(fit.factorize() < 6)
            continue;
          const Quadric_fit::Coefficients c = fit.coefficients(6);
          double height_sum = 0., slope_sum = 0.;
          for(const auto& [p, height, slope_x, slope_y] : samples)
          {
            const double h = height - Quadric_fit::height(c, p);
            const double a = slope_x - c[1] - c[3] * p.x - c[4] * p.y;
            const double b = slope_y - c[2] - c[4] * p.x - c[5] * p.y;
            height_sum += h * h;
            slope_sum += a * a + b * b;
          }
          // The fit has six degrees of freedom, about three of which are determined by the heights.
          const double n = double(samples.size());
          result.height[i] = height_sum / std::max(1., n - 3.);
          result.slope[i] = slope_sum / std::max(1., 2. * n - 3.);
        }
      });
  return result;
}

// Estimates the variances at each surfel by the medians over its neighbors.
Variances estimate_variances(const Denoising_cloud& cloud, unsigned number_of_threads)
{
  // Begin with equal variances of heights (in spacings) and slopes; then weight by the medians
  // found.
  Variances result = residual_variances(cloud, 1., number_of_threads);
  const double slope = median(result.slope), height = median(result.height);
  const Variances refined =
      residual_variances(cloud, slope > 0. ? height / slope : 1., number_of_threads);
  for_each_block(cloud.size(), surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   std::vector<double> heights, slopes;
                   for(Index i = Index(begin); i < end; ++i)
                   {
                     heights.clear();
                     slopes.clear();
                     for(const Index* j = cloud.neighbors.begin(i); j != cloud.neighbors.end(i);
                         ++j)
                     {
                       const double ratio = cloud.spacing[*j] / cloud.spacing[i];
                       heights.push_back(ratio * ratio * refined.height[*j]);
                       slopes.push_back(refined.slope[*j]);
                     }
                     result.height[i] = median(heights);
                     result.slope[i] = median(slopes);
                   }
                 });
  return result;
}

// The means of each `cluster_size` consecutive surfels in the order of the tree. Groups that are
// too large, or whose normals differ because they are on several sheets, are omitted.
struct Clusters
{
  std::vector<Surfel_mean> means;
  std::vector<Vec3> point; // #means: in the order of the tree
  Kd_tree tree;            // of the means
};

// Computes the clusters of a cloud. O(n log n).
Clusters build_clusters(const Denoising_cloud& cloud, unsigned number_of_threads)
{
  std::vector<Surfel_mean> means;
  Clusters result;
  constexpr double weight = 1. / cluster_size;
  for(Index begin = 0; begin + cluster_size <= cloud.size(); begin += cluster_size)
  {
    const Index end = begin + cluster_size;
    Surfel_mean mean;
    double spacing = 0.;
    for(Index i = begin; i < end; ++i)
    {
      mean.point = mean.point + weight * cloud.point[i];
      mean.normal = mean.normal + weight * cloud.normal[i];
      spacing = std::max(spacing, cloud.spacing[i]);
    }
    bool is_cluster = true;
    for(Index i = begin; i < end; ++i)
    {
      const Vec3 offset = cloud.point[i] - mean.point;
      is_cluster = is_cluster && norm(offset) < 5. * spacing &&
                   dot(cloud.normal[i], mean.normal) > min_normal_cosine;
      for(int k = 0; k < 3; ++k)
      {
        mean.covariance[k] += weight * offset[k] * offset[k];
        mean.covariance[3 + k] += weight * offset[(k + 1) % 3] * offset[(k + 2) % 3];
      }
    }
    if(is_cluster)
    {
      means.push_back(mean);
      result.point.push_back(mean.point);
    }
  }
  std::vector<Index> order;
  result.tree = Kd_tree(result.point, order, number_of_threads);
  for(const Index i : order)
    result.means.push_back(means[i]);
  return result;
}

// A fit: the index of its radius, and its number of coefficients (3 for a plane, 6 for a quadric).
struct Fit_choice
{
  int scale = 0, count = 3;

  friend bool operator==(const Fit_choice& a, const Fit_choice& b)
  {
    return a.scale == b.scale && a.count == b.count;
  }
  // Orders fits by their variance, largest first. The variance of a plane is that of a quadric
  // through four times as many surfels, whose radius is three scales larger.
  friend bool operator<(const Fit_choice& a, const Fit_choice& b)
  {
    const int rank_a = a.scale + (a.count == 3 ? 3 : 0), rank_b = b.scale + (b.count == 3 ? 3 : 0);
    return rank_a != rank_b ? rank_a < rank_b : a.scale < b.scale;
  }
};

// Fits planes and quadrics at increasing radii to the neighborhoods of surfels.
class Denoiser
{
public:
  // Arrays that a thread reuses.
  struct Scratch
  {
    std::vector<Index> found;
    std::array<std::vector<Index>, number_of_scales> rings;
  };

  Denoiser(const Denoising_cloud& cloud, unsigned number_of_threads)
      : m_cloud(cloud), m_variances(estimate_variances(cloud, number_of_threads)),
        m_clusters(build_clusters(cloud, number_of_threads))
  {
    for(int k = 0; k < number_of_scales; ++k)
    {
      const double radius = smallest_radius * std::pow(radius_ratio, k);
      m_squared_radius[k] = radius * radius;
    }
  }

  // Returns the fit with the smallest variance that is consistent with all fits accepted before it
  // (Lepski 1991), and sets `choice`. If the surfel has no noise, returns zero coefficients.
  Quadric_fit::Coefficients choose_fit(Index i, Scratch& scratch, Fit_choice& choice) const
  {
    Quadric_fit::Coefficients result = {};
    choice = {};
    if(!is_noisy(i))
      return result;
    std::array<Estimate, 2 * number_of_scales> estimates;
    std::size_t size = 0;
    double min_variance = infinity;
    visit_fits(i, scratch,
               [&](int scale, const Quadric_fit& fit, int count)
               {
                 bool has_estimate = count < 6;
                 for(const int n : {6, 3})
                 {
                   if(n > count)
                     continue;
                   const Quadric_fit::Coefficients c = fit.coefficients(n);
                   const Estimate e = {
                       {c[0], c[1], c[2]},
                       {fit.variance(0, n), fit.variance(1, n), fit.variance(2, n)}};
                   if(!std::all_of(estimates.begin(), estimates.begin() + size,
                                   [&](const Estimate& other) { return are_consistent(e, other); }))
                     continue;
                   has_estimate = true;
                   estimates[size++] = e;
                   if(e.variance[0] < min_variance)
                   {
                     min_variance = e.variance[0];
                     choice = {scale, n};
                     result = c;
                   }
                 }
                 return has_estimate;
               });
    return result;
  }

  // Returns the fit for a given choice.
  Quadric_fit::Coefficients fit(Index i, Scratch& scratch, const Fit_choice& choice) const
  {
    Quadric_fit::Coefficients result = {};
    if(is_noisy(i))
      visit_fits(i, scratch,
                 [&](int scale, const Quadric_fit& fit, int count)
                 {
                   if(scale < choice.scale)
                     return true;
                   if(count > 0)
                     result = fit.coefficients(std::min(count, choice.count));
                   return false;
                 });
    return result;
  }

  // Returns the weighted mean of the projections of a surfel to the fits of its neighbors. So
  // there are no jumps between surfels with different choices.
  Surfel blended_surfel(Index i, const std::vector<Quadric_fit::Coefficients>& fits) const
  {
    const Vec3& point = m_cloud.point[i];
    double max_distance = 0., weight_sum = 0.;
    for(const Index* j = m_cloud.neighbors.begin(i); j != m_cloud.neighbors.end(i); ++j)
      max_distance = std::max(max_distance, norm(m_cloud.point[*j] - point));
    Surfel sum = {{0., 0., 0.}, {0., 0., 0.}};
    for(const Index* j = m_cloud.neighbors.begin(i); j != m_cloud.neighbors.end(i); ++j)
    {
      if(!is_noisy(*j))
        continue;
      const double ratio = max_distance > 0. ? norm(m_cloud.point[*j] - point) / max_distance : 0.;
      const double root = 1. - 0.9 * ratio * ratio, weight = root * root;
      const Surfel moved = frame_of(m_cloud, *j).moved_to_fit(point, fits[*j]);
      sum.point = sum.point + weight * moved.point;
      sum.normal = sum.normal + weight * moved.normal;
      weight_sum += weight;
    }
    if(!(weight_sum > 0.))
      return {point, m_cloud.mean_normal[i]};
    return {(1. / weight_sum) * sum.point, unit(sum.normal)};
  }

private:
  // The height and both slopes at the surfel.
  struct Estimate
  {
    std::array<double, 3> value, variance;
  };

  // Returns true if the difference of two estimates is explained by noise. One estimate uses all
  // surfels of the other, so the variance of the difference is the difference of the variances.
  static bool are_consistent(const Estimate& a, const Estimate& b)
  {
    for(int k = 0; k < 3; ++k)
    {
      const double difference = a.value[k] - b.value[k];
      const double tolerance = k == 0 ? height_tolerance : slope_tolerance;
      if(difference * difference > tolerance * tolerance * std::abs(a.variance[k] - b.variance[k]))
        return false;
    }
    return true;
  }

  // Returns false if the neighborhood has no extent or fits it exactly.
  // Then the surfel is not moved.
  bool is_noisy(Index i) const
  {
    return m_cloud.spacing[i] > 0. && m_variances.height[i] > 0. && m_variances.slope[i] > 0.;
  }

  // Sorts the surfels, or the clusters, of the scales begin .. end - 1 into rings: ring k contains
  // those between the radii of scales k - 1 and k.
  void sort_into_rings(Index i, int begin, int end, Scratch& scratch) const
  {
    const bool is_clustered = begin >= first_clustered_scale;
    const double squared_spacing = m_cloud.spacing[i] * m_cloud.spacing[i];
    const std::vector<Vec3>& points = is_clustered ? m_clusters.point : m_cloud.point;
    (is_clustered ? m_clusters.tree : m_cloud.tree)
        .within(points, m_cloud.point[i], squared_spacing * m_squared_radius[end - 1],
                scratch.found);
    for(int scale = begin; scale < end; ++scale)
      scratch.rings[scale].clear();
    for(const Index j : scratch.found)
    {
      const Vec3 offset = points[j] - m_cloud.point[i];
      const double squared_distance = dot(offset, offset) / squared_spacing;
      if(begin > 0 && squared_distance <= m_squared_radius[begin - 1])
        continue;
      int ring = begin;
      while(ring + 1 < end && squared_distance > m_squared_radius[ring])
        ++ring;
      scratch.rings[ring].push_back(j);
    }
  }

  // Calls visit(scale, fit, count) for the fits at increasing radii, until it returns false.
  // `count` is the number of coefficients that the samples determine: 0, 3 or 6.
  template <typename Visit>
  void visit_fits(Index i, Scratch& scratch, Visit visit) const
  {
    const Surfel_frame surfel_frame = frame_of(m_cloud, i);
    const double max_residual = residual_tolerance * std::sqrt(m_variances.height[i]);
    const double height_weight = 1. / m_variances.height[i],
                 slope_weight = 1. / m_variances.slope[i];
    Quadric_fit fit;
    Quadric_fit::Coefficients previous_fit = {};
    bool has_previous_fit = false;
    int number_of_sorted_scales = 0; // number of scales whose rings are computed
    for(int scale = 0; scale < number_of_scales; ++scale)
    {
      if(scale == number_of_sorted_scales)
      {
        number_of_sorted_scales = scale < first_clustered_scale
                                      ? first_clustered_scale
                                      : std::min(scale + 3, number_of_scales);
        sort_into_rings(i, scale, number_of_sorted_scales, scratch);
      }
      for(const Index j : scratch.rings[scale])
      {
        Surfel_frame::Sample sample;
        const double count = scale < first_clustered_scale ? 1. : double(cluster_size);
        if(!(scale < first_clustered_scale
                 ? surfel_frame.project(m_cloud.point[j], m_cloud.normal[j], sample)
                 : surfel_frame.project(m_clusters.means[j], sample)))
          continue;
        if(has_previous_fit)
          Surfel_frame::remove_higher_order_terms(previous_fit, sample);
        if(has_previous_fit &&
           std::abs(sample.height - Quadric_fit::height(previous_fit, sample.monomials)) >
               max_residual)
          continue;
        fit.add_height(count * height_weight, sample.monomials, sample.height);
        fit.add_slopes(count * slope_weight, sample.monomials, sample.slope_x, sample.slope_y);
      }
      const int count = fit.factorize();
      if(count == 6)
      {
        previous_fit = fit.coefficients(6);
        has_previous_fit = true;
      }
      if(!visit(scale, fit, count))
        return;
    }
  }

  const Denoising_cloud& m_cloud;
  Variances m_variances;
  Clusters m_clusters;
  std::array<double, number_of_scales> m_squared_radius; // in spacings
};

} // namespace

double noise_level(const std::vector<Vec3>& points, std::vector<Vec3> normals,
                   unsigned number_of_threads)
{
  Denoising_cloud cloud(points, std::move(normals), number_of_threads);
  return cloud.size() == 0 ? 0. : median(cloud.noise);
}

void denoise(std::vector<Vec3>& points, std::vector<Vec3>& normals, unsigned number_of_threads)
{
  const Denoising_cloud cloud(points, normals, number_of_threads);
  const std::size_t n = cloud.size();
  if(n == 0)
    return;
  const Denoiser denoiser(cloud, number_of_threads);
  std::vector<Fit_choice> choices(n);
  std::vector<Quadric_fit::Coefficients> fits(n);
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   Denoiser::Scratch scratch;
                   for(Index i = Index(begin); i < end; ++i)
                     fits[i] = denoiser.choose_fit(i, scratch, choices[i]);
                 });
  // By chance, some choices are too small: use the median of the neighbors' choices.
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   Denoiser::Scratch scratch;
                   std::vector<Fit_choice> neighbor_choices;
                   for(Index i = Index(begin); i < end; ++i)
                   {
                     neighbor_choices.clear();
                     for(const Index* j = cloud.neighbors.begin(i); j != cloud.neighbors.end(i);
                         ++j)
                       neighbor_choices.push_back(choices[*j]);
                     const Fit_choice choice = median(neighbor_choices);
                     if(!(choice == choices[i]))
                       fits[i] = denoiser.fit(i, scratch, choice);
                   }
                 });
  std::vector<Surfel> surfels(n);
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index i = Index(begin); i < end; ++i)
                     surfels[i] = denoiser.blended_surfel(i, fits);
                 });
  const int exponent = std::ilogb(cloud.frame.scale);
  for(std::size_t i = 0; i < n; ++i)
  {
    Vec3& point = points[cloud.order[i]];
    for(int k = 0; k < 3; ++k)
      point[k] += std::ldexp(surfels[i].point[k] - cloud.point[i][k], exponent);
    normals[cloud.order[i]] = surfels[i].normal;
  }
}

} // namespace CGAL::Geodesic_processing::internal
