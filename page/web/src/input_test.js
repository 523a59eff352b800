// A test of an input of the running program: a signal that is added to it, and gain and phase to an output.
const make = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const signals = ['chirp', 'linear_chirp', 'sine', 'step'];
const [width, height, left, bottom] = [420, 130, 52, 22];

// The row of the page, or nothing. `panel` asks the door and tells refusals; `tests`: of the description of the door.
export function inputTest(panel, tests) {
  if (tests.length === 0) return [];
  const { door } = panel;
  const options = (names) => names.map((text) => new Option(text, text));
  const choice = (name, ariaLabel = '') => make('select', { name, className: 'changes', ...(ariaLabel && { ariaLabel }) });
  const labelled = (text, control, unit = '') => make('label', {}, `${text} `, control, unit ? ` ${unit}` : '');
  const number = (name, value, lower, upper, step = 'any') => make('input', { type: 'number', name, value, min: lower, max: upper, step, required: true, className: 'changes' });
  const input = choice('input'), signal = choice('signal'), axis = choice('axis', 'axis of the input');
  input.append(...options(tests.map((t) => t.input)));
  signal.append(...options(signals));
  const outputs = door.description.outputs.map((o) => o.path).filter((path) => !path.includes('test_'));
  // Gain and phase are those to `output` from the signal itself, or from another output.
  const output = choice('output'), outputAxis = choice('output_axis', 'axis of the output');
  const from = choice('from', 'response from'), fromAxis = choice('from_axis', 'axis of what it is the response from');
  output.append(...options(outputs));
  from.append(new Option('the signal', ''), ...options(outputs));
  const amplitude = make('input', { type: 'range', name: 'amplitude', className: 'changes' }), shown = make('output');
  const of = () => tests.find((t) => t.input === input.value);
  const show = () => { shown.textContent = `${Number(amplitude.value).toPrecision(3)} ${of().unit}`; };
  // What the tested component measures: an output of the same unit that is wired to another of its inputs.
  const measured = () => {
    const { nodes, wires, outputs: all } = door.description, test = of();
    const found = wires.find((w) => test.input.startsWith(`${nodes[w.node].path}.`) && test.input !== `${nodes[w.node].path}.${w.input}`
      && all[w.from].fields[0]?.unit === test.unit && outputs.includes(all[w.from].path));
    if (found) output.value = all[found.from].path;
  };
  // An axis is asked for where there are several.
  const offer = (select, names) => {
    select.replaceChildren(...names.map((name, i) => new Option(name, i)));
    select.parentElement.toggleAttribute('hidden', names.length < 2);
  };
  // As many from the first as the axis of the input.
  const offerPort = (port, select) => {
    offer(select, outputs.includes(port.value) ? door.description.outputs.find((o) => o.path === port.value).fields.map((f) => f.name) : []);
    select.selectedIndex = Math.min(axis.selectedIndex, select.length - 1);
  };
  const offerPorts = () => { offerPort(output, outputAxis); offerPort(from, fromAxis); };
  const range = () => {
    const { most, axes } = of();
    Object.assign(amplitude, { min: 0, max: most, step: most / 100, value: most / 4, ariaLabel: `amplitude, 0 to ${most} ${of().unit}` });
    offer(axis, axes);
    measured();
    offerPorts();
    show();
  };
  const low = labelled('from', number('frequency', 1, 0.001, 100000), 'Hz'), high = labelled('to', number('to', 50, 0.001, 100000), 'Hz');
  const ofAxis = labelled('axis', axis), ofOutput = labelled('axis', outputAxis);
  const against = make('span', {}, labelled('response from', from), ' ', labelled('axis', fromAxis));  // of a step there is none
  range();
  input.addEventListener('change', range);
  axis.addEventListener('change', offerPorts);
  output.addEventListener('change', () => offerPort(output, outputAxis));
  from.addEventListener('change', () => offerPort(from, fromAxis));
  amplitude.addEventListener('input', show);
  signal.addEventListener('change', () => {
    for (const one of [low, against]) one.toggleAttribute('hidden', signal.value === 'step');
    high.toggleAttribute('hidden', !signal.value.endsWith('chirp'));
  });
  const begin = make('button', { textContent: '▶ test', className: 'changes' });
  const end = make('button', { type: 'button', textContent: '■ end the test', className: 'changes' });
  const answer = make('div', { className: 'answer', ariaLive: 'polite' });
  const form = make('form', { className: 'row', ariaLabel: 'Test of an input' }, make('span', { className: 'group-name', textContent: 'test' }),
    labelled('input', input), ofAxis, labelled('with', signal), labelled('amplitude', amplitude), shown, low, high, labelled('for', number('duration', 10, 0.001, 600), 's'), against, labelled('output', output), ofOutput, begin, end);
  form.addEventListener('submit', async (event) => {
    event.preventDefault();
    const isFrom = from.value && signal.value !== 'step';
    const values = Object.fromEntries(['axis', 'amplitude', 'frequency', 'to', 'duration', 'output_axis', ...(isFrom ? ['from_axis'] : [])].map((name) => [name, Number(form.elements[name].value)]));
    const texts = Object.fromEntries(['input', 'signal', 'output', ...(isFrom ? ['from'] : [])].map((name) => [name, form.elements[name].value]));
    try {
      await door.call('test', { ...texts, ...values });
      panel.say(`tests ${texts.input} by a ${texts.signal}`);
      answer.replaceChildren(...drawn(await response(door)));
      panel.say(`the test of ${texts.input} is over`);
    } catch (error) {
      panel.say(`refused: ${error.message}`, true);
    }
  });
  end.addEventListener('click', () => panel.ask('the test has ended', 'end_test'));
  return [form, answer];
}

// Asked until the test is over.
async function response(door) {
  for (;;) {
    try {
      return (await door.ask('response')).response;
    } catch (error) {
      if (!error.message.includes(' runs')) throw error;
    }
    await wait(300);
  }
}

// ---- what is drawn ----

const svg = (name, attributes, ...children) => {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
};
const short = (value) => String(Number(value.toPrecision(3)));

// One curve with its axes; `log`: of x.
function curve(title, x, y, log) {
  const place = (values, value, isLog) => {
    const of = isLog ? Math.log : (v) => v, low = of(Math.min(...values)), high = of(Math.max(...values));
    return high > low ? (of(value) - low) / (high - low) : 0.5;
  };
  const points = x.map((at, i) => `${(left + place(x, at, log) * (width - left - 8)).toFixed(1)},${(8 + (1 - place(y, y[i], false)) * (height - bottom - 16)).toFixed(1)}`);
  const text = (at, value, anchor) => svg('text', { x: at[0], y: at[1], 'text-anchor': anchor, 'font-size': 11, fill: 'currentColor' }, value);
  const range = [Math.min(...y), Math.max(...y)];
  return make('figure', {}, make('figcaption', { textContent: title }), svg('svg', { viewBox: `0 0 ${width} ${height}`, width, role: 'img', 'aria-label': `${title}: ${short(range[0])} to ${short(range[1])}` },
    svg('path', { d: `M${left} 4V${height - bottom}H${width - 4}`, fill: 'none', stroke: 'currentColor' }),
    text([left - 4, 14], short(range[1]), 'end'), text([left - 4, height - bottom], short(range[0]), 'end'),
    text([left, height - 6], short(x[0]), 'start'), text([width - 4, height - 6], short(x.at(-1)), 'end'),
    svg('polyline', { points: points.join(' '), fill: 'none', stroke: '#0072b2', 'stroke-width': 2 })));
}
function drawn(of) {
  if (!of.frequency) {
    const told = `rises in ${short(of.rise_time)} s, overshoot ${short(100 * of.overshoot)} %, settled after ${short(of.settling_time)} s`;
    return [curve('answer to the step, over s', of.time, of.output, false), make('p', { textContent: told })];
  }
  const decibels = of.gain.map((g) => 20 * Math.log10(Math.max(g, 1e-12))), degrees = of.phase.map((p) => p * 180 / Math.PI);
  if (of.frequency.length === 1) return [make('p', { textContent: `at ${short(of.frequency[0])} Hz: gain ${short(of.gain[0])} (${short(decibels[0])} dB), phase ${short(degrees[0])}°, coherence ${short(of.coherence[0])}` })];
  return [curve('gain in dB, over Hz', of.frequency, decibels, true), curve('phase in degrees', of.frequency, degrees, true), curve('coherence', of.frequency, of.coherence, true)];
}
