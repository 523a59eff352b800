// The page at a running program: it starts one, and does what a user does.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';

import { manyOutputs } from './many_outputs.mjs';

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
export const freePort = () => new Promise((done) => {
  const server = createServer().listen(0, '127.0.0.1', () => { const { port } = server.address(); server.close(() => done(port)); });
});

// A program with a door, in a folder of its own; `ended`: its exit code.
export async function run(options, port, token, folder, more = []) {
  const file = `${folder}/token`;
  writeFileSync(file, `${token}\n`, { mode: 0o600 });
  const child = spawn(options.program, ['--door', String(port), '--door-token', file, '--seconds', '600', '--quiet', ...more], { cwd: folder, stdio: ['ignore', 'pipe', 'inherit'] });
  child.ended = new Promise((done) => child.on('exit', (code, signal) => done(signal ?? code)));
  await new Promise((done, refuse) => {
    child.stdout.on('data', (text) => { if (/http:/.test(text)) done(); });
    child.on('exit', () => refuse(new Error(`${options.program} has ended before its door was open`)));
  });
  return child;
}

export async function checkDoor(tools) {
  const { options, check, text, number, settle, message, press, picture, accessible, browser, complaints } = tools;
  const token = '0123456789abcdef0123456789abcdef';
  const folder = `${options.pictures}/door`;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const port = await freePort();
  let program = await run(options, port, token, folder);
  const requests = [];
  const visit = async (hash, size = { width: 1280, height: 800 }) => {
    const page = await browser.newPage();
    page.setDefaultTimeout(60_000);
    // A program that was killed on purpose can't be reached: the browser says so.
    page.on('console', (m) => { if (['error', 'warn'].includes(m.type()) && !/ERR_CONNECTION_REFUSED|closed before|ERR_CONNECTION_RESET/.test(m.text())) complaints.push(`door: ${m.type()}: ${m.text()}`); });
    page.on('pageerror', (error) => complaints.push(`door: ${error.message}`));
    page.on('request', (request) => { if (!/^(data|blob):/.test(request.url())) requests.push(request.url()); });
    await page.setViewport(size);
    await page.goto(`http://127.0.0.1:${port}/${hash}`);
    await page.waitForSelector('[data-node]');
    return page;
  };
  const until = (page, what, ...values) => page.waitForFunction(what, { timeout: 30_000 }, ...values).then(() => true, () => false);
  const says = (page, id, expected) => until(page, (i, e) => new RegExp(e).test(document.getElementById(i).textContent), id, expected);
  const isPaused = (page) => says(page, 'state', '^paused$');
  const value = (page, path) => page.$eval(`[data-path="${path}"]`, (e) => Number(e.value));
  const enter = (page, path, wanted) => page.$eval(`[data-path="${path}"]`, (e, v) => { e.value = v; e.dispatchEvent(new Event('change')); }, wanted);
  const reason = (page, path) => page.$eval(`[data-path="${path}"]`, (e) => e.parentElement.querySelector('.reason').textContent);

  // ---- who only looks ----
  let page = await visit('');
  check('door: the program serves the page, which asks for nothing else', requests.length === 1, requests);
  check('door: who has no token can look and change nothing', (await page.$$eval('.changes, #parameters input', (all) => all.length > 20 && all.every((e) => e.disabled))) && /needs the token/.test(await text(page, '#commander')), await text(page, '#commander'));
  check('door: the robot is known', await until(page, () => window.ccaPage.robot?.bodies.length === 17), await page.evaluate(() => window.ccaPage.robot?.bodies.length));
  const before = await page.evaluate(() => [...window.ccaPage.source.poses]);
  check('door: one sees the robot move', await until(page, (old) => window.ccaPage.robot.bodies.length === 17 && window.ccaPage.source.poses.some((v, i) => Math.abs(v - old[i]) > 1e-2), before), before.slice(0, 7));
  await page.keyboard.press('Escape');
  check('door: STOP without the token asks for it', /needs the token/.test(await message(page)) && program.exitCode === null, await message(page));
  await page.type('#token', 'wrong');
  await page.keyboard.press('Enter');
  check('door: a wrong token is refused', await says(page, 'message', 'not the token'), await message(page));
  await page.type('#token', token);
  await page.keyboard.press('Enter');
  check('door: the token is taken', await says(page, 'commander', 'nobody commands'), await text(page, '#commander'));
  await page.close();

  // ---- who has the token, from the address ----
  page = await visit(`#token=${token}`);
  check('door: the token is taken out of the address', (await page.evaluate(() => location.href)) === `http://127.0.0.1:${port}/` && requests.every((url) => !url.split('#')[0].includes(token)), await page.evaluate(() => location.href));
  await says(page, 'commander', 'nobody commands');
  await press(page, '#command');
  check('door: takes the right to command', await says(page, 'commander', 'this page commands'), await text(page, '#commander'));
  const other = await visit(`#token=${token}`);
  await says(other, 'commander', 'commands');
  await press(other, '#command');
  check('door: only one commands', await says(other, 'message', 'commands: it must give the command back first'), await message(other));
  await other.close();

  check('door: values, ages and components that fire are drawn', await until(page, () => /rad · \d+ ms/.test(document.querySelector('[data-port="cpg.phase"]').textContent) && document.querySelectorAll('.node.fires').length > 3), await text(page, '[data-port="cpg.phase"]'));
  check('door: plots have the seconds since it is connected', await until(page, () => window.ccaPage.plots.plots[0]?.chart.data[0].length > 300), await page.evaluate(() => window.ccaPage.plots.plots[0]?.chart.data[0].length));
  check('door: footfalls', /left front \d+ %/.test(await text(page, '#stance')), await text(page, '#stance'));

  // ---- parameters ----
  const path = 'cpg.frequency', first = await value(page, path);
  const { lower, upper } = await page.evaluate((p) => window.ccaPage.source.description.parameters.find((one) => one.path === p), path);
  await enter(page, path, '3.5');
  check('door: a parameter is changed', await says(page, 'message', 'cpg.frequency = 3.5') && await says(page, 'log', `set cpg.frequency from ${first} to 3.5`), await text(page, '#log li .what'));
  await enter(page, path, String(upper + 100));
  const refused = await until(page, (p) => /^refused: /.test(document.querySelector(`[data-path="${p}"]`).parentElement.querySelector('.reason').textContent), path);
  check('door: beyond its range it is refused, with the range, and the form goes back', refused && (await reason(page, path)).includes(String(upper)) && (await value(page, path)) === 3.5, [await reason(page, path), lower, upper]);
  await page.$eval(`[data-path="${path}"]`, (e) => { const slider = e.parentElement.querySelector('[type=range]'); slider.value = 3; slider.dispatchEvent(new Event('input')); slider.dispatchEvent(new Event('change')); });
  check('door: the slider sets it', await says(page, 'log', 'cpg.frequency from 3.5 to 3'), await value(page, path));
  await press(page, '#undo');
  check('door: undo', await until(page, (p) => document.querySelector(`[data-path="${p}"]`).value === '3.5', path), await value(page, path));

  // ---- life-cycle ----
  await press(page, '#door-play');
  check('door: pauses', await isPaused(page), await text(page, '#state'));
  await sleep(700);
  await settle(page);
  const held = await number(page, '#beat');
  await page.$eval('#door-beats', (e) => { e.value = 7; });
  await press(page, '#door-step');
  check('door: steps seven beats', await until(page, (b) => Number(document.getElementById('beat').textContent) === b, held + 7), (await number(page, '#beat')) - held);
  await press(page, '#door-play');
  check('door: goes on', await says(page, 'state', '^running$') && await until(page, (b) => Number(document.getElementById('beat').textContent) > b + 100, held), await text(page, '#state'));
  await page.select('#door-speed', '0.5');
  check('door: half the speed', await until(page, () => window.ccaPage.source.door.speed === 0.5), await page.evaluate(() => window.ccaPage.source.door.speed));
  await page.select('#door-speed', '1');

  // ---- the program's own command, held ----
  await page.$eval('[data-argument="forward"]', (e) => { e.value = 2; });
  await page.$eval('[data-command="push"]', (e) => e.scrollIntoView({ block: 'center' }));
  const box = await (await page.$('[data-command="push"]')).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  check('door: pushes while the button is held', await says(page, 'log', '/cca/command/push forward=2 left=0'), await text(page, '#log li .what'));
  await page.mouse.up();
  check('door: released, the push ends', await says(page, 'log', '/cca/release/push'), await text(page, '#log li .what'));
  await page.focus('[data-command="push"]');
  await page.keyboard.down('Space');
  const byKey = await until(page, () => document.querySelector('[data-command="push"]').getAttribute('aria-pressed') === 'true');
  await page.keyboard.up('Space');
  check('door: and by the keyboard', byKey && await until(page, () => document.querySelector('[data-command="push"]').getAttribute('aria-pressed') === 'false'), byKey);

  // ---- recording ----
  await press(page, '#record');
  check('door: records', await says(page, 'record', 'end run.mcap'), await text(page, '#record'));
  await sleep(500);
  await press(page, '#record');
  check('door: ends the recording', await says(page, 'record', '● record') && existsSync(`${folder}/run.mcap`), await message(page));

  check('door: timing of each environment', /^\d+$/.test(await text(page, '#timing tbody td:nth-child(2)')), await text(page, '#timing tbody'));
  await page.evaluate(() => scrollTo(0, 0));
  await accessible(page, 'door');
  await picture(page, 'door');

  // ---- the program is killed, and starts again ----
  program.kill('SIGKILL');
  await program.ended;
  check('door: says that there is no connection, and greys what is stale', await says(page, 'alert', 'no connection') && (await page.$eval('body', (e) => e.classList.contains('stale'))) && (await text(page, '#state')) === 'not connected', await text(page, '#alert'));
  await picture(page, 'door-lost');
  program = await run(options, port, token, folder);
  check('door: connects again by itself, with the token', await until(page, () => document.getElementById('alert').textContent === '' && !document.body.classList.contains('stale') && /nobody commands/.test(document.getElementById('commander').textContent)), await text(page, '#link'));
  const began = await until(page, () => window.ccaPage.source.beat < 20_000 && window.ccaPage.source.beat > 200 && window.ccaPage.source.publishedIn(0) > 0);
  check('door: then it shows the new run, from its beginning, with the values of this program', began && await until(page, (p, v) => Number(document.querySelector(`[data-path="${p}"]`).value) === v, path, first), [await number(page, '#beat'), await value(page, path)]);

  // ---- STOP needs no right to command ----
  const ends = (of) => Promise.race([of.ended, sleep(10_000).then(() => 'still runs')]);
  await page.focus('#record-file');
  await page.keyboard.press('Escape');
  check('door: Escape stops the run, wherever the keyboard is', (await ends(program)) === 0 && await says(page, 'alert', 'the run was stopped here'), await text(page, '#alert'));
  await page.close();
  program = await run(options, port, token, folder);

  // ---- a telephone ----
  const phone = await visit(`#token=${token}`, { width: 390, height: 844, deviceScaleFactor: 1, isMobile: true, hasTouch: true });
  await says(phone, 'commander', 'nobody commands');
  await settle(phone, 30);
  check('door: 390 pixels are enough', (await phone.evaluate(() => document.documentElement.scrollWidth)) <= 390, await phone.evaluate(() => document.documentElement.scrollWidth));
  const isSeen = () => phone.$eval('#emergency', (e) => { const b = e.getBoundingClientRect(); return b.top >= 0 && b.bottom <= innerHeight && b.left >= 0 && b.right <= innerWidth && document.elementFromPoint(b.left + 20, b.top + 20) === e; });
  const seen = [await isSeen()];
  await picture(phone, 'door-narrow');
  await phone.evaluate(() => scrollTo(0, document.body.scrollHeight));
  seen.push(await isSeen());
  check('door: STOP is always visible', seen.every(Boolean), seen);
  await accessible(phone, 'door, narrow');
  await phone.tap('#emergency');
  check('door: STOP by touch', (await ends(program)) === 0 && await says(phone, 'alert', 'the run was stopped here'), await text(phone, '#alert'));
  await phone.close();
  program.kill('SIGKILL');
}

// 100 outputs at 1 kHz, all drawn and two plotted with all samples. How many frames there are depends on the
// machine's other work, and here on a graphics card in software. So the page is called sixty times a second by the
// clock, and what counts is the time that it needs itself: a frame of 60 a second has 16.7 ms.
export async function checkManyOutputs({ options, check, browser, picture }) {
  const server = await manyOutputs(options['recording-page']);
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 800 });
  await page.evaluateOnNewDocument(() => { window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 1000 / 60); });
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  await page.waitForSelector('[data-node]');
  await page.waitForFunction(() => window.ccaPage.source.publishedIn(99) > 3000, { timeout: 120_000 });
  const devtools = await page.createCDPSession();
  await devtools.send('Performance.enable');
  const busy = async () => Object.fromEntries((await devtools.send('Performance.getMetrics')).metrics.map(({ name, value }) => [name, value])).ThreadTime;
  const count = () => page.evaluate(() => { const { source } = window.ccaPage; return { frames: window.ccaPage.frames, beat: source.publishedIn(99), now: performance.now() }; });
  const [before, from] = [await busy(), await count()];
  await new Promise((done) => setTimeout(done, 5000));
  const [after, to] = [await busy(), await count()];
  const frames = to.frames - from.frames, seconds = (to.now - from.now) / 1e3;
  const seen = { milliseconds_a_frame: (1e3 * (after - before)) / frames, busy: (after - before) / seconds, frames_a_second: frames / seconds, beats_a_second: (to.beat - from.beat) / seconds, behind: server.beats - to.beat };
  check('100 outputs at 1 kHz: the page needs less than half the time of a frame', frames >= 5 && seen.milliseconds_a_frame < 8, seen);
  const held = await page.evaluate(() => window.ccaPage.source.description.outputs.map(({ ring }) => ring.size));
  check('100 outputs at 1 kHz: of those that are not plotted it keeps 200 a second or more', held.every((size) => size > 300), Math.min(...held));
  await picture(page, 'door-many');
  await page.close();
  server.emit('ends');
  server.close();
}
