// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// node compose.mjs BUILD VERSION: writes BUILD/viewer.html from the files of this folder, the
// compiled kernels BUILD/view.js and BUILD/view.wasm, and the packages in BUILD/node_modules.
import {readFile, writeFile} from 'node:fs/promises';
import {createRequire} from 'node:module';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {deflateSync} from 'node:zlib';

const [build, version] = [resolve(process.argv[2]), process.argv[3]];
const sources = dirname(fileURLToPath(import.meta.url));
const {build: bundle} = createRequire(join(build, 'package.json'))('esbuild');

// Returns one script with all scripts that it imports.
async function script(name) {
  const {outputFiles} = await bundle({
    entryPoints: [join(sources, name)], bundle: true, minify: true, write: false, format: 'iife',
    target: 'es2022', legalComments: 'none', logLevel: 'warning',
    nodePaths: [join(build, 'node_modules')], alias: {kernels: join(build, 'view.js')},
    define: {'process.versions.node': 'undefined'}, external: ['fs', 'path', 'perf_hooks'],
  });
  // These texts would end the element of the page, or begin a comment in it.
  return outputFiles[0].text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
}

const escape = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

// Returns the licenses of the packages that the scripts contain.
async function licenses() {
  const texts = await Promise.all(['three', 'three-mesh-bvh'].map(async (name) => {
    const text = await readFile(join(build, 'node_modules', name, 'LICENSE'), 'utf8');
    return `<pre>${name}\n\n${escape(text)}</pre>`;
  }));
  return texts.join('');
}

const parts = {
  version,
  style: await readFile(join(sources, 'style.css'), 'utf8'),
  licenses: await licenses(),
  kernels: deflateSync(await readFile(join(build, 'view.wasm')), {level: 9}).toString('base64'),
  worker: await script('worker.js'),
  script: await script('main.js'),
};
const page = await readFile(join(sources, 'page.html'), 'utf8');
await writeFile(join(build, 'viewer.html'), page.replace(/{{(\w+)}}/g, (_, name) => parts[name]));
