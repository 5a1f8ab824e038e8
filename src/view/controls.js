// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
import {decalImage} from './Scene.js';
import {isImage, plyFile, readFiles, save, valuesText} from './files.js';
import {readImage} from './image.js';

const clickDistance = 6; // CSS pixels that a pointer may move during a click
const grabDistance = {mouse: 14, pen: 18, touch: 28}; // from a marker that the pointer grabs

const element = (id) => document.getElementById(id);
const tools = ['distance', 'path', 'cells', 'samples', 'decal'];

// Returns the part of a picked location that a state stores.
const toPlace = ({face, weights, vertex, point, normal}) =>
  ({face, weights, vertex, point: point.toArray(), normal: normal.toArray()});

// Connects the mouse, the keyboard, the controls of the panel and dropped files to a viewer.
export function connectControls(viewer) {
  connectPointer(viewer);
  connectFields(viewer);
  connectActions(viewer);
  connectKeys(viewer);
  connectFiles(viewer);
}

// Runs an action of the user and shows its error.
async function run(viewer, action) {
  try {
    await action();
  } catch (error) {
    viewer.panel.showError(error);
  }
}

// A click adds a point; a point or a decal can be dragged. Everything else rotates the view.
function connectPointer(viewer) {
  const {scene} = viewer, canvas = scene.canvas;
  const pointers = new Set();
  let press = null;

  const pick = ({offsetX, offsetY, shiftKey}) => {
    const hit = scene.pick(offsetX, offsetY);
    return hit && toPlace(shiftKey ? scene.snap(hit) : hit);
  };
  // Returns the index of the point that the pointer grabs, or -1.
  const grabbed = (event) => {
    const reach = grabDistance[event.pointerType] ?? grabDistance.mouse;
    const index = viewer.places().findIndex(({point}) => {
      const {x, y, isVisible} = scene.project(scene.vector(point));
      return isVisible && Math.hypot(x - event.offsetX, y - event.offsetY) < reach;
    });
    return index < 0 && viewer.isOnDecal(pick(event)) ? 0 : index;
  };

  canvas.addEventListener('pointerdown', (event) => {
    pointers.add(event.pointerId);
    if (pointers.size > 1 || event.button !== 0) {
      press = null; // a gesture of two fingers, or another button
      scene.controls.enabled = true;
      return;
    }
    const index = viewer.isLoaded ? grabbed(event) : -1;
    press = {x: event.offsetX, y: event.offsetY, index, isMoved: false};
    scene.controls.enabled = index < 0;
    if (index >= 0) canvas.setPointerCapture(event.pointerId);
  }, {capture: true});

  canvas.addEventListener('pointermove', (event) => {
    if (!press) {
      if (pointers.size === 0 && viewer.isLoaded && event.pointerType === 'mouse')
        canvas.style.cursor = grabbed(event) >= 0 ? 'grab' : 'default';
      return;
    }
    const isFirst = !press.isMoved;
    if (isFirst && Math.hypot(event.offsetX - press.x, event.offsetY - press.y) < clickDistance)
      return;
    press.isMoved = true;
    if (press.index < 0) return;
    const place = pick(event);
    if (place) {
      viewer.movePlace(press.index, place, {isMoving: true, record: !press.isRecorded});
      press.isRecorded = true;
    }
  });

  const release = (event) => {
    pointers.delete(event.pointerId);
    scene.controls.enabled = true;
    const last = press;
    press = null;
    if (!last || event.type === 'pointercancel' || !viewer.isLoaded) return;
    if (last.isMoved) {
      if (last.isRecorded) viewer.update();
      return;
    }
    if (last.index >= 0 && viewer.state.tool !== 'decal') return;
    const place = pick(event);
    if (place && viewer.state.tool !== 'samples')
      viewer.addPlace(place, event.ctrlKey || event.metaKey);
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
}

// The fields of the panel.
function connectFields(viewer) {
  const edits = {
    limit: (state, value) => { state.limit = value; },
    lines: (state, value) => { state.lines = value; },
    number: (state, value) => { state.number = value; },
    scale: (state, value) => { state.decal.width = value; },
    angle: (state, value) => { state.decal.angle = value; },
  };
  for (const [id, edit] of Object.entries(edits)) {
    let isMoving = false;
    element(id).addEventListener('input', ({target}) => {
      viewer.change((state) => edit(state, Number(target.value)),
                    {isMoving: true, record: !isMoving});
      isMoving = true;
    });
    element(id).addEventListener('change', () => {
      isMoving = false;
      viewer.update();
    });
  }
  element('method').addEventListener('change', ({target}) =>
    viewer.change((state) => { state.method = target.value; }));
  for (const button of document.querySelectorAll('[data-tool]'))
    button.addEventListener('click', () => setTool(viewer, button.dataset.tool));
  element('tools').addEventListener('keydown', (event) => {
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (!step) return;
    event.preventDefault();
    const tool = tools.at((tools.indexOf(viewer.state.tool) + step) % tools.length);
    setTool(viewer, tool);
    document.querySelector(`[data-tool="${tool}"]`).focus();
  });
  element('more').addEventListener('click', ({target}) => {
    const isOpen = element('details').classList.toggle('open');
    target.setAttribute('aria-expanded', isOpen);
    viewer.scene.resize();
  });
}

function setTool(viewer, tool) {
  if (tool === viewer.state.tool) return;
  viewer.scene.clear();
  viewer.panel.hideLegend();
  viewer.panel.showResult('');
  viewer.change((state) => { state.tool = tool; });
}

const actions = {
  undo: (viewer) => viewer.undo(),
  reset: (viewer) => viewer.scene.resetView(),
  open: () => element('file').click(),
  about: () => element('about').showModal(),
  clear: (viewer) => viewer.clearPoints(),
  picture: async (viewer) => save(baseName(viewer) + '.png', await viewer.scene.picture()),
  ply: (viewer) => {
    if (viewer.isLoaded)
      save(baseName(viewer) + '.ply',
           plyFile(viewer.surface, viewer.values?.name, viewer.values?.array));
  },
  values: (viewer) => {
    const text = viewer.resultText();
    if (text) save(baseName(viewer) + '.txt', text);
  },
};

// Returns the name of the surface's file without its extension.
function baseName({title, state}) {
  return `${title.replace(/\.[^.]*$/, '') || 'surface'}-${state.tool}`;
}

function connectActions(viewer) {
  for (const button of document.querySelectorAll('[data-action]'))
    button.addEventListener('click',
                            () => run(viewer, () => actions[button.dataset.action](viewer)));
}

function connectKeys(viewer) {
  const keys = {z: 'undo', r: 'reset', o: 'open', s: 'picture', e: 'ply', v: 'values', '?': 'about',
                h: 'about', Escape: 'clear'};
  const decalKeys = {'+': ['width', 2, 2, 80], '-': ['width', -2, 2, 80],
                     '[': ['angle', 5, -180, 180], ']': ['angle', -5, -180, 180]};
  const turns = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  document.addEventListener('keydown', (event) => {
    const isField = event.target.matches('input, select');
    if (element('about').open || event.altKey || (isField && event.key !== 'Escape')) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if ((event.ctrlKey || event.metaKey) && key !== 'z') return;
    if (turns[key] && event.target === viewer.scene.canvas) viewer.scene.turn(...turns[key]);
    else if (keys[key]) run(viewer, () => actions[keys[key]](viewer));
    else if (tools[key - 1]) setTool(viewer, tools[key - 1]);
    else if (decalKeys[key] && viewer.state.tool === 'decal') {
      const [name, step, min, max] = decalKeys[key];
      viewer.change((state) => {
        state.decal[name] = Math.min(max, Math.max(min, state.decal[name] + step));
      });
    } else return;
    event.preventDefault();
  });
}

// Files are dropped or chosen: an image for the decal, or a surface.
function connectFiles(viewer) {
  const open = (files) => run(viewer, async () => {
    if (files.length === 0) return;
    if (files.length === 1 && isImage(files[0])) {
      viewer.setImage(decalImage(await readImage(files[0])), files[0].name);
      return;
    }
    const read = await readFiles(files);
    // A glTF file refers to the others.
    const isGltf = ({name}) => name.toLowerCase().endsWith('.gltf');
    read.sort((a, b) => isGltf(b) - isGltf(a));
    await viewer.open(read);
  });
  for (const id of ['file', 'image-file'])
    element(id).addEventListener('change', ({target}) => {
      open([...target.files]);
      target.value = '';
    });
  element('choose-image').addEventListener('click', () => element('image-file').click());
  let depth = 0; // of nested elements that the dragged file has entered
  addEventListener('dragenter', () => { element('drop').hidden = ++depth === 0; });
  addEventListener('dragleave', () => { element('drop').hidden = --depth === 0; });
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', (event) => {
    event.preventDefault();
    depth = 0;
    element('drop').hidden = true;
    open([...event.dataTransfer.files]);
  });
}
