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
  const labelled = (text, control, unit = '') => make('label', {}, `${text} `, control, unit ? ` ${unit}` : '');
  const number = (name, value, lower, upper, step = 'any') => make('input', { type: 'number', name, value, min: lower, max: upper, step, required: true, className: 'changes' });
  const input = make('select', { name: 'input', className: 'changes' }, ...options(tests.map((t) => t.input)));
  const signal = make('select', { name: 'signal', className: 'changes' }, ...options(signals));
  const outputs = door.description.outputs.map((o) => o.path).filter((path) => !path.includes('test_'));
  const output = make('select', { name: 'output', className: 'changes' }, ...options(outputs));
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
  const range = () => {
    const { most, axes } = of();
    Object.assign(amplitude, { min: 0, max: most, step: most / 100, value: most / 4, ariaLabel: `amplitude, 0 to ${most} ${of().unit}` });
    axis.replaceChildren(...axes.map((name, i) => new Option(name, i)));
    axis.parentElement?.toggleAttribute('hidden', axes.length < 2);
    measured();
    show();
  };
  const axis = make('select', { name: 'axis', className: 'changes' });
  const from = labelled('from', number('frequency', 1, 0.001, 100000), 'Hz'), to = labelled('to', number('to', 50, 0.001, 100000), 'Hz');
  const of_axis = labelled('axis', axis);
  range();
  input.addEventListener('change', range);
  amplitude.addEventListener('input', show);
  signal.addEventListener('change', () => {
    from.toggleAttribute('hidden', signal.value === 'step');
    to.toggleAttribute('hidden', !signal.value.endsWith('chirp'));
  });
  const begin = make('button', { textContent: '▶ test', className: 'changes' });
  const end = make('button', { type: 'button', textContent: '■ end the test', className: 'changes' });
  const answer = make('div', { className: 'answer', ariaLive: 'polite' });
  const form = make('form', { className: 'row', ariaLabel: 'Test of an input' }, make('span', { className: 'group-name', textContent: 'test' }),
    labelled('input', input), of_axis, labelled('with', signal), labelled('amplitude', amplitude), shown, from, to, labelled('for', number('duration', 10, 0.001, 600), 's'), labelled('output', output), begin, end);
  form.addEventListener('submit', async (event) => {
    event.preventDefault();
    const values = Object.fromEntries(['axis', 'amplitude', 'frequency', 'to', 'duration'].map((name) => [name, Number(form.elements[name].value)]));
    const texts = Object.fromEntries(['input', 'signal', 'output'].map((name) => [name, form.elements[name].value]));
    try {
      const numbers = door.description.outputs.find((o) => o.path === texts.output).fields.length;
      await door.call('test', { ...texts, ...values, output_axis: Math.min(values.axis, numbers - 1) });
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
