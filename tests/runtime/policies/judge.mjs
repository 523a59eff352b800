// The actions of onnxruntime for the networks of the tests, for 1,000 steps each, with their memory.
//
// usage: node judge.mjs FOLDER-OF-NETWORKS FOLDER-OF-ANSWERS [EACH]
//   EACH   writes each such step (25); 1 for a judgement of all of them
//
// By hand: npm install --ignore-scripts onnxruntime-node, in a folder from which this program runs; then
//   node judge.mjs networks /tmp/answers 1 && CCA_POLICY_ANSWERS=/tmp/answers cca_test_policies
// The answers beside the networks were written by it.
import { createRequire } from 'node:module';
import { readdirSync, writeFileSync } from 'node:fs';
const ort = createRequire(process.cwd() + '/')('onnxruntime-node');

const [networks, answers, each = '25'] = process.argv.slice(2);
const steps = 1000;

for (const file of readdirSync(networks).filter((f) => f.endsWith('.onnx'))) {
  const session = await ort.InferenceSession.create(`${networks}/${file}`, { intraOpNumThreads: 1 });
  // As in networks.cpp: observations between -2 and 2 from the upper bits of a generator of 32 bits.
  let bits = 1;
  const draw = () => {
    bits = (Math.imul(bits, 1664525) + 1013904223) >>> 0;
    return Math.fround((bits >>> 8) / 4194304 - 2);
  };
  const memory = {};
  const kept = [];
  for (let k = 0; k < steps; ++k) {
    const feeds = { obs: new ort.Tensor('float32', Float32Array.from({ length: 20 }, draw), [1, 20]) };
    for (const name of session.inputNames.filter((n) => n !== 'obs')) {
      const units = 16, layers = file.includes('two_layers') ? 2 : 1;
      feeds[name] = memory[name] ?? new ort.Tensor('float32', new Float32Array(layers * units), [layers, 1, units]);
    }
    const made = await session.run(feeds);
    for (const name of session.inputNames) if (name.endsWith('_in')) memory[name] = made[name.replace('_in', '_out')];
    if (k % Number(each) === Number(each) - 1) kept.push(`${k} ` + Array.from(made.actions.data, (x) => x.toPrecision(9)).join(' '));
  }
  writeFileSync(`${answers}/${file.replace('.onnx', '.txt')}`, kept.join('\n') + '\n');
}
