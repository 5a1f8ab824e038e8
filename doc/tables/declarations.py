# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of the manual. The command \\table{NAME} includes the table NAME."""

from typing import Dict, List, Sequence, Union

from markdown import AnyTable, Cell, Column, Key, Range, Ratio, Table, Text, Value, Whole, grid
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
    "triceratops_2k8": "triceratops", "turbine_9k": "part of a turbine", "turbine": "part of a turbine", "icosphere 5": "sphere",
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

curves_splines = Whole("curves", "curves", MODELS, number_of_labels=3)

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

cloud_times = Whole("surfels", "table 2 of the paper, seconds")

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

HOLE_METHODS = ("minimal_dihedral_angles", "unfolding")
HOLES = {"bunny_zipper_36k": "bunny (zipper)", "plane_holes_8k5": "plane with holes",
         "mech_holes_shark_5k": "mechanical part with holes", "blade_8k": "blade", "pig_468": "pig",
         **{f"radius of {radius} edges": f"radius of {radius} edges" for radius in (2, 4, 7, 12)}}

remeshing_holes = Table(
    ["holes", "number", *(f"`{method}`: angle, dihedral angle, pairs" for method in HOLE_METHODS),
     "largest time, seconds"],
    [[name, Value("holes", "holes", (holes, "minimal_dihedral_angles"), "filled"),
      *(Text("{}, {}, {}", *(Value("holes", "holes", (holes, method), column)
                             for column in ("mean smallest angle [degrees]",
                                            "largest dihedral angle [degrees]",
                                            "new intersecting pairs")))
        for method in HOLE_METHODS),
      Range([Value("holes", "holes", (holes, method), "time [s]") for method in HOLE_METHODS])]
     for holes, name in HOLES.items()])

# Wavelets

WAVELET_MESHES = {f"{model}{kind}": f"{name}, {text}"
                  for kind, text in ((", smooth", "smooth"), ("", "semi-regular"))
                  for model, name in (("bunny_37k", "bunny"), ("nefertiti_35k", "Nefertiti"))}


def wavelet_row(mesh: str, name: str, prediction: str) -> List[Cell]:
    def tenth(method: str, column: str) -> Value:
        return Value("wavelets", mesh, (method, "10 %"), column)

    return [name, f"`{prediction}`",
            *(Ratio(tenth("samples", column), tenth(prediction, column))
              for column in ("error", "error to surface")),
            *(Value("wavelets", mesh, (prediction, "", "6.00"), column)
              for column in ("error", "error to surface"))]


wavelets_errors = Table(
    ["mesh", "prediction", "gain, vertex error", "gain, surface error",
     "vertex error at 6 bits per vertex, 10<SUP>-4</SUP> diagonals", "surface error"],
    [wavelet_row(mesh, name, prediction) for mesh, name in WAVELET_MESHES.items()
     for prediction in ("butterfly", "linear")], 2)

# Base meshes

base_steps = Whole("base", "steps of the paper", MODELS)
base_meshes = Whole(
    "base", "base meshes", MODELS,
    {"model": "model", "base": "base vertices", "folds H": "inverted before repair",
     "repaired faces": "repaired base faces", "folds": "inverted after repair",
     "round trip": "round trip", "Ec H": "Ec, Heron", "Ea H": "Ea, Heron",
     "Ec M": "Ec, mean values", "Ea M": "Ea, mean values", "base [s]": "base mesh, seconds",
     "map [s]": "parameterization, seconds"})
base_semi_regular = Whole("base", "semi-regular meshes")
flattening_optimality = Whole("distortion", "optimality")

# Samples

sampling_times = Whole(
    "sampling", "samples", MODELS,
    {"mesh": "mesh", "vertices": "vertices", "method": "method", "samples": "samples",
     "one front [ms]": "one front, ms", "all samples [s]": "all samples, seconds", "ratio": "ratio"})

# Flattening

PATCHES = {
    "disk_5k": "disk", "alligator_3k": "alligator", "bff_maze_6k": "maze",
    "cylinder_locally_refined_8k": "capped cylinder", "hemisphere_2k": "hemisphere",
    "patch_01_735": "smooth patch", "nefertiti_299": "Nefertiti", "mushroom_2k": "mushroom",
    "three_peaks_2k": "three peaks", "camelhead_11k": "camel's head", "bff_face_17k": "face",
    "mannequin_devil_13k": "mannequin with horns", "terrain_st_helens_149k": "Mount St. Helens"}


def flattening_value(patch: str, method: str, column: str) -> Value:
    return Value("flattening", "distortion", (patch, ANY, ANY, method), column)


def flattening_cell(patch: str, method: str) -> Text:
    return Text("{}, {}, {}", *(flattening_value(patch, method, column)
                                for column in ("Ec", "Ea", "flips")))


flattening_distortion = Table(
    ["patch", "vertices", "\\f$ \\int \\vert K \\vert / 2\\pi \\f$", "`geodesic_lle()`",
     "`geodesic_mds()`", "LSCM", "authalic"],
    [[name, flattening_value(patch, "glle", "vertices"),
      flattening_value(patch, "glle", "curvature / 2 pi"),
      *(flattening_cell(patch, method) for method in ("glle", "mds", "CGAL lscm", "CGAL authalic"))]
     for patch, name in PATCHES.items()])

flattening_energy = Table(
    ["patch", "`minimize_distortion()`: energy", "inverted faces", "ARAP: energy", "inverted faces"],
    [[name, *(flattening_value(patch, method, column)
              for method in ("injective", "CGAL arap") for column in ("Dirichlet", "flips"))]
     for patch, name in PATCHES.items() if patch != "terrain_st_helens_149k"])

flattening_times = Whole(
    "flattening", "times", {**PATCHES, "terrain_st_helens_149k, refined once":
                            "Mount St. Helens, refined 1-to-4"},
    {"patch": "patch", "vertices": "vertices", "glle": "`geodesic_lle()`",
     "mds": "`geodesic_mds()`", "injective": "`minimize_distortion()`", "CGAL lscm": "LSCM",
     "CGAL arap": "ARAP"})

flattening_base_points = Whole(
    "flattening", "base points", PATCHES,
    {"patch: Dirichlet energy": "patch", "5 base points": "5 base points", "10": "10", "20": "20",
     "100": "100", "20, injective": "20, `minimize_distortion()`",
     "100, injective": "100, `minimize_distortion()`"})

FLATTENING_PAPER = {"fast marching": "fast marching", "sampling, 200": "200 samples",
                    "Lloyd step": "step of a centroidal tessellation", "mds": "`geodesic_mds()`",
                    "conformal": "conformal", "authalic": "authalic", "glle": "`geodesic_lle()`",
                    "lle alone": "embedding alone", "vertices": "vertices"}


flattening_paper_1 = Whole(
    "flattening", "table I of the paper", {"camelhead_11k (10k)": "camel's head"},
    {"table I: seconds (paper)": "patch",
     **{name: FLATTENING_PAPER[name] for name in
        ("vertices", "fast marching", "sampling, 200", "Lloyd step", "mds", "glle")}})

flattening_paper_2 = Whole(
    "flattening", "table II of the paper", {"camelhead_11k (10,000)": "camel's head (10,000)"},
    {"table II: seconds (paper)": "patch",
     **{name: FLATTENING_PAPER[name] for name in ("vertices", "mds", "conformal", "glle")}})

flattening_paper_3 = Whole(
    "flattening", "table III of the paper", PATCHES,
    {"table III: Ec, Ea (paper)": "patch",
     **{name: FLATTENING_PAPER[name] for name in
        ("conformal", "authalic", "mds", "glle", "lle alone")}})

STARTS = {"lle": "start `lle`", "mds": "start `mds`", "lle alone": "embedding alone",
          "centered, interpolated": "centered", "centered, Nystrom": "centered, Nystr&ouml;m",
          "printed, interpolated": "printed", "printed, Nystrom": "printed, Nystr&ouml;m"}

flattening_starts = Table(
    ["patch", *STARTS.values()],
    [[name, *(Value("flattening", "starts", patch, column, part=1) for column in STARTS)]
     for patch, name in PATCHES.items()])

THEORY = {
    "mips": "\\f$ 1 + \\vert K \\vert r^2 / 6 \\f$", "symmetric_mips": "\\f$ 2 + K^2 r^4 / 36 \\f$",
    "conformal": "\\f$ K^2 r^4 / 72 \\f$", "green_lagrange": "\\f$ K^2 r^4 / 9 \\f$",
    "combined(1)": "\\f$ 4 + K^2 r^4 / 9 \\f$", "dirichlet": "\\f$ 1 - K r^2 / 6 \\f$",
    "l2_stretch": "\\f$ 1 - K r^2 / 12 \\f$",
    "linf_stretch": "\\f$ 1 + \\max(-K, 0) r^2 / 6 \\f$",
    "symmetric_stretch": "\\f$ 1 + \\vert K \\vert r^2 / 6 \\f$",
    "riemannian": "\\f$ \\vert K \\vert r^2 / 3 \\f$"}

flattening_measures = Table(
    ["measure", "theory", "\\f$ K = 1 \\f$", "measured", "\\f$ K = -1 \\f$", "measured"],
    [[f"`{name}`" if name.endswith(")") else f"`{name}()`", formula,
      *(Value("distortion", "coefficients of measures", name, column)
        for column in ("K = 1", "Gradient, K = 1", "K = -1", "Gradient, K = -1"))]
     for name, formula in THEORY.items()])

flattening_metric = Whole(
    "distortion", "metric on the sphere", {},
    {"u": "\\f$ u \\f$", "Gradient": "`Gradient<>`", "Exact": "`Exact`",
     "expansion": "second-order expansion", "sphere": "sphere"})

flattening_coefficients = Whole(
    "distortion", "Taylor coefficients of the metric", {},
    {"surface": "surface", "method": "method", "vertices": "vertices", "radius": "radius",
     "K/3": "\\f$ K/3 \\f$", "g11 v^2": "\\f$ u_2^2 \\f$ in \\f$ g_{11} \\f$",
     "g12 uv": "\\f$ u_1 u_2 \\f$ in \\f$ g_{12} \\f$",
     "g22 u^2": "\\f$ u_1^2 \\f$ in \\f$ g_{22} \\f$", "other": "others"}, number_of_labels=2)

flattening_residuals = Whole(
    "distortion", "deviation of the metric", {},
    {"surface": "surface", "method": "method", "vertices": "vertices",
     "0.1": "\\f$ r = 0.1 \\f$", "0.2": "0.2", "0.4": "0.4", "0.6": "0.6"}, number_of_labels=2)

# Logarithmic maps

LOG_MAPS = {"Gradient<Euclidean_front>": "`Gradient<>`",
            "Gradient<Euclidean_front>, stencil of 0.2": "`Gradient<>`, `stencil_length(0.2)`",
            "Gradient<Exact>": "`Gradient<Exact>`", "Gradient<Heat>": "`Gradient<Heat>`",
            "Gradient<Fast_marching>": "`Gradient<Fast_marching>`",
            "Gradient<Dijkstra>": "`Gradient<Dijkstra>`", "Exact": "`Exact`",
            "Discrete_exponential": "`Discrete_exponential`"}

logmap_errors = Table(
    ["method", *(f"{surface}, {size}" for surface in ("icosphere", "random points")
                 for size in ("10,242", "40,962", "163,842"))],
    [[name, *(Value("logmap", f"errors on {surface}, %", method, size)
              for surface in ("icospheres", "random points")
              for size in ("10242", "40962", "163842"))]
     for method, name in LOG_MAPS.items()])

logmap_clouds = Whole("logmap", "spherical clouds",
                      {"random": "random surfels", "spiral": "surfels on a spiral",
                       "octahedron": "subdivided octahedron"},
                      {"mean error % on a spherical cloud": "cloud", "surfels": "surfels",
                       "Gradient<Euclidean_front>": "error of `Gradient<>`, %"})

GRADIENTS = {f"Gradient<{method}>": f"`Gradient<{method}>`"
             for method in ("Dijkstra", "Fast_marching", "Euclidean_front", "Exact")}

logmap_lengths = Table(
    ["method", "noise", "distance, %", "gradient, stencil of 1 edge, %", "of 3 edges"],
    [[name, f"{noise} %", *(Value("logmap", "lengths on noisy spheres", (noise, method), column)
                            for column in ("distance", "1 ring", "3 rings"))]
     for method, name in GRADIENTS.items() for noise in ("0", "5")], 2)

logmap_noise = Table(
    ["method", "noise", "plain", "30 smoothing steps", "3 base refinements", "both"],
    [[name, f"{noise} %",
      *(Text("{}, {}", *(Value("logmap", "angles on noisy spheres", (noise, method + option), column,
                               part=0) for column in ("default stencil", "3 rings")))
        for option in ("", ", 30 steps", ", 3 refinements", ", 30 steps, 3 refinements"))]
     for method, name in GRADIENTS.items() if method != "Gradient<Exact>"
     for noise in ("0", "5")], 2)

logmap_smoothed = Table(
    ["mesh with noise of 5 %", "`Gradient<>`, default stencil, degrees", "`Exact`, degrees"],
    [[name, *(Value("logmap", "angles on noisy spheres", ("5", method + suffix), "default stencil",
                    part=1) for method in ("Gradient<Euclidean_front>", "Exact"))]
     for suffix, name in (("", "as it is"), (", smoothed mesh", "smoothed by `smooth_shape()`"))])

MEANS = {"mesh": "points on", "cloud": "points on", "vertices": "vertices", "surfels": "surfels",
         "locations": "points", "radius": "radius of the ball", "time [s]": "seconds",
         "iterations": "iterations", "error": "error"}
logmap_means = Whole("means", "means on meshes", MODELS,
                     {name: MEANS[name] for name in ("mesh", "vertices", "locations", "radius",
                                                     "time [s]", "iterations", "error")})
logmap_cloud_means = Whole("means", "means on clouds", {},
                           {name: MEANS[name] for name in ("cloud", "surfels", "locations",
                                                           "time [s]", "iterations", "error")})

# Transport

transport_accuracy = Whole(
    "transport_bounds", "bounds on models", MODELS,
    {"model": "model", "vertices": "vertices",
     "value below exact % (mean / max)": "`value` below, %, mean / maximum",
     "upper_continuous excess %": "`upper_continuous` above, %, mean / maximum"},
    ("fandisk_6k5", "kitten_9k", "camel_10k", "nefertiti_35k", "bunny_37k"))
transport_basis_sizes = Whole("transport_claims", "basis sizes", {
    **MODELS, "distance of two densities": "surface"})
transport_excess = Whole("transport_claims", "monotonicity", {
    **MODELS, **PATCHES, "plane_holes_8k5": "plane with holes", "pig_468": "pig"})
transport_pairs = Whole("transport_family", "all pairs", MODELS)
transport_one_to_all = Whole(
    "transport_family", "one to all", MODELS,
    {"one to all": "mesh", "vertices": "vertices", "family": "family", "k": "`k`",
     "set-up [s]": "set-up, seconds", "query [s]": "query, seconds", "mean error %": "mean error, %",
     "above geodesic %": "above geodesic, %"})
transport_paper_1 = Whole("transport_times", "table 1 of the paper")
transport_paper_basis = Whole("transport_times", "k = 100")
transport_paper_2 = Whole("transport_times", "table 2 of the paper")
transport_triangles = Whole("transport_claims", "triangle inequality", MODELS)
transport_stability = Whole("transport_claims", "stability")
transport_isotropy = Whole("transport_claims", "anisotropy")
transport_unevenness = Whole("transport_claims", "unevenness", {**MODELS, **PATCHES})

# Flows

flows_barycenters = Whole(
    "barycenters", "points on meshes", MODELS,
    {"mesh": "points on", "vertices": "vertices", "points": "points",
     "250 steps [s]": "250 steps, seconds", "cost excess %": "above the optimum, %", "gap %": "gap, %",
     "steps to gap of 1 %": "steps to a gap of 1 %", "time [s]": "seconds"})
flows_regions = Whole("regions", "exits with capacities")
flows_streamlines = Whole(
    "flows", "streamlines", MODELS,
    {"model": "surface", "vertices": "vertices", "masses": "masses",
     "excess length % (mean / max)": "as traced, %, mean / maximum",
     "shortened %": "shortened, %, mean / maximum",
     "assignment excess %": "assignment above the distance, %", "tracing [s]": "seconds to trace",
     "shortening [s]": "seconds to shorten"})
flows_balls = Whole("flows", "balls", MODELS)

# Volumes

volumes_coordinates = Whole(
    "volumes", "coordinates", MODELS,
    {"coordinates": "model", "vertices": "vertices",
     "linear error [diagonals]": "linear error, diagonals",
     "time per point [ms]": "time of a point, ms"})
volumes_slices = Whole(
    "volumes", "slices", MODELS,
    {"slice, 2 threads": "model", "vertices": "vertices", "points": "points",
     "processor [s]": "processor time, seconds", "wall-clock [s]": "wall-clock time, seconds",
     "solved": "solved", "maximum gap %": "largest gap, %", "maximum error %": "largest error, %"})

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
      "\\ref GP_Curves_subdivision"]], 4)

TIMES_SECTION = "\\ref GP_Transport_times \"Transport, times\""
# The samples, the mesh, its number of vertices, and the key of the row.
SAMPLED = (("1,000", "grey matter", "533,000", ("mni152_grey_matter_533k", ANY, "Euclidean_front", "1000")),
           ("5,000", "bunny, refined once", "150,000", ("bunny_37k, refined once", ANY, "Euclidean_front", "5000")))

performance_meshes = Table(
    ["task", "size", "time", "section"],
    [*(row(f"{samples} farthest point samples", f"{mesh}, {size} vertices",
           Text("{} fronts over the mesh", Value("sampling", "samples", key, "ratio")),
           "\\ref GP_Samples_implementation \"Sampling and Voronoi Diagrams\"")
       for samples, mesh, size, key in SAMPLED),
     ["remeshing with 5,000 vertices, 60 relaxation steps and a fit", "2,775 to 37,706 vertices",
      Text("{} s", Range([Value("remeshing", "quality", (name, "5000", "60 steps, fitted"),
                                "time [s]") for name in REMESHED])),
      "\\ref GP_Remeshing_quality"],
     *(row(task, "5,246 to 6,475 vertices",
           Text("{} s", Range([Value("base", "steps of the paper", name, column)
                               for name in ("eight_5k", "mech_holes_shark_5k", "fandisk_6k5")])),
           "\\ref GP_Base_implementation \"Base Meshes\"")
       for task, column in (("base mesh of 500 vertices", "base mesh (about 10)"),
                            ("semi-regular mesh, 500 base vertices and four levels",
                             "complete model (less than 60)"))),
     ["mean of 1,000 points on a sphere, ball of radius 1.41", "40,962 vertices",
      Text("{} s", Value("means", "means on meshes", ("sphere", "40962", "1000", "1.41"),
                         "time [s]")), "\\ref GP_LogMap_means"],
     ["placement of an image that covers 2,000 faces", "533,000 vertices",
      Text("{} ms", Value("decal", "placement", ("mni152_grey_matter_533k", ANY, "gradient"),
                          "placement [ms]")), "\\ref GP_Decals_implementation \"Decals\""],
     *(row(task, size, Text("{} s", Value("flattening", "times", patch, column)),
           "\\ref GP_Flattening_times \"Flattening, times\"")
       for task, size, patch, column in (
           ("`geodesic_lle()`", "148,885 vertices", "terrain_st_helens_149k", "glle"),
           ("`geodesic_lle()`", "593,955 vertices", "terrain_st_helens_149k, refined once",
            "glle"),
           ("`minimize_distortion()`, from the map of `geodesic_lle()`", "148,885 vertices",
            "terrain_st_helens_149k", "injective")))], 4)

performance_transport = Table(
    ["task", "size", "time", "section"],
    [["uniform mass to one vertex, all flows", "10,242 vertices",
      Text("{} s", Value("transport_times", "table 1 of the paper", "fsaverage5_inflated_left_10k",
                         "all flows")), TIMES_SECTION],
     ["all pairs of 100 samples, `k` = 0, precomputation and query", "37,706 vertices",
      Text("{} + {} s", *(Value("transport_family", "all pairs", ("bunny_37k", ANY, "100"),
                                 f"gradient: {part} [s]")
                          for part in ("set-up", "query"))), TIMES_SECTION],
     *(row(f"one vertex to all, `k` = {k}, precomputation and query", "10,242 vertices",
           Text("{} + {} s", *(Value("transport_family", "one to all",
                                     ("fsaverage5_inflated_left_10k", ANY, family, k),
                                     f"{part} [s]") for part in ("set-up", "query"))),
           TIMES_SECTION) for family, k in (("balanced", "0"), ("default", "100"))),
     ["barycenter of three points, 250 steps", "about 2,500 vertices",
      Text("{} s", Range([Value("barycenters", "points on meshes", (name, ANY, "3"),
                                "250 steps [s]")
                          for name in ("rotor_2k4", "cow_2k9", "elephant_2k8",
                                       "triceratops_2k8")])), "\\ref GP_Flows_barycenters"],
     ["streamlines: tracer with 200 lines", "37,706 vertices",
      Text("{} s", Range([Value("flows", "streamlines", ("bunny_37k", ANY, masses), "tracing [s]")
                          for masses in ("points", "blobs")])), "\\ref GP_Flows_streamlines"],
     ["mean value coordinates of a point", "10,242 vertices",
      Text("{} ms", Value("volumes", "coordinates", "icosphere 5", "time per point [ms]")),
      "\\ref GP_Volume_implementation \"Volumes\""],
     ["`costs()` to a grid of 100 by 100 points, processor time", "10,242 vertices",
      Text("{} s", Value("volumes", "slices", "icosphere 5", "processor [s]")),
      "\\ref GP_Volume_implementation \"Volumes\""]], 4)

TABLES: Dict[str, AnyTable] = {
    name: table for name, table in globals().items() if isinstance(table, (Table, Whole))}
