# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Invalid arguments raise subclasses of ValueError with a sentence."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays

V, F = grid_arrays(3)
NAN = np.full((9, 3), np.nan)
INFINITE = np.full((9, 3), np.inf)
NORMALS = np.tile([0.0, 0.0, 1.0], (9, 1))


class NotAnArray:
    def __array__(self, *arguments):
        raise RuntimeError("no array")


def check_error(function, kind=gp.InvalidArgumentError):
    with pytest.raises(kind) as caught:
        function()
    assert isinstance(caught.value, ValueError)
    sentence = str(caught.value)
    assert sentence.endswith(".") and " " in sentence


@pytest.mark.parametrize(
    "arguments",
    [
        (None, F), (3, F), ("points", F), ([[1, 2, 3], [1, 2]], F), (NotAnArray(), F),
        (V[:, :2], F), (V.ravel(), F), (V[:0], F), (V[None], F), (NAN, F), (INFINITE, F),
        (V.astype(complex), F), (V.astype(object), F), (V.astype("M8[s]"), F), (V > 0, F),
        (V, F[:, :2]), (V, F.ravel()), (V, F[:0]), (V, F[:, :0]), (V, F - 1), (V, F + 1),
        (V, F.astype(float)), (V, F > 0), (V, "faces"), (V, [[0, 1], [2]]), (V, [[0, 1, 2**70]]),
        (V, np.full((1, 3), 2**64 - 1, np.uint64)), (V, 5),
    ],
)
def test_mesh_rejects(arguments):
    check_error(lambda: gp.Surface(*arguments))


@pytest.mark.parametrize(
    "named",
    [
        {"normals": NORMALS[:5]}, {"normals": NAN}, {"normals": 0 * NORMALS}, {"normals": "up"},
        {"normals": NORMALS, "radii": np.ones(8)}, {"normals": NORMALS, "radii": -np.ones(9)},
        {"normals": NORMALS, "radii": np.full(9, np.nan)}, {"normals": NORMALS, "radii": NORMALS},
        {"normals": NORMALS, "merge_tolerance": 0.1}, {"remove_degenerate_faces": True},
    ],
)
def test_cloud_rejects(named):
    check_error(lambda: gp.Surface(V, **named))


def test_normals_need_enough_points():
    check_error(lambda: gp.Surface(V), gp.UnsupportedSurfaceError)


def test_mesh_rejects_arguments_of_clouds():
    check_error(lambda: gp.Surface(V, F, normals=NORMALS))
    check_error(lambda: gp.Surface(V, F, radii=np.ones(9)))
    check_error(lambda: gp.Surface(V, F, merge_tolerance=-1))
    check_error(lambda: gp.Surface(V, F, merge_tolerance="none"))


BAD_LOCATIONS = [
    [0, 9],
    None, -1, 9, 2**70, 1.0, True, "0", b"0", (), [], [[0, 1]], [None], [-1], [1.5], {}, object(),
    np.array([]), np.array([0.0]), np.array([[0]]), np.array([-1]), np.array([9]),
    np.array([True]), np.array([2**64 - 1], np.uint64),
]


@pytest.mark.parametrize("location", BAD_LOCATIONS + [
    (0, (0.2, 0.3)), (0, (0.5, 0.5, 0.5)), (0, (-0.5, 0.5, 1.0)), (0, (math.nan, 0.5, 0.5)),
    (-1, (1, 0, 0)), (8, (1, 0, 0)), (0.0, (1, 0, 0)), (0, ("a", "b", "c")), (0, 1.0), (0, None),
    [(0, (1, 0))],
])
def test_mesh_rejects_locations(location):
    surface = gp.Surface(V, F)
    check_error(lambda: surface.distance(location))
    check_error(lambda: surface.solver().compute(0).distance([location]))
    check_error(lambda: surface.path(0, location))
    check_error(lambda: surface.points([location]))
    if location is not None:
        check_error(lambda: surface.distance(0, targets=location))
        check_error(lambda: surface.distance_matrix(0, location))


@pytest.mark.parametrize("location", BAD_LOCATIONS + [
    (0, (0.2, 0.3, 0.5)), (0, (math.inf, 0)), (9, (0, 0)), (-1, (0, 0)), (0, 1.0),
])
def test_cloud_rejects_locations(location):
    surface = gp.Surface(V, normals=NORMALS)
    check_error(lambda: surface.distance(location))
    check_error(lambda: surface.solver().compute(0).distance([location]))
    check_error(lambda: surface.path(0, location))


READ_ONLY = np.empty(9)
READ_ONLY.flags.writeable = False


@pytest.mark.parametrize(
    "named",
    [
        {"method": "best"}, {"method": None}, {"method": 3}, {"max_distance": -1},
        {"max_distance": math.nan}, {"max_distance": "far"}, {"max_distance": None},
        {"offsets": [1, 2]}, {"offsets": [math.nan]}, {"offsets": [math.inf]}, {"offsets": "0"},
        {"speed": np.ones(8)}, {"speed": -np.ones(9)}, {"speed": np.full(9, np.nan)},
        {"speed": np.full(9, np.inf)}, {"speed": 1.0}, {"speed": "fast"},
        {"face_speed": np.ones(9)}, {"speed": np.ones(9), "face_speed": np.ones(8)},
        {"callback": 3}, {"targets": [0, (0, (1, 0, 0))]},
        {"out": np.empty(8)}, {"out": np.empty((9, 1))}, {"out": np.empty(9, np.float32)},
        {"out": [0.0] * 9}, {"out": READ_ONLY}, {"out": 3},
        {"out": np.empty(73, np.uint8)[1:].view(np.float64)},
    ],
)
def test_distance_rejects(named):
    surface = gp.Surface(V, F)
    out = named.get("out")
    check_error(lambda: surface.distance(0, **named))
    cloud = gp.Surface(V, normals=NORMALS)
    if "targets" not in named:
        check_error(lambda: cloud.distance(0, **named))
    assert named.get("out") is out


def test_out_is_unchanged_after_error():
    surface = gp.Surface(V, F)
    out = np.full(9, -1.0)
    check_error(lambda: surface.distance(9, out=out))
    check_error(lambda: surface.distance(0, out=out, max_distance=-1))
    assert (out == -1).all()


def test_unsupported_methods():
    cloud = gp.Surface(V, normals=NORMALS)
    mesh = gp.Surface(V, F)
    kind = gp.UnsupportedSurfaceError
    check_error(lambda: cloud.distance(0, method="exact"), kind)
    check_error(lambda: cloud.solver("exact"), kind)
    check_error(lambda: mesh.distance(0, method="heat", speed=np.arange(1, 10)), kind)
    check_error(lambda: mesh.solver("heat").compute(0, relative_tolerance=0.1), kind)
    check_error(lambda: cloud.faces, kind)
    check_error(lambda: cloud.report, kind)
    check_error(lambda: cloud.isolines(np.arange(9), [4]), kind)


@pytest.mark.parametrize("points", [[], [0, 0, 0], [[0, 0]], [[0, 0, math.nan]], "p", None])
def test_locate_rejects(points):
    check_error(lambda: gp.Surface(V, F).locate(points))
    check_error(lambda: gp.Surface(V, normals=NORMALS).locate(points))


@pytest.mark.parametrize(
    "pairs", [[], 3, None, [0], [(0,)], [(0, 1, 2)], np.array([0, 1]), [{0, 1}], [b"ab", 3]]
)
def test_paths_reject(pairs):
    check_error(lambda: gp.Surface(V, F).paths(pairs))


def test_other_functions_reject():
    surface = gp.Surface(V, F)
    check_error(lambda: surface.distance_matrix(0, threads=0))
    check_error(lambda: surface.distance_matrix(0, threads=1.5))
    check_error(lambda: surface.farthest_points())
    check_error(lambda: surface.farthest_points(-1))
    check_error(lambda: surface.farthest_points("all"))
    check_error(lambda: surface.farthest_points(radius=-1))
    check_error(lambda: surface.voronoi([]))
    for method in ("exact", "heat", "best", None):  # only fronts
        check_error(lambda: surface.voronoi(0, method=method))
        check_error(lambda: surface.farthest_points(2, method=method))
    check_error(lambda: surface.isolines(np.arange(8), [4]))
    check_error(lambda: surface.isolines(np.arange(9), []))
    check_error(lambda: surface.isolines(np.arange(9), [math.inf]))
    check_error(lambda: surface.solver().distance([0], out=np.empty(1)))


def test_unreadable_files(tmp_path):
    missing = tmp_path / "missing.off"
    with pytest.raises(OSError):
        gp.read(missing)
    check_error(lambda: gp.read(missing), gp.FileError)
    broken = tmp_path / "broken.off"
    broken.write_text("OFF\n3 1 0\n0 0 0\n")
    with pytest.raises(gp.FileError, match="broken.off"):
        gp.read(broken)
    with pytest.raises(TypeError):
        gp.read(3.5)


def test_exceptions_have_public_names():
    for name in ("InvalidArgumentError", "UnsupportedSurfaceError", "FileError", "Cancelled"):
        kind = getattr(gp, name)
        assert (kind.__module__, kind.__name__) == ("geodesic_processing", name)
    assert not issubclass(gp.Cancelled, ValueError)
