# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
from skbuild import setup

setup(
    packages=["geodesic_processing"],
    package_dir={"": "src/python"},
    package_data={"geodesic_processing": ["*.pyi", "py.typed"]},
    cmake_install_dir="src/python",
    # Other targets install the C++ library.
    cmake_install_target="install_python",
    cmake_args=[
        "-DGEODESIC_PROCESSING_PYTHON=ON",
        "-DGEODESIC_PROCESSING_PROGRAM=OFF",
        "-DCMAKE_UNITY_BUILD=ON",
    ],
)
