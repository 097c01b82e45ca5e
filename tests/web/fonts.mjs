// Compares fonts of inkcell-fontgen in WebAssembly with the host's, byte by byte,
// and its errors.
//
// Usage: node fonts.mjs GENERATOR_FOLDER HOST_FONTGEN FOLDER [CASE]
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename} from 'node:path';

import {runFontgen} from '../../fonts_gen/web/fontgen.mjs';

const [generator, host, folder, only] = process.argv.slice(2);
const factory = createRequire(import.meta.url)(`${generator}/inkcell-fontgen.js`);
const module = new WebAssembly.Module(
  readFileSync(`${generator}/inkcell-fontgen.wasm`));
const truetype = '/usr/share/fonts/truetype';
const text = (string) => new TextEncoder().encode(string);
const files = {
  'wifi.svg': text(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">
    <path d="M12 4.5C7.3 4.5 3.1 6.400.2 9.4l2 2C4.7 8.9 8.2 7.3 12 7.3z
    M9 18l3 3 3-3a4.2 4.2 0 0 0-6 0z"/><circle cx="1.25e1" cy="13" r="2.5"
    transform="rotate(30 12 13) scale(1.1)"/></svg>`),
  'words.txt': text('greeting = مرحبا بالعالم\nname = שלום 12\n'),
};
const letters = ['--symbols', 'Hamburgefonstiv 0123456789,.'];
const cases = {
  'TrueType': [`${truetype}/dejavu/DejaVuSans.ttf`, ...letters],
  'bold': [`${truetype}/dejavu/DejaVuSans-Bold.ttf`, ...letters],
  'serif': [`${truetype}/dejavu/DejaVuSerif.ttf`, ...letters],
  'fixed width': [`${truetype}/dejavu/DejaVuSansMono.ttf`, ...letters],
  'italic': [`${truetype}/liberation/LiberationSerif-Italic.ttf`, ...letters],
  'narrow': [`${truetype}/liberation/LiberationSansNarrow-Regular.ttf`, ...letters],
  'Roboto': [`${truetype}/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf`, ...letters],
  'WOFF2': [`${folder}/packed.woff2`, ...letters],
  'Devanagari': [`${truetype}/lohit-devanagari/Lohit-Devanagari.ttf`, '--symbols', 'अआकखग'],
  'Thai': [`${truetype}/tlwg/Loma.ttf`, '--symbols', 'กขคงจ'],
  'collection of CFF': ['/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc',
    '--symbols', '永字八法Ag', '--face', '1'],
  'field': [`${truetype}/dejavu/DejaVuSans.ttf`, '--symbols', 'aB', '--coding', 'field'],
  'shaped strings': [`${truetype}/dejavu/DejaVuSans.ttf`, '--strings', 'words.txt'],
  'icon': ['', '--svg', 'wifi.svg=0xE001'],
  'a budget': [`${truetype}/dejavu/DejaVuSans.ttf`, '--symbols', 'Hag0', '--budget', '700'],
};

rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
for (const [name, bytes] of Object.entries(files)) writeFileSync(`${folder}/${name}`, bytes);
copyFileSync(`${truetype}/liberation/LiberationSans-Regular.ttf`, `${folder}/packed.ttf`);
execFileSync('woff2_compress', ['packed.ttf'], {cwd: folder, stdio: 'ignore'});
const seconds = (usage) => (usage.user / 1e6).toFixed(2);
for (const [name, [font, ...options]] of Object.entries(cases)) {
  if (only && only !== name) continue;
  const outs = ['--out', 'font.hpp', '--out', 'font.c', '--header', 'font.h',
    ...(name === 'shaped strings' ? [] : ['--out', 'font.bin'])];
  const args = [...options, '--name', 'font', ...outs, '--quiet'];
  const native = spawnSync(host,
    [...(font ? ['--font', font] : []), ...args], {cwd: folder, encoding: 'utf8'});
  assert.equal(native.status, 0, native.stderr);
  const inputs = font ? {...files, [basename(font)]: readFileSync(font)} : files;
  const begin = process.cpuUsage();
  const web = await runFontgen(factory, module, inputs,
    [...(font ? ['--font', basename(font)] : []), ...args]);
  assert.equal(web.code, 0, web.err);
  assert.equal(web.err.replaceAll(`${font}`, ''), native.stderr.replaceAll(`${font}`, ''));
  for (const out of outs.filter((word) => word.includes('.'))) {
    assert.ok(readFileSync(`${folder}/${out}`).equals(web.files[out]), `${name}: ${out}`);
  }
  console.log(`${name}: ${(web.files['font.bin'] || web.files['font.hpp']).length} ` +
    `bytes equal, ${seconds(process.cpuUsage(begin))} s`);
}

// A font in parts, as workers build it: the same bytes. Times on one thread.
const dejavu = {'F.ttf': readFileSync(`${truetype}/dejavu/DejaVuSans.ttf`)};
async function timed(inputs, ...args) {
  const begin = process.cpuUsage();
  const result = await runFontgen(factory, module, inputs,
    ['--font', 'F.ttf', '--quiet', ...args]);
  assert.equal(result.code, 0, result.err);
  return {...result, seconds: process.cpuUsage(begin).user / 1e6};
}
if (!only) {
  const whole = await timed(dejavu, '--out', 'f.bin');
  const screen = await timed(dejavu, '--symbols', 'Temperature 23.5 °C!', '--out', 'f.bin');
  const cores = 4;
  const load = Array(cores).fill(0);  // as workers take part after part
  load[0] = screen.seconds;
  const built = {};
  for (let part = 0; part < 2 * cores; ++part) {
    const made = await timed(dejavu, '--part', `${part}/${2 * cores}`, '--out', `${part}.glyphs`);
    load[load.indexOf(Math.min(...load))] += made.seconds;
    Object.assign(built, made.files);
  }
  const merged = await timed({...dejavu, ...built},
    ...Object.keys(built).flatMap((name) => ['--built', name]), '--out', 'f.bin');
  execFileSync(host, ['--font', `${truetype}/dejavu/DejaVuSans.ttf`, '--quiet', '--out',
    'whole.bin'], {cwd: folder});
  const native = readFileSync(`${folder}/whole.bin`);
  assert.ok(native.equals(whole.files['f.bin']), 'ASCII');
  assert.ok(native.equals(merged.files['f.bin']), 'ASCII in parts');
  const path = Math.max(...load) + merged.seconds;
  console.log(`ASCII: ${whole.seconds.toFixed(2)} s of processor time in one run; ` +
    `${path.toFixed(2)} s on ${cores} cores, of it putting together ` +
    `${merged.seconds.toFixed(2)} s; 20 characters ${screen.seconds.toFixed(2)} s`);
  assert.ok(path < 0.75 * whole.seconds, 'parts do not pay');
}

// Progress, the report, and what is refused.
const input = {'F.ttf': readFileSync(`${truetype}/dejavu/DejaVuSans.ttf`)};
const heard = [];
const report = await runFontgen(factory, module, input,
  ['--font', 'F.ttf', '--symbols', 'ab', '--out', 'f.bin', '--report', 'r.json'],
  (done, count) => heard.push([done, count]));
assert.equal(report.code, 0, report.err);
assert.ok(heard.length > 0 && heard.every(([done, count]) => done <= count && count === 6),
  JSON.stringify(heard));
assert.equal(JSON.parse(new TextDecoder().decode(report.files['r.json'])).bytes.total,
  report.files['f.bin'].length);
assert.match(report.out, /bytes/);
for (const [args, reason] of [
  [['--font', 'none.ttf', '--out', 'f.bin'], /^error: none\.ttf: /],
  [['--font', 'F.ttf', '--tolerance', '0', '--out', 'f.bin'], /within 1\/255\.\.255\/255/],
  [['--font', 'F.ttf', '--symbols', 'a', '--out', 'f.bin', '--preview', 'p.png'],
    /no libpng; leave --preview out/]]) {
  const refused = await runFontgen(factory, module, input, args);
  assert.equal(refused.code, 1);
  assert.match(refused.err, reason);
  assert.deepEqual(Object.keys(refused.files), []);
}
console.log('progress, report and errors as on the host');
