// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_COVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_COVER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include "paths/Homotopy.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A part of the universal cover of a mesh. It consists of copies of triangles. Each copy has the
// word of a path from copy 0 to it.
class CGAL_GEODESIC_PROCESSING_EXPORT Cover
{
public:
  using Word = Homotopy::Word;

  // The first copy is that of a triangle; its word is empty.
  Cover(const Surface_arrays& triangles, const Homotopy& homotopy, Index triangle);

  Index size() const { return Index(m_triangle.size()); }
  Index triangle(Index copy) const { return m_triangle[copy]; }
  const Word& word(Index copy) const { return m_word[copy]; }
  // Returns the copies of a triangle.
  const std::vector<Index>& copies(Index triangle) const;

  // Returns a copy; adds it if it does not exist.
  Index copy(Index triangle, const Word& word);
  // Adds the copy across a halfedge that is_open().
  Index add_across(Index h) { return add(m_triangles.twin[base(h)] / 3, word_across(h)); }
  // Returns the halfedge of the mesh.
  Index base(Index h) const { return 3 * m_triangle[h / 3] + h % 3; }
  // Returns whether the triangle across a halfedge of the cover is missing.
  bool is_open(Index h) const { return m_twin[h] == none && m_triangles.twin[base(h)] != none; }

  // Returns the arrays of the copies, with the scale of the mesh times `factor`.
  std::shared_ptr<const Surface_arrays> arrays(double& factor) const;

private:
  Word word_across(Index h) const;
  Index find(Index triangle, const Word& word) const;
  Index add(Index triangle, Word word);

  const Surface_arrays& m_triangles;
  const Homotopy& m_homotopy;
  std::vector<Index> m_triangle;                          // #copies
  std::vector<Word> m_word;                               // #copies
  std::vector<Index> m_twin;                              // 3 #copies
  std::unordered_map<Index, std::vector<Index>> m_copies; // by triangle
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_COVER_H
