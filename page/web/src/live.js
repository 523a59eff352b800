// A controller as WebAssembly: the source of data that can be run, changed and put back.
import { fileSystem } from './files.js';

export const transitions = ['load', 'start', 'stop', 'resume', 'save'];

export class Refused extends Error {}

// Bodies, then for each point its place and its target.
export const poseCount = (robot) => (robot ? 7 * robot.bodies.length + 6 * robot.points.length : 0);
export function planStep(source) {
  const { plan, outputs } = source.description;
  const output = plan ? outputs.findIndex((o) => o.path === plan.port) : -1;
  const row = output < 0 ? null : source.newest();
  return row && source.publishedIn(output) >= 0 ? row[outputs[output].at] : -1;
}

export function fromBase64(text) {
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

export async function startProgram(compressed, files = {}) {
  const stream = new Blob([fromBase64(compressed)]).stream().pipeThrough(new DecompressionStream('gzip'));
  const code = await new Response(stream).arrayBuffer();
  let memory = null;
  const text = (at, size) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, size));
  const system = fileSystem(Object.fromEntries(Object.entries(files).map(([name, content]) => [name, fromBase64(content)])), () => memory);
  const { instance } = await WebAssembly.instantiate(code, {
    wasi_snapshot_preview1: system,
    page: { refuse(at, size) { throw new Refused(text(at, size)); } },
  });
  memory = instance.exports.memory;
  instance.exports._initialize();
  return new Live(instance.exports);
}

export class Live {
  constructor(program) {
    this.program = program;
    this.isLive = true;
    this.description = JSON.parse(this.text(program.description()));
    this.period = this.description.period * 1e-9;
    this.width = program.row_width();
    this.extraAt = this.description.coordinates;
    this.first = 0;  // the oldest beat that is kept
    this.refresh();
  }

  // ---- what there is ----

  text(at) {
    return new TextDecoder().decode(new Uint8Array(this.program.memory.buffer, at, this.program.text_size()));
  }
  refresh() {
    this.status = JSON.parse(this.text(this.program.status()));
    const { memory } = this.program;
    const outputs = this.description.outputs.length;
    this.rows = new Float64Array(memory.buffer, this.program.rows(), this.width * this.description.kept);
    this.origins = new Float64Array(memory.buffer, this.program.origins(), outputs);
    this.published = new Float64Array(memory.buffer, this.program.published(), outputs);
    this.poses = new Float64Array(memory.buffer, this.program.poses(), poseCount(this.description.robot));
    this.first = Math.max(0, this.status.beat - this.description.kept);
  }
  get beat() { return this.status.beat; }
  get time() { return this.status.beat * this.period; }
  get runs() { return this.status.state === 'started' || this.status.state === 'running'; }

  row(beat) {
    const at = (beat % this.description.kept) * this.width;
    return this.rows.subarray(at, at + this.width);
  }
  newest() { return this.beat > 0 ? this.row(this.beat - 1) : null; }
  publishedIn(output) { return this.published[output]; }
  originOf(output) { return this.origins[output]; }
  extra(beat, i) { return this.row(beat)[this.extraAt + i]; }

  // Points of one coordinate in a span of time: [times, values].
  series(output, coordinate, from, to, most) {
    const column = this.description.outputs[output].at + coordinate;
    const first = Math.max(this.first, Math.floor(from / this.period));
    const last = Math.min(this.beat, Math.ceil(to / this.period) + 1);
    const stride = Math.max(1, Math.ceil((last - first) / most));
    const times = [], values = [];
    for (let k = Math.ceil(first / stride) * stride; k < last; k += stride) {
      times.push(k * this.period);
      values.push(this.row(k)[column]);
    }
    return [times, values];
  }
  // Which number of a row is the first of these; undefined: this robot has none.
  place(what) { return this.description.robot?.extra[what]; }
  get hasContacts() { return this.place('contacts') !== undefined; }
  contact(point, beat) { return this.extra(beat, this.place('contacts') + point) > 0; }
  position() {
    if (this.beat === 0) return this.description.robot.kind === 'oncilla' ? [...this.poses.subarray(0, 3)] : null;
    return [0, 1, 2].map((i) => this.extra(this.beat - 1, this.place('position') + i));
  }
  // Of the world on each point of the robot, N.
  forces() {
    if (this.beat === 0) return [];
    return this.description.robot.points.map((_, p) => [0, 1, 2].map((k) => this.extra(this.beat - 1, this.place('forces') + 3 * p + k)));
  }
  // Where each point should be.
  targets() {
    const { points, bodies, target } = this.description.robot;
    if (!target) return points.map((_, p) => this.poses.subarray(7 * bodies.length + 6 * p + 3, 7 * bodies.length + 6 * p + 6));
    const output = this.description.outputs.findIndex((o) => o.path === target);
    const { at } = this.description.outputs[output];
    return this.beat > 0 && this.publishedIn(output) >= 0 ? [this.newest().subarray(at, at + 3)] : [];
  }
  get fallen() { return this.beat > 0 && this.place('fallen') !== undefined && this.extra(this.beat - 1, this.place('fallen')) > 0; }
  // Which step of the plan it is in; -1: none.
  step() { return planStep(this); }

  // ---- what one can do ----

  // A refusal leaves the frames of the program at once, so its stack is put back.
  call(name, ...values) {
    return this.guarded(() => this.program[name](...values));
  }
  guarded(action) {
    const stack = this.program.__stack_pointer.value;
    try {
      return action();
    } catch (error) {
      this.program.__stack_pointer.value = stack;
      throw error;
    } finally {
      this.refresh();
    }
  }
  advance(beats) { return this.call('advance', beats); }
  change(transition) { this.call('change', transitions.indexOf(transition)); }
  beginAnew() { this.call('begin_anew'); }
  push(force, seconds) { this.call('push', ...force, seconds); }
  press(button, down) { this.call('press', button, down ? 1 : 0); }
  takeSnapshot() { this.call('take_snapshot'); }
  goBack(beat) { return this.call('go_back', beat) !== 0; }
  // Why it is refused; empty: it is set.
  set(field, value) {
    return this.guarded(() => this.text(this.program.set(field, value)));
  }
  parameters() { return JSON.parse(this.text(this.program.parameters())); }
}
