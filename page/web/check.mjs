// Looks at a page in a headless Chromium, does what a user does, and writes what it saw.
//   node check.mjs --page trot.html ... --out check.json --pictures FOLDER [--only trot,touch]     page/CMakeLists.txt has all options
// It ends with 1 if a check has not passed.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { createRequire } from 'node:module';
import { launch } from './browser.mjs';
import { checkDoor, checkManyOutputs } from './check_door.mjs';
import { checkInputTest } from './check_input_test.mjs';
import { checkFault, checkSkills } from './check_skills.mjs';
import { checkDescribed, checkPages, checkRecording, checkRefusals } from './check_recording.mjs';
import { checkSession } from './check_session.mjs';
import { checkTouch } from './check_touch.mjs';
import { checkTrot } from './check_trot.mjs';
import { checkTwin, checkTwinOnDrives } from './check_twin.mjs';
import { checkViewer } from './check_viewer.mjs';

const options = Object.fromEntries(process.argv.slice(2).join('\n').split(/^--/m).filter(Boolean).map((o) => o.trim().split('\n')));
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const checks = [];
function check(name, passed, value) {
  checks.push({ check: name, passed: Boolean(passed), value });
  console.log(`${passed ? 'passed' : 'FAILED'}  ${name}: ${typeof value === 'object' ? JSON.stringify(value) : value}`);
}
const near = (a, b, most) => Math.abs(a - b) <= most;

const browser = await launch();
const complaints = [], requests = [];
async function open(file, hash = 'paused', size = { width: 1440, height: 1000 }) {
  const page = await browser.newPage();
  page.setDefaultTimeout(180_000);
  page.on('console', (message) => { if (['error', 'warn'].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`); });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) requests.push(request.url()); });
  await page.setViewport(size);
  await page.goto(`${pathToFileURL(file).href}#${hash}`);
  await page.waitForSelector('html[data-ready]');
  return page;
}
const text = (page, selector) => page.$eval(selector, (e) => e.textContent.trim());
const number = async (page, selector) => Number(await text(page, selector));
const settle = (page, frames = 6) => page.evaluate((n) => new Promise((done) => {
  const wait = (left) => (left ? requestAnimationFrame(() => wait(left - 1)) : done());
  wait(n);
}), frames);
const message = (page) => text(page, '#message');
// In the middle of the window, so that the bar at the top does not lie over it.
async function press(page, selector) {
  await page.$eval(selector, (e) => e.scrollIntoView({ block: 'center' }));
  await page.click(selector);
}
async function runAhead(page, seconds) {
  const end = (await number(page, '#beat')) + Math.round(seconds * 1000);
  await page.$eval('#ahead', (e, v) => { e.value = v; }, seconds);
  await press(page, '#run-ahead');
  await page.waitForFunction((beat) => Number(document.getElementById('beat').textContent) >= beat, { timeout: 600_000 }, end);
  await settle(page);
}
async function parameter(page, path, value) {
  await page.$eval(`[data-path="${path}"]`, (e, v) => { e.value = v; e.dispatchEvent(new Event('change')); }, value);
  await settle(page, 3);
  return page.$eval(`[data-path="${path}"]`, (e) => ({ value: e.value, invalid: e.getAttribute('aria-invalid') === 'true', reason: e.parentElement.querySelector('.reason').textContent }));
}
const picture = (page, name, full = false) => page.screenshot({ path: `${options.pictures}/${name}.png`, fullPage: full });
async function accessible(page, name) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'] }));
  const serious = violations.filter((v) => ['serious', 'critical'].includes(v.impact)).map((v) => `${v.id}: ${v.nodes[0].target}`);
  check(`axe has no serious finding: ${name}`, serious.length === 0, serious);
}
const position = async (page) => [await number(page, '#x'), await number(page, '#y'), await number(page, '#z')];
const state = (page) => text(page, '#state');

// `--only touch`: while you work on them.
const parts = { trot: checkTrot, fault: checkFault, skills: checkSkills, touch: checkTouch, recording: checkRecording, refusals: checkRefusals, pages: checkPages, described: checkDescribed, door: checkDoor, test: checkInputTest, twin: checkTwin, drives: checkTwinOnDrives, session: checkSession, many: checkManyOutputs, viewer: checkViewer };
const wanted = options.only?.split(',') ?? Object.keys(parts);
for (const part of wanted) await parts[part]({ options, check, near, open, text, number, settle, message, press, runAhead, parameter, picture, accessible, position, state, requests, browser, complaints });

// The driver of the graphics card in software says that each picture is read back from it (browser.mjs): not the page's.
const ours = complaints.filter((one) => !/GPU stall due to ReadPixels/.test(one));
check('no error and no warning in the console', ours.length === 0, ours);
await browser.close();
writeFileSync(options.out, `${JSON.stringify(checks, null, 1)}\n`);
const failed = checks.filter((c) => !c.passed);
console.log(`${checks.length} checks, ${failed.length} failed: ${options.out}`);
process.exit(failed.length > 0 || checks.length < 40 ? 1 : 0);
