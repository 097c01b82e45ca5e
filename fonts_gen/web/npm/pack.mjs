// Puts the npm package inkcell-fontgen together: `npm pack` or `npm publish` of the
// folder do the rest.
//
// Usage: node pack.mjs GENERATOR_FOLDER VERSIONS FOLDER
import {copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const [generator, versions, folder] = process.argv.slice(2);
const root = resolve(dirname(fileURLToPath(import.meta.url)), '../../..');
const text = (file) => readFileSync(`${root}/${file}`, 'utf8');
const [, version] = /inkcell VERSION ([\d.]+)/.exec(text('CMakeLists.txt'));

const files = ['cli.mjs', 'index.mjs', 'fontgen.mjs', 'inkcell-fontgen.cjs',
  'inkcell-fontgen.wasm'];
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
for (const [from, to] of [
  [`${root}/fonts_gen/web/npm/cli.mjs`, 'cli.mjs'],
  [`${root}/fonts_gen/web/npm/index.mjs`, 'index.mjs'],
  [`${root}/fonts_gen/web/fontgen.mjs`, 'fontgen.mjs'],
  [`${root}/LICENSE`, 'LICENSE'],
  [`${generator}/inkcell-fontgen.js`, 'inkcell-fontgen.cjs'],
  [`${generator}/inkcell-fontgen.wasm`, 'inkcell-fontgen.wasm']]) {
  copyFileSync(from, `${folder}/${to}`);
}
writeFileSync(`${folder}/README.md`, text('fonts_gen/web/npm/README.md')
  .replaceAll('{VERSION}', version)
  .replace('{LIBRARIES}', readFileSync(versions, 'utf8').trim().split('\n').join(', ')));
writeFileSync(`${folder}/package.json`, `${JSON.stringify({
  name: 'inkcell-fontgen', version, description: 'Fonts for microcontrollers, of any size',
  license: 'MIT', type: 'module', engines: {node: '>=18'}, bin: {'inkcell-fontgen': 'cli.mjs'}, exports: './index.mjs', files,
}, null, 2)}\n`);
console.log(`${folder}: inkcell-fontgen ${version}`);
