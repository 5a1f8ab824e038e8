// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

// Five colors of the map viridis, which color-blind readers can distinguish and whose lightness
// increases steadily. The program draws its pictures with the same ones.
export const viridis = [[0.267, 0.005, 0.329], [0.230, 0.322, 0.546], [0.128, 0.567, 0.551],
                        [0.369, 0.789, 0.383], [0.993, 0.906, 0.144]];
export const surfaceColor = [0.80, 0.83, 0.86];
export const unreachedColor = [0.62, 0.65, 0.68];

// Returns the color of a value in [0, 1].
export function colorOf(value) {
  const position = 4 * Math.min(1, Math.max(0, value));
  const k = Math.min(3, Math.floor(position));
  return viridis[k].map((low, c) => low + (position - k) * (viridis[k + 1][c] - low));
}

// Returns the color of a label. Hues at multiples of the golden ratio stay well separated for any
// number of labels. Lightness alternates, so that the cells also differ without hues.
export function colorOfLabel(label) {
  if (label === 0xffffffff) return unreachedColor;
  const hue = 6 * ((0.08 + 0.6180339887498949 * label) % 1);
  const value = label % 3 === 2 ? 0.70 : 0.94, saturation = label % 2 === 1 ? 0.34 : 0.56;
  return [5, 3, 1].map((shift) => {
    const k = (shift + hue) % 6;
    return value * (1 - saturation * Math.min(1, Math.max(0, Math.min(k, 4 - k))));
  });
}

// Returns the distance between isolines: 1, 2, 2.5 or 5 times a power of ten, such that about
// `number` lines fit into [0, max].
export function isolineStep(max, number) {
  if (!(max > 0) || number < 1) return 0;
  const wanted = max / number, power = 10 ** Math.floor(Math.log10(wanted));
  return power * ([1, 2, 2.5, 5, 10].find((factor) => factor * power >= 0.8 * wanted) ?? 10);
}

// Returns a number with three or four digits.
export function shortNumber(value) {
  if (value === 0) return '0';
  const size = Math.floor(Math.log10(Math.abs(value)));
  return size >= -3 && size < 6 ? value.toFixed(Math.max(0, 3 - Math.max(0, size)))
    : value.toExponential(2);
}
