// A door with no program behind it: a page, and many outputs at a high rate, so that the page's own speed is seen.
//   node many_outputs.mjs PAGE.html PORT     100 outputs of 3 numbers at 1 kHz, from 10 components
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { pathToFileURL } from 'node:url';

const components = 10, each = 10, numbers = 3, hertz = 1000;
const outputs = Array.from({ length: components * each }, (_, i) => ({ id: i + 1, path: `component_${Math.floor(i / each)}.output_${i % each}` }));
const text = ['1000000 ns a beat', ...Array.from({ length: components }, (_, c) => `node component_${c}, fires every 1 beats from 0`),
  ...outputs.map(({ path }) => `output ${path}: ${numbers} numbers, space 1`),
  ...Array.from({ length: components - 1 }, (_, c) => `wire to component_${c + 1}.input from output ${c * each}, delayed 0`)].join('\n');

function frame(opcode, payload) {
  const head = payload.length < 126 ? Buffer.from([0x80 | opcode, payload.length]) : payload.length < 65536 ? Buffer.from([0x80 | opcode, 126, payload.length >> 8, payload.length & 255]) : Buffer.alloc(10);
  if (payload.length >= 65536) {
    head[0] = 0x80 | opcode;
    head[1] = 127;
    head.writeBigUInt64BE(BigInt(payload.length), 2);
  }
  return Buffer.concat([head, payload]);
}
const say = (socket, message) => socket.write(frame(1, Buffer.from(JSON.stringify(message))));

// The text messages that a client sends: short ones, each in a frame of its own.
function* messages(state, bytes) {
  state.bytes = Buffer.concat([state.bytes, bytes]);
  for (;;) {
    const b = state.bytes;
    if (b.length < 2) return;
    let size = b[1] & 127, at = 2;
    if (size === 126) { if (b.length < 4) return; size = b.readUInt16BE(2); at = 4; }
    if (b.length < at + 4 + size) return;
    const mask = b.subarray(at, at + 4), payload = Buffer.from(b.subarray(at + 4, at + 4 + size).map((byte, i) => byte ^ mask[i & 3]));
    state.bytes = b.subarray(at + 4 + size);
    if ((b[0] & 15) === 1) yield JSON.parse(payload);
  }
}

export function manyOutputs(page, port = 0) {
  const server = createServer((request, response) => response.end(readFileSync(page)));
  server.beats = 0;
  server.on('upgrade', (request, socket) => {
    const key = createHash('sha1').update(`${request.headers['sec-websocket-key']}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`).digest('base64');
    socket.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${key}\r\nSec-WebSocket-Protocol: foxglove.websocket.v1\r\n\r\n`);
    socket.setNoDelay(true);
    say(socket, { op: 'serverInfo', name: 'many outputs', capabilities: [], sessionId: '1' });
    say(socket, { op: 'advertise', channels: outputs.map(({ id, path }) => ({ id, topic: `/${path.replaceAll('.', '/')}`, encoding: 'cdr', schemaName: 'a', schema: `int64 beat\nint64 origin\n${'float64 x\n'.repeat(numbers)}`, metadata: { axes: 'x y z', space: 'a' } })) });
    say(socket, { op: 'advertiseServices', services: [] });
    const state = { bytes: Buffer.alloc(0) }, wanted = new Set();
    socket.on('data', (bytes) => {
      for (const m of messages(state, bytes)) {
        if (m.op === 'cca.describe') say(socket, { op: 'cca.description', program: 'many outputs', architecture: text, modes: [], parts: [], nodes: [], wires: [], commands: [], parameters: [] });
        if (m.op === 'subscribe') for (const { id } of m.subscriptions) wanted.add(id);
        if (m.op === 'unsubscribe') for (const id of m.subscriptionIds) wanted.delete(id);
      }
    });
    const size = 13 + 4 + 16 + 8 * numbers, begun = performance.now();
    let beat = 0;
    const send = () => {
      const due = Math.floor(((performance.now() - begun) * hertz) / 1e3);
      for (; beat < due; ++beat) {
        const bytes = Buffer.alloc(wanted.size * (2 + size));
        let at = 0;
        for (const id of wanted) {
          bytes[at] = 0x82;
          bytes[at + 1] = size;
          bytes[at + 2] = 1;
          bytes.writeUInt32LE(id, at + 3);
          bytes.writeBigUInt64LE(BigInt(beat) * 1000000n, at + 7);
          bytes[at + 16] = 1;
          bytes.writeBigInt64LE(BigInt(beat), at + 19);
          bytes.writeBigInt64LE(BigInt(beat) * 1000000n, at + 27);
          for (let k = 0; k < numbers; ++k) bytes.writeDoubleLE(Math.sin(beat * 1e-3 * (id + k)), at + 35 + 8 * k);
          at += 2 + size;
        }
        if (at > 0) socket.write(bytes);
      }
      server.beats = beat;
    };
    const timer = setInterval(send, 2);
    const end = () => clearInterval(timer);
    socket.on('close', end).on('error', end);
    server.on('ends', () => socket.destroy());
  });
  return new Promise((done) => server.listen(port, '127.0.0.1', () => done(server)));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const server = await manyOutputs(process.argv[2], Number(process.argv[3]));
  console.log(`http://127.0.0.1:${server.address().port}/`);
}
