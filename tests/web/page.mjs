// Tests the page in headless Chromium, and leaves screenshots.
//
// Usage: node page.mjs PAGE.html NPM_FOLDER HOST_FONTGEN FOLDER
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';

import {Screen} from '../../host_tools/playground/screen.mjs';
import {Core} from '../../port/web/inkcell.mjs';

const [file, npm, host, folder] = process.argv.slice(2);
const {chromium} = createRequire(`${npm}/`)('playwright-core');
const FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf';
const MOST_BYTES = 1300000;
const MOST_MS = 300;  // of processor time until controls answer
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
assert.ok(statSync(file).size <= MOST_BYTES, `${statSync(file).size} bytes`);

const browser = await chromium.launch(
  {executablePath: '/usr/bin/chromium', args: ['--no-sandbox']});
const problems = [];
async function open(options, hash = '') {
  const page = await browser.newPage({reducedMotion: 'reduce', ...options});
  page.setDefaultTimeout(240000);
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('console', (line) => {
    if (line.type() === 'error') problems.push(line.text());
  });
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) problems.push(request.url());
  });
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable', {timeDomain: 'threadTicks'});
  await page.goto(`file://${file}${hash}`);
  await page.waitForSelector('body[data-ready]');
  const {metrics} = await devtools.send('Performance.getMetrics');
  page.milliseconds = 1000 * metrics.find(({name}) => name === 'TaskDuration').value;
  return page;
}
const text = (page, id) => page.textContent(`#${id}`);
const number = async (page, id) =>
  Number((await text(page, id)).replace(/[^0-9]/g, ''));

/** The pixels of a display on its canvas: whether each is nearer to white. */
const shown = (page, id, width, height) => page.evaluate(([name, w, h]) => {
  const canvas = document.getElementById(name);
  const zoom = canvas.width / w;
  const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return Array.from({length: w * h}, (_, i) => {
    const x = i % w * zoom;
    const y = Math.floor(i / w) * zoom;
    return data[4 * (y * canvas.width + x)] > 127 ? 1 : 0;
  });
}, [id, width, height]);

// The first screen, with what the device's library draws in node.
const page = await open({viewport: {width: 1280, height: 900}});
console.log(`${statSync(file).size} bytes; ready after ` +
  `${page.milliseconds.toFixed(0)} ms of processor time, ` +
  `${await page.getAttribute('body', 'data-ready')} ms on this machine`);
assert.ok(page.milliseconds <= MOST_MS);
const own = await page.evaluate(async () => {
  const bytes = async (id) => {
    const packed = Uint8Array.from(atob(document.getElementById(id).textContent),
      (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream()
      .pipeThrough(new DecompressionStream('gzip'));
    return [...new Uint8Array(await new Response(stream).arrayBuffer())];
  };
  return {core: await bytes('core-data'), font: await bytes('font-data')};
});
const core = await Core.load(Uint8Array.from(own.core));
core.open(Uint8Array.from(own.font));
globalThis.OffscreenCanvas = class {};
const oled = new Screen(null, {format: 'mono-pages', width: 128, height: 64, ink: 1,
  glow: 1, paper: 0});
async function compare(what, look) {
  oled.clear();
  oled.text(core, {filter: 'text', fit: 'heights', weight: 0, angle: 0, effect: 'none',
    outline: 0, glow: 0, ...look}, 'Hello, world');
  const wanted = Array.from({length: 128 * 64}, (_, i) =>
    oled.display.word(i % 128, Math.floor(i / 128)));
  assert.ok(wanted.includes(1), what);
  assert.deepEqual(await shown(page, 'oled', 128, 64), wanted, what);
}
await compare('the first screen', {size: 27});
assert.equal(await number(page, 'font-bytes'), own.font.length);
await page.screenshot({path: `${folder}/first.png`});

// By keyboard: each control changes the displays, and sizes add bitmaps.
const bitmaps = await number(page, 'bitmap-bytes');
await page.focus('#size');
await page.keyboard.press('ArrowRight');
await compare('28 px', {size: 28});
assert.ok(await number(page, 'bitmap-bytes') > 2 * bitmaps);
await page.focus('#angle');
for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
await compare('turned', {size: 28, angle: 5});
await page.focus('#outline');
for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowRight');
await compare('an outline', {size: 28, angle: 5, outline: 1, effect: 'outline'});
await page.focus('#glow');
for (let i = 0; i < 8; ++i) await page.keyboard.press('ArrowRight');
await compare('a glow', {size: 28, angle: 5, outline: 1, effect: 'outline', glow: 2});
await page.screenshot({path: `${folder}/look.png`});

// The link brings them back.
await page.click('#link');
const again = await open({viewport: {width: 1280, height: 900}},
  await page.evaluate('location.hash'));
assert.deepEqual(await again.$$eval('[data-keep]', (all) => all.map((c) => c.value)),
  await page.$$eval('[data-keep]', (all) => all.map((c) => c.value)));
await again.close();
await page.click('#plain');
await compare('plain again', {size: 28});

// The clock goes on; a sweep adds all sizes, and ends where it began.
const before = await shown(page, 'tft', 240, 64);
await page.waitForTimeout(1500);
assert.notDeepEqual(await shown(page, 'tft', 240, 64), before, 'the clock stands');
await page.click('#sweep');
await page.waitForFunction(() => document.getElementById('size').value === '28' &&
  document.getElementById('bitmap-label').textContent.includes('57 sizes'));
assert.ok(await number(page, 'bitmap-bytes') > 200 * own.font.length);
await page.screenshot({path: `${folder}/sum.png`});  // docs/img/playground.png

// A conversion, which begins by itself, and its four files by the line that is shown.
await page.fill('#text', 'Größe 12');
await page.setInputFiles('#files', FONT);
await page.waitForSelector('#result:visible');
console.log(await text(page, 'status'));
const line = await text(page, 'command');
assert.match(line, /^inkcell-fontgen .* --symbols 'öß' --name DejaVuSerif --out /);
const local = line.replace('inkcell-fontgen', host).replace('DejaVuSerif.ttf', FONT);
execFileSync('sh', ['-c', `${local} --out DejaVuSerif.c --header DejaVuSerif.h ` +
  '--out DejaVuSerif.bin --quiet'], {cwd: folder});
const buttons = await page.$$('#downloads button');
assert.equal(buttons.length, 4);
for (const button of buttons) {
  const [download] = await Promise.all([page.waitForEvent('download'), button.click()]);
  assert.ok(readFileSync(await download.path())
    .equals(readFileSync(`${folder}/${download.suggestedFilename()}`)),
  download.suggestedFilename());
}
assert.equal(await text(page, 'cmake'), 'inkcell_add_font(app NAME DejaVuSerif FONT ' +
  'DejaVuSerif.ttf CHARS 0x20-0x7E SYMBOLS öß)');
execFileSync('g++', ['-std=c++17', '-fsyntax-only', '-I', folder, '-I',
  new URL('../../core/include', import.meta.url).pathname, '-x', 'c++', '-'],
{input: await text(page, 'usage')});
assert.equal(await number(page, 'font-bytes'),
  statSync(`${folder}/DejaVuSerif.bin`).size);
await page.screenshot({path: `${folder}/convert.png`, fullPage: true});

// Cancelled; refused, in the generator's words; icons alone.
await page.focus('#go');
await page.keyboard.press('Enter');
await page.focus('#cancel');
await page.keyboard.press('Enter');
assert.equal(await text(page, 'status'), 'Cancelled.');
assert.ok(await page.isEnabled('#go'));
await page.evaluate(() => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File(['no font'], 'broken.ttf'));
  document.body.dispatchEvent(new DragEvent('drop', {dataTransfer, bubbles: true}));
});
await page.waitForSelector('#messages:visible');
assert.match(await text(page, 'messages'), /^error: broken\.ttf: /);
writeFileSync(`${folder}/dot.svg`, '<svg xmlns="http://www.w3.org/2000/svg" ' +
  'viewBox="0 0 8 8"><circle cx="4" cy="4" r="3"/></svg>');
await page.setInputFiles('#files', `${folder}/dot.svg`);
await page.waitForFunction(() =>
  document.getElementById('command').textContent.includes('--svg dot.svg=0xE000'));
assert.equal(await page.inputValue('#text'), '\ue000');
assert.ok((await shown(page, 'oled', 128, 64)).includes(1), 'no icon');

// Inside: the keys move the probe, and the cell under it is told.
await page.locator('#field').scrollIntoViewIfNeeded();
await page.waitForFunction(() => document.getElementById('probe').textContent);
assert.match(await text(page, 'field-size'), /^\d+ cells, [\d,]+ bytes/);
await page.focus('#field');
const told = new Set();
for (let i = 0; i < 12; ++i) {
  await page.keyboard.press('Shift+ArrowLeft');
  told.add(await text(page, 'probe'));
}
assert.ok(told.size > 6 && [...told].some((line) => /nine distances/.test(line)));
await page.locator('#inside').screenshot({path: `${folder}/inside.png`});

// Names of controls, contrast, phones.
assert.deepEqual(await page.$$eval('input, select, button', (all) => all
  .filter((control) => !(control.labels?.[0] || control).textContent.trim())
  .map((control) => control.id)), []);
for (const colorScheme of ['light', 'dark']) {
  const phone = await open({viewport: {width: 360, height: 740}, colorScheme,
    deviceScaleFactor: 3});
  assert.equal(await phone.evaluate('document.documentElement.scrollWidth'), 360);
  const least = await phone.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    const light = (name) => {
      const hex = style.getPropertyValue(name).trim().replace(/^#(.)(.)(.)$/, '#$1$1$2$2$3$3');
      return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255)
        .map((c) => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
        .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0.05);
    };
    return Math.min(...[['--ink', '--back'], ['--soft', '--back'], ['--accent', '--back'],
      ['--ink', '--card'], ['--on-accent', '--accent']].map(([a, b]) =>
      Math.max(light(a), light(b)) / Math.min(light(a), light(b))));
  });
  assert.ok(least >= 4.5, `contrast ${least}`);
  await phone.screenshot({path: `${folder}/phone-${colorScheme}.png`});
  await phone.close();
}

// Without a wish for less motion the first thing to see is a sweep.
const moving = await open({reducedMotion: 'no-preference'});
await moving.waitForFunction(() =>
  document.getElementById('bitmap-label').textContent.includes('57 sizes'));
await moving.close();

// Nothing leaves the page.
assert.deepEqual(problems, []);
assert.equal(await page.evaluate(() => new Promise((resolve) => {
  addEventListener('securitypolicyviolation', (event) => resolve(event.violatedDirective));
  fetch('https://localhost/').catch(() => {});
})), 'connect-src');
await browser.close();
console.log(`the page is as it should be; screenshots in ${folder}`);
