// Makes a font by the page of a release, in headless Chromium. What the page links
// lies beside it.
//
// Usage: node page.mjs PAGE_FOLDER NPM_FOLDER FONT HEADER
import assert from 'node:assert/strict';
import {copyFileSync, existsSync} from 'node:fs';

import {convert, download, launch, problems} from '../web/browser.mjs';

const [folder, npm, font, header] = process.argv.slice(2);
const {browser, open} = await launch(npm, `file://${folder}/inkcell.html`);
const page = await open({cores: 2});
const links = await page.$$eval('a[href]', (all) => all.map((link) =>
  link.getAttribute('href')).filter((to) => !/^(#|[a-z]+:)/.test(to)));
assert.ok(links.length > 0);
for (const link of links) assert.ok(existsSync(`${folder}/${link}`), link);
await convert(page, font);
copyFileSync((await download(page, 'hpp')).path, header);
assert.deepEqual(problems, []);
await browser.close();
