# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python threads, callbacks and interrupts."""

import os
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, rough_arrays
from geodesic_processing._interrupts import interruptible


def in_four_threads(function, arguments):
    with ThreadPoolExecutor(4) as pool:
        return list(pool.map(function, arguments))


def test_threads_share_surface(surface):
    sources = list(range(0, 120, 6))
    expected = [surface.distance(source) for source in sources]
    assert np.array_equal(in_four_threads(surface.distance, sources), expected)


def test_threads_share_path_finder(surface):
    pairs = [(i, 120 - i) for i in range(20)]
    expected = [surface.path(*pair) for pair in pairs]
    for found, path in zip(in_four_threads(lambda pair: surface.path(*pair), pairs), expected):
        assert np.array_equal(found.points, path.points) and found.length == path.length


def test_threads_locate_at_the_same_time(arrays):
    points = np.random.default_rng(2).uniform(0, 1, (200, 3))
    expected = gp.Surface(*arrays).locate(points)
    surface = gp.Surface(*arrays)  # its tree is built by one of the threads
    for found in in_four_threads(surface.locate, [points] * 8):
        assert np.array_equal(found.indices, expected.indices)
        assert np.array_equal(found.coordinates, expected.coordinates)


def test_threads_share_solver(surface):
    solver = surface.solver()
    possible = [surface.distance(source) for source in (0, 60, 120)]

    def compute(source):
        return solver.compute(source).distance()

    # Another thread can compute between both calls, but each result is complete.
    for result in in_four_threads(compute, [0, 60, 120] * 10):
        assert any(np.array_equal(result, expected) for expected in possible)


def test_other_threads_run_during_computation():
    surface = gp.Surface(*rough_arrays(60))
    steps = 0
    is_finished = False

    def count():
        nonlocal steps
        while not is_finished:
            steps += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    begin, before = time.monotonic(), steps
    surface.distance_matrix(np.arange(20), threads=1)
    seconds, counted = time.monotonic() - begin, steps - before
    is_finished = True
    counter.join()
    # With the GIL held, no step is counted. A busy machine can delay most of them.
    assert counted >= 1 + 20 * seconds


def test_callback_receives_fractions():
    surface = gp.Surface(*grid_arrays(120))
    fractions = []
    surface.distance(0, method="euclidean", callback=fractions.append)
    assert len(fractions) >= 2
    assert all(0 <= fraction <= 1 for fraction in fractions) and fractions == sorted(fractions)


@pytest.mark.parametrize("method", ["exact", "euclidean", "fast-marching", "dijkstra", "heat"])
def test_callback_cancels(method):
    surface = gp.Surface(*grid_arrays(120))
    out = np.full(surface.number_of_points, -1.0)
    for false in (False, 0, np.False_):
        with pytest.raises(gp.Cancelled):
            surface.distance(0, method=method, callback=lambda fraction: false, out=out)
    assert (out == -1).all()
    solver = surface.solver(method)
    with pytest.raises(gp.Cancelled):
        solver.compute(0, callback=lambda fraction: False)
    expected = surface.distance(0, method=method)
    assert np.array_equal(solver.compute(0).distance(), expected)


class Special(BaseException):
    pass


@pytest.mark.parametrize("function", ["distance", "distance_matrix", "farthest_points", "voronoi"])
def test_exception_of_callback_arrives(function):
    surface = gp.Surface(*grid_arrays(120))
    raised = Special("reason")

    def callback(fraction):
        raise raised

    argument = 20 if function == "farthest_points" else [0, 500]
    named = {"threads": 2} if function == "distance_matrix" else {}
    with pytest.raises(Special) as caught:
        getattr(surface, function)(argument, callback=callback, **named)
    assert caught.value is raised
    assert np.isfinite(surface.distance(0)).all()


def test_callback_cannot_use_its_solver():
    solver = gp.Surface(*grid_arrays(120)).solver("euclidean")
    with pytest.raises(RuntimeError):
        solver.compute(0, callback=lambda fraction: solver.compute(1))
    assert np.isfinite(solver.compute(0).distance()).all()


def test_callback_can_use_its_surface(grid):
    surface = gp.Surface(*grid_arrays(120))
    found = []
    surface.distance(0, method="euclidean", callback=lambda _: found.append(surface.path(0, 1)))
    assert found[0].length == pytest.approx(1 / 119)


class Interrupt:
    """Sends SIGINT to this process after some seconds, as Ctrl-C does."""

    def __init__(self, seconds):
        self.time = None  # of the signal
        self._timer = threading.Timer(seconds, self._send)

    def _send(self):
        self.time = time.monotonic()
        os.kill(os.getpid(), signal.SIGINT)

    def __enter__(self):
        self._handler = signal.signal(signal.SIGINT, signal.default_int_handler)
        return self

    def start(self):
        self._timer.start()

    def __exit__(self, *exception):
        self._timer.cancel()
        self._timer.join()
        signal.signal(signal.SIGINT, self._handler)


# Takes seconds without interrupt, so that signals arrive during the computation.
ROUGH = rough_arrays(150)
MANY = np.arange(2000)
# A single row, path or step takes longer than half a second.
LARGE = rough_arrays(400)
REGION = np.where(np.arange(160000) < 1000, 0, -1)


@pytest.fixture(scope="module")
def large():
    return gp.Surface(*LARGE)


@pytest.mark.parametrize(
    "call",
    [
        lambda surface, solver: [surface.distance(0) for _ in range(100)],
        lambda surface, solver: [solver.compute(0) for _ in range(100)],
        lambda surface, solver: surface.distance_matrix(MANY, method="euclidean", threads=1),
        lambda surface, solver: surface.distance_matrix(MANY, method="euclidean", threads=2),
        lambda surface, solver: [surface.farthest_points(20000) for _ in range(100)],
        lambda surface, solver: surface.paths([(0, 22499)] * 1000),
        lambda surface, solver: [surface.diameter(relative_tolerance=0) for _ in range(100)],
    ],
    ids=["distance", "solver", "matrix", "parallel matrix", "samples", "paths", "diameter"],
)
def test_interrupt_raises_within_half_a_second(call):
    surface = gp.Surface(*ROUGH)
    solver = surface.solver()
    with Interrupt(0.3) as interrupt:
        with pytest.raises(KeyboardInterrupt):
            interrupt.start()
            call(surface, solver)
        assert time.monotonic() - interrupt.time < 0.5
    expected = np.linalg.norm(ROUGH[0][1] - ROUGH[0][0])
    assert surface.distance(0, max_distance=0.1)[1] <= expected
    assert solver.compute(0, max_distance=0.1).distance(1) <= expected


@pytest.mark.parametrize(
    "call",
    [
        lambda large: large.distance(0),
        lambda large: large.distance_matrix([0, 1, 2], [159999], threads=1),
        lambda large: large.distance_matrix([0, 1, 2], [159999], threads=2),
        lambda large: large.distance_matrix(regions=REGION, reduce="mean"),
        lambda large: large.sparse_distance_matrix(0.3, threads=2),
        lambda large: [large.path(0, 159999 - i) for i in range(100)],
        lambda large: large.isolines(np.arange(160000) % 400, np.linspace(0, 399, 10000)),
        lambda large: large.locate(np.random.default_rng(3).uniform(0, 1, (2000000, 3))),
        lambda large: [gp.Surface(*ROUGH).solver("heat") for _ in range(100)],
        lambda large: large.solver("heat"),
        lambda large: large.emd(0, 159999),
        lambda large: large.log_map(0),
        lambda large: [gp.Surface(*LARGE) for _ in range(100)],
        lambda large: [gp.Surface(LARGE[0]) for _ in range(10)],
    ],
    ids=[
        "distance", "row", "parallel rows", "row of means", "sparse rows", "path", "isolines",
        "locate", "heat", "large heat", "large transport", "log map", "mesh", "cloud",
    ],
)
def test_interrupt_ends_a_single_step(large, call):
    with Interrupt(0.3) as interrupt:
        with pytest.raises(KeyboardInterrupt):
            interrupt.start()
            while True:  # a fast machine completes a call before the signal
                call(large)
        assert time.monotonic() - interrupt.time < 0.5
    expected = np.linalg.norm(LARGE[0][1] - LARGE[0][0])
    assert large.distance(0, max_distance=0.01)[1] <= expected
    assert large.path(0, 1).length <= expected


@pytest.mark.parametrize(
    "call",
    [
        lambda surface: surface.emd(0, 1599),
        lambda surface: surface.barycenter([0, 1599]),
        lambda surface: surface.transport_to_region(0, 1599),
        lambda surface: surface.geodesic_barycenter([0, 1599]),
    ],
    ids=["emd", "barycenter", "region", "geodesic barycenter"],
)
def test_transport_is_interrupted_between_factorizations(call):
    surface = gp.Surface(*rough_arrays(40))  # each factorization takes some hundredths of a second
    with Interrupt(0.2) as interrupt:
        with pytest.raises(KeyboardInterrupt):
            interrupt.start()
            while True:
                call(surface)
        assert time.monotonic() - interrupt.time < 0.5


def test_interrupt_leaves_a_function_that_cannot_be_interrupted():
    may_end = threading.Event()
    has_ended = threading.Event()

    def function():
        may_end.wait()
        has_ended.set()

    with Interrupt(0.2) as interrupt:
        with pytest.raises(KeyboardInterrupt):
            interrupt.start()
            interruptible(function)()
        assert not has_ended.is_set()
    may_end.set()
    assert has_ended.wait(60)


def test_canceled_call_ends(large):
    # Without the cancellation, the thread would compute for minutes.
    with Interrupt(0.2) as interrupt:
        with pytest.raises(KeyboardInterrupt):
            interrupt.start()
            large.distance_matrix(targets=[0], method="exact", threads=2)
    for thread in threading.enumerate():
        if thread.name == "geodesic_processing":
            thread.join(60)
            assert not thread.is_alive()


def test_main_thread_calls_callbacks(large):
    threads = set()
    large.distance(0, callback=lambda _: threads.add(threading.current_thread()))
    assert threads == {threading.main_thread()}


def test_type_of_an_array_is_not_a_callback():
    find_thread = interruptible(lambda *_: threading.current_thread())
    assert find_thread(None, np.float32) is not threading.main_thread()
    assert find_thread(None, (1, print)) is threading.main_thread()


def test_exception_of_other_thread_arrives(large):
    with pytest.raises(gp.InvalidArgumentError, match="160000"):
        large.distance(160000)


def test_waiting_thread_is_interrupted():
    surface = gp.Surface(*ROUGH)
    solver = surface.solver()
    may_end = threading.Event()
    is_running = threading.Event()

    def hold(fraction):
        is_running.set()
        may_end.wait(0.01)

    def compute():
        while not may_end.is_set():
            solver.compute(0, callback=hold)

    other = threading.Thread(target=compute)
    other.start()
    is_running.wait()
    with Interrupt(0.2) as interrupt:
        try:
            with pytest.raises(KeyboardInterrupt):
                interrupt.start()
                while True:
                    solver.distance(0)
            assert time.monotonic() - interrupt.time < 0.5
        finally:
            may_end.set()
            other.join()
    assert solver.compute(0, max_distance=0.1).distance(0) == 0
