# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact distances and paths with the interface of pygeodesic.

The names are in the module ``geodesic``, which has the list of differences.
"""

from . import geodesic

__all__ = ["geodesic"]

__version__ = "0.1.11"
"""The version of pygeodesic with this interface."""
