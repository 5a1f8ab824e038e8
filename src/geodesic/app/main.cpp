// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run.h"

int main(int argc, char** argv) { return program::run(argc, argv); }
