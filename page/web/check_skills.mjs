// A controller with a fault, and the Combination of Skills, whole and in environments.
import { readFileSync } from 'node:fs';

export async function checkFault(tools) {
  const { options, check, open, text, number, settle, press, picture, accessible, state } = tools;
  const page = await open(options.fault);
  check('a graph without a robot has a page, too', (await page.$$eval('[data-node]', (all) => all.length)) === 5 && !(await page.$eval('section.robot', (e) => e.offsetParent)), await page.$$eval('[data-node]', (all) => all.map((e) => e.dataset.node)));
  await page.$eval('#ahead', (e) => { e.value = 3; });
  await press(page, '#run-ahead');
  await page.waitForFunction(() => document.getElementById('state').textContent === 'faulted');
  await settle(page);
  check('a fault stops the loop in its beat', (await number(page, '#beat')) === 1235, await number(page, '#beat'));
  check('nothing runs after a fault', (await page.evaluate(() => window.ccaPage.source.advance(5))) === 0, await number(page, '#beat'));
  check('the fault is named with its cause', (await text(page, '#alert')) === '⚠ fault in guard: the hip is faster than 10 rad/s', await text(page, '#alert'));
  check('the component of the fault is red', (await page.$$eval('.node.faulty', (all) => all.map((e) => e.dataset.node))).join() === 'guard', await page.$eval('.node.faulty > rect', (e) => getComputedStyle(e).stroke));
  await accessible(page, 'after a fault');
  await picture(page, 'fault');
  await press(page, '[data-change=resume]');
  await settle(page);
  check('resume goes on after a fault', (await state(page)) === 'started' && (await text(page, '#alert')) === '', await state(page));
  await page.close();
}

export async function checkSkills(tools) {
  const { options, check, near, open, runAhead, picture, accessible } = tools;
  const skills = JSON.parse(readFileSync(options['native-skills'], 'utf8')).at(-1);
  const page = await open(options.skills);
  const parts = await page.$$eval('[data-node]', (all) => all.map((e) => e.dataset.node));
  check('skills: the architecture has sequencer, CPG and DMP', ['sequencer', 'cpg', 'dmp', 'hip_reaching', 'steady', 'robot'].every((n) => parts.includes(n)), `${parts.length} parts`);
  await runAhead(page, skills.seconds);
  const end = await page.evaluate(() => {
    const { source } = window.ccaPage;
    const out = source.description.outputs.find((o) => o.path === 'sequencer.step');
    const steps = new Set();
    for (let k = source.first; k < source.beat; ++k) steps.add(source.row(k)[out.at]);
    let last = source.beat;
    while (source.row(last - 1)[out.at] === 9) --last;
    return { steps: [...steps], lastStepAt: last * source.period, fallen: source.fallen, forward: source.position()[0] };
  });
  check('skills: it goes through all steps of the plan', end.steps.includes(9) && end.steps.length >= 9, end.steps);
  check('skills: the last step begins when the program says', near(end.lastStepAt, skills.seconds - 6, 0.0015), { page: end.lastStepAt, program: skills.seconds - 6 });
  check('skills: it has not fallen, as the program', end.fallen === skills.fell && !end.fallen, end);
  await accessible(page, 'skills');
  await picture(page, 'skills');
  await page.close();
}

export async function checkDeployed(tools) {
  const { options, check, near, open, number, settle, press, runAhead, picture, accessible } = tools;
  const page = await open(options.deployed);
  const names = await page.$$eval('[data-environment]', (all) => all.map((e) => e.dataset.environment));
  check('deployed: the environments are boxes', names.join() === 'simulation,robot,mind,reflexes', names);
  const inside = await page.evaluate(() => {
    const box = (e) => e.querySelector('rect').getBBox();
    const places = {};
    for (const node of document.querySelectorAll('[data-node]')) {
      const n = box(node);
      places[node.dataset.node] = [...document.querySelectorAll('[data-environment]')].filter((e) => { const b = box(e); return n.x >= b.x && n.y >= b.y && n.x + n.width <= b.x + b.width && n.y + n.height <= b.y + b.height; }).map((e) => e.dataset.environment).join();
    }
    return places;
  });
  check('deployed: each component is in the box of its environment', inside.sequencer === 'mind' && inside.heading === 'mind' && inside.cpg === 'reflexes' && inside.limits === 'robot' && inside['robot in simulation'] === 'simulation' && inside['robot in robot'] === 'robot' && Object.values(inside).every((e) => names.includes(e)), inside);
  const labels = await page.$$eval('.wire-label tspan', (all) => all.map((e) => e.textContent));
  check('deployed: a wire between environments has its transport and delay', labels.includes('turn, memory, delayed 2') && labels.some((l) => /^safe → abduction, memory, delayed 1$|wires, memory/.test(l)), labels.filter((l) => l.includes('memory')));
  check('deployed: a wire within an environment has no transport', labels.some((l) => l.includes('phase') && !l.includes('memory')), labels.filter((l) => !l.includes('memory')).slice(0, 12));
  check('deployed: wires between environments look different', (await page.$$eval('.wire.crossing', (all) => all.length)) > 5 && (await page.$$eval('.wire:not(.crossing)', (all) => all.length)) > 5, await page.$$eval('.wire.crossing', (all) => all.length));
  await runAhead(page, 2);
  const walked = await page.evaluate(() => ({ fallen: window.ccaPage.source.fallen, x: window.ccaPage.source.position()[0], step: window.ccaPage.source.step() }));
  check('deployed: it trots', !walked.fallen && walked.x > 0.3 && walked.step === 0 && near(await number(page, '#time'), 2, 1e-9), walked);
  await accessible(page, 'deployed');
  await page.$eval('section.architecture', (e) => e.scrollIntoView());
  await picture(page, 'deployed');
  await press(page, '#open');
  await settle(page);
  const all = await page.$$eval('[data-node]', (nodes) => nodes.map((e) => e.dataset.node));
  check('deployed: the inner components are in boxes, too', all.includes('robot.simulator') && all.includes('robot.left_front_hip') && (await page.$$eval('[data-environment]', (e) => e.length)) === 4, `${all.length} components`);
  await page.close();
}
