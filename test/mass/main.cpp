// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// check_results FOLDER: prints the violated invariants of the results in a folder.
#include "check_results.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if(argc != 2)
  {
    std::cerr << "usage: check_results FOLDER\n";
    return 2;
  }
  const std::vector<std::string> violations = mass_test::check_results(argv[1]);
  for(const std::string& violation : violations)
    std::cout << violation << '\n';
  return violations.empty() ? 0 : 1;
}
