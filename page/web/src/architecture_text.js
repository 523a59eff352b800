// An architecture from its text, as a recording and a door have it; the spaces of its ports from their channels.

// `channels`: by their topics, each with `metadata` (a map) and `schema`. `places`: of a deployment, where each
// component runs.
export function described(architecture, channels, places = new Map()) {
  const period = Number(architecture.ns_a_beat) * 1e-9;
  const nodes = [], outputs = [], wires = [];
  let at = 0;
  for (const line of architecture.text.split('\n')) {
    let m;
    if ((m = /^node (.*?), (.*)$/.exec(line))) {
      const every = /every (\d+) beats from (\d+)/.exec(m[2]);
      nodes.push({ path: m[1], resource: false, when: every ? `${1 / (Number(every[1]) * period)} Hz` : m[2],
        clock: every ? { period: Number(every[1]), first: Number(every[2]) } : null });
    } else if ((m = /^output (.*): (\d+) numbers/.exec(line))) {
      const path = m[1], size = Number(m[2]);
      const channel = channels.get(`/${path.replaceAll('.', '/')}`);
      const names = channel?.metadata.get('axes').split(' ') ?? [], units = unitsOf(channel, size);
      outputs.push({ path, node: portAt(nodes, path).node, at, channel, space: channel?.metadata.get('space') ?? '',
        fields: Array.from({ length: size }, (_, i) => ({ name: names[i] ?? String(i), unit: units[i] === '1' ? '' : units[i] })) });
      at += size;
    } else if ((m = /^wire to (.*) from output (\d+), delayed (\d+)$/.exec(line))) {
      const { node, port } = portAt(nodes, m[1]);
      wires.push({ from: Number(m[2]), node, input: port, delay: Number(m[3]), policy: m[3] === '0' ? 'latest' : `delayed ${m[3]}` });
    }
  }
  const environments = [...new Set(places.values())];
  for (const node of nodes) node.environment = environments.indexOf(places.get(node.path));
  return { environments, name: architecture.name, period: Number(architecture.ns_a_beat), nodes, outputs, wires, coordinates: at, parameters: [] };
}

// The node of a port, and the port's name, which may have dots: `*.status`.
function portAt(nodes, path) {
  const length = (n) => nodes[n]?.path.length ?? 0;
  const node = nodes.reduce((longest, { path: of }, n) => (path.startsWith(`${of}.`) && of.length > length(longest) ? n : longest), -1);
  if (node < 0) throw new Error(`its architecture has a port \`${path}\` of no component`);
  return { node, port: path.slice(length(node) + 1) };
}

// From the schema: `float64 hip  # N m, -3 to 3`. A unit may have spaces, so the metadata won't do.
function unitsOf(channel, size) {
  const lines = (channel?.schema ?? '').split('\n').filter((l) => l.startsWith('float64'));
  return Array.from({ length: size }, (_, i) => {
    const comment = /#\s*(.*)$/.exec(lines[i] ?? '')?.[1] ?? '';
    const unit = comment.split(',')[0];
    return /^-?[\d.]+(e[-+]?\d+)? to /.test(unit) ? '' : unit;
  });
}

// What of a recorded architecture is not as in another one, in words; empty: it is the same.
export function difference(recorded, other) {
  const missing = (here, there) => here.find((name) => !there.includes(name));
  const kinds = {
    component: (d) => d.nodes.map((n) => n.path),
    port: (d) => d.outputs.map((o) => `${o.path} of ${o.fields.length} numbers`),
    wire: (d) => d.wires.map((w) => `${d.outputs[w.from].path} → ${d.nodes[w.node]?.path}.${w.input}${w.delay ? `, delayed ${w.delay}` : ''}`),
  };
  for (const [kind, names] of Object.entries(kinds)) {
    const added = missing(names(recorded), names(other)), lacking = missing(names(other), names(recorded));
    if (added) return `it has the ${kind} ${added}, which ${other.name} does not have`;
    if (lacking) return `it does not have the ${kind} ${lacking} of ${other.name}`;
  }
  return '';
}
