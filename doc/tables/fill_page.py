# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""fill_page.py PAGE: prints a page of the manual. The table NAME replaces a line `\\table{NAME}`.

Doxygen runs this filter on each page.
"""

import re
import sys
from pathlib import Path
from typing import List, Mapping

from declarations import TABLES
from markdown import AnyTable
from results import AllResults, read_all

RUN = ("program", "processor", "cores", "compiler", "commit")


class ListOfResults:
    """A table with a row for each data file, which the command \\results refers to."""

    def write(self, results: AllResults) -> str:
        lines: List[str] = ["| data file | " + " | ".join(RUN) + " | other |\n",
                            "| :-- |" + " :-- |" * (len(RUN) + 1) + "\n"]
        for name, file in results.items():
            others = [f"{key} {value}" for key, value in file.run.items() if key not in RUN]
            cells = [f"\\anchor GP_Results_{name} <a href=\"{name}.tsv\">%{name}</a>"]
            cells.extend(file.run.get(key, "not recorded") for key in RUN)
            lines.append("| " + " | ".join(cells + [", ".join(others)]) + " |\n")
        return "".join(lines)


def fill(page: str, tables: Mapping[str, AnyTable], results: AllResults) -> str:
    """Returns the page with its tables. An indented command yields an indented table."""
    def replace(match: "re.Match[str]") -> str:
        indent, name = match.groups()
        try:
            lines = tables[name].write(results).splitlines()
        except (KeyError, ValueError) as error:
            raise SystemExit(f"Table {name}: {error}") from error
        return "\n".join(indent + line for line in lines)

    return re.sub(r"^( *)\\table\{(\w+)\}$", replace, page, flags=re.M)


if __name__ == "__main__":
    text = Path(sys.argv[1]).read_text(encoding="utf-8")
    page = fill(text, {**TABLES, "results": ListOfResults()}, read_all())
    sys.stdout.buffer.write(page.encode("utf-8"))
