// Recordings on a page.
import { readFileSync } from 'node:fs';
import { McapWriter } from '@mcap/core';

export async function checkRecording(tools) {
  const { options, check, near, open, text, number, settle, message, press, picture } = tools;
  const page = await open(options.page);
  await (await page.$('#file')).uploadFile(options.recording);
  await page.waitForFunction(() => /beats|no recording|no architecture/.test(document.getElementById('message').textContent));
  check('opens a recording', /: 2000 beats$/.test(await message(page)), await message(page));
  const parts = await page.$$eval('[data-node]', (all) => all.map((e) => e.dataset.node));
  check('its architecture is drawn', ['throttle', 'cpg', 'gait', 'limits', 'robot'].every((n) => parts.includes(n)), parts);
  await page.$eval('#replay-time', (e) => { e.value = 1.5; e.dispatchEvent(new Event('input')); });
  await settle(page);
  check('goes to a time of the recording', (await number(page, '#time')) === 1.5, await number(page, '#time'));
  const compared = await page.evaluate(() => {
    const { source } = window.ccaPage;
    const o = source.description.outputs.findIndex((out) => out.path === 'limits.safe');
    return { recorded: source.sample(o), path: source.description.outputs[o].path };
  });
  const lived = await page.evaluate(() => document.getElementById('to-live').click() || new Promise((done) => {
    requestAnimationFrame(() => {
      const { source } = window.ccaPage;
      source.advance(1500 - source.beat);
      const out = source.description.outputs.find((o) => o.path === 'limits.safe');
      done([...source.newest().subarray(out.at, out.at + 8)]);
    });
  }));
  check('the recorded commands are those of the live controller', compared.recorded.every((v, i) => near(v, lived[i], 1e-6)), { recorded: compared.recorded.slice(0, 2), live: lived.slice(0, 2) });
  await (await page.$('#file')).uploadFile(options.recording);
  await page.waitForFunction(() => !document.getElementById('replay-play').closest('.row').hidden);
  await press(page, '#replay-play');
  await page.waitForFunction(() => Number(document.getElementById('beat').textContent) > 100);
  check('plays a recording', true, await text(page, '#beat'));
  await press(page, '#replay-play');
  await page.$eval('#replay-time', (e) => { e.value = 1.5; e.dispatchEvent(new Event('input')); });
  await settle(page);
  check('the recorded robot stands on its feet', await page.evaluate(() => { const p = window.ccaPage.robot.bodies[0].position; return p.z > 0.12 && p.z < 0.22; }), await page.evaluate(() => window.ccaPage.robot.bodies[0].position.z));
  await picture(page, 'recording');
  await page.close();
}

// As a file manager does.
async function drop(page, name, bytes) {
  await page.evaluate((called, text) => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], called));
    document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
  }, name, Buffer.from(bytes).toString('base64'));
  await page.waitForFunction((called) => { const text = document.getElementById('message').textContent; return text.startsWith(`${called}: `); }, {}, name);
  return page.$eval('#message', (e) => ({ text: e.textContent, isRefused: e.classList.contains('refused') }));
}

// A recording of another program: without cca's description of an architecture.
async function foreign() {
  const parts = [];
  let size = 0n;
  const writer = new McapWriter({ writable: { position: () => size, write: async (bytes) => { parts.push(Buffer.from(bytes)); size += BigInt(bytes.length); } } });
  await writer.start({ profile: '', library: 'test' });
  const schemaId = await writer.registerSchema({ name: 'a', encoding: 'ros2msg', data: Buffer.from('float64 x') });
  const channelId = await writer.registerChannel({ topic: '/a', messageEncoding: 'cdr', schemaId, metadata: new Map() });
  await writer.addMessage({ channelId, sequence: 0, logTime: 0n, publishTime: 0n, data: new Uint8Array(12) });
  await writer.end();
  return Buffer.concat(parts);
}

// What can't be shown is refused in words, and the controller stays on the page.
export async function checkRefusals(tools) {
  const { options, check, open, settle, state } = tools;
  const bytes = readFileSync(options.recording);
  const page = await open(options.page);
  const refuses = async (what, name, content, expected) => {
    const said = await drop(page, name, content);
    check(`a dropped file is refused in words: ${what}`, said.isRefused && expected.test(said.text), said.text);
  };
  await refuses('no recording', 'text.mcap', 'no recording at all', /this is no recording/);
  await refuses('an empty file', 'empty.mcap', '', /this is no recording/);
  await refuses('the first bytes of a recording', 'begin.mcap', bytes.subarray(0, 30), /this is no recording/);
  const noise = Buffer.from(bytes);
  for (let i = 8; i < 4000; ++i) noise[i] = (i * 7919 + (i >> 3)) & 255;
  await refuses('random bytes behind the first', 'noise.mcap', noise, /this is no recording|has no architecture/);
  await refuses('a recording of another program', 'other.mcap', await foreign(), /has no architecture: cca has not recorded it/);
  await refuses('another architecture', 'field.mcap', readFileSync(options.field), /another architecture: it has the component leg, which trot does not have.*--page/);
  check('after that the controller is still there', (await state(page)) === 'started' && (await page.evaluate(() => window.ccaPage.source.isLive && window.ccaPage.source.advance(5) === 5)), await state(page));

  const cut = await drop(page, 'cut.mcap', bytes.subarray(0, bytes.length >> 1));
  const beats = Number(/: (\d+) beats, cut off at the end$/.exec(cut.text)?.[1]);
  check('of a recording that was cut off, the beginning is shown', !cut.isRefused && beats > 100 && beats < 2000, cut.text);
  await settle(page);
  const damaged = Buffer.from(bytes);
  for (let i = 0; i < 64; ++i) damaged[(damaged.length * 0.7 | 0) + i] ^= 0x5a;
  const rest = await drop(page, 'damaged.mcap', damaged);
  check('of a damaged recording, what comes before is shown, or it is refused', rest.isRefused || /\d+ beats, cut off/.test(rest.text), rest.text);
  const whole = await drop(page, 'whole.mcap', bytes);
  check('a dropped recording is shown', whole.text === 'whole.mcap: 2000 beats' && (await page.$eval('#replay-play', (e) => e.offsetParent !== null)), whole.text);
  await page.close();
}

// The picture of an architecture fits its panel, its texts fit their boxes, and its size can be changed.
export async function checkPicture(page, name, { check, press, settle }) {
  const sizes = () => page.$eval('#architecture', (box) => { const svg = box.querySelector('svg').getBoundingClientRect(); return { width: svg.width, height: svg.height, room: [box.clientWidth, box.clientHeight] }; });
  const first = await sizes();
  check(`${name}: the picture of the architecture fits its panel`, first.width <= first.room[0] + 1 && first.height <= first.room[1] + 1, first);
  const outside = await page.$$eval('.node, .environment', (all) => all.flatMap((group) => {
    const box = group.querySelector('rect').getBBox();
    return [...group.querySelectorAll('text')].filter((t) => { const b = t.getBBox(); return b.x < box.x - 1 || b.x + b.width > box.x + box.width + 1; }).map((t) => t.textContent);
  }));
  check(`${name}: every text fits its box`, outside.length === 0, outside);
  await press(page, '#larger');
  await settle(page);
  const larger = await sizes();
  await press(page, '#fit');
  await settle(page);
  const again = await sizes();
  check(`${name}: the picture can be made larger, and fits again`, larger.width > 1.2 * first.width && Math.abs(again.width - first.width) < 1, [first.width, larger.width, again.width]);
}

// The page for recordings, and what the option --page makes of it.
export async function checkPages(tools) {
  const { options, check, open, text, number, settle, press, picture, accessible, requests } = tools;
  let page = await open(options['recording-page']);
  check('the page for recordings asks for one', !(await page.$eval('section.architecture', (e) => e.offsetParent)) && (await page.$eval('#file', (e) => e.offsetParent !== null)), await page.$eval('#file', (e) => e.labels[0].textContent));
  await accessible(page, 'the page for recordings');
  const shown = await drop(page, 'trot.mcap', readFileSync(options.recording));
  check('the page for recordings shows one', shown.text === 'trot.mcap: 2000 beats' && (await page.$$eval('[data-node]', (all) => all.length)) > 5, shown.text);
  check('it knows the robot', await page.evaluate(() => window.ccaPage.robot.bodies.length === 17), await page.evaluate(() => window.ccaPage.robot?.bodies.length));
  const leg = await drop(page, 'field.mcap', readFileSync(options.field));
  check('it shows a recording of any architecture', /^field.mcap: 1235 beats/.test(leg.text) && (await page.$$eval('[data-node]', (all) => all.map((e) => e.dataset.node).join())).includes('guard'), leg.text);
  await page.close();

  requests.length = 0;
  page = await open(options['trot-page']);
  check('--page: the recording is in the page, which needs nothing else', requests.length === 0 && (await text(page, '#message')) === 'trot_page: 2000 beats' && (await page.title()) === 'trot_page', await text(page, '#message'));
  const begun = await page.evaluate(() => { const { plots, source } = window.ccaPage; return { curves: plots.plots.length, points: plots.plots[0]?.chart.data[0].length, shown: plots.shown(), duration: source.duration }; });
  check('--page: plots show the whole recording at once', begun.curves > 0 && begun.points > 500 && begun.shown[0] === 0 && begun.shown[1] === begun.duration, begun);
  await checkPicture(page, '--page', tools);
  await page.$eval('#replay-time', (e) => { e.value = 1.5; e.dispatchEvent(new Event('input')); });
  await settle(page);
  check('--page: goes to a time', (await number(page, '#time')) === 1.5, await number(page, '#time'));
  check('--page: values, ages and components that fire are drawn', /rad · \d+ ms/.test(await text(page, '[data-port="cpg.phase"]')) && (await page.$$eval('.node.fires', (all) => all.length)) > 3, await text(page, '[data-port="cpg.phase"]'));
  check('--page: the robot stands on its feet', await page.evaluate(() => { const p = window.ccaPage.robot.bodies[0].position; return p.z > 0.12 && p.z < 0.22; }), await page.evaluate(() => window.ccaPage.robot.bodies[0].position.z));
  check('--page: footfalls', (await text(page, '#stance')).includes('left front'), await text(page, '#stance'));
  const plotted = await page.evaluate(() => { const { plots, source } = window.ccaPage; const curve = plots.plots[0].series[0]; const { data } = plots.plots[0].chart; return { time: data[0].at(-1), value: data[1].at(-1), sample: source.sample(curve.output, Math.round(data[0].at(-1) / source.period) + 1)[curve.i] }; });
  check('--page: what is plotted is what was recorded', plotted.value === plotted.sample, plotted);
  await press(page, '#replay-play');
  await page.waitForFunction(() => Number(document.getElementById('time').textContent) > 1.6);
  await press(page, '#replay-play');
  check('--page: it plays', (await number(page, '#time')) > 1.6, await number(page, '#time'));
  check('--page: nothing of a live controller is offered', await page.$$eval('.live-only', (all) => all.every((e) => e.offsetParent === null)), 'hidden');
  await accessible(page, '--page');
  await picture(page, 'page-of-recording');
  await page.close();
  page = await open(options['trot-page'], 'paused', { width: 360, height: 740, deviceScaleFactor: 1, isMobile: true, hasTouch: true });
  await settle(page, 10);
  check('--page: 360 pixels are enough', (await page.evaluate(() => document.documentElement.scrollWidth)) <= 360, await page.evaluate(() => document.documentElement.scrollWidth));
  await picture(page, 'page-of-recording-narrow', true);
  await page.close();

  page = await open(options['field-page']);
  await page.$eval('#replay-time', (e) => { e.value = e.max; e.dispatchEvent(new Event('input')); });
  await settle(page);
  check('--page: the fault of the field, with its cause', (await text(page, '#alert')) === '⚠ fault in guard: the hip is faster than 10 rad/s', await text(page, '#alert'));
  await page.close();
}

// A robot that the page does not know, as its recording describes it: the arm.
export async function checkDescribed(tools) {
  const { options, check, open, text, settle, accessible, picture } = tools;
  const [, ...rows] = readFileSync(options['touch-path'], 'utf8').trim().split('\n').map((l) => l.split(',').map(Number));
  const page = await open(options['touch-recording']);
  const shown = await page.evaluate(() => ({ kind: window.ccaPage.source.description.robot?.kind, bodies: window.ccaPage.robot?.bodies.length }));
  check('--page: an arm is drawn from /robot_description', shown.kind === 'described' && shown.bodies >= 14, shown);
  let worst = 0;
  for (const seconds of [2, 5, 10, 14]) {
    const [time, ...hand] = rows.reduce((best, row) => (Math.abs(row[0] - seconds) < Math.abs(best[0] - seconds) ? row : best));
    const at = await page.evaluate((t) => { const { source } = window.ccaPage; source.seek(t / source.period); return [...source.robot.frames.values()].at(-1).at; }, time);
    worst = Math.max(worst, Math.hypot(...at.map((x, i) => x - hand[i])));
  }
  check('--page: the arm moves: its hand is where the program says, within what it moves in 20 ms', worst < 0.01, worst);
  await page.$eval('#replay-time', (e) => { e.value = 10; e.dispatchEvent(new Event('input')); });
  await settle(page);
  check('--page: the plan of the arm', (await text(page, '#plan')).includes('wipe'), await text(page, '#plan'));
  await accessible(page, '--page, an arm');
  await picture(page, 'page-of-arm');
  await page.close();
}
