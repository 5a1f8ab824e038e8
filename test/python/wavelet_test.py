# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wavelets on semi-regular meshes."""

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, refined_arrays, sphere_arrays

# A value is computed by a few additions on each of three levels.
ROUND_OFF = 1e-14


@pytest.fixture(scope="module")
def plane():
    """A square that is refined twice."""
    return gp.Surface(*refined_arrays(*refined_arrays(*grid_arrays(4))))


@pytest.fixture(scope="module")
def sphere():
    return gp.Surface(*sphere_arrays(3))


def test_levels_of_refined_mesh(plane):
    wavelet = gp.SubdivisionWavelet(plane, 2)
    assert wavelet.number_of_levels == 2
    numbers = wavelet.numbers_of_vertices
    assert np.array_equal(numbers, [16, 49, 169])  # 4^2, 7^2 and 13^2
    assert np.array_equal(np.sort(wavelet.vertices), np.arange(169))
    parents = wavelet.parents
    assert np.array_equal(parents[:16], np.repeat(np.arange(16), 2).reshape(16, 2))
    V = plane.vertices[wavelet.vertices]
    assert np.abs(V[parents].mean(axis=1) - V).max() <= ROUND_OFF
    for level, number in enumerate([18, 72, 288]):
        triangles = wavelet.triangles(level)
        assert triangles.shape == (number, 3) and triangles.max() == numbers[level] - 1
    found = {frozenset(t) for t in wavelet.vertices[wavelet.triangles(2)].tolist()}
    assert found == {frozenset(t) for t in plane.faces.tolist()}


@pytest.mark.parametrize("update", [False, True])
def test_linear_functions_have_no_details(plane, update):
    wavelet = gp.SubdivisionWavelet(plane, 2, prediction="linear", update=update)
    V = plane.vertices
    details = wavelet.analyze(V)
    assert details.values.shape == V.shape and not details.is_in_frames
    assert np.abs(details.values[16:]).max() <= ROUND_OFF
    assert np.abs(details.values[:16] - V[wavelet.vertices[:16]]).max() <= ROUND_OFF


@pytest.mark.parametrize("prediction", ["linear", "butterfly"])
@pytest.mark.parametrize("channels", [None, 1, 2, 3, 5])
def test_synthesis_inverts_analysis(sphere, prediction, channels):
    wavelet = gp.SubdivisionWavelet(sphere, prediction=prediction)
    size = sphere.number_of_points
    values = np.random.default_rng(3).normal(size=size if channels is None else (size, channels))
    details = wavelet.analyze(values)
    assert details.values.shape == values.shape
    assert np.abs(wavelet.synthesize(details) - values).max() <= 10 * ROUND_OFF


def test_details_in_frames_do_not_depend_on_rotation(sphere):
    wavelet = gp.SubdivisionWavelet(sphere)
    details = wavelet.analyze(sphere.vertices, frames=True)
    assert details.is_in_frames
    lengths = np.linalg.norm(wavelet.analyze(sphere.vertices).values, axis=1)
    assert np.abs(np.linalg.norm(details.values, axis=1) - lengths).max() <= ROUND_OFF
    rotation = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]
    rotation *= np.linalg.det(rotation)  # otherwise it can be a reflection
    rotated = wavelet.analyze(sphere.vertices @ rotation.T, frames=True)
    begin = wavelet.numbers_of_vertices[0]  # the coarsest values are positions
    assert np.abs(rotated.values - details.values)[begin:].max() <= 10 * ROUND_OFF
    assert np.abs(wavelet.synthesize(details) - sphere.vertices).max() <= 10 * ROUND_OFF


def test_channels_are_independent(sphere):
    wavelet = gp.SubdivisionWavelet(sphere)
    V = sphere.vertices
    together = wavelet.analyze(V).values
    for k in range(3):
        assert np.array_equal(wavelet.analyze(V[:, k]).values, together[:, k])


def test_largest_details_are_kept(sphere):
    wavelet = gp.SubdivisionWavelet(sphere)
    coarse = wavelet.numbers_of_vertices[0]
    details = wavelet.analyze(sphere.vertices)
    before = details.values.copy()
    errors = []
    for kept in (0, 20, 60, sphere.number_of_points):
        result = wavelet.keep_largest(details, kept)
        is_kept = (result.values != 0).any(axis=1)
        assert is_kept[coarse:].sum() <= kept
        assert np.array_equal(result.values[is_kept], before[is_kept])
        errors.append(np.linalg.norm(wavelet.synthesize(result) - sphere.vertices))
    assert np.array_equal(details.values, before)  # not modified
    assert errors == sorted(errors, reverse=True) and errors[-1] <= 1e-12 < errors[0]


def test_stream_is_decoded(sphere):
    wavelet = gp.SubdivisionWavelet(sphere)
    details = wavelet.analyze(sphere.vertices, frames=True)
    stream = wavelet.encode(details, bit_planes=40)
    assert isinstance(stream, bytes)
    decoded = gp.decode_wavelets(stream)
    assert decoded.is_complete and not decoded.is_damaged
    assert decoded.number_of_levels == wavelet.number_of_levels
    assert decoded.number_of_bit_planes == 40
    # The documented error of `encode()`: 11 times 2^(L - p), for half of the range 1.
    bound = 11 * 2.0 ** (wavelet.number_of_levels - 40)
    assert np.abs(decoded.surface.vertices - sphere.vertices[wavelet.vertices]).max() <= bound
    assert np.array_equal(
        decoded.surface.faces, wavelet.triangles(wavelet.number_of_levels)
    )
    same = gp.decode_wavelets(memoryview(bytearray(stream)))
    assert np.array_equal(same.surface.vertices, decoded.surface.vertices)


def test_prefix_decodes_to_approximation(sphere):
    wavelet = gp.SubdivisionWavelet(sphere)
    details = wavelet.analyze(sphere.vertices, frames=True)
    stream = wavelet.encode(details)
    errors = []
    for size in (len(stream) // 4, len(stream) // 2, len(stream)):
        prefix = wavelet.encode(details, max_bytes=size)
        assert prefix == stream[:size]
        decoded = gp.decode_wavelets(prefix)
        assert decoded.is_complete == (size == len(stream))
        difference = decoded.surface.vertices - sphere.vertices[wavelet.vertices]
        errors.append(np.linalg.norm(difference))
    assert errors[0] > errors[1] > errors[2]


def test_damage_is_detected(sphere):
    wavelet = gp.SubdivisionWavelet(sphere)
    stream = bytearray(wavelet.encode(wavelet.analyze(sphere.vertices)))
    stream[len(stream) // 2] ^= 1
    decoded = gp.decode_wavelets(stream)
    assert decoded.is_damaged and not decoded.is_complete
    assert np.isfinite(decoded.surface.vertices).all()


def test_semi_regular_mesh_has_its_levels(sphere):
    mesh = sphere.semi_regular(12, 3).surface
    wavelet = gp.SubdivisionWavelet(mesh, 3)
    assert wavelet.number_of_levels == 3


def test_wavelets_reject(sphere, plane, cloud):
    wavelet = gp.SubdivisionWavelet(sphere)
    V = sphere.vertices
    details = wavelet.analyze(V)
    wide = wavelet.analyze(np.tile(V, (1, 6)))
    for function in (
        lambda: wavelet.analyze(V[1:]), lambda: wavelet.analyze(np.full(len(V), np.nan)),
        lambda: wavelet.analyze(V[:, :2], frames=True), lambda: wavelet.analyze("values"),
        lambda: wavelet.analyze(V[None]), lambda: wavelet.analyze(None),
        lambda: wavelet.synthesize(details._replace(values=V[1:])),
        lambda: wavelet.synthesize(gp.WaveletDetails(V[:, 0], True)),
        lambda: wavelet.keep_largest(details, -1), lambda: wavelet.triangles(-1),
        lambda: wavelet.triangles(wavelet.number_of_levels + 1),
        lambda: wavelet.encode(details, bit_planes=0), lambda: wavelet.encode(wide),
        lambda: wavelet.encode(details, bit_planes=49),
        lambda: wavelet.encode(details, max_bytes=-1),
        lambda: gp.SubdivisionWavelet(sphere, prediction="cubic"),
        lambda: gp.SubdivisionWavelet(sphere, -1),
        lambda: gp.decode_wavelets(b""), lambda: gp.decode_wavelets("stream"),
        lambda: gp.decode_wavelets(None), lambda: gp.decode_wavelets(np.zeros((4, 4))),
        lambda: gp.decode_wavelets(wavelet.encode(details)[::2]),
        lambda: gp.decode_wavelets(wavelet.encode(details), max_vertices=10),
        lambda: gp.decode_wavelets(wavelet.encode(wavelet.analyze(V[:, 0]))),
    ):
        with pytest.raises(gp.InvalidArgumentError, match=r"\.$"):
            function()
    for surface in (cloud, gp.Surface(np.eye(3), [[0, 1, 2]])):
        with pytest.raises(gp.UnsupportedSurfaceError, match=r"\.$"):
            gp.SubdivisionWavelet(surface)
