# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the module with the program, which calls the library in C++."""

import json
import os
import subprocess

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import cube_arrays, rough_arrays

PROGRAM = os.environ.get("GEODESIC_PROCESSING_PROGRAM")
pytestmark = pytest.mark.skipif(not PROGRAM, reason="GEODESIC_PROCESSING_PROGRAM is not set")


def write_off(path, V, F):
    lines = ["OFF", f"{len(V)} {len(F)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in V]
    lines += ["3 " + " ".join(str(i) for i in f) for f in F]
    path.write_text("\n".join(lines) + "\n")


@pytest.fixture
def model(tmp_path):
    path = tmp_path / "rough.off"
    write_off(path, *rough_arrays(12))
    return path


def run(*arguments):
    result = subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True)
    return result.stdout


@pytest.mark.parametrize(
    "method", ["automatic", "exact", "euclidean", "fast-marching", "dijkstra", "heat"]
)
def test_distance_equals_program(model, tmp_path, method):
    values = tmp_path / "values.txt"
    run("distance", model, "--source", "0,77", "--method", method, "--values", values, "--quiet")
    name = "auto" if method == "automatic" else method
    # The program writes the shortest text that is read as the same number.
    assert np.array_equal(gp.read(model).distance([0, 77], method=name), np.loadtxt(values))


def test_path_equals_program(model):
    result = json.loads(run("path", model, "--from", 3, "--to", 140, "--json"))
    assert gp.read(model).path(3, 140).length == result["length"]


@pytest.mark.parametrize("reduce", ["min", "mean"])
def test_matrix_of_regions_equals_program(model, tmp_path, reduce):
    regions = np.arange(144) % 5 - 1
    file, matrix = tmp_path / "regions.txt", tmp_path / "matrix.npy"
    np.savetxt(file, regions, "%d")
    options = ["--average"] if reduce == "mean" else []
    run("matrix", model, "--regions", file, "--between-regions", *options, "-o", matrix, "--quiet")
    found = gp.read(model).distance_matrix(regions=regions, reduce=reduce)
    assert np.array_equal(found, np.load(matrix))


def test_labels_equal_program(model, tmp_path):
    values = tmp_path / "values.txt"
    run("voronoi", model, "--number", 5, "--values", values, "--quiet")
    surface = gp.read(model)
    labels = surface.voronoi(surface.farthest_points(5).locations).labels
    assert np.array_equal(labels, np.loadtxt(values))


def test_logarithmic_map_equals_program(model, tmp_path):
    values = tmp_path / "values.txt"
    surface = gp.read(model)
    for method in ("gradient", "exact", "discrete-exponential"):
        run("logmap", model, "--base", 65, "--radius", 0.4, "--up", "0,1,0", "--method", method,
            "--values", values, "--quiet")
        uv = surface.log_map(65, 0.4, (0, 1, 0), method=method).uv
        assert np.array_equal(uv, np.loadtxt(values), equal_nan=True)


def test_mean_equals_program(model):
    result = json.loads(run("karcher-mean", model, "--points", "3,60,140", "--json"))
    mean = gp.read(model).karcher_mean([3, 60, 140])
    # The program passes the corners of faces instead of vertices. Both are within the tolerance.
    assert np.abs(mean.point - result["mean"]).max() <= 1e-7
    assert abs(mean.value - result["value"]) <= 1e-12


@pytest.mark.parametrize("method", ["glle", "mds"])
def test_flattening_equals_program(model, tmp_path, method):
    values = tmp_path / "values.txt"
    run("flatten", model, "--method", method, "--values", values, "--quiet")
    surface = gp.read(model)
    flat = surface.lle() if method == "glle" else surface.mds()
    assert np.array_equal(flat.uv, np.loadtxt(values))


def test_injective_flattening_equals_program(model, tmp_path):
    values = tmp_path / "values.txt"
    result = json.loads(run("flatten", model, "--injective", "--values", values, "--json"))
    flat = gp.read(model).flatten()
    assert np.array_equal(flat.uv, np.loadtxt(values))
    for name in ("conformal", "authalic", "symmetric_dirichlet", "l2_stretch", "linf_stretch"):
        assert getattr(flat.distortion, name) == result[name]


def test_atlas_equals_program(model, tmp_path):
    values = tmp_path / "values.txt"
    result = json.loads(run("atlas", model, "--number", 3, "--values", values, "--json"))
    atlas = gp.read(model).atlas(3)
    assert np.array_equal(atlas.corner_uv.reshape(-1, 6), np.loadtxt(values))
    assert atlas.number_of_charts == result["charts"]
    assert atlas.coverage == result["coverage"]


def test_fuzzy_geodesics_equal_program(model, tmp_path):
    values = tmp_path / "values.txt"
    surface = gp.read(model)
    run("fuzzy", model, "--from", 13, "--to", 130, "--by-distances", "--values", values, "--quiet")
    # The program passes vertices, and the module locations at the corners of faces, whose exact
    # distances differ by round-off errors.
    assert np.abs(surface.fuzzy_geodesic_by_distances(13, 130) - np.loadtxt(values)).max() <= 1e-11
    run("fuzzy", model, "--from", 13, "--to", 130, "--width", 0.15, "--values", values, "--quiet")
    found = surface.fuzzy_geodesic(13, 130, 0.15).likelihood
    assert np.abs(found - np.loadtxt(values)).max() <= 1e-9


def result_of(*arguments):
    return json.loads(run(*arguments, "--json"))


def test_curves_equal_program(model):
    surface = gp.read(model)
    result = result_of("curve", model, "--points", "3,70,140")
    assert surface.bezier_curve([3, 70, 140]).length == result["length"]
    result = result_of("curve", model, "--points", "3,70,140", "--spline", "--closed")
    assert surface.spline([3, 70, 140], is_closed=True).length == result["length"]


def test_measures_equal_program(model):
    surface = gp.read(model)
    result = result_of("ball", model, "--source", "3,70", "--radius", 0.3)
    ball = surface.ball([3, 70], 0.3)
    assert ball.area == result["area"] and len(ball.faces) == result["faces_inside"]
    result = result_of("diameter", model)
    assert (surface.diameter().lower, surface.diameter().upper) == (
        result["lower"], result["upper"]
    )


def test_transport_equals_program(model, tmp_path):
    surface = gp.read(model)
    values = tmp_path / "values.txt"
    result = result_of("emd", model, "--from", 3, "--to", "70,140", "--values", values)
    found = surface.emd(3, [70, 140])
    assert (found.cost.lower, found.cost.upper) == (result["lower"], result["upper"])
    assert np.array_equal(found.potential, np.loadtxt(values))
    result = result_of("emd", model, "--from", 3, "--to", 140, "--basis", 5)
    found = surface.emd(3, 140, 5)
    assert (found.cost.value, found.basis_size) == (result["value"], result["basis"])
    result = result_of("plan", model, "--from", 3, "--to", "70,140", "--capacity", "0.5,0.7")
    found = surface.transport_to_region(3, [70, 140], capacities=[0.5, 0.7])
    assert found.cost.value == result["value"]
    assert found.arrivals[[70, 140]].tolist() == result["arrivals"]
    result = result_of("streamlines", model, "--from", 3, "--to", 140, "--number", 4)
    lines = surface.streamlines(3, 140, 4)
    assert sum(line.has_arrived for line in lines) == result["arrived"]
    assert np.mean([line.path.length for line in lines]) == pytest.approx(result["mean_length"])


def test_barycenters_equal_program(model, tmp_path):
    surface = gp.read(model)
    values = tmp_path / "values.txt"
    result = result_of("barycenter", model, "--points", "3,70,140", "--values", values)
    found = surface.barycenter([3, 70, 140])
    assert (found.value, found.distances.tolist()) == (result["value"], result["distances"])
    assert np.array_equal(found.masses, np.loadtxt(values))
    point = surface.geodesic_barycenter([3, 70, 140])
    assert (point.vertex, point.value) == (result["point"], result["point_value"])


def test_volumetric_distance_equals_program(tmp_path):
    cube = tmp_path / "cube.off"
    write_off(cube, *cube_arrays())
    result = result_of("volume", cube, "--from", "0.2,0.3,0.4", "--to", "1.5,0.5,0.5")
    cost = gp.read(cube).volumetric_distance([0.2, 0.3, 0.4], [1.5, 0.5, 0.5]).cost
    assert (cost.lower, cost.upper) == (result["lower"], result["upper"])
def test_segments_equal_program(model, tmp_path):
    values = tmp_path / "values.txt"
    run("segment", model, "--number", 5, "--values", values, "--quiet")
    labels = gp.read(model).segment(5, disks=False).labels
    assert np.array_equal(labels, np.loadtxt(values))


def check_mesh(path, surface):
    expected = gp.read(path)
    assert np.array_equal(surface.vertices, expected.vertices)
    assert np.array_equal(surface.faces, expected.faces)


def test_remeshing_equals_program(model, tmp_path):
    out = tmp_path / "out.off"
    run("remesh", model, "--number", 40, "--lloyd", 3, "--fit", "--seed", 7, "-o", out, "--quiet")
    check_mesh(out, gp.read(model).remesh(40, relaxation_steps=3, fit=True, seed=7).surface)
    run("remesh", model, "--number", 40, "--speed", "curvature-attractive", "-o", out, "--quiet")
    surface = gp.read(model)
    check_mesh(out, surface.remesh(40, speed=surface.curvature_speeds()).surface)


def test_base_mesh_equals_program(model, tmp_path):
    out, values = tmp_path / "out.off", tmp_path / "values.txt"
    run("base", model, "--number", 8, "-o", out, "--values", values, "--quiet")
    surface = gp.read(model)
    base = surface.parameterize_over_base(8)
    check_mesh(out, base.surface)
    check_mesh(out, surface.base_mesh(8).surface)
    lines = np.loadtxt(values)
    assert np.array_equal(base.vertex_locations.indices, lines[:, 0])
    assert np.array_equal(base.vertex_locations.coordinates, lines[:, 1:])


def test_semi_regular_mesh_equals_program(model, tmp_path):
    out = tmp_path / "out.off"
    run("semiregular", model, "--number", 8, "--levels", 2, "-o", out, "--quiet")
    check_mesh(out, gp.read(model).semi_regular(8, 2).surface)


def test_feature_distance_equals_program(model, tmp_path):
    values = tmp_path / "values.txt"
    run("feature-distance", model, "--feature", "3,77", "--values", values, "--quiet")
    distances = gp.read(model).feature_distance([3, 77]).distances
    assert np.array_equal(distances, np.loadtxt(values))
