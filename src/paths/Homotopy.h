// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_HOMOTOPY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_HOMOTOPY_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include "paths/fans.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Decides whether closed curves on a mesh are contractible.
//
// A spanning tree of triangles, joined across edges, leaves a graph of edges. A spanning forest of
// this graph leaves one edge for each generator of the fundamental group. If a component has a
// boundary, the trees of the forest are rooted at the boundary. Then the group is free. Otherwise
// the crossings around the root are the only relator, of length 4 genus. A curve is a word: it
// contains a generator for each crossing of the generator's edge. Instead of crossing an edge of
// the forest, the curve passes around the subtree.
//
// Words are reduced freely, and by Dehn's algorithm if the genus is at least 2 (Lyndon and Schupp
// 1977, Theorem V.4.4). On a torus, exponents are summed.
//
// The fans of a nonmanifold vertex are different vertices.
//
// O(n) time and memory; a curve takes O(genus) per crossed edge.
class CGAL_GEODESIC_PROCESSING_EXPORT Homotopy
{
public:
  // A generator is an even number, and its inverse is the next odd number.
  using Word = std::vector<Index>;

  // The arrays of a mesh. They must exist as long as this object.
  explicit Homotopy(const Surface_arrays& triangles);

  std::size_t number_of_generators() const { return m_relator_length.size(); }

  // Returns the word of a curve that crosses these halfedges, each in the triangle that is left.
  Word word(const std::vector<Index>& crossed_halfedges) const;
  // Returns a word of the same group element, freely reduced. It is empty if the element is the
  // neutral one.
  Word reduced(const Word& word) const;

  static Word inverse(const Word& word);
  // Returns whether two words are the same element.
  bool is_equal(const Word& a, const Word& b) const;

  // Returns whether a closed curve that crosses these halfedges is contractible.
  bool is_contractible(const std::vector<Index>& crossed_halfedges) const
  {
    return reduced(word(crossed_halfedges)).empty();
  }

private:
  std::vector<Index> grow_forest();
  void find_generators();
  void order_crossings(Index root);
  void set_relator(std::size_t begin);
  Word reduced_on_torus(const Word& word) const;

  const Surface_arrays& t;
  Fans m_fans;
  std::vector<Index> m_parent_halfedge;    // #fans: leads to the parent; none at a root
  std::vector<Index> m_letter;             // #halfedges: of crossing it; none if in no word
  std::vector<Index> m_crossings;          // around the trees, counterclockwise
  std::vector<std::size_t> m_begin, m_end; // #fans: the crossings around the subtree
  // 2 #generators: the next letter in the relator, and in its inverse
  std::array<std::vector<Index>, 2> m_next_letter;
  std::vector<Index> m_relator_length; // #generators: 0 if the group is free
};

// Returns the halfedges that a closed path crosses, each in the triangle that is left. The path
// passes vertices on either side. Consecutive locations lie in a common triangle, and the last one
// is the first one. If the path joins two fans of a vertex, returns nothing.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<std::vector<Index>>
crossed_halfedges(const Surface_arrays& triangles,
                  const std::vector<Surface_location>& closed_path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_HOMOTOPY_H
