# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of samples, remeshing and maps."""

from typing import List, Union

from markdown import Cell, Key, Range, Ratio, Table, Text, Value, Whole
from names import METHODS, MODELS
from results import ANY

# Samples

sampling_times = Whole(
    "sampling", "samples",
    {**MODELS, **METHODS, "icosphere 7": "sphere", "bunny_37k, refined once": "bunny, refined once"},
    {"mesh": "mesh", "vertices": "vertices", "method": "method", "samples": "samples",
     "one front [ms]": "one front, ms", "all samples [s]": "all samples, seconds", "ratio": "ratio"})

# Remeshing

REMESHED = ("bunny_37k", "armadillo_26k", "fandisk_6k5", "kitten_9k", "elephant_2k8",
            "nefertiti_35k")
QUALITY = ("mean angle", "1st percentile", "mean to input %", "time [s]")


def remeshing_cell(file: str, table: str, key: Key) -> Text:
    return Text("{}, {}, {}, {}", *(Value(file, table, key, column) for column in QUALITY))


remeshing_quality = Table(
    ["model", "`geodesic_delaunay_remeshing()`", "`isotropic_remeshing()`",
     "vorpalite (geogram 1.10)", "ACVD"],
    [[f"{MODELS[name]}, creases of 40 degrees kept" if name == "fandisk_6k5" else MODELS[name],
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

# Base meshes

base_steps = Whole("base", "steps of the paper",
                   {**MODELS, "model": "model (in parentheses: paper)"})
BASE_MODELS = ("bunny_37k", "armadillo_26k", "fandisk_6k5", "knot1_3k", "plane_holes_8k5")
base_meshes = Whole(
    "base", "base meshes", MODELS,
    {"model": "model", "base": "base vertices", "folds H": "inverted before repair",
     "repaired faces": "repaired base faces", "folds": "inverted after repair",
     "round trip": "round trip", "Ec H": "Ec, Heron", "Ea H": "Ea, Heron",
     "Ec M": "Ec, mean values", "Ea M": "Ea, mean values", "base [s]": "base mesh, seconds",
     "map [s]": "parameterization, seconds"},
    BASE_MODELS)
base_semi_regular = Table(
    ["model", "coordinates", "faces", "mean distance", "largest distance",
     "angles from 20 to 120 degrees", "seconds"],
    [[MODELS[name], coordinates,
      *(Value("base", "semi-regular meshes", f"{name} {letter}", column)
        for column in ("faces", "mean distance", "maximum distance", "angles in 20..120",
                       "time [s]"))]
     for name in BASE_MODELS for letter, coordinates in (("H", "Heron"), ("M", "mean value"))], 2)

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

GRADIENTS = {f"Gradient<{method}>": f"`Gradient<{name}>`"
             for method, name in (("Dijkstra", "Dijkstra"), ("Fast_marching", "Fast_marching"),
                                  ("Euclidean_front", ""), ("Exact", "Exact"))}

logmap_lengths = Table(
    ["method", "noise", "distance, %", "gradient, stencil of 1 edge, %", "of 3 edges"],
    [[name, f"{noise} %", *(Value("logmap", "lengths on noisy spheres", (noise, method), column)
                            for column in ("distance", "1 ring", "3 rings"))]
     for method, name in GRADIENTS.items() for noise in ("0", "5")], 2)

logmap_noise = Table(
    ["method", "noise", "plain", "30 smoothing steps", "3 base refinements", "both"],
    [[name, f"{noise} %",
      *(Text("{}, {}", *(Value("logmap", "angles on noisy spheres", (noise, method + option), column,
                               part=1) for column in ("default stencil", "3 rings")))
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
                                                     "time [s]", "iterations", "error")},
                     ("sphere", "kitten_9k", "bunny_37k"))
logmap_cloud_means = Whole("means", "means on clouds", {},
                           {name: MEANS[name] for name in ("cloud", "surfels", "locations",
                                                           "time [s]", "iterations", "error")})

# Decals

decals_placement = Table(
    ["mesh", "vertices", "median of `place()`, ms", "largest, ms", "first image of a placer, ms"],
    [[name, *(Value("decal", "placement", (mesh, ANY, "gradient"), column)
              for column in ("vertices", "placement [ms]", "maximum [ms]", "first placement [ms]"))]
     for mesh, name in {"bunny_37k": "bunny", "icosphere 7": "sphere",
                        "mni152_grey_matter_533k": "grey matter"}.items()])

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

def energy_cell(patch: str, method: str, column: str) -> Union[str, Value]:
    """Returns an empty cell where the method takes too long to be measured."""
    if (patch, method) == ("terrain_st_helens_149k", "CGAL arap"):
        return ""
    return flattening_value(patch, method, column)


flattening_energy = Table(
    ["patch", "`minimize_distortion()`: energy", "inverted faces", "ARAP: energy", "inverted faces"],
    [[name, *(energy_cell(patch, method, column)
              for method in ("injective", "CGAL arap") for column in ("Dirichlet", "flips"))]
     for patch, name in PATCHES.items()])

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
    "flattening", "table II of the paper",
    {"camelhead_11k (10,000)": "camel's head (10,000)",
     "terrain, refined once (700,000)": "Mount St. Helens, refined 1-to-4 (700,000)"},
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
     for name, formula in THEORY.items()], 2)

flattening_metric = Whole(
    "distortion", "metric on the sphere", {},
    {"u": "\\f$ u \\f$", "Gradient": "`Gradient<>`", "Exact": "`Exact`",
     "expansion": "second-order expansion", "sphere": "sphere"})

METRIC_METHODS = {"Gradient": "`Gradient<>`", "Exact": "`Exact`"}

flattening_coefficients = Whole(
    "distortion", "Taylor coefficients of the metric", METRIC_METHODS,
    {"surface": "surface", "method": "method", "vertices": "vertices", "radius": "radius",
     "K/3": "\\f$ K/3 \\f$", "g11 v^2": "\\f$ u_2^2 \\f$ in \\f$ g_{11} \\f$",
     "g12 uv": "\\f$ u_1 u_2 \\f$ in \\f$ g_{12} \\f$",
     "g22 u^2": "\\f$ u_1^2 \\f$ in \\f$ g_{22} \\f$", "other": "others"}, number_of_labels=2)

flattening_optimality = Whole(
    "distortion", "optimality", {},
    {"vertices": "vertices", "edge length": "edge length", "Gradient": "`Gradient<>`",
     "Exact": "`Exact`", "orthogonal projection": "orthogonal projection",
     "LSCM": "least squares conformal map"})

flattening_residuals = Whole(
    "distortion", "deviation of the metric", METRIC_METHODS,
    {"surface": "surface", "method": "method", "vertices": "vertices",
     "0.1": "\\f$ r = 0.1 \\f$", "0.2": "0.2", "0.4": "0.4", "0.6": "0.6"}, number_of_labels=2)
