# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a mesh with a texture atlas to atlas.glb (binary glTF). Argument: a mesh or a cloud."""

import json
import struct
import sys

import geodesic_processing as gp

if len(sys.argv) > 1:
    surface = gp.read(sys.argv[1])
else:
    cube = [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    surface = gp.Surface(cube, sides)

atlas = surface.atlas(6, texture_size=512)
print(f"charts: {atlas.number_of_charts}, injective: {atlas.is_injective}")
print(f"used part of the texture: {atlas.coverage:.1%}")
points, faces = atlas.points.astype("<f4"), atlas.faces.astype("<u4")
uv = (atlas.uv * (1, -1) + (0, 1)).astype("<f4")  # in glTF, (0, 0) is the upper left corner
data = [points.tobytes(), uv.tobytes(), faces.tobytes()]
number_of_bytes = sum(map(len, data))
views = [{"buffer": 0, "byteOffset": sum(map(len, data[:k])), "byteLength": len(data[k])}
         for k in range(3)]
real, integer = 5126, 5125  # the numbers of types in glTF: float32 and uint32
box = {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}
accessors = [{"bufferView": 0, "componentType": real, "count": len(points), "type": "VEC3", **box},
             {"bufferView": 1, "componentType": real, "count": len(uv), "type": "VEC2"},
             {"bufferView": 2, "componentType": integer, "count": faces.size, "type": "SCALAR"}]
primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}
gltf = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}], "buffers": [{"byteLength": number_of_bytes}],
        "bufferViews": views, "accessors": accessors}
text = json.dumps(gltf).encode()
text += b" " * (-len(text) % 4)
header = struct.pack("<4s3I4s", b"glTF", 2, 28 + len(text) + number_of_bytes, len(text), b"JSON")
with open("atlas.glb", "wb") as file:
    file.write(header + text + struct.pack("<I4s", number_of_bytes, b"BIN") + b"".join(data))
