# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes from samples of a surface."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from numpy.typing import ArrayLike

from . import _core
from ._distances import Distances, Path, SurfelPath
from ._types import Callback, Floats, Integers, Locations, ManyLocations

if TYPE_CHECKING:
    from ._surface import Surface


class RemeshedSurface(NamedTuple):
    """The geodesic Delaunay triangulation of samples."""

    surface: Surface
    """The new mesh."""
    locations: Locations
    """The location of each vertex of the new mesh on the original surface; on a cloud, the location
    closest to the vertex."""
    number_of_added_vertices: int
    """The number of vertices beyond the requested number."""
    number_of_self_intersections: int
    """The number of pairs of intersecting faces; 0 if self-intersections are not avoided."""
    edges: Integers
    """Shape (e, 2): the vertices of each edge; empty unless ``edge_paths`` is set."""
    paths: list[Path | SurfelPath]
    """A locally shortest path on the original surface for each row of ``edges``."""


class HoleFilling(NamedTuple):
    """A mesh whose holes are filled."""

    surface: Surface
    """The new mesh. Its vertices are those of the original mesh, and its first faces are the faces
    of the original mesh. A face can begin at another corner."""
    new_faces: Integers
    """Shape (k,): the new faces, rows of ``surface.faces``."""
    number_of_holes: int
    """The number of holes of the original mesh."""
    number_of_filled: int
    """The number of holes that were filled."""
    number_of_failed: int
    """The number of holes that satisfy the bounds, but have no valid triangulation."""
    number_of_unfolded: int
    """The number of holes that were filled by ``"unfolding"``."""


class BaseMesh(NamedTuple):
    """A base mesh, and a copy of the surface that is split along its edges."""

    surface: Surface
    """The base mesh."""
    divided: Surface
    """The copy. Each base face is the union of some of its faces."""
    base_faces: Integers
    """Shape (m,): the base face that contains each face of ``divided``."""
    number_of_added_vertices: int
    """The number of base vertices beyond the requested number."""


class SemiRegularMesh(NamedTuple):
    """A mesh with subdivision connectivity."""

    surface: Surface
    """The mesh. Quads are divided into two triangles."""
    polygons: Integers
    """Shape (m, 3) or (m, 4): the triangles or quads. Rows 4 f to 4 f + 3 are the parts of face f
    of the previous level; quads 3 f to 3 f + 2 of level 0 are the parts of base face f."""
    levels: Integers
    """Shape (n,): the level that adds each vertex; 0 for base vertices. Vertices are in the order
    of their levels."""
    number_of_levels: int
    """The number of 1-to-4 refinements."""
    number_of_base_faces: int
    """The number of faces of the base mesh."""
    number_of_flips: int
    """The number of inverted triangles of the parameterization."""
    deviation: float
    """The maximum distance of a vertex of the original surface from the point with the same base
    coordinates; 0 if ``max_deviation`` is ``None`` or 0."""


class BaseParameterization:
    """A continuous, one-to-one map between a surface and a base mesh. It is immutable.

    ``Surface.parameterize_over_base()`` returns it. Locations of the base mesh are locations of
    ``surface``: its faces are the base faces.
    """

    def __init__(
        self, surface: Surface, core: _core.Mesh_base_map | _core.Cloud_base_map
    ) -> None:
        self._core = core
        self.surface = surface
        """The base mesh."""
        self.base_vertices = Locations(*core.base_vertices())
        """The locations of the base vertices on the original surface."""
        self.vertex_locations = Locations(*core.vertex_locations())
        """The location of each vertex of the original surface on the base mesh: face -1 and
        coordinates NaN if the vertex has no face."""
        self.number_of_flips = core.number_of_flips()
        """The number of inverted triangles: 0, unless round-off errors invert triangles after base
        vertices have been added."""
        self.number_of_repaired_faces = core.number_of_repaired_faces()
        """The number of base faces whose coordinates were replaced by another kind."""

    def map(self, locations: ManyLocations) -> Locations:
        """Maps locations of the original surface to the base mesh.

        Parameters
        ----------
        locations
            A location of the original surface, or a range of them. Vertices must have faces.

        Takes time proportional to the number of parts of each face; on a cloud, another O(log n).
        """
        return Locations(*self._core.map(locations))

    def inverse(self, locations: ManyLocations) -> Locations:
        """Maps locations of the base mesh to the original surface.

        Parameters
        ----------
        locations
            A location of the base mesh, or a range of them.

        For each location, takes time proportional to the number of parts of its base face.
        """
        return Locations(*self._core.inverse(locations))

    def points(self, locations: ManyLocations) -> Floats:
        """Maps locations of the base mesh to points of the original surface, shape (k, 3).

        The points of a cloud are on the reconstructed mesh. The parameters and the time are those
        of ``inverse()``.
        """
        return self._core.points(locations)


class Remeshing(Distances):
    """The functions of a surface for meshes from samples."""

    def remesh(
        self,
        n: int,
        keep_sharp: float | None = None,
        max_deviation: float | None = None,
        *,
        curve_spacing: float = 0.0,
        relaxation_steps: int = 0,
        first: ManyLocations | None = None,
        fit: bool = False,
        avoid_self_intersections: bool = True,
        too_few_samples: str = "refine",
        edge_paths: bool = False,
        speed: ArrayLike | None = None,
        constrained_edges: ArrayLike | None = None,
        edge_spacing: ArrayLike | None = None,
        seed: int = 0,
        callback: Callback | None = None,
    ) -> RemeshedSurface:
        """Computes the geodesic Delaunay triangulation of samples: a coarser or finer mesh of the
        same surface, with well-shaped triangles. A clean cloud is reconstructed coarsely.

        Each component has the genus, boundary cycles and orientation of the original one. Vertices
        lie on the original surface unless ``fit`` is set.

        Parameters
        ----------
        n
            The number of vertices. More are added if the topology or another argument requires
            them.
        keep_sharp
            An angle in degrees. Edges whose dihedral angle deviates from flat by at least this
            angle become chains of edges. By default, no edge is sharp.
        max_deviation
            The maximum distance between the original surface and the new mesh. By default, it is
            unlimited.
        curve_spacing
            The approximate maximum distance between adjacent vertices on the boundary and on sharp
            edges. 0 stands for the distance between vertices elsewhere.
        relaxation_steps
            The number of steps that move samples to the centroids of their cells.
        first
            A location, or a range of either vertices or other locations: the first vertices of the
            new mesh, included in ``n``.
        fit
            Whether vertices are moved off the surface to reduce the distances to the faces.
        avoid_self_intersections
            Whether vertices are added if faces intersect.
        too_few_samples
            ``"refine"`` adds vertices if ``n`` is too small; ``"raise"`` raises
            ``InvalidArgumentError``.
        edge_paths
            Whether the paths of the edges are computed.
        speed
            Shape (n,), positive: triangles are smaller in regions of low speed.
        constrained_edges
            Shape (k, 2): the vertices of edges of a mesh that become chains of edges, as sharp
            edges do. By default, there are none.
        edge_spacing
            Shape (k,): ``curve_spacing`` for each of the ``constrained_edges``; 0 stands for the
            value of this argument.
        seed
            Selects the first sample, and random samples.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, or if ``n`` is too small.
        UnsupportedSurfaceError
            If no surface can be reconstructed from a cloud, or if additional samples do not make
            the topology that of the surface.
        Cancelled
            If the callback returns a false value.

        Takes about the time of ``farthest_points()``; each relaxation step at most that of one
        front over the surface.
        """
        core, indices, coordinates, added, intersections, edges, paths = self._core.remesh(
            (
                n,
                keep_sharp,
                curve_spacing,
                relaxation_steps,
                first,
                speed,
                constrained_edges,
                edge_spacing,
                seed,
                callback,
            ),
            max_deviation,
            bool(fit),
            bool(avoid_self_intersections),
            too_few_samples,
            bool(edge_paths),
        )
        return RemeshedSurface(
            self._new(core),
            Locations(indices, coordinates),
            added,
            intersections,
            edges,
            [self._path(path) for path in paths],
        )

    def fill_holes(
        self,
        *,
        max_edges: int | None = None,
        max_perimeter: float = math.inf,
        method: str = "minimal-dihedral-angles",
        callback: Callback | None = None,
    ) -> HoleFilling:
        """Fills the holes of a mesh with triangles between the vertices of their boundaries.

        The outer boundary of an open surface is also a hole: use a bound to keep it open.

        Parameters
        ----------
        max_edges
            Holes with more edges are left open. By default, their number is unlimited.
        max_perimeter
            Holes with a longer boundary are left open.
        method
            - ``"minimal-dihedral-angles"``: the triangulation with the smallest dihedral angles
            - ``"unfolding"``: the constrained Delaunay triangulation of the unfolded boundary

            If one of them has no valid triangulation, the other one is used.
        callback
            A function that takes the completed fraction.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid.
        UnsupportedSurfaceError
            If the surface is a cloud.
        Cancelled
            If the callback returns a false value.

        Takes O(n) time, and for each hole of k edges O(k^3), or O(k log k) for ``"unfolding"``.
        """
        arrays = self._mesh("fill_holes").fill_holes(
            max_edges, max_perimeter, method, callback
        )
        return HoleFilling(self._new(arrays[0]), *arrays[1:])

    def base_mesh(
        self,
        n: int,
        keep_sharp: float | None = None,
        *,
        curve_spacing: float = 0.0,
        relaxation_steps: int = 0,
        first: ManyLocations | None = None,
        speed: ArrayLike | None = None,
        constrained_edges: ArrayLike | None = None,
        edge_spacing: ArrayLike | None = None,
        seed: int = 0,
        callback: Callback | None = None,
    ) -> BaseMesh:
        """Computes a base mesh of few triangles, and splits a copy of the surface along its edges.

        Each base face is a disk on the copy that is bounded by its three base edges, which are
        locally shortest paths. A cloud is reconstructed first.

        Parameters
        ----------
        n
            The number of base vertices; 0 requests the minimum that the topology requires.
        keep_sharp, curve_spacing, relaxation_steps, first, speed, constrained_edges, \
edge_spacing, seed, callback
            As for ``remesh()``. Base edges follow the boundary, sharp edges and constrained edges
            exactly.

        Raises
        ------
        UnsupportedSurfaceError
            As ``remesh()``, and if edges cannot be traced on the mesh.

        Takes near-linear time in the number of vertices and in the length of base edges.
        """
        base, divided, base_faces, added = self._core.base_mesh(
            (
                n,
                keep_sharp,
                curve_spacing,
                relaxation_steps,
                first,
                speed,
                constrained_edges,
                edge_spacing,
                seed,
                callback,
            )
        )
        return BaseMesh(self._new(base), self._new(divided), base_faces, added)

    def parameterize_over_base(
        self,
        n: int,
        keep_sharp: float | None = None,
        *,
        coordinates: str = "heron",
        curve_spacing: float = 0.0,
        relaxation_steps: int = 0,
        first: ManyLocations | None = None,
        speed: ArrayLike | None = None,
        constrained_edges: ArrayLike | None = None,
        edge_spacing: ArrayLike | None = None,
        seed: int = 0,
        callback: Callback | None = None,
    ) -> BaseParameterization:
        """Computes a base mesh, and a one-to-one map between the surface and the base mesh.

        Parameters
        ----------
        n
            The number of base vertices. More are added if the topology requires them, or if
            triangles would be inverted.
        coordinates
            The coordinates inside base faces:

            - ``"heron"``: areas of triangles that have the lengths of base edges and the geodesic
              distances to the corners
            - ``"mean-value"``: convex combinations of the neighbors with mean value weights
            - ``"uniform"``: the mean of the neighbors
        keep_sharp, curve_spacing, relaxation_steps, first, speed, constrained_edges, \
edge_spacing, seed, callback
            As for ``base_mesh()``.

        The exceptions and the time are those of ``base_mesh()``.
        """
        core = self._core.parameterize_over_base(
            (
                n,
                keep_sharp,
                curve_spacing,
                relaxation_steps,
                first,
                speed,
                constrained_edges,
                edge_spacing,
                seed,
                callback,
            ),
            coordinates,
        )
        return BaseParameterization(self._new(core.base()), core)

    def semi_regular(
        self,
        n: int,
        levels: int = 3,
        *,
        quads: bool = False,
        max_deviation: float | None = None,
        coordinates: str = "heron",
        keep_sharp: float | None = None,
        curve_spacing: float = 0.0,
        relaxation_steps: int = 0,
        first: ManyLocations | None = None,
        speed: ArrayLike | None = None,
        constrained_edges: ArrayLike | None = None,
        edge_spacing: ArrayLike | None = None,
        seed: int = 0,
        callback: Callback | None = None,
    ) -> SemiRegularMesh:
        """Computes a mesh with subdivision connectivity: the faces of a base mesh are uniformly
        refined. ``SubdivisionWavelet`` transforms it.

        All vertices lie on the surface. In a triangle mesh all vertices except base vertices have
        six neighbors, or four on the boundary. A cloud is reconstructed first.

        Parameters
        ----------
        n
            The number of base vertices.
        levels
            The number of 1-to-4 refinements.
        quads
            Whether each base face is first split into three quads.
        max_deviation
            Refinement of triangles stops if each vertex of the original surface is within this
            distance of the point with the same base coordinates. If it is ``None`` or 0, all levels
            are computed.
        coordinates
            As for ``parameterize_over_base()``.
        keep_sharp, curve_spacing, relaxation_steps, first, speed, constrained_edges, \
edge_spacing, seed, callback
            As for ``base_mesh()``.

        Raises
        ------
        InvalidArgumentError
            If an argument is invalid, if the mesh would be too large, or if ``quads`` and
            ``max_deviation`` are combined.
        UnsupportedSurfaceError
            As ``base_mesh()``.

        Takes the time of ``base_mesh()``, and linear time in the size of the new mesh.
        """
        arrays = self._core.semi_regular(
            (
                n,
                keep_sharp,
                curve_spacing,
                relaxation_steps,
                first,
                speed,
                constrained_edges,
                edge_spacing,
                seed,
                callback,
            ),
            coordinates,
            levels,
            bool(quads),
            max_deviation,
        )
        return SemiRegularMesh(self._new(arrays[0]), *arrays[1:])
