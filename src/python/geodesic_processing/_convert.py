# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of the objects of other packages. The packages are not imported."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._content import make_mesh
from ._core import InvalidArgumentError
from ._surface import Surface


def as_surface(
    mesh: Any, *, merge_tolerance: float | None = None, remove_degenerate_faces: bool = False
) -> Surface:
    """Returns the surface of an object of another package.

    The vertices of the surface are the points of the object, in their order.

    Parameters
    ----------
    mesh
        - trimesh: ``Trimesh``, ``PointCloud``
        - pyvista: ``PolyData``; VTK: ``vtkPolyData``. Vertices and lines are ignored if there are
          polygons. Without polygons, the object is a cloud.
        - meshio: ``Mesh`` with triangles, quadrilaterals or polygons. Cells of other dimensions are
          ignored. A mesh without cells, or with vertices only, is a cloud.
        - open3d: ``TriangleMesh`` and ``PointCloud``, also those of ``open3d.t``
        - ``Surface``: the object itself

        A cloud has the normals of the object. If there are none, they are estimated.
    merge_tolerance, remove_degenerate_faces
        As for ``Surface``, for meshes.

    Raises
    ------
    InvalidArgumentError
        If the object is of no such type, or if it has triangle strips or curved faces.
    """
    if isinstance(mesh, Surface):
        return mesh
    for read in (_read_vtk, _read_meshio, _read_tensors, _read_open3d, _read_trimesh):
        found = read(mesh)
        if found is not None:
            break
    else:
        raise InvalidArgumentError(
            f"An object of the type {type(mesh).__name__} is no mesh or cloud of trimesh, pyvista, "
            "VTK, meshio or open3d."
        )
    points, corners, offsets, normals = found
    if corners is None:
        return Surface(
            points,
            normals=normals,
            merge_tolerance=merge_tolerance,
            remove_degenerate_faces=remove_degenerate_faces,
        )
    return Surface._of(
        *make_mesh(points, corners, offsets, merge_tolerance, bool(remove_degenerate_faces))
    )


# Points, corners, offsets and normals. For triangles, the corners are rows and the offsets None. For
# polygons, they are those of the extension. A cloud has no corners.
_Arrays = tuple[Any, Any, Any, Any]


def _has(object_: Any, *names: str) -> bool:
    return all(hasattr(object_, name) for name in names)


def _read_vtk(mesh: Any) -> _Arrays | None:
    """Reads a vtkPolyData, or a PolyData of pyvista."""
    if _has(mesh, "GetPolys", "GetPoints", "GetStrips"):
        return _read_poly_data(mesh)
    if not _has(mesh, "points", "faces", "strips"):
        return None
    if len(mesh.strips) > 0:
        raise InvalidArgumentError("The mesh has triangle strips; triangulate it first.")
    points = np.asarray(mesh.points)
    if len(mesh.faces) > 0:
        return points, *_unpadded(np.asarray(mesh.faces)), None
    # pyvista computes the property point_normals from faces.
    return points, None, None, _first(mesh.point_data, ("Normals", "normals"))


def _read_poly_data(mesh: Any) -> _Arrays:
    # An object of VTK exists, so the package does as well. It has no type hints.
    vtk_to_numpy = import_module("vtkmodules.util.numpy_support").vtk_to_numpy
    if mesh.GetStrips().GetNumberOfCells() > 0:
        raise InvalidArgumentError("The mesh has triangle strips; triangulate it first.")
    if mesh.GetPoints() is None:
        raise InvalidArgumentError("The mesh has no points.")
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    polygons = mesh.GetPolys()
    if polygons.GetNumberOfCells() > 0:
        corners = vtk_to_numpy(polygons.GetConnectivityArray())
        return points, corners, vtk_to_numpy(polygons.GetOffsetsArray()), None
    normals = mesh.GetPointData().GetNormals()
    return points, None, None, None if normals is None else vtk_to_numpy(normals)


def _unpadded(faces: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Converts [3, a, b, c, 4, a, b, c, d, ...] to corners and offsets."""
    width = int(faces[0]) + 1
    if width > 0 and len(faces) % width == 0 and (faces[::width] == faces[0]).all():
        rows = faces.reshape(-1, width)[:, 1:]
        return rows.ravel(), np.arange(len(rows) + 1) * (width - 1)
    beginnings = []
    position = 0
    while position < len(faces) and faces[position] >= 0:
        beginnings.append(position)
        position += int(faces[position]) + 1
    if position != len(faces):
        raise InvalidArgumentError("The faces of the mesh do not match their numbers of corners.")
    sizes = faces[beginnings]
    return np.delete(faces, beginnings), np.concatenate([[0], np.cumsum(sizes)])


def _read_meshio(mesh: Any) -> _Arrays | None:
    """Reads a Mesh of meshio."""
    if not _has(mesh, "points", "cells", "point_data") or not isinstance(mesh.cells, list):
        return None
    corners: list[NDArray[Any]] = []
    sizes: list[NDArray[np.int64]] = []
    other_types = set()
    for block in mesh.cells:
        if block.type in ("triangle", "quad") or block.type.startswith("polygon"):
            # The polygons of a block have the same size, or are a list of arrays.
            for cells in [block.data] if isinstance(block.data, np.ndarray) else block.data:
                rows = np.atleast_2d(np.asarray(cells))
                corners.append(rows.ravel())
                sizes.append(np.full(len(rows), rows.shape[1], np.int64))
        elif block.type.startswith(("triangle", "quad", "VTK_LAGRANGE_TRI", "VTK_LAGRANGE_QUAD")):
            raise InvalidArgumentError(f"Faces of the type {block.type} are not supported.")
        else:
            other_types.add(block.type)
    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] == 2:  # a mesh of the plane
        points = np.column_stack([points, np.zeros(len(points))])
    if corners:
        offsets = np.concatenate([[0], np.cumsum(np.concatenate(sizes))])
        return points, np.concatenate(corners), offsets, None
    if other_types - {"vertex"}:
        raise InvalidArgumentError("The mesh has cells, but no faces: extract its surface first.")
    return points, None, None, _first(mesh.point_data, ("Normals", "normals"))


def _read_tensors(mesh: Any) -> _Arrays | None:
    """Reads a TriangleMesh or a PointCloud of open3d.t."""
    if _has(mesh, "vertex", "triangle"):
        return _numpy(mesh.vertex["positions"]), _numpy(mesh.triangle["indices"]), None, None
    if _has(mesh, "point") and _has(mesh.point, "__getitem__", "__contains__"):
        normals = _numpy(mesh.point["normals"]) if "normals" in mesh.point else None
        return _numpy(mesh.point["positions"]), None, None, normals
    return None


def _read_open3d(mesh: Any) -> _Arrays | None:
    """Reads a TriangleMesh or a PointCloud of open3d."""
    if _has(mesh, "vertices", "triangles"):
        return np.asarray(mesh.vertices), np.asarray(mesh.triangles), None, None
    if _has(mesh, "points", "has_normals"):
        normals = np.asarray(mesh.normals) if mesh.has_normals() else None
        return np.asarray(mesh.points), None, None, normals
    return None


def _read_trimesh(mesh: Any) -> _Arrays | None:
    """Reads a Trimesh or a PointCloud of trimesh."""
    if _has(mesh, "vertices", "faces"):
        return np.asarray(mesh.vertices), np.asarray(mesh.faces), None, None
    if _has(mesh, "vertices", "convex_hull"):  # a PointCloud
        return np.asarray(mesh.vertices), None, None, None
    return None


def _first(arrays: Any, names: tuple[str, ...]) -> NDArray[Any] | None:
    for name in names:
        if name in arrays:
            return np.asarray(arrays[name])
    return None


def _numpy(tensor: Any) -> NDArray[Any]:
    """Returns the array of a tensor of open3d, which can be in the memory of a GPU."""
    result: NDArray[Any] = (tensor.cpu() if hasattr(tensor, "cpu") else tensor).numpy()
    return result
