# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Matrices, paths and collections that the workers of executors compute."""

import json
import math
import multiprocessing
import os
import pickle
import shutil
import signal
import subprocess
import sys
import tracemalloc
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool

import geodesic_processing as gp
import numpy as np
import pytest
from conftest import grid_arrays, rough_arrays, sphere_arrays
from geodesic_processing import _executors

PROGRAM = os.environ.get("GEODESIC_PROCESSING_PROGRAM")
# Seconds until a script, or a task of a worker, is regarded as hanging. Each takes less than 20 s
# on an idle machine.
MAX_WAIT = 200
# A tile of two rows takes some hundredths of a second, longer than a message.
SURFACE = gp.Surface(*rough_arrays(50))
SOURCES = np.arange(0, 2500, 50)


@pytest.fixture(scope="module")
def expected():
    return SURFACE.distance_matrix(SOURCES, threads=1)


class Counting(Executor):
    """Counts the tasks of another executor, and those with a surface."""

    def __init__(self, executor):
        self.executor = executor
        self.number_of_tasks = 0
        self.number_of_transfers = 0

    def submit(self, function, *arguments):
        self.number_of_tasks += 1
        self.number_of_transfers += any(isinstance(a, bytes) for a in arguments)
        return self.executor.submit(function, *arguments)


def new_processes(number=2):
    """Returns a pool whose processes do not have the surfaces of this process."""
    return ProcessPoolExecutor(number, mp_context=multiprocessing.get_context("spawn"))


def kill_a_worker(executor):
    os.kill(executor.submit(os.getpid).result(MAX_WAIT), signal.SIGKILL)


def run_script(script, text, arguments=(), launcher=(sys.executable,), **environment):
    """Runs a script that can import this file, in a new process. Returns the completed process.

    If it takes too long, all processes that it has started are killed as well.
    """
    script.write_text(text)
    path = os.pathsep.join([os.path.dirname(__file__), *filter(None, sys.path)])
    process = subprocess.Popen(
        [*launcher, str(script), *map(str, arguments)], text=True, start_new_session=True,
        env=dict(os.environ, PYTHONPATH=path, PYTHONDONTWRITEBYTECODE="1", **environment),
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )
    try:
        output = process.communicate(timeout=MAX_WAIT)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        raise
    return subprocess.CompletedProcess(process.args, process.returncode, *output)


def paths_are_equal(found, expected):
    return len(found) == len(expected) and all(
        np.array_equal(a.points, b.points) and a[3:] == b[3:] for a, b in zip(found, expected)
    )


# ---- Surfaces


def quads():
    V, F = grid_arrays(9)
    half = len(F) // 2
    return gp.Surface(V, np.column_stack([F[:half], F[half:, 2]]))


def damaged():
    V, F = sphere_arrays(2)
    F = np.concatenate([F, F[:5], F[7:9, ::-1], [[0, 0, 1], [0, 5, 60]]])
    return gp.Surface(np.concatenate([V, V[:3]]), F, merge_tolerance=1e-9)


def polygons():
    points, F = sphere_arrays(1)
    faces = np.column_stack([np.full(len(F), 3), F]).ravel()
    mesh = type("PolyData", (), {"points": points, "faces": faces, "strips": []})
    return gp.as_surface(mesh)


def cloud_with_radii():
    V = sphere_arrays(3)[0]
    return gp.Surface(2 * V, normals=V.tolist(), radii=np.full(len(V), 0.3, np.float32))


def half():
    V, F = sphere_arrays(3)
    return gp.Surface(V, F).split_at_isolines(V[:, 2], [0.05]).surface


def cloud_of_coincident_surfels():
    V = sphere_arrays(3)[0]
    # Coordinates of the cloud have round-off errors in its frame, which has another origin.
    V = 0.37 * np.concatenate([V, V[:20], V[:3]]) + [0.1, 5.3, -3.7]
    return gp.Surface(V, radii=np.linspace(0.02, 0.2, len(V)))


def merged():
    V, F = sphere_arrays(2)
    return gp.Surface(np.concatenate(V[F]), np.arange(3 * len(F)).reshape(-1, 3), merge_tolerance=0)


MAKERS = [
    quads, damaged, polygons, cloud_with_radii, cloud_of_coincident_surfels, half, merged,
    lambda: gp.Surface(sphere_arrays(3)[0]),
    lambda: gp.Surface(np.asfortranarray(sphere_arrays(2)[0]), sphere_arrays(2)[1][::-1]),
]


@pytest.mark.parametrize("make", MAKERS)
def test_pickled_surface_is_equal(make):
    surface = make()
    copy = pickle.loads(pickle.dumps(surface))
    assert type(copy) is gp.Surface and copy.content_hash == surface.content_hash
    assert make().content_hash == surface.content_hash
    assert np.array_equal(copy.vertices, surface.vertices)
    assert np.array_equal(copy.distance([0, 7]), surface.distance([0, 7]))
    if not surface.is_cloud:
        assert np.array_equal(copy.faces, surface.faces) and copy.report == surface.report


def test_hash_depends_on_content():
    V, F = grid_arrays(5)
    moved = V.copy()
    moved[3, 2] = 1e-9
    surfaces = [
        gp.Surface(V, F), gp.Surface(moved, F), gp.Surface(V, F[::-1]), gp.Surface(V),
        gp.Surface(V, F, merge_tolerance=0.0), gp.Surface(V, F, remove_degenerate_faces=True),
    ]
    assert len({surface.content_hash for surface in surfaces}) == len(surfaces)


def test_hash_does_not_depend_on_types_and_strides():
    V, F = (array.astype(np.float32) for array in grid_arrays(5))
    expected = gp.Surface(V, F.astype(np.int64)).content_hash
    assert gp.Surface(V.astype(float), F.astype(np.uint32)).content_hash == expected
    assert gp.Surface(np.asfortranarray(V), F.astype(np.int32).tolist()).content_hash == expected


@pytest.mark.parametrize("is_cloud", [False, True])
def test_surface_keeps_no_arrays(is_cloud):
    V, F = grid_arrays(60)
    tracemalloc.start()
    try:
        surface = gp.Surface(V) if is_cloud else gp.Surface(V, F)
        size, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    # NumPy reports its arrays. A copy of the points has 86,400 bytes; objects of Python are smaller.
    assert surface.number_of_points == 3600 and size < 20000


def test_pickled_surface_does_not_depend_on_changed_arrays():
    V, F = grid_arrays(5)
    surface = gp.Surface(V, F)
    before = surface.distance(0)
    V *= 2
    F[:] = 0
    assert np.array_equal(pickle.loads(pickle.dumps(surface)).distance(0), before)


def test_surface_of_file_is_pickled_with_the_file(tmp_path):
    V, F = grid_arrays(5)
    path = tmp_path / "grid.off"
    lines = ["OFF", f"{len(V)} {len(F)} 0"]
    lines += [f"{x} {y} {z}" for x, y, z in V] + [f"3 {a} {b} {c}" for a, b, c in F]
    path.write_text("\n".join(lines))
    surface = gp.read(path)
    content = pickle.dumps(surface)
    path.write_text("\n".join(lines) + "\n")
    with pytest.raises(gp.FileError, match="has changed"):
        pickle.dumps(surface)
    path.unlink()
    assert np.array_equal(pickle.loads(content).distance(0), surface.distance(0))


# ---- Equal results


def test_threads_compute_equal_matrix(expected):
    with ThreadPoolExecutor(2) as threads:
        counting = Counting(threads)
        found = SURFACE.distance_matrix(SOURCES, executor=counting)
    assert np.array_equal(found, expected)
    assert counting.number_of_transfers == 0


def test_processes_receive_the_surface_once(expected):
    with new_processes() as processes:
        first, second = Counting(processes), Counting(processes)
        found = SURFACE.distance_matrix(SOURCES, executor=first, rows_per_tile=2)
        assert np.array_equal(found, expected)
        # The third one is for a task that another worker takes.
        assert 1 <= first.number_of_transfers <= 3
        again = SURFACE.distance_matrix(SOURCES, executor=second, rows_per_tile=2)
        assert np.array_equal(again, expected)
        assert first.number_of_transfers + second.number_of_transfers <= 3


def forget_surfaces():
    _executors._received.clear()


class Forgetting(Counting):
    """An executor of one worker that forgets each surface after its task."""

    def submit(self, function, *arguments):
        future = super().submit(function, *arguments)
        self.executor.submit(forget_surfaces)
        return future


def test_worker_that_forgets_surfaces_receives_them_again():
    with new_processes(1) as processes:
        forgetting = Forgetting(processes)
        found = SURFACE.distance_matrix(SOURCES[:10], executor=forgetting, rows_per_tile=1)
    assert np.array_equal(found, SURFACE.distance_matrix(SOURCES[:10]))
    # Each of the ten tasks needs a transfer, because the worker never has the surface.
    assert forgetting.number_of_transfers == 10


# A forked process has the locks of other threads, but not these threads, which would unlock them. A
# new process therefore runs this script: threads of other tests do not run in it.
FORK_JOB = """
import json
import multiprocessing
from concurrent.futures import ProcessPoolExecutor
import geodesic_processing as gp
import numpy as np
from executor_test import Counting, SOURCES, SURFACE


def heat_distance(source):
    return SURFACE.distance(source, method="heat")


if __name__ == "__main__":
    # Threads of the library and of OpenBLAS compute before the fork.
    expected = SURFACE.distance_matrix(SOURCES, threads=2), [heat_distance(i) for i in (0, 7)]
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork")) as processes:
        counting = Counting(processes)
        matrix = SURFACE.distance_matrix(SOURCES, executor=counting, rows_per_tile=2)
        distances = gp.map(heat_distance, [0, 7], executor=processes)
    print(json.dumps([
        np.array_equal(matrix, expected[0]), np.array_equal(distances, expected[1]),
        counting.number_of_tasks, counting.number_of_transfers,
    ]))
"""


def test_forked_processes_have_the_surface(tmp_path):
    if "fork" not in multiprocessing.get_all_start_methods():
        pytest.skip("needs fork")
    job = run_script(tmp_path / "job.py", FORK_JOB)
    assert job.returncode == 0, job.stderr
    assert json.loads(job.stdout) == [True, True, 25, 0]


def test_dask_computes_equal_matrix(expected, tmp_path):
    distributed = pytest.importorskip("distributed")
    with dask_cluster(distributed, tmp_path) as cluster, distributed.Client(cluster) as client:
        counting = Counting(client.get_executor())
        found = SURFACE.distance_matrix(SOURCES, executor=counting, rows_per_tile=2)
        assert np.array_equal(found, expected)
        assert 1 <= counting.number_of_transfers <= 3
        # A worker is killed after some tiles. Dask starts it again, and repeats its tasks.
        out = np.zeros_like(expected)
        SURFACE.distance_matrix(
            SOURCES, executor=client.get_executor(), rows_per_tile=1, out=out,
            callback=KillAt(0.2, lambda: kill_a_worker(client.get_executor())),
        )
        assert np.array_equal(out, expected)


def dask_cluster(distributed, folder):
    return distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None,
        local_directory=str(folder), silence_logs=50,
    )


class KillAt:
    """A callback that calls a function once, at a fraction."""

    def __init__(self, fraction, kill):
        self.fraction = fraction
        self.kill = kill
        self.number_of_calls = 0

    def __call__(self, fraction):
        self.number_of_calls += 1
        if self.kill is not None and fraction >= self.fraction:
            kill, self.kill = self.kill, None
            kill()


@pytest.mark.parametrize("reduce", ["min", "mean"])
@pytest.mark.parametrize("dtype", ["f4", "f8"])
def test_matrix_of_regions_is_equal(surface, reduce, dtype):
    regions = np.arange(121) // 13
    regions[regions == 4] = 3
    regions[:5] = -1
    with ThreadPoolExecutor(2) as threads:
        for rows in ({}, {"sources": [3, 5, 120]}, {"targets": [7, 8]}):
            named = dict(rows, regions=regions, reduce=reduce, dtype=dtype)
            found = surface.distance_matrix(**named, executor=threads, rows_per_tile=4)
            assert found.dtype == dtype
            assert np.array_equal(found, surface.distance_matrix(**named))


def test_kinds_of_sources_and_targets(grid, arrays):
    locations = grid.locate(arrays[0][:4] + [0.02, 0.01, 0])
    border = grid.border_sources()[0]
    with ThreadPoolExecutor(2) as threads:
        for arguments in (
            (), (None, [3, 4]), (7,), (locations,), (locations[1], 5), ([3, locations[0]], [8]),
            ((0, 12), locations), (border, [60]), ([border, 0], [60, 61]), (np.int64(3), (4, 5)),
        ):
            found = grid.distance_matrix(*arguments, executor=threads, rows_per_tile=3)
            assert np.array_equal(found, grid.distance_matrix(*arguments))


def test_paths_are_equal(surface):
    pairs = np.random.default_rng(4).integers(0, 121, (30, 2))
    expected = surface.paths(pairs)
    with new_processes() as processes:
        assert paths_are_equal(surface.paths(pairs, executor=processes), expected)
        assert paths_are_equal(surface.paths(pairs.tolist()[:3], executor=processes), expected[:3])
        with pytest.raises(gp.InvalidArgumentError):
            surface.paths([(0, 121)], executor=processes)
        with pytest.raises(gp.InvalidArgumentError):
            surface.paths([], executor=processes)


def eccentricity(shape):
    return shape.distance(0).max()


def test_map_returns_results_in_the_order_of_shapes():
    shapes = [gp.Surface(*grid_arrays(n)) for n in (20, 3, 12, 5, 30, 4)]
    expected = [eccentricity(shape) for shape in shapes]
    assert gp.map(eccentricity, shapes) == expected
    fractions = []
    with ThreadPoolExecutor(2) as threads:
        assert gp.map(eccentricity, shapes, executor=threads, callback=fractions.append) == expected
    assert fractions == [(i + 1) / 6 for i in range(6)]
    with new_processes() as processes:
        found = gp.map(gp.Surface.diameter, shapes, executor=processes)
    assert found == [shape.diameter() for shape in shapes]
    assert gp.map(eccentricity, []) == []


def test_exception_of_function_arrives():
    with ThreadPoolExecutor(2) as threads, pytest.raises(AttributeError):
        gp.map(eccentricity, [1, 2], executor=threads)
    with pytest.raises(AttributeError):
        gp.map(eccentricity, [1, 2])


# ---- Arguments


@pytest.mark.parametrize(
    "named",
    [
        {"dtype": "i4"}, {"dtype": None}, {"dtype": "no type"}, {"out": np.empty((2, 3))},
        {"out": np.empty((2, 2), "i8")}, {"out": [[0.0] * 2] * 2}, {"rows_per_tile": 0},
        {"rows_per_tile": 1.5}, {"regions": np.zeros(121)}, {"regions": np.zeros(120, int)},
        {"regions": np.full(121, -1)}, {"regions": np.full(121, 121)}, {"regions": "all"},
        {"regions": np.zeros(121, int), "targets": [3, 4]}, {"threads": 0}, {"method": "best"},
        {"max_distance": -1}, {"reduce": "max"}, {"targets": []}, {"targets": "ab"},
        {"targets": [121]}, {"sources": []}, {"sources": 1.5}, {"sources": np.zeros((2, 2), int)},
        {"sources": None, "targets": [121]},
    ],
)
def test_matrix_rejects(surface, named):
    with ThreadPoolExecutor(1) as threads:
        with pytest.raises(gp.InvalidArgumentError, match=r" .*\.$"):
            surface.distance_matrix(**{"sources": [0, 1], **named}, executor=threads)


def test_callback_cancels(surface):
    fractions = []

    def callback(fraction):
        fractions.append(fraction)
        return fraction < 0.25

    with ThreadPoolExecutor(2) as threads:
        with pytest.raises(gp.Cancelled):
            surface.distance_matrix(executor=threads, rows_per_tile=1, callback=callback)
        assert fractions == [(i + 1) / 121 for i in range(31)]


def test_distance_is_too_large_for_float32():
    V, F = grid_arrays(3)
    large = gp.Surface(V * 1e39, F)
    regions = np.arange(9) // 5
    with ThreadPoolExecutor(1) as threads:
        for named in ({}, {"regions": regions, "reduce": "mean"}):
            with pytest.raises(gp.InvalidArgumentError):
                large.distance_matrix(dtype="f4", executor=threads, **named)


# ---- Outputs and interrupted computations


class Cancelling:
    """A callback that cancels after a number of tiles."""

    def __init__(self, number_of_tiles=math.inf):
        self.number_of_tiles = number_of_tiles
        self.number_of_calls = 0

    def __call__(self, fraction):
        self.number_of_calls += 1
        return self.number_of_calls < self.number_of_tiles


def interrupt(out, number_of_tiles=5, executor=None, sources=SOURCES):
    with ThreadPoolExecutor(1) as threads, pytest.raises(gp.Cancelled):
        SURFACE.distance_matrix(sources, executor=executor or threads, out=out, rows_per_tile=2,
                                callback=Cancelling(number_of_tiles))


def resume(out, sources=SOURCES):
    """Completes a matrix. Returns the number of tiles that were missing."""
    count = Cancelling()
    with ThreadPoolExecutor(1) as threads:
        result = SURFACE.distance_matrix(sources, executor=threads, out=out, rows_per_tile=2,
                                         callback=count)
    assert result is out
    return count.number_of_calls


def zarr_array(folder, dtype="f8", **named):
    zarr = pytest.importorskip("zarr")
    return zarr.open(str(folder / "matrix.zarr"), mode="a", shape=(50, 50), dtype=dtype, **named)


def memory_map(folder, dtype="f8"):
    path = folder / "matrix.npy"
    mode = "r+" if path.exists() else "w+"
    return np.lib.format.open_memmap(path, mode, dtype, (50, 50))


@pytest.fixture(params=["array", "memmap", "zarr"])
def open_output(request, tmp_path):
    """Returns a function that opens the same output again."""
    array = np.zeros((50, 50))
    return {
        "array": lambda: array,
        "memmap": lambda: memory_map(tmp_path),
        "zarr": lambda: zarr_array(tmp_path),
    }[request.param]


def test_second_call_computes_missing_tiles(open_output, expected, tmp_path):
    interrupt(open_output())
    assert resume(open_output()) == 20
    assert np.array_equal(open_output()[:], expected)
    # The record is removed: another call computes everything.
    assert not list(tmp_path.glob("*.tiles"))
    assert not dict(getattr(open_output(), "attrs", {}))
    assert resume(open_output()) == 25


def test_changed_tiles_are_computed_again(open_output, expected):
    interrupt(open_output())
    out = open_output()
    out[3, 4] = 7.0
    assert resume(open_output()) == 21
    assert np.array_equal(open_output()[:], expected)


def test_other_arguments_compute_everything(open_output):
    interrupt(open_output())
    others = SOURCES + 1
    assert resume(open_output(), others) == 25
    assert np.array_equal(open_output()[:], SURFACE.distance_matrix(others))


def test_damaged_record_is_ignored(expected, tmp_path):
    out = memory_map(tmp_path)
    interrupt(out)
    (record,) = tmp_path.glob("matrix.npy.*.tiles")
    lines = record.read_text().splitlines()
    assert len(lines) == 5
    damaged = [lines[0], "0 2", lines[1].replace("2 4", "4 6"), "-1 99 x", "", "48 99 0", lines[3][:20]]
    record.write_text("\n".join(damaged))
    assert resume(out) == 24
    assert np.array_equal(out, expected)


def test_zarr_array_receives_matrix(expected, tmp_path):
    out = zarr_array(tmp_path, "f4", chunks=(8, 50))
    count = Cancelling()
    with ThreadPoolExecutor(2) as threads:
        SURFACE.distance_matrix(SOURCES, executor=threads, out=out, callback=count)
    assert count.number_of_calls == 7  # one tile for each chunk
    assert np.array_equal(out[:], expected.astype("f4"))
    out[:] = 0
    SURFACE.distance_matrix(SOURCES, out=out)  # without an executor
    assert np.array_equal(out[:], expected.astype("f4"))


def test_second_call_completes_after_killed_worker(open_output, expected):
    # With a second worker, the surface could be on its way at the same time. Python before 3.11.5
    # then waits forever, as it does not stop writing to the pipe that no worker reads.
    with new_processes(1) as processes:
        killing = KillAt(0.2, lambda: kill_a_worker(processes))
        with pytest.raises(BrokenProcessPool):
            SURFACE.distance_matrix(SOURCES, executor=processes, out=open_output(),
                                    rows_per_tile=2, callback=killing)
    assert 5 <= killing.number_of_calls < 25
    assert resume(open_output()) == 25 - killing.number_of_calls
    assert np.array_equal(open_output()[:], expected)


MPI_JOB = """
import json
import sys
import time
from pathlib import Path
from executor_test import Counting, KillAt, SURFACE, SOURCES, kill_a_worker, memory_map
from mpi4py.futures import MPIPoolExecutor


def kill(pool):
    kill_a_worker(pool)
    time.sleep(60)  # mpiexec ends this process meanwhile


if __name__ == "__main__":
    with MPIPoolExecutor() as pool:
        counting = Counting(pool)
        callback = KillAt(float(sys.argv[2]), lambda: kill(pool))
        out = memory_map(Path(sys.argv[1]))
        SURFACE.distance_matrix(SOURCES, executor=counting, out=out, rows_per_tile=2,
                                callback=callback)
        print(json.dumps([callback.number_of_calls, counting.number_of_transfers]))
"""


def run_mpi_job(folder, fraction):
    # A process that waits for a message would use a processor that the others need.
    settings = ["mpi_yield_when_idle", "rmaps_base_oversubscribe"]
    return run_script(
        folder / "job.py", MPI_JOB, [folder, fraction],
        ["mpiexec", "-n", "3", sys.executable, "-m", "mpi4py.futures"],
        OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        **{f"OMPI_MCA_{name}": "1" for name in settings},
    )


def test_second_mpi_job_completes_after_killed_job(expected, tmp_path):
    pytest.importorskip("mpi4py")
    if shutil.which("mpiexec") is None:
        pytest.skip("needs mpiexec")
    killed = run_mpi_job(tmp_path, 0.2)
    assert killed.returncode != 0
    (record,) = tmp_path.glob("matrix.npy.*.tiles")
    finished = len(record.read_text().splitlines())
    assert 5 <= finished < 25
    job = run_mpi_job(tmp_path, 2)
    assert job.returncode == 0, job.stderr
    number_of_tiles, number_of_transfers = json.loads(job.stdout)
    assert number_of_tiles == 25 - finished
    assert 1 <= number_of_transfers <= 3
    assert np.array_equal(memory_map(tmp_path), expected)


# ---- Examples of the manual

EXAMPLES = os.path.join(os.path.dirname(__file__), "..", "..", "doc", "examples")


@pytest.mark.skipif(not PROGRAM, reason="GEODESIC_PROCESSING_PROGRAM is not set")
def test_parts_of_an_array_job_are_merged(tmp_path):
    V, F = rough_arrays(12)
    lines = ["OFF", f"{len(V)} {len(F)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in V] + ["3 %d %d %d" % tuple(f) for f in F]
    (tmp_path / "rough.off").write_text("\n".join(lines) + "\n")
    # The script of the manual, run by tasks one after the other.
    script = os.path.abspath(os.path.join(EXAMPLES, "array_job.sh"))
    environment = dict(os.environ, GEODESIC=PROGRAM, SLURM_ARRAY_TASK_COUNT="2")
    for task in ("0", "1"):
        subprocess.run(["bash", script, "rough.off", "matrix.npy", "144"], check=True, cwd=tmp_path,
                       env=dict(environment, SLURM_ARRAY_TASK_ID=task))
        parts = sorted(path.name for path in tmp_path.glob("matrix.*.npy"))
        assert parts == [f"matrix.{i}.npy" for i in range(int(task) + 1)]
    subprocess.run([PROGRAM, "merge-matrices", "--part", "matrix.0.npy", "--part", "matrix.1.npy",
                    "-o", "matrix.npy"], check=True, cwd=tmp_path)
    assert np.array_equal(np.load(tmp_path / "matrix.npy"), gp.Surface(V, F).distance_matrix())
