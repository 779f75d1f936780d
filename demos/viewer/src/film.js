import { AnimationMixer, Box3, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { dressWater } from './water.js';

const isMarker = (name) => /: (centre of buoyancy|force)$/.test(name);

/** A film as demos record it: a node for each body, "water", and markers "BODY: force", "BODY: centre of buoyancy". */
export class Film {
  /** Rejects, with a message for people, what is no glTF binary. */
  static async read(bytes) {
    const magic = new TextDecoder().decode(new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength)));
    if (magic !== 'glTF') throw new Error('it is not a glTF binary (.glb)');
    return new Film(await new GLTFLoader().parseAsync(bytes, ''));
  }

  constructor(gltf) {
    this.root = gltf.scene;
    this.mixer = new AnimationMixer(this.root);
    this.actions = gltf.animations.map((clip) => this.mixer.clipAction(clip).play());
    this.duration = Math.max(0, ...gltf.animations.map((clip) => clip.duration));
    this.bodies = [];
    this.markers = [];
    const moving = new Set(gltf.animations.flatMap(({ tracks }) => tracks.map(({ name }) => name.split('.')[0])));
    for (const node of this.root.children) {
      const name = node.userData.name ?? node.name;
      if (name === 'water') this.water = node;
      else (isMarker(name) ? this.markers : this.bodies).push(node);
    }
    for (const body of this.bodies)
      body.traverse((part) => Object.assign(part, { castShadow: true, receiveShadow: true }));
    this.markers.forEach(drawOnTop);
    this.showForces(false);
    this.seek(0);
    this.bounds = this.#stageBounds(this.bodies.filter((body) => moving.has(body.name)));
    if (this.bounds.isEmpty()) throw new Error('there is nothing in it');
    if (this.water) dressWater(this.water, this.bounds.min.y);
  }

  /** To a time from 0 to the duration, s. */
  seek(time) {
    this.time = Math.min(Math.max(time, 0), this.duration);
    for (const action of this.actions) action.time = this.time;
    this.mixer.update(0);
    this.root.updateMatrixWorld();
  }

  showForces(visible) {
    for (const marker of this.markers) marker.visible = visible;
  }

  dispose() {
    this.root.traverse((part) => {
      part.geometry?.dispose();
      part.material?.dispose();
    });
  }

  /**
   * Of the water at all times, with room below for what dips in, and of the bodies that move, as they start, as far as
   * they are near the water; without water, of all bodies at all times.
   */
  #stageBounds(moving) {
    if (!this.water) return this.#boundsOverTime(this.bodies);
    const bounds = this.#boundsOverTime([this.water]), size = bounds.getSize(new Vector3());
    const width = Math.min(size.x, size.z);
    const heights = moving.map((body) => boundsOf([body]).getSize(new Vector3()).y);
    const meanHeight = heights.reduce((sum, height) => sum + height, 0) / Math.max(heights.length, 1);
    const near = bounds.clone().expandByScalar(0.3 * width);
    near.max.y = Math.max(near.max.y, bounds.max.y + 3 * meanHeight);
    const lowest = this.#boundsOverTime(moving).min.y;
    const deepest = bounds.min.y - Math.max(0.25 * width, meanHeight);
    bounds.min.y = Math.max(Math.min(bounds.min.y - 0.14 * width, lowest), deepest);
    return bounds.union(boundsOf(moving).intersect(near));
  }

  #boundsOverTime(nodes) {
    const bounds = new Box3(), moments = 12;
    for (let i = moments; i >= 0; --i) {
      this.seek(this.duration * i / moments);
      bounds.union(boundsOf(nodes));
    }
    return bounds;
  }
}

function boundsOf(nodes) {
  const bounds = new Box3(), everyVertex = true;
  for (const node of nodes) bounds.expandByObject(node, everyVertex);
  return bounds;
}

/** Markers lie inside of the bodies. */
function drawOnTop(marker) {
  marker.traverse((part) => {
    if (!part.isMesh) return;
    part.renderOrder = 10;
    Object.assign(part.material, { depthTest: false, transparent: true });
  });
}
