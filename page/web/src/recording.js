// A recording (.mcap) as a source of data: read whole, also where it was cut off.
import { McapStreamReader } from '@mcap/core';
import { decompress } from 'fzstd';

import { planStep, poseCount } from './live.js';

const never = -1;

// `known`: descriptions of controllers, whose robots and plans the recording may have.
export async function readRecording(bytes, known) {
  const channels = new Map();
  const metadata = new Map();
  let cut = false;
  const reader = new McapStreamReader({ decompressHandlers: { zstd: (buffer, size) => decompress(new Uint8Array(buffer), new Uint8Array(Number(size))) } });
  const schemas = new Map();
  try {
    reader.append(bytes);
    for (let record; (record = reader.nextRecord());) {
      if (record.type === 'Schema') schemas.set(record.id, new TextDecoder().decode(record.data));
      else if (record.type === 'Channel') {
        if (!channels.has(record.id)) channels.set(record.id, { topic: record.topic, metadata: record.metadata, schema: schemas.get(record.schemaId), beats: [], origins: [], values: [], texts: [] });
      } else if (record.type === 'Message') take(channels.get(record.channelId), record);
      else if (record.type === 'Metadata') metadata.set(record.name, record.metadata);
    }
    cut = !reader.done();
  } catch (error) {
    if (channels.size === 0) throw new Error(`this is no recording: ${error.message}`);
    cut = true;
  }
  const architecture = metadata.get('cca.architecture');
  if (channels.size === 0 && cut) throw new Error('this is no recording: it ends in its first bytes');
  if (!architecture) throw new Error('this file has no architecture: cca has not recorded it');
  return new Recording(Object.fromEntries(architecture), [...channels.values()], metadata, cut, known);
}

// What of a recorded architecture is not as in another one, in words; empty: it is the same.
export function difference(recorded, other) {
  const missing = (here, there) => here.find((name) => !there.includes(name));
  const kinds = {
    component: (d) => d.nodes.map((n) => n.path),
    port: (d) => d.outputs.map((o) => `${o.path} of ${o.fields.length} numbers`),
    wire: (d) => d.wires.map((w) => `${d.outputs[w.from].path} → ${d.nodes[w.node]?.path}.${w.input}${w.delay ? `, delayed ${w.delay}` : ''}`),
  };
  for (const [kind, names] of Object.entries(kinds)) {
    const added = missing(names(recorded), names(other)), lacking = missing(names(other), names(recorded));
    if (added) return `it has the ${kind} ${added}, which ${other.name} does not have`;
    if (lacking) return `it does not have the ${kind} ${lacking} of ${other.name}`;
  }
  return '';
}

function take(channel, { data }) {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  if (channel.topic === '/cca/state' || channel.topic === '/cca/fault') {
    const texts = [];
    for (let at = 12; at + 4 <= data.byteLength;) {
      const size = view.getUint32(at, true);
      texts.push(new TextDecoder().decode(data.subarray(at + 4, at + 3 + size)));
      at += Math.ceil((4 + size) / 4) * 4;
    }
    channel.beats.push(Number(view.getBigInt64(4, true)));
    channel.texts.push(texts);
  } else if (channel.metadata.has('axes')) {  // a port; beside it are messages for other viewers
    channel.beats.push(Number(view.getBigInt64(4, true)));
    channel.origins.push(Number(view.getBigInt64(12, true)) * 1e-9);
    for (let at = 20; at < data.byteLength; at += 8) channel.values.push(view.getFloat64(at, true));
  }
}

export class Recording {
  constructor(architecture, channels, metadata, cut, known) {
    this.isLive = false;
    this.isCut = cut;
    this.metadata = metadata;
    this.period = Number(architecture.ns_a_beat) * 1e-9;
    this.channels = new Map(channels.map((c) => [c.topic, c]));
    this.description = this.describe(architecture);
    this.beats = 0;
    for (const c of channels) if (c.metadata.has('axes') && c.beats.length > 0) this.beats = Math.max(this.beats, c.beats.at(-1) + 1);
    this.beat = 0;
    this.first = 0;
    this.memory = new Float64Array(this.description.coordinates);
    const differences = known.map((one) => difference(this.description, one));
    this.difference = differences.includes('') ? '' : differences[0] ?? '';
    const same = known[differences.indexOf('')];
    Object.assign(this.description, { plan: same?.plan, plots: same?.plots });
    this.findRobot(same?.robot ?? known.find((one) => one.robot?.kind === 'oncilla')?.robot);
    this.seek(0);
  }

  // The architecture from its text in the file; the spaces from the channels.
  describe(architecture) {
    const nodes = [], outputs = [], wires = [];
    let at = 0;
    for (const line of architecture.text.split('\n')) {
      let m;
      if ((m = /^node (.*?), (.*)$/.exec(line))) {
        const every = /every (\d+) beats from (\d+)/.exec(m[2]);
        nodes.push({ path: m[1], resource: false, when: every ? `${1 / (Number(every[1]) * this.period)} Hz` : m[2],
          clock: every ? { period: Number(every[1]), first: Number(every[2]) } : null });
      } else if ((m = /^output (.*): (\d+) numbers/.exec(line))) {
        const path = m[1], size = Number(m[2]);
        const channel = this.channels.get(`/${path.replaceAll('.', '/')}`);
        const names = channel?.metadata.get('axes').split(' ') ?? [], units = this.unitsOf(channel, size);
        outputs.push({ path, node: this.nodeAt(nodes, path.slice(0, path.lastIndexOf('.'))), at, channel, space: channel?.metadata.get('space') ?? '',
          fields: Array.from({ length: size }, (_, i) => ({ name: names[i] ?? String(i), unit: units[i] === '1' ? '' : units[i] })) });
        at += size;
      } else if ((m = /^wire to (.*) from output (\d+), delayed (\d+)$/.exec(line))) {
        const dot = m[1].lastIndexOf('.');
        wires.push({ from: Number(m[2]), node: this.nodeAt(nodes, m[1].slice(0, dot)), input: m[1].slice(dot + 1), delay: Number(m[3]), policy: m[3] === '0' ? 'latest' : `delayed ${m[3]}` });
      }
    }
    const places = this.metadata.get('cca.places') ?? new Map();  // of a deployment
    const environments = [...new Set(places.values())];
    for (const node of nodes) node.environment = environments.indexOf(places.get(node.path));
    return { environments, name: architecture.name, period: Number(architecture.ns_a_beat), nodes, outputs, wires, coordinates: at, parameters: [] };
  }
  nodeAt(nodes, path) { return nodes.findIndex((n) => n.path === path); }
  // From the schema: `float64 hip  # N m, -3 to 3`. A unit may have spaces, so the metadata won't do.
  unitsOf(channel, size) {
    const lines = (channel?.schema ?? '').split('\n').filter((l) => l.startsWith('float64'));
    return Array.from({ length: size }, (_, i) => {
      const comment = /#\s*(.*)$/.exec(lines[i] ?? '')?.[1] ?? '';
      const unit = comment.split(',')[0];
      return /^-?[\d.]+(e[-+]?\d+)? to /.test(unit) ? '' : unit;
    });
  }

  port(ending, size) {
    return this.description.outputs.findIndex((o) => o.path.endsWith(`.${ending}`) && (!size || o.fields.length === size));
  }
  findRobot(robot) {
    this.ports = { angles: this.port('angles', 8), orientation: this.port('orientation', 4), contacts: this.port('contacts', 4), loads: this.port('foot_loads', 4), targets: this.port('safe', 8) };
    const measured = this.description.outputs.findIndex((o) => o.fields.length === 8 && o.path.startsWith('robot.angles'));
    if (measured >= 0) this.ports.angles = measured;  // not the commands
    if (robot?.kind !== 'oncilla' || this.ports.angles < 0 || this.ports.orientation < 0) return;
    this.description.robot = robot;
    this.poses = new Float64Array(poseCount(robot));
  }

  // ---- as of a live controller ----

  get time() { return this.beat * this.period; }
  get runs() { return false; }
  seek(beat) {
    this.beat = Math.min(this.beats, Math.max(0, Math.round(beat)));
    const state = this.last('/cca/state'), fault = this.last('/cca/fault');
    this.status = { beat: this.beat, state: state?.[0] ?? '', fault: fault?.[1] ?? '', faultPath: fault?.[0] ?? '', snapshots: [] };
    if (fault && this.beat >= this.beats) this.status.state = 'faulted';
    if (this.poses) this.pose();
  }
  last(topic) {
    const channel = this.channels.get(topic);
    const i = channel ? this.index(channel, this.beat + 1) : -1;
    return i < 0 ? null : channel.texts[i];
  }
  // The last message before a beat; -1: none.
  index(channel, beat) {
    let low = 0, high = channel.beats.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (channel.beats[middle] < beat) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
  sample(output, beat = this.beat) {
    const { channel, fields } = this.description.outputs[output];
    const i = channel ? this.index(channel, beat) : -1;
    return i < 0 ? null : channel.values.slice(i * fields.length, (i + 1) * fields.length);
  }
  newest() {
    if (this.beat === 0) return null;
    this.description.outputs.forEach((o, i) => { const s = this.sample(i); if (s) this.memory.set(s, o.at); });
    return this.memory;
  }
  publishedIn(output) {
    const { channel } = this.description.outputs[output];
    const i = channel ? this.index(channel, this.beat) : -1;
    return i < 0 ? never : channel.beats[i];
  }
  originOf(output) {
    const { channel } = this.description.outputs[output];
    const i = channel ? this.index(channel, this.beat) : -1;
    return i < 0 ? never : channel.origins[i];
  }
  series(output, coordinate, from, to, most) {
    const { channel, fields } = this.description.outputs[output];
    const times = [], values = [];
    if (!channel) return [times, values];
    const first = Math.max(0, this.index(channel, from / this.period)), last = this.index(channel, Math.min(to / this.period + 1, this.beat));
    const stride = Math.max(1, Math.ceil((last - first) / most));
    for (let i = first; i <= last; i += stride) {
      times.push(channel.beats[i] * this.period);
      values.push(channel.values[i * fields.length + coordinate]);
    }
    return [times, values];
  }
  get hasContacts() { return this.ports.contacts >= 0; }
  contact(leg, beat) { return (this.sample(this.ports.contacts, beat + 1)?.[leg] ?? 0) > 0; }
  position() { return null; }
  forces() {
    const loads = this.ports.loads >= 0 ? this.sample(this.ports.loads) : null;
    return loads ? loads.map((n) => [0, 0, n]) : [];
  }
  targets() {
    const at = 7 * this.description.robot.bodies.length;
    return this.description.robot.points.map((_, p) => this.poses.subarray(at + 6 * p + 3, at + 6 * p + 6));
  }
  step() { return planStep(this); }
  get fallen() { return false; }

  // No sensor measures where the trunk is. So it stays in its place, as high as its lowest foot says.
  pose() {
    const { robot } = this.description;
    const angles = this.sample(this.ports.angles), q = this.sample(this.ports.orientation), targets = this.ports.targets >= 0 ? this.sample(this.ports.targets) : null;
    if (!angles || !q) return;
    const names = this.description.outputs[this.ports.angles].fields.map((f) => f.name);
    const turn = (v) => {  // by the quaternion x y z w
      const [x, y, z, w] = q;
      const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
      return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]];
    };
    const legs = robot.points.map((name, leg) => {
      const key = name.replace(' ', '_');
      const at = (joint, fallback) => { const i = names.findIndex((n) => n.includes(key) && n.includes(joint)); return i < 0 ? fallback : i; };
      const hipAt = at('hip', leg), kneeAt = at('knee', leg + 4);
      const chain = (hip, knee) => {
        const [upper, middle, lower, toe] = robot.segments;
        const along = (p, angle, length) => [p[0] + length * Math.sin(angle), 0, p[2] - length * Math.cos(angle)];
        const k = along([0, 0, 0], hip, upper), a = along(k, hip - knee, middle), t = along(a, hip, lower), foot = along(t, hip, toe);
        const half = (p, r) => [(p[0] + r[0]) / 2, 0, (p[2] + r[2]) / 2];
        return { centres: [half([0, 0, 0], k), half(k, a), half(a, t), foot], angles: [hip, hip - knee, hip, hip], foot };
      };
      const place = (v) => turn([v[0] + robot.hips[leg][0], v[1] + robot.hips[leg][1], v[2] + robot.hips[leg][2]]);
      const now = chain(angles[hipAt], angles[kneeAt]);
      return { centres: now.centres.map(place), angles: now.angles, foot: place(now.foot), target: targets ? place(chain(targets[hipAt], targets[kneeAt]).foot) : place(now.foot) };
    });
    const height = -Math.min(...legs.map((l) => l.foot[2])) + robot.bodies.at(-1).size[0];
    const up = (v) => [v[0], v[1], v[2] + height];
    this.poses.set([0, 0, height, q[3], q[0], q[1], q[2]], 0);
    legs.forEach((leg, i) => {
      leg.centres.forEach((centre, part) => {
        const s = Math.sin(-leg.angles[part] / 2), c = Math.cos(leg.angles[part] / 2);  // about y
        const [x, y, z, w] = q;
        const turned = [w * c - y * s, x * c - z * s, y * c + w * s, z * c + x * s];
        this.poses.set([...up(centre), ...turned], 7 * (1 + 4 * i + part));
      });
      this.poses.set([...up(leg.foot), ...up(leg.target)], 7 * robot.bodies.length + 6 * i);
    });
  }
}
