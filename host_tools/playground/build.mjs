// Puts the page together, twice: as one HTML file, which needs no server, and as
// files for a web server, which a service worker keeps for use without a network.
//
// Usage: node build.mjs CORE.wasm GENERATOR_FOLDER VERSIONS FONT.ttf OUT.html FOLDER
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {basename, dirname, join, resolve} from 'node:path';

import {runFontgen} from '../../fonts_gen/web/fontgen.mjs';

const [coreFile, generator, versions, fontFile, out, folder] = process.argv.slice(2);
const here = import.meta.dirname ?? dirname(new URL(import.meta.url).pathname);
const text = (file) => readFileSync(resolve(here, file), 'utf8');
const sha256 = (content) => createHash('sha256').update(content);
const hash = (content) => `'sha256-${sha256(content).digest('base64')}'`;

/** Without lines of comments. */
const bare = (script) => script.replace(/^\s*\/\*\*(?:(?!\*\/)[^])*\*\/\s*$/gm, '')
  .replace(/^\s*\/\/.*$/gm, '').replace(/\n\s*\n/g, '\n');

/** Modules as one, each after those that it imports. */
function joined(file, done = new Set()) {
  const path = resolve(here, file);
  if (done.has(path)) return '';
  done.add(path);
  let before = '';
  const source = readFileSync(path, 'utf8');
  const body = source.replace(/^import [^;]*? from '(\..*?)';\n/gm, (_, name) => {
    before += joined(resolve(dirname(path), name), done);
    return '';
  }).replace(/^export /gm, '');
  // Names that are local in their modules stay so.
  const names = [...source.matchAll(/^export (?:async )?(?:function|class|const) ([\w$]+)/gm)]
    .map(([, name]) => name);
  return names.length === 0 ? `${before}${body}`
    : `${before}const {${names}} = (() => {\n${body}return {${names}};\n})();\n`;
}

/**
 * Seven bits a character, the lowest first: of ASCII, but that one of two bytes
 * stands for what HTML would change, NUL, CR and '<' (parts.mjs).
 */
function sevenBits(bytes) {
  const codes = [];
  let bits = 0;
  let count = 0;
  const put = () => {
    const code = bits & 127;
    codes.push([0, 13, 60].includes(code) ? code | 128 : code);
    bits >>= 7;
    count -= 7;
  };
  for (const byte of bytes) {
    bits |= byte << count;
    for (count += 8; count >= 7;) put();
  }
  if (count > 0) put();
  return codes.map((code) => String.fromCharCode(code)).join('');
}

/** By zopfli, in seconds: 5 % less than zlib's. */
function gzip(bytes) {
  const place = mkdtempSync(join(tmpdir(), 'inkcell-'));
  const file = join(place, 'bytes');
  writeFileSync(file, bytes);
  const packed = execFileSync('zopfli', ['-c', '--i5', file], {maxBuffer: 1 << 26});
  rmSync(place, {recursive: true});
  return packed;
}

const fontgenFile = `${generator}/inkcell-fontgen`;
const fontgen = readFileSync(`${fontgenFile}.wasm`);
const made = await runFontgen(createRequire(import.meta.url)(`${fontgenFile}.js`),
  new WebAssembly.Module(fontgen), {[basename(fontFile)]: readFileSync(fontFile)},
  ['--font', basename(fontFile), '--quiet', '--out', 'font.bin']);
assert.equal(made.code, 0, made.err);

const style = text('page.css');
const script = bare(joined('page.mjs'));
const data = {
  'core.wasm': readFileSync(coreFile),
  'font.bin': Buffer.from(made.files['font.bin']),
  'fontgen.wasm': fontgen,
  'worker.js': Buffer.from([readFileSync(`${fontgenFile}.js`, 'utf8'),
    bare(text('../../fonts_gen/web/fontgen.mjs').replace(/^export /gm, '')),
    bare(text('worker.js'))].join('\n')),
};
const [, version] = /inkcell VERSION ([\d.]+)/.exec(text('../../CMakeLists.txt'));

/** page.html with its parts. */
const page = (parts) => text('page.html').replace(/\{([A-Z_]+)\}/g, (_, name) => {
  const all = {...parts, VERSION: version,
    LIBRARIES: readFileSync(versions, 'utf8').trim().split('\n').join(', ')};
  assert.ok(name in all, `{${name}} in page.html is unknown`);
  return all[name];
});
const policy = (parts) => Object.entries({'default-src': "'none'", ...parts,
  'base-uri': "'none'", 'form-action': "'none'"}).map((words) => words.join(' ')).join('; ');

const single = page({
  POLICY: policy({'script-src': `${hash(script)} 'wasm-unsafe-eval' blob:`,
    'worker-src': 'blob:', 'style-src': hash(style), 'connect-src': "'none'"}),
  STYLE: `<style>${style}</style>`,
  DATA: Object.entries(data).map(([name, bytes]) => {
    const packed = gzip(bytes);
    return `<script type="text/plain" id="data:${name}" data-bytes="${packed.length}">` +
      `${sevenBits(packed)}</script>\n`;
  }).join(''),
  SCRIPT: `<script type="module">${script}</script>`,
});
writeFileSync(out, single);

const files = {
  'index.html': Buffer.from(page({
    POLICY: policy({'script-src': "'self' 'wasm-unsafe-eval'", 'worker-src': "'self'",
      'style-src': "'self'", 'connect-src': "'self'"}),
    STYLE: '<link rel="stylesheet" href="page.css">',
    DATA: '',
    SCRIPT: '<script type="module" src="page.js"></script>',
  })),
  'page.css': Buffer.from(style), 'page.js': Buffer.from(script), ...data,
};
const all = sha256('');
for (const bytes of Object.values(files)) all.update(bytes);
const service = `const FILES = ${JSON.stringify(['./', ...Object.keys(files)])};\n` +
  `const VERSION = '${all.digest('hex').slice(0, 16)}';\n${text('service.js')}`;
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
for (const [name, bytes] of Object.entries({...files, 'service.js': service})) {
  writeFileSync(`${folder}/${name}`, bytes);
}
console.log(`${out}: ${Buffer.byteLength(single)} bytes, built-in font ${data['font.bin'].length}; ` +
  `${folder}: ${Object.keys(files).length + 1} files for a web server`);
