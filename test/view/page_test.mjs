// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page in the browser: mouse, touch, keyboard, pictures, files and errors.
import assert from 'node:assert/strict';
import {existsSync, readFileSync, readdirSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {deflateSync, gzipSync} from 'node:zlib';
import {Page, native, page, startBrowser, stopBrowser, write} from './Page.mjs';
import {cloud, generator, torus} from './models.mjs';

const data = process.env.GEODESIC_PROCESSING_DATA ?? '';
let mesh, meshPage, cloudPage;

before(async () => {
  await startBrowser();
  mesh = write('torus.off', torus());
  meshPage = page(mesh);
  cloudPage = page(write('torus.xyz', cloud()));
});
after(stopBrowser);

// Opens a page, runs a test with it, and fails if its console has an error.
async function withPage(file, options, body) {
  const open = await Page.open(file, options);
  await body(open);
  await open.close();
}

const state = (open) => open.run(() => structuredClone(geodesicViewer.state));
const lightness = ([red, green, blue]) => 0.3 * red + 0.59 * green + 0.11 * blue;

test('page_opens_from_disk_without_network', () => withPage(meshPage, {}, async (open) => {
  assert.equal(await open.text('name'), 'torus.off');
  assert.equal(await open.text('size'), '10,000 faces');
  assert.match(await open.text('hint'), /^Click on the surface/);
}));

test('page_without_model_is_at_most_5_megabytes', () => {
  assert.ok(statSync(join(process.env.GEODESIC_VIEWER, 'viewer.html')).size <= 5e6);
});

test('page_without_model_opens_a_dropped_file', () =>
  withPage(join(process.env.GEODESIC_VIEWER, 'viewer.html'), {}, async (open) => {
    assert.match(await open.text('hint'), /^Drop a mesh/);
    await open.drop('torus.off', torus());
    assert.equal(await open.text('size'), '10,000 faces');
  }));

test('click_computes_the_distances_of_the_program', () => withPage(meshPage, {}, async (open) => {
  const [vertex] = await open.visibleVertices(1);
  await open.clickVertex(vertex);
  await open.settle();
  const {sources: [{point}]} = await state(open);
  const position = await open.run((point) => point.map((x, c) =>
    x * geodesicViewer.scene.scale + geodesicViewer.scene.center[c]), point);
  const {lines} = native('distance', mesh, ['--source-at', position.join(',')], true);
  const values = await open.run(() => Array.from(geodesicViewer.values.array));
  // The page locates the click in single precision, and so do the coordinates of its location.
  values.forEach((value, i) => assert.ok(Math.abs(value - lines[i][0]) < 1e-6));
  assert.match(await open.text('answer'), /^Largest distance \d/);
  assert.match(await open.text('time'), /^Exact, /);
}));

test('click_with_shift_selects_a_vertex', () => withPage(meshPage, {}, async (open) => {
  const [vertex] = await open.visibleVertices(1);
  await open.tab.keyboard.down('Shift');
  await open.clickVertex(vertex);
  await open.tab.keyboard.up('Shift');
  await open.settle();
  assert.equal((await state(open)).sources[0].vertex, vertex);
  const {lines} = native('distance', mesh, ['--source', vertex], true);
  assert.deepEqual(await open.run(() => Array.from(geodesicViewer.values.array)),
                   lines.map(([value]) => value));
}));

test('colors_show_distances', () => withPage(meshPage, {}, async (open) => {
  const vertices = await open.visibleVertices(200);
  await open.run(() => geodesicViewer.change((state) => { state.lines = 0; }));
  await open.clickVertex(vertices[0]);
  await open.settle();
  const values = await open.run(() => Array.from(geodesicViewer.values.array));
  vertices.sort((v, w) => values[v] - values[w]);
  const near = vertices[5], far = vertices.at(-1);
  const pixels = [];
  for (const vertex of [near, far]) pixels.push(await open.pixelOf(vertex));
  const [nearColor, farColor] = await open.colors(pixels);
  // The map begins with dark purple. Its end is light, with more green than red.
  assert.ok(lightness(nearColor) + 40 < lightness(farColor), `${nearColor}; ${farColor}`);
  assert.ok(nearColor[2] > nearColor[1], `${nearColor}`);
  assert.ok(farColor[1] > farColor[2], `${farColor}`);
  const [corner] = await open.colors([{x: 639, y: 5}]);
  assert.ok(Math.min(...corner) > 220, 'The background is light.');
}));

test('isolines_are_drawn', () => withPage(meshPage, {}, async (open) => {
  const pixels = Array.from({length: 6000}, (_, i) => ({x: 300 + 3 * (i % 100),
                                                        y: 50 + 5 * Math.floor(i / 100)}));
  const [vertex] = await open.visibleVertices(1);
  await open.clickVertex(vertex);
  await open.settle();
  const withLines = await open.colors(pixels);
  await open.run(() => geodesicViewer.change((state) => { state.lines = 0; }));
  await open.settle();
  const without = await open.colors(pixels);
  const darker = withLines.filter((color, i) => lightness(color) < lightness(without[i]) - 20);
  assert.ok(darker.length > 40, `${darker.length} of ${pixels.length} pixels are darker.`);
}));

test('two_clicks_compute_the_shortest_path', () => withPage(meshPage, {}, async (open) => {
  await open.tab.keyboard.press('2');
  const [from, , to] = await open.visibleVertices(3);
  await open.tab.keyboard.down('Shift');
  await open.clickVertex(from);
  await open.settle();
  assert.match(await open.text('hint'), /^Click where the path ends/);
  await open.clickVertex(to);
  await open.tab.keyboard.up('Shift');
  await open.settle();
  const {length} = native('path', mesh, ['--from', from, '--to', to]);
  assert.equal(await open.run(() => geodesicViewer.path.length), length);
  assert.match(await open.text('answer'), /^Length \d/);
  assert.equal(await open.run(() => geodesicViewer.scene.path.visible), true);
}));

test('dragged_point_moves_and_undo_restores_it', () => withPage(meshPage, {}, async (open) => {
  const [first, , , second] = await open.visibleVertices(4);
  await open.clickVertex(first);
  await open.settle();
  const before = await state(open);
  const from = await open.pixelOf(first), to = await open.pixelOf(second);
  await open.tab.mouse.move(from.x, from.y);
  await open.tab.mouse.down();
  for (let i = 1; i <= 8; ++i)
    await open.tab.mouse.move(from.x + i / 8 * (to.x - from.x), from.y + i / 8 * (to.y - from.y));
  await open.tab.mouse.up();
  await open.settle();
  const moved = await state(open);
  assert.notDeepEqual(moved.sources, before.sources);
  assert.match(await open.text('time'), /^Exact, /);
  await open.tab.keyboard.press('z');
  await open.settle();
  assert.deepEqual(await state(open), before);
}));

test('front_answers_while_a_point_moves', () => withPage(meshPage, {}, async (open) => {
  const [first, second] = await open.visibleVertices(2);
  await open.clickVertex(first);
  await open.settle();
  const from = await open.pixelOf(first), to = await open.pixelOf(second);
  await open.tab.mouse.move(from.x, from.y);
  await open.tab.mouse.down();
  const seen = new Set();
  for (let i = 1; i <= 15; ++i) {
    await open.tab.mouse.move(from.x + i / 30 * (to.x - from.x), from.y + i / 30 * (to.y - from.y));
    await open.tab.waitForTimeout(40);
    seen.add((await open.text('time')).split(',')[0]);
  }
  assert.ok(seen.has('Euclidean front'), [...seen].join());
  await open.settle(); // the pointer rests
  assert.match(await open.text('time'), /^Exact, /);
  await open.tab.mouse.up();
}));

test('seeds_and_samples_show_cells', () => withPage(meshPage, {}, async (open) => {
  await open.tab.keyboard.press('3');
  for (const vertex of await open.visibleVertices(4)) await open.clickVertex(vertex);
  await open.settle();
  assert.equal(await open.text('answer'), '4 cells');
  assert.equal(await open.run(() => new Set(geodesicViewer.values.array).size), 4);
  await open.tab.keyboard.press('4');
  await open.run(() => {
    const slider = document.getElementById('number');
    slider.value = 12;
    slider.dispatchEvent(new Event('input', {bubbles: true}));
    slider.dispatchEvent(new Event('change', {bubbles: true}));
  });
  await open.settle();
  assert.match(await open.text('time'), /^12 samples/);
  assert.equal(await open.run(() => new Set(geodesicViewer.values.array).size), 12);
}));

test('image_is_placed_scaled_and_rotated', () => withPage(meshPage, {}, async (open) => {
  await open.tab.keyboard.press('5');
  const red = await open.run(async () => {
    const canvas = new OffscreenCanvas(8, 8), context = canvas.getContext('2d');
    context.fillStyle = '#ff0000';
    context.fillRect(0, 0, 8, 8);
    return Array.from(new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer()));
  });
  await open.drop('red.png', red, 'image/png');
  const [vertex] = await open.visibleVertices(1);
  await open.clickVertex(vertex);
  await open.settle();
  const faces = async () => Number((await open.text('answer')).replace(/[^\d]/g, ''));
  const small = await faces(), {x, y} = await open.pixelOf(vertex);
  const [[r, g]] = await open.colors([{x: x + 14, y}]);
  assert.ok(r > 100 && g < 60, `${r}, ${g}`);
  for (let i = 0; i < 5; ++i) await open.tab.keyboard.press('+');
  await open.tab.keyboard.press('[');
  await open.settle();
  assert.ok(await faces() > small);
  assert.deepEqual(await open.run(({}) => {
    const {width, angle} = geodesicViewer.state.decal;
    return [width, angle];
  }, {}), [35, 5]);
}));

test('cloud_answers_all_tools', () => withPage(cloudPage, {}, async (open) => {
  assert.equal(await open.text('size'), '5,000 points');
  const vertices = await open.visibleVertices(3);
  await open.clickVertex(vertices[0]);
  await open.settle();
  assert.match(await open.text('time'), /^Euclidean front/);
  await open.tab.keyboard.press('2');
  for (const vertex of vertices.slice(0, 2)) await open.clickVertex(vertex);
  await open.settle();
  assert.match(await open.text('answer'), /^Length/);
  await open.tab.keyboard.press('3');
  for (const vertex of vertices) await open.clickVertex(vertex);
  await open.settle();
  assert.equal(await open.text('answer'), '3 cells');
  await open.tab.keyboard.press('4');
  await open.settle();
  assert.match(await open.text('time'), /^40 samples/);
  await open.tab.keyboard.press('5');
  await open.clickVertex(vertices[0]);
  await open.settle();
  assert.match(await open.text('answer'), /points$/);
}));

test('hostile_files_are_rejected_with_one_sentence', () => withPage(meshPage, {}, async (open) => {
  const header = 'ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n' +
    'property double x\nproperty double y\nproperty double z\nend_header\n';
  for (const [name, bytes] of [
    ['garbage.off', 'this is not a mesh'], ['empty.ply', ''], ['long.ply', header],
    ['index.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n'],
    ['nan.off', 'OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n'],
    ['flat.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 0 0\n'],
    ['unknown.doc', 'x'], ['cut.ply.gz', gzipSync('ply').subarray(0, 12)],
    ['expanding.ply.gz', gzipSync(Buffer.alloc(1 << 25))],
    ['image.png', 'not an image']]) {
    await open.drop(name, bytes);
    const message = await open.message();
    assert.match(message, /^[^\n]*[^.\n]\.$/, name);
    assert.ok(message.includes(name.replace(/\.gz$/, '').split('.')[0]), message);
    assert.equal(await open.text('name'), 'torus.off');
  }
  const [vertex] = await open.visibleVertices(1);
  await open.clickVertex(vertex);
  await open.settle();
  assert.match(await open.text('answer'), /^Largest distance/);
}));

test('compressed_files_are_read', () => withPage(cloudPage, {}, async (open) => {
  await open.drop('torus.off.gz', gzipSync(torus()));
  assert.equal(await open.text('size'), '10,000 faces');
  // GIFTI and VTP files have compressed data inside.
  const array = (intent, type, dimensions, bytes) =>
    `<DataArray Intent="${intent}" DataType="${type}" ArrayIndexingOrder="RowMajorOrder" ` +
    `Dimensionality="2" Dim0="${dimensions[0]}" Dim1="${dimensions[1]}" ` +
    'Encoding="GZipBase64Binary" Endian="LittleEndian" ExternalFileName="" ' +
    `ExternalFileOffset=""><Data>${deflateSync(Buffer.from(bytes.buffer)).toString('base64')}` +
    '</Data></DataArray>';
  await open.drop('square.gii', '<?xml version="1.0"?>' +
    '<GIFTI Version="1.0" NumberOfDataArrays="2">' +
    array('NIFTI_INTENT_POINTSET', 'NIFTI_TYPE_FLOAT32', [4, 3],
          Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)) +
    array('NIFTI_INTENT_TRIANGLE', 'NIFTI_TYPE_INT32', [2, 3], Int32Array.of(0, 1, 2, 0, 2, 3)) +
    '</GIFTI>');
  assert.equal(await open.message(), '');
  assert.equal(await open.text('size'), '2 faces');
}));

const skipWithout = (folder) =>
  existsSync(join(data, folder)) ? false : `there is no folder ${folder} of models`;

test('vtp_files_are_read', {skip: skipWithout('formats')}, () =>
  withPage(meshPage, {}, async (open) => {
    for (const name of readdirSync(join(data, 'formats'))) {
      if (!name.endsWith('.vtp')) continue;
      const file = join(data, 'formats', name);
      await open.drop(name, readFileSync(file));
      assert.equal(await open.message(), '', name);
      const {vertices} = native('info', file, []);
      assert.equal(await open.run(() => geodesicViewer.surface.points.length / 3), vertices, name);
    }
  }));

test('hostile_models_are_opened_or_rejected', {skip: skipWithout('hostile')}, () =>
  withPage(meshPage, {}, async (open) => {
    for (const name of [
      'hm_scale_1e160.off', 'hm_scale_1e-160.off', 'hm_far_offset.off', 'hm_single_point.xyz',
      'hm_coincident_points.xyz', 'hm_collinear_points.xyz', 'hm_collinear_faces.off',
      'hm_moebius.off', 'hm_bowtie_vertex.off', 'hm_truncated_binary.ply', 'hm_all_nan.ply']) {
      await open.drop(name, readFileSync(join(data, 'hostile', name)));
      const message = await open.message();
      assert.match(message, /^([^\n]*[^.\n]\.)?$/, name);
      if (message) continue;
      assert.equal(await open.text('name'), name);
      await open.tab.mouse.click(470, 200);
    }
    await open.drop('torus.off', torus());
    assert.equal(await open.message(), '');
  }));

test('ended_worker_is_restored', () => withPage(meshPage, {}, async (open) => {
  const result = await open.run(async () => {
    const engine = geodesicViewer.engines.fast;
    const query = () => engine.ask('distances', [{vertex: 5}], 'exact', Infinity, 60);
    const before = (await query()).result.values;
    const ended = query().then(() => 'answered', (error) => error.message);
    await new Promise((resolve) => setTimeout(resolve, 5));
    engine.restart();
    const after = (await query()).result.values;
    return {sentence: await ended, isEqual: before.every((value, i) => value === after[i])};
  });
  assert.deepEqual(result, {sentence: 'The query was ended, because it took too long.',
                            isEqual: true});
}));

test('results_are_saved', () => withPage(meshPage, {}, async (open) => {
  const [vertex] = await open.visibleVertices(1);
  await open.tab.keyboard.down('Shift');
  await open.clickVertex(vertex);
  await open.tab.keyboard.up('Shift');
  await open.settle();
  const picture = await open.saved(() => open.tab.keyboard.press('s'));
  assert.equal(picture.name, 'torus-distance.png');
  assert.equal(picture.bytes.subarray(1, 4).toString(), 'PNG');
  const values = await open.saved(() => open.tab.keyboard.press('v'));
  const expected = native('distance', mesh, ['--source', vertex], true).lines;
  assert.deepEqual(values.bytes.toString().trim().split('\n').map(Number),
                   expected.map(([value]) => value));
  const ply = await open.saved(() => open.tab.keyboard.press('e'));
  const info = native('info', write('saved.ply', ply.bytes), [], true);
  assert.deepEqual([info.vertices, info.faces], [5000, 10000]);
  assert.deepEqual(info.lines, native('info', mesh, [], true).lines);
  assert.match(ply.bytes.subarray(0, 300).toString(), /property double distance/);
}));

test('keyboard_controls_the_page', () => withPage(meshPage, {}, async (open) => {
  for (const [key, tool] of [['2', 'path'], ['3', 'cells'], ['4', 'samples'], ['5', 'decal'],
                             ['1', 'distance']]) {
    await open.tab.keyboard.press(key);
    assert.equal((await state(open)).tool, tool);
  }
  const camera = () => open.run(() => geodesicViewer.scene.camera.position.toArray());
  const before = await camera();
  await open.tab.focus('#canvas');
  await open.tab.keyboard.press('ArrowLeft');
  assert.notDeepEqual(await camera(), before);
  await open.tab.keyboard.press('r');
  (await camera()).forEach((x, c) => assert.ok(Math.abs(x - before[c]) < 1e-9));
  const [vertex] = await open.visibleVertices(1);
  await open.clickVertex(vertex);
  await open.tab.keyboard.press('Escape');
  assert.equal((await state(open)).sources.length, 0);
  await open.tab.keyboard.press('Control+z');
  assert.equal((await state(open)).sources.length, 1);
  await open.tab.keyboard.press('?');
  assert.equal(await open.run(() => document.getElementById('about').open), true);
  await open.tab.keyboard.press('Escape');
  assert.equal((await state(open)).sources.length, 1);
  await open.tab.focus('[data-tool="distance"]');
  await open.tab.keyboard.press('ArrowRight');
  assert.equal((await state(open)).tool, 'path');
}));

test('phone_is_controlled_by_touch', () =>
  withPage(meshPage, {width: 390, height: 640, isPhone: true}, async (open) => {
    assert.equal(await open.run(() => document.documentElement.scrollWidth <= innerWidth), true);
    const [first] = await open.visibleVertices(1), {x, y} = await open.pixelOf(first);
    await open.tab.touchscreen.tap(x, y);
    await open.settle();
    assert.equal((await state(open)).sources.length, 1);
    assert.match(await open.text('answer'), /^Largest distance/);
    assert.equal(await open.tab.isVisible('#method'), false);
    // A finger drags the point.
    const touch = await open.tab.context().newCDPSession(open.tab);
    const send = (type, points) => touch.send('Input.dispatchTouchEvent', {
      type, touchPoints: points.map(([x, y]) => ({x: Math.round(x), y: Math.round(y)}))});
    const camera = () => open.run(() => geodesicViewer.scene.camera.position.toArray());
    const before = await state(open), view = await camera();
    await send('touchStart', [[x, y]]);
    for (let i = 1; i <= 6; ++i) await send('touchMove', [[x + 4 * i, y + 3 * i]]);
    await send('touchEnd', []);
    await open.settle();
    assert.notDeepEqual((await state(open)).sources, before.sources);
    assert.deepEqual(await camera(), view);
    // Two fingers zoom.
    await send('touchStart', [[150, 150], [200, 200]]);
    for (let i = 1; i <= 6; ++i) await send('touchMove', [[150 - 8 * i, 150], [200 + 8 * i, 200]]);
    await send('touchEnd', []);
    assert.notDeepEqual(await camera(), view);
    await open.tab.tap('#more');
    assert.equal(await open.tab.isVisible('#method'), true);
    await open.tab.tap('[data-tool="path"]');
    assert.equal((await state(open)).tool, 'path');
  }));

test('200_random_operations_cause_no_error', () => withPage(meshPage, {}, async (open) => {
  const random = generator(44), choose = (list) => list[Math.floor(random() * list.length)];
  const keys = ['1', '2', '3', '4', '5', 'z', 'r', 'Escape', '+', '-', '[', ']', 'ArrowLeft',
                'ArrowUp'];
  const position = () => [Math.floor(640 * random()), Math.floor(400 * random())];
  const operations = [
    () => open.tab.keyboard.press(choose(keys)),
    async () => {
      const {x, y} = await open.pixelOf(Math.floor(5000 * random()));
      if (await open.run(({x, y}) => document.elementFromPoint(x, y)?.id === 'canvas', {x, y}))
        await open.tab.mouse.click(x, y, {modifiers: random() < 0.3 ? ['Control'] : []});
    },
    async () => {
      const [x, y] = position();
      await open.tab.mouse.move(Math.max(310, x), y);
      await open.tab.mouse.wheel(0, 200 * random() - 100);
    },
    async () => {
      await open.tab.mouse.move(330 + 300 * random(), 390 * random());
      await open.tab.mouse.down();
      await open.tab.mouse.move(330 + 300 * random(), 390 * random(), {steps: 3});
      await open.tab.mouse.up();
    },
    () => open.run(([id, fraction]) => {
      const slider = document.getElementById(id), min = Number(slider.min);
      slider.value = Math.round(min + fraction * (Number(slider.max) - min));
      slider.dispatchEvent(new Event('input', {bubbles: true}));
      slider.dispatchEvent(new Event('change', {bubbles: true}));
    }, [choose(['limit', 'lines', 'number', 'scale', 'angle']), random()]),
    () => open.run((method) => {
      const select = document.getElementById('method');
      select.value = method;
      select.dispatchEvent(new Event('change'));
    }, choose(['exact', 'euclidean', 'fast-marching', 'heat', 'dijkstra'])),
  ];
  for (let i = 0; i < 200; ++i) await choose(operations)();
  await open.settle();
  assert.equal(await open.message(), '');
  await open.tab.keyboard.press('1');
  await open.tab.keyboard.press('r');
  const [vertex] = await open.visibleVertices(1);
  await open.clickVertex(vertex);
  await open.settle();
  assert.match(await open.text('answer'), /^Largest distance/);
}));
