# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Describes tables of the manual whose cells are taken from data files, and writes them."""

import math
import re
from dataclasses import dataclass, field
from typing import Dict, List, Mapping, Optional, Protocol, Sequence, Tuple, Union

from results import AllResults

Key = Union[str, Tuple[str, ...]]


@dataclass(frozen=True)
class Value:
    """A cell of a data file: of the row that begins with `key`, in the column `column`.

    digits  number of significant digits; the default writes the cell as it is
    factor  of the number, for another unit
    part    of a cell with several numbers `x / y`, from zero
    """
    file: str
    table: str
    key: Key
    column: str
    digits: Optional[int] = None
    factor: float = 1.0
    part: Optional[int] = None

    def number(self, results: AllResults) -> float:
        return self.factor * float(self._cell(results).rstrip("%").replace(",", ""))

    def text(self, results: AllResults) -> str:
        cell = self._cell(results)
        if self.digits is None and self.factor == 1.0:
            return readable(cell)
        return rounded(self.number(results), self.digits or 2)

    def _cell(self, results: AllResults) -> str:
        key = (self.key,) if isinstance(self.key, str) else self.key
        try:
            cell = results[self.file].tables[self.table].cell(key, self.column)
        except (KeyError, ValueError) as error:
            raise KeyError(f"{self.file}, {self.table}, {key}, {self.column}: {error}") from error
        return cell if self.part is None else re.split(" / |, ", cell)[self.part]


@dataclass(frozen=True)
class Ratio:
    """The quotient of two values."""
    numerator: Value
    denominator: Value
    digits: int = 2

    def number(self, results: AllResults) -> float:
        return self.numerator.number(results) / self.denominator.number(results)

    def text(self, results: AllResults) -> str:
        return rounded(self.number(results), self.digits)


@dataclass(frozen=True)
class Exponent:
    """The exponent of the power law through the values at two sizes."""
    small: Value
    large: Value
    ratio_of_sizes: float

    def text(self, results: AllResults) -> str:
        ratio = self.large.number(results) / self.small.number(results)
        return f"{math.log(ratio) / math.log(self.ratio_of_sizes):.2f}"


@dataclass(frozen=True)
class Range:
    """The smallest and the largest of several values."""
    values: Sequence[Union[Value, Ratio]]

    def text(self, results: AllResults) -> str:
        smallest = min(self.values, key=lambda value: value.number(results)).text(results)
        largest = max(self.values, key=lambda value: value.number(results)).text(results)
        return smallest if smallest == largest else f"{smallest} to {largest}"


class Text:
    """A text with a pair of braces for each value. It is empty if no value is recorded."""

    def __init__(self, form: str, *values: Union[Value, Range, Ratio, Exponent]) -> None:
        self._form = form
        self._values = values

    def text(self, results: AllResults) -> str:
        texts = [value.text(results) for value in self._values]
        return self._form.format(*texts) if any(texts) else ""


Cell = Union[str, Value, Range, Ratio, Text]


@dataclass(frozen=True)
class Column:
    """A column of a grid. The key of a row is followed by `key`."""
    heading: str
    table: str
    column: str
    key: Tuple[str, ...] = ()
    digits: Optional[int] = None
    factor: float = 1.0
    part: Optional[int] = None
    file: Optional[str] = None


@dataclass(frozen=True)
class Table:
    """A table of the manual. Columns after the first `number_of_labels` ones are right-aligned."""
    headings: Sequence[str]
    rows: Sequence[Sequence[Cell]]
    number_of_labels: int = 1

    def write(self, results: AllResults) -> str:
        alignment = [":--" if i < self.number_of_labels else "--:"
                     for i in range(len(self.headings))]
        rows = [[cell if isinstance(cell, str) else cell.text(results) for cell in row]
                for row in self.rows]
        for row in rows:
            if len(row) != len(self.headings):
                raise ValueError(f"{len(row)} cells, {len(self.headings)} headings: {row}")
        return "".join(f"| {' | '.join(row)} |\n" for row in [self.headings, alignment, *rows])


@dataclass(frozen=True)
class Whole:
    """A table of a data file with the order of its rows.

    names    of cells and headings that are written differently
    columns  the headings that are written, each with the heading in the manual (default: all)
    rows     the first cells of the rows that are written (default: all)
    """
    file: str
    table: str
    names: Mapping[str, str] = field(default_factory=dict)
    columns: Optional[Mapping[str, str]] = None
    rows: Optional[Sequence[str]] = None
    number_of_labels: int = 1

    def write(self, results: AllResults) -> str:
        try:
            table = results[self.file].tables[self.table]
            columns = self.columns or {heading: self.names.get(heading, heading)
                                       for heading in table.headings}
            indices = [table.headings.index(heading) for heading in columns]
        except (KeyError, ValueError) as error:
            raise KeyError(f"{self.file}, {self.table}: {error}") from error
        rows = [[self.names.get(row[i], readable(row[i])) for i in indices]
                for row in table.rows if self.rows is None or row[0] in self.rows]
        return Table(list(columns.values()), rows, self.number_of_labels).write(results)


class AnyTable(Protocol):
    def write(self, results: AllResults) -> str:
        """Returns the table in Markdown."""


def grid(file: str, label: Union[str, Sequence[str]], rows: Dict[Key, Union[str, Sequence[str]]],
         columns: Sequence[Column]) -> Table:
    """Returns a table of one data file.

    label    heading or headings of the labels
    rows     label or labels of each row, by the key of the row
    """
    labels = [label] if isinstance(label, str) else list(label)
    cells: List[List[Cell]] = []
    for key, names in rows.items():
        row: List[Cell] = [names] if isinstance(names, str) else list(names)
        row_key = (key,) if isinstance(key, str) else key
        row.extend(Value(c.file or file, c.table, row_key + c.key, c.column, c.digits, c.factor,
                         c.part) for c in columns)
        cells.append(row)
    return Table(labels + [c.heading for c in columns], cells, len(labels))


def rounded(number: float, digits: int) -> str:
    """Returns the number with so many significant digits, without an exponent."""
    if number == 0.0:
        return "0"
    decimals = digits - 1 - math.floor(math.log10(abs(number)))
    number = round(number, decimals)
    return f"{number:,.{max(decimals, 0)}f}"


def readable(cell: str) -> str:
    """Returns the cell with separated thousands and powers of ten, or nothing for a missing number."""
    if cell == "-":
        return ""
    if cell.isdigit():
        return f"{int(cell):,}"
    cell = re.sub(r"\b[0-9.]+e\+0[1-6]\b", lambda m: f"{float(m[0]):,.0f}", cell)
    return re.sub(r"\b([0-9.]+)e([+-])0*([0-9]+)\b",
                  lambda m: f"{m[1]} &middot; 10<SUP>{m[2].strip('+')}{m[3]}</SUP>", cell)
