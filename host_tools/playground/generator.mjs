// inkcell-fontgen in workers, which share the glyphs of a font.

/**
 * @typedef {Record<string, Uint8Array>} Files by name
 * @typedef {{code: number, out: string, err: string, files: Files}} Result
 * @typedef {(done: number, count: number) => void} Progress
 */

/**
 * One run of the program.
 * @param {Worker} worker
 * @param {{module: WebAssembly.Module | null, files: Files, args: string[]}} job
 * @param {Progress} progress
 * @returns {Promise<Result>}
 */
const run = (worker, job, progress) => new Promise((resolve, reject) => {
  worker.onmessage = ({data}) => {
    if (data.count) progress(data.done, data.count);
    else resolve(data);
  };
  worker.onerror = (event) => reject(new Error(event.message));
  worker.postMessage(job);
});

export class Generator {
  /**
   * @param {() => Promise<Uint8Array>} program WebAssembly
   * @param {() => Promise<string>} script the address of worker.js
   * @param {number} count of workers
   */
  constructor(program, script, count) {
    this.program = program;
    this.script = script;
    this.count = count;
    /** @type {Worker[]} */
    this.workers = [];
    /** @type {Promise<WebAssembly.Module> | null} */
    this.module = null;
    /** @type {Files} glyphs of the last font, which need not be built again */
    this.built = {};
  }

  async start() {
    this.module ??= this.program().then((bytes) => WebAssembly.compile(bytes));
    const script = await this.script();
    await this.module;
    this.stop();
    this.workers = Array.from({length: this.count}, () => new Worker(script));
  }

  stop() {
    for (const worker of this.workers) worker.terminate();
    this.workers = [];
  }

  /**
   * Runs the program once.
   * @param {Files} files @param {string[]} args @param {Progress} progress
   * @param {Worker} [worker]
   */
  async run(files, args, progress, worker = this.workers[0]) {
    return run(worker, {module: await this.module, files, args}, progress);
  }

  /**
   * Makes a font: each worker builds parts of its glyphs, and one puts them
   * together. `first` is done before all.
   * @param {Files} files
   * @param {string[]} args
   * @param {string[]} outs the options that name the files to write
   * @param {(part: number) => void} progress 0 to 1
   * @param {() => Promise<void>} first
   */
  async convert(files, args, outs, progress, first) {
    if (!args.includes('--font') || args.includes('--budget') || args.includes('field')) {
      await first();
      return this.run(files, [...args, ...outs], (done, count) => progress(done / count));
    }
    const known = Object.fromEntries(Object.entries(this.built)
      .map(([name, bytes]) => [`known-${name}`, bytes]));
    const inputs = {...files, ...known};
    const built = Object.keys(known).flatMap((name) => ['--built', name]);
    const count = this.count === 1 ? 1 : 2 * this.count;
    const shares = Array(count).fill(0);
    /** @type {Files} */
    const parts = {};
    /** @type {Result | null} */
    let refused = null;
    let next = 0;
    /** @param {Worker} worker */
    const build = async (worker) => {
      while (next < count && !refused) {
        const number = next++;
        const result = await this.run(inputs, [...args, ...built, '--part',
          `${number}/${count}`, '--out', `${number}.glyphs`], (done, glyphs) => {
          shares[number] = done / glyphs;
          progress(shares.reduce((sum, share) => sum + share) / count);
        }, worker);
        if (result.code !== 0) refused ??= result;
        Object.assign(parts, result.files);
      }
    };
    const [one, ...others] = this.workers;
    await Promise.all([first().then(() => build(one)), ...others.map(build)]);
    if (refused) return refused;
    this.built = parts;
    progress(1);
    return this.run({...files, ...parts},
      [...args, ...Object.keys(parts).flatMap((name) => ['--built', name]), ...outs],
      () => {});
  }
}
