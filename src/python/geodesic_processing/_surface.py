# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces."""

from __future__ import annotations

import os
from typing import NamedTuple

from numpy.typing import ArrayLike

from . import _core
from ._atlas import Atlases
from ._content import file_content, make_mesh
from ._core import InvalidArgumentError
from ._curvature import Curvature
from ._curves import Curves
from ._decals import Decals
from ._distances import Distances
from ._distortion import Distortion
from ._features import Features
from ._flattening import Flattenings
from ._fuzzy import FuzzyGeodesics
from ._maps import Maps
from ._measures import Measures
from ._remeshing import Remeshing
from ._sampling import Sampling
from ._transport import Transports
from ._types import Callback, Integers
from ._volumes import Volumes


class SoupReport(NamedTuple):
    """The repairs of a soup, and the topology of the mesh. All members are numbers."""

    number_of_merged_points: int
    number_of_triangulated_polygons: int
    number_of_degenerate_faces: int
    number_of_duplicate_triangles: int
    number_of_triangles_without_area: int
    number_of_reversed_triangles: int
    number_of_split_edges: int
    number_of_nonmanifold_points: int
    number_of_components: int
    number_of_boundary_cycles: int
    genus: int


class Surface(
    Curves,
    Measures,
    Transports,
    Remeshing,
    Distances,
    Sampling,
    Maps,
    Flattenings,
    Distortion,
    Atlases,
    Decals,
    FuzzyGeodesics,
    Curvature,
    Features,
    Volumes,
):
    """A triangle mesh or a surfel cloud, prepared for any number of queries. It is immutable.

    Parameters
    ----------
    V
        Points, shape (n, 3), finite.
    F
        Polygons of a mesh, shape (m, k) with k >= 3: rows of ``V``. They need not be a manifold or
        oriented; ``report`` has the repairs. Polygons with more than three corners are
        triangulated.
    normals
        Normals of a cloud, shape (n, 3), of any positive length. If neither ``F`` nor ``normals``
        is given, normals are estimated from 18 neighbors.
    radii
        Radii of the surfels of a cloud, shape (n,). By default, the distance to the 8th neighbor
        divided by the square root of two.
    merge_tolerance
        Points of a mesh within this distance are merged. By default, no points are merged.
    remove_degenerate_faces
        Whether triangles without area are removed.
    callback
        A function that is called with 0 between the steps of the construction.

    Raises
    ------
    InvalidArgumentError
        If an array has a wrong shape or type or is empty, if a number is not finite, if an index is
        not a row of ``V``, or if a normal has no direction.
    UnsupportedSurfaceError
        If there are too many points or halfedges, or too few points to estimate normals.

    A surface can be pickled. The arrays are then copied from its data. If polygons were repaired,
    the surface keeps a copy of ``F`` for this purpose.

    Takes O(n) time for a mesh and O(n log n) time for a cloud.
    """

    def __init__(
        self,
        V: ArrayLike,
        F: ArrayLike | None = None,
        *,
        normals: ArrayLike | None = None,
        radii: ArrayLike | None = None,
        merge_tolerance: float | None = None,
        remove_degenerate_faces: bool = False,
        callback: Callback | None = None,
    ) -> None:
        if F is None:
            if merge_tolerance is not None or remove_degenerate_faces:
                raise InvalidArgumentError(
                    "merge_tolerance and remove_degenerate_faces need the faces F of a mesh."
                )
            self._core = _core.make_cloud(V, normals, radii, callback)
        else:
            if normals is not None or radii is not None:
                raise InvalidArgumentError("A mesh has faces, but neither normals nor radii.")
            self._core, self._make_content = make_mesh(
                V, F, None, merge_tolerance, bool(remove_degenerate_faces), callback
            )

    def _new(self, core: _core.Mesh | _core.Cloud) -> Surface:
        return self._of(core)

    def __repr__(self) -> str:
        if self.is_cloud:
            return f"<geodesic_processing.Surface: {self.number_of_points} surfels>"
        return (
            f"<geodesic_processing.Surface: {self.number_of_points} points, "
            f"{self.number_of_faces} faces>"
        )

    @property
    def faces(self) -> Integers:
        """The triangles after repair, a new array of the shape (m, 3)."""
        return self._mesh("faces").faces()

    @property
    def report(self) -> SoupReport:
        """The repairs of the polygons, and the topology of the mesh."""
        return SoupReport(**self._mesh("report").report())


def read(path: str | os.PathLike[str]) -> Surface:
    """Reads a surface from a file: a mesh if it has faces, otherwise a cloud.

    Formats: PLY, OFF, OBJ, STL, XYZ, PWN, VTP, GLB, glTF, GIFTI and FreeSurfer, also compressed by
    gzip. If a cloud has no normals, they are estimated.

    If the surface is pickled, the file is read again; it must not have changed. A glTF file with
    other files cannot be pickled.

    Raises
    ------
    FileError
        If the file cannot be read. It is a subclass of ``OSError`` and ``ValueError``.
    """
    name = os.fspath(path)
    content = file_content(name)
    return Surface._of(_core.read(name), content)
