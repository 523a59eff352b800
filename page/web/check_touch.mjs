// The compliant arm, live.
import { readFileSync } from 'node:fs';

export async function checkTouch(tools) {
  const { options, check, near, open, text, number, settle, message, press, runAhead, parameter, picture, accessible, position } = tools;
  const native = JSON.parse(readFileSync(options['native-touch'], 'utf8'))[0];
  const [head, ...rows] = readFileSync(options['touch-path'], 'utf8').trim().split('\n').map((l) => l.split(','));
  const moments = rows.map((row) => Object.fromEntries(head.map((name, i) => [name, Number(row[i])])));
  const nativeAt = (seconds) => moments.find((m) => near(m.time, seconds, 1e-6));
  const ended = (step) => moments.findLast((m) => m.step === step);

  const page = await open(options.touch);
  const shown = () => page.evaluate(() => ({ place: window.ccaPage.source.position(), force: window.ccaPage.source.forces()[0], step: window.ccaPage.source.step() }));
  const nodes = await page.$$eval('[data-node]', (all) => all.map((e) => e.dataset.node));
  check('touch: the architecture has all skills of the type', ['sequencer', 'recorder', 'repeat', 'path', 'feel', 'watch', 'operator', 'leader', 'impedance', 'guard', 'limits', 'robot'].every((n) => nodes.includes(n)), nodes);
  const steps = await page.$$eval('#plan li', (all) => all.map((e) => e.textContent));
  check('touch: the plan has its steps', steps.length === 14 && steps[0] === 'guided' && steps.at(-1) === 'rest', steps);
  const current = () => page.$$eval('#plan [aria-current=step]', (all) => all.map((e) => e.textContent).join());
  await press(page, '#step');
  await settle(page);
  check('touch: in the first beat the arm is guided', (await current()) === 'guided', await current());
  check('touch: there are no footfalls', !(await page.$eval('#footfalls', (e) => e.offsetParent)), 'hidden');

  // As the program, from the first beat to the last step: the same bits, of which the file has twelve digits.
  const asInFile = (v) => Number(v.toPrecision(12));
  const compare = async (seconds, name) => {
    await runAhead(page, seconds - (await number(page, '#beat')) / 1000);
    const here = await shown(), there = nativeAt(seconds);
    check(`touch: ${name} (${seconds} s): hand and step are the program’s`, here.step === there.step && ['x', 'y', 'z'].every((axis, i) => asInFile(here.place[i]) === there[axis]), { page: here, program: there });
    check(`touch: ${name} (${seconds} s): the force is the program’s`, ['force_x', 'force_y', 'force_z'].every((axis, i) => asInFile(here.force[i]) === there[axis]), { page: here.force, program: [there.force_x, there.force_y, there.force_z] });
    return here;
  };
  const at = (step, before) => +(ended(step).time - before).toFixed(2);
  await compare(2, 'while somebody leads the hand');
  await compare(at(3, 0.1), 'at the end of the repetition');
  const wipes = steps.indexOf('wipe'), wipesOn = steps.indexOf('wipe on');
  const wiping = await compare(at(wipes, 1.5), 'while it wipes');
  check('touch: it presses with the wanted force', near(Math.hypot(...wiping.force), 10, 3), wiping.force);
  check('touch: the force is shown in N', near(await number(page, '#force'), Math.hypot(...wiping.force), 0.006), await text(page, '#force-box'));
  check('touch: the step of the plan is marked', (await current()) === 'wipe' && (await page.$$eval('#plan .over', (all) => all.length)) === wipes, await current());
  check('touch: the position shown is that of the world inside', (await position(page)).every((v, i) => near(v, wiping.place[i], 6e-5)), await position(page));
  const drawn = await page.evaluate(() => {
    const { robot, source } = window.ccaPage;
    const place = (o) => [o.position.x, o.position.y, o.position.z];
    const sphere = robot.bodies.at(-2), table = robot.bodies.at(-1);
    const up = sphere.position.clone().set(0, 0, 1).applyQuaternion(table.quaternion);  // the table's normal
    return { tool: place(sphere), above: sphere.position.clone().sub(table.position).dot(up), tilt: Math.acos(up.z), radius: source.description.robot.bodies.at(-2).size[0], table: place(table), size: source.description.robot.bodies.at(-1).size, arrow: robot.forces[0].visible, from: place(robot.forces[0]), ring: place(robot.targets[0]), ringIsSeen: robot.targets[0].visible };
  });
  check('touch: the tool is drawn at the hand', near(Math.hypot(...drawn.tool.map((v, i) => v - wiping.place[i])), drawn.radius, 1e-6), drawn);
  check('touch: the table is drawn tilted, and touched by the tool', drawn.size[2] === 0.04 && drawn.tilt > 0.05 && near(drawn.above, drawn.size[2] / 2 + drawn.radius, 1e-3), drawn);
  check('touch: the force is drawn where the tool is touched', drawn.arrow && near(Math.hypot(...drawn.tool.map((v, i) => v - drawn.from[i])), drawn.radius, 1e-6), drawn);
  check('touch: a ring shows where the hand should be', drawn.ringIsSeen && Math.hypot(...drawn.ring.map((v, i) => v - wiping.place[i])) < 0.05, drawn.ring);
  await picture(page, 'touch');
  await page.select('#seconds', '20');
  await settle(page);
  const plotted = await page.evaluate(() => { const { plots, source } = window.ccaPage; const curve = plots.plots[0].series[0]; const { data } = plots.plots[0].chart; return { name: curve.name, unit: curve.unit, value: data[1].at(-1), sample: source.row(Math.round(data[0].at(-1) / source.period))[source.description.outputs[curve.output].at] }; });
  check('touch: the force that is felt is plotted', plotted.name === 'feel.force' && plotted.value === plotted.sample, plotted);
  await compare(at(wipesOn, 1), 'after the push, while it wipes on');
  await compare(at(12, 0), 'above the table again');
  await runAhead(page, 0.2);
  const rest = await shown();
  check('touch: it goes through the plan to its end', native.last_skill === 'rest' && rest.step === 13, { page: steps[rest.step], program: native.last_skill });
  const most = await page.evaluate(() => { const { source } = window.ccaPage; let n = 0; for (let k = source.first; k < source.beat; ++k) n = Math.max(n, Math.hypot(...[0, 1, 2].map((i) => source.extra(k, 3 + i)))); return n; });
  check('touch: no force is above the largest of the program', most <= native.max_force_n + 1e-3 && most > 5, { page: most, program: native.max_force_n });
  await accessible(page, 'touch');

  // Back to the wiping: the same again; then a push, the operator's stop, another force.
  const back = Math.ceil(at(wipes, 1.5)) - 2;
  const goBack = async () => {
    await page.select('#snapshots', String(back * 1000));
    await press(page, '#go-back');
    await settle(page);
  };
  await goBack();
  check('touch: goes back to an earlier snapshot', (await number(page, '#time')) === back && (await current()) === 'wipe', await message(page));
  await runAhead(page, 1);
  const undisturbed = await shown();
  await goBack();
  await runAhead(page, 1);
  check('touch: from there everything happens again, bit for bit', JSON.stringify(await shown()) === JSON.stringify(undisturbed), await shown());
  await goBack();
  await page.$eval('#robot', (e) => e.scrollIntoView({ block: 'center' }));
  const [px, py] = await page.evaluate(() => window.ccaPage.robot.pushedOnScreen());
  await page.mouse.move(px, py - 6);
  await page.mouse.down();
  await page.mouse.move(px + 60, py - 6, { steps: 4 });
  const pull = await page.evaluate(() => window.ccaPage.robot.push?.toArray());
  await page.evaluate(() => { for (let i = 0; i < 100; ++i) window.ccaPage.source.advance(10); });
  await settle(page, 3);
  await picture(page, 'touch-push');
  const pushed = await shown();
  await page.mouse.up();
  check('touch: a pull at the hand with the mouse moves it', pull && Math.hypot(...pull) > 1 && Math.hypot(...pushed.place.map((v, i) => v - undisturbed.place[i])) > 0.002, { force: pull, pushed, undisturbed });
  await goBack();
  await runAhead(page, 1);
  check('touch: the snapshot keeps no pull that came later', JSON.stringify(await shown()) === JSON.stringify(undisturbed), await shown());

  await goBack();
  await press(page, '#buttons button');
  await settle(page);
  const isPressed = () => page.$eval('#buttons button', (e) => e.getAttribute('aria-pressed'));
  check('touch: the operator’s stop is a button', (await text(page, '#buttons button')) === 'operator\'s stop' && (await isPressed()) === 'true', await message(page));
  await runAhead(page, 2);
  const fastest = () => page.evaluate(() => { const { source } = window.ccaPage; const o = source.description.outputs.find((out) => out.path.endsWith('robot.velocities') || (out.path.startsWith('robot.') && out.path.endsWith('velocities'))) ?? source.description.outputs.find((out) => out.path.endsWith('velocities.whole')); if (!o) return source.description.outputs.map((out) => out.path).join(); return Math.max(...o.fields.map((_, i) => Math.abs(source.newest()[o.at + i]))); });
  const stopped = await fastest();
  check('touch: stopped, the arm comes to rest', stopped < 0.01, stopped);
  const stoppedAt = await shown();
  await accessible(page, 'touch, stopped');
  await picture(page, 'touch-stopped');
  await press(page, '#buttons button');
  await runAhead(page, 1.5);
  const goesOn = await shown();
  check('touch: released, it goes on', (await isPressed()) === 'false' && Math.hypot(...goesOn.place.map((v, i) => v - stoppedAt.place[i])) > 0.003, { stoppedAt, goesOn });

  await goBack();
  const refused = await parameter(page, 'leader.press', '200');
  check('touch: a refused force shows its reason', refused.invalid && /100/.test(refused.reason), refused);
  const set = await parameter(page, 'leader.press', '5');
  await runAhead(page, 1.5);
  const softer = await shown();
  check('touch: with another wanted force it presses with that', !set.invalid && near(Math.hypot(...softer.force), 5, 2), softer.force);

  // Looks.
  await page.$eval('#theme', (e) => { if (document.documentElement.dataset.theme !== 'dark') e.click(); });
  await settle(page);
  await accessible(page, 'touch, dark');
  await picture(page, 'touch-dark');
  await page.setViewport({ width: 360, height: 740, deviceScaleFactor: 1, isMobile: true, hasTouch: true });
  await settle(page, 10);
  const wide = await page.evaluate(() => ({ page: document.documentElement.scrollWidth, screen: innerWidth }));
  check('touch: 360 pixels are enough', wide.page <= 360 && wide.screen <= 360, wide);
  await accessible(page, 'touch, 360 pixels');
  await picture(page, 'touch-narrow', true);
  await page.close();
}
