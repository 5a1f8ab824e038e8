// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
import {
  BufferAttribute, BufferGeometry, CanvasTexture, ColorManagement, DoubleSide, LinearSRGBColorSpace,
  Mesh, PerspectiveCamera, Points, Raycaster, Scene as ThreeScene, ShaderMaterial, Spherical,
  Triangle, Vector2,
  Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {LineMaterial} from 'three/examples/jsm/lines/LineMaterial.js';
import {LineSegments2} from 'three/examples/jsm/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import {MeshBVH} from 'three-mesh-bvh';
import {colorOfLabel, surfaceColor} from './colors.js';
import {cloudShader, decalShader, markerShader, surfaceShader, towardsCamera} from './shaders.js';

// Colors are given as they appear on the screen.
ColorManagement.enabled = false;

const markerColor = [0.85, 0.24, 0.12];
const markerSize = 17; // in CSS pixels

const material = (shader, options = {}) =>
  new ShaderMaterial({...shader, uniforms: shader.uniforms(), ...options});

function lineMaterial(color, width, {opacity = 1, lift = 0.002} = {}) {
  const result = new LineMaterial({color, linewidth: width, transparent: opacity < 1, opacity});
  // Lines on the surface are drawn slightly in front of it.
  result.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      '#include <logdepthbuf_vertex>', towardsCamera(lift));
  };
  result.customProgramCacheKey = () => `line ${lift}`; // otherwise materials share one shader
  return result;
}

// Returns the segments of polylines: `ends` has the number of points up to the end of each.
function segments(points, ends) {
  const result = [];
  let begin = 0;
  for (const end of ends) {
    for (let i = begin; i + 1 < end; ++i)
      result.push(...points.subarray(3 * i, 3 * i + 6));
    begin = end;
  }
  return result;
}

// Draws a surface and the results of queries on it, and finds locations under the pointer.
// Coordinates on the screen are CSS pixels. Points of the surface are moved and scaled to a sphere
// of radius 1, because single precision would be too coarse far from the origin.
export class Scene {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({canvas, antialias: true, alpha: true,
                                       preserveDrawingBuffer: true});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.scene = new ThreeScene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.zoomToCursor = true;

    this.surfaceMaterial = material(surfaceShader, {side: DoubleSide, polygonOffset: true,
                                                    polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    this.cellMaterial = this.surfaceMaterial.clone();
    this.cellMaterial.uniforms.mode.value = 2;
    this.cloudMaterial = material(cloudShader);
    this.decalMaterial = material(decalShader, {side: DoubleSide, transparent: true,
                                                depthWrite: false, polygonOffset: true,
                                                polygonOffsetFactor: -1, polygonOffsetUnits: -1});
    this.cells = new Mesh(new BufferGeometry(), this.cellMaterial);
    this.decal = new Mesh(new BufferGeometry(), this.decalMaterial);
    this.markers = new Points(new BufferGeometry(),
                              material(markerShader, {transparent: true}));
    this.isolines = this.lines(lineMaterial(0x0f1419, 1.4, {opacity: 0.8}));
    this.bisectors = this.lines(lineMaterial(0x2a333b, 2.2));
    this.casing = this.lines(lineMaterial(0xffffff, 7.5));
    this.path = this.lines(lineMaterial(0xd63d1f, 4, {lift: 0.005}));
    this.casing.material.depthWrite = false; // otherwise it hides parts of the path
    this.path.renderOrder = 2;
    this.markers.renderOrder = 3;
    this.overlays = [this.cells, this.decal, this.markers, this.isolines, this.bisectors,
                     this.casing, this.path];
    for (const object of this.overlays) {
      object.frustumCulled = false;
      object.visible = false;
      this.scene.add(object);
    }
    this.surface = null;
    this.raycaster = new Raycaster();
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  lines(lineMaterial) {
    return new LineSegments2(new LineSegmentsGeometry(), lineMaterial);
  }

  // Shows another surface: `points` (3 coordinates each), `triangles` and, on clouds, `normals`.
  load({points, triangles, normals, isMesh}) {
    this.points = points;
    this.isMesh = isMesh;
    this.triangles = triangles;
    this.setFrame(points);
    const geometry = new BufferGeometry();
    const positions = this.toLocal(points), count = points.length / 3;
    this.extent = this.largestNorm(positions);
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('value', new BufferAttribute(new Float32Array(count), 1));
    geometry.setAttribute('tint', new BufferAttribute(new Uint8Array(3 * count), 3, true));
    if (this.surface) {
      this.scene.remove(this.surface);
      this.surface.geometry.dispose();
    }
    this.bvh = null;
    if (isMesh) {
      geometry.setIndex(new BufferAttribute(triangles, 1));
      geometry.computeVertexNormals();
      this.bvh = new MeshBVH(geometry, {indirect: true});
      this.surface = new Mesh(geometry, this.surfaceMaterial);
    } else {
      geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(normals), 3));
      this.surface = new Points(geometry, this.cloudMaterial);
      this.radius = this.spacing(positions);
      this.cloudMaterial.uniforms.radius.value = this.radius;
    }
    this.surface.frustumCulled = false;
    this.scene.add(this.surface);
    this.clear();
    this.resetView();
  }

  setFrame(points) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], points[i]);
      high[i % 3] = Math.max(high[i % 3], points[i]);
    }
    this.center = low.map((x, c) => 0.5 * x + 0.5 * high[c]);
    this.scale = Math.hypot(...low.map((x, c) => 0.5 * high[c] - 0.5 * x)) || 1;
  }

  toLocal(points) {
    const result = new Float32Array(points.length);
    for (let i = 0; i < points.length; ++i)
      result[i] = (points[i] - this.center[i % 3]) / this.scale;
    return result;
  }

  largestNorm(positions) {
    let result = 1e-9;
    for (let i = 0; i < positions.length; i += 3)
      result = Math.max(result, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
    return result;
  }

  // Returns the radius of the disks of a cloud: the mean distance of 300 points to their fourth
  // nearest neighbor.
  spacing(positions) {
    const count = positions.length / 3, samples = Math.min(count, 300);
    let sum = 0;
    for (let s = 0; s < samples; ++s) {
      const i = 3 * Math.floor(s * count / samples);
      const nearest = [4, 4, 4, 4, 4];
      for (let j = 0; j < positions.length; j += 3) {
        const x = positions[j] - positions[i], y = positions[j + 1] - positions[i + 1],
          z = positions[j + 2] - positions[i + 2], d = x * x + y * y + z * z;
        if (d >= nearest[4]) continue;
        let k = 4;
        for (; k > 0 && nearest[k - 1] > d; --k) nearest[k] = nearest[k - 1];
        nearest[k] = d;
      }
      sum += Math.sqrt(nearest[4]);
    }
    return Math.max(0.9 * sum / samples, 0.0015);
  }

  resetView() {
    this.controls.target.set(0, 0, 0);
    this.camera.up.set(0, 1, 0);
    this.fit(new Vector3(0.45, 0.32, 1).normalize());
  }

  // Views the surface from a direction, such that it fits beside the panel.
  fit(direction) {
    const {left, right, top, bottom} = this.free;
    const half = Math.tan(this.camera.fov * Math.PI / 360);
    const distance = 1.06 * this.extent * this.height /
      (half * Math.min(right - left, bottom - top));
    this.camera.position.copy(direction).multiplyScalar(distance);
    this.camera.lookAt(0, 0, 0);
    this.controls.update();
    this.draw();
  }

  // Rotates the view by steps to the right and down.
  turn(right, down) {
    const step = 0.12;
    const offset = new Spherical().setFromVector3(
      this.camera.position.clone().sub(this.controls.target));
    offset.theta += step * right;
    offset.phi += step * down;
    offset.makeSafe();
    this.camera.position.setFromSpherical(offset).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  // Sets the part of the canvas that no panel covers. The target of the camera is at its center.
  setFreeArea(free) {
    this.free = free;
    this.camera.setViewOffset(this.width, this.height, (this.width - free.left - free.right) / 2,
                              (this.height - free.top - free.bottom) / 2, this.width, this.height);
    this.draw();
  }

  resize() {
    this.width = this.canvas.clientWidth || 1;
    this.height = this.canvas.clientHeight || 1;
    this.camera.aspect = this.width / this.height;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(this.width, this.height, false);
    this.markers.material.uniforms.size.value = markerSize * this.renderer.getPixelRatio();
    this.surfaceMaterial.uniforms.pixel.value = this.renderer.getPixelRatio();
    this.cloudMaterial.uniforms.height.value = this.height * this.renderer.getPixelRatio();
    this.setFreeArea(this.onResize?.() ??
                     {left: 0, top: 0, right: this.width, bottom: this.height});
  }

  // Requests a frame.
  draw() {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => this.drawNow());
  }
  drawNow() {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.renderer.render(this.scene, this.camera);
  }

  // ---- Picking

  // Returns the location at a position on the screen, or null: {face, weights} or {vertex}, and the
  // local point and normal.
  pick(x, y) {
    if (!this.surface) return null;
    this.camera.updateMatrixWorld();
    this.raycaster.setFromCamera(new Vector2(2 * x / this.width - 1, 1 - 2 * y / this.height),
                                 this.camera);
    return this.isMesh ? this.pickFace(this.raycaster.ray) : this.pickSurfel(this.raycaster.ray);
  }

  pickFace(ray) {
    const hit = this.bvh.raycastFirst(ray, DoubleSide);
    if (!hit) return null;
    const corners = this.corners(hit.faceIndex);
    const triangle = new Triangle(...corners.map((i) => this.position(i)));
    const weights = triangle.getBarycoord(hit.point, new Vector3());
    if (!weights) return this.atVertex(corners[0]);
    const positive = weights.toArray().map((weight) => Math.max(0, weight));
    const sum = positive[0] + positive[1] + positive[2];
    return {face: hit.faceIndex, weights: positive.map((weight) => weight / sum), point: hit.point,
            normal: triangle.getNormal(new Vector3())};
  }

  // Returns the surfel closest to the camera among those whose disks the ray meets.
  pickSurfel(ray) {
    const positions = this.attributes.position.array;
    const {origin: o, direction: d} = ray;
    let best = -1, bestDepth = Infinity, found = null;
    for (let i = 0; i < positions.length; i += 3) {
      const x = positions[i] - o.x, y = positions[i + 1] - o.y, z = positions[i + 2] - o.z;
      const depth = x * d.x + y * d.y + z * d.z;
      const off = x * x + y * y + z * z - depth * depth;
      // Of disks at similar depths, the one is chosen whose center is closest to the ray.
      const key = depth + 3 * Math.sqrt(Math.max(0, off));
      if (depth > 0 && off < this.radius * this.radius && key < bestDepth) {
        bestDepth = key;
        best = i / 3;
      }
    }
    if (best >= 0) found = this.atVertex(best);
    return found;
  }

  get attributes() { return this.surface.geometry.attributes; }
  vector(coordinates) { return new Vector3(...coordinates); }
  corners(face) { return [0, 1, 2].map((k) => this.triangles[3 * face + k]); }
  position(vertex) {
    return new Vector3().fromBufferAttribute(this.attributes.position, vertex);
  }
  // Returns the location of a vertex.
  atVertex(vertex) {
    return {vertex, point: this.position(vertex),
            normal: new Vector3().fromBufferAttribute(this.attributes.normal, vertex)};
  }
  // Returns the vertex nearest to a location.
  snap(place) {
    if (place.vertex !== undefined) return place;
    const k = place.weights.indexOf(Math.max(...place.weights));
    return this.atVertex(this.corners(place.face)[k]);
  }

  // Returns the position on the screen of a local point, and whether it is visible.
  project(point) {
    this.camera.updateMatrixWorld();
    const p = point.clone().project(this.camera);
    const x = (p.x + 1) / 2 * this.width, y = (1 - p.y) / 2 * this.height;
    const hit = this.pick(x, y);
    const isVisible = !hit || hit.point.distanceTo(this.camera.position) >
      point.distanceTo(this.camera.position) - 0.02;
    return {x, y, isVisible};
  }

  // Returns the upward direction of the screen in the coordinates of the surface.
  upDirection() { return new Vector3(0, 1, 0).applyQuaternion(this.camera.quaternion); }

  // ---- Results

  // Removes the results of all queries.
  clear() {
    for (const object of this.overlays) object.visible = false;
    if (this.surface) this.setMode(0);
    this.draw();
  }

  setMode(mode) {
    this.surface.visible = true;
    this.surfaceMaterial.uniforms.mode.value = mode;
    this.cloudMaterial.uniforms.mode.value = mode;
  }

  // Shows values at vertices, and isolines at the multiples of `step` unless it is zero.
  showValues(values, max, step) {
    const attribute = this.attributes.value;
    for (let i = 0; i < values.length; ++i)
      attribute.array[i] = values[i] < Infinity ? values[i] / this.scale : -1e9;
    attribute.needsUpdate = true;
    for (const {uniforms} of [this.surfaceMaterial, this.cloudMaterial]) {
      uniforms.range.value = max / this.scale || 1;
      uniforms.step.value = step / this.scale;
    }
    this.isolines.visible = false;
    this.setMode(1);
    this.draw();
  }

  // Draws isolines {points, ends} instead of those of showValues().
  showIsolines({points, ends}) {
    this.setSegments(this.isolines, segments(this.toLocal(points), ends));
    this.surfaceMaterial.uniforms.step.value = 0;
  }

  showPath(points) {
    const line = segments(this.toLocal(points), [points.length / 3]);
    this.setSegments(this.casing, line);
    this.setSegments(this.path, line);
  }

  setSegments(object, coordinates) {
    object.geometry.dispose();
    object.geometry = new LineSegmentsGeometry();
    object.visible = coordinates.length > 0;
    if (object.visible) object.geometry.setPositions(coordinates);
    this.draw();
  }

  // Shows a Voronoi diagram as the worker returns it.
  showCells({labels, points, triangles, triangleLabels}) {
    if (!this.isMesh) return this.showTints((i) => colorOfLabel(labels[i]));
    const smooth = new BufferGeometry();
    smooth.setAttribute('position', new BufferAttribute(this.toLocal(points), 3));
    smooth.setIndex(new BufferAttribute(triangles, 1));
    smooth.computeVertexNormals();
    // Triangles of different cells have no corners in common, because corners have one color each.
    const geometry = smooth.toNonIndexed();
    const tint = new Uint8Array(3 * triangles.length);
    for (let f = 0; f < triangleLabels.length; ++f) {
      const color = colorOfLabel(triangleLabels[f]).map((x) => Math.round(255 * x));
      for (let k = 0; k < 3; ++k) tint.set(color, 9 * f + 3 * k);
    }
    geometry.setAttribute('tint', new BufferAttribute(tint, 3, true));
    geometry.setAttribute('value', new BufferAttribute(new Float32Array(triangles.length), 1));
    this.cells.geometry.dispose();
    this.cells.geometry = geometry;
    this.cells.visible = true;
    this.surface.visible = false;
    this.setSegments(this.bisectors, this.cellEdges(smooth, triangles, triangleLabels));
  }

  // Returns the segments of the edges between triangles of different cells.
  cellEdges(geometry, triangles, labels) {
    const p = geometry.attributes.position.array, edges = new Map(), result = [];
    const count = p.length / 3;
    for (let f = 0; f < labels.length; ++f)
      for (let k = 0; k < 3; ++k) {
        const a = triangles[3 * f + k], b = triangles[3 * f + (k + 1) % 3];
        const key = Math.min(a, b) * count + Math.max(a, b), other = edges.get(key);
        if (other === undefined) edges.set(key, labels[f]);
        else if (other !== labels[f])
          result.push(p[3 * a], p[3 * a + 1], p[3 * a + 2], p[3 * b], p[3 * b + 1], p[3 * b + 2]);
      }
    return result;
  }

  // Colors each vertex by a function of its number.
  showTints(colorOfVertex) {
    const attribute = this.attributes.tint;
    for (let i = 0; i < attribute.count; ++i)
      attribute.array.set(colorOfVertex(i).map((x) => 255 * x), 3 * i);
    attribute.needsUpdate = true;
    this.setMode(2);
    this.draw();
  }

  // Places an image (an ImageData for clouds, and a texture of it) as the worker returns it.
  showDecal(placed, {texture, pixels}) {
    if (!this.isMesh) return this.showCloudDecal(placed, pixels);
    const {faces, cornerUv} = placed;
    const source = this.attributes;
    const position = new Float32Array(9 * faces.length);
    const normal = new Float32Array(9 * faces.length);
    for (let i = 0; i < faces.length; ++i)
      for (let k = 0; k < 3; ++k) {
        const vertex = 3 * this.triangles[3 * faces[i] + k], to = 9 * i + 3 * k;
        position.set(source.position.array.subarray(vertex, vertex + 3), to);
        normal.set(source.normal.array.subarray(vertex, vertex + 3), to);
      }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(position, 3));
    geometry.setAttribute('normal', new BufferAttribute(normal, 3));
    geometry.setAttribute('uv', new BufferAttribute(Float32Array.from(cornerUv), 2));
    this.decal.geometry.dispose();
    this.decal.geometry = geometry;
    this.decalMaterial.uniforms.image.value = texture;
    this.decal.visible = true;
    this.draw();
  }

  showCloudDecal({vertices, vertexUv}, {width, height, data}) {
    const colors = new Map();
    vertices.forEach((vertex, i) => {
      const x = Math.min(width - 1, Math.floor(vertexUv[2 * i] * width));
      const y = Math.min(height - 1, Math.floor((1 - vertexUv[2 * i + 1]) * height));
      const from = 4 * (y * width + x), opacity = data[from + 3] / 255;
      colors.set(vertex, surfaceColor.map(
        (below, c) => opacity * data[from + c] / 255 + (1 - opacity) * below));
    });
    this.showTints((i) => colors.get(i) ?? surfaceColor);
  }

  // Shows markers at local points.
  showMarkers(points, scale = 1) {
    const geometry = new BufferGeometry().setFromPoints(points);
    const count = points.length;
    const tint = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i) tint.set(markerColor, 3 * i);
    geometry.setAttribute('tint', new BufferAttribute(tint, 3));
    geometry.setAttribute('scale', new BufferAttribute(new Float32Array(count).fill(scale), 1));
    this.markers.geometry.dispose();
    this.markers.geometry = geometry;
    this.markers.visible = count > 0;
    this.draw();
  }

  // Returns the picture as a PNG file.
  picture() {
    this.drawNow();
    return new Promise((resolve) => {
      const {width, height} = this.canvas;
      const copy = new OffscreenCanvas(width, height), context = copy.getContext('2d');
      context.fillStyle = '#ffffff';
      context.fillRect(0, 0, width, height);
      context.drawImage(this.canvas, 0, 0);
      copy.convertToBlob({type: 'image/png'}).then(resolve);
    });
  }
}

// Returns an image for decals: its texture and its pixels.
export function decalImage(canvas) {
  const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const texture = new CanvasTexture(canvas);
  texture.anisotropy = 8;
  return {texture, pixels, aspect: canvas.width / canvas.height};
}
