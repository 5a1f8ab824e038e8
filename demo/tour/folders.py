# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The folders of the tour."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOUR = ROOT / "demo/tour"
GALLERY = ROOT / "demo/gallery"  # the page and its pictures
BUILD = ROOT / "build/demo"  # the program, the demo programs and run.log
MODEL_FOLDER = BUILD / "models"
WORK = BUILD / "tour"  # links to the models, and the results; the commands run in this folder


def first_existing(*files: Path) -> Path | None:
    """Returns the first of these files that exists."""
    return next((file for file in files if file.exists()), None)
