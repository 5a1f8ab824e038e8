# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Geodesic distances and paths on triangle meshes and surfel clouds.

Conventions
-----------
- A vertex is the index of a row of ``V`` (mesh) or ``P`` (cloud).
- A location is a vertex, a pair ``(face, barycentric)`` on a mesh, a pair ``(surfel, offset)`` on a
  cloud, or a row of ``Surface.locate(points)``. Ranges are lists or tuples of them, arrays of
  vertices, and ``Locations``. A tuple of two integers is a range of two vertices. A source can also
  be a ``Polyline``.
- Images and textures are arrays of uint8. Their first row is the highest one, as in image files.
  Coordinates (0, 0) of an image or a texture are its lower left corner.
- Lengths have the unit of the coordinates. A distance is infinite if no source reaches the vertex.
- Arrays of float64 and float32, int32, int64, uint32 and uint64 are read without a copy, with any
  strides. Others are converted.
- Invalid arguments raise ``InvalidArgumentError``, surfaces that a method does not support raise
  ``UnsupportedSurfaceError``. Both are subclasses of ``ValueError``.
- Computations run without the GIL. Several threads can use the same object. A solver serves one
  thread at a time.
- ``callback(fraction)`` is called with the completed fraction. If it returns a false value other
  than ``None``, the function raises ``Cancelled``. If it raises an exception, this exception
  arrives.
- Ctrl-C raises ``KeyboardInterrupt`` within half a second. With a callback, this can take until
  its next call.
- The modules of ``compat`` have the interfaces of other packages.
"""

from . import _interrupts as _interrupts  # isort: skip - replaces functions of the extension
from . import compat as compat
from ._atlas import Atlas
from ._convert import as_surface
from ._core import Cancelled, FileError, InvalidArgumentError, UnsupportedSurfaceError
from ._curvature import PrincipalCurvatures
from ._curves import Isoline, Loop, PolylinePath, SplitMesh
from ._decals import Decal, DecalTexture
from ._distances import Path, Solver, SparseMatrix, SurfelPath
from ._distortion import DistortionMinimum, FaceDistortion, SurfaceDistortion
from ._executors import map as map  # not in __all__, which would hide the function of Python
from ._features import FeatureDistance
from ._flattening import BaseFlattening, Flattening, FlatteningDistortion
from ._fuzzy import FuzzyGeodesic
from ._maps import Frame, KarcherMean, LogMap, StraightestGeodesic
from ._measures import Ball, Diameter, DistanceDerivatives, Eccentricity, Radius
from ._remeshing import (
    BaseMesh,
    BaseParameterization,
    HoleFilling,
    RemeshedSurface,
    SemiRegularMesh,
)
from ._sampling import Bisector, Samples, Segments, VertexSamples, Voronoi, VoronoiCells
from ._surface import SoupReport, Surface, read
from ._transport import (
    GeodesicBarycenter,
    HodgeDecomposition,
    MassDensity,
    RegionTransport,
    Streamline,
    SurfelHodgeDecomposition,
    Transport,
    TransportBarycenter,
    TransportCost,
    mass_density,
)
from ._types import Location, Locations, Polyline, SurfelLocation
from ._volumes import VolumetricDistances, VolumetricMetric, VolumetricPath
from ._wavelets import DecodedWavelets, SubdivisionWavelet, WaveletDetails, decode_wavelets

__all__ = [
    "Atlas",
    "Ball",
    "BaseFlattening",
    "BaseMesh",
    "BaseParameterization",
    "Bisector",
    "Cancelled",
    "Decal",
    "DecalTexture",
    "DecodedWavelets",
    "Diameter",
    "DistanceDerivatives",
    "DistortionMinimum",
    "Eccentricity",
    "FaceDistortion",
    "FeatureDistance",
    "FileError",
    "Flattening",
    "FlatteningDistortion",
    "Frame",
    "FuzzyGeodesic",
    "GeodesicBarycenter",
    "HodgeDecomposition",
    "HoleFilling",
    "InvalidArgumentError",
    "Isoline",
    "KarcherMean",
    "Location",
    "Locations",
    "LogMap",
    "Loop",
    "MassDensity",
    "Path",
    "Polyline",
    "PolylinePath",
    "PrincipalCurvatures",
    "Radius",
    "RegionTransport",
    "RemeshedSurface",
    "Samples",
    "Segments",
    "SemiRegularMesh",
    "Solver",
    "SoupReport",
    "SparseMatrix",
    "SplitMesh",
    "StraightestGeodesic",
    "Streamline",
    "SubdivisionWavelet",
    "Surface",
    "SurfaceDistortion",
    "SurfelHodgeDecomposition",
    "SurfelLocation",
    "SurfelPath",
    "Transport",
    "TransportBarycenter",
    "TransportCost",
    "UnsupportedSurfaceError",
    "VertexSamples",
    "VolumetricDistances",
    "VolumetricMetric",
    "VolumetricPath",
    "Voronoi",
    "VoronoiCells",
    "WaveletDetails",
    "as_surface",
    "decode_wavelets",
    "mass_density",
    "read",
]

for _name in __all__:
    globals()[_name].__module__ = __name__
del _name
