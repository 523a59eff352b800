// The trot, live: what a user does on its page.
import { readFileSync } from 'node:fs';

export async function checkTrot(tools) {
  const { options, check, near, open, text, number, settle, message, press, runAhead, parameter, picture, accessible, position, state, requests } = tools;
  const native = JSON.parse(readFileSync(options.native, 'utf8'));
  const [head, ...lines] = readFileSync(options.path, 'utf8').trim().split('\n').map((l) => l.split(','));
  const column = (name) => head.findIndex((h) => h.trim() === name);
  const nativeAt = (seconds) => {
    const row = lines.reduce((best, l) => (Math.abs(l[column('time')] - seconds) < Math.abs(best[column('time')] - seconds) ? l : best));
    return ['x', 'y', 'z'].map((axis) => Number(row[column(axis)]));
  };

  // The program and the page compute the same bits, so their files differ by what a file rounds.
  const asInFile = (place) => place.map((v) => Number(v.toPrecision(6)));
  const isProgrammes = (place, there) => JSON.stringify(asInFile(place)) === JSON.stringify(there);

  const page = await open(options.page);
  const insideNow = () => page.evaluate(() => window.ccaPage.source.position());
  check('the page starts', (await page.$eval('html', (e) => e.dataset.ready)) === 'true', await text(page, 'h1'));
  check('one file is enough: no request to anywhere', requests.length === 0, requests);
  check('the state is shown', (await state(page)) === 'started', await state(page));
  const nodes = await page.$$eval('[data-node]', (all) => all.map((e) => e.dataset.node));
  check('the architecture has all components of the type', ['throttle', 'posture', 'cpg', 'gait', 'limits', 'robot'].every((n) => nodes.includes(n)), nodes);
  const wires = await page.$$eval('.wire-label', (all) => all.map((e) => e.textContent));
  check('the wires are named', wires.some((w) => w.includes('amplitude')) && wires.some((w) => w.includes('turn')), wires);
  check('the rates are shown', (await text(page, '[data-node=throttle] .when')) === '100 Hz' && (await text(page, '[data-node=cpg] .when')) === '1 kHz', await page.$$eval('.when', (all) => all.map((e) => e.textContent)));
  check('before the first beat no port has a value', (await page.$$eval('.port .value', (all) => all.every((e) => e.textContent === '—'))), await text(page, '[data-port="cpg.phase"]'));
  const begin = await position(page), start = await insideNow();
  check('the robot stands where the program puts it', near(begin[0], 0, 1e-3) && begin[2] > 0.12 && begin[2] < 0.22, begin);

  await press(page, '#step');
  await settle(page);
  check('a step is one beat', (await number(page, '#beat')) === 1, await number(page, '#beat'));
  check('after a beat the ports have values, with unit and age', /rad · \d+ ms/.test(await text(page, '[data-port="cpg.phase"]')), await text(page, '[data-port="cpg.phase"]'));
  const fires = () => page.$$eval('.node.fires', (all) => all.map((e) => e.dataset.node));
  check('beat 0: the 100 Hz components fire', (await fires()).includes('throttle'), await fires());
  await press(page, '#step');
  await settle(page);
  check('beat 1: only those of 1 kHz fire', !(await fires()).includes('throttle') && (await fires()).includes('cpg'), await fires());
  check('a value that was not published again gets older', /· 1 ms/.test(await text(page, '[data-port="throttle.amplitude"]')), await text(page, '[data-port="throttle.amplitude"]'));

  await runAhead(page, 1.998);
  check('runs on, as fast as possible', (await number(page, '#time')) === 2, await number(page, '#time'));
  const at2 = await insideNow(), native2 = nativeAt(2);
  check('after 2 s the position is the program’s', isProgrammes(at2, native2), { page: at2, program: native2 });
  await runAhead(page, 18);
  const at20 = await insideNow();
  check('after 20 s the distance is that of `trot --summary`, bit for bit', at20[0] - start[0] === native.distance_m, { page: at20[0] - start[0], program: native.distance_m });
  const native20 = nativeAt(20);
  check('after 20 s the position is the program’s', isProgrammes(at20, native20), { page: at20, program: native20 });
  const inside = await page.evaluate(() => ({ shown: ['x', 'y', 'z'].map((a) => document.getElementById(a).textContent), world: window.ccaPage.source.position() }));
  check('the position shown is that of the world inside', inside.shown.every((t, i) => t === inside.world[i].toFixed(4)), inside);
  const drawn = await page.evaluate(() => { const p = window.ccaPage.robot.bodies[0].position; return [p.x, p.y, p.z]; });
  check('the trunk is drawn where the world has it', drawn.every((v, i) => near(v, inside.world[i], 1e-9)), drawn);
  const legs = await page.evaluate(() => {
    const { robot, source } = window.ccaPage, { bodies } = source.description.robot;
    // An end of a segment: a body lies along its z axis.
    const end = (i, side) => robot.bodies[i].position.clone().add(robot.bodies[i].position.clone().set(0, 0, (side * bodies[i].size[1]) / 2).applyQuaternion(robot.bodies[i].quaternion));
    return [0, 1, 2, 3].map((leg) => {
      const upper = 1 + 4 * leg, foot = source.poses.subarray(119 + 6 * leg, 122 + 6 * leg);
      return { knee: end(upper, -1).distanceTo(end(upper + 1, 1)), ankle: end(upper + 1, -1).distanceTo(end(upper + 2, 1)), foot: robot.bodies[upper + 3].position.distanceTo({ x: foot[0], y: foot[1], z: foot[2] }) };
    });
  });
  check('the segments of each leg are drawn joint to joint, and its foot where the world has it', legs.every((l) => l.knee < 1e-9 && l.ankle < 1e-9 && l.foot < 1e-9), legs);
  check('it has not fallen', !native.fell && (await text(page, '#alert')) === '', await text(page, '#alert'));
  const stance = await page.evaluate(() => window.ccaPage.source && document.getElementById('stance').textContent);
  check('footfalls: each foot stands for a part of the stride', (stance.match(/\d+ %/g) ?? []).every((p) => parseInt(p) > 30 && parseInt(p) < 85) && stance.includes('left front'), stance);
  const forces = await page.evaluate(() => {
    const s = window.ccaPage.source;
    let sum = 0;
    for (let k = s.beat - 1000; k < s.beat; ++k) for (let leg = 0; leg < 4; ++leg) sum += s.extra(k, 3 + 3 * leg + 2);
    return { mean: sum / 1000, weight: s.description.robot.weight };
  });
  check('the feet carry the robot’s weight', near(forces.mean / forces.weight, 1, 0.05), forces);
  check('forces are drawn on feet that stand', await page.evaluate(() => window.ccaPage.robot.forces.some((f) => f.visible)), await page.evaluate(() => window.ccaPage.robot.forces.map((f) => f.visible)));
  const targets = await page.evaluate(() => window.ccaPage.robot.targets.map((t, i) => t.position.distanceTo({ x: window.ccaPage.source.poses[119 + 6 * i], y: window.ccaPage.source.poses[120 + 6 * i], z: window.ccaPage.source.poses[121 + 6 * i] })));
  check('targets are drawn near the feet', targets.every((d) => d > 0 && d < 0.06), targets);
  const colours = await page.evaluate(() => {
    const canvas = document.getElementById('robot'), copy = document.createElement('canvas');
    copy.width = 80; copy.height = 60;
    const g = copy.getContext('2d');
    window.ccaPage.robot.draw(window.ccaPage.source.poses, window.ccaPage.source.forces(), window.ccaPage.source.targets());
    g.drawImage(canvas, 0, 0, 80, 60);
    const seen = new Set();
    const d = g.getImageData(0, 0, 80, 60).data;
    for (let i = 0; i < d.length; i += 4) seen.add(`${d[i] >> 4},${d[i + 1] >> 4},${d[i + 2] >> 4}`);
    return seen.size;
  });
  check('the picture of the robot is not empty', colours > 12, `${colours} colours`);
  await picture(page, 'trot');

  // Going back.
  await page.select('#snapshots', '18000');
  await press(page, '#go-back');
  await settle(page);
  check('goes back to an earlier snapshot', (await number(page, '#time')) === 18, `${await text(page, '#time')} s, ${await message(page)}`);
  await runAhead(page, 2);
  const again = await page.evaluate(() => window.ccaPage.source.position());
  check('from the snapshot on everything happens again, bit for bit', again.every((v, i) => v === inside.world[i]), { first: inside.world, again });

  // A push.
  await page.select('#snapshots', '18000');
  await press(page, '#go-back');
  await page.$eval('#push-force', (e) => { e.value = 15; });
  await press(page, '[data-push="0,1"]');
  await runAhead(page, 0.3);
  const pushed = await page.evaluate(() => window.ccaPage.source.position());
  const unpushed = await page.evaluate(() => { const s = window.ccaPage.source; s.goBack(18000); s.advance(300); return s.position(); });
  check('a push to the left by a button moves it to the left', pushed[1] > unpushed[1] + 0.002, { pushed: pushed[1], unpushed: unpushed[1] });
  await page.select('#snapshots', '18000');
  await press(page, '#go-back');
  await settle(page);
  await page.$eval('#robot', (e) => e.scrollIntoView({ block: 'center' }));
  const [px, py] = await page.evaluate(() => window.ccaPage.robot.pushedOnScreen());
  await page.mouse.move(px, py);
  await page.mouse.down();
  await page.mouse.move(px + 5, py - 40, { steps: 4 });
  const dragged = await page.evaluate(() => window.ccaPage.robot.push?.toArray());
  await page.evaluate(() => { for (let i = 0; i < 60; ++i) window.ccaPage.source.advance(1); });
  await settle(page, 2);
  await picture(page, 'push');
  await page.mouse.up();
  await runAhead(page, 0.2);
  const afterDrag = await page.evaluate(() => window.ccaPage.source.position());
  const undisturbed = await page.evaluate(() => { const s = window.ccaPage.source; const end = s.beat; s.goBack(18000); s.advance(end - 18000); return s.position(); });
  check('a snapshot keeps no push that came later', undisturbed[1] < 0.1, undisturbed);
  check('dragging the robot with the mouse pushes it', dragged && Math.hypot(...dragged) > 1 && Math.hypot(afterDrag[0] - undisturbed[0], afterDrag[1] - undisturbed[1]) > 1e-4, { force: dragged, pushed: afterDrag, undisturbed });

  // Parameters.
  const fields = await page.$$eval('#parameters [data-path]', (all) => all.map((e) => e.dataset.path));
  check('each parameter has a field', ['throttle.speed', 'posture.heading', 'cpg.frequency', 'gait.front.hip', 'gait.offsets[2]'].every((p) => fields.includes(p)), `${fields.length} fields`);
  const speedRange = await page.$eval('[data-path="throttle.speed"]', (e) => e.parentElement.querySelector('small').textContent);
  check('ranges and units are shown', speedRange === '0 to 1 m/s', speedRange);
  const set = await parameter(page, 'throttle.speed', '0.4');
  check('a value is set', !set.invalid && (await page.evaluate(() => window.ccaPage.source.parameters()[0])) === 0.4, set);
  const refused = await parameter(page, 'throttle.speed', '7');
  check('a refused value shows the reason', refused.invalid && refused.reason.includes('7 m/s is out of range, expected 0 to 1 m/s'), refused);
  check('a refused value changes nothing', (await page.evaluate(() => window.ccaPage.source.parameters()[0])) === 0.4, await page.evaluate(() => window.ccaPage.source.parameters()[0]));
  const notNumber = await parameter(page, 'throttle.speed', 'nan');
  check('NaN is refused', notNumber.invalid && notNumber.reason.includes('nan m/s is not allowed'), notNumber);
  const word = await parameter(page, 'throttle.speed', 'fast');
  check('a word is refused', word.invalid && word.reason.includes('expected a number'), word);
  const furlong = await parameter(page, 'gait.front.hip', '3 furlong');
  check('an unknown unit is refused, and the known ones are named', furlong.invalid && furlong.reason.includes('rad') && furlong.reason.includes('deg'), furlong);
  const degrees = await parameter(page, 'gait.front.hip', '45.5 deg');
  check('a value may have a unit', !degrees.invalid && /= 0\.794/.test(await message(page)), await message(page));
  await picture(page, 'refused');

  // The life-cycle.
  const enabled = () => page.$$eval('[data-change]', (all) => Object.fromEntries(all.map((e) => [e.dataset.change, !e.disabled])));
  check('only what the state allows can be pressed', JSON.stringify(await enabled()) === '{"load":false,"start":false,"stop":true,"resume":false,"save":false}', await enabled());
  await press(page, '[data-change=stop]');
  await settle(page);
  check('stop', (await state(page)) === 'loaded', await state(page));
  const still = await number(page, '#beat');
  check('a stopped controller makes no beat', await page.$eval('#step', (e) => e.disabled) && (await page.evaluate(() => window.ccaPage.source.advance(5))) === 0 && (await number(page, '#beat')) === still, still);
  await press(page, '[data-change=save]');
  await settle(page);
  const saved = await state(page);
  const refusal = await page.evaluate(() => { try { window.ccaPage.source.change('start'); return 'not refused'; } catch (e) { return e.message; } });
  check('what the life-cycle refuses is shown with the controller’s own words', refusal === 'cca::controller: start() is refused in the state `created`: load() it first', refusal);
  await press(page, '[data-change=load]');
  await settle(page);
  const loaded = await state(page);
  await press(page, '[data-change=start]');
  await settle(page);
  check('save, load and start', saved === 'created' && loaded === 'loaded' && (await state(page)) === 'started', [saved, loaded, await state(page)]);
  await press(page, '#anew');
  await settle(page);
  check('begins anew, and keeps the parameters', (await number(page, '#beat')) === 0 && (await state(page)) === 'created' && (await page.evaluate(() => window.ccaPage.source.parameters()[0])) === 0.4, [await number(page, '#beat'), await state(page)]);
  await press(page, '[data-change=load]');
  await settle(page, 2);
  await press(page, '[data-change=start]');
  await settle(page, 2);
  await runAhead(page, 4);
  const slow = await position(page);
  check('with 0.4 m/s it is slower than with 0.75', slow[0] < nativeAt(4)[0] - 0.3 && slow[0] > 0.5, { at04: slow[0], at075: nativeAt(4)[0] });

  // Plots.
  const plotCount = () => page.$$eval('.plot', (all) => all.length);
  check('a plot of a command and what is measured of it', (await page.$$eval('.plot:first-child .curve', (all) => all.map((e) => e.textContent))).length === 2, await page.$$eval('.plot:first-child .curve', (all) => all.map((e) => e.textContent)));
  const before = await plotCount();
  await press(page, '[data-port="throttle.amplitude"]');
  await settle(page);
  check('a click on a port plots it', (await plotCount()) === before + 1 && (await page.$$eval('.curve', (all) => all.map((e) => e.textContent))).some((t) => t.includes('throttle.amplitude')), await plotCount());
  const force = await page.$$eval('#port option', (all) => all.find((o) => o.textContent.startsWith('foot_loads'))?.value);
  await page.select('#port', force);
  await page.select('#in-plot', '0');
  await press(page, '#add-curve');
  await settle(page);
  check('several curves in one plot, each with its unit', (await page.$$eval('.plot:first-child .curve', (all) => all.map((e) => e.textContent))).some((t) => /foot_loads.* N/.test(t)) && (await page.$$eval('.plot:first-child .curve', (all) => all.map((e) => e.textContent))).some((t) => t.includes('rad')), await page.$$eval('.plot:first-child .curve', (all) => all.map((e) => e.textContent)));
  const plotted = await page.evaluate(() => { const { plots, source } = window.ccaPage; const curve = plots.plots[0].series[0]; const data = plots.plots[0].chart.data; return { time: data[0].at(-1), value: data[1].at(-1), sample: source.row(Math.round(data[0].at(-1) / source.period))[source.description.outputs[curve.output].at + curve.i] }; });
  check('what is plotted is what was published', plotted.value === plotted.sample, plotted);
  const dashes = await page.evaluate(() => window.ccaPage.plots.plots[0].chart.series.slice(1).map((s) => `${s.stroke()} ${s.dash}`));
  check('curves differ in colour and in dash', new Set(dashes.map((d) => d.split(' ')[0])).size === dashes.length && new Set(dashes.map((d) => d.split(' ')[1])).size === dashes.length, dashes);
  await press(page, '#pause');
  const shown = () => page.evaluate(() => window.ccaPage.plots.shown());
  const paused = await shown();
  await runAhead(page, 0.5);
  check('a paused plot stands still while the robot runs on', JSON.stringify(await shown()) === JSON.stringify(paused), paused);
  await press(page, '#zoom-in');
  const zoomed = await shown();
  check('zooms in', near(zoomed[1] - zoomed[0], (paused[1] - paused[0]) / 2, 1e-9), zoomed);
  await press(page, '#zoom-all');
  await press(page, '#pause');
  await settle(page);
  check('goes on with the newest values', (await shown())[1] > paused[1], await shown());
  await page.$eval('.plot:first-child .u-over', (e) => e.scrollIntoView({ block: 'center' }));
  const over = await (await page.$('.plot:first-child .u-over')).boundingBox();
  await page.mouse.move(over.x + over.width * 0.25, over.y + 60);
  await page.mouse.down();
  await page.mouse.move(over.x + over.width * 0.5, over.y + 70, { steps: 4 });
  await page.mouse.up();
  const byMouse = await shown();
  check('a drag over a plot zooms to what it covers', near(byMouse[1] - byMouse[0], 1, 0.05), byMouse);
  await picture(page, 'plots');
  await press(page, '#zoom-all');
  await press(page, '.plot:last-child .curve button');
  await settle(page);
  check('a curve can be removed', (await plotCount()) === before, await plotCount());

  // Slow motion, keys.
  await page.select('#speed', '0.1');
  await page.evaluate(() => { document.activeElement.blur(); window.started = [performance.now(), window.ccaPage.source.time]; });
  await page.keyboard.press('Space');
  const pressed = await page.$eval('#play', (e) => e.getAttribute('aria-pressed'));
  await new Promise((done) => { setTimeout(done, 3000); });
  const ratio = await page.evaluate(() => (window.ccaPage.source.time - window.started[1]) / ((performance.now() - window.started[0]) / 1e3));
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('Space');
  check('the space bar runs and pauses', pressed === 'true' && (await page.$eval('#play', (e) => e.getAttribute('aria-pressed'))) === 'false', pressed);
  check('slow motion: a tenth of the speed, or less on a busy machine', ratio > 0 && ratio < 0.13, ratio);
  await settle(page);
  const beat = await number(page, '#beat');
  await page.keyboard.press('.');
  await settle(page);
  check('the full stop is a single beat', (await number(page, '#beat')) === beat + 1, await number(page, '#beat'));
  const turned = await page.evaluate(() => { const { robot } = window.ccaPage; const was = robot.angle.azimuth; document.getElementById('robot').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true })); return robot.angle.azimuth - was; });
  check('arrow keys turn the view', turned !== 0, turned);
  const tabs = new Set();
  await page.evaluate(() => document.activeElement.blur());
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press('Tab');
    tabs.add(await page.evaluate(() => document.activeElement.id || document.activeElement.dataset.change || document.activeElement.dataset.push || document.activeElement.dataset.port || document.activeElement.tagName));
  }
  check('everything can be reached by the tabulator', ['play', 'step', 'speed', 'stop', 'go-back', 'robot', 'cpg.phase'].every((t) => tabs.has(t)), [...tabs]);

  // Inner components.
  const few = await page.$$eval('[data-node]', (all) => all.length);
  await press(page, '#open');
  await settle(page);
  const inner = await page.$$eval('[data-node]', (all) => all.map((e) => e.dataset.node));
  check('the inner components of the robot can be shown', inner.length > few + 8 && inner.includes('robot.simulator'), `${few}, then ${inner.length}`);
  await picture(page, 'inner', true);
  await press(page, '#open');

  // Looks.
  await page.$eval('#theme', (e) => { if (document.documentElement.dataset.theme === 'dark') e.click(); });
  await settle(page);
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const lightPaper = await paper();
  await accessible(page, 'light');
  await press(page, '#theme');
  await settle(page);
  check('dark and light', lightPaper !== (await paper()), [lightPaper, await paper()]);
  await accessible(page, 'dark');
  await picture(page, 'dark');
  await page.setViewport({ width: 360, height: 740, deviceScaleFactor: 2, isMobile: true, hasTouch: true });
  await settle(page, 10);
  const wide = await page.evaluate(() => ({ page: document.documentElement.scrollWidth, screen: innerWidth }));
  check('360 pixels are enough: nothing is wider than the screen', wide.page <= 360 && wide.screen <= 360, wide);
  await accessible(page, '360 pixels');
  await picture(page, 'narrow', true);
  await page.close();
}
