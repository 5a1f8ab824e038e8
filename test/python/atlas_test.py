# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texture atlases."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import sphere_arrays
from error_test import check_error


@pytest.fixture(scope="module")
def sphere():
    return gp.Surface(*sphere_arrays(3))


def signed_areas(triangles):
    a, b = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    return (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) / 2


def check_atlas(atlas):
    """Checks that the arrays of an atlas agree with each other."""
    assert np.array_equal(atlas.vertices[atlas.faces], atlas.surface.faces)
    assert np.array_equal(atlas.points, atlas.surface.points(atlas.vertices))
    assert atlas.uv.min() >= 0 and atlas.uv.max() <= 1
    assert set(atlas.charts) == set(range(atlas.number_of_charts))
    assert np.array_equal(atlas.corner_uv, atlas.uv[atlas.faces])
    # The certificate agrees with the signs of the areas, which are far from round-off errors.
    assert atlas.is_injective and signed_areas(atlas.corner_uv).min() > 0
    # No vertex is in two charts, so faces of different charts have no vertex in common.
    chart_of_vertex = np.full(len(atlas.points), -1)
    for face, chart in zip(atlas.faces, atlas.charts):
        assert set(chart_of_vertex[face]) <= {-1, chart}
        chart_of_vertex[face] = chart


@pytest.mark.parametrize("charts", [None, 6])
def test_atlas_of_closed_mesh(sphere, charts):
    atlas = sphere.atlas(charts, texture_size=256)
    check_atlas(atlas)
    assert atlas.surface is sphere
    assert atlas.number_of_charts >= (charts or 2)  # a sphere is not a disk
    assert len(atlas.points) > sphere.number_of_points
    # All charts have the same scale: their area is that of the surface, up to the distortion.
    area = signed_areas(atlas.corner_uv).sum()
    scale = atlas.texels_per_length / 256
    assert area / scale**2 == pytest.approx(4 * math.pi, rel=0.1)
    assert sphere.flattening_distortion(atlas.corner_uv).number_of_flips == 0


def test_planar_mesh_is_one_chart(grid):
    atlas = grid.atlas()
    check_atlas(atlas)
    assert atlas.number_of_charts == 1 and len(atlas.points) == 121
    assert np.array_equal(atlas.vertices, np.arange(121))
    # The map is isometric up to the tolerance of Newton's method, 1e-6 of the energy.
    assert grid.flattening_distortion(atlas.corner_uv).symmetric_dirichlet <= 4 + 1e-5
    # A square fills at least half of its bounding box at any angle. The gutter takes less than 2 %.
    assert 0.49 <= atlas.coverage <= 1


def test_low_speed_makes_small_charts(sphere):
    top = sphere_arrays(3)[0][:, 2] > 0
    even = sphere.atlas(12, texture_size=256)
    uneven = sphere.atlas(12, texture_size=256, speed=np.where(top, 0.2, 1.0))
    in_top = top[sphere.faces].all(axis=1)

    def charts_in_top(atlas):
        return len(set(atlas.charts[in_top]))

    assert charts_in_top(uneven) > charts_in_top(even)


def test_result_does_not_depend_on_threads(sphere):
    one, three = (sphere.atlas(6, texture_size=256, threads=t) for t in (1, 3))
    assert np.array_equal(one.uv, three.uv) and np.array_equal(one.charts, three.charts)


def test_atlas_of_cloud():
    V = sphere_arrays(3)[0]
    cloud = gp.Surface(V, normals=V)
    atlas = cloud.atlas(6, texture_size=256)
    check_atlas(atlas)
    assert not atlas.surface.is_cloud and atlas.surface.number_of_points == len(V)
    # The vertices of the mesh are surfels, whose points are stored relative to a frame.
    assert np.abs(atlas.points - V[atlas.vertices]).max() <= 1e-14
    report = atlas.surface.report
    assert report.number_of_reversed_triangles == report.number_of_duplicate_triangles == 0


def test_texels_show_their_locations(sphere):
    atlas = sphere.atlas(6, texture_size=128)
    shown = []

    def colors(locations):
        shown.append(locations)
        number = np.arange(len(locations))
        return np.stack([number % 256, number // 256, 0 * number], axis=1).astype(np.uint8)

    image = sphere.bake_atlas(atlas.corner_uv, colors, 128, background=(9, 8, 7, 0))
    (locations,) = shown
    assert image.shape == (128, 128, 4) and image.dtype == np.uint8
    row, column = np.nonzero(image[:, :, 3])
    number = image[row, column, 0] + 256 * image[row, column, 1].astype(int)
    assert len(number) == len(locations)
    uv = np.einsum(
        "ik,ikc->ic", locations.coordinates, atlas.corner_uv[locations.indices]
    )[number]
    # The first row is the highest one.
    center = np.stack([column + 0.5, 127.5 - row], axis=1) / 128
    texels = np.linalg.norm(uv - center, axis=1) * 128
    inside = locations.coordinates.min(axis=1)[number] > 0
    assert texels[inside].max() <= 1e-9
    # Others show the closest location, at most half of the gutter away along both axes.
    assert texels.max() <= 2 * math.sqrt(2)
    assert inside.sum() / 128**2 == pytest.approx(atlas.coverage, abs=0.05)
    assert (image[image[:, :, 3] == 0] == (9, 8, 7, 0)).all()


def test_colors_of_vertices_are_interpolated(grid, arrays):
    corner_uv = arrays[0][:, :2][grid.faces]  # the texture is the square itself
    gray = np.rint(arrays[0][:, 0] * 200).astype(np.uint8)
    colors = np.stack([gray, 0 * gray, 0 * gray + 7], axis=1)
    image = grid.bake_atlas(corner_uv, colors, 50)
    expected = (np.arange(50) + 0.5) / 50 * 200
    # Both the colors and the result are rounded.
    assert np.abs(image[:, :, 0] - expected).max() <= 1
    assert (image[:, :, 1:] == (0, 7, 255)).all()
    transparent = np.column_stack([colors, np.full(121, 80, np.uint8)])
    assert (grid.bake_atlas(corner_uv, transparent, 50)[:, :, 3] == 80).all()


def test_atlas_is_canceled(sphere):
    with pytest.raises(gp.Cancelled):
        sphere.atlas(callback=lambda fraction: False)


@pytest.mark.parametrize(
    "named",
    [
        {"charts": 0}, {"charts": -1}, {"charts": 1.5}, {"texture_size": 15},
        {"texture_size": 16385}, {"texture_size": None}, {"gutter_width": -1}, {"speed": [1, 2]},
        {"max_iterations": -1}, {"seed": "one"}, {"threads": 0}, {"callback": 3},
        {"charts": 60, "texture_size": 16, "gutter_width": 4},
    ],
)
def test_atlas_rejects(surface, named):
    check_error(lambda: surface.atlas(**named))


def test_bake_atlas_rejects(grid, cloud, arrays):
    uv = arrays[0][:, :2][grid.faces]
    colors = np.zeros((121, 3), np.uint8)
    for corner_uv in (None, uv[:5], uv[:, :2], uv.reshape(-1, 2), np.nan * uv, "uv", []):
        check_error(lambda: grid.bake_atlas(corner_uv, colors))
    for wrong in (colors[:5], colors[:, :2], colors.astype(float), colors.tolist(), None, "red"):
        check_error(lambda: grid.bake_atlas(uv, wrong, 16))
        check_error(lambda: grid.bake_atlas(uv, lambda locations: wrong, 16))
    for size in (0, 16385, -1, 1.5, None):
        check_error(lambda: grid.bake_atlas(uv, colors, size))
    for background in ((1, 2, 3), (1, 2, 3, 256), (0.5, 0, 0, 0), "red", None, [[1], 2]):
        check_error(lambda: grid.bake_atlas(uv, colors, 16, background=background))
    check_error(lambda: grid.bake_atlas(uv, colors, 16, gutter_width=-1))
    check_error(lambda: cloud.bake_atlas(uv, colors), gp.UnsupportedSurfaceError)
    with pytest.raises(ZeroDivisionError):
        grid.bake_atlas(uv, lambda locations: 1 / 0, 16)


def upper_faces(surface):
    return surface.vertices[surface.faces].mean(axis=1)[:, 2] > 0


def test_charts_are_smaller_in_slow_faces(sphere):
    upper = upper_faces(sphere)
    atlas = sphere.atlas(12, face_speed=np.where(upper, 0.25, 1.0))
    check_atlas(atlas)
    assert len(set(atlas.charts[upper])) > 2 * len(set(atlas.charts[~upper]))


def test_constant_speeds_of_faces_and_vertices_are_equal(sphere):
    of_faces = sphere.atlas(6, face_speed=np.full(sphere.number_of_faces, 0.5))
    of_vertices = sphere.atlas(6, speed=np.full(sphere.number_of_points, 0.5))
    assert np.array_equal(of_faces.uv, of_vertices.uv)


def test_method_of_atlas_is_used(sphere):
    atlas = sphere.atlas(6, method="dijkstra")
    check_atlas(atlas)
    assert not np.array_equal(atlas.charts, sphere.atlas(6, method="euclidean").charts)
    # The tessellation needs a front.
    check_error(lambda: sphere.atlas(6, method="exact"))


def test_speeds_of_atlas_are_checked(sphere, cloud):
    m = sphere.number_of_faces
    for named in (
        {"face_speed": np.ones(m + 1)}, {"face_speed": -np.ones(m)}, {"face_speed": "slow"},
        {"face_speed": np.ones(m), "speed": np.ones(sphere.number_of_points)},
    ):
        check_error(lambda: sphere.atlas(**named))
    check_error(lambda: cloud.atlas(face_speed=np.ones(121)))
