// Compares pictures of the device's library in WebAssembly with the host's, byte
// by byte: all pixel formats, filters, fits and effects; and that the module has
// no imports.
//
// Usage: node pictures.mjs CORE.wasm HOST_PROGRAM FONT FOLDER
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';

import {Core, Display, EFFECTS, FILTERS, FITS, FORMATS, jobWords, KINDS}
  from '../../port/web/inkcell.mjs';

const TEXT = 'Hamburg 0189 é!';
const [wasm, program, fontFile, folder] = process.argv.slice(2);
const code = readFileSync(wasm);
assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(code)), []);
const core = await Core.load(code);
core.open(readFileSync(fontFile));

const pictures = [];
const add = (format, kind, look, morph) => pictures.push({format, kind, morph,
  look: {size: 19, colour: format.startsWith('rgb') || format === 'xrgb8888'
    ? 0xf2a03c : format === 'grey8' ? 255 : format === 'grey4' ? 15
    : format === 'grey2' ? 3 : 1, filter: 'text', ...look}});
for (const format of FORMATS) {
  for (const kind of KINDS) add(format, kind, {});
  for (const fit of FITS) {
    for (const levels of [0, 2, 4]) add(format, 'plain', {fit, levels, size: 13});
  }
  for (const filter of FILTERS) {
    const weight = filter === 'shadow' || filter === 'glow' ? 2.5 : 0;
    add(format, 'plain', {filter, weight});
    add(format, 'plain', {filter, weight: weight || 0.3, angle: -11});
  }
  for (const effect of EFFECTS) {
    for (const size of [11, 37.5]) {
      add(format, 'plain', {effect, size, stroke: 1.25, fit: 'heights'});
    }
    add(format, 'plain', {effect, stroke: 1.25, fit: 'heights', weight: 0.4});
  }
  for (const progress of [0, 0.4, 1]) {
    add(format, 'plain', {size: 40}, {width: 30, height: 44, baseline: 38,
      from: '4', to: '5', progress});
  }
}
for (const char of ['g', '@', ' ']) pictures.push({field: char});
for (const char of ['g', 'H', ' ']) pictures.push({points: char});

const pattern = (display) => {
  display.pixels.forEach((_, i) => { display.pixels[i] = i * 37 >> 3; });
  return display;
};
const rows = pictures.flatMap(({format, kind, look, morph, field, points}) => {
  if (points) {
    return [...jobWords(new Display('a8', 256, 256), {size: 16, colour: 0}, 0, 0),
      256 * 256, -2, 0, 0, points.codePointAt(0), 0, 0];
  }
  if (field) {
    return [...jobWords(new Display('a8', 40, 40), {size: 16, colour: 0}, 0, 0),
      20 + 16 * 40 * 40, -1, 0, 0, field.codePointAt(0), 0, 0];
  }
  const display = new Display(format, 101, 48, kind);
  return [...jobWords(display, look, 2.3, 33.7), display.pixels.length,
    ...(morph ? [morph.width, morph.height, morph.baseline,
      morph.from.codePointAt(0), morph.to.codePointAt(0),
      Math.round(morph.progress * 65536)] : [0, 0, 0, 0, 0, 0])];
});
writeFileSync(`${folder}/jobs.bin`, Int32Array.from(rows));
execFileSync(program, [fontFile, `${folder}/jobs.bin`, `${folder}/pictures.bin`]);

const wanted = readFileSync(`${folder}/pictures.bin`);
let at = 0;
let drawn = 0;
for (const {format, kind, look, morph, field, points} of pictures) {
  if (points) {
    const status = wanted[at];
    if (status === 0) {
      const numbers = new Int32Array(
        Uint8Array.from(wanted.subarray(at + 1, at + 1 + 256 * 256)).buffer);
      const got = core.points(points);
      assert.deepEqual([got.points.length, ...got.points.flatMap(({x, y, kind: what}) =>
        [x * 256, y * 256, what]), got.zones.length, ...got.zones.flat(),
      got.heights.length, ...got.heights.flat(), got.stems.length, ...got.stems.flat()],
      [...numbers.subarray(0, 4 + 3 * numbers[0] + 2 * got.zones.length +
        3 * got.heights.length + 2 * got.stems.length)], `points of ${points}`);
      assert.equal(got.points[0].kind, 3);
      assert.ok(got.zones.length > 2 && got.heights.length > 0 && got.stems.length > 0);
      assert.ok(got.points.length > 10 && got.points.every(({x, y}) =>
        x > -50 && x < 1024 && y > -300 && y < 1024));
    } else {
      assert.throws(() => core.points(points), /no glyph/);
      assert.equal(points, ' ');
    }
    at += 1 + 256 * 256;
    drawn += 1;
    continue;
  }
  if (field) {
    const size = 20 + 16 * 40 * 40;
    if (wanted[at] === 0) {
      const {x, y, side, bytes, cells, points: samples} = core.field(field, 40);
      const got = Int32Array.of(x, y, side, bytes, cells, ...samples);
      assert.ok(wanted.subarray(at + 1, at + 1 + size).equals(new Uint8Array(got.buffer)),
        `field of ${field}`);
      for (let i = 0; i < 40 * 40; i += 77) {
        const [column, row] = [i % 40, 39 - Math.floor(i / 40)];
        assert.equal(core.distance(...[[x, column], [y, row]].map(([low, n]) =>
          low + Math.floor((2 * n + 1) * side * 32768 / 40) / 65536)), samples[4 * i] / 1024);
      }
      assert.ok(Math.max(...samples.filter((_, i) => i % 4 === 0)) > 20 << 10);
      assert.ok(cells > 20 && bytes > 500);
    } else {
      assert.throws(() => core.field(field, 40), /no glyph/);
      assert.equal(field, ' ');
    }
    at += 1 + size;
    drawn += 1;
    continue;
  }
  const display = pattern(new Display(format, 101, 48, kind));
  const before = display.pixels.slice();
  let status = 0;
  try {
    if (morph) {
      core.morph(display, look, morph, morph.from, morph.to, morph.progress, 2.3, 33.7);
    } else {
      core.draw(display, look, TEXT, 2.3, 33.7);
    }
  } catch {
    status = 1;
  }
  const what = JSON.stringify({format, kind, look, morph});
  assert.equal(status !== 0, wanted[at] !== 0, `status of ${what}`);
  assert.ok(wanted.subarray(at + 1, at + 1 + before.length).equals(display.pixels),
    `pixels of ${what}`);
  drawn += status === 0 && !before.every((byte, i) => byte === display.pixels[i]);
  at += 1 + before.length;
}
assert.equal(at, wanted.length);
assert.equal(drawn, pictures.length, 'pictures that show nothing');

// What a page asks besides.
assert.ok(Math.abs(core.advance({size: 32, colour: 0}, 'mm') -
  2 * core.advance({size: 32, colour: 0}, 'm')) < 0.1);
assert.ok(core.glyphs > 90);
assert.deepEqual([...'Az~é'].map((char) => core.has(char)), [true, true, true, false]);
assert.deepEqual(core.sizes, {least: 8, most: 64});
const bitmaps = [16, 32].map((size) => core.bitmapBytes(size, 4));
assert.ok(bitmaps[0] > 0 && bitmaps[1] > 3 * bitmaps[0]);
assert.throws(() => core.open(new Uint8Array(64)), /bad magic/);
console.log(`${pictures.length} pictures equal the host's; module of ` +
  `${code.length} bytes, no imports`);
