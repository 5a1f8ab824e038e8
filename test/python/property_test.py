# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of any kind: bad ones are rejected with a sentence, the layout of good ones has no effect."""

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays

hypothesis = pytest.importorskip("hypothesis")
from hypothesis import given, settings, strategies as st  # noqa: E402
from hypothesis.extra import numpy as hnp  # noqa: E402

# Examples are the same in each run, and nothing is written to the disk.
settings.register_profile("tests", max_examples=150, derandomize=True, database=None, deadline=None)
settings.load_profile("tests")

V, F = grid_arrays(4)
SURFACES = [gp.Surface(V, F), gp.Surface(V, normals=np.tile([0.0, 0.0, 1.0], (len(V), 1)))]
surfaces = st.sampled_from(SURFACES)

shapes = hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=5)
numbers = st.one_of(
    hnp.integer_dtypes(endianness="?"), hnp.unsigned_integer_dtypes(endianness="?"),
    hnp.floating_dtypes(endianness="?"), hnp.boolean_dtypes(), hnp.complex_number_dtypes(),
    hnp.datetime64_dtypes(), hnp.byte_string_dtypes(), hnp.unicode_string_dtypes(),
)
arrays = hnp.arrays(numbers, shapes)
scalars = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(), st.binary(), st.complex_numbers()
)
anything = st.one_of(
    arrays,
    st.recursive(
        scalars, lambda s: st.one_of(st.lists(s), st.tuples(s, s), st.dictionaries(st.text(), s)),
        max_leaves=8,
    ),
)


def accepts_or_rejects(function):
    """Calls a function, which either works or raises an exception with a sentence."""
    try:
        function()
    except (gp.InvalidArgumentError, gp.UnsupportedSurfaceError) as error:
        assert str(error).endswith(".") and " " in str(error)


@given(anything, anything)
def test_bad_mesh_is_rejected(points, faces):
    accepts_or_rejects(lambda: gp.Surface(points, faces))
    accepts_or_rejects(lambda: gp.Surface(points, F))
    accepts_or_rejects(lambda: gp.Surface(V, faces))


@given(hnp.arrays(np.float64, (5, 3), elements=st.floats(width=64)),
       hnp.arrays(np.int64, (6, 3), elements=st.integers(-1, 5)))
def test_any_soup_is_accepted_or_rejected(points, faces):
    def use():
        surface = gp.Surface(points, faces)
        assert surface.faces.shape == (surface.number_of_faces, 3)
        distance = surface.distance(0)
        assert distance[0] == 0 and not np.isnan(distance).any()

    with np.errstate(all="ignore"):
        accepts_or_rejects(use)


@given(anything, anything, anything)
def test_bad_cloud_is_rejected(points, normals, radii):
    accepts_or_rejects(lambda: gp.Surface(points, normals=normals, radii=radii))
    accepts_or_rejects(lambda: gp.Surface(V, normals=normals))
    accepts_or_rejects(lambda: gp.Surface(V, normals=V + [0, 0, 1], radii=radii))


@given(surfaces, anything, anything)
def test_bad_sources_are_rejected(surface, sources, other):
    accepts_or_rejects(lambda: surface.distance(sources))
    accepts_or_rejects(lambda: surface.distance([sources, other]))
    accepts_or_rejects(lambda: surface.distance((sources, other)))
    accepts_or_rejects(lambda: surface.distance(0, targets=sources))
    accepts_or_rejects(lambda: surface.distance(0, offsets=sources))
    accepts_or_rejects(lambda: surface.distance(0, speed=sources))
    accepts_or_rejects(lambda: surface.distance(0, face_speed=sources))
    accepts_or_rejects(lambda: surface.distance(0, max_distance=sources))
    accepts_or_rejects(lambda: surface.distance(0, out=other))
    accepts_or_rejects(lambda: surface.path(sources, other))
    accepts_or_rejects(lambda: surface.paths(sources))
    accepts_or_rejects(lambda: surface.paths([(sources, other)]))


@given(surfaces, anything, anything)
def test_bad_arguments_are_rejected(surface, first, second):
    accepts_or_rejects(lambda: surface.locate(first))
    accepts_or_rejects(lambda: surface.points(first))
    accepts_or_rejects(lambda: surface.voronoi(first, speed=second))
    accepts_or_rejects(lambda: surface.solver().compute(0).distance(first))
    accepts_or_rejects(lambda: surface.distance_matrix(0, first, out=second))
    accepts_or_rejects(lambda: surface.distance_matrix(None, [1], regions=first))
    accepts_or_rejects(lambda: surface.distance_matrix(0, dtype=first, reduce=second))
    accepts_or_rejects(lambda: surface.sparse_distance_matrix(first, second))
    accepts_or_rejects(lambda: surface.farthest_points(2, first=first, speed=second))
    accepts_or_rejects(lambda: surface.farthest_points(2, radius=first))
    accepts_or_rejects(lambda: surface.isolines(first, second))
    accepts_or_rejects(lambda: surface.isolines(np.arange(16.0), second))
    accepts_or_rejects(lambda: surface.solver(method=first))
    accepts_or_rejects(lambda: gp.as_surface(first))


@st.composite
def views(draw, array):
    """Returns a view with equal values and another layout in memory."""
    array = draw(st.sampled_from([array, array.astype(array.dtype.newbyteorder())]))
    parent_shape, index = [], []
    for size in array.shape:
        step = draw(st.sampled_from([1, 2, 3, -1, -2]))
        begin = draw(st.integers(0, 2))
        extent = begin + (size - 1) * abs(step) + 1
        parent_shape.append(extent + draw(st.integers(0, 2)))
        index.append(
            slice(begin, extent, step) if step > 0
            else slice(extent - 1, None if begin == 0 else begin - 1, step)
        )
    order = draw(st.sampled_from("CF"))
    size = int(np.prod(parent_shape)) * array.itemsize
    unaligned = draw(st.integers(0, array.itemsize))
    memory = np.zeros(size + array.itemsize, np.uint8)[unaligned : unaligned + size]
    parent = memory.view(array.dtype).reshape(parent_shape, order=order)
    result = parent[tuple(index)]
    result[...] = array
    result.flags.writeable = draw(st.booleans())
    return result


@given(views(V), views(F), views(np.linspace(1, 2, 16)), views(np.array([0, 9])))
def test_layout_has_no_effect(points, faces, speed, sources):
    surface = gp.Surface(points, faces)
    expected = SURFACES[0]
    assert np.array_equal(surface.distance(sources, speed=speed),
                          expected.distance([0, 9], speed=np.linspace(1, 2, 16)))
    located = surface.locate(points)
    assert np.array_equal(located.coordinates, expected.locate(V).coordinates)


@given(views(V), views(np.tile([0.0, 0.0, 2.0], (16, 1))), views(np.full(16, 0.4)))
def test_layout_of_cloud_has_no_effect(points, normals, radii):
    expected = gp.Surface(V, normals=np.tile([0.0, 0.0, 2.0], (16, 1)), radii=np.full(16, 0.4))
    surface = gp.Surface(points, normals=normals, radii=radii)
    assert np.array_equal(surface.distance(3), expected.distance(3))


@given(views(np.zeros(16)))
def test_layout_of_output_has_no_effect(out):
    try:
        SURFACES[0].distance(3, out=out)
    except gp.InvalidArgumentError:
        # Numbers are written as aligned numbers in the order of the machine.
        assert not (out.flags.writeable and out.flags.aligned and out.dtype.isnative)
        assert (out == 0).all()
    else:
        assert np.array_equal(out, SURFACES[0].distance(3))
