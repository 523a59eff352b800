// Bundles a page: one HTML file with its program, its style and all libraries.
//   node build.mjs FOLDER PROGRAM.wasm TITLE OUT.html [FILE ...]     FOLDER has node_modules; the program can read the files
// A page for recordings has no program, but it knows the robots and plans of some:
//   node build.mjs FOLDER --knows TITLE OUT.html PROGRAM.wasm ...
import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';
import { startProgram } from './src/live.js';

const [here, program, title, out, ...names] = process.argv.slice(2);
const isForRecordings = program === '--knows';
const packed = (name) => gzipSync(readFileSync(name), { level: 9 }).toString('base64');
const base64 = (all) => Object.fromEntries(all.map((name) => [basename(name), readFileSync(name).toString('base64')]));
const compressed = isForRecordings ? '' : packed(program);
const known = [];
for (const name of isForRecordings ? names : []) {
  const { description } = await startProgram(packed(name));
  known.push({ ...description, parameters: [] });
}
const bundle = await build({
  entryPoints: [`${here}/src/main.js`],
  bundle: true, minify: true, format: 'esm', target: 'es2022', write: false,
  loader: { '.css': 'text' },
  define: { PROGRAM: JSON.stringify(isForRecordings ? '' : '@@PROGRAM@@'), FILES: JSON.stringify(isForRecordings ? {} : base64(names)), KNOWN: JSON.stringify(known) },
  legalComments: 'inline',
});
const script = bundle.outputFiles[0].text.replace('@@PROGRAM@@', () => compressed).replaceAll('</script', '<\\/script');
const page = readFileSync(`${here}/index.html`, 'utf8')
  .replaceAll('{{title}}', () => title)
  .replace('{{style}}', () => readFileSync(`${here}/style.css`, 'utf8'))
  .replace('{{script}}', () => script);
writeFileSync(out, page);
console.log(`${out}: ${Math.round(page.length / 1000)} kB, of which the program ${Math.round(compressed.length / 1000)}`);
