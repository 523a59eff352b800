// How large a program of a page is, and how many times faster than real time it runs here.
//   node speed.mjs PROGRAM.wasm SECONDS [FILE ...]     it can read the files; a second of it is the median's sample
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';
import { startProgram } from './src/live.js';

const [program, seconds, ...names] = process.argv.slice(2);
const code = readFileSync(program), packed = gzipSync(code, { level: 9 });
const files = Object.fromEntries(names.map((name) => [basename(name), readFileSync(name).toString('base64')]));
const live = await startProgram(packed.toString('base64'), files);
live.change('load');
live.change('start');
const beats = Math.round(1 / live.period), took = [];
for (let second = 0; second < Number(seconds); ++second) {
  const begin = performance.now();
  if (live.advance(beats) !== beats) throw new Error(`it stopped: ${live.status.state}, ${live.status.fault}`);
  took.push(performance.now() - begin);
}
took.sort((a, b) => a - b);
console.log(`${basename(program)}: ${code.length} bytes, packed ${packed.length}; ${(1000 / took[took.length >> 1]).toFixed(1)} times real time`);
