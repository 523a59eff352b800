// Plots of chosen ports over time: several curves in one, each with its unit; pause and zoom.
import uPlot from 'uplot';
import { curves, short } from './numbers.js';

const points = 1200;

export class Plots {
  constructor(box, source) {
    this.box = box;
    this.source = source;
    this.plots = [];
    this.seconds = 4;
    this.isPaused = false;
    this.span = null;  // zoomed: [from, to]
    this.isWhole = Boolean(source.isRecording);  // it is shown from its beginning to its end
    this.isDark = false;
  }

  coordinate(output, i) {
    const { path, fields } = this.source.description.outputs[output];
    const name = fields.length === 1 ? path : `${path}.${fields[i].name}`;
    return { output, i, name, unit: fields[i].unit || '' };
  }
  // The first four coordinates of a port, as curves of one plot.
  addPort(output) {
    const { fields } = this.source.description.outputs[output];
    this.add(fields.slice(0, 4).map((_, i) => this.coordinate(output, i)));
  }
  add(series) {
    const plot = { series: [...series], box: document.createElement('figure') };
    plot.box.className = 'plot';
    this.plots.push(plot);
    this.box.append(plot.box);
    this.make(plot);
    return plot;
  }
  addTo(number, output, i) {
    const curve = this.coordinate(output, i);
    const plot = this.plots[number];
    if (!plot) return this.add([curve]);
    if (plot.series.length >= curves.length || plot.series.some((s) => s.name === curve.name)) return plot;
    plot.series.push(curve);
    this.make(plot);
    return plot;
  }
  remove(plot, curve) {
    plot.series = plot.series.filter((s) => s !== curve);
    if (plot.series.length > 0) return this.make(plot);
    plot.chart.destroy();
    plot.box.remove();
    this.plots = this.plots.filter((p) => p !== plot);
    this.number();
  }
  number() {
    this.plots.forEach((plot, i) => { plot.title.textContent = `Plot ${i + 1}`; });
    this.onChange?.();
  }

  make(plot) {
    plot.chart?.destroy();
    const colour = (i) => curves[i % curves.length][this.isDark ? 'dark' : 'light'];
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue('--ink-2'), grid = style.getPropertyValue('--line');
    const units = [...new Set(plot.series.map((s) => s.unit || '1'))];
    const axis = (scale, side) => ({ scale, side, label: scale, labelSize: 18, labelGap: 0, size: 52, stroke: ink, grid: { stroke: grid, show: side === 3 }, ticks: { stroke: grid }, font: '11px system-ui', labelFont: '11px system-ui' });
    const caption = document.createElement('figcaption');
    plot.title = document.createElement('span');
    plot.title.className = 'plot-title';
    caption.append(plot.title);
    plot.labels = plot.series.map((curve, i) => {
      const label = document.createElement('span');
      label.className = 'curve';
      const line = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
      line.setAttribute('viewBox', '0 0 28 8');
      line.setAttribute('aria-hidden', 'true');
      line.innerHTML = `<line x1="0" y1="4" x2="28" y2="4" stroke="${colour(i)}" stroke-width="3" stroke-dasharray="${curves[i].dash.join(' ')}"/>`;
      const value = document.createElement('output');
      const remove = document.createElement('button');
      remove.type = 'button';
      remove.textContent = '×';
      remove.setAttribute('aria-label', `Remove ${curve.name}`);
      remove.addEventListener('click', () => this.remove(plot, curve));
      label.append(line, ` ${curve.name} `, value, remove);
      caption.append(label);
      return { value, curve };
    });
    const drawing = document.createElement('div');
    plot.box.replaceChildren(caption, drawing);
    const width = Math.max(200, plot.box.clientWidth - 2);
    plot.chart = new uPlot({
      width, height: 190, legend: { show: false },
      cursor: { sync: { key: 'page' }, drag: { x: true, y: false } },
      scales: { x: { time: false, auto: false, range: () => this.shown() } },
      axes: [{ stroke: ink, grid: { stroke: grid }, ticks: { stroke: grid }, font: '11px system-ui', values: (_, v) => v.map((t) => `${+t.toFixed(3)} s`) },
        ...units.slice(0, 2).map((u, i) => axis(u, i === 0 ? 3 : 1))],
      series: [{}, ...plot.series.map((curve, i) => ({ label: curve.name, scale: curve.unit || '1', stroke: colour(i), width: 1.6, dash: curves[i].dash, points: { show: false } }))],
      hooks: { setSelect: [(chart) => this.select(chart)], draw: [(chart) => this.markNow(chart)] },
    }, [[0], ...plot.series.map(() => [0])], drawing);
    // uPlot's own double click would go back to its automatic scale.
    plot.chart.over.addEventListener('dblclick', () => this.zoom(null));
    this.number();
    this.fill(plot);
  }

  // The span of time that is shown.
  shown() {
    if (this.span) return this.span;
    if (this.isWhole) return [0, Math.max(this.source.duration, this.source.period)];
    const end = this.frozen ?? this.source.time;
    return [Math.max(0, end - this.seconds), Math.max(end, this.seconds * 0.25)];
  }
  // A line where the recording is played.
  markNow(chart) {
    if (!this.source.isRecording) return;
    const { ctx, bbox } = chart, x = Math.round(chart.valToPos(this.source.time, 'x', true)) + 0.5;
    if (x < bbox.left || x > bbox.left + bbox.width) return;
    ctx.save();
    ctx.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue('--accent');
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }
  select(chart) {
    const { left, width } = chart.select;
    if (width < 4) return;
    this.zoom([chart.posToVal(left, 'x'), chart.posToVal(left + width, 'x')]);
    chart.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
  }
  zoom(span) {
    this.span = span;
    this.onZoom?.();
    this.plots.forEach((p) => this.fill(p));
  }
  zoomBy(factor) {
    const [from, to] = this.shown();
    const middle = (from + to) / 2, half = ((to - from) / 2) * factor;
    this.zoom([Math.max(0, middle - half), middle + half]);
  }
  pause(on) {
    this.isPaused = on;
    if (this.source.isRecording && on) this.span = this.shown();
    this.frozen = on ? this.source.time : null;
    if (!on) this.span = null;
    this.onZoom?.();
    this.plots.forEach((p) => this.fill(p));
  }

  fill(plot) {
    const [from, to] = this.shown();
    const data = plot.series.map((s) => this.source.series(s.output, s.i, from, to, points));
    // Curves of a recording have times of their own, and may end at different ones: each is put onto those of all.
    const [first, ...others] = data.map(([times]) => times);
    const isSame = others.every((times) => times.length === first.length && times.every((t, k) => t === first[k]));
    const all = isSame ? first : [...new Set(data.flatMap(([times]) => times))].sort((a, b) => a - b);
    plot.chart.setData([all, ...data.map(([times, values]) => (isSame ? values : onto(all, times, values)))]);
    this.label(plot, data.map(([, values]) => values.at(-1)));
  }
  // The newest value of each curve; of a recording the one at the time that is played.
  label(plot, newest) {
    plot.labels.forEach(({ value, curve }, i) => {
      const now = !this.source.isRecording ? newest[i] : this.source.sample(curve.output)?.[curve.i];
      value.textContent = now === undefined ? '—' : `${short(now)} ${curve.unit}`;
    });
  }

  update() {
    if (this.source.isRecording && (this.span || this.isWhole || this.isPaused)) {  // nothing moves but the line
      for (const plot of this.plots) {
        plot.chart.redraw(false);
        this.label(plot, []);
      }
      return;
    }
    if (this.isPaused || this.span) return;
    this.plots.forEach((p) => this.fill(p));
  }
  resize() {
    for (const plot of this.plots) plot.chart.setSize({ width: Math.max(200, plot.box.clientWidth - 2), height: 190 });
  }
  theme(isDark) {
    this.isDark = isDark;
    this.plots.forEach((p) => this.make(p));
  }
}

// Values at other times: each is the last one that was published; none after the last.
function onto(wanted, times, values) {
  let at = -1;
  return wanted.map((t) => {
    while (at + 1 < times.length && times[at + 1] <= t + 1e-9) ++at;
    return at < 0 || t > times.at(-1) + 1e-9 ? null : values[at];
  });
}
