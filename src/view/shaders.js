// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
import {surfaceColor, unreachedColor, viridis} from './colors.js';

const vec3 = (color) => `vec3(${color.map((x) => x.toFixed(3)).join(', ')})`;

// Returns a statement that moves a vertex towards the camera by a fraction of its distance, without
// a change of its position on the screen.
export const towardsCamera = (fraction) =>
  `gl_Position.z += ${fraction} * projectionMatrix[3][2];`;

// Colors of values and light, for triangles and disks.
const common = `
vec3 colorOf(float value) {
  float x = 4.0 * clamp(value, 0.0, 1.0);
  ${viridis.slice(1).map((color, k) => `
  if (x <= ${k + 1}.0) return mix(${vec3(viridis[k])}, ${vec3(color)}, x - ${k}.0);`).join('')}
  return ${vec3(viridis[4])};
}
// The main light is at the camera, slightly above. The sides of a surface have the same color.
vec3 lit(vec3 color, vec3 normal) {
  vec3 n = normal.z < 0.0 ? -normal : normal;
  float main = max(0.0, dot(n, normalize(vec3(0.25, 0.5, 1.0))));
  float shine = pow(max(0.0, dot(n, normalize(vec3(0.15, 0.45, 1.2)))), 40.0);
  return color * (0.36 + 0.12 * n.y + 0.64 * main) + 0.10 * shine;
}
const vec3 unreached = ${vec3(unreachedColor)};
`;

// Triangles. \`mode\`: 0 plain, 1 values with isolines, 2 colors of vertices.
export const surfaceShader = {
  uniforms: () => ({mode: {value: 0}, range: {value: 1}, step: {value: 0}, pixel: {value: 1}}),
  vertexShader: `
attribute float value;
attribute vec3 tint;
varying float vValue;
varying vec3 vNormal, vTint;
void main() {
  vValue = value;
  vTint = tint;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,
  fragmentShader: `
uniform int mode;
uniform float range, step, pixel;
varying float vValue;
varying vec3 vNormal, vTint;
${common}
void main() {
  vec3 color = ${vec3(surfaceColor)};
  if (mode == 2) color = vTint;
  if (mode == 1) {
    color = vValue < 0.0 ? unreached : colorOf(vValue / range);
    if (step > 0.0 && vValue >= 0.0) {
      float level = vValue / step, width = max(fwidth(level), 1e-6);
      float toLine = abs(fract(level - 0.5) - 0.5) / width;
      float line = (1.0 - smoothstep(0.3 * pixel, 0.3 * pixel + 1.0, toLine)) * step_fade(width);
      color = mix(color, vec3(0.06, 0.08, 0.10), 0.75 * line * float(level > 0.5));
    }
  }
  gl_FragColor = vec4(lit(color, normalize(vNormal)), 1.0);
}`.replace('void main', `
// Lines that are closer than three pixels fade out.
float step_fade(float width) { return clamp(2.0 - 4.0 * width, 0.0, 1.0); }
void main`),
};

// Disks of a cloud, in the tangent planes of its points.
export const cloudShader = {
  uniforms: () => ({mode: {value: 0}, range: {value: 1}, step: {value: 0}, radius: {value: 0.01},
                    height: {value: 1}}),
  vertexShader: `
uniform float radius, height;
attribute float value;
attribute vec3 tint;
varying float vValue, vDepth;
varying vec3 vNormal, vTint;
void main() {
  vValue = value;
  vTint = tint;
  vNormal = normalMatrix * normal;
  vec4 position = modelViewMatrix * vec4(position, 1.0);
  vDepth = position.z;
  gl_Position = projectionMatrix * position;
  gl_PointSize = max(1.5, height * projectionMatrix[1][1] * radius / gl_Position.w);
}`,
  fragmentShader: `
uniform int mode;
uniform float range, step, radius;
uniform mat4 projectionMatrix;
varying float vValue, vDepth;
varying vec3 vNormal, vTint;
${common}
void main() {
  vec3 normal = normalize(vNormal);
  if (normal.z < 0.0) normal = -normal;
  // The point of the disk at this pixel, in the unit of the radius.
  vec2 offset = vec2(2.0, -2.0) * gl_PointCoord - vec2(1.0, -1.0);
  float height = -dot(offset, normal.xy) / max(normal.z, 0.15);
  if (dot(offset, offset) + height * height > 1.0) discard;
  float z = vDepth + radius * height;
  gl_FragDepth = 0.5 - 0.5 * (projectionMatrix[2][2] + projectionMatrix[3][2] / z);
  vec3 color = ${vec3(surfaceColor)};
  if (mode == 2) color = vTint;
  if (mode == 1) {
    color = vValue < 0.0 ? unreached : colorOf(vValue / range);
    // Every other band is darker. Lines would be as wide as the disks.
    if (step > 0.0 && vValue >= 0.0 && fract(0.5 * vValue / step) >= 0.5) color *= 0.7;
  }
  gl_FragColor = vec4(lit(color, normal), 1.0);
}`,
};

// An image on faces.
export const decalShader = {
  uniforms: () => ({image: {value: null}}),
  vertexShader: `
varying vec2 vUv;
varying vec3 vNormal;
void main() {
  vUv = uv;
  vNormal = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,
  fragmentShader: `
uniform sampler2D image;
varying vec2 vUv;
varying vec3 vNormal;
${common}
void main() {
  if (any(lessThan(vUv, vec2(0.0))) || any(greaterThan(vUv, vec2(1.0)))) discard;
  vec4 texel = texture2D(image, vUv);
  gl_FragColor = vec4(lit(texel.rgb, normalize(vNormal)), texel.a);
}`,
};

// Round markers of a constant size in pixels, with a white border.
export const markerShader = {
  uniforms: () => ({size: {value: 16}}),
  vertexShader: `
uniform float size;
attribute vec3 tint;
attribute float scale;
varying vec3 vTint;
varying float vSize;
void main() {
  vTint = tint;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  ${towardsCamera(0.012)}
  gl_PointSize = vSize = size * scale;
}`,
  fragmentShader: `
varying vec3 vTint;
varying float vSize;
void main() {
  float distance = length(2.0 * gl_PointCoord - 1.0), pixel = 2.0 / vSize;
  float inside = 1.0 - smoothstep(1.0 - pixel, 1.0, distance);
  if (inside <= 0.0) discard;
  float core = 1.0 - smoothstep(0.66 - pixel, 0.66 + pixel, distance);
  gl_FragColor = vec4(mix(vec3(1.0), vTint, core), inside);
}`,
};
