// Reads plain CDR, little endian: numbers are aligned to their size, counted from behind the four bytes of the head.
export class CdrReader {
  constructor(bytes) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset + 4, bytes.byteLength - 4);
    this.at = 0;
  }
  get isOver() { return this.at + 4 > this.view.byteLength; }
  skip(size) {
    const at = Math.ceil(this.at / size) * size;
    this.at = at + size;
    return at;
  }
  count() { return this.view.getUint32(this.skip(4), true); }
  integer() { return Number(this.view.getBigInt64(this.skip(8), true)); }
  number() { return this.view.getFloat64(this.skip(8), true); }
  numbers(count) { return Array.from({ length: count }, () => this.number()); }
  text() {
    const size = this.count(), from = this.view.byteOffset + this.at;
    this.at += size;
    return new TextDecoder().decode(new Uint8Array(this.view.buffer, from, size - 1));
  }
}
