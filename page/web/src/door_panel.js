// What one sees and does of a running program: the connection, the right to command, STOP, modes, parts, commands.
import { inputTest } from './input_test.js';

const $ = (id) => document.getElementById(id);
const make = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};
const milliseconds = (seconds) => (seconds > 0 ? `${(seconds * 1e3).toPrecision(3)} ms` : '—');
const silentAfter = 1500;  // ms; the status comes ten times a second
const linesKept = 200;

export class DoorPanel {
  // `say(text, isRefused)`: what the page tells below the controls.
  constructor(door, say) {
    Object.assign(this, { door, say, offered: '' });
    this.listen();
    this.rights();
    this.connection();
  }

  // Asks, and shows what is refused with its reason.
  async ask(what, name, request) {
    try {
      const answer = await this.door.call(name, request);
      this.say(answer || what);
    } catch (error) {
      this.say(`refused: ${error.message}`, true);
    }
  }

  listen() {
    const { door } = this;
    $('access').addEventListener('submit', (event) => {
      event.preventDefault();
      const token = $('token').value.trim();
      if (!token) return this.say('enter the token that the program has printed at its start', true);
      $('token').value = '';
      this.offeredToken = token;
      if (door.isConnected) door.showToken(token);
      else door.connect(undefined, token);
    });
    $('command').addEventListener('click', () => (door.rights.commands ? this.ask('the command is given back', 'give_command') : this.ask('this page commands', 'take_command')));
    $('emergency').addEventListener('click', () => this.stop());
    document.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || event.repeat) return;
      event.preventDefault();
      this.stop();
    }, true);
    $('door-play').addEventListener('click', () => this.playOrPause());
    $('door-step').addEventListener('click', () => this.step());
    $('door-speed').addEventListener('change', () => this.ask(`speed ${$('door-speed').selectedOptions[0].textContent}`, 'speed', { factor: Number($('door-speed').value) }).then(() => this.status()));
    $('door-resume').addEventListener('click', () => this.ask('goes on after the fault', 'resume'));
    $('door-start').addEventListener('click', () => this.ask('it is started', 'start'));
    $('record').addEventListener('click', () => {
      const { recording } = door.door;
      if (recording) this.ask(`recorded: ${recording}`, 'end_recording');
      else this.ask(`records into ${$('record-file').value}`, 'record', { file: $('record-file').value.trim() });
    });
    $('undo').addEventListener('click', () => this.ask('the last change is undone', 'undo'));
    for (const does of ['save', 'load']) $(`${does}-parameters`).addEventListener('click', () => this.ask(`${does}: done`, does, { file: $('parameter-file').value.trim() }));
    for (const event of ['blur', 'pagehide']) addEventListener(event, () => this.releaseAll?.());
  }
  // Without the right to command, but with the token.
  stop() {
    if (!this.door.isConnected) return this.say('STOP can\'t reach the program: there is no connection. Use the stop of the robot', true);
    if (!this.door.rights.mayChange) {
      $('token').focus();
      return this.say('STOP needs the token that the program has printed at its start', true);
    }
    this.isStopped = true;
    this.ask('stopped', 'stop');
  }
  playOrPause() {
    if (this.door.door.is_paused) this.ask('goes on', 'go_on');
    else this.ask('paused', 'pause');
  }
  step() { this.ask('', 'step', { beats: Number($('door-beats').value) }); }

  // ---- what is shown ----

  connection() {
    const { door } = this;
    if (door.isConnected) this.isStopped = false;
    document.body.classList.toggle('stale', !door.isConnected);
    this.refresh();
    this.rights();
  }
  // Each frame that draws texts.
  refresh() {
    const { door } = this;
    const quiet = door.isConnected && performance.now() - door.heardAt;
    const isSilent = quiet > silentAfter;
    const ago = (since) => `${((performance.now() - since) / 1e3).toFixed(0)} s`;
    const text = isSilent ? `connected, but nothing has come for ${ago(door.heardAt)}`
      : door.isConnected ? `connected to ${door.description?.name ?? 'the program'} at ${location.host}`
        : door.lostAt ? `not connected for ${ago(door.lostAt)}, tries again` : `no program answers at ${location.host} yet, tries again`;
    if ($('link').textContent !== text) $('link').textContent = text;
    $('link').classList.toggle('connected', door.isConnected && !isSilent);
    $('link').classList.toggle('silent', isSilent);
    document.body.classList.toggle('stale', !door.isConnected || isSilent);
  }
  // Of what the page shows nothing is new; empty: it is.
  get complaint() {
    if (this.door.isConnected) return '';
    const why = this.isStopped ? ': the run was stopped here' : this.door.why ? `: ${this.door.why}` : '';
    return `⚠ no connection${why}. What you see is the last that came; the page connects again when the program is there`;
  }
  rights() {
    const { rights, isConnected } = this.door;
    $('token-box').hidden = !isConnected || rights.mayChange;
    $('command').hidden = !rights.mayChange;
    $('command').textContent = rights.commands ? 'give the command back' : 'take the command';
    $('command').classList.toggle('primary', !rights.commands);
    $('commander').textContent = !isConnected ? ''
      : rights.commands ? 'this page commands'
        : rights.commandedBy ? `${rights.commandedBy} commands`
          : rights.mayChange ? 'nobody commands: take the command to change anything' : 'you can look; to change anything it needs the token that the program has printed';
    $('emergency').classList.toggle('needs', !isConnected || !rights.mayChange);
    if (rights.mayChange && this.offeredToken) this.keepToken?.(this.offeredToken);
    this.enable();
  }
  enable() {
    const may = this.door.isConnected && this.door.rights.commands;
    if (!may) this.releaseAll?.();
    for (const one of document.querySelectorAll('.changes')) one.disabled = !may;
    for (const one of $('parameters').querySelectorAll('input, select')) one.disabled = !may;
  }
  status() {
    const { is_paused: isPaused, speed, mode, causes = [], stopped_parts: stopped, recording, recording_problem: problem, environments, state } = this.door.door;
    const set = (id, text) => { if ($(id).textContent !== text) $(id).textContent = text; };
    set('door-play', isPaused ? '▶ Go on' : '❚❚ Pause');
    const rests = state === 'loaded', isFaulted = state === 'faulted';
    $('door-resume').hidden = !isFaulted;
    $('door-start').hidden = !(isFaulted || rests || isPaused);
    set('door-start', rests ? 'start' : 'start anew');
    $('door-play').hidden = $('door-step').parentElement.hidden = isFaulted || rests;
    this.causes = causes;
    if (document.activeElement !== $('door-speed')) {
      const text = String(speed);
      if (![...$('door-speed').options].some((o) => o.value === text)) $('door-speed').append(new Option(text, text));
      $('door-speed').value = text;
    }
    set('record', recording ? `■ end ${recording}${problem ? ', which is incomplete' : ''}` : '● record');
    $('record').title = problem ?? '';
    $('record').setAttribute('aria-pressed', String(Boolean(recording)));
    for (const button of $('modes').querySelectorAll('button')) button.setAttribute('aria-pressed', String(button.value === mode));
    for (const button of $('parts').querySelectorAll('button')) {
      const isStopped = stopped.includes(button.value), text = `${isStopped ? '▶ start' : '■ stop'} ${button.value}`;
      if (button.textContent !== text) button.textContent = text;
      button.isStopped = isStopped;
    }
    $('timing').tBodies[0].replaceChildren(...environments.map((e) => make('tr', {}, ...[e.name, e.beats, e.overruns, e.late, milliseconds(e.beat_p99), milliseconds(e.wake_up_p99)].map((text) => make('td', { textContent: text })))));
  }

  // The log comes again with each connection.
  line({ time, client, what }) {
    const key = `${time} ${client} ${what}`;
    if ((this.seen ??= new Set()).has(key)) return;
    this.seen.add(key);
    const at = new Date(1e3 * time);
    $('log').prepend(make('li', {}, make('time', { textContent: at.toLocaleTimeString('en-GB'), dateTime: at.toISOString() }), make('span', { className: 'who', textContent: client }),
      make('span', { className: what.startsWith('refused') ? 'what refused' : 'what', textContent: what })));
    while ($('log').children.length > linesKept) $('log').lastChild.remove();
  }

  // Modes, parts and commands of a program.
  offer() {
    const { modes, parts, commands } = this.door.program;
    const named = (name, list) => (list.length > 0 ? [make('span', { className: 'group-name', textContent: name }), ...list] : []);
    const button = (properties, does) => {
      const one = make('button', { type: 'button', ...properties });
      one.classList.add('changes');
      one.addEventListener('click', () => does(one));
      return one;
    };
    $('modes').replaceChildren(...named('mode', modes.map((mode) => button({ textContent: mode, value: mode }, () => this.ask(`mode ${mode}`, 'switch_mode', { mode })))));
    $('parts').replaceChildren(...named('parts', parts.map((part) => button({ textContent: `■ stop ${part}`, value: part },
      (one) => this.ask(one.isStopped ? `${part} starts` : `${part} stops`, one.isStopped ? 'start_part' : 'stop_part', { part })))));
    this.held = new Map();
    $('commands').replaceChildren(...commands.map((command) => this.command(command)));
    $('tests').replaceChildren(...inputTest(this, this.door.program.tests ?? []));
    this.enable();
  }
  command({ name, help, held, arguments: all }) {
    const inputs = all.map(({ name: of, unit, value, lower, upper }) => {
      const input = make('input', { type: 'number', value, step: 'any', className: 'changes', ...(lower < upper ? { min: lower, max: upper, title: `${lower} to ${upper} ${unit}` } : {}) });
      input.dataset.argument = of;
      return make('label', {}, `${of} `, input, ` ${unit}`);
    });
    const values = () => Object.fromEntries(inputs.map((label) => [label.querySelector('input').dataset.argument, Number(label.querySelector('input').value)]));
    const button = make('button', { type: 'button', textContent: held ? `hold to ${name}` : name, title: help, className: held ? 'held changes' : 'changes' });
    button.dataset.command = name;
    const row = make('div', { className: 'row', role: 'group', ariaLabel: name }, ...inputs, button);
    if (!held) {
      button.addEventListener('click', () => this.ask(`${name}: done`, `command/${name}`, values()));
      return row;
    }
    const begin = () => {
      if (this.held.has(name) || button.disabled) return;
      this.held.set(name, button);
      button.setAttribute('aria-pressed', 'true');
      this.ask(`${name}: held`, `command/${name}`, values());
    };
    button.setAttribute('aria-pressed', 'false');
    button.addEventListener('pointerdown', (event) => { if (event.button === 0) { button.setPointerCapture(event.pointerId); begin(); } });
    for (const event of ['pointerup', 'pointercancel', 'lostpointercapture', 'blur']) button.addEventListener(event, () => this.release(name));
    button.addEventListener('keydown', (event) => { if (event.key === ' ' || event.key === 'Enter') { event.preventDefault(); if (!event.repeat) begin(); } });
    button.addEventListener('keyup', (event) => { if (event.key === ' ' || event.key === 'Enter') { event.preventDefault(); this.release(name); } });
    button.addEventListener('contextmenu', (event) => event.preventDefault());  // of a long touch
    return row;
  }
  release(name) {
    const button = this.held?.get(name);
    if (!button) return;
    this.held.delete(name);
    button.setAttribute('aria-pressed', 'false');
    if (this.door.isConnected && this.door.rights.commands) this.ask(`${name}: released`, `release/${name}`);
  }
  releaseAll() { for (const name of [...(this.held?.keys() ?? [])]) this.release(name); }
}
