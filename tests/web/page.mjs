// Tests the page in headless Chromium, and leaves screenshots.
//
// Usage: node page.mjs PAGE.html SITE_FOLDER NPM_FOLDER FOLDER
import assert from 'node:assert/strict';
import {existsSync, mkdirSync, readFileSync, rmSync, statSync} from 'node:fs';
import {dirname} from 'node:path';

import {Screen} from '../../host_tools/playground/screen.mjs';
import {Core} from '../../port/web/inkcell.mjs';
import {launch, number, problems, shown, text} from './browser.mjs';

const [file, site, npm, folder] = process.argv.slice(2);
const limits = JSON.parse(
  readFileSync(new URL('../limits.json', import.meta.url), 'utf8')).page;
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
assert.ok(statSync(file).size <= limits.bytes,
  `${statSync(file).size} bytes, at most ${limits.bytes} (tests/limits.json)`);

const {browser, open} = await launch(npm, `file://${file}`);

// The first screen, with what the device's library draws in node.
const page = await open({viewport: {width: 1280, height: 900}});
console.log(`${statSync(file).size} bytes; ready after ` +
  `${page.milliseconds.toFixed(0)} ms of processor time, ` +
  `${await page.getAttribute('body', 'data-ready')} ms on this machine`);
assert.ok(page.milliseconds <= limits['processor time, ms']);  // until controls answer
const own = {core: readFileSync(`${site}/core.wasm`), font: readFileSync(`${site}/font.bin`)};
const core = await Core.load(own.core);
core.open(own.font);
globalThis.OffscreenCanvas = class { getContext() { return null; } };
const oled = new Screen(null, {format: 'mono-pages', width: 128, height: 64, ink: 1,
  glow: 1, paper: 0});
async function compare(what, look) {
  oled.clear();
  oled.text(core, {filter: 'text', fit: 'heights', weight: 0, angle: 0, effect: 'none',
    stroke: 0, glow: 0, ...look}, 'Hello, world');
  const wanted = Array.from({length: 128 * 64}, (_, i) =>
    oled.display.word(i % 128, Math.floor(i / 128)));
  assert.ok(wanted.includes(1), what);
  assert.deepEqual(await shown(page, 'oled', 128, 64), wanted, what);
}
await compare('the first screen', {size: 27});
assert.equal(await number(page, 'font-bytes'), own.font.length);
await page.screenshot({path: `${folder}/first.png`});

// Where nothing moves, bitmaps of all sizes are counted from the beginning.
let sum = 0;
for (let px = 8; px <= 64; ++px) sum += core.bitmapBytes(px, 4);
assert.equal(await number(page, 'bitmap-bytes'), sum);
assert.ok(sum > 200 * own.font.length);

// By keyboard: each control changes the displays.
await page.focus('#size');
await page.keyboard.press('ArrowRight');
await compare('28 px', {size: 28});
await page.focus('#angle');
for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
await compare('turned', {size: 28, angle: 5});
await page.focus('#stroke');
for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowRight');
await compare('a stroke', {size: 28, angle: 5, stroke: 1, effect: 'stroke'});
await page.focus('#glow');
for (let i = 0; i < 8; ++i) await page.keyboard.press('ArrowRight');
await compare('a glow', {size: 28, angle: 5, stroke: 1, effect: 'stroke', glow: 2});
await page.screenshot({path: `${folder}/look.png`});

// The link brings them back.
await page.click('#link');
const again = await open({viewport: {width: 1280, height: 900},
  hash: await page.evaluate('location.hash')});
assert.deepEqual(await again.$$eval('[data-keep]', (all) => all.map((c) => c.value)),
  await page.$$eval('[data-keep]', (all) => all.map((c) => c.value)));
await again.close();
await page.click('#plain');
await compare('plain again', {size: 28});


// On 1 bit, too: bolder strokes, and a glow of scattered pixels.
const lit = async () => (await shown(page, 'oled', 128, 64)).filter(Boolean).length;
let before = await lit();
await page.focus('#weight');
for (const weight of [0.4, 0.8]) {
  for (let i = 0; i < 8; ++i) await page.keyboard.press('ArrowRight');
  await compare(`bolder by ${weight} px`, {size: 28, weight});
  assert.ok(await lit() > 1.15 * before, `${await lit()} pixels, ${before} before`);
  before = await lit();
}
await page.click('#plain');
before = await lit();
await page.focus('#glow');
for (let i = 0; i < 12; ++i) await page.keyboard.press('ArrowRight');
assert.ok(await lit() > 1.15 * before, 'no glow');
await page.click('#plain');

// A text that is too long is told below the displays that cut it off.
assert.ok(!await page.isVisible('.oled .cut'));
await page.fill('#text', 'More words than a display of this size has room for');
assert.ok(await page.isVisible('.oled .cut') && !await page.isVisible('.tft .cut'));
await page.fill('#text', 'Hello, world');

// The clock goes on; a sweep ends where it began, and can be stopped.
const clock = await shown(page, 'tft', 240, 64);
await page.waitForTimeout(1500);
assert.notDeepEqual(await shown(page, 'tft', 240, 64), clock, 'the clock stands');
await page.click('#sweep');
await page.waitForFunction(() => document.getElementById('size').value > 40);
await page.waitForFunction(() => document.getElementById('size').value === '28' &&
  document.getElementById('sweep').textContent === 'Sweep all sizes');
await page.click('#sweep');
await page.waitForFunction(() => document.getElementById('size').value < 20);
await page.click('#sweep');
const stopped = await page.inputValue('#size');
await page.waitForTimeout(200);
assert.equal(await page.inputValue('#size'), stopped);
await page.fill('#size', '28');

// Inside: the keys move the probe, and the cell under it is told.
await page.locator('#field').scrollIntoViewIfNeeded();
await page.waitForFunction(() => document.getElementById('field-size').textContent);
assert.match(await text(page, 'field-size'), /^\d+ cells, [\d,]+ bytes/);
await page.focus('#field');
const told = new Set();
for (let i = 0; i < 12; ++i) {
  await page.keyboard.press('Shift+ArrowLeft');
  told.add(await text(page, 'probe'));
}
assert.ok(told.size > 6 && [...told].some((line) => /nine distances/.test(line)));
const plain = await page.evaluate(() => document.getElementById('field').toDataURL());
for (const id of ['points-shown', 'hints-shown']) {
  await page.focus(`#${id}`);
  await page.keyboard.press('Space');
}
assert.notEqual(await page.evaluate(() => document.getElementById('field').toDataURL()), plain);
assert.match(await text(page, 'outline-size'), /^\d\d points; hints: .*bar.*stem/);
await page.fill('#glyph', '€');
assert.equal(await text(page, 'outline-size'), "The font has no '€'.");
await page.fill('#glyph', 'gh');
assert.equal(await page.inputValue('#glyph'), 'h');
await page.fill('#glyph', 'g');
assert.ok(await page.isVisible('#cell') || /No edge is near/.test(await text(page, 'probe')));
await page.focus('#field');
for (let i = 0; i < 40 && !await page.isVisible('#cell'); ++i) {
  await page.keyboard.press('Shift+ArrowRight');
}
await page.locator('#inside').screenshot({path: `${folder}/inside.png`});

// Without a wish for less motion the first thing to see is a sweep. A busy machine's
// frames begin before the press that they answer.
// Words that are typed meanwhile are swept, too.
const moving = await open({reducedMotion: 'no-preference', late: 100});
await moving.fill('#text', 'Hey');
await moving.waitForFunction(() =>
  document.getElementById('bitmap-label').textContent.includes('57 sizes'));
await moving.waitForFunction(() => document.getElementById('size').value === '27');
await moving.close();

// The library lies beside both pages.
const library = await page.getAttribute('#result a', 'href');
for (const place of [dirname(file), site]) assert.ok(existsSync(`${place}/${library}`));

// Nothing leaves the page.
assert.deepEqual(problems, []);
assert.equal(await page.evaluate(() => new Promise((resolve) => {
  addEventListener('securitypolicyviolation', (event) => resolve(event.violatedDirective));
  fetch('https://localhost/').catch(() => {});
})), 'connect-src');
await browser.close();
console.log(`the page is as it should be; screenshots in ${folder}`);
