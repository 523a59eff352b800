// A controller with a fault, and the Combination of Skills.
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
