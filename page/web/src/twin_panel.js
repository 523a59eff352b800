// The live twin on the page: begun and ended by a button, its program from the door or from a file.
import { twinText } from './twin.js';

const $ = (id) => document.getElementById(id);

export class TwinPanel {
  constructor(door, worker) {
    Object.assign(this, { door, worker, isRunning: false, told: null });
    worker.onmessage = ({ data }) => this.show(data);
    $('twin-run').addEventListener('click', () => (this.isRunning ? this.stop() : this.begin()));
    $('twin-file').addEventListener('change', async () => {
      const [file] = $('twin-file').files;
      if (file) this.begin(await file.arrayBuffer());
      $('twin-file').value = '';
    });
  }
  begin(code) {
    if (!this.door.isConnected) return this.show({ state: 'unknown', beats: 0, why: 'there is no connection to the program' });
    const { url, token } = this.door;
    this.isRunning = true;
    this.worker.postMessage({ url, protocols: ['foxglove.websocket.v1', ...(token ? [`cca.token.${token}`] : [])], code });
  }
  stop() {
    this.isRunning = false;
    this.worker.postMessage({});
    this.buttons();
    this.report('ended', '');
    $('twin').textContent = `${$('twin').textContent.replace(/ \(ended here\)$/, '')} (ended here)`;
  }
  show(told) {
    this.told = told;
    if (told.state === 'unknown' || told.state === 'differs') this.isRunning = false;
    const text = twinText(told);
    if ($('twin').textContent !== text) $('twin').textContent = text;
    $('twin').dataset.state = told.state;
    this.buttons();
    this.report(told.state, text);
  }
  // So others that look at the program, in a terminal too, see what the twin finds: each new finding, and twice a second.
  report(state, text) {
    const now = performance.now();
    if (!this.door.isConnected || !this.door.rights.mayChange || state === 'begins' || (state === this.reported && now - this.reportedAt < 500)) return;
    Object.assign(this, { reported: state, reportedAt: now });
    this.door.send({ op: 'cca.twin', says: text });
  }
  buttons() {
    const text = this.isRunning ? '■ end the twin' : '▶ run the twin';
    if ($('twin-run').textContent !== text) $('twin-run').textContent = text;
    $('twin-run').setAttribute('aria-pressed', String(this.isRunning));
  }
}
