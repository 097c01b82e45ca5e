// What the controls ask for, as the generator's command line and for CMake.
import {$} from './dom.mjs';

/** @param {string} name */
export const isIcon = (name) => /\.svg$/i.test(name);
/** @param {string} name */
export const isFont = (name) => /\.(ttf|otf|ttc|otc|woff2?)$/i.test(name);
// Of xml, arb and ts of Qt the generator says what to do.
/** @param {string} name */
const isSource = (name) =>
  /\.([ch]|cc|cpp|cxx|hh|hpp|hxx|ino|po|pot|ts|xml|arb|json|csv)$/i.test(name);

/**
 * The names of the faces of a collection; no name if the file is none.
 * @param {Uint8Array} bytes
 */
export function faceNames(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  if (bytes.length < 12 || view.getUint32(0) !== 0x74746366) return [];  // 'ttcf'
  return Array.from({length: Math.min(99, view.getUint32(8))}, (_, face) => {
    try {
      const font = view.getUint32(12 + 4 * face);
      for (let i = 0; i < view.getUint16(font + 4); ++i) {
        if (view.getUint32(font + 12 + 16 * i) !== 0x6e616d65) continue;  // 'name'
        const table = view.getUint32(font + 20 + 16 * i);
        const text = table + view.getUint16(table + 4);
        for (let at = table + 6; at < table + 6 + 12 * view.getUint16(table + 2); at += 12) {
          // The full name in UTF-16, in whatever language comes first.
          if (view.getUint16(at) !== 3 || view.getUint16(at + 6) !== 4) continue;
          const begin = text + view.getUint16(at + 10);
          return `${face}: ${new TextDecoder('utf-16be')
            .decode(bytes.subarray(begin, begin + view.getUint16(at + 8)))}`;
        }
      }
    } catch {
      // Cut off: the generator says so.
    }
    return `${face}`;
  });
}

/** An identifier of C from a file's name. @param {string} name */
export const identifier = (name) =>
  name.replace(/\.\w+$/, '').replace(/\W+/g, '_').replace(/^(\d|$)/, 'font_$1');

/** A word of a shell's line. @param {string} word */
export const quoted = (word) => /^[\w.,:=+%/-]+$/.test(word)
  ? word : `'${word.replaceAll("'", "'\\''")}'`;

/**
 * The characters of a text that no list such as 0x20-0x7E,0xB0 has.
 * @param {string[]} lists @param {string} text
 */
function beyond(lists, text) {
  const ranges = lists.flatMap((list) => list.split(','))
    .map((range) => range.split('-').map(Number));
  return [...new Set(text)].filter((char) => !ranges.some(([first, last = first]) => {
    const code = char.codePointAt(0) ?? 0;
    return first <= code && code <= last;
  })).join('');
}

/**
 * The options that name characters, or null if there are none.
 * @param {string[]} names of the files
 * @param {string} screenText
 */
export function charactersOf(names, screenText) {
  const lists = [...document.querySelectorAll('[name=set]:checked')]
    .map((/** @type {any} */ set) => set.value);
  const more = beyond(lists, $('symbols').value + ($('mine').checked ? screenText : ''));
  const texts = names.filter((name) => !isFont(name) && !isIcon(name));
  const args = [...lists.map((list) => ['--chars', list]), ...(more ? [['--symbols', more]] : []),
    ...texts.filter(isSource).map((name) => ['--strings-from', name]),
    ...texts.filter((name) => !isSource(name)).map((name) => ['--text-file', name])].flat();
  return args.length > 0 ? args : null;
}

/**
 * @param {string[]} names of the files
 * @param {string} screenText
 */
export function argumentsOf(names, screenText) {
  const font = names.find(isFont);
  const args = font ? ['--font', font] : [];
  /** @param {string} option @param {string[]} values */
  const add = (option, ...values) => values.forEach((value) => args.push(option, value));
  if (font) {
    if (!$('face-label').hidden) add('--face', $('face').value);
    args.push(...charactersOf(names, screenText) ?? []);
  }
  names.filter(isIcon).forEach((name, i) =>
    add('--svg', `${name}=0x${(0xE000 + i).toString(16).toUpperCase()}`));
  /** @type {NodeListOf<HTMLInputElement>} */
  const axes = document.querySelectorAll('#axes input');
  for (const axis of axes) {
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

/** Arguments without those of characters. @param {string[]} args */
export const withoutCharacters = (args) => args.filter((_, i) =>
  !['--chars', '--symbols', '--strings-from', '--text-file'].some((option) =>
    [args[i], args[i - 1]].includes(option)));

/**
 * The line of CMake with the same arguments.
 * @param {string[]} args @param {string} name
 */
export function cmakeOf(args, name) {
  const words = [];
  let last = '';
  for (let i = 0; i < args.length; ++i) {
    const option = args[i].slice(2).replaceAll('-', '_').toUpperCase();
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
