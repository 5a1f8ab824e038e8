// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
import {Vector3} from 'three';
import {Engine} from './Engine.js';
import {decalImage} from './Scene.js';
import {isolineStep, shortNumber} from './colors.js';
import {valuesText} from './files.js';
import {defaultImage} from './image.js';

const restTime = 220; // milliseconds without a movement until the exact method answers
const maxUndo = 200;

const methodNames = {
  'exact': 'Exact', 'euclidean': 'Euclidean front', 'fast-marching': 'Fast marching',
  'heat': 'Heat', 'dijkstra': 'Dijkstra',
};

const hints = {
  distance: 'Click on the surface to see the distances from a point. Drag the point to move it.',
  path: ['Click on the surface where the path starts.', 'Click where the path ends.',
         'Drag an end of the path, or click to start another path.'],
  cells: 'Click to add seeds. The points of a cell are closer to its seed than to the others.',
  samples: 'Move the slider. Each sample is as far as possible from the samples before it.',
  decal: 'Click on the surface to place the image, then drag it. Drop another image to use it.',
};

const initialState = () => ({
  tool: 'distance', method: 'exact', limit: 100, lines: 20, number: 40,
  sources: [], ends: [], seeds: [],
  decal: {center: null, up: null, width: 25, angle: 0},
});

const plural = (number, one, many = `${one}s`) =>
  `${number.toLocaleString('en-US')} ${number === 1 ? one : many}`;
const time = (seconds) => seconds < 0.9995 ? `${Math.max(1, Math.round(1000 * seconds))} ms`
  : `${seconds.toFixed(2)} s`;

// The state of the page: the tool and its points, the queries that they need, and the results.
//
// While a point moves, only the newest of the queries that wait is sent. Fast queries have a worker
// of their own, so that they need not wait until an exact one ends.
export class Viewer {
  constructor(scene, panel, startEngine) {
    this.scene = scene;
    this.panel = panel;
    this.startEngine = startEngine;
    this.engines = {fast: startEngine(), slow: null};
    this.state = initialState();
    this.history = [];
    this.image = decalImage(defaultImage());
    this.values = null; // {name, array}: the last result, one value for each vertex
    this.path = null; // {points, length}: the last path
    this.title = '';
    this.revision = 0; // of the state: results of older ones are dropped
    this.slowRevision = 0; // of the last slow answer that was shown
    this.running = {}; // promises of the queries that the fast and the slow worker answer
    this.waiting = {}; // whether another query follows them
    this.scene.onResize = () => panel.freeArea();
    this.scene.resize();
    this.refresh();
  }

  get isLoaded() { return this.scene.surface !== null; }

  // ---- Surfaces

  // Opens a surface from files {name, bytes}. If it cannot be read, the last surface remains.
  async open(files, title = files[0].name) {
    this.panel.setBusy(true);
    try {
      const surface = await this.engines.fast.load(files);
      this.engines.slow?.end();
      this.engines.slow = null;
      this.files = files;
      this.title = title;
      this.surface = surface;
      this.revision++;
      this.history = [];
      const {tool, method, lines, number} = this.state;
      this.state = {...initialState(), tool, lines, number,
                    method: surface.isMesh ? method : 'euclidean'};
      this.values = null;
      this.scene.load(surface);
      this.panel.showModel(title, surface.points.length / 3, surface.triangles.length / 3);
      document.querySelector('#method option[value="exact"]').disabled = !surface.isMesh;
      const size = surface.points.length / 3;
      this.panel.showResult(surface.isMesh ? plural(size, 'vertex', 'vertices')
        : plural(size, 'point'), surface.isRepaired ? 'The surface was repaired.' : '');
      this.update();
    } finally {
      this.panel.setBusy(false);
    }
  }

  // Returns the worker of slow queries, and starts it when it is first needed.
  async slowEngine() {
    if (!this.engines.slow) {
      const engine = this.startEngine();
      this.engines.slow = engine;
      try {
        await engine.load(this.files);
      } catch (error) {
        engine.end();
        if (this.engines.slow === engine) this.engines.slow = null;
        throw error;
      }
    }
    return this.engines.slow;
  }

  setImage(image, name) {
    this.image = image;
    this.imageName = name;
    if (this.state.tool === 'decal') this.update();
    else this.change((state) => { state.tool = 'decal'; });
  }

  // Returns whether a location is close to the center of the decal, where it can be grabbed.
  isOnDecal(place) {
    const {tool, decal} = this.state;
    return tool === 'decal' && decal.center !== null && place !== null &&
      Math.hypot(...place.point.map((x, c) => x - decal.center.point[c])) < decal.width / 100;
  }

  // Returns the result as the program writes it by --values, or an empty text.
  resultText() {
    if (this.values) return valuesText(this.values.array);
    if (!this.path) return '';
    const lines = [];
    for (let i = 0; i < this.path.points.length; i += 3)
      lines.push(this.path.points.slice(i, i + 3).join(' ') + '\n');
    return lines.join('');
  }

  // ---- States

  // Changes the state by a function. `isMoving` is true while a point or a slider moves, and
  // `record` is false after the first change of a movement: undo skips the states between.
  change(edit, {isMoving = false, record = true} = {}) {
    if (record) {
      this.history.push(structuredClone(this.state));
      if (this.history.length > maxUndo) this.history.shift();
    }
    edit(this.state);
    this.update(isMoving);
  }

  undo() {
    if (this.history.length === 0) return;
    this.state = this.history.pop();
    this.update();
  }

  clearPoints() {
    const {sources, ends, seeds, decal} = this.state;
    if (sources.length + ends.length + seeds.length > 0 || decal.center)
      this.change((state) => {
        state.sources = [];
        state.ends = [];
        state.seeds = [];
        state.decal.center = null;
      });
  }

  // Returns the points of the tool.
  places() {
    const {tool, sources, ends, seeds, decal} = this.state;
    return {distance: sources, path: ends, cells: seeds, samples: [],
            decal: decal.center ? [decal.center] : []}[tool];
  }

  // Adds a point, as a click does. `isFurther` adds a source to the others.
  addPlace(place, isFurther = false) {
    this.change((state) => {
      const {tool, sources, ends} = state;
      if (tool === 'distance') state.sources = isFurther ? [...sources, place] : [place];
      if (tool === 'path') state.ends = ends.length < 2 ? [...ends, place] : [place];
      if (state.tool === 'cells') state.seeds = [...state.seeds, place];
      if (state.tool === 'decal') {
        state.decal.center = place;
        state.decal.up ??= this.scene.upDirection().toArray();
      }
    });
  }

  movePlace(index, place, options) {
    this.change((state) => {
      if (state.tool === 'decal') state.decal.center = place;
      else this.places()[index] = place;
    }, options);
  }

  // ---- Queries

  refresh() {
    const {tool, ends, limit} = this.state;
    this.panel.showState(this.state, {
      canUndo: this.history.length > 0,
      limitText: limit < 100 ? shortNumber(this.limit()) : 'none',
      hasValues: this.isLoaded,
    });
    this.panel.showHint(!this.isLoaded ? 'Drop a mesh or a point cloud here, or press Open.'
      : tool === 'path' ? hints.path[ends.length] : hints[tool]);
  }

  // Returns the maximum distance of the slider: a fraction of the surface's diagonal, in steps that
  // grow with the fraction.
  limit() {
    const {limit} = this.state;
    return limit < 100 ? 3 * this.scene.scale * (limit / 100) ** 2 : Infinity;
  }

  // Shows the state, and sends the queries that it needs.
  update(isMoving = false) {
    this.refresh();
    if (!this.isLoaded) return;
    this.revision++;
    clearTimeout(this.restTimer);
    this.scene.showMarkers(this.places().map(({point}) => new Vector3(...point)));
    if (!this.hasQuery()) {
      this.values = this.path = null;
      this.scene.clear();
      this.panel.hideLegend();
      this.panel.setBusy(false);
      return;
    }
    this.panel.setBusy(true);
    if (this.isSlow()) {
      // The answer of the front is shown until the exact one is known.
      if (this.hasPreview()) this.send('fast');
      if (isMoving) this.restTimer = setTimeout(() => this.send('slow'), restTime);
      else this.send('slow');
    } else
      this.send('fast');
  }

  hasQuery() { return this.state.tool === 'samples' || this.places().length > 0; }

  // Returns whether the query of the state can take long.
  isSlow() {
    const {tool, method, ends} = this.state;
    return tool === 'distance' ? method !== 'euclidean'
      : tool === 'path' ? ends.length > 1 && this.scene.isMesh : tool !== 'decal';
  }
  hasPreview() { return this.state.tool === 'distance' || this.state.tool === 'path'; }

  // Sends the query of the state to a worker. If the worker is busy, the query is sent when the
  // worker has answered, unless the state changes before.
  send(speed) {
    if (this.running[speed]) {
      this.waiting[speed] = true;
      return;
    }
    this.waiting[speed] = false;
    const revision = this.revision;
    this.running[speed] = this.answer(speed, revision)
      .catch((error) => {
        if (revision === this.revision) this.panel.showError(error);
      })
      .finally(() => {
        this.running[speed] = null;
        if (this.waiting[speed]) this.send(speed);
        if (!this.isBusy()) this.panel.setBusy(false);
      });
  }

  isBusy() { return Boolean(this.running.fast || this.running.slow); }

  // Waits until all queries of the state are answered.
  async settle() {
    do {
      await new Promise((resolve) => setTimeout(resolve, restTime + 30));
      while (this.isBusy()) await (this.running.fast ?? this.running.slow);
    } while (this.isBusy());
  }

  async answer(speed, revision) {
    const engine = speed === 'fast' ? this.engines.fast : await this.slowEngine();
    const state = structuredClone(this.state);
    const {surface} = this;
    // Returns whether the answer is shown. Fast answers that arrive after a slow one are not.
    const isCurrent = () => {
      if (surface !== this.surface) return false;
      if (speed === 'fast')
        return state.tool === this.state.tool && this.hasQuery() && this.slowRevision < revision;
      if (revision !== this.revision) return false;
      this.slowRevision = revision;
      return true;
    };
    const query = {distance: 'answerDistance', path: 'answerPath', cells: 'answerCells',
                   samples: 'answerSamples', decal: 'answerDecal'}[state.tool];
    await this[query](engine, state, speed, isCurrent);
  }

  async answerDistance(engine, state, speed, isCurrent) {
    const method = speed === 'fast' ? 'euclidean' : state.method;
    const {result: {values}, seconds} = await engine.ask(
      'distances', state.sources.map(toQuery), method, this.limit(), Engine.deadline);
    if (!isCurrent()) return;
    let max = 0, reached = 0;
    for (const value of values)
      if (value < Infinity) {
        reached++;
        if (value > max) max = value;
      }
    const step = isolineStep(max, state.lines);
    this.values = {name: 'distance', array: values};
    this.scene.showValues(values, max, step);
    this.panel.showLegend(max, step, this.scene.isMesh);
    const unreached = values.length - reached;
    this.panel.showResult(`Largest distance ${shortNumber(max)}`,
      `${methodNames[method]}, ${time(seconds)}` +
      (unreached > 0 ? `, ${unreached.toLocaleString('en-US')} not reached` : ''));
    if (speed === 'slow' && this.scene.isMesh && step > 0) {
      const levels = Array.from({length: Math.floor(max / step)}, (_, i) => (i + 1) * step);
      const {result} = await engine.ask('isolines', values, levels);
      if (isCurrent()) this.scene.showIsolines(result);
    }
  }

  async answerPath(engine, state, speed, isCurrent) {
    if (state.ends.length < 2) {
      this.scene.clear();
      this.scene.showMarkers(state.ends.map(({point}) => new Vector3(...point)));
      return;
    }
    const [from, to] = state.ends.map(toQuery);
    const {result: {points, length}, seconds} =
      await engine.ask('path', from, to, speed === 'slow');
    if (!isCurrent()) return;
    this.panel.hideLegend();
    this.values = null;
    this.path = {points, length};
    this.scene.setMode(0);
    this.scene.showPath(points);
    if (points.length === 0) this.panel.showResult('There is no path between these points.');
    else this.panel.showResult(`Length ${shortNumber(length)}`,
      `${speed === 'slow' || !this.scene.isMesh ? 'Shortest path' : 'Locally shortest path'}, ` +
      time(seconds));
  }

  async answerCells(engine, state, speed, isCurrent) {
    const {result, seconds} =
      await engine.ask('voronoi', state.seeds.map(toQuery), Engine.deadline);
    if (!isCurrent()) return;
    this.showCells(result);
    this.panel.showResult(plural(state.seeds.length, 'cell'), `Voronoi diagram, ${time(seconds)}`);
  }

  async answerSamples(engine, state, speed, isCurrent) {
    const {result, seconds} = await engine.ask('samples', state.number, Engine.deadline);
    if (!isCurrent()) return;
    const local = this.scene.toLocal(result.points);
    const points = result.places.map((_, i) => new Vector3().fromArray(local, 3 * i));
    const cells = await engine.ask('voronoi', result.places, Engine.deadline);
    if (!isCurrent()) return;
    this.showCells(cells.result);
    this.scene.showMarkers(points, points.length > 150 ? 0.45 : 0.65);
    this.panel.showResult(`Covering radius ${shortNumber(result.radii.at(-1))}`,
      `${plural(points.length, 'sample')}, ${time(seconds)}`);
  }

  showCells(cells) {
    this.scene.clear();
    this.scene.showMarkers(this.places().map(({point}) => new Vector3(...point)));
    this.panel.hideLegend();
    this.values = {name: 'label', array: Float64Array.from(cells.labels, (label) =>
      label === 0xffffffff ? -1 : label)};
    this.scene.showCells(cells);
  }

  async answerDecal(engine, state, speed, isCurrent) {
    const {center, up, width, angle} = state.decal;
    const size = width / 100 * 2 * this.scene.scale, height = size / this.image.aspect;
    const rotated = new Vector3(...up).applyAxisAngle(new Vector3(...center.normal).normalize(),
                                                      angle * Math.PI / 180);
    const {result, seconds} =
      await engine.ask('decal', toQuery(center), rotated.toArray(), size, height);
    if (!isCurrent()) return;
    this.panel.hideLegend();
    this.values = null;
    this.scene.setMode(0);
    this.scene.showDecal(result, this.image);
    this.panel.showResult(this.scene.isMesh ? plural(result.faces.length, 'face')
      : plural(result.vertices.length, 'point'), `Image placed in ${time(seconds)}`);
  }
}

// Returns the location of a query: without what only the scene needs.
function toQuery({face, weights, vertex}) {
  return vertex === undefined ? {face, weights} : {vertex};
}
