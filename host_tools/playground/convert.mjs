// Converts the reader's fonts by inkcell-fontgen in workers.
import {$, addCopy, bytesOf, copyLink, restore, sizesOf} from './dom.mjs';
import {Generator} from './generator.mjs';
import {argumentsOf, charactersOf, faceNames, isFont, isIcon, withoutCharacters}
  from './options.mjs';
import {compareBitmaps, refreshLines, showReport} from './report.mjs';

/**
 * @typedef {object} Page
 * @property {import('../../port/web/inkcell.mjs').Core} core
 * @property {() => Promise<Uint8Array>} fontgen
 * @property {() => Promise<string>} worker
 * @property {() => string} screenText
 * @property {() => import('../../port/web/inkcell.mjs').Look} look
 * @property {(font: Uint8Array, label: string, text?: string) => void} show
 * @property {(font?: Uint8Array) => void} showPart without a font: the last whole one again
 */

const MOST_WORKERS = 8;

/** @type {Record<string, Uint8Array>} */
let files = {};  // chosen, by name
/** @type {Record<string, Uint8Array>} */
let good = {};  // those of the results
let goodFace = '';  // of a collection
let turn = 0;  // of the conversion that is wanted
let shown = '';  // the font of the results
/** Of the results: what was asked for, and the status. */
let asked = '';
let told = '';
let refused = false;  // whether the status is a refusal
let done = 0;  // of the conversion, 0 to 1
/** @type {number | undefined} */
let timer;
/** @type {Generator} */
let generator;

/** @param {string} name */
const isDrawn = (name) => isFont(name) || isIcon(name);

/** A status, and what the generator says with it. @param {string} status */
function say(status, messages = '') {
  refused = false;
  $('status').textContent = status;
  $('messages').textContent = messages;
  $('messages').hidden = !messages;
}

/** What the results are of, after a conversion that gave none. @param {string} what */
const still = (what, end = '.') => shown ? `${what}; below is still ${shown}.` : `${what}${end}`;

/** What the controls ask for. @param {Page} page */
const asksFor = (page) =>
  JSON.stringify(argumentsOf(Object.keys(files), page.screenText()));

/**
 * A conversion that gave none: the generator's words, and the last good files.
 * @param {Page} page @param {string} messages
 * @param {boolean} isRead whether the files could be read, but not with these settings
 */
function refuse(page, messages, isRead) {
  const names = Object.keys(files).filter(isDrawn);
  say(still(isRead ? 'These settings were refused' : `${names.join(', ')} ` +
    `${names.length === 1 ? 'was' : 'were'} refused`, ':'), messages);
  refused = true;
  if (!isRead && shown) {
    files = good;
    showFiles();
    showFaces();
    $('face').value = goodFace;
  }
  page.showPart();
}

/** @param {Uint8Array} bytes */
const decoded = (bytes) => JSON.parse(new TextDecoder().decode(bytes));

function stop() {
  ++turn;
  clearInterval(timer);
  $('passed').textContent = '';
  generator.stop();
  $('result').inert = false;
  $('go').disabled = Object.keys(files).length === 0;
  $('cancel').hidden = $('progress').hidden = true;
  $('convert-link').hidden = false;
}

/** The seconds that passed, and those that are left. */
function startTimer() {
  const begin = performance.now();
  done = 0;
  timer = setInterval(() => {
    const passed = (performance.now() - begin) / 1000;
    const left = Math.ceil(passed / done - passed);
    $('passed').textContent = `${Math.floor(passed)} s` +
      (done > 0.05 && done < 1 ? `, about ${left} s left` : '');
  }, 250);
}

/** Sliders for the axes of a variable font. @param {any} report */
function showAxes(report) {
  const {axes = {}} = report.faces?.[0] || {};
  $('axes').replaceChildren(...Object.entries(axes).map(([tag, axis]) => {
    const label = document.createElement('label');
    const shown = document.createElement('output');
    const range = document.createElement('input');
    Object.assign(range, {type: 'range', min: axis.min, max: axis.max,
      step: axis.max - axis.min > 10 ? 1 : 0.01, value: axis.default});
    Object.assign(range.dataset, {tag, usual: range.value, keep: ''});
    label.htmlFor = range.id = `axis-${tag}`;
    restore([range]);
    range.oninput = () => { shown.textContent = range.value; };
    shown.textContent = range.value;
    label.append(`Axis ${tag} `, shown, range);
    return label;
  }));
}

/** Faces of a collection. */
function showFaces() {
  const bytes = files[Object.keys(files).find(isFont) ?? ''];
  const names = bytes ? faceNames(bytes) : [];
  $('face-label').hidden = names.length < 2;
  $('face').replaceChildren(...names.map((name, i) => new Option(name, `${i}`)));
}

/**
 * The characters on the screen, which takes a second.
 * @param {Page} page @param {string[]} args
 */
async function showFirst(page, args) {
  const mine = turn;
  const text = page.screenText().trim();
  if (!text || !args.includes('--font') || args.includes('field')) return;
  const first = await generator.run(files, [...withoutCharacters(args)
    .filter((word, i, all) => ![word, all[i - 1]].includes('--budget')),
  '--symbols', text, '--out', 'font.bin', '--quiet'], () => {});
  if (mine !== turn) return;
  if (first.code === 0) page.showPart(first.files['font.bin']);
}

/** @param {Page} page */
async function convert(page) {
  const {args, name} = argumentsOf(Object.keys(files), page.screenText());
  const now = asksFor(page);
  const begin = performance.now();
  const outs = ['--name', name, '--out', 'font.hpp', '--out', 'font.c',
    '--header', 'font.h', '--out', 'font.bin', '--report', 'report.json'];
  const mine = turn;
  const result = await generator.convert(files, args, outs, (part) => {
    if (mine !== turn) return;
    done = part;
    $('progress').value = part;
    $('status').textContent = args.includes('--budget')
      ? 'Converting several times, for the limit of bytes'
      : part < 1 ? 'Converting glyphs' : 'Hints, and a last check, which takes a few seconds';
  }, () => showFirst(page, args));
  if (mine !== turn) return;
  const seconds = (performance.now() - begin) / 1000;
  if (result.code !== 0) {
    refuse(page, result.err, args.includes('--font'));
    return;
  }
  const {'report.json': json, ...made} = result.files;
  const report = decoded(json);
  good = files;
  goodFace = $('face').value;
  asked = now;
  const added = [...report.added?.characters ?? ''].join(' and ');
  const characters = (report.characters === 1 ? '1 character'
    : `${report.characters} characters`) + (added && `, with ${added} for broken lines`);
  if (report.coding === 'outline') {
    const icons = args.includes('--font') ? [] : Object.values(report.icons);
    page.show(made['font.bin'], `${report.font}, ${characters}, ${sizesOf(report.min_px, report.max_px)}`,
      String.fromCodePoint(...icons));
  } else {
    page.showPart();
  }
  showReport(page.core, report, made, name, args, page.screenText(), page.look());
  say(`${bytesOf(report.bytes.total)} for ${sizesOf(report.min_px, report.max_px)}. ` +
    `With the filter 'text' no pixel is off by more than ` +
    `${report.error.max.toFixed(1)}/255. ${report.font}: ${characters} in ` +
    `${seconds.toFixed(1)} s, by ${generator.count} ` +
    `${generator.count === 1 ? 'worker' : 'workers'}.` +
    (report.coding === 'outline' ? ' The displays above show it.' : ''), result.err);
  shown = report.font;
  told = $('status').textContent;
  $('result').dataset.seconds = seconds.toFixed(2);
  $('status').scrollIntoView({block: 'start'});
  $('result').dataset.count = `${Number($('result').dataset.count ?? 0) + 1}`;
}

/** @param {Page} page */
async function submit(page) {
  stop();
  const names = Object.keys(files);
  if (names.some(isFont) && !charactersOf(names, page.screenText())) {
    say('Choose characters first: a list, the text above, or more.');
    page.showPart();
    return;
  }
  const mine = turn;
  $('go').disabled = $('result').inert = true;
  $('cancel').hidden = $('progress').hidden = false;
  $('convert-link').hidden = true;
  $('progress').removeAttribute('value');
  startTimer();
  $('status').scrollIntoView({block: 'nearest'});
  say('Starting the generator');
  try {
    await generator.start();
    if (mine !== turn) return;
    if ($('axes').dataset.of !== $('chosen').textContent) {
      // What the file has, whatever its container: the generator's own report.
      const font = Object.keys(files).find(isFont);
      const tried = font && await generator.run(files, ['--font', font, '--symbols', ' ',
        '--out', 'font.bin', '--report', 'report.json', '--quiet'], () => {});
      if (mine !== turn) return;
      if (tried && tried.code !== 0) {
        refuse(page, tried.err, false);
        stop();
        return;
      }
      $('axes').dataset.of = $('chosen').textContent;
      showAxes(tried ? decoded(tried.files['report.json']) : {});
    }
    await convert(page);
  } catch (error) {
    say(/** @type {Error} */ (error).message);
    page.showPart();
  }
  if (mine === turn) stop();
}

function showFiles() {
  const names = Object.keys(files);
  $('chosen').textContent = names.filter(isDrawn).join(', ');
  $('sources-chosen').textContent = names.filter((name) => !isDrawn(name)).join(', ');
  $('no-sources').hidden = names.every(isDrawn);
}

/** Fonts and icons replace each other; so do sources and texts. @param {FileList} list */
async function choose(list) {
  say('');
  const chosen = [...list];
  const kinds = new Set(chosen.map(({name}) => isDrawn(name)));
  files = Object.fromEntries(Object.entries(files).filter(([name]) => !kinds.has(isDrawn(name))));
  for (const file of chosen) files[file.name] = new Uint8Array(await file.arrayBuffer());
  showFiles();
  const names = Object.keys(files);
  $('characters').disabled = names.some(isIcon) && !names.some(isFont);
  if (kinds.has(true)) showFaces();
  if (names.some(isDrawn)) $('options').requestSubmit();
  else stop();
}

/** @param {Page} page */
export function startConverter(page) {
  generator = new Generator(page.fontgen, page.worker,
    Math.max(1, Math.min(MOST_WORKERS, navigator.hardwareConcurrency || 1)));
  $('to-convert').onclick = () => {
    $('convert').scrollIntoView();
    // The browser would scroll to the input, which is not seen.
    $('files').focus({preventScroll: true});
  };
  for (const id of ['files', 'sources']) {
    $(id).onchange = () => choose($(id).files);
    // The same file again, after it has changed.
    $(id).onclick = () => { $(id).value = ''; };
  }
  $('no-sources').onclick = () => {
    files = Object.fromEntries(Object.entries(files).filter(([name]) => isDrawn(name)));
    showFiles();
    $('sources').focus();
  };
  const over = (/** @type {DragEvent} */ event) => {
    event.preventDefault();
    $('drop').classList.toggle('over', event.type === 'dragover');
  };
  document.addEventListener('dragover', over);
  document.addEventListener('dragleave', over);
  document.addEventListener('drop', (event) => {
    over(event);
    if (event.dataTransfer?.files.length) choose(event.dataTransfer.files);
  });
  const showBudget = () => { $('budget-label').hidden = $('precision').value !== 'budget'; };
  $('precision').onchange = showBudget;
  showBudget();
  $('cancel').onclick = () => {
    stop();
    page.showPart();
    say(still('Cancelled'));
    $('go').focus();
  };
  $('options').onsubmit = (/** @type {Event} */ event) => {
    event.preventDefault();
    submit(page);
  };
  const checkSizes = () => $('max').setCustomValidity(
    Number($('max').value) < Number($('min').value)
      ? `From (${$('min').value} px) is above to (${$('max').value} px).` : '');
  $('options').oninput = () => {
    checkSizes();
    // The words of a refusal say what to change.
    if (shown && !refused && !$('result').inert) {
      $('status').textContent = asksFor(page) === asked
        ? told : 'Settings have changed. Convert again for a font with them.';
    }
  };
  checkSizes();
  // The programs are of the displays, which change after a conversion.
  const refresh = () => {
    if (shown && !$('built-in').hidden && !$('result').inert) {
      refreshLines(page.screenText(), page.look());
    }
  };
  $('try').addEventListener('change', refresh);
  $('try').addEventListener('click', refresh);
  if (location.hash) $('status').textContent = 'The link has brought settings; a font is missing.';
  $('sizes').oninput = $('bits').onchange = () => compareBitmaps(page.core);
  document.querySelectorAll('#result pre').forEach((/** @type {any} */ listing) =>
    addCopy(listing));
  $('convert-link').onclick = () => copyLink($('convert-note'));
}
