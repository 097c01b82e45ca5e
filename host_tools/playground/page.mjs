// The first screen: three displays that the device's library draws.
import {Core} from '../../port/web/inkcell.mjs';
import {drawClock} from './clock.mjs';
import {startConverter} from './convert.mjs';
import {$, bytesOf, copyLink, reset, restore} from './dom.mjs';
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
const CLOCK = {size: 44, top: 16, bottom: 64};  // on the TFT [px]

let size = 0;  // that is shown, between whole ones while it sweeps
let usual = 0;  // bytes of the built-in font
let fontBytes = 0;
let seen = new Map();  // bytes of bitmaps by whole size
let all = 1;  // of all sizes

/** The style that the controls ask for. */
function look() {
  const value = (id) => Number($(id).value);
  return {size, filter: $('filter').value, fit: $('fit').value, weight: value('weight'),
    angle: value('angle'), effect: value('outline') ? 'outline' : 'none',
    outline: value('outline'), glow: value('glow')};
}

function drawTft(now) {
  const {tft} = screens;
  tft.clear();
  try {
    drawClock(core, tft, now, CLOCK.size, CLOCK.top, still.matches);
    tft.text(core, look(), $('text').value, CLOCK.bottom);
  } finally {
    tft.show();
  }
}

function draw() {
  try {
    for (const screen of [screens.oled, screens.paper]) {
      screen.clear();
      screen.text(core, look(), $('text').value);
      screen.show();
    }
    drawTft(Date.now());
    $('note').textContent = fontBytes === usual && /[^ -~]/.test($('text').value)
      ? 'The built-in font has ASCII alone: convert one of yours below for more.' : '';
  } catch (error) {
    $('note').textContent = /** @type {Error} */ (error).message;
  }
  for (const screen of Object.values(screens)) {
    screen.canvas.setAttribute('aria-label', `${$('text').value}, ${Math.round(size)} px`);
  }
}

function showSum() {
  let sum = 0;
  for (const bytes of seen.values()) sum += bytes;
  $('size-shown').textContent = `${Math.round(size)} px`;
  $('font-bytes').textContent = bytesOf(fontBytes);
  $('bitmap-label').textContent = 'The same glyphs as 4-bit bitmaps, uncompressed: ' +
    (seen.size === 1 ? 'one size so far' : `${seen.size} sizes so far`);
  $('bitmap-bytes').textContent = bytesOf(sum);
  $('font-bar').style.width = `${100 * fontBytes / all}%`;
  $('bitmap-bar').style.width = `${100 * sum / all}%`;
}

/** Counts the bitmaps of a size once. */
function see(whole) {
  if (!seen.has(whole)) seen.set(whole, core.bitmapBytes(whole, 4));
}

function setSize(px) {
  size = px;
  see(Math.round(px));
  showSum();
  draw();
}

const lookInside = startInside(core);

/** Shows another font, with a text for one that has icons alone. */
function setFont(bytes, label, text) {
  core.open(bytes);
  if (text) {
    $('text').value = text;
    $('glyph').value = [...text][0];
  }
  fontBytes = bytes.length;
  $('font-label').textContent = label;
  $('title-bytes').textContent = `${(fontBytes / 1000).toFixed(1)} KB.`;
  all = 0;
  for (let px = 8; px <= 64; ++px) all += core.bitmapBytes(px, 4);
  seen = new Map();
  lookInside();
  setSize(Number($('size').value));
}

let sweeping = 0;
function sweep() {
  const end = Number($('size').value);
  const begin = performance.now();
  const step = (now) => {
    const part = Math.min(1, (now - begin) / 4500);
    // Up to 64 px, then back to where it was. Slow machines leave sizes out.
    const px = part < 0.8 ? 8 + 56 * (part / 0.8) ** 1.5
                          : 64 + (end - 64) * ((part - 0.8) / 0.2) ** 0.5;
    for (let whole = 8; whole <= (part < 0.8 ? px : 64); ++whole) see(whole);
    $('size').value = px;
    setSize(part === 1 ? end : px);
    sweeping = part === 1 ? 0 : requestAnimationFrame(step);
  };
  cancelAnimationFrame(sweeping);
  sweeping = requestAnimationFrame(step);
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
    cancelAnimationFrame(sweeping);
    sweeping = 0;
    showValues();
    setSize(Number($('size').value));
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
$('sweep').onclick = sweep;
$('plain').onclick = () => {
  reset(document.querySelectorAll('.look [data-keep]'));
  showValues();
  draw();
};
$('link').onclick = () => copyLink($('note'));
new ResizeObserver(draw).observe(document.body);

const builtIn = await part('font.bin');
usual = builtIn.length;
showValues();
setFont(builtIn, 'DejaVu Sans, 95 characters: this font, any size');
startConverter({
  core,
  fontgen: () => part('fontgen.wasm'),
  worker: () => scriptOf('worker.js'),
  screenText: () => $('text').value,
  show: setFont,
});
keepOffline();
document.body.dataset.ready = `${Math.round(performance.now())}`;
if (!still.matches && !location.hash) sweep();
tick();
