// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_APP_MEMORY_H
#define GEODESIC_PROGRAM_APP_MEMORY_H

#include <optional>
#include <string>

namespace program {

// Returns the number of bytes that the process can still allocate without swapping: the minimum over
// the system, the control group (containers) and the limit of the address space. Nothing if the
// system is not Linux.
std::optional<double> available_memory();

// Returns a size in gigabytes with two decimals, for example "4.84 GB".
std::string gigabytes(double bytes);

// Returns the reason to refuse a computation that needs more memory than is available, or an empty
// text. `what` is the subject of the sentence.
std::string lack_of_memory(const std::string& what, double bytes, std::optional<double> available);

} // namespace program

#endif // GEODESIC_PROGRAM_APP_MEMORY_H
