// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_COLORS_H
#define GEODESIC_PROGRAM_IO_COLORS_H

#include <array>
#include <vector>

namespace program {

using Color = std::array<double, 3>; // red, green, blue in [0, 1]

// Of surfaces.
inline constexpr Color default_color = {0.80, 0.82, 0.85};

// Where nothing is known: unreached, unlabelled.
inline constexpr Color gray = {0.72, 0.72, 0.72};

// From dark violet (0) over green to yellow (1): five points of the map viridis.
Color viridis(double t);

// Colours that differ from one another for any number of labels; grey for negative ones.
Color color_of_label(long long label);

// viridis over a range, or over that of the finite values; grey for those that are not finite.
std::vector<Color> colors_of(const std::vector<double>& values, double low, double high);
std::vector<Color> colors_of(const std::vector<double>& values);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_COLORS_H
