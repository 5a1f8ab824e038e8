# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces for the tests, and a limit of their time."""

import faulthandler
import os

import geodesic_processing as gp
import numpy as np
import pytest

# A test that takes longer waits for something that never happens: the slowest test takes 20 s on an
# idle machine.
MAX_SECONDS = 600


def pytest_configure(config):
    # pytest captures standard error later, and a message in a captured file would be lost.
    config.uncaptured_stderr = os.fdopen(os.dup(2), "w")


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_protocol(item):
    """Ends the process if a test waits forever. Prints what each thread waits for."""
    faulthandler.dump_traceback_later(MAX_SECONDS, exit=True, file=item.config.uncaptured_stderr)
    yield
    faulthandler.cancel_dump_traceback_later()


def grid_arrays(n, side=1.0):
    """Returns the vertices and triangles of n x n points of a square; vertex i n + j is (i, j)."""
    x, y = np.meshgrid(np.linspace(0, side, n), np.linspace(0, side, n), indexing="ij")
    V = np.stack([x.ravel(), y.ravel(), np.zeros(n * n)], axis=1)
    i = np.arange((n - 1) * n).reshape(n - 1, n)[:, :-1].ravel()
    F = np.concatenate([np.stack([i, i + n, i + n + 1], 1), np.stack([i, i + n + 1, i + 1], 1)])
    return V, F


def rough_arrays(n):
    """Returns a square with random heights, on which exact distances take long."""
    V, F = grid_arrays(n)
    V[:, 2] = np.random.default_rng(1).uniform(0, 2 / n, len(V))
    return V, F


def prism_arrays(k, n):
    """Returns the lateral faces of a prism with k sides, radius 1, height 1 and n rings.

    Vertex i k + j is at the angle 2 pi j / k of ring i.
    """
    angle = 2 * np.pi * np.arange(k) / k
    z = np.repeat(np.linspace(0, 1, n), k)
    V = np.stack([np.tile(np.cos(angle), n), np.tile(np.sin(angle), n), z], axis=1)
    i, j = np.meshgrid(np.arange(n - 1) * k, np.arange(k), indexing="ij")
    a, b = (i + j).ravel(), (i + (j + 1) % k).ravel()
    F = np.concatenate([np.stack([a, b, b + k], 1), np.stack([a, b + k, a + k], 1)])
    return V, F


def points_of(V, F, faces, barycentric):
    """Returns the points with barycentric coordinates in faces."""
    return np.einsum("ij,ijk->ik", barycentric, V[F[faces]])


def refined_arrays(V, F):
    """Returns the uniform 1-to-4 refinement of a mesh. Vertices of the mesh come first."""
    edges = np.sort(F[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, position = np.unique(edges, axis=0, return_inverse=True)
    a, b, c = F.T
    ab, bc, ca = len(V) + position.reshape(-1, 3).T
    parts = [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    return np.concatenate([V, V[edges].mean(axis=1)]), np.concatenate(parts, axis=1).T


def sphere_arrays(levels):
    """Returns a refined octahedron with vertices on the unit sphere; 4^(levels + 1) + 2 vertices."""
    V = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    F = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
                  [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    for _ in range(levels):
        V, F = refined_arrays(V, F)
        V = V / np.linalg.norm(V, axis=1)[:, None]
    return V, F


def torus_arrays(n, m, radius=1.0, tube=0.4):
    """Returns a torus of n x m vertices around the z axis."""
    i, j = np.meshgrid(np.arange(n), np.arange(m), indexing="ij")
    a, b = 2 * np.pi * i.ravel() / n, 2 * np.pi * j.ravel() / m
    r = radius + tube * np.cos(b)
    V = np.stack([r * np.cos(a), r * np.sin(a), tube * np.sin(b)], axis=1)
    corner = lambda di, dj: ((i + di) % n * m + (j + dj) % m).ravel()
    p, q, r, s = corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)
    return V, np.concatenate([np.stack([p, q, r], 1), np.stack([p, r, s], 1)])


def cube_arrays(levels=0):
    """Returns the unit cube with two refined triangles on each side, oriented outwards."""
    V = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    F = np.array([t for a, b, c, d in quads for t in ([a, b, c], [a, c, d])])
    for _ in range(levels):
        V, F = refined_arrays(V, F)
    return V, F


def face_areas(surface):
    """Returns the areas of the faces of a surface."""
    a, b, c = np.moveaxis(surface.vertices[surface.faces], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def points_at(surface, locations):
    """Returns the points of locations on a mesh by their barycentric coordinates."""
    corners = surface.vertices[surface.faces[locations.indices]]
    return np.einsum("ij,ijk->ik", locations.coordinates, corners)


def topology(surface):
    """Returns the numbers of components and boundary cycles, and the genus."""
    report = surface.report
    return report.number_of_components, report.number_of_boundary_cycles, report.genus


@pytest.fixture
def arrays():
    return grid_arrays(11)


@pytest.fixture
def grid(arrays):
    return gp.Surface(*arrays)


@pytest.fixture
def cloud(arrays):
    V = arrays[0]
    return gp.Surface(V, normals=np.tile([0.0, 0.0, 1.0], (len(V), 1)))


@pytest.fixture(params=["mesh", "cloud"])
def surface(request):
    return request.getfixturevalue("grid" if request.param == "mesh" else "cloud")
