// A robot as its recording describes it: shapes from /robot_description (URDF), their places from /tf.
import { CdrReader } from './cdr.js';
import { about, product, turned } from './rotation.js';

const identity = { at: [0, 0, 0], turn: [0, 0, 0, 1] };

function behind(outer, inner) {
  const at = turned(outer.turn, inner.at);
  return { at: outer.at.map((x, i) => x + at[i]), turn: product(outer.turn, inner.turn) };
}
function fromAngles([roll, pitch, yaw]) {
  return product(about(2, yaw), product(about(1, pitch), about(0, roll)));
}

function transformsOf(message) {
  const from = new CdrReader(message);
  return Array.from({ length: from.count() }, () => {
    from.count(), from.count();  // the stamp
    return { parent: from.text(), child: from.text(), place: { at: from.numbers(3), turn: from.numbers(4) } };
  });
}

function shapesOf(urdf) {
  const xml = new DOMParser().parseFromString(urdf, 'text/xml');
  const numbers = (element, name, otherwise) => element?.getAttribute(name)?.trim().split(/\s+/).map(Number) ?? otherwise;
  const shapes = [];
  [...xml.querySelectorAll('robot > link')].forEach((link, number) => {
    for (const visual of link.querySelectorAll('visual')) {
      const origin = visual.querySelector('origin'), form = visual.querySelector('geometry > *');
      const size = { sphere: ['radius'], cylinder: ['radius', 'length'] }[form?.localName]?.flatMap((name) => numbers(form, name, [])) ?? numbers(form, 'size');
      if (!size) continue;  // a mesh: its file is not in the recording
      shapes.push({ shape: form.localName, size, part: number % 5, link: link.getAttribute('name'),
        place: { at: numbers(origin, 'xyz', identity.at), turn: fromAngles(numbers(origin, 'rpy', [0, 0, 0])) } });
    }
  });
  return shapes;
}

export class DescribedRobot {
  // Null: the recording describes none.
  static in(recording) {
    const [description, tf] = ['/robot_description', '/tf'].map((topic) => recording.channels.get(topic));
    if (!description?.messages.length || !tf?.messages.length) return null;
    const robot = new DescribedRobot(new CdrReader(description.messages[0]).text(), tf);
    return robot.shapes.length > 0 ? robot : null;
  }
  constructor(urdf, tf) {
    this.shapes = shapesOf(urdf);
    this.tf = tf;
    this.poses = new Float64Array(7 * this.shapes.length);
    this.put(tf.messages[0]);
    // Seen whole, as it stands at first.
    const centres = this.shapes.map((_, i) => this.poses.subarray(7 * i, 7 * i + 3));
    const ends = [0, 1, 2].map((i) => [Math.min(...centres.map((c) => c[i])), Math.max(...centres.map((c) => c[i]))]);
    const reach = Math.hypot(...ends.map(([low, high]) => high - low));
    this.shown = { kind: 'described', points: [], bodies: this.shapes, view: { at: ends.map(([low, high]) => (low + high) / 2), distance: 2 * reach + 0.3 } };
  }
  forces() { return []; }
  targets() { return []; }

  pose(recording) {
    this.put(this.tf.messages[Math.max(0, recording.index(this.tf, recording.beat))]);
  }
  // No sensor measures where a walking robot is: it stays in its place, with its lowest part on the floor.
  put(message) {
    const frames = this.frames = new Map();
    const links = new Set(this.shapes.map((s) => s.link));
    let isFloating = false;
    for (const { parent, child, place } of transformsOf(message)) {
      isFloating ||= frames.size === 0 && !links.has(parent);  // its base turns in the world
      frames.set(child, behind(frames.get(parent) ?? identity, place));
    }
    const placed = this.shapes.map(({ link, place }) => behind(frames.get(link) ?? identity, place));
    const lowest = Math.min(...placed.map(({ at }, i) => at[2] - (this.shapes[i].shape === 'sphere' ? this.shapes[i].size[0] : 0)));
    placed.forEach(({ at: [x, y, z], turn: [qx, qy, qz, qw] }, i) => this.poses.set([x, y, isFloating ? z - lowest : z, qw, qx, qy, qz], 7 * i));
  }
}
