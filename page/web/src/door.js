// A running program as a source of data: what its door tells, and what one may ask of it. The protocol is that of
// Foxglove's WebSocket, with what cca adds to it (docs/door.md).
import { described, difference } from './architecture_text.js';
import { DescribedRobot } from './described_robot.js';
import { planStep } from './live.js';
import { RecordedOncilla } from './recorded_oncilla.js';
import { Ring } from './ring.js';

const keptSeconds = 30, keptPerSecond = 200;  // of a port; all samples of one that is plotted
const shownWithin = 500;                      // ms; samples older than that don't say what time it is
const factors = { rad: { deg: Math.PI / 180, turn: 2 * Math.PI }, 'rad/s': { 'deg/s': Math.PI / 180, rpm: Math.PI / 30 }, m: { cm: 1e-2, mm: 1e-3 },
  'm/s': { 'mm/s': 1e-3, 'km/h': 1 / 3.6 }, s: { ms: 1e-3, us: 1e-6, min: 60 }, Hz: { kHz: 1e3 }, N: { kN: 1e3 }, 'N m': { Nm: 1, 'mN m': 1e-3 }, kg: { g: 1e-3 } };
const unitsOf = (unit) => (unit ? [{ text: unit, factor: 1 }, ...Object.entries(factors[unit] ?? {}).map(([text, factor]) => ({ text, factor }))] : []);

export class Door {
  // `on`: changed (another program, or its robot is known now), rights, parameters, line (of the log), connection
  constructor(worker, known, on) {
    Object.assign(this, { worker, known, on, isDoor: true, isLive: false, isConnected: false, isDescribed: false });
    this.rights = { mayChange: false, commands: false, commandedBy: null };
    this.status = { state: '', beat: 0, fault: '', faultPath: '', snapshots: [] };
    this.door = {};
    this.waiting = new Map();
    this.calls = 0;
    this.wait = 250;
    this.tries = 0;
    this.first = 0;
    worker.onmessage = ({ data }) => this.hear(data);
  }

  // ---- the connection ----

  connect(url, token) {
    Object.assign(this, { url: url ?? this.url, token: token ?? this.token });
    clearTimeout(this.again);
    this.forgetConnection();
    this.worker.postMessage({ do: 'connect', url: this.url, protocols: ['foxglove.websocket.v1', 'foxglove.sdk.v1', 'cca.batches.v1', ...(this.token ? [`cca.token.${this.token}`] : [])] });
  }
  forgetConnection() {
    Object.assign(this, { channelList: new Map(), services: new Map(), isDescribed: false, needsToken: false });
    for (const { refuse } of this.waiting.values()) refuse(new Error('the connection is lost'));
    this.waiting.clear();
    if (this.setting) {
      this.setting.why = 'the connection is lost';
      this.setting.done();
    }
  }
  showToken(token) {
    this.token = token;
    this.send({ op: 'cca.token', token });
  }
  send(message) { this.worker.postMessage({ do: 'send', message: JSON.stringify(message) }); }

  hear({ opened, closed, samples, texts, status, raw, time }) {
    if (opened) {
      Object.assign(this, { isConnected: true, wait: 250, connections: (this.connections ?? 0) + 1, heardAt: performance.now() });
      this.url = this.url.replace(/\?once=.*/, '');  // it was valid once
      this.send({ op: 'cca.describe' });
      this.send({ op: 'subscribeParameterUpdates', parameterNames: [] });
      this.on.connection();
    } else if (closed) this.lost(closed);
    else {
      this.heardAt = performance.now();
      for (const text of texts) this.message(JSON.parse(text));
      for (const [id, bytes] of raw) this.take(id, bytes);
      if (status !== null) this.takeStatus(JSON.parse(status));
      this.takeSamples(samples);
      this.clock = time;
    }
  }
  lost({ code, reason }) {
    if (this.isConnected) Object.assign(this, { lostAt: performance.now(), why: reason || (code === 1006 ? '' : `code ${code}`) });
    this.isConnected = false;
    this.rights = { mayChange: false, commands: false, commandedBy: null };
    this.forgetConnection();
    this.on.connection();
    this.on.rights();
    // The page may come from elsewhere than a door.
    if (!this.connections && ++this.tries > 8) return this.on.nobody();
    this.again = setTimeout(() => this.connect(), this.wait);
    this.wait = Math.min(2000, 2 * this.wait);
  }

  message(m) {
    const does = {
      serverInfo: () => { this.session = m.sessionId; },
      advertise: () => {
        for (const c of m.channels) this.channelList.set(c.id, { ...c, metadata: new Map(Object.entries(c.metadata ?? {})), messages: [] });
        this.begin();
      },
      unadvertise: () => {
        for (const id of m.channelIds) {
          this.channelList.delete(id);
          this.subscribed?.delete(id);
        }
      },
      advertiseServices: () => { for (const { name, id } of m.services) this.services.set(name, id); },
      parameterValues: () => this.takeParameters(m),
      'cca.description': () => { this.program = m; this.begin(); },
      'cca.rights': () => { this.rights = m; this.on.rights(); },
      answer: () => {
        const call = this.waiting.get(m.call);
        this.waiting.delete(m.call);
        const answer = JSON.parse(m.answer), { success, message } = answer;
        if (success) call?.done(answer);
        else call?.refuse(new Error(message));
      },
      serviceCallFailure: () => {
        this.waiting.get(m.callId)?.refuse(new Error(m.message));
        this.waiting.delete(m.callId);
      },
      log: () => this.on.line(m.line),
      status: () => {
        if (this.setting && m.message.startsWith('setParameters: ')) this.setting.why = m.message.slice(15);
        else if (/this door needs|needs the token, too/.test(m.message)) this.needsToken = true;
        this.on.told(m);
      },
    };
    does[m.op]?.();
  }

  // Both the channels and the description are there.
  begin() {
    if (!this.program || this.channelList.size === 0) return;
    const { architecture: text, program: name } = this.program;
    const architecture = this.program.metadata?.['cca.architecture'] ?? { name, text, ns_a_beat: /^(\d+) ns a beat/.exec(text)?.[1] };
    if (!architecture.ns_a_beat) return;
    const channels = new Map([...this.channelList.values()].map((c) => [c.topic, c]));
    const same = this.isSame(architecture.text);
    if (!same) {
      this.text = architecture.text;
      this.channels = channels;
      this.description = described(architecture, channels, new Map(Object.entries(this.program.metadata?.['cca.places'] ?? {})));
      this.description.name = this.program.program || this.description.name;
      this.description.parameters = this.program.parameters.map(parameterOf);
      this.period = this.description.period * 1e-9;
      this.memory = new Float64Array(this.description.coordinates);
      const known = this.known.find((one) => difference(this.description, one) === '');
      Object.assign(this.description, { plan: known?.plan, plots: known?.plots });
      this.oncilla = (known ?? this.known.find((one) => one.robot?.kind === 'oncilla'))?.robot;
      this.robot = null;
      delete this.description.robot;
    }
    const { outputs } = this.description;
    this.channels = channels;
    this.byId = new Map();
    outputs.forEach((output, o) => {
      output.channel = channels.get(`/${output.path.replaceAll('.', '/')}`);
      output.ring = new Ring(2 + output.fields.length, Math.ceil(keptSeconds * Math.min(1 / this.period, 1500)));
      if (output.channel) this.byId.set(output.channel.id, o);
    });
    this.sampleBeat = 0;
    this.sampledAt = 0;
    const wanted = ['/robot_description', '/tf', '/cca/status', '/cca/log'].map((topic) => channels.get(topic)).filter(Boolean);
    this.worker.postMessage({ do: 'ports', list: [...this.byId].map(([id, o]) => [id, outputs[o].fields.length]), between: Math.max(1, Math.round(1 / (keptPerSecond * this.period))),
      status: channels.get('/cca/status')?.id ?? -1, log: channels.get('/cca/log')?.id ?? -1 });
    this.contacts = this.port('contacts', 4);
    if (!this.isDescribed) {
      this.isDescribed = true;
      this.subscribed = new Set();
    }
    this.candidate = RecordedOncilla.in(this, this.oncilla);
    this.subscribe(wanted.map((c) => c.id));
    this.follow(this.drawn, this.plotted);
    this.values = this.program.parameters.map((p) => p.value);
    if (!same) this.on.changed();
    this.on.parameters();
  }
  isSame(text) {
    return this.text === text && this.description && this.program.program === this.shownProgram
      || (this.shownProgram = this.program.program, false);
  }
  subscribe(ids) {
    const more = ids.filter((id) => !this.subscribed.has(id));
    for (const id of more) this.subscribed.add(id);
    if (more.length > 0) this.send({ op: 'subscribe', subscriptions: more.map((id) => ({ id, channelId: id })) });
  }
  // The program sends only what is shown: the outputs that are drawn with their values, and what the robot is
  // drawn from. Of those that are plotted all samples are kept.
  follow(drawn = [], plotted = []) {
    Object.assign(this, { drawn, plotted });
    if (!this.isDescribed) return;
    const idOf = (o) => this.description.outputs[o]?.channel?.id;
    const plan = this.description.outputs.findIndex((o) => o.path === this.description.plan?.port);
    const all = new Set([...plotted, this.contacts].map(idOf).filter((id) => id !== undefined));
    const ids = new Set([...drawn, plan, ...Object.values(this.candidate?.ports ?? {})].map(idOf).filter((id) => id !== undefined));
    for (const id of all) ids.add(id);
    const key = `${this.connections} ${[...ids]} ${[...all]}`;
    if (key === this.followed) return;
    this.followed = key;
    this.subscribe([...ids]);
    const less = [...this.subscribed].filter((id) => this.byId.has(id) && !ids.has(id));
    for (const id of less) this.subscribed.delete(id);
    if (less.length > 0) this.send({ op: 'unsubscribe', subscriptionIds: less });
    this.worker.postMessage({ do: 'full', ids: [...all] });
  }

  // ---- what comes ----

  take(id, bytes) {
    const channel = this.channelList.get(id);
    if (!channel) return;
    channel.messages = [new Uint8Array(bytes)];
    if (channel.topic === '/robot_description' || channel.topic === '/tf') this.findRobot();
  }
  takeSamples(samples) {
    if (!this.isDescribed) return;
    const { outputs } = this.description;
    for (let at = 0; at < samples.length;) {
      const output = outputs[this.byId.get(samples[at])];
      if (!output) return;  // of channels that were there before
      const { ring } = output;
      if (ring.size > 0 && samples[at + 1] < ring.number(ring.size - 1, 0)) ring.clear();
      ring.push(samples, at + 1);
      this.sampleBeat = Math.max(this.sampleBeat, samples[at + 1] + 1);
      at += 3 + output.fields.length;
    }
    if (samples.length > 0) this.sampledAt = performance.now();
    if (!this.robot) this.findRobot();
  }
  takeStatus(s) {
    if (s.beat + 1 / this.period < this.sampleBeat) this.sampleBeat = 0;  // it has begun anew
    this.door = s;
    this.status = { state: s.state, beat: s.beat, fault: s.fault, faultPath: s.fault_path, snapshots: [] };
    if (s.fault) this.status.state = 'faulted';
    this.on.status();
  }
  // An Oncilla is drawn as on a live page, any other robot as it is described (cca::shows).
  findRobot() {
    if (this.robot || !this.isDescribed) return;
    const oncilla = this.candidate;
    if (oncilla && [oncilla.ports.angles, oncilla.ports.orientation].some((o) => this.description.outputs[o].ring.size === 0)) return;
    this.robot = oncilla ?? DescribedRobot.in(this);
    if (!this.robot) return;
    this.description.robot = this.robot.shown;
    this.robot.pose(this);
    this.on.changed();
  }
  port(ending, size) {
    return this.description.outputs.findIndex((o) => o.path.endsWith(`.${ending}`) && (!size || o.fields.length === size));
  }

  // ---- as of a live controller ----

  get beat() { return performance.now() - this.sampledAt < shownWithin || !this.isConnected ? this.sampleBeat : Math.max(this.sampleBeat, this.status.beat); }
  get time() { return this.beat * this.period; }
  get runs() { return this.isConnected; }
  index(channel) { return channel.messages.length - 1; }  // of a viewer's message
  sample(output, beat = Infinity) {
    const { ring } = this.description.outputs[output];
    const i = beat === Infinity ? ring.size - 1 : ring.before(beat);
    return i < 0 ? null : [...ring.row(i).subarray(2)];
  }
  newest() {
    for (const { ring, at } of this.description.outputs) if (ring.size > 0) this.memory.set(ring.row(ring.size - 1).subarray(2), at);
    return this.memory;
  }
  publishedIn(output) {
    const { ring } = this.description.outputs[output];
    return ring.size > 0 ? ring.number(ring.size - 1, 0) : -1;
  }
  originOf(output) {
    const { ring } = this.description.outputs[output];
    return ring.size > 0 ? ring.number(ring.size - 1, 1) * 1e-9 : -1;
  }
  series(output, coordinate, from, to, most) {
    const { ring } = this.description.outputs[output];
    const first = Math.max(0, ring.before(from / this.period)), last = ring.before(to / this.period + 1);
    const stride = Math.max(1, Math.ceil((last - first) / most));
    const times = [], values = [];
    if (ring.size === 0) return [times, values];
    const add = (i) => { times.push(ring.number(i, 0) * this.period); values.push(ring.number(i, 2 + coordinate)); };
    // Always the same ones, and the newest: else a plot that moves would flicker.
    for (let i = first; i <= last; ++i) if (stride === 1 || Math.round(ring.number(i, 0)) % stride === 0) add(i);
    if (times.at(-1) !== ring.number(last, 0) * this.period && last >= 0) add(last);
    return [times, values];
  }
  get hasContacts() { return this.contacts >= 0 && this.description.robot?.points.length === 4; }
  contact(leg, beat) {
    const { ring } = this.description.outputs[this.contacts];
    const i = ring.before(beat + 1);
    return i >= 0 && ring.number(i, 2 + leg) > 0;
  }
  position() { return null; }
  get poses() { return this.robot.poses; }
  pose() { this.robot?.pose(this); }
  forces() { return this.robot.forces(this); }
  targets() { return this.robot.targets(this); }
  step() { return planStep(this); }
  get fallen() { return false; }

  parameters() { return this.values; }

  // ---- what one can ask ----

  // Done, with what the program says; or refused, with its reason.
  async call(name, request) { return (await this.ask(name, request)).message; }
  // The whole answer.
  ask(name, request = {}) {
    return new Promise((done, refuse) => {
      const service = this.services.get(`/cca/${name}`);
      if (!this.isConnected) return refuse(new Error('there is no connection to the program'));
      if (service === undefined) return refuse(new Error(`this program does not offer ${name}`));
      const id = ++this.calls;
      this.waiting.set(id, { done, refuse });
      const payload = new TextEncoder().encode(JSON.stringify(request)), encoding = new TextEncoder().encode('json');
      const message = new Uint8Array(13 + encoding.length + payload.length), view = new DataView(message.buffer);
      view.setUint8(0, 2);
      view.setUint32(1, service, true);
      view.setUint32(5, id, true);
      view.setUint32(9, encoding.length, true);
      message.set(encoding, 13);
      message.set(payload, 13 + encoding.length);
      this.worker.postMessage({ do: 'send', message: message.buffer });
    });
  }
  // A force in the world, N, with the command that pushes the robot, if the program has one; 0 ends it. One call
  // at a time, with the newest force.
  async push([x, y]) {
    const command = this.program.commands.find(({ name, held, arguments: all }) => name === 'push' && held && all.length === 2 && all.every((a) => a.unit === 'N'));
    if (!command || !this.rights.commands) return;
    this.wanted = [x, y];
    if (this.isPushing) return;
    this.isPushing = true;
    try {
      while (this.wanted) {
        const [now, isOver] = [this.wanted, this.wanted.every((f) => f === 0)];
        this.wanted = null;
        if (isOver) await this.call('release/push');
        else await this.call('command/push', Object.fromEntries(command.arguments.map(({ name, lower, upper }, i) => [name, Math.min(upper, Math.max(lower, now[i]))])));
      }
    } catch (error) {
      this.on.refused(error.message);
    } finally {
      this.isPushing = false;
    }
  }
  // One at a time, so that a refusal is of this one.
  async set(path, value) {
    while (this.setting) await this.setting.end;
    if (!this.isConnected) throw new Error('there is no connection to the program');
    const setting = { id: `set-${++this.calls}`, why: '' };
    setting.end = new Promise((done) => { setting.done = done; });
    this.setting = setting;
    this.send({ op: 'setParameters', id: setting.id, parameters: [{ name: path, value }] });
    const late = setTimeout(() => { setting.why ||= 'the program does not answer'; setting.done(); }, 6000);
    await setting.end;
    clearTimeout(late);
    if (this.setting === setting) this.setting = null;
    if (setting.why) throw new Error(setting.why);
  }
  takeParameters({ parameters, id }) {
    if (this.isDescribed) {
      for (const { name, value } of parameters) {
        const i = this.description.parameters.findIndex((p) => p.path === name);
        if (i >= 0) this.values[i] = value;
      }
      this.on.parameters(parameters.map((p) => p.name));
    }
    if (id && this.setting?.id === id) this.setting.done();
  }
}

function parameterOf({ path, kind, unit, lower, upper, choices }) {
  return { path, kind: choices.length > 0 ? 'choice' : kind, names: choices, unit, lower, upper, units: unitsOf(unit) };
}
