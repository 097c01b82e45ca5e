// What became of a font: bytes, glyphs, the worst pixel, bitmaps beside it,
// files to download, and the lines that make them again.
import {Display} from '../../port/web/inkcell.mjs';
import {$, button, bytesOf, row} from './dom.mjs';
import {cmakeOf, quoted} from './options.mjs';

/** @type {Record<string, string>} */
const NAMES = {hpp: 'C++ header', c: 'C source', h: 'C header', bin: 'binary'};
const LISTED = 8;
const WINDOW = 33;  // pixels around the worst one
const ZOOM = 10;

/** @typedef {import('../../port/web/inkcell.mjs').Core} Core */
/** @typedef {{px: number, x_u: number, y_u: number}} Pixel */

/**
 * Shows the worst pixel of a glyph as the device draws it, in a frame.
 * @param {Core} core @param {string} glyph @param {number} error @param {Pixel} pixel
 */
function showPixel(core, glyph, error, {px, x_u: x, y_u: y}) {
  const display = new Display('a8', WINDOW, WINDOW);
  const middle = (WINDOW - 1) / 2;
  core.draw(display, {size: px, filter: 'text', colour: 255}, glyph,
    middle + 0.5 - x * px / 1024, middle + 0.5 + y * px / 1024);
  const canvas = $('pixel');
  canvas.width = canvas.height = WINDOW * ZOOM;
  const context = canvas.getContext('2d');
  for (let i = 0; i < WINDOW * WINDOW; ++i) {
    const grey = 255 - display.pixels[i];
    context.fillStyle = `rgb(${grey} ${grey} ${grey})`;
    context.fillRect(i % WINDOW * ZOOM, Math.floor(i / WINDOW) * ZOOM, ZOOM, ZOOM);
  }
  context.lineWidth = 3;
  context.strokeStyle = '#d0021b';
  context.strokeRect(middle * ZOOM - 1.5, middle * ZOOM - 1.5, ZOOM + 3, ZOOM + 3);
  const drawn = display.pixels[middle * WINDOW + middle];
  $('pixel-text').textContent = `'${glyph}' at ${px} px. The device draws the framed pixel ` +
    `with ${drawn}/255. That differs by ${error.toFixed(1)}/255 from the exact distance to ` +
    'the outline in your file, and no pixel of this glyph differs more, at any whole size.';
  $('pixel-box').hidden = false;
}

/** @param {Core} core @param {any} report */
function showGlyphs(core, report) {
  /** @param {Record<string, number>} values */
  const most = (values) => Object.entries(values).sort(([, a], [, b]) => b - a)
    .slice(0, LISTED);
  $('largest').replaceChildren(...most(report.bytes_per_glyph).map(row));
  $('worst').replaceChildren(...most(report.error_per_glyph).map(([glyph, error]) => {
    const pixel = report.worst_pixel_per_glyph[glyph];
    if (!pixel || report.coding !== 'outline' || [...glyph].length !== 1) {
      return row([glyph, `${error.toFixed(1)}/255`]);
    }
    const show = button(`${error.toFixed(1)}/255 at ${pixel.px} px`, () => {
      showPixel(core, glyph, error, pixel);
      $('pixel-box').scrollIntoView({block: 'nearest'});
    });
    show.setAttribute('aria-label', `Show the worst pixel of ${glyph}`);
    return row([glyph, show]);
  }));
}

/** Bitmaps at the sizes that the reader names. @param {Core} core */
export function compareBitmaps(core) {
  const sizes = [...new Set(($('sizes').value.match(/\d+/g) || []).map(Number))]
    .filter((px) => px >= 4 && px <= 255).sort((a, b) => a - b);
  const bits = Number($('bits').value);
  const bitmaps = sizes.map((px) => core.bitmapBytes(px, bits));
  const sum = bitmaps.reduce((all, bytes) => all + bytes, 0);
  $('bitmaps').replaceChildren(...sizes.map((px, i) => row([`${px} px`, bitmaps[i]])),
    row(['all of them', sum]), row(['this font, any size', core.fontBytes]));
}

/** @param {Record<string, Uint8Array>} made @param {string} name */
function showDownloads(made, name) {
  $('downloads').replaceChildren(...Object.keys(NAMES).map((ending) => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([made[`font.${ending}`]]));
    link.download = `${name}.${ending}`;
    return button(`${NAMES[ending]}: ${link.download}`, () => link.click());
  }));
}

/**
 * Programs are in page.html, for a font FACE.
 * @param {any} shown @param {string} name @param {boolean} outlines
 */
function showProgram(shown, name, outlines) {
  shown.dataset.program ??= shown.textContent;
  let text = shown.dataset.program.replaceAll('FACE', name);
  if (!outlines) {
    text = text.replace(`fonts::${name}, `, `fonts::${name}, kFieldCoding, `)
      .replace('inkcell.hpp>\n', 'inkcell.hpp>\n#include <inkcell/field/draw.hpp>\n');
  }
  shown.textContent = text;
}

/** @param {string} name @param {string[]} args @param {boolean} outlines */
function showLines(name, args, outlines) {
  $('command').textContent = ['inkcell-fontgen', ...args, '--name', name, '--out',
    `${name}.hpp`].map(quoted).join(' ');
  $('cmake').textContent = cmakeOf(args, name);
  showProgram($('usage'), name, outlines);
  showProgram($('usage-c'), name, true);
  $('usage-c').parentElement.hidden = !outlines;
}

/**
 * @param {Core} core with the font open
 * @param {any} report the generator's
 * @param {Record<string, Uint8Array>} made
 * @param {string} name @param {string[]} args
 */
export function showReport(core, report, made, name, args) {
  const {total, ...parts} = report.bytes;
  $('parts').replaceChildren(...Object.entries({...parts, total})
    .filter(([, bytes]) => bytes > 0).map(row));
  showGlyphs(core, report);
  showDownloads(made, name);
  showLines(name, args, report.coding === 'outline');
  $('pixel-box').hidden = true;
  $('comparison').hidden = report.coding !== 'outline';
  if (report.coding === 'outline') compareBitmaps(core);
  $('result').hidden = false;
  $('status').textContent = `${bytesOf(total)} for every size. ` +
    `No pixel is off by more than ${report.error.max.toFixed(1)}/255.`;
}
