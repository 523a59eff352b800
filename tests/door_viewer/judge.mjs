// Looks at a door with the protocol's own client, from npm: connects, reads, tunes, calls, is refused.
// use: node judge.mjs FOLDER of node_modules PORT TOKEN ONCE
import { createRequire } from 'node:module';
const [folder, port, token, once] = process.argv.slice(2);
const require = createRequire(`${folder}/package.json`);
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const { WebSocket } = require('ws');

const problems = [];
const expect = (holds, what) => { if (!holds) problems.push(what); };
const pause = (ms) => new Promise((done) => setTimeout(done, ms));
async function until(holds, what, ms = 5000) {
  for (const end = Date.now() + ms; Date.now() < end; await pause(5)) if (holds()) return true;
  problems.push(`not within ${ms} ms: ${what}`);
  return false;
}
const connect = (protocols, headers = {}, target = '/') => new WebSocket(`ws://127.0.0.1:${port}${target}`, protocols, { headers });
const answer = (protocols, headers) => new Promise((done) => {
  const w = connect(protocols, headers);
  w.on('unexpected-response', (_, r) => { done(r.statusCode); w.terminate(); });
  w.on('open', () => { done(w.protocol); w.close(); });
  w.on('error', () => done('error'));
});

class viewer {
  constructor(protocols = [FoxgloveClient.SUPPORTED_SUBPROTOCOL], target = '/') {
    this.ws = connect(protocols, {}, target);
    this.client = new FoxgloveClient({ ws: this.ws });
    this.seen = { status: [], error: [], parameterValues: [], serviceCallResponse: [], serviceCallFailure: [], connectionGraphUpdate: [], message: [], time: [], serverInfo: [], close: [] };
    for (const name of Object.keys(this.seen)) this.client.on(name, (event) => this.seen[name].push(event));
    this.client.on('advertise', (all) => { this.channels = [...(this.channels ?? []), ...all]; });
    this.client.on('advertiseServices', (all) => { this.services = all; });
    this.calls = 0;
  }
  topic(name) { return this.channels?.find((one) => one.topic === name); }
  async call(name, given = {}) {
    const callId = ++this.calls;
    const serviceId = this.services.find((one) => one.name === name).id;
    this.client.sendServiceCallRequest({ serviceId, callId, encoding: 'json', data: new TextEncoder().encode(JSON.stringify(given)) });
    const of = () => this.seen.serviceCallResponse.find((one) => one.callId === callId);
    if (!await until(of, `an answer of ${name}`)) return {};
    return JSON.parse(new TextDecoder().decode(of().data));
  }
}

expect(await answer(['foxglove.websocket.v1']) === 'foxglove.websocket.v1', 'foxglove.websocket.v1');
expect(await answer(['foxglove.sdk.v1']) === 'foxglove.sdk.v1', 'foxglove.sdk.v1');
expect(await answer(['chat']) === 400, 'another sub-protocol is refused');
expect(await answer(['foxglove.sdk.v1'], { Origin: 'https://evil.example' }) === 403, 'another origin is refused');
expect(await answer(['foxglove.sdk.v1'], { Origin: `http://localhost:${port}` }) === 'foxglove.sdk.v1', 'the own origin');
expect(await answer(['foxglove.sdk.v1'], { Host: 'evil.example' }) === 403, 'another host is refused');

// It reads without a token, and changes nothing.
const reader = new viewer();
await until(() => reader.topic('/joint1') && reader.services, 'channels and services');
expect(reader.seen.serverInfo[0]?.capabilities.length === 6, 'capabilities');
const joint = reader.topic('/joint1');
expect(joint.encoding === 'cdr' && joint.schemaEncoding === 'ros2msg' && joint.schema.includes('float64[7]'), `channel ${JSON.stringify(joint)}`);
const subscription = reader.client.subscribe(joint.id);
const status = reader.client.subscribe(reader.topic('/cca/status').id);
const of = (id) => reader.seen.message.filter((one) => one.subscriptionId === id);
await until(() => of(subscription).length > 500 && of(status).length > 5, 'samples');
const beats = of(subscription).map((one) => Number(one.data.getBigUint64(4, true)));
expect(beats.every((beat, i) => i === 0 || beat === beats[i - 1] + 1), 'no sample is missing');
expect(of(subscription).every((one) => one.timestamp > 0n), 'their time');
expect(JSON.parse(new TextDecoder().decode(of(status)[0].data)).state === 'running', 'the status');
await until(() => reader.seen.time.length > 5, 'the time');
reader.client.subscribeConnectionGraph();
await until(() => reader.seen.connectionGraphUpdate.length === 1, 'the graph');
expect(!(await reader.call('/cca/pause')).success, 'a pause without the token is refused');
reader.client.setParameters([{ name: 'gait.frequency', value: 2 }], 'no');
await until(() => reader.seen.status.some((one) => one.message.includes('needs the token')), 'a change without the token is refused');

// With it, it commands.
const tuner = new viewer([FoxgloveClient.SUPPORTED_SUBPROTOCOL, `cca.token.${token}`]);
await until(() => tuner.services, 'services');
expect((await tuner.call('/cca/take_command')).success, 'the right to command');
tuner.client.subscribeParameterUpdates([]);
tuner.client.setParameters([{ name: 'gait.frequency', value: 2.5 }], 'set');
await until(() => tuner.seen.parameterValues.some((one) => one.id === 'set' && one.parameters[0].value === 2.5), 'the value that was set');
tuner.client.setParameters([{ name: 'gait.frequency', value: 99 }], 'wrong');
await until(() => tuner.seen.parameterValues.some((one) => one.id === 'wrong' && one.parameters[0].value === 2.5), 'the old value with a refusal');
expect(tuner.seen.status.some((one) => one.level === 2 && one.message.includes('from 0.1 to 5 Hz')), 'the reason of the refusal');
expect((await tuner.call('/cca/undo')).success, 'undo');
expect((await tuner.call('/cca/command/push', { force: 20 })).success, 'a command');
expect((await tuner.call('/cca/command/push', { force: 200 })).message?.includes('from -50 to 50 N'), 'a command that is too strong');
tuner.client.getParameters([], 'all');
await until(() => tuner.seen.parameterValues.some((one) => one.id === 'all' && one.parameters.length === 5 && one.parameters[0].value === 1.5), 'the value after undo');

// A URL is valid once.
const guest = new viewer(undefined, `/?once=${once}`);
await until(() => guest.services, 'services');
expect(!(await guest.call('/cca/pause')).success, 'somebody commands already');
tuner.client.close();
await pause(100);
expect((await guest.call('/cca/take_command')).success, 'the right to command, once it is free');
expect((await guest.call('/cca/pause')).success, 'a pause');
const late = new viewer(undefined, `/?once=${once}`);
await until(() => late.seen.status.some((one) => one.message.includes('valid once')), 'the URL is not valid again');

for (const one of [reader, tuner, guest, late]) {
  const own = ['cca.rights', 'cca.description'];
  const errors = one.seen.error.filter((e) => !own.some((op) => String(e.message).includes(op)));
  expect(errors.length === 0, `errors of the client: ${errors.map((e) => e.message)}`);
}
console.log(problems.length ? problems.join('\n') : `the protocol's own client: ${beats.length} samples, ${reader.services.length} services, all is as it should be`);
process.exit(problems.length ? 1 : 0);
