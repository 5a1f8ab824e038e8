// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Copies commands, enlarges pictures and marks the current section in the contents.
'use strict';

const announcement = document.getElementById('status');

for (const button of document.querySelectorAll('.copy'))
  button.addEventListener('click', async () => {
    await navigator.clipboard.writeText(button.closest('figure').querySelector('code').textContent);
    announcement.textContent = 'Copied';
    button.textContent = 'Copied';
    setTimeout(() => {
      announcement.textContent = '';
      button.textContent = 'Copy';
    }, 1500);
  });

const dialog = document.querySelector('dialog');
const thumbnails = [...document.querySelectorAll('.thumbnail')];
let shown = 0; // index of the picture in the dialog

function show(index) {
  shown = (index + thumbnails.length) % thumbnails.length;
  const picture = thumbnails[shown].querySelector('img').cloneNode();
  picture.loading = 'eager';
  dialog.querySelector('.picture').replaceChildren(picture);
  dialog.querySelector('.caption').textContent =
    thumbnails[shown].closest('figure').querySelector('figcaption p').textContent;
}

thumbnails.forEach((thumbnail, index) => thumbnail.addEventListener('click', (event) => {
  if (event.ctrlKey || event.metaKey || event.shiftKey) return; // opens a tab or a window
  event.preventDefault();
  show(index);
  dialog.showModal();
}));
for (const button of dialog.querySelectorAll('[data-step]'))
  button.addEventListener('click', () => show(shown + Number(button.dataset.step)));
dialog.addEventListener('keydown', ({key}) => {
  if (key === 'ArrowLeft') show(shown - 1);
  if (key === 'ArrowRight') show(shown + 1);
});
dialog.addEventListener('click', ({target}) => {
  if (target === dialog) dialog.close(); // the backdrop
});
dialog.addEventListener('close', () => thumbnails[shown].focus());

// On a narrow window, the contents are closed until they are needed.
const contents = document.querySelector('nav details');
const narrow = matchMedia('(max-width: 52rem)');
const adapt = () => { contents.open = !narrow.matches; };
narrow.addEventListener('change', adapt);
adapt();
contents.addEventListener('click', ({target}) => {
  if (target.matches('a')) adapt();
});

// The current section is the last one whose top is above the upper third of the window.
const sections = [...document.querySelectorAll('section')];
function markCurrent() {
  const current = sections.findLast((s) => s.getBoundingClientRect().top < innerHeight / 3);
  for (const link of document.querySelectorAll('nav a'))
    link.toggleAttribute('aria-current', link.hash === `#${current?.id}`);
}
addEventListener('scroll', markCurrent, {passive: true});
markCurrent();
