// The first screen: three displays that the device's library draws.
import {Core} from '../../port/web/inkcell.mjs';
import {drawClock} from './clock.mjs';
import {startConverter} from './convert.mjs';
import {$, bytesOf, copyLink, reset, restore, sizesOf} from './dom.mjs';
import {startInside} from './inside.mjs';
import {keepOffline, part, scriptOf} from './parts.mjs';
import {Screen} from './screen.mjs';

const still = matchMedia('(prefers-reduced-motion: reduce)');

const core = await Core.load(await part('core.wasm'));
const screens = {
  oled: new Screen($('oled'), {format: 'mono-pages', width: 128, height: 64, ink: 1,
    glow: 1, paper: 0, gap: '#000', tint: ([on]) => on ? [176, 232, 255] : [7, 10, 14]}),
  tft: new Screen($('tft'), {format: 'rgb565', width: 240, height: 240, ink: 0xffffff,
    glow: 0xff5a1f, paper: 0x0b0f16, clockInk: 0xffc37a, gap: '#000'}),
  paper: new Screen($('paper'), {format: 'grey4', width: 212, height: 104, ink: 0,
    glow: 9, paper: 15, gap: '#d9d5ca', tint: ([grey]) =>
      [38, 36, 34].map((black, i) => black + grey * ([232, 229, 220][i] - black) / 255)}),
};
const FEW = [12, 16, 24, 32];  // sizes of a usual program [px]
const CLOCK = {size: 44, top: 16, bottom: 64};  // on the TFT [px]

let size = 0;  // that is shown, between whole ones while it sweeps
/** @typedef {{bytes: Uint8Array, label: string, isPart: boolean}} Shown */
/** @type {Shown} */
let builtIn;
/** @type {Shown} the font of the displays; a part of one while the rest is converted */
let shown;
/** @type {Shown} the last whole one */
let whole;
let seen = new Map();  // bytes of bitmaps by whole size
let all = 1;  // of all sizes
let few = 0;  // of those of FEW
let range = {least: 8, most: 64};  // sizes that are shown [px]
let clock = true;  // whether the font has its characters

/** The style that the controls ask for. */
function look() {
  const value = (id) => Number($(id).value);
  return {size, colour: 0, filter: $('filter').value, fit: $('fit').value, weight: value('weight'),
    angle: value('angle'), effect: value('stroke') ? 'stroke' : 'none',
    stroke: value('stroke'), glow: value('glow')};
}

/** Draws text, and says below the display if it does not fit. */
function drawText(screen, top = 0) {
  const fits = screen.text(core, look(), $('text').value, top);
  screen.canvas.closest('figure').querySelector('.cut').hidden = fits;
}

function drawTft(now) {
  const {tft} = screens;
  tft.clear();
  try {
    if (clock) drawClock(core, tft, now, CLOCK.size, CLOCK.top, still.matches);
    drawText(tft, clock ? CLOCK.bottom : 0);
  } finally {
    tft.show();
  }
}

/** What one should know of the displays. */
function notes() {
  const text = $('text').value;
  if (shown.isPart) return 'Your text in your font. All other characters follow.';
  const missing = [...new Set(text)].filter((char) => !core.has(char)).join(' ');
  const list = [];
  if (missing) {
    list.push(`The font lacks ${missing}: boxes stand for that.`, shown === builtIn
      ? 'The built-in font has ASCII alone: convert one of yours below for more.'
      : 'Convert it again with the characters of this text.');
  }
  if (/[\ue000-\uf8ff]/.test(text)) {
    list.push('Icons are boxes in the text field, since the browser does not know them.');
  }
  if (!clock) list.push('There is no clock: the font lacks digits or the colon.');
  return list.join(' ');
}

/** Once, since messages are read aloud. @param {string} note */
function say(note) {
  if ($('note').textContent !== note) $('note').textContent = note;
}

function draw() {
  try {
    for (const screen of [screens.oled, screens.paper]) {
      screen.clear();
      drawText(screen);
      screen.show();
    }
    drawTft(Date.now());
    say(notes());
  } catch (error) {
    say(/** @type {Error} */ (error).message);
  }
  for (const screen of Object.values(screens)) {
    screen.canvas.setAttribute('aria-label', `${$('text').value}, ${Math.round(size)} px`);
  }
}

function showSum() {
  let sum = 0;
  for (const bytes of seen.values()) sum += bytes;
  $('size-shown').textContent = `${Math.round(size)} px`;
  const {length} = whole.bytes;
  $('font-bytes').textContent = bytesOf(length);
  $('bitmap-label').textContent = '4-bit bitmaps of the same glyphs, uncompressed, ' +
    (seen.size === 1 ? 'this size' : seen.size > range.most - range.least
      ? `all ${seen.size} sizes` : `${seen.size} sizes so far`) +
    ` (${FEW.join(', ')} px alone: ${few.toLocaleString('en')})`;
  $('bitmap-bytes').textContent = bytesOf(sum);
  $('font-bar').style.width = `${100 * length / all}%`;
  $('bitmap-bar').style.width = `${100 * sum / all}%`;
}

/** Counts the bitmaps of a size once. */
function see(px) {
  if (!shown.isPart && !seen.has(px)) seen.set(px, core.bitmapBytes(px, 4));
}

function setSize(px) {
  size = px;
  see(Math.round(px));
  showSum();
  draw();
}

const lookInside = startInside(core);

/** Draws with a font. @param {Shown} font */
function open(font) {
  shown = font;
  core.open(font.bytes);
  clock = [...'0123456789:'].every((char) => core.has(char));
}

/** Shows a whole font, with a text for one that has icons alone. @param {string} [text] */
function setFont(font, text) {
  open(font);
  whole = font;
  if (text) $('text').value = text;
  // A glyph to look into: the one before, or one that the font has.
  $('glyph').value = [$('glyph').value, ...$('text').value, ...'0Aa'].find((char) =>
    char.trim() && core.has(char)) ?? $('glyph').value;
  $('font-label').textContent = font.label;
  $('title-bytes').textContent = `${(font.bytes.length / 1000).toFixed(1)} KB.`;
  $('built-in').hidden = font === builtIn;
  const {least, most} = core.sizes;
  $('title-sizes').textContent = font === builtIn ? 'Every size.'
    : least === most ? `${least} px.` : `${least} to ${most} px.`;
  range = {least, most: Math.max(least, Math.min(most, 64))};
  $('size').min = range.least;
  $('size').max = range.most;
  all = 0;
  for (let px = range.least; px <= range.most; ++px) all += core.bitmapBytes(px, 4);
  few = FEW.reduce((sum, px) => sum + core.bitmapBytes(px, 4), 0);
  seen = new Map();
  // Where nothing moves by itself, the sum is not that of a sweep.
  if (still.matches) for (let px = range.least; px <= range.most; ++px) see(px);
  lookInside();
  setSize(Number($('size').value));
}

/**
 * Shows a part of a font, or, without one, the last whole font again.
 * @param {Uint8Array} [bytes]
 */
function showPart(bytes) {
  if (!bytes && shown === whole) return;
  open(bytes ? {bytes, label: '', isPart: true} : whole);
  draw();
}

let sweeping = 0;
function sweep() {
  const end = Number($('size').value);
  let begin = 0;
  const step = (now) => {
    // Frames have times of their own, which may be before that of a press.
    begin ||= now;
    const part = Math.min(1, (now - begin) / 4500);
    // Up to the largest, then back to where it was. Slow machines leave sizes out.
    const {least, most} = range;
    const last = Math.max(least, Math.min(end, most));
    const px = part < 0.8 ? least + (most - least) * (part / 0.8) ** 1.5
                          : most + (last - most) * ((part - 0.8) / 0.2) ** 0.5;
    for (let whole = least; whole <= (part < 0.8 ? px : most); ++whole) see(whole);
    $('size').value = px;
    setSize(part === 1 ? last : px);
    if (part === 1) stopSweep();
    else sweeping = requestAnimationFrame(step);
  };
  $('sweep').textContent = 'Stop';
  sweeping = requestAnimationFrame(step);
}

function stopSweep() {
  cancelAnimationFrame(sweeping);
  sweeping = 0;
  $('sweep').textContent = 'Sweep all sizes';
}

/** The clock moves while the page is seen. */
let drawn = 0;
function tick() {
  const now = Date.now();
  const moves = now % 1000 < 450 && !still.matches;
  if (!sweeping && (moves || Math.floor(now / 1000) !== Math.floor(drawn / 1000) ||
      drawn % 1000 < 450)) {
    try {
      drawTft(now);
    } catch {
      // draw() has said why.
    }
    drawn = now;
  }
  requestAnimationFrame(tick);
}

// Controls, whose values are in the link.
restore(document.querySelectorAll('[data-keep]'));
for (const control of document.querySelectorAll('#try [data-keep]')) {
  control.addEventListener('input', () => {
    showValues();
    if (control.id === 'size') stopSweep();
    if (!sweeping) setSize(Number($('size').value));
  });
}
function showValues() {
  /** @type {NodeListOf<HTMLOutputElement>} */
  const outputs = document.querySelectorAll('.look output');
  for (const output of outputs) {
    const control = $(output.htmlFor.value);
    output.textContent = control.value + control.dataset.unit;
  }
}
$('sweep').onclick = () => {
  if (!sweeping) sweep();
  else {
    stopSweep();
    setSize(Number($('size').value));
  }
};
$('built-in').onclick = () => {
  setFont(builtIn);
  $('plain').focus();
};
$('plain').onclick = () => {
  reset(document.querySelectorAll('.look [data-keep]'));
  showValues();
  draw();
};
$('link').onclick = () => copyLink($('note'));
new ResizeObserver(draw).observe(document.body);

showValues();
builtIn = {bytes: await part('font.bin'), isPart: false,
  label: `DejaVu Sans, 95 characters, ${sizesOf(8, 64)}`};
setFont(builtIn);
startConverter({
  core,
  fontgen: () => part('fontgen.wasm'),
  worker: () => scriptOf('worker.js'),
  look,
  screenText: () => $('text').value,
  show: (bytes, label, text) => setFont({bytes, label, isPart: false}, text),
  showPart,
});
keepOffline();
document.body.dataset.ready = `${Math.round(performance.now())}`;
if (!still.matches && !location.hash) sweep();
tick();
