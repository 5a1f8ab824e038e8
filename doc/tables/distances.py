# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of distances, paths and curves."""

from typing import List, Sequence

from markdown import Cell, Column, Range, Ratio, Table, Value, Whole, grid
from names import METHODS, MODELS, methods, models
from results import ANY

# Distances

QUANTILES = ("median", "90 %", "99 %")

distances_errors = grid(
    "public_meshes", "method",
    {**methods("Euclidean_front", "Fast_marching", "Heat"),
     "CGAL heat": "`Heat_method_3` of %CGAL, intrinsic Delaunay", "Dijkstra": "`Dijkstra`"},
    [*(Column(f"mean error, %: {q}", "mean error, %", q) for q in QUANTILES),
     *(Column(f"largest error, %: {q}", "largest error, %", q) for q in QUANTILES)])

MEASURED_MESHES = ("square 101^2", "square 1001^2", "bunny_37k", "nefertiti_35k", "fandisk_16k",
                   "mni152_grey_matter_533k")


def solver_memory(file: str, table: str, surfaces: Sequence[str], names: Sequence[str]) -> Table:
    """Returns the memory of solvers after some queries, and the time of later queries."""
    def values(method: str, column: str) -> List[Value]:
        return [Value(file, table, (surface, ANY, method), column) for surface in surfaces]

    rows: List[List[Cell]] = []
    for method in names:
        later = [Ratio(after, before) for after, before in
                 zip(values(method, "later queries [ms]"), values(method, "query 1 [ms]"))]
        rows.append([METHODS[method], *(Range(values(method, f"after {n} [bytes per vertex]"))
                                        for n in ("1 query", "5 queries")),
                     Range(later)])
    return Table(["method", "bytes after 1 query", "bytes after 5 queries",
                  "time of a later query / time of the first"], rows)


distances_memory = solver_memory("memory", "solvers on meshes", MEASURED_MESHES,
                                 ("Dijkstra", "Fast_marching", "Euclidean_front", "Exact"))

distances_exact = grid(
    "exact", "surface",
    {"bunny_37k": "bunny (scan)", "nefertiti_35k": "Nefertiti (scan)", "icosphere 6": "sphere",
     "icosphere 7": "sphere", "square 201^2": "flat square", "square 631^2": "flat square"},
    [Column("vertices", "one source", "vertices"),
     Column("`Euclidean_front`, seconds", "one source", "Euclidean [s]"),
     Column("`Exact`, seconds", "one source", "Exact [s]"),
     Column("`Exact` / `Euclidean_front`", "one source", "Exact/Euclidean"),
     Column("exact method of \\cgal / `Exact`", "one source", "CGAL/Exact")])

TOLERANCES = {"0": "0", "1.0e-05": "10<SUP>-5</SUP>", "1.0e-04": "10<SUP>-4</SUP>",
              "0.001": "10<SUP>-3</SUP>", "0.01": "10<SUP>-2</SUP>"}

distances_tolerance = Table(
    ["tolerance", "scan, 37,706 vertices", "largest error", "sphere, 163,842 vertices",
     "largest error"],
    [[name, *(Value("exact", "relative tolerance", (surface, ANY, tolerance), column)
              for surface in ("scan", "sphere") for column in ("/ Euclidean", "largest error"))]
     for tolerance, name in TOLERANCES.items()])

distances_matrices = grid(
    "memory", "output", {("man_17k", ANY, "file, float"): "file, `float`",
                         ("man_17k", ANY, "memory, double"): "memory, `double`"},
    [Column(heading, "matrices of all pairs, Fast_marching", column)
     for heading, column in (("processor time, seconds", "processor time [s]"),
                             ("peak memory, MB", "peak [MB]"))])

FEATURE_MODELS = ("fandisk_6k5", "camel_10k", "fsaverage5_inflated_left_10k", "armadillo_26k",
                  "nefertiti_35k", "bunny_37k")

distances_features = Table(
    ["model", "vertices", "to a point: error, %", "to a curve: error, %",
     "to a curve, fixed masses: error, %", "to a curve: seconds"],
    [[MODELS[name], *(Value("regions", "features", f"{name}, a {feature}", column)
                      for feature, column in (("point", "vertices"), ("point", "mean error %"),
                                              ("curve", "mean error %"),
                                              ("curve", "fixed masses, mean %"),
                                              ("curve", "time [s]")))]
     for name in FEATURE_MODELS])

# Paths

paths_tracing = Table(
    ["mesh, vertices", "vertex gradients: arrived", "excess, %", "shortened",
     "face gradients: excess, %", "shortened", "`locally_shortest_path()`"],
    [[name, *(Value("accuracy", "paths", (mesh, distances, path), column)
              for distances, path, column in (
                  ("marching", "vertex gradients", "arrived"),
                  ("marching", "vertex gradients", "excess %"),
                  ("marching", "vertex gradients", "shortened: excess %"),
                  ("marching", "face gradients", "excess %"),
                  ("marching", "face gradients", "shortened: excess %"),
                  ("-", "locally_shortest_path()", "excess %")))]
     for mesh, name in {"icosphere 5": "sphere, 10,242", "square 101^2": "jittered square, 10,201",
                        "bunny_37k": "bunny, 37,706", "nefertiti_35k": "Nefertiti, 35,002",
                        "fandisk_6k5": "fandisk, 6,475",
                        "mech_holes_shark_5k": "mechanical part with holes, 5,246"}.items()])

paths_tracing_times = Table(
    ["method", "set-up for each source, ms", "path, ms", "shortening, ms"],
    [[path, *(Value("accuracy", "paths", ("bunny_37k", "marching", path), column)
              for column in ("set-up [ms]", "path [ms]", "shortened [ms]"))]
     for path in ("vertex gradients", "face gradients")])

paths_finder = grid(
    "speed", "method",
    {"geodesic_path(domain)": "`geodesic_path()` of a domain",
     "geodesic_path<Euclidean_front>(domain)": "`geodesic_path<Euclidean_front>()` of a domain",
     "Geodesic_distance_solver, targets": "`Geodesic_distance_solver`, `Euclidean_front`, targets",
     "Geodesic_path_finder, 0 landmarks, shortest": "`Geodesic_path_finder`",
     "Geodesic_path_finder, 0 landmarks, locally shortest": "`locally_shortest_path()`",
     "Geodesic_path_finder, 16 landmarks, shortest": "`Geodesic_path_finder`, 16 landmarks",
     "Geodesic_path_finder, 16 landmarks, locally shortest":
         "`locally_shortest_path()`, 16 landmarks"},
    [Column("set-up, ms", "paths", "set-up [ms]"),
     Column("median of a path, ms", "paths", "median [ms]"),
     Column("90th percentile, ms", "paths", "90th percentile [ms]"),
     Column("mean excess of the length, %", "paths", "mean excess %")])

paths_speeds = grid(
    "curves", "mesh",
    models("bunny_37k", "nefertiti_35k", "armadillo_26k", "kitten_9k", "camel_10k", "fandisk_6k5"),
    [Column("faces", "paths with speeds", "faces"),
     Column("travel times, ms", "paths with speeds", "travel times [ms]"),
     Column("median of a path, ms", "paths with speeds", "path, median [ms]"),
     Column("largest, ms", "paths with speeds", "path, maximum [ms]")])

# Curves

curves_isolines = grid(
    "isolines", "mesh", {"square 1000": "jittered grid"},
    [Column("vertices", "milliseconds", "vertices"),
     Column("`make_domain()`, ms", "milliseconds", "domain"),
     Column("`isolines()` of the domain, ms", "milliseconds", "isolines, domain"),
     Column("`split_at_isolines()` of the mesh, ms", "milliseconds", "split, mesh")])

curves_loops = grid(
    "curves", "mesh", models("rotor_2k4", "turbine_9k", "bunny_zipper_36k"),
    [Column("vertices", "loops", "vertices"),
     Column("loops of a basis", "loops", "loops of the basis"),
     Column("`loop_basis()`, seconds", "loops", "basis [s]"),
     Column("`shortest_noncontractible_loop()`, smallest", "loops", "shortest loop, minimum [s]"),
     Column("largest, seconds", "loops", "shortest loop, maximum [s]"),
     Column("exact distances, seconds", "loops", "exact distances [s]")])

curves_diameter = grid(
    "curves", "mesh",
    {**models("bunny_37k", "nefertiti_35k", "armadillo_26k", "man_17k", "fandisk_16k", "kitten_9k",
              "pinion_650"), "sphere": "sphere", "torus": "torus"},
    [Column("vertices", "diameter and radius", "vertices"),
     Column("diameter to 1 %: iterations", "diameter and radius", "diameter to 1 %: iterations"),
     Column("seconds", "diameter and radius", "diameter to 1 % [s]"),
     Column("diameter to 0.1 %: iterations", "diameter and radius",
            "diameter to 0.1 %: iterations"),
     Column("seconds", "diameter and radius", "diameter to 0.1 % [s]"),
     Column("radius to 1 %: iterations", "diameter and radius", "radius to 1 %: iterations"),
     Column("gap, %", "diameter and radius", "radius: gap %"),
     Column("seconds", "diameter and radius", "radius to 1 % [s]")])

curves_splines = Whole("curves", "curves", {**MODELS, "time [s]": "seconds"}, number_of_labels=3)
