# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
from setuptools import find_packages
from skbuild import setup

cmake_args = [
    "-DGEODESIC_PROCESSING_PYTHON=ON",
    # The library is built unless it is installed. CMAKE_PREFIX_PATH can have its folder.
    "-DGEODESIC_PROCESSING_FIND_INSTALLED=ON",
    "-DGEODESIC_PROCESSING_PROGRAM=OFF",
    "-DCMAKE_UNITY_BUILD=ON",
]
try:
    import pybind11

    cmake_args.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
except ImportError:
    pass  # CMake finds the package of the system

setup(
    packages=find_packages("src/python"),
    package_dir={"": "src/python"},
    package_data={"geodesic_processing": ["*.pyi", "py.typed"]},
    cmake_install_dir="src/python",
    # Other targets install the C++ library.
    cmake_install_target="install_python",
    cmake_args=cmake_args,
)
