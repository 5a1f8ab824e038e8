// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of 5,000 vertices, and a deterministic generator of random numbers.

// Returns a function that returns uniform numbers in [0, 1): a linear congruential generator with
// the constants of Numerical Recipes.
export function generator(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const columns = 100, rows = 50;

// Returns the point of a bumpy torus.
function point(i, j) {
  const u = 2 * Math.PI * i / columns, v = 2 * Math.PI * j / rows;
  const radius = 0.4 + 0.05 * Math.sin(5 * u) * Math.cos(3 * v);
  const x = (1 + radius * Math.cos(v)) * Math.cos(u), y = (1 + radius * Math.cos(v)) * Math.sin(u);
  return [x, y, radius * Math.sin(v)];
}

function points() {
  return Array.from({length: columns * rows},
                    (_, k) => point(k % columns, Math.floor(k / columns)));
}

// Returns an OFF file of the torus.
export function torus() {
  const vertex = (i, j) => i % columns + columns * (j % rows), faces = [];
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i)
      faces.push(`3 ${vertex(i, j)} ${vertex(i + 1, j)} ${vertex(i + 1, j + 1)}`,
                 `3 ${vertex(i, j)} ${vertex(i + 1, j + 1)} ${vertex(i, j + 1)}`);
  return `OFF\n${columns * rows} ${faces.length} 0\n` +
    points().map((p) => p.join(' ')).join('\n') + '\n' + faces.join('\n') + '\n';
}

// Returns an XYZ file of the torus without normals.
export function cloud() { return points().map((p) => p.join(' ')).join('\n') + '\n'; }
