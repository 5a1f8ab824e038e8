# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of other packages."""

from types import SimpleNamespace

import geodesic_processing as gp
import numpy as np
import pytest

NORMAL = np.array([0.0, 0.0, 1.0])


def normals_of(points):
    return np.tile(NORMAL, (len(points), 1))


def expect_same(found, expected):
    assert found.is_cloud == expected.is_cloud
    assert found.number_of_points == expected.number_of_points
    assert np.array_equal(found.distance(5), expected.distance(5))


def quads(n=11):
    i = np.arange((n - 1) * n).reshape(n - 1, n)[:, :-1].ravel()
    return np.stack([i, i + n, i + n + 1, i + 1], axis=1)


class Tensor:
    """As those of open3d: it is copied from a device."""

    def __init__(self, values):
        self._values = values
        self._is_on_cpu = False

    def cpu(self):
        self._is_on_cpu = True
        return self

    def numpy(self):
        assert self._is_on_cpu
        return self._values


class Vector:
    """As those of open3d: a sequence that NumPy can read."""

    def __init__(self, values):
        self._values = values

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self._values, dtype)

    def __len__(self):
        return len(self._values)


def test_surface_is_itself(grid):
    assert gp.as_surface(grid) is grid


def test_trimesh(grid, arrays):
    V, F = arrays
    expect_same(gp.as_surface(SimpleNamespace(vertices=V, faces=F, convex_hull=None)), grid)
    cloud = gp.as_surface(SimpleNamespace(vertices=V, convex_hull=None))
    expect_same(cloud, gp.Surface(V))


def test_open3d(grid, cloud, arrays):
    V, F = arrays
    mesh = SimpleNamespace(vertices=Vector(V), triangles=Vector(F.astype(np.int32)))
    expect_same(gp.as_surface(mesh), grid)
    points = SimpleNamespace(
        points=Vector(V), normals=Vector(normals_of(V)), has_normals=lambda: True
    )
    expect_same(gp.as_surface(points), cloud)
    points = SimpleNamespace(points=Vector(V), normals=Vector([]), has_normals=lambda: False)
    expect_same(gp.as_surface(points), gp.Surface(V))


def test_tensors_of_open3d(grid, cloud, arrays):
    V, F = arrays
    mesh = SimpleNamespace(vertex={"positions": Tensor(V)}, triangle={"indices": Tensor(F)})
    expect_same(gp.as_surface(mesh), grid)
    points = {"positions": Tensor(V), "normals": Tensor(normals_of(V))}
    expect_same(gp.as_surface(SimpleNamespace(point=points)), cloud)
    del points["normals"]
    expect_same(gp.as_surface(SimpleNamespace(point=points)), gp.Surface(V))


def pyvista(points, faces, strips=(), point_data=None):
    return SimpleNamespace(
        points=points, faces=np.asarray(faces), strips=np.asarray(strips), cells=np.asarray(faces),
        point_data=point_data or {},
    )


def test_pyvista(grid, cloud, arrays):
    V, F = arrays
    padded = np.insert(F, 0, 3, axis=1).ravel()
    expect_same(gp.as_surface(pyvista(V, padded)), grid)
    expect_same(gp.as_surface(pyvista(V, [], point_data={"Normals": normals_of(V)})), cloud)
    expect_same(gp.as_surface(pyvista(V, [])), gp.Surface(V))
    mixed = np.concatenate([padded[:8], np.insert(quads()[1:], 0, 4, axis=1).ravel()])
    assert gp.as_surface(pyvista(V, mixed)).report.number_of_triangulated_polygons == 99
    expect_same(gp.as_surface(pyvista(V, np.insert(quads(), 0, 4, axis=1).ravel())),
                gp.Surface(V, quads()))


def test_vtk(grid, cloud, arrays):
    vtk = pytest.importorskip("vtkmodules.all")
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

    V, F = arrays
    mesh = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(V, deep=True))
    mesh.SetPoints(points)
    expect_same(gp.as_surface(mesh), gp.Surface(V))
    mesh.GetPointData().SetNormals(numpy_to_vtk(normals_of(V), deep=True))
    expect_same(gp.as_surface(mesh), cloud)
    for faces in (F, quads()):
        cells = vtk.vtkCellArray()
        padded = np.insert(faces, 0, faces.shape[1], axis=1).ravel().astype(np.int64)
        cells.SetCells(len(faces), numpy_to_vtkIdTypeArray(padded, deep=True))
        mesh.SetPolys(cells)
        expect_same(gp.as_surface(mesh), gp.Surface(V, faces))
    strips = vtk.vtkCellArray()
    strips.InsertNextCell(3, [0, 1, 2])
    mesh.SetStrips(strips)
    with pytest.raises(gp.InvalidArgumentError, match="strips"):
        gp.as_surface(mesh)
    for other in (vtk.vtkPolyData(), vtk.vtkUnstructuredGrid()):
        with pytest.raises(gp.InvalidArgumentError):
            gp.as_surface(other)


def test_meshio(grid, cloud, arrays):
    meshio = pytest.importorskip("meshio")
    V, F = arrays
    expect_same(gp.as_surface(meshio.Mesh(V, [("line", [[0, 1]]), ("triangle", F)])), grid)
    # Two blocks, and a mesh in the plane.
    expect_same(gp.as_surface(meshio.Mesh(V, [("triangle", F[:70]), ("triangle", F[70:])])), grid)
    expect_same(gp.as_surface(meshio.Mesh(V[:, :2], [("triangle", F)])), grid)
    mixed = gp.as_surface(meshio.Mesh(V, [("triangle", F[:1]), ("quad", quads()[1:])]))
    assert mixed.report.number_of_triangulated_polygons == 99
    # An octahedron without its upper half, and a square of four corners as a polygon.
    polygons = gp.as_surface(meshio.Mesh(V, [("polygon", quads())]))
    expect_same(polygons, gp.Surface(V, quads()))
    points = meshio.Mesh(V, [("vertex", np.arange(len(V))[:, None])],
                         point_data={"Normals": normals_of(V)})
    expect_same(gp.as_surface(points), cloud)
    for cells in ([("tetra", [[0, 1, 11, 12]])], [("triangle6", [[0, 1, 2, 3, 4, 5]])]):
        with pytest.raises(gp.InvalidArgumentError):
            gp.as_surface(meshio.Mesh(V, cells))


def test_points_are_merged(arrays):
    V, F = arrays
    separate = SimpleNamespace(vertices=V[F].reshape(-1, 3), faces=np.arange(F.size).reshape(-1, 3))
    merged = gp.as_surface(separate, merge_tolerance=0)
    assert merged.report.number_of_merged_points == F.size - len(V)
    with pytest.raises(gp.InvalidArgumentError):
        gp.as_surface(SimpleNamespace(vertices=V, convex_hull=None), merge_tolerance=0)


@pytest.mark.parametrize(
    "mesh",
    [
        None, 3, "mesh.ply", np.zeros((3, 3)), object(), [np.zeros((3, 3))],
        SimpleNamespace(vertices=np.zeros((3, 3))),
        SimpleNamespace(vertices="none", faces=[[0, 1, 2]]),
        SimpleNamespace(vertices=np.zeros((3, 3)), faces=[[0, 1, 3]]),
        SimpleNamespace(vertices=np.zeros((3, 3)), faces=np.empty((0, 3), int)),
        pyvista(np.zeros((3, 3)), [3, 0, 1]), pyvista(np.zeros((3, 3)), [3, 0, 1, 2, 2, 0]),
        pyvista(np.zeros((3, 3)), [-1, 0, 1, 2]), pyvista(np.zeros((3, 3)), [], [3, 0, 1, 2]),
        pyvista(np.zeros((3, 3)), [3, 0, 1, 7]), pyvista(np.zeros((3, 3)), [0]),
    ],
)
def test_rejects_other_objects(mesh):
    with pytest.raises(gp.InvalidArgumentError, match=r" .*\.$"):
        gp.as_surface(mesh)
