// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The worker: runs the kernels. Each message {id, name, args} is a call of one of the functions in
// bindings.cpp, or of `start` or `load`. The answer is {id, result, seconds} or {id, error}.
import createKernels from 'kernels';
import {decompressSync} from 'three/examples/jsm/libs/fflate.module.js';

let kernels = null;

// Decompresses data in the zlib or gzip format inside of a file. Returns null if they are invalid
// or expand too much.
function inflate(bytes, maxSize) {
  try {
    const result = decompressSync(bytes);
    return result.length <= maxSize ? result : null;
  } catch {
    return null;
  }
}

async function start(module) {
  kernels = await createKernels({
    inflate,
    print() {},
    printErr() {},
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module));
      return {};
    },
  });
  return {};
}

// Reads the first of several files. It can refer to the others.
function load(files) {
  for (const {name, bytes} of files) kernels.FS.writeFile(name, bytes);
  try {
    return kernels.load(files[0].name);
  } finally {
    for (const {name} of files) kernels.FS.unlink(name);
  }
}

// Returns the buffers of all typed arrays in an object, which can be moved to the page.
function buffers(object) {
  return Object.values(object).filter(ArrayBuffer.isView).map((array) => array.buffer);
}

self.onmessage = async ({data: {id, name, args}}) => {
  try {
    const begin = performance.now();
    const result = name === 'start' ? await start(...args)
      : name === 'load' ? load(...args) : kernels[name](...args);
    const seconds = (performance.now() - begin) / 1000;
    if (result.error) self.postMessage({id, error: result.error});
    else self.postMessage({id, result, seconds}, buffers(result));
  } catch (error) {
    // The memory of the kernels may be damaged, so the page starts a new worker.
    self.postMessage({id, error: 'The computation failed in this browser.', isFatal: true,
                      cause: String(error)});
  }
};
