// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

// Seconds after which a query ends itself, and, if it does not, after which its worker is ended.
const deadline = 20;
const patience = 5;

// Runs queries in a worker. If a query takes too long or fails, the worker is replaced by a new
// one, which loads the surface again.
export class Engine {
  // source   the script of the worker
  // module   the compiled kernels
  constructor(source, module) {
    this.url = URL.createObjectURL(new Blob([source], {type: 'text/javascript'}));
    this.module = module;
    this.files = null;
    this.calls = new Map();
    this.nextId = 0;
    this.restart();
  }

  // Loads a surface from files {name, bytes}. The first one can refer to the others. If it cannot
  // be read, the last surface remains.
  async load(files) {
    await this.restored;
    const {result} = await this.call('load', [files], 600);
    this.files = files;
    return result;
  }

  // Returns {result, seconds} of a function of the kernels. Throws an Error with one sentence.
  async ask(name, ...args) {
    await this.restored;
    return this.call(name, args, deadline + patience);
  }

  // Ends the worker with all of its queries.
  end() {
    this.worker?.terminate();
    for (const {reject, timer} of this.calls.values()) {
      clearTimeout(timer);
      reject(new Error('The query was ended, because it took too long.'));
    }
    this.calls.clear();
  }

  // Ends the worker and restores its surface in a new one.
  restart() {
    this.end();
    this.worker = new Worker(this.url);
    this.worker.onmessage = ({data}) => this.receive(data);
    this.restored = this.call('start', [this.module], 600).then(
      () => this.files && this.call('load', [this.files], 600));
    this.restored.catch(() => {});
  }

  call(name, args, seconds) {
    return new Promise((resolve, reject) => {
      const id = this.nextId++;
      const timer = setTimeout(() => this.restart(), 1000 * seconds);
      this.calls.set(id, {resolve, reject, timer});
      this.worker.postMessage({id, name, args});
    });
  }

  receive({id, result, seconds, error, isFatal}) {
    const call = this.calls.get(id);
    if (!call) return;
    this.calls.delete(id);
    clearTimeout(call.timer);
    if (error) call.reject(new Error(error));
    else call.resolve({result, seconds});
    if (isFatal) this.restart();
  }
}

Engine.deadline = deadline;
