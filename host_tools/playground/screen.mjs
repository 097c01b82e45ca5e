// A display on a canvas: each of its pixels is a square of whole device pixels.
import {Display} from '../../port/web/inkcell.mjs';

const LINE = 1.17;  // of the size, from baseline to baseline
const ASCENT = 0.93;

/**
 * Colours are as the format has them.
 * @typedef {object} Kind
 * @property {string} format
 * @property {number} width
 * @property {number} height
 * @property {number} ink
 * @property {number} glow
 * @property {number} paper
 * @property {string} gap between pixels, in CSS
 * @property {number} [clockInk]
 * @property {(rgb: number[]) => number[]} [tint] how the panel shows a colour
 */

export class Screen {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Kind} kind
   */
  constructor(canvas, kind) {
    this.canvas = canvas;
    this.kind = kind;
    this.width = kind.width;
    this.height = kind.height;
    this.display = new Display(kind.format, kind.width, kind.height);
    this.small = new OffscreenCanvas(kind.width, kind.height);
    this.pixels = this.small.getContext('2d');
    // The bytes of each colour, as an image has them.
    this.palette = Uint32Array.from({length: 2 ** this.display.bits}, (_, word) => {
      const rgb = this.display.colour(word);
      const [red, green, blue] = kind.tint ? kind.tint(rgb) : rgb;
      return 0xff000000 | blue << 16 | green << 8 | red;
    });
  }

  clear() {
    const {display, kind: {format, paper}} = this;
    if (format === 'rgb565') {
      const word = paper >> 8 & 0xf800 | paper >> 5 & 0x7e0 | paper >> 3 & 31;
      for (let i = 0; i < display.pixels.length; i += 2) {
        display.pixels[i] = word & 255;
        display.pixels[i + 1] = word >> 8;
      }
    } else {
      display.pixels.fill(paper ? 255 : 0);
    }
  }

  /** What suits this display of a style that is meant for all. */
  fitted(look, colour) {
    const oneBit = this.kind.format === 'mono-pages';
    // Strokes that are bolder by more do not break.
    const bilevel = oneBit && look.fit !== 'none' && !look.angle &&
      look.effect === 'none' && look.weight <= 0.5;
    return {...look, colour, levels: oneBit ? 2 : 0,
      fit: oneBit && look.fit !== 'none' ? 'across' : look.fit,  // as its canvas does
      effect: bilevel ? 'bilevel' : look.effect};
  }

  /**
   * Draws text in the middle of the rows [top, bottom), over several lines, and
   * returns whether all of it is there.
   */
  text(core, look, text, top = 0, bottom = this.height) {
    const step = look.size * LINE;
    // The descent of the last line may be cut off, but not its letters.
    const most = Math.max(1, Math.floor((bottom - top + look.size * 0.4) / step));
    const all = wrapped(core, look, text, this.width - 4);
    const lines = all.slice(0, most);
    const middle = (top + bottom) / 2;
    // The lines are turned as one, about the middle.
    const turn = (look.angle || 0) * Math.PI / 180;
    const place = (line, i) => {
      const x = Math.max(look.angle ? -1e4 : 2 - this.width / 2,
        -core.advance({...look, angle: 0}, line) / 2);
      const y = (i - lines.length / 2) * step + look.size * ASCENT;
      return [this.width / 2 + x * Math.cos(turn) + y * Math.sin(turn),
        Math.round(middle - x * Math.sin(turn) + y * Math.cos(turn))];
    };
    if (look.glow) {
      this.display.kind = this.kind.format === 'rgb565' ? 0 : 1;
      const soft = this.fitted({...look, effect: 'none', filter: 'glow',
        weight: look.glow, fit: 'none'}, this.kind.glow);
      lines.forEach((line, i) =>
        core.draw(this.display, soft, line, ...place(line, i)));
      this.display.kind = 0;
      if (look.effect === 'stroke') {
        const body = this.fitted({...look, effect: 'none'}, this.kind.paper);
        lines.forEach((line, i) => core.draw(this.display, body, line, ...place(line, i)));
      }
    }
    const sharp = this.fitted(look, this.kind.ink);
    lines.forEach((line, i) =>
      core.draw(this.display, sharp, line, ...place(line, i)));
    return lines.length === all.length && lines.every((line) =>
      core.advance({...look, angle: 0}, line) <= this.width);
  }

  /** Copies the memory of the display to the canvas. */
  show() {
    const {canvas, display, small, pixels, width, height} = this;
    const image = new ImageData(width, height);
    const words = new Uint32Array(image.data.buffer);
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        words[y * width + x] = this.palette[display.word(x, y)];
      }
    }
    pixels?.putImageData(image, 0, 0);
    const zoom = this.zoom();
    if (canvas.width !== width * zoom) {
      canvas.width = width * zoom;
      canvas.height = height * zoom;
      canvas.style.width = `${width * zoom / devicePixelRatio}px`;
    }
    const context = canvas.getContext('2d');
    if (!context) return;
    context.imageSmoothingEnabled = false;
    context.drawImage(small, 0, 0, canvas.width, canvas.height);
    if (zoom > 1) this.drawGrid(context, zoom);
  }

  zoom() {
    const bezel = /** @type {HTMLElement} */ (this.canvas.parentElement);
    const room = (bezel.clientWidth - 2 * parseFloat(getComputedStyle(bezel).paddingLeft)) *
      devicePixelRatio;
    const most = Math.ceil(4 * devicePixelRatio);
    return Math.max(1, Math.min(most, Math.floor(room / this.width)));
  }

  drawGrid(context, zoom) {
    const {width, height} = this.canvas;
    const gap = Math.max(1, Math.round(zoom / 8));
    context.fillStyle = this.kind.gap;
    context.globalAlpha = zoom > 2 ? 1 : 0.15;
    for (let x = zoom - gap; x < width; x += zoom) context.fillRect(x, 0, gap, height);
    for (let y = zoom - gap; y < height; y += zoom) context.fillRect(0, y, width, gap);
    context.globalAlpha = 1;
  }
}

/** The lines of a text, broken at spaces. */
function wrapped(core, look, text, width) {
  const straight = {...look, angle: 0, colour: 0};
  const lines = [];
  for (const word of text.split(' ')) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && core.advance(straight, longer) <= width) {
      lines[lines.length - 1] = longer;
    } else {
      lines.push(word);
    }
  }
  return lines;
}
