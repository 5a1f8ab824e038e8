# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Declares names that several chapters use."""

from typing import Dict, List, Sequence, Union

from markdown import Cell, Key

# The models of the data folder, as the manual names them.
MODELS = {
    "armadillo_26k": "armadillo", "bunny_37k": "bunny", "bunny_zipper_36k": "bunny (zipper)",
    "camel_10k": "camel", "cow_2k9": "cow", "eight_5k": "double torus", "elephant_2k8": "elephant",
    "fandisk_16k": "fandisk", "fandisk_6k5": "fandisk",
    "fsaverage5_inflated_left_10k": "brain, inflated", "human_man_7k": "man",
    "human_woman_7k": "woman", "kitten_9k": "kitten", "knot1_3k": "knot", "man_17k": "man",
    "mech_holes_shark_5k": "mechanical part with holes", "mni152_grey_matter_533k": "grey matter",
    "nefertiti_35k": "Nefertiti", "pinion_650": "pinion", "plane_holes_8k5": "plane with holes",
    "rotor_2k4": "rotor",
    "triceratops_2k8": "triceratops", "turbine_9k": "part of a turbine",
    "turbine": "part of a turbine", "icosphere 5": "sphere",
}
METHODS = {name: f"`{name}`" for name in ("Dijkstra", "Fast_marching", "Euclidean_front", "Exact",
                                          "Heat")}


def models(*names: str) -> Dict[Key, Union[str, Sequence[str]]]:
    return {name: MODELS[name] for name in names}


def methods(*names: str) -> Dict[Key, Union[str, Sequence[str]]]:
    return {name: METHODS[name] for name in names}


def row(*cells: Cell) -> List[Cell]:
    return list(cells)
