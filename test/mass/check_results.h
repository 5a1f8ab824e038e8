// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_MASS_CHECK_RESULTS_H
#define CGAL_GEODESIC_PROCESSING_TEST_MASS_CHECK_RESULTS_H

#include <filesystem>
#include <string>
#include <vector>

namespace mass_test {

// Checks the results of all commands on one surface, which are described in Results.h. Returns one
// line for each violated invariant: command, tab, sentence. It uses no code of the package.
std::vector<std::string> check_results(const std::filesystem::path& folder);

} // namespace mass_test

#endif // CGAL_GEODESIC_PROCESSING_TEST_MASS_CHECK_RESULTS_H
