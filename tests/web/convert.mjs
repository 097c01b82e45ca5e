// Tests conversions of the page in headless Chromium against the host's program.
//
// Usage: node convert.mjs PAGE.html SITE_FOLDER NPM_FOLDER HOST_FONTGEN FOLDER
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {basename, dirname} from 'node:path';

import {Core, Display} from '../../port/web/inkcell.mjs';
import {convert, converted, download, launch, number, problems, shown, text}
  from './browser.mjs';

const [file, site, npm, host, folder] = process.argv.slice(2);
const FONTS = '/usr/share/fonts/truetype/dejavu';
const ROOT = new URL('../../', import.meta.url).pathname;
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
const {browser, open} = await launch(npm, `file://${file}`);
const core = await Core.load(readFileSync(`${site}/core.wasm`));

/** The font that the shown command makes here, of files in `folder`. */
async function native(page, more = '') {
  const line = await text(page, 'command');
  execFileSync('sh', ['-c', `${line.replace('inkcell-fontgen', host)} --out font.bin ` +
    `--quiet ${more}`], {cwd: folder, stdio: ['ignore', 'ignore', 'ignore']});
  return readFileSync(`${folder}/font.bin`);
}
async function compare(page, what) {
  const {path} = await download(page, 'bin');
  const wanted = await native(page);
  assert.ok(readFileSync(path).equals(wanted), what);
  console.log(`${what}: ${wanted.length} bytes equal`);
  return wanted;
}
/** A file of `folder`, copied if it lies elsewhere. */
function local(path) {
  writeFileSync(`${folder}/${basename(path)}`, readFileSync(path));
  return `${folder}/${basename(path)}`;
}
async function again(page) {
  const before = await page.getAttribute('#result', 'data-count') ?? '0';
  await page.click('#go');
  await converted(page, before);
}

// ASCII by one worker and by several.
for (const cores of [1, 2, 4]) {
  const page = await open({cores});
  // All that it says of the time.
  await page.evaluate(() => {
    window.times = [];
    new MutationObserver(() => times.push(document.getElementById('passed').textContent))
      .observe(document.getElementById('passed'), {childList: true});
  });
  await convert(page, local(`${FONTS}/DejaVuSans.ttf`));
  const times = await page.evaluate('times');
  assert.match(times[0], /^\d+ s$/);
  assert.ok(times.some((said) => /^\d+ s, about \d+ s left$/.test(said)), `${times}`);
  assert.equal(times.at(-1), '');
  console.log(`${cores} workers: ${await text(page, 'status')}`);
  assert.match(await text(page, 'status'), new RegExp(`by ${cores} worker`));
  await compare(page, `ASCII, ${cores} workers`);
  await page.close();
}

// The whole way by the lines that are shown.
const page = await open({viewport: {width: 1280, height: 900}, cores: 2});
await page.fill('#text', 'Größe 12');
await convert(page, local(`${FONTS}/DejaVuSerif.ttf`));
assert.match(await text(page, 'command'),
  /^inkcell-fontgen .* --symbols 'öß' --name DejaVuSerif --out DejaVuSerif\.hpp$/);
await native(page, '--out DejaVuSerif.c --header DejaVuSerif.h --out DejaVuSerif.bin');
for (const ending of ['hpp', 'c', 'h', 'bin']) {
  const {path, name} = await download(page, ending);
  assert.equal(name, `DejaVuSerif.${ending}`);
  assert.ok(readFileSync(path).equals(readFileSync(`${folder}/${name}`)), name);
}
assert.equal(await text(page, 'cmake'), 'inkcell_add_font(app NAME DejaVuSerif FONT ' +
  'DejaVuSerif.ttf CHARS 0x20-0x7E SYMBOLS öß)');
const includes = [...['core', 'core/field', 'core/layout', 'core/cache', 'port/pixel']
  .map((part) => `${ROOT}${part}`), `${dirname(file)}/core/port/c`]
  .flatMap((part) => ['-I', `${part}/include`]);
const compile = (program, language, input) => execFileSync(program,
  ['-fsyntax-only', '-Wall', '-Werror', '-I', folder, ...includes, '-x', language, '-'],
  {input, encoding: 'utf8'});

// Projects of what the page offers: the library, the font, CMakeLists.txt and the
// program, in C++ and in C. They draw what the displays show.
for (const suffix of ['', '-c']) {
  mkdirSync(`${folder}/project${suffix}`);
  execFileSync('tar', ['-xf', `${dirname(file)}/${await page.getAttribute('#result a', 'href')}`],
    {cwd: `${folder}/project${suffix}`});
}
/** The rows that a program draws, as a display. */
async function drawnBy(suffix, source, ...fonts) {
  const place = `${folder}/project${suffix}`;
  for (const name of fonts) writeFileSync(`${place}/${name}`, readFileSync(`${folder}/${name}`));
  writeFileSync(`${place}/CMakeLists.txt`, await text(page, `lists${suffix}`));
  const program = await text(page, `usage${suffix}`);
  // Its own main() shows characters.
  writeFileSync(`${place}/${source}`, `#define main show\n${program}
#undef main
int main(int count, char **words) {
  if (count > 1) return show();
  if ((int)hello() != 0) return 1;
  fwrite(rows, 1, sizeof rows, stdout);
  return words == 0;
}
`);
  execFileSync('cmake', ['-S', '.', '-B', 'build'], {cwd: place});
  execFileSync('cmake', ['--build', 'build', '--target', 'app'], {cwd: place});
  const pixels = execFileSync(`${place}/build/app`);
  const lines = execFileSync(`${place}/build/app`, ['show'], {encoding: 'utf8'}).split('\n');
  assert.equal(lines.length, Math.ceil(pixels.length / 480 / 2) + 1);
  lines.slice(0, -1).forEach((line, i) => assert.equal(line,
    Array.from({length: 120}, (_, x) => ' .:-=+*#'[pixels[2 * (480 * i + x) + 1] & 7]).join('')));
  const display = new Display('rgb565', 240, pixels.length / 480);
  display.pixels.set(pixels);
  return display;
}
/** Both programs, against one drawing after another of the library in node. */
async function compareDrawn(what, words, x, y, ...looks) {
  const cpp = await drawnBy('', 'main.cpp', 'DejaVuSerif.hpp');
  const c = await drawnBy('-c', 'main.c', 'DejaVuSerif.c', 'DejaVuSerif.h');
  const wanted = new Display('rgb565', 240, cpp.height);
  for (const look of looks) core.draw(wanted, look, words, x, y);
  assert.ok(wanted.pixels.some((byte) => byte !== 0), what);
  assert.deepEqual(cpp.pixels, wanted.pixels, `${what} in C++`);
  assert.deepEqual(c.pixels, wanted.pixels, `${what} in C`);
}
core.open(readFileSync(`${folder}/DejaVuSerif.bin`));
const white = {size: 27, filter: 'text', colour: 0xffffff, fit: 'heights'};
await compareDrawn('the text', 'Größe 12', 4, 31, white);
await page.fill('#weight', '0.4');
await page.fill('#stroke', '1');
await page.fill('#glow', '2');
await again(page);
const bolder = {...white, weight: 0.4};
await compareDrawn('stroke and glow', 'Größe 12', 4, 31,
  {...white, filter: 'glow', weight: 2, fit: 'none', colour: 0xff5c18}, {...bolder, colour: 0},
  {...bolder, effect: 'stroke', stroke: 1});
await page.click('#plain');
await page.fill('#angle', '20');
// The programs follow the displays at once.
await page.selectOption('#filter', 'area');
assert.match(await text(page, 'usage'), /kFilterArea, direction/);
assert.equal(await text(page, 'made-header'), '<fonts/DejaVuSerif.hpp>');
await again(page);
assert.match(await text(page, 'usage'), /kFilterArea, direction/);
const [, left, top] = /\{(\d+), (\d+)\}, "/.exec(await text(page, 'usage'));
await compareDrawn('turned text', 'Größe 12', Number(left), Number(top),
  {...white, filter: 'area', angle: 20});
await page.click('#plain');
assert.equal(await number(page, 'font-bytes'), statSync(`${folder}/DejaVuSerif.bin`).size);

// The worst pixel, on demand, and bitmaps of sizes that the reader names.
await page.click('#worst tr:nth-child(2) button');
const [, glyph, px, drawn, error] =
  /^(.) at (\d+) px\. .* with (\d+)\/255\. That differs by ([\d.]+)\//
    .exec(await text(page, 'pixel-text'));
assert.ok(error > 10 && error < 16.5, error);
const {worst_pixel_per_glyph: pixels, error_per_glyph: errors} = (execFileSync('sh', ['-c',
  `${(await text(page, 'command')).replace('inkcell-fontgen', host)} --report r.json --quiet`],
{cwd: folder}), JSON.parse(readFileSync(`${folder}/r.json`)));
const worst = pixels[glyph];
assert.equal(worst.px, Number(px));
assert.equal(errors[glyph].toFixed(1), error);
const one = new Display('a8', 1, 1);
core.draw(one, {size: worst.px, filter: 'text', colour: 255}, glyph,
  0.5 - worst.x_u * worst.px / 1024, 0.5 + worst.y_u * worst.px / 1024);
assert.equal(one.pixels[0], Number(drawn));
assert.ok(await page.isVisible('#pixel'));
assert.ok(await page.evaluate(() => {
  const canvas = document.getElementById('pixel');
  const {width, height} = canvas;
  const context = canvas.getContext('2d');
  return [[0, 0, width, 1], [0, height - 1, width, 1], [0, 0, 1, height],
    [width - 1, 0, 1, height]].every(([...box]) =>
    context.getImageData(...box).data.every((level) => level === 255));
}), 'the glyph is cut off');
await page.fill('#sizes', '20, 28');
await page.selectOption('#bits', '1');
assert.deepEqual(await page.$$eval('#bitmaps td', (cells) =>
  cells.map((cell) => Number(cell.textContent.replace(/,/g, '')))),
[core.bitmapBytes(20, 1), core.bitmapBytes(28, 1),
  core.bitmapBytes(20, 1) + core.bitmapBytes(28, 1),
  statSync(`${folder}/DejaVuSerif.bin`).size]);
await page.screenshot({path: `${folder}/convert.png`, fullPage: true});

// Other settings: what was built before is used where it can be.
await page.uncheck('#hints');
await again(page);
await compare(page, 'without hints');
await page.uncheck('#ascii');
await page.uncheck('#mine');
await page.fill('#symbols', 'Hag永');
await again(page);
assert.match(await text(page, 'messages'), /U\+6C38/);
await compare(page, 'a character that is missing');
await page.fill('#symbols', '');
await page.check('#digits');
writeFileSync(`${folder}/main.c`, 'const char* s = "Ωm";  // not this: Ж\n');
writeFileSync(`${folder}/menu.txt`, 'Äü');
await convert(page, [`${folder}/main.c`, `${folder}/menu.txt`], 'sources');
assert.match(await text(page, 'command'), /--strings-from main\.c --text-file menu\.txt/);
assert.match(await text(page, 'cmake'), / TEXT_FILE menu\.txt\)$| STRINGS_FROM main\.c /);
await compare(page, 'sources and texts');
await page.selectOption('#precision', 'budget');
await page.fill('#budget', '2');
await again(page);
assert.ok((await compare(page, 'what fits in 2 KB')).length <= 2048);
await page.selectOption('#precision', '');
await page.selectOption('#coding', 'field');
await again(page);
assert.match(await text(page, 'usage'), /kFieldCoding/);
await native(page);
compile('g++', 'c++', await text(page, 'usage'));
await compare(page, 'a field');
await page.selectOption('#coding', 'outline');

// Sizes of the displays are the font's. A text of digits and no colon: no clock.
await page.uncheck('#digits');
await page.check('#mine');
await page.fill('#text', '23.5 °C');
await page.fill('#min', '30');
await page.fill('#max', '30');
await page.click('#no-sources');
await again(page);
assert.equal(await text(page, 'title-sizes'), '30 px.');
assert.match(await text(page, 'status'), /bytes for 30 px\. /);
await page.fill('#max', '48');
await again(page);
assert.equal(await text(page, 'title-sizes'), '30 to 48 px.');
assert.deepEqual(await page.evaluate(() => ['min', 'max', 'value'].map((name) =>
  document.getElementById('size')[name])), ['30', '48', '30']);
assert.match(await text(page, 'note'), /no clock/);
assert.match(await text(page, 'usage'), /style\(30_px,[^]* \{4, 34\}, "23.5 °C"\);/);
await page.fill('#text', '23 km');
assert.match(await text(page, 'note'), /lacks k m:/);
await page.fill('#min', '49');
assert.ok(!await page.evaluate(() => document.getElementById('options').checkValidity()));
await page.fill('#min', '8');
await page.uncheck('#mine');
await page.click('#go');
assert.match(await text(page, 'status'), /^Choose characters/);
await page.click('#built-in');
assert.ok(!await page.isVisible('#built-in'));
assert.match(await text(page, 'font-label'), /^DejaVu Sans, 95/);
assert.equal(await text(page, 'title-sizes'), 'Every size.');
await page.check('#mine');

// The link carries settings.
await page.fill('#max', '32');
await page.click('#convert-link');
const linked = await open({hash: await page.evaluate('location.hash')});
const settings = (which) => which.$$eval('[data-keep]', (all) =>
  all.map((c) => `${c.id} ${c.type === 'checkbox' ? c.checked : c.value}`));
assert.deepEqual(await settings(linked), await settings(page));
assert.equal(await linked.inputValue('#max'), '32');
assert.ok(!await linked.isChecked('#ascii'));
await linked.close();

// Containers: WOFF, WOFF2 with axes, a collection.
execFileSync('/usr/bin/python3', [`${ROOT}tests/web/make_fonts.py`, folder,
  `${FONTS}/DejaVuSans.ttf`]);
execFileSync('woff2_compress', ['variable.ttf'], {cwd: folder, stdio: 'ignore'});
await convert(page, `${folder}/sans.woff`);
await compare(page, 'WOFF');
await convert(page, `${folder}/variable.woff2`);
assert.deepEqual(await page.$$eval('#axes input', (all) => all.map((axis) =>
  [axis.id, axis.min, axis.max, axis.value])), [['axis-wght', '100', '900', '400']]);
await page.focus('#axis-wght');
await page.keyboard.press('End');
await again(page);
assert.match(await text(page, 'command'), /--axis wght=900/);
await compare(page, 'an axis of WOFF2');
await convert(page, `${folder}/both.ttc`);
assert.ok(await page.isVisible('#face'));
// The second has no name.
assert.equal(await page.textContent('#face'), '0: DejaVu Sans1');
await page.selectOption('#face', '1');
await again(page);
assert.match(await text(page, 'command'), /--face 1/);
await compare(page, 'the second face of a collection');

// Cancelled; refused, in the generator's words; icons alone.
await page.focus('#go');
await page.keyboard.press('Enter');
await page.focus('#cancel');
await page.keyboard.press('Enter');
assert.match(await text(page, 'status'), /^Cancelled; below is still \S[^;]*\.$/);
assert.doesNotMatch(await text(page, 'note'), /Your text in your font/);
assert.ok(await page.isEnabled('#go'));
const kept = await page.$$eval('#result', ([result]) => result.textContent);
await page.evaluate(() => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File(['no font'], 'broken.ttf'));
  document.body.dispatchEvent(new DragEvent('drop', {dataTransfer, bubbles: true}));
});
await page.waitForFunction(() =>
  document.getElementById('messages').textContent.startsWith('error: broken.ttf: '));
assert.match(await text(page, 'status'), /^broken\.ttf was refused; below is still \S[^;]*\.$/);
async function checkKept() {
  assert.ok(await page.isVisible('#result'), 'the last good result is gone');
  assert.equal(await page.$$eval('#result', ([result]) => result.textContent), kept);
  assert.equal((await download(page, 'bin')).name, 'both.bin');
}
await checkKept();
assert.equal(await text(page, 'chosen'), 'both.ttc');
assert.equal(await page.inputValue('#face'), '1');
// The refusal goes with the next file, and stays away when that is cancelled.
await page.setInputFiles('#files', local(`${FONTS}/DejaVuSans-Bold.ttf`));
await page.waitForSelector('#cancel');
assert.ok(!await page.isVisible('#messages'), await text(page, 'messages'));
assert.doesNotMatch(await text(page, 'status'), /refused/);
await page.click('#cancel');
assert.match(await text(page, 'status'), /^Cancelled; below is still \S/);
assert.equal(await text(page, 'messages'), '');
await checkKept();
writeFileSync(`${folder}/dot.svg`, '<svg xmlns="http://www.w3.org/2000/svg" ' +
  'viewBox="0 0 8 8"><circle cx="4" cy="4" r="3"/></svg>');
await convert(page, `${folder}/dot.svg`);
assert.match(await text(page, 'command'), /--svg dot\.svg=0xE000/);
assert.equal(await page.inputValue('#text'), '\ue000');
assert.ok((await shown(page, 'oled', 128, 64)).includes(1), 'no icon');
assert.deepEqual(await page.$$eval('#icon-list th, #icon-list td', (cells) =>
  cells.map((cell) => cell.textContent)),
['Dot', '', 'U+E000', 'fonts::icons_icons::kDot icons_icons_Dot']);
assert.ok(!await page.isEnabled('#ascii'));
assert.equal(await page.textContent('#largest th'), 'Dot');
await page.click('#worst button');
assert.match(await text(page, 'pixel-text'), /^Dot at /);
await native(page, '--out icons.c --header icons.h');
assert.match(await text(page, 'usage'), /fonts::icons_icons::kDot\);/);
compile('g++', 'c++', await text(page, 'usage'));
compile('gcc', 'c', await text(page, 'usage-c'));
assert.deepEqual(problems, []);
await browser.close();
