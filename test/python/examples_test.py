# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the examples of the manual and checks their results by closed forms and identities."""

import os
import re
import runpy
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, sphere_arrays

FOLDER = Path(__file__).parents[2] / "doc" / "examples" / "python"
NAMES = sorted(path.stem for path in FOLDER.glob("*.py") if path.stem != "pictures")


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    """Runs an example in a new folder. Returns its variables and, as ``output``, what it prints."""

    def run_example(name, *arguments):
        monkeypatch.chdir(tmp_path)
        monkeypatch.setattr(sys, "argv", [name, *map(str, arguments)])
        variables = runpy.run_path(str(FOLDER / f"{name}.py"))
        return SimpleNamespace(**variables, output=capsys.readouterr().out)

    return run_example


def numbers(text):
    """Returns the numbers in a text."""
    return [float(number) for number in re.findall(r"\d+(?:\.\d+)?", text)]


def areas_of(points, faces):
    a, b, c = np.moveaxis(points[faces], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def all_distances(points):
    return np.linalg.norm(points[:, None] - points, axis=2)


@pytest.mark.parametrize("name", NAMES)
def test_example_is_short_and_has_a_test(name):
    assert len((FOLDER / f"{name}.py").read_text().splitlines()) <= 40
    assert f"test_{name}" in globals()


def test_chapter_has_all_functions_and_examples():
    manual = FOLDER.parents[1] / "manual"
    chapter = "".join((manual / name).read_text() for name in ("python.txt", "clusters.txt"))
    for name in NAMES:
        assert f"\\include python/{name}.py" in chapter
    for name in dir(gp.Surface):
        assert name[0] == "_" or re.search(rf"`s\.{name}\b", chapter), name
    for name in gp.__all__:
        assert re.search(rf"\b{name}\b", chapter), name


def test_pictures_are_drawn(tmp_path):
    pytest.importorskip("vtkmodules.all")
    if shutil.which("xvfb-run") is None:
        pytest.skip("xvfb-run is not installed")
    command = ["xvfb-run", "-a", sys.executable, FOLDER / "pictures.py", tmp_path]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    for name in ("parcels", "stamp", "activations"):
        size = (tmp_path / f"python_{name}.png").stat().st_size
        # An empty picture has less than 5 kB.
        assert 30_000 < size <= 150_000


def test_distances_on_scan(run):
    example = run("distances_on_scan")
    reached, size, farthest = numbers(example.output)[:3]
    assert reached == size == 4000
    distances = np.loadtxt("distances.txt")
    assert farthest == pytest.approx(distances.max(), abs=1e-4)  # four decimals
    directions = example.P / np.linalg.norm(example.P, axis=1, keepdims=True)
    exact = np.arccos(directions[:, 2].clip(-1, 1))  # the angle to the point (0, 0, 1)
    # The standard deviation of the noise is 0.01. The largest error that was measured is 0.046.
    assert np.abs(distances - exact).max() < 0.07


def test_path_between_points(run):
    example = run("path_between_points")
    # Sixteen sides of the tube and the height are the legs of a right triangle in the plane.
    exact = np.hypot(16 * 2 * np.sin(np.pi / 64), 1.6)
    assert example.path.length == pytest.approx(exact, rel=1e-12)
    assert example.path.lower <= exact * (1 + 1e-14)
    lines = [line.split() for line in Path("path.obj").read_text().splitlines()]
    points = np.array([line[1:] for line in lines if line[0] == "v"], float)
    assert [int(i) for i in lines[-1][1:]] == list(range(1, len(points) + 1))
    assert np.linalg.norm(np.diff(points, axis=0), axis=1).sum() == pytest.approx(exact, rel=1e-12)


def test_pooling_levels(run):
    example = run("pooling_levels")
    surface, samples = example.surface, example.samples
    levels = np.load("levels.npz")
    for size in example.sizes:
        cells, edges = levels[f"cells_{size}"], levels[f"edges_{size}"]
        assert sorted(set(cells)) == list(range(size))
        distance = surface.distance(samples.vertices[:size])
        # The radii are those of an approximate front. The largest difference measured is 0.02 %.
        assert distance.max() == pytest.approx(samples.radii[size - 1], rel=0.002)
        pooled = levels[f"features_{size}"] * np.bincount(cells)
        assert pooled.sum() == pytest.approx(example.features.sum(), abs=1e-9)
        if size >= 64:  # Euler's formula on a torus: the samples are the vertices of triangles
            assert len(edges) == 3 * size


def test_cortex_matrix(run):
    example = run("cortex_matrix")
    matrix, vertices = np.load("distances.npy"), np.loadtxt("vertices.txt", dtype=int)
    assert np.abs(matrix - matrix.T).max() < 1e-6  # float32
    # The same distances on the whole surface, on which a front does not enter the wall
    surface = gp.Surface(example.V, example.all_faces)
    kept = {tuple(face) for face in np.sort(example.cortex.faces)}
    speed = np.array([float(tuple(face) in kept) for face in np.sort(surface.faces)])
    for row in (0, 100, 400):
        expected = surface.distance(vertices[row], face_speed=speed)[vertices]
        assert matrix[row] == pytest.approx(expected, rel=1e-6)
    # The wall makes some paths longer and none shorter.
    some = slice(None, None, 20)
    direct = surface.distance_matrix(vertices[some], vertices)
    assert (matrix[some] >= direct * (1 - 1e-6)).all()
    assert (matrix[some] > 1.1 * direct).any()


def test_atlas_to_gltf(run):
    example = run("atlas_to_gltf")
    assert "injective: True" in example.output
    surface = gp.read("atlas.glb")
    assert areas_of(surface.vertices, surface.faces) == pytest.approx(np.full(12, 2.0), rel=1e-6)
    data = Path("atlas.glb").read_bytes()[-example.number_of_bytes :]
    size = len(example.points)
    uv = np.frombuffer(data, "<f4", 2 * size, 12 * size).reshape(-1, 2)
    faces = np.frombuffer(data, "<u4", offset=20 * size).reshape(-1, 3)
    assert uv.min() >= 0 and uv.max() <= 1
    assert len(np.unique(np.round(surface.vertices))) == 2  # coordinates 1 and -1
    # Charts do not overlap, so that areas in the texture add up to the part that is used.
    areas = areas_of(np.insert(uv.astype(float), 2, 0, axis=1), faces)
    assert numbers(example.output)[-1] == pytest.approx(100 * areas.sum(), abs=0.1)


def test_activation_distance(run):
    example = run("activation_distance")
    lower, upper, in_space = numbers(example.output)
    # The sheet is a rectangle that is folded. The masses move along it by 40 steps.
    assert lower - 1e-4 <= 4 <= upper + 1e-4  # four decimals
    assert lower == pytest.approx(4, rel=1e-3)  # the tolerance of emd()
    assert upper < 1.05 * lower
    center = example.cortex.vertices
    straight = np.linalg.norm(center[example.first] - center[example.second])
    assert in_space < 1.1 * straight < lower


def test_parcellation(run):
    example = run("parcellation")
    surface, labels = example.surface, np.loadtxt("parcels.txt", dtype=int)
    total = areas_of(surface.vertices, surface.faces).sum()
    areas = [float(area) for area in re.findall(r"area (\d+\.\d+)", example.output)]
    assert sum(areas) == pytest.approx(total, abs=12 * 1e-4)  # twelve numbers with four decimals
    matrix = surface.distance_matrix(example.seeds, np.arange(surface.number_of_points))
    used = np.unique(surface.faces)
    own = matrix[labels[used], used]
    # Labels are those of an approximate method. The largest ratio that was measured is 1.001.
    assert (own <= 1.01 * matrix[:, used].min(axis=0)).all()
    a, b, c = np.moveaxis(surface.vertices[surface.faces], 1, 0)
    longest_edge = max(np.linalg.norm(p - q, axis=1).max() for p, q in ((a, b), (b, c), (c, a)))
    solvers = [surface.solver().compute(seed) for seed in example.seeds]
    for line in example.voronoi.bisectors:
        locations = gp.Locations(line.faces, line.barycentric)
        left, right = (solvers[cell].distance(locations) for cell in (line.left, line.right))
        # A corner of a cell is known up to the face that contains it.
        assert left == pytest.approx(right, abs=2 * longest_edge)
        assert np.median(np.abs(left - right)) < 0.05 * longest_edge


def test_stamp(run):
    example = run("stamp")
    lines = Path("stamp.off").read_text().splitlines()
    rows = np.array([line.split() for line in lines[2 : 2 + 201 * 101]], float)
    row, column = np.divmod(np.arange(201 * 101), 101)
    radius = 0.03 * np.hypot(row - 100, column - 50)  # the unfolded sheet
    colors = rows[:, 3:]
    for low, high, color in (
        (0, 0.2, (200, 30, 60)),
        (0.2, 0.4, (250, 220, 90)),
        (0.8, 1, (200, 30, 60)),
        (1, np.inf, (220, 220, 220)),
    ):
        # Colors are interpolated between the centers of pixels, whose diagonal is this long.
        diagonal = np.sqrt(2) * 2 / 256
        is_inside = (radius > low + diagonal) & (radius < high - diagonal)
        assert (colors[is_inside] == color).all()
    assert gp.read("stamp.off").number_of_faces == example.surface.number_of_faces


def test_split_at_isolines(run):
    example = run("split_at_isolines")
    perimeter = 48 * 2 * np.sin(np.pi / 48)
    lengths = re.findall(r"length (\d+\.\d+)", example.output)
    assert [float(length) for length in lengths] == pytest.approx([perimeter] * 3, abs=1e-6)
    expected = perimeter * np.array([0.6, 0.6, 0.6, 0.2])
    assert numbers(example.output.splitlines()[-1]) == pytest.approx(expected, abs=1e-6)
    assert example.areas == pytest.approx(expected, rel=1e-9)


def test_remesh(run):
    example = run("remesh")
    vertices, faces, angle = numbers(example.output)
    assert vertices == 500 and faces == 2 * 500 - 4  # Euler's formula on a sphere
    assert angle > 30  # measured: 39; the triangles at the poles have an angle of 3.75 degrees
    remeshed = gp.read("remeshed.off")
    assert remeshed.report.number_of_components == 1 and remeshed.report.genus == 0
    points = remeshed.vertices
    on_surface = example.surface.points(example.surface.locate(points))
    assert points == pytest.approx(on_surface, abs=1e-8)  # nine digits


def test_flatten_sheet(run):
    example = run("flatten_sheet")
    assert example.output.startswith("inverted faces: 0 of 2400")
    lines = [line.split()[1:] for line in Path("flat.obj").read_text().splitlines()]
    uv = np.array(lines[41 * 31 : 2 * 41 * 31], float)
    row, column = np.divmod(np.arange(41 * 31), 31)
    unfolded = 0.1 * np.stack([row, column], axis=1)
    some = slice(None, None, 7)
    assert all_distances(uv[some]) == pytest.approx(all_distances(unfolded[some]), abs=1e-3)


def test_density_barycenter(run):
    example = run("density_barycenter")
    # Both densities are moved by half of their distance 2, in opposite directions.
    result = example.result
    assert result.lower <= 2
    assert result.value == pytest.approx(2, rel=0.01)  # the tolerance of barycenter()
    assert result.distances == pytest.approx([1, 1], rel=0.01)
    assert result.masses.sum() == pytest.approx(1, rel=1e-9)
    assert np.array_equal(np.loadtxt("barycenter.txt"), result.density)


def test_cortex_parcels(tmp_path):
    # Its processes import it, so that it is run as a program.
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join(filter(None, sys.path)))
    script = FOLDER / "cortex_parcels.py"
    subprocess.run([sys.executable, script], check=True, cwd=tmp_path, env=environment)
    distances = np.load(tmp_path / "distances.npy")
    assert distances.dtype == np.float32 and distances.shape == (17 * 16, 17 * 16)
    minima, means = (np.loadtxt(tmp_path / name) for name in ("minima.txt", "means.txt"))
    parcels = np.arange(17 * 16) // 16 // 4  # the last one is one ring of vertices
    assert minima.shape == means.shape == (5, 5)
    for a in range(5):
        for b in range(5):
            block = distances[np.ix_(parcels == a, parcels == b)]
            # Numbers of 32 bits.
            assert means[a, b] == pytest.approx(block.mean(), rel=1e-6)
            # A front from several sources has other errors than fronts from each of them.
            assert minima[a, b] == pytest.approx(block.min(), abs=0.02)
    # Half of the torus is left. The shortest path between its ends consists of 16 chords of the inner
    # circle, which has the radius 2. The numbers have 32 bits.
    length = 16 * 2 * 2 * np.sin(np.pi / 32)
    assert distances[:16, -16:].min() == pytest.approx(length, rel=1e-6)


ARGUMENTS = {
    "distances_on_scan": [0, 0, 1],
    "path_between_points": [0, 0, 0, 1, 1, 0],
    "cortex_matrix": ["wall.txt"],
    "activation_distance": [3, 40],
    "parcellation": [5],
    "remesh": [30],
    "stamp": [20, 0.5],
    "split_at_isolines": [0.2],
    "density_barycenter": [3, 40],
}


@pytest.mark.parametrize("name", [name for name in NAMES if name != "cortex_parcels"])
def test_example_reads_a_file(run, tmp_path, name):
    V, F = sphere_arrays(4) if name in ("pooling_levels", "distances_on_scan") else grid_arrays(9)
    lines = [f"OFF\n{len(V)} {len(F)} 0", *("{} {} {}".format(*p) for p in V)]
    lines += ["3 {} {} {}".format(*f) for f in F]
    (tmp_path / "model.off").write_text("\n".join(lines) + "\n")
    (tmp_path / "wall.txt").write_text("1\n" + "0\n" * (len(V) - 1))
    example = run(name, "model.off", *ARGUMENTS.get(name, []))
    surfaces = [value for value in vars(example).values() if isinstance(value, gp.Surface)]
    assert any(surface.number_of_points == len(V) for surface in surfaces)
    assert "nan" not in example.output and "inf" not in example.output
