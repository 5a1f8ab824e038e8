// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_COLORS_H
#define GEODESIC_PROGRAM_IO_COLORS_H

#include <array>
#include <vector>

namespace program {

using Color = std::array<double, 3>; // red, green, blue in [0, 1]

// Color of surfaces
inline constexpr Color default_color = {0.80, 0.82, 0.85};

// Color of missing data: unreached or unlabeled vertices
inline constexpr Color gray = {0.72, 0.72, 0.72};

// Color map viridis by five control points: dark violet (0), green, yellow (1).
Color viridis(double t);

// Returns a color that is distinct for any number of labels. Negative labels are gray.
Color color_of_label(long long label);

// Applies viridis to the range [low, high], or to the range of finite values. Other values are
// gray.
std::vector<Color> colors_of(const std::vector<double>& values, double low, double high);
std::vector<Color> colors_of(const std::vector<double>& values);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_COLORS_H
