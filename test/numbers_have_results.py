# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists numbers of the manual and of README.md that have no source.

A number counts if a unit follows it, or if it is a cell of a table. Its source is a data file that
the same paragraph names, by `\\results{NAME}` or by a link to `NAME.tsv`, and that contains the number
up to rounding. A paragraph and the table after it are one. Other numbers are listed in
doc/numbers_without_results.tsv, each with its reason. The tables of doc/tables are generated from
data files and are not read.
"""

import re
import sys
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Set, Tuple

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "doc" / "tables"))

from declarations import TABLES
from results import Results, read_all

EXCEPTIONS = ROOT / "doc" / "numbers_without_results.tsv"
UNIT = (r"(?:[mµ]?s|[kKMGT]?B|bytes?|times|(?:micro|milli)?seconds?|minutes?|hours?"
        r"|(?:mega|giga)bytes?)")
NUMBER = r"\d+(?:,\d{3})*(?:\.\d+)?(?: &(?:times|middot); 10<SUP>-?\d+</SUP>|e-?\d+)?"
MEASURED = re.compile(rf"({NUMBER})(?:(?: (?:to|and|or|by|/|\+) |, )({NUMBER}))?"
                      rf" ?(?:{UNIT}\b(?!-)|%)")
CELL = re.compile(rf"^[-+<]?(?:{NUMBER})(?:(?: to |, | / | \+ )-?{NUMBER})*$")
CODE = re.compile(r"\\(?:verbatim|code|f\[).*?\\(?:endverbatim|endcode|f\])"
                  r"|```.*?```|`[^`]*`|\\f\$.*?\\f\$", re.S)
SOURCES = re.compile(r"\\results\{([^}]*)\}|doc/results/(\w+)\.tsv")
# A change of the unit: seconds and milliseconds, fractions and percent, bytes and gigabytes.
FACTORS = tuple(10.0 ** e for e in (0, 2, -2, 3, -3, 6, -6, 9, -9))


class Number(NamedTuple):
    file: str
    line: int
    text: str
    sources: Tuple[str, ...]


def value_and_tolerance(text: str) -> Tuple[float, float]:
    """Returns the number, and half of the unit of its last digit."""
    text = re.sub(r" &\w+; 10<SUP>(-?\d+)</SUP>", r"e\1", text).replace(",", "")
    mantissa, _, exponent = text.partition("e")
    scale = 10.0 ** int(exponent or 0)
    integer, point, decimals = mantissa.partition(".")
    zeros = len(integer) - len(integer.rstrip("0")) if len(integer) > 2 and not point else 0
    return float(mantissa) * scale, 0.5 * 10.0 ** (zeros - len(decimals)) * scale


def numbers_in(results: Results) -> Set[float]:
    return {float(text) for table in results.tables.values() for row in table.rows for cell in row
            for text in re.findall(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?", cell)}


def contains(values: Set[float], text: str) -> bool:
    number, tolerance = value_and_tolerance(text)
    return any(abs(value * factor - number) <= 1.0001 * tolerance
               for value in values for factor in FACTORS)


def paragraphs(text: str) -> Iterator[Tuple[int, str]]:
    """Yields the first line and the text of each paragraph, together with the table after it."""
    text = CODE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    lines = text.split("\n")
    begin = 0
    for i in range(1, len(lines) + 1):
        is_end = i == len(lines) or (not lines[i - 1].strip() and not lines[i].startswith("|"))
        if is_end:
            yield begin, "\n".join(lines[begin:i])
            begin = i


def numbers_of(path: Path) -> Iterator[Number]:
    for begin, paragraph in paragraphs(path.read_text(encoding="utf-8")):
        sources = tuple(name.strip() for match in SOURCES.finditer(paragraph)
                        for name in (match[1] or match[2]).split(","))
        # A line break inside of a sentence is a space, except before a row of a table.
        prose = re.sub(r"\n(?!\|)", " ", paragraph)
        for line in prose.split("\n"):
            for text in measured_numbers(line):
                yield Number(path.name, begin + 1, text, sources)


def measured_numbers(line: str) -> Iterator[str]:
    for match in MEASURED.finditer(line):
        yield from (text for text in match.groups() if text)
    if line.startswith("|"):
        for cell in line.strip("|").split("|"):
            if CELL.match(cell.strip()):
                yield from re.findall(NUMBER, cell)


def read_exceptions() -> Dict[Tuple[str, str], str]:
    result: Dict[Tuple[str, str], str] = {}
    for line in EXCEPTIONS.read_text(encoding="utf-8").splitlines():
        file, numbers, reason = line.split("\t")
        for number in numbers.split(" "):
            result[file, number] = reason
    return result


def table_failures(pages: List[Path], results: Dict[str, Results]) -> List[str]:
    """Lists tables that cannot be generated, are not declared, or are not in the manual.

    A table that is not in the manual yet can be declared before its data file is recorded.
    """
    included = {name for page in pages
                for name in re.findall(r"\\table\{(\w+)\}", page.read_text(encoding="utf-8"))}
    result = [f"table {name}: not declared" for name in included - TABLES.keys() - {"results"}]
    for name, table in TABLES.items():
        try:
            table.write(results)
            if name not in included:
                result.append(f"table {name}: no page includes it")
        except (KeyError, ValueError) as error:
            if name in included:
                result.append(f"table {name}: {error}")
    return result


def number_failures(files: List[Path], results: Dict[str, Results]) -> List[str]:
    values = {name: numbers_in(file) for name, file in results.items()}
    exceptions = read_exceptions()
    used: Set[Tuple[str, str]] = set()
    result: List[str] = []
    for number in (n for file in files for n in numbers_of(file)):
        unknown = [source for source in number.sources if source not in values]
        key = (number.file, number.text)
        if unknown:
            result.append(f"{number.file}:{number.line}: no data file {', '.join(unknown)}")
        elif any(contains(values[source], number.text) for source in number.sources):
            continue
        elif key in exceptions:
            used.add(key)
        else:
            where = f"not in {', '.join(number.sources)}" if number.sources else "no source"
            result.append(f"{number.file}:{number.line}: {number.text}: {where}")
    result.extend(f"{EXCEPTIONS.name}: {file}: {text}: not needed"
                  for file, text in exceptions if (file, text) not in used)
    return result


def failures() -> List[str]:
    pages = sorted((ROOT / "doc" / "manual").glob("*.txt"))
    results = read_all()
    return table_failures(pages, results) + number_failures([*pages, ROOT / "README.md"], results)


if __name__ == "__main__":
    found = failures()
    print("\n".join(found))
    sys.exit(1 if found else 0)
