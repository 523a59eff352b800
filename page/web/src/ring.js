// The last samples of a port, oldest first.
export class Ring {
  constructor(width, most) {
    Object.assign(this, { width, most, numbers: new Float64Array(64 * width), size: 0, begin: 0 });
  }
  get capacity() { return this.numbers.length / this.width; }
  clear() { this.size = this.begin = 0; }
  at(i) { return ((this.begin + i) % this.capacity) * this.width; }
  number(i, k) { return this.numbers[this.at(i) + k]; }
  row(i) { const at = this.at(i); return this.numbers.subarray(at, at + this.width); }
  // It grows while it is full, up to the most.
  push(from, start) {
    if (this.size === this.capacity && this.capacity < this.most) this.grow(Math.min(this.most, 2 * this.capacity));
    const at = this.at(this.size);
    for (let k = 0; k < this.width; ++k) this.numbers[at + k] = from[start + k];
    if (this.size < this.capacity) ++this.size;
    else this.begin = (this.begin + 1) % this.capacity;
  }
  grow(capacity) {
    const numbers = new Float64Array(capacity * this.width);
    for (let i = 0; i < this.size; ++i) numbers.set(this.row(i), i * this.width);
    Object.assign(this, { numbers, begin: 0 });
  }
  // The last whose number 0 is below; -1: none.
  before(beat) {
    let low = 0, high = this.size;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.number(middle, 0) < beat) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
}
