// What became of a font: bytes, glyphs, the worst pixel, bitmaps beside it,
// files to download, and the lines that make them again.
import {Display} from '../../port/web/inkcell.mjs';
import {$, button, row} from './dom.mjs';
import {cmakeOf, quoted} from './options.mjs';
import {cmakeListsOf, cOf, cppOf, sampleOf} from './program.mjs';

/** @type {Record<string, string>} */
const NAMES = {hpp: 'C++ header', c: 'C source', h: 'C header', bin: 'binary'};
const LISTED = 8;
const REACH = 48;  // of the picture of the worst pixel, to each side [px]
const PICTURE = 330;  // its size on the screen, about [px]
const ICON = 32;  // the size of icons in their table [px]

/** @typedef {import('../../port/web/inkcell.mjs').Core} Core */
/** @typedef {{px: number, x_u: number, y_u: number}} Pixel */

/**
 * Shows the worst pixel of a glyph as the device draws it, in a frame.
 * @param {Core} core @param {string} glyph @param {string} called
 * @param {number} error @param {Pixel} pixel
 */
function showPixel(core, glyph, called, error, {px, x_u: x, y_u: y}) {
  const side = 2 * REACH + 1;
  const display = new Display('a8', side, side);
  core.draw(display, {size: px, filter: 'text', colour: 255}, glyph,
    REACH + 0.5 - x * px / 1024, REACH + 0.5 + y * px / 1024);
  // The ink and this pixel, and one row and column around them.
  let [left, top, right, bottom] = [REACH, REACH, REACH, REACH];
  display.pixels.forEach((level, i) => {
    if (!level) return;
    const [column, row] = [i % side, Math.floor(i / side)];
    [left, right] = [Math.min(left, column), Math.max(right, column)];
    [top, bottom] = [Math.min(top, row), Math.max(bottom, row)];
  });
  const [width, height] = [right - left + 3, bottom - top + 3];
  const zoom = Math.max(3, Math.floor(PICTURE / Math.max(width, height)));
  const canvas = $('pixel');
  canvas.width = width * zoom;
  canvas.height = height * zoom;
  const context = canvas.getContext('2d');
  for (let i = 0; i < width * height; ++i) {
    const [column, row] = [i % width, Math.floor(i / width)];
    const grey = 255 - (display.pixels[(top - 1 + row) * side + left - 1 + column] ?? 0);
    context.fillStyle = `rgb(${grey} ${grey} ${grey})`;
    context.fillRect(column * zoom, row * zoom, zoom, zoom);
  }
  context.lineWidth = 3;
  context.strokeStyle = '#d0021b';
  context.strokeRect((REACH - left + 1) * zoom - 1.5, (REACH - top + 1) * zoom - 1.5,
    zoom + 3, zoom + 3);
  const drawn = display.pixels[REACH * side + REACH];
  $('pixel-text').textContent = `${called} at ${px} px. The device draws the framed pixel ` +
    `with ${drawn}/255. That differs by ${error.toFixed(1)}/255 from what the exact ` +
    'distance to the outline in your file gives, and no pixel of this glyph differs more, at ' +
    'any whole size.';
  $('pixel-box').hidden = false;
}

/** What a glyph is called here: icons by their files. @param {any} report */
const namesOf = (report) => {
  const icons = Object.fromEntries(Object.entries(report.icons ?? {})
    .map(([name, code]) => [String.fromCodePoint(code), name]));
  return (/** @type {string} */ glyph) => icons[glyph] ?? glyph;
};

/** @param {Core} core @param {any} report */
function showGlyphs(core, report) {
  const called = namesOf(report);
  /** @param {Record<string, number>} values */
  const most = (values) => Object.entries(values).sort(([, a], [, b]) => b - a)
    .slice(0, LISTED);
  $('largest').replaceChildren(...most(report.bytes_per_glyph).map(([glyph, bytes]) =>
    row([called(glyph), bytes])));
  $('worst').replaceChildren(...most(report.error_per_glyph).map(([glyph, error]) => {
    const pixel = report.worst_pixel_per_glyph[glyph];
    if (!pixel || report.coding !== 'outline' || [...glyph].length !== 1) {
      return row([called(glyph), `${error.toFixed(1)}/255`]);
    }
    const show = button(`${error.toFixed(1)}/255 at ${pixel.px} px`, () => {
      showPixel(core, glyph, called(glyph), error, pixel);
      $('pixel-box').scrollIntoView({block: 'nearest'});
    });
    show.setAttribute('aria-label', `Show the worst pixel of ${called(glyph)}`);
    return row([called(glyph), show]);
  }));
}

/** Icons, and what they are called in programs. @param {Core} core @param {any} report */
function showIcons(core, report, name) {
  $('icons').hidden = !report.icons || report.coding !== 'outline';
  if ($('icons').hidden) return;
  $('icon-list').replaceChildren(...Object.entries(report.icons).map(([icon, code]) => {
    const char = String.fromCodePoint(code);
    const display = new Display('a8', ICON * 2, ICON * 2);
    const look = {size: ICON, colour: 255};
    core.draw(display, look, char, (ICON * 2 - core.advance(look, char)) / 2, ICON * 1.4);
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = ICON * 2;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', icon);
    const image = new ImageData(ICON * 2, ICON * 2);
    const words = new Uint32Array(image.data.buffer);
    display.pixels.forEach((level, i) => { words[i] = 0xff000000 | 0x10101 * (255 - level); });
    canvas.getContext('2d')?.putImageData(image, 0, 0);
    const names = document.createElement('code');
    names.textContent = `fonts::${name}_icons::k${icon} ${name}_icons_${icon}`;
    return row([icon, canvas, `U+${code.toString(16).toUpperCase()}`, names]);
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
    row(['all of them', sum]), row(['this font', core.fontBytes]));
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
 * @param {string} name @param {string[]} args
 * @param {import('./program.mjs').Sample} sample
 */
function showLines(name, args, sample) {
  $('command').textContent = ['inkcell-fontgen', ...args, '--name', name, '--out',
    `${name}.hpp`].map(quoted).join(' ');
  $('cmake').textContent = cmakeOf(args, name);
  $('made-header').textContent = `<fonts/${name}.hpp>`;
  $('lists').textContent = cmakeListsOf(sample, false);
  $('usage').textContent = cppOf(sample);
  // The interface for C opens fields by another function.
  $('in-c').hidden = !sample.outlines;
  $('lists-c').textContent = cmakeListsOf(sample, true);
  $('usage-c').textContent = cOf(sample);
}

/** @typedef {import('../../port/web/inkcell.mjs').Look} Look */
/** @type {(text: string, look: Look) => void} */
let writeLines = () => {};

/**
 * Writes the programs anew, for what the displays show now; the font is open.
 * @param {string} text @param {Look} look
 */
export function refreshLines(text, look) {
  writeLines(text, look);
}

/**
 * @param {Core} core with the font open
 * @param {any} report the generator's
 * @param {Record<string, Uint8Array>} made
 * @param {string} name @param {string[]} args
 * @param {string} text on the displays, in the style `look`
 * @param {import('../../port/web/inkcell.mjs').Look} look
 */
export function showReport(core, report, made, name, args, text, look) {
  const {total, ...parts} = report.bytes;
  $('parts').replaceChildren(...Object.entries({...parts, total})
    .filter(([, bytes]) => bytes > 0).map(row));
  showGlyphs(core, report);
  showDownloads(made, name);
  showIcons(core, report, name);
  writeLines = (newText, newLook) =>
    showLines(name, args, sampleOf(core, report, name, newText, newLook));
  writeLines(text, look);
  $('pixel-box').hidden = true;
  $('comparison').hidden = report.coding !== 'outline';
  if (report.coding === 'outline') compareBitmaps(core);
  $('result').hidden = false;
}
