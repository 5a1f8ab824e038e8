# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of the performance page."""

from typing import Sequence

from clouds import SPHERE_CLOUDS, cloud_cells
from distances import FEATURE_MODELS, MEASURED_MESHES
from markdown import Range, Table, Text, Value, grid
from meshes import REMESHED
from names import METHODS, row
from programs import command_cell
from results import ANY

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
       for method in ("Dijkstra", "Fast_marching", "Euclidean_front"))], 3)


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
               size: Text("{} s", cloud_cells(size)["domain: seconds"])
               for size in ("1000000", "10000000")}),
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
      Text("{} ms", Value("isolines", "milliseconds", "square 1000", "split, mesh")),
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
SAMPLED = (("1,000", "grey matter", "533,000",
            ("mni152_grey_matter_533k", ANY, "Euclidean_front", "1000")),
           ("5,000", "bunny, refined once", "150,000",
            ("bunny_37k, refined once", ANY, "Euclidean_front", "5000")))

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
           TIMES_SECTION) for family, k in (("balanced", "0"), ("default", "102"))),
     ["barycenter of three points, 250 steps", "about 2,500 vertices",
      Text("{} s", Range([Value("barycenters", "points on meshes", (name, ANY, "3"),
                                "250 steps [s]")
                          for name in ("rotor_2k4", "cow_2k9", "elephant_2k8",
                                       "triceratops_2k8")])), "\\ref GP_Flows_barycenters"],
     ["streamlines: tracer with 200 lines", "37,706 vertices",
      Text("{} s", Range([Value("flows", "streamlines", ("bunny_37k", ANY, masses), "tracing [s]")
                          for masses in ("points", "Gaussians")])), "\\ref GP_Flows_streamlines"],
     ["mean value coordinates of a point", "10,242 vertices",
      Text("{} ms", Value("volumes", "coordinates", "icosphere 5", "time per point [ms]")),
      "\\ref GP_Volume_implementation \"Volumes\""],
     ["`costs()` to a grid of 100 by 100 points, processor time", "10,242 vertices",
      Text("{} s", Value("volumes", "slices", "icosphere 5", "processor [s]")),
      "\\ref GP_Volume_implementation \"Volumes\""]], 4)
