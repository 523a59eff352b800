// A viewer that others have made, at a running program: Foxglove Studio 1.48, whose parts are in npm
// (@foxglove/studio-base, MPL-2.0). It shows the robot, plots, messages and parameters. None of its code is in this
// repository: npm fetches it. page/viewer/viewer.html has its panels.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';

const types = { js: 'text/javascript', html: 'text/html; charset=utf-8', wasm: 'application/wasm' };

// The viewer's files, at an address of their own: for a door, a page of elsewhere.
function serve(folder) {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const file = pathname === '/' ? `${folder}/viewer.html` : `${folder}/node_modules${pathname}`;
    if (pathname.includes('..') || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { 'Content-Type': types[file.split('.').pop()] ?? 'application/octet-stream' }).end(readFileSync(file));
  });
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done(server)));
}

// How many pixels of a picture of a part of the page have that colour, nearly.
async function pixels(page, clip, is) {
  const picture = await page.screenshot({ clip, encoding: 'base64' });
  return page.evaluate(async (data, test) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data: all } = context.getImageData(0, 0, image.width, image.height), holds = new Function('r', 'g', 'b', `return ${test}`);
    let count = 0, place = 0;
    for (let i = 0; i < all.length; i += 4) if (holds(all[i], all[i + 1], all[i + 2])) { ++count; place += (i >> 2) * (count % 7 + 1); }
    return { count, place };
  }, picture, is);
}

export async function checkViewer({ options, check, browser, picture }) {
  const folder = `${options.pictures}/viewer`;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const server = await serve(options.viewer), here = `http://127.0.0.1:${server.address().port}`;
  const program = spawn(options.program, ['--door', '0', '--door-origin', here, '--engine', 'compiled', '--seconds', '900', '--quiet'], { cwd: folder, stdio: ['ignore', 'pipe', 'inherit'] });
  let said = '';
  const [url, once] = await new Promise((done, refuse) => {
    program.stdout.on('data', (text) => {
      said += text;
      const all = [/door: (ws:[^,\s]+),/, /once: (ws:\S+)\n/].map((one) => one.exec(said)?.[1]);
      if (all.every(Boolean)) done(all);
    });
    program.on('exit', () => refuse(new Error(`${options.program} has ended before its door was open:\n${said}`)));
  });
  const problems = [];
  const open = async (address, message) => {
    const page = await browser.newPage();
    page.setDefaultTimeout(240_000);
    page.on('pageerror', (error) => problems.push(error.message));
    await page.bringToFront();
    await page.setViewport({ width: 1400, height: 900 });
    await page.goto(`${here}/?ds=foxglove-websocket&ds.url=${encodeURIComponent(address)}&message=${message}`, { waitUntil: 'domcontentloaded' });
    return page;
  };
  const until = (page, what, ...values) => page.waitForFunction(what, { timeout: 240_000, polling: 250 }, ...values).then(() => true, () => false);
  const text = (page) => page.evaluate(() => document.body.innerText);
  const has = (page, ...words) => until(page, (all) => all.every((one) => document.body.innerText.includes(one)), words);

  let page = await open(url, '/gait/angles');
  check('viewer: it connects, and knows the program', await has(page, 'cca: trot'), (await text(page)).slice(0, 200));
  check('viewer: it lists the outputs with their types', await has(page, '/cpg/phase', 'cca/msg/gait_phase', '/gait/angles', 'cca/msg/leg_angles'), (await text(page)).slice(0, 400));
  check('viewer: it lists the parameters', await has(page, 'throttle.speed', 'cpg.frequency', 'gait.duty'), (await text(page)).slice(-600));
  check('viewer: messages come, with beat and origin', await has(page, 'beat', 'origin'), (await text(page)).slice(-600));
  // Of the 3D panel: what is neither background nor grid is the robot.
  const robot = { x: 425, y: 45, width: 500, height: 830 }, ofRobot = 'Math.max(r, g, b) < 200 && Math.abs(r - g) < 60';
  let seen = { count: 0 };
  for (let tries = 0; tries < 60 && seen.count < 2000; ++tries) {
    await new Promise((done) => setTimeout(done, 1000));
    seen = await pixels(page, robot, ofRobot);
  }
  check('viewer: the robot stands in the 3D panel', seen.count > 2000, seen);
  let later = seen;
  for (let tries = 0; tries < 20 && later.place === seen.place; ++tries) {
    await new Promise((done) => setTimeout(done, 500));
    later = await pixels(page, robot, ofRobot);
  }
  check('viewer: and walks', later.place !== seen.place, [seen, later]);
  await picture(page, 'viewer');
  // What it changes. Without the token nothing; with the address that is valid once, it has the command.
  const enter = async (name, value) => {
    const field = await page.evaluateHandle((n) => [...document.querySelectorAll('tr')].find((row) => row.innerText.startsWith(n))?.querySelector('textarea'), name);
    await field.evaluate((e) => { e.scrollIntoView({ block: 'center' }); e.focus(); e.select(); });
    await page.keyboard.type(String(value));
    await field.evaluate((e) => e.closest('tr').querySelector('button').click());
  };
  await enter('throttle.speed', 0.5);
  check('viewer: without the token it changes nothing, and is told why', await has(page, 'Problems\n1') && (await page.evaluate(() => [...document.querySelectorAll('button')].find((e) => /^Problems/.test(e.innerText)).click()), await has(page, 'needs the token')), (await text(page)).slice(0, 300));
  await page.close();
  page = await open(once, '/cca/parameters/throttle');
  check('viewer: a message of the parameters', await has(page, 'cca/msg/throttle_parameters @', '0.75'), (await text(page)).slice(-200));
  await enter('throttle.speed', 0.5);
  check('viewer: with the address that is valid once it changes a parameter', await until(page, () => /throttle_parameters @[\s\S]*speed\s*0\.5\n/.test(document.body.innerText)), (await text(page)).slice(-200));
  await picture(page, 'viewer-tunes');
  await page.close();
  check('viewer: it complains about nothing', problems.length === 0, problems);
  program.kill('SIGTERM');
  server.close();
  server.closeAllConnections();
}
