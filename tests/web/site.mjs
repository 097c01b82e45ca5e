// Tests the page as files for a web server: it asks only that server, converts,
// and opens again without any.
//
// Usage: node site.mjs SITE_FOLDER NPM_FOLDER HOST_FONTGEN FOLDER
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname} from 'node:path';

import {convert, download, launch, problems, shown} from './browser.mjs';

const [site, npm, host, folder] = process.argv.slice(2);
const FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf';
const TYPES = {'.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript'};
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
const asked = new Set();
const server = createServer(({url}, answer) => {
  const name = url === '/sub/' ? 'index.html' : url.replace('/sub/', '');
  asked.add(name);
  try {
    const bytes = readFileSync(`${site}/${name}`);
    answer.writeHead(200, {'content-type': TYPES[extname(name)] ?? 'application/octet-stream'});
    answer.end(bytes);
  } catch {
    answer.writeHead(404);
    answer.end();
  }
});
await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
// Not at the root, as pages of projects lie.
const address = `http://127.0.0.1:${server.address().port}/sub/`;
const {browser, open} = await launch(npm, address);

const page = await open({cores: 1});
await page.evaluate(() => navigator.serviceWorker.ready);
await page.waitForFunction(() => navigator.serviceWorker.controller);
assert.deepEqual([...asked].filter((name) => name !== 'favicon.ico').sort(), ['core.wasm',
  'font.bin', 'fontgen.wasm', 'index.html', 'page.css', 'page.js', 'service.js', 'worker.js']);
server.closeAllConnections();
await new Promise((closed) => server.close(closed));
await page.reload();
await page.waitForSelector('body[data-ready]');
assert.ok((await shown(page, 'oled', 128, 64)).includes(1));
await page.uncheck('#ascii');
await page.uncheck('#mine');
await page.check('#digits');
await convert(page, FONT);
const {path} = await download(page, 'bin');
execFileSync(host, ['--font', FONT, '--chars', '0x20,0x25,0x2B-0x3A', '--quiet', '--out',
  'font.bin'], {cwd: folder});
assert.ok(readFileSync(path).equals(readFileSync(`${folder}/font.bin`)));
assert.deepEqual(problems.filter((text) => !/favicon/.test(text)), []);
assert.equal(await page.evaluate(() => new Promise((resolve) => {
  addEventListener('securitypolicyviolation', (event) => resolve(event.violatedDirective));
  fetch('https://localhost/').catch(() => {});
})), 'connect-src');
await browser.close();
console.log('files for a server: open, convert and open again without one');
