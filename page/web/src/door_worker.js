// The connection to a door, in a thread of its own, so that the one that draws never waits for it. 100,000 samples a
// second come in some hundred messages (docs/door.md: cca.batches.v1); no object is made for a sample.
// It keeps the newest sample of each port and as many of the others as a plot shows, and hands them over sixty
// times a second as one array: channel, beat, origin (ns), numbers, channel, ...

const ofSample = 1, ofTime = 2, ofAnswer = 3, ofBatch = 0xca, cdrHead = 4;
let socket = null, ports = new Map(), apart = 1, full = new Set();
let raw = new Map(), texts = [], statusText = null, time = 0;
let statusId = -1, logId = -1;

// Numbers that were kept, in an array that grows to what one hand-over needs.
const kept = {
  numbers: new Float64Array(1 << 14),
  size: 0,
  add(some) {
    if (this.size + some.length > this.numbers.length) {
      const more = new Float64Array(2 * this.numbers.length + some.length);
      more.set(this.numbers.subarray(0, this.size));
      this.numbers = more;
    }
    for (let i = 0; i < some.length; ++i) this.numbers[this.size + i] = some[i];
    this.size += some.length;
  },
};

// An int64 as a number: exact below 2^53, which is 104 days of nanoseconds.
const whole = (view, at) => view.getUint32(at, true) + 4294967296 * view.getInt32(at + 4, true);

// A port's channel: whether the sample is one to keep, and its newest.
class Port {
  constructor(id, size) {
    Object.assign(this, { id, size, last: -Infinity, isWaiting: false, newest: new Float64Array(3 + size), isFull: full.has(id) });
  }
  take(view, begin, length) {
    if (length < cdrHead + 16 + 8 * this.size) return;
    const { newest } = this, beat = whole(view, begin + cdrHead);
    if (this.isWaiting && (this.isFull || newest[1] - this.last >= apart)) this.keep();
    if (beat < newest[1]) this.last = -Infinity;  // it has begun anew
    newest[0] = this.id;
    newest[1] = beat;
    newest[2] = whole(view, begin + cdrHead + 8);
    for (let i = 3, at = begin + cdrHead + 16; i < newest.length; ++i, at += 8) newest[i] = view.getFloat64(at, true);
    this.isWaiting = true;
  }
  keep() {
    kept.add(this.newest);
    this.last = this.newest[1];
    this.isWaiting = false;
  }
}

function takeSample(view, id, begin, length) {
  const port = ports.get(id);
  if (port) port.take(view, begin, length);
  else if (id === statusId) statusText = textOf(view, begin, length);
  else if (id === logId) texts.push(`{"op":"log","line":${textOf(view, begin, length)}}`);
  else raw.set(id, view.buffer.slice(begin, begin + length));
}
function takeBatch(view) {
  const end = view.byteLength;
  for (let at = 1; at + 16 <= end;) {
    const length = view.getUint32(at + 12, true);
    if (at + 16 + length > end) return;
    takeSample(view, view.getUint32(at, true), at + 16, length);
    at += 16 + length;
  }
}
function hear({ data }) {
  if (typeof data === 'string') return void texts.push(data);
  const view = new DataView(data), what = view.getUint8(0);
  if (what === ofBatch) takeBatch(view);
  else if (what === ofSample) takeSample(view, view.getUint32(1, true), 13, data.byteLength - 13);  // of a door that knows no batches
  else if (what === ofTime) time = whole(view, 1);
  else if (what === ofAnswer) {
    const begin = 13 + view.getUint32(9, true);
    texts.push(JSON.stringify({ op: 'answer', call: view.getUint32(5, true), answer: textOf(view, begin, data.byteLength - begin) }));
  }
}
const utf8 = new TextDecoder();
const textOf = (view, begin, length) => utf8.decode(new Uint8Array(view.buffer, begin, length));

function forget() {
  kept.size = 0;
  raw = new Map(), texts = [], statusText = null;
}
function handOver() {
  for (const port of ports.values()) if (port.isWaiting) port.keep();
  if (kept.size === 0 && texts.length === 0 && statusText === null && raw.size === 0) return;
  const samples = kept.numbers.slice(0, kept.size);
  self.postMessage({ samples, texts, status: statusText, raw: [...raw], time }, [samples.buffer]);
  forget();
}
setInterval(handOver, 1000 / 60);

const tasks = {
  connect({ url, protocols }) {
    socket?.close();
    ports = new Map();
    forget();
    const mine = (socket = new WebSocket(url, protocols));
    mine.binaryType = 'arraybuffer';
    mine.onopen = () => { if (mine === socket) self.postMessage({ opened: true }); };
    mine.onmessage = (message) => { if (mine === socket) hear(message); };
    mine.onclose = ({ code, reason }) => {
      if (mine !== socket) return;
      handOver();
      socket = null;
      self.postMessage({ closed: { code, reason } });
    };
  },
  send({ message }) { if (socket?.readyState === WebSocket.OPEN) socket.send(message); },
  // `list`: id and count of numbers of each port; `between`: beats between two samples that are kept.
  ports({ list, between, status, log }) {
    ports = new Map(list.map(([id, size]) => [id, new Port(id, size)]));
    apart = between;
    statusId = status;
    logId = log;
  },
  full({ ids }) {
    full = new Set(ids);
    for (const port of ports.values()) port.isFull = full.has(port.id);
  },
  close() { socket?.close(); },
};
self.onmessage = ({ data }) => tasks[data.do](data);
