// Bundles a page: one HTML file with its program, its style and all libraries.
//   node build.mjs FOLDER PROGRAM.wasm TITLE OUT.html [FILE ...]     FOLDER has node_modules; the program can read the files
// A page for recordings has no program, but it knows the robots and plans of some. They are described in a file,
// so this page needs no WebAssembly:
//   node build.mjs FOLDER --knows TITLE OUT.html KNOWN.json
//   node build.mjs FOLDER --describe KNOWN.json PROGRAM.wasm ...
import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';
import { startProgram } from './src/live.js';

const packed = (name) => gzipSync(readFileSync(name), { level: 9 }).toString('base64');
if (process.argv[3] === '--describe') {
  await describe(...process.argv.slice(4));
  process.exit(0);
}
const [here, program, title, out, ...names] = process.argv.slice(2);
const isForRecordings = program === '--knows';
const base64 = (all) => Object.fromEntries(all.map((name) => [basename(name), readFileSync(name).toString('base64')]));
const compressed = isForRecordings ? '' : packed(program);
const known = isForRecordings ? JSON.parse(readFileSync(names[0], 'utf8')) : [];
// The connection to a running program and its twin are in threads of their own, whose code is a text in the page.
const thread = async (name) => JSON.stringify((await build({ entryPoints: [`${here}/src/${name}.js`], bundle: true, minify: true, format: 'iife', target: 'es2022', write: false })).outputFiles[0].text);
const bundle = await build({
  entryPoints: [`${here}/src/main.js`],
  bundle: true, minify: true, format: 'esm', target: 'es2022', write: false,
  loader: { '.css': 'text' },
  define: { PROGRAM: JSON.stringify(isForRecordings ? '' : '@@PROGRAM@@'), FILES: JSON.stringify(isForRecordings ? {} : base64(names)), KNOWN: JSON.stringify(known), DOOR_WORKER: await thread('door_worker'), TWIN_WORKER: await thread('twin_worker') },
  legalComments: 'inline',
});
const script = bundle.outputFiles[0].text.replace('@@PROGRAM@@', () => compressed).replaceAll('</script', '<\\/script');
const page = readFileSync(`${here}/index.html`, 'utf8')
  .replaceAll('{{title}}', () => title)
  .replace('{{style}}', () => readFileSync(`${here}/style.css`, 'utf8'))
  .replace('{{script}}', () => script);
writeFileSync(out, page);
console.log(`${out}: ${Math.round(page.length / 1000)} kB, of which the program ${Math.round(compressed.length / 1000)}`);

// What a recording is compared with, and how its robot is drawn.
async function describe(to, ...programs) {
  const known = [];
  for (const name of programs) {
    const { name: called, nodes, outputs, wires, plan, plots, robot } = (await startProgram(packed(name))).description;
    known.push({ name: called, nodes: nodes.map(({ path }) => ({ path })), outputs: outputs.map(({ path, fields }) => ({ path, fields: fields.map(({ name }) => ({ name })) })),
      wires: wires.map(({ from, node, input, delay }) => ({ from, node, input, delay })), plan, plots, robot });
  }
  writeFileSync(to, `[\n${known.map((one) => JSON.stringify(one)).join(',\n')}\n]\n`);
  console.log(`${to}: ${known.map((one) => one.name).join(', ')}`);
}
