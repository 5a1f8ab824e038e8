// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>

#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::size_t leaf_size = 12;
// Number of points that a thread copies at a time.
constexpr std::size_t block_size = 4096;

double squared_distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return x * x + y * y + z * z;
}

} // namespace

// Sorts the points into the nodes of a tree whose number of levels is known.
class Kd_tree::Builder
{
public:
  Builder(Kd_tree& tree, const std::vector<Point>& points, unsigned number_of_threads)
      : m_tree(tree), m_threads(number_of_threads), m_entries(points.size())
  {
    for_each_block(m_entries.size(), block_size, m_threads,
                   [&](std::size_t, std::size_t begin, std::size_t end)
                   {
                     for(std::size_t i = begin; i < end; ++i)
                       m_entries[i] = {points[i], static_cast<Index>(i)};
                   });
  }

  // Splits all nodes. Threads process the nodes of one upper level in parallel, then whole
  // subtrees.
  void split_all()
  {
    const unsigned upper = std::min(m_tree.m_levels, m_threads > 1 ? 4u : 0u);
    for(unsigned level = 0; level < upper; ++level)
      for_each_block(std::size_t(1) << level, 1, m_threads,
                     [&](std::size_t node, std::size_t, std::size_t) { split(level, node); });
    for_each_block(std::size_t(1) << upper, 1, m_threads,
                   [&](std::size_t root, std::size_t, std::size_t) { split_subtree(upper, root); });
  }

  // Writes the sorted points and the former index of each point.
  void store(std::vector<Point>& points, std::vector<Index>& order) const
  {
    for_each_block(m_entries.size(), block_size, m_threads,
                   [&](std::size_t, std::size_t begin, std::size_t end)
                   {
                     for(std::size_t i = begin; i < end; ++i)
                     {
                       points[i] = m_entries[i].point;
                       order[i] = m_entries[i].position;
                     }
                   });
  }

private:
  struct Entry
  {
    Point point;
    Index position;
  };

  // Computes the box of a node, and partitions its points at the median along the longest axis.
  void split(unsigned level, std::size_t node)
  {
    const auto first = m_entries.begin() + m_tree.begin(node, level);
    const auto last = m_entries.begin() + m_tree.begin(node + 1, level);
    Box box = {first->point, first->point};
    for(auto entry = first; entry != last; ++entry)
      for(int k = 0; k < 3; ++k)
      {
        box.low[k] = std::min(box.low[k], entry->point[k]);
        box.high[k] = std::max(box.high[k], entry->point[k]);
      }
    m_tree.m_boxes[(std::size_t(1) << level) - 1 + node] = box;
    int axis = 0;
    for(int k = 1; k < 3; ++k)
      if(box.high[k] - box.low[k] > box.high[axis] - box.low[axis])
        axis = k;
    const auto less = [axis](const Entry& a, const Entry& b)
    {
      return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis]
             : a.point != b.point           ? a.point < b.point
                                            : a.position < b.position;
    };
    if(level == m_tree.m_levels)
      std::sort(first, last, less);
    else
      std::nth_element(first, m_entries.begin() + m_tree.begin(2 * node + 1, level + 1), last,
                       less);
  }

  // Splits a node and its descendants depth first, so that their points stay in the cache.
  void split_subtree(unsigned root_level, std::size_t root)
  {
    std::vector<std::pair<unsigned, std::size_t>> stack{{root_level, root}};
    while(!stack.empty())
    {
      const auto [level, node] = stack.back();
      stack.pop_back();
      split(level, node);
      if(level < m_tree.m_levels)
      {
        stack.emplace_back(level + 1, 2 * node + 1);
        stack.emplace_back(level + 1, 2 * node);
      }
    }
  }

  Kd_tree& m_tree;
  unsigned m_threads;
  std::vector<Entry> m_entries;
};

Kd_tree::Kd_tree(std::vector<Point>& points, std::vector<Index>& order, unsigned number_of_threads)
    : m_size(points.size())
{
  order.resize(m_size);
  if(m_size == 0)
    return;
  while(m_size > leaf_size << m_levels)
    ++m_levels;
  m_boxes.resize((std::size_t(2) << m_levels) - 1);
  Builder builder(*this, points, number_of_threads);
  builder.split_all();
  builder.store(points, order);
}

void Kd_tree::scale(double factor)
{
  for(Box& box : m_boxes)
    for(int k = 0; k < 3; ++k)
    {
      box.low[k] *= factor;
      box.high[k] *= factor;
    }
}

// Calls visit(begin, end) for the leaves within the squared distance `bound`, approximately in the
// order of their distances. `visit` can reduce `bound` through another reference.
template <typename Visit>
void Kd_tree::visit_leaves(const Point& query, const double& bound, Visit&& visit) const
{
  if(m_size == 0)
    return;
  const auto distance = [&](std::size_t box)
  {
    const Box& b = m_boxes[box];
    double sum = 0.;
    for(int k = 0; k < 3; ++k)
    {
      const double d = std::max(std::max(b.low[k] - query[k], query[k] - b.high[k]), 0.);
      sum += d * d;
    }
    return sum;
  };
  struct Pending
  {
    double distance;
    std::size_t node;
    unsigned level;
  };
  std::array<Pending, 34> stack; // one node per level of a tree of 2^32 points, and one sibling
  std::size_t top = 0;
  stack[top++] = {distance(0), 0, 0};
  while(top != 0)
  {
    Pending next = stack[--top];
    if(next.distance > bound)
      continue;
    while(next.level < m_levels)
    {
      const std::size_t left = (std::size_t(2) << next.level) - 1 + 2 * next.node;
      Pending a = {distance(left), 2 * next.node, next.level + 1};
      Pending b = {distance(left + 1), 2 * next.node + 1, next.level + 1};
      if(b.distance < a.distance)
        std::swap(a, b);
      if(b.distance <= bound)
        stack[top++] = b;
      next = a;
    }
    if(next.distance <= bound)
      visit(begin(next.node, next.level), begin(next.node + 1, next.level));
  }
}

void Kd_tree::nearest(const std::vector<Point>& points, const Point& query, std::size_t k,
                      std::vector<Neighbor>& result, double bound) const
{
  result.resize(std::min(k, m_size));
  if(result.empty())
    return;
  std::size_t size = 0;
  visit_leaves(
      query, bound,
      [&](std::size_t begin, std::size_t end)
      {
        // Local copies: the compiler can keep them in registers, as writes cannot alias them.
        const Point* const point = points.data();
        const Point query_point = query;
        Neighbor* const nearest = result.data();
        const std::size_t capacity = result.size();
        double max_squared_distance = bound;
        for(std::size_t i = begin; i < end; ++i)
        {
          const Neighbor found = {squared_distance(point[i], query_point), static_cast<Index>(i)};
          if(found.squared_distance > max_squared_distance ||
             (size == capacity && !(found < nearest[capacity - 1])))
            continue;
          if(size < capacity)
            ++size;
          std::size_t position = size - 1;
          for(; position > 0 && found < nearest[position - 1]; --position)
            nearest[position] = nearest[position - 1];
          nearest[position] = found;
          if(size == capacity)
            max_squared_distance =
                std::min(max_squared_distance, nearest[capacity - 1].squared_distance);
        }
        bound = max_squared_distance;
      });
  result.resize(size);
}

Index Kd_tree::nearest(const std::vector<Point>& points, const Point& query) const
{
  Neighbor best = {infinity, none};
  visit_leaves(
      query, best.squared_distance,
      [&](std::size_t begin, std::size_t end)
      {
        for(std::size_t i = begin; i < end; ++i)
          best = std::min(best, {squared_distance(points[i], query), static_cast<Index>(i)});
      });
  return best.point;
}

std::pair<Index, Index> Kd_tree::ancestor(Index point, std::size_t size) const
{
  for(unsigned level = m_levels; level > 0; --level)
    if(const auto range = node(point, level); range.second - range.first >= size)
      return range;
  return {0, Index(m_size)};
}

bool Kd_tree::leaves_near(const std::vector<Point>& points, Index first, Index last,
                          double squared_distance, std::size_t max_number,
                          std::vector<std::pair<Index, Index>>& result) const
{
  Box query_box = {points[first], points[first]};
  for(Index i = first; i < last; ++i)
    for(int k = 0; k < 3; ++k)
    {
      query_box.low[k] = std::min(query_box.low[k], points[i][k]);
      query_box.high[k] = std::max(query_box.high[k], points[i][k]);
    }
  result.clear();
  std::size_t count = 0;
  std::array<std::pair<std::size_t, unsigned>, 34> stack; // as in visit_leaves()
  std::size_t top = 0;
  stack[top++] = {0, 0};
  while(top != 0)
  {
    const auto [node, level] = stack[--top];
    const Box& box = m_boxes[(std::size_t(1) << level) - 1 + node];
    double sum = 0.;
    for(int k = 0; k < 3; ++k)
    {
      const double d =
          std::max(std::max(box.low[k] - query_box.high[k], query_box.low[k] - box.high[k]), 0.);
      sum += d * d;
    }
    if(sum > squared_distance)
      continue;
    if(level < m_levels)
    {
      stack[top++] = {2 * node + 1, level + 1};
      stack[top++] = {2 * node, level + 1};
      continue;
    }
    result.emplace_back(Index(begin(node, level)), Index(begin(node + 1, level)));
    count += result.back().second - result.back().first;
    if(count > max_number)
      return false;
  }
  return true;
}

void Kd_tree::within(const std::vector<Point>& points, const Point& query, double squared_radius,
                     std::vector<Index>& result) const
{
  result.clear();
  visit_leaves(query, squared_radius,
               [&](std::size_t begin, std::size_t end)
               {
                 for(std::size_t i = begin; i < end; ++i)
                   if(squared_distance(points[i], query) <= squared_radius)
                     result.push_back(static_cast<Index>(i));
               });
  std::sort(result.begin(), result.end());
}

} // namespace CGAL::Geodesic_processing::internal
