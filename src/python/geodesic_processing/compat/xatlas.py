# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texture atlases with the interface of xatlas 0.0.11.

The charts and their images are those of ``Surface.atlas()``: images of faces are not inverted,
and do not overlap.

Differences
-----------
- There are other charts, and fewer. The atlas is one square with ``PackOptions.resolution`` texels
  along each edge, by default 1024.
- Normals and texture coordinates of the input are checked, but do not influence the charts.
- Vertices with equal coordinates are one vertex for the charts, as in xatlas.
- Faces that are repeated or have two equal corners, and edges with more than two faces, are
  repaired. Faces that are removed have the texture coordinates (0, 0), and are in no chart. The
  images of faces that are reversed are clockwise.
- ``add_mesh()`` and ``generate()`` cannot be called after ``generate()``.
- Not covered: ``Atlas.add_uv_mesh()``, ``Atlas.get_chart_image()``, ``Atlas.chart_image``,
  ``Chart.type``, ``ChartType``, and options with values other than their defaults, except for
  ``ChartOptions.fix_winding`` and ``PackOptions.padding``, ``resolution``, ``bilinear``,
  ``blockAlign``, ``bruteForce``, ``rotate_charts`` and ``rotate_charts_to_axis``. Of these,
  ``padding``, ``resolution`` and ``bilinear`` have an effect.

Tests of xatlas pass, except for ``test_generate`` and ``test_parametrize``, which compare the
number of charts and vertices with those of xatlas.
"""

from __future__ import annotations

import os
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._atlas import Atlas as SurfaceAtlas
from .._surface import Surface
from .._types import Floats, Integers
from ._common import missing_method, missing_names, not_covered, require_default

__all__ = ["Atlas", "Chart", "ChartOptions", "PackOptions", "export", "parametrize"]

__version__ = "0.0.11"
"""The version of xatlas with this interface."""

Indices = NDArray[np.uint32]
MeshArrays = tuple[Indices, Indices, NDArray[np.float32]]

__getattr__ = missing_names(__name__, "ChartType")


class _Options:
    """Options with default values. A subclass has the options that can have other values."""

    _flexible: frozenset[str] = frozenset()

    def __setattr__(self, name: str, value: Any) -> None:
        if not hasattr(type(self), name) or name.startswith("_"):
            raise AttributeError(f"{type(self).__name__} has no option {name}.")
        super().__setattr__(name, value)

    def _check(self) -> None:
        """Raises NotImplementedError if an option has a value that is not covered."""
        for name in vars(self).keys() - self._flexible:
            full_name = f"{type(self).__name__}.{name}"
            require_default(full_name, getattr(self, name), getattr(type(self), name))


class ChartOptions(_Options):
    """The options for charts. Only ``fix_winding`` can be changed; images are never inverted."""

    max_chart_area: float = 0.0
    max_boundary_length: float = 0.0
    normal_deviation_weight: float = 2.0
    roundness_weight: float = 0.01
    straightness_weight: float = 6.0
    normal_seam_weight: float = 4.0
    texture_seam_weight: float = 0.5
    max_cost: float = 2.0
    max_iterations: int = 1
    use_input_mesh_uvs: bool = False
    fix_winding: bool = False

    _flexible = frozenset({"fix_winding"})


class PackOptions(_Options):
    """The options for the layout of charts in the atlas."""

    max_chart_size: int = 0
    padding: int = 0
    """The minimum number of texels between charts."""
    texels_per_unit: float = 0.0
    resolution: int = 0
    """The number of texels along each edge of the atlas, 16 to 16384; 0 is 1024."""
    bilinear: bool = True
    """Whether there are at least three texels between charts."""
    blockAlign: bool = False
    bruteForce: bool = False
    create_image: bool = False
    rotate_charts_to_axis: bool = True
    rotate_charts: bool = True

    _flexible = frozenset(
        {
            "padding",
            "resolution",
            "bilinear",
            "blockAlign",
            "bruteForce",
            "rotate_charts_to_axis",
            "rotate_charts",
        }
    )


class Chart:
    """A chart of a mesh."""

    def __init__(self, faces: Indices) -> None:
        self.faces = faces
        """The faces, which are rows of the indices of the mesh."""
        self.atlas_index = 0
        """The only atlas."""
        self.material = 0
        """Meshes have one material."""

    @property
    def type(self) -> Any:
        """Raises ``NotImplementedError``."""
        raise not_covered("Chart.type")


class _Mesh(NamedTuple):
    """A mesh in the atlas."""

    vmapping: Indices
    """Shape (k,): the vertex that is repeated."""
    indices: Indices
    """Shape (m, 3): the repeated vertices of each face."""
    uvs: NDArray[np.float32]
    """Shape (k, 2): the texture coordinates."""
    vertex_charts: Integers
    """Shape (k,): the chart of each repeated vertex, -1 if it is in none."""
    charts: list[Indices]
    """The faces of each chart."""


class Atlas:
    """Computes one texture atlas for any number of meshes."""

    get_chart_image = missing_method("Atlas.get_chart_image")
    add_uv_mesh = missing_method("Atlas.add_uv_mesh")

    def __init__(self) -> None:
        self._inputs: list[tuple[Floats, Integers]] = []
        self._meshes: list[_Mesh] = []
        self._size = 0
        self._texels_per_unit = 0.0
        self._utilization: float | None = None
        self._chart_count = 0

    def add_mesh(
        self,
        positions: ArrayLike,
        indices: ArrayLike,
        normals: ArrayLike | None = None,
        uvs: ArrayLike | None = None,
    ) -> None:
        """Adds a mesh.

        Parameters
        ----------
        positions
            Shape (n, 3): the points of the vertices.
        indices
            Shape (m, 3): the faces.
        normals
            Shape (n, 3): they are checked, but have no influence.
        uvs
            Shape (n, 2): they are checked, but have no influence.

        Raises
        ------
        ValueError
            If an array has a wrong shape.
        RuntimeError
            If an index is out of range, or if the atlas is already generated.
        """
        mesh = _checked_mesh(positions, indices, normals, uvs)
        if self._utilization is not None:
            raise RuntimeError("No mesh can be added to an atlas that is generated.")
        self._inputs.append(mesh)

    def generate(
        self,
        chart_options: ChartOptions | None = None,
        pack_options: PackOptions | None = None,
        verbose: bool = False,
    ) -> None:
        """Computes the charts of all meshes and their layout.

        Parameters
        ----------
        chart_options, pack_options
            The options. Values that are not covered raise ``NotImplementedError``.
        verbose
            Must be false: nothing is printed.

        Raises
        ------
        RuntimeError
            If the atlas is already generated.
        ValueError
            If there are too few texels for the charts.
        """
        if self._utilization is not None:
            raise RuntimeError("The atlas is already generated.")
        require_default("verbose", bool(verbose), False)
        (chart_options or ChartOptions())._check()
        pack = pack_options or PackOptions()
        pack._check()
        if not self._inputs:
            return
        size = pack.resolution or 1024
        points, faces = self._joined_meshes()
        result = Surface(points, faces).atlas(
            texture_size=size, gutter_width=max(pack.padding, 3 if pack.bilinear else 1)
        )
        corners, charts = _match_faces(faces, result)
        uv = np.concatenate([result.uv, np.zeros((1, 2))])  # the last row for faces without chart
        begin = 0
        for _, rows in self._inputs:
            part = slice(begin, begin + len(rows))
            self._meshes.append(_output_mesh(rows, corners[part], charts[part], uv))
            begin += len(rows)
        self._size = size
        self._chart_count = result.number_of_charts
        self._utilization = result.coverage
        self._texels_per_unit = result.texels_per_length

    def _joined_meshes(self) -> tuple[Floats, Integers]:
        """Returns one mesh. Vertices of a mesh with equal coordinates are welded."""
        sizes = [len(points) for points, _ in self._inputs]
        numbers = np.repeat(np.arange(len(sizes)), sizes)
        points = np.concatenate([points for points, _ in self._inputs])
        begins = np.cumsum([0, *sizes])
        faces = np.concatenate([rows + i for (_, rows), i in zip(self._inputs, begins)])
        rows, vertices = np.unique(
            np.column_stack([points, numbers]), axis=0, return_inverse=True
        )
        return rows[:, :3], vertices.ravel()[faces]

    def get_mesh(self, mesh_index: int) -> MeshArrays:
        """Returns a mesh with texture coordinates.

        Returns
        -------
        The input vertex of each new vertex, shape (k,); the faces as rows of new vertices, shape
        (m, 3); and the texture coordinates of the new vertices, shape (k, 2).
        """
        return self._mesh(mesh_index)[:3]

    def get_mesh_vertex_assignment(self, mesh_index: int) -> tuple[Indices, Indices]:
        """Returns the atlas and the chart of each new vertex of a mesh, two arrays of shape (k,).

        There is one atlas, 0. Charts are those of the whole atlas. The chart of a vertex without
        chart is 2^32 - 1.
        """
        charts = self._mesh(mesh_index).vertex_charts.astype(np.uint32)
        return np.zeros_like(charts), charts

    def get_mesh_chart_count(self, mesh_index: int) -> int:
        """Returns the number of charts of a mesh."""
        return len(self._mesh(mesh_index).charts)

    def get_mesh_chart(self, mesh_index: int, chart_index: int) -> Chart:
        """Returns a chart of a mesh."""
        charts = self._mesh(mesh_index).charts
        return Chart(charts[_checked_index("Chart", chart_index, len(charts))])

    def get_utilization(self, atlas_index: int) -> float:
        """Returns the fraction of the texels that charts cover."""
        _checked_index("Atlas", atlas_index, self.atlas_count)
        return self._utilization or 0.0

    @property
    def atlas_count(self) -> int:
        """One if the atlas is generated."""
        return 0 if self._utilization is None else 1

    @property
    def mesh_count(self) -> int:
        """The number of meshes that were added."""
        return len(self._inputs)

    @property
    def chart_count(self) -> int:
        """The number of charts of all meshes."""
        return self._chart_count

    @property
    def width(self) -> int:
        """The number of texels along the edges of the atlas; 0 before it is generated."""
        return self._size

    @property
    def height(self) -> int:
        """Equal to ``width``."""
        return self._size

    @property
    def texels_per_unit(self) -> float:
        """The approximate number of texels along a unit of length."""
        return self._texels_per_unit

    @property
    def utilization(self) -> float:
        """The fraction of the texels that charts cover."""
        return self.get_utilization(0)

    @property
    def chart_image(self) -> Any:
        """Raises ``NotImplementedError``."""
        raise not_covered("Atlas.chart_image")

    def __len__(self) -> int:
        return self.mesh_count

    def __getitem__(self, mesh_index: int) -> MeshArrays:
        return self.get_mesh(mesh_index)

    def _mesh(self, index: int) -> _Mesh:
        return self._meshes[_checked_index("Mesh", index, len(self._meshes))]


def parametrize(
    positions: ArrayLike,
    indices: ArrayLike,
    normals: ArrayLike | None = None,
    uvs: ArrayLike | None = None,
) -> MeshArrays:
    """Computes an atlas of one mesh. See ``Atlas.add_mesh()`` and ``Atlas.get_mesh()``."""
    atlas = Atlas()
    atlas.add_mesh(positions, indices, normals, uvs)
    atlas.generate()
    return atlas.get_mesh(0)


def export(
    path: str | os.PathLike[str],
    positions: ArrayLike,
    indices: ArrayLike | None = None,
    uvs: ArrayLike | None = None,
    normals: ArrayLike | None = None,
) -> None:
    """Writes a mesh to an OBJ file.

    Parameters
    ----------
    path
        The name of the file.
    positions
        Shape (n, 3): the points.
    indices
        Shape (m, 3): the faces.
    uvs
        Shape (n, 2): the texture coordinates of the vertices.
    normals
        Shape (n, 3): the normals of the vertices.
    """
    points = _checked_shape("Position", positions, 3)
    blocks = [("v", points)]
    if normals is not None:
        blocks.append(("vn", _checked_shape("Normal", normals, 3, len(points))))
    if uvs is not None:
        blocks.append(("vt", _checked_shape("Texture coordinate", uvs, 2, len(points))))
    corner = {
        (False, False): "{0}",
        (True, False): "{0}/{0}",
        (False, True): "{0}//{0}",
        (True, True): "{0}/{0}/{0}",
    }[uvs is not None, normals is not None]
    faces = np.empty((0, 3)) if indices is None else _checked_shape("Index", indices, 3)
    with open(path, "w", encoding="ascii") as file:
        for word, rows in blocks:
            file.writelines(f"{word} {' '.join(map(repr, row))}\n" for row in rows.tolist())
        for face in (faces.astype(np.int64) + 1).tolist():
            file.write(f"f {' '.join(corner.format(vertex) for vertex in face)}\n")


def _checked_shape(name: str, values: ArrayLike, width: int, length: int | None = None) -> Any:
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"The {name} array has the shape {array.shape} instead of Nx{width}.")
    if length is not None and len(array) != length:
        raise ValueError(
            f"The first dimension of the {name} array is {len(array)} instead of {length}."
        )
    return array


def _checked_mesh(
    positions: ArrayLike, indices: ArrayLike, normals: ArrayLike | None, uvs: ArrayLike | None
) -> tuple[Floats, Integers]:
    points = _checked_shape("Position", positions, 3)
    faces = _checked_shape("Index", indices, 3)
    if normals is not None:
        _checked_shape("Normal", normals, 3, len(points))
    if uvs is not None:
        _checked_shape("Texture coordinate", uvs, 2, len(points))
    if faces.size > 0 and not (0 <= faces.min() and faces.max() < len(points)):
        raise RuntimeError("An index of a face is out of range.")
    return points.astype(np.float64), faces.astype(np.int64)


def _checked_index(name: str, index: int, size: int) -> int:
    if not 0 <= index < size:
        raise IndexError(f"{name} {index} is out of bounds: there are {size}.")
    return index


def _match_faces(faces: Integers, atlas: SurfaceAtlas) -> tuple[Integers, Integers]:
    """Returns the vertices of the atlas at the corners of each face, and its chart.

    Both are -1 for faces that are not in the atlas. Faces can begin at another corner in the atlas.
    If they are not found, they are searched with the opposite orientation.
    """
    m = len(atlas.faces)
    candidates = np.concatenate([atlas.faces, atlas.faces[:, ::-1]])
    vertices = np.concatenate([atlas.vertices[candidates], faces])
    # The corners of each face, beginning at the smallest vertex.
    order = (vertices.argmin(axis=1)[:, None] + np.arange(3)) % 3
    rotated = np.take_along_axis(vertices, order, axis=1)
    label = np.unique(rotated, axis=0, return_inverse=True)[1].ravel()
    row_of = np.full(len(label), -1)
    row_of[label[m : 2 * m]] = np.arange(m, 2 * m)
    row_of[label[:m]] = np.arange(m)
    rows = row_of[label[2 * m :]]
    corners = np.empty_like(faces)
    found = np.take_along_axis(candidates[rows], order[rows], axis=1)
    np.put_along_axis(corners, order[2 * m :], found, axis=1)
    corners[rows < 0] = -1
    return corners, np.where(rows < 0, -1, atlas.charts[rows % m])


def _output_mesh(faces: Integers, corners: Integers, charts: Integers, uv: Floats) -> _Mesh:
    """Returns a mesh with a new vertex for each vertex of the input and of the atlas."""
    pairs = np.column_stack([faces.ravel(), corners.ravel()])
    rows, first, indices = np.unique(pairs, axis=0, return_index=True, return_inverse=True)
    return _Mesh(
        rows[:, 0].astype(np.uint32),
        indices.reshape(-1, 3).astype(np.uint32),
        uv[rows[:, 1]].astype(np.float32),
        charts[first // 3],
        [
            np.flatnonzero(charts == chart).astype(np.uint32)
            for chart in np.unique(charts[charts >= 0])
        ],
    )
