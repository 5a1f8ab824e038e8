// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_gpw.h"

#include "readers/Input_error.h"

#include <CGAL/Geodesic_processing/exceptions.h>
// Not public: decode_wavelets() writes to a halfedge mesh and rejects streams with nonmanifold
// vertices, which the program repairs.
#include <CGAL/Geodesic_processing/internal/subdivision/zerotree.h>

#include <algorithm>

namespace program {

namespace {

// Not public: The include above has the reason.
using CGAL::Geodesic_processing::internal::decode;
using CGAL::Geodesic_processing::internal::decoded_values;
using CGAL::Geodesic_processing::internal::Decoded_wavelets;

// Bounds the number of vertices, because a few bytes can encode a mesh of any size. In practice,
// base meshes are subdivided five or six times.
std::size_t max_number_of_vertices(std::size_t bytes)
{
  return std::min<std::size_t>(65536 + 1024 * bytes, std::size_t(1) << 21);
}

} // namespace

Surface_file read_gpw(std::string_view bytes, const std::string& name)
{
  Decoded_wavelets decoding;
  try
  {
    decoding = decode(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                      max_number_of_vertices(bytes.size()));
  }
  catch(const CGAL::Geodesic_processing::Invalid_argument_error& error)
  {
    throw Input_error(name + ": " + error.what());
  }
  if(decoding.signal.channels != 3)
    throw Input_error(name + ": The wavelet stream does not contain vertex positions.");
  const std::vector<double> values = decoded_values(decoding);
  Surface_file result;
  for(std::size_t i = 0; i < values.size(); i += 3)
    result.points.push_back({values[i], values[i + 1], values[i + 2]});
  for(const auto& t : decoding.subdivision->finest().triangles)
  {
    result.corners.insert(result.corners.end(), t.begin(), t.end());
    result.polygon_begin.push_back(result.corners.size());
  }
  return result;
}

} // namespace program
