# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of point clouds."""

from typing import Dict, List, Sequence

from distances import solver_memory
from markdown import Cell, Table, Text, Value, Whole
from names import METHODS, MODELS, methods, row
from results import ANY

# Point clouds

cloud_accuracy = Table(
    ["cloud", "surfels", *(f"{METHODS[method]}: {error}"
                           for method in ("Euclidean_front", "Fast_marching", "Dijkstra")
                           for error in ("mean, %", "largest, %"))],
    [[MODELS[name], Value("cloud_errors", "errors on clouds", (name, ANY, "Dijkstra"), "surfels"),
      *(Value("cloud_errors", "errors on clouds", (name, ANY, method), column)
        for method in ("Euclidean_front", "Fast_marching", "Dijkstra")
        for column in ("mean error %", "largest error %"))]
     for name in ("bunny_37k", "nefertiti_35k", "kitten_9k", "eight_5k", "human_woman_7k",
                  "elephant_2k8")])

SPHERE_CLOUDS = {"100000": "100,000", "1000000": "1 million", "10000000": "10 million"}


def cloud_cells(size: str) -> Dict[str, Value]:
    sphere = f"sphere {size}"
    front = (sphere, ANY, "Euclidean_front")
    return {
        "domain: seconds": Value("memory", "domains of clouds", sphere, "make_domain() [s]"),
        "bytes": Value("memory", "domains of clouds", sphere, "domain [bytes per vertex]"),
        "peak bytes": Value("memory", "domains of clouds", sphere, "peak [bytes per vertex]"),
        "`Euclidean_front`: set-up, seconds":
            Value("memory", "solvers on clouds", front, "set-up [ms]", 2, 0.001),
        "query, seconds":
            Value("memory", "solvers on clouds", front, "later queries [ms]", 2, 0.001),
        "decal of 2,000 surfels: ms":
            Value("memory", "decals of 2,000 surfels", size, "median [ms]")}


cloud_memory = Table(
    ["surfels", *cloud_cells("1000000")],
    [[name, *cloud_cells(size).values()] for size, name in SPHERE_CLOUDS.items()])

cloud_solver_memory = solver_memory(
    "memory", "solvers on clouds", [f"sphere {size}" for size in SPHERE_CLOUDS],
    ("Dijkstra", "Fast_marching", "Euclidean_front"))

PUBLISHED = ("paper", "HP, paper")
SURFEL_METHODS = ("disks", "planes", "denoised disks", "default")


def surfel_errors(table: str, rows: Dict[str, str], names: Sequence[str],
                  sizes: Sequence[str] = ("surfels",)) -> List[List[Cell]]:
    """Returns the columns of sizes, and the errors EG and EP of the methods in one cell each."""
    return [[name, *(Value("surfels", table, row, size) for size in sizes),
             *(Text("{}, {}", Value("surfels", table, row, f"EG {method}"),
                    Value("surfels", table, row, f"EP {method}")) for method in names)]
            for row, name in rows.items()]


NOISES = {" 50 %": ", noise of 50 %", " 50 % +5 %": ", noise of 50 %, outliers",
          " 100 %": ", noise of 100 %", " 100 % +5 %": ", noise of 100 %, outliers"}

cloud_paper = Table(
    ["cloud", "surfels", "paper: EG, EP", "HP, paper", *SURFEL_METHODS],
    [*surfel_errors("clean clouds, %", {name: name for name in ("sphere", "plane", "cylinder")},
                    PUBLISHED + SURFEL_METHODS),
     *surfel_errors("spheres, %",
                    {f"level {i}": "sphere" for i in range(3, 7)}, PUBLISHED + SURFEL_METHODS),
     *surfel_errors("noisy clouds, %",
                    {**{name + noise: name + text for noise, text in NOISES.items()
                        for name in ("sphere", "plane", "cylinder")},
                     "simulated scan": "plane, simulated scan"}, PUBLISHED + SURFEL_METHODS)])

cloud_surfaces = Table(
    ["cloud", "surfels", *(f"{method}: EG, EP" for method in SURFEL_METHODS)],
    surfel_errors("other surfaces, %",
                  {row + noise: name + text
                   for row, name in {"torus": "torus", "ellipsoid": "ellipsoid",
                                     "bunny_zipper_36k": "scan"}.items()
                   for noise, text in {" 0 %": "", " 50 %": ", noise of 50 %",
                                       " 100 %": ", noise of 100 %",
                                       " 100 % +5 %": ", noise of 100 %, outliers"}.items()},
                  SURFEL_METHODS))

cloud_control_points = Table(
    ["cloud", *(f"{n} control points: EG, EP" for n in (9, 21, 37, 75))],
    surfel_errors("control points, %",
                  {f"{name} {noise} %": f"{name}, noise of {noise} %"
                   for name in ("sphere", "plane", "cylinder") for noise in (0, 50, 100)},
                  ("9", "21", "37", "75"), ()))

cloud_robust = Table(
    ["cloud, method", "clean", "5 % outliers", "10 % noise", "both"],
    [[f"{cloud}, `{method}`",
      *(Value("surfels", "robust weights", f"{cloud} {noise}", f"EG {weights}")
        for noise in ("0 %", "0 % +5 %", "10 %", "10 % +5 %"))]
     for cloud in ("sphere", "plane", "cylinder")
     for method, weights in (("spheres", "spheres"), ("robust_spheres", "robust spheres"))])

cloud_times = Whole(
    "surfels", "table 2 of the paper, seconds",
    {"sphere 50 %": "sphere, noise of 50 %", "plane 50 %": "plane, noise of 50 %",
     "cylinder 50 %": "cylinder, noise of 50 %", "simulated scan": "plane, simulated scan"},
    {"surface": "cloud", "surfels": "surfels", "paper, points": "points, paper", "paper": "paper",
     "HP, paper": "HP, paper", **{name: name for name in SURFEL_METHODS[:-1]}, "points": "points",
     "default": "default", "set-up": "precomputation"})

cloud_graph_times = Table(
    ["surfels", "graph, paper", "graph", "100 paths"],
    [[f"{size:,}", *(Value("surfels", "table 1 of the paper, seconds", str(size), column)
                     for column in ("paper, graph", "processor", "100 paths"))]
     for size in (35948, 101685, 134345, 546137, 1060220)])
