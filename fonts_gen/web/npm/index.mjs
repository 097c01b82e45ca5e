// inkcell-fontgen for programs: files in, files out.
//
//   import {fontgen} from 'inkcell-fontgen';
//   const {code, err, files} = await fontgen({'A.ttf': bytes},
//     ['--font', 'A.ttf', '--out', 'a.hpp']);
import {readFileSync} from 'node:fs';

import factory from './inkcell-fontgen.cjs';
import {runFontgen} from './fontgen.mjs';

export const module = new WebAssembly.Module(
  readFileSync(new URL('inkcell-fontgen.wasm', import.meta.url)));
export {factory};

/**
 * Runs the program once.
 * @param {Record<string, Uint8Array>} files what it may read, by name
 * @param {string[]} args
 * @param {(done: number, count: number) => void} [progress] glyphs
 */
export const fontgen = (files, args, progress) =>
  runFontgen(factory, module, files, args, progress);
