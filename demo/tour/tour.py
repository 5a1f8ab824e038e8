# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads tour.md, the list of all pictures of the tour.  Its first lines describe its format."""

import re
from dataclasses import dataclass, field

from folders import ROOT, TOUR
from models import MODELS, Model

SUFFIXES = (".png", ".svg", ".html", ".txt")  # of the results of an entry
DEMOS = {source.stem for source in (ROOT / "demo").glob("*.cpp")}


def program_of(command: str) -> str:
    return command.split()[0]


@dataclass
class Entry:
    """A picture, or the output of a demo program."""

    name: str
    caption: str
    section: str  # title of the section of the manual; empty for the whole chapter
    commands: list[str] = field(default_factory=list)
    models: list[Model] = field(default_factory=list)
    files: set[str] = field(default_factory=set)  # files that the commands name, without models

    @property
    def calls_demo(self) -> bool:
        return any(program_of(command) in DEMOS for command in self.commands)

    @property
    def is_viewer(self) -> bool:
        return self.commands[-1].startswith("geodesic view ")

    @property
    def result(self) -> str | None:
        """The file that the last command writes if it calls `geodesic`."""
        if program_of(self.commands[-1]) != "geodesic":
            return None
        return f"{self.name}.html" if self.is_viewer else f"{self.name}.png"

    @property
    def description(self) -> str:
        """The alternative text of the picture: the first model, if any, and the caption."""
        prefix = f"{self.models[0].description.capitalize()}. " if self.models else ""
        return prefix + self.caption

    def set_commands(self, lines: list[str]) -> None:
        """Replaces `$name` by the file of the model, and adds the option that writes the result."""
        text = "\n".join(lines)
        self.files = set(re.findall(r"[\w-]+\.(?:ply|off|txt|png)\b", text))
        self.models = [MODELS[name] for name in re.findall(r"\$(\w+)", text)]
        text = re.sub(r"\$(\w+)", lambda match: MODELS[match[1]].file.name, text)
        self.commands = text.splitlines()
        if self.result:
            self.commands[-1] += f" {'-o' if self.is_viewer else '--picture'} {self.result}"


@dataclass
class Chapter:
    """A chapter of the manual with its entries."""

    title: str
    introduction: str = ""
    entries: list[Entry] = field(default_factory=list)


def read_tour() -> list[Chapter]:
    chapters: list[Chapter] = []
    section = ""
    text = re.sub(r"<!--.*?-->", "", (TOUR / "tour.md").read_text(), flags=re.S)
    for block in re.split(r"\n{2,}", text.strip("\n")):
        if block.startswith("# "):
            chapters.append(Chapter(block.removeprefix("# ")))
            section = ""
        elif block.startswith("## "):
            section = block.removeprefix("## ")
        elif match := re.fullmatch(r"\*\*([\w.-]+)\*\* (.+)", block):
            chapters[-1].entries.append(Entry(match[1], match[2], section))
        elif block.startswith("    "):
            chapters[-1].entries[-1].set_commands([line.strip() for line in block.splitlines()])
        else:
            chapters[-1].introduction = block
    return chapters
