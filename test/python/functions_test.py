# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists every public function of the C++ library with its name in Python."""

import re
from pathlib import Path

import geodesic_processing as gp

ROOT = Path(__file__).parents[2]

IN_PYTHON = {
    "bake_atlas": "Surface.bake_atlas",
    "bake_decals": "Surface.bake_decals",
    "border_sources": "Surface.border_sources",
    "composite_decal": "Surface.composite_decal",
    "curvature_speeds": "Surface.curvature_speeds",
    "decode_wavelets": "decode_wavelets",
    "earth_movers_distance": "Surface.emd",
    "estimate_surfels": "Surface",
    "exponential_map": "Surface.exp_map",
    "face_distortion": "Surface.face_distortion",
    "farthest_point_sampling": "Surface.farthest_points",
    "farthest_vertex_sampling": "Surface.farthest_vertices",
    "feature_distance": "Surface.feature_distance",
    "fill_holes": "Surface.fill_holes",
    "flattening_distortion": "Surface.flattening_distortion",
    "fuzzy_geodesic": "Surface.fuzzy_geodesic",
    "fuzzy_geodesic_by_distances": "Surface.fuzzy_geodesic_by_distances",
    "geodesic_ball": "Surface.ball",
    "geodesic_barycenter": "Surface.geodesic_barycenter",
    "geodesic_base_mesh": "Surface.base_mesh",
    "geodesic_bezier_curve": "Surface.bezier_curve",
    "geodesic_centroidal_tessellation": "Surface.segment",
    "geodesic_delaunay_remeshing": "Surface.remesh",
    "geodesic_diameter": "Surface.diameter",
    "geodesic_distance_derivatives": "Surface.distance_derivatives",
    "geodesic_distance_matrix": "Surface.distance_matrix",
    "geodesic_distances": "Surface.distance",
    "geodesic_eccentricity": "Surface.eccentricity",
    "geodesic_lle": "Surface.lle",
    "geodesic_mds": "Surface.mds",
    "geodesic_path": "Solver.path",
    "geodesic_polyline": "Surface.polyline",
    "geodesic_radius": "Surface.radius",
    "geodesic_spline": "Surface.spline",
    "geodesic_voronoi_cells": "Surface.voronoi_cells",
    "geodesic_voronoi_diagram": "Surface.voronoi",
    "hodge_decomposition": "Surface.hodge_decomposition",
    "image_speeds": "Surface.image_speeds",
    "isolines": "Surface.isolines",
    "karcher_mean": "Surface.karcher_mean",
    "locate_on_surface": "Surface.locate",
    "logarithmic_map": "Surface.log_map",
    "loop_basis": "Surface.loop_basis",
    "make_domain": "Surface",
    "mass_density": "mass_density",
    "mean_value_coordinates": "Surface.mean_value_coordinates",
    "minimize_distortion": "Surface.minimize_distortion",
    "parameterize_over_base": "Surface.parameterize_over_base",
    "principal_curvatures": "Surface.principal_curvatures",
    "semi_regular_remeshing": "Surface.semi_regular",
    "shorten_loop": "Surface.shorten_loop",
    "shorten_polyline": "Surface.shorten_polyline",
    "shortest_noncontractible_loop": "Surface.shortest_noncontractible_loop",
    "similar_curvature_speeds": "Surface.similar_curvature_speeds",
    "sparse_geodesic_distance_matrix": "Surface.sparse_distance_matrix",
    "split_at_isolines": "Surface.split_at_isolines",
    "straightest_geodesic": "Surface.trace",
    "surface_distortion": "Surface.surface_distortion",
    "surfel_geodesic_path": "Surface.path",
    "surfel_geodesic_paths": "Surface.paths",
    "texture_atlas": "Surface.atlas",
    "transport_barycenter": "Surface.barycenter",
    "transport_streamlines": "Surface.streamlines",
    "transport_to_region": "Surface.transport_to_region",
    "volumetric_distance": "Surface.volumetric_distance",
    "write_geodesic_distance_matrix": "Surface.distance_matrix",
}

WITHOUT_PYTHON = {
    "merge_distance_matrices": "Parts of a matrix are rows of one numpy.memmap.",
}


def public_functions():
    """Returns the names of the documented functions in the public headers."""
    names = set()
    for header in (ROOT / "include/CGAL/Geodesic_processing").glob("*.h"):
        # A documented declaration: the comment, the template parameters, and the signature.
        for comment in re.finditer(r"^/// \\ingroup \w+\n(?:///.*\n)*", header.read_text(), re.M):
            declaration = comment.string[comment.end() :].split("\n\n")[0]
            declaration = re.split(r"[{;]", declaration)[0]
            if re.match(r"(class|struct|enum|using|inline)\b", declaration):
                continue
            depth = 0
            text = ""
            for letter in declaration:  # without template parameters
                depth += {"<": 1, ">": -1}.get(letter, 0)
                text += letter if depth == 0 else ""
            text = re.sub(r"^template>\s*|^template >\s*", "", text)
            if re.match(r"(class|struct|enum|using|inline)\b", text):
                continue
            if name := re.search(r"\b(?!decltype)([a-z]\w*)\(", text):
                names.add(name[1])
    return names


def test_every_function_is_listed():
    found = public_functions()
    assert len(found) > 60
    assert not IN_PYTHON.keys() & WITHOUT_PYTHON.keys()
    assert found == IN_PYTHON.keys() | WITHOUT_PYTHON.keys()


def test_listed_names_exist():
    for name in IN_PYTHON.values():
        value = gp
        for part in name.split("."):
            value = getattr(value, part)
        assert value.__doc__


def test_every_public_name_is_documented():
    for name in gp.__all__:
        value = getattr(gp, name)
        if isinstance(value, type) and issubclass(value, Exception):
            continue
        assert value.__doc__
        if isinstance(value, type):
            for member, function in vars(value).items():
                if not member.startswith("_") and callable(function):
                    assert function.__doc__, f"{name}.{member}"


def test_versions_are_equal():
    in_cmake = re.search(r"project\(\w+ VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    in_python = re.search(r'^version = "(.*)"', (ROOT / "pyproject.toml").read_text(), re.M)
    assert in_cmake[1] == in_python[1]
