# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the demo programs, runs all commands of the tour and copies the pictures to the gallery.

The pictures of the program `geodesic` are computed two at a time while the demo programs are built.
Demo programs then run alone, because some of them measure times.  At last, pictures are computed
that read files of other entries.
"""

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor

from folders import BUILD, GALLERY, ROOT, WORK, first_existing
from models import link_models
from tour import DEMOS, SUFFIXES, Entry, program_of, read_tour

LOG = BUILD / "run.log"
VIEWER = first_existing(
    BUILD / "viewer/viewer.html", ROOT / "build/release/viewer/viewer.html"
)  # the page without a surface


class Failure(Exception):
    """A command of an entry failed, or did not write its picture."""


def build_demos() -> subprocess.Popen[bytes]:
    """Starts the build of the demo programs, with a lower priority than the pictures."""
    jobs = os.environ.get("JOBS") or str(os.cpu_count())
    command = ["nice", "cmake", "--build", str(BUILD), "-j", jobs]
    return subprocess.Popen(command, stdout=LOG.open("a"), stderr=subprocess.STDOUT)


def executed(command: str) -> str:
    """Returns the command with the options that the page does not show."""
    if program_of(command) != "geodesic":
        return command
    return command + " --quiet" + (f" --page {VIEWER}" if " view " in command else "")


def run(entry: Entry) -> str:
    """Runs the commands of an entry, and returns the output of its demo program."""
    path = f"{BUILD}:{BUILD}/demo:{os.environ['PATH']}"
    output = ""
    for command in map(executed, entry.commands):
        result = subprocess.run(
            ["bash", "-c", command],
            cwd=WORK,
            env={**os.environ, "PATH": path},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        with LOG.open("a") as log:
            log.write(f"{command}\n{result.stdout}")
        if result.returncode != 0:
            raise Failure(f"{command}\n{result.stdout}")
        if program_of(command) in DEMOS:
            output += result.stdout
    if entry.result and not (WORK / entry.result).exists():
        raise Failure(f"{entry.result} was not written")
    return output


def show(entry: Entry) -> bool:
    """Runs an entry, and copies its results to the gallery.  Returns false if it fails."""
    for folder in (GALLERY, WORK):
        for suffix in SUFFIXES:
            (folder / (entry.name + suffix)).unlink(missing_ok=True)
    begin = time.monotonic()
    try:
        output = run(entry)
    except Failure as failure:
        print(f"{entry.name:<26} FAILED: {failure}", file=sys.stderr)
        return False
    if output:
        (WORK / f"{entry.name}.txt").write_text(output)
    for suffix in SUFFIXES:
        if (file := WORK / (entry.name + suffix)).exists():
            shutil.copy(file, GALLERY)
    print(f"{entry.name:<26} {time.monotonic() - begin:3.0f} s  {entry.caption}", flush=True)
    if output:
        print(output, flush=True)
    return True


def readers(entries: list[Entry]) -> set[str]:
    """Returns the names of the entries that read a file of another entry.

    A picture is written by the entry of its name, any other file by the first entry that names it.
    """
    writer = {f"{entry.name}.png": entry.name for entry in entries}
    for entry in entries:
        for file in entry.files:
            writer.setdefault(file, entry.name)
    return {e.name for e in entries if any(writer[file] != e.name for file in e.files)}


def show_all(entries: Iterable[Entry], number_at_once: int) -> int:
    """Returns the number of entries that fail."""
    with ThreadPoolExecutor(number_at_once) as executor:
        return list(executor.map(show, entries)).count(False)


def main() -> int:
    for folder in (GALLERY, WORK):
        folder.mkdir(parents=True, exist_ok=True)
    link_models()
    entries = [entry for chapter in read_tour() for entry in chapter.entries]
    if not VIEWER:
        print("The viewers are missing, because the target viewer was not built.")
        entries = [entry for entry in entries if not entry.is_viewer]
    demos = [entry for entry in entries if entry.calls_demo]
    pictures = [entry for entry in entries if not entry.calls_demo]
    late = readers(entries)

    build = build_demos()
    try:
        failures = show_all((entry for entry in pictures if entry.name not in late), 2)
        if build.wait() != 0:
            print(f"The build failed; the complete output is in {LOG}.", file=sys.stderr)
            return 1
    finally:
        build.terminate()
    failures += show_all(demos, 1)
    failures += show_all((entry for entry in pictures if entry.name in late), 2)
    if failures:
        print(f"Failed entries: {failures}; {LOG} contains all output.", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
