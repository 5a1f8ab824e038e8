// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
import {colorOf, shortNumber} from './colors.js';

const element = (id) => document.getElementById(id);

// The panel with the tools and the last result, the legend and the messages.
export class Panel {
  constructor() {
    this.messageTimer = 0;
    const canvas = element('legend').querySelector('canvas');
    const context = canvas.getContext('2d');
    for (let i = 0; i < canvas.width; ++i) {
      const [red, green, blue] = colorOf(i / (canvas.width - 1)).map((x) => Math.round(255 * x));
      context.fillStyle = `rgb(${red}, ${green}, ${blue})`;
      context.fillRect(i, 0, 1, 1);
    }
  }

  showModel(title, points, triangles) {
    element('name').textContent = element('name').title = title;
    const count = (number) => number.toLocaleString('en-US');
    element('size').textContent = triangles > 0 ? `${count(triangles)} faces`
      : `${count(points)} points`;
    document.title = `${title} – Geodesic viewer`;
  }

  showHint(text) { element('hint').textContent = text; }

  // Shows a sentence about the result, and how it was computed.
  showResult(answer, details = '') {
    element('answer').textContent = answer;
    element('time').textContent = details;
  }

  setBusy(isBusy) { document.body.classList.toggle('busy', isBusy); }

  showError(error) {
    element('message').textContent = error.message;
    element('message').hidden = false;
    clearTimeout(this.messageTimer);
    this.messageTimer = setTimeout(() => { element('message').hidden = true; }, 8000);
  }

  // Shows the colors of distances up to `max`. Isolines of meshes and bands of clouds have the
  // width `step`, unless it is zero.
  showLegend(max, step, isMesh) {
    element('legend').hidden = false;
    element('legend-title').textContent =
      step > 0 ? `Distance, ${isMesh ? 'isolines every' : 'bands of'} ${+step.toPrecision(3)}`
        : 'Distance';
    element('legend-ticks').replaceChildren(...[0, 0.25, 0.5, 0.75, 1].map((fraction) => {
      const tick = document.createElement('span');
      tick.style.left = `${100 * fraction}%`;
      tick.textContent = shortNumber(fraction * max);
      return tick;
    }));
  }
  hideLegend() { element('legend').hidden = true; }

  // Shows the state of all controls.
  showState(state, {canUndo, limitText, hasValues}) {
    for (const button of document.querySelectorAll('[data-tool]')) {
      const isChecked = button.dataset.tool === state.tool;
      button.setAttribute('aria-checked', isChecked);
      button.tabIndex = isChecked ? 0 : -1;
    }
    for (const field of document.querySelectorAll('[data-for]'))
      field.hidden = field.dataset.for !== state.tool;
    const set = (id, value, text) => {
      element(id).value = value;
      const output = document.querySelector(`output[for="${id}"]`);
      if (output) output.textContent = text ?? value;
    };
    set('method', state.method);
    set('limit', state.limit, limitText);
    set('lines', state.lines);
    set('number', state.number);
    set('scale', state.decal.width, `${state.decal.width} %`);
    set('angle', state.decal.angle, `${state.decal.angle}°`);
    document.querySelector('[data-action="undo"]').disabled = !canUndo;
    for (const action of ['values', 'ply'])
      document.querySelector(`[data-action="${action}"]`).disabled = !hasValues;
  }

  // Returns the part of the window that the panel does not cover.
  freeArea() {
    const {innerWidth: right, innerHeight: bottom} = window;
    const panel = element('panel').getBoundingClientRect();
    return panel.width > 0.7 * right ? {left: 0, top: 0, right, bottom: panel.top}
      : {left: panel.right, top: 0, right, bottom};
  }
}
