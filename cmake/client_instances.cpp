// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "client_headers.h"

GEODESIC_PROCESSING_CLIENT_INSTANCES(, CGAL::Epick)
GEODESIC_PROCESSING_CLIENT_INSTANCES(, CGAL::Simple_cartesian<double>)
