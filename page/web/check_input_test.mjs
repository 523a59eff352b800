// A test of an input from the page, at the program of docs/tuning.md: a chirp and its curves, one that is ended, a step, what is
// refused; and the axes of a program that has several.
import { mkdirSync, rmSync } from 'node:fs';

import { freePort, run } from './check_door.mjs';

const token = '0123456789abcdef0123456789abcdef';

export async function checkInputTest(tools) {
  const { options, check, text, press, picture, accessible, browser, complaints } = tools;
  const folder = `${options.pictures}/input_test`;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const port = await freePort();
  const program = await run({ program: options.tuning }, port, token, folder);
  const visitAt = async (port, size) => {
    const page = await browser.newPage();
    page.setDefaultTimeout(60_000);
    page.on('console', (m) => { if (['error', 'warn'].includes(m.type())) complaints.push(`test of an input: ${m.type()}: ${m.text()}`); });
    page.on('pageerror', (error) => complaints.push(`test of an input: ${error.message}`));
    await page.setViewport(size);
    await page.goto(`http://127.0.0.1:${port}/#token=${token}`);
    await page.waitForSelector('#tests form');
    return page;
  };
  const visit = (size) => visitAt(port, size);
  const says = (page, id, expected) => page.waitForFunction((i, e) => new RegExp(e).test(document.getElementById(i).textContent), { timeout: 30_000 }, id, expected).then(() => true, () => false);
  const enter = (page, values) => page.$eval('#tests form', (form, all) => {
    for (const [name, value] of Object.entries(all)) {
      form.elements[name].value = value;
      for (const event of ['input', 'change']) form.elements[name].dispatchEvent(new Event(event));
    }
  }, values);
  const begin = (page) => press(page, '#tests form button:not([type])');
  const end = (page) => press(page, '#tests form button[type=button]');
  const curves = (page) => page.$$eval('#tests figure', (all) => all.map((one) => ({ title: one.textContent.replace(/[\d.-]+$/, ''), label: one.querySelector('svg').getAttribute('aria-label'), points: one.querySelector('polyline').getAttribute('points').split(' ').map((p) => p.split(',').map(Number)) })));
  const answers = (page, count) => page.waitForFunction((n) => document.querySelectorAll('#tests figure').length === n, { timeout: 60_000 }, count).then(() => true, () => false);
  const signal = (page) => page.$eval('[data-path="test_servo_reference.signal"]', (e) => e.value);
  const becomes = (page, wanted) => page.waitForFunction((w) => document.querySelector('[data-path="test_servo_reference.signal"]')?.value === w, { timeout: 10_000 }, wanted).then(() => true, () => false);

  // The axis moves when it starts and when its gains change.
  const beatOf = (page) => page.$eval('#beat', (e) => Number(e.textContent));
  const atRest = async (page) => page.waitForFunction((b) => Number(document.getElementById('beat').textContent) > b, { timeout: 60_000 }, await beatOf(page) + 4000);

  let page = await visit({ width: 1280, height: 900 });
  check('test of an input: who does not command can begin none', await page.$$eval('#tests form .changes', (all) => all.length > 8 && all.every((e) => e.disabled)), await page.$$eval('#tests form .changes', (all) => all.map((e) => e.disabled)));
  await says(page, 'commander', 'nobody commands');
  await press(page, '#command');
  await says(page, 'commander', 'this page commands');
  // The soft gains of docs/tuning.md.
  for (const [path, value] of [['servo.proportional', '1'], ['servo.derivative', '0.05'], ['servo.filter', '0.001']]) {
    await page.$eval(`[data-path^="${path}"]`, (e, v) => { e.value = v; e.dispatchEvent(new Event('change')); }, value);
    await says(page, 'message', `${path}.* = `);
  }

  // ---- a chirp ----
  const slider = await page.$eval('#tests [name=amplitude]', ({ min, max, ariaLabel }) => ({ min, max, ariaLabel }));
  check('test of an input: the slider has the range of the declaration', slider.min === '0' && slider.max === '0.2' && /0\.2 rad/.test(slider.ariaLabel), slider);
  check('test of an input: the output is what the servo measures', await page.$eval('#tests [name=output]', (e) => e.value) === 'drive.angle', await page.$eval('#tests [name=output]', (e) => e.value));
  await enter(page, { signal: 'chirp', output: 'drive.angle', amplitude: 0.05, frequency: 0.5, to: 50, duration: 20 });
  await atRest(page);
  await begin(page);
  check('test of an input: it begins', await says(page, 'message', 'tests servo.reference by a chirp') && await says(page, 'log', '/cca/test servo.reference'), [await text(page, '#message'), await text(page, '#log li .what')]);
  await begin(page);
  check('test of an input: no second one while it runs', await says(page, 'message', 'refused: .*a test of servo.reference runs'), await text(page, '#message'));
  await answers(page, 3);
  check('test of an input: it says when it is over', await says(page, 'message', 'the test of servo.reference is over'), await text(page, '#message'));
  const [gain, phase, coherence] = await curves(page);
  const range = (of) => /: (\S+) to (\S+)$/.exec(of?.label)?.slice(1).map(Number) ?? [];
  const seen = { points: gain?.points.length, gain: range(gain), phase: range(phase), coherence: range(coherence) };
  // Of the closed loop: 0 dB where it is slow, a resonance of 4 dB near 1.4 Hz, then 40 dB a decade down.
  const top = gain?.points.reduce((most, p) => (p[1] < most[1] ? p : most), [0, 1e9]) ?? [0, 0];
  const peak = 0.5 * 100 ** ((top[0] - 52) / (420 - 52 - 8));
  check('test of an input: gain, phase and coherence are curves of 60 points', [gain, phase, coherence].every((one) => one?.points.length === 60 && one.points.every((p) => p.every((v) => v >= 0 && v <= 420))), seen);
  check('test of an input: they are the closed loop', Math.abs(seen.gain[1] - closedLoop(peak)) < 0.5 && Math.abs(seen.gain[0] - closedLoop(50)) < 2 && Math.abs(peak - 1.4) < 0.3 && seen.phase[0] < -150 && seen.phase[1] < 0 && seen.coherence[1] > 0.99, { ...seen, peak, computed: [closedLoop(50), closedLoop(peak)] });
  await page.$eval('#tests', (e) => e.scrollIntoView({ block: 'center' }));
  await accessible(page, 'test of an input');
  await picture(page, 'input-test');

  // ---- one that is ended ----
  await enter(page, { duration: 300 });
  await begin(page);
  const began = await becomes(page, 'chirp');
  await end(page);
  const ended = await says(page, 'message', 'the test has ended|the test of servo.reference is over');
  check('test of an input: the button ends it', began && ended && await becomes(page, 'off'), [began, await signal(page), await text(page, '#message')]);
  await end(page);
  check('test of an input: where none runs, there is none to end', await says(page, 'message', 'refused: .*no test runs'), await text(page, '#message'));

  // ---- refusals: with the reason of the program ----
  await page.$eval('#tests [name=amplitude]', (e) => { e.max = 9; });
  await enter(page, { amplitude: 0.5, duration: 10 });
  await begin(page);
  check('test of an input: an amplitude beyond is refused, with the range', await says(page, 'message', 'refused: .*amplitude.*from -0.2 to 0.2 rad'), await text(page, '#message'));
  await enter(page, { amplitude: 0.1, to: 600 });
  await begin(page);
  check('test of an input: and a frequency that is too high', await says(page, 'message', 'refused: .*below half its rate'), await text(page, '#message'));

  // ---- a step ----
  await enter(page, { signal: 'step', duration: 2 });
  check('test of an input: a step has no frequency', await page.$$eval('#tests [name=frequency], #tests [name=to]', (all) => all.every((e) => e.getBoundingClientRect().width === 0)), await page.$$eval('#tests [name=frequency], #tests [name=to]', (all) => all.map((e) => e.getBoundingClientRect().width)));
  await begin(page);
  await answers(page, 1);
  const told = await text(page, '#tests .answer p');
  check('test of an input: the figures of a step', /^rises in 0\.1[34]\d* s, overshoot (29|3[0-3])[.\d]* %, settled after [01]\.\d+ s$/.test(told), told);
  await page.close();

  // ---- a telephone ----
  page = await visit({ width: 390, height: 844, deviceScaleFactor: 1, isMobile: true, hasTouch: true });
  await says(page, 'commander', 'nobody commands');
  await press(page, '#command');
  await says(page, 'commander', 'this page commands');
  await enter(page, { output: 'drive.angle', amplitude: 0.05, frequency: 0.5, duration: 5 });
  await begin(page);
  await answers(page, 3);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  check('test of an input: 390 pixels are enough', (await curves(page)).length === 3 && width <= 390, width);
  await page.$eval('#tests', (e) => e.scrollIntoView({ block: 'start' }));
  await accessible(page, 'test of an input, narrow');
  await picture(page, 'input-test-narrow');
  // The connection is lost with the page: so is the test.
  await enter(page, { duration: 300 });
  await begin(page);
  const onPhone = await becomes(page, 'chirp');
  await page.close();
  page = await visit({ width: 1280, height: 900 });
  const off = await becomes(page, 'off');
  check('test of an input: it ends with the page that began it', onPhone && off && await says(page, 'log', 'ends the test of servo.reference'), [await signal(page), await text(page, '#log')]);
  await page.close();
  program.kill('SIGKILL');
  await severalAxes(tools, { folder, visitAt, enter, begin, answers, curves, range });
}

// Two joints of 20 ms, one driven by the other: page/two_joints.cpp.
async function severalAxes(tools, { folder, visitAt, enter, begin, answers, curves, range }) {
  const { options, check, picture, press, accessible } = tools;
  const port = await freePort();
  const program = await run({ program: options['two-joints'] }, port, token, folder);
  const page = await visitAt(port, { width: 1280, height: 900 });
  const offered = (name) => page.$eval(`#tests [name=${name}]`, (e) => ({ shown: e.getBoundingClientRect().width > 0, names: [...e.options].map((o) => o.text), chosen: e.selectedOptions[0]?.text }));
  const axes = async () => Object.fromEntries(await Promise.all(['axis', 'output_axis', 'from_axis'].map(async (name) => [name, await offered(name)])));
  const is = (one, chosen) => one.shown && one.names.join() === 'hip,knee' && one.chosen === chosen;
  await enter(page, { output: 'leg.angles' });
  let now = await axes();
  check('test of an input: axes are asked for where there are several', is(now.axis, 'hip') && is(now.output_axis, 'hip') && !now.from_axis.shown, now);
  check('test of an input: the response can be from any output', (await offered('from')).names.join() === 'the signal,rest.angles,limits.safe,leg.angles,leg.knee', await offered('from'));
  await enter(page, { axis: 1, from: 'limits.safe' });
  now = await axes();
  check('test of an input: the axis of the input is the first choice for the others', is(now.output_axis, 'knee') && is(now.from_axis, 'knee'), now);
  await enter(page, { axis: 0, output: 'leg.knee' });
  now = await axes();
  check('test of an input: no axis is asked for of an output that has one', !now.output_axis.shown && is(now.from_axis, 'hip'), now);
  await enter(page, { signal: 'step' });
  check('test of an input: the response to a step is that to the signal', !(await offered('from')).shown && !(await offered('from_axis')).shown, await offered('from'));

  await press(page, '#command');
  await page.waitForFunction(() => !document.querySelector('#tests form button').disabled);
  // Gain in dB at 2 and at 20 Hz, by the number of joints between.
  const expected = [0, 1, 2].map((joints) => [20, 2].map((hz) => -20 * joints * Math.log10(Math.hypot(1, 2 * Math.PI * hz * 0.02))));
  for (const [name, values, joints] of [
    ['from the signal at one axis to another', { output: 'leg.angles', output_axis: 1, from: '' }, 2],
    ['from one axis to another of an output', { output: 'leg.angles', output_axis: 1, from: 'leg.angles', from_axis: 0 }, 1],
    ['from the output to itself', { output: 'leg.knee', from: 'leg.angles', from_axis: 1 }, 0],
  ]) {
    // The axes after what they are of.
    await enter(page, { signal: 'chirp', axis: 0, amplitude: 0.2, frequency: 2, to: 20, duration: 5, output: values.output, from: values.from });
    await enter(page, values);
    await page.$eval('#tests .answer', (e) => e.replaceChildren());
    await begin(page);
    await answers(page, 3);
    const gain = range((await curves(page))[0]);
    check(`test of an input: ${name}`, gain.length === 2 && gain.every((v, i) => Math.abs(v - expected[joints][i]) < 0.7), { gain, expected: expected[joints] });
    if (joints === 1) {
      await accessible(page, 'test of an input, several axes');
      await picture(page, 'input-test-axes');
    }
  }
  await page.close();
  program.kill('SIGKILL');
}

// In dB, from the reference to the angle: kp P / (1 + P (kp + kd s)), P = 1 / (s (0.01 s + 0.02)).
function closedLoop(frequency) {
  const w = 2 * Math.PI * frequency;
  return -20 * Math.log10(Math.hypot(1 - 0.01 * w * w, w * (0.02 + 0.05)));
}
