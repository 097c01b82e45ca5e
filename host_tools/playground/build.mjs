// Puts the page together: one HTML file, without a server.
//
// Usage: node build.mjs CORE.wasm GENERATOR_FOLDER VERSIONS FONT.ttf OUT.html
import assert from 'node:assert/strict';
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, dirname, resolve} from 'node:path';
import {gzipSync} from 'node:zlib';

import {runFontgen} from '../../fonts_gen/web/fontgen.mjs';

const [coreFile, generator, versions, fontFile, out] = process.argv.slice(2);
const here = import.meta.dirname ?? dirname(new URL(import.meta.url).pathname);
const text = (file) => readFileSync(resolve(here, file), 'utf8');
const packed = (bytes) => gzipSync(bytes, {level: 9}).toString('base64');
const hash = (content) =>
  `'sha256-${createHash('sha256').update(content).digest('base64')}'`;

/** Modules as one, each after those that it imports. */
function joined(file, done = new Set()) {
  const path = resolve(here, file);
  if (done.has(path)) return '';
  done.add(path);
  let before = '';
  const body = readFileSync(path, 'utf8').replace(
    /^import [^;]*? from '(\..*?)';\n/gm, (_, name) => {
      before += joined(resolve(dirname(path), name), done);
      return '';
    }).replace(/^export /gm, '');
  // Names that are local in their modules stay so.
  const names = [...readFileSync(path, 'utf8').matchAll(
    /^export (?:async )?(?:function|class|const) (\w+)/gm)].map(([, name]) => name);
  return names.length === 0 ? `${before}${body}`
    : `${before}const {${names}} = (() => {\n${body}return {${names}};\n})();\n`;
}

const fontgenFile = `${generator}/inkcell-fontgen`;
const fontgen = readFileSync(`${fontgenFile}.wasm`);
const made = await runFontgen(createRequire(import.meta.url)(`${fontgenFile}.js`),
  new WebAssembly.Module(fontgen), {[basename(fontFile)]: readFileSync(fontFile)},
  ['--font', basename(fontFile), '--quiet', '--out', 'font.bin']);
assert.equal(made.code, 0, made.err);

const style = text('page.css');
const script = joined('page.mjs');
const worker = [readFileSync(`${fontgenFile}.js`, 'utf8'),
  text('../../fonts_gen/web/fontgen.mjs').replace(/^export /gm, ''), text('worker.js')];
const [, version] = /inkcell VERSION ([\d.]+)/.exec(text('../../CMakeLists.txt'));
const parts = {
  STYLE: style, STYLE_HASH: hash(style), SCRIPT: script, SCRIPT_HASH: hash(script),
  VERSION: version,
  LIBRARIES: readFileSync(versions, 'utf8').trim().split('\n').join(', '),
  CORE: packed(readFileSync(coreFile)), FONT: packed(made.files['font.bin']),
  FONTGEN: packed(fontgen),
  WORKER: packed(worker.join('\n')),
};
const page = text('page.html').replace(/\{([A-Z_]+)\}/g, (_, name) => {
  assert.ok(name in parts, `{${name}} in page.html is unknown`);
  return parts[name];
});
writeFileSync(out, page);
console.log(`${out}: ${page.length} bytes, built-in font ${made.files['font.bin'].length}`);
