import { readFileSync } from 'node:fs';

const widths = { SCALAR: 1, VEC3: 3, VEC4: 4 };

/** A film's file by its bytes alone: little of glTF, but independent of the page's loader. */
export class Glb {
  constructor(path) {
    const bytes = readFileSync(path);
    const jsonLength = bytes.readUInt32LE(12);
    this.json = JSON.parse(bytes.toString('utf8', 20, 20 + jsonLength));
    this.binary = bytes.subarray(20 + jsonLength + 8);
    this.animation = this.json.animations[0];
  }

  floats(accessor) {
    const { bufferView, byteOffset = 0, count, type } = this.json.accessors[accessor];
    const start = (this.json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    return Array.from({ length: count * widths[type] }, (_, i) => this.binary.readFloatLE(start + 4 * i));
  }

  node(name) {
    return this.json.nodes.findIndex((node) => node.name === name);
  }

  /** Times and values of what moves a node; null where nothing does. */
  keys(node, path) {
    const channel = this.animation.channels.find(({ target }) => target.node === node && target.path === path);
    if (!channel) return null;
    const sampler = this.animation.samplers[channel.sampler];
    const steps = sampler.interpolation === 'STEP';
    return { times: this.floats(sampler.input), values: this.floats(sampler.output), steps };
  }

  /** By straight lines between the keys, or by steps. */
  valueAt(node, path, time) {
    const { times, values, steps } = this.keys(node, path);
    const width = values.length / times.length;
    const next = Math.max(1, times.findIndex((t) => t > time)), last = next - 1;
    const share = steps ? 0 : (time - times[last]) / (times[next] - times[last]);
    return Array.from({ length: width }, (_, i) =>
      (1 - share) * values[last * width + i] + share * values[next * width + i]);
  }

  get duration() {
    return Math.max(...this.animation.samplers.map(({ input }) => Math.max(...this.floats(input))));
  }

  /** Height of a node of the water's surface. */
  waterHeight(vertex, time) {
    const node = this.node('water'), primitive = this.json.meshes[this.json.nodes[node].mesh].primitives[0];
    let height = this.floats(primitive.attributes.POSITION)[3 * vertex + 1];
    if (primitive.targets)
      this.valueAt(node, 'weights', time).forEach((weight, i) => {
        height += weight * this.floats(primitive.targets[i].POSITION)[3 * vertex + 1];
      });
    return height;
  }
}
