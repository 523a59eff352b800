// A recording (.mcap) as a source of data: read whole, also where it was cut off.
import { McapStreamReader } from '@mcap/core';
import { decompress } from 'fzstd';

import { described, difference } from './architecture_text.js';
import { CdrReader } from './cdr.js';
import { DescribedRobot } from './described_robot.js';
import { planStep } from './live.js';
import { RecordedOncilla } from './recorded_oncilla.js';

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
        if (!channels.has(record.id)) channels.set(record.id, { topic: record.topic, metadata: record.metadata, schema: schemas.get(record.schemaId), beats: [], origins: [], values: [], texts: [], times: [], messages: [] });
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

function take(channel, { data, logTime }) {
  const from = new CdrReader(data);
  if (channel.topic === '/cca/state' || channel.topic === '/cca/fault') {
    channel.beats.push(from.integer());
    const texts = [];
    while (!from.isOver) texts.push(from.text());
    channel.texts.push(texts);
  } else if (channel.topic === '/robot_description' || channel.topic === '/tf') {
    channel.times.push(Number(logTime) * 1e-9);
    channel.messages.push(data.slice());
  } else if (channel.metadata.has('axes')) {  // a port; beside it are messages for other viewers
    channel.beats.push(from.integer());
    channel.origins.push(from.integer() * 1e-9);
    while (!from.isOver) channel.values.push(from.number());
  }
}

export class Recording {
  constructor(architecture, channels, metadata, cut, known) {
    this.isLive = false;
    this.isRecording = true;
    this.isCut = cut;
    this.metadata = metadata;
    this.period = Number(architecture.ns_a_beat) * 1e-9;
    this.channels = new Map(channels.map((c) => [c.topic, c]));
    this.description = described(architecture, this.channels, metadata.get('cca.places'));
    this.beats = 0;
    for (const c of channels) for (const time of c.times) c.beats.push(Math.round(time / this.period));  // of a viewer's message
    for (const c of channels) if (c.metadata.has('axes') && c.beats.length > 0) this.beats = Math.max(this.beats, c.beats.at(-1) + 1);
    this.beat = 0;
    this.first = 0;
    this.memory = new Float64Array(this.description.coordinates);
    const differences = known.map((one) => difference(this.description, one));
    this.difference = differences.includes('') ? '' : differences[0] ?? '';
    const same = known[differences.indexOf('')];
    Object.assign(this.description, { plan: same?.plan, plots: same?.plots });
    this.findRobot((same ?? known.find((one) => one.robot?.kind === 'oncilla'))?.robot);
    this.seek(0);
  }

  port(ending, size) {
    return this.description.outputs.findIndex((o) => o.path.endsWith(`.${ending}`) && (!size || o.fields.length === size));
  }
  // An Oncilla is drawn as on a live page, any other robot as the recording describes it (cca::shows).
  findRobot(known) {
    this.contacts = this.port('contacts', 4);
    this.robot = RecordedOncilla.in(this, known) ?? DescribedRobot.in(this);
    if (this.robot) this.description.robot = this.robot.shown;
  }

  // ---- as of a live controller ----

  get time() { return this.beat * this.period; }
  get duration() { return this.beats * this.period; }
  get runs() { return false; }
  seek(beat) {
    this.beat = Math.min(this.beats, Math.max(0, Math.round(beat)));
    const state = this.last('/cca/state'), fault = this.last('/cca/fault');
    this.status = { beat: this.beat, state: state?.[0] ?? '', fault: fault?.[1] ?? '', faultPath: fault?.[0] ?? '', snapshots: [] };
    if (fault && this.beat >= this.beats) this.status.state = 'faulted';
    this.robot?.pose(this);
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
    const first = Math.max(0, this.index(channel, from / this.period)), last = this.index(channel, to / this.period + 1);
    const stride = Math.max(1, Math.ceil((last - first) / most));
    for (let i = first; i <= last; i += stride) {
      times.push(channel.beats[i] * this.period);
      values.push(channel.values[i * fields.length + coordinate]);
    }
    return [times, values];
  }
  get hasContacts() { return this.contacts >= 0 && this.description.robot?.points.length === 4; }
  contact(leg, beat) { return (this.sample(this.contacts, beat + 1)?.[leg] ?? 0) > 0; }
  position() { return null; }
  get poses() { return this.robot?.poses; }
  forces() { return this.robot.forces(this); }
  targets() { return this.robot.targets(this); }
  step() { return planStep(this); }
  get fallen() { return false; }
}
