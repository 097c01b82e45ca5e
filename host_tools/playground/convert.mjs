// Converts the reader's fonts by inkcell-fontgen in a worker.
import {axesOf} from './axes.mjs';

const $ = (id) => document.getElementById(id);
const NAMES = {hpp: 'C++ header', c: 'C source', h: 'C header', bin: 'binary'};
const decoded = (bytes) => new TextDecoder().decode(bytes);
const isIcon = (name) => /\.svg$/i.test(name);

let files = {};  // chosen, by name
let worker = null;
let turn = 0;  // of the conversion that is wanted
let module = null;  // of WebAssembly, compiled once

/** An identifier of C from a file's name. */
const identifier = (name) =>
  name.replace(/\.\w+$/, '').replace(/\W+/g, '_').replace(/^(\d|$)/, 'font_$1');

/** A word of a shell's line. */
const quoted = (word) => /^[\w.,:=+%/-]+$/.test(word) ? word
                                                      : `'${word.replaceAll("'", "'\\''")}'`;

/** The characters of a text that no list such as 0x20-0x7E,0xB0 has. */
function beyond(lists, text) {
  const ranges = lists.flatMap((list) => list.split(','))
    .map((range) => range.split('-').map(Number));
  return [...new Set(text)].filter((char) => !ranges.some(([first, last = first]) =>
    first <= char.codePointAt(0) && char.codePointAt(0) <= last)).join('');
}

/** What the controls ask for, as arguments of inkcell-fontgen. */
function argumentsOf(screenText) {
  const names = Object.keys(files);
  const font = names.find((name) => !isIcon(name));
  const args = font ? ['--font', font] : [];
  const add = (option, ...values) => values.forEach((value) => args.push(option, value));
  const lists = [...document.querySelectorAll('[name=set]:checked')].map((set) => set.value);
  const more = beyond(lists, $('symbols').value + ($('mine').checked ? screenText : ''));
  if (font) {
    add('--chars', ...lists);
    if (more) add('--symbols', more);
  }
  names.filter(isIcon).forEach((name, i) =>
    add('--svg', `${name}=0x${(0xE000 + i).toString(16).toUpperCase()}`));
  for (const axis of document.querySelectorAll('#axes input')) {
    if (axis.value !== axis.dataset.usual) add('--axis', `${axis.dataset.tag}=${axis.value}`);
  }
  if ($('min').value !== '8') add('--min-px', $('min').value);
  if ($('max').value !== '64') add('--max-px', $('max').value);
  const precision = $('precision').value;
  if (precision === 'budget') add('--budget', `${$('budget').value}K`);
  else if (precision) add('--tolerance', precision), args.push('--best-effort');
  if ($('coding').value !== 'outline') add('--coding', $('coding').value);
  if (!$('hints').checked) add('--hints', 'off');
  return {args, name: identifier(font || 'icons')};
}

/** The line of CMake with the same arguments. */
function cmakeOf(args, name) {
  const words = [];
  let last = '';
  for (let i = 0; i < args.length; ++i) {
    const option = args[i].slice(2).replace('-', '_').toUpperCase();
    if (option === 'BEST_EFFORT') {
      words.push(option);
      continue;
    }
    const value = args[++i];
    // A list names its option once.
    words.push(...(option === last ? [] : [option]),
      /[\s";#$()\\]/.test(value) ? `[==[${value}]==]` : value);
    last = option;
  }
  return `inkcell_add_font(app NAME ${name} ${words.join(' ')})`;
}

function row(cells, head) {
  const line = document.createElement('tr');
  cells.forEach((text, i) => {
    const cell = document.createElement(head && i === 0 ? 'th' : 'td');
    cell.textContent = text;
    line.append(cell);
  });
  return line;
}

function showReport(report) {
  const {total, ...parts} = report.bytes;
  $('parts').replaceChildren(...Object.entries({...parts, total})
    .filter(([, bytes]) => bytes > 0)
    .map(([part, bytes]) => row([part, bytes.toLocaleString('en')], true)));
  const largest = Object.entries(report.bytes_per_glyph)
    .sort(([, a], [, b]) => b - a).slice(0, 8);
  $('largest').replaceChildren(...largest.map(([glyph, bytes]) =>
    row([glyph, bytes, `${report.error_per_glyph[glyph]}/255`], true)));
}

function showDownloads(made, name) {
  const links = Object.keys(NAMES).map((ending) => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([made[`font.${ending}`]]));
    link.download = `${name}.${ending}`;
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = `${NAMES[ending]}: ${link.download}`;
    button.onclick = () => link.click();
    return button;
  });
  $('downloads').replaceChildren(...links);
}

function stop() {
  ++turn;
  worker?.terminate();
  worker = null;
  $('go').disabled = Object.keys(files).length === 0;
  $('cancel').hidden = $('progress').hidden = true;
  $('count').textContent = '';
}

/** Waits for one run of the program in the worker. */
const run = (args) => new Promise((resolve, reject) => {
  worker.onmessage = ({data}) => {
    if (data.count) {
      $('progress').max = data.count;
      $('progress').value = data.done;
      $('count').textContent = `${data.done} of ${data.count} glyphs`;
    } else {
      resolve(data);
    }
  };
  worker.onerror = (event) => reject(new Error(event.message));
  worker.postMessage({module, files, args});
});

/** The characters on the screen first, which takes a second; then all. */
async function convert(page) {
  const {args, name} = argumentsOf(page.screenText());
  const begin = performance.now();
  const quick = args.includes('--font') && page.screenText().trim();
  if (quick && $('coding').value === 'outline' && !args.includes('--budget')) {
    const chars = args.filter((_, i) => !['--chars', '--symbols'].some((option) =>
      [args[i], args[i - 1]].includes(option)));
    const first = await run([...chars, '--symbols', quick, '--out', 'font.bin', '--quiet']);
    if (first.code === 0) page.show(first.files['font.bin'], `${name}, your text alone`);
  }
  const result = await run([...args, '--name', name, '--out', 'font.hpp', '--out', 'font.c',
    '--header', 'font.h', '--out', 'font.bin', '--report', 'report.json']);
  const seconds = ((performance.now() - begin) / 1000).toFixed(1);
  $('messages').textContent = result.err;
  $('messages').hidden = !result.err;
  if (result.code !== 0) {
    $('status').textContent = 'The generator has refused that:';
    return;
  }
  const {'report.json': json, ...made} = result.files;
  const report = JSON.parse(decoded(json));
  showReport(report);
  showDownloads(made, name);
  $('command').textContent = ['inkcell-fontgen', ...args, '--name', name, '--out',
    `${name}.hpp`].map(quoted).join(' ');
  $('cmake').textContent = cmakeOf(args, name);
  const [header, coding] = report.coding === 'outline'
    ? ['font.hpp', ''] : ['field/draw.hpp', 'inkcell::kFieldCoding, '];
  $('usage').textContent = `#include <inkcell/${header}>\n\n#include "${name}.hpp"\n\n` +
    'inkcell::Font font;\n' +
    `const inkcell::Status status = inkcell::Font::open(fonts::${name}, ${coding}font);`;
  $('result').hidden = false;
  $('status').textContent = `${report.bytes.total.toLocaleString('en')} bytes for every size, ` +
    `in ${seconds} s. No pixel is off by more than ${report.error.max}/255.`;
  if (report.coding === 'outline') {
    const icons = args.includes('--font') ? [] : Object.values(report.icons);
    page.show(made['font.bin'], `${name}, ${report.glyphs} glyphs: this font, any size`,
      String.fromCodePoint(...icons));
    $('status').textContent += ' The displays above show it.';
  }
}

async function choose(list) {
  files = {};
  for (const file of list) files[file.name] = new Uint8Array(await file.arrayBuffer());
  $('chosen').textContent = Object.keys(files).join(', ');
  const font = Object.keys(files).find((name) => !isIcon(name));
  $('axes').replaceChildren(...(font ? axesOf(files[font]) : []).map((axis) => {
    const label = document.createElement('label');
    const shown = document.createElement('output');
    const range = document.createElement('input');
    Object.assign(range, {type: 'range', min: axis.least, max: axis.most, step: 'any',
      value: axis.usual});
    range.step = axis.most - axis.least > 10 ? 1 : 0.01;
    Object.assign(range.dataset, {tag: axis.tag, usual: range.value});
    range.oninput = () => { shown.textContent = range.value; };
    range.oninput();
    label.htmlFor = range.id = `axis-${axis.tag}`;
    label.append(`Axis ${axis.tag} `, shown, range);
    return label;
  }));
  if (Object.keys(files).length) $('options').requestSubmit();
  else stop();
}

/**
 * @param {{fontgen: () => Promise<Uint8Array>, worker: () => Promise<Uint8Array>,
 *   screenText: () => string, show: (font: Uint8Array, label: string, text?: string) => void}} page
 */
export function startConverter(page) {
  $('files').onchange = () => choose($('files').files);
  const drop = $('drop');
  const over = (event) => {
    event.preventDefault();
    drop.classList.toggle('over', event.type === 'dragover');
  };
  for (const type of ['dragover', 'dragleave', 'drop']) document.addEventListener(type, over);
  document.addEventListener('drop', (event) => choose(event.dataTransfer.files));
  $('precision').onchange = () => {
    $('budget-label').hidden = $('precision').value !== 'budget';
  };
  $('cancel').onclick = () => {
    stop();
    $('status').textContent = 'Cancelled.';
  };
  $('options').onsubmit = async (event) => {
    event.preventDefault();
    stop();
    const mine = turn;
    $('go').disabled = true;
    $('cancel').hidden = $('progress').hidden = false;
    $('progress').removeAttribute('value');
    $('status').textContent = 'Starting the generator';
    try {
      const script = new Blob([await page.worker()], {type: 'text/javascript'});
      module ??= await WebAssembly.compile(await page.fontgen());
      if (mine !== turn) return;
      worker = new Worker(URL.createObjectURL(script));
      await convert(page);
    } catch (error) {
      $('status').textContent = error.message;
    }
    if (mine === turn) stop();
  };
}
