# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures distance matrices of a cortex with the Python module, in one process and in two.

    python3 cortex.py SURFACE MASK [--all-pairs METHOD]... [--gdist NAME=VALUE]...

SURFACE is a mesh, and MASK a text file with a number per vertex: 0 in the medial wall. ``--all-pairs``
also computes the whole matrix by a method, which takes minutes. ``--gdist`` also measures the
module gdist; its pairs describe that build (version, commit, flags). If the environment variable
GEODESIC_PROCESSING_RESULTS names a folder, the tables are written to the file cortex.tsv there.
GEODESIC_PROCESSING_COMMIT is the commit of the library. Use an idle machine.
"""

import argparse
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import geodesic_processing as gp
import numpy as np

METHODS = ("exact", "heat", "euclidean", "fast-marching", "dijkstra")
NUMBER_OF_ROWS = 49  # for the time of a row
GDIST_ROWS = 5  # gdist takes seconds for a row
COMPARED_ROWS = 1000  # with one process and with two
COMPARED_METHODS = ("euclidean", "exact")


def megabytes():
    """Returns the largest memory of this process so far."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def read_cortex(surface, mask):
    """Returns the cortex without the medial wall, and its vertices."""
    mesh, is_cortex = gp.read(surface), np.loadtxt(mask) != 0
    F = mesh.faces[is_cortex[mesh.faces].all(axis=1)]
    return gp.Surface(mesh.vertices, F), np.unique(F)


def measure_rows(surface, mask, method):
    """Prints the processor time of a row in milliseconds, the memory of the process, and saves rows."""
    cortex, vertices = read_cortex(surface, mask)
    solver = cortex.solver(method=method)
    rows, seconds = [], []
    for source in vertices[:: len(vertices) // NUMBER_OF_ROWS][:NUMBER_OF_ROWS]:
        begin = time.process_time()
        solver.compute(int(source))
        rows.append(solver.distance(vertices))
        seconds.append(time.process_time() - begin)
    np.save(f"{method}.npy", rows)
    print(1000 * np.mean(seconds), megabytes())


def measure_gdist(surface, mask):
    """Returns the processor time of a row of gdist, and the largest difference from the exact rows."""
    import gdist

    cortex, vertices = read_cortex(surface, mask)
    index = np.full(len(cortex.vertices), -1)
    index[vertices] = np.arange(len(vertices))
    V, F = cortex.vertices[vertices], index[cortex.faces].astype(np.int32)
    exact, seconds, difference = np.load("exact.npy"), [], 0.0
    for i in range(GDIST_ROWS):
        source = i * (len(vertices) // NUMBER_OF_ROWS)
        begin = time.process_time()
        row = gdist.compute_gdist(V, F, source_indices=np.array([source], np.int32))
        seconds.append(time.process_time() - begin)
        difference = max(difference, np.abs(row - exact[i]).max())
    return 1000 * np.mean(seconds), difference


def compare_processes(cortex, vertices, method):
    """Returns the seconds of some rows with one process and with two, and the processor time of the
    calling process with two. The results must be equal."""
    sources = vertices[:: len(vertices) // COMPARED_ROWS][:COMPARED_ROWS]
    seconds, results = [], []
    for workers in (1, 2):
        with ProcessPoolExecutor(workers) as pool:
            list(pool.map(time.sleep, [0.1] * workers))  # starts the processes
            begin, caller = time.perf_counter(), time.process_time()
            results.append(cortex.distance_matrix(sources, vertices, method=method, executor=pool))
            seconds.append(time.perf_counter() - begin)
            caller = time.process_time() - caller
    if not np.array_equal(*results):
        sys.exit("One process and two have different results.")
    return (*seconds, caller)


def all_pairs_minutes(cortex, vertices, method):
    """Returns the minutes of the whole matrix, which two processes write to a file as float32."""
    with tempfile.TemporaryDirectory(dir=".") as folder, ProcessPoolExecutor(2) as pool:
        matrix = np.lib.format.open_memmap(f"{folder}/distances.npy", "w+", "f4", 2 * (len(vertices),))
        begin = time.perf_counter()
        cortex.distance_matrix(vertices, out=matrix, method=method, executor=pool)
        matrix.flush()
        return (time.perf_counter() - begin) / 60


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.processor()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("surface", type=os.path.abspath)
    parser.add_argument("mask", type=os.path.abspath)
    parser.add_argument("--all-pairs", action="append", default=[])
    parser.add_argument("--gdist", action="append", default=[])
    parser.add_argument("--rows", help="measures only the rows of this method, in this process")
    arguments = parser.parse_args()
    model = (arguments.surface, arguments.mask)
    if arguments.rows:
        return measure_rows(*model, arguments.rows)

    properties = {
        "program": "benchmark cortex.py",
        "load average before": f"{os.getloadavg()[0]:.2f}",
        "processor": processor(),
        "cores": os.cpu_count(),
        "Python": platform.python_version(),
        "NumPy": np.__version__,
        "commit": os.environ.get("GEODESIC_PROCESSING_COMMIT", "not recorded"),
    }
    empty = megabytes()
    folder = os.environ.get("GEODESIC_PROCESSING_RESULTS")
    folder = Path(folder).resolve() if folder else None
    script = os.path.abspath(__file__)
    with tempfile.TemporaryDirectory() as work:
        os.chdir(work)
        times, memory = {}, {}
        for method in METHODS:
            command = [sys.executable, script, *model, "--rows", method]
            output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            times[method], memory[method] = map(float, output.split())
        exact = np.load("exact.npy")
        cortex, vertices = read_cortex(*model)
        minutes = len(vertices) / 2 / 60000  # of two processors, for one millisecond a row
        rows = [["method", "time per source [ms]", "mean error %",
                 "all pairs, two processors [minutes]", "memory of a worker [MB]"]]
        for method in METHODS:
            error = np.abs(np.load(f"{method}.npy") - exact).sum() / exact.sum()
            rows.append([method, f"{times[method]:.1f}",
                         "-" if method == "exact" else f"{100 * error:.2g}",
                         f"{times[method] * minutes:.1f}", f"{memory[method]:.0f}"])
        quantities = [["quantity", "value"], ["vertices of the cortex", len(vertices)],
                      ["vertices with the wall", len(cortex.vertices)],
                      ["Python with NumPy [MB]", f"{empty:.0f}"],
                      ["size of a row [kB]", f"{4 * len(vertices) / 1000:.0f}"]]
        tables = {}
        if arguments.gdist:
            milliseconds, difference = measure_gdist(*model)
            rows.append(["tvb-gdist", f"{milliseconds:.0f}", "-", "-", "-"])
            quantities.append(["largest difference of tvb-gdist from exact", f"{difference:.1g}"])
            build = dict(pair.split("=", 1) for pair in arguments.gdist)
            tables["libraries"] = [["library", *build], ["tvb-gdist", *build.values()]]
        tables["rows of a distance matrix, one thread"] = rows
        processes = [["method", "rows", "one process [s]", "two processes [s]", "ratio",
                      "all pairs, two processes [minutes]",
                      "calling process, per row [ms]"]]
        for method in COMPARED_METHODS:
            one, two, caller = compare_processes(cortex, vertices, method)
            processes.append([method, COMPARED_ROWS, f"{one:.2f}", f"{two:.2f}", f"{one / two:.2f}",
                              f"{two * len(vertices) / COMPARED_ROWS / 60:.1f}",
                              f"{1000 * caller / COMPARED_ROWS:.1f}"])
        tables["wall-clock time of some rows"] = processes
        if arguments.all_pairs:
            tables["wall-clock time of the whole matrix, two processes"] = [
                ["method", "time [minutes]"],
                *([method, f"{all_pairs_minutes(cortex, vertices, method):.1f}"]
                  for method in arguments.all_pairs)]
        tables["other quantities"] = quantities

    text = "".join(f"{name}\t{value}\n" for name, value in properties.items())
    for title, table in tables.items():
        text += f"\ntable\t{title}\n" + "".join("\t".join(map(str, row)) + "\n" for row in table)
    print(text)
    if folder:
        (folder / "cortex.tsv").write_text(text)


if __name__ == "__main__":
    main()
