// Recordings on a page.
import { writeFileSync } from 'node:fs';

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
  writeFileSync(`${options.pictures}/broken.mcap`, 'no recording at all');
  await (await page.$('#file')).uploadFile(`${options.pictures}/broken.mcap`);
  await page.waitForFunction(() => document.getElementById('message').textContent.startsWith('broken.mcap'));
  check('what is no recording is refused', (await message(page)).includes('this is no recording'), await message(page));
  await page.close();
}
