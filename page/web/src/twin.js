// A live twin: the controller of a program that runs, as WebAssembly, fed with what its robot sensed. It asks the
// program's door for one piece of the stream after the other (docs/door.md), on a connection of its own, and tells
//
//   { state: 'begins' | 'same' | 'differs' | 'unknown', beats, samples, behind, bytes, why, component, port, beat, robot, twin }
//
// `same`: all beats so far, bit for bit; `behind`: bytes of the stream that it has not read yet. `differs`: the first
// sample that is not. `unknown`: it can't tell, and `why`; what was compared before was the same.
import { fileSystem } from './files.js';

const waitBeforeMore = 50;  // ms
const ofAsset = 4;

class Refused extends Error {}

// The program of a twin (page/wasm/twin_exports.cpp).
export async function startTwin(code) {
  let memory = null;
  const text = (at, size) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, size));
  const { instance } = await WebAssembly.instantiate(code, {
    wasi_snapshot_preview1: fileSystem({}, () => memory),
    page: { refuse(at, size) { throw new Refused(text(at, size)); } },
  });
  const { exports: program } = instance;
  for (const name of ['begin', 'room', 'take', 'result', 'text_size']) if (!program[name]) throw new Refused('this is no program of a twin');
  memory = program.memory;
  program._initialize();
  return {
    take(bytes) {
      const to = program.room(bytes.length);
      new Uint8Array(memory.buffer, to, bytes.length).set(bytes);
      program.take();
    },
    result() {
      const at = program.result();  // before its size is asked
      return JSON.parse(text(at, program.text_size()));
    },
  };
}

// A sample as the twin writes it: `[0.1 0.2] of 5 ns`.
export function sampleText(message) {
  const view = new DataView(message.buffer, message.byteOffset), numbers = [];
  for (let at = 20; at + 8 <= view.byteLength; at += 8) numbers.push(exact(view.getFloat64(at, true)));
  return `[${numbers.join(' ')}] of ${view.getBigInt64(12, true)} ns`;
}
const exact = (number) => (Object.is(number, -0) ? '-0' : String(number));
// The twin writes 17 digits; as many as tell two numbers apart are enough.
const shortened = (text) => text.replace(/-?\d[\d.]*(?:e[+-]?\d+)?(?=[ \]])/g, (digits) => exact(Number(digits)));

export class Twin {
  // `socket`: a WebSocket that is being connected to a door. `code`: the bytes of the twin's program; else the door's.
  constructor(socket, code, tell) {
    Object.assign(this, { socket, code, tell, requests: 0, waiting: new Map(), channels: new Map(), at: 0, last: { beats: 0, samples: 0 }, isOver: false });
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.run().catch((error) => this.end(error.message));
    socket.onmessage = ({ data }) => (typeof data === 'string' ? this.hear(JSON.parse(data)) : this.take(data));
    socket.onclose = ({ reason }) => this.end(reason || 'the connection is lost');
    socket.onerror = () => {};
    this.say('begins');
  }
  stop() {
    this.isOver = true;
    this.socket.close();
  }

  say(state, more = {}) { this.tell({ state, beats: this.last.beats, samples: this.last.samples, bytes: this.at, behind: 0, ...more }); }
  end(why) {
    if (this.isOver) return;
    this.say('unknown', { why });
    this.stop();
  }

  hear(message) {
    if (message.op === 'advertise') for (const { id, topic } of message.channels) this.channels.set(topic, id);
    else if (message.op === 'status' && message.level === 2) this.end(message.message);
  }
  take(data) {
    const view = new DataView(data);
    if (view.getUint8(0) !== ofAsset) return;
    const answer = this.waiting.get(view.getUint32(1, true)), size = view.getUint32(6, true);
    this.waiting.delete(view.getUint32(1, true));
    if (view.getUint8(5) === 0) answer?.done(new Uint8Array(data, 10 + size));
    else answer?.refuse(new Refused(new TextDecoder().decode(new Uint8Array(data, 10, size))));
  }
  ask(uri) {
    return new Promise((done, refuse) => {
      this.waiting.set(++this.requests, { done, refuse });
      this.socket.send(JSON.stringify({ op: 'fetchAsset', uri: `cca://twin/${uri}`, requestId: this.requests }));
    });
  }
  // A piece from a place on, and where the end is.
  async piece(of, from) {
    const data = await this.ask(`${of}?from=${from}`);
    const size = new DataView(data.buffer, data.byteOffset).getBigUint64(0, true);
    return [data.subarray(8), Number(size)];
  }

  async run() {
    const program = await startTwin(this.code ?? await this.program());
    while (!this.isOver) {
      const [bytes, end] = await this.piece('stream', this.at);
      this.at += bytes.length;
      if (bytes.length > 0) {
        program.take(bytes);
        this.last = program.result();
        if (this.last.difference) return this.differs();
        if (this.last.endedEarly) return this.end(this.last.endedEarly);
      }
      this.say('same', { behind: end - this.at });
      if (end === this.at) await new Promise((done) => setTimeout(done, waitBeforeMore));
    }
  }
  async program() {
    const pieces = [];
    for (let size = 0, end = 1; size < end;) {
      const [bytes, all] = await this.piece('program', size);
      if (bytes.length === 0) break;
      pieces.push(bytes);
      size += bytes.length;
      end = all;
    }
    return new Blob(pieces).arrayBuffer();
  }
  // With what the robot has published, if the door still has it.
  async differs() {
    const { component, port, beat, difference } = this.last;
    const found = /: robot (.*), twin (.*)$/s.exec(difference);
    const told = { component, port, beat, robot: shortened(found?.[1] ?? ''), twin: shortened(found?.[2] ?? difference) };
    const channel = this.channels.get(`/${component}.${port}`.replaceAll('.', '/'));
    if (told.robot === 'other bits' && channel !== undefined)
      await this.ask(`value?channel=${channel}&beat=${beat}`).then((data) => { told.robot = sampleText(data); }, () => { told.robot = 'other bits (its value is no longer kept)'; });
    this.say('differs', told);
    this.stop();
  }
}

// What a person reads.
export function twinText({ state, beats, samples, behind, why, component, port, beat, robot, twin }) {
  const so = `${beats} beats, ${samples} samples`;
  if (state === 'begins') return 'the twin begins';
  if (state === 'same') return behind > 0 ? `catches up; the same, bit for bit, so far: ${so}` : `the same, bit for bit: ${so}`;
  if (state === 'unknown') return beats > 0 ? `can't tell any more: ${why}. Before that it was the same, bit for bit: ${so}` : `can't tell: ${why}`;
  return `first difference: component ${component}${port ? `, port ${port}` : ''}, beat ${beat}: robot ${robot}, twin ${twin}`;
}
