// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opens the page of a model in chromium, and runs the native program on the same model.
// Environment: GEODESIC_VIEWER (the folder with viewer.html and the packages of its scripts),
// GEODESIC_PROCESSING_PROGRAM (the native program), CHROMIUM (default: /usr/bin/chromium).
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';

const viewerFolder = resolve(process.env.GEODESIC_VIEWER);
const program = resolve(process.env.GEODESIC_PROCESSING_PROGRAM);
const {chromium} = createRequire(join(viewerFolder, 'package.json'))('playwright-core');

// In milliseconds. A page opens in a second; on a busy machine it takes fifty times as long.
const timeout = 180000;

export const folder = mkdtempSync(join(tmpdir(), 'viewer-'));

let browser = null;

// Software rendering: tests run without a graphics processor.
export async function startBrowser() {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
           '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
  });
}

export async function stopBrowser() {
  await browser?.close();
  rmSync(folder, {recursive: true});
}

export function write(name, content) {
  const file = join(folder, name);
  writeFileSync(file, content);
  return file;
}

// Runs the native program with one thread. Returns its JSON, and the numbers of --values if
// `values` is given.
export function native(command, model, options, values = false) {
  const output = join(folder, 'values.txt');
  const json = execFileSync(program, [command, model, ...options, '--json', '--threads', '1',
                                      ...(values ? ['--values', output] : [])]);
  const result = JSON.parse(json);
  if (values)
    result.lines = readFileSync(output, 'utf8').trim().split('\n').map((line) =>
      line.split(' ').map((word) => word === 'inf' ? Infinity : Number(word)));
  return result;
}

// Writes the page of a model by the program. Returns its file.
export function page(model) {
  const file = model + '.html';
  native('view', model, ['-o', file]);
  return file;
}

// A page that is open in the browser. Errors in its console are collected.
export class Page {
  static async open(file, {width = 640, height = 400, isPhone = false} = {}) {
    const context = await browser.newContext({viewport: {width, height}, hasTouch: isPhone,
                                              isMobile: isPhone, acceptDownloads: true});
    const page = new Page();
    page.errors = [];
    page.tab = await context.newPage();
    page.tab.setDefaultTimeout(timeout);
    page.tab.on('console', (message) => {
      if (message.type() === 'error') page.errors.push(message.text());
    });
    page.tab.on('pageerror', (error) => page.errors.push(error.message));
    page.tab.on('request', (request) => {
      if (!/^(file|data|blob):/.test(request.url()))
        page.errors.push(`request of ${request.url()}`);
    });
    await page.tab.goto('file://' + file);
    await page.tab.waitForFunction(() => document.documentElement.dataset.ready);
    return page;
  }

  // Fails if there were errors, and closes the page.
  async close() {
    assert.deepEqual(this.errors, []);
    await this.tab.context().close();
  }

  // Runs a function of the page.
  run(f, argument) { return this.tab.evaluate(f, argument); }

  // Returns the result of a query. Typed arrays become arrays.
  ask(...query) {
    return this.run(async (query) => {
      const {result} = await geodesicViewer.engines.fast.ask(...query);
      return Object.fromEntries(Object.entries(result).map(
        ([name, value]) => [name, ArrayBuffer.isView(value) ? Array.from(value) : value]));
    }, query);
  }

  async settle() { await this.run(() => geodesicViewer.settle()); }
  text(id) { return this.run((id) => document.getElementById(id).textContent, id); }
  message() {
    return this.run(() => {
      const {hidden, textContent} = document.getElementById('message');
      return hidden ? '' : textContent;
    });
  }

  // Returns the pixel of a vertex on the screen, and whether it is visible.
  pixelOf(vertex) {
    return this.run((vertex) => {
      const {scene} = geodesicViewer;
      return scene.project(scene.position(vertex));
    }, vertex);
  }

  // Returns vertices whose pixels are visible and not close to a silhouette, spread over the
  // surface.
  visibleVertices(count) {
    return this.run((count) => {
      const {scene} = geodesicViewer, size = scene.points.length / 3, result = [];
      const isFacing = ({normal}) => normal.angleTo(scene.camera.position) < 0.9;
      for (let i = 0; i < size && result.length < count; ++i) {
        const vertex = (i * 997) % size, {x, y} = scene.project(scene.position(vertex));
        const element = document.elementFromPoint(x, y), hit = scene.pick(x, y);
        if (element === scene.canvas && hit && isFacing(hit) &&
            hit.point.distanceTo(scene.position(vertex)) < 0.02) result.push(vertex);
      }
      return result;
    }, count);
  }

  async clickVertex(vertex, options) {
    const {x, y} = await this.pixelOf(vertex);
    await this.tab.mouse.click(x, y, options);
  }

  // Returns the colors (red, green, blue from 0 to 255) at pixels of the canvas.
  colors(pixels) {
    return this.run(async (pixels) => {
      const {scene} = geodesicViewer;
      const bitmap = await createImageBitmap(await scene.picture());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const ratio = bitmap.width / scene.width;
      return pixels.map(({x, y}) => Array.from(
        context.getImageData(Math.round(x * ratio), Math.round(y * ratio), 1, 1).data.slice(0, 3)));
    }, pixels);
  }

  // Drops a file on the page and waits until it was opened or rejected.
  async drop(name, bytes, type = '') {
    await this.run(({name, bytes, type}) => {
      document.getElementById('message').hidden = true;
      const transfer = new DataTransfer();
      transfer.items.add(new File([new Uint8Array(bytes)], name, {type}));
      dispatchEvent(new DragEvent('drop', {dataTransfer: transfer, cancelable: true}));
    }, {name, bytes: Array.from(typeof bytes === 'string' ? Buffer.from(bytes) : bytes), type});
    const title = name.replace(/\.gz$/, '');
    await this.tab.waitForFunction((title) => !document.getElementById('message').hidden ||
      geodesicViewer.title === title || geodesicViewer.imageName === title, title);
    await this.settle();
  }

  // Presses a key or clicks, and returns the bytes and the name of the file that the page saves.
  async saved(action) {
    const [download] = await Promise.all([this.tab.waitForEvent('download'), action()]);
    const file = join(folder, 'download');
    await download.saveAs(file);
    return {name: download.suggestedFilename(), bytes: readFileSync(file)};
  }
}
