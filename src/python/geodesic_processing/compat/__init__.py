# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules with the names, arguments and shapes of other Python packages for geodesics.

A script that uses one of these packages runs with this package if it imports another module::

    from geodesic_processing.compat import potpourri3d as pp3d
    from geodesic_processing.compat.pygeodesic import geodesic
    from geodesic_processing.compat import gdist
    from geodesic_processing.compat import xatlas

Functions, methods and options that are not covered raise ``NotImplementedError`` with their name.
Other errors are those of this package, except for the exceptions that a module describes. Matrices
need SciPy.
"""

from . import gdist, potpourri3d, pygeodesic, xatlas

__all__ = ["gdist", "potpourri3d", "pygeodesic", "xatlas"]
