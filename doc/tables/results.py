# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the data files of doc/results.

A data file begins with lines `NAME<TAB>VALUE` that describe the run: program, processor, compiler,
versions of the libraries, commit. An empty line, a line `table<TAB>TITLE`, a line of column headings
and the rows follow for each table. Columns are separated by tabs. Units are part of the headings.
"""

from pathlib import Path
from typing import Dict, List, NamedTuple, Tuple

FOLDER = Path(__file__).parent.parent / "results"

# Matches any cell in the key of a row.
ANY = "*"


class Table(NamedTuple):
    headings: List[str]
    rows: List[List[str]]

    def row(self, key: Tuple[str, ...]) -> List[str]:
        """Returns the only row whose first cells are those of the key."""
        found = [row for row in self.rows
                 if all(part in (ANY, cell) for part, cell in zip(key, row))]
        if len(found) != 1:
            raise KeyError(f"{len(found)} rows begin with {key}")
        return found[0]

    def cell(self, key: Tuple[str, ...], heading: str) -> str:
        return self.row(key)[self.headings.index(heading)]


class Results(NamedTuple):
    """A data file."""
    run: Dict[str, str]
    tables: Dict[str, Table]


def read_results(path: Path) -> Results:
    """Reads a data file. Throws ValueError if it has another format."""
    blocks = path.read_text(encoding="utf-8").rstrip("\n").split("\n\n")
    run = dict(_pair(line, path) for line in blocks[0].split("\n"))
    tables: Dict[str, Table] = {}
    for block in blocks[1:]:
        lines = block.split("\n")
        word, title = _pair(lines[0], path)
        rows = [line.split("\t") for line in lines[1:]]
        if word != "table" or not rows or title in tables:
            raise ValueError(f"{path.name}: table '{title}'")
        if len(set(rows[0])) != len(rows[0]) or any(len(row) != len(rows[0]) for row in rows):
            raise ValueError(f"{path.name}: columns of table '{title}'")
        tables[title] = Table(rows[0], rows[1:])
    return Results(run, tables)


AllResults = Dict[str, Results]


def read_all() -> AllResults:
    """Returns the data files by their names without extension."""
    return {path.stem: read_results(path) for path in sorted(FOLDER.glob("*.tsv"))}


def _pair(line: str, path: Path) -> Tuple[str, str]:
    name, separator, value = line.partition("\t")
    if not separator:
        raise ValueError(f"{path.name}: '{line}' has no tab")
    return name, value
