# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the page of the tour from the pictures and outputs in the gallery."""

import re
import struct
from html import escape
from pathlib import Path

from folders import GALLERY, TOUR
from manual import Manual
from tour import SUFFIXES, Chapter, Entry, read_tour


def find_result(entry: Entry, *suffixes: str) -> Path | None:
    files = (GALLERY / (entry.name + suffix) for suffix in suffixes)
    return next((file for file in files if file.exists()), None)


def marked_up(text: str) -> str:
    """Returns the text as HTML, in which backticks enclose code."""
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", escape(text))


def size_attributes(picture: Path) -> str:
    """Returns the size of a PNG file, so that the page does not move while it is loaded."""
    if picture.suffix != ".png":
        return ""
    width, height = struct.unpack(">II", picture.read_bytes()[16:24])  # of its IHDR chunk
    return f' width="{width}" height="{height}"'


def thumbnail(entry: Entry) -> str:
    if picture := find_result(entry, ".png", ".svg"):
        return (
            f'<a class="thumbnail" href="{picture.name}"><img src="{picture.name}"'
            f'{size_attributes(picture)} alt="{escape(entry.description)}" loading="lazy"></a>\n'
        )
    if page := find_result(entry, ".html"):
        title = escape(entry.description)
        return f'<iframe src="{page.name}" title="{title}" loading="lazy"></iframe>\n'
    return ""


def output(entry: Entry) -> str:
    file = find_result(entry, ".txt")
    return f'<pre class="output">{escape(file.read_text().rstrip())}</pre>\n' if file else ""


def command(entry: Entry) -> str:
    """Returns the commands of an entry.  Lines break between their words only."""
    lines = (line.split(" ") for line in entry.commands)
    text = "\n".join(" ".join(f"<span>{escape(word)}</span>" for word in line) for line in lines)
    return f'<pre class="command"><code>{text}</code></pre>\n'


def links(chapter: Chapter, entry: Entry, manual: Manual) -> str:
    title = escape(entry.section or chapter.title)
    result = f'<a href="{manual.link(chapter.title, entry.section)}">Manual: {title}</a>\n'
    if page := find_result(entry, ".html"):
        result = f'<a href="{page.name}">Open on a page of its own</a>\n{result}'
    return result


def figure(chapter: Chapter, entry: Entry, manual: Manual) -> str:
    return (
        f'<figure id="{entry.name}">\n{thumbnail(entry)}<figcaption>\n'
        f"<p>{escape(entry.caption)}</p>\n{output(entry)}{command(entry)}"
        f'<div class="links">{links(chapter, entry, manual)}'
        f'<button type="button" class="copy" aria-label="Copy the command of {entry.name}">Copy'
        f"</button></div>\n</figcaption></figure>\n"
    )


def section(chapter: Chapter, manual: Manual) -> str:
    figures = "".join(figure(chapter, entry, manual) for entry in chapter.entries)
    name, title = manual.anchor(chapter.title), escape(chapter.title)
    return (
        f'<section id="{name}" aria-labelledby="{name}-title">\n'
        f'<h2 id="{name}-title">{title}</h2>\n'
        f'<p class="introduction">{marked_up(chapter.introduction)}</p>\n'
        f'<p class="links"><a href="{manual.link(chapter.title)}">Chapter {title} of the manual</a>'
        f'</p>\n<div class="figures">\n{figures}</div>\n</section>\n'
    )


def main() -> None:
    manual = Manual()
    chapters = read_tour()
    for chapter in chapters:  # entries that failed or were skipped have no results
        chapter.entries = [entry for entry in chapter.entries if find_result(entry, *SUFFIXES)]
    chapters = [chapter for chapter in chapters if chapter.entries]
    parts = {
        "style": (TOUR / "style.css").read_text(),
        "script": (TOUR / "script.js").read_text(),
        "contents": "".join(
            f'<li><a href="#{manual.anchor(chapter.title)}">{escape(chapter.title)}</a></li>\n'
            for chapter in chapters
        ),
        "sections": "".join(section(chapter, manual) for chapter in chapters),
    }
    template = (TOUR / "page.html").read_text()
    page = re.sub(r"{{(\w+)}}", lambda match: parts[match[1]], template)
    (GALLERY / "index.html").write_text(page)


if __name__ == "__main__":
    main()
