# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""generate.py FOLDER: writes the tables of the manual, FOLDER/NAME.md, from the data files."""

import sys
from pathlib import Path
from typing import List

from declarations import TABLES
from markdown import AllResults
from results import read_all

RUN = ("program", "processor", "cores", "compiler", "commit")


def list_of_results(results: AllResults) -> str:
    """Returns a table with a row for each data file, which the command \\results refers to."""
    lines: List[str] = ["| data file | " + " | ".join(RUN) + " | other |\n",
                        "| :-- |" + " :-- |" * (len(RUN) + 1) + "\n"]
    for name, file in results.items():
        others = [f"{key} {value}" for key, value in file.run.items() if key not in RUN]
        cells = [f"\\anchor GP_Results_{name} <a href=\"{name}.tsv\">%{name}</a>"]
        cells.extend(file.run.get(key, "not recorded") for key in RUN)
        lines.append("| " + " | ".join(cells + [", ".join(others)]) + " |\n")
    return "".join(lines)


def main(folder: Path) -> None:
    results = read_all()
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "results.md").write_text(list_of_results(results), encoding="utf-8")
    for name, table in TABLES.items():
        try:
            text = table.write(results)
        except (KeyError, ValueError) as error:
            raise SystemExit(f"Table {name}: {error}") from error
        (folder / f"{name}.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
