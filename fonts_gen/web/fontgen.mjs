// inkcell-fontgen in a worker of a page or in node: files in, files out, or in
// node on the disk.

/**
 * Runs the program once, with the arguments of its command line.
 *
 * @param {Function} factory InkcellFontgen of inkcell-fontgen.js
 * @param {WebAssembly.Module} module compiled inkcell-fontgen.wasm
 * @param {Record<string, Uint8Array>} files what it may read, by name
 * @param {string[]} args
 * @param {(done: number, count: number) => void} [progress] glyphs
 * @param {{mounts: Record<string, string>, at: string}} [disk] folders of the
 *   disk by the place where the program finds them, and where it works
 * @returns {Promise<{code: number, out: string, err: string,
 *   files: Record<string, Uint8Array>}>} the files that it has written
 */
export async function runFontgen(factory, module, files, args, progress, disk) {
  const texts = {out: '', err: ''};
  const program = await factory({
    thisProgram: 'inkcell-fontgen',
    quit: (_, error) => { throw error; },  // node's would end the process
    print: (line) => { texts.out += `${line}\n`; },
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(module, imports).then((instance) => done(instance));
      return {};
    },
  });
  const {FS, NODEFS} = program;
  // Standard error is a terminal: a bar of progress begins with \r.
  let line = '';
  FS.getStream(2).tty.ops = {
    put_char(_, byte) {
      line += String.fromCharCode(byte & 255);
      const bar = /^\r\[.*\] (\d+)\/(\d+) .*\x1b\[K$/.exec(line);
      if (bar) {
        progress?.(Number(bar[1]), Number(bar[2]));
        line = '';
      } else if (line.endsWith('\r\x1b[K')) {
        line = line.slice(0, -4);
      } else if (byte === 10) {
        texts.err += new TextDecoder().decode(
          Uint8Array.from(line, (char) => char.charCodeAt(0)));
        line = '';
      }
    },
    flush() {},  // as emscripten 3 calls it
    fsync() {},
  };
  FS.mkdir('/files');
  for (const [place, root] of Object.entries(disk?.mounts ?? {})) {
    FS.mkdirTree(place);
    FS.mount(NODEFS, {root}, place);
  }
  FS.chdir(disk?.at ?? '/files');
  for (const [name, bytes] of Object.entries(files)) FS.writeFile(`/files/${name}`, bytes);
  let code = 1;
  try {
    code = program.callMain(['--threads', '1', ...args]);
  } catch (thrown) {
    const error = /** @type {any} */ (thrown);
    if (error?.name !== 'ExitStatus') throw error;
    code = error.status;
  }
  /** @type {Record<string, Uint8Array>} */
  const written = {};
  for (const name of FS.readdir('/files')) {
    if (!(name in files) && !/^\.+$/.test(name)) written[name] = FS.readFile(`/files/${name}`);
  }
  return {code, ...texts, files: written};
}
