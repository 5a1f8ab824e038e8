// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

// A compressed file must not expand more than this, so that a short file cannot exhaust the memory.
const maxExpansion = 1000;

// Decompresses a stream of bytes. Throws an Error with one sentence that names the file.
export async function decompress(bytes, format, name = 'The page') {
  const pieces = [];
  let size = 0;
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format));
    const reader = stream.getReader();
    for (;;) {
      const {done, value} = await reader.read();
      if (done) break;
      pieces.push(value);
      size += value.length;
      if (size > maxExpansion * bytes.length) {
        await reader.cancel();
        throw new RangeError();
      }
    }
  } catch (error) {
    throw new Error(error instanceof RangeError
      ? `${name}: its compressed data expand to more than 1,000 times their length.`
      : `${name}: its compressed data are invalid.`);
  }
  const result = new Uint8Array(size);
  let end = 0;
  for (const piece of pieces) {
    result.set(piece, end);
    end += piece.length;
  }
  return result;
}

// Returns the bytes of a text in base64.
export function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

// Reads files {name, bytes} and decompresses those that end with .gz.
export async function readFiles(files) {
  return Promise.all([...files].map(async (file) => {
    const name = file.name.replaceAll('/', '_');
    const bytes = new Uint8Array(await file.arrayBuffer());
    if (!name.toLowerCase().endsWith('.gz')) return {name, bytes};
    return {name: name.slice(0, -3), bytes: await decompress(bytes, 'gzip', name)};
  }));
}

export function isImage(file) {
  return file.type.startsWith('image/') || /\.(png|jpe?g|webp|gif|bmp|svg|avif)$/i.test(file.name);
}

// Lets the reader of the page save a file.
export function save(name, content) {
  const link = document.createElement('a');
  link.download = name;
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content]));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// Returns the bytes of a binary PLY file with one property `name` per vertex, if there are values.
export function plyFile({points, triangles}, name, values) {
  const vertices = points.length / 3, faces = triangles.length / 3;
  const header = ['ply', 'format binary_little_endian 1.0', `element vertex ${vertices}`,
    'property double x', 'property double y', 'property double z',
    ...(values ? [`property double ${name}`] : []),
    ...(faces > 0 ? [`element face ${faces}`, 'property list uchar int vertex_indices'] : []),
    'end_header', ''].join('\n');
  const row = values ? 32 : 24;
  const data = new DataView(new ArrayBuffer(vertices * row + faces * 13));
  for (let i = 0; i < vertices; ++i) {
    for (let c = 0; c < 3; ++c) data.setFloat64(i * row + 8 * c, points[3 * i + c], true);
    if (values) data.setFloat64(i * row + 24, values[i], true);
  }
  for (let f = 0; f < faces; ++f) {
    const begin = vertices * row + f * 13;
    data.setUint8(begin, 3);
    for (let k = 0; k < 3; ++k) data.setInt32(begin + 1 + 4 * k, triangles[3 * f + k], true);
  }
  return new Blob([header, data.buffer]);
}

// Returns the values as text, one line each, as the program writes them.
export function valuesText(values) {
  return Array.from(values, (value) => (value === Infinity ? 'inf' : value) + '\n').join('');
}
