// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// node speed.mjs BUILD MODEL: measures the processor time of the queries of the compiled page in
// the folder BUILD, without the page. test/benchmark/viewer_queries.cpp measures the same queries
// of the native library.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, join, resolve} from 'node:path';
import {generator} from './models.mjs';

const warmUpQueries = 10, measuredQueries = 15;

const [build, model] = [resolve(process.argv[2]), process.argv[3]];
const createKernels = createRequire(import.meta.url)(join(build, 'view.js'));
const kernels = await createKernels({wasmBinary: readFileSync(join(build, 'view.wasm'))});

// Returns the result of a query and its processor time in milliseconds.
function run(name, ...args) {
  const begin = process.cpuUsage(), result = kernels[name](...args), {user, system} =
    process.cpuUsage(begin);
  if (result.error) throw new Error(result.error);
  return {result, time: (user + system) / 1000};
}

const print = (name, time) => console.log(`${name.padEnd(10)} ${time.toFixed(1).padStart(8)} ms`);

function measure(name, query) {
  for (let i = 0; i < warmUpQueries; ++i) query();
  const times = Array.from({length: measuredQueries}, () => query().time).sort((a, b) => a - b);
  print(name, times[Math.floor(times.length / 2)]);
}

const name = basename(model);
kernels.FS.writeFile(name, readFileSync(model));
const {result: {points, triangles}, time} = run('load', name);
print('load', time);

const random = generator(1);
const vertex = () => ({vertex: Math.floor(random() * points.length / 3)});
for (const method of ['euclidean', 'exact'])
  measure(method, () => run('distances', [vertex()], method, Infinity, 60));
measure('path', () => run('path', vertex(), vertex(), true));

// The decal covers about 2,000 faces.
let area = 0;
for (let f = 0; f < triangles.length; f += 3) {
  const [p, q, r] = [0, 1, 2].map((k) => points.subarray(3 * triangles[f + k]));
  const u = [q[0] - p[0], q[1] - p[1], q[2] - p[2]], v = [r[0] - p[0], r[1] - p[1], r[2] - p[2]];
  area += 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                           u[0] * v[1] - u[1] * v[0]);
}
const width = Math.sqrt(2000 * area / (triangles.length / 3));
measure('decal', () => run('decal', vertex(), [0.1, 0.2, 1], width, width));
measure('locally', () => run('path', vertex(), vertex(), false));
