// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

const maxPixels = 1024; // of a side, so that a large photograph does not slow down the page

// Returns a canvas with the image of a file. Throws an Error with one sentence.
export async function readImage(file) {
  let bitmap;
  try {
    bitmap = await createImageBitmap(file);
  } catch {
    throw new Error(`${file.name}: it is not an image that this browser reads.`);
  }
  const scale = Math.min(1, maxPixels / Math.max(bitmap.width, bitmap.height));
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(scale * bitmap.width));
  canvas.height = Math.max(1, Math.round(scale * bitmap.height));
  canvas.getContext('2d').drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  return canvas;
}

// Returns a canvas with the image that decals have until the user chooses another one: a
// checkerboard with rings, on which distortion is easy to see, and an arrow that points up.
export function defaultImage() {
  const size = 512, cells = 8, cell = size / cells;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d');
  for (let i = 0; i < cells; ++i)
    for (let j = 0; j < cells; ++j) {
      context.fillStyle = (i + j) % 2 ? '#f7f3e8' : '#1f7a86';
      context.fillRect(i * cell, j * cell, cell, cell);
    }
  context.lineWidth = 7;
  context.strokeStyle = '#d9582b';
  for (const radius of [0.15, 0.3, 0.45]) {
    context.beginPath();
    context.arc(size / 2, size / 2, radius * size, 0, 2 * Math.PI);
    context.stroke();
  }
  context.lineWidth = 14;
  context.lineJoin = context.lineCap = 'round';
  context.beginPath();
  context.moveTo(size / 2, 0.68 * size);
  context.lineTo(size / 2, 0.27 * size);
  context.moveTo(0.40 * size, 0.38 * size);
  context.lineTo(size / 2, 0.27 * size);
  context.lineTo(0.60 * size, 0.38 * size);
  context.stroke();
  context.lineWidth = 10;
  context.strokeStyle = '#14373c';
  context.strokeRect(5, 5, size - 10, size - 10);
  return canvas;
}
