// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kernels in the compiled page: exact predicates, and the results of the native program.
import assert from 'node:assert/strict';
import {after, before, describe, test} from 'node:test';
import {Page, native, page, startBrowser, stopBrowser, write} from './Page.mjs';
import {cloud, generator, torus} from './models.mjs';

const models = {};
const pages = {};

before(async () => {
  await startBrowser();
  models.mesh = write('torus.off', torus());
  models.cloud = write('torus.xyz', cloud());
  for (const [kind, model] of Object.entries(models)) pages[kind] = await Page.open(page(model));
});
after(async () => {
  try {
    for (const open of Object.values(pages)) await open.close();
  } finally {
    await stopBrowser();
  }
});

// Returns an integer that is the number times 2^1074. All finite numbers are multiples of 2^-1074.
function scaled(number) {
  const bits = new BigUint64Array(Float64Array.of(number).buffer)[0];
  const exponent = Number((bits >> 52n) & 0x7ffn), fraction = bits & 0xfffffffffffffn;
  const size = exponent === 0 ? fraction : (fraction | (1n << 52n)) << BigInt(exponent - 1);
  return bits >> 63n ? -size : size;
}

// Returns the sign of the exact determinant of a triangle.
function exactOrientation([ax, ay, bx, by, cx, cy]) {
  const [px, py, qx, qy, rx, ry] = [ax, ay, bx, by, cx, cy].map(scaled);
  const determinant = (qx - px) * (ry - py) - (qy - py) * (rx - px);
  return determinant > 0n ? 1 : determinant < 0n ? -1 : 0;
}

test('orientation_is_exact_on_40000_nearly_degenerate_triangles', async () => {
  const random = generator(7), coordinates = [], expected = [];
  const ulps = () => (Math.floor(5 * random()) - 2) * 2 ** -53;
  for (let i = 0; i < 40000; ++i) {
    // The third point is on the line through the others, up to some units in the last place. Every
    // other triangle has coordinates of few bits, so that many of these are exactly collinear.
    const bits = i % 2 ? 2 ** 32 : 2 ** 10;
    const [ax, ay, bx, by, t] =
      Array.from({length: 5}, () => Math.floor(bits * random()) / bits);
    const triangle = [ax, ay, bx, by, ax + t * (bx - ax) + ulps(), ay + t * (by - ay) + ulps()];
    coordinates.push(...triangle);
    expected.push(exactOrientation(triangle));
  }
  const {signs} = await pages.mesh.ask('orientations', coordinates);
  assert.equal(signs.length, 40000);
  assert.equal(signs.filter((sign, i) => sign !== expected[i]).length, 0);
  for (const sign of [-1, 0, 1]) assert.ok(expected.filter((other) => other === sign).length > 500);
});

// The heat method solves linear systems by another library than the native program. Its
// factorization has round-off errors of 1e-13; measured are differences of at most 2e-12 of the
// largest distance.
const heatTolerance = 1e-10;

describe('distances_are_bitwise_those_of_the_program', () => {
  for (const [kind, methods] of [['mesh', ['exact', 'euclidean', 'fast-marching', 'dijkstra']],
                                 ['cloud', ['euclidean', 'fast-marching', 'dijkstra']]])
    for (const method of methods)
      test(`${kind}_${method}`, async () => {
        for (const source of [0, 1234, 4321]) {
          const {lines} = native('distance', models[kind],
                                 ['--source', source, '--method', method], true);
          const {values} =
            await pages[kind].ask('distances', [{vertex: source}], method, Infinity, 60);
          assert.deepEqual(values, lines.map(([value]) => value));
        }
      });
});

test('distances_respect_the_limit', async () => {
  const {lines} = native('distance', models.mesh, ['--source', 17, '--limit', '0.5'], true);
  const {values} = await pages.mesh.ask('distances', [{vertex: 17}], 'exact', 0.5, 60);
  assert.deepEqual(values.map((value) => value ?? Infinity), lines.map(([value]) => value));
});

test('heat_distances_agree_with_the_program', async () => {
  const {lines} = native('distance', models.mesh, ['--source', 0, '--method', 'heat'], true);
  const {values} = await pages.mesh.ask('distances', [{vertex: 0}], 'heat', Infinity, 60);
  const largest = Math.max(...values);
  values.forEach((value, i) =>
    assert.ok(Math.abs(value - lines[i][0]) <= heatTolerance * largest, `vertex ${i}`));
});

test('paths_on_meshes_are_bitwise_those_of_the_program', async () => {
  for (const [from, to] of [[0, 2550], [17, 4999], [1234, 4321], [10, 11]]) {
    const {length, lines} = native('path', models.mesh, ['--from', from, '--to', to], true);
    const path = await pages.mesh.ask('path', {vertex: from}, {vertex: to}, true);
    assert.equal(path.length, length);
    assert.deepEqual(path.points, lines.flat());
    const {length: local} =
      native('path', models.mesh, ['--from', from, '--to', to, '--locally-shortest']);
    assert.equal((await pages.mesh.ask('path', {vertex: from}, {vertex: to}, false)).length, local);
  }
});

test('paths_on_clouds_agree_with_the_program', async () => {
  for (const [from, to] of [[0, 2550], [1234, 4321]]) {
    const {length} = native('path', models.cloud, ['--from', from, '--to', to]);
    const path = await pages.cloud.ask('path', {vertex: from}, {vertex: to}, true);
    assert.equal(path.length, length);
  }
});

// Numbers of nodes times numbers of points exceed 32 bits.
test('distances_on_a_large_cloud_are_those_of_the_program', async () => {
  const random = generator(3);
  const model = write('sphere.xyz', Array.from({length: 250000}, () => {
    const z = 2 * random() - 1, angle = 2 * Math.PI * random(), radius = Math.sqrt(1 - z * z);
    return `${radius * Math.cos(angle)} ${radius * Math.sin(angle)} ${z}\n`;
  }).join(''));
  const {lines} = native('distance', model, ['--source', 0, '--method', 'euclidean'], true);
  const open = await Page.open(page(model));
  const {values} = await open.ask('distances', [{vertex: 0}], 'euclidean', Infinity, 60);
  assert.equal(values.length, 250000);
  assert.deepEqual(values.map((value) => value ?? Infinity), lines.map(([value]) => value));
  await open.close();
});

test('voronoi_labels_are_those_of_the_program', async () => {
  for (const kind of ['mesh', 'cloud']) {
    const {lines} = native('voronoi', models[kind], ['--seeds', '3,777,2500,4000'], true);
    const {labels} = await pages[kind].ask(
      'voronoi', [3, 777, 2500, 4000].map((vertex) => ({vertex})), 60);
    assert.deepEqual(labels, lines.map(([label]) => label));
  }
});

test('cells_split_the_mesh', async () => {
  const {points, triangles, triangleLabels} =
    await pages.mesh.ask('voronoi', [{vertex: 0}, {vertex: 2550}], 60);
  assert.equal(triangles.length, 3 * triangleLabels.length);
  assert.ok(points.length > 3 * 5000 && Math.max(...triangles) < points.length / 3);
  assert.deepEqual([...new Set(triangleLabels)].sort(), [0, 1]);
});

test('samples_are_those_of_the_program', async () => {
  const {lines, covering_radius: radius} = native('sample', models.mesh, ['--number', 20], true);
  const {places, radii} = await pages.mesh.ask('samples', 20, 60);
  assert.equal(places.length, 20);
  assert.equal(radii.at(-1), radius);
  // A line has three vertices and three weights.
  places.forEach(({weights}, i) =>
    assert.deepEqual(Object.values(weights), lines[i].slice(3)));
});

test('decal_covers_the_faces_of_the_program', async () => {
  const {faces} = native('decal', models.mesh, ['--base', 1234, '--up', '0,0,1', '--width', '0.5']);
  const decal = await pages.mesh.ask('decal', {vertex: 1234}, [0, 0, 1], 0.5, 0.5);
  assert.equal(decal.faces.length, faces);
  assert.equal(decal.cornerUv.length, 6 * faces);
  const onCloud = await pages.cloud.ask('decal', {vertex: 1234}, [0, 0, 1], 0.5, 0.5);
  assert.ok(onCloud.vertices.length > 50);
  assert.ok(onCloud.vertexUv.every((x) => x >= 0 && x <= 1));
});

test('isolines_lie_at_their_distance', async () => {
  const {values} = await pages.mesh.ask('distances', [{vertex: 0}], 'exact', Infinity, 60);
  const {points, ends} = await pages.mesh.ask('isolines', values, [0.25, 0.5]);
  const {lines} = native('isolines', models.mesh, ['--source', 0, '--isovalues', '0.25,0.5']);
  assert.equal(ends.length, lines);
  assert.equal(ends.at(-1), points.length / 3);
});

test('errors_are_one_sentence', async () => {
  for (const [query, sentence] of [
    [['distances', [{vertex: 5000}], 'exact', Infinity, 60], 'A vertex does not exist.'],
    [['distances', [{vertex: 0}], 'fast', Infinity, 60], 'There is no method fast.'],
    [['distances', [], 'exact', Infinity, 60], /\.$/],
    [['path', {face: 0, weights: [2, 0, 0]}, {vertex: 0}, true], /\.$/],
    [['distances', [{vertex: 0}], 'exact', Infinity, 0],
     'The query was ended, because it took too long.']])
    await assert.rejects(pages.mesh.ask(...query), (error) => {
      const message = error.message.match(/Error: (.*)/)?.[1] ?? error.message;
      assert.match(message, typeof sentence === 'string' ? new RegExp(`^${sentence}$`) : sentence);
      return true;
    });
  await assert.rejects(pages.cloud.ask('distances', [{vertex: 0}], 'exact', Infinity, 60),
                       /The method exact needs a mesh\./);
  const {values} = await pages.mesh.ask('distances', [{vertex: 0}], 'exact', Infinity, 60);
  assert.equal(values[0], 0);
});
