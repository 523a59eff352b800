// The connection to a door, in a thread of its own: 100,000 messages a second are too many for the one that draws.
// It keeps the newest sample of each port and as many of the others as a plot shows, and hands them over sixty
// times a second as one array: channel, beat, origin (ns), numbers, channel, ...

const ofSample = 1, ofTime = 2, ofAnswer = 3, head = 13, cdrHead = 4;
let socket = null, ports = new Map(), apart = 1, full = new Set();
let kept = [], raw = new Map(), texts = [], statusText = null, time = 0;

// A port's channel: whether the sample is one to keep, and its newest.
class Port {
  constructor(id, size) {
    Object.assign(this, { id, size, last: -Infinity, isWaiting: false, newest: new Float64Array(3 + size) });
  }
  take(view) {
    let at = head + cdrHead;
    const beat = Number(view.getBigInt64(at, true));
    if (this.isWaiting && (full.has(this.id) || this.newest[1] - this.last >= apart)) this.keep();
    if (beat < this.newest[1]) this.last = -Infinity;  // it has begun anew
    this.newest[0] = this.id;
    this.newest[1] = beat;
    this.newest[2] = Number(view.getBigInt64(at + 8, true));
    at += 16;
    for (let i = 0; i < this.size; ++i, at += 8) this.newest[3 + i] = view.getFloat64(at, true);
    this.isWaiting = true;
  }
  keep() {
    for (const number of this.newest) kept.push(number);
    this.last = this.newest[1];
    this.isWaiting = false;
  }
}

function hear({ data }) {
  if (typeof data === 'string') return void texts.push(data);
  const view = new DataView(data), what = view.getUint8(0);
  if (what === ofSample) {
    const id = view.getUint32(1, true), port = ports.get(id);
    if (port) {
      if (data.byteLength >= head + cdrHead + 16 + 8 * port.size) port.take(view);
    } else if (id === statusId) statusText = textOf(data, head);
    else if (id === logId) texts.push(`{"op":"log","line":${textOf(data, head)}}`);
    else raw.set(id, data.slice(head));
  } else if (what === ofTime) time = Number(view.getBigUint64(1, true));
  else if (what === ofAnswer) {
    const size = view.getUint32(9, true);
    texts.push(JSON.stringify({ op: 'answer', call: view.getUint32(5, true), answer: textOf(data, head + size) }));
  }
}
const textOf = (data, from) => new TextDecoder().decode(new Uint8Array(data, from));
let statusId = -1, logId = -1;

function handOver() {
  for (const port of ports.values()) if (port.isWaiting) port.keep();
  if (kept.length === 0 && texts.length === 0 && statusText === null && raw.size === 0) return;
  const samples = Float64Array.from(kept);
  self.postMessage({ samples, texts, status: statusText, raw: [...raw], time }, [samples.buffer]);
  kept = [], raw = new Map(), texts = [], statusText = null;
}
setInterval(handOver, 1000 / 60);

const tasks = {
  connect({ url, protocols }) {
    socket?.close();
    ports = new Map();
    kept = [], texts = [], raw = new Map(), statusText = null;
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
  full({ ids }) { full = new Set(ids); },
  close() { socket?.close(); },
};
self.onmessage = ({ data }) => tasks[data.do](data);
