# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Collects the declared tables. The command \\table{NAME} inserts the table NAME into a page."""

from typing import Dict

import clouds
import distances
import meshes
import performance
import programs
import transport
from markdown import AnyTable, Table, Whole

TABLES: Dict[str, AnyTable] = {
    name: table for module in (distances, clouds, programs, meshes, transport, performance)
    for name, table in vars(module).items() if isinstance(table, (Table, Whole))}
