// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
import {Engine} from './Engine.js';
import {Scene} from './Scene.js';
import {Viewer} from './Viewer.js';
import {decompress, fromBase64} from './files.js';
import {connectControls} from './controls.js';
import {Panel} from './Panel.js';

const element = (id) => document.getElementById(id);

async function compileKernels() {
  const bytes = await decompress(fromBase64(element('kernels').textContent), 'deflate');
  return WebAssembly.compile(bytes);
}

// Returns the model that the page contains, or null.
async function embeddedModel() {
  const {textContent, dataset} = element('model');
  if (!dataset.name) return null;
  const bytes = await decompress(fromBase64(textContent), 'deflate');
  element('model').textContent = ''; // frees its memory
  return {title: dataset.name, files: [{name: 'model.ply', bytes}]};
}

async function main() {
  const panel = new Panel();
  try {
    const [module, model] = await Promise.all([compileKernels(), embeddedModel()]);
    const source = element('worker').textContent;
    const viewer = new Viewer(new Scene(element('canvas')), panel,
                              () => new Engine(source, module));
    connectControls(viewer);
    window.geodesicViewer = viewer; // for scripts that control the page
    if (model) await viewer.open(model.files, model.title);
    viewer.secondsToOpen = performance.now() / 1000;
    document.documentElement.dataset.ready = 'yes';
  } catch (error) {
    panel.showError(error);
  }
}

main();
