# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the calls in Python and the commands in the tables of the page "Migration"."""

import json
import os
import pathlib
import re
import shlex
import subprocess

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays

PROGRAM = os.environ.get("GEODESIC_PROCESSING_PROGRAM")
PAGE = pathlib.Path(__file__).parents[2] / "doc" / "manual" / "migration.txt"

# The grid has the unit square, so vertices are at multiples of this.
SIDE = 11
STEP = 1 / (SIDE - 1)


def calls(section):
    """Returns the code in the last column of the table of a section."""
    text = PAGE.read_text().split(r"\section GP_Migration_" + section + " ")[1].split(r"\section")[0]
    cells = [line.split("|")[-2] for line in text.splitlines() if line.startswith("| ")]
    return [call for cell in cells for call in re.findall("`([^`]+)`", cell)]


def write_off(path, V, F):
    lines = ["OFF", f"{len(V)} {len(F)} 0"]
    lines += [" ".join(map(str, p)) for p in V.tolist()]
    lines += ["3 " + " ".join(map(str, f)) for f in F.tolist()]
    path.write_text("\n".join(lines) + "\n")


@pytest.fixture
def part(tmp_path, monkeypatch):
    """Writes a grid to part.off in the current folder."""
    monkeypatch.chdir(tmp_path)
    V, F = grid_arrays(SIDE)
    write_off(tmp_path / "part.off", V, F)
    return V, F


def test_python_calls(part):
    V, F = part
    names = {"gp": gp, "V": V, "F": F, "P": V}
    for call in calls("potpourri3d"):
        exec(call, names)
    exact = np.linalg.norm(V - V[7], axis=1)
    # The grid is planar, so exact distances have round-off errors only.
    assert np.abs(names["e"] - exact).max() < 1e-12
    assert np.array_equal(names["part"].distance(7), names["e"])
    # The heat method and fast marching are off by less than one edge on this grid.
    for name in "d", "h", "f":
        assert np.abs(names[name] - exact).max() < STEP
    nearest = np.linalg.norm(V[:, None] - V[[1, 3, 4]], axis=2).min(axis=1)
    assert np.abs(names["m"] - nearest).max() < STEP
    p = names["p"]
    assert np.abs(p[[0, -1]] - V[[14, 22]]).max() < 1e-12
    length = np.linalg.norm(np.diff(p, axis=0), axis=1).sum()
    assert abs(length - np.linalg.norm(V[22] - V[14])) < 1e-12
    # The error of the front on a cloud is a few percent of the size of the square at most.
    assert np.abs(names["g"] - np.linalg.norm(V - V[4], axis=1)).max() < 0.05


def read_distances(name):
    """Returns the property `distance` of the vertices of a binary PLY file."""
    header, body = pathlib.Path(name).read_bytes().split(b"end_header\n", 1)
    properties = re.findall(rb"property double (\w+)", header)
    number = int(re.search(rb"element vertex (\d+)", header)[1])
    values = np.frombuffer(body, count=number * len(properties)).reshape(number, -1)
    return values[:, properties.index(b"distance")]


@pytest.mark.skipif(not PROGRAM, reason="GEODESIC_PROCESSING_PROGRAM is not set")
def test_commands(part):
    V, F = part
    output = b""
    for command in calls("meshlab"):
        program, *arguments = shlex.split(command)
        assert program == "geodesic"
        output += subprocess.run(
            [PROGRAM, *arguments, "--quiet"], check=True, capture_output=True
        ).stdout
    exact = np.linalg.norm(V, axis=1)
    # The grid is planar, so exact distances have round-off errors only.
    assert np.abs(read_distances("distance.ply") - exact).max() < 1e-12
    near = read_distances("near.ply")
    # The limit of the command is between two distances of the grid.
    assert np.array_equal(np.isfinite(near), exact <= 0.45)
    boundary = np.minimum(V[:, :2], 1 - V[:, :2]).min(axis=1)
    assert np.abs(read_distances("border.ply") - boundary).max() < 1e-12
    nearest = np.minimum(exact, np.linalg.norm(V - V[7], axis=1))
    assert np.abs(read_distances("selection.ply") - nearest).max() < 1e-12
    # The heat method is off by less than one edge on this grid.
    assert np.abs(read_distances("heat.ply") - nearest).max() < STEP
    assert gp.read("samples.ply").number_of_points == 20
    assert gp.read("remeshed.ply").number_of_points == 200
    assert json.loads(output)["faces"] == len(F)
