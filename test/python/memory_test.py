# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The peak memory of a process, which tracemalloc does not see."""

import os
import subprocess
import sys

import pytest

SCRIPT = """
import os, sys
import numpy as np
sys.path.insert(0, sys.argv[1])
import geodesic_processing as gp
from conftest import grid_arrays

def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

V, F = grid_arrays(500)
before = resident()
surface = gp.Surface(V, F)
domain = resident() - before
# Dijkstra's algorithm has the smallest solver.
distance = surface.distance(0, method="dijkstra")
# resource.getrusage() would include the memory of the process that has started this one.
with open("/proc/self/status") as file:
    (line,) = [line for line in file if line.startswith("VmHWM:")]
peak = int(line.split()[1]) * 1024 - before
print(domain, distance.nbytes, peak)
"""


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="needs the file system proc")
def test_peak_is_domain_and_result():
    # Otherwise glibc has a heap for each thread, and the memory that they use again is random.
    run = subprocess.run(
        [sys.executable, "-c", SCRIPT, os.path.dirname(__file__)], capture_output=True, check=True,
        env=dict(os.environ, MALLOC_ARENA_MAX="1"),
    )
    domain, result, peak = map(int, run.stdout.split())
    # A copy of the input has 10 % of the domain (points) or 20 % (faces).
    assert peak <= 1.1 * (domain + result)
