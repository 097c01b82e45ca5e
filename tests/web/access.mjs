// Tests that the page serves everybody: by keyboard alone, with names for all
// controls, enough contrast in both schemes, little motion where that is asked
// for, messages that are read aloud, and on a phone.
//
// Usage: node access.mjs PAGE.html NPM_FOLDER FOLDER
import assert from 'node:assert/strict';
import {mkdirSync, rmSync} from 'node:fs';

import {converted, launch, problems, shown, text} from './browser.mjs';

const [file, npm, folder] = process.argv.slice(2);
const FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf';
const LEAST_TARGET = 24;  // of what fingers press [px]
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
const {browser, open} = await launch(npm, `file://${file}`);

/** What has the focus: its name, and whether one sees that it has it. */
const focus = (page) => page.evaluate(() => {
  const control = document.activeElement;
  const ringed = control.matches('.file input') ? control.closest('#drop') : control;
  const {outlineStyle, outlineWidth} = getComputedStyle(ringed);
  return {name: control.id || control.textContent.trim(), tag: control.tagName,
    ring: outlineStyle === 'none' ? 0 : parseFloat(outlineWidth)};
});
async function tabTo(page, name) {
  for (let i = 0; i < 80; ++i) {
    const at = await focus(page);
    if (at.name === name) return;
    await page.keyboard.press('Tab');
  }
  assert.fail(`no Tab leads to ${name}`);
}

// By keyboard alone: choose a file, convert, download, look inside.
const page = await open({viewport: {width: 1100, height: 900}, cores: 2});
page.on('filechooser', () => {});  // from now on it is seen, and none opens
const order = [];
for (let i = 0; i < 80; ++i) {
  await page.keyboard.press('Tab');
  const at = await focus(page);
  if (at.tag === 'BODY' || order.includes(at.name)) break;
  assert.ok(at.ring >= 2, `no ring around ${at.name}`);
  order.push(at.name);
}
const controls = await page.$$eval('input, select, button, summary, [tabindex="0"]', (all) => all
  .filter((control) => control.checkVisibility() && !control.disabled)
  .map((control) => control.id || control.textContent.trim()));
assert.deepEqual(order, controls, 'the order of Tab is that of the page');
await page.evaluate(() => {
  document.activeElement.blur();
  // What screen readers would say.
  window.said = [];
  for (const region of document.querySelectorAll('[role=status]')) {
    new MutationObserver(() => window.said.push(`${region.id}: ${region.textContent}`))
      .observe(region, {childList: true, characterData: true, subtree: true});
  }
});
for (const name of ['ascii', 'digits', 'mine']) {
  await tabTo(page, name);
  await page.keyboard.press('Space');
}
// The first screen leads to the form.
await tabTo(page, 'to-convert');
assert.deepEqual(await focus(page), {name: 'to-convert', tag: 'BUTTON', ring: 3});
await page.keyboard.press('Enter');
assert.deepEqual(await focus(page), {name: 'files', tag: 'INPUT', ring: 3});
assert.ok(await page.evaluate(() => [...document.querySelectorAll('#convert-title, #drop')]
  .every((seen) => seen.getBoundingClientRect().top > -1 &&
    seen.getBoundingClientRect().bottom <= innerHeight)), 'the form is not seen');
const [chooser] = await Promise.all([page.waitForEvent('filechooser'),
  page.keyboard.press('Space')]);
await chooser.setFiles(FONT);
await converted(page, '0');
const said = await page.evaluate(() => window.said);
assert.ok(said.some((line) => /Converting/.test(line)), said.join('\n'));
assert.match(said.filter((line) => line.startsWith('status: ')).at(-1), /bytes for any size from 8 to 64 px/);
assert.ok(said.length < 40, `${said.length} messages are too many to listen to`);
await tabTo(page, 'C++ header: DejaVuSans.hpp');
const [got] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
assert.equal(got.suggestedFilename(), 'DejaVuSans.hpp');
await tabTo(page, 'field');
const told = await text(page, 'probe');
await page.keyboard.press('Shift+ArrowLeft');
assert.notEqual(await text(page, 'probe'), told);
await page.keyboard.press('Shift+Tab');
assert.notEqual((await focus(page)).name, 'field', 'the field holds the focus');

// Names, headings, language.
const faults = await page.evaluate(() => {
  const list = [];
  const named = (element) => (element.labels?.[0] || element).textContent.trim() ||
    element.getAttribute('aria-label') || element.getAttribute('aria-labelledby');
  for (const element of document.querySelectorAll(
    'input, select, button, progress, canvas, [tabindex="0"], section')) {
    const helped = element.getAttribute('aria-describedby');
    if (!named(element) && !(helped && document.getElementById(helped).textContent)) {
      list.push(`${element.tagName} ${element.id} has no name`);
    }
    if (helped && !document.getElementById(helped)) list.push(`${helped} is not there`);
  }
  let level = 0;
  for (const heading of document.querySelectorAll('h1, h2, h3, h4')) {
    const next = Number(heading.tagName[1]);
    if (next > level + 1) list.push(`${heading.textContent}: h${next} after h${level}`);
    level = next;
  }
  if (document.querySelectorAll('h1').length !== 1) list.push('not one h1');
  if (!document.documentElement.lang) list.push('no language');
  for (const one of ['header', 'main', 'footer']) {
    if (!document.querySelector(one)) list.push(`no ${one}`);
  }
  const ids = [...document.querySelectorAll('[id]')].map(({id}) => id);
  for (const id of ids.filter((id, i) => ids.indexOf(id) !== i)) list.push(`two of ${id}`);
  for (const region of ['status', 'probe', 'note']) {
    if (document.getElementById(region).getAttribute('role') !== 'status') {
      list.push(`${region} is not read aloud`);
    }
  }
  return list;
});
assert.deepEqual(faults, []);
await page.close();

// With less motion nothing moves by itself; the clock changes once a second.
const calm = await open({viewport: {width: 1100, height: 900}});
assert.equal(await calm.inputValue('#size'), '27');
assert.equal(await calm.evaluate(() => document.getAnimations().length), 0);
const frames = await calm.evaluate(async () => {
  const canvas = document.getElementById('tft');
  const seen = new Map();
  for (const end = performance.now() + 2500; performance.now() < end;) {
    await new Promise(requestAnimationFrame);
    const second = Math.floor(Date.now() / 1000);
    const picture = canvas.toDataURL();
    if (Math.floor(Date.now() / 1000) !== second) continue;
    seen.set(second, (seen.get(second) ?? new Set()).add(picture));
  }
  return [...seen.values()].map((pictures) => pictures.size);
});
// The old picture may stand for a frame.
assert.ok(frames.length > 1 && frames.every((count) => count <= 2), frames.join());
await calm.close();

/** Texts whose contrast with what is behind them is less than they need. */
const pale = (which) => which.evaluate(() => {
  const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
  const light = (rgb) => rgb.slice(0, 3).map((c) => c / 255)
    .map((c) => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0.05);
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const back = numbers(getComputedStyle(at).backgroundColor);
      if (back[3] !== 0) return back;
    }
    return [255, 255, 255];
  };
  const list = [];
  let count = 0;
  for (const element of document.querySelectorAll('body *')) {
    const own = [...element.childNodes].some((node) =>
      node.nodeType === 3 && node.textContent.trim());
    if ((!own && !element.matches('input, select')) || !element.checkVisibility() ||
      element.matches('script, option, :disabled')) continue;
    const style = getComputedStyle(element);
    const [a, b] = [light(numbers(style.color)), light(behind(element))];
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    ++count;
    if (Math.max(a, b) / Math.min(a, b) < (large ? 3 : 4.5)) {
      list.push(`${element.tagName} ${element.id} '${element.textContent.slice(0, 30)}' ` +
        (Math.max(a, b) / Math.min(a, b)).toFixed(2));
    }
  }
  if (count < 60) list.push(`only ${count} texts were seen`);
  return list;
});

for (const colorScheme of ['light', 'dark']) {
  const phone = await open({viewport: {width: 360, height: 740}, colorScheme, cores: 1,
    deviceScaleFactor: 2, hasTouch: true});
  await phone.screenshot({path: `${folder}/phone-${colorScheme}.png`});
  const box = await phone.locator('#to-convert').boundingBox();
  assert.ok(box && box.y + box.height <= 740, 'no button on the first screen');
  await phone.tap('#to-convert');
  assert.equal((await focus(phone)).name, 'files');
  await phone.uncheck('#ascii');
  await phone.check('#digits');
  await phone.setInputFiles('#files', FONT);
  await converted(phone, '0');
  await phone.click('#worst button');
  await phone.click('summary');
  await phone.locator('#field').scrollIntoViewIfNeeded();
  await phone.waitForFunction(() => document.getElementById('field-size').textContent);
  assert.equal(await phone.evaluate('document.documentElement.scrollWidth'), 360);
  assert.deepEqual(await pale(phone), [], colorScheme);
  assert.deepEqual(await phone.$$eval('button, select, input:not([type=range]), summary',
    (all, least) => all.filter((control) => control.checkVisibility()).map((control) =>
      [control, (control.closest('label') ?? control).getBoundingClientRect()])
      .filter(([, box]) => box.height < least || box.width < least)
      .map(([control, box]) => `${control.id || control.textContent} ${box.height}`),
    LEAST_TARGET), []);
  assert.ok((await shown(phone, 'oled', 128, 64)).includes(1));
  await phone.screenshot({path: `${folder}/phone-${colorScheme}-all.png`, fullPage: true});
  await phone.close();
  const wide = await open({viewport: {width: 1280, height: 900}, colorScheme});
  assert.deepEqual(await pale(wide), [], colorScheme);
  await wide.screenshot({path: `${folder}/wide-${colorScheme}.png`});
  await wide.close();
}
assert.deepEqual(problems, []);
await browser.close();
console.log(`keyboard, names, contrast, motion, messages, 360 px; screenshots in ${folder}`);
