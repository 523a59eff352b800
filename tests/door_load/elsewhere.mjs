// What a page of elsewhere can do to a door on this machine, in a real browser: nothing. It is served here, and
// tries WebSockets, requests without CORS, forms, frames, scripts, and a name that points to this machine.
//   node elsewhere.mjs --program PROGRAM --out FOLDER
// PROGRAM is one of cca::robot_main with the option --door. Exit code 0: no attempt got in, none changed
// anything, and the door's own page still can connect in the same browser. Needs chromium.
import { spawn } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createServer as createHttpServer } from 'node:http';
import { connect, createServer } from 'node:net';

const given = {};
for (let i = 2; i < process.argv.length; i += 2) given[process.argv[i]] = process.argv[i + 1];
const { '--program': program, '--out': out } = given;
if (!program || !out) { console.error('usage: elsewhere.mjs --program PROGRAM --out FOLDER'); process.exit(2); }

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
const freePort = () => new Promise((done) => {
  const server = createServer().listen(0, '127.0.0.1', () => { const { port } = server.address(); server.close(() => done(port)); });
});
let failed = 0;
const check = (what, passed, seen = '') => {
  if (!passed) ++failed;
  console.log(`${passed ? 'passed' : 'FAILED'}: ${what}${passed ? '' : `: ${JSON.stringify(seen)}`}`);
};

// A client of the door on a socket, which sees what changes: no library is needed.
class Watcher {
  texts = []; status = {}; log = []; head = '';
  constructor(port, headers = {}) {
    this.bytes = Buffer.alloc(0);
    this.socket = connect(port, '127.0.0.1');
    this.socket.on('error', () => {});
    const all = { Host: `127.0.0.1:${port}`, Upgrade: 'websocket', Connection: 'Upgrade', 'Sec-WebSocket-Version': '13', 'Sec-WebSocket-Key': randomBytes(16).toString('base64'), 'Sec-WebSocket-Protocol': 'foxglove.websocket.v1', ...headers };
    this.socket.write(`GET / HTTP/1.1\r\n${Object.entries(all).map(([name, value]) => `${name}: ${value}\r\n`).join('')}\r\n`);
    this.socket.on('data', (piece) => { this.bytes = Buffer.concat([this.bytes, piece]); while (this.take()); });
    this.answered = new Promise((done) => { this.isAnswered = done; });
  }
  send(message, first = 0x81) {
    const payload = Buffer.from(typeof message === 'string' ? message : JSON.stringify(message));
    this.socket.write(Buffer.concat([Buffer.from([first, 0x80 | payload.length, 0, 0, 0, 0]), payload]));  // below 126 bytes, masked with zeros
  }
  take() {
    if (!this.head) {
      const end = this.bytes.indexOf('\r\n\r\n');
      if (end < 0) return false;
      this.head = this.bytes.subarray(0, end).toString();
      this.bytes = this.bytes.subarray(end + 4);
      this.isAnswered(this.head);
    }
    if (!this.head.startsWith('HTTP/1.1 101') || this.bytes.length < 2) return false;
    let size = this.bytes[1] & 127, at = 2;
    if (size === 126) { if (this.bytes.length < 4) return false; size = this.bytes.readUInt16BE(2); at = 4; }
    else if (size === 127) { if (this.bytes.length < 10) return false; size = Number(this.bytes.readBigUInt64BE(2)); at = 10; }
    if (this.bytes.length < at + size) return false;
    const kind = this.bytes[0] & 15, payload = this.bytes.subarray(at, at + size);
    this.bytes = this.bytes.subarray(at + size);
    if (kind === 9) this.send(payload.toString(), 0x8a);
    if (kind === 1) this.texts.push(JSON.parse(payload));
    if (kind === 2 && payload[0] === 1) {
      const sample = JSON.parse(payload.subarray(13));
      if (payload.readUInt32LE(1) === 1) this.status = sample; else this.log.push(sample);
    }
    return true;
  }
  async next(op) {
    for (let i = 0; i < 600; ++i) {
      const at = this.texts.findIndex((one) => one.op === op);
      if (at >= 0) return this.texts.splice(at, 1)[0];
      await sleep(10);
    }
    throw new Error(`no ${op} has come`);
  }
  async watch() {
    const { channels } = await this.next('advertise');
    const id = (topic) => channels.find((one) => one.topic === topic).id;
    this.send({ op: 'subscribe', subscriptions: [{ id: 1, channelId: id('/cca/status') }] });
    this.send({ op: 'subscribe', subscriptions: [{ id: 2, channelId: id('/cca/log') }] });
  }
  async parameters() {
    this.send({ op: 'getParameters', parameterNames: [], id: 'all' });
    return JSON.stringify((await this.next('parameterValues')).parameters);
  }
}

// What the page of elsewhere tries; each attempt ends with a word.
const attack = (port, token) => `<!doctype html><meta charset="utf-8"><title>elsewhere</title><body><script>
const seen = {}, after = (ms) => new Promise((done) => setTimeout(() => done('nothing happened'), ms));
const socket = (url, protocols) => Promise.race([after(4000), new Promise((done) => {
  let one;
  try { one = new WebSocket(url, protocols); } catch (error) { return done('not allowed: ' + error.name); }
  one.onopen = () => { one.send('{"op":"cca.token","token":"${token}"}'); done('OPEN'); };
  one.onerror = () => done('refused');
})]);
const request = (url, init) => Promise.race([after(4000), fetch(url, init).then((r) => r.type === 'opaque' ? 'opaque' : 'READ ' + r.status, () => 'refused')]);
const element = (name, properties) => Promise.race([after(4000), new Promise((done) => {
  const made = Object.assign(document.createElement(name), properties);
  made.onload = () => done('loaded'); made.onerror = () => done('refused');
  document.body.append(made);
})]);
const right = ['foxglove.websocket.v1', 'cca.token.${token}'];
const call = '\\u0002\\u0007\\u0000\\u0000\\u0000';
(async () => {
  for (const host of ['127.0.0.1', 'localhost', '[::1]', 'evil.example', '0.0.0.0']) {
    const at = host + ':${port}';
    seen['socket ' + host] = await socket('ws://' + at + '/', ['foxglove.websocket.v1']);
    seen['socket with the token ' + host] = await socket('ws://' + at + '/', right);
    seen['request ' + host] = await request('http://' + at + '/');
    seen['request without CORS ' + host] = await request('http://' + at + '/', { mode: 'no-cors' });
    seen['post ' + host] = await request('http://' + at + '/', { method: 'POST', mode: 'no-cors', headers: { 'Content-Type': 'text/plain' }, body: '{"op":"cca.token","token":"${token}"}' });
    seen['put ' + host] = await request('http://' + at + '/cca/stop', { method: 'PUT', body: call });
    seen['upgrade by hand ' + host] = await request('http://' + at + '/', { headers: { 'X-Upgrade': 'websocket' } });
    navigator.sendBeacon('http://' + at + '/cca/stop', call);
  }
  seen.script = await element('script', { src: 'http://127.0.0.1:${port}/' });
  seen.image = await element('img', { src: 'http://127.0.0.1:${port}/' });
  await element('iframe', { src: 'http://127.0.0.1:${port}/#token=${token}' });
  await element('iframe', { name: 'target' });
  const form = Object.assign(document.createElement('form'), { action: 'http://127.0.0.1:${port}/cca/stop', method: 'post', enctype: 'text/plain', target: 'target' });
  form.append(Object.assign(document.createElement('input'), { name: '{"op":"setParameters","x":"', value: '"}' }));
  document.body.append(form);
  form.submit();
  await new Promise((done) => setTimeout(done, 1500));
  await fetch('/seen', { method: 'POST', body: JSON.stringify(seen) });
})();
</script>`;

const browse = (url, folder, rules = '') => spawn(process.env.CHROMIUM ?? '/usr/bin/chromium', ['--headless=new', '--no-sandbox', '--disable-gpu', '--no-first-run', `--user-data-dir=${folder}`, '--remote-debugging-port=0', ...(rules ? [`--host-resolver-rules=${rules}`] : []), url], { stdio: 'ignore', detached: true });
const end = (child) => { try { process.kill(-child.pid, 'SIGKILL'); } catch { /* it has ended */ } };
const until = async (holds, ms) => { for (let i = 0; i < ms / 50; ++i) { if (holds()) return true; await sleep(50); } return false; };

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const token = randomBytes(16).toString('hex'), port = await freePort();
writeFileSync(`${out}/token`, `${token}\n`, { mode: 0o600 });
const robot = spawn(program, ['--door', String(port), '--door-token', `${out}/token`, '--seconds', '600', '--quiet'], { cwd: out, stdio: ['ignore', 'pipe', 'inherit'] });
let hasEnded = false;
robot.on('exit', () => { hasEnded = true; });
await new Promise((done) => robot.stdout.on('data', (text) => { if (/http:/.test(text)) done(); }));
const browsers = [];
try {
  const watcher = new Watcher(port);
  await watcher.watch();
  await until(() => watcher.status.state === 'running', 10_000);
  const before = await watcher.parameters(), beat = watcher.status.beat;
  let most = 0;
  const looks = setInterval(() => { most = Math.max(most, watcher.status.clients ?? 0); }, 20);

  // The page of elsewhere: another port of this machine, and a name of its own that points here.
  let seen = null;
  const server = createHttpServer((request, answer) => {
    if (request.method !== 'POST') return answer.writeHead(200, { 'Content-Type': 'text/html' }).end(attack(port, token));
    let body = '';
    request.on('data', (piece) => { body += piece; });
    return request.on('end', () => { seen = JSON.parse(body); answer.end(); });
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  for (const host of ['127.0.0.1', 'evil.example']) {
    seen = null;
    browsers.push(browse(`http://${host}:${server.address().port}/`, `${out}/${host}`, 'MAP evil.example 127.0.0.1'));
    check(`the page of ${host} has tried everything`, await until(() => seen, 240_000), 'its script has not ended');
    end(browsers.at(-1));
    const got = Object.entries(seen ?? {}).filter(([, word]) => /OPEN|READ/.test(word));
    check(`${host}: no socket opened, nothing was read`, got.length === 0 && Object.keys(seen ?? {}).length >= 37, got);
    check(`${host}: the page of the door is no script and no image`, seen?.script === 'refused' && seen?.image === 'refused', seen);
  }
  clearInterval(looks);
  check('nobody else was let in, the framed page of the door neither', most === 1, most);
  check('no parameter has changed', await watcher.parameters() === before);
  check('nobody has changed or commanded anything', watcher.log.every(({ what }) => !/takes the command|^set|\/cca\//.test(what)), watcher.log);
  check('the program runs on', !hasEnded && watcher.status.state === 'running' && watcher.status.beat > beat, watcher.status);

  // What a browser sends after a rebound name: host and origin agree, and are not this machine's.
  const name = `evil.example:${port}`;
  for (const [what, headers] of Object.entries({ 'a rebound name': { Host: name, Origin: `http://${name}` }, 'another port': { Origin: `http://127.0.0.1:${port + 1}` }, 'a page without an origin': { Origin: 'null' }, 'a name without a port': { Host: 'evil.example' } }))
    check(`${what} is refused`, /^HTTP\/1.1 40[03]|^HTTP\/1.1 421/.test(await new Watcher(port, headers).answered), what);

  // The same browser, the page of the door itself: it can.
  browsers.push(browse(`http://127.0.0.1:${port}/#token=${token}`, `${out}/own`));
  check('the page of the door itself connects', await until(() => watcher.status.clients === 2, 120_000), watcher.status.clients);
  server.close();
} finally {
  for (const one of browsers) end(one);
  robot.kill('SIGKILL');
}
await sleep(300);
console.log(failed ? `${failed} checks have failed` : 'a page of elsewhere can do nothing');
process.exit(failed ? 1 : 0);
