// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Arcs to the neighbours that `meet`, nearest first, and back from those that look at us although we
// do not look at them.  All have seen what is nearer than their `reach`.
template <typename Meet>
Site_graph make_graph(const std::vector<Spatial>& point, const Rows& near,
                      const std::vector<double>& reach, unsigned threads, const Meet& meet)
{
  const std::size_t n = point.size();
  Site_graph graph;
  graph.first.assign(n + 1, 0);
  std::vector<std::vector<std::pair<Index, Index>>> missing((n + surfel_block - 1) / surfel_block);
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(const Index* j = near.begin(i); j != near.end(i); ++j)
                     {
                       const double length = norm(point[*j] - point[i]);
                       if(!meet(i, *j, length))
                         continue;
                       ++graph.first[i + 1];
                       if(length > reach[*j] * (1. - 1e-12) &&
                          std::find(near.begin(*j), near.end(*j), i) == near.end(*j))
                         missing[block].emplace_back(*j, i);
                     }
                 });
  // Dealt out to where they begin; those of a site are in their order.
  std::vector<Index> first_back(n + 1, 0);
  for(const auto& part : missing)
    for(const auto& arc : part)
    {
      ++graph.first[arc.first + 1];
      ++first_back[arc.first + 1];
    }
  std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
  std::partial_sum(first_back.begin(), first_back.end(), first_back.begin());
  std::vector<Index> back(first_back.back()), end_of_back = first_back;
  for(const auto& part : missing)
    for(const auto& arc : part)
      back[end_of_back[arc.first]++] = arc.second;
  graph.target.resize(graph.first.back());
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   Index i = static_cast<Index>(begin), arc = graph.first[i];
                   for(; i < end; ++i)
                   {
                     for(const Index* j = near.begin(i); j != near.end(i); ++j)
                       if(meet(i, *j, norm(point[*j] - point[i])))
                         graph.target[arc++] = *j;
                     for(Index k = first_back[i]; k < first_back[i + 1]; ++k)
                       graph.target[arc++] = back[k];
                   }
                 });
  return graph;
}

// Joins sites by arcs, within blocks first, which threads can do side by side, then between them.
void label_components(unsigned threads, Surfel_cloud& cloud)
{
  const Site_graph& graph = cloud.graph;
  std::vector<Index>& label = cloud.component; // a site of the same component, none later
  const std::size_t n = cloud.number_of_sites();
  label.resize(n);
  const auto root = [&](Index site)
  {
    while(label[site] != site)
      site = label[site] = label[label[site]];
    return site;
  };
  const auto join = [&](Index a, Index b)
  {
    a = root(a);
    b = root(b);
    return label[std::max(a, b)] = std::min(a, b);
  };
  std::vector<std::vector<std::pair<Index, Index>>> between((n + surfel_block - 1) / surfel_block);
  for_each_block(n, surfel_block, threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index site = static_cast<Index>(begin); site < end; ++site)
                   {
                     Index own = label[site] = site;
                     for(Index arc = graph.first[site]; arc < graph.first[site + 1]; ++arc)
                       if(const Index other = graph.target[arc]; other < begin)
                         between[block].emplace_back(other, site);
                       else if(other < site && label[other] != own) // most are the same already
                         own = join(other, own);
                   }
                 });
  for(const auto& part : between)
    for(const auto& [a, b] : part)
      join(a, b);
  // In the order of their first sites, each of which is a root.
  for(Index site = 0; site < n; ++site)
    label[site] = label[site] == site ? cloud.number_of_components++ : label[label[site]];
}

} // namespace

Surfel_cloud make_cloud(std::vector<Spatial> points, std::vector<Spatial> normals,
                        const std::vector<double>& radii, const Cloud_options& options,
                        const Frame* frame)
{
  check_sizes(points.size(), normals.size(), radii.size());
  if(!(options.maximum_angle > 0.) || options.maximum_angle > std::acos(-1.) || options.rank == 0 ||
     options.neighbors == 0)
    throw Invalid_argument_error(
        "The angle between neighbours must lie between 0 and pi, and their "
        "number and rank above 0.");
  const Agree agree = {std::cos(options.maximum_angle)};
  normalize(normals);
  Surfel_cloud cloud;
  static_cast<Sorted_surfels&>(cloud) =
      sort_surfels(std::move(points), normals, agree.cosine, options.threads, frame);
  Surroundings around;
  const Rows near = find_neighbors(cloud.point, cloud.normal, cloud.tree, &agree, options.neighbors,
                                   options.threads, around);
  cloud.radius = site_radii(cloud, radii, near, options.rank, options.threads);
  const auto graph = [&](const Rows& rows, const auto& meet)
  { cloud.graph = make_graph(cloud.point, rows, around.seen, options.threads, meet); };
  if(options.graph == Surfel_graph::extended_spheres)
    graph(near, [&](Index i, Index j, double length)
          { return length <= options.influence * (cloud.radius[i] + cloud.radius[j]); });
  else
  {
    const Rows all = find_neighbors(cloud.point, cloud.normal, cloud.tree, nullptr,
                                    options.neighbors, options.threads, around);
    if(options.graph == Surfel_graph::nearest)
      graph(all, [](Index, Index, double) { return true; });
    else
    {
      std::vector<double> nearest(cloud.number_of_sites(), 0.);
      for(Index i = 0; i < nearest.size(); ++i)
        if(all.begin(i) != all.end(i))
          nearest[i] = norm(cloud.point[*all.begin(i)] - cloud.point[i]);
      graph(all,
            [&](Index i, Index j, double length) { return length <= nearest[i] + nearest[j]; });
    }
  }
  label_components(options.threads, cloud);
  cloud.spacing = std::move(around.spacing);
  cloud.seen = std::move(around.seen);
  return cloud;
}

} // namespace CGAL::Geodesic_processing::internal
