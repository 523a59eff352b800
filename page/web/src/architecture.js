// The architecture as a picture: components in their environments, wires, newest values with their ages, what
// fires, and faults.
import dagre from '@dagrejs/dagre';
import { age, short } from './numbers.js';

const svgSpace = 'http://www.w3.org/2000/svg';
function element(name, attributes = {}, ...children) {
  const made = document.createElementNS(svgSpace, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const lineHeight = 15;
// Widths of texts, in the fonts of style.css.
const ruler = document.createElement('canvas').getContext('2d');
const fonts = { port: '11.5px system-ui, sans-serif', name: '700 12.5px system-ui, sans-serif', when: 'italic 11.5px system-ui, sans-serif', label: '10px system-ui, sans-serif', environment: '700 13px system-ui, sans-serif' };
function widthOf(text, font) {
  ruler.font = fonts[font];
  return ruler.measureText(text).width;
}
// The text, or as much of its beginning as fits.
function fitting(text, font, width) {
  if (widthOf(text, font) <= width) return text;
  let short = text;
  while (short && widthOf(`${short}…`, font) > width) short = short.slice(0, -1);
  return `${short}…`;
}
// As wide as values usually are: two numbers, a unit, an age.
const usualValue = (fields) => `${fields.slice(0, 2).map(() => '−00.000').join(', ')}${fields.length > 2 ? ', …' : ''} ${fields[0]?.unit ?? ''} · 1000 ms`;
const largestZoom = 4;
const kilo = (hz) => (hz >= 1000 ? `${hz / 1000} kHz` : `${hz} Hz`);
const transport = 'memory';  // between the environments of one process
const boxOf = (environment) => `environment ${environment}`;
const rate = (when) => when.replace(/^([\d.]+) Hz$/, (_, hz) => kilo(Number(hz)));

export class ArchitectureView {
  constructor(box, source, onPick) {
    this.box = box;
    this.source = source;
    this.onPick = onPick;
    this.drawnAt = 0;
    this.since = 0;
    this.isOpen = false;  // inner graphs are shown as one node each
    this.isFitted = true;
    this.listen();
    this.lay();
  }

  // The path of what is drawn of a node: a component, or a whole inner graph.
  pathOf(node) {
    const { path } = this.source.description.nodes[node];
    const dot = path.indexOf('.');
    return this.isOpen || dot < 0 ? path : path.slice(0, dot);
  }
  // Its name in the picture. Of an inner graph in several environments each has its part.
  groupOf(node) {
    const path = this.pathOf(node);
    const { nodes, environments } = this.source.description;
    const { environment } = nodes[node];
    const isSplit = nodes.some((other, i) => this.pathOf(i) === path && other.environment !== environment);
    return isSplit ? `${path} in ${environments[environment]}` : path;
  }
  crosses(wire) {
    const { nodes, outputs } = this.source.description;
    return nodes[outputs[wire.from].node].environment !== nodes[wire.node].environment;
  }

  // The name of a port in what is drawn: with the inner path, where an inner graph is one node.
  portName(output) {
    const { path, node } = this.source.description.outputs[output];
    return path.slice(this.pathOf(node).length + 1);
  }

  lay() {
    const { nodes, outputs, wires } = this.source.description;
    const drawn = new Map();
    nodes.forEach((node, i) => {
      const name = this.groupOf(i);
      if (!drawn.has(name)) drawn.set(name, { name, nodes: [], outputs: [], environment: node.environment ?? -1 });
      drawn.get(name).nodes.push(i);
    });
    const edges = new Map();
    for (const wire of wires) {
      const from = this.groupOf(outputs[wire.from].node), to = this.groupOf(wire.node);
      if (from === to && !this.isOpen) continue;
      const node = drawn.get(from);
      if (!node.outputs.includes(wire.from)) node.outputs.push(wire.from);
      const key = `${from}>${to}`;
      if (!edges.has(key)) edges.set(key, { from, to, wires: [] });
      edges.get(key).wires.push(wire);
    }
    outputs.forEach((output, o) => {  // outputs that nothing reads, of components of the outermost graph
      const node = drawn.get(this.groupOf(output.node));
      if (!node.outputs.includes(o) && (this.isOpen || node.nodes.length === 1)) node.outputs.push(o);
    });

    this.width = this.box.clientWidth;
    const across = this.place(drawn, edges, 'LR'), acrossFits = this.fitOf(across.graph());
    const down = acrossFits < 1 ? this.place(drawn, edges, 'TB') : null;
    const isDown = down && this.fitOf(down.graph()) > acrossFits;
    this.paint(drawn, edges, isDown ? down : across);
  }

  // ---- the size of the picture ----

  // With which scale a picture fits its panel; at most 1.
  fitOf({ width, height }) {
    const highest = parseFloat(getComputedStyle(this.box).maxHeight) || this.box.clientHeight || height;
    return Math.min(1, (this.box.clientWidth - 4) / width, (highest - 4) / height);
  }
  fit() {
    this.isFitted = true;
    this.scaleTo(this.fitOf(this.size));
  }
  // `at`: what stays in its place, in the panel; else its middle.
  zoomBy(factor, at = { x: this.box.clientWidth / 2, y: this.box.clientHeight / 2 }) {
    const before = this.scale;
    const scale = Math.min(largestZoom, Math.max(0.5 * this.fitOf(this.size), before * factor));
    const x = (this.box.scrollLeft + at.x) / before, y = (this.box.scrollTop + at.y) / before;
    this.isFitted = false;
    this.scaleTo(scale);
    this.box.scrollLeft = x * scale - at.x;
    this.box.scrollTop = y * scale - at.y;
  }
  scaleTo(scale) {
    this.scale = scale;
    this.svg.setAttribute('width', this.size.width * scale);
    this.svg.setAttribute('height', this.size.height * scale);
  }
  // The wheel with the control key, or two fingers; keys; dragging moves a picture that is larger than its panel.
  listen() {
    const { box } = this;
    box.addEventListener('wheel', (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      const { left, top } = box.getBoundingClientRect();
      this.zoomBy(Math.exp(-0.002 * event.deltaY), { x: event.clientX - left, y: event.clientY - top });
    }, { passive: false });
    box.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === '+') this.zoomBy(1.25);
      else if (event.key === '-') this.zoomBy(0.8);
      else if (event.key === '0') this.fit();
      else return;
      event.preventDefault();
    });
    box.addEventListener('dblclick', (event) => { if (!event.target.closest('.port')) this.fit(); });
    box.addEventListener('pointerdown', (event) => {
      if (event.pointerType !== 'mouse' || event.button !== 0 || event.target.closest('.port')) return;
      const from = { x: event.clientX + box.scrollLeft, y: event.clientY + box.scrollTop };
      const move = (e) => { box.scrollLeft = from.x - e.clientX; box.scrollTop = from.y - e.clientY; };
      const up = () => { removeEventListener('pointermove', move); removeEventListener('pointerup', up); };
      addEventListener('pointermove', move);
      addEventListener('pointerup', up);
    });
  }

  // From left to right, or from top to bottom.
  place(drawn, edges, rankdir) {
    const { nodes, outputs } = this.source.description;
    const graph = new dagre.graphlib.Graph({ multigraph: false, compound: true });
    const { environments = [] } = this.source.description;
    const margin = environments.length > 0 ? 34 : 12;  // for the boxes around
    graph.setGraph({ rankdir, nodesep: environments.length > 0 ? 44 : 22, ranksep: rankdir === 'LR' ? 46 : 34, marginx: margin, marginy: margin });
    environments.forEach((name, e) => graph.setNode(boxOf(e), {}));
    graph.setDefaultEdgeLabel(() => ({}));
    for (const node of drawn.values()) {
      node.outputs.sort((a, b) => a - b);
      const rows = node.outputs.map((o) => widthOf(`${this.portName(o)} ${usualValue(outputs[o].fields)}`, 'port'));
      node.label = node.nodes.length > 1 ? `${node.name} (${node.nodes.length} components)` : node.name;
      node.when = node.nodes.length > 1 ? '' : rate(nodes[node.nodes[0]].when);
      node.width = Math.max(110, widthOf(node.label, 'name') + 40, widthOf(node.when, 'when') + 20, ...rows.map((width) => width + 20));
      node.height = 30 + (node.when ? lineHeight : 0) + node.outputs.length * lineHeight;
      graph.setNode(node.name, { width: node.width, height: node.height });
      if (environments[node.environment]) graph.setParent(node.name, boxOf(node.environment));
    }
    for (const edge of edges.values()) {
      edge.lines = edge.wires.map((w) => {
        const name = this.portName(w.from);
        const renamed = name === w.input ? name : `${name} → ${w.input}`;
        return [renamed, ...(this.crosses(w) ? [transport] : []), ...(w.policy === 'latest' ? [] : [w.policy])].join(', ');
      });
      edge.crosses = edge.wires.some((w) => this.crosses(w));
      const delays = [...new Set(edge.wires.map((w) => w.policy))].join(' or ');
      if (edge.lines.length > 4) edge.lines = [`${edge.lines.length} wires${edge.crosses ? `, ${transport}, ${delays}` : ''}`];
      const widest = Math.max(...edge.lines.map((line) => widthOf(line, 'label')));
      graph.setEdge(edge.from, edge.to, { width: widest + 6, height: edge.lines.length * 12, labelpos: 'c' });
    }
    dagre.layout(graph);
    return graph;
  }

  paint(drawn, edges, graph) {
    const { outputs, nodes } = this.source.description;
    const svg = element('svg', { role: 'group', 'aria-label': 'The components and their wires' });
    svg.append(element('defs', {}, element('marker', { id: 'tip', viewBox: '0 0 8 8', refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: 'auto' },
      element('path', { d: 'M0 0 L8 4 L0 8 z', class: 'tip' }))));
    (this.source.description.environments ?? []).forEach((name, e) => {
      const box = graph.node(boxOf(e));
      if (!box?.width) return;
      const group = element('g', { class: 'environment', 'data-environment': name });
      const wide = Math.max(box.width + 8, widthOf(name, 'environment') + 20);
      const top = box.y - box.height / 2 - 18, left = box.x - wide / 2;
      group.append(element('rect', { x: left, y: top, width: wide, height: box.height + 22, rx: 10 }), element('text', { x: left + 10, y: top + 15 }, name));
      svg.append(group);
    });
    for (const edge of edges.values()) {
      const { points, x, y } = graph.edge(edge.from, edge.to);
      let d = `M${points[0].x} ${points[0].y}`;
      for (let i = 1; i < points.length - 1; ++i) {
        const to = { x: (points[i].x + points[i + 1].x) / 2, y: (points[i].y + points[i + 1].y) / 2 };
        d += ` Q${points[i].x} ${points[i].y} ${to.x} ${to.y}`;
      }
      d += ` L${points.at(-1).x} ${points.at(-1).y}`;
      const isDelayed = edge.wires.some((w) => w.delay > 0);
      svg.append(element('path', { d, class: ['wire', isDelayed && 'delayed', edge.crosses && 'crossing'].filter(Boolean).join(' '), 'marker-end': 'url(#tip)' }));
      const text = element('text', { class: 'wire-label', 'text-anchor': 'middle' });
      edge.lines.forEach((line, i) => text.append(element('tspan', { x, y: y + 4 + (i - (edge.lines.length - 1) / 2) * 12 }, line)));
      svg.append(text);
    }
    this.parts = [];
    for (const node of drawn.values()) {
      const { x, y } = graph.node(node.name);
      const left = x - node.width / 2, top = y - node.height / 2;
      const isResource = node.nodes.some((n) => nodes[n].resource);
      const group = element('g', { class: isResource ? 'node resource' : 'node', 'data-node': node.name });
      group.append(element('rect', { x: left, y: top, width: node.width, height: node.height, rx: isResource ? 14 : 5 }));
      const lamp = element('circle', { cx: left + node.width - 13, cy: top + 14, r: 4.5, class: 'lamp' });
      group.append(lamp, element('text', { x: left + 10, y: top + 19, class: 'name' }, node.label));
      if (node.when) group.append(element('text', { x: left + 10, y: top + 19 + lineHeight, class: 'when' }, node.when));
      const values = node.outputs.map((o, i) => {
        const lineTop = top + 34 + (node.when ? lineHeight : 0) + i * lineHeight;
        const row = element('g', { class: 'port', tabindex: 0, role: 'button', 'data-port': outputs[o].path });
        const value = element('tspan', { class: 'value' });
        const text = element('text', { x: left + 10, y: lineTop }, `${this.portName(o)} `, value);
        row.append(element('rect', { x: left + 4, y: lineTop - 11, width: node.width - 8, height: lineHeight, class: 'hit' }), text);
        const pick = () => this.onPick(o);
        row.addEventListener('click', pick);
        row.addEventListener('keydown', (e) => { if (e.key === 'Enter' || e.key === ' ') { e.preventDefault(); pick(); } });
        group.append(row);
        return { output: o, value, room: node.width - 20 - widthOf(`${this.portName(o)} `, 'port') };
      });
      const fault = element('title');
      group.prepend(fault);
      svg.append(group);
      this.parts.push({ ...node, group, lamp, values, fault });
    }
    this.box.replaceChildren(svg);
    this.svg = svg;
    // All that is drawn, so that nothing is cut off.
    const drawing = svg.getBBox();
    this.size = { width: drawing.width + 12, height: drawing.height + 12 };
    svg.setAttribute('viewBox', `${drawing.x - 6} ${drawing.y - 6} ${this.size.width} ${this.size.height}`);
    if (this.isFitted) this.fit();
    else this.scaleTo(this.scale);
  }

  resize() {
    if (Math.abs(this.box.clientWidth - this.width) < 40) return;
    this.lay();
    this.update();
  }

  // In which beat a component fired last, as far as its clock or its samples tell.
  lastFiring(node) {
    const { clock } = this.source.description.nodes[node];
    const last = this.source.beat - 1;
    if (clock && clock.period > 0) return last < clock.first ? -1 : last - ((last - clock.first) % clock.period);
    let newest = -1;
    this.source.description.outputs.forEach((output, o) => {
      if (output.node === node) newest = Math.max(newest, this.source.publishedIn(o));
    });
    return newest;
  }

  // The outputs whose values are drawn.
  shown() { return this.parts.flatMap((part) => part.values.map(({ output }) => output)); }

  update() {
    const { source } = this;
    const row = source.newest();
    const { state, fault, faultPath } = source.status;
    // Fired since it was drawn last; while nothing runs that stays as it is.
    if (source.beat !== this.drawnAt) this.since = Math.max(0, this.drawnAt < source.beat ? this.drawnAt : source.beat - 1);
    for (const part of this.parts) {
      const fired = Math.max(...part.nodes.map((n) => this.lastFiring(n)));
      const isNew = fired >= this.since;
      part.lamp.classList.toggle('on', isNew);
      part.group.classList.toggle('fires', isNew);
      const isFaulty = state === 'faulted' && part.nodes.some((n) => source.description.nodes[n].path === faultPath);
      part.group.classList.toggle('faulty', isFaulty);
      part.fault.textContent = isFaulty ? `fault: ${fault}` : '';
      for (const { output, value, room } of part.values) {
        const { at, fields } = source.description.outputs[output];
        const text = !row || source.publishedIn(output) < 0
          ? '—'
          : `${fields.slice(0, 2).map((f, i) => short(row[at + i])).join(', ')}${fields.length > 2 ? ', …' : ''} ${fields[0]?.unit ?? ''} · ${age(source.time - source.period - source.originOf(output))}`;
        const shown = fitting(text, 'port', room);
        if (value.textContent !== shown) value.textContent = shown;
      }
    }
    this.drawnAt = source.beat;
  }
}
