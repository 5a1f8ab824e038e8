# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Images on surfaces."""

import math

import geodesic_processing as gp
import numpy as np
import pytest
from error_test import check_error

UP = (0, 1, 0)
RED, BLUE = (255, 0, 0, 255), (0, 0, 255, 255)
WHITE = np.full((121, 4), 255, np.uint8)


def image_of(*rows):
    """Returns an image of the colors of its rows, from the highest one."""
    return np.array([[row] * 4 for row in rows], np.uint8)


def test_coordinates_in_plane_are_linear(surface, arrays):
    decal = surface.decal(60, (0.45, 0.25), UP)
    offset = arrays[0][:, :2] - 0.5
    inside = (np.abs(offset) <= [0.225, 0.125]).all(axis=1)
    assert sorted(decal.vertices) == list(np.flatnonzero(inside))
    expected = 0.5 + offset / [0.45, 0.25]
    # The map is exact in the plane up to round-off errors.
    assert np.abs(decal.coordinates - expected[decal.vertices]).max() <= 1e-12
    assert np.abs(decal.frame.v - UP).max() <= 1e-14
    if surface.is_cloud:
        assert decal.faces.shape == (0,) and decal.face_coordinates.shape == (0, 3, 2)
        return
    corners = expected[surface.faces]
    assert np.abs(decal.face_coordinates - corners[decal.faces]).max() <= 1e-12
    # A face is covered if it intersects the image; at least if it has a corner inside.
    assert set(np.flatnonzero(inside[surface.faces].any(axis=1))) <= set(decal.faces)
    box_misses = (corners.max(axis=1) < 0).any(axis=1) | (corners.min(axis=1) > 1).any(axis=1)
    assert not box_misses[decal.faces].any()


def test_exact_map_places_the_same(grid):
    expected, found = (grid.decal(60, (0.45, 0.25), UP, method=m) for m in ("gradient", "exact"))
    assert sorted(found.vertices) == sorted(expected.vertices)
    assert sorted(found.faces) == sorted(expected.faces)


def test_location_is_center(grid):
    base = grid.locate([[0.33, 0.62, 0]])[0]
    assert np.abs(grid.decal(base, (0.2, 0.2)).frame.origin - [0.33, 0.62, 0]).max() <= 1e-14


@pytest.mark.parametrize("channels", [3, 4])
def test_opaque_image_replaces_colors(surface, channels):
    decal = surface.decal(60, (0.45, 0.25), UP)
    colors = WHITE[:, :channels]
    found = surface.composite_decal(decal, image_of(RED)[:, :, :channels], colors)
    expected = colors.copy()
    expected[decal.vertices] = RED[:channels]
    assert np.array_equal(found, expected) and (colors == 255).all()


def test_first_row_is_up(surface, arrays):
    decal = surface.decal(60, (0.45, 0.45), UP)
    found = surface.composite_decal(decal, image_of(RED, RED, BLUE, BLUE), WHITE)
    y = arrays[0][:, 1]
    above, below = (decal.vertices[w[decal.vertices]] for w in (y > 0.65, y < 0.35))
    assert len(above) > 0 and (found[above] == RED).all()
    assert len(below) > 0 and (found[below] == BLUE).all()


def test_image_is_interpolated(grid, arrays):
    # The first column is black and the last one is white.
    row = np.linspace(0, 255, 5).round().astype(np.uint8)
    image = np.repeat(row[None, :, None], 3, axis=2)
    decal = grid.decal(60, (1.25, 1.25), UP)
    assert len(decal.vertices) == 121
    found = grid.composite_decal(decal, image, WHITE)[:, 0]
    position = np.clip(((arrays[0][:, 0] - 0.5) / 1.25 + 0.5) * 5 - 0.5, 0, 4)
    # Coordinates have round-off errors, and the result is rounded.
    assert np.abs(found - np.interp(position, np.arange(5), row)).max() <= 0.5 + 1e-9


def test_opacity_blends(surface):
    decal = surface.decal(60, (0.25, 0.25), UP)
    half = image_of((255, 0, 0, 51))  # a fifth
    found = surface.composite_decal(decal, half, WHITE)
    assert (found[decal.vertices] == (255, 204, 204, 255)).all()
    clear = np.zeros((121, 4), np.uint8)
    found = surface.composite_decal(decal, half, clear)
    assert (found[decal.vertices] == (255, 0, 0, 51)).all()


def test_transparent_pixels_have_no_color(grid):
    decal = grid.decal(60, (1.0, 1.0), UP)
    image = image_of(RED, (0, 255, 0, 0))
    found = grid.composite_decal(decal, image, WHITE)
    # Between the rows, red fades into white; the green of the transparent row is not mixed in.
    assert (found[:, 0] == 255).all() and (found[:, 1] == found[:, 2]).all()


def test_memory_layout_of_image_is_irrelevant(grid):
    image = np.random.default_rng(3).integers(0, 256, (7, 5, 4), np.uint8)
    decal = grid.decal(60, (0.8, 0.8), UP)
    expected = grid.composite_decal(decal, image, WHITE)
    wide = np.zeros((14, 10, 8), np.uint8)[::2, ::-2, ::2]
    wide[...] = image
    for other in (np.asfortranarray(image), wide):
        assert np.array_equal(grid.composite_decal(decal, other, WHITE), expected)


def texel_at(texture, uv):
    height, width = texture.image.shape[:2]
    return texture.image[int((1 - uv[1]) * height), int(uv[0] * width)]


def test_texture_shows_images(grid):
    layers = [
        (grid.decal(60, (0.45, 0.45), UP), image_of(RED)),
        (grid.decal(62, (0.25, 0.25), UP), image_of(BLUE)),
    ]
    texture = grid.bake_decals(layers, 8, background=(10, 20, 30, 255))
    assert texture.corner_uv.shape == (200, 3, 2)
    assert set(texture.faces) == set(layers[0][0].faces) | set(layers[1][0].faces)
    center = grid.points(list(zip(range(200), [(1 / 3, 1 / 3, 1 / 3)] * 200)))
    for face in range(200):
        shown = tuple(texel_at(texture, texture.corner_uv[face].mean(axis=0)))
        from_red = np.abs(center[face] - [0.5, 0.5, 0]).max()
        from_blue = np.abs(center[face] - [0.5, 0.7, 0]).max()
        expected = BLUE if from_blue < 0.125 else RED if from_red < 0.225 else (10, 20, 30, 255)
        # A texel is less than an eighth of the side of a face away from its location.
        if min(abs(from_red - 0.225), abs(from_blue - 0.125)) > 0.1 / 8:
            assert shown == expected


def test_faces_without_decal_show_background(grid):
    texture = grid.bake_decals([(grid.decal(60, (0.1, 0.1)), image_of(RED))], 4)
    others = np.setdiff1d(np.arange(200), texture.faces)
    assert len(others) > 150
    assert (texture.corner_uv[others] == texture.corner_uv[others[0], 0]).all()
    assert tuple(texel_at(texture, texture.corner_uv[others[0], 0])) == (255, 255, 255, 255)


def test_no_layers_are_background(grid):
    texture = grid.bake_decals([], 4, background=(1, 2, 3, 4))
    assert len(texture.faces) == 0 and (texture.image == (1, 2, 3, 4)).all()


@pytest.mark.parametrize(
    "named",
    [
        {"base": 121}, {"base": None}, {"size": (1,)}, {"size": 1.0}, {"size": (0, 1)},
        {"size": (1, -1)}, {"size": (1, math.inf)}, {"size": (math.nan, 1)}, {"up": (0, 0, 1)},
        {"up": (0, 1)}, {"up": (math.nan, 0, 0)}, {"method": "fast"}, {"method": None},
    ],
)
def test_decal_rejects(surface, named):
    check_error(lambda: surface.decal(**{"base": 60, "size": (0.2, 0.2), **named}))


def test_colors_reject(surface):
    decal, image = surface.decal(60, (0.25, 0.25)), image_of(RED)
    for wrong in (None, image.astype(float), image[0], image[:, :, :2], image[:0], [RED], "red"):
        check_error(lambda: surface.composite_decal(decal, wrong, WHITE))
    for wrong in (None, WHITE[:5], WHITE[:, :2], WHITE[0], WHITE.astype(int), "white"):
        check_error(lambda: surface.composite_decal(decal, image, wrong))
    check_error(lambda: surface.composite_decal(tuple(decal), image, WHITE))
    for wrong in (
        decal._replace(vertices=decal.vertices + 115),
        decal._replace(vertices=decal.vertices[:1]),
        decal._replace(coordinates=decal.coordinates[:, :1]),
        decal._replace(vertices=None),
    ):
        check_error(lambda: surface.composite_decal(wrong, image, WHITE))


def test_textures_reject(grid, cloud):
    decal, image = grid.decal(60, (0.25, 0.25)), image_of(RED)
    for layers in (None, 3, [3], [decal], [(decal,)], [(image, decal)], [(decal, image, 1)]):
        check_error(lambda: grid.bake_decals(layers, 4))
    check_error(lambda: grid.bake_decals([(decal, None)], 4))
    for wrong in (
        decal._replace(faces=decal.faces + 190),
        decal._replace(face_coordinates=decal.face_coordinates[:1]),
        decal._replace(face_coordinates=decal.face_coordinates[:, :2]),
        decal._replace(face_coordinates=None),
    ):
        check_error(lambda: grid.bake_decals([(wrong, image)], 4))
    for segments in (0, -1, 1.5, None, 2**30):
        check_error(lambda: grid.bake_decals([(decal, image)], segments))
    check_error(lambda: grid.bake_decals([(decal, image)], 4, background=(1, 2, 3)))
    kind = gp.UnsupportedSurfaceError
    check_error(lambda: cloud.bake_decals([], 4), kind)
    check_error(lambda: cloud.decal(60, (0.2, 0.2), method="exact"), kind)
