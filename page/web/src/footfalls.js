// Footfalls: a row for each foot, filled while it is on the ground.

const seconds = 3;

export class Footfalls {
  constructor(canvas, text, source, legs) {
    Object.assign(this, { canvas, text, source, legs });
  }
  update(isDark) {
    const { canvas, source } = this;
    const ratio = Math.min(window.devicePixelRatio, 2);
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (width === 0) return;
    if (canvas.width !== Math.round(width * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const g = canvas.getContext('2d');
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    const left = 74, row = height / this.legs.length;
    const last = source.beat, first = Math.max(source.first, last - Math.round(seconds / source.period));
    const shown = Math.round(seconds / source.period);
    g.font = '12px system-ui';
    g.textBaseline = 'middle';
    const stance = [];
    this.legs.forEach((name, leg) => {
      const top = leg * row;
      g.fillStyle = isDark ? '#dfe5ea' : '#28323c';
      g.fillText(name, 0, top + row / 2);
      g.fillStyle = isDark ? '#2b333b' : '#dde3e9';
      g.fillRect(left, top + 3, width - left, row - 6);
      g.fillStyle = leg === 0 || leg === 3 ? (isDark ? '#56b4e9' : '#0072b2') : (isDark ? '#e69f00' : '#b25000');
      let down = 0, since = -1;
      const x = (k) => left + ((k - (last - shown)) / shown) * (width - left);
      for (let k = first; k <= last; ++k) {
        const is = k < last && source.contact(leg, k);
        if (is) ++down;
        if (is && since < 0) since = k;
        if (!is && since >= 0) {
          g.fillRect(x(since), top + 3, Math.max(1, x(k) - x(since)), row - 6);
          since = -1;
        }
      }
      stance.push(last > first ? down / (last - first) : 0);
    });
    this.stance = stance;
    this.text.textContent = stance.map((s, i) => `${this.legs[i]} ${(100 * s).toFixed(0)} %`).join(', ');
  }
}
