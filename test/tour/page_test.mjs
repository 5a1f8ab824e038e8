// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opens the page of the tour from disk in chromium.
// Environment: GEODESIC_TOUR_PACKAGES (the folder with the packages of package.json), GEODESIC_TOUR
// (the page, default: demo/gallery/index.html), CHROMIUM (default: /usr/bin/chromium).
import assert from 'node:assert/strict';
import {existsSync, readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, dirname, join, resolve} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';

const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const page = pathToFileURL(process.env.GEODESIC_TOUR ?? join(root, 'demo/gallery/index.html'));
const require = createRequire(join(resolve(process.env.GEODESIC_TOUR_PACKAGES), 'package.json'));
const {chromium} = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

const desktop = {width: 1280, height: 800};
const phone = {width: 390, height: 844};

// In milliseconds. All pictures are loaded in seconds; on a busy machine, fifty times as long.
const timeout = 180000;

let browser;
before(async () => {
  browser = await chromium.launch({executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
                                   args: ['--no-sandbox']});
});
after(() => browser?.close());

// Opens the page without its viewers, which have tests of their own, and runs a function with its
// tab. Fails if there were errors or requests to the network.
async function withPage(viewport, body) {
  const context = await browser.newContext({viewport, isMobile: viewport === phone,
                                            hasTouch: viewport === phone, reducedMotion: 'reduce',
                                            permissions: ['clipboard-read', 'clipboard-write']});
  context.setDefaultTimeout(timeout);
  const tab = await context.newPage();
  const errors = [];
  tab.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  tab.on('pageerror', (error) => errors.push(error.message));
  tab.on('request', (request) => {
    if (!/^(file|data):/.test(request.url())) errors.push(`request of ${request.url()}`);
  });
  await tab.route(/\/view-[^/]*\.html$/, (route) => route.fulfill({body: ''}));
  await tab.goto(page.href);
  await body(tab);
  assert.deepEqual(errors, []);
  await context.close();
}

// Returns the violations of the rules of axe-core, one line each.
async function violations(tab) {
  await tab.evaluate(axe);
  const result = await tab.evaluate(() => axe.run({iframes: false}));
  assert.ok(result.passes.some(({id}) => id === 'color-contrast'));
  return result.violations.flatMap(({id, help, nodes}) =>
    nodes.map(({target}) => `${id}: ${help}: ${target}`));
}

const isTooWide = (tab) =>
  tab.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);

test('links_point_to_existing_files_and_anchors', () => withPage(desktop, async (tab) => {
  const links = await tab.locator('a').evaluateAll((all) => all.map(({href}) => href));
  assert.ok(links.length > 0);
  const texts = new Map(); // of the files that the links point to
  const broken = [...new Set(links)].filter((link) => {
    const url = new URL(link), anchor = decodeURIComponent(url.hash.slice(1));
    url.hash = '';
    const file = fileURLToPath(url);
    if (!existsSync(file)) return true;
    if (!anchor) return false;
    if (!texts.has(file)) texts.set(file, readFileSync(file, 'utf8'));
    return !texts.get(file).includes(`id="${anchor}"`);
  });
  assert.deepEqual(broken, []);
}));

test('identifiers_are_unique', () => withPage(desktop, async (tab) => {
  const all = await tab.locator('[id]').evaluateAll((elements) => elements.map(({id}) => id));
  assert.deepEqual(all.filter((id, i) => all.indexOf(id) !== i), []);
}));

test('images_are_loaded_and_described', () => withPage(desktop, async (tab) => {
  const images = await tab.locator('main img').evaluateAll((all) => Promise.all(
    all.map(async (image) => {
      image.loading = 'eager';
      await image.decode().catch(() => {});
      return {file: image.src, width: image.naturalWidth, alternative: image.alt.trim()};
    })));
  assert.ok(images.length > 0);
  for (const {file, width, alternative} of images) {
    const name = basename(new URL(file).pathname);
    assert.ok(width > 0, `${name} is not loaded`);
    assert.ok(alternative && !alternative.includes(name), `${name} has no alternative text`);
  }
}));

test('sections_have_two_sentences_and_pictures', () => withPage(desktop, async (tab) => {
  const sections = await tab.locator('main section').evaluateAll((all) => all.map((section) => ({
    id: section.id,
    introduction: section.querySelector('.introduction').textContent,
    number: section.querySelectorAll('figure').length,
  })));
  for (const {id, introduction, number} of sections) {
    assert.match(introduction, /^[^.]+\. [^.]+\.$/, id);
    assert.ok(number > 0, id);
  }
}));

test('contents_list_all_sections', () => withPage(desktop, async (tab) => {
  const entries = await tab.locator('nav a').evaluateAll((all) =>
    all.map((link) => [link.hash.slice(1), link.textContent]));
  const sections = await tab.locator('main section').evaluateAll((all) =>
    all.map((section) => [section.id, section.querySelector('h2').textContent]));
  assert.deepEqual(entries, sections);
}));

test('contents_mark_the_section_on_the_screen', () => withPage(desktop, async (tab) => {
  const last = tab.locator('nav a').last();
  await last.click();
  await tab.waitForFunction(() =>
    document.querySelector('nav li:last-child a').hasAttribute('aria-current'));
  assert.equal(await tab.locator('nav a[aria-current]').count(), 1);
}));

for (const [name, viewport] of Object.entries({desktop, phone})) {
  test(`page_is_accessible_on_${name}`, () => withPage(viewport, async (tab) => {
    assert.deepEqual(await violations(tab), []);
    await tab.locator('.thumbnail').first().click();
    assert.deepEqual(await violations(tab), []);
  }));

  test(`page_does_not_scroll_sideways_on_${name}`, () => withPage(viewport, async (tab) => {
    assert.equal(await isTooWide(tab), false);
    await tab.locator('.thumbnail').first().click();
    assert.equal(await isTooWide(tab), false);
  }));
}

test('contents_close_on_phone_after_a_choice', () => withPage(phone, async (tab) => {
  const link = tab.locator('nav a').nth(1);
  assert.equal(await link.isVisible(), false);
  await tab.locator('nav summary').tap();
  await link.tap();
  assert.equal(await link.isVisible(), false);
  const title = tab.locator('main h2').nth(1), bar = tab.locator('nav');
  const [{y}, {y: top, height}] = [await title.boundingBox(), await bar.boundingBox()];
  assert.ok(y >= top + height && y < phone.height / 2, 'the bar hides the title');
}));

test('buttons_copy_the_command', () => withPage(desktop, async (tab) => {
  await tab.locator('.copy').first().click(); // by the mouse; all in the page, which is faster
  const failures = await tab.evaluate(async () => {
    const failures = [];
    for (const figure of document.querySelectorAll('figure')) {
      await navigator.clipboard.writeText('');
      figure.querySelector('.copy').click();
      const code = figure.querySelector('code').textContent, end = Date.now() + 5000;
      const isCopied = async () => code && await navigator.clipboard.readText() === code;
      while (!await isCopied() && Date.now() < end) await new Promise((go) => setTimeout(go, 10));
      if (!await isCopied()) failures.push(figure.id);
    }
    return failures;
  });
  assert.deepEqual(failures, []);
}));

test('button_says_that_it_copied', () => withPage(desktop, async (tab) => {
  const button = tab.locator('.copy').first();
  await button.click();
  await tab.waitForFunction(() => document.getElementById('status').textContent === 'Copied');
  assert.equal(await button.textContent(), 'Copied');
  await tab.waitForFunction(() => document.querySelector('.copy').textContent === 'Copy');
}));

test('thumbnail_opens_large_and_closes_by_escape', () => withPage(desktop, async (tab) => {
  const thumbnail = tab.locator('.thumbnail').first(), large = tab.locator('dialog img');
  const {width} = await thumbnail.boundingBox();
  await thumbnail.focus();
  await tab.keyboard.press('Enter');
  await large.waitFor();
  assert.ok((await large.boundingBox()).width > 2 * width);
  await tab.keyboard.press('Escape');
  await large.waitFor({state: 'hidden'});
  assert.ok(await thumbnail.evaluate((link) => link === document.activeElement));
}));

test('keys_show_the_next_and_the_previous_picture', () => withPage(desktop, async (tab) => {
  const files = await tab.locator('.thumbnail img').evaluateAll((all) => all.map(({src}) => src));
  const shown = () => tab.locator('dialog img').evaluate(({src}) => src);
  await tab.locator('.thumbnail').first().click();
  await tab.keyboard.press('ArrowRight');
  assert.equal(await shown(), files[1]);
  await tab.keyboard.press('ArrowLeft');
  await tab.keyboard.press('ArrowLeft');
  assert.equal(await shown(), files.at(-1));
  await tab.keyboard.press('Escape');
  const last = tab.locator('.thumbnail').last();
  assert.ok(await last.evaluate((link) => link === document.activeElement));
}));
