// Tests the npm package inkcell-fontgen as it is installed, against the host's
// program: bytes, help, errors, exit codes, files on the disk.
//
// Usage: node npm.mjs PACKAGE_FOLDER HOST_FONTGEN FOLDER [NODE]
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [source, host, folder, node = process.execPath] = process.argv.slice(2);
const FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf';
rmSync(folder, {recursive: true, force: true});
mkdirSync(`${folder}/project/deep`, {recursive: true});
const [{filename}] = JSON.parse(execFileSync('npm',
  ['pack', '--json', '--pack-destination', folder, source], {encoding: 'utf8'}));
execFileSync('npm', ['install', '--offline', '--no-audit', '--no-fund', '--silent',
  '--prefix', folder, join(folder, filename)]);
const packed = `${folder}/node_modules/inkcell-fontgen`;
const cli = `${folder}/node_modules/.bin/inkcell-fontgen`;
const at = `${folder}/project`;
copyFileSync(FONT, `${at}/Sans.ttf`);
writeFileSync(`${at}/deep/main.c`, 'const char* text = "Grüße";\n');

/** The same command of both programs. */
function both(args, name = '') {
  const [ours, theirs] = [[node, [cli]], [host, []]].map(([program, first]) => {
    const result = spawnSync(program, [...first, ...args], {cwd: at, encoding: 'utf8'});
    const files = Object.fromEntries((name ? [name].flat() : [])
      .map((file) => [file, readFileSync(`${at}/${file}`)]));
    for (const file of Object.keys(files)) rmSync(`${at}/${file}`);
    return {...result, files};
  });
  assert.equal(ours.status, theirs.status, ours.stderr);
  // Progress is for terminals.
  assert.equal(ours.stderr, theirs.stderr.replace(/^ *\d+ %: .*\n/gm, ''));
  const [printed, wanted] = [ours, theirs].map(({stdout}) =>
    stdout.replace(/time .*/, '').replaceAll(host, 'inkcell-fontgen'));
  assert.equal(printed, wanted);
  for (const [file, bytes] of Object.entries(ours.files)) {
    assert.ok(bytes.equals(theirs.files[file]), file);
  }
  return ours;
}

const quick = ['--symbols', 'Hag 12', '--quiet'];
assert.equal(both(['--font', 'Sans.ttf', ...quick, '--out', 'a.bin'], 'a.bin').status, 0);
both(['--font', FONT, ...quick, '--name', 'a', '--out', 'deep/a.c', '--header', `${at}/a.h`],
  ['deep/a.c', 'a.h']);
both([`--font=${at}/Sans.ttf`, '--strings-from', 'deep/*.c', '--quiet', '--out', 'a.hpp'],
  'a.hpp');
both(['--font', `../project/Sans.ttf`, ...quick, '--out', 'a.hpp', '--depfile', 'a.d'],
  ['a.hpp', 'a.d']);
assert.match(both(['--font', 'Sans.ttf', '--symbols', 'a永', '--quiet', '--out', 'a.bin'],
  'a.bin').stderr, /U\+6C38 '永'/);
const report = both(['--font', 'Sans.ttf', '--symbols', 'Ag', '--out', 'a.bin'], 'a.bin');
assert.match(report.stdout, /total/);
const help = both(['--help']);
assert.equal(help.status, 0);
for (const args of [['--font', 'none.ttf', '--out', 'a.bin'],
  ['--font', '/none/none.ttf', '--out', 'a.bin'], ['--font', 'Sans.ttf'], ['--no-such'],
  ['--font', 'Sans.ttf', '--tolerance', '0', '--out', 'a.bin']]) {
  assert.notEqual(both(args).status, 0, args.join(' '));
}
assert.match(both(['--font', '/none/none.ttf', '--out', 'a.bin']).stderr,
  /^error: \/none\/none\.ttf: /);

// cli.mjs knows each option that takes a path.
const paths = [...help.stdout.matchAll(/(--[\w-]+) (?:FILE|DIR|PATTERN|FACE)/g)]
  .map(([, option]) => option);
assert.ok(paths.length >= 10, paths.join(' '));
const known = /PATHS = \[([^\]]*)\]/.exec(readFileSync(`${packed}/cli.mjs`, 'utf8'))[1];
assert.deepEqual(paths.filter((option) => !known.includes(`'${option}'`)), []);

const {fontgen} = await import(pathToFileURL(`${packed}/index.mjs`).href);
const made = await fontgen({'Sans.ttf': readFileSync(FONT)},
  ['--font', 'Sans.ttf', ...quick, '--out', 'a.bin']);
assert.equal(made.code, 0, made.err);
execFileSync(host, ['--font', 'Sans.ttf', ...quick, '--out', 'a.bin'], {cwd: at});
assert.ok(readFileSync(`${at}/a.bin`).equals(made.files['a.bin']));
const {version} = JSON.parse(readFileSync(`${packed}/package.json`, 'utf8'));
console.log(`inkcell-fontgen ${version} from npm's package, run by ${execFileSync(node, ['--version'], {encoding: 'utf8'}).trim()}: bytes, help, ` +
  'errors and exit codes are the program\'s');
