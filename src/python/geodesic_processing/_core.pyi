# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension. Its functions check all arguments, which therefore have the type Any."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

_Floats = NDArray[np.float64]
_Integers = NDArray[np.int64]
_Bytes = NDArray[np.uint8]
_Locations = tuple[_Integers, _Floats]
_Frame = tuple[_Floats, _Floats, _Floats]
_Distortion = tuple[float, float, float, float, float, int, int]
_PathArrays = tuple[_Floats, _Integers, _Floats, float, float, float]
_LoopArrays = tuple[_Floats, _Integers, _Floats, float]
_Cost = tuple[float, float, float, float, float, int, float, bool]
_IsolineArrays = tuple[float, bool, _Floats, _Integers, _Floats, float]
_LocationArrays = tuple[_Integers, _Floats]
# n, keep_sharp, curve_spacing, relaxation_steps, first, speed, constrained_edges, edge_spacing,
# seed, callback
_Remeshing = tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]
# points, normals, radii, and the origin and the scale of the frame
_CloudContent = tuple[_Floats, _Floats, _Floats | None, _Floats, float]

class InvalidArgumentError(ValueError): ...
class UnsupportedSurfaceError(ValueError): ...
class FileError(OSError, ValueError): ...
class Cancelled(Exception): ...

# pybind11 creates the classes. They have no constructor: their __init__ raises TypeError.
class _Type(type): ...

class Cancellation(metaclass=_Type):
    def __init__(self) -> None: ...
    def call(self, function: Any, /, *arguments: Any) -> Any: ...
    def cancel(self) -> None: ...

class _Solver(metaclass=_Type):
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    @property
    def number_of_points(self) -> int: ...
    def compute(
        self,
        sources: Any,
        max_distance: Any,
        targets: Any,
        speed: Any,
        face_speed: Any,
        offsets: Any,
        relative_tolerance: Any,
        callback: Any,
        /,
    ) -> None: ...
    def write_distances(self, out: _Floats, /) -> None: ...
    def distances(self, locations: Any, /) -> Any: ...
    def path(self, location: Any, /) -> _PathArrays: ...
    def labels(self) -> _Integers: ...
    def reached(self) -> _Integers: ...

class Mesh_solver(_Solver): ...
class Cloud_solver(_Solver): ...

class _Surface(metaclass=_Type):
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    @property
    def number_of_points(self) -> int: ...
    @property
    def number_of_faces(self) -> int: ...
    def locate(self, points: Any, /) -> tuple[_Integers, _Floats]: ...
    def points(self, locations: Any, /) -> _Floats: ...
    def paths(self, pairs: Any, callback: Any, /) -> list[_PathArrays]: ...
    def vertices(self) -> _Floats: ...
    def distance_matrix(
        self,
        sources: Any,
        targets: Any,
        max_distance: Any,
        regions: Any,
        mean: bool,
        dtype: Any,
        out: Any,
        method: Any,
        threads: Any,
        callback: Any,
        /,
    ) -> NDArray[Any]: ...
    def log_map(
        self,
        base: Any,
        radius: Any,
        up: Any,
        method: Any,
        stencil_length: Any,
        stencil_size: Any,
        number_of_smoothing_steps: Any,
        number_of_base_refinements: Any,
        /,
    ) -> tuple[_Floats, _Frame, _Integers, _Integers, int, int]: ...
    def exp_map(self, base: Any, uv: Any, up: Any, /) -> _Locations: ...
    def trace(
        self, start: Any, vector: Any, length: Any, /
    ) -> tuple[_Floats, _Locations, float, bool]: ...
    def karcher_mean(
        self,
        points: Any,
        weights: Any,
        initial_location: Any,
        tolerance: Any,
        max_iterations: Any,
        threads: Any,
        callback: Any,
        /,
    ) -> tuple[_Locations, _Floats, float, float, bool, int]: ...
    def lle(
        self,
        injective: bool,
        number_of_base_points: Any,
        base_points: Any,
        number_of_neighbors: Any,
        flattening_start: Any,
        number_of_rigid_steps: Any,
        method: Any,
        seed: Any,
        callback: Any,
        /,
    ) -> tuple[_Floats, _Integers]: ...
    def mds(
        self,
        number_of_base_points: Any,
        base_points: Any,
        method: Any,
        seed: Any,
        callback: Any,
        /,
    ) -> tuple[_Floats, _Integers]: ...
    def flattening_distortion(self, uv: Any, /) -> _Distortion: ...
    def atlas(
        self,
        charts: Any,
        texture_size: Any,
        gutter_width: Any,
        method: Any,
        speed: Any,
        face_speed: Any,
        max_iterations: Any,
        seed: Any,
        threads: Any,
        callback: Any,
        /,
    ) -> tuple[_Integers | None, _Floats, _Integers, tuple[int, int, int, float, float]]: ...
    def decal(
        self, base: Any, size: Any, up: Any, method: Any, /
    ) -> tuple[_Frame, _Integers, _Floats, _Integers, _Floats]: ...
    def composite_decal(
        self, vertices: Any, coordinates: Any, image: Any, colors: Any, /
    ) -> _Bytes: ...
    def fuzzy_geodesic(
        self,
        a: Any,
        b: Any,
        width: Any,
        method: Any,
        tolerance: Any,
        number_of_refinements: Any,
        speed: Any,
        callback: Any,
        /,
    ) -> tuple[_Floats, float, float, float, float, int, float, bool]: ...
    def fuzzy_geodesic_by_distances(
        self, a: Any, b: Any, width: Any, method: Any, speed: Any, callback: Any, /
    ) -> _Floats: ...
    def sparse_distance_matrix(
        self, vertices: Any, max_distance: Any, method: Any, threads: Any, callback: Any, /
    ) -> tuple[_Floats, NDArray[np.int32], NDArray[np.int32]]: ...
    def farthest_points(
        self, n: Any, radius: Any, first: Any, method: Any, speed: Any, callback: Any, /
    ) -> tuple[_Integers, _Floats, _Floats, _Integers]: ...
    def polyline(self, points: Any, close: bool, /) -> tuple[_PathArrays, _Integers]: ...
    def shorten_polyline(self, points: Any, /) -> _PathArrays: ...
    def emd(
        self, a: Any, b: Any, setup: Any, query: Any, callback: Any, /
    ) -> tuple[_Cost, _Floats, _Floats]: ...
    def spectral_emd(
        self,
        a: Any,
        b: Any,
        basis: Any,
        transport_flow: Any,
        tolerance: Any,
        max_iterations: Any,
        normalize: bool,
        callback: Any,
        /,
    ) -> tuple[_Cost, _Floats, int]: ...
    def barycenter(
        self,
        masses: list[Any],
        weights: Any,
        setup: Any,
        tolerance: Any,
        max_iterations: Any,
        normalize: bool,
        callback: Any,
        /,
    ) -> tuple[float, float, float, _Floats, int, float, bool, _Floats, _Floats]: ...
    def geodesic_barycenter(
        self,
        locations: Any,
        weights: Any,
        method: Any,
        speed: Any,
        face_speed: Any,
        callback: Any,
        /,
    ) -> tuple[int, float, _Floats]: ...
    def transport_to_region(
        self,
        masses: Any,
        region: Any,
        capacities: Any,
        spreading_weight: Any,
        setup: Any,
        query: Any,
        callback: Any,
        /,
    ) -> tuple[_Cost, _Floats, _Floats, _Floats]: ...
    def streamlines(
        self,
        a: Any,
        b: Any,
        n: Any,
        seeds: Any,
        straighten: bool,
        setup: Any,
        query: Any,
        callback: Any,
        /,
    ) -> list[tuple[_PathArrays, bool]]: ...
    def farthest_vertices(
        self, n: Any, radius: Any, first: Any, method: Any, speed: Any, callback: Any, /
    ) -> tuple[_Integers, _Floats, _Integers]: ...
    def segment(
        self,
        n: Any,
        disks: bool,
        max_iterations: Any,
        seed: Any,
        method: Any,
        speed: Any,
        threads: Any,
        callback: Any,
        /,
    ) -> tuple[_Integers, _Integers, _Floats, _Floats]: ...
    def remesh(
        self,
        arguments: _Remeshing,
        max_deviation: Any,
        fit: bool,
        avoid_self_intersections: bool,
        too_few_samples: Any,
        edge_paths: bool,
        /,
    ) -> tuple[Mesh, _Integers, _Floats, int, int, _Integers, list[_PathArrays]]: ...
    def base_mesh(self, arguments: _Remeshing, /) -> tuple[Mesh, Mesh, _Integers, int]: ...
    def semi_regular(
        self,
        arguments: _Remeshing,
        coordinates: Any,
        levels: Any,
        quads: bool,
        max_deviation: Any,
        /,
    ) -> tuple[Mesh, _Integers, _Integers, int, int, int, float]: ...
    def principal_curvatures(
        self, ball_radius: Any, threads: Any, /
    ) -> tuple[_Floats, _Floats, _Floats, _Floats]: ...
    def curvature_speeds(
        self, kind: Any, strength: Any, ball_radius: Any, threads: Any, /
    ) -> _Floats: ...
    def similar_curvature_speeds(
        self, vertex: Any, strength: Any, ball_radius: Any, threads: Any, /
    ) -> _Floats: ...
    def image_speeds(self, image: Any, strength: Any, /) -> _Floats: ...
    def surface_distortion(
        self, uv: Any, has_corners: bool, measure: Any, /
    ) -> tuple[float, float, float, float, _LocationArrays, int, int]: ...
    def feature_distance(
        self,
        feature: Any,
        fix_masses: bool,
        speed: Any,
        refinements: Any,
        tolerance: Any,
        callback: Any,
        /,
    ) -> tuple[_Floats, float, float, float, float, int, float, bool]: ...

class Mesh(_Surface):
    def solver(self, method: Any, callback: Any, /) -> Mesh_solver: ...
    def border_sources(self) -> list[tuple[_Integers, _Floats]]: ...
    def faces(self) -> _Integers: ...
    def report(self) -> dict[str, int]: ...
    def voronoi(
        self, seeds: Any, method: Any, speed: Any, callback: Any, /
    ) -> tuple[_Integers, _Integers, list[tuple[int, int, _Floats, _Integers, _Floats]]]: ...
    def voronoi_cells(
        self, seeds: Any, max_distance: Any, speed: Any, callback: Any, /
    ) -> tuple[Mesh, _Integers]: ...
    def fill_holes(
        self, max_edges: Any, max_perimeter: Any, method: Any, callback: Any, /
    ) -> tuple[Mesh, _Integers, int, int, int, int]: ...
    def parameterize_over_base(
        self, arguments: _Remeshing, coordinates: Any, /
    ) -> Mesh_base_map: ...
    def wavelet(self, levels: Any, prediction: Any, update: bool, /) -> Wavelet: ...
    def face_distortion(
        self, uv: Any, has_corners: bool, /
    ) -> tuple[_Floats, _Floats, NDArray[np.bool_], _Floats]: ...
    def minimize_distortion(
        self, uv: Any, max_iterations: Any, callback: Any, /
    ) -> tuple[_Floats, int, int, int, float]: ...
    def isolines(
        self, values: Any, levels: Any, fit_circles: bool, callback: Any, /
    ) -> list[_IsolineArrays]: ...
    def corner_distortion(self, corner_uv: Any, /) -> _Distortion: ...
    def mean_value_coordinates(self, points: Any, callback: Any, /) -> _Floats: ...
    def texel_locations(
        self, corner_uv: Any, texture_size: Any, gutter_width: Any, /
    ) -> tuple[_Integers, _Locations]: ...
    def bake_decals(
        self, layers: list[tuple[Any, Any, Any]], segments: Any, background: Any, /
    ) -> tuple[_Bytes, _Floats, _Integers]: ...
    def split_at_isolines(
        self, values: Any, levels: Any, fit_circles: bool, /
    ) -> tuple[Mesh, _Integers, tuple[_Integers, _Floats], _Integers]: ...
    def shorten_loop(self, points: Any, /) -> _LoopArrays: ...
    def loop_basis(self, shorten: bool, /) -> list[_LoopArrays]: ...
    def shortest_noncontractible_loop(self, through: Any, /) -> _LoopArrays: ...
    def bezier_curve(
        self, control_points: Any, number_of_subdivisions: Any, callback: Any, /
    ) -> _PathArrays: ...
    def spline(
        self,
        control_points: Any,
        degree: Any,
        is_closed: bool,
        number_of_subdivisions: Any,
        callback: Any,
        /,
    ) -> _PathArrays: ...
    def ball(
        self, centers: Any, radius: Any, callback: Any, /
    ) -> tuple[_Integers, float, list[_IsolineArrays]]: ...
    def diameter(
        self, relative_tolerance: Any, max_iterations: Any, callback: Any, /
    ) -> tuple[float, float, int, int, bool, int]: ...
    def radius(
        self, relative_tolerance: Any, max_iterations: Any, callback: Any, /
    ) -> tuple[float, float, int, int, bool, int]: ...
    def distance_derivatives(
        self, source: Any, target: Any, vertex_tolerance: Any, second_path_tolerance: Any, /
    ) -> tuple[float, str, _Floats, _Floats, _Integers, _Floats]: ...
    def hodge_decomposition(
        self, field: Any, /
    ) -> tuple[_Floats, _Floats, _Floats, _Floats, _Integers, _Floats, _Floats]: ...
    def volumetric_metric(
        self, number_of_refinements: Any, barycentric_coordinates: Any, /
    ) -> Volumetric_metric: ...

class Cloud(_Surface):
    def content(self) -> _CloudContent: ...
    def solver(self, method: Any, callback: Any, /) -> Cloud_solver: ...
    def voronoi(self, seeds: Any, method: Any, speed: Any, callback: Any, /) -> _Integers: ...
    def hodge_decomposition(self, field: Any, /) -> tuple[_Floats, _Floats, _Floats]: ...
    def parameterize_over_base(
        self, arguments: _Remeshing, coordinates: Any, /
    ) -> Cloud_base_map: ...

class Volumetric_metric(metaclass=_Type):
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    def cost(
        self,
        a: Any,
        b: Any,
        tolerance: Any,
        max_iterations: Any,
        bound_from_above: bool,
        callback: Any,
        /,
    ) -> tuple[_Cost, _Floats, _Floats]: ...
    def costs(
        self, a: Any, points: Any, tolerance: Any, threads: Any, callback: Any, /
    ) -> tuple[_Floats, _Floats, _Floats, _Integers, NDArray[np.bool_]]: ...
    def path(self, a: Any, b: Any, max_iterations: Any, /) -> tuple[_Floats, bool]: ...

class _Base_map(metaclass=_Type):
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    def base(self) -> Mesh: ...
    def base_vertices(self) -> _LocationArrays: ...
    def vertex_locations(self) -> _LocationArrays: ...
    def number_of_flips(self) -> int: ...
    def number_of_repaired_faces(self) -> int: ...
    def map(self, locations: Any, /) -> _LocationArrays: ...
    def inverse(self, locations: Any, /) -> _LocationArrays: ...
    def points(self, locations: Any, /) -> _Floats: ...

class Mesh_base_map(_Base_map): ...
class Cloud_base_map(_Base_map): ...

class Wavelet(metaclass=_Type):
    def __init__(self, *args: Any, **kwargs: Any) -> None: ...
    def number_of_levels(self) -> int: ...
    def numbers_of_vertices(self) -> _Integers: ...
    def order(self) -> _Integers: ...
    def parents(self) -> _Integers: ...
    def triangles(self, level: Any, /) -> _Integers: ...
    def analyze(self, values: Any, frames: bool, /) -> _Floats: ...
    def synthesize(self, details: Any, frames: bool, /) -> _Floats: ...
    def keep_largest(self, details: Any, frames: bool, n: Any, /) -> _Floats: ...
    def encode(self, details: Any, frames: bool, bit_planes: Any, max_bytes: Any, /) -> bytes: ...

def make_mesh(
    V: Any,
    F: Any,
    offsets: Any,
    merge_tolerance: Any,
    remove_degenerate_faces: bool,
    callback: Any,
    /,
) -> Mesh: ...
def make_cloud(P: Any, normals: Any, radii: Any, callback: Any, /) -> Cloud: ...
def cloud_of_content(
    points: Any, normals: Any, radii: Any, origin: Any, scale: Any, /
) -> Cloud: ...
def decode_wavelets(stream: Any, max_vertices: Any, /) -> tuple[Mesh, int, int, bool, bool]: ...
def read(path: str, /) -> Mesh | Cloud: ...
def output(out: Any, size: int, /) -> _Floats: ...
