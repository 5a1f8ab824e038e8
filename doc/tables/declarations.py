# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of the manual. The command \\table{NAME} includes the table NAME."""

from typing import Dict, List, Sequence, Union

from markdown import Cell, Column, Key, Range, Ratio, Table, Text, Value, Whole, grid
from results import ANY

# The models of the data folder, as the manual names them.
MODELS = {
    "armadillo_26k": "armadillo", "bunny_37k": "bunny", "bunny_zipper_36k": "bunny (zipper)",
    "camel_10k": "camel", "cow_2k9": "cow", "eight_5k": "double torus", "elephant_2k8": "elephant",
    "fandisk_16k": "fandisk", "fandisk_6k5": "fandisk",
    "fsaverage5_inflated_left_10k": "brain, inflated", "human_man_7k": "man",
    "human_woman_7k": "woman", "kitten_9k": "kitten", "man_17k": "man",
    "mech_holes_shark_5k": "mechanical part with holes", "mni152_grey_matter_533k": "grey matter",
    "nefertiti_35k": "Nefertiti", "pinion_650": "pinion", "rotor_2k4": "rotor",
    "triceratops_2k8": "triceratops", "turbine_9k": "part of a turbine",
}
METHODS = {name: f"`{name}`" for name in ("Dijkstra", "Fast_marching", "Euclidean_front", "Exact",
                                          "Heat")}


def models(*names: str) -> Dict[Key, Union[str, Sequence[str]]]:
    return {name: MODELS[name] for name in names}


def methods(*names: str) -> Dict[Key, Union[str, Sequence[str]]]:
    return {name: METHODS[name] for name in names}


def row(*cells: Cell) -> List[Cell]:
    return list(cells)


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
    [Column("processor time, seconds", "matrices of all pairs, Fast_marching", "processor time [s]"),
     Column("peak memory, MB", "matrices of all pairs, Fast_marching", "peak [MB]")])

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
    ["mesh", "vertex gradients: excess, %", "shortened", "face gradients: excess, %", "shortened",
     "`locally_shortest_path()`"],
    [[name, *(Value("accuracy", "paths", (mesh, distances, path), column)
              for distances, path, column in (
                  ("marching", "vertex gradients", "excess %"),
                  ("marching", "vertex gradients", "shortened: excess %"),
                  ("marching", "face gradients", "excess %"),
                  ("marching", "face gradients", "shortened: excess %"),
                  ("-", "locally_shortest_path()", "excess %")))]
     for mesh, name in {"icosphere 5": "sphere", "square 101^2": "jittered square",
                        "bunny_37k": "bunny", "nefertiti_35k": "Nefertiti",
                        "fandisk_6k5": "fandisk",
                        "mech_holes_shark_5k": "mechanical part with holes"}.items()])

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
    "isolines", "mesh", {"square 1001^2": "jittered grid"},
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

curves_splines = Whole("curves", "curves", MODELS, 3)

# Point clouds

cloud_accuracy = Table(
    ["cloud", "surfels", *(f"{METHODS[method]}: {error}"
                           for method in ("Euclidean_front", "Fast_marching", "Dijkstra")
                           for error in ("mean, %", "largest"))],
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


def surfel_errors(table: str, rows: Dict[str, str], names: Sequence[str]) -> List[List[Cell]]:
    """Returns the errors EG and EP of the methods in one cell each."""
    return [[name, *(Text("{}, {}", Value("surfels", table, row, f"EG {method}"),
                          Value("surfels", table, row, f"EP {method}")) for method in names)]
            for row, name in rows.items()]


NOISES = {" 50 %": ", noise of 50 %", " 50 % +5 %": ", noise of 50 %, outliers",
          " 100 %": ", noise of 100 %", " 100 % +5 %": ", noise of 100 %, outliers"}

cloud_paper = Table(
    ["cloud", "paper: EG, EP", "HP, paper", *SURFEL_METHODS],
    [*surfel_errors("clean clouds, %", {name: name for name in ("sphere", "plane", "cylinder")},
                    PUBLISHED + SURFEL_METHODS),
     *surfel_errors("spheres, %",
                    {f"level {i}": f"sphere, {4 ** (i + 1) + 2:,} surfels" for i in range(3, 8)},
                    PUBLISHED + SURFEL_METHODS),
     *surfel_errors("noisy clouds, %",
                    {**{name + noise: name + text for noise, text in NOISES.items()
                        for name in ("sphere", "plane", "cylinder")},
                     "simulated scan": "plane, simulated scan"}, PUBLISHED + SURFEL_METHODS)])

cloud_surfaces = Table(
    ["cloud", *(f"{method}: EG, EP" for method in SURFEL_METHODS)],
    surfel_errors("other surfaces, %",
                  {name + noise: name + text for name in ("torus", "ellipsoid", "scan")
                   for noise, text in {" 0 %": "", " 50 %": ", noise of 50 %",
                                       " 100 %": ", noise of 100 %",
                                       " 100 % +5 %": ", noise of 100 %, outliers"}.items()},
                  SURFEL_METHODS))

cloud_control_points = Table(
    ["cloud", *(f"{n} control points: EG, EP" for n in (9, 21, 37, 75))],
    surfel_errors("control points, %",
                  {f"{name} {noise} %": f"{name}, noise of {noise} %"
                   for name in ("sphere", "plane", "cylinder") for noise in (0, 50, 100)},
                  ("9", "21", "37", "75")))

cloud_robust = Table(
    ["cloud, method", "clean", "5 % outliers", "10 % noise", "both"],
    [[f"{cloud}, `{method}`", *(Value("surfels", "robust weights", f"{cloud} {noise}", f"EG {weights}")
                                for noise in ("0 %", "0 % +5 %", "10 %", "10 % +5 %"))]
     for cloud in ("sphere", "plane", "cylinder")
     for method, weights in (("spheres", "spheres"), ("robust_spheres", "robust spheres"))])

cloud_times = Whole("surfels", "table 2 of the paper, seconds", {}, 1)

cloud_graph_times = Table(
    ["surfels", "graph, paper", "graph", "100 paths"],
    [[f"{size:,}", *(Value("surfels", "table 1 of the paper, seconds", str(size), column)
                     for column in ("paper, graph", "processor", "100 paths"))]
     for size in (35948, 101685, 134345, 546137, 1060220)])

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

# Program

COMMANDS = ("distance", "path", "voronoi", "sample", "remesh")
GRIDS = {"10000": "10,000", "99856": "99,856", "1000000": "1 million", "9998244": "10 million",
         "19998784": "20 million"}


def command_cell(size: str, command: str) -> Text:
    key = (size, command)
    return Text("{} s, {} GB", Value("commands", "commands on grids", key, "processor time [s]"),
                Value("commands", "commands on grids", key, "peak [GB]"))


program_large = Table(
    ["vertices", *(f"`{command}`" for command in COMMANDS)],
    [[name, *(command_cell(size, command) for command in COMMANDS)]
     for size, name in GRIDS.items()])

program_files = Whole("inputs", "files", {})

# Surfaces

surfaces_soups = Whole("soups", "milliseconds", {})

# Decals

decals_placement = Table(
    ["mesh", "vertices", "median of `place()`, ms", "largest, ms", "first image of a placer, ms"],
    [[name, *(Value("decal", "placement", (mesh, ANY, "gradient"), column)
              for column in ("vertices", "placement [ms]", "maximum [ms]", "first placement [ms]"))]
     for mesh, name in {"bunny_37k": "bunny", "icosphere 7": "sphere",
                        "mni152_grey_matter_533k": "grey matter"}.items()])

# Remeshing

REMESHED = ("bunny_37k", "armadillo_26k", "fandisk_6k5", "kitten_9k", "elephant_2k8",
            "nefertiti_35k")
QUALITY = ("mean angle", "1st percentile", "mean to input %", "time [s]")


def remeshing_cell(file: str, table: str, key: Key) -> Text:
    return Text("{}, {}, {}, {}", *(Value(file, table, key, column) for column in QUALITY))


remeshing_quality = Table(
    ["model", "`geodesic_delaunay_remeshing()`", "`isotropic_remeshing()`",
     "vorpalite (geogram 1.10)", "ACVD"],
    [[MODELS[name],
      remeshing_cell("remeshing", "quality",
                     (name, "5000", "60 steps, fitted, sharp edges kept" if name == "fandisk_6k5"
                      else "60 steps, fitted")),
      remeshing_cell("remeshing", "quality", (name, "5000", "CGAL")),
      *(remeshing_cell("remeshing_peers", "quality, 5,000 vertices", (name, program))
        for program in ("vorpalite", "ACVD"))]
     for name in REMESHED])

remeshing_steps = Table(
    ["relaxation", "mean of the smallest angles, degrees", "mean distance to the input, %",
     "seconds"],
    [[steps, *(Range([Value("remeshing", "quality", (name, "5000", steps), column)
                      for name in REMESHED])
               for column in ("mean angle", "mean to input %", "time [s]"))]
     for steps in ("0 steps", "12 steps", "12 steps, fitted", "30 steps", "30 steps, fitted",
                   "60 steps, fitted")])

# Base meshes

base_steps = Whole("base", "steps of the paper", MODELS)
base_semi_regular = Whole("base", "semi-regular meshes", {})

# Performance

performance_files = Table(
    ["command", "100,000 vertices", "1 million", "20 million"],
    [[name, *(command_cell(size, command) for size in ("99856", "1000000", "19998784"))]
     for command, name in {
         "distance": "`distance`, fast marching from one corner",
         "path": "`path`, between opposite corners", "voronoi": "`voronoi`, 100 cells",
         "sample": "`sample`, 1,000 samples", "remesh": "`remesh`, 50,000 vertices"}.items()])


def solver_bytes(table: str, surfaces: Sequence[str], method: str, queries: str) -> Range:
    return Range([Value("memory", table, (surface, ANY, method),
                        f"after {queries} [bytes per vertex]") for surface in surfaces])


SPHERES = [f"sphere {size}" for size in SPHERE_CLOUDS]
MEMORY_SECTIONS = ("\\ref GP_Distances_memory \"Distances, memory\"",
                   "\\ref GP_Clouds_memory \"Point Clouds, memory\"")

performance_memory = Table(
    ["object", "bytes", "section"],
    [["domain of a mesh",
      Range([Value("memory", "domains of meshes", mesh, "domain [bytes per vertex]")
             for mesh in MEASURED_MESHES]), MEMORY_SECTIONS[0]],
     *(row(f"domain of a cloud{state}",
           Range([Value("memory", "domains of clouds", cloud, column) for cloud in SPHERES]),
           MEMORY_SECTIONS[1])
       for state, column in (("", "domain [bytes per vertex]"),
                             (", peak while it is built", "peak [bytes per vertex]"))),
     *(row(f"solver on a mesh, {METHODS[method]}, after {queries}",
           solver_bytes("solvers on meshes", MEASURED_MESHES, method, queries), MEMORY_SECTIONS[0])
       for method in ("Dijkstra", "Fast_marching", "Euclidean_front", "Exact")
       for queries in ("1 query", "5 queries")),
     *(row(f"solver on a cloud, {METHODS[method]}",
           solver_bytes("solvers on clouds", SPHERES, method, "5 queries"), MEMORY_SECTIONS[1])
       for method in ("Dijkstra", "Fast_marching", "Euclidean_front"))])


def exact_ratio(*surfaces: str) -> Text:
    return Text("{} times", Range([Value("exact", "one source", surface, "Exact/Euclidean")
                                   for surface in surfaces]))


def tolerance_ratio(surface: str) -> Text:
    return Text("{} times", Value("exact", "relative tolerance", (surface, ANY, "0.001"),
                                  "/ Euclidean"))


EXACT_SECTION = "\\ref GP_Distances_exact"
performance_distances = Table(
    ["task", "size", "time", "section"],
    [["`Exact`, relative to `Euclidean_front`", "scans of 36,000 vertices",
      exact_ratio("bunny_37k", "nefertiti_35k"), EXACT_SECTION],
     ["", "spheres of 41,000 to 164,000 vertices", exact_ratio("icosphere 6", "icosphere 7"), ""],
     ["", "flat squares", exact_ratio("square 201^2", "square 631^2"), ""],
     ["`Exact` with a relative tolerance of 10<SUP>-3</SUP>, relative to `Euclidean_front`",
      "scan of 37,706 vertices", tolerance_ratio("scan"), EXACT_SECTION],
     ["", "sphere of 163,842 vertices", tolerance_ratio("sphere"), ""],
     *(row(task if size == "1000000" else "", f"{SPHERE_CLOUDS[size]} surfels", cell,
           MEMORY_SECTIONS[1])
       for task, cells in (
           ("`make_domain()` of a cloud", {
               size: Text("{} s", cloud_cells(size)["domain: seconds"]) for size in ("1000000", "10000000")}),
           ("`Euclidean_front` on a cloud, set-up and query", {
               size: Text("{} + {} s", cloud_cells(size)["`Euclidean_front`: set-up, seconds"],
                          cloud_cells(size)["query, seconds"])
               for size in ("1000000", "10000000")}))
       for size, cell in cells.items()),
     ["matrix of `Fast_marching` in a file", "all pairs of 17,495 vertices",
      Text("{} s", Value("memory", "matrices of all pairs, Fast_marching",
                         ("man_17k", ANY, "file, float"), "processor time [s]")),
      "\\ref GP_Distances_matrices"],
     ["`feature_distance()`", "6,475 to 37,706 vertices",
      Text("{} s", Range([Value("regions", "features", f"{name}, a curve", "time [s]")
                          for name in FEATURE_MODELS])), "\\ref GP_Distances_features"],
     *(row(task, "150,000 vertices", Text("{} ms", Value("speed", "paths", key, "median [ms]")),
           "\\ref GP_Paths_finder")
       for task, key in (
           ("locally shortest path, `Geodesic_path_finder`",
            "Geodesic_path_finder, 0 landmarks, locally shortest"),
           ("shortest path, `Geodesic_path_finder`",
            "Geodesic_path_finder, 0 landmarks, shortest"))),
     ["path with speeds, after the travel times", "6,475 to 37,706 vertices",
      Text("{} ms", Range([Value("curves", "paths with speeds", name, "path, median [ms]")
                           for name in ("bunny_37k", "nefertiti_35k", "armadillo_26k", "kitten_9k",
                                        "camel_10k", "fandisk_6k5")])), "\\ref GP_Paths_speeds"],
     ["100 paths on a clean cloud", "134,345 surfels",
      Text("{} s", Value("surfels", "table 2 of the paper, seconds", "ellipsoid", "default")),
      "\\ref GP_Clouds_times \"Clouds, times\""],
     ["proximity graph of a cloud", "1,060,220 surfels",
      Text("{} s", Value("surfels", "table 1 of the paper, seconds", "1060220", "processor")),
      "\\ref GP_Clouds_times \"Clouds, times\""],
     ["split of a mesh at 20 isovalues", "1 million vertices",
      Text("{} ms", Value("isolines", "milliseconds", "square 1001^2", "split, mesh")),
      "\\ref GP_Curves_isolines"],
     ["diameter, tolerance of 1 %", "650 to 37,706 vertices",
      Text("{} s", Range([Value("curves", "diameter and radius", name, "diameter to 1 % [s]")
                          for name in ("bunny_37k", "nefertiti_35k", "armadillo_26k", "man_17k",
                                       "fandisk_16k", "kitten_9k", "pinion_650")])),
      "\\ref GP_Curves_diameter"],
     ["B&eacute;zier curve with 64 segments", "37,706 vertices",
      Text("{} s", Value("curves", "curves", ("bunny_37k", ANY, ANY, "64"), "time [s]")),
      "\\ref GP_Curves_subdivision"]])

TABLES: Dict[str, Union[Table, Whole]] = {
    name: table for name, table in globals().items() if isinstance(table, (Table, Whole))}
