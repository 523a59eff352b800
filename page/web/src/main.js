// The page: what runs, what is shown, and what the user does.
import uPlotStyle from 'uplot/dist/uPlot.min.css';
import { ArchitectureView } from './architecture.js';
import { Door } from './door.js';
import { DoorPanel } from './door_panel.js';
import { Footfalls } from './footfalls.js';
import { fromBase64, Live, startProgram } from './live.js';
import { parse, range } from './numbers.js';
import { Plots } from './plots.js';
import { readRecording } from './recording.js';
import { RobotView } from './robot.js';
import { TwinPanel } from './twin_panel.js';

const $ = (id) => document.getElementById(id);
const settings = new URLSearchParams(location.hash.slice(1));

document.head.append(Object.assign(document.createElement('style'), { textContent: uPlotStyle }));

const embedded = $('recording');  // what a program has put into the page (`--page`)

let live = null, door = null, panel = null, source = null, robot = null, architecture = null, plots = null, footfalls = null, fields = [];
let isPlaying = false, speed = 1, last = 0, due = 0, pace = 0, ahead = 0, isDark = false;

function say(text, isRefused = false) {
  $('message').textContent = text;
  $('message').classList.toggle('refused', isRefused);
}
// What the program refuses is shown, with its own reason.
function attempt(what, action) {
  try {
    action();
    if (what) say(what);
  } catch (error) {
    say(error.message, true);
  }
  show(true);
}

// ---- running ----

function play(on) {
  if (source.isDoor) return;
  isPlaying = on;
  due = 0;
  const button = $(source.isLive ? 'play' : 'replay-play');
  button.setAttribute('aria-pressed', String(on));
  button.textContent = on ? '⏸ Pause' : source.isLive ? '▶ Run' : '▶ Play';
}
function runFor(beats) {
  if (!source.isLive) return 0;
  const done = source.advance(beats);
  if (done < beats) {
    play(false);
    ahead = 0;
  }
  return done;
}
let frames = 0;
function frame(now) {
  ++frames;
  const seconds = Math.min(0.25, (now - last) / 1e3);
  last = now;
  if (door && now - toldAt > 250) {
    toldAt = now;
    panel.refresh();
  }
  if (!source) return requestAnimationFrame(frame);
  const before = source.beat;
  if (ahead > 0) {
    // As fast as possible, but so that the page still answers.
    const end = performance.now() + 60;
    while (ahead > 0 && performance.now() < end) {
      const done = runFor(Math.min(ahead, 100));  // sets `ahead` to 0 where the run ends
      ahead = Math.max(0, ahead - done);
    }
    if (ahead <= 0) {
      say(`ran on, to ${source.time.toFixed(3)} s`);
      show(true);
    }
  } else if (isPlaying && source.isLive) {
    due += (seconds * speed) / source.period;
    const end = performance.now() + 14;
    while (due >= 1 && performance.now() < end) {
      const n = Math.min(Math.floor(due), 4);
      if (runFor(n) < n) break;
      due -= n;
    }
    due = Math.min(due, 1 + 0.02 / source.period);
  } else if (isPlaying && source.isRecording) {
    source.seek(source.beat + (seconds * speed) / source.period);
    if (source.beat >= source.beats) play(false);
  }
  if (source.isDoor) measurePace(now);
  else if (seconds > 0) pace += 0.1 * (((source.beat - before) * source.period) / seconds - pace);
  show(false);
  requestAnimationFrame(frame);
}

// Of a running program, in each second: its samples come in batches.
let paceSince = { now: 0, time: 0 };
function measurePace(now) {
  if (now - paceSince.now < 1000) return;
  pace = Math.max(0, (source.time - paceSince.time) / ((now - paceSince.now) * 1e-3));
  paceSince = { now, time: source.time };
}

let toldAt = 0, drawnAt = -1, drawnAgo = 99, isBehind = false;
function show(now) {
  const changed = now || source.beat !== drawnAt;
  isBehind ||= changed;
  drawnAt = source.beat;
  ++drawnAgo;
  const { state, fault, faultPath } = source.status;
  const set = (id, text) => { if ($(id).textContent !== text) $(id).textContent = text; };
  set('state', !source.isDoor ? state : !source.isConnected ? 'not connected' : source.door.is_paused ? 'paused' : state);
  $('state').classList.toggle('faulted', state === 'faulted');
  set('time', source.time.toFixed(3));
  set('beat', String(source.beat));
  set('pace', isPlaying || ahead > 0 || source.isDoor && source.isConnected && !source.door.is_paused ? `${pace.toFixed(2)} ×` : '—');
  if (source.description.robot) {
    const position = source.position();
    $('position-box').hidden = !position;
    if (position) ['x', 'y', 'z'].forEach((axis, i) => set(axis, position[i].toFixed(4)));
    showForce();
  }
  set('alert', source.isDoor && panel.complaint ? panel.complaint : state === 'faulted' ? `⚠ fault in ${faultPath || 'the loop'}: ${fault}${source.isDoor && panel.causes?.length > 1 ? `. First: ${panel.causes[0]}` : ''}` : source.isDoor && source.door.is_paused && panel.causes?.length ? `⚠ ${panel.causes[0]}` : source.fallen ? '⚠ the robot has fallen' : '');
  if (source.isLive) {
    for (const button of document.querySelectorAll('[data-change]')) button.disabled = !allowed[button.dataset.change].includes(state);
    for (const id of ['play', 'step', 'run-ahead']) $(id).disabled = !source.runs;
    showSnapshots();
  } else if (source.isRecording && document.activeElement !== $('replay-time')) $('replay-time').value = source.time;
  // Nothing is drawn that looks as before, and little while it runs on as fast as possible.
  if (robot && source.description.robot && (changed || robot.isStale || robot.isResized) && (ahead <= 0 || drawnAgo % 8 === 0)) {
    if (source.isDoor) source.pose();
    robot.draw(source.poses, source.forces(), source.targets());
  }
  if ((changed || isBehind) && drawnAgo >= (ahead > 0 ? 16 : 3) || now) {  // text and lines need not follow at 60 Hz
    drawnAgo = 0;
    isBehind = false;
    architecture.update();
    plots.update();
    if (source.isDoor) source.follow(architecture.shown(), plots.plots.flatMap((plot) => plot.series.map((curve) => curve.output)));
    if (source.description.robot && source.hasContacts) footfalls.update(isDark);
    showPlan();
    showButtons();
  }
}
// Of the force on the hand, along the world's axes.
function showForce() {
  const force = source.description.robot?.kind === 'arm' ? source.forces()[0] : null;
  $('force-box').hidden = !force;
  if (force) $('force').textContent = Math.hypot(...force).toFixed(2);
}
function buildPlan() {
  const { plan } = source.description;
  $('plan-box').hidden = !plan;
  $('plan').replaceChildren(...(plan?.steps ?? []).map((name) => Object.assign(document.createElement('li'), { textContent: name })));
}
function showPlan() {
  if (!source.description.plan) return;
  const step = source.step();
  [...$('plan').children].forEach((item, i) => {
    if (i === step) item.setAttribute('aria-current', 'step');
    else item.removeAttribute('aria-current');
    item.classList.toggle('over', i < step);
  });
}
function buildButtons() {
  const names = (source.isLive && source.description.buttons) || [];
  $('buttons').hidden = names.length === 0;
  $('buttons').replaceChildren(...names.map((name, i) => {
    const button = Object.assign(document.createElement('button'), { type: 'button', textContent: name, className: 'operator' });
    button.addEventListener('click', () => attempt('', () => {
      const down = !source.status.pressed[i];
      source.press(i, down);
      say(`${name}: ${down ? 'pressed' : 'released'}`);
    }));
    return button;
  }));
  showButtons();
}
function showButtons() {
  [...$('buttons').children].forEach((button, i) => button.setAttribute('aria-pressed', String(source.status.pressed[i])));
}

// ---- life-cycle, snapshots, pushes ----

const allowed = { load: ['created', 'loaded'], start: ['loaded'], stop: ['started', 'faulted'], resume: ['faulted'], save: ['loaded'] };
let snapshotsShown = '';
function showSnapshots() {
  const text = source.status.snapshots.join();
  if (text === snapshotsShown) return;
  snapshotsShown = text;
  const chosen = $('snapshots').value;
  $('snapshots').replaceChildren(...source.status.snapshots.map((beat) => new Option(`${(beat * source.period).toFixed(3)} s`, beat)).reverse());
  if (source.status.snapshots.includes(Number(chosen)) && chosen !== '') $('snapshots').value = chosen;
}

function listen() {
  $('play').addEventListener('click', () => play(!isPlaying));
  $('replay-play').addEventListener('click', () => play(!isPlaying));
  $('replay-time').addEventListener('input', () => { source.seek(Number($('replay-time').value) / source.period); show(true); });
  $('step').addEventListener('click', () => { play(false); runFor(1); show(true); });
  $('speed').addEventListener('change', () => { speed = Number($('speed').value); due = 0; });
  $('run-ahead').addEventListener('click', () => {
    const seconds = Number($('ahead').value);
    if (!(seconds > 0 && seconds <= 600)) return say('expected a time from 0.001 to 600 s', true);
    play(false);
    say('running on …');
    ahead = Math.round(seconds / source.period);
  });
  for (const button of document.querySelectorAll('[data-change]')) button.addEventListener('click', () => attempt(`${button.dataset.change}: done`, () => source.change(button.dataset.change)));
  $('anew').addEventListener('click', () => attempt('begins anew, with these parameters', () => {
    play(false);
    ahead = 0;
    source.beginAnew();
    plots.zoom(null);
  }));
  $('snapshot').addEventListener('click', () => attempt(`snapshot of ${source.time.toFixed(3)} s`, () => source.takeSnapshot()));
  $('go-back').addEventListener('click', () => attempt(`back at ${$('snapshots').selectedOptions[0]?.textContent}`, () => {
    if ($('snapshots').value === '') throw new Error('there is no snapshot yet');
    ahead = 0;
    source.goBack(Number($('snapshots').value));
    showParameters();
    plots.plots.forEach((p) => plots.fill(p));
  }));
  for (const button of document.querySelectorAll('[data-push]')) button.addEventListener('click', () => attempt('pushed', () => {
    const force = Number($('push-force').value);
    if (!(force >= 0 && force <= 100)) throw new Error('expected a force from 0 to 100 N');
    const [x, y] = button.dataset.push.split(',').map((d) => d * force);
    source.push([x, y, 0], 0.1);
  }));
  document.addEventListener('keydown', (event) => {
    if (!source || /^(INPUT|SELECT|TEXTAREA|BUTTON)$/.test(event.target.tagName) || event.ctrlKey || event.altKey || event.metaKey || event.target.classList.contains('port')) return;
    if (event.key === ' ' && source.isDoor) panel.playOrPause();
    else if (event.key === ' ') play(!isPlaying);
    else if (event.key === '.' && source.isDoor) panel.step();
    else if (event.key === '.' && source.isLive) $('step').click();
    else return;
    event.preventDefault();
  });

  $('open').addEventListener('change', () => { architecture.isOpen = $('open').checked; architecture.lay(); architecture.update(); });
  $('add-curve').addEventListener('click', () => {
    const [output, i] = $('port').value.split(',').map(Number);
    plots.addTo(Number($('in-plot').value), output, i);
  });
  $('seconds').addEventListener('change', () => {
    plots.isWhole = $('seconds').value === 'whole';
    if (!plots.isWhole) plots.seconds = Number($('seconds').value);
    plots.zoom(null);
  });
  $('larger').addEventListener('click', () => architecture.zoomBy(1.25));
  $('smaller').addEventListener('click', () => architecture.zoomBy(0.8));
  $('fit').addEventListener('click', () => architecture.fit());
  $('pause').addEventListener('click', () => plots.pause(!plots.isPaused));
  $('zoom-in').addEventListener('click', () => plots.zoomBy(0.5));
  $('zoom-out').addEventListener('click', () => plots.zoomBy(2));
  $('zoom-all').addEventListener('click', () => plots.zoom(null));
  $('theme').addEventListener('click', () => {
    settings.set('theme', isDark ? 'light' : 'dark');
    theme();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', theme);
  new ResizeObserver(() => plots?.resize()).observe($('plots'));
  new ResizeObserver(() => architecture?.resize()).observe($('architecture'));

  $('file').addEventListener('change', () => {
    openFile($('file').files[0]);
    $('file').value = '';  // so that the same file can be chosen again
  });
  $('to-live').addEventListener('click', () => look(live ?? door));
  document.addEventListener('dragover', (event) => { event.preventDefault(); document.body.classList.add('dropping'); });
  document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) document.body.classList.remove('dropping'); });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    openFile(event.dataTransfer.files[0]);
  });
}

async function openFile(file) {
  if (!file) return;
  if (source) play(false);
  say(`reading ${file.name} …`);
  await openRecording(file.name, async () => new Uint8Array(await file.arrayBuffer()));
}
async function openRecording(name, read) {
  const before = source;
  try {
    const recording = await readRecording(await read(), live ? [live.description] : KNOWN);
    if (live && recording.difference) throw new Error(`this is a recording of another architecture: ${recording.difference}. page/recording.html shows the recordings of any architecture, and so does the option --page`);
    look(recording);
    recording.seek(1);  // the first that there is to see
    show(true);
    say(`${name}: ${recording.beats} beats${recording.isCut ? ', cut off at the end' : ''}`);
  } catch (error) {
    source = before;
    say(`${name}: ${error.message}`, true);
  }
}

// ---- parameters ----

const mostShown = 24;  // of one component; more are folded

function buildParameters() {
  const groups = new Map();
  fields = source.description.parameters;
  $('parameters').replaceChildren();
  const count = (node) => fields.filter((f) => f.path.startsWith(`${node}.`)).length;
  fields.forEach((field, i) => {
    const dot = field.path.indexOf('.');
    const node = field.path.slice(0, dot), rest = field.path.slice(dot + 1);
    if (!groups.has(node)) {
      const set = document.createElement('fieldset');
      set.append(Object.assign(document.createElement('legend'), { textContent: node }));
      $('parameters').append(set);
      groups.set(node, set);
      if (count(node) > mostShown) {
        const rest = document.createElement('details');
        rest.append(Object.assign(document.createElement('summary'), { textContent: `${count(node)} numbers` }));
        set.append(rest);
        groups.set(node, rest);
      }
    }
    const row = document.createElement('div');
    row.className = 'field';
    const id = `parameter-${i}`;
    const label = Object.assign(document.createElement('label'), { textContent: rest, htmlFor: id });
    let input;
    if (field.kind === 'choice') {
      input = document.createElement('select');
      input.append(...field.names.map((name, n) => new Option(name, source.isDoor ? name : n)));
    } else if (field.kind === 'boolean') {
      input = Object.assign(document.createElement('input'), { type: 'checkbox' });
    } else {
      input = Object.assign(document.createElement('input'), { type: 'text', inputMode: field.kind === 'text' || field.kind === 'numbers' ? 'text' : 'decimal', autocomplete: 'off' });
    }
    input.id = id;
    input.dataset.path = field.path;
    const allowedRange = Object.assign(document.createElement('small'), { id: `${id}-range`, textContent: range(field) });
    const reason = Object.assign(document.createElement('span'), { className: 'reason', id: `${id}-reason` });
    input.setAttribute('aria-describedby', `${id}-range ${id}-reason`);
    input.addEventListener('input', () => { field.isEdited = true; });
    input.addEventListener('change', () => setParameter(i));
    row.append(label, input, ...slider(field, i), allowedRange, reason);
    groups.get(node).append(row);
    Object.assign(field, { input, reason });
  });
  showParameters();
}
// Of a running program, with the range of the parameter's type.
function slider(field, i) {
  delete field.slider;
  if (!source.isDoor || !['number', 'integer'].includes(field.kind) || field.lower === null || field.upper === null) return [];
  const step = field.kind === 'integer' ? 1 : (field.upper - field.lower) / 500;
  field.slider = Object.assign(document.createElement('input'), { type: 'range', min: field.lower, max: field.upper, step, ariaLabel: `${field.path}, slider` });
  field.slider.addEventListener('input', () => { field.input.value = +Number(field.slider.value).toPrecision(4); });
  field.slider.addEventListener('change', () => setParameter(i));
  return [field.slider];
}
// All of them, or those whose paths are given. What someone is typing stays.
function showParameters(paths) {
  const values = source.parameters();
  fields.forEach((field, i) => {
    if (paths && !paths.includes(field.path) || field.isEdited && document.activeElement === field.input) return;
    const value = values[i];
    if (field.kind === 'boolean') field.input.checked = Boolean(value);
    else if (field.kind === 'numbers') field.input.value = value.map((one) => +one.toPrecision(6)).join(', ');
    else field.input.value = field.kind === 'choice' || field.kind === 'text' ? value : value === null ? 'inf' : +value.toPrecision(6);  // JSON has no infinity
    if (field.slider && document.activeElement !== field.slider) field.slider.value = value;
    field.isEdited = false;
    field.reason.textContent = '';
    field.input.removeAttribute('aria-invalid');
  });
}
function wantedOf(field) {
  const { value } = field.input;
  if (field.kind === 'boolean') return { value: source.isDoor ? field.input.checked : field.input.checked ? 1 : 0 };
  if (field.kind === 'choice') return { value: source.isDoor ? value : Number(value) };
  if (field.kind === 'text') return { value };
  if (field.kind !== 'numbers') return parse(value, field);
  const all = value.split(',').map((one) => parse(one, field));
  return all.find((one) => one.problem) ?? { value: all.map((one) => one.value) };
}
async function setParameter(i) {
  const field = fields[i], of = source;
  let { value, problem = '' } = wantedOf(field);
  field.isEdited = false;
  try {
    if (!problem && of.isDoor) await of.set(field.path, value);
    else problem ||= of.set(i, value);
  } catch (error) {
    problem = error.message;
    if (field.slider) field.slider.value = of.parameters()[i];
  }
  field.reason.textContent = problem ? `refused: ${problem}` : '';
  field.input.toggleAttribute('aria-invalid', false);
  if (problem) field.input.setAttribute('aria-invalid', 'true');
  say(problem ? `refused: ${problem}` : `${field.path} = ${value}${field.unit ? ` ${field.unit}` : ''}`, Boolean(problem));
}

// ---- what is looked at ----

function theme() {
  const wanted = settings.get('theme');
  isDark = wanted ? wanted === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  document.documentElement.dataset.theme = isDark ? 'dark' : 'light';
  $('theme-name').textContent = wanted ?? 'auto';
  robot?.theme(isDark);
  plots?.theme(isDark);
  if (source) show(true);
}

// What is offered of a kind of source: `live`, `recording`, `door`.
function offer(kind) {
  for (const one of document.querySelectorAll('.live-only, .recording-only, .door-only')) one.hidden = !one.classList.contains(`${kind}-only`);
  document.body.classList.toggle('at-door', kind === 'door');
}
function look(at) {
  if (source) play(false);
  source = at;
  document.body.classList.remove('empty');
  document.body.classList.toggle('no-robot', !source.description.robot);
  document.body.classList.toggle('no-parameters', Boolean(source.isRecording) || source.description.parameters.length === 0);
  offer(source.isDoor ? 'door' : source.isLive ? 'live' : 'recording');
  $('to-live').hidden = !(live ?? door) || !source.isRecording;
  $('to-live').textContent = live ? 'back to the live controller' : 'back to the running program';
  $('position-box').hidden = !source.description.robot || !source.isLive;
  $('pace-box').hidden = false;
  if (source.isRecording) $('replay-time').max = source.beats * source.period;
  if (!source.isRecording) buildParameters();
  $('plots').replaceChildren();
  plots = new Plots($('plots'), source);
  plots.isDark = isDark;
  $('seconds').value = source.isRecording ? 'whole' : source.isDoor ? '10' : '4';
  if (source.isDoor) plots.seconds = 10;
  plots.onChange = () => $('in-plot').replaceChildren(...plots.plots.map((_, i) => new Option(`plot ${i + 1}`, i)), new Option('a new plot', plots.plots.length));
  plots.onZoom = () => {
    $('zoom-all').disabled = !plots.span;
    $('pause').setAttribute('aria-pressed', String(plots.isPaused));
    $('pause').textContent = plots.isPaused ? 'go on' : 'pause';
  };
  plots.onChange();
  plots.onZoom();
  $('port').replaceChildren(...portGroups());
  if (!architecture) architecture = new ArchitectureView($('architecture'), source, (o) => plots.addPort(o));
  architecture.source = source;
  architecture.drawnAt = 0;
  architecture.lay();
  if (source.description.robot) {
    robot ??= startRobot();
    robot?.show(source.description.robot);
    footfalls = new Footfalls($('footfalls'), $('stance'), source, source.description.robot.points);
    $('footfalls-box').hidden = !source.hasContacts;
    $('points-hint').hidden = source.description.robot.points.length === 0;
    const isArm = source.description.robot.kind === 'arm';
    $('force-name').textContent = isArm ? 'force on the tool' : 'force on a foot';
    $('target-name').textContent = isArm ? 'where the hand should be' : 'where the targets put a foot';
  }
  buildPlan();
  buildButtons();
  firstPlots();
  theme();
}
function startRobot() {
  try {
    return new RobotView($('robot'), source, (force) => !source.isRecording && source.push(force, force.some((f) => f !== 0) ? 3600 : 0));
  } catch (error) {
    say(`the robot can't be shown in 3D: ${error.message}`, true);
    return null;
  }
}
function portGroups() {
  const groups = new Map();
  source.description.outputs.forEach((output, o) => {
    const node = source.description.nodes[output.node]?.path ?? '';
    if (!groups.has(node)) groups.set(node, Object.assign(document.createElement('optgroup'), { label: node }));
    output.fields.forEach((f, i) => groups.get(node).append(new Option(`${output.path.split('.').pop()}${output.fields.length > 1 ? `.${f.name}` : ''}${f.unit ? ` (${f.unit})` : ''}`, `${o},${i}`)));
  });
  return groups.values();
}
// What the page's program names; else the first commands and what the robot measures of them.
function firstPlots() {
  const { outputs, plots: named } = source.description;
  if (named?.length > 0) {
    for (const [plot, path, i] of named) plots.addTo(plot, outputs.findIndex((o) => o.path === path), i);
    return;
  }
  const find = (test) => outputs.findIndex((o) => test.test(o.path));
  const command = find(/^limits\.safe$/);
  const measured = outputs.findIndex((o, i) => i !== command && command >= 0 && o.fields.length === outputs[command].fields.length && /angle/.test(o.path) && source.description.nodes[o.node].path.startsWith('robot'));
  if (command >= 0) {
    const plot = plots.add([plots.coordinate(command, 0)]);
    if (measured >= 0) plots.addTo(plots.plots.indexOf(plot), measured, 0);
  }
  const other = find(/^(cpg\.phase|velocity\.velocity)$/);
  if (other >= 0) plots.addPort(other);
  if (plots.plots.length > 0) return;
  // Of an architecture with other names: what goes to the robot and what comes from it, else what has numbers.
  const robots = new Set(source.description.nodes.flatMap((n, i) => (n.resource || /(^|\.)robot($|\.)/.test(n.path) ? [i] : [])));
  const sent = source.description.wires.find((w) => robots.has(w.node) && !robots.has(outputs[w.from].node))?.from;
  const sensed = source.description.wires.find((w) => robots.has(outputs[w.from].node))?.from;
  const chosen = [sent, sensed, ...outputs.keys()].filter((o) => o !== undefined && outputs[o].fields.length > 0);
  for (const o of [...new Set(chosen)].slice(0, 2)) plots.addPort(o);
}

// The page comes from the door of a program, and is connected to it.
function openDoor() {
  offer('door');
  const memory = 'cca-token';
  // Out of the address, where it would be copied along.
  const token = settings.get('token') ?? sessionStorage.getItem(memory) ?? '';
  const once = new URLSearchParams(location.search).get('once');
  settings.delete('token');
  history.replaceState(null, '', `${location.pathname}${settings.size > 0 ? `#${settings}` : ''}`);
  const isShown = () => source === door && door.description;
  const thread = new Worker(URL.createObjectURL(new Blob([DOOR_WORKER], { type: 'text/javascript' })));
  door = new Door(thread, KNOWN, {
    changed() {
      document.title = door.description.name;
      document.querySelector('h1').textContent = door.description.name;
      panel.offer();
      if (source?.isRecording) return;
      look(door);
      panel.enable();
    },
    rights() { panel?.rights(); },
    connection() {
      panel?.connection();
      if (isShown()) show(true);
    },
    status() { panel.status(); },
    parameters(paths) { if (isShown() && fields.length > 0) { showParameters(paths); panel.enable(); } },
    line(one) { panel.line(one); },
    told({ level, message }) { if (!message.startsWith('setParameters: ')) say(message, level === 2); },
    nobody() {
      offer('none');
      say('no program answers here; recordings can be opened');
    },
    refused(why) { say(`refused: ${why}`, true); },
  });
  panel = new DoorPanel(door, say);
  new TwinPanel(door, new Worker(URL.createObjectURL(new Blob([TWIN_WORKER], { type: 'text/javascript' }))));
  panel.keepToken = (one) => sessionStorage.setItem(memory, one);
  panel.offeredToken = token;
  door.connect(`ws://${location.host}/${once ? `?once=${once}` : ''}`, token);
}

async function start() {
  if (PROGRAM) {
    live = await startProgram(PROGRAM, FILES);
    look(live);
    live.change('load');
    live.change('start');
    show(true);
    if (!settings.has('paused')) play(true);
  } else {  // recordings, or a program that runs
    document.body.classList.add('empty', 'no-parameters');
    offer('none');
    theme();
  }
  listen();
  if (!PROGRAM && !embedded && location.protocol === 'http:') openDoor();
  if (embedded) {
    document.title = embedded.dataset.name;
    document.querySelector('h1').textContent = embedded.dataset.name;
    await openRecording(embedded.dataset.name, () => fromBase64(embedded.textContent));
  }
  requestAnimationFrame((now) => { last = now; frame(now); });
  document.documentElement.dataset.ready = 'true';
}
start().catch((error) => {
  $('alert').textContent = `The page can't run: ${error.message}`;
  document.documentElement.dataset.ready = 'failed';
  throw error;
});
// For tests: what the page shows is checked against what the program says.
window.ccaPage = { get source() { return source; }, get robot() { return robot; }, get plots() { return plots; }, get frames() { return frames; }, Live };
