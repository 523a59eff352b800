// What the threads of a browser and of a program have needed: seconds of work, and seconds in which they could
// have worked but the machine did something else. From Linux, so other work on the machine is told apart.
import { readFileSync, readdirSync } from 'node:fs';

function taskTimes(process, task) {
  const at = `/proc/${process}/task/${task}`;
  const [work, wait] = readFileSync(`${at}/schedstat`, 'utf8').split(' ').map((ns) => Number(ns) * 1e-9);
  return { name: readFileSync(`${at}/comm`, 'utf8').trim(), work, wait };
}

// `browser`: of puppeteer. Gives an object of `{ process, kind, isFirst, name, work, wait }`; `kind`: renderer, GPU, ..., or `program`.
export async function threadTimes(browser, program) {
  const session = await browser.target().createCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const all = {};
  for (const { type, id } of [...processInfo, { type: 'program', id: program.pid }])
    for (const task of readdirSync(`/proc/${id}/task`))
      try { all[`${id} ${task}`] = { process: id, kind: type, isFirst: String(id) === task, ...taskTimes(id, task) }; } catch (error) {
        if (!['ENOENT', 'ESRCH'].includes(error.code)) throw error;  // it has ended meanwhile
      }
  return all;
}

// Between two such times, of the threads that `which` picks.
export function between(before, after, which) {
  const sum = { work: 0, wait: 0, threads: 0 };
  for (const [key, now] of Object.entries(after)) {
    if (!which(now)) continue;
    const then = before[key] ?? { work: 0, wait: 0 };
    sum.work += now.work - then.work;
    sum.wait += now.wait - then.wait;
    ++sum.threads;
  }
  return sum;
}
