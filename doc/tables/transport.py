# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares the tables of transport and volumes."""

from typing import Dict, Sequence

from markdown import Whole
from meshes import PATCHES
from names import MODELS

# Transport

SURFACES = {**MODELS, **PATCHES, "boot_20k": "boot", "dino_4k": "dinosaur", "pig_468": "pig",
            "retinal_3k6": "protein"}

transport_accuracy = Whole(
    "transport_bounds", "bounds on models", MODELS,
    {"model": "model", "vertices": "vertices",
     "value below exact % (mean / max)": "`value` below, %, mean / maximum",
     "upper_continuous excess %": "`upper_continuous` above, %, mean / maximum"},
    ("fandisk_6k5", "kitten_9k", "camel_10k", "nefertiti_35k", "bunny_37k"))
transport_cloud_accuracy = Whole(
    "transport_bounds", "bounds on surfels", {},
    {"5,000 surfels of a sphere": "5,000 surfels of a sphere", "noise %": "noise, %",
     "pairs": "pairs",
     "value error % (mean / max)": "error of `value`, %, mean / maximum",
     "estimate error %": "error of `estimate`, %, mean / maximum"})
transport_disks = Whole(
    "transport_claims", "disks", MODELS,
    {"model": "model", "radius / distance": "radius",
     "error / (radius + gap), mean / max": "difference, mean / maximum"}, number_of_labels=2)
BASIS_SIZES = (0, 10, 20, 50, 100, 200, 300, 400)
transport_basis_sizes = Whole(
    "transport_claims", "basis sizes", MODELS,
    {"distance of two densities": "surface", "family": "family", "all flows": "all flows",
     **{f"k = {k}": f"`k` = {k}" for k in BASIS_SIZES}}, number_of_labels=2)
transport_excess = Whole(
    "transport_claims", "monotonicity",
    SURFACES,
    {"monotonicity in k": "surface", "family": "family", "vertices": "vertices",
     "harmonic fields": "harmonic fields", "pairs": "pairs", "increases": "increases",
     "from k = 0": "increases from `k` = 0", "above exact %: k = 0": "excess for `k` = 0, %",
     "k = 10": "`k` = 10", "k = 30": "`k` = 30", "k = 100": "`k` = 100"}, number_of_labels=2)
transport_pairs = Whole(
    "transport_family", "all pairs", SURFACES,
    {"all pairs, k = 0": "mesh", "vertices": "vertices", "samples": "samples",
     **{f"{family}: {part} [s]": f"{family} flow: {text}, seconds"
        for family in ("gradient", "balanced")
        for part, text in (("set-up", "precomputation"), ("query", "all pairs"))}})
transport_one_to_all = Whole(
    "transport_family", "one to all", MODELS,
    {"one to all": "mesh", "vertices": "vertices", "family": "family", "k": "`k`",
     "set-up [s]": "set-up, seconds", "query [s]": "query, seconds", "mean error %": "mean error, %",
     "above geodesic %": "above geodesic, %"})
PAPER_METHODS = {"exact (marching)": "geodesic", "heat": "heat", "biharmonic": "biharmonic",
                 "k = 0": "`k` = 0"}
transport_paper_1 = Whole(
    "transport_times", "table 1 of the paper", SURFACES,
    {"one to all: seconds (paper)": "model", "vertices": "vertices",
     "model of the paper": "model of the paper", **PAPER_METHODS, "all flows": "all flows"})
transport_paper_basis = Whole(
    "transport_times", "k = 100", SURFACES,
    {"k = 100, seconds": "model", "vertices": "vertices", "paper": "paper",
     **{f"{family} flow: {column}": f"{family} family: {column}"
        for family in ("paper's", "default")
        for column in ("clusters", "error %", "minimized")}})
transport_paper_2 = Whole(
    "transport_times", "table 2 of the paper", SURFACES,
    {"all pairs: seconds (paper)": "model", "vertices": "vertices", "paper": "model of the paper",
     "samples": "samples", **PAPER_METHODS})
FAMILIES = {"exact": "geodesic", "heat": "`Heat`", "biharmonic": "biharmonic", "k = 0": "`k` = 0",
            **{f"k = {k}{family}": f"`k` = {k}{family or ', default'}" for k in (5, 10, 100)
               for family in (", paper", "")}, "complete": "all flows"}
transport_triangles = Whole(
    "transport_claims", "triangle inequality",
    {**SURFACES, **FAMILIES, "heat 1 h2": "`Heat`, time step \\f$ h^2 \\f$",
     **{f"heat {k} h2": f"`Heat`, time step \\f$ {k} h^2 \\f$" for k in (10, 100)}},
    {"1,000 triples": "distance", "model": "model", "violations": "violations",
     "certified violations": "proven violations", "maximum violation %": "largest violation, %",
     "maximum asymmetry %": "largest asymmetry, %"}, number_of_labels=2)


def families(label: str, heading: str, names: Sequence[str]) -> Dict[str, str]:
    return {label: heading, **{name: FAMILIES[name] for name in names}}


CHANGES = {**{f"noise of {size} edges": f"noise of {size} edge lengths" for size in (0.1, 0.3)},
           "bent": "one end rotated by 40 degrees", "refined once": "refined 1-to-4",
           "remeshed": "remeshed"}
transport_stability = Whole(
    "transport_claims", "stability",
    {f"{model}, {change}": f"{MODELS[model]}, {name}" for model in ("elephant_2k8", "cow_2k9")
     for change, name in CHANGES.items()},
    {"change %, mean / max": "change", "vertices": "vertices",
     **families("exact", "geodesic",
                ("heat", "biharmonic", "k = 0", "k = 100, paper", "k = 100", "complete"))})
transport_isotropy = Whole(
    "transport_claims", "anisotropy", {},
    families("anisotropy %", "surface",
             ("biharmonic", "k = 0", "k = 5, paper", "k = 5", "k = 10, paper", "k = 10",
              "k = 100, paper", "k = 100")))
transport_unevenness = Whole(
    "transport_claims", "unevenness",
    SURFACES,
    families("unevenness", "surface",
             ("exact", "heat", "biharmonic", "k = 0", "k = 10, paper", "k = 10", "k = 100, paper",
              "k = 100")))

# Flows

flows_barycenters = Whole(
    "barycenters", "points on meshes", MODELS,
    {"mesh": "points on", "vertices": "vertices", "points": "points",
     "250 steps [s]": "250 steps, seconds", "cost excess %": "above the optimum, %", "gap %": "gap, %",
     "steps to gap of 1 %": "steps to a gap of 1 %", "time [s]": "seconds"})
flows_regions = Whole(
    "regions", "exits with capacities", {},
    {name: name for name in ("maze", "vertices", "exits", "tolerance", "maximum iterations",
                             "maximum gap")} | {"mean time [s]": "mean time, seconds"})
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
