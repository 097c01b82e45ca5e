// The device's library in a page or in node: displays in memory, and text that
// the firmware's code draws into them.
//
//   const core = await Core.load(wasm);
//   core.open(font);
//   const oled = new Display('mono-pages', 128, 64);
//   core.draw(oled, {size: 16, filter: 'text', colour: 1}, 'Hello', 2, 20);

export const FORMATS = ['a8', 'grey8', 'grey4', 'grey2', 'mono-rows',
  'mono-pages', 'rgb565', 'rgb888', 'xrgb8888'];
export const KINDS = ['plain', 'dithered', 'sub-pixels'];
export const FILTERS = ['text', 'motion', 'paper-display', 'paper-body', 'area',
  'shadow', 'glow'];
export const FITS = ['none', 'heights', 'across'];
export const EFFECTS = ['none', 'stroke', 'bilevel', 'edge-contrast',
  'supersample'];
const STATUS = ['ok', 'bad magic', 'bad version', 'corrupt', 'no glyph',
  'buffer small', 'misaligned', 'unsupported', 'bad argument', 'beyond band'];
const BITS = [8, 8, 4, 2, 1, 1, 16, 24, 32];
const TEXT_BYTES = 4096;
const JOB_BYTES = 96;

/**
 * @typedef {object} Look
 * @property {number} size px to the em
 * @property {number} colour 0xRRGGBB, or a level of the display
 * @property {string} [filter]
 * @property {number} [weight] px, up to 1/2 with 'bilevel'; the reach of shadow and glow
 * @property {string} [fit]
 * @property {number} [levels]
 * @property {number} [angle] degrees, counter-clockwise
 * @property {string} [effect]
 * @property {number} [stroke] px
 */

/** The memory of a display. */
export class Display {
  /**
   * @param {string} format one of FORMATS
   * @param {number} width
   * @param {number} height
   * @param {string} [kind] one of KINDS
   */
  constructor(format, width, height, kind = 'plain') {
    const number = FORMATS.indexOf(format);
    const pages = format === 'mono-pages';
    const row = pages ? width : Math.ceil(width * BITS[number] / 8);
    this.format = number;
    this.bits = BITS[number];
    this.kind = KINDS.indexOf(kind);
    this.width = width;
    this.height = height;
    this.row = row;
    this.pages = pages;
    this.pixels = new Uint8Array(row * (pages ? Math.ceil(height / 8) : height));
  }

  /** What the memory holds of a pixel: a level, or a colour of the format. */
  word(x, y) {
    const {format, row, pixels} = this;
    const bits = BITS[format];
    if (this.pages) return pixels[(y >> 3) * row + x] >> (y & 7) & 1;
    const i = y * row + (x * bits >> 3);
    if (bits <= 8) return pixels[i] >> 8 - bits - (x * bits & 7) & (1 << bits) - 1;
    return bits === 16 ? pixels[i] | pixels[i + 1] << 8
      : bits === 24 ? pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]
                    : pixels[i + 2] << 16 | pixels[i + 1] << 8 | pixels[i];
  }

  /** A word as [red, green, blue], 0 to 255. @returns {number[]} */
  colour(word) {
    const bits = BITS[this.format];
    if (bits > 16) return [word >> 16, word >> 8 & 255, word & 255];
    if (bits === 16) {
      return [(word >> 11) * 255 / 31, (word >> 5 & 63) * 255 / 63, (word & 31) * 255 / 31]
        .map(Math.round);
    }
    const grey = Math.round(word * 255 / ((1 << bits) - 1));
    return [grey, grey, grey];
  }
}

const index = (names, name) => {
  const found = names.indexOf(name);
  if (found < 0) throw new Error(`'${name}' is none of ${names.join(', ')}`);
  return found;
};

/**
 * The members of web_job_t (web.h) from `width` on.
 * @param {Display} display
 * @param {Look} look
 */
export function jobWords(display, look, x, y) {
  const angle = (look.angle || 0) * Math.PI / 180;
  const turned = angle !== 0;
  return Int32Array.from([
    display.width, display.height, display.format, display.kind, look.colour,
    look.size * 64, Math.round(x * 64), Math.round(y * 64),
    turned ? Math.round(Math.cos(angle) * 2 ** 30) : 0,
    turned ? Math.round(Math.sin(angle) * 2 ** 30) : 0,
    index(FILTERS, look.filter || 'text'), Math.round((look.weight || 0) * 1024),
    turned ? 0 : index(FITS, look.fit || 'none'), look.levels || 0,
    index(EFFECTS, look.effect || 'none'), Math.round((look.stroke || 0) * 1024),
  ]);
}

export class Core {
  /** @param {BufferSource} wasm */
  static async load(wasm) {
    const {instance} = await WebAssembly.instantiate(wasm, {});
    return new Core(instance.exports);
  }

  constructor(code) {
    this.code = code;
    this.job = code.__heap_base.value + 15 & ~15;
    this.text = this.job + JOB_BYTES;
    this.font = this.text + TEXT_BYTES;
    this.fontBytes = 0;
  }

  /** The memory, with room for `bytes`. */
  memory(bytes) {
    const more = bytes - this.code.memory.buffer.byteLength;
    if (more > 0) this.code.memory.grow(Math.ceil(more / 65536));
    return new Uint8Array(this.code.memory.buffer);
  }

  /** Takes a font, and checks all of it. @param {Uint8Array} font */
  open(font) {
    this.memory(this.font + font.length).set(font, this.font);
    this.fontBytes = font.length;
    this.call('verify', new Display('a8', 1, 1), {size: 16, colour: 0}, '', 0, 0);
  }

  /** Writes a job, and calls the function that takes it. */
  run(name, display, look, text, x, y, ...more) {
    const bytes = new TextEncoder().encode(text).subarray(0, TEXT_BYTES);
    const at = this.font + this.fontBytes + 15 & ~15;
    const memory = this.memory(at + display.pixels.length);
    memory.set(bytes, this.text);
    memory.set(display.pixels, at);
    new Int32Array(memory.buffer, this.job, 22).set([this.font, this.fontBytes,
      this.text, bytes.length, at, display.pixels.length,
      ...jobWords(display, look, x, y)]);
    const result = this.code[`web_${name}`](this.job, ...more);
    display.pixels.set(memory.subarray(at, at + display.pixels.length));
    return result;
  }

  /** The same of a function that returns a status. */
  call(name, ...args) {
    const status = this.run(name, ...args);
    if (status) throw new Error(`the device's library says: ${STATUS[status]}`);
  }

  /** Draws text with the left end of its baseline at (x, y). */
  draw(display, look, text, x, y) {
    this.call('draw', display, look, text, x, y);
  }

  /** The advance of a text. [px] */
  advance(look, text) {
    const none = new Display('a8', 1, 1);
    return this.run('advance', none, look, text, 0, 0) / 64;
  }

  /** What bitmaps of all glyphs take at a size. [bytes] */
  bitmapBytes(size, bits) {
    const none = new Display('a8', 1, 1);
    return this.run('bitmap_bytes', none, {size, colour: 0}, '', 0, 0, bits);
  }

  get glyphs() {
    const none = new Display('a8', 1, 1);
    return this.run('glyph_count', none, {size: 16, colour: 0}, '', 0, 0);
  }

  /** Whether the font has a character. @param {string} char */
  has(char) {
    const none = new Display('a8', 1, 1);
    return this.run('has', none, {size: 16, colour: 0}, '', 0, 0, char.codePointAt(0)) === 1;
  }

  /** The sizes that the font was made for. [px to the em] */
  get sizes() {
    const none = new Display('a8', 1, 1);
    const both = this.run('sizes', none, {size: 16, colour: 0}, '', 0, 0);
    return {least: both & 0xffff, most: both >>> 16};
  }

  /** Draws the glyph between two characters, in {width, height, baseline}. */
  morph(display, look, box, from, to, progress, x, y) {
    this.call('morph', display, look, '', x, y, box.width, box.height,
      box.baseline, from.codePointAt(0), to.codePointAt(0),
      Math.round(progress * 65536));
  }

  /**
   * The field of a character, which the device's library makes of its outline:
   * `points` has for each of n x n points, row by row from the top, the distance
   * [u, Q10], and the corner and the side of its cell [u].
   */
  field(char, n) {
    const memory = {...new Display('a8', n, n), pixels: new Uint8Array(20 + 16 * n * n)};
    this.call('field', memory, {size: 16, colour: 0}, '', 0, 0, char.codePointAt(0));
    const [x, y, side, bytes, cells, ...points] = new Int32Array(memory.pixels.buffer);
    return {x, y, side, bytes, cells, points};
  }

  /** The distance at a point [u] of the glyph that field() was asked for. [u] */
  distance(x, y) {
    return this.code.web_distance(x * 65536, y * 65536) / 1024;
  }

  /** The points and hints of a character: see web_points in web.h. [u] */
  points(char) {
    const memory = new Display('a8', 256, 256);
    this.call('points', memory, {size: 16, colour: 0}, '', 0, 0, char.codePointAt(0));
    const numbers = new Int32Array(memory.pixels.buffer);
    let at = 0;
    const list = (width) => {
      const count = numbers[at++];
      return Array.from({length: count}, () => [...numbers.subarray(at, at += width)]);
    };
    return {points: list(3).map(([x, y, kind]) => ({x: x / 256, y: y / 256, kind})),
      zones: list(2), heights: list(3), stems: list(2)};
  }
}
