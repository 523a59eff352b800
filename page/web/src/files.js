// The files that a program reads, as the system calls of WASI: only reading, of files that the page has with it.
// What is not here fails, as on a computer without it.

const success = 0, badDescriptor = 8, noEntry = 44, notSupported = 58;
const root = 3, regularFile = 4, directory = 3, mayAll = 0x1fffffffn;

export function fileSystem(files, memory) {
  const open = new Map();
  let next = root + 1;
  const view = () => new DataView(memory().buffer);
  const bytes = (at, size) => new Uint8Array(memory().buffer, at, size);
  const text = (at, size) => new TextDecoder().decode(bytes(at, size));
  const calls = {
    fd_prestat_get(fd, to) {
      if (fd !== root) return badDescriptor;
      view().setUint32(to, 0, true);
      view().setUint32(to + 4, 1, true);
      return success;
    },
    fd_prestat_dir_name(fd, to) {
      bytes(to, 1)[0] = '.'.charCodeAt(0);
      return success;
    },
    fd_fdstat_get(fd, to) {
      if (fd !== root && !open.has(fd)) return badDescriptor;
      bytes(to, 24).fill(0);
      view().setUint8(to, fd === root ? directory : regularFile);
      view().setBigUint64(to + 8, mayAll, true);
      view().setBigUint64(to + 16, mayAll, true);
      return success;
    },
    path_open(fd, flags, path, size, how, rights, inheriting, fdFlags, to) {
      const content = files[text(path, size).replace(/^\.\//, '')];
      if (!content || how !== 0) return noEntry;
      open.set(next, { content, at: 0 });
      view().setUint32(to, next++, true);
      return success;
    },
    fd_read(fd, vectors, count, to) {
      const file = open.get(fd);
      if (!file) return badDescriptor;
      let done = 0;
      for (let i = 0; i < count; ++i) {
        const at = view().getUint32(vectors + 8 * i, true), size = view().getUint32(vectors + 8 * i + 4, true);
        const part = file.content.subarray(file.at, file.at + size);
        bytes(at, part.length).set(part);
        file.at += part.length;
        done += part.length;
      }
      view().setUint32(to, done, true);
      return success;
    },
    fd_seek(fd, offset, whence, to) {
      const file = open.get(fd);
      if (!file) return badDescriptor;
      file.at = Number(offset) + [0, file.at, file.content.length][whence];
      view().setBigUint64(to, BigInt(file.at), true);
      return success;
    },
    fd_close(fd) { return open.delete(fd) ? success : badDescriptor; },
    proc_exit() { throw new Error('the program has ended'); },
  };
  return new Proxy(calls, { get: (all, name) => all[name] ?? ((fd) => (fd === root ? notSupported : badDescriptor)) });
}
