// The robot in 3D: its bodies, the forces on its points (feet, a hand), where these should be, and a push by
// the mouse.
import * as THREE from 'three';

const partColours = [0x9a3b2f, 0x2f6db3, 0xc7812a, 0x2f8f6a, 0x30343a, 0x9aa0a6];
const floorSize = 40;  // m
const pushPerMetre = 120;     // N for a drag of one metre

export class RobotView {
  constructor(canvas, source, onPush) {
    this.canvas = canvas;
    this.onPush = onPush;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.1, 30);
    this.camera.up.set(0, 0, 1);
    this.target = new THREE.Vector3();
    this.frames = 0;
    this.light();
    this.ground();
    this.show(source.description.robot);
    this.listen();
  }

  // Of another source.
  show(robot) {
    if (this.shown === robot) return;
    if (this.shown) this.scene.remove(...this.bodies, ...this.forces, ...this.targets, this.pushing);
    this.shown = robot;
    this.isWalking = robot.kind === 'oncilla';  // then the view goes along
    this.newtonsPerMetre = robot.newtonsPerMetre ?? 200;  // of a force's arrow
    this.angle = { azimuth: -1.05, height: 0.32, distance: 1.15, ...robot.view };
    this.aimSun();
    this.build(robot);
    this.isStale = true;
  }

  light() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8f99, 1.6));
    this.sun = new THREE.DirectionalLight(0xffffff, 2.2);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(512, 512);
    this.scene.add(this.sun, this.sun.target);
  }
  aimSun() {
    const wide = this.isWalking ? 0.6 : 1.2;
    Object.assign(this.sun.shadow.camera, { left: -wide, right: wide, top: wide, bottom: -wide, near: 0.1, far: 4 });
    this.sun.shadow.camera.updateProjectionMatrix();
  }

  ground() {
    this.floor = new THREE.Mesh(new THREE.PlaneGeometry(floorSize, floorSize), new THREE.MeshStandardMaterial({ roughness: 1 }));
    this.floor.receiveShadow = true;
    this.scene.add(this.floor);
  }

  // Squares of 0.2 m, so that one sees how fast it goes.
  squares(isDark) {
    const picture = Object.assign(document.createElement('canvas'), { width: 256, height: 256 });
    const g = picture.getContext('2d');
    g.fillStyle = isDark ? '#2a3138' : '#d6dde4';
    g.fillRect(0, 0, 256, 256);
    g.strokeStyle = isDark ? '#4a5560' : '#aab4be';
    g.lineWidth = 5;
    g.strokeRect(0, 0, 256, 256);
    const texture = new THREE.CanvasTexture(picture);
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
    texture.repeat.set(floorSize / 0.2, floorSize / 0.2);
    texture.anisotropy = this.renderer.capabilities.getMaxAnisotropy();
    return texture;
  }

  build(robot) {
    this.bodies = robot.bodies.map(({ shape, size, part }) => {
      let geometry;
      if (shape === 'box') geometry = new THREE.BoxGeometry(...size);
      else if (shape === 'sphere') geometry = new THREE.SphereGeometry(size[0], 20, 14);
      else if (shape === 'cylinder' && !this.isWalking) geometry = new THREE.CylinderGeometry(size[0], size[0], size[1], 32).rotateX(Math.PI / 2);
      else geometry = new THREE.CapsuleGeometry(size[0] * (this.isWalking ? 0.8 : 1), size[1], 8, 20).rotateX(Math.PI / 2);
      const body = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color: partColours[part], roughness: 0.55 }));
      body.castShadow = true;
      body.receiveShadow = !this.isWalking;
      this.scene.add(body);
      return body;
    });
    this.handles = this.bodies.filter((_, i) => !robot.bodies[i].stands);
    if (this.isWalking) this.addNose(robot);
    this.forces = robot.points.map(() => this.arrow(0xd55e00, this.isWalking ? 0.0045 : 0.008));
    if (!this.isWalking) for (const part of this.forces.flatMap((f) => f.children)) Object.assign(part, { renderOrder: 1 }).material.depthTest = false;  // it points into the arm
    this.targets = robot.points.map(() => {
      const ring = new THREE.Mesh(new THREE.TorusGeometry(this.isWalking ? 0.017 : 0.05, this.isWalking ? 0.0028 : 0.005, 8, 28), new THREE.MeshBasicMaterial({ color: 0x0072b2 }));
      this.scene.add(ring);
      return ring;
    });
    this.pushing = this.arrow(0xcc79a7, 0.007);
  }

  // Which way is forward.
  addNose(robot) {
    const nose = new THREE.Mesh(new THREE.ConeGeometry(0.022, 0.05, 16).rotateZ(-Math.PI / 2),
      new THREE.MeshStandardMaterial({ color: 0xf2c14e, roughness: 0.5 }));
    nose.position.x = robot.bodies[0].size[0] / 2 + 0.02;
    nose.castShadow = true;
    this.bodies[0].add(nose);
  }

  arrow(colour, radius = 0.0045) {
    const group = new THREE.Group();
    const material = new THREE.MeshBasicMaterial({ color: colour });
    const shaft = new THREE.Mesh(new THREE.CylinderGeometry(radius, radius, 1, 12).translate(0, 0.5, 0), material);
    const head = new THREE.Mesh(new THREE.ConeGeometry(radius * 2.6, radius * 6, 14), material);
    group.add(shaft, head);
    group.userData = { shaft, head };
    group.visible = false;
    this.scene.add(group);
    return group;
  }
  point(arrow, from, vector) {
    const length = vector.length();
    arrow.visible = length > 0.004;
    if (!arrow.visible) return;
    arrow.position.copy(from);
    arrow.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), vector.clone().divideScalar(length));
    arrow.userData.shaft.scale.y = length;
    arrow.userData.head.position.y = length;
  }

  theme(isDark) {
    this.isStale = true;
    const sky = isDark ? 0x14181d : 0xe9eef3;
    this.scene.background = new THREE.Color(sky);
    this.scene.fog = new THREE.Fog(sky, 2.2, 9);
    this.floor.material.map?.dispose();
    this.floor.material.map = this.squares(isDark);
    this.floor.material.needsUpdate = true;
  }

  // Drag the robot: a push. Drag elsewhere: turn the view. Wheel: distance.
  listen() {
    const ray = new THREE.Raycaster();
    const at = (event) => {
      const box = this.canvas.getBoundingClientRect();
      return new THREE.Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    };
    const onPlane = (event) => {
      ray.setFromCamera(at(event), this.camera);
      const hit = new THREE.Vector3();
      return ray.ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1), -this.pushedAt().z), hit) ? hit : null;
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      ray.setFromCamera(at(event), this.camera);
      this.drag = this.onPush && ray.intersectObjects(this.handles).length > 0 ? 'push' : 'turn';
      this.last = [event.clientX, event.clientY];
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (this.drag === 'turn') {
        this.turn((event.clientX - this.last[0]) * -0.008, (event.clientY - this.last[1]) * 0.006);
        this.last = [event.clientX, event.clientY];
      } else if (this.drag === 'push') {
        const hit = onPlane(event);
        if (!hit) return;
        const force = hit.sub(this.pushedAt()).setZ(0).multiplyScalar(pushPerMetre).clampLength(0, 60);
        this.push = force;
        this.isStale = true;
        this.onPush([force.x, force.y, 0]);
      }
    });
    const end = () => {
      if (this.drag === 'push') this.onPush([0, 0, 0]);
      this.drag = this.push = null;
      this.isStale = true;
    };
    this.canvas.addEventListener('pointerup', end);
    this.canvas.addEventListener('pointercancel', end);
    this.canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.001));
    }, { passive: false });
    this.canvas.addEventListener('keydown', (event) => {
      const turns = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08] };
      if (turns[event.key]) this.turn(...turns[event.key]);
      else if (event.key === '+' || event.key === '=') this.zoom(0.9);
      else if (event.key === '-') this.zoom(1.1);
      else return;
      event.preventDefault();
    });
  }
  turn(azimuth, height) {
    this.isStale = true;
    this.angle.azimuth += azimuth;
    this.angle.height = Math.min(1.5, Math.max(0.03, this.angle.height + height));
  }
  zoom(factor) {
    this.isStale = true;
    this.angle.distance = Math.min(6, Math.max(0.35, this.angle.distance * factor));
  }

  get isResized() { return Math.round(this.canvas.clientWidth * Math.min(window.devicePixelRatio, 2)) !== this.canvas.width; }

  // Where a push acts: on the trunk, or on the hand.
  pushedAt() { return this.isWalking ? this.bodies[0].position : this.place; }

  draw(poses, forces, targets) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.isStale = false;
    const ratio = Math.min(window.devicePixelRatio, 2);
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
    }
    this.bodies.forEach((body, i) => {
      const p = poses.subarray(7 * i, 7 * i + 7);
      body.position.set(p[0], p[1], p[2]);
      body.quaternion.set(p[4], p[5], p[6], p[3]);
    });
    const rest = 7 * this.bodies.length;
    this.forces.forEach((arrow, p) => {
      const place = new THREE.Vector3(...poses.subarray(rest + 6 * p, rest + 6 * p + 3));
      if (p === 0) this.place = place;
      this.point(arrow, place, new THREE.Vector3(...(forces[p] ?? [0, 0, 0])).divideScalar(this.newtonsPerMetre));
      this.targets[p].visible = Boolean(targets[p]);
      if (targets[p]) this.targets[p].position.set(...targets[p]);
      this.targets[p].lookAt(this.camera.position);
    });
    this.point(this.pushing, this.pushedAt(), this.push ? this.push.clone().divideScalar(pushPerMetre) : new THREE.Vector3());
    if (this.isWalking) this.target.set(this.bodies[0].position.x, this.bodies[0].position.y, 0.1);
    else this.target.set(...this.shown.view.at);
    const { azimuth, height: up, distance } = this.angle;
    this.camera.position.set(this.target.x + distance * Math.cos(up) * Math.cos(azimuth),
      this.target.y + distance * Math.cos(up) * Math.sin(azimuth), this.target.z + distance * Math.sin(up));
    this.camera.lookAt(this.target);
    this.sun.position.set(this.target.x + 0.5, this.target.y - 0.7, this.isWalking ? 1.6 : 2.4);
    this.sun.target.position.copy(this.target);
    // The ground has no end: it goes along, by whole squares.
    this.floor.position.set(Math.round(this.target.x / 0.2) * 0.2, Math.round(this.target.y / 0.2) * 0.2, 0);
    this.renderer.render(this.scene, this.camera);
    ++this.frames;
  }

  // The pixel at which a push acts, for tests.
  pushedOnScreen() {
    const p = this.pushedAt().clone().project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return [box.left + ((p.x + 1) / 2) * box.width, box.top + ((1 - p.y) / 2) * box.height];
  }
}
