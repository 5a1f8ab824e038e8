# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves on meshes."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from ._base import Base
from ._types import Floats, Integers


class Isoline(NamedTuple):
    """A line of constant value on a mesh. Larger values are on the left, seen from outside."""

    value: float
    """The value on the line."""
    is_closed: bool
    """Whether the last point equals the first one."""
    points: Floats
    """Shape (k, 3): the polyline."""
    faces: Integers
    """Shape (k,): a face that contains the point."""
    barycentric: Floats
    """Shape (k, 3): the barycentric coordinates of the points."""
    length: float
    """The length of the polyline."""


class Curves(Base):
    """The functions of a surface for curves."""

    def isolines(
        self, values: ArrayLike, levels: ArrayLike, *, fit_circles: bool = False
    ) -> list[Isoline]:
        """Computes the isolines of a function on a mesh that is linear in each face.

        Parameters
        ----------
        values
            Shape (n,): the values of the vertices. They can be infinite.
        levels
            Shape (k,), finite: the values of the isolines.
        fit_circles
            Whether values are interpolated along edges like distances from a point in the plane.
        """
        lines = self._mesh("isolines").isolines(values, levels, bool(fit_circles))
        return [Isoline(*line) for line in lines]
