# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds chapters and sections of the manual by their titles."""

import os
import re
from pathlib import Path

from folders import BUILD, GALLERY, ROOT, first_existing


class Manual:
    """The sources of the manual, and its pages if the target `documentation` was built."""

    def __init__(self) -> None:
        index = first_existing(
            BUILD / "doc/html/index.html", ROOT / "build/release/doc/html/index.html"
        )
        self.pages = index.parent if index else None
        self._sources: dict[str, Path] = {}  # by the title of the chapter
        self._anchors: dict[tuple[str, str], str] = {}  # by the titles of chapter and section
        for source in sorted((ROOT / "doc/manual").glob("*.txt")):
            self._read(source)

    def _read(self, source: Path) -> None:
        text = source.read_text()
        if chapter := re.search(r"^\\page (\w+) (.+)$", text, flags=re.M):
            title = chapter[2]
            self._sources[title] = source
            self._anchors[title, ""] = chapter[1]
            for anchor, section in re.findall(r"^\\(?:sub)?section (\w+) (.+)$", text, flags=re.M):
                self._anchors[title, section] = anchor

    def anchor(self, chapter: str, section: str = "") -> str:
        return self._anchors[chapter, section]

    def link(self, chapter: str, section: str = "") -> str:
        """Returns the address of a section, or of the chapter if no section is given.

        It is relative to the gallery.  If the manual was not built, it is that of the source.
        """
        if not self.pages:
            return os.path.relpath(self._sources[chapter], GALLERY)
        address = os.path.relpath(self.pages / f"{self.anchor(chapter)}.html", GALLERY)
        return f"{address}#{self.anchor(chapter, section)}" if section else address
