// One session at one robot on virtual drives, from three places: the page, cca-top in a terminal, and the protocol's own
// client from npm. Each starts it, tunes it, pushes it, records it, stops it, and sees what a twin finds; the right to command
// goes from one to the next. Then a recording is computed again, and read for who changed what. docs/door.md, A session.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { McapStreamReader } from '@mcap/core';
import WebSocket from 'ws';

import { freePort } from './check_door.mjs';
import { startTwin } from './src/twin.js';

const require = createRequire(import.meta.url);
const { FoxgloveClient } = require('@foxglove/ws-protocol');

const token = '0123456789abcdef0123456789abcdef';
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
async function until(holds, seconds = 60) {
  for (const end = Date.now() + 1e3 * seconds; Date.now() < end; await sleep(20)) if (await holds()) return true;
  return false;
}
const within = (promise, seconds) => Promise.race([promise, sleep(1e3 * seconds).then(() => 'still runs')]);

// The program of the robot, at its first beat.
async function start(path, port, folder, more) {
  const child = spawn(path, ['--door', String(port), '--door-token', `${folder}/token`, '--pace', 'lock-step', '--seconds', '36000', ...more], { cwd: folder, stdio: ['ignore', 'pipe', 'inherit'] });
  child.ended = new Promise((done) => child.on('exit', (code, signal) => done(signal ?? code)));
  child.said = '';
  child.stdout.on('data', (text) => { child.said += text; });
  if (!await until(() => /door: http:/.test(child.said))) throw new Error(`${path} has opened no door: ${child.said}`);
  return child;
}
// Runs to its end: its exit code and all that it has written.
function result(path, words, folder) {
  const child = spawn(path, words, { cwd: folder, stdio: ['ignore', 'pipe', 'pipe'] });
  let said = '';
  for (const one of [child.stdout, child.stderr]) one.on('data', (text) => { said += text; });
  return new Promise((done) => child.on('close', (code) => done({ code, said })));
}

// A program in a terminal of 100 by 30 that is seen: xterm.js in the browser, keys as they are pressed there, and `script`,
// which gives the program a terminal of the system.
async function terminal(browser, command, complaints) {
  const page = await browser.newPage(), folder = require.resolve('@xterm/xterm/package.json').replace('package.json', '');
  page.on('pageerror', (error) => complaints.push(`terminal: ${error.message}`));
  await page.setViewport({ width: 920, height: 560 });
  await page.setContent(`<!doctype html><style>${readFileSync(`${folder}css/xterm.css`)} body { margin: 8px; background: #000 }</style><div id="screen"></div>`);
  await page.addScriptTag({ path: `${folder}lib/xterm.js` });
  const child = spawn('script', ['--quiet', '--return', '--command', `stty cols 100 rows 30; exec ${command}`, '/dev/null'], { stdio: ['pipe', 'pipe', 'inherit'], env: { ...process.env, TERM: 'xterm-256color', LC_ALL: 'C.UTF-8' } });
  child.ended = new Promise((done) => child.on('exit', (code, signal) => done(signal ?? code)));
  child.stdin.on('error', () => {});
  await page.exposeFunction('typed', (text) => { child.stdin.write(text); });
  await page.evaluate(() => {
    window.terminal = new window.Terminal({ cols: 100, rows: 30, fontSize: 15 });
    window.terminal.open(document.getElementById('screen'));
    window.terminal.onData((text) => window.typed(text));
    window.terminal.focus();
  });
  let writing = Promise.resolve();
  child.stdout.on('data', (bytes) => { writing = writing.then(() => page.evaluate((all) => window.terminal.write(new Uint8Array(all)), [...bytes])).catch(() => {}); });
  const lines = () => page.evaluate(() => Array.from({ length: 30 }, (_, i) => window.terminal.buffer.active.getLine(i)?.translateToString(true) ?? ''));
  return {
    page, child, lines,
    shows: (what, seconds = 30) => until(async () => what.test((await lines()).join('\n')), seconds),
    async press(keys) {
      await page.bringToFront();
      await page.evaluate(() => window.terminal.focus());
      for (const key of keys) await (key.length === 1 ? page.keyboard.sendCharacter(key) : page.keyboard.press(key));
    },
  };
}

// The protocol's own client: channels, parameters and services as the protocol has them, and the pieces for a twin.
class Client {
  constructor(port) {
    this.client = new FoxgloveClient({ ws: new WebSocket(`ws://127.0.0.1:${port}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL, `cca.token.${token}`]) });
    Object.assign(this, { services: [], channels: [], values: new Map(), waiting: new Map(), log: [], status: {}, errors: [], last: 0 });
    const on = (name, does) => this.client.on(name, does), json = (data) => JSON.parse(new TextDecoder().decode(data));
    on('advertiseServices', (all) => this.services.push(...all));
    on('parameterValues', ({ parameters }) => parameters.forEach(({ name, value }) => this.values.set(name, value)));
    on('serviceCallResponse', ({ callId, data }) => this.waiting.get(callId)?.(json(data)));
    on('fetchAssetResponse', (m) => this.waiting.get(m.requestId)?.(m));
    on('status', (m) => { if (m.level > 0) this.errors.push(m.message); });
    on('message', ({ subscriptionId, data }) => {
      if (subscriptionId === this.ofLog) this.log.push(json(data));
      if (subscriptionId === this.ofStatus) this.status = json(data);
    });
    on('advertise', (all) => {
      this.channels.push(...all);
      for (const { id, topic } of all) {
        if (topic === '/cca/log') this.ofLog = this.client.subscribe(id);
        if (topic === '/cca/status') this.ofStatus = this.client.subscribe(id);
      }
    });
    on('open', () => this.client.subscribeParameterUpdates([]));
  }
  later(send) {
    const id = ++this.last;
    return within(new Promise((done) => { this.waiting.set(id, done); send(id); }), 20);
  }
  // '' or the reason of a refusal.
  async call(name, request = {}) {
    const serviceId = this.services.find((one) => one.name === name)?.id;
    const answer = await this.later((callId) => this.client.sendServiceCallRequest({ serviceId, callId, encoding: 'json', data: new TextEncoder().encode(JSON.stringify(request)) }));
    return answer.success ? '' : answer.message ?? 'no answer';
  }
  set(name, value) {
    this.client.setParameters([{ name, value }], 'set');
    return until(() => this.values.get(name) === value, 10);
  }
  async piece(of, from) {
    const { status, data, error } = await this.later((id) => this.client.fetchAsset(`cca://twin/${of}?from=${from}`, id));
    if (status !== 0) throw new Error(error ?? 'no answer');
    return [new Uint8Array(data.buffer, data.byteOffset + 8, data.byteLength - 8), Number(data.getBigUint64(0, true))];
  }
  // The robot's program beside this client, from the first beat to `beats`.
  async twin(beats) {
    const code = [];
    for (let size = 0, end = 1; size < end;) {
      const [bytes, all] = await this.piece('program', size);
      code.push(bytes);
      size += bytes.length;
      end = all;
    }
    const twin = await startTwin(await new Blob(code).arrayBuffer());
    let told = { beats: 0 };
    for (let at = 0, end = Date.now() + 120_000; told.beats < beats && !told.difference && !told.endedEarly && Date.now() < end;) {
      const [bytes] = await this.piece('stream', at);
      if (bytes.length === 0) { await sleep(50); continue; }
      twin.take(bytes);
      at += bytes.length;
      told = twin.result();
    }
    return told;
  }
}

// What the door has noted in a recording: client and change, in their order.
function changesIn(file) {
  const reader = new McapStreamReader({ validateCrcs: false, includeChunks: false, decompressHandlers: { zstd: () => new Uint8Array() } });
  const all = [];
  reader.append(readFileSync(file));
  for (let record; (record = reader.nextRecord());) if (record.type === 'Metadata' && record.name === 'cca.door') all.push(Object.fromEntries(record.metadata));
  return all;
}

export async function checkSession({ options, check, text, press, picture, accessible, browser, complaints }) {
  const folder = `${options.pictures}/session`;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(`${folder}/token`, `${token}\n`, { mode: 0o600 });
  const port = await freePort(), path = options['drives-program'];
  let program = await start(path, port, folder, ['--paused', '--twin', options['drives-twin']]);

  const page = await browser.newPage();
  page.setDefaultTimeout(60_000);
  page.on('console', (m) => { if (['error', 'warn'].includes(m.type()) && !/ERR_CONNECTION_REFUSED|closed before|ERR_CONNECTION_RESET/.test(m.text())) complaints.push(`session: ${m.type()}: ${m.text()}`); });
  page.on('pageerror', (error) => complaints.push(`session: ${error.message}`));
  await page.setViewport({ width: 1280, height: 900 });
  await page.goto(`http://127.0.0.1:${port}/#token=${token}`);
  await page.waitForSelector('[data-node]');
  // A page that is not in front draws nothing.
  const shown = async (what, ...values) => {
    await page.bringToFront();
    return page.waitForFunction(what, { timeout: 60_000, polling: 50 }, ...values).then(() => true, () => false);
  };
  const says = (id, expected) => shown((i, e) => new RegExp(e).test(document.getElementById(i).textContent), id, expected);
  const logged = (expected) => says('log', expected);
  const valueIs = (of, wanted) => shown((p, v) => document.querySelector(`[data-path="${p}"]`)?.value === v, of, wanted);
  const top = await terminal(browser, `${options.top} ${port} --token-file ${folder}/token`, complaints);
  const client = new Client(port);

  // Until it walks: its drives are enabled first.
  const walks = async () => {
    const from = client.status.beat;
    return await until(() => client.status.beat > from + 600, 120) && client.status.state === 'running' && !client.status.is_paused;
  };

  // ---- the three see the same, and nobody commands ----
  const waits = [await says('state', '^loaded$'), await says('commander', 'nobody commands'), await top.shows(/^ cca-top .* loaded/), await top.shows(/nobody commands/), await until(() => client.status.state === 'loaded' && client.services.length > 15)];
  check('session: all three see the robot wait for its first beat', waits.every(Boolean), waits);

  // ---- the page: from the first beat on ----
  await page.bringToFront();
  await press(page, '#command');
  const one = [await says('commander', 'this page commands'), await top.shows(/127\.0\.0\.1:\d+ commands/), await client.call('/cca/take_command')];
  check('session: the page commands, the others are told so', one[0] && one[1] && /commands: it must give the command back first/.test(one[2]), one);
  await page.$eval('#record-file', (e) => { e.value = 'session.mcap'; });
  await press(page, '#record');
  check('session: the page records, before the first beat', await says('record', 'end session.mcap') && await top.shows(/recording session\.mcap/), await text(page, '#message'));
  await press(page, '#twin-run');
  await press(page, '#door-start');
  check('session: the page starts it', await says('state', '^running$') && await says('twin', '^the same, bit for bit: \\d{4,} beats') && await top.shows(/ running/), [await text(page, '#state'), await text(page, '#twin')]);
  await page.$eval('[data-path="cpg.frequency"]', (e) => { e.value = '3.2'; e.dispatchEvent(new Event('change')); });
  await top.press('2');
  const tuned = [await logged('set cpg.frequency from \\S+ to 3.2'), await top.shows(/cpg\.frequency +3\.2 /), await until(() => client.values.get('cpg.frequency') === 3.2, 10)];
  check('session: the page tunes it, and all three have the value', tuned.every(Boolean), tuned);
  await page.bringToFront();
  await page.$eval('[data-argument="forward"]', (e) => { e.value = 8; });
  await page.$eval('[data-command="push"]', (e) => e.scrollIntoView({ block: 'center' }));
  await page.focus('[data-command="push"]');
  await page.keyboard.down('Space');
  const pushed = await logged('/cca/command/push forward=8 left=0');
  await page.keyboard.up('Space');
  check('session: the page pushes it, and lets go', pushed && await logged('/cca/release/push'), await text(page, '#message'));
  check('session: the page says what the twin finds, and the terminal shows it', await says('twin', '^the same, bit for bit') && await top.shows(/twin of 127\.0\.0\.1:\d+: the same, bit for bit: \d{4,} beats/), [await text(page, '#twin'), (await top.lines()).filter((l) => /twin/.test(l))]);
  await page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
  await accessible(page, 'session');
  await picture(page, 'session-page');
  await top.press('3');
  await top.shows(/who did what/);
  await sleep(300);
  await picture(top.page, 'session-terminal');
  await page.bringToFront();
  await press(page, '#door-play');
  const stops = [await says('state', '^paused$'), await top.shows(/paused, running/), await until(() => client.status.is_paused)];
  check('session: the page stops it: a pause', stops.every(Boolean), stops);
  await press(page, '#command');
  check('session: the page gives the command back', await says('commander', 'nobody commands'), await text(page, '#commander'));

  // ---- cca-top ----
  await top.press('c');
  check('session: cca-top takes the command', await top.shows(/YOU COMMAND/) && await says('commander', ' commands$'), await text(page, '#commander'));
  await top.press(['5', 'ArrowDown', 'Enter']);
  const isDown = await top.shows(/put_down: done/);
  await top.press('s');
  check('session: cca-top puts it down and starts it anew', isDown && await top.shows(/it begins anew/) && await walks(), [client.status, (await top.lines()).slice(-2)]);
  await top.press(['2', '/', ...'cpg.freq', 'Enter', 'Enter', ...Array(8).fill('Backspace'), '3', 'Enter']);
  check('session: cca-top tunes it', await top.shows(/cpg\.frequency is 3 Hz/) && await valueIs('cpg.frequency', '3') && await until(() => client.values.get('cpg.frequency') === 3, 10), (await top.lines()).slice(-2));
  await top.press(['Escape']);
  await top.shows(/find q quit/);
  await sleep(300);  // else it is the begin of a code of a key
  await top.press(['5', 'Home', 'Enter']);
  await top.shows(/push .*forward=10,left=0/);
  await top.press([...Array(20).fill('Backspace'), ...'forward=-6,left=4', 'Enter']);
  const isHeld = await top.shows(/push +HELD/);
  await picture(top.page, 'session-terminal-push');
  await top.press(['Enter']);
  check('session: cca-top pushes it, and lets go', isHeld && await top.shows(/push: released/) && await logged('/cca/command/push forward=-6 left=4'), (await top.lines()).slice(-2));
  await top.press('p');
  check('session: cca-top stops it: a pause', await top.shows(/paused, running/) && await says('state', '^paused$'), await text(page, '#state'));
  await top.press('c');
  check('session: cca-top gives the command back', await top.shows(/nobody commands/), (await top.lines()).slice(0, 3));

  // ---- the protocol's own client ----
  const taken = [await client.call('/cca/take_command'), await client.call('/cca/command/put_down'), await client.call('/cca/start')];
  check('session: the client takes the command, puts it down and starts it anew', taken.join() === ',,' && await walks(), [taken, client.status]);
  const given = [await client.set('cpg.frequency', 2.8), await client.call('/cca/command/push', { forward: 5, left: -5 })];
  await sleep(200);
  given.push(await client.call('/cca/release/push'));
  check('session: the client tunes and pushes it', given.join() === 'true,,' && await valueIs('cpg.frequency', '2.8') && await top.shows(/twin of/), given);
  const twin = await client.twin(client.status.beat + 500);
  check('session: the client\'s own twin computes all of it, bit for bit', twin.beats > client.status.beat - 5000 && !twin.difference && !twin.endedEarly, twin);
  check('session: the twin of the page, too, after all that the others did', await says('twin', `^the same, bit for bit: `), await text(page, '#twin'));
  // The recording that the page began; then each of the others makes one.
  const ended = [await client.call('/cca/end_recording'), await client.call('/cca/record', { file: 'client.mcap' })];
  await sleep(300);
  ended.push(await client.call('/cca/end_recording'), await client.call('/cca/give_command'));
  check('session: the client ends the recording and makes one of its own', ended.join() === ',,,' && existsSync(`${folder}/session.mcap`) && existsSync(`${folder}/client.mcap`), ended);
  await top.press(['c']);
  await top.shows(/YOU COMMAND/);
  await top.press(['w', ...Array(8).fill('Backspace'), ...'top.mcap', 'Enter']);
  const records = [await top.shows(/records into top\.mcap/), await says('record', 'end top.mcap')];
  await sleep(300);
  await top.press('w');
  records.push(await top.shows(/recorded: top\.mcap/), existsSync(`${folder}/top.mcap`));
  check('session: cca-top makes one', records.every(Boolean), [records, (await top.lines()).slice(-2)]);

  // ---- the end: STOP needs no right to command ----
  const stopped = [await client.call('/cca/stop'), await within(program.ended, 20)];
  check('session: the client stops the run, the robot was shut down in order and has not fallen', stopped[0] === '' && stopped[1] === 0 && /robot: runs, nothing tripped/.test(program.said) && /drives: switched off/.test(program.said) && !/fell/.test(program.said), [stopped, program.said.split('\n').slice(-6)]);
  check('session: no error was told to the client', client.errors.length === 0, client.errors);
  for (const [who, does] of [['page', async () => { await page.bringToFront(); await page.keyboard.press('Escape'); }], ['cca-top', () => top.press(' ')]]) {
    program = await start(path, port, folder, []);
    const back = [await says('state', '^running$'), await top.shows(/ running/)];
    await does();
    const code = await within(program.ended, 20);
    check(`session: the next run is seen by itself, and ${who} stops it`, back.every(Boolean) && code !== 'still runs' && /drives: switched off/.test(program.said), [back, code]);
    program.kill('SIGKILL');
  }
  await top.press('q');
  check('session: cca-top ends', (await within(top.child.ended, 10)) === 0, top.child.exitCode);

  // ---- the recording ----
  const replayed = await result(path, ['--replay', 'session.mcap'], folder);
  check('session: the recording is computed again, bit for bit', replayed.code === 0 && /: \d+ samples of \d{4,} beats, bit for bit as recorded/.test(replayed.said), replayed);
  const changes = changesIn(`${folder}/session.mcap`), who = (what) => changes.filter((c) => what.test(c.what)).map((c) => c.client);
  const tuners = who(/^set cpg\.frequency/), pushers = who(/command\/push/), takers = who(/^takes the command/);
  check('session: the recording says who changed what', new Set(tuners).size === 3 && tuners.join() === pushers.join() && tuners.join() === takers.join(), changes);
  await top.page.close();
  await page.close();
}
