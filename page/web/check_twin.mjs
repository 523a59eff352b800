// The live twin of a running program: the same bits, one constant that differs, a client that comes late, and what it
// says where it can't tell. In node, and on the page.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import WebSocket from 'ws';

import { freePort, run } from './check_door.mjs';
import { Twin, twinText } from './src/twin.js';

const token = '0123456789abcdef0123456789abcdef';
const secondsOf = (ms) => new Promise((done) => setTimeout(done, ms));

// The last that a twin tells: when `isEnough`, or after some seconds.
function follow(socket, isEnough, seconds = 30) {
  return new Promise((done) => {
    let last = null;
    const end = () => { twin.stop(); done(last); };
    const late = setTimeout(end, 1e3 * seconds);
    const twin = new Twin(socket, undefined, (told) => {
      last = told;
      if (told.state === 'differs' || told.state === 'unknown' || isEnough(told)) { clearTimeout(late); setTimeout(end); }
    });
  });
}
// A door that answers each request for an asset as `answer(uri)` says.
function fakeDoor(answer) {
  const socket = {
    send(text) {
      const { requestId, uri } = JSON.parse(text), [why, data] = answer(uri);
      const message = Buffer.concat([Buffer.from([4]), Buffer.alloc(9), Buffer.from(why), data]);
      message.writeUInt32LE(requestId, 1);
      message[5] = why ? 1 : 0;
      message.writeUInt32LE(Buffer.byteLength(why), 6);
      setTimeout(() => socket.onmessage({ data: new Uint8Array(message).buffer }));
    },
    close() {},
  };
  setTimeout(() => socket.onopen());
  return socket;
}
const piece = (bytes, size) => {
  const head = Buffer.alloc(8);
  head.writeBigUInt64LE(BigInt(size));
  return Buffer.concat([head, bytes]);
};

// Bytes a second of all ports of the program, with the heads of their messages and frames.
function bytesOfAll(port, ms) {
  return new Promise((done) => {
    const socket = new WebSocket(`ws://127.0.0.1:${port}/`, ['foxglove.websocket.v1']);
    let bytes = 0, first = null, last = 0, messages = 0;
    socket.on('message', (data, isBinary) => {
      if (!isBinary) {
        const { op, channels } = JSON.parse(data);
        if (op === 'advertise') socket.send(JSON.stringify({ op: 'subscribe', subscriptions: channels.filter((c) => c.metadata?.axes).map(({ id }) => ({ id, channelId: id })) }));
        return;
      }
      if (data[0] !== 1) return;
      const beat = Number(data.readBigInt64LE(17));
      first ??= beat;
      last = Math.max(last, beat);
      bytes += data.length + (data.length < 126 ? 2 : 4);
      ++messages;
    });
    setTimeout(() => { socket.close(); done({ perBeat: bytes / (last - first + 1), messages: messages / (last - first + 1), beats: last - first + 1 }); }, ms);
  });
}

export async function checkTwin(tools) {
  const { options, check, text, picture, accessible, press, browser, complaints } = tools;
  const folder = `${options.pictures}/twin`;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const port = await freePort(), url = `ws://127.0.0.1:${port}/`;
  const socket = () => new WebSocket(url, ['foxglove.websocket.v1']);
  const start = (twin) => run(options, port, token, folder, twin ? ['--twin', twin] : []);

  // ---- without the twin's program ----
  let program = await start('');
  let told = await follow(socket(), () => false);
  check('twin: a program without it says how to give it', told.state === 'unknown' && /--twin FILE/.test(told.why), told);
  program.kill('SIGKILL');
  await program.ended;

  // ---- the same bits ----
  program = await start(options.twin);
  told = await follow(socket(), (t) => t.beats > 3000 && t.behind === 0);
  check('twin: the same, bit for bit', told.state === 'same' && told.beats > 3000 && told.samples > 3 * told.beats, told);
  const all = await bytesOfAll(port, 3000);
  check('twin: what it needs is a part of all outputs', told.bytes / told.beats < 0.6 * all.perBeat, { twin_bytes_a_beat: told.bytes / told.beats, all_outputs: all });
  const earlier = told.beats;
  told = await follow(socket(), (t) => t.beats > 0 && t.behind === 0, 90);
  check('twin: who comes later computes all from the first beat on', told.state === 'same' && told.beats > earlier + 1000, told);

  // ---- on the page ----
  const visit = async () => {
    const page = await browser.newPage();
    page.setDefaultTimeout(60_000);
    page.on('console', (m) => { if (['error', 'warn'].includes(m.type()) && !/ERR_CONNECTION_REFUSED|closed before|ERR_CONNECTION_RESET/.test(m.text())) complaints.push(`twin: ${m.type()}: ${m.text()}`); });
    page.on('pageerror', (error) => complaints.push(`twin: ${error.message}`));
    await page.setViewport({ width: 1280, height: 900 });
    await page.goto(`http://127.0.0.1:${port}/#token=${token}`);
    await page.waitForSelector('[data-node]');
    return page;
  };
  const says = (page, expected, id = 'twin') => page.waitForFunction((i, e) => new RegExp(e).test(document.getElementById(i).textContent), { timeout: 60_000 }, id, expected).then(() => true, () => false);
  const beats = async (page) => Number(/: (\d+) beats/.exec(await text(page, '#twin'))?.[1] ?? -1);
  let page = await visit();
  await press(page, '#twin-run');
  check('twin: the page says so', await says(page, '^the same, bit for bit: \\d+ beats'), await text(page, '#twin'));
  await says(page, 'nobody commands', 'commander');
  await press(page, '#command');
  await says(page, 'this page commands', 'commander');
  await page.$eval('[data-path="cpg.frequency"]', (e) => { e.value = '3.5'; e.dispatchEvent(new Event('change')); });
  await says(page, 'cpg.frequency = 3.5', 'message');
  await page.focus('[data-command="push"]');
  await page.keyboard.down('Space');
  await secondsOf(300);
  await page.keyboard.up('Space');
  const before = await beats(page);
  await page.waitForFunction((b) => Number(/: (\d+) beats/.exec(document.getElementById('twin').textContent)?.[1] ?? 0) > b + 1000, {}, before);
  check('twin: still the same after a changed parameter and a push', /^the same, bit for bit/.test(await text(page, '#twin')), await text(page, '#twin'));
  await page.evaluate(() => scrollTo(0, 0));
  await accessible(page, 'twin');
  await picture(page, 'twin');
  program.kill('SIGKILL');
  await program.ended;
  check('twin: without a connection it can\'t tell any more', await says(page, '^can.t tell any more: .* Before that it was the same'), await text(page, '#twin'));
  await page.close();

  // ---- a twin that computes with one bit of one constant, 2 pi, that differs ----
  const changed = readFileSync(options.twin), whole = Buffer.alloc(8);
  whole.writeDoubleLE(2 * Math.PI);
  let places = 0;
  for (let at = changed.indexOf(whole); at >= 0; at = changed.indexOf(whole, at + 8), ++places) changed[at] ^= 1;
  writeFileSync(`${folder}/changed.wasm`, changed);
  program = await start(`${folder}/changed.wasm`);
  told = await follow(socket(), () => false);
  const numbers = (sample) => sample.match(/\[(.*)\]/)[1].split(' ').map(Number);
  check('twin: one bit of a constant is found: component, port, beat, and both values', places > 0 && told.state === 'differs' && told.component === 'cpg' && told.beat < 300
    && /^\[.*\] of \d+ ns$/.test(told.robot) && told.robot !== told.twin && numbers(told.robot).every((x, i) => Math.abs(x - numbers(told.twin)[i]) < 1e-6), told);
  page = await visit();
  await press(page, '#twin-run');
  check('twin: the page names it', await says(page, `^first difference: component cpg, port ${told.port}, beat ${told.beat}: robot `), await text(page, '#twin'));
  await picture(page, 'twin-differs');
  const input = await page.$('#twin-file');
  await input.uploadFile(options.twin);
  check('twin: its program may come from a file', await says(page, '^the same, bit for bit'), await text(page, '#twin'));
  writeFileSync(`${folder}/none.wasm`, 'no program');
  await input.uploadFile(`${folder}/none.wasm`);
  check('twin: what is no program is refused', await says(page, '^can.t tell: .*(WebAssembly|magic)'), await text(page, '#twin'));
  await page.close();
  program.kill('SIGKILL');
  await program.ended;

  // ---- where it can't tell ----
  const code = readFileSync(options.twin);
  told = await follow(fakeDoor((uri) => (uri.includes('program') ? ['', piece(code.subarray(Number(uri.split('=')[1])), code.length)] : ['too late: this door keeps the last 10 of 20 bytes', Buffer.alloc(0)])), () => false);
  check('twin: too late is no answer', told.state === 'unknown' && twinText(told) === 'can\'t tell: too late: this door keeps the last 10 of 20 bytes', told);
  told = await follow(fakeDoor((uri) => ['', uri.includes('program') ? piece(code.subarray(Number(uri.split('=')[1])), code.length) : piece(Buffer.from([0, 0, 1, 0, 0, 0, 0, 0, 0, 0]), 10)]), () => false);
  check('twin: a damaged stream is no answer', told.state === 'unknown' && /stream is damaged/.test(told.why), told);
}

// Who commands a program from node: `call` answers with the reason of a refusal, `set` with the value then.
function commander(url) {
  const socket = new WebSocket(url, ['foxglove.websocket.v1', `cca.token.${token}`]), services = new Map(), waiting = new Map();
  let last = 0;
  const later = (what, send) => new Promise((done, refuse) => {
    const id = ++last;
    waiting.set(String(id), done);
    setTimeout(() => refuse(new Error(`the program does not answer ${what}`)), 20_000).unref();
    send(id);
  });
  const call = (name, request = {}) => later(name, (id) => {
    const text = Buffer.from(`json${JSON.stringify(request)}`), message = Buffer.concat([Buffer.alloc(13), text]);
    message[0] = 2;
    [services.get(name), id, 4].forEach((number, i) => message.writeUInt32LE(number, 1 + 4 * i));
    socket.send(message);
  });
  const set = (name, value) => later(name, (id) => socket.send(JSON.stringify({ op: 'setParameters', id: String(id), parameters: [{ name, value }] })));
  socket.on('message', (data, isBinary) => {
    if (isBinary) {
      if (data[0] !== 3) return;
      const answer = JSON.parse(data.subarray(13 + data.readUInt32LE(9)));
      return waiting.get(String(data.readUInt32LE(5)))?.(answer.success ? '' : answer.message);
    }
    const m = JSON.parse(data);
    if (m.op === 'advertiseServices') for (const { id, name } of m.services) services.set(name, id);
    if (m.op === 'parameterValues') waiting.get(m.id)?.(m.parameters[0]?.value);
  });
  return new Promise((done) => {
    const look = setInterval(() => { if (services.has('/cca/take_command')) { clearInterval(look); done({ call, set }); } }, 20);
  });
}

// The program of a robot on drives, in two environments, while somebody changes a parameter and pushes. In a fast run,
// since in one by the clock a sample may come late, and then no other machine can tell what was computed.
export async function checkTwinOnDrives({ options, check }) {
  const folder = `${options.pictures}/twin_on_drives`;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const port = await freePort(), url = `ws://127.0.0.1:${port}/`;
  const program = await run({ program: options['drives-program'] }, port, token, folder, ['--paused', '--pace', 'lock-step', '--twin', options['drives-twin']]);
  const user = await commander(url), socket = () => new WebSocket(url, ['foxglove.websocket.v1']);
  // At least `beats`, and 500 after `change`; then a pause.
  const compare = async (beats, change = async () => []) => {
    let isChanged = false, least = null;
    const told = follow(socket(), (t) => isChanged && t.beats > (least ??= Math.max(beats, t.beats + 500)), 90);
    const done = [await user.call('/cca/go_on'), ...await change()];
    isChanged = true;
    return { ...await told, done: JSON.stringify([...done, await user.call('/cca/pause')]) };
  };
  await user.call('/cca/take_command');
  let told = await compare(1000);
  check('twin on drives: the same, bit for bit', told.state === 'same' && told.beats > 1000 && told.samples > 10 * told.beats && told.done === '["",""]', told);
  told = await compare(told.beats + 1000, async () => [await user.set('cpg.frequency', 3.5), await user.call('/cca/command/push', { forward: 30, left: 20 })]);
  check('twin on drives: still the same after a changed parameter and a push', told.state === 'same' && told.beats > 2000 && told.done === '["",3.5,"",""]', told);
  program.kill('SIGKILL');
  await program.ended;
}
