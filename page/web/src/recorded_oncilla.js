// An Oncilla in a recording: drawn from its joint angles and its orientation, with the loads on its feet and
// where the commands put them.
import { poseCount } from './live.js';
import { about, product, turned } from './rotation.js';

const axesOf = (recording, output) => recording.description.outputs[output].fields.map((f) => f.name);
const axisAt = (axes, leg, joint) => axes.findIndex((name) => name.includes(leg.replace(' ', '_')) && name.includes(joint));
const isOncilla = (shown, axes) => shown.points.every((leg) => axisAt(axes, leg, 'hip') >= 0 && axisAt(axes, leg, 'knee') >= 0);

export class RecordedOncilla {
  // `shown`: how a live page draws an Oncilla. Null: the recording has none.
  static in(recording, shown) {
    if (shown?.kind !== 'oncilla') return null;
    const measured = recording.description.outputs.findIndex((o) => o.fields.length === 8 && o.path.startsWith('robot.angles'));
    const angles = measured >= 0 ? measured : recording.port('angles', 8);  // else the commands
    const orientation = recording.port('orientation', 4);
    if (angles < 0 || orientation < 0 || !isOncilla(shown, axesOf(recording, angles))) return null;
    return new RecordedOncilla(shown, { angles, orientation, loads: recording.port('foot_loads', 4), targets: recording.port('safe', 8) });
  }
  constructor(shown, ports) {
    this.shown = shown;
    this.ports = ports;
    this.poses = new Float64Array(poseCount(shown));
  }

  forces(recording) {
    const loads = this.ports.loads >= 0 ? recording.sample(this.ports.loads) : null;
    return loads ? loads.map((n) => [0, 0, n]) : [];
  }
  targets() {
    const at = 7 * this.shown.bodies.length;
    return this.shown.points.map((_, p) => this.poses.subarray(at + 6 * p + 3, at + 6 * p + 6));
  }

  // No sensor measures where the trunk is. So it stays in its place, as high as its lowest foot says.
  pose(recording) {
    const robot = this.shown;
    const angles = recording.sample(this.ports.angles), q = recording.sample(this.ports.orientation), targets = this.ports.targets >= 0 ? recording.sample(this.ports.targets) : null;
    if (!angles || !q) return;
    const axes = axesOf(recording, this.ports.angles);
    const legs = robot.points.map((name, leg) => {
      const hipAt = axisAt(axes, name, 'hip'), kneeAt = axisAt(axes, name, 'knee');
      const chain = (hip, knee) => {
        const [upper, middle, lower, toe] = robot.segments;
        const along = (p, angle, length) => [p[0] + length * Math.sin(angle), 0, p[2] - length * Math.cos(angle)];
        const k = along([0, 0, 0], hip, upper), a = along(k, hip - knee, middle), t = along(a, hip, lower), foot = along(t, hip, toe);
        const half = (p, r) => [(p[0] + r[0]) / 2, 0, (p[2] + r[2]) / 2];
        return { centres: [half([0, 0, 0], k), half(k, a), half(a, t), foot], angles: [hip, hip - knee, hip, hip], foot };
      };
      const place = (v) => turned(q, [v[0] + robot.hips[leg][0], v[1] + robot.hips[leg][1], v[2] + robot.hips[leg][2]]);
      const now = chain(angles[hipAt], angles[kneeAt]);
      return { centres: now.centres.map(place), angles: now.angles, foot: place(now.foot), target: targets ? place(chain(targets[hipAt], targets[kneeAt]).foot) : place(now.foot) };
    });
    const height = -Math.min(...legs.map((l) => l.foot[2])) + robot.bodies.at(-1).size[0];
    const up = (v) => [v[0], v[1], v[2] + height];
    this.poses.set([0, 0, height, q[3], q[0], q[1], q[2]], 0);
    legs.forEach((leg, i) => {
      leg.centres.forEach((centre, part) => {
        const [x, y, z, w] = product(q, about(1, -leg.angles[part]));
        this.poses.set([...up(centre), w, x, y, z], 7 * (1 + 4 * i + part));
      });
      this.poses.set([...up(leg.foot), ...up(leg.target)], 7 * robot.bodies.length + 6 * i);
    });
  }
}
