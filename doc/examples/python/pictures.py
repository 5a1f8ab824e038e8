# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the results of three examples: the pictures of the chapter "Python" of the manual.

Argument: the folder of the pictures. It needs VTK and a display. Without a display, use
`xvfb-run -a python3 pictures.py FOLDER`.
"""

import os
import runpy
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLightKit,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, the implementation of the window

GREY = np.array([225, 225, 225])
BLACK = (0.1, 0.1, 0.1)
SCRIPTS = Path(__file__).resolve().parent


def example(name):
    """Runs an example in a temporary folder and returns its variables."""
    sys.argv = [name]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        return SimpleNamespace(**runpy.run_path(str(SCRIPTS / f"{name}.py")))


def poly_data(points, cells, are_faces):
    """Returns polygons or lines: a list of rows of points."""
    data = vtkPolyData()
    vertices = vtkPoints()
    vertices.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(vertices)
    array = vtkCellArray()
    flat = np.concatenate([np.insert(cell, 0, len(cell)) for cell in cells]).astype(np.int64)
    array.SetCells(len(cells), numpy_to_vtkIdTypeArray(flat, deep=True))
    (data.SetPolys if are_faces else data.SetLines)(array)
    return data


def actor_of(output, color=None):
    """Returns the actor of a filter, in one color or in those of its scalars."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(output)
    actor = vtkActor()
    actor.SetMapper(mapper)
    if color is not None:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(*color)
    return actor


def mesh(surface, colors):
    """Returns the actor of a mesh with colors of its vertices or faces."""
    faces = surface.faces
    data = poly_data(surface.vertices, faces, True)
    scalars = numpy_to_vtk(np.ascontiguousarray(colors, np.uint8), deep=True)
    (data.GetCellData() if len(colors) == len(faces) else data.GetPointData()).SetScalars(scalars)
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    return actor_of(normals.GetOutputPort())


def tube(points, radius):
    """Returns the actor of a polyline."""
    filter = vtkTubeFilter()
    filter.SetInputData(poly_data(points, [np.arange(len(points))], False))
    filter.SetRadius(radius)
    filter.SetNumberOfSides(8)
    return actor_of(filter.GetOutputPort(), BLACK)


def ball(point, radius):
    """Returns the actor of a point."""
    source = vtkSphereSource()
    source.SetCenter(*point)
    source.SetRadius(radius)
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    return actor_of(source.GetOutputPort(), BLACK)


def write_picture(actors, direction, zoom, size, path):
    """Draws actors that are seen from a direction, the third coordinate upwards."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    vtkLightKit().AddLightsToRenderer(renderer)
    for actor in actors:
        actor.GetProperty().SetAmbient(0.2)
        renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*direction)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def parcels(path):
    result = example("parcellation")
    palette = np.random.default_rng(3).uniform(80, 255, (len(result.seeds), 3))
    lines = [tube(line.points, 0.01) for line in result.voronoi.bisectors]
    seeds = [ball(point, 0.03) for point in result.surface.points(result.seeds)]
    cells = result.surface.voronoi_cells(result.seeds)
    surface = mesh(cells.surface, palette[cells.face_labels])
    write_picture([surface, *lines, *seeds], (2, -3, 1.5), 1.4, (600, 560), path)


def stamp(path):
    result = example("stamp")
    write_picture([mesh(result.surface, result.colors)], (1, -3, 2.5), 1.5, (760, 460), path)


def activations(path):
    result = example("activation_distance")
    a, b = (masses[:, None] / masses.max() for masses in (result.a, result.b))
    colors = GREY + a * ((200, 40, 40) - GREY) + b * ((40, 70, 200) - GREY)
    lines = result.cortex.streamlines(result.a, result.b, 40)
    tubes = [tube(line.path.points, 0.008) for line in lines]
    write_picture([mesh(result.cortex, colors), *tubes], (1, -3, 2), 1.4, (760, 460), path)


if __name__ == "__main__":
    folder = Path(sys.argv[1]).resolve()
    for draw in (parcels, stamp, activations):
        draw(folder / f"python_{draw.__name__}.png")
