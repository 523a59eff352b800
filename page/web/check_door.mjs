// The page at a running program: it starts one, and does what a user does.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';

import { between, threadTimes } from './threads.mjs';

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
  await page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
  await page.keyboard.press('Space');
  const stopped = await isPaused(page);
  await sleep(700);
  await settle(page);
  const atRest = await number(page, '#beat');
  await page.$eval('#door-beats', (e) => { e.value = 1; });
  await page.keyboard.press('.');
  check('door: space pauses, the full stop steps a beat', stopped && await until(page, (b) => Number(document.getElementById('beat').textContent) === b, atRest + 1), (await number(page, '#beat')) - atRest);
  await page.keyboard.press('Space');
  check('door: space goes on', await says(page, 'state', '^running$'), await text(page, '#state'));
  // By the tabulator alone, from the top: what has the keyboard is seen to have it.
  await page.evaluate(() => { document.body.tabIndex = -1; document.body.focus(); document.body.removeAttribute('tabindex'); });
  const reached = new Set(), unseen = [];
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press('Tab');
    const { name, isSeen } = await page.evaluate(() => {
      const e = document.activeElement, style = getComputedStyle(e);
      return { name: e.id || e.dataset.path || e.dataset.port || e.dataset.command || e.className, isSeen: e === document.body || style.outlineStyle !== 'none' || style.boxShadow !== 'none' || e.querySelector('.hit') !== null };
    });
    reached.add(name);
    if (!isSeen) unseen.push(name);
  }
  const needed = ['emergency', 'command', 'door-play', 'door-step', 'door-beats', 'door-speed', 'record', 'push', 'cpg.phase'];
  check('door: the tabulator reaches all that one steers with, and one sees where it is', needed.every((name) => reached.has(name)) && unseen.length === 0, [needed.filter((name) => !reached.has(name)), unseen]);
  await page.evaluate(() => { document.activeElement.blur(); scrollTo(0, 0); });
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

// A program with 100 outputs of three numbers at 1 kHz, all drawn and ten curves plotted with all samples.
//
// The machine may do other work meanwhile, so what is judged is work: microseconds of a processor for a sample, and
// its part of each second for the pictures. What the page did not get done it must have had no processor for: pictures and samples may be
// missing for the time in which its threads were ready and waited, and no longer.
export async function checkManyOutputs({ options, check, browser, picture, complaints }) {
  const folder = `${options.pictures}/door-many`;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const port = await freePort();
  const program = await run({ program: options['many-outputs'] }, port, '0123456789abcdef0123456789abcdef', folder);
  const page = await browser.newPage();
  page.on('pageerror', (error) => complaints.push(`door, many: ${error.message}`));
  await page.bringToFront();
  await page.setViewport({ width: 1280, height: 800 });
  await page.goto(`http://127.0.0.1:${port}/`);
  await page.waitForSelector('[data-node]');
  for (const name of ['first.a', 'second.b', 'third.c']) await page.$eval(`[data-port="${name}"]`, (e) => e.dispatchEvent(new MouseEvent('click')));
  await page.waitForFunction(() => window.ccaPage.source.description.outputs.every(({ ring }) => ring.size > 300), { timeout: 120_000 });
  await page.evaluate(() => {
    const { source } = window.ccaPage, { told } = source.on;
    window.seen = { lost: 0, oldest: 0 };
    source.on.told = (m) => { window.seen.lost += Number(/it has lost (\d+) messages/.exec(m.message)?.[1] ?? 0); told(m); };
    setInterval(() => { window.seen.oldest = Math.max(window.seen.oldest, performance.now() - source.sampledAt); }, 10);
  });
  const count = () => page.evaluate(() => { const { source, plots } = window.ccaPage; return { frames: window.ccaPage.frames, beat: source.sampleBeat, now: performance.now(), ...window.seen, curves: plots.plots.flatMap((p) => p.series).length }; });
  const [before, from] = [await threadTimes(browser, program), await count()];
  await sleep(5000);
  const [after, to] = [await threadTimes(browser, program), await count()];
  // How many samples it has of these beats, of each output.
  const held = await page.evaluate((a, b) => window.ccaPage.source.description.outputs.map(({ ring }) => ring.before(b) - ring.before(a)), from.beat, to.beat);
  const plotted = await page.evaluate(() => window.ccaPage.plots.plots.flatMap((plot) => plot.series).map(({ output }) => output));

  const seconds = (to.now - from.now) / 1e3, frames = to.frames - from.frames, beats = to.beat - from.beat, samples = beats * held.length - to.lost;
  // The renderer of the page is the one that has the worker.
  const own = new Set(Object.values(after).filter((t) => t.name.startsWith('DedicatedWorker')).map((t) => t.process));
  const spent = (which) => between(before, after, (t) => which({ ...t, isPage: own.has(t.process) }));
  const draws = spent((t) => t.isPage && t.isFirst);
  const reads = spent((t) => t.isPage && /^(DedicatedWorker|Chrome_ChildIOT)/.test(t.name) || /network/i.test(t.kind));
  const serves = spent((t) => t.kind === 'program');
  const shows = spent((t) => t.isPage || ['GPU', 'browser'].includes(t.kind));
  const seen = { outputs: held.length, curves: to.curves, beats_a_second: beats / seconds, pictures_a_second: frames / seconds, work_to_draw_of_a_second: draws.work / seconds, work_a_sample_us: 1e6 * reads.work / samples,
    lost: to.lost, oldest_ms: to.oldest, waited_to_draw_s: shows.wait, waited_to_read_s: reads.wait + serves.wait };
  check('100 outputs at 1 kHz: the page shows all of them', held.length === 102 && to.curves >= 6 && beats > 0, seen);
  check('100 outputs at 1 kHz: a sample costs less than 6 us in all threads that it passes', reads.threads >= 3 && seen.work_a_sample_us < 6, seen.work_a_sample_us);
  check('100 outputs at 1 kHz: the thread that draws works for less than 0.6 of a second in each', draws.threads === 1 && draws.work > 0 && seen.work_to_draw_of_a_second < 0.6, seen.work_to_draw_of_a_second);
  check('100 outputs at 1 kHz: what the program has published is here, but what it or the page could not yet do', beats > 1000 * (seconds - seen.waited_to_read_s) - 200, beats);
  check('100 outputs at 1 kHz: sixty pictures a second, less those in whose time the machine worked for others', frames >= 55 * (seconds - shows.wait), seen.pictures_a_second);
  check('100 outputs at 1 kHz: nothing is lost, but while the machine worked for others', to.lost <= held.length * 1000 * seen.waited_to_read_s, [to.lost, seen.waited_to_read_s]);
  check('100 outputs at 1 kHz: the newest sample is not older than 0.2 s, but for others', to.oldest < 200 + 1e3 * (seen.waited_to_read_s + shows.wait), to.oldest);
  check('100 outputs at 1 kHz: of what is plotted it keeps all samples', plotted.every((o) => held[o] <= beats && held[o] >= beats - to.lost), [plotted.map((o) => held[o]), beats]);
  check('100 outputs at 1 kHz: of the others 200 a second', held.every((size) => size > 0.19 * beats - to.lost), [Math.min(...held), beats]);
  await picture(page, 'door-many');
  await page.close();
  program.kill('SIGKILL');
}
