// Runs a WebAssembly program with a file as its standard input: node run_wasi.mjs PROGRAM INPUT
import { openSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const wasi = new WASI({ version: 'preview1', args: [], env: {}, preopens: { '.': '.' }, stdin: openSync(process.argv[3]) });
let instance;
const refuse = (at, size) => {
  throw new Error(Buffer.from(instance.exports.memory.buffer, at, size).toString());
};
const program = await WebAssembly.compile(await readFile(process.argv[2]));
instance = await WebAssembly.instantiate(program, { ...wasi.getImportObject(), page: { refuse } });
process.exitCode = wasi.start(instance);
