#!/usr/bin/env node
// inkcell-fontgen on the disk of this machine, by WebAssembly.
import {readFileSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';

import {factory, module} from './index.mjs';
import {runFontgen} from './fontgen.mjs';

// Options whose value is a path or begins with one.
const PATHS = ['--font', '--text-file', '--strings-from', '--strings', '--merge', '--svg',
  '--svg-dir', '--out', '--header', '--report', '--preview', '--depfile', '--built'];
const windows = process.platform === 'win32';

/** @type {Record<string, string>} */
const mounts = {};

/** Where the program finds a path of this machine. @param {string} path */
function placed(path) {
  const slashed = windows ? path.replaceAll('\\', '/') : path;
  const [, drive = '', rest] = /^([A-Za-z]:)?(\/.*)$/.exec(slashed) ?? [];
  if (rest === undefined) return slashed;  // it is relative
  const whole = drive || (windows ? process.cwd().slice(0, 2) : '');
  const place = whole ? `/disk/${whole[0].toLowerCase()}` : '/disk';
  mounts[place] = `${whole}/`;
  return place + rest;
}

/** Paths of the program as those of this machine. @param {string} text */
const ours = (text) => windows ? text.replace(/\/disk\/([a-z])\//g, '$1:/')
                               : text.replaceAll('/disk/', '/');

let depfile = '';
const args = process.argv.slice(2).map((word, i, all) => {
  const [, option, value] = /^(--[\w-]+)=(.*)$/s.exec(word) ?? [];
  if (option === '--depfile') depfile = value;
  if (all[i - 1] === '--depfile') depfile = word;
  return PATHS.includes(option) ? `${option}=${placed(value)}`
    : PATHS.includes(all[i - 1]) ? placed(word) : word;
});

const shows = process.stderr.isTTY && !args.includes('--quiet');
const result = await runFontgen(factory, module, {}, args, (done, count) => {
  if (shows) process.stderr.write(`\r${done} of ${count} glyphs\x1b[K`);
}, {at: placed(process.cwd().replaceAll('\\', '/')), mounts});
if (shows) process.stderr.write('\r\x1b[K');
if (result.code === 0 && depfile) {
  const file = resolve(depfile);
  writeFileSync(file, ours(readFileSync(file, 'utf8')));
}
process.stderr.write(ours(result.err));
process.stdout.write(ours(result.out));
process.exitCode = result.code;
