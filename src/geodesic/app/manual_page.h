// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_APP_MANUAL_PAGE_H
#define GEODESIC_PROGRAM_APP_MANUAL_PAGE_H

#include <string>

namespace CLI {
class App;
}

namespace program {

// Returns the manual page of the program with its commands and their options, in the format of man.
// `version` is the name of the program with its version.
std::string manual_page(const CLI::App& program, const std::string& version);

} // namespace program

#endif // GEODESIC_PROGRAM_APP_MANUAL_PAGE_H
