# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of surfaces, the program and comparisons with others."""

from typing import List

from markdown import Cell, Exponent, Table, Text, Value, Whole

# Surfaces

surfaces_soups = Whole("soups", "milliseconds", {},
                       {name: name for name in ("soup", "faces", "mesh", "arrays", "CGAL arrays",
                                                "torn", "CGAL torn")})

# Program

COMMANDS = ("distance", "path", "voronoi", "sample", "remesh")
GRIDS = {"10000": "10,000", "99856": "99,856", "1000000": "1 million", "9998244": "10 million",
         "19998784": "20 million"}


def command_cell(size: str, command: str) -> Text:
    key = (size, command)
    return Text("{} s, {} GB", *(Value("commands", "commands on grids", key, column, digits=2)
                                 for column in ("processor time [s]", "peak [GB]")))


def exponent(command: str, column: str) -> Exponent:
    small, large = (Value("commands", "commands on grids", (size, command), column)
                    for size in ("1000000", "19998784"))
    return Exponent(small, large, 19998784 / 1000000)


LARGE_ROWS: List[List[Cell]] = [
    [name, *(command_cell(size, command) for command in COMMANDS)]
    for size, name in GRIDS.items()]
program_large = Table(["vertices", *(f"`{command}`" for command in COMMANDS)],
                      [*LARGE_ROWS,
                       ["exponents", *(Text("{}, {}", exponent(command, "processor time [s]"),
                                            exponent(command, "peak [GB]"))
                                       for command in COMMANDS)]])

program_files = Whole(
    "inputs", "files", {},
    {"file": "file", "MB": "MB", "read": "read, ms",
     "CGAL soup/read": "reader of soups of \\cgal / read",
     "CGAL mesh/read": "reader of meshes of \\cgal / read", "solver": "solver, ms",
     "solver/PLY": "solver / PLY", "solver/CGAL mesh": "solver / reader of meshes",
     "speed-up of 2 threads": "two threads"})

# Comparison

COMPARED = {"Fast_marching": "`Fast_marching`", "Euclidean_front": "`Euclidean_front`",
            "Exact": "`Exact`", "Heat": "`Heat`", "CGAL": "\\cgal"}
comparison_fronts = Whole("comparison", "fronts: query [s]", COMPARED)
comparison_exact = Whole("comparison", "exact distances with set-up [s]", COMPARED)
comparison_heat = Whole("comparison", "heat method: set-up + query [s]", COMPARED)
comparison_clouds = Whole("comparison", "cloud of 100,000 random points of a sphere", {})

# Errors and limits

errors_commands = Whole("mass_test", "commands", {
    name: f"`{name}`" for name in ("info", "distance --method exact", "distance --method euclidean",
                                   "path", "sample", "voronoi", "segment", "remesh", "semiregular",
                                   "atlas", "emd")}
    | {"flatten, of surfaces with boundary": "`flatten`, of surfaces with boundary"})
errors_refused = Whole("mass_test", "refused files", {})

# Clusters

clusters_cortex = Whole("cortex", "rows of a distance matrix, one thread", {
    name: f"`{name}`" for name in ("exact", "heat", "euclidean", "fast-marching", "dijkstra")}
    | {"tvb-gdist": "exact algorithm of tvb-gdist"})
clusters_processes = Whole("cortex", "wall-clock time of some rows", {
    name: f"`{name}`" for name in ("euclidean", "exact")})
